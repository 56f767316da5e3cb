//! The visible triangle at each pixel of a tile of 16 × 16 blocks of 4 × 4 pixels, stored block by block.

use crate::raster::coverage::setup::{GROUP, SIDE, Setup, TILE};

pub(crate) const LANES: usize = SIDE * SIDE;
/// Blocks along the side of a tile.
pub(crate) const BLOCKS: usize = TILE / SIDE;
pub(crate) const PIXELS: usize = TILE * TILE;
/// Colours of the pixels of a tile, a row for each component.
pub(crate) type Colours = [Box<[f32; PIXELS]>; 3];
pub(crate) const NOTHING: u32 = u32::MAX;

/// Where in a tile the pixel stored under this number lies.
#[inline(always)]
pub(crate) fn place(pixel: usize) -> [usize; 2] {
    let (block, lane) = (pixel / LANES, pixel % LANES);
    [block % BLOCKS * SIDE + lane % SIDE, block / BLOCKS * SIDE + lane / SIDE]
}

/// Under which number a pixel of a tile is stored.
#[inline(always)]
pub(crate) fn number([x, y]: [usize; 2]) -> usize {
    (y / SIDE * BLOCKS + x / SIDE) * LANES + y % SIDE * SIDE + x % SIDE
}

pub(crate) struct Visible {
    /// Larger is nearer; −∞ where there is nothing.
    pub(crate) depth: Box<[f32; PIXELS]>,
    pub(crate) owner: Box<[u32; PIXELS]>,
}

impl Visible {
    pub(crate) fn new() -> Self {
        Self { depth: Box::new([f32::NEG_INFINITY; PIXELS]), owner: Box::new([NOTHING; PIXELS]) }
    }

    pub(crate) fn clear(&mut self) {
        self.depth.fill(f32::NEG_INFINITY);
        self.owner.fill(NOTHING);
    }

    /// Draws one of a group by its mask of covered pixels, with the bits of [`draw`](Self::draw).
    #[inline(always)]
    pub(crate) fn draw_small(
        &mut self,
        group: &Setup<[i32; GROUP], [f32; GROUP]>,
        lane: usize,
        mut mask: u32,
        owner: u32,
    ) {
        let [x, y] = [group.x[0][lane] as usize, group.y[0][lane] as usize];
        let [right, down] = [group.depth_right[lane], group.depth_down[lane]];
        let range = group.depth_range.each_ref().map(|row| row[lane]);
        while mask != 0 {
            let pixel = mask.trailing_zeros() as usize;
            mask &= mask - 1;
            let [x, y] = [x + pixel % SIDE, y + pixel / SIDE];
            // Rounded as in a block: to its corner, then to the pixel.
            let [column, row] = [x, y].map(|n| (n & !(SIDE - 1)) as f32);
            let [from_column, from_row] = [x, y].map(|n| (n % SIDE) as f32);
            let corner = (group.depth[lane] + right * column) + down * row;
            let z = between(corner + (right * from_column + down * from_row), range);
            let at = number([x, y]) % PIXELS;
            let wins = z > self.depth[at];
            self.depth[at] = if wins { z } else { self.depth[at] };
            self.owner[at] = if wins { owner } else { self.owner[at] };
        }
    }

    /// Draws a triangle. Of equally near ones the first stays: draw in ascending face index.
    #[inline(always)]
    pub(crate) fn draw(&mut self, setup: &Setup, owner: u32) {
        let lanes = BlockLanes::new(setup);
        let [x, y] = [setup.x, setup.y].map(|[first, last]| first as usize / SIDE..=last as usize / SIDE);
        // With more than a few blocks it pays to test blocks first.
        let is_large = (x.end() - x.start()) + (y.end() - y.start()) > 3;
        for row in y {
            for column in x.clone() {
                let corner = [column * SIDE, row * SIDE].map(|n| n as i32);
                let edge: [i32; 3] = std::array::from_fn(|i| {
                    setup.edge[i] + setup.right[i] * corner[0] + setup.down[i] * corner[1]
                });
                if is_large && (0..3).any(|i| edge[i] + lanes.most[i] < 0) {
                    continue;
                }
                let depth = (setup.depth + setup.depth_right * corner[0] as f32)
                    + setup.depth_down * corner[1] as f32;
                let at = (row * BLOCKS + column) * LANES;
                let depths = (&mut self.depth[at..at + LANES]).try_into().expect("a block");
                let owners = (&mut self.owner[at..at + LANES]).try_into().expect("a block");
                lanes.draw(edge, depth, owner, depths, owners);
            }
        }
    }
}

/// A depth between those of the corners; compared so that what overflowed to NaN becomes the low end.
#[inline(always)]
fn between(z: f32, [low, high]: [f32; 2]) -> f32 {
    let z = if z > low { z } else { low };
    if z < high { z } else { high }
}

/// Differences from a block's first pixel to all others, the same for all blocks of a triangle.
struct BlockLanes {
    edge: [[i32; LANES]; 3],
    depth: [f32; LANES],
    depth_range: [f32; 2],
    /// The most that an edge function grows by within a block.
    most: [i32; 3],
}

impl BlockLanes {
    #[inline(always)]
    fn new(setup: &Setup) -> Self {
        let mut lanes =
            Self { edge: [[0; LANES]; 3], depth: [0.0; LANES], depth_range: setup.depth_range, most: [0; 3] };
        let side = SIDE as i32 - 1;
        for i in 0..3 {
            for lane in 0..LANES {
                let (x, y) = ((lane % SIDE) as i32, (lane / SIDE) as i32);
                lanes.edge[i][lane] = setup.right[i] * x + setup.down[i] * y;
            }
            lanes.most[i] = (side * setup.right[i]).max(0) + (side * setup.down[i]).max(0);
        }
        for lane in 0..LANES {
            let (x, y) = ((lane % SIDE) as f32, (lane / SIDE) as f32);
            lanes.depth[lane] = setup.depth_right * x + setup.depth_down * y;
        }
        lanes
    }

    #[inline(always)]
    fn draw(
        &self,
        edge: [i32; 3],
        depth: f32,
        owner: u32,
        depths: &mut [f32; LANES],
        owners: &mut [u32; LANES],
    ) {
        for lane in 0..LANES {
            // Within ±2³¹ by the bound in `Setup`; wrapping only omits the check.
            let side = edge[0].wrapping_add(self.edge[0][lane])
                | edge[1].wrapping_add(self.edge[1][lane])
                | edge[2].wrapping_add(self.edge[2][lane]);
            let z = between(depth + self.depth[lane], self.depth_range);
            let wins = side >= 0 && z > depths[lane];
            depths[lane] = if wins { z } else { depths[lane] };
            owners[lane] = if wins { owner } else { owners[lane] };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::test_numbers::Numbers;
    use crate::raster::coverage::setup::{CornerRows, LARGE, double_area};
    use crate::raster::view::fixed_point::ONE;
    use crate::raster::view::project::ScreenVertex;

    fn random(numbers: &mut Numbers, size: usize) -> [ScreenVertex; 3] {
        let middle = [0; 2].map(|_| numbers.below(64 * 256) as i32);
        [0; 3].map(|_| {
            let [x, y] = middle.map(|m| m + numbers.below(size) as i32 - size as i32 / 2);
            ScreenVertex { x, y, depth: numbers.unit() as f32, outside: 0 }
        })
    }

    #[test]
    fn pixels_are_numbered_once() {
        for pixel in 0..PIXELS {
            assert_eq!(number(place(pixel)), pixel);
        }
        assert_eq!(place(LANES), [4, 0]);
    }

    /// Against one pixel after the other, for triangles from under a pixel to many tiles.
    #[test]
    fn blocks_give_what_pixels_give() {
        let mut numbers = Numbers::new(11);
        let mut visible = Visible::new();
        let mut expected = vec![(f32::NEG_INFINITY, NOTHING); PIXELS];
        for owner in 0..600 {
            let v = random(&mut numbers, [400, 3000, 30_000, 1 << 21][owner % 4]);
            let setup = Setup::new(v, [128, 128]);
            if double_area(&v) == 0.0 || setup.is_empty() {
                continue;
            }
            visible.draw(&setup, owner as u32);
            for (pixel, seen) in expected.iter_mut().enumerate() {
                let [x, y] = place(pixel).map(|n| n as i32);
                let inside = (setup.x[0]..=setup.x[1]).contains(&x)
                    && (setup.y[0]..=setup.y[1]).contains(&y)
                    && (0..3).all(|i| setup.edge[i] + setup.right[i] * x + setup.down[i] * y >= 0);
                let [block, lane] = [|n: i32| n & !3, |n: i32| n & 3].map(|f| [f(x), f(y)].map(|n| n as f32));
                let z = ((setup.depth + setup.depth_right * block[0]) + setup.depth_down * block[1])
                    + (setup.depth_right * lane[0] + setup.depth_down * lane[1]);
                let z = z.clamp(setup.depth_range[0], setup.depth_range[1]);
                if inside && z > seen.0 {
                    *seen = (z, owner as u32);
                }
            }
        }
        let got: Vec<_> = visible.depth.iter().copied().zip(visible.owner.iter().copied()).collect();
        assert!(got == expected);
        let owners: std::collections::BTreeSet<u32> = visible.owner.iter().copied().collect();
        assert!(owners.len() > 20, "the test is too easy: {}", owners.len());
    }

    /// Groups of triangles from under a pixel to several blocks, also across the tile's border.
    #[test]
    fn small_triangles_give_what_blocks_give() {
        let mut numbers = Numbers::new(13);
        let (mut visible, mut expected) = (Visible::new(), Visible::new());
        let (mut corners, mut group, mut masks) = (CornerRows::default(), Setup::default(), [0; GROUP]);
        let mut small = 0;
        for round in 0..400 {
            for lane in 0..GROUP {
                corners.set(lane, &random(&mut numbers, [200, 500, 1000, 2000][(round + lane) % 4]));
            }
            group.prepare(&corners, [128, 128]);
            group.masks(&mut masks);
            for (lane, &mask) in masks.iter().enumerate() {
                let (setup, owner) = (group.get(lane), (round * GROUP + lane) as u32);
                if double_area(&corners.get(lane)) == 0.0 || mask == LARGE {
                    continue;
                }
                small += usize::from(mask != 0);
                visible.draw_small(&group, lane, mask, owner);
                if !setup.is_empty() {
                    expected.draw(&setup, owner);
                }
            }
        }
        assert!(visible.owner == expected.owner && visible.depth == expected.depth);
        assert!(small > 4000, "the test is too easy: {small}");
    }

    #[test]
    fn the_first_of_equals_stays() {
        let mut numbers = Numbers::new(12);
        let mut visible = Visible::new();
        let mut drawn = 0;
        while drawn < 50 {
            let [a, b, c] = random(&mut numbers, 20 * ONE as usize);
            let setup = Setup::new([a, b, c], [128, 128]);
            if double_area(&[a, b, c]) == 0.0 || setup.is_empty() {
                continue;
            }
            visible.clear();
            visible.draw(&setup, 7);
            let first = visible.owner.clone();
            for (owner, v) in [[b, c, a], [c, b, a], [a, c, b]].into_iter().enumerate() {
                visible.draw(&Setup::new(v, [128, 128]), owner as u32 + 8);
            }
            assert!(visible.owner == first);
            drawn += 1;
        }
    }
}
