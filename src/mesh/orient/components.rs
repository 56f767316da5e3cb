//! Connected components, and which faces of each have the opposite winding to the others.

use crate::mesh::faces::is_collapsed;
use crate::mesh::link::Link;
use crate::mesh::polygon_mesh::Mesh;
use crate::mesh::topology::Topology;
use std::cmp::Ordering;

/// The components of a mesh: faces connected over edges that join exactly two of them.
///
/// A face of fewer than three distinct positions that is joined to nothing is in no component.
pub(super) struct Components {
    /// Faces, component after component, ascending within each.
    faces: Vec<u32>,
    /// Where each component starts in `faces`, with the total at the end.
    starts: Vec<u32>,
    /// Of each face: whether it runs against the lowest face of its component.
    pub(super) against: Vec<bool>,
    /// Of each component: whether its faces can all be made to agree.
    pub(super) orientable: Vec<bool>,
}

impl Components {
    /// Walks over every component once, breadth first, from its lowest face.
    pub(super) fn find(mesh: &Mesh, topology: &Topology) -> Self {
        let count = mesh.face_count();
        let mut reached = vec![false; count];
        let mut against = vec![false; count];
        // Both the queue of the walk and its result.
        let mut faces: Vec<u32> = Vec::with_capacity(count);
        let (mut starts, mut orientable) = (vec![0], Vec::new());
        for seed in 0..count {
            if reached[seed] {
                continue;
            }
            reached[seed] = true;
            let (start, mut head, mut agree) = (faces.len(), faces.len(), true);
            faces.push(seed as u32);
            while let Some(&face) = faces.get(head) {
                head += 1;
                for half_edge in mesh.faces().range(face as usize) {
                    let (across, turned) = match topology.link(half_edge as u32) {
                        Link::Twin(across) | Link::Welded(across) => (across, false),
                        Link::Inconsistent(across) => (across, true),
                        _ => continue,
                    };
                    let other = topology.face_of(across) as usize;
                    let other_against = against[face as usize] ^ turned;
                    if !reached[other] {
                        reached[other] = true;
                        against[other] = other_against;
                        faces.push(other as u32);
                    } else {
                        agree &= against[other] == other_against;
                    }
                }
            }
            let places = || mesh.faces().face(seed).iter().map(|&v| mesh.position(v));
            if faces.len() == start + 1 && is_collapsed(places()) {
                faces.pop();
                continue;
            }
            faces[start..].sort_unstable();
            starts.push(faces.len() as u32);
            orientable.push(agree);
        }
        Self { faces, starts, against, orientable }
    }

    pub(super) fn len(&self) -> usize {
        self.orientable.len()
    }

    /// The faces of a component, ascending.
    pub(super) fn faces(&self, component: usize) -> &[u32] {
        &self.faces[self.starts[component] as usize..self.starts[component + 1] as usize]
    }

    /// The faces of a component that run against its lowest one, or the others.
    pub(super) fn side(&self, component: usize, against: bool) -> impl Iterator<Item = u32> {
        let faces = self.faces(component).iter().copied();
        faces.filter(move |&face| self.against[face as usize] == against)
    }

    /// Whether so many faces are more than half of a component.
    pub(super) fn is_majority(&self, component: usize, count: usize) -> bool {
        2 * count > self.faces(component).len()
    }

    /// Whether at most half of the faces of a component that count run against its lowest one; all count if none does.
    pub(super) fn agrees_with_lowest(&self, component: usize, counts: impl Fn(u32) -> bool) -> bool {
        let faces = self.faces(component);
        let all_count = !faces.iter().any(|&face| counts(face));
        let (mut against, mut all) = (0, 0);
        for &face in faces.iter().filter(|&&face| all_count || counts(face)) {
            against += usize::from(self.against[face as usize]);
            all += 1;
        }
        2 * against <= all
    }

    /// Whether an orientable component has no boundary: once its faces agree, its half-edges cancel at every edge.
    ///
    /// At an edge of more than two faces (two boxes that touch along an edge) only the component's own faces
    /// count. Edges of no length count nowhere.
    pub(super) fn is_closed(&self, component: usize, mesh: &Mesh, topology: &Topology) -> bool {
        let mut crowded = Vec::new();
        for &face in self.faces(component) {
            for half_edge in mesh.faces().range(face as usize) {
                let half_edge = half_edge as u32;
                match topology.link(half_edge) {
                    Link::NonManifold | Link::Ambiguous => crowded.push(half_edge),
                    Link::Boundary => {
                        let (tail, head) = topology.ends(mesh.faces().corners(), half_edge);
                        if mesh.position(tail) != mesh.position(head) {
                            return false;
                        }
                    }
                    Link::Twin(_) | Link::Welded(_) | Link::Inconsistent(_) | Link::Collapsed => {}
                }
            }
        }
        // An edge by its positions, lower end first, and whether the surface runs along it upwards.
        let edge = |half_edge: u32| {
            let (tail, head) = topology.ends(mesh.faces().corners(), half_edge);
            let (tail, head) = (mesh.position(tail).to_array(), mesh.position(head).to_array());
            let up = tail < head;
            let against = self.against[topology.face_of(half_edge) as usize];
            (if up { (tail, head) } else { (head, tail) }, up ^ against)
        };
        let compare = |a: u32, b: u32| edge(a).0.partial_cmp(&edge(b).0).unwrap_or(Ordering::Equal);
        crowded.sort_unstable_by(|&a, &b| compare(a, b));
        crowded.chunk_by(|&a, &b| compare(a, b).is_eq()).all(|half_edges| {
            let up = half_edges.iter().filter(|&&half_edge| edge(half_edge).1).count();
            2 * up == half_edges.len()
        })
    }
}
