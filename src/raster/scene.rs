//! Objects, lights and lines to draw.

use crate::mesh::Mesh;
use crate::normals::NormalField;
use crate::num::LinearRgb;
use crate::raster::settings::{LineStyle, ObjectSettings};
use crate::raster::view::camera::Camera;
use crate::raster::view::project::Points;
use crate::shade::{Light, Material, Optics};
use crate::surface::Primitive;
use glam::{DMat4, DVec3};
use rayon::prelude::*;
use std::borrow::Cow;

/// Objects, lights and a camera.
#[derive(Clone, Debug)]
pub struct Scene<'a> {
    /// The visible objects. Of two that are equally near the earlier one shows.
    pub objects: Vec<Object<'a>>,
    /// Lines in addition to those of [`Shading::Wireframe`](crate::raster::Shading::Wireframe): overlays.
    pub lines: Vec<Lines>,
    /// The lights.
    pub lights: Vec<Light>,
    /// The camera.
    pub camera: Camera,
    /// The colour where no object is visible.
    pub background: LinearRgb,
}

/// One shape with one paint.
#[derive(Clone, Debug)]
pub struct Object<'a> {
    /// Its form, in its own space.
    pub shape: Shape<'a>,
    /// From its own space to the scene's: any invertible affine map. Normals are multiplied by the inverse transpose;
    /// front faces of mirrored objects stay front faces.
    pub transform: DMat4,
    /// Its colour.
    pub paint: Paint<'a>,
    /// The analytic surface that the shape approximates, in the same space: what
    /// [`Shading::Exact`](crate::raster::Shading::Exact) draws and deviations are measured from.
    pub surface: Option<Primitive>,
    /// Reflection and transmission, for [`Shading::Traced`](crate::raster::Shading::Traced) only.
    pub optics: Optics,
    /// Settings of its own.
    pub settings: ObjectSettings,
}

impl<'a> Object<'a> {
    /// A shape at its own position, in a material.
    pub fn new(shape: Shape<'a>, material: Material) -> Self {
        Self {
            shape,
            transform: DMat4::IDENTITY,
            paint: Paint::Lit(material),
            surface: None,
            optics: Optics::NONE,
            settings: ObjectSettings::default(),
        }
    }
}

/// The form of an object.
#[derive(Clone, Debug)]
pub enum Shape<'a> {
    /// A polygon mesh and normals computed or replaced for it.
    Mesh {
        /// The polygons.
        mesh: &'a Mesh,
        /// Their normals.
        normals: &'a NormalField,
    },
    /// Triangles from a caller's own arrays.
    Triangles(Triangles<'a>),
    /// An analytic surface, always drawn exactly.
    Surface(Primitive),
}

/// Triangles in single precision, as engines keep them. The same code draws them as draws meshes.
#[derive(Clone, Copy, Debug)]
pub struct Triangles<'a> {
    /// Finite positions.
    pub positions: &'a [[f32; 3]],
    /// Three vertices each, counter-clockwise as seen from the front.
    pub triangles: &'a [[u32; 3]],
    /// The unit normal of each vertex.
    pub normals: &'a [[f32; 3]],
    /// The unit normal of each triangle, for flat shading and deviations; else it may be empty.
    pub face_normals: &'a [[f32; 3]],
}

/// Where the colour of an object comes from.
#[derive(Clone, Debug)]
pub enum Paint<'a> {
    /// From a material under the scene's lights.
    Lit(Material),
    /// Given for each vertex and interpolated unlit, as exercises 1.6.24 and 1.6.25 of the lectures prescribe.
    Given(Cow<'a, [LinearRgb]>),
}

/// Straight lines in the scene: overlays of edges, creases, normals.
#[derive(Clone, Debug)]
pub struct Lines {
    /// Where they begin and end.
    pub path: LinePath,
    /// What they look like. A line in a surface counts as in front of it.
    pub style: LineStyle,
}

/// Where lines begin and end. Those along an object take their places from it: a dense mesh has millions.
#[derive(Clone, Debug)]
pub enum LinePath {
    /// Between points.
    Points {
        /// In the scene's space.
        points: Vec<DVec3>,
        /// Two points each.
        segments: Vec<[u32; 2]>,
    },
    /// Between vertices of an object, two each.
    Edges {
        /// Its number.
        object: usize,
        /// The vertices.
        edges: Vec<[u32; 2]>,
    },
    /// From vertices of an object along normals.
    VertexNormals {
        /// Its number.
        object: usize,
        /// A vertex and the number of a normal each.
        normals: Vec<[u32; 2]>,
        /// How long they are in the scene.
        length: f64,
    },
    /// From the middle of each face of an object along its normal.
    FaceNormals {
        /// Its number.
        object: usize,
        /// How long they are in the scene.
        length: f64,
    },
}

impl Scene<'_> {
    /// The smallest and the largest corner of the bounding box of all that is drawn, in the scene's space, without
    /// unused vertices and lines along objects. `None` if nothing is drawn.
    pub fn bounds(&self) -> Option<(DVec3, DVec3)> {
        let mut bounds: Option<(DVec3, DVec3)> = None;
        self.each_point(|point| {
            let (low, high) = bounds.unwrap_or((point, point));
            bounds = Some((low.min(point), high.max(point)));
        });
        bounds
    }

    /// Visits all used points in the scene's space; of analytic surfaces the corners of their boxes.
    pub(super) fn each_point(&self, mut visit: impl FnMut(DVec3)) {
        self.each_point_of(|_| true, &mut visit);
    }

    /// The same of some of the objects.
    pub(super) fn each_point_of(&self, wanted: impl Fn(&Object) -> bool, visit: &mut dyn FnMut(DVec3)) {
        for Object { shape, transform, .. } in self.objects.iter().filter(|object| wanted(object)) {
            let mut visit = |point: DVec3| visit(transform.transform_point3(point));
            match shape {
                Shape::Mesh { mesh, .. } => {
                    let positions = mesh.positions();
                    let used = used(mesh.faces().corners(), positions.len());
                    positions.iter().zip(used).filter(|(_, used)| *used).for_each(|(point, _)| visit(point));
                }
                Shape::Triangles(Triangles { positions, triangles, .. }) => {
                    let points = positions.iter().map(|point| DVec3::from(point.map(f64::from)));
                    let used = used(triangles.as_flattened(), positions.len());
                    points.zip(used).filter(|(_, used)| *used).for_each(|(point, _)| visit(point));
                }
                Shape::Surface(primitive) => {
                    corners(primitive.half_extents()).into_iter().for_each(&mut visit);
                }
            }
        }
        for lines in &self.lines {
            if let LinePath::Points { points, .. } = &lines.path {
                points.iter().for_each(|&point| visit(point));
            }
        }
    }
}

pub(super) fn corners(half: DVec3) -> [DVec3; 8] {
    [0, 1, 2, 3, 4, 5, 6, 7].map(|signs: u32| {
        let sign = |bit: u32| if signs >> bit & 1 == 0 { -1.0 } else { 1.0 };
        half * DVec3::new(sign(0), sign(1), sign(2))
    })
}

fn used(corners: &[u32], vertices: usize) -> Vec<bool> {
    let mut used = vec![false; vertices];
    for &vertex in corners {
        if let Some(used) = used.get_mut(vertex as usize) {
            *used = true;
        }
    }
    used
}

impl<'a> Shape<'a> {
    /// How many faces there are; an analytic surface has none.
    pub fn face_count(&self) -> usize {
        match self {
            Shape::Mesh { mesh, .. } => mesh.face_count(),
            Shape::Triangles(triangles) => triangles.triangles.len(),
            Shape::Surface(_) => 0,
        }
    }

    pub(crate) fn face(&self, face: u32) -> &'a [u32] {
        match *self {
            Shape::Mesh { mesh, .. } => mesh.faces().face(face as usize),
            Shape::Triangles(triangles) => &triangles.triangles[face as usize],
            Shape::Surface(_) => &[],
        }
    }

    pub(crate) fn faces(&self) -> impl Iterator<Item = &'a [u32]> {
        (0..self.face_count() as u32).map(|face| self.face(face))
    }

    /// The edges of the faces, each once: two vertices, the lower one first, in ascending order.
    pub fn edges(&self) -> Vec<[u32; 2]> {
        self.edges_of(|_| true)
    }

    /// The edges of those faces that are wanted, by their numbers; likewise.
    pub(crate) fn edges_of(&self, wanted: impl Fn(usize) -> bool) -> Vec<[u32; 2]> {
        let faces = || self.faces().enumerate().filter(|&(number, _)| wanted(number)).map(|(_, face)| face);
        // As many as there are corners, before each is left once: no room is taken twice.
        let mut edges = Vec::with_capacity(faces().map(<[u32]>::len).sum());
        for face in faces() {
            let next = face.iter().cycle().skip(1);
            edges.extend(face.iter().zip(next).map(|(&a, &b)| [a.min(b), a.max(b)]));
        }
        edges.par_sort_unstable();
        edges.dedup();
        edges.shrink_to_fit();
        edges
    }

    pub(crate) fn points(&self) -> Option<Points<'a>> {
        match *self {
            Shape::Mesh { mesh, .. } => Some(mesh.positions()),
            Shape::Triangles(triangles) => Some(Points::F32(triangles.positions)),
            Shape::Surface(_) => None,
        }
    }

    /// Where a vertex is, in the object's own space; the origin for an analytic surface, which has none.
    ///
    /// # Panics
    /// If there is no vertex of this number.
    pub fn point(&self, vertex: u32) -> DVec3 {
        self.points().map_or(DVec3::ZERO, |points| points.at(vertex))
    }

    /// The normals of vertices; an analytic surface has none.
    pub(crate) fn normals(&self) -> Points<'a> {
        match *self {
            Shape::Mesh { normals, .. } => Points::F64(&normals.normals.values),
            Shape::Triangles(triangles) => Points::F32(triangles.normals),
            Shape::Surface(_) => Points::F64(&[]),
        }
    }

    /// The normals of faces: of all, or of none.
    pub(crate) fn face_normals(&self) -> Points<'a> {
        match *self {
            Shape::Mesh { normals, .. } => Points::F64(&normals.face_normals),
            Shape::Triangles(triangles) => Points::F32(triangles.face_normals),
            Shape::Surface(_) => Points::F64(&[]),
        }
    }

    /// The vertices with the numbers of their normals, in ascending order, each pair once: several for a vertex where smooth
    /// groups meet, of a mesh none for one that no face uses. What [`LinePath::VertexNormals`](crate::raster::LinePath::VertexNormals) takes.
    ///
    /// ```
    /// use crease::raster::{Shape, Triangles};
    ///
    /// let positions = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    /// let triangles = Triangles { positions: &positions, triangles: &[[0, 1, 2]], normals: &[[0.0, 0.0, 1.0]; 3], face_normals: &[] };
    /// assert_eq!(Shape::Triangles(triangles).vertex_normals(), [[0, 0], [1, 1], [2, 2]]);
    /// ```
    pub fn vertex_normals(&self) -> Vec<[u32; 2]> {
        match *self {
            Shape::Mesh { mesh, normals } => normals_in_use(mesh, normals),
            Shape::Triangles(Triangles { normals, .. }) => {
                (0..normals.len() as u32).map(|n| [n, n]).collect()
            }
            Shape::Surface(_) => Vec::new(),
        }
    }
}

fn normals_in_use(mesh: &Mesh, normals: &NormalField) -> Vec<[u32; 2]> {
    let corners = mesh.faces().corners();
    let mut pairs = Vec::with_capacity(corners.len());
    let slot = |(corner, &vertex): (usize, &u32)| Some([vertex, normals.normals.slot(corner, vertex)?]);
    pairs.extend(corners.iter().enumerate().filter_map(slot));
    pairs.par_sort_unstable();
    pairs.dedup();
    pairs.shrink_to_fit();
    pairs
}
