//! Outlines that are known: a ball seen along its axis is a regular polygon, a torus two of them.

use super::super::body::{Body, Diagonal};
use super::super::stage::{front, light_at};
use super::super::{
    ArtefactError, Chart, Curve, Drawn, Language, Measure, Moved, Outcome, Parameters, Scale, Shot, Text,
    Threshold, Verdict,
};
use super::texts::TEXTS;
use super::{Outline, View, between, material};
use crate::metric::ContourDistance;
use crate::raster::{Image, Object, Shading, Shape};
use crate::surface::{Parametric, Primitive, Sphere, Torus};
use glam::{DMat4, DVec3, DVec4};
use std::f64::consts::{PI, TAU};

/// The window's side over the outer radius of what is in it.
const WINDOW: f64 = 2.2;
/// The radius of the torus' outer outline.
const OUTER: f64 = 1.4;
/// The y axis, about which things are round, to the viewer.
const TOWARDS_VIEWER: DMat4 = DMat4::from_cols(DVec4::X, DVec4::Z, DVec4::NEG_Y, DVec4::W);

pub(super) fn run(parameters: &Parameters) -> Result<Outcome, ArtefactError> {
    let &Parameters { size, segments, light, .. } = parameters;
    let radius = f64::from(size) / WINDOW;
    let view = |height: f64| View { size, camera: front(height), light: light_at(light) };
    let ball = Subject { primitive: Sphere::default().into(), view: view(WINDOW) };
    let torus = Subject { primitive: Torus::default().into(), view: view(WINDOW * OUTER) };
    let (enough, open) = (enough(radius), ball.view.open());
    let circle = ball.outline_of_truth()?;
    let outline = ball.outline(segments, Shading::Phong)?;
    let flat = ball.outline(segments, Shading::Flat)?;
    let of_coarse = outline.distance(&circle)?;
    // Less than half a pixel with all that outlines of pixels add, unless they add that much, and finer than what it cures.
    let left = (0.5 - open).clamp(0.125, 0.25);
    let fine = for_error(left, radius).max(2 * segments);
    let of_fine = ball.error(fine, &circle)?;
    let true_torus = torus.outline_of_truth()?;
    let [of_torus, of_fine_torus] = [segments, fine].map(|segments| torus.error(segments, &true_torus));
    let (of_torus, of_fine_torus) = (of_torus?, of_fine_torus?);
    let found = ball.found_enough(enough, &circle)?;
    let measures = vec![
        largest(TEXTS.get("ball"), segments, &of_coarse, radius, open),
        Measure::new(TEXTS.get("measure-ball-mean-distance"), "px", of_coarse.mean).expect(
            mean(segments, radius),
            open,
            TEXTS.get("by-mean-e-over"),
        ),
        area(TEXTS.get("ball"), segments, &of_coarse, open * 2.0 / radius),
        largest(TEXTS.get("ball"), fine, &of_fine, radius, open),
        Measure::new(TEXTS.get("measure-ball-fewest-segments"), "", f64::from(found)).expect(
            f64::from(enough),
            (f64::from(enough) * ((0.5 / (0.5 - 0.5 * open)).sqrt() - 1.0)).ceil(),
            TEXTS.get("by-arcsin-r-found"),
        ),
        largest(TEXTS.get("torus"), segments, &of_torus, radius, open),
        largest(TEXTS.get("torus"), fine, &of_fine_torus, radius, open),
        // Between two outlines, 1 and 3/7 of the radius.
        area(TEXTS.get("torus"), segments, &of_torus, open * 2.0 / (radius * (1.0 - 3.0 / 7.0))),
        Measure::new(TEXTS.get("measure-flat-shading-against"), "px", flat.distance(&outline)?.hausdorff)
            .expect(0.0, 0.0, TEXTS.get("by-shading-does-not")),
    ];
    let moved = Moved {
        name: TEXTS.get("moved"),
        unit: "px",
        bad: of_coarse.hausdorff,
        present: Threshold {
            value: Threshold::HALF_PIXEL.value + open,
            why: TEXTS.get("why-half-pixel-outlines"),
        },
        cure: TEXTS.with("cure", &[("fine", fine.into())]),
        cured: of_fine.hausdorff,
        factor: (sagitta(segments, radius) / (left + open)).max(1.0),
    };
    let of_torus = Moved { bad: of_torus.hausdorff, cured: of_fine_torus.hausdorff, ..moved.clone() };
    Ok(Outcome {
        verdict: Verdict::Holds(Text::made(
            format!(
                "whatever the shading; only more faces help. The error falls as 1/n². For half a pixel this ball of a radius of {radius:.0} \
                 pixels needs {enough} segments, one of 200 pixels 45; outlines in pictures are made of pixels, so that up to {} px more \
                 are measured.",
                Language::English.short(open, "")
            ),
            format!(
                "seja qual for o sombreamento; só mais faces ajudam. O erro cai como 1/n². Para meio pixel esta bola de raio de \
                 {radius:.0} pixels precisa de {enough} segmentos, uma de 200 pixels de 45; contornos em imagens são feitos de pixels, e \
                 por isso se medem até {} px a mais.",
                Language::Portuguese.short(open, "")
            ),
        )),
        charts: vec![ball.chart(&circle, radius)?],
        shots: shots([&ball, &torus], [segments, fine], [left, open], [&moved, &of_torus])?,
        moved,
        measures,
        notes: vec![TEXTS.get("note-vertices-ball-own"), TEXTS.get("note-near-outline-faces")],
    })
}

/// How far the middle of a side of an n-gon lies within its circle.
pub(super) fn sagitta(segments: u32, radius: f64) -> f64 {
    let sine = libm::sin(PI / (2.0 * f64::from(segments)));
    2.0 * radius * sine * sine
}

/// The smallest n for which that is below half a pixel.
pub(super) fn enough(radius: f64) -> u32 {
    for_error(0.5, radius)
}

/// The smallest n for which it is below an error.
fn for_error(error: f64, radius: f64) -> u32 {
    let least = PI / (2.0 * libm::asin((0.5 * error / radius).sqrt()));
    least.floor() as u32 + 1
}

/// The area of an n-gon over that of its circle.
pub(super) fn area_ratio(segments: u32) -> f64 {
    let turn = TAU / f64::from(segments);
    libm::sin(turn) / turn
}

/// The mean distance of an n-gon and its circle: half of that from the points of the sides to the circle, half of that back.
fn mean(segments: u32, radius: f64) -> f64 {
    let half = PI / f64::from(segments);
    let (sine, cosine) = libm::sincos(half);
    // ∫√(a² + t²) dt over a side at the distance a = R cos δ, and R sin δ/δ − a over the arc.
    let to_circle = 1.0 - 0.5 * (1.0 + cosine * cosine / sine * libm::asinh(sine / cosine));
    radius * 0.5 * (to_circle + sine / half - cosine)
}

fn largest(of: Text, segments: u32, found: &ContourDistance, radius: f64, open: f64) -> Measure {
    let name = Text::each(|language| match (language, of.get(language)) {
        (Language::English, of) => format!("{of}, {segments} segments: largest distance of the outline"),
        (Language::Portuguese, of) => format!("{of}, {segments} segmentos: maior distância do contorno"),
    });
    Measure::new(name, "px", found.hausdorff).expect(sagitta(segments, radius), open, TEXTS.get("by-r-cos-n"))
}

/// `open` is the share of the area that outlines leave open.
fn area(of: Text, segments: u32, found: &ContourDistance, open: f64) -> Measure {
    let name = Text::each(|language| match (language, of.get(language)) {
        (Language::English, of) => format!("{of}, {segments} segments: area over the true one"),
        (Language::Portuguese, of) => format!("{of}, {segments} segmentos: área sobre a verdadeira"),
    });
    Measure::new(name, "", found.area_ratio).expect(area_ratio(segments), open, TEXTS.get("by-n-sin-n"))
}

/// A surface that is round about the y axis, seen along it.
struct Subject {
    primitive: Primitive,
    view: View,
}

impl Subject {
    fn itself(&self) -> Object<'_> {
        let object = Object::new(Shape::Surface(self.primitive), material());
        Object { transform: TOWARDS_VIEWER, ..object }
    }

    /// The surface with so many segments round its axis.
    fn cut(&self, segments: u32) -> Body {
        match &self.primitive {
            Primitive::Torus(torus) => {
                // An even number: one circle of vertices is the outermost, one the innermost.
                let cells = [segments, 2 * segments.div_ceil(4)];
                Body::grid(cells, Diagonal::Rising, |u, v| {
                    torus
                        .at(u, v)
                        .map_or((DVec3::ZERO, DVec3::Y), |sample| (sample.position, sample.normal.get()))
                })
            }
            _ => Body::globe(segments, 0.0),
        }
    }

    fn picture(&self, segments: u32) -> Result<Image, ArtefactError> {
        self.view.draw(turned(&self.cut(segments)), Shading::Phong)
    }

    fn outline(&self, segments: u32, shading: Shading) -> Result<Outline, ArtefactError> {
        self.view.outline(turned(&self.cut(segments)), shading)
    }

    fn outline_of_truth(&self) -> Result<Outline, ArtefactError> {
        self.view.outline(self.itself(), Shading::Flat)
    }

    fn error(&self, segments: u32, circle: &Outline) -> Result<ContourDistance, ArtefactError> {
        self.outline(segments, Shading::Flat)?.distance(circle)
    }

    /// The fewest segments whose outline is measured to be right to half a pixel, near those that should be, beside what outlines
    /// of pixels are off even with so many segments that their polygon is a circle to a hundredth of a pixel.
    fn found_enough(&self, expected: u32, circle: &Outline) -> Result<u32, ArtefactError> {
        let of_pixels = self.error(8 * expected, circle)?.hausdorff;
        let (mut low, mut high) = (3, 2 * expected);
        while high - low > 1 {
            let middle = low.midpoint(high);
            if self.error(middle, circle)?.hausdorff < 0.5 + of_pixels { high = middle } else { low = middle }
        }
        Ok(high)
    }

    /// Errors by the number of segments.
    fn chart(&self, circle: &Outline, radius: f64) -> Result<Chart, ArtefactError> {
        const SEGMENTS: [u32; 11] = [4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128];
        let (mut farthest, mut means) = (Vec::new(), Vec::new());
        for segments in SEGMENTS {
            let error = self.error(segments, circle)?;
            farthest.push([f64::from(segments), error.hausdorff]);
            means.push([f64::from(segments), error.mean]);
        }
        let law =
            |law: &dyn Fn(u32) -> f64| SEGMENTS.map(|segments| [f64::from(segments), law(segments)]).to_vec();
        let curve = |name, drawn, points| Curve { name, drawn, points };
        Ok(Chart {
            name: "error-by-segments",
            title: TEXTS.get("chart-title"),
            caption: TEXTS.get("chart-caption"),
            x: Scale::log(TEXTS.get("axis-segments-n")),
            y: Scale::log(TEXTS.get("axis-distance-pixels")),
            curves: vec![
                curve(TEXTS.get("largest"), Drawn::Points, farthest),
                curve(TEXTS.get("mean"), Drawn::Points, means),
                curve(TEXTS.get("largest-closed-form"), Drawn::Guide, law(&|n| sagitta(n, radius))),
                curve(TEXTS.get("mean-closed-form"), Drawn::Guide, law(&|n| mean(n, radius))),
            ],
        })
    }
}

fn turned(body: &Body) -> Object<'_> {
    Object { transform: TOWARDS_VIEWER, ..body.object(material()) }
}

fn shots(
    [ball, torus]: [&Subject; 2],
    [segments, fine]: [u32; 2],
    [left, open]: [f64; 2],
    [of_ball, of_torus]: [&Moved; 2],
) -> Result<Vec<Shot>, ArtefactError> {
    let round = ball.view.draw(ball.itself(), Shading::Phong)?;
    let coarse = ball.picture(segments)?;
    let lacking = between(&coarse, &round);
    let label = |en: &str, pt: &str, count: u32| {
        Text::made(format!("{en}, {count} segments"), format!("{pt}, {count} segmentos"))
    };
    Ok(vec![
        of_ball.bad_shot(
            "ball",
            label("ball", "bola", segments),
            [TEXTS.get("ball-title"), TEXTS.get("ball-caption-outline-polygon")],
            coarse,
        ),
        Shot::difference(
            "lacking",
            TEXTS.get("lacking-title"),
            TEXTS.get("lacking-caption-yellow-ball-covers"),
            lacking,
        ),
        of_ball.cured_shot(
            "ball-fine",
            label("ball", "bola", fine),
            [
                TEXTS.with("ball-fine-title", &[("left", left.into()), ("open", open.into())]),
                TEXTS.get("ball-fine-caption-outline-round-eye"),
            ],
            ball.picture(fine)?,
        ),
        Shot::truth(
            "ball-itself",
            TEXTS.get("ball-itself-title"),
            TEXTS.get("ball-itself-caption-ball-equation-without"),
            round,
        ),
        of_torus.bad_shot(
            "torus",
            label("torus", "toro", segments),
            [TEXTS.get("torus-title"), TEXTS.get("torus-caption-outside-inside-outline")],
            torus.picture(segments)?,
        ),
        of_torus.cured_shot(
            "torus-fine",
            label("torus", "toro", fine),
            [TEXTS.get("torus-fine-title"), TEXTS.get("torus-fine-caption-round-eye")],
            torus.picture(fine)?,
        ),
    ])
}
