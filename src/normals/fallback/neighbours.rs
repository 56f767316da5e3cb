//! Fallback normals from the faces at a vertex and the edges of a face, without topology.

use crate::mesh::{FacesRef, PositionsRef};
use crate::normals::faces::positions::Source;
use crate::normals::faces::shape::FaceState;
use crate::normals::sums::corner_mean::uniform_mean;
use crate::normals::sums::corner_terms::CornerTerms;
use crate::normals::sums::request::SlotState;
use glam::DVec3;

/// The normal of what no face gives one.
pub(crate) const LAST_RESORT: DVec3 = DVec3::Z;

/// The unit sum of some defined normals; if they cancel the first of them by lexicographic value, +Z without any.
pub(crate) fn unit_sum_or_first(normals: &[DVec3]) -> DVec3 {
    let (sum, state) = uniform_mean(normals.iter().copied());
    if state == SlotState::Good {
        return sum;
    }
    normals.iter().copied().min_by(lexicographic).unwrap_or(LAST_RESORT)
}

/// The order by which one of several equivalent normals is chosen.
pub(crate) fn lexicographic(a: &DVec3, b: &DVec3) -> std::cmp::Ordering {
    a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)).then(a.z.total_cmp(&b.z))
}

/// A vertex whose sum has no direction: its fallback normal, and why.
pub(crate) struct VertexFallback {
    /// The vertex.
    pub(crate) vertex: u32,
    /// A unit vector.
    pub(crate) normal: DVec3,
    /// Of the faces at it the first one without direction; [`FaceState::Counted`] if there is no such face.
    pub(crate) cause: FaceState,
    /// Whether any face uses it.
    pub(crate) referenced: bool,
}

/// Looks up the faces of some vertices, given ascending, in one walk over all faces.
pub(crate) fn vertex_fallbacks(
    faces: FacesRef,
    positions: PositionsRef,
    vertices: &[u32],
) -> Vec<VertexFallback> {
    if vertices.is_empty() {
        return Vec::new();
    }
    let source = Source::new(positions);
    let mut scalar = CornerTerms::default();
    // Normal and state of the faces at each, in ascending face index.
    let mut found: Vec<Vec<(DVec3, FaceState)>> = vec![Vec::new(); vertices.len()];
    for face in 0..faces.len() {
        let mut shape = None;
        for vertex in faces.face(face) {
            let Ok(place) = vertices.binary_search(vertex) else { continue };
            let shape = *shape.get_or_insert_with(|| scalar.shape(faces, &source, face));
            found[place].push((shape.unit, shape.state));
        }
    }
    let fallback = |(&vertex, faces): (&u32, Vec<(DVec3, FaceState)>)| {
        let defined: Vec<DVec3> =
            faces.iter().filter(|(_, state)| state.has_direction()).map(|&(unit, _)| unit).collect();
        let cause = faces.iter().map(|&(_, state)| state).find(|state| !state.has_direction());
        VertexFallback {
            vertex,
            normal: unit_sum_or_first(&defined),
            cause: cause.unwrap_or_default(),
            referenced: !faces.is_empty(),
        }
    };
    vertices.iter().zip(found).map(fallback).collect()
}

/// For faces without a normal, given ascending, the unit sum of those of their edge neighbours that have one. Edges are
/// shared where two faces use the same two vertices.
pub(crate) fn neighbour_normals(
    faces: FacesRef,
    without: &[u32],
    normal: impl Fn(usize) -> Option<DVec3>,
) -> Vec<DVec3> {
    let edges_of = |face: usize| {
        let corners = faces.face(face);
        let next = corners.iter().cycle().skip(1);
        corners.iter().zip(next).map(|(&a, &b)| (a.min(b), a.max(b)))
    };
    let mut edges: Vec<((u32, u32), u32)> = Vec::new();
    for (place, &face) in without.iter().enumerate() {
        edges.extend(edges_of(face as usize).map(|edge| (edge, place as u32)));
    }
    edges.sort_unstable();
    edges.dedup();
    let mut around: Vec<Vec<DVec3>> = vec![Vec::new(); without.len()];
    for face in 0..faces.len() {
        let Some(normal) = normal(face) else { continue };
        for edge in edges_of(face) {
            let first = edges.partition_point(|&(other, _)| other < edge);
            let same = edges[first..].iter().take_while(|&&(other, _)| other == edge);
            same.for_each(|&(_, place)| around[place as usize].push(normal));
        }
    }
    around.iter().map(|normals| unit_sum_or_first(normals)).collect()
}
