//! Where something was found, in the numbers of the mesh as it was read.

use super::faces::Turned;
use crate::mesh::Mesh;
use crate::normals::{Broken, Fault, FaultReason, Faults};

/// The most places that are kept of each kind of element. Counts are always complete.
pub const MOST_PLACES: usize = 100;

/// An element of a mesh as it was read; all numbers count from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Spot {
    /// A face.
    Face(u32),
    /// A vertex.
    Vertex(u32),
    /// A corner of a face.
    #[serde(untagged)]
    Corner {
        /// The face.
        face: u32,
        /// Which of the face's corners.
        corner: u32,
        /// The vertex at the corner.
        vertex: u32,
    },
}

/// The first faults of each kind of element: faces, corners, vertices, [`MOST_PLACES`] of each.
pub(super) fn of_faults(turned: &Turned<'_>, read: &Mesh, faults: &Faults) -> Vec<(Spot, FaultReason)> {
    let first = |list: &[Fault]| list.iter().take(MOST_PLACES).copied().collect::<Vec<_>>();
    let corners = first(&faults.corners);
    let corners = corners.iter().zip(of_corners(turned, read, corners.iter().map(|fault| fault.index)));
    let corners = corners.map(|(fault, spot)| (spot, fault.reason));
    let faces = first(&faults.faces);
    let numbers = turned.as_read(faces.iter().map(|fault| fault.index));
    let faces = faces.iter().zip(numbers).map(|(fault, face)| (Spot::Face(face), fault.reason));
    let vertices = first(&faults.vertices).into_iter().map(|fault| (Spot::Vertex(fault.index), fault.reason));
    faces.chain(corners).chain(vertices).collect()
}

/// The first corners whose stored normals are broken.
pub(super) fn of_broken(turned: &Turned<'_>, read: &Mesh, broken: &[(u32, Broken)]) -> Vec<(Spot, Broken)> {
    let first = &broken[..broken.len().min(MOST_PLACES)];
    let spots = of_corners(turned, read, first.iter().map(|&(corner, _)| corner));
    spots.into_iter().zip(first).map(|(spot, &(_, cause))| (spot, cause)).collect()
}

/// Corners of the turned mesh, ascending.
fn of_corners(turned: &Turned<'_>, read: &Mesh, corners: impl Iterator<Item = u32>) -> Vec<Spot> {
    let mut ranges = turned.mesh.faces().ranges().enumerate();
    let mut current = ranges.next();
    let within: Vec<(u32, u32)> = corners
        .filter_map(|corner| {
            while current.as_ref().is_some_and(|(_, range)| range.end <= corner as usize) {
                current = ranges.next();
            }
            current.as_ref().map(|(face, range)| (*face as u32, corner - range.start as u32))
        })
        .collect();
    let faces = turned.as_read(within.iter().map(|&(face, _)| face));
    let spot = |(&(_, place), face): (&(u32, u32), u32)| {
        let vertices = read.faces().face(face as usize);
        let corner = match place {
            // The first corner of a turned face stays the first.
            1.. if turned.reverses(face) => vertices.len() as u32 - place,
            place => place,
        };
        Spot::Corner { face, corner, vertex: vertices[corner as usize] }
    };
    within.iter().zip(faces).map(spot).collect()
}
