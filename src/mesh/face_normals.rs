//! Vector areas of faces, and the stored normals compared with them.

use super::columns::Column;
use super::polygon_mesh::Mesh;
use crate::num::{UnitVec3, unit_scale};
use glam::DVec3;

/// Whether more than half of the stored normals at some faces point against their face; each face comes with whether it
/// counts as reversed. `None` if there are no normals, or if all are the same and not, as on a flat surface, those of the
/// faces or their opposites.
pub(crate) fn normals_oppose(mesh: &Mesh, faces: impl Iterator<Item = (u32, bool)>) -> Option<bool> {
    let stored = mesh.columns().normals.as_ref()?;
    let scale = unit_scale(mesh.extent());
    let (mut against, mut all, mut first, mut is_constant) = (0usize, 0usize, None, true);
    let (mut side, mut is_flat) = (None, true);
    for (face, is_reversed) in faces {
        let area = vector_area(mesh, face as usize, scale) * if is_reversed { -1.0 } else { 1.0 };
        let direction = UnitVec3::new(area).map(UnitVec3::get);
        for unit in mesh.faces().range(face as usize).filter_map(|corner| stored_unit(stored, mesh, corner)) {
            is_constant &= are_same(*first.get_or_insert(unit), unit);
            is_flat &= direction.is_none_or(|direction| {
                let side = *side.get_or_insert(unit.dot(direction).signum());
                are_same(unit, direction * side)
            });
            all += 1;
            against += usize::from(unit.dot(area) < 0.0);
        }
    }
    let is_along = is_flat && side.is_some();
    (!is_constant || is_along).then_some(2 * against > all)
}

/// Whether two unit vectors count as the same constant normal.
pub(crate) fn are_same(a: DVec3, b: DVec3) -> bool {
    a.dot(b) > 0.9999
}

/// The direction of the value that a corner has in a column of normals.
pub(crate) fn stored_unit(stored: &Column<DVec3>, mesh: &Mesh, corner: usize) -> Option<DVec3> {
    let normal = *stored.get(corner, mesh.faces().corners()[corner])?;
    UnitVec3::new(normal).map(UnitVec3::get)
}

/// The vector area of a face: half the sum of the cross products of its edges, from its first corner.
pub(crate) fn vector_area(mesh: &Mesh, face: usize, scale: f64) -> DVec3 {
    let cross = |triangle: [u32; 3]| {
        let [a, b, c] = triangle.map(|vertex| mesh.position(vertex));
        ((b - a) * scale).cross((c - a) * scale)
    };
    mesh.faces().fan(face as u32).map(cross).sum::<DVec3>() * 0.5
}
