//! Positions as the kernels see them: a mesh's or a caller's slice, single or double precision.

use crate::mesh::Storage;
use crate::num;
use glam::DVec3;

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
    /// What a position's coordinates are stored as.
    type Scalar: Copy + Default + Into<f64>;

    /// Whether every coordinate is an `f32` value.
    fn storage(self) -> Storage;

    /// The coordinates of a vertex, in kernel units.
    fn stored(self, vertex: u32) -> [Self::Scalar; 3];

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
    fn stored(self, vertex: u32) -> [f32; 3] {
        self.0[vertex as usize]
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

impl<'a> Doubles<'a> {
    fn new(points: &'a [DVec3], storage: Storage) -> Self {
        let factor = match storage {
            Storage::F32 => 1.0,
            Storage::F64 => factor_of(points),
        };
        Self { points, storage, factor }
    }
}

impl Source for Doubles<'_> {
    type Scalar = f64;

    #[inline(always)]
    fn storage(self) -> Storage {
        self.storage
    }

    #[inline(always)]
    fn stored(self, vertex: u32) -> [f64; 3] {
        (self.points[vertex as usize] * self.factor).to_array()
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
    let largest = points.iter().fold(0.0, |largest, point| {
        let point = point.abs().max_element();
        if point > largest && point < f64::INFINITY { point } else { largest }
    });
    if largest == 0.0 {
        return 1.0;
    }
    num::power_of_two((127 - num::exponent(largest)).min(1023))
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
            Positions::F64(points, storage) => visitor.visit(Doubles::new(points, storage)),
        }
    }
}
