//! Sharp edges that averaged normals smooth away.

// A mesh rendered with averaged or split normals, compared with its faces.
mod lit_mesh;
// Meshes with sharp edges, whose faces share their vertices.
mod meshes;
// What averaging does to sharp edges.
#[cfg(test)]
mod tests;

use super::prelude::*;
use lit_mesh::{FULL_ANGLE, FULL_LIGHT, LitMesh, Rendering};

static TEXTS: Catalogue = catalogue!("texts");

pub(super) static EXPERIMENT: Experiment = Experiment {
    takes: &[
        ParameterName::Size,
        ParameterName::Light,
        ParameterName::Weight,
        ParameterName::Crease,
        ParameterName::Mesh,
    ],
    defaults: Parameters { light: Degrees(35.0), ..Parameters::USUAL },
    ..Experiment::new("false-smoothing", &TEXTS, run)
};

/// The lean of the strips of the zig-zag and of the roof.
const SLOPE: Degrees = Degrees(45.0);
/// The angle at the cube's corners: arctan √2.
const CUBE: f64 = 54.735_610_317_245_346;

fn run(setup: &Setup) -> Result<Outcome> {
    let crease = setup.parameters.crease.0;
    let mut out =
        Recorder::new(&TEXTS, &[("crease", Value::number(crease)), ("full-angle", FULL_ANGLE.into())]);
    if let Some(own) = &setup.mesh {
        return lit_mesh::run(own, &setup.parameters, out);
    }
    let effect = shapes(&setup.parameters, &mut out)?;
    Ok(out.finish(Verdict::Holds(out.text("holds")), effect))
}

/// The cube, the gear, the zig-zag and the roof, averaged and split. Returns the effect on the gear.
fn shapes(parameters: &Parameters, out: &mut Recorder) -> Result<Effect> {
    let &Parameters { size, light, weight, crease, .. } = parameters;
    let sheet = |leans: &[Degrees], light| {
        // Wider than the window, so that its ends are not visible.
        let mesh = meshes::folded(leans, 32)?;
        Ok::<_, ArtefactError>(LitMesh { mesh, camera: from_above(), light: light_at(light), size })
    };
    let pair = |mesh: &LitMesh| -> Result<[Rendering; 2]> {
        Ok([mesh.render(weight, Crease::OFF)?, mesh.render(weight, Crease::Angle(crease))?])
    };
    let folds = [SLOPE, Degrees(-SLOPE.0)];
    let gear_mesh = LitMesh::from_corner(meshes::gear()?, light, size)?;
    let cube = pair(&LitMesh::from_corner(meshes::cube()?, light, size)?)?;
    let gear = pair(&gear_mesh)?;
    let zigzag = pair(&sheet(&folds, light)?)?;
    let roof = pair(&sheet(&[SLOPE, Degrees(0.0), Degrees(-SLOPE.0), Degrees(0.0)], light)?)?;
    let [front_smooth, front_sharp] = pair(&sheet(&folds, Degrees(0.0))?)?;
    let right_angle = Degrees(90.0);
    // Corners at the sheets' ends, out of the picture, have one face only.
    for (shape, pair, law, edge) in [
        ("shape-cube", &cube, CUBE, right_angle),
        ("shape-zigzag", &zigzag, SLOPE.0, right_angle),
        ("shape-roof", &roof, 0.5 * SLOPE.0, SLOPE),
    ] {
        out.set("shape", out.text(shape));
        measure_angles(pair, law, edge, parameters, out);
    }
    out.measure("front-averaged", "", front_smooth.middle(), Check::Near(1.0, 1e-6));
    let law = libm::cos(Radians::from(SLOPE).0);
    out.measure("front-faces", "", front_sharp.true_middle(), Check::Near(law, 1e-6));
    out.measure("gear-share", "", gear[0].share_over(crease), Check::None);
    // The gear's bore, which is round, keeps half the angle between its facets.
    let check = match separates_gear(parameters) {
        true => Check::Near(180.0 / f64::from(meshes::BORE), 1e-9),
        false => Check::None,
    };
    out.measure("gear-bore", "°", gear[1].largest(), check);
    out.measure("gear-averaged", "°", gear[0].deviation.mean, Check::None);
    out.measure("gear-split", "°", gear[1].deviation.mean, Check::None);
    chart(&gear_mesh, weight, out);
    let ([gear_angles, gear_light], [cube_angles, _]) = (gear[0].maps(), cube[0].maps());
    let effect = show(["gear", "gear-split"], gear, out);
    out.difference("gear-angles", gear_angles, FULL_ANGLE, "°");
    out.difference("gear-light", gear_light, FULL_LIGHT, "");
    show(["cube", "cube-split"], cube, out);
    out.difference("cube-angles", cube_angles, FULL_ANGLE, "°");
    show(["zigzag", "zigzag-split"], zigzag, out);
    show(["roof", "roof-split"], roof, out);
    Ok(Effect { name: out.text("gear-effect"), ..effect })
}

/// A parallel view of a sheet that shows its profile at both ends.
fn from_above() -> Camera {
    Camera { eye: DVec3::new(0.0, 70.0, 100.0), ..front(6.0) }
}

fn show(names: [&'static str; 2], [smooth, sharp]: [Rendering; 2], out: &mut Recorder) -> Effect {
    let means = [smooth.deviation.mean, sharp.deviation.mean];
    let effect = out.effect("pixels", "°", means, Threshold::half_step_of_tilt(), 100.0);
    out.bad(names[0], &effect, smooth.lit);
    out.cured(names[1], &effect, sharp.lit);
    effect
}

/// The largest angle between a corner's normal and its face, averaged and split, with the law of the averaged one and the angle
/// of the edges.
fn measure_angles(
    [smooth, sharp]: &[Rendering; 2],
    law: f64,
    edge: Degrees,
    parameters: &Parameters,
    out: &mut Recorder,
) {
    let split_law = if parameters.crease.0 < edge.0 - 0.1 { 0.0 } else { law };
    for (name, rendering, law) in [("averaged", smooth, law), ("split", sharp, split_law)] {
        // A surface fitted to the vertices of a fold is not a mean of its faces.
        let check = if parameters.weight.is_fit() { Check::None } else { Check::Near(law, 1e-9) };
        out.measure(name, "°", rendering.largest(), check);
    }
}

/// Whether all of the gear is split but its bore: its teeth have edges of more than 60°, its bore of 7.5°.
fn separates_gear(parameters: &Parameters) -> bool {
    (8.0..60.0).contains(&parameters.crease.0) && !parameters.weight.is_fit()
}

fn chart(gear: &LitMesh, weight: Weight, out: &mut Recorder) {
    let points = (0..=36).map(|k| {
        let crease = Degrees(5.0 * f64::from(k));
        [crease.0, gear.mean_of_corners(weight, Crease::Angle(crease))]
    });
    let curve = out.curve("gear", Drawn::Line, points.collect());
    out.chart("error-by-crease-angle", [Axis::Linear; 2], vec![curve]);
}
