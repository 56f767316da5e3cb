//! An irregular torus and a ball of slivers.

use super::super::prelude::*;
use super::lit_surface::{LitSurface, View};
use super::weights::{FLAT, MEANS, ROUND};
use crate::surface::{Pattern, Tessellation, Torus};

/// How many times narrower every other row of the ball is than the next.
pub(super) const SLIVERS: f64 = 12.0;
/// Full scale of the maps of angles, in degrees.
const FULL_ANGLE: f64 = 5.0;

pub(super) fn torus(view: &View) -> Result<LitSurface> {
    let irregular = Tessellation { jitter: 0.5, ..Tessellation::default() };
    LitSurface::new(Torus::default().into(), Torus::default().into(), &irregular, view)
}

/// A ball in rows, every other one so many times narrower.
pub(super) fn ball(ratio: f64, view: &View) -> Result<LitSurface> {
    let (pattern, segments) = (Pattern::Slivers(ratio), [24, 24]);
    let tessellation = Tessellation { pattern, segments, ..Tessellation::default() };
    LitSurface::new(Sphere::default().into(), Sphere::default().into(), &tessellation, view)
}

/// Rms and maximum over the vertices of the torus, for two weights by figures of another program.
pub(super) fn measure_torus(torus: &LitSurface, out: &mut Recorder) {
    const KNOWN: [(Weight, [f64; 2]); 2] = [(Weight::Uniform, [1.644, 4.677]), (Weight::Max, [0.498, 2.054])];
    for (weight, name) in MEANS {
        out.set("weighting", out.text(name));
        let known = KNOWN.iter().find(|(known, _)| *known == weight).map(|(_, known)| known);
        let check = |figure: usize| known.map_or(Check::None, |known| Check::Near(known[figure], 5e-4));
        let errors = torus.at_vertices(weight);
        out.measure("torus-rms", "°", errors.rms, check(0));
        out.measure("torus-largest", "°", errors.max, check(1));
    }
}

pub(super) fn measure_ball(ball: &LitSurface, out: &mut Recorder) {
    for (weight, name) in MEANS {
        out.set("weighting", out.text(name));
        let check = if weight == ROUND { Check::Near(0.0, 1e-9) } else { Check::None };
        out.measure("ball", "°", ball.at_vertices(weight).rms, check);
    }
}

/// The effect of some weights on a surface, compared with Max's.
fn effect(name: &str, surface: &LitSurface, weight: Weight, factor: f64, out: &Recorder) -> Effect {
    let errors = [weight, ROUND].map(|weight| surface.at_vertices(weight).rms);
    out.effect(name, "°", errors, Threshold::half_step_of_tilt(), factor)
}

pub(super) fn show_ball(ball: &LitSurface, weight: Weight, out: &mut Recorder) -> Result<Effect> {
    let slivers = effect("slivers", ball, weight, 1000.0, out);
    let by_angle = effect("slivers", ball, FLAT, 1000.0, out);
    out.set("full-angle", FULL_ANGLE);
    out.bad("slivers", &slivers, ball.picture(weight)?);
    out.bad("slivers-angle", &by_angle, ball.picture(FLAT)?);
    out.cured("slivers-max", &by_angle, ball.picture(ROUND)?);
    out.difference("slivers-error", ball.error_map(weight, FULL_ANGLE)?);
    Ok(slivers)
}

pub(super) fn show_torus(torus: &LitSurface, weight: Weight, out: &mut Recorder) -> Result<Effect> {
    // No weights are exact on a torus.
    let effect = effect("torus", torus, weight, 1.5, out);
    out.bad("torus", &effect, torus.picture(weight)?);
    out.cured("torus-max", &effect, torus.picture(ROUND)?);
    out.difference("torus-error", torus.error_map(weight, FULL_ANGLE)?);
    out.truth("torus-itself", torus.truth(Show::Shaded)?);
    Ok(effect)
}

/// Errors on the ball by the thinness of its slivers.
pub(super) fn chart(view: &View, out: &mut Recorder) -> Result<()> {
    const RATIOS: [f64; 6] = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0];
    let balls = RATIOS.map(|ratio| ball(ratio, view).map(|ball| (ratio, ball)));
    let balls = balls.into_iter().collect::<Result<Vec<_>>>()?;
    let mut curves = Vec::new();
    for (weight, name) in MEANS {
        let errors = balls.iter().map(|(ratio, ball)| [*ratio, ball.at_vertices(weight).rms]);
        curves.push(out.curve(name, Drawn::Line, errors.collect()));
    }
    out.chart("error-by-slivers", [Axis::Log, Axis::Linear], curves);
    Ok(())
}
