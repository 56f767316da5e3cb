//! A cube and a long box, whose faces are cut in all ways.

use super::super::prelude::*;
use super::box_cuts::{CUTS, cut_box, law, measured};
use super::lit_surface::View;
use super::weights::{FLAT, ROUND};

/// The sides of the cube and of the long box.
pub(super) const CUBE: DVec3 = DVec3::ONE;
pub(super) const LONG: DVec3 = DVec3::new(10.0, 1.0, 1.0);
/// Full scale of the map of light.
const FULL_LIGHT: f64 = 0.3;

/// Over all corners and all 64 cuts: the largest angle, and the others that are of interest.
pub(super) fn measure(weight: Weight, out: &mut Recorder) -> Result<()> {
    let check = |law: Option<f64>| law.map_or(Check::None, |law| Check::Near(law, 1e-9));
    let [cube_law, long_law] = [CUBE, LONG].map(|sides| law(sides, weight));
    let cube = measured(CUBE, weight)?;
    out.measure("cube-largest", "°", cube.largest, check(cube_law.map(|law| law.largest)));
    if cube.next < cube.largest {
        out.measure("cube-next", "°", cube.next, check(cube_law.map(|law| law.next)));
    }
    let long = measured(LONG, weight)?;
    out.measure("box-largest", "°", long.largest, check(long_law.map(|law| law.largest)));
    if long.least > 1.0 {
        out.measure("box-least", "°", long.least, check(long_law.map(|law| law.least)));
    }
    Ok(())
}

/// The largest angle on a box by some weights, and by those that do not depend on the cut.
pub(super) fn effect(name: &str, sides: DVec3, weight: Weight, out: &Recorder) -> Result<Effect> {
    let angles = [measured(sides, weight)?.largest, measured(sides, FLAT)?.largest];
    Ok(out.effect(name, "°", angles, Threshold::half_step_of_tilt(), 1000.0))
}

/// The cube in two cuts, and the long box by Max's weights, which favour its ends.
pub(super) fn show(of_cube: &Effect, weight: Weight, view: &View, out: &mut Recorder) -> Result<()> {
    let of_box = effect("box", LONG, ROUND, out)?;
    let (one, other) = (draw_box(CUBE, 0, weight, view)?, draw_box(CUBE, CUTS - 1, weight, view)?);
    let between = map(one.size, &differences(&one, &other), FULL_LIGHT);
    out.set("full-light", FULL_LIGHT);
    out.bad("cube-1", of_cube, one);
    out.bad("cube-2", of_cube, other);
    out.difference("cube-difference", between);
    out.cured("cube-angle", of_cube, draw_box(CUBE, 0, FLAT, view)?);
    out.bad("box-max", &of_box, draw_box(LONG, 0, ROUND, view)?);
    out.cured("box-angle", &of_box, draw_box(LONG, 0, FLAT, view)?);
    Ok(())
}

/// A box whose corners are smoothed.
fn draw_box(sides: DVec3, cut: u32, weight: Weight, view: &View) -> Result<Image> {
    let mesh = cut_box(sides, cut)?;
    let field = smooth(&mesh, weight);
    let object = object(&mesh, &field, chalk());
    let camera = camera(std::slice::from_ref(&object));
    let settings = settings([view.size; 2], Shading::Phong, Interpolation::Perspective);
    draw(vec![object], &[light_from(&camera, view.light)?], camera, &settings)
}
