//! Pictures of the polygon in its positions, under scanlines and in triangles, and of the rotated one rotated back.

use super::super::prelude::*;
use super::polygon::{Polygon, sin_cos};

pub(super) const FULL: f64 = 0.4;

pub(super) struct Pictures {
    /// Under scanlines: not turned, turned by the given angle and by 90°, and the last turned back.
    pub(super) upright: Image,
    pub(super) turned: Image,
    quarter: Image,
    back: Image,
    triangles_back: Image,
    /// In triangles cut one way and the other; the same where the polygon has one cut only.
    pub(super) cuts: [Image; 2],
    has_one_cut: bool,
}

impl Pictures {
    pub(super) fn draw(polygon: &Polygon, size: u32, turn: Degrees) -> Result<Self> {
        let scanline = |angle| polygon.draw(size, angle, Interpolation::Scanline);
        let (first, second) = (polygon.cut(false)?, polygon.cut(true)?);
        let triangles = |cut: &Polygon, angle| cut.draw(size, angle, Interpolation::Affine);
        let quarter = scanline(QUARTER)?;
        Ok(Self {
            upright: scanline(Degrees(0.0))?,
            turned: scanline(turn)?,
            back: turned_back(&quarter, QUARTER),
            quarter,
            triangles_back: turned_back(&triangles(&first, QUARTER)?, QUARTER),
            cuts: [triangles(&first, Degrees(0.0))?, triangles(&second, Degrees(0.0))?],
            has_one_cut: first.is_cut_as(&second),
        })
    }

    /// Shows the pictures, with the effect of a turn on the centre.
    pub(super) fn show(self, effect: &Effect, out: &mut Recorder) {
        let Self { upright, turned, quarter, back, triangles_back, cuts: [one, other], has_one_cut } = self;
        let changes = [largest_difference(&upright, &back), largest_difference(&one, &triangles_back)];
        let seam = out.effect("seam", "", changes, effect.present.clone(), 10.0);
        out.set("cuts", if has_one_cut { "one" } else { "two" });
        let difference = map(upright.size, &differences(&upright, &back), FULL);
        let between = map(upright.size, &differences(&one, &other), FULL);
        out.bad("halves", &seam, halves(&upright, &back));
        out.cured("halves-triangles", &seam, halves(&one, &triangles_back));
        out.bad("position-1", effect, upright);
        out.bad("turned", effect, turned);
        out.bad("position-2", effect, quarter);
        out.difference("difference", difference, FULL, "");
        out.cured("diagonal-13", effect, one);
        out.cured("diagonal-24", effect, other);
        if !has_one_cut {
            out.difference("diagonals", between, FULL, "");
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

/// The turn that pixels are exchanged by, none of them between others.
const QUARTER: Degrees = Degrees(90.0);

/// For each interpolation, the root mean square difference of the unturned picture and that of a quarter turn, turned back.
pub(super) fn measure(polygon: &Polygon, size: u32, out: &mut Recorder) -> Result<()> {
    let tolerance = polygon.tolerance(size);
    for (name, interpolation) in [
        ("back-scanline", Interpolation::Scanline),
        ("back-triangles", Interpolation::Affine),
        ("back-perspective", Interpolation::Perspective),
    ] {
        let upright = polygon.draw(size, Degrees(0.0), interpolation)?;
        let back = turned_back(&polygon.draw(size, QUARTER, interpolation)?, QUARTER);
        let found = errors(&back, &upright)?[1];
        let law = match interpolation {
            Interpolation::Scanline => law(polygon, &upright, &back, tolerance),
            _ => 0.0,
        };
        out.measure(name, "", found, polygon.check(size, law, tolerance));
    }
    Ok(())
}

/// The same by the law, over the pixels that both pictures cover.
fn law(polygon: &Polygon, upright: &Image, back: &Image, tolerance: f64) -> f64 {
    let [width, height] = upright.size;
    let (mut squares, mut count) = (0.0, 0_u32);
    for pixel in (0..height).flat_map(|y| (0..width).map(move |x| [x, y])) {
        let index = upright.index(pixel[0], pixel[1]);
        if index.is_some_and(|index| upright.coverage[index] > 0 && back.coverage[index] > 0) {
            let place = Polygon::place(pixel, width);
            let colour = |angle| polygon.scanline(place, angle);
            // Where the law jumps it is that of either side: the picture's own colour is used.
            let angles = [QUARTER, Degrees(0.0)];
            let jumps = angles.iter().any(|&angle| polygon.jumps(place, angle, width, tolerance));
            let [turned, straight] = match index.filter(|_| jumps) {
                Some(index) => [back, upright].map(|image| DVec3::from(linear(image)[index].map(f64::from))),
                None => angles.map(colour),
            };
            squares += (turned - straight).length_squared();
            count += 3;
        }
    }
    (squares / f64::from(count.max(1))).sqrt()
}

/// A picture turned back by an angle: bilinear between the four pixels about a pixel's origin, background if one of them is.
pub(super) fn turned_back(image: &Image, angle: Degrees) -> Image {
    let (sin, cos) = sin_cos(angle);
    let [width, height] = image.size;
    let (mid_x, mid_y) = (f64::from(width - 1) / 2.0, f64::from(height - 1) / 2.0);
    let pixels = linear(image);
    let (mut colours, mut coverage) = (Vec::new(), Vec::new());
    for (y, x) in (0..height).flat_map(|y| (0..width).map(move |x| (y, x))) {
        // Rows run downwards.
        let (right, up) = (f64::from(x) - mid_x, mid_y - f64::from(y));
        let from = [mid_x + cos * right - sin * up, mid_y - (sin * right + cos * up)];
        let corner = from.map(libm::floor);
        let [share_x, share_y] = [from[0] - corner[0], from[1] - corner[1]];
        let mut sum = DVec3::ZERO;
        let mut covered = true;
        for (dx, dy) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            let weight = (if dx == 0 { 1.0 - share_x } else { share_x })
                * (if dy == 0 { 1.0 - share_y } else { share_y });
            if weight == 0.0 {
                continue;
            }
            let [column, row] = [corner[0] + f64::from(dx), corner[1] + f64::from(dy)];
            let inside = column >= 0.0 && row >= 0.0;
            let index = inside.then(|| image.index(column as u32, row as u32)).flatten();
            covered &= index.is_some_and(|index| image.coverage[index] > 0);
            if let Some(index) = index {
                sum += DVec3::from(pixels[index].map(f64::from)) * weight;
            }
        }
        let colour = if covered { sum } else { DVec3::from(BACKGROUND.to_array()) };
        colours.push(colour.to_array().map(|component| component as f32));
        coverage.push(u8::from(covered));
    }
    picture(image.size, colours, coverage)
}

#[cfg(test)]
mod tests {
    use super::super::EXPERIMENT;
    use super::*;
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

    #[test]
    fn a_picture_turned_back_a_quarter_is_the_same_pixels() {
        let size = 33;
        let image = Polygon::of(None, size).unwrap().draw(size, Degrees(0.0), Interpolation::Affine).unwrap();
        let mut back = image.clone();
        for _ in 0..4 {
            back = turned_back(&back, Degrees(90.0));
        }
        assert_eq!((linear(&back), &back.coverage), (linear(&image), &image.coverage));
    }
}
