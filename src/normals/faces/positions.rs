//! Positions as the kernels read them: in place, in the type that they came in.

use crate::mesh::{PositionsRef, Storage};
use crate::normals::faces::sliver;
use crate::num::{self, Kernel, Lanes};
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
    /// Whether all coordinates are close enough in size that all their differences are exact.
    pub(crate) is_exact: bool,
}

/// Differences of `f32` values are exact in `f64` while no value is this many times as large as another that is not
/// zero: 24 bits each, 28 between their exponents and one to carry make 53.
pub(crate) const EXACT_RATIO: f64 = (1 << 28) as f64;

impl Extent {
    fn new(Magnitudes { smallest, largest }: Magnitudes) -> Option<Self> {
        // Differences are at most twice as large, and 53 bits long. Where all is zero, any grain will do.
        let grain = num::power_of_two((num::exponent(largest) - 50).max(-1022));
        let sliver_bound = sliver::triangle_bound(Storage::F32, largest);
        let is_exact = largest < EXACT_RATIO * smallest;
        largest.is_finite().then_some(Self { sliver_bound, grain, is_exact })
    }
}

/// The smallest magnitude of some `f32` values that are not zero, and the largest.
struct Magnitudes {
    smallest: f64,
    largest: f64,
}

impl Magnitudes {
    fn new(points: &[[f32; 3]]) -> Self {
        let bits = |points: &[[f32; 3]]| num::dispatch(MagnitudeBits(points.as_flattened()));
        let join = |(low, high): (u32, u32), (a, b): (u32, u32)| (low.min(a), high.max(b));
        let (below, largest) = points.par_chunks(1 << 16).map(bits).reduce(|| (u32::MAX, 0), join);
        let number = |bits| f64::from(f32::from_bits(bits));
        // Zero if all are.
        Self { smallest: number(below.wrapping_add(1)), largest: number(largest) }
    }
}

impl<'a> Source<'a> {
    /// Finds the range of coordinates, in parallel.
    pub(crate) fn new(positions: PositionsRef<'a>) -> Self {
        let (factor, extent) = match positions {
            PositionsRef::F32(points) => (1.0, Extent::new(Magnitudes::new(points))),
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

    /// The positions in the caller's units.
    #[inline(always)]
    pub(crate) fn positions(&self) -> PositionsRef<'a> {
        self.positions
    }

    /// From the caller's units to kernel units.
    #[inline(always)]
    pub(crate) fn factor(&self) -> f64 {
        self.factor
    }

    /// The range of all coordinates, if they are `f32` values.
    #[inline(always)]
    pub(crate) fn extent(&self) -> Option<Extent> {
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

/// The bits of the smallest magnitude but zero, less one, and of the largest one. Bits without sign order like magnitudes, and
/// integers compare faster than floating-point numbers; NaN comes last. One less makes zero the highest number.
struct MagnitudeBits<'a>(&'a [f32]);

impl Kernel for MagnitudeBits<'_> {
    type Output = (u32, u32);

    #[inline(always)]
    fn run<A: Lanes>(self, _: A) -> (u32, u32) {
        self.0.iter().map(|x| x.to_bits() & !(1 << 31)).fold((u32::MAX, 0), |(below, largest), bits| {
            (below.min(bits.wrapping_sub(1)), largest.max(bits))
        })
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
    use super::*;
    use crate::normals::fault::FaultReason;
    use crate::normals::scratch::Scratch;
    use crate::normals::slices::vertex_normals::face_normals;

    /// More than eight triangles, so that they are looked at side by side.
    #[test]
    fn triangles_that_are_all_at_the_origin_are_degenerate() {
        let mut normals = [[0.0_f32; 3]; 20];
        let faults =
            face_normals(&[[0.0; 3]; 3], &[[0, 1, 2]; 20], &mut Scratch::new(), &mut normals).unwrap();
        assert!(faults.faces.len() == 20 && faults.faces.iter().all(|f| f.reason == FaultReason::ZeroArea));
        assert_eq!(normals, [[0.0, 0.0, 1.0]; 20]);
    }

    /// Differences from coordinates near 2^-40 take 60 bits, and z is what is left of them: b' − b, against 1 for x and y.
    #[test]
    fn small_components_are_right_where_differences_are_not_exact() {
        let power = |exponent: i32| num::power_of_two(exponent) as f32;
        let (b, c) = (power(-40) * (1.0 + power(-20)), power(-38) * (1.0 + power(-21)));
        let points = [[b, c, 0.0], [1.0, 1.0, 0.0], [2.0, 2.0, 1.0], [0.0; 3]];
        let mut normals = [[0.0_f32; 3]; 16];
        face_normals(&points, &[[0, 1, 2]; 16], &mut Scratch::new(), &mut normals).unwrap();
        let z = (f64::from(c) - f64::from(b)) / 2.0_f64.sqrt();
        // One unit in the last place.
        assert!(normals.iter().all(|normal| (f64::from(normal[2]) - z).abs() <= z * f64::from(f32::EPSILON)));
    }
}
