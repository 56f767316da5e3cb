//! One tile: visibility, colours, lines.

use crate::num;
use crate::raster::coverage::records::Record;
use crate::raster::coverage::setup::{TILE, depth_plane, double_area};
use crate::raster::coverage::shown::{Block, Shown};
use crate::raster::coverage::tile_bins::{Bins, tile_origin, tiles};
use crate::raster::coverage::tile_list::{DrawTriangles, Owner, Run, TileList};
use crate::raster::coverage::visible_triangle::{Colours, NOTHING, PIXELS, Visible, number, place};
use crate::raster::error::Result;
use crate::raster::frame::job::Job;
use crate::raster::lines::{LineJob, LineSet, Segment};
use crate::raster::picture::with_sample;
use crate::raster::settings::{Shading, Show};
use crate::raster::shading::ray_cast::{Hits, cast};
use crate::raster::shading::shade_samples::{Painter, Tile};
use crate::raster::traced::camera_rays::{TileTracer, first_hit};
use crate::raster::traced::world::TracedScene;
use crate::raster::view::fixed_point::ONE;

/// Works on one tile after the other and keeps its memory in between.
pub(crate) struct Worker {
    list: TileList,
    visible: Visible,
    hits: Option<Hits>,
    pub(crate) tracer: TileTracer,
    shown: Shown,
    records: Vec<Record>,
    runs: Vec<Run>,
    /// The blocks that show the object in hand.
    blocks: Vec<Block>,
    painter: Painter,
    /// Colours of the samples in hand.
    colour: Colours,
    /// Sums over the samples done.
    sum: Colours,
    covered: Box<[u8; PIXELS]>,
    edged: Box<[bool; PIXELS]>,
    objects: Box<[u32; PIXELS]>,
}

/// Whether faces hide edges, but are not shown themselves.
fn shows_edges_alone(job: &Job) -> bool {
    job.settings.shading == Shading::Wireframe && job.settings.show == Show::Shaded
}

fn colours() -> Colours {
    [(); 3].map(|()| Box::new([0.0; PIXELS]))
}

/// Whether a depth is behind a surface that a ray meets at a distance along the axis.
fn is_behind(job: &Job, surface: Option<f64>, depth: f64) -> bool {
    /// How far behind the true surface, as a share of the distance, a mesh's edges may lie and still show.
    const CHORD: f64 = 1e-3;
    surface.is_some_and(|z| job.view.depth(z + CHORD * z.min(job.view.reach)) > depth)
}

pub(crate) struct Finished<'a> {
    pub(crate) colours: &'a Colours,
    pub(crate) covered: &'a [u8; PIXELS],
    /// The pixels that show a wireframe's edge; `None` where faces are shown.
    pub(crate) edged: Option<&'a [bool; PIXELS]>,
    /// See [`Image::objects`](crate::raster::Image::objects).
    pub(crate) objects: &'a [u32; PIXELS],
}

impl Worker {
    pub(crate) fn new() -> Self {
        Self {
            list: TileList::default(),
            visible: Visible::new(),
            hits: None,
            tracer: TileTracer::default(),
            shown: Shown::new(),
            records: Vec::new(),
            runs: Vec::new(),
            blocks: Vec::new(),
            painter: Painter::new(),
            colour: colours(),
            sum: colours(),
            covered: Box::new([0; PIXELS]),
            edged: Box::new([false; PIXELS]),
            objects: Box::new([0; PIXELS]),
        }
    }

    /// Draws a tile; `None` if there is nothing but background.
    pub(crate) fn draw(
        &mut self,
        job: &Job,
        bins: &Bins,
        lines: &LineJob,
        tile: [usize; 2],
    ) -> Result<Option<Finished<'_>>> {
        let number = tile[1] * tiles(job.view.size)[0] + tile[0];
        let is_traced = job.traced.is_some();
        if !is_traced
            && bins.is_empty(number)
            && lines.is_empty(number)
            && job.cast_objects().next().is_none()
        {
            return Ok(None);
        }
        let count = job.settings.samples.count();
        self.list.fill(job, bins, tile);
        self.covered.fill(0);
        self.edged.fill(false);
        if job.settings.keep_objects {
            self.objects.fill(0);
        }
        for (number, sample) in job.settings.samples.offsets().enumerate() {
            let origin = tile_origin(tile, sample);
            match &job.traced {
                Some(scene) => self.trace(job, scene, origin)?,
                None => {
                    self.find_visible(job, origin);
                    self.collect(job, tile);
                    if job.settings.keep_objects {
                        self.number_objects();
                    }
                    self.paint(job, origin)?;
                }
            }
            self.draw_lines(job, lines, tile, sample);
            if count == 1 {
                return Ok(Some(self.finished(job, &self.colour)));
            }
            for (sum, colour) in self.sum.iter_mut().zip(&self.colour) {
                if number == 0 {
                    sum.fill(0.0);
                }
                sum.iter_mut().zip(colour.iter()).for_each(|(sum, &colour)| *sum += colour);
            }
        }
        let share = 1.0 / count as f32;
        self.sum.iter_mut().flat_map(|sum| sum.iter_mut()).for_each(|sum| *sum *= share);
        Ok(Some(self.finished(job, &self.sum)))
    }

    /// Traces the samples of a tile, over the background.
    fn trace(&mut self, job: &Job, scene: &TracedScene, origin: [i32; 2]) -> Result<()> {
        for (row, background) in self.colour.iter_mut().zip(job.background) {
            row.fill(background);
        }
        let Self { tracer, colour, covered, objects, .. } = self;
        if job.settings.keep_objects {
            objects.iter_mut().for_each(|number| *number = with_sample(*number, None));
        }
        tracer.trace(job, scene, origin, |pixel, object, found| {
            covered[pixel] += 1;
            for (row, component) in colour.iter_mut().zip(found.to_array()) {
                row[pixel] = component;
            }
            if job.settings.keep_objects {
                // In place of the background.
                objects[pixel] = objects[pixel].wrapping_add(object as u32 + 1);
            }
        })
    }

    fn finished<'a>(&'a self, job: &Job, colours: &'a Colours) -> Finished<'a> {
        let edged = shows_edges_alone(job).then_some(&*self.edged);
        Finished { colours, covered: &self.covered, edged, objects: &self.objects }
    }

    /// The record that is visible at a sample of a pixel.
    pub(crate) fn visible_record(
        &mut self,
        job: &Job,
        bins: &Bins,
        pixel: [u32; 2],
        sample: [i32; 2],
    ) -> Option<Record> {
        let tile = pixel.map(|n| n as usize / TILE);
        self.list.fill(job, bins, tile);
        self.find_visible(job, tile_origin(tile, sample));
        let owner = self.visible.owner[number(pixel.map(|n| n as usize % TILE))];
        (owner != NOTHING).then(|| self.list.record(job, owner))
    }

    fn find_visible(&mut self, job: &Job, origin: [i32; 2]) {
        let Self { visible, list, hits, .. } = self;
        visible.clear();
        num::dispatch(DrawTriangles { job, list, origin, visible });
        for (at, &object) in list.casts.iter().enumerate() {
            let hits = hits.get_or_insert_with(Hits::new);
            hits.cast(job, object, (list.first_cast() + at) as u32, origin, visible);
        }
    }

    /// Finds out what each sample shows, and makes a record of each visible triangle.
    fn collect(&mut self, job: &Job, tile: [usize; 2]) {
        self.hide_outside(job, tile);
        let Self { visible, shown, list, records, runs, .. } = self;
        for (covered, &owner) in self.covered.iter_mut().zip(visible.owner.iter()) {
            *covered += u8::from(owner != NOTHING);
        }
        shown.number(&visible.owner, list.len());
        list.records(job, &shown.owners, records, runs);
    }

    /// Adds the visible object of each pixel's sample to the pixel's number.
    fn number_objects(&mut self) {
        for (number, &record) in self.objects.iter_mut().zip(self.shown.records.iter()) {
            let record = self.records.get(record as usize);
            *number = with_sample(*number, record.map(|record| record.object));
        }
    }

    /// Removes pixels beyond the picture's right and lower border.
    fn hide_outside(&mut self, job: &Job, tile: [usize; 2]) {
        let room = [0, 1].map(|axis| job.view.size[axis] as usize - tile[axis] * TILE);
        if room.iter().all(|&room| room >= TILE) {
            return;
        }
        for (pixel, owner) in self.visible.owner.iter_mut().enumerate() {
            let [x, y] = place(pixel);
            if x >= room[0] || y >= room[1] {
                *owner = NOTHING;
            }
        }
    }

    fn paint(&mut self, job: &Job, origin: [i32; 2]) -> Result<()> {
        for (row, background) in self.colour.iter_mut().zip(job.background) {
            row.fill(background);
        }
        if shows_edges_alone(job) {
            return Ok(());
        }
        for run in &self.runs {
            self.painter.prepare(job, run, &self.list, &self.shown.owners, &mut self.records)?;
            self.shown.blocks(run.records.clone(), &mut self.blocks);
            let tile = Tile {
                blocks: &self.blocks,
                shown: &self.shown.records,
                records: &self.records,
                depth: &self.visible.depth,
                hits: self.hits.as_ref(),
                origin,
            };
            self.painter.paint(job, run.object, &tile, &mut self.colour)?;
        }
        Ok(())
    }

    fn draw_lines(&mut self, job: &Job, lines: &LineJob, tile: [usize; 2], sample: [i32; 2]) {
        let columns = tiles(job.view.size)[0];
        let corner = tile.map(|n| (n * TILE) as f64);
        let offset = sample.map(|n| f64::from(n) / f64::from(ONE));
        for (set, segment) in lines.tile(job, tile[1] * columns + tile[0]) {
            for row in 0..TILE {
                let y = corner[1] + row as f64 + offset[1];
                let Some([low, high]) = segment.columns(y, set.radius, offset[0]) else { continue };
                // Pixels of the tile from the first one not left of the line to the last one not right of it.
                let first = (low - corner[0]).ceil().max(0.0) as usize;
                let end = (high - corner[0]).floor().min(TILE as f64 - 1.0);
                for column in (first..TILE).take_while(|&column| column as f64 <= end) {
                    self.draw_line(
                        job,
                        set,
                        &segment,
                        [column, row],
                        [corner[0] + column as f64 + offset[0], y],
                    );
                }
            }
        }
    }

    fn draw_line(&mut self, job: &Job, set: &LineSet, segment: &Segment, pixel: [usize; 2], at: [f64; 2]) {
        let Some((place, depth)) = segment.nearest(at, set.radius) else { return };
        let pixel = number(pixel);
        let is_hidden = || match &job.traced {
            Some(scene) => is_behind(job, first_hit(job, scene, place).map(|(.., z)| z), depth),
            None => self.hides(job, self.visible.owner[pixel], place, depth),
        };
        if set.hide && is_hidden() {
            return;
        }
        for (row, component) in self.colour.iter_mut().zip(set.colour.to_array()) {
            row[pixel] = component;
        }
        self.edged[pixel] |= set.is_wireframe;
    }

    /// Whether the visible surface at a sample is in front of a line. It is evaluated at the line's own place, with room for the
    /// snapping of corners, so that it does not hide lines in it.
    fn hides(&self, job: &Job, owner: u32, place: [f64; 2], depth: f64) -> bool {
        /// Pixels that a corner may be off by snapping, with some room.
        const SNAPPED: f64 = 1.0 / 64.0;
        /// Roundings of single-precision depths.
        const ROUNDED: f64 = 1e-6;
        if owner == NOTHING {
            return false;
        }
        let v = match self.list.look_up(job, owner) {
            Owner::Triangle { corners, .. } => corners,
            Owner::Cast(object) => {
                return is_behind(job, cast(job, object, place).map(|(_, z)| z), depth);
            }
        };
        let at = place.map(crate::raster::view::fixed_point::snap);
        let [surface, right, down] = depth_plane(&v, double_area(&v), at).map(f64::from);
        let room = (right.abs() + down.abs()) * SNAPPED + surface.abs() * ROUNDED;
        depth < surface - room
    }
}
