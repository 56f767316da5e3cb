//! The lectures' formulas for both precisions. They have selections and no branches, so that loops over rows become vector
//! code with the bits of a single point. Undefined values stay NaN through every selection (`x < y` is false for NaN).

use crate::num::Real;
use glam::DVec3;

pub(super) type Triple<R> = [R; 3];

pub(super) fn unit(direction: DVec3) -> DVec3 {
    crate::num::direction(direction).0
}

/// The nearest numbers of this precision.
pub(super) fn rounded<R: Real>(v: DVec3) -> Triple<R> {
    v.to_array().map(|x| R::of(x))
}

#[inline(always)]
pub(super) fn dot<R: Real>(a: Triple<R>, b: Triple<R>) -> R {
    (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]
}

#[inline(always)]
pub(super) fn plus<R: Real>(a: Triple<R>, b: Triple<R>) -> Triple<R> {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

#[inline(always)]
pub(super) fn minus<R: Real>(a: Triple<R>, b: Triple<R>) -> Triple<R> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline(always)]
pub(super) fn times<R: Real>(a: Triple<R>, k: R) -> Triple<R> {
    [a[0] * k, a[1] * k, a[2] * k]
}

/// The product of the components.
#[inline(always)]
pub(super) fn scaled<R: Real>(a: Triple<R>, b: Triple<R>) -> Triple<R> {
    [a[0] * b[0], a[1] * b[1], a[2] * b[2]]
}

/// |a×b|².
#[inline(always)]
fn squared_cross<R: Real>(a: Triple<R>, b: Triple<R>) -> R {
    let x = a[1] * b[2] - a[2] * b[1];
    let y = a[2] * b[0] - a[0] * b[2];
    let z = a[0] * b[1] - a[1] * b[0];
    dot([x, y, z], [x, y, z])
}

/// The unit vector of a normal: zero if its square underflows, NaN if it overflows. With a normal of zero a point shows
/// ambient light only.
#[inline(always)]
pub(super) fn normalised<R: Real>(v: Triple<R>) -> Triple<R> {
    let square = dot(v, v);
    let factor = R::ONE / square.sqrt();
    let factor = if square < R::MIN_POSITIVE { R::ZERO } else { factor };
    times(v, if square > R::MAX { R::NAN } else { factor })
}

/// The unit vector from one point to another, and the distance; NaN where the square of the distance is out of range.
#[inline(always)]
pub(super) fn towards<R: Real>(from: Triple<R>, to: Triple<R>) -> (Triple<R>, R) {
    let v = minus(to, from);
    let square = dot(v, v);
    let square = if square < R::MIN_POSITIVE { R::NAN } else { square };
    let square = if square > R::MAX { R::NAN } else { square };
    let distance = square.sqrt();
    (times(v, R::ONE / distance), distance)
}

/// 1/(kc + kl·d + kq·d²) (F9, F10, F11): exactly 1 for (1, 0, 0).
#[inline(always)]
pub(super) fn attenuation<R: Real>([constant, linear, quadratic]: Triple<R>, distance: R) -> R {
    R::ONE / (constant + (linear * distance + quadratic * (distance * distance)))
}

/// max(1 − (d/r)⁴, 0), from 1/r².
#[inline(always)]
pub(super) fn window<R: Real>(distance: R, inverse_square_range: R) -> R {
    let ratio = (distance * distance) * inverse_square_range;
    at_least(R::ONE - ratio * ratio, R::ZERO)
}

/// 1 − cos of the angle between unit vectors with the cosine `cosine`, to full relative accuracy at small angles.
#[inline(always)]
pub(super) fn versine<R: Real>(a: Triple<R>, b: Triple<R>, cosine: R) -> R {
    let narrow = squared_cross(a, b) / (R::ONE + cosine);
    if cosine > R::ZERO { narrow } else { R::ONE - cosine }
}

/// The soft edge of a spot: ((vo − v)/(vo − vi))² with versines v, 1 at the most, 0 outside.
#[inline(always)]
pub(super) fn soft_edge<R: Real>(versine: R, outer: R, inverse_width: R) -> R {
    let inside = at_least((outer - versine) * inverse_width, R::ZERO);
    let inside = if inside > R::ONE { R::ONE } else { inside };
    inside * inside
}

/// The larger one; NaN stays NaN.
#[inline(always)]
pub(super) fn at_least<R: Real>(x: R, least: R) -> R {
    if x < least { least } else { x }
}

/// The factor of light near the terminator, −g³ + g² + g with g = N_g·L/((N·L)(N_g·N)): 1 for g ≥ 1, 0 where N_g·L ≤ 0
/// (Chiang, Li & Burley 2019). Takes N_g·L, N·L and N_g·N of unit vectors.
#[inline(always)]
pub(super) fn softened<R: Real>(face_light: R, normal_light: R, face_normal: R) -> R {
    let product = normal_light * face_normal;
    let g = face_light / product;
    let soft = g * (R::ONE + g * (R::ONE - g));
    // Also 1 where N itself is turned away.
    let soft = if product > face_light { soft } else { R::ONE };
    if face_light > R::ZERO { soft } else { R::ZERO }
}

/// R = 2N(N·L) − L (F5).
#[inline(always)]
pub(super) fn mirrored<R: Real>(normal: Triple<R>, light: Triple<R>) -> Triple<R> {
    let cosine = dot(normal, light);
    minus(times(normal, cosine + cosine), light)
}

/// V·R without R: 2(N·L)(N·V) − L·V (F4, F5).
#[inline(always)]
pub(super) fn phong_cosine<R: Real>(normal: Triple<R>, light: Triple<R>, view: Triple<R>) -> R {
    let product = dot(normal, light) * dot(normal, view);
    (product + product) - dot(light, view)
}

/// N·H with H = (L+V)/‖L+V‖ (F6). If L and V are opposite, H is 0/0 and L + V is only rounding: then there is no
/// highlight, and the result is 0.
#[inline(always)]
pub(super) fn blinn_cosine<R: Real>(normal: Triple<R>, light: Triple<R>, view: Triple<R>) -> R {
    let sum = plus(light, view);
    let square = dot(sum, sum);
    let cosine = dot(normal, sum) / square.sqrt();
    if square <= rounding_of_opposites() { R::ZERO } else { cosine }
}

/// H of unit vectors in double precision, unless they are opposite.
pub(super) fn half_vector(light: DVec3, view: DVec3) -> Option<DVec3> {
    let sum = light + view;
    (sum.length_squared() > rounding_of_opposites::<f64>()).then(|| unit(sum))
}

/// The square of the length that two opposite unit vectors may add up to: each is off by up to 2ε.
#[inline(always)]
fn rounding_of_opposites<R: Real>() -> R {
    let length = R::EPSILON * R::of(4.0);
    length * length
}
