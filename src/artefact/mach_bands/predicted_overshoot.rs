//! The overshoot at edges that a model of lateral inhibition predicts. It says nothing about what observers report.

use super::super::outcome::Curve;
use super::super::prelude::*;
use super::tube::{Law, Tube, WINDOW, flat_step, gouraud_jump, is_drawn, phong_jump};
use crate::metric::{DifferenceOfGaussians, MetricError, PIXELS_PER_DEGREE, Profile};

/// Width in pixels of the scanline that the model is applied to, whatever the size of the pictures: 15° of the field of view.
const WIDTH: u32 = 1024;
/// Pixels to either side that the model's answer depends on, at its default widths.
const REACH: f64 = 8.0;

/// Pixels of a radius.
fn radius() -> f64 {
    f64::from(WIDTH) / WINDOW
}

/// The model's answers along a scanline, by pixel.
fn answers(tube: &Tube, light: Degrees, shading: Shading) -> Result<Vec<[f64; 2]>> {
    let image = tube.draw([WIDTH, 1], light, shading)?;
    let runs = Profile::of_row(&image, Samples::One, 0)?;
    let profile = runs.first().ok_or(MetricError::Empty)?;
    Ok(DifferenceOfGaussians::default().along(profile))
}

/// The largest answer within two pixels of an edge, with its sign.
fn answer_at(answers: &[[f64; 2]], theta: f64) -> f64 {
    let edge = 0.5 * f64::from(WIDTH) + radius() * libm::sin(theta);
    let near = answers.iter().filter(|[x, _]| (x - edge).abs() <= 2.0).map(|[_, answer]| *answer);
    near.max_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or(0.0)
}

/// The model's answer at an edge in closed form, and its tolerance.
#[derive(Clone, Copy, Debug)]
struct Prediction {
    answer: f64,
    open: f64,
}

impl Prediction {
    /// Up to 11.6 % less where the edge lies between two pixels, and roundings of the samples.
    fn at_edge(answer: f64) -> Self {
        Self { answer, open: 0.12 * answer.abs() + 2.0 * f64::from(f32::EPSILON) }
    }

    /// Adds the answer to Phong's curvature next to the edge, −Y″ (σs² − σc²)/2: the normal turns along the chord of a facet of
    /// width w by α′ = sin Δ/w at its ends and α″ = ±2 sin Δ (1 − cos Δ)/w². On the edge that is the mean of both
    /// sides; two pixels away one side counts more, which is in the tolerance.
    fn with_bends(self, theta: f64, light: Degrees, delta: f64) -> Self {
        let [centre, surround] = DifferenceOfGaussians::default().widths();
        let (sine, cosine) = libm::sincos(theta - Radians::from(light).0);
        let (turn, versine) = (libm::sin(delta), 1.0 - libm::cos(delta));
        let bends = [1.0, -1.0].map(|side| {
            let width = libm::sin(theta + side * delta) - libm::sin(theta);
            let (first, second) = (turn / width, 2.0 * side * turn * versine / (width * width));
            let curvature = -cosine * first * first - sine * second;
            -0.5 * curvature * (surround - centre) * (surround + centre) / (radius() * radius())
        });
        let [right, left] = bends;
        Self { answer: self.answer + 0.5 * (right + left), open: self.open + 0.5 * (right - left).abs() }
    }
}

/// The overshoot predicted at the edge where it is largest, for flat, Gouraud's and Phong's shading and for the finer tube.
pub(super) fn measure(tube: &Tube, fine: &Tube, light: Degrees, out: &mut Recorder) -> Result<()> {
    let model = DifferenceOfGaussians::default();
    let [centre, surround] = model.widths();
    for (name, value) in [("centre", centre), ("surround", surround), ("density", PIXELS_PER_DEGREE)] {
        out.set(name, Value::number(value));
    }
    let mut measure = |name, tube: &Tube, shading, law: &dyn Fn(f64) -> Prediction| {
        let answers = answers(tube, light, shading)?;
        let found = tube.largest(light, |theta| (answer_at(&answers, theta).abs(), law(theta).answer.abs()));
        let check = match tube.narrowest() * radius() > 2.0 * REACH {
            true => Check::Near(found.law, law(found.theta).open),
            false => Check::Untested("narrow-facets"),
        };
        out.measure(name, "", found.measured, check);
        Ok::<_, ArtefactError>(())
    };
    let corner = |law: Law, delta: f64| {
        move |theta| Prediction::at_edge(model.at_corner(law(theta, light, delta) / radius()))
    };
    let delta = tube.delta();
    let step = |theta| Prediction::at_edge(model.near_step(flat_step(theta, light, delta)).0);
    measure("overshoot-flat", tube, Shading::Flat, &step)?;
    measure("overshoot-gouraud", tube, Shading::Gouraud, &corner(gouraud_jump, delta))?;
    measure("overshoot-phong", tube, Shading::Phong, &|theta| {
        corner(phong_jump, delta)(theta).with_bends(theta, light, delta)
    })?;
    measure("overshoot-fine", fine, Shading::Gouraud, &corner(gouraud_jump, fine.delta()))
}

/// The answers across the picture: of slopes that jump, and of steps, which are many times larger.
pub(super) fn charts(tube: &Tube, light: Degrees, out: &mut Recorder) -> Result<()> {
    let curve = |name, shading, out: &Recorder| -> Result<Curve> {
        // By position across the picture, in radii.
        let place = |[x, answer]: [f64; 2]| [(x - 0.5 * f64::from(WIDTH)) / radius(), answer];
        let points = answers(tube, light, shading)?.into_iter().map(place).filter(|&[x, _]| is_drawn(x));
        Ok(out.curve(name, Drawn::Curve, points.collect()))
    };
    let slopes = vec![
        curve("gouraud", Shading::Gouraud, out)?,
        curve("phong", Shading::Phong, out)?,
        curve("exact", Shading::Exact, out)?,
    ];
    out.chart("predicted", [Axis::Linear; 2], slopes);
    let steps = vec![curve("flat", Shading::Flat, out)?];
    out.chart("predicted-flat", [Axis::Linear; 2], steps);
    Ok(())
}
