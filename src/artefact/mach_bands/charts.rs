//! Luminance across the cylinder with its derivatives.

use super::super::outcome::Curve;
use super::super::prelude::*;
use super::tube::{Profile, Tube};

/// Luminance across the picture under each shading.
pub(super) struct Lines {
    pub(super) flat: Profile,
    pub(super) gouraud: Profile,
    pub(super) phong: Profile,
    exact: Profile,
}

impl Lines {
    pub(super) fn new(tube: &Tube, light: Degrees) -> Result<Self> {
        Ok(Self {
            flat: tube.profile(light, Shading::Flat)?,
            gouraud: tube.profile(light, Shading::Gouraud)?,
            phong: tube.profile(light, Shading::Phong)?,
            exact: tube.profile(light, Shading::Exact)?,
        })
    }

    /// A derivative of the shadings without steps.
    fn curves(&self, derivative: Derivative, out: &Recorder) -> Vec<Curve> {
        [("gouraud", &self.gouraud), ("phong", &self.phong), ("exact", &self.exact)]
            .map(|(name, line)| out.curve(name, Drawn::Curve, points(line, derivative)))
            .to_vec()
    }
}

/// Luminance, its slope and its curvature.
pub(super) fn record(lines: &Lines, effect: &Effect, out: &mut Recorder) {
    out.set("bad", effect.bad);
    out.set("cured", effect.cured);
    for (name, derivative) in
        [("luminance", Derivative::Zeroth), ("slope", Derivative::First), ("curvature", Derivative::Second)]
    {
        let mut curves = lines.curves(derivative, out);
        if let Derivative::Zeroth = derivative {
            // Last, so that the others look alike in all plots.
            curves.push(out.curve("flat", Drawn::Curve, points(&lines.flat, derivative)));
        }
        out.chart(name, [Axis::Linear; 2], curves);
    }
}

/// The same in grazing light, where Phong's jumps are the larger ones.
pub(super) fn record_grazing(tube: &Tube, light: Degrees, effect: &Effect, out: &mut Recorder) -> Result<()> {
    let lines = Lines::new(tube, light)?;
    out.set("bad", effect.bad);
    out.set("cured", effect.cured);
    out.chart("luminance-80", [Axis::Linear; 2], lines.curves(Derivative::Zeroth, out));
    // Where the light ends, and far round, slopes jump more, but not because of the shading.
    let (from, to) = tube.near_edges(light);
    for (name, derivative) in [("slope-80", Derivative::First), ("curvature-80", Derivative::Second)] {
        let mut curves = lines.curves(derivative, out);
        curves.iter_mut().for_each(|curve| curve.points.retain(|[x, _]| (from..to).contains(x)));
        out.chart(name, [Axis::Linear; 2], curves);
    }
    Ok(())
}

/// Pixels between the samples that differences are taken of.
const STEP: usize = 32;

#[derive(Clone, Copy)]
enum Derivative {
    Zeroth,
    First,
    Second,
}

fn points(line: &Profile, derivative: Derivative) -> Vec<[f64; 2]> {
    let unit = Profile::x(STEP) - Profile::x(0);
    let value = |values: &[f64], pixel: usize| {
        let at = |pixel: usize| values[pixel.min(values.len() - 1)];
        let (before, here, after) = (at(pixel.saturating_sub(STEP)), at(pixel), at(pixel + STEP));
        match derivative {
            Derivative::Zeroth => here,
            Derivative::First => (after - before) / (2.0 * unit),
            Derivative::Second => (after + before - 2.0 * here) / (unit * unit),
        }
    };
    line.points(STEP, value)
}
