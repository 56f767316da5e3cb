//! Colours of the visible samples.

use crate::num;
use crate::raster::coverage::records::{
    Record, ValueKind, face_corners, mean_colour, piece_values, single, takes_mean, triangle_corners,
};
use crate::raster::coverage::tile_list::{Run, TileList};
use crate::raster::coverage::triangles::{Corner, DrawnObject};
use crate::raster::coverage::visible_triangle::{Colours, PIXELS, place};
use crate::raster::error::{RenderError, Result};
use crate::raster::frame::job::{Job, Prepared};
use crate::raster::settings::{Interpolation, Show};
use crate::raster::shading::false_colour;
use crate::raster::shading::interpolate::{BATCH, Interpolate, Positions, Row, ScanPolygon, VisibleSample};
use crate::raster::shading::lighting::{Lit, PointLight};
use crate::raster::shading::ray_cast::{Hits, cast};
use crate::raster::shading::surface_colour::{ObjectColour, Shaders};
use crate::raster::view::fixed_point::{BITS, ONE};
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
    pub(crate) seen: &'a [VisibleSample],
    pub(crate) records: &'a [Record],
    pub(crate) depth: &'a [f32],
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
        let (object, Some(drawn)) = (&job.objects[run.object], run.drawn) else { return Ok(()) };
        let drawn = &job.drawn[drawn];
        let (records, owners) = (&mut records[run.records.clone()], &owners[run.records.clone()]);
        let wanted = ValueKind::new(object);
        match (wanted, &object.colour) {
            (ValueKind::Nothing, _) => return Ok(()),
            (ValueKind::FaceNormal, _) => {
                for record in records {
                    record.values = [object.face_normal(record.face, record.turned); 3];
                }
                return Ok(());
            }
            (ValueKind::FaceColour, ObjectColour::Given(colours)) => {
                for record in records {
                    record.values = [mean_colour(colours, face_corners(object, drawn, record)); 3];
                }
                return Ok(());
            }
            (ValueKind::FaceColour, ObjectColour::Lit(shaders)) => {
                return self.light_faces(&Lit { job, object, drawn, shaders }, records);
            }
            (ValueKind::CornerNormals, _) => {
                for record in records.iter_mut() {
                    let corners = triangle_corners(drawn, record);
                    record.values = corners.map(|corner| object.corner_normal(corner));
                }
            }
            (ValueKind::CornerColours, ObjectColour::Given(colours)) => {
                for record in records.iter_mut() {
                    record.values = record.vertices.map(|vertex| single(colours[vertex as usize]));
                }
            }
            (ValueKind::CornerColours, ObjectColour::Lit(shaders)) => {
                let corners = records.iter().flat_map(|record| triangle_corners(drawn, record));
                self.light.corners(&Lit { job, object, drawn, shaders }, corners)?;
                for (at, record) in records.iter_mut().enumerate() {
                    record.values = [0, 1, 2].map(|k| self.light.colour(3 * at + k));
                }
            }
        }
        if !list.pieces.is_empty() {
            for (record, &owner) in records.iter_mut().zip(owners) {
                if let Some(piece) = list.piece(owner) {
                    record.values = piece_values(record.values, piece, object.settings.interpolation);
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
                record.values = [self.light.colour(at); 3];
            }
            return Ok(());
        }
        self.light.corners(lit, records.iter().flat_map(corners))?;
        let mut first = 0;
        for record in records {
            let count = corners(record).len();
            let colours = (first..first + count).map(|corner| self.light.colour(corner).as_dvec3());
            record.values = [(colours.sum::<DVec3>() / count as f64).as_vec3(); 3];
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
        for seen in tile.seen.chunks(BATCH) {
            match tile.hits.filter(|_| prepared.is_cast) {
                Some(hits) => self.take_hits(hits, seen),
                None => {
                    self.take_values(job, prepared, wanted, seen, tile);
                    if needs_positions {
                        self.take_positions(job, seen, tile);
                    }
                }
            }
            match (shaders, job.settings.show) {
                (Some(shaders), _) => self.shade(job, object, shaders, seen, tile)?,
                // The values are colours already.
                (None, Show::Shaded) => {}
                (None, _) => self.show_false_colours(job, prepared, seen, tile),
            }
            let is_colour = shaders.is_none() && job.settings.show == Show::Shaded;
            let colours = if is_colour { &self.values } else { &self.colours };
            for (out, colours) in out.iter_mut().zip(colours.iter()) {
                for (seen, &colour) in seen.iter().zip(colours.iter()) {
                    out[usize::from(seen.pixel) % PIXELS] = colour;
                }
            }
        }
        Ok(())
    }

    fn shade(
        &mut self,
        job: &Job,
        object: usize,
        shaders: &Shaders,
        seen: &[VisibleSample],
        tile: &Tile,
    ) -> Result<()> {
        let prepared = &job.objects[object];
        let by_faces = prepared.settings.asks_faces() && !prepared.is_cast;
        if by_faces {
            for (lane, seen) in seen.iter().enumerate() {
                let record = &tile.records[seen.record as usize];
                let normal = prepared.face_normal(record.face, record.turned).to_array();
                self.faces.iter_mut().zip(normal).for_each(|(row, component)| row[lane] = component);
            }
        }
        let count = seen.len();
        let rows = SurfaceRows {
            positions: self.positions.each_ref().map(|row| &row[..count]),
            normals: self.values.each_ref().map(|row| &row[..count]),
            faces: by_faces.then(|| self.faces.each_ref().map(|row| &row[..count])),
        };
        let colours = self.colours.each_mut().map(|row| &mut row[..count]);
        shaders
            .shade_rows(&rows, colours, |lane| seen_exactly(job, object, tile, seen[lane]))
            .map_err(|error| RenderError::NotFinite { object, error })
    }

    fn show_false_colours(&mut self, job: &Job, prepared: &Prepared, seen: &[VisibleSample], tile: &Tile) {
        for (lane, seen) in seen.iter().enumerate() {
            let at = |rows: &[Row; 3]| Vec3::new(rows[0][lane], rows[1][lane], rows[2][lane]);
            let sample = false_colour::Sample {
                record: &tile.records[seen.record as usize],
                hit: tile.hits.filter(|_| prepared.is_cast).map(|hits| hits.at(seen.pixel)),
                value: at(&self.values),
                position: at(&self.positions),
                depth: tile.depth[usize::from(seen.pixel)],
                at: tile.place(*seen),
            };
            let colour = false_colour::colour(job, prepared, &sample).to_array();
            self.colours.iter_mut().zip(colour).for_each(|(row, component)| row[lane] = component);
        }
    }

    fn take_positions(&mut self, job: &Job, seen: &[VisibleSample], tile: &Tile) {
        num::dispatch(Positions {
            rays: &job.rays,
            seen,
            depth: tile.depth,
            records: job.view.has_level().then_some(tile.records),
            origin: tile.origin,
            out: &mut self.positions,
        });
    }

    fn take_values(
        &mut self,
        job: &Job,
        prepared: &Prepared,
        wanted: ValueKind,
        seen: &[VisibleSample],
        tile: &Tile,
    ) {
        let Tile { records, origin, .. } = *tile;
        if !wanted.varies() {
            let [x, y, z] = &mut *self.values;
            for (((seen, x), y), z) in seen.iter().zip(x).zip(y).zip(z) {
                [*x, *y, *z] = records[seen.record as usize].values[0].to_array();
            }
            return;
        }
        // In a parallel projection the picture is the scene seen from far away: nothing to correct.
        let is_perspective = prepared.settings.interpolation == Interpolation::Perspective;
        let perspective = is_perspective && job.view.perspective;
        num::dispatch(Interpolate { records, seen, origin, perspective, out: &mut self.values });
        if self.polygons.is_empty() {
            return;
        }
        for (lane, seen) in seen.iter().enumerate() {
            let face = records[seen.record as usize].face;
            let Ok(found) = self.polygons.binary_search_by_key(&face, |&(face, _)| face) else { continue };
            let at = tile.place(*seen).map(|n| f64::from(n) / f64::from(ONE));
            let value = self.polygons[found].1.value(at);
            self.values.iter_mut().zip(value.to_array()).for_each(|(row, value)| row[lane] = value as f32);
        }
    }

    fn take_hits(&mut self, hits: &Hits, seen: &[VisibleSample]) {
        for (lane, seen) in seen.iter().enumerate() {
            let hit = hits.at(seen.pixel);
            self.values.iter_mut().zip(hit.normal.to_array()).for_each(|(row, value)| row[lane] = value);
            self.positions.iter_mut().zip(hit.position.to_array()).for_each(|(row, value)| row[lane] = value);
        }
    }
}

impl Tile<'_> {
    fn place(&self, seen: VisibleSample) -> [i32; 2] {
        let [column, row] = place(usize::from(seen.pixel)).map(|n| n as i32);
        [self.origin[0] + (column << BITS), self.origin[1] + (row << BITS)]
    }
}

/// Where a sample sees an object, in the frame of the shaders, before depth and corners are rounded.
fn seen_exactly(job: &Job, object: usize, tile: &Tile, seen: VisibleSample) -> DVec3 {
    let at = tile.place(seen).map(|n| f64::from(n) / f64::from(ONE));
    let position = match job.drawn.iter().find(|drawn| drawn.object == object) {
        Some(drawn) => {
            let triangle = tile.records[seen.record as usize].vertices;
            drawn.plane_point(&job.view, triangle, at).from_eye + (job.view.eye - job.view.origin)
        }
        None => cast(job, object, at).map_or(DVec3::NAN, |(hit, _)| hit.position - job.view.origin),
    };
    position / job.frame.unit
}
