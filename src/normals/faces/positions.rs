//! Positions as the kernels read them: in place, in the type that they came in.

use crate::mesh::{PositionsRef, Storage};
use crate::normals::faces::sliver;
use crate::num::{self, Kernel, LANES, Lanes};
use glam::DVec3;
use rayon::prelude::*;

/// Where kernels read positions. Everything is measured in *kernel units*: the caller's own for `f32` values;
/// for doubles, those times a power of two that brings the largest coordinate to the top of the `f32` range. So
/// one proof of what can overflow serves both, and scaling a mesh by a power of two cannot change a bit.
#[derive(Clone, Copy)]
pub(crate) struct Source<'a> {
    positions: PositionsRef<'a>,
    /// From the caller's units to kernel units: a power of two.
    factor: f64,
    extent: Option<Extent>,
}

/// How far coordinates go.
#[derive(Clone, Copy)]
pub(crate) struct Extent {
    /// The [`triangle_bound`](sliver::triangle_bound) of all triangles.
    pub(crate) sliver_bound: f64,
    /// Differences of multiples of this are exact: a power of two.
    pub(crate) grain: f64,
}

impl Extent {
    fn new(largest: f64) -> Option<Self> {
        // Differences are at most twice as large, and 53 bits long. Where all is zero, any grain will do.
        let grain = num::power_of_two((num::exponent(largest) - 50).max(-1022));
        let sliver_bound = sliver::triangle_bound(Storage::F32, largest);
        largest.is_finite().then_some(Self { sliver_bound, grain })
    }
}

impl<'a> Source<'a> {
    /// Finds the largest coordinate, in parallel.
    pub(crate) fn new(positions: PositionsRef<'a>) -> Self {
        let (factor, extent) = match positions {
            PositionsRef::F32(points) => {
                let largest = |points: &[[f32; 3]]| num::dispatch(LargestSingle(points.as_flattened()));
                let largest = points.par_chunks(1 << 16).map(largest).reduce(|| 0, u32::max);
                (1.0, Extent::new(f64::from(f32::from_bits(largest))))
            }
            PositionsRef::F64(points) => {
                let largest = |points: &[DVec3]| num::dispatch(LargestDouble(points));
                let largest = points.par_chunks(1 << 14).map(largest).reduce(|| 0.0, f64::max);
                (factor_of(largest), None)
            }
        };
        Self { positions, factor, extent }
    }

    /// Whether every coordinate is an `f32` value.
    #[inline(always)]
    pub(crate) fn storage(&self) -> Storage {
        self.positions.storage()
    }

    /// The position of a vertex, in kernel units, and whether the conversion lost bits.
    #[inline(always)]
    pub(crate) fn point(&self, vertex: u32) -> (DVec3, bool) {
        match self.positions {
            PositionsRef::F32(points) => (DVec3::from(points[vertex as usize].map(f64::from)), false),
            PositionsRef::F64(points) => {
                let point = points[vertex as usize];
                let scaled = point * self.factor;
                (scaled, self.factor < 1.0 && scaled / self.factor != point)
            }
        }
    }

    /// The number of vertices.
    #[inline(always)]
    pub(crate) fn count(&self) -> usize {
        self.positions.len()
    }

    /// The positions of eight vertices, in kernel units. None may be the last, as rows are read with the number after them.
    #[inline(always)]
    pub(crate) fn columns<A: Lanes>(&self, arch: A, vertices: [u32; LANES]) -> [A::Number; 3] {
        match self.positions {
            PositionsRef::F32(points) => arch.columns_of_singles(rows(points.as_flattened(), vertices)),
            PositionsRef::F64(points) => {
                let [x, y, z, _] = arch.columns(rows(bytemuck::cast_slice(points), vertices));
                let factor = arch.splat(self.factor);
                [arch.mul(x, factor), arch.mul(y, factor), arch.mul(z, factor)]
            }
        }
    }

    /// The range of all coordinates, if they are `f32` values.
    #[inline(always)]
    pub(crate) fn extent(&self) -> Option<Extent> {
        self.extent
    }
}

/// The coordinates of some vertices and the number after them.
#[inline(always)]
fn rows<T>(coordinates: &[T], [a, b, c, d, e, f, g, h]: [u32; LANES]) -> [&[T; 4]; LANES] {
    #[inline(always)]
    fn row<T>(coordinates: &[T], vertex: u32) -> &[T; 4] {
        coordinates[..3 * vertex as usize + 4].last_chunk().expect("four numbers at least")
    }
    let rows = coordinates;
    [
        row(rows, a),
        row(rows, b),
        row(rows, c),
        row(rows, d),
        row(rows, e),
        row(rows, f),
        row(rows, g),
        row(rows, h),
    ]
}

/// The power of two that brings the largest finite coordinate into [2^127, 2^128), where that is possible.
fn factor_of(largest: f64) -> f64 {
    if largest == 0.0 {
        return 1.0;
    }
    num::power_of_two((127 - num::exponent(largest)).min(1023))
}

/// The largest magnitude of some coordinates. Bits without sign order like magnitudes, and integers compare faster than
/// floating-point numbers; NaN comes last.
struct LargestSingle<'a>(&'a [f32]);

impl Kernel for LargestSingle<'_> {
    type Output = u32;

    #[inline(always)]
    fn run<A: Lanes>(self, _: A) -> u32 {
        self.0.iter().fold(0, |largest, x| largest.max(x.to_bits() & !(1 << 31)))
    }
}

/// The largest finite magnitude; a kernel so that it is compiled with the widest instructions.
struct LargestDouble<'a>(&'a [DVec3]);

impl Kernel for LargestDouble<'_> {
    type Output = f64;

    #[inline(always)]
    fn run<A: Lanes>(self, _: A) -> f64 {
        let mut largest = 0.0;
        for &x in bytemuck::cast_slice::<DVec3, f64>(self.0) {
            let x = x.abs();
            largest = if (x > largest) & (x < f64::INFINITY) { x } else { largest };
        }
        largest
    }
}

#[cfg(test)]
mod tests {
    use crate::normals::fault::FaultReason;
    use crate::normals::slices::vertex_normals::{Scratch, face_normals};

    /// More than eight triangles, so that they are looked at side by side.
    #[test]
    fn triangles_that_are_all_at_the_origin_are_degenerate() {
        let mut normals = [[0.0_f32; 3]; 20];
        let faults =
            face_normals(&[[0.0; 3]; 3], &[[0, 1, 2]; 20], &mut Scratch::new(), &mut normals).unwrap();
        assert!(faults.faces.len() == 20 && faults.faces.iter().all(|f| f.reason == FaultReason::ZeroArea));
        assert_eq!(normals, [[0.0, 0.0, 1.0]; 20]);
    }
}
