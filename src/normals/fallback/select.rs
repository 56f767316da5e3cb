//! The normals of a mesh: stored ones and computed ones, combined by a policy.

use crate::mesh::{Column, Mesh, NONE};
use crate::normals::fallback::replace::{Broken, Replacement, When, replace};
use crate::normals::field::NormalField;
use crate::num::UnitVec3;
use glam::DVec3;

/// Normals as they are written and drawn, on the faces of the mesh that they were computed for.
#[derive(Clone, Debug, PartialEq)]
pub struct Selection {
    /// One index a corner: first the stored values, untouched and in their order, then those that replace some of
    /// them: computed ones, and stored ones that were divided by their length.
    pub normals: Column<DVec3>,
    /// How many values, from the front, are stored ones.
    pub kept: usize,
    /// For each morph target, one normal a value.
    pub morph_normals: Vec<Vec<DVec3>>,
    /// One normal a face: the stored one where all corners of a face share it and keep its direction, as those of an
    /// STL file do, else the computed one.
    pub face_normals: Vec<DVec3>,
    /// Corners that had no normal, unless all were to be replaced.
    pub missing: Vec<u32>,
    /// Corners whose normal was broken, and why, unless all were to be replaced.
    pub broken: Vec<(u32, Broken)>,
}

impl Selection {
    /// Whether every corner keeps its stored normal.
    pub fn is_as_stored(&self, when: When) -> bool {
        when != When::Always && self.missing.is_empty() && self.broken.is_empty()
    }
}

/// Puts the normals stored in a mesh and those computed for it together.
///
/// ```
/// use crease::io::{Format, ReadOptions, read_bytes};
/// use crease::normals::{NormalRecipe, When, compute, select};
/// use glam::DVec3;
///
/// let one_of_three = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0.6 0 0.8\nf 1//1 2 3\n";
/// let loaded = read_bytes(one_of_three.to_vec(), Some(Format::Obj), None, &ReadOptions::default())?;
/// let mesh = &loaded.parts[0].mesh;
/// let selection = select(mesh, compute(mesh, &NormalRecipe::default()), When::Missing);
/// assert_eq!(selection.normals.get(0, 0), Some(&DVec3::new(0.6, 0.0, 0.8)));
/// assert_eq!((selection.normals.get(1, 1), selection.missing), (Some(&DVec3::Z), vec![1, 2]));
/// # Ok::<(), crease::io::ReadError>(())
/// ```
pub fn select(mesh: &Mesh, field: NormalField, when: When) -> Selection {
    if when == When::Always {
        let NormalField { normals, morph_normals, face_normals, .. } = field;
        let (missing, broken) = (Vec::new(), Vec::new());
        return Selection { normals, kept: 0, morph_normals, face_normals, missing, broken };
    }
    let replacement = replace(mesh, &field, when);
    let morph_normals = morph_normals(mesh, &field, &replacement);
    let face_normals = face_normals(mesh, &field, &replacement);
    let Replacement { normals, kept, missing, broken, .. } = replacement;
    Selection { normals, kept, morph_normals, face_normals, missing, broken }
}

/// The normals of morphed shapes for every value: that of its entry, or, for a stored value, of the entry of the
/// first corner that uses it. A stored value that no corner uses keeps its direction.
fn morph_normals(mesh: &Mesh, field: &NormalField, replacement: &Replacement) -> Vec<Vec<DVec3>> {
    if field.morph_normals.is_empty() {
        return Vec::new();
    }
    let mut entry_of_value = vec![NONE; replacement.kept];
    entry_of_value.extend_from_slice(&replacement.entries);
    for (corner, &vertex) in mesh.faces().corners().iter().enumerate().rev() {
        let value =
            replacement.normals.slot(corner, vertex).filter(|&value| (value as usize) < replacement.kept);
        if let (Some(value), Some(entry)) = (value, field.normals.slot(corner, vertex)) {
            entry_of_value[value as usize] = entry;
        }
    }
    let direction = |stored: DVec3| UnitVec3::new(stored).map_or(DVec3::Z, UnitVec3::get);
    let of_shape = |shape: &Vec<DVec3>| {
        let entries = entry_of_value.iter().zip(&replacement.normals.values);
        let normal =
            |(&entry, &stored)| shape.get(entry as usize).copied().unwrap_or_else(|| direction(stored));
        entries.map(normal).collect()
    };
    field.morph_normals.iter().map(of_shape).collect()
}

fn face_normals(mesh: &Mesh, field: &NormalField, replacement: &Replacement) -> Vec<DVec3> {
    let corners = mesh.faces().corners();
    let stored = |range: std::ops::Range<usize>| {
        let mut slots = range.map(|corner| replacement.normals.slot(corner, corners[corner]));
        let first = slots.next()?.filter(|&slot| replacement.is_stored(slot))?;
        slots.all(|slot| slot == Some(first)).then(|| replacement.normals.values[first as usize])
    };
    let ranges = mesh.faces().ranges().zip(&field.face_normals);
    ranges.map(|(range, &computed)| stored(range).unwrap_or(computed)).collect()
}

impl NormalField {
    /// The field with the normals that [`select`] chooses in the place of its own, for code that draws or measures what
    /// a file would have. The vertex of a value that several use is the first one that does; that of a stored value
    /// that none uses is 0.
    pub fn selected(self, mesh: &Mesh, when: When) -> NormalField {
        if when == When::Always {
            return self;
        }
        let (faults, summary) = (self.faults.clone(), self.summary);
        let Selection { normals, morph_normals, face_normals, .. } = select(mesh, self, when);
        let mut entry_vertex = vec![0; normals.values.len()];
        for (corner, &vertex) in mesh.faces().corners().iter().enumerate().rev() {
            if let Some(slot) = normals.slot(corner, vertex) {
                entry_vertex[slot as usize] = vertex;
            }
        }
        NormalField { normals, entry_vertex, face_normals, morph_normals, faults, summary }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{ColumnIndex, Columns, Faces, MeshBuilder};
    use crate::normals::compute::compute;
    use crate::normals::recipe::NormalRecipe;

    /// Two triangles: the first has a normal of its own at all corners, the second at one corner.
    fn mesh() -> Mesh {
        let normals =
            Some(Column::per_corner(vec![DVec3::X, DVec3::new(0.6, 0.0, 0.8)], vec![1, 1, 1, 0, NONE, NONE]));
        MeshBuilder {
            positions: vec![DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.0), DVec3::Y].into(),
            faces: Faces::triangles(vec![0, 1, 2, 0, 2, 3]),
            columns: Columns { normals, ..Columns::default() },
        }
        .build()
        .unwrap()
    }

    #[test]
    fn faces_take_the_normal_that_all_their_corners_share() {
        let mesh = mesh();
        let field = compute(&mesh, &NormalRecipe::default());
        let kept = select(&mesh, field.clone(), When::Missing);
        assert_eq!(kept.face_normals, [DVec3::new(0.6, 0.0, 0.8), DVec3::Z]);
        let mut longer = mesh.columns().normals.clone().unwrap();
        longer.values.iter_mut().for_each(|normal| *normal *= 4.0);
        let scaled = select(&mesh.clone().with_normals(Some(longer)), field.clone(), When::Broken);
        assert!(scaled.face_normals[0].distance(DVec3::new(0.6, 0.0, 0.8)) < 1e-15);
        assert_eq!(scaled.face_normals[1], DVec3::Z);
        assert_eq!((&kept.missing[..], kept.is_as_stored(When::Missing)), (&[4, 5][..], false));
        let all = select(&mesh, field.clone(), When::Always);
        assert_eq!((all.face_normals.clone(), all.kept), (vec![DVec3::Z; 2], 0));
        assert_eq!(field.clone().selected(&mesh, When::Always), field);
    }

    #[test]
    fn a_field_takes_over_what_is_selected() {
        let mesh = mesh();
        let taken = compute(&mesh, &NormalRecipe::default()).selected(&mesh, When::Missing);
        let ColumnIndex::PerCorner(index) = &taken.normals.index else { panic!("per corner") };
        assert_eq!(index[..4], [1, 1, 1, 0]);
        assert_eq!(taken.normals.get(3, 0), Some(&DVec3::X));
        // Stored value 0 is used by vertex 0, value 1 first by vertex 0; the computed ones by vertices 2 and 3.
        assert_eq!(taken.entry_vertex, [0, 0, 2, 3]);
    }
}
