//! Sorting triangles into tiles.

use crate::num::parallel;
use crate::num::{self, Kernel, Lanes};
use crate::raster::coverage::setup::{CornerRows, Corners, GROUP, TILE, double_area};
use crate::raster::coverage::triangles::DrawnObject;
use crate::raster::settings::Cull;
use crate::raster::view::clip::{ClipVertex, Shares, clip, screen_vertex};
use crate::raster::view::fixed_point::{BITS, first_pixel, last_pixel};
use crate::raster::view::project::{NOT_FINITE, ScreenVertex};
use crate::raster::view::screen_transform::View;

/// Marks a triangle that has to be clipped; the other bits are its number among those of all objects.
pub(crate) const CLIPPED: u32 = 1 << 31;

/// The view and settings that decide where triangles go.
#[derive(Clone, Copy)]
pub(crate) struct Binning<'a> {
    pub(crate) view: &'a View,
    pub(crate) cull: Cull,
    /// Smallest and largest place of a sample within its pixel, in x and in y.
    pub(crate) samples: [[i32; 2]; 2],
}

/// The triangles of each tile, in ascending order; in parts that follow one another.
pub(crate) struct Bins {
    parts: Vec<Part>,
    pub(crate) counts: Counts,
}

impl Bins {
    pub(crate) fn is_empty(&self, tile: usize) -> bool {
        self.parts.iter().all(|part| part.starts[tile] == part.starts[tile + 1])
    }
}

struct Part {
    /// Where each tile's list begins, with the total at the end.
    starts: Vec<u32>,
    triangles: Vec<u32>,
    counts: Counts,
}

#[derive(Clone, Copy, Default)]
pub(crate) struct Counts {
    pub(crate) drawn: u64,
    pub(crate) clipped: u64,
    pub(crate) culled: u64,
}

/// Most triangles of a part: their numbers and tiles fit into the second-level cache.
const PART: usize = 1 << 16;
/// Parts that even a small scene is divided into, so that there is work for all threads.
const PARTS: usize = 16;

pub(crate) fn tiles(size: [u32; 2]) -> [usize; 2] {
    size.map(|pixels| (pixels as usize).div_ceil(TILE))
}

impl Bins {
    pub(crate) fn new(objects: &[DrawnObject], binning: Binning) -> Self {
        let total: usize = objects.iter().map(|object| object.list.len()).sum();
        let length = total.div_ceil(PARTS).clamp(1024, PART);
        let parts = objects
            .iter()
            .flat_map(|object| (0..object.list.len()).step_by(length).map(move |start| (object, start)));
        let parts: Vec<_> = parts.collect();
        let parts = parallel::map_each(&parts, |&(object, start)| {
            let end = (start + length).min(object.list.len());
            Part::new(object, start as u32..end as u32, binning)
        });
        let counts = parts.iter().fold(Counts::default(), |sum, part| Counts {
            drawn: sum.drawn + part.counts.drawn,
            clipped: sum.clipped + part.counts.clipped,
            culled: sum.culled + part.counts.culled,
        });
        Self { parts, counts }
    }

    /// Appends the triangles of a tile, by its number counted along rows.
    pub(crate) fn tile(&self, tile: usize, triangles: &mut Vec<u32>) {
        for part in &self.parts {
            let range = part.starts[tile] as usize..part.starts[tile + 1] as usize;
            triangles.extend_from_slice(&part.triangles[range]);
        }
    }
}

/// The first and last tile that something touches, in x and in y: 256 tiles are the most.
pub(crate) type TileBox = [u8; 4];

impl Part {
    fn new(object: &DrawnObject, range: std::ops::Range<u32>, binning: Binning) -> Self {
        let mut counts = Counts::default();
        let mut found = Vec::with_capacity(range.len());
        num::dispatch(FindTiles { object, range, binning, counts: &mut counts, found: &mut found });
        let (starts, triangles) = sort(&found, tiles(binning.view.size));
        Self { starts, triangles, counts }
    }
}

/// A counting sort by tile, which keeps the order within each.
pub(crate) fn sort(found: &[(u32, TileBox)], [columns, rows]: [usize; 2]) -> (Vec<u32>, Vec<u32>) {
    let mut starts = vec![0_u32; columns * rows + 2];
    // Two ahead: filling advances each start to the next one.
    for &(_, tiles) in found {
        each_tile(tiles, columns, |tile| starts[tile + 2] += 1);
    }
    for tile in 2..starts.len() {
        starts[tile] += starts[tile - 1];
    }
    let mut triangles = vec![0; starts.last().map_or(0, |&last| last as usize)];
    for &(triangle, tiles) in found {
        each_tile(tiles, columns, |tile| {
            triangles[starts[tile + 1] as usize] = triangle;
            starts[tile + 1] += 1;
        });
    }
    starts.pop();
    (starts, triangles)
}

#[inline(always)]
fn each_tile([x0, y0, x1, y1]: TileBox, columns: usize, mut put: impl FnMut(usize)) {
    for y in usize::from(y0)..=usize::from(y1) {
        for x in usize::from(x0)..=usize::from(x1) {
            put(y * columns + x);
        }
    }
}

/// Finds the tiles that triangles touch, a group of triangles at a time.
struct FindTiles<'a> {
    object: &'a DrawnObject<'a>,
    range: std::ops::Range<u32>,
    binning: Binning<'a>,
    counts: &'a mut Counts,
    found: &'a mut Vec<(u32, TileBox)>,
}

impl Kernel for FindTiles<'_> {
    type Output = ();

    #[inline(always)]
    fn run<A: Lanes>(self, arch: A) {
        let Self { object, range, binning, counts, found } = self;
        let mut clipper = Clipper::default();
        let mut corners = Corners::new();
        let mut rows = CornerRows::default();
        let mut outside = [0; GROUP];
        let mut is_drawn = [false; GROUP];
        let mut boxes = [[0; 4]; GROUP];
        let total = range.len() as u64;
        for start in range.clone().step_by(GROUP) {
            let count = (range.end - start).min(GROUP as u32) as usize;
            for lane in 0..count {
                corners.set(lane, object.screen(start + lane as u32));
            }
            rows.load(arch, &corners);
            for lane in 0..GROUP {
                let [a, b, c] = [rows.outside[0][lane], rows.outside[1][lane], rows.outside[2][lane]];
                outside[lane] = if a & b & c == 0 { a | b | c } else { OUT_OF_SIGHT };
                (is_drawn[lane], boxes[lane]) = binning.touched(&rows.get(lane), object.mirrored);
            }
            for lane in 0..count {
                let triangle = start + lane as u32;
                if outside[lane] == 0 {
                    if is_drawn[lane] {
                        found.push((object.first + triangle, boxes[lane]));
                    }
                } else if outside[lane] != OUT_OF_SIGHT {
                    let pieces = clipper.pieces(object, triangle, binning.view);
                    let touched =
                        pieces.iter().map(|piece| binning.touched(&piece.vertices, object.mirrored));
                    let boxes = touched.filter(|(is_drawn, _)| *is_drawn).map(|(_, tiles)| tiles);
                    if let Some(tiles) = boxes.reduce(join) {
                        counts.clipped += 1;
                        found.push((CLIPPED | (object.first + triangle), tiles));
                    }
                }
            }
        }
        counts.drawn = found.len() as u64;
        counts.culled = total - counts.drawn;
    }
}

/// Marks a triangle whose corners are all on the outer side of one clipping plane.
const OUT_OF_SIGHT: u32 = u32::MAX;

fn join(a: TileBox, b: TileBox) -> TileBox {
    [a[0].min(b[0]), a[1].min(b[1]), a[2].max(b[2]), a[3].max(b[3])]
}

impl Binning<'_> {
    /// Whether a triangle is to be drawn, and the tiles that the box around it touches. Without a branch.
    #[inline(always)]
    fn touched(&self, v: &[ScreenVertex; 3], mirrored: bool) -> (bool, TileBox) {
        let area = double_area(v);
        // Counter-clockwise in the scene is clockwise with y down, where the area is negative.
        let is_front = (area < 0.0) != mirrored;
        let is_kept = self.cull.keeps(is_front);
        let pixels = |a: i32, b: i32, c: i32, axis: usize| {
            let [low, high] = self.samples[axis];
            let first = first_pixel(a.min(b).min(c), high).max(0);
            let last = last_pixel(a.max(b).max(c), low).min(self.view.size[axis] as i32 - 1);
            [first, last]
        };
        let [x0, x1] = pixels(v[0].x, v[1].x, v[2].x, 0);
        let [y0, y1] = pixels(v[0].y, v[1].y, v[2].y, 1);
        let is_drawn = is_kept & (area != 0.0) & (x0 <= x1) & (y0 <= y1);
        (is_drawn, [x0, y0, x1, y1].map(|pixel| (pixel / TILE as i32) as u8))
    }
}

/// Part of a clipped triangle: a triangle itself.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece {
    pub(crate) vertices: [ScreenVertex; 3],
    /// The nearness of its corners, in perspective.
    pub(crate) nearness: [f32; 3],
    /// The shares of the whole triangle's corners in each of its corners.
    pub(crate) shares: [Shares; 3],
}

/// Clips triangles; reuses its memory.
#[derive(Default)]
pub(crate) struct Clipper {
    polygon: Vec<ClipVertex<Shares>>,
    spare: Vec<ClipVertex<Shares>>,
    pieces: Vec<Piece>,
}

impl Clipper {
    /// The visible part of a triangle, as a fan.
    pub(crate) fn pieces(&mut self, object: &DrawnObject, triangle: u32, view: &View) -> &[Piece] {
        self.pieces.clear();
        let vertices = object.list.vertices(triangle);
        let screen = object.screen(triangle);
        let planes = screen.iter().fold(0, |planes, v| planes | v.outside);
        if planes & NOT_FINITE != 0 {
            return &[];
        }
        self.polygon.clear();
        self.polygon.extend(vertices.iter().enumerate().map(|(k, &vertex)| ClipVertex {
            point: object.map.view(object.points.at(vertex)),
            attribute: Shares::of_corner(k),
        }));
        clip(view, planes, &mut self.polygon, &mut self.spare);
        if let Some((first, rest)) = self.polygon.split_first() {
            for pair in rest.windows(2) {
                let corners = [first, &pair[0], &pair[1]];
                let vertices = corners.map(|corner| screen_vertex(view, corner.point));
                if double_area(&vertices) != 0.0 {
                    let nearness = corners.map(|corner| view.nearness(corner.point.z) as f32);
                    self.pieces.push(Piece { vertices, nearness, shares: corners.map(|c| c.attribute) });
                }
            }
        }
        &self.pieces
    }
}

/// The sample of the upper left pixel of a tile, in 256ths of a pixel of the picture.
pub(crate) fn tile_origin(tile: [usize; 2], sample: [i32; 2]) -> [i32; 2] {
    [0, 1].map(|axis| (((tile[axis] * TILE) as i32) << BITS) + sample[axis])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::test_numbers::Numbers;

    #[test]
    fn sorting_keeps_order_within_a_tile() {
        let mut numbers = Numbers::new(5);
        let size = [7, 5];
        let found: Vec<(u32, TileBox)> = (0..500)
            .map(|triangle| {
                let [x, y] = size.map(|n| numbers.below(n));
                let [x1, y1] =
                    [(x, size[0]), (y, size[1])].map(|(from, end)| from + numbers.below(end - from));
                (triangle, [x, y, x1, y1].map(|n| n as u8))
            })
            .collect();
        let (starts, triangles) = sort(&found, size);
        for tile in 0..35 {
            let [x, y] = [tile % 7, tile / 7].map(|n| n as u8);
            let inside = |b: &TileBox| (b[0]..=b[2]).contains(&x) && (b[1]..=b[3]).contains(&y);
            let expected: Vec<u32> = found.iter().filter(|(_, b)| inside(b)).map(|&(t, _)| t).collect();
            assert_eq!(triangles[starts[tile] as usize..starts[tile + 1] as usize], expected);
        }
    }
}
