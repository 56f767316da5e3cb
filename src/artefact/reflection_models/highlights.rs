//! A sphere with nothing but a highlight: light from behind it, and the ratio of length to width of the highlight.

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

/// Half the width of a highlight at half height, as angles on the sphere: in the plane of light and view, and across it.
#[derive(Clone, Copy, Debug)]
pub(super) struct HalfWidths {
    along: f64,
    across: f64,
}

impl HalfWidths {
    /// Phong's: along, cos(2t) = q; across, 2 cos²(t) cos²(β/2) − cos β = q; q = 2^(−1/n).
    pub(super) fn of_phong(exponent: f64) -> Self {
        let beta = Radians::from(GRAZING).0;
        let q = libm::pow(2.0, -1.0 / exponent);
        let half = libm::cos(0.5 * beta);
        Self {
            along: 0.5 * libm::acos(q),
            across: libm::acos(((q + libm::cos(beta)).max(0.0) / (2.0 * half * half)).sqrt()),
        }
    }

    /// Blinn's, which is round: cos t = 2^(−1/n).
    pub(super) fn of_blinn(exponent: f64) -> Self {
        let angle = libm::acos(libm::pow(2.0, -1.0 / exponent));
        Self { along: angle, across: angle }
    }

    /// Measures the ratio of the widths across and along, against that of a highlight with a `height` for each normal. Returns how
    /// much the highlight is stretched, 0 if that is unknown.
    pub(super) fn measure(
        self,
        name: &str,
        image: &Image,
        height: impl Fn(DVec3) -> f64,
        out: &mut Recorder,
    ) -> f64 {
        let values = linear(image);
        let size = image.size[0];
        let drawn = |x, y| image.index(x, y).map_or(0.0, |i| f64::from(values[i][0]));
        let ratio = found(size, drawn);
        let check = self.check(size, height);
        out.measure(name, "", ratio, check);
        if let Check::Untested(_) = check { 0.0 } else { (ratio - 1.0).abs() }
    }

    fn check(self, size: u32, height: impl Fn(DVec3) -> f64) -> Check {
        let beta = Radians::from(GRAZING).0;
        // The highlight stands at β/2, where the picture shows cos(β/2) of its length.
        let pixels = self.along * libm::cos(0.5 * beta) * f64::from(size) / WINDOW;
        if self.along >= std::f64::consts::FRAC_PI_2 - 0.5 * beta || self.across > 1.0 {
            return Check::Untested("highlight-too-wide");
        }
        if pixels < 1.5 {
            return Check::Untested("highlight-too-narrow");
        }
        // Lines between pixel centres cut bells off and reach beyond the outline, as they do for heights of the closed form.
        let lines = found(size, |x, y| {
            let [x, y] = [x, y].map(|k| ((f64::from(k) + 0.5) / f64::from(size) - 0.5) * WINDOW);
            match 1.0 - x * x - y * y {
                of_z if of_z > 0.0 => height(DVec3::new(x, -y, of_z.sqrt())),
                _ => BACKGROUND.r,
            }
        });
        let ratio = self.across / self.along;
        Check::Near(ratio, (lines - ratio).abs() + 1e-3 * ratio)
    }
}

/// Light and viewer in front: how far the normal is from them, in degrees, where Blinn's highlight and Phong's are at half height.
pub(super) fn in_front(exponent: f64) -> [f64; 2] {
    let blinn = Degrees::from(Radians(HalfWidths::of_blinn(exponent).along)).0;
    [blinn, 0.5 * blinn]
}

/// The height of Phong's highlight where the normal is N: (R·V)ⁿ on the side of the light.
pub(super) fn phong_at(exponent: f64) -> impl Fn(DVec3) -> f64 {
    let (sine, cosine) = libm::sincos(Radians::from(GRAZING).0);
    move |n| match n.x * sine + n.z * cosine {
        of_light if of_light > 0.0 => libm::pow((2.0 * of_light * n.z - cosine).max(0.0), exponent),
        _ => 0.0,
    }
}

/// Blinn's: (N·H)ⁿ on the side of the light.
pub(super) fn blinn_at(exponent: f64) -> impl Fn(DVec3) -> f64 {
    let (sine, cosine) = libm::sincos(Radians::from(GRAZING).0);
    let (sine_of_half, cosine_of_half) = libm::sincos(0.5 * Radians::from(GRAZING).0);
    move |n| match n.x * sine + n.z * cosine {
        of_light if of_light > 0.0 => {
            libm::pow((n.x * sine_of_half + n.z * cosine_of_half).max(0.0), exponent)
        }
        _ => 0.0,
    }
}

/// The same ratio of heights at the pixels of a picture.
fn found(size: u32, height: impl Fn(u32, u32) -> f64) -> f64 {
    let (sine, cosine) = libm::sincos(0.5 * Radians::from(GRAZING).0);
    let (pixels, size) = (size, f64::from(size));
    // Between pixel centres, linearly.
    let at = |x: f64, y: f64| {
        let [x, y] = [x, -y].map(|c| (c / WINDOW + 0.5) * size - 0.5);
        let value = |dx: f64, dy: f64| {
            let [x, y] = [x.floor() + dx, y.floor() + dy].map(|k| k as u32);
            if x.max(y) < pixels { height(x, y) } else { 0.0 }
        };
        let (s, t) = (x - x.floor(), y - y.floor());
        (value(0.0, 0.0) * (1.0 - s) + value(1.0, 0.0) * s) * (1.0 - t)
            + (value(0.0, 1.0) * (1.0 - s) + value(1.0, 1.0) * s) * t
    };
    // The angle at which half height is reached, by halving.
    let half = |value: &dyn Fn(f64) -> f64| {
        let (mut low, mut high) = (0.0, std::f64::consts::FRAC_PI_2);
        for _ in 0..40 {
            let middle = 0.5 * (low + high);
            if value(middle) > 0.5 { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    };
    // Towards the viewer, where the sphere is seen less from the side.
    let along = half(&|t| at(sine * libm::cos(t) - cosine * libm::sin(t), 0.0));
    let across = half(&|t| at(sine * libm::cos(t), libm::sin(t)));
    across / along
}
