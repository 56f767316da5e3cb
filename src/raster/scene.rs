//! What there is to draw.

use super::camera::Camera;
use super::settings::LineStyle;
use crate::mesh::Mesh;
use crate::normals::NormalField;
use crate::num::LinearRgb;
use crate::shade::{Light, Material};
use crate::surface::Primitive;
use glam::{DMat4, DVec3};
use std::borrow::Cow;

/// Objects, lights and a camera.
#[derive(Clone, Debug)]
pub struct Scene<'a> {
    /// What is seen. Where two are equally near, the earlier one shows.
    pub objects: Vec<Object<'a>>,
    /// Lines beside those of [`Shading::Wireframe`](super::Shading::Wireframe): overlays.
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
    /// [`Shading::Exact`](super::Shading::Exact) draws and deviations are measured from.
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
#[derive(Clone, Debug, Default)]
pub struct Lines {
    /// Where they begin and end, in the scene's space.
    pub points: Vec<DVec3>,
    /// Two points each.
    pub segments: Vec<[u32; 2]>,
    /// What they look like. A line in a surface counts as in front of it.
    pub style: LineStyle,
}

impl Scene<'_> {
    /// Smallest and largest corner of the box around all that is drawn, in the scene's space; `None` if nothing is.
    /// Vertices that no face uses do not count.
    pub fn bounds(&self) -> Option<(DVec3, DVec3)> {
        let objects = self.objects.iter().flat_map(|object| {
            let map = move |point: DVec3| object.transform.transform_point3(point);
            let (low, high) = match &object.shape {
                Shape::Mesh { mesh, .. } => {
                    let positions = mesh.positions();
                    bounds(mesh.faces().corners().iter().map(|&vertex| map(positions[vertex as usize])))?
                }
                Shape::Triangles(triangles) => {
                    let corners = triangles.triangles.as_flattened().iter();
                    let points = corners.filter_map(|&vertex| triangles.positions.get(vertex as usize));
                    bounds(points.map(|point| map(DVec3::from(point.map(f64::from)))))?
                }
                Shape::Surface(primitive) => {
                    let signs = [-1.0, 1.0];
                    let corners = signs.into_iter().flat_map(|x| signs.map(|y| [x, y]));
                    let corners = corners.flat_map(|[x, y]| signs.map(|z| DVec3::new(x, y, z)));
                    bounds(corners.map(|corner| map(corner * primitive.half_extents())))?
                }
            };
            Some([low, high])
        });
        let lines = self.lines.iter().flat_map(|lines| lines.points.iter().copied());
        bounds(objects.flatten().chain(lines))
    }
}

fn bounds(mut points: impl Iterator<Item = DVec3>) -> Option<(DVec3, DVec3)> {
    let first = points.next()?;
    Some(points.fold((first, first), |(low, high), point| (low.min(point), high.max(point))))
}
