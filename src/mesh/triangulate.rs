//! Polygons cut into triangles, for outputs that cannot hold polygons.

mod polygon;
mod quad;

use super::Mesh;
use crate::num::unit_scale;
use glam::DVec3;

/// The faces of a mesh as triangles.
///
/// A face of `n` corners always gives `n - 2` triangles, which run the same way round as the face and use each
/// of its corners, so that no vertex, no edge of the mesh and no attribute of a corner is lost.
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
/// - A triangle stays as it is. The result for a mesh of triangles is the list of its corners; test
///   [`Faces::is_triangles`](super::Faces::is_triangles) to avoid it.
/// - A quad is cut along the diagonal that leaves two triangles of positive area about the quad's own normal
///   ½(P2−P0)×(P3−P1); at a reflex corner there is only one. Where both do, the Delaunay criterion decides: the
///   diagonal with the smaller sum of the two angles opposite to it. Where these sums agree within 2⁻²⁰ (four
///   corners on a circle, a rectangle above all) the shorter diagonal is taken; where these agree too, the
///   diagonal that ends at the corner whose position is the smallest in lexicographic order, so that a grid of
///   rectangles is cut one way throughout. The choice does not depend on where the list of corners starts.
/// - A polygon of five corners or more gets the constrained Delaunay triangulation of its projection along its
///   vector area, summed relative to the first corner. Corners on a straight edge, holes joined to the outside
///   by a bridge of two coincident edges, and repeated positions are right.
///
/// All polygons together may cost a few seconds; one of many thousand needle-like corners that wants more counts
/// as failed. Scaling all positions by a power of two changes nothing as long as they stay normal numbers.
/// Cost: a few nanoseconds for each triangle, tens for a quad, some microseconds for a larger polygon, n log n
/// in its corners.
pub fn triangulate(mesh: &Mesh) -> Triangulation {
    let faces = mesh.faces();
    let count = faces.corner_count().saturating_sub(2 * faces.len());
    let mut out = Triangulation {
        triangles: Vec::with_capacity(count),
        source_face: Vec::with_capacity(count),
        failed: Vec::new(),
    };
    let mut points = Vec::new();
    let mut budget = polygon::Budget::for_corners(faces.corner_count());
    for (face, range) in faces.ranges().enumerate() {
        let (first, arity) = (range.start as u32, range.len());
        if arity > 3 {
            points.clear();
            points.extend(faces.corners()[range].iter().map(|&v| mesh.positions()[v as usize]));
            if !cut(&mut points, first, &mut budget, &mut out.triangles) {
                out.failed.push(face as u32);
                out.triangles.extend((1..arity as u32 - 1).map(|k| [first, first + k, first + k + 1]));
            }
        } else {
            out.triangles.push([first, first + 1, first + 2]);
        }
        out.source_face.extend(std::iter::repeat_n(face as u32, arity - 2));
    }
    out
}

/// Appends the triangles of one polygon, or nothing if it cannot be done.
fn cut(
    points: &mut [DVec3],
    first: u32,
    budget: &mut polygon::Budget,
    triangles: &mut Vec<[u32; 3]>,
) -> bool {
    // The lexicographic order is that of the stored positions: subtraction may round two apart into one.
    let lowest = quad::lowest(points);
    normalise(points);
    if let [p0, p1, p2, p3] = *points {
        let Some(cut) = quad::cut([p0, p1, p2, p3], lowest) else { return false };
        triangles.extend(cut.map(|triangle| triangle.map(|corner| first + corner)));
        return true;
    }
    let Some(cut) = polygon::cut(points, budget) else { return false };
    debug_assert_eq!(cut.len(), points.len() - 2);
    triangles.extend(cut.iter().map(|triangle| triangle.map(|corner| first + corner)));
    true
}

/// Moves the first point to the origin and scales by a power of two to a size of about one, so that nothing
/// later overflows or underflows. Subtracting first is also what keeps the vector area of a polygon far from the
/// origin right: the terms of a sum about the origin cancel.
fn normalise(points: &mut [DVec3]) {
    rescale(points);
    let origin = points[0];
    points.iter_mut().for_each(|p| *p -= origin);
    rescale(points);
}

/// Multiplies by the power of two that brings the largest coordinate to about one. Twice, because one power of two
/// does not lift a subnormal number so far.
fn rescale(points: &mut [DVec3]) {
    for _ in 0..2 {
        let scale = unit_scale(points.iter().fold(0.0, |m: f64, p| m.max(p.abs().max_element())));
        points.iter_mut().for_each(|p| *p *= scale);
    }
}

#[cfg(test)]
mod tests;
