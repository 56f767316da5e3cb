//! Outlines that are known: a ball seen along its axis is a regular polygon, a torus two of them.

use super::super::prelude::*;
use super::outline::{Outline, View, between};
use crate::metric::ContourDistance;
use crate::surface::{Parametric, Torus};
use glam::DVec4;
use std::f64::consts::{PI, TAU};

/// The window's side over the outer radius of what is in it.
const WINDOW: f64 = 2.2;
/// The radius of the torus' outer outline.
const OUTER: f64 = 1.4;
/// The y axis, about which things are round, to the viewer.
const TOWARDS_VIEWER: DMat4 = DMat4::from_cols(DVec4::X, DVec4::Z, DVec4::NEG_Y, DVec4::W);

pub(super) fn run(parameters: &Parameters, mut out: Recorder) -> Result<Outcome> {
    let &Parameters { size, segments, light, .. } = parameters;
    let radius = f64::from(size) / WINDOW;
    let view = |height: f64| View { size, camera: front(height), light: light_at(light) };
    let ball = RoundSurface { primitive: Sphere::default().into(), view: view(WINDOW) };
    let torus = RoundSurface { primitive: Torus::default().into(), view: view(WINDOW * OUTER) };
    let open = ball.view.open();
    // Less than half a pixel with all that outlines of pixels add, unless they add that much, and finer than what it cures.
    let left = (0.5 - open).clamp(0.125, 0.25);
    let fine = for_error(left, radius).max(2 * segments);
    out.set("segments", segments);
    out.set("fine", fine);
    out.set("radius", libm::round(radius));
    out.set("enough", enough(radius));
    out.set("compared", "ball");
    out.set("left", left);
    out.set("open", open);
    let circle = ball.true_outline()?;
    let of_ball = measure_ball(&ball, [segments, fine], radius, &circle, &mut out)?;
    let of_torus = measure_torus(&torus, [segments, fine], radius, open, &mut out)?;
    let [phong, flat] = [Shading::Phong, Shading::Flat].map(|shading| ball.outline(segments, shading));
    out.measure("flat-shading", "px", flat?.distance(&phong?)?.hausdorff, Check::Near(0.0, 0.0));
    ball.chart(&circle, radius, &mut out)?;
    let why = out.text("why-half-pixel-of-outlines");
    let present = Threshold { value: Threshold::HALF_PIXEL + open, why };
    let factor = (sagitta(segments, radius) / (left + open)).max(1.0);
    let effect = out.effect("outline", "px", of_ball, present, factor);
    let [bad, cured] = of_torus;
    show([&ball, &torus], [segments, fine], [&effect, &Effect { bad, cured, ..effect.clone() }], &mut out)?;
    Ok(out.finish(Verdict::Holds(out.text("holds")), effect))
}

/// The errors of the coarse and the fine ball. Returns their largest distances.
fn measure_ball(
    ball: &RoundSurface,
    [segments, fine]: [u32; 2],
    radius: f64,
    circle: &Outline,
    out: &mut Recorder,
) -> Result<[f64; 2]> {
    let open = ball.view.open();
    let of_coarse = ball.outline(segments, Shading::Phong)?.distance(circle)?;
    let of_fine = ball.error(fine, circle)?;
    out.set("surface", out.text("ball"));
    out.measure("distance", "px", of_coarse.hausdorff, Check::Near(sagitta(segments, radius), open));
    out.measure("mean-distance", "px", of_coarse.mean, Check::Near(mean(segments, radius), open));
    let check = Check::Near(area_ratio(segments), open * 2.0 / radius);
    out.measure("area", "", of_coarse.area_ratio, check);
    out.measure("distance-fine", "px", of_fine.hausdorff, Check::Near(sagitta(fine, radius), open));
    let enough = enough(radius);
    let found = ball.found_enough(enough, circle)?;
    let tolerance = (f64::from(enough) * ((0.5 / (0.5 - 0.5 * open)).sqrt() - 1.0)).ceil();
    out.measure("fewest-segments", "", f64::from(found), Check::Near(f64::from(enough), tolerance));
    Ok([of_coarse.hausdorff, of_fine.hausdorff])
}

fn measure_torus(
    torus: &RoundSurface,
    [segments, fine]: [u32; 2],
    radius: f64,
    open: f64,
    out: &mut Recorder,
) -> Result<[f64; 2]> {
    let truth = torus.true_outline()?;
    let [of_coarse, of_fine] = [segments, fine].map(|segments| torus.error(segments, &truth));
    let (of_coarse, of_fine) = (of_coarse?, of_fine?);
    out.set("surface", out.text("torus"));
    out.measure("distance", "px", of_coarse.hausdorff, Check::Near(sagitta(segments, radius), open));
    out.measure("distance-fine", "px", of_fine.hausdorff, Check::Near(sagitta(fine, radius), open));
    // Between two outlines, 1 and 3/7 of the radius.
    let check = Check::Near(area_ratio(segments), open * 2.0 / (radius * (1.0 - 3.0 / 7.0)));
    out.measure("area", "", of_coarse.area_ratio, check);
    Ok([of_coarse.hausdorff, of_fine.hausdorff])
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

fn for_error(error: f64, radius: f64) -> u32 {
    let least = PI / (2.0 * libm::asin((0.5 * error / radius).sqrt()));
    least.floor() as u32 + 1
}

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

/// A surface that is round about the y axis, seen along it.
struct RoundSurface {
    primitive: Primitive,
    view: View,
}

impl RoundSurface {
    fn itself(&self) -> Object<'_> {
        let object = Object::new(Shape::Surface(self.primitive), chalk());
        Object { transform: TOWARDS_VIEWER, ..object }
    }

    /// The surface with so many segments round its axis.
    fn cut(&self, segments: u32) -> TriangleMesh {
        match &self.primitive {
            Primitive::Torus(torus) => {
                // An even number: one circle of vertices is the outermost, one the innermost.
                let cells = [segments, 2 * segments.div_ceil(4)];
                TriangleMesh::grid(cells, Diagonal::Rising, |u, v| {
                    torus
                        .at(u, v)
                        .map_or((DVec3::ZERO, DVec3::Y), |sample| (sample.position, sample.normal.get()))
                })
            }
            _ => TriangleMesh::globe(segments, 0.0),
        }
    }

    fn picture(&self, segments: u32) -> Result<Image> {
        self.view.draw(turned(&self.cut(segments)), Shading::Phong)
    }

    fn outline(&self, segments: u32, shading: Shading) -> Result<Outline> {
        self.view.outline(turned(&self.cut(segments)), shading)
    }

    fn true_outline(&self) -> Result<Outline> {
        self.view.outline(self.itself(), Shading::Flat)
    }

    fn error(&self, segments: u32, circle: &Outline) -> Result<ContourDistance> {
        self.outline(segments, Shading::Flat)?.distance(circle)
    }

    /// The fewest segments with an outline that is right to half a pixel, in addition to the error of an outline of many segments.
    fn found_enough(&self, expected: u32, circle: &Outline) -> Result<u32> {
        let of_pixels = self.error(8 * expected, circle)?.hausdorff;
        let (mut low, mut high) = (3, 2 * expected);
        while high - low > 1 {
            let middle = low.midpoint(high);
            if self.error(middle, circle)?.hausdorff < 0.5 + of_pixels { high = middle } else { low = middle }
        }
        Ok(high)
    }

    fn chart(&self, circle: &Outline, radius: f64, out: &mut Recorder) -> Result<()> {
        const SEGMENTS: [u32; 11] = [4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128];
        let (mut farthest, mut means) = (Vec::new(), Vec::new());
        for segments in SEGMENTS {
            let error = self.error(segments, circle)?;
            farthest.push([f64::from(segments), error.hausdorff]);
            means.push([f64::from(segments), error.mean]);
        }
        let law =
            |law: &dyn Fn(u32) -> f64| SEGMENTS.map(|segments| [f64::from(segments), law(segments)]).to_vec();
        let curves = vec![
            out.curve("largest", Drawn::Points, farthest),
            out.curve("mean", Drawn::Points, means),
            out.curve("largest-law", Drawn::Guide, law(&|n| sagitta(n, radius))),
            out.curve("mean-law", Drawn::Guide, law(&|n| mean(n, radius))),
        ];
        out.chart("error-by-segments", [Axis::Log; 2], curves);
        Ok(())
    }
}

fn turned(mesh: &TriangleMesh) -> Object<'_> {
    Object { transform: TOWARDS_VIEWER, ..mesh.object(chalk()) }
}

fn show(
    [ball, torus]: [&RoundSurface; 2],
    [segments, fine]: [u32; 2],
    [of_ball, of_torus]: [&Effect; 2],
    out: &mut Recorder,
) -> Result<()> {
    let round = ball.view.draw(ball.itself(), Shading::Phong)?;
    let coarse = ball.picture(segments)?;
    let lacking = between(&coarse, &round);
    out.bad("ball", of_ball, coarse);
    out.difference("lacking", lacking, 1.0, "px");
    out.cured("ball-fine", of_ball, ball.picture(fine)?);
    out.truth("ball-itself", round);
    out.bad("torus", of_torus, torus.picture(segments)?);
    out.cured("torus-fine", of_torus, torus.picture(fine)?);
    Ok(())
}
