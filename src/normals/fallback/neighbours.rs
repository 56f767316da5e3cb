//! Fallback normals from the faces at a vertex and the edges of a face, without topology.

use crate::mesh::FacesRef;
use crate::normals::faces::positions::{Positions, Source};
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
    positions: Positions,
    vertices: &[u32],
) -> Vec<VertexFallback> {
    if vertices.is_empty() {
        return Vec::new();
    }
    let source = Source::new(positions);
    let mut scalar = CornerTerms::default();
    // (place in `vertices`, normal and state of a face there), in ascending face index.
    let mut found: Vec<(u32, DVec3, FaceState)> = Vec::new();
    for face in 0..faces.len() {
        let mut shape = None;
        for vertex in faces.face(face) {
            let Ok(place) = vertices.binary_search(vertex) else { continue };
            let shape = *shape.get_or_insert_with(|| scalar.shape(faces, &source, face));
            found.push((place as u32, shape.unit, shape.state));
        }
    }
    found.sort_by_key(|&(place, ..)| place);
    let mut found = found.chunk_by(|a, b| a.0 == b.0).peekable();
    let fallback = |(place, &vertex): (usize, &u32)| {
        let faces = found.next_if(|faces| faces[0].0 as usize == place).unwrap_or(&[]);
        let defined: Vec<DVec3> =
            faces.iter().filter(|(.., state)| state.has_direction()).map(|&(_, unit, _)| unit).collect();
        let cause = faces.iter().map(|&(.., state)| state).find(|state| !state.has_direction());
        VertexFallback {
            vertex,
            normal: unit_sum_or_first(&defined),
            cause: cause.unwrap_or_default(),
            referenced: !faces.is_empty(),
        }
    };
    vertices.iter().enumerate().map(fallback).collect()
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
    let mut around: Vec<(u32, DVec3)> = Vec::new();
    for face in 0..faces.len() {
        let Some(normal) = normal(face) else { continue };
        for edge in edges_of(face) {
            let first = edges.partition_point(|&(other, _)| other < edge);
            let same = edges[first..].iter().take_while(|&&(other, _)| other == edge);
            around.extend(same.map(|&(_, place)| (place, normal)));
        }
    }
    around.sort_by_key(|&(place, _)| place);
    let mut around = around.chunk_by(|a, b| a.0 == b.0).peekable();
    (0..without.len())
        .map(|place| {
            let normals = around.next_if(|normals| normals[0].0 as usize == place).unwrap_or(&[]);
            unit_sum_or_first(&normals.iter().map(|&(_, normal)| normal).collect::<Vec<_>>())
        })
        .collect()
}
