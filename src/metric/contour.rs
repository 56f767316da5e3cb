//! Outlines by marching squares.

use crate::raster::{Image, Samples};

/// The outline of all that a picture shows: closed polygons, in pixels from its upper left corner.
///
/// The covered share of a pixel's samples is a function of the pixel's centre; the outline is where it is ½, linearly
/// interpolated between neighbouring centres (marching squares; at saddles the mean of four centres decides). Nothing is
/// covered outside of the picture.
///
/// *Accuracy.* With one sample a pixel a vertical edge is found within ½ pixel. With many, a vertical edge at ½ + c, whose
/// pixel has the covered share c ≥ ½, is found at 1 + (c − ½)/c pixels: at most 3/2 − √2 ≈ 0.0858 pixels off, plus the
/// distance of samples, 1/16 of a pixel for sixteen. Corners are cut by a fraction of a pixel.
///
/// *Does not measure* inner outlines, where one part of an object hides another.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Contour {
    loops: Vec<Vec<[f64; 2]>>,
}

impl Contour {
    /// The outline in a picture that was drawn with so many samples a pixel; no loops if nothing is covered.
    pub fn of(image: &Image, samples: Samples) -> Self {
        let grid = Grid { image, full: samples.count() as f64 };
        let mut segments = grid.segments();
        segments.sort_unstable();
        let mut used = vec![false; segments.len()];
        let points_from = |first: usize| {
            let (mut points, mut at) = (Vec::new(), first);
            while !used[at] {
                used[at] = true;
                points.push(grid.crossing(segments[at].0));
                // Each crossing ends one segment and begins one: loops close.
                at = segments.binary_search_by_key(&segments[at].1, |segment| segment.0).unwrap_or(first);
            }
            points
        };
        let loops = (0..segments.len()).map(points_from).filter(|points| !points.is_empty()).collect();
        Self { loops }
    }

    /// The area within, without holes, in square pixels.
    pub fn area(&self) -> f64 {
        self.segments().map(|[a, b]| 0.5 * (a[0] * b[1] - b[0] * a[1])).sum()
    }

    pub(super) fn segments(&self) -> impl Iterator<Item = [[f64; 2]; 2]> {
        self.loops.iter().flat_map(|points| {
            let next = points.iter().cycle().skip(1);
            points.iter().zip(next).map(|(&a, &b)| [a, b])
        })
    }
}

/// Centres of pixels and a border of one more around them, where nothing is covered.
struct Grid<'a> {
    image: &'a Image,
    /// Samples of a pixel.
    full: f64,
}

/// A side of a cell between four centres: twice the number of its first centre, plus 1 for those that go down.
type Side = u64;

impl Grid<'_> {
    fn columns(&self) -> u64 {
        u64::from(self.image.size[0]) + 2
    }

    fn rows(&self) -> u64 {
        u64::from(self.image.size[1]) + 2
    }

    /// The share covered of a centre; the first inside the picture is (1, 1).
    fn share(&self, x: u64, y: u64) -> f64 {
        let pixel = |n: u64| u32::try_from(n).unwrap_or(u32::MAX).wrapping_sub(1);
        self.image.index(pixel(x), pixel(y)).map_or(0.0, |i| f64::from(self.image.coverage[i]) / self.full)
    }

    /// Where along a side the share is ½.
    fn crossing(&self, side: Side) -> [f64; 2] {
        let (node, down) = (side / 2, side % 2);
        let (x, y) = (node % self.columns(), node / self.columns());
        let from = self.share(x, y);
        let to = self.share(x + 1 - down, y + down);
        let t = (from - 0.5) / (from - to);
        let [across, below] = if down == 1 { [0.0, t] } else { [t, 0.0] };
        [x as f64 - 0.5 + across, y as f64 - 0.5 + below]
    }

    /// The directed segments of the outline, each from one side of its cell to another, with the covered side on their right
    /// in the picture.
    fn segments(&self) -> Vec<(Side, Side)> {
        let mut segments = Vec::new();
        let columns = self.columns();
        for y in 0..self.rows() - 1 {
            for x in 0..columns - 1 {
                // Clockwise on the picture from the upper left.
                let shares =
                    [self.share(x, y), self.share(x + 1, y), self.share(x + 1, y + 1), self.share(x, y + 1)];
                let inside = shares.map(|share| share >= 0.5);
                if inside == [inside[0]; 4] {
                    continue;
                }
                let node = y * columns + x;
                let sides: [Side; 4] = [2 * node, 2 * (node + 1) + 1, 2 * (node + columns), 2 * node + 1];
                let leaves = |k: usize| inside[k] && !inside[(k + 1) % 4];
                let enters = |k: usize| !inside[k] && inside[(k + 1) % 4];
                let is_joined = shares.iter().sum::<f64>() >= 2.0;
                for k in (0..4).filter(|&k| leaves(k)) {
                    // At a saddle the partner is the next side that enters if the covered corners are joined, else the
                    // previous one.
                    let steps = [1, 2, 3].map(|step| if is_joined { k + step } else { k + 4 - step });
                    if let Some(other) = steps.into_iter().map(|k| k % 4).find(|&k| enters(k)) {
                        segments.push((sides[k], sides[other]));
                    }
                }
            }
        }
        segments
    }
}

#[cfg(test)]
mod tests {
    use super::super::pictures_tests::shape;
    use super::*;

    #[test]
    fn upright_edges_are_found_as_well_as_promised() {
        for samples in [Samples::One, Samples::Sixteen] {
            let mut worst: f64 = 0.0;
            for step in 0..64 {
                let right = 10.0 + f64::from(step) / 32.0;
                let image = shape([20, 6], samples, |x, _| x < right);
                let contour = Contour::of(&image, samples);
                assert_eq!(contour.loops.len(), 1);
                let found = contour.loops[0].iter().filter(|point| (point[1] - 3.0).abs() < 1.0);
                let found = found.map(|point| point[0]).fold(0.0, f64::max);
                worst = worst.max((found - right).abs());
            }
            let allowed = if samples == Samples::One { 0.5 } else { 1.5 - 2.0_f64.sqrt() + 1.0 / 16.0 };
            assert!(worst <= allowed && worst > 0.5 * allowed, "{worst} of {allowed}");
        }
    }

    #[test]
    fn holes_are_taken_off_and_corners_kept_separate() {
        // A square of 8 with a hole of 2: corners lose an eighth of a pixel each, those of the hole gain it.
        let ring = |x: f64, y: f64| {
            let inside = |low: f64, high: f64| x > low && x < high && y > low && y < high;
            inside(2.0, 10.0) && !inside(5.0, 7.0)
        };
        let contour = Contour::of(&shape([12, 12], Samples::One, ring), Samples::One);
        assert_eq!(contour.loops.len(), 2);
        assert_eq!(contour.area(), (64.0 - 0.5) - (4.0 - 0.5));
        // Two pixels that touch at a corner: the mean of the four is ½, which joins them.
        let touching =
            |x: f64, y: f64| (x < 3.0) == (y < 3.0) && (x - 3.0).abs() < 1.0 && (y - 3.0).abs() < 1.0;
        assert_eq!(Contour::of(&shape([6, 6], Samples::One, touching), Samples::One).loops.len(), 1);
        assert_eq!(Contour::of(&shape([6, 6], Samples::One, |_, _| false), Samples::One), Contour::default());
    }

    #[test]
    fn what_leaves_the_picture_ends_there() {
        let contour = Contour::of(&shape([5, 4], Samples::Four, |_, _| true), Samples::Four);
        // The picture's rectangle without its corners.
        assert_eq!(contour.area(), 20.0 - 0.5);
    }
}
