//! Pictures of the cylinder, and maps of its slope jumps.

use super::super::prelude::*;
use super::tube::{Tube, WINDOW};

/// The cylinder under each shading, and the finer one under the worse of Gouraud's and Phong's.
pub(super) fn record(
    size: u32,
    light: Degrees,
    [tube, fine]: [&Tube; 2],
    worse: Shading,
    [of_step, of_shading, of_finer]: [&Effect; 3],
    out: &mut Recorder,
) -> Result<()> {
    let draw = |tube: &Tube, shading| tube.draw([size; 2], light, shading);
    out.bad("flat", of_step, draw(tube, Shading::Flat)?);
    for (name, shading) in [("gouraud", Shading::Gouraud), ("phong", Shading::Phong)] {
        match shading == worse {
            true => out.bad(name, of_shading, draw(tube, shading)?),
            false => out.cured(name, of_shading, draw(tube, shading)?),
        }
    }
    out.cured("fine", of_finer, draw(fine, worse)?);
    out.truth("exact", draw(tube, Shading::Exact)?);
    Ok(())
}

/// The slope jumps of Phong's and Gouraud's shading at the edges of a cylinder: place across the picture, and jump.
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

    pub(super) fn largest_of_phong(&self) -> f64 {
        largest(&self.phong)
    }

    pub(super) fn largest_of_gouraud(&self) -> f64 {
        largest(&self.gouraud)
    }

    /// Maps of the jumps, and the pictures, in which they are hardly visible.
    pub(super) fn show(&self, size: u32, light: Degrees, effect: &Effect, out: &mut Recorder) -> Result<()> {
        let full = effect.bad.max(effect.cured);
        out.set("full", full);
        let draw = |shading| self.tube.draw([size; 2], light, shading);
        let (gouraud, phong) = (draw(Shading::Gouraud)?, draw(Shading::Phong)?);
        let map = |image, jumps: &[[f64; 2]]| jump_map(image, &self.tube, light, jumps, full);
        out.bad("phong-80-jumps", effect, map(&phong, &self.phong));
        out.cured("gouraud-80-jumps", effect, map(&gouraud, &self.gouraud));
        out.seen("phong-80", phong);
        out.seen("gouraud-80", gouraud);
        Ok(())
    }
}

fn largest(jumps: &[[f64; 2]]) -> f64 {
    jumps.iter().map(|jump| jump[1]).fold(0.0, f64::max)
}

/// Half the width of the bars in maps of jumps, in pixels.
const HALF_BAR: f64 = 2.5;

/// Where the slope jumps: a bar at each edge that is measured, as light as the jump is large. Facets beside which nothing is
/// measured are omitted.
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
