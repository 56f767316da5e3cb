//! Objects made of triangles, ready to be drawn.

use crate::mesh::{Triangulation, triangulate};
use crate::num::parallel;
use crate::num::{self, Split, unit_scale};
use crate::raster::scene::Shape;
use crate::raster::settings::Cull;
use crate::raster::view::project::{Points, ScreenVertex, project};
use crate::raster::view::screen_transform::{ObjectMap, View, ViewPoint};
use glam::{DMat4, DVec3};

/// The triangles of an object and where its vertices are on the picture.
pub(crate) struct DrawnObject<'a> {
    pub(crate) object: usize,
    /// The number of its first triangle, all objects counted through.
    pub(crate) first: u32,
    pub(crate) list: TriangleList<'a>,
    pub(crate) points: Points<'a>,
    pub(crate) vertices: Vec<ScreenVertex>,
    /// The clipping planes that any of them is outside of.
    pub(crate) outside: u32,
    pub(crate) map: ObjectMap,
    /// Whether its transform turns faces inside out.
    pub(crate) mirrored: bool,
}

impl<'a> DrawnObject<'a> {
    /// Cuts and projects the shape of an object, in the memory of other vertices if there is any; `None` for analytic surfaces.
    pub(crate) fn new(
        shape: &Shape<'a>,
        object: usize,
        first: u32,
        transform: DMat4,
        mirrored: bool,
        view: &View,
        spare: &mut Vec<Vec<ScreenVertex>>,
    ) -> Option<Self> {
        let points = shape.points()?;
        let list = match *shape {
            Shape::Mesh { mesh, .. } if mesh.faces().is_triangles() => {
                TriangleList::Whole(mesh.faces().corners().as_chunks().0)
            }
            Shape::Mesh { mesh, .. } => {
                TriangleList::Cut { corner_vertices: mesh.faces().corners(), cut: triangulate(mesh) }
            }
            Shape::Triangles(triangles) => TriangleList::Whole(triangles.triangles),
            Shape::Surface(_) => return None,
        };
        let near = points.iter().next().unwrap_or_default();
        let map = ObjectMap::about(view, transform, near);
        let mut vertices = spare.pop().unwrap_or_default();
        let outside = project(points, &map, view, &mut vertices);
        Some(Self { object, first, list, points, vertices, outside, map, mirrored })
    }

    /// Whether each of so many faces, or a triangle of it, shows the side that is kept. It is computed from vertices
    /// that are not snapped, so that it holds for triangles smaller than a pixel and behind the eye.
    pub(crate) fn kept_faces(&self, count: usize, cull: Cull) -> Vec<bool> {
        let is_kept = |triangle: usize| {
            let [a, b, c] = self.list.vertices(triangle as u32).map(|vertex| {
                let ViewPoint { x, y, h, .. } = self.map.view(self.points.at(vertex));
                DVec3::new(x, y, h)
            });
            // Twice the area on the picture, times all three h. No product overflows.
            let [a, b, c] = [a, b - a, c - a].map(|v| v * unit_scale(v.abs().max_element()));
            let volume = b.cross(c).dot(a);
            volume != 0.0 && cull.keeps((volume < 0.0) != self.mirrored)
        };
        let of_triangles = parallel::map(self.list.len(), is_kept);
        let mut of_faces = vec![false; count];
        for (triangle, is_kept) in of_triangles.into_iter().enumerate() {
            of_faces[self.list.face(triangle as u32) as usize] |= is_kept;
        }
        of_faces
    }

    #[inline(always)]
    pub(crate) fn screen(&self, triangle: u32) -> [&ScreenVertex; 3] {
        let [a, b, c] = self.list.vertices(triangle);
        [&self.vertices[a as usize], &self.vertices[b as usize], &self.vertices[c as usize]]
    }
}

pub(crate) struct PlanePoint {
    /// Its barycentric coordinates in the scene.
    pub(crate) weights: [f64; 3],
    /// Its position relative to the eye, in the scene's axes: on the ray, however far away corners are.
    pub(crate) from_eye: DVec3,
}

impl DrawnObject<'_> {
    /// The point of a triangle's plane at a place of the picture, by homogeneous edge functions, which hold also behind
    /// the eye (Olano & Greer 1997).
    pub(crate) fn plane_point(&self, view: &View, triangle: [u32; 3], at: [f64; 2]) -> PlanePoint {
        let [mx, my] = view.middle();
        let ray = DVec3::new(at[0] - mx, at[1] - my, 1.0);
        let seen = triangle.map(|vertex| self.map.view(self.points.at(vertex)));
        let corners = seen.map(|point| DVec3::new(point.x, point.y, point.h));
        let normals = [0, 1, 2].map(|k| num::cross::<Split>(corners[(k + 1) % 3], corners[(k + 2) % 3]));
        let parts = normals.map(|normal| ray.dot(normal));
        let weights = shares(parts);
        let distance = if view.perspective {
            // The determinant of the corners, by the corner with the smallest products, which lose least.
            let products = [0, 1, 2].map(|k| corners[k] * normals[k]);
            let size = |product: &&DVec3| product.abs().element_sum();
            let least = products.iter().min_by(|a, b| size(a).total_cmp(&size(b)));
            least.map_or(f64::NAN, |product| product.element_sum()) / parts.iter().sum::<f64>()
        } else {
            (0..3).map(|k| seen[k].z * weights[k]).sum()
        };
        let (start, direction) = view.ray(at);
        PlanePoint { weights, from_eye: start + direction * distance }
    }
}

pub(crate) fn shares(parts: [f64; 3]) -> [f64; 3] {
    let sum: f64 = parts.iter().sum();
    parts.map(|part| part / sum)
}

/// Triangles, and what they are parts of.
pub(crate) enum TriangleList<'a> {
    /// Each is a face.
    Whole(&'a [[u32; 3]]),
    /// Polygons have been cut.
    Cut { corner_vertices: &'a [u32], cut: Triangulation },
}

impl TriangleList<'_> {
    pub(crate) fn len(&self) -> usize {
        match self {
            Self::Whole(triangles) => triangles.len(),
            Self::Cut { cut, .. } => cut.triangles.len(),
        }
    }

    #[inline(always)]
    pub(crate) fn vertices(&self, triangle: u32) -> [u32; 3] {
        match self {
            Self::Whole(triangles) => triangles[triangle as usize],
            Self::Cut { corner_vertices, cut } => {
                cut.triangles[triangle as usize].map(|corner| corner_vertices[corner as usize])
            }
        }
    }

    #[inline(always)]
    pub(crate) fn corners(&self, triangle: u32) -> [u32; 3] {
        match self {
            Self::Whole(_) => [0, 1, 2].map(|k| 3 * triangle + k),
            Self::Cut { cut, .. } => cut.triangles[triangle as usize],
        }
    }

    #[inline(always)]
    pub(crate) fn face(&self, triangle: u32) -> u32 {
        match self {
            Self::Whole(_) => triangle,
            Self::Cut { cut, .. } => cut.source_face[triangle as usize],
        }
    }
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Corner {
    pub(crate) number: u32,
    pub(crate) vertex: u32,
    /// Whether its normal is that of the other side.
    pub(crate) turned: bool,
}
