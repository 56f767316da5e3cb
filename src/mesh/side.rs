//! On which side of faces their stored normals lie.

use super::{Column, Mesh};
use crate::num::{UnitVec3, unit_scale};
use glam::DVec3;

/// Whether more than half of the stored normals at some faces point against their face, each of which comes with whether it
/// counts as turned round; `None` if there are none, or all are the same and say nothing of any side. What is flat has one normal
/// by right: that of its faces, or their opposite.
pub(crate) fn normals_oppose(mesh: &Mesh, faces: impl Iterator<Item = (u32, bool)>) -> Option<bool> {
    let stored = mesh.columns().normals.as_ref()?;
    let scale = unit_scale(mesh.bounds().map_or(0.0, |(low, high)| (high - low).max_element()));
    let (mut against, mut all, mut first, mut is_constant) = (0usize, 0usize, None, true);
    let (mut side, mut is_flat) = (None, true);
    for (face, is_turned) in faces {
        let area = vector_area(mesh, face as usize, scale) * if is_turned { -1.0 } else { 1.0 };
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

/// Whether two unit vectors are one, as far as a mesh whose normals are all the same goes.
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
    let corners = mesh.faces().face(face);
    let place = |vertex: u32| mesh.positions()[vertex as usize];
    let first = place(corners[0]);
    let spokes = corners[1..]
        .windows(2)
        .map(|pair| ((place(pair[0]) - first) * scale).cross((place(pair[1]) - first) * scale));
    spokes.sum::<DVec3>() * 0.5
}
