//! Straight lines with a width, on top of what is seen or hidden by it.

use crate::raster::coverage::setup::TILE;
use crate::raster::coverage::tile_bins::{TileBox, sort, tiles};
use crate::raster::error::RenderError;
use crate::raster::frame::job::Job;
use crate::raster::lines::segments::LineEnds;
use crate::raster::scene::Scene;
use crate::raster::settings::{LineStyle, Shading};
use crate::raster::view::clip::clip_line;
use crate::raster::view::screen_transform::ObjectMap;
use glam::Vec3;
use rayon::prelude::*;

/// All lines of a picture.
pub(crate) struct LineJob<'a> {
    sets: Vec<LineSet<'a>>,
    /// Where each tile's lines begin, with the total at the end; and the lines, as a set and a number in it.
    parts: Vec<(usize, Vec<u32>, Vec<u32>)>,
}

/// Lines that look alike.
pub(crate) struct LineSet<'a> {
    ends: LineEnds<'a>,
    /// From the space of the ends to view space.
    map: ObjectMap,
    pub(crate) colour: Vec3,
    pub(crate) radius: f64,
    pub(crate) hide: bool,
    /// Whether these are the edges of an object under [`Shading::Wireframe`], and not lines laid over it.
    pub(crate) is_wireframe: bool,
}

/// A line on the picture.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Segment {
    /// Its ends, in pixels.
    pub(crate) ends: [[f64; 2]; 2],
    /// Depth there, which is linear in between.
    pub(crate) depth: [f64; 2],
}

impl<'a> LineJob<'a> {
    pub(crate) fn new(job: &Job<'a>, scene: &'a Scene<'a>) -> Result<Self, RenderError> {
        let mut sets = Vec::new();
        if job.settings.shading == Shading::Wireframe {
            check_style(&job.settings.wire)?;
            let cull = job.settings.cull;
            let edges =
                job.drawn.iter().map(|drawn| LineEnds::edges(&scene.objects[drawn.object], drawn, cull));
            sets.extend(edges.map(|ends| LineSet::new(job, ends, &job.settings.wire, true)));
        }
        for (number, lines) in scene.lines.iter().enumerate() {
            check_style(&lines.style)?;
            sets.push(LineSet::new(job, LineEnds::new(scene, number, &lines.path)?, &lines.style, false));
        }
        let parts = sets.par_iter().enumerate().map(|(number, set)| {
            let found: Vec<_> = (0..set.ends.len())
                .filter_map(|line| Some((line, set.touched(job, set.segment(job, line)?)?)))
                .collect();
            let (starts, lines) = sort(&found, tiles(job.view.size));
            (number, starts, lines)
        });
        Ok(Self { parts: parts.collect(), sets })
    }

    /// Whether a tile has no line.
    pub(crate) fn is_empty(&self, tile: usize) -> bool {
        self.parts.iter().all(|(_, starts, _)| starts[tile] == starts[tile + 1])
    }

    /// The lines of a tile.
    pub(crate) fn tile(&self, job: &Job, tile: usize) -> impl Iterator<Item = (&LineSet<'a>, Segment)> {
        self.parts.iter().flat_map(move |(number, starts, lines)| {
            let set = &self.sets[*number];
            let range = starts[tile] as usize..starts[tile + 1] as usize;
            lines[range].iter().filter_map(move |&line| Some((set, set.segment(job, line)?)))
        })
    }
}

fn check_style(style: &LineStyle) -> Result<(), RenderError> {
    let number = |what, found: String, expected| Err(RenderError::Number { what, found, expected });
    if !(style.width.is_finite() && style.width > 0.0) {
        return number("the width of lines", style.width.to_string(), "above 0 and finite");
    }
    if !style.colour.is_finite() {
        return number("the colour of lines", format!("{:?}", style.colour.to_array()), "finite");
    }
    Ok(())
}

impl<'a> LineSet<'a> {
    fn new(job: &Job, ends: LineEnds<'a>, style: &LineStyle, is_wireframe: bool) -> Self {
        let (transform, first) = ends.space();
        let map = ObjectMap::about(&job.view, transform, first);
        let colour = crate::raster::coverage::records::single(style.colour);
        Self { ends, map, colour, radius: 0.5 * style.width, hide: style.hide, is_wireframe }
    }

    /// A line on the picture, clipped to the near plane and the guard band; `None` if nothing is left.
    fn segment(&self, job: &Job, line: u32) -> Option<Segment> {
        let ends = clip_line(&job.view, self.ends.get(line)?.map(|end| self.map.view(end)))?;
        Some(Segment {
            ends: ends.map(|end| job.view.on_picture(end)),
            depth: ends.map(|end| job.view.depth(end.z)),
        })
    }

    /// The tiles that the box around a line touches.
    fn touched(&self, job: &Job, segment: Segment) -> Option<TileBox> {
        let [a, b] = segment.ends;
        let tiles = |axis: usize| {
            let last = f64::from(job.view.size[axis]) - 1.0;
            let first = (a[axis].min(b[axis]) - self.radius - 1.0).max(0.0);
            let end = (a[axis].max(b[axis]) + self.radius).min(last);
            (first <= end).then_some([first, end].map(|pixel| (pixel as usize / TILE) as u8))
        };
        let ([x0, x1], [y0, y1]) = (tiles(0)?, tiles(1)?);
        Some([x0, y0, x1, y1])
    }
}

impl Segment {
    /// The place of the line nearest to a point of the picture and the depth there, if it is within the radius.
    pub(crate) fn nearest(&self, [x, y]: [f64; 2], radius: f64) -> Option<([f64; 2], f64)> {
        let [a, b] = self.ends;
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let squared = dx * dx + dy * dy;
        let t = if squared > 0.0 { ((x - a[0]) * dx + (y - a[1]) * dy) / squared } else { 0.0 };
        let t = t.clamp(0.0, 1.0);
        let place = [a[0] + dx * t, a[1] + dy * t];
        let (ex, ey) = (place[0] - x, place[1] - y);
        let depth = self.depth[0] + (self.depth[1] - self.depth[0]) * t;
        (ex * ex + ey * ey <= radius * radius).then_some((place, depth))
    }

    /// The pixels of a row that the line may touch, given the height of the row's samples and how far into a pixel
    /// they are.
    pub(crate) fn columns(&self, y: f64, radius: f64, offset: f64) -> Option<[f64; 2]> {
        let [a, b] = self.ends;
        if y < a[1].min(b[1]) - radius || y > a[1].max(b[1]) + radius {
            return None;
        }
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let (low, high) = (a[0].min(b[0]) - radius, a[0].max(b[0]) + radius);
        // Between the two lines beside it, or round an end.
        let (middle, half) = (a[0] + (y - a[1]) * (dx / dy), radius * (dx / dy).abs() + 2.0 * radius);
        let [low, high] =
            if middle.is_finite() { [low.max(middle - half), high.min(middle + half)] } else { [low, high] };
        (low <= high).then_some([low - offset, high - offset])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::test_numbers::Numbers;
    use crate::raster::view::screen_transform::View;
    use glam::{DMat4, DVec3};

    /// The columns that are looked at hold every pixel that the line touches.
    #[test]
    fn no_touched_pixel_is_left_out() {
        let mut numbers = Numbers::new(9);
        let mut touched = 0;
        for round in 0..2000 {
            let mut place = || [0; 2].map(|_| numbers.unit() * 80.0 - 10.0);
            let (a, mut b) = (place(), place());
            match round % 8 {
                0 => b[1] = a[1],
                1 => b[0] = a[0],
                2 => b = a,
                _ => {}
            }
            let segment = Segment { ends: [a, b], depth: [1.0, 0.5] };
            let radius = [0.3, 0.5, 1.0, 4.0][round % 4];
            for row in 0..64 {
                let y = f64::from(row) + 0.5;
                let columns = segment.columns(y, radius, 0.5);
                for column in 0..64 {
                    let Some((nearest, depth)) = segment.nearest([f64::from(column) + 0.5, y], radius) else {
                        continue;
                    };
                    touched += 1;
                    let [low, high] = columns.expect("a row that is touched");
                    assert!(
                        f64::from(column) >= low && f64::from(column) <= high,
                        "{segment:?} {column} {row}"
                    );
                    // Within the ends, but for the rounding of a place of at most 80 pixels.
                    let (left, right) = (a[0].min(b[0]) - 1e-13, a[0].max(b[0]) + 1e-13);
                    assert!((0.5..=1.0).contains(&depth) && (left..=right).contains(&nearest[0]));
                }
            }
        }
        assert!(touched > 50_000, "{touched}");
    }

    #[test]
    fn lines_are_cut_where_they_leave() {
        let camera = crate::raster::view::camera::Camera {
            eye: DVec3::ZERO,
            target: DVec3::NEG_Z,
            up: DVec3::Y,
            projection: crate::raster::view::camera::Projection::Perspective(crate::num::Radians(1.0)),
            near: 0.5,
        };
        let view = View::new(&camera, [100, 100]).unwrap();
        let map = ObjectMap::new(&view, DMat4::IDENTITY, DVec3::ZERO);
        let cut = |a: DVec3, b: DVec3| clip_line(&view, [map.view(a), map.view(b)]);
        let [a, b] = cut(DVec3::new(0.0, 0.0, 3.0), DVec3::new(0.0, 0.0, -3.0)).unwrap();
        assert!((a.z - 0.5).abs() < 1e-15 && b.z == 3.0);
        let [a, b] = cut(DVec3::new(-1e30, 0.0, -1.0), DVec3::new(1e30, 0.0, -1.0)).unwrap();
        let guard = f64::from(crate::raster::view::fixed_point::GUARD);
        assert!((a.x + guard).abs() < 1e-3 * guard && (b.x - guard).abs() < 1e-3 * guard, "{a:?} {b:?}");
        assert_eq!(cut(DVec3::new(-1.0, 0.0, 1.0), DVec3::new(2.0, 0.0, 1.0)), None);
        assert_eq!(cut(DVec3::new(-1e6, 0.0, -1.0), DVec3::new(-2e6, 1.0, -1.0)), None);
    }
}
