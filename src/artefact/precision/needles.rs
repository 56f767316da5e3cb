//! Slivers: triangles whose normals cancel in plain arithmetic.

use super::super::prelude::*;
use crate::normals::{Scratch, face_normals};
use glam::Vec3;

/// Heights of needles over their lengths.
const NEEDLES: [f64; 5] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6];

/// Each height with the largest error of the normal in degrees: by plain single precision, and as this library computes it.
fn errors() -> [Vec<[f64; 2]>; 2] {
    [0, 1].map(|way| NEEDLES.map(|ratio| [ratio, needle(ratio)[way]]).to_vec())
}

/// The error of the normal of a triangle that is so much lower than long, over some positions: by plain single precision, and
/// as this library computes it; NaN if it refused.
fn needle(ratio: f64) -> [f64; 2] {
    let mut worst = [0.0_f64; 2];
    for k in 0..400 {
        // Directions that share no digits with the axes.
        let t = f64::from(k) * 0.618_033_988_749_895;
        let along = DVec3::new(libm::cos(t), libm::sin(t) * 0.8, libm::sin(t) * 0.6);
        let aside = along.cross(DVec3::new(0.3, -0.5, 0.81)).normalize();
        let base = DVec3::new(0.4, -0.7, 0.3) * libm::cos(3.0 * t);
        let corners = [DVec3::ZERO, along, along * 0.37 + aside * ratio];
        let positions = corners.map(|p| (base + p).as_vec3().to_array());
        let [p, q, r] = positions.map(Vec3::from);
        let truth = {
            let [p, q, r] = [p, q, r].map(|v| v.as_dvec3());
            // Differences of single numbers and their products are exact in double precision.
            (q - p).cross(r - p)
        };
        let plain = (q - p).cross(r - p);
        let mut own = [[0.0_f32; 3]];
        if face_normals(&positions, &[[0, 1, 2]], &mut Scratch::new(), &mut own).is_err() {
            return [f64::NAN; 2];
        }
        for (worst, found) in worst.iter_mut().zip([plain.as_dvec3(), Vec3::from(own[0]).as_dvec3()]) {
            let off = libm::atan2(found.cross(truth).length(), found.dot(truth));
            *worst = worst.max(Degrees::from(Radians(off)).0);
        }
    }
    worst
}

/// One rounding of a product over the height of the triangle, in degrees: the size of the error of plain arithmetic.
fn rounding(ratio: f64) -> f64 {
    Degrees::from(Radians(0.5 * f64::from(f32::EPSILON) / ratio)).0
}

/// Measures and chart of the errors.
pub(super) fn record(out: &mut Recorder) {
    let [plain, careful] = errors();
    out.measure("needle-plain", "°", plain[4][1], Check::None);
    let largest = careful.iter().map(|point| point[1]).fold(0.0, f64::max);
    out.measure("needles-exact", "°", largest, Check::AtMost(6e-6));
    let guide = NEEDLES.iter().map(|&ratio| [ratio, rounding(ratio)]).collect();
    let curves = vec![
        out.curve("plain", Drawn::Points, plain),
        out.curve("exact", Drawn::Points, careful),
        out.curve("rounding", Drawn::Guide, guide),
    ];
    out.chart("needles", [Axis::Log; 2], curves);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Six products are rounded; the largest error over some hundred directions is of the size of one rounding.
    #[test]
    fn needles_cancel_in_plain_arithmetic() {
        for ratio in [1e-3, 1e-4, 1e-5] {
            let [naive, careful] = needle(ratio);
            let size = naive / rounding(ratio);
            assert!((0.2..6.0).contains(&size), "{ratio}: {naive}");
            assert!(careful < 6e-6, "{ratio}: {careful}");
        }
    }
}
