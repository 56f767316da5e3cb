//! Pictures of the cylinder, maps of its slope jumps, and luminance across it with its derivatives.

use super::super::outcome::Curve;
use super::super::prelude::*;
use super::tube::{Profile, Tube, WINDOW};

/// The cylinder under each shading, and the finer one under the worse of Gouraud's and Phong's.
pub(super) fn record(
    size: u32,
    light: Degrees,
    [tube, fine]: [&Tube; 2],
    worse: Shading,
    [of_step, of_shading, of_finer]: [&Effect; 3],
    out: &mut Recorder,
) -> Result<()> {
    // Kinks of slope are where surfaces are bright, at which a step of luminance is few codes.
    let exact = tube.draw([size; 2], light, Shading::Exact)?;
    let white = luminance(&exact).into_iter().zip(&exact.coverage).filter(|(_, covered)| **covered > 0);
    let white = white.map(|(light, _)| light).fold(0.0, f64::max);
    let dark = DARK * white;
    out.set("white", white);
    out.set("dark", dark);
    let draw = |tube: &Tube, shading| -> Result<Image> {
        Ok(stretched(&tube.draw([size; 2], light, shading)?, [dark, white]))
    };
    out.bad("flat", of_step, draw(tube, Shading::Flat)?);
    for (name, shading) in [("gouraud", Shading::Gouraud), ("phong", Shading::Phong)] {
        match shading == worse {
            true => out.bad(name, of_shading, draw(tube, shading)?),
            false => out.cured(name, of_shading, draw(tube, shading)?),
        }
    }
    out.cured("fine", of_finer, draw(fine, worse)?);
    out.truth("exact", stretched(&exact, [dark, white]));
    Ok(())
}

/// The luminance that pictures show as black, as a share of the largest one.
const DARK: f64 = 0.6;

/// A picture whose surfaces are black at one luminance and white at another.
fn stretched(image: &Image, [dark, white]: [f64; 2]) -> Image {
    let stretch = |light: f32| ((f64::from(light) - dark) / (white - dark)).clamp(0.0, 1.0) as f32;
    let is_lit = white > dark;
    let pixel = |(colour, &covered): (&[f32; 3], &u8)| {
        if covered > 0 && is_lit { colour.map(stretch) } else { *colour }
    };
    let colours = linear(image).iter().zip(&image.coverage).map(pixel).collect();
    picture(image.size, colours, image.coverage.clone())
}

/// The slope jumps of Phong's and Gouraud's shading at the edges of a cylinder: position across the picture, and jump.
pub(super) struct Jumps {
    pub(super) tube: Tube,
    phong: Vec<[f64; 2]>,
    gouraud: Vec<[f64; 2]>,
}

impl Jumps {
    pub(super) fn measure(tube: Tube, light: Degrees) -> Result<Self> {
        let (phong, gouraud) = (tube.jumps(light, Shading::Phong)?, tube.jumps(light, Shading::Gouraud)?);
        Ok(Self { tube, phong, gouraud })
    }

    /// The largest jump of Phong's and of Gouraud's shading.
    pub(super) fn largest(&self) -> [f64; 2] {
        [&self.phong, &self.gouraud].map(|jumps| jumps.iter().map(|jump| jump[1]).fold(0.0, f64::max))
    }

    /// Maps of the jumps, and the pictures, in which they are hardly visible.
    pub(super) fn show(&self, size: u32, light: Degrees, effect: &Effect, out: &mut Recorder) -> Result<()> {
        let full = effect.bad.max(effect.cured);
        out.set("full", full);
        let draw = |shading| self.tube.draw([size; 2], light, shading);
        let (gouraud, phong) = (draw(Shading::Gouraud)?, draw(Shading::Phong)?);
        let map = |image, jumps: &[[f64; 2]]| jump_map(image, &self.tube, light, jumps, full);
        out.bad("phong-80-jumps", effect, map(&phong, &self.phong));
        out.scaled(full, "1/R");
        out.cured("gouraud-80-jumps", effect, map(&gouraud, &self.gouraud));
        out.scaled(full, "1/R");
        out.seen("phong-80", phong);
        out.seen("gouraud-80", gouraud);
        Ok(())
    }
}

/// Half the width of the bars in maps of jumps, in pixels.
const HALF_BAR: f64 = 2.5;

/// A bar at each measured edge, as light as its jump is large. Facets without a measured edge are omitted.
fn jump_map(drawn: &Image, tube: &Tube, light: Degrees, jumps: &[[f64; 2]], full: f64) -> Image {
    let pixel = WINDOW / f64::from(drawn.size[0]);
    let (from, to) = tube.near_edges(light);
    let column = |index: usize| (index as u32 % drawn.size[0], drawn.coverage[index] > 0);
    let value = |(column, is_covered): (u32, bool)| {
        let x = (f64::from(column) + 0.5) * pixel - 0.5 * WINDOW;
        let here = jumps.iter().filter(|[at, _]| (x - at).abs() < HALF_BAR * pixel);
        (is_covered && (from..to).contains(&x)).then(|| here.map(|jump| jump[1]).fold(0.0, f64::max))
    };
    let values: Vec<Option<f64>> = (0..drawn.coverage.len()).map(|index| value(column(index))).collect();
    map(drawn.size, &values, full.max(f64::MIN_POSITIVE))
}

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

pub(super) fn record_charts(lines: &Lines, effect: &Effect, out: &mut Recorder) {
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
