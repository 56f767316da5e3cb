//! What there is to draw.

use crate::mesh::Mesh;
use crate::normals::NormalField;
use crate::num::LinearRgb;
use crate::raster::settings::LineStyle;
use crate::raster::view::camera::Camera;
use crate::shade::{Light, Material};
use crate::surface::Primitive;
use glam::{DMat4, DVec3};
use std::borrow::Cow;

/// Objects, lights and a camera.
#[derive(Clone, Debug)]
pub struct Scene<'a> {
    /// What is seen. Where two are equally near, the earlier one shows.
    pub objects: Vec<Object<'a>>,
    /// Lines beside those of [`Shading::Wireframe`](crate::raster::Shading::Wireframe): overlays.
    pub lines: Vec<Lines>,
    /// What lights them.
    pub lights: Vec<Light>,
    /// Where they are seen from.
    pub camera: Camera,
    /// What is seen where there is nothing.
    pub background: LinearRgb,
}

/// One shape with one paint.
#[derive(Clone, Debug)]
pub struct Object<'a> {
    /// Its form, in its own space.
    pub shape: Shape<'a>,
    /// From its own space to the scene's: any affine map that can be undone. Mirrored objects stay lit from the right
    /// side: normals go through the inverse transpose, and front faces stay front faces.
    pub transform: DMat4,
    /// Its colour.
    pub paint: Paint<'a>,
    /// The analytic surface that the shape stands for, in the same space: what
    /// [`Shading::Exact`](crate::raster::Shading::Exact) draws and deviations are measured from.
    pub surface: Option<Primitive>,
}

impl<'a> Object<'a> {
    /// A shape where it is, in a material.
    pub fn new(shape: Shape<'a>, material: Material) -> Self {
        Self { shape, transform: DMat4::IDENTITY, paint: Paint::Lit(material), surface: None }
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
    /// The unit normal of each triangle: for flat shading, and to measure deviations from. May be empty if nothing
    /// asks for it.
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
    /// Smallest and largest corner of the box around all that is drawn, in the scene's space; `None` if nothing is.
    /// Vertices that no face uses do not count, nor do lines along objects.
    pub fn bounds(&self) -> Option<(DVec3, DVec3)> {
        let mut bounds: Option<(DVec3, DVec3)> = None;
        self.each_point(|point| {
            let (low, high) = bounds.unwrap_or((point, point));
            bounds = Some((low.min(point), high.max(point)));
        });
        bounds
    }

    /// Visits all points between which something is drawn, in the scene's space; of analytic surfaces the corners of
    /// the box around them.
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
                    positions.iter().zip(used).filter(|(_, used)| *used).for_each(|(&point, _)| visit(point));
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

/// The corners of a box about the origin.
pub(super) fn corners(half: DVec3) -> [DVec3; 8] {
    [0, 1, 2, 3, 4, 5, 6, 7].map(|signs: u32| {
        let sign = |bit: u32| if signs >> bit & 1 == 0 { -1.0 } else { 1.0 };
        half * DVec3::new(sign(0), sign(1), sign(2))
    })
}

/// Which vertices the corners of faces use.
fn used(corners: &[u32], vertices: usize) -> Vec<bool> {
    let mut used = vec![false; vertices];
    for &vertex in corners {
        if let Some(used) = used.get_mut(vertex as usize) {
            *used = true;
        }
    }
    used
}
