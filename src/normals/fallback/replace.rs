//! Replacing single normals that are missing or broken, and leaving the good ones alone to the bit.

use crate::mesh::{Column, ColumnIndex, Mesh, NONE};
use crate::normals::fault::{FaultReason, Faults};
use crate::normals::field::NormalField;
use crate::num::{UnitVec3, names};
use glam::DVec3;
use rustc_hash::FxHashMap;

/// Which stored normals are replaced.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum When {
    /// All.
    #[default]
    Always,
    /// Missing ones, and those that are not finite: no format can store them.
    Missing,
    /// Missing ones and broken ones: see [`Broken`].
    Broken,
}

/// Most by which the length of a stored normal may differ from 1: the bound of the official glTF validator, a
/// little over what rounding to 8 bits does (0.006687).
pub const LENGTH_TOLERANCE: f64 = 0.00674;

/// Within this distance a stored normal is the computed one, as some format rounded it: eight bits move a unit
/// vector by at most √3/254 = 0.00682.
const ROUNDED: f64 = 0.00683;

/// What is wrong with a stored normal: the first of these that applies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Broken {
    /// It is infinite or not a number.
    NotFinite,
    /// It is zero, and has no direction.
    Zero,
    /// It points more than 90° away from the normal of its own face, whatever its length. Faces that add nothing to sums are not
    /// checked: their own direction means nothing. Nor is a normal that equals its replacement: around a sharp fold a mean may
    /// point behind one of its faces.
    AgainstFace,
    /// Only its length is wrong, by more than [`LENGTH_TOLERANCE`]: the normal is divided by it, and keeps its direction, which a
    /// computed normal may not have.
    Length,
}

names! { Broken: NotFinite = "NotFinite", Zero = "Zero", AgainstFace = "AgainstFace", Length = "Length" }

/// Stored normals with some replaced; see [`Selection`](crate::normals::Selection).
pub(super) struct Replacement {
    pub(super) normals: Column<DVec3>,
    pub(super) kept: usize,
    /// For each value past `kept`, the entry of the [`NormalField`] that it is, or that the first of its corners has
    /// there if it is `scaled`.
    pub(super) entries: Vec<u32>,
    /// The values past `kept`, ascending, that are stored ones divided by their length.
    pub(super) scaled: Vec<u32>,
    pub(super) missing: Vec<u32>,
    pub(super) broken: Vec<(u32, Broken)>,
}

impl Replacement {
    /// Whether a value has the direction of a stored one.
    pub(super) fn is_stored(&self, value: u32) -> bool {
        (value as usize) < self.kept || self.scaled.binary_search(&value).is_ok()
    }
}

/// Replaces the stored normals of single corners where the policy says so: by computed ones, or by themselves divided
/// by their length where nothing else is wrong.
///
/// The computed ones are those of the whole mesh: all faces contribute to them, whether or not their corners
/// have good normals. Replacing twice gives the same as replacing once. Without the field's
/// [`face_normals`](NormalField::face_normals), no normal counts as turned against its face.
pub(super) fn replace(mesh: &Mesh, field: &NormalField, when: When) -> Replacement {
    let corners = mesh.faces().corners();
    let stored = mesh.columns().normals.as_ref().filter(|_| when != When::Always);
    let ColumnIndex::PerCorner(entry_of) = &field.normals.index else {
        unreachable!("a field has one index a corner");
    };
    let mut values = stored.map_or_else(Vec::new, |stored| stored.values.clone());
    let kept = values.len();
    let (mut entries, mut scaled) = (Vec::new(), Vec::new());
    let mut computed_at = vec![NONE; field.normals.values.len()];
    let mut scaled_at = FxHashMap::default();
    let (mut missing, mut broken) = (Vec::new(), Vec::new());
    let mut silent = silent_faces(&field.faults).peekable();
    let mut index = Vec::with_capacity(corners.len());
    for (face, range) in mesh.faces().ranges().enumerate() {
        let is_silent = silent.next_if_eq(&(face as u32)).is_some();
        let own = field.face_normals.get(face).copied().filter(|_| !is_silent);
        for corner in range {
            let slot = stored.and_then(|stored| stored.slot(corner, corners[corner]));
            let entry = entry_of[corner];
            let computed = field.normals.values[entry as usize];
            let (cause, value) = match slot.map(|slot| fault(values[slot as usize], own, computed)) {
                Some(Some((cause, value))) if when == When::Broken || cause == Broken::NotFinite => {
                    (Some(cause), value)
                }
                None => (None, computed),
                Some(_) => {
                    index.extend(slot);
                    continue;
                }
            };
            match cause {
                Some(cause) => broken.push((corner as u32, cause)),
                None => missing.push(corner as u32),
            }
            let is_scaled = cause == Some(Broken::Length);
            let place = match slot {
                Some(slot) if is_scaled => scaled_at.entry(slot).or_insert(NONE),
                _ => &mut computed_at[entry as usize],
            };
            if *place == NONE {
                *place = values.len() as u32;
                scaled.extend(is_scaled.then_some(*place));
                values.push(value);
                entries.push(entry);
            }
            index.push(*place);
        }
    }
    Replacement { normals: Column::per_corner(values, index), kept, entries, scaled, missing, broken }
}

/// The faces that add nothing to sums, ascending.
fn silent_faces(faults: &Faults) -> impl Iterator<Item = u32> + '_ {
    let adds_nothing = [FaultReason::ZeroArea, FaultReason::BelowStorage, FaultReason::OutOfRange];
    faults.faces.iter().filter(move |fault| adds_nothing.contains(&fault.reason)).map(|fault| fault.index)
}

/// What is wrong with a stored normal at a corner of a face with this normal, and what replaces it: the computed one, or
/// what it is itself at unit length.
fn fault(stored: DVec3, face: Option<DVec3>, computed: DVec3) -> Option<(Broken, DVec3)> {
    if !stored.is_finite() {
        return Some((Broken::NotFinite, computed));
    }
    let is_long = (stored.length() - 1.0).abs() > LENGTH_TOLERANCE;
    let shaded = match is_long.then(|| UnitVec3::new(stored)) {
        Some(Some(unit)) => unit.get(),
        Some(None) => return Some((Broken::Zero, computed)),
        None => stored,
    };
    if face.is_some_and(|face| shaded.dot(face) < 0.0) && shaded.distance(computed) > ROUNDED {
        Some((Broken::AgainstFace, computed))
    } else {
        is_long.then_some((Broken::Length, shaded))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Columns, Faces, MeshBuilder};
    use crate::normals::compute::compute;
    use crate::normals::recipe::NormalRecipe;

    fn square(normals: Option<Column<DVec3>>) -> Mesh {
        MeshBuilder {
            positions: vec![DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.0), DVec3::Y].into(),
            faces: Faces::triangles(vec![0, 1, 2, 0, 2, 3]),
            columns: Columns { normals, ..Columns::default() },
        }
        .build()
        .unwrap()
    }

    fn keeps_all(mesh: &Mesh, field: &NormalField) -> bool {
        let replaced = replace(mesh, field, When::Broken);
        replaced.missing.is_empty() && replaced.broken.is_empty()
    }

    #[test]
    fn only_what_is_missing_or_broken_is_replaced() {
        let good = DVec3::new(0.6, 0.0, 0.8);
        let stored = vec![good, DVec3::NAN, DVec3::ZERO, DVec3::NEG_Z, DVec3::Z * 1.006];
        let mesh = square(Some(Column::per_corner(stored, vec![0, 1, 2, 3, 4, NONE])));
        let field = compute(&mesh, &NormalRecipe::default());

        let missing = replace(&mesh, &field, When::Missing);
        assert_eq!((missing.missing, missing.broken), (vec![5], vec![(1, Broken::NotFinite)]));
        assert_eq!(missing.normals.index, ColumnIndex::PerCorner(vec![0, 5, 2, 3, 4, 6]));

        let broken = replace(&mesh, &field, When::Broken);
        let causes = [(1, Broken::NotFinite), (2, Broken::Zero), (3, Broken::AgainstFace)];
        assert_eq!((&broken.missing[..], &broken.broken[..]), (&[5][..], &causes[..]));
        assert_eq!(broken.kept, 5);
        assert_eq!(broken.normals.get(0, 0), Some(&good));
        assert!([1, 2, 3, 5].iter().all(|&corner| broken.normals.get(corner, 0) == Some(&DVec3::Z)));

        // Once replaced, nothing is left to replace.
        let again = square(Some(broken.normals));
        assert!(keeps_all(&again, &compute(&again, &NormalRecipe::default())));
    }

    /// Authored directions are kept if their length is wrong, at any scale, once for each value that is used.
    #[test]
    fn wrong_lengths_are_divided_by() {
        let made = DVec3::new(0.6, 0.0, 0.8);
        for length in [5e-324, 1e-300, 1e-6, 0.5, 1.01, 3.0, 1e300] {
            let stored = vec![made * length, DVec3::new(-0.6, 0.0, -0.8) * length, DVec3::Z];
            let mesh = square(Some(Column::per_corner(stored, vec![0, 1, 2, 2, 0, 0])));
            let field = compute(&mesh, &NormalRecipe::default());
            let replaced = replace(&mesh, &field, When::Broken);
            let length_of = [0, 4, 5].map(|corner| (corner, Broken::Length));
            let causes = [length_of[0], (1, Broken::AgainstFace), length_of[1], length_of[2]];
            assert_eq!(replaced.broken, causes, "{length}");
            assert_eq!((replaced.normals.values.len(), &replaced.scaled[..]), (5, &[3][..]), "{length}");
            // Of the smallest numbers a component keeps few bits.
            let off = replaced.normals.get(0, 0).unwrap().distance(made);
            assert!(off < if length < 1e-320 { 0.6 } else { 1e-15 }, "{length}: {off}");
            assert!((1..6).all(|c| replaced.normals.get(c, 0).is_some_and(|n| n.dot(DVec3::Z) > 0.5)));

            let again = square(Some(replaced.normals));
            assert!(keeps_all(&again, &compute(&again, &NormalRecipe::default())));
        }
    }

    #[test]
    fn always_keeps_nothing() {
        let mesh = square(Some(Column::per_vertex(vec![DVec3::Y; 4])));
        let all = replace(&mesh, &compute(&mesh, &NormalRecipe::default()), When::Always);
        assert_eq!((all.kept, all.missing.len(), all.broken.len()), (0, 6, 0));
        assert_eq!(all.normals.values, [DVec3::Z; 4]);
    }

    /// A face without area has no side that a normal could be on the wrong one of.
    #[test]
    fn faces_that_add_nothing_are_not_asked() {
        let normals = Some(Column::per_vertex(vec![DVec3::NEG_Z; 3]));
        let columns = Columns { normals, ..Columns::default() };
        let mesh = MeshBuilder {
            positions: vec![DVec3::ZERO, DVec3::X, DVec3::X * 2.0].into(),
            faces: Faces::triangles(vec![0, 1, 2]),
            columns,
        }
        .build()
        .unwrap();
        assert!(keeps_all(&mesh, &compute(&mesh, &NormalRecipe::default())));
    }

    /// Two faces face up and a third is folded back over them: their mean is against the third, and would be
    /// replaced by itself for ever.
    #[test]
    fn a_mean_round_a_fold_is_not_broken_by_its_own_doing() {
        let corner = |x, y, z| DVec3::new(x, y, z);
        let positions =
            [DVec3::ZERO, DVec3::X, corner(1.0, 1.0, 0.0), DVec3::Y, corner(1.0, 1.0, 0.1)].to_vec();
        let recipe = NormalRecipe { crease: crate::normals::Crease::OFF, ..NormalRecipe::default() };
        let with = |normals| {
            let columns = Columns { normals: Some(normals), ..Columns::default() };
            let faces = Faces::triangles(vec![0, 1, 2, 0, 2, 3, 0, 3, 4]);
            MeshBuilder { positions: positions.clone().into(), faces, columns }.build().unwrap()
        };
        let computed = compute(&with(Column::per_vertex(vec![DVec3::Z; 5])), &recipe);
        let mean = *computed.normals.get(6, 0).unwrap();
        assert!(mean.dot(computed.face_normals[2]) < 0.0, "the fold does what the test is about");

        let rounded = computed.normals.values.iter().map(|n| n.as_vec3().as_dvec3()).collect();
        let stored = with(Column { values: rounded, ..computed.normals.clone() });
        assert!(keeps_all(&stored, &compute(&stored, &recipe)));

        let opposite = computed.normals.values.iter().map(|n| -n).collect();
        let stored = with(Column { values: opposite, ..computed.normals.clone() });
        let broken = replace(&stored, &compute(&stored, &recipe), When::Broken).broken;
        assert!(broken.contains(&(0, Broken::AgainstFace)), "{broken:?}");
    }
}
