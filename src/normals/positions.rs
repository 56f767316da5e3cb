//! Positions as the kernels see them: a mesh's or a caller's slice, single or double precision.

use crate::mesh::Storage;
use crate::num::{self, Kernel, Product};
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

/// A stored coordinate.
pub(crate) trait Scalar: Copy + Default + Into<f64> + Send + Sync {
    /// Numbers that order like magnitudes.
    type Order: Copy + PartialOrd;
    /// Below and above all of them.
    const LOWEST: Self::Order;
    const HIGHEST: Self::Order;

    /// Orders by magnitude; NaN comes last.
    fn magnitude(self) -> Self::Order;

    /// The same with zero last.
    fn magnitude_but_zero(self) -> Self::Order;

    /// Back to a magnitude.
    fn largest(order: Self::Order) -> f64;

    /// Back to a magnitude.
    fn smallest(order: Self::Order) -> f64;
}

impl Scalar for f32 {
    // The bits without sign order like magnitudes, and integers compare faster than floating-point numbers.
    type Order = u32;
    const LOWEST: u32 = 0;
    const HIGHEST: u32 = u32::MAX;

    #[inline(always)]
    fn magnitude(self) -> u32 {
        self.to_bits() << 1
    }

    #[inline(always)]
    fn magnitude_but_zero(self) -> u32 {
        (self.to_bits() << 1).wrapping_sub(1)
    }

    #[inline(always)]
    fn largest(order: u32) -> f64 {
        f64::from(f32::from_bits(order >> 1))
    }

    #[inline(always)]
    fn smallest(order: u32) -> f64 {
        f64::from(f32::from_bits(order.wrapping_add(1) >> 1))
    }
}

impl Scalar for f64 {
    type Order = f64;
    const LOWEST: f64 = 0.0;
    const HIGHEST: f64 = f64::INFINITY;

    #[inline(always)]
    fn magnitude(self) -> f64 {
        if self.is_nan() { f64::INFINITY } else { self.abs() }
    }

    #[inline(always)]
    fn magnitude_but_zero(self) -> f64 {
        if self == 0.0 { f64::INFINITY } else { self.abs() }
    }

    #[inline(always)]
    fn largest(order: f64) -> f64 {
        order
    }

    #[inline(always)]
    fn smallest(order: f64) -> f64 {
        order
    }
}

/// Where kernels get positions from. Everything is measured in *kernel units*: the caller's own for `f32` values;
/// for doubles, those times a power of two that brings the largest coordinate to the top of the `f32` range. So
/// one proof of what can overflow serves both, and scaling a mesh by a power of two cannot change a bit.
pub(crate) trait Source: Copy + Send + Sync {
    /// What a position's coordinates are stored as.
    type Scalar: Scalar;

    /// Whether every coordinate is an `f32` value.
    fn storage(self) -> Storage;

    /// The coordinates of a vertex, in kernel units: x and y, and z.
    fn stored(self, vertex: u32) -> ([Self::Scalar; 2], Self::Scalar);

    /// The position of a vertex, in kernel units, and whether that lost bits.
    fn point(self, vertex: u32) -> (DVec3, bool);
}

/// A slice of single-precision positions.
#[derive(Clone, Copy)]
pub(crate) struct Singles<'a>(&'a [[f32; 3]]);

impl Source for Singles<'_> {
    type Scalar = f32;

    #[inline(always)]
    fn storage(self) -> Storage {
        Storage::F32
    }

    #[inline(always)]
    fn stored(self, vertex: u32) -> ([f32; 2], f32) {
        let [x, y, z] = self.0[vertex as usize];
        ([x, y], z)
    }

    #[inline(always)]
    fn point(self, vertex: u32) -> (DVec3, bool) {
        (DVec3::from(self.0[vertex as usize].map(f64::from)), false)
    }
}

/// A slice of double-precision positions and the power of two that turns them into kernel units.
#[derive(Clone, Copy)]
pub(crate) struct Doubles<'a> {
    points: &'a [DVec3],
    storage: Storage,
    factor: f64,
}

impl Source for Doubles<'_> {
    type Scalar = f64;

    #[inline(always)]
    fn storage(self) -> Storage {
        self.storage
    }

    #[inline(always)]
    fn stored(self, vertex: u32) -> ([f64; 2], f64) {
        let point = self.points[vertex as usize] * self.factor;
        ([point.x, point.y], point.z)
    }

    #[inline(always)]
    fn point(self, vertex: u32) -> (DVec3, bool) {
        let point = self.points[vertex as usize];
        let scaled = point * self.factor;
        (scaled, self.factor < 1.0 && scaled / self.factor != point)
    }
}

/// The power of two that brings the largest finite coordinate into [2^127, 2^128), where that is possible.
fn factor_of(points: &[DVec3]) -> f64 {
    let largest_of = |points: &[DVec3]| num::dispatch(Largest(points));
    let largest = points.par_chunks(1 << 14).map(largest_of).reduce(|| 0.0, f64::max);
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
    fn run<P: Product>(self) -> f64 {
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
            Positions::F32(points) => visitor.visit(Singles(points)),
            Positions::F64(points, storage) => {
                let factor = if storage == Storage::F64 { factor_of(points) } else { 1.0 };
                visitor.visit(Doubles { points, storage, factor })
            }
        }
    }
}
