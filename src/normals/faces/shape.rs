//! The direction and area of one face, faithfully: the path that is right for every input.

use crate::mesh::Storage;
use crate::normals::faces::sliver;
use crate::num::{self, CompensatedSum, ExactSum, Product};
use glam::DVec3;

/// Whether and why a face adds to sums.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u8)]
pub(crate) enum FaceState {
    /// It has a direction, and height above its storage's rounding.
    #[default]
    Counted,
    /// It has a direction, which is noise: its height is below the rounding of its coordinates.
    Sliver,
    /// Its area is exactly zero.
    ZeroArea,
    /// Exponents that `f64` cannot hold.
    OutOfRange,
    /// A coordinate is infinite or not a number.
    NonFinite,
}

impl FaceState {
    /// Whether the face has a direction at all.
    #[inline]
    pub(crate) fn has_direction(self) -> bool {
        matches!(self, FaceState::Counted | FaceState::Sliver)
    }
}

/// One face: its normal and its area.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FaceShape {
    /// Twice the area vector, in units of 2^(2·exponent) kernel units squared. Zero without direction.
    pub(crate) vector: DVec3,
    /// Unit normal. Zero without direction.
    pub(crate) unit: DVec3,
    /// Length of `vector`.
    pub(crate) length: f64,
    /// Binary exponent of the face's size: its largest coordinate difference is in [2^exponent, 2^(exponent+1)).
    pub(crate) exponent: i32,
    /// The state of the face.
    pub(crate) state: FaceState,
}

impl FaceShape {
    pub(crate) fn without_direction(state: FaceState) -> Self {
        Self { vector: DVec3::ZERO, unit: DVec3::ZERO, length: 0.0, exponent: 0, state }
    }
}

/// A relative error above which a component of a triangle's or quad's normal is recomputed exactly: far below
/// the 2^-24 that would show in an `f32`.
const COMPONENT_BOUND: f64 = 1.0 / (1 << 30) as f64;
/// The same for the angle between computed and true normal of everything else: 1e-12 rad with a factor of 2.
const ANGLE_BOUND: f64 = 0.5e-12;
/// u², u = 2^-53.
const U2: f64 = f64::EPSILON * f64::EPSILON / 4.0;
/// Scaled differences below this may lose bits of their products to the subnormal range.
const LOSSLESS: f64 = 1e-144;
/// What such a loss, or one when coordinates were brought to kernel units, adds to a sum of products at most.
const LOSS: f64 = 1e-200;
/// Exponent of size below which the latter is no longer so.
const SMALLEST_LOSSY: i32 = -400;

/// A vector as an unevaluated sum: the difference of two positions, without error.
#[derive(Clone, Copy)]
struct Difference {
    high: DVec3,
    low: DVec3,
}

impl Difference {
    #[inline(always)]
    fn new(to: DVec3, from: DVec3) -> Self {
        let (x, y, z) = (
            num::two_difference(to.x, from.x),
            num::two_difference(to.y, from.y),
            num::two_difference(to.z, from.z),
        );
        Self { high: DVec3::new(x.0, y.0, z.0), low: DVec3::new(x.1, y.1, z.1) }
    }

    fn scaled(self, k: i32) -> Self {
        Self { high: num::scale(self.high, k), low: num::scale(self.low, k) }
    }

    fn smallest(self) -> f64 {
        let least = |least: f64, x: f64| if x == 0.0 { least } else { least.min(x.abs()) };
        self.high.to_array().into_iter().chain(self.low.to_array()).fold(f64::INFINITY, least)
    }
}

/// One component of a cross product of differences: ab − cd, each factor a high and a low part.
#[derive(Clone, Copy)]
pub(crate) struct Minor {
    pub(crate) a: (f64, f64),
    pub(crate) b: (f64, f64),
    pub(crate) c: (f64, f64),
    pub(crate) d: (f64, f64),
}

impl Minor {
    /// ab − cd: difference of products of the high parts, corrected for the low ones to first order. Where those
    /// are zero the relative error is 2u (Cornea, Harrison & Tang 2002), otherwise it is below 2u plus
    /// 16u²·(|ab| + |cd|).
    #[inline(always)]
    pub(crate) fn value<P: Product>(self) -> f64 {
        let Self { a, b, c, d } = self;
        let ((p, ep), (q, eq)) = (P::two_product(a.0, b.0), P::two_product(c.0, d.0));
        (p - q) + ((ep - eq) + self.correction())
    }

    /// The same into a sum of many.
    #[inline(always)]
    fn add_to<P: Product>(self, sum: &mut CompensatedSum) {
        let Self { a, b, c, d } = self;
        let ((p, ep), (q, eq)) = (P::two_product(a.0, b.0), P::two_product(c.0, d.0));
        *sum += p;
        *sum += -q;
        sum.correct((ep - eq) + self.correction());
    }

    #[inline(always)]
    fn correction(self) -> f64 {
        let Self { a, b, c, d } = self;
        (a.0 * b.1 + a.1 * b.0) - (c.0 * d.1 + c.1 * d.0)
    }

    fn magnitude(self) -> f64 {
        (self.a.0 * self.b.0).abs() + (self.c.0 * self.d.0).abs()
    }

    fn add_exactly<P: Product>(self, sum: &mut ExactSum) {
        let mut product = |x: f64, y: f64| {
            let (p, e) = P::two_product(x, y);
            sum.add(p);
            sum.add(e);
        };
        let Self { a, b, c, d } = self;
        for (x, y) in [(a.0, b.0), (a.0, b.1), (a.1, b.0), (a.1, b.1)] {
            product(x, y);
        }
        for (x, y) in [(c.0, d.0), (c.0, d.1), (c.1, d.0), (c.1, d.1)] {
            product(-x, y);
        }
    }
}

/// The three minors of u × v.
fn minors(u: Difference, v: Difference) -> [Minor; 3] {
    let part = |w: Difference, axis: usize| (w.high[axis], w.low[axis]);
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| Minor {
        a: part(u, i),
        b: part(v, j),
        c: part(u, j),
        d: part(v, i),
    })
}

/// The pairs of differences whose cross products add up to twice the area vector: (P1−P0)×(P2−P0) for a
/// triangle, (P2−P0)×(P3−P1) for a quad, the fan from P0 beyond. Always differences first: sums of products of
/// positions cancel away from the origin, and sums over three consecutive corners are not the area vector.
#[inline(always)]
fn for_each_pair(points: &[DVec3], mut visit: impl FnMut(Difference, Difference)) {
    let difference = |i: usize, j: usize| Difference::new(points[i], points[j]);
    match points.len() {
        3 => visit(difference(1, 0), difference(2, 0)),
        4 => visit(difference(2, 0), difference(3, 1)),
        n => {
            let mut previous = difference(1, 0);
            for i in 2..n {
                let next = difference(i, 0);
                visit(previous, next);
                previous = next;
            }
        }
    }
}

/// The shape of the face with these corners. `lossy`: bringing them to kernel units may have lost bits.
#[inline(always)]
pub(crate) fn face_shape<P: Product>(points: &[DVec3], storage: Storage, lossy: bool) -> FaceShape {
    if !points.iter().all(|point| point.is_finite()) {
        return FaceShape::without_direction(FaceState::NonFinite);
    }
    let (mut largest, mut size) = (0.0, 0.0);
    for &point in points {
        largest = f64::max(largest, point.abs().max_element());
        size = f64::max(size, (point - points[0]).abs().max_element());
    }
    let exponent = num::exponent(size);
    if lossy && exponent < SMALLEST_LOSSY {
        return FaceShape::without_direction(FaceState::OutOfRange);
    }
    if size == 0.0 {
        return FaceShape::without_direction(FaceState::ZeroArea);
    }
    let (vector, settled) = match points.len() {
        3 | 4 => area_vector_of_one_pair::<P>(points, storage, exponent, lossy),
        _ => area_vector_of_fan::<P>(points, exponent, lossy),
    };
    if !settled {
        return FaceShape::without_direction(FaceState::OutOfRange);
    }
    if vector == DVec3::ZERO {
        return FaceShape::without_direction(FaceState::ZeroArea);
    }
    let (unit, length) = num::direction(vector);
    let diameter = sliver::squared_diameter(points, exponent).sqrt();
    let threshold = libm::ldexp(sliver::threshold(storage, largest), -exponent);
    let state = if length < threshold * diameter { FaceState::Sliver } else { FaceState::Counted };
    FaceShape { vector, unit, length, exponent, state }
}

/// Twice the area vector of a triangle or quad in units of 2^(2·exponent), and whether its error is in bounds.
#[inline(always)]
fn area_vector_of_one_pair<P: Product>(
    points: &[DVec3],
    storage: Storage,
    exponent: i32,
    lossy: bool,
) -> (DVec3, bool) {
    let (mut vector, mut magnitudes) = ([0.0; 3], [0.0; 3]);
    let (mut smallest, mut low_parts) = (f64::INFINITY, false);
    for_each_pair(points, |u, v| {
        smallest = u.smallest().min(v.smallest());
        low_parts = u.low != DVec3::ZERO || v.low != DVec3::ZERO;
        for (axis, minor) in minors(u.scaled(-exponent), v.scaled(-exponent)).into_iter().enumerate() {
            vector[axis] = minor.value::<P>();
            magnitudes[axis] = minor.magnitude();
        }
    });
    let vector = DVec3::from(vector);
    let loss = loss(smallest, exponent, lossy);
    if !low_parts && loss == 0.0 {
        return (vector, true);
    }
    let errors = DVec3::from(magnitudes) * (16.0 * U2) + loss;
    let within = match storage {
        Storage::F32 => (0..3).all(|axis| errors[axis] <= vector[axis].abs() * COMPONENT_BOUND),
        Storage::F64 => within_angle(vector, errors),
    };
    if within { (vector, true) } else { exact_area_vector::<P>(points, exponent, loss) }
}

/// The same for a polygon of five corners or more.
#[inline(always)]
fn area_vector_of_fan<P: Product>(points: &[DVec3], exponent: i32, lossy: bool) -> (DVec3, bool) {
    let (mut sums, mut magnitudes) = ([CompensatedSum::default(); 3], [0.0; 3]);
    let (mut smallest, mut pairs) = (f64::INFINITY, 0.0);
    for_each_pair(points, |u, v| {
        smallest = smallest.min(u.smallest()).min(v.smallest());
        pairs += 1.0;
        for (axis, minor) in minors(u.scaled(-exponent), v.scaled(-exponent)).into_iter().enumerate() {
            minor.add_to::<P>(&mut sums[axis]);
            magnitudes[axis] += minor.magnitude();
        }
    });
    let vector = DVec3::from(sums.map(CompensatedSum::value));
    let loss = pairs * loss(smallest, exponent, lossy);
    // Ogita, Rump & Oishi's bound for sums of products, in addition to the one of the low parts.
    let errors = DVec3::from(magnitudes) * ((16.0 + 8.0 * pairs * pairs) * U2) + loss;
    if within_angle(vector, errors) {
        return (vector, true);
    }
    exact_area_vector::<P>(points, exponent, loss)
}

/// Whether errors of this size turn a vector by less than the bound.
fn within_angle(vector: DVec3, errors: DVec3) -> bool {
    // Not `length`: errors may be too small to square.
    vector != DVec3::ZERO && errors.element_sum() <= num::direction(vector).1 * ANGLE_BOUND
}

/// What is lost at most of one pair where exponents come to the end of what `f64` holds.
fn loss(smallest: f64, exponent: i32, lossy: bool) -> f64 {
    if lossy || smallest < libm::ldexp(LOSSLESS, exponent) { LOSS } else { 0.0 }
}

/// Twice the area vector in units of 2^(2·exponent), each component rounded once, and whether `loss` leaves its
/// direction certain.
fn exact_area_vector<P: Product>(points: &[DVec3], exponent: i32, loss: f64) -> (DVec3, bool) {
    let mut sums = [ExactSum::new(), ExactSum::new(), ExactSum::new()];
    for_each_pair(points, |u, v| {
        let minors = minors(u.scaled(-exponent), v.scaled(-exponent));
        for (minor, sum) in minors.into_iter().zip(&mut sums) {
            minor.add_exactly::<P>(sum);
        }
    });
    let vector = DVec3::from(sums.map(ExactSum::value));
    (vector, loss == 0.0 || within_angle(vector, DVec3::splat(loss)))
}
