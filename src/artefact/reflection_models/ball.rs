//! A sphere with nothing but a highlight, and light from behind it, which leaves a highlight on the dark side.

use super::super::prelude::*;
use crate::shade::Guards;

/// Light far round the sphere.
pub(super) const GRAZING: Degrees = Degrees(120.0);
/// The window's side; the sphere has the radius 1.
pub(super) const WINDOW: f64 = 2.2;

pub(super) fn ball(
    reflection: Reflection,
    exponent: f64,
    light: Degrees,
    guards: Guards,
    size: u32,
) -> Result<Image> {
    let material = Material { reflection, ..shiny([0.0, 1.0], exponent) };
    let sphere = Object::new(Shape::Surface(Primitive::from(Sphere::default())), material);
    let settings = RenderSettings { guards, ..settings([size; 2], Shading::Exact) };
    draw(vec![sphere], &[light_at(light)], front(WINDOW), settings)
}

/// Light almost behind the sphere.
pub(super) const BEHIND: Degrees = Degrees(150.0);

/// The normal of the sphere at a pixel of a picture of this size.
fn normal(pixel: u32, size: u32) -> Option<DVec3> {
    let place = |k: u32| ((f64::from(k) + 0.5) / f64::from(size) - 0.5) * WINDOW;
    let (x, y) = (place(pixel % size), place(pixel / size));
    let square = 1.0 - x * x - y * y;
    (square > 0.0).then(|| DVec3::new(x, y, square.sqrt()))
}

/// Pixels with N·L < 0, by more than single precision leaves open.
fn turned_away(size: u32) -> impl Iterator<Item = (usize, DVec3)> {
    let pixels = (0..size * size).filter_map(move |pixel| Some((pixel as usize, normal(pixel, size)?)));
    pixels.filter(|(_, normal)| normal.dot(direction(BEHIND)) < -1e-6)
}

fn brightest(image: &Image) -> f64 {
    let pixels = linear(image);
    turned_away(image.size[0]).map(|(pixel, _)| f64::from(pixels[pixel][0])).fold(0.0, f64::max)
}

/// The same by the formula: Blinn's (N·H)ⁿ or Phong's (R·V)ⁿ.
fn law(reflection: Reflection, exponent: f64, size: u32) -> f64 {
    let light = direction(BEHIND);
    let half = (light + DVec3::Z).normalize();
    let cosine = |normal: DVec3| match reflection {
        Reflection::Blinn => normal.dot(half),
        Reflection::Phong => (2.0 * normal.dot(light) * normal - light).z,
    };
    let highlight = |(_, normal): (usize, DVec3)| libm::pow(cosine(normal).max(0.0), exponent);
    turned_away(size).map(highlight).fold(0.0, f64::max)
}

/// Records one model's highlight under light from behind, without the guard and with it.
pub(super) fn record_light_behind(
    reflection: Reflection,
    exponent: f64,
    size: u32,
    out: &mut Recorder,
) -> Result<()> {
    let [bad, guarded] = match reflection {
        Reflection::Phong => ["behind-phong", "behind-phong-guarded"],
        Reflection::Blinn => ["behind", "behind-guarded"],
    };
    let on = Guards::default();
    let off = Guards { highlight: false, ..on };
    let draw = |guards| ball(reflection, exponent, BEHIND, guards, size);
    let (without, with) = (draw(off)?, draw(on)?);
    let numbers = [brightest(&without), brightest(&with)];
    let law = law(reflection, exponent, size);
    out.measure(bad, "", numbers[0], Check::Near(law, 1e-6 * (1.0 + exponent)));
    out.measure(guarded, "", numbers[1], Check::Near(0.0, 0.0));
    let effect = out.effect("behind", "", numbers, Threshold::half_step(), 5.0);
    out.bad(bad, &effect, without);
    out.cured(guarded, &effect, with);
    Ok(())
}
