//! One tile: what is seen, its colours, its lines.

use super::bins::{Bins, CLIPPED, Clipper, Piece, tile_origin, tiles};
use super::cast::{Hits, cast};
use super::coverage::{LANES, NOTHING, PIXELS, Visible, number, place};
use super::error::RenderError;
use super::fixed::ONE;
use super::interpolate::Seen;
use super::job::Job;
use super::lines::{LineJob, LineSet, Segment};
use super::paint::Painter;
use super::project::ScreenVertex;
use super::records::{Record, piece_values};
use super::settings::{Shading, Show};
use super::setup::{CornerRows, GROUP, Setup, TILE, depth_plane, double_area};
use crate::num::{self, Kernel, Product};
use glam::Vec3;

/// Works on one tile after the other and keeps its memory in between.
pub(super) struct Worker {
    visible: Visible,
    /// The tile's triangles as the bins have them.
    triangles: Vec<u32>,
    /// Pieces of those that are clipped, each with its triangle's place in the list.
    pieces: Vec<(u32, Piece)>,
    clipper: Clipper,
    /// The record of each triangle and piece that is seen, [`NOTHING`] for others.
    record_of: Vec<u32>,
    pub(super) records: Vec<Record>,
    /// The piece of each record, if it is of one.
    record_piece: Vec<u32>,
    /// The owner of each record, while they are made.
    record_owner: Vec<u32>,
    /// The samples at which something is seen.
    seen: Vec<Seen>,
    /// Those of one of several objects.
    seen_of_object: Vec<Seen>,
    hits: Option<Hits>,
    painter: Painter,
    /// Colours of the samples in hand.
    colour: Colours,
    /// Sums over the samples done.
    sum: Colours,
    covered: Box<[u8; PIXELS]>,
}

/// A row of each component.
pub(super) type Colours = [Box<[f32; PIXELS]>; 3];

fn colours() -> Colours {
    [(); 3].map(|()| Box::new([0.0; PIXELS]))
}

/// A finished tile with something in it.
pub(super) struct Finished<'a> {
    /// Linear colours, the mean of the samples.
    pub(super) colours: &'a Colours,
    /// How many samples of each pixel are covered.
    pub(super) covered: &'a [u8; PIXELS],
}

/// What a number in [`Visible`] stands for.
enum Owner {
    /// A place in the tile's list of triangles.
    Triangle(usize),
    /// A place in the list of pieces.
    Piece(usize),
    /// A place among the objects that rays are cast at.
    Cast(usize),
}

impl Worker {
    pub(super) fn new() -> Self {
        Self {
            visible: Visible::new(),
            triangles: Vec::new(),
            pieces: Vec::new(),
            clipper: Clipper::default(),
            record_of: Vec::new(),
            records: Vec::new(),
            record_piece: Vec::new(),
            record_owner: Vec::new(),
            seen: Vec::new(),
            seen_of_object: Vec::new(),
            hits: None,
            painter: Painter::new(),
            colour: colours(),
            sum: colours(),
            covered: Box::new([0; PIXELS]),
        }
    }

    /// Draws a tile; `None` if there is nothing but background.
    pub(super) fn draw(
        &mut self,
        job: &Job,
        bins: &Bins,
        lines: &LineJob,
        tile: [usize; 2],
    ) -> Result<Option<Finished<'_>>, RenderError> {
        let number = tile[1] * tiles(job.view.size)[0] + tile[0];
        if bins.is_empty(number) && lines.is_empty(number) && cast_objects(job).next().is_none() {
            return Ok(None);
        }
        let count = job.settings.samples.count();
        self.list(job, bins, tile);
        self.covered.fill(0);
        for (number, sample) in job.settings.samples.offsets().enumerate() {
            let origin = tile_origin(tile, sample);
            self.see(job, origin);
            self.collect(job, tile);
            self.paint(job, origin)?;
            self.draw_lines(job, lines, tile, sample);
            if count == 1 {
                return Ok(Some(Finished { colours: &self.colour, covered: &self.covered }));
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
        Ok(Some(Finished { colours: &self.sum, covered: &self.covered }))
    }

    /// The triangle or piece that a sample of a pixel shows, after drawing with one sample.
    pub(super) fn look(
        &mut self,
        job: &Job,
        bins: &Bins,
        pixel: [u32; 2],
        sample: [i32; 2],
    ) -> Option<Record> {
        let tile = pixel.map(|n| n as usize / TILE);
        self.list(job, bins, tile);
        self.see(job, tile_origin(tile, sample));
        let owner = self.visible.owner[number(pixel.map(|n| n as usize % TILE))];
        if owner == NOTHING {
            return None;
        }
        Some(match self.owner(owner) {
            Owner::Triangle(at) => self.record(job, at, None),
            Owner::Piece(at) => self.record(job, self.pieces[at].0 as usize, Some(at)),
            Owner::Cast(at) => cast_record(cast_objects(job).nth(at)?),
        })
    }

    /// Takes the tile's triangles from the bins and clips those that need it.
    fn list(&mut self, job: &Job, bins: &Bins, tile: [usize; 2]) {
        self.triangles.clear();
        self.pieces.clear();
        bins.tile(tile[1] * tiles(job.view.size)[0] + tile[0], &mut self.triangles);
        if bins.counts.clipped > 0 {
            for (at, &triangle) in self.triangles.iter().enumerate().filter(|(_, t)| *t & CLIPPED != 0) {
                let object = job.owner(triangle & !CLIPPED);
                let pieces = self.clipper.pieces(object, (triangle & !CLIPPED) - object.first, &job.view);
                self.pieces.extend(pieces.iter().map(|piece| (at as u32, *piece)));
            }
        }
        self.record_of.clear();
        self.record_of.resize(self.triangles.len() + self.pieces.len() + cast_objects(job).count(), NOTHING);
    }

    /// Finds what is seen at one sample of each pixel.
    fn see(&mut self, job: &Job, origin: [i32; 2]) {
        self.visible.clear();
        let Self { visible, triangles, pieces, .. } = self;
        num::dispatch(DrawTriangles { job, triangles, pieces, origin, visible });
        let first = self.triangles.len() + self.pieces.len();
        for (at, object) in cast_objects(job).enumerate() {
            let hits = self.hits.get_or_insert_with(Hits::new);
            hits.cast(job, object, (first + at) as u32, origin, &mut self.visible);
        }
    }

    fn owner(&self, owner: u32) -> Owner {
        let owner = owner as usize;
        let (triangles, pieces) = (self.triangles.len(), self.pieces.len());
        if owner < triangles {
            Owner::Triangle(owner)
        } else if owner < triangles + pieces {
            Owner::Piece(owner - triangles)
        } else {
            Owner::Cast(owner - triangles - pieces)
        }
    }

    fn record(&self, job: &Job, at: usize, piece: Option<usize>) -> Record {
        let triangle = self.triangles[at] & !CLIPPED;
        let object = job.owner(triangle);
        let number = triangle - object.first;
        let v = match piece {
            Some(piece) => self.pieces[piece].1.vertices,
            None => object.screen(number),
        };
        Record::new(job, object, number, &v)
    }

    /// Lists what is seen and makes a record of each triangle that is.
    fn collect(&mut self, job: &Job, tile: [usize; 2]) {
        self.records.clear();
        self.record_piece.clear();
        self.hide_outside(job, tile);
        for (covered, &owner) in self.covered.iter_mut().zip(self.visible.owner.iter()) {
            *covered += u8::from(owner != NOTHING);
        }
        let mut seen = std::mem::take(&mut self.seen);
        seen.clear();
        let (mut last, mut record) = (NOTHING, NOTHING);
        for block in 0..PIXELS / LANES {
            let first = block * LANES;
            let owners: [u32; LANES] = self.visible.owner[first..first + LANES].try_into().expect("a block");
            let is_empty = owners.iter().fold(NOTHING, |all, owner| all & owner) == NOTHING;
            if is_empty {
                continue;
            }
            // Kept whole, so that room is asked for once a block.
            let mut found = [Seen { pixel: 0, record: 0 }; LANES];
            let mut count = 0;
            for (lane, owner) in owners.into_iter().enumerate() {
                if owner != last && owner != NOTHING {
                    (last, record) = (owner, self.record_of[owner as usize]);
                    if record == NOTHING {
                        record = self.add_record(job, owner);
                    }
                }
                found[count % LANES] = Seen { pixel: (first + lane) as u16, record };
                count += usize::from(owner != NOTHING);
            }
            seen.extend_from_slice(&found[..count]);
        }
        self.seen = seen;
        // Ready for the next sample.
        for &owner in &self.record_owner {
            self.record_of[owner as usize] = NOTHING;
        }
        self.record_owner.clear();
    }

    /// Takes away what lies beyond the picture's right and lower border.
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

    /// Makes the record of a triangle, a piece or an analytic surface that is seen.
    fn add_record(&mut self, job: &Job, owner: u32) -> u32 {
        let (record, piece) = match self.owner(owner) {
            Owner::Triangle(at) => (self.record(job, at, None), None),
            Owner::Piece(at) => (self.record(job, self.pieces[at].0 as usize, Some(at)), Some(at)),
            Owner::Cast(at) => {
                let object = cast_objects(job).nth(at).expect("an object that rays were cast at");
                (cast_record(object), None)
            }
        };
        let number = self.records.len() as u32;
        self.record_of[owner as usize] = number;
        self.record_owner.push(owner);
        self.records.push(record);
        self.record_piece.push(piece.map_or(NOTHING, |piece| piece as u32));
        number
    }

    /// Colours of all samples.
    fn paint(&mut self, job: &Job, origin: [i32; 2]) -> Result<(), RenderError> {
        for (row, background) in self.colour.iter_mut().zip(job.background) {
            row.fill(background);
        }
        let is_hidden = job.settings.shading == Shading::Wireframe && job.settings.show == Show::Shaded;
        if is_hidden {
            return Ok(());
        }
        let Self { painter, records, record_piece, pieces, .. } = self;
        painter.corner_values(job, records, |record, values| match record_piece[record] {
            NOTHING => values,
            piece => piece_values(values, &pieces[piece as usize].1, job.settings.interpolation),
        })?;
        let mut objects: Vec<u32> = self.records.iter().map(|record| record.object).collect();
        objects.dedup();
        objects.sort_unstable();
        objects.dedup();
        for &object in &objects {
            let seen = match objects.len() {
                1 => &self.seen,
                _ => {
                    let is_its = |seen: &&Seen| self.records[seen.record as usize].object == object;
                    self.seen_of_object.clear();
                    self.seen_of_object.extend(self.seen.iter().filter(is_its));
                    &self.seen_of_object
                }
            };
            self.painter.paint(
                job,
                object as usize,
                seen,
                &self.records,
                &self.visible.depth[..],
                self.hits.as_ref(),
                origin,
                &mut self.colour,
            )?;
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
        if set.hide && self.hides(job, self.visible.owner[pixel], place, depth) {
            return;
        }
        for (row, component) in self.colour.iter_mut().zip(set.colour.to_array()) {
            row[pixel] = component;
        }
    }

    /// Whether what is seen at a sample is in front of a line. A line in a surface is not behind it: the surface is
    /// taken at the line's own place, not at the sample's, with room for the snapping of corners.
    fn hides(&self, job: &Job, owner: u32, place: [f64; 2], depth: f64) -> bool {
        /// Pixels that a corner may be off by snapping, with some room.
        const SNAPPED: f64 = 1.0 / 64.0;
        /// Roundings of single-precision depths.
        const ROUNDED: f64 = 1e-6;
        /// How far behind the true surface, as a share of the distance, a mesh's edges may lie and still show.
        const CHORD: f64 = 1e-3;
        if owner == NOTHING {
            return false;
        }
        let v: [ScreenVertex; 3] = match self.owner(owner) {
            Owner::Triangle(at) => {
                let triangle = self.triangles[at] & !CLIPPED;
                let object = job.owner(triangle);
                object.screen(triangle - object.first)
            }
            Owner::Piece(at) => self.pieces[at].1.vertices,
            Owner::Cast(at) => {
                let hit = cast_objects(job).nth(at).and_then(|object| cast(job, object, place));
                return hit.is_some_and(|(_, z)| job.view.depth(z * (1.0 + CHORD)) > depth);
            }
        };
        let at = place.map(super::fixed::snap);
        let [surface, right, down] = depth_plane(&v, double_area(&v), at).map(f64::from);
        let room = (right.abs() + down.abs()) * SNAPPED + surface.abs() * ROUNDED;
        depth < surface - room
    }
}

/// The objects that rays are cast at.
fn cast_objects(job: &Job) -> impl Iterator<Item = usize> {
    job.objects.iter().enumerate().filter(|(_, object)| object.is_cast).map(|(number, _)| number)
}

/// The record of all that is seen of an analytic surface.
fn cast_record(object: usize) -> Record {
    Record {
        x: [0; 3],
        y: [0; 3],
        depth: [0.0; 3],
        values: [Vec3::ZERO; 3],
        vertices: [0; 3],
        triangle: 0,
        face: 0,
        object: object as u32,
        front: true,
        turned: false,
    }
}

/// Draws the triangles of a tile in order, a group at a time.
struct DrawTriangles<'a> {
    job: &'a Job<'a>,
    triangles: &'a [u32],
    pieces: &'a [(u32, Piece)],
    origin: [i32; 2],
    visible: &'a mut Visible,
}

impl Kernel for DrawTriangles<'_> {
    type Output = ();

    #[inline(always)]
    fn run<P: Product>(self) {
        let Self { job, triangles, pieces, origin, visible } = self;
        let mut group = Group { corners: CornerRows::new(), owners: [0; GROUP], count: 0, origin };
        let mut setups = Setup::rows();
        let (mut piece, mut from) = (0, 0);
        for (number, object) in job.drawn.iter().enumerate() {
            let end = match job.drawn.get(number + 1) {
                None => triangles.len(),
                Some(next) => from + triangles[from..].partition_point(|&t| t & !CLIPPED < next.first),
            };
            for (at, &triangle) in triangles.iter().enumerate().take(end).skip(from) {
                if triangle & CLIPPED == 0 {
                    group.add(&object.screen(triangle - object.first), at as u32);
                    group.draw_if(GROUP, &mut setups, visible);
                    continue;
                }
                while piece < pieces.len() && pieces[piece].0 as usize == at {
                    group.add(&pieces[piece].1.vertices, (triangles.len() + piece) as u32);
                    group.draw_if(GROUP, &mut setups, visible);
                    piece += 1;
                }
            }
            from = end;
        }
        group.draw_if(1, &mut setups, visible);
    }
}

/// Triangles gathered to be prepared side by side.
struct Group {
    corners: CornerRows,
    owners: [u32; GROUP],
    count: usize,
    origin: [i32; 2],
}

impl Group {
    #[inline(always)]
    fn add(&mut self, v: &[ScreenVertex; 3], owner: u32) {
        self.corners.set(self.count, v);
        self.owners[self.count] = owner;
        self.count += 1;
    }

    /// Draws the group if it has so many.
    #[inline(always)]
    fn draw_if(
        &mut self,
        least: usize,
        setups: &mut Setup<[i32; GROUP], [f32; GROUP]>,
        visible: &mut Visible,
    ) {
        if self.count < least {
            return;
        }
        setups.prepare(&self.corners, self.origin);
        for lane in 0..self.count {
            let setup = setups.get(lane);
            if !setup.is_empty() {
                visible.draw(&setup, self.owners[lane]);
            }
        }
        self.count = 0;
    }
}
