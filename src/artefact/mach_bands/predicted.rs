//! What lateral inhibition predicts at the edges. It is called predicted, for it is a model's answer and nobody's sight.

use super::super::{ArtefactError, Chart, Curve, Drawn, Language, Measure, Scale, Text};
use super::texts::TEXTS;
use super::tube::{Tube, WINDOW, is_drawn};
use super::{Law, flat_step, gouraud_jump, phong_jump};
use crate::metric::{DifferenceOfGaussians, MetricError, PIXELS_PER_DEGREE, Profile};
use crate::num::{Degrees, Radians};
use crate::raster::{Samples, Shading};

/// Width in pixels of the picture whose scanline the model looks at, whatever the size of the pictures shown: 15° of sight.
const WIDTH: u32 = 1024;
/// Pixels to either side that the model's answer depends on, at its default widths.
const REACH: f64 = 8.0;

/// The model's answers along a scanline.
struct Answers {
    points: Vec<[f64; 2]>,
}

/// Pixels of a radius.
fn radius() -> f64 {
    f64::from(WIDTH) / WINDOW
}

impl Answers {
    fn of(tube: &Tube, light: Degrees, shading: Shading) -> Result<Self, ArtefactError> {
        let image = tube.draw([WIDTH, 1], light, shading)?;
        let runs = Profile::of_row(&image, Samples::One, 0)?;
        let profile = runs.first().ok_or(MetricError::Empty)?;
        Ok(Self { points: DifferenceOfGaussians::default().along(profile) })
    }

    /// The largest answer within two pixels of an edge, with its sign.
    fn at(&self, theta: f64) -> f64 {
        let edge = 0.5 * f64::from(WIDTH) + radius() * libm::sin(theta);
        let near = self.points.iter().filter(|[x, _]| (x - edge).abs() <= 2.0).map(|[_, answer]| *answer);
        near.max_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or(0.0)
    }

    fn curve(&self, name: Text) -> Curve {
        let place = |&[x, answer]: &[f64; 2]| [(x - 0.5 * f64::from(WIDTH)) / radius(), answer];
        let points = self.points.iter().map(place).filter(|&[x, _]| is_drawn(x)).collect();
        Curve { name, drawn: Drawn::Curve, points }
    }
}

/// What the model should answer at an edge, and how far off that it may be.
#[derive(Clone, Copy, Debug)]
struct Expected {
    answer: f64,
    open: f64,
}

impl Expected {
    /// Up to 11.6 % less where the edge lies between two pixels, and roundings of the samples.
    fn at_edge(answer: f64) -> Self {
        Self { answer, open: 0.12 * answer.abs() + 2.0 * f64::from(f32::EPSILON) }
    }

    /// Beside the edge Phong's shading bends, to which the answer is −Y″ (σs² − σc²)/2: as the normal turns along the chord of
    /// a facet of the width w, by α′ = sin Δ/w at its ends and α″ = ±2 sin Δ (1 − cos Δ)/w². On the edge that is the mean of both
    /// sides, and two pixels off more of one.
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
pub(super) fn measures(tube: &Tube, fine: &Tube, light: Degrees) -> Result<Vec<Measure>, ArtefactError> {
    let model = DifferenceOfGaussians::default();
    let [centre, surround] = model.widths();
    let of = |tube: &Tube, shading, name: [&str; 2], law: &dyn Fn(f64) -> Expected| {
        let answers = Answers::of(tube, light, shading)?;
        let found = tube.largest(light, |theta| (answers.at(theta).abs(), law(theta).answer.abs()));
        let name = Text::each(|language| {
            let (of, overshoot) = match language {
                Language::English => (name[0], "predicted overshoot"),
                Language::Portuguese => (name[1], "excesso previsto"),
            };
            let [centre, surround, density] =
                [centre, surround, PIXELS_PER_DEGREE].map(|x| language.number(x));
            format!("{of}: {overshoot} (DoG, σ {centre} px, {surround} px; {density} px/°)")
        });
        let measure = Measure::new(name, "", found.measured);
        Ok::<_, ArtefactError>(match tube.narrowest() * radius() > 2.0 * REACH {
            true => measure.expect(found.law, law(found.theta).open, TEXTS.get("by-i-s-c")),
            false => measure.beyond(TEXTS.get("untested-facets-narrow-model")),
        })
    };
    let corner = |law: Law, delta: f64| {
        move |theta| Expected::at_edge(model.at_corner(law(theta, light, delta) / radius()))
    };
    let delta = tube.delta();
    let step = |theta| Expected::at_edge(model.near_step(flat_step(theta, light, delta)).0);
    let segments = fine.segments;
    Ok(vec![
        of(tube, Shading::Flat, ["flat", "plano"], &step)?,
        of(tube, Shading::Gouraud, ["Gouraud", "Gouraud"], &corner(gouraud_jump, delta))?,
        of(tube, Shading::Phong, ["Phong", "Phong"], &|theta| {
            corner(phong_jump, delta)(theta).with_bends(theta, light, delta)
        })?,
        of(
            fine,
            Shading::Gouraud,
            [&format!("Gouraud, {segments} segments"), &format!("Gouraud, {segments} segmentos")],
            &corner(gouraud_jump, fine.delta()),
        )?,
    ])
}

/// The answers across the picture: of slopes that jump, and of steps, which are many times larger.
pub(super) fn charts(tube: &Tube, light: Degrees) -> Result<Vec<Chart>, ArtefactError> {
    let curve = |name, shading| Ok::<_, ArtefactError>(Answers::of(tube, light, shading)?.curve(name));
    let chart = |name, title, caption, curves| Chart {
        name,
        title,
        caption,
        x: Scale::linear(TEXTS.get("axis-x-across-picture")),
        y: Scale::linear(TEXTS.get("axis-predicted-overshoot-luminance")),
        curves,
    };
    Ok(vec![
        chart(
            "predicted",
            TEXTS.get("predicted-overshoot-slopes"),
            TEXTS.get("difference-gaussians-pixels"),
            vec![
                curve(Text::same("Gouraud"), Shading::Gouraud)?,
                curve(Text::same("Phong"), Shading::Phong)?,
                curve(TEXTS.get("exact"), Shading::Exact)?,
            ],
        ),
        chart(
            "predicted-flat",
            TEXTS.get("predicted-overshoot-steps"),
            TEXTS.get("same-model-flat"),
            vec![curve(TEXTS.get("flat-title"), Shading::Flat)?],
        ),
    ])
}
