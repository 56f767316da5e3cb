//! A triangle prepared for one tile: edge functions in whole numbers and a plane of depth.

use crate::num::{self, EightLanes, Lanes};
use crate::raster::view::fixed_point::{ONE, first_pixel, last_pixel, whole};
use crate::raster::view::project::ScreenVertex;

pub(crate) const TILE: usize = 64;
/// Pixels along the side of a block, and of the window in which small triangles are drawn.
pub(crate) const SIDE: usize = 4;

/// Twice the signed area of a triangle in squares of 1/256 pixel: positive if clockwise (y is down). Exact: 48 bits.
#[inline(always)]
pub(crate) fn double_area([a, b, c]: &[ScreenVertex; 3]) -> f64 {
    let (x1, y1) = (f64::from(b.x - a.x), f64::from(b.y - a.y));
    let (x2, y2) = (f64::from(c.x - a.x), f64::from(c.y - a.y));
    x1 * y2 - x2 * y1
}

/// A triangle prepared for one sample of each pixel of a tile, in pixels of the tile; or rows of many triangles.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Setup<I = i32, F = f32> {
    /// Each edge's function at pixel (0, 0), divided by 256 and rounded down, and its growth per pixel to the right and down. A
    /// sample is covered where all three are 0 or more.
    pub(crate) edge: [I; 3],
    pub(crate) right: [I; 3],
    pub(crate) down: [I; 3],
    pub(crate) depth: F,
    pub(crate) depth_right: F,
    pub(crate) depth_down: F,
    /// Depth stays between those of the corners.
    pub(crate) depth_range: [F; 2],
    /// The first and last pixel that may be covered, in x and in y; the last before the first if there is none.
    pub(crate) x: [I; 2],
    pub(crate) y: [I; 2],
}

/// Bound of what edge functions grow by within a tile: 63 · (2²³ + 2²³) < 2³⁰. Beyond it only the sign counts.
const FAR: f64 = (1 << 30) as f64;

impl Setup {
    /// Prepares a triangle of non-zero area for the tile with the sample of pixel (0, 0) at `origin` (in 256ths of a pixel of the
    /// picture). Edge functions are exact in doubles, and change by multiples of 256 from sample to sample: divided by 256 and
    /// rounded down they keep their signs and fit into 32 bits. There is no branch, for vector code.
    #[inline(always)]
    pub(crate) fn new([a, b, c]: [ScreenVertex; 3], origin: [i32; 2]) -> Self {
        let last = TILE as i32 - 1;
        let low = |a: i32, b: i32, c: i32| a.min(b).min(c);
        let high = |a: i32, b: i32, c: i32| a.max(b).max(c);
        let pixels = |low: i32, high: i32, origin: i32| {
            [first_pixel(low, origin).max(0), last_pixel(high, origin).min(last)]
        };
        let x = pixels(low(a.x, b.x, c.x), high(a.x, b.x, c.x), origin[0]);
        let y = pixels(low(a.y, b.y, c.y), high(a.y, b.y, c.y), origin[1]);
        let area = double_area(&[a, b, c]);
        let v = [a, select(area < 0.0, c, b), select(area < 0.0, b, c)];
        let (mut edge, mut right, mut down) = ([0; 3], [0; 3], [0; 3]);
        for i in 0..3 {
            let (from, to) = (&v[i], &v[(i + 1) % 3]);
            let (dx, dy) = (to.x - from.x, to.y - from.y);
            // Top-left rule: a sample on an edge belongs to the triangle to the right of it, or below a level edge.
            let is_top_left = (dy < 0) | ((dy == 0) & (dx > 0));
            let at_origin = f64::from(dx) * f64::from(origin[1] - from.y)
                - f64::from(dy) * f64::from(origin[0] - from.x)
                - if is_top_left { 0.0 } else { 1.0 };
            edge[i] = whole((at_origin * (1.0 / f64::from(ONE))).floor().clamp(-FAR, FAR));
            (right[i], down[i]) = (-dy, dx);
        }
        let [depth, depth_right, depth_down] = depth_plane(&v, area.abs(), origin);
        let (low, high) =
            (|a: f32, b: f32| if a < b { a } else { b }, |a: f32, b: f32| if a > b { a } else { b });
        let depth_range = [low(low(a.depth, b.depth), c.depth), high(high(a.depth, b.depth), c.depth)];
        Self { edge, right, down, depth, depth_right, depth_down, depth_range, x, y }
    }

    #[inline(always)]
    pub(crate) fn is_empty(&self) -> bool {
        let last = TILE as i32 - 1;
        // Within the tile an edge function is greatest in one of its corners.
        let misses =
            |i: usize| self.edge[i] + (last * self.right[i]).max(0) + (last * self.down[i]).max(0) < 0;
        self.x[0] > self.x[1] || self.y[0] > self.y[1] || (0..3).any(misses)
    }
}

#[inline(always)]
fn select(first: bool, a: ScreenVertex, b: ScreenVertex) -> ScreenVertex {
    ScreenVertex {
        x: if first { a.x } else { b.x },
        y: if first { a.y } else { b.y },
        depth: if first { a.depth } else { b.depth },
        outside: 0,
    }
}

/// Depth at a sample and its growth per pixel to the right and down. It is computed from the corner that is first in
/// (y, x), so that the order of corners changes no bit: of two faces with the same corners the first is visible
/// everywhere.
#[inline(always)]
pub(crate) fn depth_plane([a, b, c]: &[ScreenVertex; 3], area: f64, origin: [i32; 2]) -> [f32; 3] {
    let before = |a: &ScreenVertex, b: &ScreenVertex| (a.y < b.y) | ((a.y == b.y) & (a.x < b.x));
    let (ab, bc, ca) = (before(a, b), before(b, c), before(c, a));
    let (is_a, is_b) = (ab & !ca, bc & !ab);
    let pick = |a, b, c| select(is_a, a, select(is_b, b, c));
    let (a, b, c) = (pick(*a, *b, *c), pick(*b, *c, *a), pick(*c, *a, *b));
    let (d1, d2) = (f64::from(b.depth) - f64::from(a.depth), f64::from(c.depth) - f64::from(a.depth));
    let (x1, y1) = (f64::from(b.x - a.x), f64::from(b.y - a.y));
    let (x2, y2) = (f64::from(c.x - a.x), f64::from(c.y - a.y));
    let per_area = 1.0 / area;
    let right = (d1 * y2 - d2 * y1) * per_area;
    let down = (d2 * x1 - d1 * x2) * per_area;
    let depth = f64::from(a.depth) + (right * f64::from(origin[0] - a.x) + down * f64::from(origin[1] - a.y));
    let one = f64::from(ONE);
    [depth as f32, (right * one) as f32, (down * one) as f32]
}

/// In place of the pixels of a triangle that covers more than 4 × 4.
pub(crate) const LARGE: u32 = u32::MAX;

/// Triangles that are prepared side by side.
pub(crate) const GROUP: usize = 32;

/// Where the corners of a group of triangles are stored.
pub(crate) struct Corners<'a>([[&'a ScreenVertex; GROUP]; 3]);

impl<'a> Corners<'a> {
    pub(crate) fn new() -> Self {
        Self([[&ScreenVertex { x: 0, y: 0, depth: 0.0, outside: 0 }; GROUP]; 3])
    }

    #[inline(always)]
    pub(crate) fn set(&mut self, lane: usize, [a, b, c]: [&'a ScreenVertex; 3]) {
        (self.0[0][lane], self.0[1][lane], self.0[2][lane]) = (a, b, c);
    }
}

/// Corners of a group of triangles, row by row.
#[derive(Default)]
pub(crate) struct CornerRows {
    x: [[i32; GROUP]; 3],
    y: [[i32; GROUP]; 3],
    depth: [[f32; GROUP]; 3],
    pub(crate) outside: [[u32; GROUP]; 3],
}

impl CornerRows {
    /// Turns eight vertices at a time into rows: reading them number by number takes as long as all that follows.
    #[inline(always)]
    pub(crate) fn load<A: Lanes>(&mut self, arch: A, corners: &Corners) {
        let single = arch.singles();
        for (k, corners) in corners.0.iter().enumerate() {
            for (eight, v) in corners.as_chunks::<{ num::LANES }>().0.iter().enumerate() {
                let rows = [v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7]];
                let [x, y, depth, outside] = single.columns(rows.map(bytemuck::cast_ref));
                let at = eight * num::LANES..(eight + 1) * num::LANES;
                self.x[k][at.clone()].copy_from_slice(&bytemuck::cast::<_, [i32; 8]>(single.to_array(x)));
                self.y[k][at.clone()].copy_from_slice(&bytemuck::cast::<_, [i32; 8]>(single.to_array(y)));
                self.depth[k][at.clone()].copy_from_slice(&single.to_array(depth));
                self.outside[k][at].copy_from_slice(&bytemuck::cast::<_, [u32; 8]>(single.to_array(outside)));
            }
        }
    }

    #[cfg(test)]
    pub(crate) fn set(&mut self, lane: usize, v: &[ScreenVertex; 3]) {
        for (k, v) in v.iter().enumerate() {
            (self.x[k][lane], self.y[k][lane], self.depth[k][lane]) = (v.x, v.y, v.depth);
        }
    }

    #[inline(always)]
    pub(crate) fn get(&self, lane: usize) -> [ScreenVertex; 3] {
        [0, 1, 2].map(|k| ScreenVertex {
            x: self.x[k][lane],
            y: self.y[k][lane],
            depth: self.depth[k][lane],
            outside: 0,
        })
    }
}

impl Setup<[i32; GROUP], [f32; GROUP]> {
    #[inline(always)]
    pub(crate) fn prepare(&mut self, corners: &CornerRows, origin: [i32; 2]) {
        for lane in 0..GROUP {
            let setup = Setup::new(corners.get(lane), origin);
            for i in 0..3 {
                self.edge[i][lane] = setup.edge[i];
                self.right[i][lane] = setup.right[i];
                self.down[i][lane] = setup.down[i];
            }
            self.depth[lane] = setup.depth;
            self.depth_right[lane] = setup.depth_right;
            self.depth_down[lane] = setup.depth_down;
            for i in 0..2 {
                self.depth_range[i][lane] = setup.depth_range[i];
                self.x[i][lane] = setup.x[i];
                self.y[i][lane] = setup.y[i];
            }
        }
    }

    /// The covered pixels of the 4 × 4 from the first that each triangle may cover, a bit for each, row by row; [`LARGE`] for
    /// triangles that may cover others too.
    #[inline(always)]
    pub(crate) fn masks(&self, masks: &mut [u32; GROUP]) {
        // The sign of each edge's complement, from the last pixel to the first.
        masks.fill(0);
        let mut edge = [[0; GROUP]; 3];
        for (i, edge) in edge.iter_mut().enumerate() {
            for (lane, edge) in edge.iter_mut().enumerate() {
                // Within the tile below 2³¹, as in `Setup::new`; pixels beyond may wrap and are masked out.
                let right = self.right[i][lane].wrapping_mul(self.x[0][lane] + SIDE as i32 - 1);
                let down = self.down[i][lane].wrapping_mul(self.y[0][lane] + SIDE as i32 - 1);
                *edge = self.edge[i][lane].wrapping_add(right).wrapping_add(down);
            }
        }
        for pixel in (0..SIDE * SIDE).rev() {
            for (lane, mask) in masks.iter_mut().enumerate() {
                let outside = (edge[0][lane] | edge[1][lane] | edge[2][lane]) as u32 >> 31;
                *mask = *mask << 1 | (1 - outside);
            }
            for (i, edge) in edge.iter_mut().enumerate() {
                let last = if pixel % SIDE == 0 { SIDE as i32 - 1 } else { -1 };
                for (lane, edge) in edge.iter_mut().enumerate() {
                    // To the left; or to the end of the row above.
                    let step = self.right[i][lane].wrapping_mul(last);
                    let up = if pixel % SIDE == 0 { self.down[i][lane] } else { 0 };
                    *edge = edge.wrapping_add(step).wrapping_sub(up);
                }
            }
        }
        for (lane, mask) in masks.iter_mut().enumerate() {
            let (columns, rows) = (self.x[1][lane] - self.x[0][lane], self.y[1][lane] - self.y[0][lane]);
            let fits = (columns < SIDE as i32) & (rows < SIDE as i32);
            let is_empty = (columns < 0) | (rows < 0);
            // In the box: as many columns of each row, and as many rows.
            let in_columns = ((2_u32 << (columns & 3)) - 1) * 0x1111;
            let in_rows = (0x10_u32 << ((rows & 3) * SIDE as i32)) - 1;
            let small = if is_empty { 0 } else { *mask & in_columns & in_rows };
            *mask = if fits { small } else { LARGE };
        }
    }

    #[inline(always)]
    pub(crate) fn get(&self, lane: usize) -> Setup {
        Setup {
            edge: self.edge.each_ref().map(|row| row[lane]),
            right: self.right.each_ref().map(|row| row[lane]),
            down: self.down.each_ref().map(|row| row[lane]),
            depth: self.depth[lane],
            depth_right: self.depth_right[lane],
            depth_down: self.depth_down[lane],
            depth_range: self.depth_range.each_ref().map(|row| row[lane]),
            x: self.x.each_ref().map(|row| row[lane]),
            y: self.y.each_ref().map(|row| row[lane]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::test_numbers::Numbers;

    fn vertex([x, y]: [i32; 2], depth: f32) -> ScreenVertex {
        ScreenVertex { x, y, depth, outside: 0 }
    }

    /// The pixels of a tile that a triangle covers, straight from its definition in 128-bit numbers.
    fn covered(v: &[[i32; 2]; 3], [x, y]: [i32; 2]) -> bool {
        let wide = |p: [i32; 2]| p.map(i128::from);
        let mut v = v.map(wide);
        let [x, y] = wide([x, y]);
        let area = (v[1][0] - v[0][0]) * (v[2][1] - v[0][1]) - (v[2][0] - v[0][0]) * (v[1][1] - v[0][1]);
        if area < 0 {
            v.swap(1, 2);
        }
        (0..3).all(|i| {
            let (a, b) = (v[i], v[(i + 1) % 3]);
            let side = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
            side > 0 || side == 0 && (b[1] < a[1] || b[1] == a[1] && b[0] > a[0])
        })
    }

    /// Triangles of every size within the guard band, against exact arithmetic.
    #[test]
    fn coverage_is_exact() {
        let mut numbers = Numbers::new(3);
        let mut seen = [0; 2];
        for round in 0..4000 {
            let reach = [300, 40_000, 1 << 22, 1 << 23][round % 4];
            let origin = [128 + 64 * ONE * numbers.below(4) as i32, 128];
            let mut place = || {
                [0; 2].map(|_| {
                    let place = numbers.below(2 * reach as usize) as i32 - reach + 8192;
                    // A third of the corners on samples, so that edges run through samples.
                    let place = if numbers.below(3) == 0 { (place & !0xff) + 128 } else { place };
                    place.clamp(-(1 << 22), 1 << 22)
                })
            };
            let places = [place(), place(), place()];
            let v = places.map(|place| vertex(place, 0.5));
            if double_area(&v) == 0.0 {
                continue;
            }
            let setup = Setup::new(v, origin);
            for y in (0..64).step_by(3) {
                for x in (0..64).step_by(3) {
                    let inside = !setup.is_empty() && {
                        let s = &setup;
                        (s.x[0]..=s.x[1]).contains(&x)
                            && (s.y[0]..=s.y[1]).contains(&y)
                            && (0..3).all(|i| s.edge[i] + s.right[i] * x + s.down[i] * y >= 0)
                    };
                    let truth = covered(&places, [origin[0] + ONE * x, origin[1] + ONE * y]);
                    assert_eq!(inside, truth, "{places:?} {origin:?} {x} {y}");
                    seen[usize::from(truth)] += 1;
                }
            }
        }
        assert!(seen.iter().all(|&seen| seen > 10_000), "{seen:?}");
    }

    /// Direct3D 9's example: pixel centres at whole numbers, a diagonal shared by two triangles.
    #[test]
    fn the_top_left_rule_gives_15_and_10() {
        let count = |corners: [[i32; 2]; 3]| {
            let v = corners.map(|corner| corner.map(|x| x * ONE)).map(|place| vertex(place, 1.0));
            let setup = Setup::new(v, [0, 0]);
            let inside =
                |x: i32, y: i32| (0..3).all(|i| setup.edge[i] + setup.right[i] * x + setup.down[i] * y >= 0);
            (0..64 * 64).filter(|i| inside(i % 64, i / 64)).count()
        };
        assert_eq!(count([[0, 0], [5, 0], [5, 5]]), 15);
        assert_eq!(count([[0, 5], [0, 0], [5, 5]]), 10);
    }

    #[test]
    fn depth_does_not_depend_on_the_first_corner_or_the_way_round() {
        let mut numbers = Numbers::new(4);
        for _ in 0..1000 {
            let v = [0; 3].map(|_| {
                let place = [0; 2].map(|_| numbers.below(20_000) as i32);
                vertex(place, numbers.unit() as f32)
            });
            let area = double_area(&v);
            if area == 0.0 {
                continue;
            }
            let expected = depth_plane(&v, area, [128, 128]);
            let [a, b, c] = v;
            for order in [[b, c, a], [c, a, b]] {
                assert_eq!(depth_plane(&order, area, [128, 128]), expected);
            }
            for order in [[a, c, b], [c, b, a], [b, a, c]] {
                assert_eq!(depth_plane(&order, -area, [128, 128]), expected);
            }
            for v in v {
                let [depth, right, down] = depth_plane(&[a, b, c], area, [v.x, v.y]);
                let _ = (right, down);
                // One rounding of the result; the plane itself is in doubles.
                assert!((depth - v.depth).abs() < 1e-6 * (1.0 + 1e9 / area.abs() as f32));
            }
        }
    }
}
