//! Flat shading as an edit: the simplest normals that split every vertex.

use crease::io::{Part, PartEdit};
use crease::mesh::{Column, Mesh};
use glam::DVec3;

/// The unit vector area of a face about its first corner, which is scaled first; +Z without area.
pub fn face_normal(mesh: &Mesh, face: usize) -> DVec3 {
    let corners: Vec<DVec3> = mesh.faces().face(face).iter().map(|&v| mesh.positions().at(v)).collect();
    let offsets: Vec<DVec3> = corners.iter().map(|corner| *corner - corners[0]).collect();
    let size = offsets.iter().fold(0.0, |m: f64, p| m.max(p.abs().max_element()));
    let area: DVec3 = offsets.windows(2).map(|pair| (pair[0] / size).cross(pair[1] / size)).sum();
    area.try_normalize().unwrap_or(DVec3::Z)
}

pub fn face_normals(mesh: &Mesh) -> Vec<DVec3> {
    (0..mesh.face_count()).map(|face| face_normal(mesh, face)).collect()
}

/// Every corner gets the normal of its face.
pub fn flat(part: &Part) -> PartEdit {
    let normals = face_normals(&part.mesh);
    PartEdit {
        normals: Some(Column::per_corner(normals.clone(), part.mesh.faces().owners())),
        face_normals: Some(normals),
        ..PartEdit::default()
    }
}
