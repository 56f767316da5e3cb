//! The counter-example: light from the side, under which Phong shading has the larger jumps of slope (Duff 1979).

use super::super::prelude::*;
use super::laws::{gouraud_jump, phong_jump};
use super::tube::Tube;
use std::f64::consts::PI;

/// Light in which Phong's shading is the worse one.
pub(super) const GRAZING: Degrees = Degrees(80.0);
/// The light at which Phong's jump half-way between viewer and light is as large as Gouraud's: arccos(1/3).
const BORDER: f64 = 70.528_779_365_509_31;
/// How much larger their ratio is a degree farther on: cot(θ_L/2) + tan(θ_L) there, per radian.
const GROWTH: f64 = 3.0 * std::f64::consts::SQRT_2 * PI / 180.0;

pub(super) fn measure(segments: u32, out: &mut Recorder) -> Result<()> {
    let (worst, open) = ratio(GRAZING, segments)?;
    let (border, open_there) = border(segments)?;
    let theta = half(GRAZING);
    let delta = 2.0 * PI / f64::from(segments);
    let law = phong_jump(theta, GRAZING, delta) / gouraud_jump(theta, GRAZING, delta);
    // The facets beside the edge have to be lit as a whole: half of 80° and one facet are less than 90° then.
    let check = |value, tolerance| match theta + delta > PI / 2.0 {
        true => Check::Untested("facets-lit-in-part"),
        false => Check::Near(value, tolerance),
    };
    out.measure("grazing-ratio", "", worst, check(law, open));
    out.measure("border-angle", "°", border, check(BORDER, open_there / GROWTH + RESOLVED));
    Ok(())
}

fn half(Degrees(angle): Degrees) -> f64 {
    Radians::from(Degrees(angle / 2.0)).0
}

/// Phong's slope jump over Gouraud's at the edge where it is worst, half-way between the viewer and the light, and how far
/// roundings may move that.
fn ratio(light: Degrees, segments: u32) -> Result<(f64, f64)> {
    let tube = Tube::new(segments, half(light))?;
    let jump = |shading| tube.profile(light, shading).map(|line| line.slope_jump(&tube, half(light)));
    let ((phong, by_phong), (gouraud, by_gouraud)) = (jump(Shading::Phong)?, jump(Shading::Gouraud)?);
    let ratio = phong / gouraud;
    Ok((ratio, ratio.abs() * (by_phong / phong.abs() + by_gouraud / gouraud.abs())))
}

/// How far halving leaves the angle open.
const RESOLVED: f64 = 20.0 / 2048.0;

/// The angle of the light at which Phong's jump is as large as Gouraud's, in degrees, by halving; and how far roundings may
/// move the ratio there.
fn border(segments: u32) -> Result<(f64, f64)> {
    let (mut low, mut high, mut open) = (60.0, 80.0, 0.0);
    for _ in 0..10 {
        let middle = 0.5 * (low + high);
        let (ratio, moved) = ratio(Degrees(middle), segments)?;
        open = moved;
        if ratio.abs() > 1.0 { high = middle } else { low = middle }
    }
    Ok((0.5 * (low + high), open))
}
