//! Refraction: a stick in water and a glass ball, against Snell's law in closed form.

// The scenes: rays through water and glass, and the position on a screen that each ray meets.
mod rays;

use super::prelude::*;
use rays::{Ball, Water};

static TEXTS: Catalogue = catalogue!("texts");

pub(super) static EXPERIMENT: Experiment = Experiment {
    takes: &[ParameterName::Size, ParameterName::Light],
    ..Experiment::new("refraction", &TEXTS, run)
};

/// The refractive indices of water and of glass.
const WATER: f64 = 1.333;
const GLASS: f64 = 1.5;
/// The angles from the vertical at which the depth of water is measured.
const ANGLES: [f64; 4] = [1.0, 20.0, 50.0, 75.0];
/// The angle from the vertical of the pictures of water.
const SEEN_FROM: Degrees = Degrees(50.0);
/// The heights of rays above the axis of the ball, in radii.
const HEIGHTS: [f64; 3] = [0.05, 0.3, 0.7];
/// Rounding of positions on the screen, which are colours in single precision.
const ROUNDING: f64 = 2e-4;

fn run(setup: &Setup) -> Result<Outcome> {
    let Parameters { size, light, .. } = setup.parameters;
    let mut out = Recorder::new(
        &TEXTS,
        &[("water", WATER.into()), ("glass", GLASS.into()), ("angle", SEEN_FROM.0.into())],
    );
    let mut depths = Vec::new();
    for angle in ANGLES {
        out.set("view", angle);
        let depth = Water { ior: WATER }.apparent_depth(Degrees(angle))?;
        out.measure("depth", "", depth, Check::Near(apparent_depth(Degrees(angle)), ROUNDING));
        depths.push([angle, depth]);
    }
    let mut lengths = Vec::new();
    for height in HEIGHTS {
        out.set("height", height);
        let length = Ball { ior: GLASS }.focal_length(height)?;
        // Rounding at the screen, over the slope of the ray.
        out.measure("focus", "R", length, Check::Near(focal_length(height), ROUNDING / height));
        lengths.push([height, length]);
    }
    // A ray at a height of h is off the limit by about h² of it.
    let paraxial = GLASS / (2.0 * (GLASS - 1.0));
    out.measure(
        "paraxial",
        "R",
        lengths[0][1],
        Check::Near(paraxial, HEIGHTS[0] * HEIGHTS[0] * paraxial + ROUNDING / HEIGHTS[0]),
    );
    let effect = effect(size, &out)?;
    let law = 1.0 / focal_length(HEIGHTS[1]);
    let off = [law, (1.0 / lengths[1][1] - law).abs()];
    let present = Threshold { value: 0.005, why: out.text("why-power") };
    let focus = out.effect("power", "1/R", off, present, 100.0);
    let draw_water = |ior| Water { ior }.picture(SEEN_FROM, light, size);
    let draw_ball = |ior| Ball { ior }.picture(light, size);
    out.bad("stick-straight", &effect, draw_water(1.0)?);
    out.cured("stick", &effect, draw_water(WATER)?);
    out.bad("ball-straight", &focus, draw_ball(1.0)?);
    out.cured("ball", &focus, draw_ball(GLASS)?);
    charts(depths, lengths, &mut out);
    Ok(out.finish(Verdict::HoldsOnlyIf(out.text("holds-only-if")), effect))
}

/// The displacement of the stick's lower end in the picture without refraction, and what is left with it, in pixels.
fn effect(size: u32, out: &Recorder) -> Result<Effect> {
    let law = apparent_depth(SEEN_FROM);
    let pixels = Water::pixels_of_depth(SEEN_FROM, size);
    let [straight, bent] = [1.0, WATER].map(|ior| Water { ior }.apparent_depth(SEEN_FROM));
    let off = [straight?, bent?].map(|depth| (depth - law).abs() * pixels);
    Ok(out.effect("stick", "px", off, Threshold::half_pixel(), 10.0))
}

/// The depth at which a point in water seems to be, as a share of its depth: tan θ′/tan θ with sin θ = n sin θ′.
fn apparent_depth(view: Degrees) -> f64 {
    let angle = Radians::from(view).0;
    libm::tan(libm::asin(libm::sin(angle) / WATER)) / libm::tan(angle)
}

/// The distance from the centre at which a ray at a height h crosses the axis, in radii: h/sin(2(i − r)).
fn focal_length(height: f64) -> f64 {
    height / libm::sin(2.0 * (libm::asin(height) - libm::asin(height / GLASS)))
}

fn charts(depths: Vec<[f64; 2]>, lengths: Vec<[f64; 2]>, out: &mut Recorder) {
    let angles = (1..85).map(f64::from);
    let law = angles.map(|angle| [angle, apparent_depth(Degrees(angle))]).collect();
    let curves = vec![out.curve("measured", Drawn::Points, depths), out.curve("law", Drawn::Guide, law)];
    out.chart("depth-by-angle", [Axis::Linear; 2], curves);
    let heights = (1..95).map(|k| f64::from(k) / 100.0);
    let law = heights.map(|height| [height, focal_length(height)]).collect();
    let curves = vec![out.curve("measured", Drawn::Points, lengths), out.curve("law", Drawn::Guide, law)];
    out.chart("focus-by-height", [Axis::Linear; 2], curves);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rays_follow_snells_law() {
        for size in [32, 96] {
            let parameters = Parameters { size, ..EXPERIMENT.defaults };
            let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
            outcome.prove();
            // Three quarters from above (1/1.333), and 1.5 radii (n/(2(n − 1))).
            assert!((outcome.measures[0].value - 0.7502).abs() < 1e-3, "{:?}", outcome.measures[0]);
            assert!((outcome.measured("glass ball: focal length in the limit") - 1.5).abs() < 0.01);
            assert!(matches!(outcome.verdict, Verdict::HoldsOnlyIf(_)), "{:?}", outcome.verdict);
        }
    }

    /// Figures computed outside this program: 50° in water, and a ray at 0.7 radii through glass of 1.5.
    #[test]
    fn closed_forms_have_their_published_values() {
        assert!((apparent_depth(Degrees(50.0)) - 0.589_23).abs() < 1e-4, "{}", apparent_depth(Degrees(50.0)));
        assert!((focal_length(0.7) - 1.277_79).abs() < 1e-4, "{}", focal_length(0.7));
    }
}
