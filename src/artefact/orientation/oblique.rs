//! The diamond seen obliquely, where triangles depend on the rotation unless they are interpolated with perspective.

use super::super::prelude::*;
use super::polygon::{Polygon, centre};

/// How far the eye is from the middle, over the distance of a corner from it.
const EYE: f64 = 2.0;

/// By how much the right side is turned away from the viewer, about the upright axis.
const AWAY: Degrees = Degrees(60.0);

/// Edges foreshorten: the shortest is three quarters as long as seen from in front, so corners that snap move its colours by so
/// many times as much.
const FORESHORTENED: f64 = 4.0 / 3.0;

fn camera() -> Camera {
    // The window of the frontal pictures, at the middle.
    let angle = Radians(2.0 * libm::atan(0.5 * Polygon::WINDOW / EYE));
    let projection = Projection::Perspective(angle);
    Camera { eye: DVec3::Z * EYE, target: DVec3::ZERO, up: DVec3::Y, projection, near: 0.1 }
}

/// By how much the colour at the centre changes by a quarter turn in the diamond's own plane.
fn change(diamond: &Polygon, size: u32, interpolation: Interpolation) -> Result<f64> {
    let oblique = DMat4::from_rotation_y(Radians::from(AWAY).0);
    let colour = |turn: f64| -> Result<DVec3> {
        Ok(centre(&diamond.draw_from(camera(), oblique, size, Degrees(turn), interpolation)?))
    };
    Ok((colour(90.0)? - colour(0.0)?).abs().max_element())
}

/// The change under scanlines, in triangles, and in triangles by perspective, against the law: of the ends of a line at depths
/// d ± s, the middle has the colours in parts of (d ∓ s)/2d when they are mixed by distances in the picture. That is the line
/// from corner 3 to corner 1 in one position; in the other scanlines run from corner 2 to corner 4, while the triangles' edge
/// is upright and has one depth.
pub(super) fn measure(diamond: &Polygon, size: u32, tolerance: f64, out: &mut Recorder) -> Result<()> {
    let triangles = diamond.cut(false)?;
    let [c1, c2, c3, c4] = Polygon::LECTURES.map(DVec3::from);
    let lean = libm::sin(Radians::from(AWAY).0) / EYE;
    // The left end is nearer, and so larger: the middle of the picture's line is beyond the middle of the edge.
    let mixed = |left: DVec3, right: DVec3| 0.5 * (left * (1.0 - lean) + right * (1.0 + lean));
    let largest = |a: DVec3, b: DVec3| (a - b).abs().max_element();
    let upright = mixed(c3, c1);
    for (name, polygon, interpolation, law) in [
        ("oblique-scanline", diamond, Interpolation::Scanline, largest(mixed(c2, c4), upright)),
        ("oblique-triangles", &triangles, Interpolation::Affine, largest(0.5 * (c1 + c3), upright)),
        ("oblique-perspective", &triangles, Interpolation::Perspective, 0.0),
    ] {
        let found = change(polygon, size, interpolation)?;
        out.measure(name, "", found, Check::Near(law, 2.0 * FORESHORTENED * tolerance));
    }
    Ok(())
}
