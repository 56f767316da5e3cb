//! The pictures: a box and a plate under a near lamp, and a plate before a near viewer.

use super::super::stage::{chalk, draw, front, object, settings};
use super::super::{ArtefactError, Moved, Shot, Threshold};
use super::texts::TEXTS;
use super::{Lamp, RADIUS, RATIOS, Viewer, paint_plate, squares};
use crate::metric::image_error;
use crate::normals::{NormalRecipe, compute};
use crate::num::{Degrees, LinearRgb};
use crate::raster::{Camera, Image, Interpolation, Shading};
use crate::shade::{Attenuation, Light};
use glam::DVec3;

/// The plate that the number that moves is measured on.
pub(super) fn of_plate(
    lamp: &Lamp,
    moved: &Moved,
    segments: u32,
    size: u32,
) -> Result<Vec<Shot>, ArtefactError> {
    let paint = |cells| paint_plate(cells, chalk(), lamp.light(), front(2.0), size, Shading::Flat);
    Ok(vec![
        moved.bad_shot(
            "plate",
            TEXTS.get("plate-title"),
            [TEXTS.get("plate-caption-plate-under-lamp"), TEXTS.get("plate-caption-all-grey")],
            paint(1)?,
        ),
        moved.cured_shot(
            "plate-small-faces",
            TEXTS.get("plate-small-faces-title"),
            [
                TEXTS.with("plate-small-faces-caption-same-plate-cut", &[("segments", segments.into())]),
                TEXTS.get("plate-small-faces-caption-light-falls-off"),
            ],
            paint(segments)?,
        ),
    ])
}

/// A box under a lamp that is near its upper corner, and far away in the same direction.
pub(super) fn of_box(size: u32, segments: u32) -> Result<Vec<Shot>, ArtefactError> {
    let sides = [
        (DVec3::new(-1.0, -1.0, 1.0), DVec3::X * 2.0, DVec3::Y * 2.0),
        (DVec3::new(1.0, -1.0, 1.0), DVec3::Z * -2.0, DVec3::Y * 2.0),
        (DVec3::new(-1.0, 1.0, 1.0), DVec3::X * 2.0, DVec3::Z * -2.0),
    ];
    let camera = Camera { eye: DVec3::new(60.0, 45.0, 80.0), ..front(3.8) };
    let lamp = DVec3::new(1.5, 1.8, 2.1);
    let paint = |cells: u32, away: f64, shading| -> Result<Image, ArtefactError> {
        let mesh = squares(cells, &sides)?;
        let normals = compute(&mesh, &NormalRecipe::default());
        let light =
            Light::Point { position: lamp * away, colour: LinearRgb::WHITE, attenuation: Attenuation::None };
        let settings = settings([size; 2], shading, Interpolation::Perspective);
        draw(vec![object(&mesh, &normals, chalk())], &[light], camera, &settings)
    };
    let near = paint(1, 1.0, Shading::Phong)?;
    let [flat, cut_up] = [1, segments].map(|cells| paint(cells, 1.0, Shading::Flat));
    let (flat, cut_up, far) = (flat?, cut_up?, paint(1, 100.0, Shading::Flat)?);
    let off = |image: &Image, truth: &Image| {
        Ok::<f64, ArtefactError>(image_error(image, truth, 0.5)?.linear.max / 255.0)
    };
    let small = Moved {
        name: TEXTS.get("moved-largest-error-pixel"),
        unit: "",
        bad: off(&flat, &near)?,
        present: Threshold::HALF_STEP,
        cure: TEXTS.get("cure-smaller-faces"),
        cured: off(&cut_up, &near)?,
        // Of faces a third as long already.
        factor: 2.0,
    };
    let away = Moved { cured: off(&far, &paint(1, 100.0, Shading::Phong)?)?, factor: 10.0, ..small.clone() };
    Ok(vec![
        small.bad_shot(
            "flat",
            TEXTS.get("flat-title"),
            [TEXTS.get("flat-caption-lamp-stands-near"), TEXTS.get("flat-caption-but-each-side")],
            flat,
        ),
        Shot::truth(
            "every-pixel",
            TEXTS.get("every-pixel-title"),
            TEXTS.get("every-pixel-caption-lit-every-pixel"),
            near,
        ),
        small.cured_shot(
            "flat-small-faces",
            TEXTS.get("flat-small-faces-title"),
            [
                TEXTS.with("flat-small-faces-caption-same-flat-shading", &[("segments", segments.into())]),
                TEXTS.get("flat-small-faces-caption-closer-truth"),
            ],
            cut_up,
        ),
        away.cured_shot(
            "flat-lamp-far",
            TEXTS.get("flat-lamp-far-title"),
            [
                TEXTS.get("flat-lamp-far-caption-lamp-moved-hundred"),
                TEXTS.get("flat-lamp-far-caption-now-colour-side"),
            ],
            far,
        ),
    ])
}

/// How far to the side the light stands whose highlight a near viewer sees on the plate: closer to the axis than its edges.
pub(super) const ASIDE: Degrees = Degrees(15.0);

/// The plate with nothing but a highlight, its viewer at two circumradii.
pub(super) fn of_highlight(exponent: f64, segments: u32, size: u32) -> Result<Vec<Shot>, ArtefactError> {
    let viewer = Viewer { angle: ASIDE, distance: RATIOS[0] * RADIUS, exponent };
    let (material, light, camera) = viewer.scene();
    let paint = |cells, shading| paint_plate(cells, material, light, camera, size, shading);
    let small = Moved {
        name: TEXTS.with("moved-largest-error-highlight", &[("value", ASIDE.0.into())]),
        unit: "",
        bad: viewer.error(1, size)?,
        present: Threshold::HALF_STEP,
        cure: TEXTS.get("cure-smaller-faces"),
        cured: viewer.error(segments, size)?,
        // Of a few steps less the squares are still seen.
        factor: 20.0,
    };
    Ok(vec![
        small.bad_shot(
            "highlight",
            TEXTS.get("highlight-title"),
            [
                TEXTS.with(
                    "highlight-caption-plate-nothing-but",
                    &[("exponent", exponent.into()), ("value", ASIDE.0.into())],
                ),
                TEXTS.get("highlight-caption-grey-middle-no"),
            ],
            paint(1, Shading::Flat)?,
        ),
        Shot::truth(
            "highlight-every-pixel",
            TEXTS.get("highlight-every-pixel-title"),
            TEXTS.get("highlight-every-pixel-caption-lit-every-pixel"),
            paint(1, Shading::Phong)?,
        ),
        small.cured_shot(
            "highlight-small-faces",
            TEXTS.get("highlight-small-faces-title"),
            [
                TEXTS.with(
                    "highlight-small-faces-caption-flat-shading-segments",
                    &[("segments", segments.into())],
                ),
                TEXTS.get("highlight-small-faces-caption-highlight-place-steps"),
            ],
            paint(segments, Shading::Flat)?,
        ),
    ])
}
