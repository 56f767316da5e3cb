//! How luminance breaks at the edges of a mesh.

use super::MetricError;
use super::luminance::luminances;
use crate::num::least_squares;
use crate::raster::{Image, Samples};
use serde::Serialize;

/// How luminance changes from one side of an edge to the other, at the middle of the edge.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct EdgeJump {
    /// Where, in pixels.
    pub at: [f64; 2],
    /// Y beyond the edge less Y before it, going right (down, for edges more across than upright): what flat shading has.
    pub step: f64,
    /// The slope across the edge beyond it less that before, in Y per pixel at right angles to the edge: what Gouraud and Phong
    /// shading have. Mach's bands appear where this is large.
    pub slope: f64,
    /// The larger of both slopes across the edge, as a magnitude. A jump is sharper the larger it is beside this one.
    pub steepest: f64,
}

/// Measures steps and breaks of slope of luminance Y at straight edges that are given on the picture.
///
/// On the row (for edges more across than upright: the column) of pixels through the middle of each edge, a parabola is
/// fitted to the `reach` nearest pixels on either side that the edge does not touch; both are continued to the edge, where
/// their values and slopes are compared. On a row the slope of what is the same along the edge is cos φ of that across it,
/// φ the angle between row and normal; it is divided out.
///
/// *Accuracy*: exact for luminance that is quadratic on both sides; else the slope is off by about Y‴·reach²/4. Choose a
/// reach that stays in the faces on either side. *Claims* a property of the picture. *Does not claim* a visible
/// band: see [`Profile`](super::Profile).
///
/// `None` for edges on whose row not all of these pixels are covered by all of their samples: outlines, edges near them, edges
/// out of the picture; and for edges without length.
///
/// # Errors
/// A picture without linear colours; a reach below 3.
pub fn slope_jumps(
    image: &Image,
    samples: Samples,
    edges: &[[[f64; 2]; 2]],
    reach: u32,
) -> Result<Vec<Option<EdgeJump>>, MetricError> {
    if reach < 3 {
        return Err(MetricError::Reach(reach));
    }
    let luminances = luminances(image)?;
    let full = samples.count();
    let value = |x: f64, y: f64| {
        let index = (x >= 0.0 && y >= 0.0).then(|| image.index(x as u32, y as u32)).flatten()?;
        (usize::from(image.coverage[index]) == full).then(|| luminances[index])
    };
    Ok(edges.iter().map(|edge| jump(edge, reach, value)).collect())
}

fn jump([a, b]: &[[f64; 2]; 2], reach: u32, value: impl Fn(f64, f64) -> Option<f64>) -> Option<EdgeJump> {
    let along = [b[0] - a[0], b[1] - a[1]];
    let length = libm::hypot(along[0], along[1]);
    if !(length > 0.0 && length.is_finite()) {
        return None;
    }
    // The axis that pixels are taken along, and the other one.
    let axis = usize::from(along[1].abs() < along[0].abs());
    let other = 1 - axis;
    let per_row = along[axis] / along[other];
    let row = (0.5 * (a[other] + b[other])).floor() + 0.5;
    let crossing = a[axis] + (row - a[other]) * per_row;
    let cosine = along[other].abs() / length;
    // Pixels nearer than this are touched by the edge.
    let nearest = 0.5 * (1.0 + per_row.abs());
    let side = |sign: f64| -> Option<[f64; 3]> {
        let first = match sign > 0.0 {
            true => (crossing + nearest - 0.5).ceil() + 0.5,
            false => (crossing - nearest + 0.5).floor() - 0.5,
        };
        let places: Vec<f64> = (0..reach).map(|n| first + sign * f64::from(n)).collect();
        let at = |place: f64| if axis == 0 { value(place, row) } else { value(row, place) };
        let mut right = places.iter().map(|&place| at(place)).collect::<Option<Vec<f64>>>()?;
        let mut offsets: Vec<f64> = places.iter().map(|place| place - crossing).collect();
        let mut squares: Vec<f64> = offsets.iter().map(|t| t * t).collect();
        let mut ones = vec![1.0; offsets.len()];
        least_squares(&mut [&mut ones, &mut offsets, &mut squares], &mut right)
    };
    let (before, beyond) = (side(-1.0)?, side(1.0)?);
    let mut at = [crossing; 2];
    at[other] = row;
    Some(EdgeJump {
        at,
        step: beyond[0] - before[0],
        slope: (beyond[1] - before[1]) / cosine,
        steepest: before[1].abs().max(beyond[1].abs()) / cosine,
    })
}

#[cfg(test)]
mod tests {
    use super::super::pictures_tests::grey;
    use super::*;

    /// Parabolas on both sides of lines of all directions.
    #[test]
    fn breaks_of_parabolas_are_exact() {
        for degrees in [0.0, 20.0, 44.0, 46.0, 90.0, 133.0_f64] {
            let (sine, cosine) = libm::sincos(degrees.to_radians());
            // The distance beyond an edge through (20.3, 20.1) with the normal (cosine, sine).
            let beyond = |x: f64, y: f64| (x - 20.3) * cosine + (y - 20.1) * sine;
            let image = grey([40, 40], |x, y| {
                let t = beyond(x, y);
                let (step, slope) = if t > 0.0 { (0.125, 0.03) } else { (0.0, -0.01) };
                0.5 + step + slope * t + 0.001 * t * t
            });
            let edge = |half: f64| {
                [[20.3 - half * sine, 20.1 + half * cosine], [20.3 + half * sine, 20.1 - half * cosine]]
            };
            let edges = [edge(5.0), edge(0.0)];
            let found = slope_jumps(&image, Samples::One, &edges, 6).unwrap();
            let jump = found[0].unwrap();
            // Going right or down may be going back across the edge; single precision leaves 6e-8, the fit some ten times that.
            let upright = cosine.abs() >= sine.abs();
            let sign = if (upright && cosine > 0.0) || (!upright && sine > 0.0) { 1.0 } else { -1.0 };
            assert!((jump.step - sign * 0.125).abs() < 2e-6, "{degrees}: {jump:?}");
            assert!((jump.slope - 0.04).abs() < 2e-6, "{degrees}: {jump:?}");
            assert!((jump.steepest - 0.03).abs() < 2e-6, "{degrees}: {jump:?}");
            assert_eq!(found[1], None, "no length");
        }
    }

    #[test]
    fn what_cannot_be_measured_is_left_out() {
        let image = grey([20, 20], |x, _| x);
        let upright = |x: f64| [[x, 5.0], [x, 15.0]];
        let found =
            slope_jumps(&image, Samples::One, &[upright(10.0), upright(2.0), upright(30.0)], 4).unwrap();
        assert!(found[0].is_some_and(|jump| jump.slope.abs() < 1e-6 && (jump.steepest - 1.0).abs() < 1e-6));
        assert_eq!(found[1..], [None, None]);
        assert_eq!(slope_jumps(&image, Samples::One, &[], 2), Err(MetricError::Reach(2)));
        assert_eq!(slope_jumps(&image, Samples::Four, &[upright(10.0)], 4), Ok(vec![None]));
    }
}
