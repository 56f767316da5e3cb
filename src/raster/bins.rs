//! Sorting triangles into tiles.

use super::clip::{ClipVertex, Shares, clip, screen_vertex};
use super::fixed::{BITS, first_pixel, last_pixel};
use super::project::{NOT_FINITE, ScreenVertex};
use super::settings::Cull;
use super::setup::{TILE, double_area};
use super::triangles::DrawnObject;
use super::view::View;
use rayon::prelude::*;

/// Marks a triangle that has to be clipped before it is drawn; the other bits are its number, all objects counted
/// through.
pub(super) const CLIPPED: u32 = 1 << 31;

/// What decides where triangles go.
#[derive(Clone, Copy)]
pub(super) struct Binning<'a> {
    pub(super) view: &'a View,
    pub(super) cull: Cull,
    /// Smallest and largest place of a sample within its pixel, in x and in y.
    pub(super) samples: [[i32; 2]; 2],
}

/// The triangles of each tile, in ascending order; in parts that follow one another.
pub(super) struct Bins {
    parts: Vec<Part>,
    pub(super) counts: Counts,
}

/// The triangles of some tiles' lists.
struct Part {
    /// Where each tile's list begins, with the total at the end.
    starts: Vec<u32>,
    triangles: Vec<u32>,
    counts: Counts,
}

/// How many triangles met which fate.
#[derive(Clone, Copy, Default)]
pub(super) struct Counts {
    pub(super) drawn: u64,
    pub(super) clipped: u64,
    pub(super) culled: u64,
}

/// Most triangles of a part: their numbers and tiles stay in the second-level cache while they are counted and sorted.
const PART: usize = 1 << 16;
/// Parts that even a small scene is divided into, so that there is work for all threads.
const PARTS: usize = 16;

/// The number of tiles in x and in y.
pub(super) fn tiles(size: [u32; 2]) -> [usize; 2] {
    size.map(|pixels| (pixels as usize).div_ceil(TILE))
}

impl Bins {
    /// Sorts the triangles of all objects.
    pub(super) fn new(objects: &[DrawnObject], binning: Binning) -> Self {
        let total: usize = objects.iter().map(|object| object.list.len()).sum();
        let length = total.div_ceil(PARTS).clamp(1024, PART);
        let parts = objects
            .iter()
            .flat_map(|object| (0..object.list.len()).step_by(length).map(move |start| (object, start)));
        let parts: Vec<_> = parts.collect();
        let parts: Vec<Part> = parts
            .into_par_iter()
            .map(|(object, start)| {
                let end = (start + length).min(object.list.len());
                Part::new(object, start as u32..end as u32, binning)
            })
            .collect();
        let counts = parts.iter().fold(Counts::default(), |sum, part| Counts {
            drawn: sum.drawn + part.counts.drawn,
            clipped: sum.clipped + part.counts.clipped,
            culled: sum.culled + part.counts.culled,
        });
        Self { parts, counts }
    }

    /// Appends the triangles of a tile, by its number counted along rows.
    pub(super) fn tile(&self, tile: usize, triangles: &mut Vec<u32>) {
        for part in &self.parts {
            let range = part.starts[tile] as usize..part.starts[tile + 1] as usize;
            triangles.extend_from_slice(&part.triangles[range]);
        }
    }
}

/// The first and last tile that something touches, in x and in y: 256 tiles are the most.
pub(super) type TileBox = [u8; 4];

impl Part {
    fn new(object: &DrawnObject, range: std::ops::Range<u32>, binning: Binning) -> Self {
        let mut counts = Counts::default();
        let mut found: Vec<(u32, TileBox)> = Vec::new();
        let mut clipper = Clipper::default();
        for triangle in range {
            let v = object.screen(triangle);
            if v[0].outside & v[1].outside & v[2].outside != 0 {
                counts.culled += 1;
                continue;
            }
            let mut mark = 0;
            let touched = if v[0].outside | v[1].outside | v[2].outside == 0 {
                binning.touched(&v, object.mirrored)
            } else {
                mark = CLIPPED;
                let pieces = clipper.pieces(object, triangle, binning.view);
                let boxes =
                    pieces.iter().filter_map(|piece| binning.touched(&piece.vertices, object.mirrored));
                boxes.reduce(|a, b| [a[0].min(b[0]), a[1].min(b[1]), a[2].max(b[2]), a[3].max(b[3])])
            };
            match touched {
                None => counts.culled += 1,
                Some(tiles) => {
                    counts.drawn += 1;
                    counts.clipped += u64::from(mark != 0);
                    found.push((mark | (object.first + triangle), tiles));
                }
            }
        }
        let (starts, triangles) = sort(&found, tiles(binning.view.size));
        Self { starts, triangles, counts }
    }
}

/// A counting sort by tile, which keeps the order within each.
pub(super) fn sort(found: &[(u32, TileBox)], [columns, rows]: [usize; 2]) -> (Vec<u32>, Vec<u32>) {
    let each = |[x0, y0, x1, y1]: TileBox, put: &mut dyn FnMut(usize)| {
        for y in y0..=y1 {
            for x in x0..=x1 {
                put(usize::from(y) * columns + usize::from(x));
            }
        }
    };
    let mut starts = vec![0_u32; columns * rows + 2];
    // Two ahead: filling advances each start to the next one's place.
    for &(_, tiles) in found {
        each(tiles, &mut |tile| starts[tile + 2] += 1);
    }
    for tile in 2..starts.len() {
        starts[tile] += starts[tile - 1];
    }
    let mut triangles = vec![0; starts.last().map_or(0, |&last| last as usize)];
    for &(triangle, tiles) in found {
        each(tiles, &mut |tile| {
            triangles[starts[tile + 1] as usize] = triangle;
            starts[tile + 1] += 1;
        });
    }
    starts.pop();
    (starts, triangles)
}

impl Binning<'_> {
    /// The tiles that the box around a triangle touches, if it is to be drawn at all.
    #[inline(always)]
    fn touched(&self, v: &[ScreenVertex; 3], mirrored: bool) -> Option<TileBox> {
        let area = double_area(v);
        // Counter-clockwise in the scene is clockwise with y down, where the area is negative.
        let is_front = (area < 0) != mirrored;
        let is_culled = match self.cull {
            Cull::None => false,
            Cull::Back => !is_front,
            Cull::Front => is_front,
        };
        if area == 0 || is_culled {
            return None;
        }
        let pixels = |a: i32, b: i32, c: i32, axis: usize| {
            let [low, high] = self.samples[axis];
            let first = first_pixel(a.min(b).min(c), high).max(0);
            let last = last_pixel(a.max(b).max(c), low).min(self.view.size[axis] as i32 - 1);
            (first <= last).then_some([first, last].map(|pixel| (pixel / TILE as i32) as u8))
        };
        let [x0, x1] = pixels(v[0].x, v[1].x, v[2].x, 0)?;
        let [y0, y1] = pixels(v[0].y, v[1].y, v[2].y, 1)?;
        Some([x0, y0, x1, y1])
    }
}

/// Part of a clipped triangle: a triangle itself.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    pub(super) vertices: [ScreenVertex; 3],
    /// What each of its corners has of the corners of the whole.
    pub(super) shares: [Shares; 3],
}

/// Clips triangles; keeps its memory.
#[derive(Default)]
pub(super) struct Clipper {
    polygon: Vec<ClipVertex<Shares>>,
    spare: Vec<ClipVertex<Shares>>,
    pieces: Vec<Piece>,
}

impl Clipper {
    /// What is left of a triangle, as a fan.
    pub(super) fn pieces(&mut self, object: &DrawnObject, triangle: u32, view: &View) -> &[Piece] {
        self.pieces.clear();
        let vertices = object.list.vertices(triangle);
        let screen = object.screen(triangle);
        let planes = screen.iter().fold(0, |planes, v| planes | v.outside);
        if planes & NOT_FINITE != 0 {
            return &[];
        }
        self.polygon.clear();
        self.polygon.extend(vertices.iter().enumerate().map(|(k, &vertex)| ClipVertex {
            point: object.map.view(object.points.get(vertex)),
            attribute: Shares::of_corner(k),
        }));
        clip(view, planes, &mut self.polygon, &mut self.spare);
        let corner = |vertex: &ClipVertex<Shares>| (screen_vertex(view, vertex.point), vertex.attribute);
        if let Some((first, rest)) = self.polygon.split_first() {
            let a = corner(first);
            for pair in rest.windows(2) {
                let [b, c] = [0, 1].map(|k| corner(&pair[k]));
                let vertices = [a.0, b.0, c.0];
                if double_area(&vertices) != 0 {
                    self.pieces.push(Piece { vertices, shares: [a.1, b.1, c.1] });
                }
            }
        }
        &self.pieces
    }
}

/// The sample of the upper left pixel of a tile, in 256ths of a pixel of the picture.
pub(super) fn tile_origin(tile: [usize; 2], sample: [i32; 2]) -> [i32; 2] {
    [0, 1].map(|axis| (((tile[axis] * TILE) as i32) << BITS) + sample[axis])
}
