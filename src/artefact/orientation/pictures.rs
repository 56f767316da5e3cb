//! The polygon in its positions, under scanlines and in triangles.

use super::super::prelude::*;
use super::polygon::Polygon;
use super::turned_back::turned_back;

/// Full scale of the maps of differences.
pub(super) const FULL: f64 = 0.4;

/// The pictures that are compared.
pub(super) struct Pictures {
    /// Under scanlines: not turned, turned by 45° and by 90°, and the last turned back.
    upright: Image,
    half: Image,
    turned: Image,
    back: Image,
    /// In triangles, turned by 90° and turned back.
    triangles_back: Image,
    /// In triangles cut one way and the other; the same where the polygon has one cut only.
    pub(super) cuts: [Image; 2],
    has_one_cut: bool,
}

impl Pictures {
    pub(super) fn draw(polygon: &Polygon, size: u32) -> Result<Self> {
        let right_angle = Degrees(90.0);
        let scanline = |angle| polygon.draw(size, angle, Interpolation::Scanline);
        let (first, second) = (polygon.cut(false)?, polygon.cut(true)?);
        let triangles = |cut: &Polygon, angle| cut.draw(size, angle, Interpolation::Affine);
        let turned = scanline(right_angle)?;
        Ok(Self {
            upright: scanline(Degrees(0.0))?,
            half: scanline(Degrees(45.0))?,
            back: turned_back(&turned, right_angle),
            turned,
            triangles_back: turned_back(&triangles(&first, right_angle)?, right_angle),
            cuts: [triangles(&first, Degrees(0.0))?, triangles(&second, Degrees(0.0))?],
            has_one_cut: first.is_cut_as(&second),
        })
    }

    /// Shows the pictures, with the effect of a turn on the centre.
    pub(super) fn show(self, effect: &Effect, out: &mut Recorder) {
        let Self { upright, half, turned, back, triangles_back, cuts: [one, other], has_one_cut } = self;
        let largest = |a: &Image, b: &Image| differences(a, b).into_iter().flatten().fold(0.0, f64::max);
        let changes = [largest(&upright, &back), largest(&one, &triangles_back)];
        let seam = out.effect("seam", "", changes, effect.present.clone(), 10.0);
        out.set("cuts", if has_one_cut { "one" } else { "two" });
        let difference = map(upright.size, &differences(&upright, &back), FULL);
        let between = map(upright.size, &differences(&one, &other), FULL);
        out.bad("halves", &seam, halves(&upright, &back));
        out.cured("halves-triangles", &seam, halves(&one, &triangles_back));
        out.bad("position-1", effect, upright);
        out.bad("turned-45", effect, half);
        out.bad("position-2", effect, turned);
        out.difference("difference", difference);
        out.cured("diagonal-13", effect, one);
        out.cured("diagonal-24", effect, other);
        if !has_one_cut {
            out.difference("diagonals", between);
        }
    }
}

/// The upper half of a picture above the lower half of another of the same size: where both show the same, there is no seam.
fn halves(upper: &Image, lower: &Image) -> Image {
    let [width, height] = upper.size;
    let middle = (width * (height / 2)) as usize;
    let colours = [&linear(upper)[..middle], &linear(lower)[middle..]].concat();
    let coverage = [&upper.coverage[..middle], &lower.coverage[middle..]].concat();
    picture(upper.size, colours, coverage)
}

#[cfg(test)]
mod tests {
    use super::super::EXPERIMENT;
    use crate::artefact::drawing::luminance;
    use crate::artefact::{Parameters, Setup};

    /// The seam's height at the centre: the colours of the exercise's two positions against none.
    #[test]
    fn halves_fit_only_in_triangles() {
        let parameters = Parameters { size: 129, ..EXPERIMENT.defaults };
        let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
        let seam = |name: &str| {
            let image = &outcome.shots.iter().find(|shot| shot.name == name).unwrap().image;
            let at = |y| luminance(image)[image.index(64, y).unwrap()];
            (at(63) - at(64)).abs()
        };
        // (0.1, 0.5, 0.5) and (0.2, 0.3, 0.1) as luminances, and what changes from a row to the next.
        let [one, two] =
            [[0.1, 0.5, 0.5], [0.2, 0.3, 0.1]].map(|[r, g, b]| 0.2126 * r + 0.7152 * g + 0.0722 * b);
        let row = 2.0 * 0.6 / 112.0;
        let [scanline, triangles] = ["halves", "halves-triangles"].map(seam);
        assert!((scanline - (one - two)).abs() < row && triangles < row, "{scanline} {triangles}");
    }
}
