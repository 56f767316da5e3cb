//! Light on corners and faces: on points that are not samples.

use crate::num::{self, Kernel, Lanes, parallel};
use crate::raster::coverage::records::ValueKind;
use crate::raster::coverage::triangles::{Corner, DrawnObject};
use crate::raster::error::{RenderError, Result};
use crate::raster::frame::job::{Job, Prepared};
use crate::raster::shading::surface_colour::{ObjectColour, Shaders};
use crate::raster::view::project::Points;
use crate::raster::view::screen_transform::{ObjectMap, REACH};
use crate::shade::SurfaceRows;
use glam::{DVec3, Vec3};

#[derive(Clone, Copy)]
pub(crate) struct Lit<'a> {
    pub(crate) job: &'a Job<'a>,
    pub(crate) object: &'a Prepared<'a>,
    pub(crate) drawn: &'a DrawnObject<'a>,
    pub(crate) shaders: &'a Shaders,
}

/// Lights points and keeps its memory.
#[derive(Default)]
pub(crate) struct PointLight {
    vertices: Vec<u32>,
    /// Where the vertices of each point end, if points are means of several.
    ends: Vec<usize>,
    positions: [Vec<f32>; 3],
    normals: [Vec<f32>; 3],
    colours: [Vec<f32>; 3],
    /// Which point each corner asked for is.
    point_of: Vec<u32>,
    /// What each point is, for corners.
    known: Vec<Known>,
    /// The point of a corner by the low bits of its entry, if that point is known to be of the corner.
    memo: Vec<u32>,
}

#[derive(Clone, Copy, PartialEq)]
struct Known {
    entry: u32,
    vertex: u32,
    turned: bool,
}

/// Corners remembered; a forgotten one is lit a second time.
const MEMO: usize = 4096;

impl PointLight {
    /// Lights corners of faces with their normals; [`colour`](Self::colour) then has the light on each.
    pub(crate) fn corners(&mut self, lit: &Lit, corners: impl Iterator<Item = Corner>) -> Result<()> {
        self.clear();
        self.known.clear();
        self.memo.resize(MEMO, 0);
        corners.for_each(|corner| {
            let Corner { number, vertex, turned } = corner;
            let known = Known { entry: lit.object.entry(number, vertex), vertex, turned };
            let point = &mut self.memo[known.entry as usize % MEMO];
            if self.known.get(*point as usize) != Some(&known) {
                *point = self.known.len() as u32;
                self.known.push(known);
                self.vertices.push(vertex);
                let normal = lit.object.corner_normal(corner).to_array();
                self.normals.iter_mut().zip(normal).for_each(|(row, component)| row.push(component));
            }
            self.point_of.push(*point);
        });
        self.place(lit);
        self.light(lit)
    }

    /// Lights a range of vertices that have one normal each, and writes the light on them.
    fn vertices(&mut self, lit: &Lit, range: std::ops::Range<u32>, out: &mut [Vec3]) -> Result<()> {
        self.clear();
        self.vertices.extend(range.clone());
        for vertex in range {
            let corner = Corner { number: 0, vertex, turned: false };
            let normal = lit.object.corner_normal(corner).to_array();
            self.normals.iter_mut().zip(normal).for_each(|(row, component)| row.push(component));
        }
        self.place(lit);
        self.light(lit)?;
        let [red, green, blue] = &self.colours;
        for (((out, &red), &green), &blue) in out.iter_mut().zip(red).zip(green).zip(blue) {
            *out = Vec3::new(red, green, blue);
        }
        Ok(())
    }

    /// Lights one point for each face: the mean of its corners, with the face's normal.
    pub(crate) fn faces<C: Iterator<Item = Corner>>(
        &mut self,
        lit: &Lit,
        faces: impl Iterator<Item = (C, Vec3)>,
    ) -> Result<()> {
        self.clear();
        for (corners, normal) in faces {
            self.vertices.extend(corners.map(|corner| corner.vertex));
            self.point_of.push(self.ends.len() as u32);
            self.ends.push(self.vertices.len());
            self.normals.iter_mut().zip(normal.to_array()).for_each(|(row, component)| row.push(component));
        }
        self.place(lit);
        if lit.shaders.needs_positions() {
            for row in &mut self.positions {
                let mut from = 0;
                // In place: a face has three corners or more, so a mean never overtakes what it is of.
                for (face, &end) in self.ends.iter().enumerate() {
                    let sum: f32 = row[from..end].iter().sum();
                    row[face] = sum / (end - from) as f32;
                    from = end;
                }
                row.truncate(self.ends.len());
            }
        }
        self.light(lit)
    }

    #[inline(always)]
    pub(crate) fn colour(&self, number: usize) -> Vec3 {
        let point = self.point_of[number] as usize;
        let [red, green, blue] = &self.colours;
        Vec3::new(red[point], green[point], blue[point])
    }

    fn clear(&mut self) {
        self.vertices.clear();
        self.ends.clear();
        self.point_of.clear();
        self.positions.iter_mut().chain(&mut self.normals).for_each(Vec::clear);
    }

    fn place(&mut self, lit: &Lit) {
        if lit.shaders.needs_positions() {
            let count = self.vertices.len();
            self.positions.iter_mut().for_each(|row| row.resize(count, 0.0));
            let out = self.positions.each_mut().map(|row| &mut row[..]);
            let per_unit = 1.0 / lit.job.frame.unit;
            let DrawnObject { points, map, .. } = lit.drawn;
            num::dispatch(FromOrigin { points: *points, map, per_unit, vertices: &self.vertices, out });
        }
    }

    /// Brings points farther away than [`REACH`] nearer to the view's origin, on the way to it.
    fn bring_into_reach(&mut self) {
        let is_far = |row: &Vec<f32>| row.iter().any(|x| x.abs() > REACH);
        if !self.positions.iter().any(is_far) {
            return;
        }
        let [x, y, z] = &mut self.positions;
        for ((x, y), z) in x.iter_mut().zip(y).zip(z) {
            let largest = x.abs().max(y.abs()).max(z.abs());
            if largest > REACH {
                for coordinate in [x, y, z] {
                    *coordinate = *coordinate / largest * REACH;
                }
            }
        }
    }

    fn light(&mut self, lit: &Lit) -> Result<()> {
        self.bring_into_reach();
        let count = self.normals[0].len();
        self.colours.iter_mut().for_each(|row| row.resize(count, 0.0));
        let rows = SurfaceRows {
            positions: self.positions.each_ref().map(|row| &row[..]),
            normals: self.normals.each_ref().map(|row| &row[..]),
            faces: None,
        };
        let colours = self.colours.each_mut().map(|row| &mut row[..]);
        let exactly = |point| exactly(lit, vertices_of(&self.vertices, &self.ends, point));
        let object = lit.drawn.object;
        let done = lit.shaders.shade_rows(&rows, colours, exactly);
        done.map_err(|error| RenderError::NotFinite { object, error })
    }
}

/// Vertices that one task lights.
const TASK: usize = 4096;

/// The light on all vertices of objects that are shaded at vertices, if of so many triangles most are drawn: in order of vertices this
/// is faster than tile by tile. What fails is left to the tiles, which light only what is visible.
pub(crate) fn light_in_advance(job: &Job, drawn_triangles: u64) -> Vec<Option<Vec<Vec3>>> {
    let vertices: usize = job.drawn.iter().map(|object| object.vertices.len()).sum();
    let are_most_visible = 2 * drawn_triangles >= vertices as u64;
    job.drawn.iter().map(|drawn| are_most_visible.then(|| lit_vertices(job, drawn)).flatten()).collect()
}

/// The light on every vertex of an object that is shaded at vertices which have one normal each; `None` for others, and if a vertex,
/// which may not be visible, has no finite colour.
fn lit_vertices(job: &Job, drawn: &DrawnObject) -> Option<Vec<Vec3>> {
    let object = &job.objects[drawn.object];
    let ObjectColour::Lit(shaders) = &object.colour else { return None };
    if ValueKind::new(object) != ValueKind::CornerColours || !object.has_vertex_normals() {
        return None;
    }
    let mut colours = vec![Vec3::ZERO; drawn.vertices.len()];
    let lit = Lit { job, object, drawn, shaders };
    let done = parallel::map_chunks_with(&mut colours, TASK, PointLight::default, |light, task, out| {
        let first = task * TASK;
        light.vertices(&lit, first as u32..(first + out.len()) as u32, out)
    });
    done.into_iter().all(|done| done.is_ok()).then_some(colours)
}

/// The vertices that a point is the mean of.
fn vertices_of<'a>(vertices: &'a [u32], ends: &[usize], point: usize) -> &'a [u32] {
    match ends.get(point) {
        Some(&end) => &vertices[point.checked_sub(1).map_or(0, |before| ends[before])..end],
        None => &vertices[point..=point],
    }
}

/// The mean of some vertices as shaders take it, before anything is rounded.
fn exactly(lit: &Lit, vertices: &[u32]) -> DVec3 {
    let place = |&vertex: &u32| lit.drawn.map.scene_point(lit.drawn.points.at(vertex)) / lit.job.frame.unit;
    vertices.iter().map(place).sum::<DVec3>() / vertices.len() as f64
}

/// Positions of vertices relative to the view's origin, as shaders take them.
struct FromOrigin<'a> {
    points: Points<'a>,
    map: &'a ObjectMap,
    per_unit: f64,
    vertices: &'a [u32],
    out: [&'a mut [f32]; 3],
}

const LANES: usize = 32;

/// The largest coordinate in single precision that leaves room for sums over the corners of a face.
const LARGEST: f64 = 1e30;

impl Kernel for FromOrigin<'_> {
    type Output = ();

    #[inline(always)]
    fn run<A: Lanes>(self, _: A) {
        let Self { points, map, per_unit, vertices, out: [out_x, out_y, out_z] } = self;
        let mut rows = [[0.0; LANES]; 3];
        for (block, vertices) in vertices.chunks(LANES).enumerate() {
            for (lane, &vertex) in vertices.iter().enumerate().take(LANES) {
                let point = points.at(vertex);
                (rows[0][lane], rows[1][lane], rows[2][lane]) = (point.x, point.y, point.z);
            }
            let mut single = [[0.0; LANES]; 3];
            for lane in 0..LANES {
                let point = DVec3::new(rows[0][lane], rows[1][lane], rows[2][lane]);
                let from_origin = map.scene_point(point) * per_unit;
                let largest = from_origin.abs().max_element();
                let from_origin = from_origin * if largest > LARGEST { LARGEST / largest } else { 1.0 };
                single[0][lane] = from_origin.x as f32;
                single[1][lane] = from_origin.y as f32;
                single[2][lane] = from_origin.z as f32;
            }
            let range = block * LANES..block * LANES + vertices.len();
            out_x[range.clone()].copy_from_slice(&single[0][..vertices.len()]);
            out_y[range.clone()].copy_from_slice(&single[1][..vertices.len()]);
            out_z[range].copy_from_slice(&single[2][..vertices.len()]);
        }
    }
}
