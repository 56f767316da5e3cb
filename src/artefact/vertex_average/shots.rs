//! The pictures, with what there is to see in them.

use super::super::own_mesh::{camera, light_from};
use super::super::stage::{chalk, differences, draw, map, object, settings, smooth};
use super::super::{ArtefactError, Language, Moved, Shot, Text};
use super::cuts::{CUTS, cut_box};
use super::specimen::{Look, Specimen};
use super::texts::TEXTS;
use super::{FLAT, LONG, ROUND, Shown, name_of};
use crate::normals::Weight;
use crate::raster::{Image, Interpolation, Shading, Show};
use glam::DVec3;

/// Full scale of the maps: of light, and of angles in degrees.
const FULL_LIGHT: f64 = 0.3;
const FULL_ANGLE: f64 = 5.0;

pub(super) fn all(
    weight: Weight,
    look: &Look,
    [torus, ball]: [&Specimen; 2],
    shown: &Shown,
) -> Result<Vec<Shot>, ArtefactError> {
    // The ball first: of these pictures the index shows the first of each kind, and bands are plain even when they are small.
    let mut shots = of_ball(weight, ball, shown)?;
    shots.extend(of_boxes(weight, look, shown)?);
    shots.extend(of_torus(weight, torus, &shown.torus)?);
    Ok(shots)
}

/// What is seen, and by which weights.
fn label(what: [&str; 2], weight: Weight) -> Text {
    Text::each(|language| {
        let what = what[usize::from(language == Language::Portuguese)];
        format!("{what}, {}", name_of(weight, language))
    })
}

fn of_boxes(weight: Weight, look: &Look, shown: &Shown) -> Result<Vec<Shot>, ArtefactError> {
    let Shown { cube, long, .. } = shown;
    let (one, other) = (cut(DVec3::ONE, 0, weight, look)?, cut(DVec3::ONE, CUTS - 1, weight, look)?);
    let between = map(one.size, &differences(&one, &other), FULL_LIGHT);
    Ok(vec![
        cube.bad_shot(
            "cube-1",
            label(["cube cut one way", "cubo cortado de um modo"], weight),
            [TEXTS.get("cube-1-title"), TEXTS.get("cube-1-caption-some-corners-lean")],
            one,
        ),
        cube.bad_shot(
            "cube-2",
            label(["cut the other way", "cortado do outro modo"], weight),
            [TEXTS.get("cube-2-title"), TEXTS.get("cube-2-caption-light-shadow-elsewhere")],
            other,
        ),
        Shot::difference(
            "cube-difference",
            TEXTS.get("cube-difference-title"),
            TEXTS.with("cube-difference-caption-how-far-both", &[("full-light", FULL_LIGHT.into())]),
            between,
        ),
        cube.cured_shot(
            "cube-angle",
            label(["cube", "cubo"], FLAT),
            [TEXTS.get("cube-angle-title"), TEXTS.get("cube-angle-caption-every-corner-diagonal")],
            cut(DVec3::ONE, 0, FLAT, look)?,
        ),
        long.bad_shot(
            "box-max",
            label(["box", "caixa"], ROUND),
            [TEXTS.get("box-max-title"), TEXTS.get("box-max-caption-normals-lean-towards")],
            cut(LONG, 0, ROUND, look)?,
        ),
        long.cured_shot(
            "box-angle",
            label(["box", "caixa"], FLAT),
            [TEXTS.get("box-angle-title"), TEXTS.get("box-angle-caption-each-three-faces")],
            cut(LONG, 0, FLAT, look)?,
        ),
    ])
}

fn of_ball(weight: Weight, ball: &Specimen, shown: &Shown) -> Result<Vec<Shot>, ArtefactError> {
    let of = ["slivers", "lascas"];
    let slivers = &shown.slivers;
    let by_angle = Moved { bad: shown.slivers_by_angle, ..slivers.clone() };
    Ok(vec![
        slivers.bad_shot(
            "slivers",
            label(of, weight),
            [TEXTS.get("slivers-title"), TEXTS.get("slivers-caption-rows-show-bands")],
            ball.picture(weight)?,
        ),
        by_angle.bad_shot(
            "slivers-angle",
            label(of, FLAT),
            [TEXTS.get("slivers-angle-title"), TEXTS.get("slivers-angle-caption-sliver-between-vertices")],
            ball.picture(FLAT)?,
        ),
        by_angle.cured_shot(
            "slivers-max",
            label(of, ROUND),
            [TEXTS.get("slivers-max-title"), TEXTS.get("slivers-max-caption-they-exact-every")],
            ball.picture(ROUND)?,
        ),
        error_map("slivers-error", of, ball, weight)?,
    ])
}

fn of_torus(weight: Weight, torus: &Specimen, moved: &Moved) -> Result<Vec<Shot>, ArtefactError> {
    let of = ["irregular torus", "toro irregular"];
    Ok(vec![
        moved.bad_shot(
            "torus",
            label(of, weight),
            [TEXTS.get("torus-title"), TEXTS.get("torus-caption-light-uneven")],
            torus.picture(weight)?,
        ),
        moved.cured_shot(
            "torus-max",
            label(of, ROUND),
            [TEXTS.get("torus-max-title"), TEXTS.get("torus-max-caption-light-more-even")],
            torus.picture(ROUND)?,
        ),
        error_map("torus-error", of, torus, weight)?,
        Shot::truth(
            "torus-itself",
            TEXTS.get("torus-itself-title"),
            TEXTS.get("torus-itself-caption-torus-own-normal"),
            torus.truth(Show::Shaded)?,
        ),
    ])
}

fn error_map(
    name: &'static str,
    [en, pt]: [&str; 2],
    specimen: &Specimen,
    weight: Weight,
) -> Result<Shot, ArtefactError> {
    let caption = Text::made(
        format!("The angle between interpolated and true normals: violet 0°, yellow {FULL_ANGLE}° and more."),
        format!(
            "O ângulo entre normais interpoladas e verdadeiras: violeta 0°, amarelo {FULL_ANGLE}° ou mais."
        ),
    );
    let label = label([&format!("{en}, error"), &format!("{pt}, erro")], weight);
    Ok(Shot::difference(name, label, caption, specimen.error_map(weight, FULL_ANGLE)?))
}

/// A box whose corners are smoothed.
fn cut(sides: DVec3, cut: u32, weight: Weight, look: &Look) -> Result<Image, ArtefactError> {
    let mesh = cut_box(sides, cut)?;
    let field = smooth(&mesh, weight);
    let object = object(&mesh, &field, chalk());
    let camera = camera(std::slice::from_ref(&object));
    let settings = settings([look.size; 2], Shading::Phong, Interpolation::Perspective);
    draw(vec![object], &[light_from(&camera, look.light)?], camera, &settings)
}
