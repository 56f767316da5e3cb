//! Colours of the visible samples.

use crate::num;
use crate::raster::coverage::records::{
    Record, ValueKind, face_corners, mean_colour, piece_values, single, takes_mean, triangle_corners,
};
use crate::raster::coverage::shown::Block;
use crate::raster::coverage::tile_list::{Run, TileList};
use crate::raster::coverage::triangles::{Corner, DrawnObject};
use crate::raster::coverage::visible_triangle::{Colours, LANES, PIXELS};
use crate::raster::error::{RenderError, Result};
use crate::raster::frame::job::{Job, Prepared};
use crate::raster::settings::{Interpolation, Show};
use crate::raster::shading::false_colour;
use crate::raster::shading::interpolate::{
    BATCH, Interpolate, Positions, Row, Spread, fill_lanes, sample_at,
};
use crate::raster::shading::lighting::{Lit, PointLight};
use crate::raster::shading::ray_cast::{Hits, cast};
use crate::raster::shading::scan_polygon::ScanPolygon;
use crate::raster::shading::surface_colour::{ObjectColour, Shaders};
use crate::raster::view::fixed_point::ONE;
use crate::shade::SurfaceRows;
use glam::{DVec3, Vec3};

/// Computes colours; keeps its memory.
pub(crate) struct Painter {
    values: Box<[Row; 3]>,
    positions: Box<[Row; 3]>,
    colours: Box<[Row; 3]>,
    faces: Box<[Row; 3]>,
    light: PointLight,
    /// Polygons of the scanline algorithm, by ascending face.
    polygons: Vec<(u32, ScanPolygon)>,
}

/// The visible samples of one object in a tile.
pub(crate) struct Tile<'a> {
    /// The blocks that show it.
    pub(crate) blocks: &'a [Block],
    /// The record that each pixel shows.
    pub(crate) shown: &'a [u32; PIXELS],
    pub(crate) records: &'a [Record],
    pub(crate) depth: &'a [f32; PIXELS],
    pub(crate) hits: Option<&'a Hits>,
    /// The sample of the tile's first pixel, in 256ths of a pixel of the picture.
    pub(crate) origin: [i32; 2],
}

impl Painter {
    pub(crate) fn new() -> Self {
        let rows = || Box::new([[0.0; BATCH]; 3]);
        Self {
            values: rows(),
            positions: rows(),
            colours: rows(),
            faces: rows(),
            light: PointLight::default(),
            polygons: Vec::new(),
        }
    }

    /// Computes the values at the corners of the triangles of a run.
    pub(crate) fn prepare(
        &mut self,
        job: &Job,
        run: &Run,
        list: &TileList,
        owners: &[u32],
        records: &mut [Record],
    ) -> Result<()> {
        self.polygons.clear();
        let (object, Some(number)) = (&job.objects[run.object], run.drawn) else { return Ok(()) };
        let drawn = &job.drawn[number];
        let (records, owners) = (&mut records[run.records.clone()], &owners[run.records.clone()]);
        let wanted = ValueKind::new(object);
        let lit_before = job.lit[number].as_ref().filter(|_| !records.iter().any(|record| record.turned));
        match (wanted, &object.colour) {
            (ValueKind::Nothing, _) => return Ok(()),
            (ValueKind::FaceNormal, _) => {
                for record in records {
                    record.corners.values = [object.face_normal(record.face, record.turned); 3];
                }
                return Ok(());
            }
            (ValueKind::FaceColour, ObjectColour::Given(colours)) => {
                for record in records {
                    record.corners.values = [mean_colour(colours, face_corners(object, drawn, record)); 3];
                }
                return Ok(());
            }
            (ValueKind::FaceColour, ObjectColour::Lit(shaders)) => {
                return self.light_faces(&Lit { job, object, drawn, shaders }, records);
            }
            (ValueKind::CornerNormals, _) => {
                for record in records.iter_mut() {
                    let [a, b, c] = triangle_corners(drawn, record);
                    record.corners.values =
                        [object.corner_normal(a), object.corner_normal(b), object.corner_normal(c)];
                }
            }
            (ValueKind::CornerColours, ObjectColour::Given(colours)) => {
                for record in records.iter_mut() {
                    record.corners.values = record.vertices.map(|vertex| single(colours[vertex as usize]));
                }
            }
            (ValueKind::CornerColours, ObjectColour::Lit(_)) if let Some(lit) = lit_before => {
                for record in records.iter_mut() {
                    let [a, b, c] = record.vertices;
                    record.corners.values = [lit[a as usize], lit[b as usize], lit[c as usize]];
                }
            }
            (ValueKind::CornerColours, ObjectColour::Lit(shaders)) => {
                let corners = records.iter().flat_map(|record| triangle_corners(drawn, record));
                self.light.corners(&Lit { job, object, drawn, shaders }, corners)?;
                for (at, record) in records.iter_mut().enumerate() {
                    let colour = |k: usize| self.light.colour(3 * at + k);
                    record.corners.values = [colour(0), colour(1), colour(2)];
                }
            }
        }
        if !list.pieces.is_empty() {
            for (record, &owner) in records.iter_mut().zip(owners) {
                if let Some(piece) = list.piece(owner) {
                    record.corners.values =
                        piece_values(record.corners.values, piece, object.settings.interpolation);
                }
            }
        }
        match object.settings.interpolation {
            Interpolation::Scanline => self.make_polygons(job, object, drawn, records),
            Interpolation::Affine | Interpolation::Perspective => Ok(()),
        }
    }

    fn light_faces(&mut self, lit: &Lit, records: &mut [Record]) -> Result<()> {
        let corners = |record: &Record| face_corners(lit.object, lit.drawn, record);
        if !takes_mean(lit.object) {
            let normal = |record: &Record| lit.object.face_normal(record.face, record.turned);
            self.light.faces(lit, records.iter().map(|record| (corners(record), normal(record))))?;
            for (at, record) in records.iter_mut().enumerate() {
                record.corners.values = [self.light.colour(at); 3];
            }
            return Ok(());
        }
        self.light.corners(lit, records.iter().flat_map(corners))?;
        let mut first = 0;
        for record in records {
            let count = corners(record).len();
            let colours = (first..first + count).map(|corner| self.light.colour(corner).as_dvec3());
            record.corners.values = [(colours.sum::<DVec3>() / count as f64).as_vec3(); 3];
            first += count;
        }
        Ok(())
    }

    /// The polygons of faces with four corners or more, for the scanline algorithm.
    fn make_polygons(
        &mut self,
        job: &Job,
        object: &Prepared,
        drawn: &DrawnObject,
        records: &[Record],
    ) -> Result<()> {
        let mut faces: Vec<&Record> = records.iter().collect();
        faces.retain(|record| face_corners(object, drawn, record).len() > 3);
        faces.sort_by_key(|record| record.face);
        faces.dedup_by_key(|record| record.face);
        let corners = || faces.iter().flat_map(|record| face_corners(object, drawn, record));
        let wants_normals = ValueKind::new(object) == ValueKind::CornerNormals;
        if let (false, ObjectColour::Lit(shaders)) = (wants_normals, &object.colour) {
            self.light.corners(&Lit { job, object, drawn, shaders }, corners())?;
        }
        let value = |(at, corner): (usize, Corner)| match &object.colour {
            _ if wants_normals => object.corner_normal(corner),
            ObjectColour::Given(colours) => single(colours[corner.vertex as usize]),
            ObjectColour::Lit(_) => self.light.colour(at),
        };
        let place = |corner: Corner| drawn.map.view(drawn.points.at(corner.vertex));
        let mut placed =
            corners().enumerate().map(|(at, corner)| (place(corner), value((at, corner)).as_dvec3()));
        for record in &faces {
            let count = face_corners(object, drawn, record).len();
            let polygon = ScanPolygon::new(&job.view, placed.by_ref().take(count));
            self.polygons.push((record.face, polygon));
        }
        Ok(())
    }

    pub(crate) fn paint(&mut self, job: &Job, object: usize, tile: &Tile, out: &mut Colours) -> Result<()> {
        let prepared = &job.objects[object];
        let wanted = ValueKind::new(prepared);
        let shaders = match (&prepared.colour, job.settings.show) {
            (ObjectColour::Lit(shaders), Show::Shaded)
                if wanted == ValueKind::CornerNormals || prepared.is_cast =>
            {
                Some(shaders)
            }
            _ => None,
        };
        let needs_positions = shaders.is_some_and(|shaders| shaders.needs_positions())
            || matches!(job.settings.show, Show::Deviation(_)) && prepared.truth.is_some();
        for blocks in tile.blocks.chunks(BATCH / LANES) {
            match tile.hits.filter(|_| prepared.is_cast) {
                Some(hits) => self.take_hits(hits, blocks),
                None => {
                    self.take_values(job, prepared, wanted, blocks, tile);
                    if needs_positions {
                        self.take_positions(job, blocks, tile);
                    }
                }
            }
            match (shaders, job.settings.show) {
                (Some(shaders), _) => self.shade(job, object, shaders, blocks, tile)?,
                // The values are colours already.
                (None, Show::Shaded) => {}
                (None, _) => self.show_false_colours(job, prepared, blocks, tile),
            }
            let is_colour = shaders.is_none() && job.settings.show == Show::Shaded;
            let colours = if is_colour { &self.values } else { &self.colours };
            for (out, colours) in out.iter_mut().zip(colours.iter()) {
                write_blocks(blocks, colours, out);
            }
        }
        Ok(())
    }

    fn shade(
        &mut self,
        job: &Job,
        object: usize,
        shaders: &Shaders,
        blocks: &[Block],
        tile: &Tile,
    ) -> Result<()> {
        let prepared = &job.objects[object];
        let by_faces = prepared.settings.asks_faces() && !prepared.is_cast;
        if by_faces {
            for (at, record) in tile.shown(blocks) {
                let normal = prepared.face_normal(record.face, record.turned).to_array();
                self.faces.iter_mut().zip(normal).for_each(|(row, component)| row[at.row] = component);
            }
        }
        for rows in [&mut self.positions, &mut self.values, &mut self.faces] {
            fill_lanes(blocks, rows);
        }
        let count = blocks.len() * LANES;
        let rows = SurfaceRows {
            positions: self.positions.each_ref().map(|row| &row[..count]),
            normals: self.values.each_ref().map(|row| &row[..count]),
            faces: by_faces.then(|| self.faces.each_ref().map(|row| &row[..count])),
        };
        let colours = self.colours.each_mut().map(|row| &mut row[..count]);
        let exactly = |at: usize| {
            let block = blocks[at / LANES];
            seen_exactly(job, object, tile, block.start() + block.lane_or_first(at % LANES))
        };
        let shaded = shaders.shade_rows(&rows, colours, exactly);
        shaded.map_err(|error| RenderError::NotFinite { object, error })
    }

    fn show_false_colours(&mut self, job: &Job, prepared: &Prepared, blocks: &[Block], tile: &Tile) {
        for (Shown { row, pixel }, record) in tile.shown(blocks) {
            let at = |rows: &[Row; 3]| Vec3::new(rows[0][row], rows[1][row], rows[2][row]);
            let sample = false_colour::Sample {
                record,
                hit: tile.hits.filter(|_| prepared.is_cast).map(|hits| hits.at(pixel)),
                value: at(&self.values),
                position: at(&self.positions),
                depth: tile.depth[pixel],
                at: sample_at(tile.origin, pixel),
            };
            let colour = false_colour::colour(job, prepared, &sample).to_array();
            self.colours.iter_mut().zip(colour).for_each(|(out, component)| out[row] = component);
        }
    }

    fn take_positions(&mut self, job: &Job, blocks: &[Block], tile: &Tile) {
        num::dispatch(Positions {
            rays: &job.rays,
            blocks,
            depth: tile.depth,
            records: job.view.has_level().then_some((tile.records, tile.shown)),
            origin: tile.origin,
            out: &mut self.positions,
        });
    }

    fn take_values(
        &mut self,
        job: &Job,
        prepared: &Prepared,
        wanted: ValueKind,
        blocks: &[Block],
        tile: &Tile,
    ) {
        let &Tile { records, shown, origin, .. } = tile;
        // In a parallel projection the picture is the scene seen from far away: nothing to correct.
        let is_perspective = prepared.settings.interpolation == Interpolation::Perspective;
        let spread = match wanted.varies() {
            false => Spread::Constant,
            true if is_perspective && job.view.perspective => Spread::Perspective,
            true => Spread::Affine,
        };
        num::dispatch(Interpolate { records, blocks, shown, origin, spread, out: &mut self.values });
        if self.polygons.is_empty() || !wanted.varies() {
            return;
        }
        for (Shown { row, pixel }, record) in tile.shown(blocks) {
            let found = self.polygons.binary_search_by_key(&record.face, |&(face, _)| face);
            let Ok(found) = found else { continue };
            let at = sample_at(tile.origin, pixel).map(|n| f64::from(n) / f64::from(ONE));
            let value = self.polygons[found].1.value(at);
            self.values.iter_mut().zip(value.to_array()).for_each(|(out, value)| out[row] = value as f32);
        }
    }

    fn take_hits(&mut self, hits: &Hits, blocks: &[Block]) {
        for Shown { row, pixel } in shown(blocks) {
            let hit = hits.at(pixel);
            self.values.iter_mut().zip(hit.normal.to_array()).for_each(|(out, value)| out[row] = value);
            self.positions.iter_mut().zip(hit.position.to_array()).for_each(|(out, value)| out[row] = value);
        }
    }
}

/// A sample that shows the object: its place in rows, and its pixel in the tile.
struct Shown {
    row: usize,
    pixel: usize,
}

fn shown(blocks: &[Block]) -> impl Iterator<Item = Shown> + '_ {
    let of_block = |(at, block): (usize, &Block)| {
        let block = *block;
        block.shown().map(move |lane| Shown { row: at * LANES + lane, pixel: block.start() + lane })
    };
    blocks.iter().enumerate().flat_map(of_block)
}

/// Writes the colours of rows to the pixels that show the object.
fn write_blocks(blocks: &[Block], row: &Row, out: &mut [f32; PIXELS]) {
    for (block, row) in blocks.iter().zip(row.as_chunks::<LANES>().0) {
        let out = &mut out[block.start()..][..LANES];
        if block.is_full() {
            out.copy_from_slice(row);
        } else {
            block.shown().for_each(|lane| out[lane] = row[lane]);
        }
    }
}

impl<'a> Tile<'a> {
    /// The samples of blocks that show the object, with their records.
    fn shown<'b>(&'b self, blocks: &'b [Block]) -> impl Iterator<Item = (Shown, &'a Record)> + 'b {
        shown(blocks).map(|at| {
            let record = &self.records[self.shown[at.pixel] as usize];
            (at, record)
        })
    }
}

/// Where a sample sees an object, in the frame of the shaders, before depth and corners are rounded.
fn seen_exactly(job: &Job, object: usize, tile: &Tile, pixel: usize) -> DVec3 {
    let at = sample_at(tile.origin, pixel).map(|n| f64::from(n) / f64::from(ONE));
    let position = match job.drawn.iter().find(|drawn| drawn.object == object) {
        Some(drawn) => {
            let triangle = tile.records[tile.shown[pixel] as usize].vertices;
            drawn.plane_point(&job.view, triangle, at).from_eye + (job.view.eye - job.view.origin)
        }
        None => cast(job, object, at).map_or(DVec3::NAN, |(hit, _)| hit.position - job.view.origin),
    };
    position / job.frame.unit
}
