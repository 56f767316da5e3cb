//! Positions as the kernels see them: a mesh's or a caller's slice, single or double precision.

use crate::mesh::Storage;
use crate::normals::sums::block::bar;
use crate::num::{self, Kernel, LANES, Lanes};
use glam::DVec3;
use rayon::prelude::*;

/// Borrowed positions.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Positions<'a> {
    /// Single precision.
    F32(&'a [[f32; 3]]),
    /// Double precision, which may hold nothing but `f32` values.
    F64(&'a [DVec3], Storage),
}

/// Where kernels get positions from. Everything is measured in *kernel units*: the caller's own for `f32` values;
/// for doubles, those times a power of two that brings the largest coordinate to the top of the `f32` range. So
/// one proof of what can overflow serves both, and scaling a mesh by a power of two cannot change a bit.
pub(crate) trait Source: Copy + Send + Sync {
    /// Whether every coordinate is an `f32` value.
    fn storage(&self) -> Storage;

    /// The position of a vertex, in kernel units, and whether that lost bits.
    fn point(&self, vertex: u32) -> (DVec3, bool);

    /// How many vertices there are.
    fn count(&self) -> usize;

    /// The positions of eight vertices, in kernel units. None may be the last.
    fn columns<A: Lanes>(&self, arch: A, vertices: [u32; LANES]) -> [A::Number; 3];

    /// What is known of all coordinates, if they are `f32` values.
    fn extent(&self) -> Option<Extent>;
}

/// How far coordinates go.
#[derive(Clone, Copy)]
pub(crate) struct Extent {
    /// The [`bar`] of all triangles.
    pub(crate) bar: f64,
    /// Differences of multiples of this are exact: a power of two.
    pub(crate) grain: f64,
}

impl Extent {
    fn new(largest: f64) -> Option<Self> {
        // Differences are at most twice as large, and 53 bits long. Where all is zero, any grain will do.
        let grain = num::power_of_two((num::exponent(largest) - 50).max(-1022));
        largest.is_finite().then(|| Self { bar: bar(Storage::F32, largest), grain })
    }
}

/// A slice of single-precision positions.
#[derive(Clone, Copy)]
pub(crate) struct Singles<'a> {
    points: &'a [[f32; 3]],
    extent: Option<Extent>,
}

impl<'a> Singles<'a> {
    fn new(points: &'a [[f32; 3]]) -> Self {
        let largest = |points: &[[f32; 3]]| num::dispatch(LargestSingle(points.as_flattened()));
        let largest = points.par_chunks(1 << 16).map(largest).reduce(|| 0, u32::max);
        Self { points, extent: Extent::new(f64::from(f32::from_bits(largest))) }
    }
}

impl Source for Singles<'_> {
    #[inline(always)]
    fn storage(&self) -> Storage {
        Storage::F32
    }

    #[inline(always)]
    fn point(&self, vertex: u32) -> (DVec3, bool) {
        (DVec3::from(self.points[vertex as usize].map(f64::from)), false)
    }

    #[inline(always)]
    fn count(&self) -> usize {
        self.points.len()
    }

    #[inline(always)]
    fn columns<A: Lanes>(&self, arch: A, vertices: [u32; LANES]) -> [A::Number; 3] {
        arch.columns_of_singles(rows(self.points.as_flattened(), vertices))
    }

    #[inline(always)]
    fn extent(&self) -> Option<Extent> {
        self.extent
    }
}

/// The coordinates of some vertices and the number after them.
#[inline(always)]
fn rows<T>(coordinates: &[T], [a, b, c, d, e, f, g, h]: [u32; LANES]) -> [&[T; 4]; LANES] {
    [
        row(coordinates, a),
        row(coordinates, b),
        row(coordinates, c),
        row(coordinates, d),
        row(coordinates, e),
        row(coordinates, f),
        row(coordinates, g),
        row(coordinates, h),
    ]
}

#[inline(always)]
fn row<T>(coordinates: &[T], vertex: u32) -> &[T; 4] {
    coordinates[..3 * vertex as usize + 4].last_chunk().expect("four numbers at least")
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

/// A slice of double-precision positions and the power of two that turns them into kernel units.
#[derive(Clone, Copy)]
pub(crate) struct Doubles<'a> {
    points: &'a [DVec3],
    storage: Storage,
    factor: f64,
    extent: Option<Extent>,
}

impl<'a> Doubles<'a> {
    fn new(points: &'a [DVec3], storage: Storage) -> Self {
        let largest = |points: &[DVec3]| num::dispatch(Largest(points));
        let largest = points.par_chunks(1 << 14).map(largest).reduce(|| 0.0, f64::max);
        let (factor, extent) = match storage {
            Storage::F32 => (1.0, Extent::new(largest)),
            Storage::F64 => (factor_of(largest), None),
        };
        Self { points, storage, factor, extent }
    }
}

impl Source for Doubles<'_> {
    #[inline(always)]
    fn storage(&self) -> Storage {
        self.storage
    }

    #[inline(always)]
    fn point(&self, vertex: u32) -> (DVec3, bool) {
        let point = self.points[vertex as usize];
        let scaled = point * self.factor;
        (scaled, self.factor < 1.0 && scaled / self.factor != point)
    }

    #[inline(always)]
    fn count(&self) -> usize {
        self.points.len()
    }

    #[inline(always)]
    fn columns<A: Lanes>(&self, arch: A, vertices: [u32; LANES]) -> [A::Number; 3] {
        let [x, y, z, _] = arch.columns(rows(bytemuck::cast_slice(self.points), vertices));
        let factor = arch.splat(self.factor);
        [arch.mul(x, factor), arch.mul(y, factor), arch.mul(z, factor)]
    }

    #[inline(always)]
    fn extent(&self) -> Option<Extent> {
        self.extent
    }
}

/// The power of two that brings the largest finite coordinate into [2^127, 2^128), where that is possible.
fn factor_of(largest: f64) -> f64 {
    if largest == 0.0 {
        return 1.0;
    }
    num::power_of_two((127 - num::exponent(largest)).min(1023))
}

/// The largest finite magnitude; a kernel so that it is compiled with the widest instructions.
struct Largest<'a>(&'a [DVec3]);

impl Kernel for Largest<'_> {
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

/// Work on positions of either kind.
pub(crate) trait Visitor {
    /// What it gives.
    type Output;

    /// Does it.
    fn visit<S: Source>(self, source: S) -> Self::Output;
}

impl Positions<'_> {
    /// Calls the visitor with the source that these positions are.
    pub(crate) fn visit<V: Visitor>(self, visitor: V) -> V::Output {
        match self {
            Positions::F32(points) => visitor.visit(Singles::new(points)),
            Positions::F64(points, storage) => visitor.visit(Doubles::new(points, storage)),
        }
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
