//! Angles between the normals of two pictures.

use super::pairs::{MetricError, Moments, pairs};
use crate::num::{Degrees, Radians};
use crate::raster::Image;
use glam::DVec3;
use serde::Serialize;

/// Angles between the normals of two pictures, in degrees.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct NormalDeviation {
    /// Pixels compared: covered in both, by as many of their samples.
    pub compared: u64,
    /// Pixels that only one picture covers, or of which one covers more samples, or whose normals cancel.
    pub disagreeing: u64,
    /// The mean angle.
    pub mean: f64,
    /// The root of the mean square.
    pub rms: f64,
    /// The largest.
    pub max: f64,
    /// The angle of each pixel, in order; `None` where there is no comparison.
    #[serde(skip)]
    pub angles: Vec<Option<f64>>,
}

/// Compares the normals of two pictures drawn with [`Show::Normals`](crate::raster::Show::Normals), pixel by pixel: for instance
/// those of a mesh with those of the surface that it approximates, drawn with
/// [`Shading::Exact`](crate::raster::Shading::Exact).
///
/// The angle is atan2(|a×b|, a·b) of the two means of a pixel's samples. Pictures hold (n + 1)/2 in single precision, so angles
/// are right to about 2·10⁻⁷ rad ≈ 10⁻⁵°. *Measures* the angle at each pixel. *Does not measure* surfaces that are not
/// visible; surfaces seen edge-on have few pixels. *Does not measure* how much light changes: an angle of δ changes diffuse
/// light by at most δ, a highlight by up to [`steepest_slope`](crate::num::steepest_slope)·δ.
///
/// # Errors
/// Pictures of different sizes or without linear colours.
pub fn normal_deviation(picture: &Image, truth: &Image) -> Result<NormalDeviation, MetricError> {
    let mut deviation = NormalDeviation::default();
    let mut moments = Moments::default();
    for pair in pairs(picture, truth)? {
        let [found, expected] = pair.colours.map(normal);
        let angle = if pair.is_comparable() { angle(found, expected) } else { None };
        deviation.angles.push(angle);
        match angle {
            Some(angle) => moments.add(angle),
            None => deviation.disagreeing += u64::from(pair.covered != [0, 0]),
        }
        deviation.compared += u64::from(angle.is_some());
    }
    (deviation.mean, deviation.rms, deviation.max) = (moments.mean(), moments.rms(), moments.max);
    Ok(deviation)
}

/// The normal that a colour of [`Show::Normals`](crate::raster::Show::Normals) encodes.
fn normal(colour: [f64; 3]) -> DVec3 {
    DVec3::from(colour) * 2.0 - 1.0
}

/// The angle in degrees; `None` if one has no direction.
fn angle(a: DVec3, b: DVec3) -> Option<f64> {
    // What cancels leaves the rounding of single precision.
    const NOTHING: f64 = f32::EPSILON as f64;
    let angle = Degrees::from(Radians(libm::atan2(a.cross(b).length(), a.dot(b))));
    (a.length() > NOTHING && b.length() > NOTHING).then_some(angle.0)
}

#[cfg(test)]
mod tests {
    use super::super::pictures_tests::grey;
    use super::*;

    /// A picture of one row of normals.
    fn normals(list: &[DVec3]) -> Image {
        let mut image = grey([list.len() as u32, 1], |_, _| 0.0);
        image.linear = Some(list.iter().map(|&n| ((n + 1.0) * 0.5).as_vec3().to_array()).collect());
        image
    }

    fn turned(degrees: f64) -> DVec3 {
        let (sine, cosine) = libm::sincos(degrees.to_radians());
        DVec3::new(sine, 0.6 * cosine, 0.8 * cosine)
    }

    #[test]
    fn angles_are_those_given() {
        let angles = [0.0, 0.001, 5.0, 90.0, 179.0];
        let truth = normals(&[turned(0.0); 5]);
        let measured = normal_deviation(&normals(&angles.map(turned)), &truth).unwrap();
        for (angle, expected) in measured.angles.iter().zip(angles) {
            // Two codes in single precision on either side.
            assert!((angle.unwrap() - expected).abs() < 2e-5, "{angle:?} {expected}");
        }
        assert!((measured.mean - angles.iter().sum::<f64>() / 5.0).abs() < 1e-5);
        let square: f64 = angles.iter().map(|angle| angle * angle).sum();
        assert!((measured.rms - (square / 5.0).sqrt()).abs() < 1e-5 && (measured.max - 179.0).abs() < 2e-5);
    }

    #[test]
    fn what_is_not_in_both_is_distinguished() {
        let mut picture = normals(&[DVec3::X, DVec3::Y, DVec3::Z, DVec3::ZERO]);
        let mut truth = normals(&[DVec3::X; 4]);
        picture.coverage = vec![1, 0, 0, 1];
        truth.coverage = vec![1, 1, 0, 1];
        let measured = normal_deviation(&picture, &truth).unwrap();
        assert_eq!((measured.compared, measured.disagreeing, measured.max), (1, 2, 0.0));
        assert_eq!(measured.angles, [Some(0.0), None, None, None]);
        truth.linear = None;
        assert_eq!(normal_deviation(&picture, &truth), Err(MetricError::NoLinear));
    }
}
