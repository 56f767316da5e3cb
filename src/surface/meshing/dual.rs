//! The dual of a net of triangles.

use crate::mesh::{Faces, Topology};
use crate::surface::error::SurfaceError;
use crate::surface::meshing::net::Net;
use crate::surface::shapes::chart::Sample;
use glam::DVec2;
use rayon::prelude::*;

/// One polygon round each vertex that is not on an open side, its corners above the middles of the triangles there.
pub(in crate::surface) fn net(
    triangles: &Net,
    sample: impl Fn(usize, DVec2) -> Result<Sample, SurfaceError> + Sync,
) -> Result<Net, SurfaceError> {
    let topology = Topology::by_index(&triangles.faces, triangles.samples.len());
    let mut faces = Faces::with_capacity(triangles.faces.corner_count());
    let mut ring = Vec::new();
    // Triangles that are corners of a polygon, numbered in the order in which they are met.
    let (mut number, mut used) = (vec![u32::MAX; triangles.faces.len()], Vec::new());
    for vertex in 0..triangles.samples.len() as u32 {
        if !fan(&topology, vertex, &mut ring) {
            continue;
        }
        for face in &mut ring {
            let number = &mut number[*face as usize];
            if *number == u32::MAX {
                *number = used.len() as u32;
                used.push(*face as usize);
            }
            *face = *number;
        }
        faces.push(&ring);
    }
    let middle = |&face: &usize| (face, triangles.middle(face));
    let samples: Result<Vec<Sample>, SurfaceError> =
        used.par_iter().map(middle).map(|(face, at)| sample(face, at)).collect();
    let samples = samples?;
    let parameters = faces.corners().iter().map(|&corner| triangles.middle(used[corner as usize])).collect();
    Ok(Net { samples, faces, corner_parameters: parameters, first_faces: Vec::new() })
}

/// The faces round a vertex, counter-clockwise; whether they close.
fn fan(topology: &Topology, vertex: u32, ring: &mut Vec<u32>) -> bool {
    ring.clear();
    let Some(&first) = topology.corners_at(vertex).first() else { return false };
    let mut corner = first;
    loop {
        ring.push(topology.face_of(corner));
        match topology.across(topology.previous(corner)) {
            None => return false,
            Some(next) if next == first => return true,
            Some(next) => corner = next,
        }
    }
}
