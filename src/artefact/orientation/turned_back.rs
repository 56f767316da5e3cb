//! Pictures of the rotated polygon rotated back, for comparison with the original one.

use super::super::prelude::*;
use super::polygon::{Polygon, sin_cos};

/// The turn that pixels are exchanged by, none of them between others.
const QUARTER: Degrees = Degrees(90.0);

/// For each interpolation, how far the picture of a quarter turn, turned back, is from that of none (root mean square over
/// pixels and components).
pub(super) fn measure(polygon: &Polygon, size: u32, out: &mut Recorder) -> Result<()> {
    let tolerance = polygon.tolerance(size);
    for (name, interpolation) in [
        ("back-scanline", Interpolation::Scanline),
        ("back-triangles", Interpolation::Affine),
        ("back-perspective", Interpolation::Perspective),
    ] {
        let upright = polygon.draw(size, Degrees(0.0), interpolation)?;
        let back = turned_back(&polygon.draw(size, QUARTER, interpolation)?, QUARTER);
        let found = image_error(&back, &upright, 0.5)?.linear.rms / 255.0;
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
            // Where the law jumps it is that of either side: what is there stands for it.
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

/// A picture of something turned by an angle, turned back: every pixel is where its centre came from, bilinear between the
/// four pixels about it, and background if one of those is.
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
    use super::*;

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
