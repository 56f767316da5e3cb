//! The pictures: a box and a plate under a near lamp, and a plate before a near viewer.

use super::super::prelude::*;
use super::plate::{Lamp, RADIUS, RATIOS, Viewer, paint_plate, squares};

/// The plate on which the effect is measured.
pub(super) fn of_plate(
    lamp: &Lamp,
    effect: &Effect,
    segments: u32,
    size: u32,
    out: &mut Recorder,
) -> Result<()> {
    let paint = |cells| paint_plate(cells, chalk(), lamp.light(), front(2.0), size, Shading::Flat);
    out.bad("plate", effect, paint(1)?);
    out.cured("plate-small-faces", effect, paint(segments)?);
    Ok(())
}

/// A box under a lamp that is near its upper corner, and far away in the same direction.
pub(super) fn of_box(size: u32, segments: u32, out: &mut Recorder) -> Result<()> {
    let sides = [
        (DVec3::new(-1.0, -1.0, 1.0), DVec3::X * 2.0, DVec3::Y * 2.0),
        (DVec3::new(1.0, -1.0, 1.0), DVec3::Z * -2.0, DVec3::Y * 2.0),
        (DVec3::new(-1.0, 1.0, 1.0), DVec3::X * 2.0, DVec3::Z * -2.0),
    ];
    let camera = Camera { eye: DVec3::new(60.0, 45.0, 80.0), ..front(3.8) };
    let lamp = DVec3::new(1.5, 1.8, 2.1);
    let paint = |cells: u32, away: f64, shading| -> Result<Image> {
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
    // Of faces a third as long already.
    let errors = [off(&flat, &near)?, off(&cut_up, &near)?];
    let small = out.effect("small-faces", "", errors, Threshold::half_step(), 2.0);
    let cured = off(&far, &paint(1, 100.0, Shading::Phong)?)?;
    let away = Effect { cured, factor: 10.0, ..small.clone() };
    out.bad("flat", &small, flat);
    out.truth("every-pixel", near);
    out.cured("flat-small-faces", &small, cut_up);
    out.cured("flat-lamp-far", &away, far);
    Ok(())
}

/// How far to the side the light stands whose highlight a near viewer sees on the plate: closer to the axis than its edges.
pub(super) const ASIDE: Degrees = Degrees(15.0);

/// The plate with nothing but a highlight, its viewer at two circumradii.
pub(super) fn of_highlight(exponent: f64, segments: u32, size: u32, out: &mut Recorder) -> Result<()> {
    let viewer = Viewer { angle: ASIDE, distance: RATIOS[0] * RADIUS, exponent };
    let (material, light, camera) = viewer.scene();
    let paint = |cells, shading| paint_plate(cells, material, light, camera, size, shading);
    // With an error that is only a few steps smaller the squares would still be seen.
    let errors = [viewer.error(1, size)?, viewer.error(segments, size)?];
    let effect = out.effect("highlight", "", errors, Threshold::half_step(), 20.0);
    out.bad("highlight", &effect, paint(1, Shading::Flat)?);
    out.truth("highlight-every-pixel", paint(1, Shading::Phong)?);
    out.cured("highlight-small-faces", &effect, paint(segments, Shading::Flat)?);
    Ok(())
}
