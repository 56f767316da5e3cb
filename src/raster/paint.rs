//! Colours of the samples that are seen.

use super::cast::Hits;
use super::coverage::{PIXELS, place};
use super::error::RenderError;
use super::fixed::{BITS, ONE};
use super::interpolate::{BATCH, Interpolate, Positions, Row, Seen};
use super::job::{Ink, Job, Prepared};
use super::records::{
    CornerPoint, Record, Wanted, centroid, corner_point, face_corners, mean_colour, single, takes_mean,
};
use super::scanline::ScanPolygon;
use super::settings::{Interpolation, Show};
use super::show;
use super::tile::Colours;
use super::triangles::DrawnObject;
use crate::num;
use crate::shade::{Shader, SurfaceRows};
use glam::{DVec3, Vec3};

/// Makes colours; keeps its memory.
pub(super) struct Painter {
    values: Box<[Row; 3]>,
    positions: Box<[Row; 3]>,
    colours: Box<[Row; 3]>,
    /// Points to be lit that are not samples, and their colours.
    points: [Vec<f32>; 6],
    lit: [Vec<f32>; 3],
    /// Polygons of the scanline algorithm, and which face each is of.
    polygons: Vec<(u32, u32, ScanPolygon)>,
}

impl Painter {
    pub(super) fn new() -> Self {
        let rows = || Box::new([[0.0; BATCH]; 3]);
        Self {
            values: rows(),
            positions: rows(),
            colours: rows(),
            points: Default::default(),
            lit: Default::default(),
            polygons: Vec::new(),
        }
    }

    /// Fills in what the corners of each triangle carry; `premix` makes of a triangle's values those of its piece.
    pub(super) fn corner_values(
        &mut self,
        job: &Job,
        records: &mut [Record],
        premix: impl Fn(usize, [Vec3; 3]) -> [Vec3; 3],
    ) -> Result<(), RenderError> {
        self.polygons.clear();
        for drawn in &job.drawn {
            let object = &job.objects[drawn.object];
            let wanted = Wanted::new(job, object);
            if wanted == Wanted::Nothing {
                continue;
            }
            let is_its = |record: &Record| record.object as usize == drawn.object;
            let mut of_object: Vec<usize> = Vec::new();
            of_object.extend((0..records.len()).filter(|&number| is_its(&records[number])));
            match wanted {
                Wanted::Nothing => {}
                Wanted::FaceNormal => {
                    for record in records.iter_mut().filter(|record| is_its(record)) {
                        record.values = [object.face_normal(record.face, record.turned); 3];
                    }
                }
                Wanted::FaceColour => self.face_colours(job, object, drawn, records, &of_object)?,
                Wanted::CornerNormals | Wanted::CornerColours => {
                    let lit = self.corner_colours(job, object, drawn, records, &of_object, wanted)?;
                    for (at, &number) in of_object.iter().enumerate() {
                        let record = &mut records[number];
                        let (corners, vertices) = (drawn.list.corners(record.triangle), record.vertices);
                        let value = |k: usize| match (wanted, &object.ink) {
                            (Wanted::CornerNormals, _) => {
                                object.corner_normal(corners[k], vertices[k], record.turned)
                            }
                            (_, Ink::Given(colours)) => single(colours[vertices[k] as usize]),
                            (_, Ink::Lit(_)) => lit[3 * at + k],
                        };
                        record.values = premix(number, [0, 1, 2].map(value));
                    }
                    if job.settings.interpolation == Interpolation::Scanline {
                        self.polygons(job, object, drawn, records, &of_object, wanted)?;
                    }
                }
            }
        }
        Ok(())
    }

    /// The light on the corners of triangles, three each; nothing unless that is what is wanted.
    fn corner_colours(
        &mut self,
        job: &Job,
        object: &Prepared,
        drawn: &DrawnObject,
        records: &[Record],
        of_object: &[usize],
        wanted: Wanted,
    ) -> Result<Vec<Vec3>, RenderError> {
        let Ink::Lit(shader) = &object.ink else { return Ok(Vec::new()) };
        if wanted != Wanted::CornerColours {
            return Ok(Vec::new());
        }
        let points = of_object.iter().flat_map(|&number| {
            let record = &records[number];
            let (corners, vertices) = (drawn.list.corners(record.triangle), record.vertices);
            [0, 1, 2].map(|k| corner_point(job, object, drawn, (corners[k], vertices[k]), record.turned))
        });
        self.light(drawn.object, shader, points)
    }

    /// The colour of each face that is seen, under flat shading.
    fn face_colours(
        &mut self,
        job: &Job,
        object: &Prepared,
        drawn: &DrawnObject,
        records: &mut [Record],
        of_object: &[usize],
    ) -> Result<(), RenderError> {
        let colours: Vec<Vec3> = match &object.ink {
            Ink::Given(colours) => {
                let mean =
                    |&number: &usize| mean_colour(colours, face_corners(object, drawn, &records[number]));
                of_object.iter().map(mean).collect()
            }
            Ink::Lit(shader) if takes_mean(job, object) => {
                let corners = |number: usize| face_corners(object, drawn, &records[number]);
                let points = of_object.iter().flat_map(|&number| {
                    let turned = records[number].turned;
                    corners(number).map(move |corner| corner_point(job, object, drawn, corner, turned))
                });
                let lit = self.light(drawn.object, shader, points)?;
                let mut lit = lit.into_iter();
                let mut mean =
                    |count: usize| lit.by_ref().take(count).map(Vec3::as_dvec3).sum::<DVec3>() / count as f64;
                of_object.iter().map(|&number| mean(corners(number).len()).as_vec3()).collect()
            }
            Ink::Lit(shader) => {
                let points = of_object.iter().map(|&number| centroid(job, object, drawn, &records[number]));
                self.light(drawn.object, shader, points)?
            }
        };
        for (&number, colour) in of_object.iter().zip(colours) {
            records[number].values = [colour; 3];
        }
        Ok(())
    }

    /// The polygons of faces with four corners or more, for the scanline algorithm.
    fn polygons(
        &mut self,
        job: &Job,
        object: &Prepared,
        drawn: &DrawnObject,
        records: &[Record],
        of_object: &[usize],
        wanted: Wanted,
    ) -> Result<(), RenderError> {
        let mut faces: Vec<&Record> = of_object.iter().map(|&number| &records[number]).collect();
        faces.retain(|record| face_corners(object, drawn, record).len() > 3);
        faces.sort_by_key(|record| record.face);
        faces.dedup_by_key(|record| record.face);
        for record in faces {
            let corners: Vec<(u32, u32)> = face_corners(object, drawn, record).collect();
            let values: Vec<Vec3> = match (wanted, &object.ink) {
                (Wanted::CornerNormals, _) => {
                    corners.iter().map(|&(c, v)| object.corner_normal(c, v, record.turned)).collect()
                }
                (_, Ink::Given(colours)) => {
                    corners.iter().map(|&(_, vertex)| single(colours[vertex as usize])).collect()
                }
                (_, Ink::Lit(shader)) => {
                    let point =
                        |&corner: &(u32, u32)| corner_point(job, object, drawn, corner, record.turned);
                    self.light(drawn.object, shader, corners.iter().map(point))?
                }
            };
            let place = |&(_, vertex): &(u32, u32)| drawn.map.view(drawn.points.get(vertex));
            let corners = corners.iter().map(place).zip(values.iter().map(|value| value.as_dvec3()));
            self.polygons.push((record.object, record.face, ScanPolygon::new(&job.view, corners)));
        }
        Ok(())
    }

    /// The light on some points.
    fn light(
        &mut self,
        object: usize,
        shader: &Shader<f32>,
        points: impl Iterator<Item = CornerPoint>,
    ) -> Result<Vec<Vec3>, RenderError> {
        self.points.iter_mut().for_each(Vec::clear);
        for CornerPoint { position, normal } in points {
            let values = [position.x, position.y, position.z, normal.x, normal.y, normal.z];
            self.points.iter_mut().zip(values).for_each(|(row, value)| row.push(value));
        }
        let [x, y, z, nx, ny, nz] = &self.points;
        self.lit.iter_mut().for_each(|row| row.resize(x.len(), 0.0));
        let [r, g, b] = &mut self.lit;
        let rows = SurfaceRows { positions: [x, y, z], normals: [nx, ny, nz] };
        shader.shade_rows(&rows, [r, g, b]).map_err(|error| RenderError::NotFinite { object, error })?;
        Ok((0..x.len()).map(|i| Vec3::new(r[i], g[i], b[i])).collect())
    }

    /// Colours of the samples of one object.
    #[allow(clippy::too_many_arguments, reason = "what a tile is made of, borrowed piece by piece")]
    pub(super) fn paint(
        &mut self,
        job: &Job,
        object: usize,
        seen: &[Seen],
        records: &[Record],
        depth: &[f32],
        hits: Option<&Hits>,
        origin: [i32; 2],
        out: &mut Colours,
    ) -> Result<(), RenderError> {
        let prepared = &job.objects[object];
        let wanted = Wanted::new(job, prepared);
        let shader = match (&prepared.ink, job.settings.show) {
            (Ink::Lit(shader), Show::Shaded) if wanted == Wanted::CornerNormals || prepared.is_cast => {
                Some(shader)
            }
            _ => None,
        };
        let needs_positions = shader.is_some_and(|shader| shader.needs_positions())
            || matches!(job.settings.show, Show::Deviation(_)) && prepared.truth.is_some();
        for seen in seen.chunks(BATCH) {
            let count = seen.len();
            match hits.filter(|_| prepared.is_cast) {
                Some(hits) => self.take_hits(hits, seen),
                None => {
                    self.take_values(job, wanted, seen, records, origin);
                    if needs_positions {
                        num::dispatch(Positions {
                            rays: &job.rays,
                            seen,
                            depth,
                            origin,
                            out: &mut self.positions,
                        });
                    }
                }
            }
            let Self { values, positions, colours, .. } = self;
            match shader {
                Some(shader) => {
                    let rows = SurfaceRows {
                        positions: positions.each_ref().map(|row| &row[..count]),
                        normals: values.each_ref().map(|row| &row[..count]),
                    };
                    let colours = colours.each_mut().map(|row| &mut row[..count]);
                    let error = |error| RenderError::NotFinite { object, error };
                    shader.shade_rows(&rows, colours).map_err(error)?;
                }
                None if job.settings.show == Show::Shaded => {
                    for (colours, values) in colours.iter_mut().zip(values.iter()) {
                        colours[..count].copy_from_slice(&values[..count]);
                    }
                }
                None => {
                    for (lane, seen) in seen.iter().enumerate() {
                        let at = |rows: &[Row; 3]| Vec3::new(rows[0][lane], rows[1][lane], rows[2][lane]);
                        let hit = hits.filter(|_| prepared.is_cast).map(|hits| hits.at(seen.pixel));
                        let sample = show::Sample {
                            record: &records[seen.record as usize],
                            front: hit.map_or(records[seen.record as usize].front, |hit| hit.front),
                            value: at(values),
                            position: at(positions),
                            depth: depth[usize::from(seen.pixel)],
                        };
                        let colour = show::colour(job, prepared, &sample);
                        colours.iter_mut().zip(colour.to_array()).for_each(|(row, c)| row[lane] = c);
                    }
                }
            }
            for (out, colours) in out.iter_mut().zip(colours.iter()) {
                for (seen, &colour) in seen.iter().zip(colours.iter()) {
                    out[usize::from(seen.pixel) % PIXELS] = colour;
                }
            }
        }
        Ok(())
    }

    /// What the corners carry, at the samples.
    fn take_values(
        &mut self,
        job: &Job,
        wanted: Wanted,
        seen: &[Seen],
        records: &[Record],
        origin: [i32; 2],
    ) {
        if !wanted.varies() {
            for (lane, seen) in seen.iter().enumerate() {
                let value = records[seen.record as usize].values[0].to_array();
                self.values.iter_mut().zip(value).for_each(|(row, value)| row[lane] = value);
            }
            return;
        }
        // In a parallel projection the picture is the scene seen from far away: nothing to correct.
        let perspective = job.settings.interpolation == Interpolation::Perspective && job.view.perspective;
        num::dispatch(Interpolate { records, seen, origin, perspective, out: &mut self.values });
        if self.polygons.is_empty() {
            return;
        }
        for (lane, seen) in seen.iter().enumerate() {
            let record = &records[seen.record as usize];
            let key = (record.object, record.face);
            let Ok(found) = self.polygons.binary_search_by_key(&key, |&(object, face, _)| (object, face))
            else {
                continue;
            };
            let [column, row] = place(usize::from(seen.pixel)).map(|n| n as i32);
            let at = [origin[0] + (column << BITS), origin[1] + (row << BITS)];
            let value = self.polygons[found].2.value(at.map(|n| f64::from(n) / f64::from(ONE)));
            self.values.iter_mut().zip(value.to_array()).for_each(|(row, value)| row[lane] = value as f32);
        }
    }

    /// What rays hit.
    fn take_hits(&mut self, hits: &Hits, seen: &[Seen]) {
        for (lane, seen) in seen.iter().enumerate() {
            let hit = hits.at(seen.pixel);
            self.values.iter_mut().zip(hit.normal.to_array()).for_each(|(row, value)| row[lane] = value);
            self.positions.iter_mut().zip(hit.position.to_array()).for_each(|(row, value)| row[lane] = value);
        }
    }
}
