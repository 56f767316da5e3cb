//! A triangle prepared for one tile: edge functions in whole numbers and a plane of depth.

use super::fixed::{BITS, ONE, first_pixel, last_pixel};
use super::project::ScreenVertex;

/// Pixels along the side of a tile.
pub(super) const TILE: usize = 64;

/// Twice the signed area of a triangle in squares of 1/256 pixel: positive if it runs clockwise as seen (y is down).
#[inline(always)]
pub(super) fn double_area([a, b, c]: &[ScreenVertex; 3]) -> i64 {
    let (x1, y1) = (i64::from(b.x) - i64::from(a.x), i64::from(b.y) - i64::from(a.y));
    let (x2, y2) = (i64::from(c.x) - i64::from(a.x), i64::from(c.y) - i64::from(a.y));
    x1 * y2 - x2 * y1
}

/// What covers pixels of a tile. Coordinates are pixels of the tile; each is looked at in one sample.
#[derive(Clone, Copy, Debug)]
pub(super) struct Setup {
    /// Each edge's function at pixel (0, 0), divided by 256 and rounded down, and its growth per pixel to the right and
    /// down. A sample is covered where all three are 0 or more.
    pub(super) edge: [i32; 3],
    pub(super) right: [i32; 3],
    pub(super) down: [i32; 3],
    /// Depth at pixel (0, 0) and its growth.
    pub(super) depth: f32,
    pub(super) depth_right: f32,
    pub(super) depth_down: f32,
    /// Depth stays between those of the corners.
    pub(super) depth_range: [f32; 2],
    /// The first and last pixel that may be covered, in x and in y.
    pub(super) x: [i32; 2],
    pub(super) y: [i32; 2],
}

/// Bound of what edge functions grow by within a tile: 63 · (2²³ + 2²³) < 2³⁰. Beyond it only the sign counts.
const FAR: i64 = 1 << 30;

impl Setup {
    /// Prepares a triangle of non-zero area for the tile whose pixel (0, 0) has its sample at `origin` (in 256ths of a
    /// pixel of the picture); `None` if it covers nothing there.
    ///
    /// Edge functions are exact. As they change by multiples of 256 from sample to sample, dividing by 256 and rounding
    /// down keeps their signs and lets 32 bits do for triangles of any size within the guard band.
    #[inline(always)]
    pub(super) fn new(mut v: [ScreenVertex; 3], origin: [i32; 2]) -> Option<Self> {
        let last = TILE as i32 - 1;
        let low = |f: fn(&ScreenVertex) -> i32| f(&v[0]).min(f(&v[1])).min(f(&v[2]));
        let high = |f: fn(&ScreenVertex) -> i32| f(&v[0]).max(f(&v[1])).max(f(&v[2]));
        let pixels = |low: i32, high: i32, origin: i32| {
            [first_pixel(low, origin).max(0), last_pixel(high, origin).min(last)]
        };
        let x = pixels(low(|v| v.x), high(|v| v.x), origin[0]);
        let y = pixels(low(|v| v.y), high(|v| v.y), origin[1]);
        if x[0] > x[1] || y[0] > y[1] {
            return None;
        }
        let mut area = double_area(&v);
        if area < 0 {
            v.swap(1, 2);
            area = -area;
        }
        let (mut edge, mut right, mut down) = ([0; 3], [0; 3], [0; 3]);
        for i in 0..3 {
            let (from, to) = (&v[i], &v[(i + 1) % 3]);
            let (dx, dy) = (to.x - from.x, to.y - from.y);
            // Top-left rule: a sample on an edge belongs to the triangle to the right of it or, if the edge is
            // level, below it.
            let is_top_left = dy < 0 || dy == 0 && dx > 0;
            let at_origin = i64::from(dx) * i64::from(origin[1] - from.y)
                - i64::from(dy) * i64::from(origin[0] - from.x)
                - i64::from(!is_top_left);
            edge[i] = (at_origin >> BITS).clamp(-FAR, FAR) as i32;
            (right[i], down[i]) = (-dy, dx);
        }
        let [depth, depth_right, depth_down] = depth_plane(&v, area, origin);
        let depths = v.map(|v| v.depth);
        let depth_range = [depths[0].min(depths[1]).min(depths[2]), depths[0].max(depths[1]).max(depths[2])];
        Some(Self { edge, right, down, depth, depth_right, depth_down, depth_range, x, y })
    }
}

/// Depth at a sample and its growth per pixel to the right and down.
///
/// Starts from the corner that is first in (y, x): then neither the way round nor the corner that a face begins with
/// changes a bit, and of two faces with the same corners the first one wins everywhere.
#[inline(always)]
pub(super) fn depth_plane(v: &[ScreenVertex; 3], area: i64, origin: [i32; 2]) -> [f32; 3] {
    let before = |a: usize, b: usize| (v[a].y, v[a].x) < (v[b].y, v[b].x);
    let start = match (before(0, 1), before(1, 2), before(2, 0)) {
        (true, _, false) => 0,
        (false, true, _) => 1,
        _ => 2,
    };
    let [a, b, c] = [0, 1, 2].map(|k| &v[(start + k) % 3]);
    let (d1, d2) = (f64::from(b.depth) - f64::from(a.depth), f64::from(c.depth) - f64::from(a.depth));
    let (x1, y1) = (f64::from(b.x - a.x), f64::from(b.y - a.y));
    let (x2, y2) = (f64::from(c.x - a.x), f64::from(c.y - a.y));
    let per_area = 1.0 / area as f64;
    let right = (d1 * y2 - d2 * y1) * per_area;
    let down = (d2 * x1 - d1 * x2) * per_area;
    let depth = f64::from(a.depth) + (right * f64::from(origin[0] - a.x) + down * f64::from(origin[1] - a.y));
    let one = f64::from(ONE);
    [depth as f32, (right * one) as f32, (down * one) as f32]
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
            if double_area(&v) == 0 {
                continue;
            }
            let setup = Setup::new(v, origin);
            for y in (0..64).step_by(3) {
                for x in (0..64).step_by(3) {
                    let inside = setup.is_some_and(|s| {
                        (s.x[0]..=s.x[1]).contains(&x)
                            && (s.y[0]..=s.y[1]).contains(&y)
                            && (0..3).all(|i| s.edge[i] + s.right[i] * x + s.down[i] * y >= 0)
                    });
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
            let setup = Setup::new(v, [0, 0]).unwrap();
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
            if area == 0 {
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
