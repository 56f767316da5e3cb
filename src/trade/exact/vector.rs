//! Vectors of big numbers, and the errors of computed ones.

use super::{Big, big, small};
use dashu_base::Abs;
use glam::DVec3;

/// Three components.
pub(crate) type Vector = [Big; 3];

/// a − b.
pub(crate) fn difference(a: DVec3, b: DVec3) -> Vector {
    let (a, b) = (a.to_array(), b.to_array());
    std::array::from_fn(|axis| big(a[axis]) - big(b[axis]))
}

/// a + b.
pub(crate) fn add(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|axis| &a[axis] + &b[axis])
}

/// a·b.
pub(crate) fn dot(a: &Vector, b: &Vector) -> Big {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

/// a × b.
pub(crate) fn cross(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|axis| {
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        &a[j] * &b[k] - &a[k] * &b[j]
    })
}

/// |v|.
pub(crate) fn length(v: &Vector) -> Big {
    dot(v, v).sqrt()
}

/// v/|v|; `None` for zero.
pub(crate) fn unit(v: &Vector) -> Option<Vector> {
    let length = length(v);
    (length != Big::ZERO).then(|| std::array::from_fn(|axis| &v[axis] / &length))
}

/// The angle between two vectors, in radians.
pub(crate) fn angle(a: &Vector, b: &Vector) -> Big {
    length(&cross(a, b)).atan2(&dot(a, b))
}

/// The angle between a computed vector of any length and a true one, in radians; NaN for what has no direction.
pub(crate) fn angle_to(got: DVec3, truth: &Vector) -> f64 {
    if !got.is_finite() || got == DVec3::ZERO {
        return f64::NAN;
    }
    let got = got.to_array().map(big);
    libm::atan2(small(&length(&cross(&got, truth))), small(&dot(&got, truth)))
}

/// The angle between a computed vector of any length and a true one, in degrees; NaN for a vector without a direction.
pub(crate) fn degrees_to(computed: DVec3, truth: &Vector) -> f64 {
    angle_to(computed, truth).to_degrees()
}

/// The length of the difference between a computed vector and a true one.
pub(crate) fn distance(got: DVec3, truth: &Vector) -> f64 {
    if !got.is_finite() {
        return f64::NAN;
    }
    let got = got.to_array();
    let errors: [f64; 3] = std::array::from_fn(|axis| small(&(big(got[axis]) - &truth[axis])));
    DVec3::from(errors).length()
}

/// The largest error of a component, in units of the last place of an `f32` as large as the true component.
pub(crate) fn error_in_ulps(got: [f32; 3], truth: &Vector) -> f64 {
    let error = |(got, truth): (f32, &Big)| {
        if !got.is_finite() {
            return f64::INFINITY;
        }
        let distance = small(&(big(f64::from(got)) - truth).abs());
        distance / ulp32(small(truth))
    };
    got.into_iter().zip(truth).map(error).fold(0.0, f64::max)
}

/// Spacing of `f32` values at a magnitude.
fn ulp32(x: f64) -> f64 {
    libm::ldexp(1.0, (crate::num::exponent(x) - 23).max(-149))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_and_distances_are_those_of_the_plane() {
        let truth = [1.0, 0.0, 0.0].map(big);
        assert_eq!(angle_to(DVec3::new(0.0, 0.0, 3.0), &truth), std::f64::consts::FRAC_PI_2);
        assert_eq!(angle_to(DVec3::new(-1e300, 0.0, 0.0), &truth), std::f64::consts::PI);
        assert_eq!(angle_to(DVec3::new(1.0, 1e-200, 0.0), &truth), 1e-200);
        assert!(angle_to(DVec3::ZERO, &truth).is_nan() && angle_to(DVec3::NAN, &truth).is_nan());
        assert_eq!(distance(DVec3::new(1.0, 3e-20, 4e-20), &truth), 5e-20);
        assert_eq!(error_in_ulps([1.0 + f32::EPSILON, 0.0, 0.0], &truth), 1.0);
        assert_eq!(error_in_ulps([1.0, f32::NAN, 0.0], &truth), f64::INFINITY);
    }

    #[test]
    fn roots_have_all_their_bits() {
        let vector = [1.0, 1.0, 0.0].map(big);
        let root = length(&vector);
        let off = small(&(&root * &root - big(2.0)).abs());
        assert!(off > 0.0 && off < 1e-75, "{off:e}");
    }
}
