//! The triangles of one tile: collecting them, drawing them, and records of the visible ones.

use crate::num::{Kernel, Lanes};
use crate::raster::coverage::records::Record;
use crate::raster::coverage::setup::{CornerRows, Corners, GROUP, LARGE, Setup};
use crate::raster::coverage::tile_bins::{Bins, CLIPPED, Clipper, Piece, tiles};
use crate::raster::coverage::visible_triangle::Visible;
use crate::raster::frame::job::Job;
use crate::raster::view::project::ScreenVertex;
use std::ops::Range;

/// The owners of pixels in a tile, numbered through: triangles, pieces of clipped triangles, objects that rays are cast at.
#[derive(Default)]
pub(crate) struct TileList {
    /// As the bins have them.
    pub(crate) triangles: Vec<u32>,
    /// Each with its triangle's place in the list.
    pub(crate) pieces: Vec<(u32, Piece)>,
    pub(crate) casts: Vec<usize>,
    clipper: Clipper,
}

pub(crate) enum Owner {
    /// A triangle of one of [`Job::drawn`], or a piece of it, and its corners on the picture.
    Triangle { object: usize, triangle: u32, corners: [ScreenVertex; 3] },
    /// An analytic surface: the object's number in the scene.
    Cast(usize),
}

/// Records of one object that follow one another.
#[derive(Clone, Debug)]
pub(crate) struct Run {
    pub(crate) object: usize,
    /// Its number among [`Job::drawn`]; `None` for analytic surfaces.
    pub(crate) drawn: Option<usize>,
    pub(crate) records: Range<usize>,
}

impl TileList {
    /// Takes the tile's triangles from the bins and clips those that need it.
    pub(crate) fn fill(&mut self, job: &Job, bins: &Bins, tile: [usize; 2]) {
        self.triangles.clear();
        self.pieces.clear();
        self.casts.clear();
        bins.tile(tile[1] * tiles(job.view.size)[0] + tile[0], &mut self.triangles);
        self.casts.extend(job.cast_objects());
        if bins.counts.clipped == 0 {
            return;
        }
        for (at, &triangle) in self.triangles.iter().enumerate().filter(|(_, t)| *t & CLIPPED != 0) {
            let object = &job.drawn[job.owner(triangle & !CLIPPED)];
            let pieces = self.clipper.pieces(object, (triangle & !CLIPPED) - object.first, &job.view);
            self.pieces.extend(pieces.iter().map(|piece| (at as u32, *piece)));
        }
    }

    pub(crate) fn len(&self) -> usize {
        self.triangles.len() + self.pieces.len() + self.casts.len()
    }

    pub(crate) fn first_cast(&self) -> usize {
        self.triangles.len() + self.pieces.len()
    }

    #[inline(always)]
    pub(crate) fn piece(&self, owner: u32) -> Option<&Piece> {
        let piece = (owner as usize).checked_sub(self.triangles.len())?;
        self.pieces.get(piece).map(|(_, piece)| piece)
    }

    pub(crate) fn look_up(&self, job: &Job, owner: u32) -> Owner {
        let number = owner as usize;
        if number >= self.first_cast() {
            return Owner::Cast(self.casts[number - self.first_cast()]);
        }
        let piece = number.checked_sub(self.triangles.len()).map(|piece| &self.pieces[piece]);
        let triangle = self.triangles[piece.map_or(number, |&(at, _)| at as usize)] & !CLIPPED;
        let object = job.owner(triangle);
        let triangle = triangle - job.drawn[object].first;
        let corners =
            piece.map_or_else(|| job.drawn[object].screen(triangle).map(|v| *v), |(_, piece)| piece.vertices);
        Owner::Triangle { object, triangle, corners }
    }

    pub(crate) fn record(&self, job: &Job, owner: u32) -> Record {
        match self.look_up(job, owner) {
            Owner::Triangle { object, triangle, corners } => {
                let mut record = Record::new(job, &job.drawn[object], triangle, &corners);
                if let Some(piece) = self.piece(owner) {
                    record.corners.nearness = piece.nearness;
                }
                record
            }
            Owner::Cast(object) => Record::cast(object),
        }
    }

    /// Records of owners in ascending order, and the runs of those that are of one object.
    pub(crate) fn records(&self, job: &Job, owners: &[u32], records: &mut Vec<Record>, runs: &mut Vec<Run>) {
        runs.clear();
        let (whole, rest) =
            owners.split_at(owners.partition_point(|&owner| (owner as usize) < self.triangles.len()));
        let number = |owner: u32| self.triangles[owner as usize] & !CLIPPED;
        let mut from = 0;
        // There are many whole triangles: object by object is faster.
        for (at, object) in job.drawn.iter().enumerate() {
            let end = match job.drawn.get(at + 1) {
                None => whole.len(),
                Some(next) => from + whole[from..].partition_point(|&owner| number(owner) < next.first),
            };
            if from < end {
                // Written in place of those of another tile: appending would copy each once more.
                if records.len() < end {
                    records.resize(end, Record::default());
                }
                for (record, &owner) in records[from..end].iter_mut().zip(&whole[from..end]) {
                    let triangle = number(owner) - object.first;
                    let [a, b, c] = object.screen(triangle);
                    *record = Record::new(job, object, triangle, &[*a, *b, *c]);
                }
                runs.push(Run { object: object.object, drawn: Some(at), records: from..end });
            }
            from = end;
        }
        records.truncate(whole.len());
        for &owner in rest {
            let record = self.record(job, owner);
            let (object, end) = (record.object as usize, records.len() + 1);
            records.push(record);
            match runs.last_mut() {
                Some(run) if run.object == object => run.records.end = end,
                _ => {
                    let drawn = job.drawn.iter().position(|drawn| drawn.object == object);
                    runs.push(Run { object, drawn, records: end - 1..end });
                }
            }
        }
    }
}

/// Draws the triangles of a tile in order, a group at a time.
pub(crate) struct DrawTriangles<'a> {
    pub(crate) job: &'a Job<'a>,
    pub(crate) list: &'a TileList,
    /// The sample of the tile's first pixel, in 256ths of a pixel of the picture.
    pub(crate) origin: [i32; 2],
    pub(crate) visible: &'a mut Visible,
}

impl Kernel for DrawTriangles<'_> {
    type Output = ();

    #[inline(always)]
    fn run<A: Lanes>(self, arch: A) {
        let Self { job, list, origin, visible } = self;
        let (triangles, pieces) = (&list.triangles[..], &list.pieces[..]);
        let mut group = Group {
            corners: Corners::new(),
            owners: [0; GROUP],
            count: 0,
            origin,
            rows: CornerRows::default(),
            setups: Setup::default(),
        };
        let (mut piece, mut from) = (0, 0);
        for (number, object) in job.drawn.iter().enumerate() {
            let end = match job.drawn.get(number + 1) {
                None => triangles.len(),
                Some(next) => from + triangles[from..].partition_point(|&t| t & !CLIPPED < next.first),
            };
            for (at, &triangle) in triangles.iter().enumerate().take(end).skip(from) {
                if triangle & CLIPPED == 0 {
                    group.add(object.screen(triangle - object.first), at as u32);
                    group.draw_if(arch, GROUP, visible);
                    continue;
                }
                while piece < pieces.len() && pieces[piece].0 as usize == at {
                    group.add(pieces[piece].1.vertices.each_ref(), (triangles.len() + piece) as u32);
                    group.draw_if(arch, GROUP, visible);
                    piece += 1;
                }
            }
            from = end;
        }
        group.draw_if(arch, 1, visible);
    }
}

/// Triangles gathered to be prepared side by side.
struct Group<'a> {
    corners: Corners<'a>,
    owners: [u32; GROUP],
    count: usize,
    origin: [i32; 2],
    rows: CornerRows,
    setups: Setup<[i32; GROUP], [f32; GROUP]>,
}

impl<'a> Group<'a> {
    #[inline(always)]
    fn add(&mut self, corners: [&'a ScreenVertex; 3], owner: u32) {
        self.corners.set(self.count, corners);
        self.owners[self.count] = owner;
        self.count += 1;
    }

    #[inline(always)]
    fn draw_if<A: Lanes>(&mut self, arch: A, least: usize, visible: &mut Visible) {
        if self.count < least {
            return;
        }
        self.rows.load(arch, &self.corners);
        self.setups.prepare(&self.rows, self.origin);
        let mut masks = [0; GROUP];
        self.setups.masks(&mut masks);
        for (lane, &mask) in masks.iter().enumerate().take(self.count) {
            if mask != LARGE {
                visible.draw_small(&self.setups, lane, mask, self.owners[lane]);
                continue;
            }
            let setup = self.setups.get(lane);
            if !setup.is_empty() {
                visible.draw(&setup, self.owners[lane]);
            }
        }
        self.count = 0;
    }
}
