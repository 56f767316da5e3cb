//! Triangulation of polygons, for outputs that cannot store polygons.

mod polygon;
mod quad;

use super::polygon_mesh::Mesh;
use crate::num::parallel;
use crate::num::unit_scale;
use glam::DVec3;
use polygon::{Budget, Unfit};

/// The faces of a mesh as triangles.
///
/// A face of `n` corners always gives `n - 2` triangles with the winding of the face. They use each of its corners, so that
/// no vertex, no edge of the mesh and no attribute of a corner is lost.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Triangulation {
    /// Three corner numbers of the mesh each, face by face.
    pub triangles: Vec<[u32; 3]>,
    /// The face that each triangle is part of, ascending.
    pub source_face: Vec<u32>,
    /// Faces that could not be triangulated (without area, self-crossing, touching themselves), ascending.
    /// Their triangles are the fan from the first corner.
    pub failed: Vec<u32>,
}

/// Cuts every face into triangles.
///
/// - A triangle stays unchanged. The result for a mesh of triangles is the list of its corners; test
///   [`Faces::is_triangles`](super::Faces::is_triangles) to avoid it.
/// - A quad is cut along the diagonal that leaves two triangles of positive area about the quad's own normal
///   ½(P2−P0)×(P3−P1); at a reflex corner there is only one. Where both do, the Delaunay criterion decides: the
///   diagonal with the smaller sum of the two angles opposite to it. Where these sums agree within 2⁻²⁰ (four
///   corners on a circle, a rectangle above all) the shorter diagonal is taken; where these agree too, the
///   diagonal that ends at the corner whose position is the smallest in lexicographic order, so that a grid of
///   rectangles is cut along parallel diagonals. The choice does not depend on where the list of corners starts.
/// - A polygon of five corners or more has the constrained Delaunay triangulation of its projection along its
///   vector area, summed relative to the first corner. Corners on a straight edge, holes joined to the outside
///   by a bridge of two coincident edges, and repeated positions are right.
///
/// A polygon of many thousand slivers may cost more than a few seconds; it then counts as failed. Scaling all positions by
/// a power of two changes nothing as long as they stay normal numbers.
/// Cost: a few nanoseconds for each triangle, tens for a quad, some microseconds for a larger polygon, n log n
/// in its corners; larger polygons are cut on all threads.
pub fn triangulate(mesh: &Mesh) -> Triangulation {
    let faces = mesh.faces();
    let count = faces.corner_count().saturating_sub(2 * faces.len());
    let mut out = Triangulation {
        triangles: Vec::with_capacity(count),
        source_face: Vec::with_capacity(count),
        failed: Vec::new(),
    };
    let mut polygons = cut_polygons(mesh).into_iter();
    let mut points = Vec::new();
    for (face, range) in faces.ranges().enumerate() {
        let (first, arity) = (range.start as u32, range.len());
        let mut put = |triangles: &[[u32; 3]]| {
            out.triangles.extend(triangles.iter().map(|triangle| triangle.map(|corner| first + corner)));
            triangles.len()
        };
        let put = match arity {
            3 => put(&[[0, 1, 2]]),
            4 => {
                let points = gather(mesh, face, &mut points);
                // Before subtraction, which may round two distinct positions to one.
                let lowest = quad::lowest(points);
                quad::cut(normalise(points), lowest).map_or(0, |cut| put(&cut))
            }
            _ => polygons.next().flatten().map_or(0, |cut| put(&cut)),
        };
        if put == 0 {
            out.failed.push(face as u32);
            out.triangles.extend((1..arity as u32 - 1).map(|k| [first, first + k, first + k + 1]));
        }
        out.source_face.extend(std::iter::repeat_n(face as u32, arity - 2));
    }
    out
}

/// The triangles of each face of five corners or more, by corners of that face; `None` where it cannot be done.
fn cut_polygons(mesh: &Mesh) -> Vec<Option<Vec<[u32; 3]>>> {
    let arity = |face: &usize| mesh.faces().range(*face).len();
    let polygons: Vec<usize> = (0..mesh.face_count()).filter(|face| arity(face) > 4).collect();
    let cut = |face: usize, budget: &mut Budget, points: &mut Vec<DVec3>| {
        gather(mesh, face, points);
        polygon::cut(normalise(points), budget)
    };
    let first = parallel::map_with(polygons.len(), Vec::new, |points, i| {
        let face = polygons[i];
        cut(face, &mut Budget::own(mesh.faces().range(face).len()), points)
    });
    // Polygons that exceed their own budget use the common one, in order, so that the result does not depend on the
    // number of threads.
    let (mut common, mut points) = (Budget::common(), Vec::new());
    let retry = |(result, &face): (Result<_, Unfit>, &usize)| match result {
        Err(Unfit::OverBudget) => cut(face, &mut common, &mut points).ok(),
        result => result.ok(),
    };
    first.into_iter().zip(&polygons).map(retry).collect()
}

/// The positions of a face's corners.
fn gather<'a>(mesh: &Mesh, face: usize, points: &'a mut Vec<DVec3>) -> &'a mut [DVec3] {
    points.clear();
    points.extend(mesh.faces().face(face).iter().map(|&vertex| mesh.positions().at(vertex)));
    points
}

/// Moves the first point to the origin and scales by a power of two to a size of about one, so that nothing later overflows
/// or underflows. Subtraction also keeps the vector area of a polygon far from the origin exact: without it terms cancel.
fn normalise(points: &mut [DVec3]) -> &[DVec3] {
    rescale(points);
    let origin = points[0];
    points.iter_mut().for_each(|p| *p -= origin);
    rescale(points);
    points
}

/// Multiplies by the power of two that brings the largest coordinate to about one. Twice, because one power of two is not
/// enough for subnormal numbers.
fn rescale(points: &mut [DVec3]) {
    for _ in 0..2 {
        let scale = unit_scale(points.iter().fold(0.0, |m: f64, p| m.max(p.abs().max_element())));
        points.iter_mut().for_each(|p| *p *= scale);
    }
}

#[cfg(test)]
mod tests;
