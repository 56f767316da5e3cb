//! The triangles of a mesh, by the primitives that they become.

use crate::io::Note;
use crate::mesh::{ColumnIndex, Mesh, NONE, triangulate};
use rustc_hash::FxHashMap;

#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Group {
    pub label: u32,
    pub flat: bool,
}

/// The corners of the triangles of each primitive; `None` for every corner of the mesh in order.
pub fn groups(mesh: &Mesh, notes: &mut Vec<Note>) -> Vec<(Group, Option<Vec<u32>>)> {
    let faces = mesh.face_count();
    // Corner numbers, three a triangle, and the face of each; `None` if the faces are triangles already.
    let triangles = (!mesh.faces().is_triangles()).then(|| {
        let cut = triangulate(mesh);
        if let Some(first) = cut.failed.first() {
            let text = format!("without area or with crossing edges cut into fans (first: face {first})");
            notes.extend(Note::counted(cut.failed.len(), ["polygon", "polygons"], text));
        }
        (cut.triangles, cut.source_face)
    });
    if faces == 0 {
        return Vec::new();
    }
    let flat = faces_without_normals(mesh);
    let labels = mesh.columns().materials.as_ref();
    let of_face = |face: u32| Group {
        label: labels.map_or(NONE, |labels| labels.of_face[face as usize]),
        flat: flat.as_ref().is_some_and(|flat| flat[face as usize]),
    };
    let first = of_face(0);
    if (1..faces as u32).all(|face| of_face(face) == first) {
        return vec![(first, triangles.map(|(corners, _)| corners.into_flattened()))];
    }
    let mut groups: Vec<(Group, Option<Vec<u32>>)> = Vec::new();
    let mut numbers: FxHashMap<Group, usize> = FxHashMap::default();
    for triangle in 0..triangles.as_ref().map_or(faces, |(_, faces)| faces.len()) {
        let (face, corners) = match &triangles {
            None => (triangle as u32, [0, 1, 2].map(|k| (3 * triangle + k) as u32)),
            Some((corners, faces)) => (faces[triangle], corners[triangle]),
        };
        let group = of_face(face);
        let number = *numbers.entry(group).or_insert_with(|| {
            groups.push((group, Some(Vec::new())));
            groups.len() - 1
        });
        groups[number].1.iter_mut().for_each(|all| all.extend(corners));
    }
    groups
}

/// Which faces have a corner without a normal; `None` if all have all or no normals are there at all.
fn faces_without_normals(mesh: &Mesh) -> Option<Vec<bool>> {
    let ColumnIndex::PerCorner(index) = &mesh.columns().normals.as_ref()?.index else { return None };
    let is_flat = |range: std::ops::Range<usize>| index[range].contains(&NONE);
    index.contains(&NONE).then(|| mesh.faces().ranges().map(is_flat).collect())
}
