//! Errors and costs of this crate's own approximations.

use super::effort::{Candidate, fewest_seconds};
use crate::num::{LinearRgb, Power, Real, Underflow, corner_angle};
use crate::shade::{Attenuation, Light, Material, ShadeError, ShadeSettings, Shader, SurfacePoint, Viewer};
use glam::DVec3;
use serde::Serialize;
use std::f64::consts::PI;
use std::hint::black_box;

/// An approximation compared with the function that it replaces.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ApproximationRow {
    /// The approximated function.
    pub what: String,
    /// The largest error found.
    pub error: f64,
    /// The unit of the error.
    pub unit: &'static str,
    /// Nanoseconds of each computation.
    pub ns: f64,
    /// Nanoseconds of the function that it replaces.
    pub exact_ns: f64,
}

/// How many arguments each is tried with.
const COUNT: usize = 1 << 14;

/// A function to measure on numbers whose true values are known.
struct Trial<'a> {
    what: String,
    error: f64,
    unit: &'static str,
    approximate: Candidate<'a>,
    exact: Candidate<'a>,
}

/// Angles of corners without an arc tangent; powers for highlights without a logarithm of the platform, in double and in
/// single precision; and light on points in single precision, as in pictures, compared with double.
pub fn approximation_rows() -> Vec<ApproximationRow> {
    let shares: Vec<f64> = (1..=COUNT).map(|k| k as f64 / COUNT as f64).collect();
    let corners: Vec<[f64; 2]> =
        shares.iter().map(|share| libm::sincos(PI * share)).map(<[f64; 2]>::from).collect();
    let cosines: Vec<f32> = shares.iter().map(|&share| share as f32).collect();
    let doubles: Vec<f64> = cosines.iter().map(|&share| f64::from(share)).collect();
    let points = points();
    let mut trials = vec![angle(&corners)];
    for exponent in [10.0, 50.0, 200.0, 1000.0] {
        trials.push(power::<f64>("f64", exponent, &doubles, &doubles));
        trials.push(power::<f32>("f32", exponent, &cosines, &doubles));
    }
    trials.extend(light(&points).ok());
    let (mut rows, mut candidates) = (Vec::new(), Vec::new());
    for Trial { what, error, unit, approximate, exact } in trials {
        rows.push(ApproximationRow { what, error, unit, ns: 0.0, exact_ns: 0.0 });
        candidates.extend([approximate, exact]);
    }
    let seconds = fewest_seconds(candidates, 3);
    for (row, pair) in rows.iter_mut().zip(seconds.as_chunks::<2>().0) {
        [row.ns, row.exact_ns] = pair.map(|seconds| seconds * 1e9 / COUNT as f64);
    }
    rows
}

/// In steps of the last place of the truth.
fn ulps(found: f64, truth: f64) -> f64 {
    (found - truth).abs() / (truth.next_up() - truth)
}

fn angle(corners: &[[f64; 2]]) -> Trial<'_> {
    let error = corners.iter().map(|&[y, x]| ulps(corner_angle(y, x), libm::atan2(y, x)));
    Trial {
        what: "angle of a corner: polynomial".into(),
        error: error.fold(0.0, f64::max),
        unit: "ulp",
        approximate: Box::new(move || sum(corners, |[y, x]| corner_angle(y, x))),
        exact: Box::new(move || sum(corners, |[y, x]| libm::atan2(y, x))),
    }
}

fn power<'a, R: Real + Send + Sync>(
    precision: &str,
    exponent: f64,
    cosines: &'a [R],
    doubles: &'a [f64],
) -> Trial<'a> {
    let power = Power::<R>::new(exponent, Underflow::Zero);
    let error = cosines
        .iter()
        .zip(doubles)
        .map(|(&x, &truly)| 255.0 * (power.of(x).to_f64() - libm::pow(truly, exponent)).abs());
    let mut row = cosines.to_vec();
    Trial {
        what: format!("x^{exponent} in {precision}"),
        error: error.fold(0.0, f64::max),
        unit: "1/255",
        approximate: Box::new(move || {
            row.copy_from_slice(cosines);
            power.of_row(black_box(&mut row));
        }),
        exact: Box::new(move || sum(doubles, |x| libm::pow(x, exponent))),
    }
}

/// Points of a unit sphere on a spiral, in single precision, with their normals.
fn points() -> Vec<SurfacePoint<f32>> {
    // The golden angle: rotations that never coincide.
    let turn = PI * (3.0 - 5.0_f64.sqrt());
    let point = |k: usize| {
        let height = 1.0 - (2 * k + 1) as f64 / COUNT as f64;
        let (sine, cosine) = libm::sincos(turn * k as f64);
        let radius = (1.0 - height * height).sqrt();
        let place = DVec3::new(radius * cosine, radius * sine, height).as_vec3().to_array();
        SurfacePoint { position: place, normal: place }
    };
    (0..COUNT).map(point).collect()
}

/// A lamp and a viewer nearby, Blinn's highlight with n = 32.
fn light(points: &[SurfacePoint<f32>]) -> Result<Trial<'_>, ShadeError> {
    let lamp = Light::Point {
        position: DVec3::new(2.0, 3.0, 4.0),
        colour: LinearRgb::WHITE,
        attenuation: Attenuation::None,
    };
    let settings =
        ShadeSettings { viewer: Viewer::At(DVec3::new(0.0, 0.0, 5.0)), ..ShadeSettings::default() };
    let single = Shader::<f32>::new(&[lamp], &Material::default(), &settings)?;
    let double = Shader::<f64>::new(&[lamp], &Material::default(), &settings)?;
    let grey = |colour: Result<[f64; 3], _>| colour.map_or(f64::NAN, |colour: [f64; 3]| colour[0]);
    let lit = move |point: SurfacePoint<f32>| grey(single.shade(&point).map(|c| c.map(f64::from)));
    let truly = move |SurfacePoint { position, normal }: SurfacePoint<f32>| {
        let [position, normal] = [position, normal].map(|v| v.map(f64::from));
        grey(double.shade(&SurfacePoint { position, normal }))
    };
    let error = points.iter().map(|&point| 255.0 * (lit(point) - truly(point)).abs());
    Ok(Trial {
        what: "light on a point in f32".into(),
        error: error.fold(0.0, f64::max),
        unit: "1/255",
        approximate: Box::new(move || sum(points, &lit)),
        exact: Box::new(move || sum(points, &truly)),
    })
}

/// Uses every result, so that none is optimised away.
fn sum<T: Copy>(arguments: &[T], of: impl Fn(T) -> f64) {
    black_box(arguments.iter().map(|&argument| of(argument)).sum::<f64>());
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_are_within_the_documented_bounds() {
        for row in approximation_rows() {
            let bound = match (row.unit, row.what.as_str()) {
                // 2 ulp of the polynomial and 1 of libm.
                ("ulp", _) => 3.0,
                // Some six roundings of N·H, 32 times over in its power, of which two tenths count, and a few more of N·L.
                (_, what) if what.starts_with("light") => 255.0 * 60.0 * 6e-8,
                // At most n·u relative up to n = 128, where xⁿ ≤ 1; beyond, 4 u. u = 6e-8 in single precision; libm's own
                // error is far below.
                (_, what) if what.ends_with("f32") && !what.contains("00") => 255.0 * 50.0 * 6e-8,
                (_, what) if what.ends_with("f32") => 255.0 * 4.0 * 6e-8,
                _ => 255.0 * 50.0 * 1.2e-16,
            };
            assert!(row.error > 0.0 && row.error <= bound, "{row:?}");
            assert!(row.ns > 0.0 && row.exact_ns > 0.0);
        }
    }
}
