//! Edges of more than two faces, and edges where the surface folds back.

use crate::mesh::{Link, place_key};
use crate::num::parallel;
use crate::quality::findings::prelude::*;
use rayon::prelude::*;

pub(crate) fn check_folds(facts: &Facts<'_>, face: usize, folded: Limit, found: &mut Found) {
    for half_edge in facts.corners_of(face) {
        if let Some(across) = facts.across_once(half_edge as u32)
            && let other = facts.topology.face_of(across) as usize
            && facts.area[face] > 0.0
            && facts.area[other] > 0.0
            && let Some(angle) = folded.exceeded(facts.face_normal(face), facts.face_normal(other))
        {
            found.add(Kind::Folded, Spot::corner(face, half_edge, angle), 0.0);
        }
    }
}

/// Finds edges of more than two faces, each once.
pub(crate) fn search_non_manifold(facts: &Facts<'_>, found: &mut Found) {
    let corners = facts.mesh.faces().corners();
    let key = |vertex: u32| place_key(facts.mesh.positions().at(vertex));
    let ends = |half_edge: usize| {
        let half_edge = half_edge as u32;
        let (tail, head) = facts.topology.ends(corners, half_edge);
        let [a, b] = match facts.topology.link(half_edge) {
            // By index where it is an edge by index, else by position.
            Link::NonManifold => [[u64::from(tail); 3], [u64::from(head); 3]],
            Link::Ambiguous => [key(tail), key(head)],
            _ => return None,
        };
        Some(([a.min(b), a.max(b)], half_edge))
    };
    let mut edges = parallel::filter_map(corners.len(), ends);
    edges.par_sort_unstable();
    for edge in edges.chunk_by(|a, b| a.0 == b.0) {
        let half_edge = edge[0].1 as usize;
        let spot = Spot::corner(facts.face_of(half_edge), half_edge, 0.0);
        found.add(Kind::NonManifold, spot.of(Measure::Amount, edge.len() as f64), 0.0);
    }
}

/// The largest dihedral angle in degrees between two of the faces at an edge, whichever way they run.
pub(crate) fn largest_dihedral_angle(facts: &Facts<'_>, half_edge: u32) -> f64 {
    let vertices = facts.mesh.faces().corners();
    let ends = |half_edge: u32| {
        let (tail, head) = facts.topology.ends(vertices, half_edge);
        [tail, head].map(|vertex| place_key(facts.mesh.positions().at(vertex)))
    };
    let [tail, head] = ends(half_edge);
    let normals = parallel::filter_map(vertices.len(), |other| {
        let other = other as u32;
        let normal = || facts.face_normal(facts.topology.face_of(other) as usize);
        match ends(other) {
            same if same == [tail, head] => Some(normal()),
            back if back == [head, tail] => Some(-normal()),
            _ => None,
        }
    });
    // From one face into another the two run the edge opposite ways.
    let pairs = normals.iter().enumerate().flat_map(|(i, a)| normals[i + 1..].iter().map(move |b| (*a, -*b)));
    pairs.map(|(a, b)| degrees_between(a, b)).fold(0.0, f64::max)
}
