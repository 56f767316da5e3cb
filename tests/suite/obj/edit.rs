//! Editing real files in place: only what was asked for changes.

use super::{Random, at_corners, corner_index, mesh_of, read};
use crate::meshes::rows;
use crease::io::{self, PartEdit, WriteOptions};
use crease::mesh::{Column, FaceEdit, Mesh, NONE};
use glam::DVec3;

fn edited(bytes: &[u8], edit: PartEdit) -> Vec<u8> {
    io::write(&read(bytes).unwrap(), &[edit], io::Format::Obj, &WriteOptions::default()).unwrap().bytes
}

/// Unit vectors that are `f32` values.
fn directions(count: usize, random: &mut Random) -> Vec<DVec3> {
    let mut component = || random.below(2001) as f64 - 1000.0;
    (0..count).map(|_| DVec3::new(component(), component(), 1.0).normalize().as_vec3().as_dvec3()).collect()
}

/// The lines, continued ones joined, that are neither normals nor faces.
fn other_lines(bytes: &[u8]) -> Vec<String> {
    let text: String = bytes.iter().map(|&byte| byte as char).collect();
    let text = text.replace("\r\n", "\n").replace("\\\n", "\\ ");
    let is_other = |line: &&str| !matches!(line.split_ascii_whitespace().next(), Some("vn" | "f"));
    text.split_inclusive('\n').filter(is_other).map(str::to_owned).collect()
}

/// The good files that load.
fn good_files() -> Vec<(String, Vec<u8>, Mesh)> {
    let rows = rows("obj/", &["obj"]);
    let loaded = rows.iter().filter_map(|row| {
        let bytes = row.bytes();
        let mesh = read(&bytes).ok()?.parts.remove(0).mesh;
        Some((row.name().to_owned(), bytes, mesh))
    });
    loaded.collect()
}

/// All but normals.
fn geometry(mesh: &Mesh) -> Mesh {
    mesh.clone().with_normals(None)
}

#[test]
fn without_changes_the_bytes_are_the_same() {
    for (name, bytes, mesh) in good_files() {
        assert!(edited(&bytes, PartEdit::default()) == bytes, "{name}");
        if let Some(normals) = mesh.columns().normals.clone() {
            let kept = normals.values.len();
            assert!(
                edited(&bytes, PartEdit { normals: Some(normals), kept, ..PartEdit::default() }) == bytes,
                "{name}"
            );
        }
    }
}

#[test]
fn new_normals_come_back_exactly_and_all_else_stays() {
    let mut random = Random(3);
    for (name, bytes, mesh) in good_files() {
        let corners = mesh.faces().corner_count();
        let values = directions(corners / 2 + 1, &mut random);
        let index = (0..corners).map(|_| random.below(values.len()) as u32).collect();
        let column = Some(Column::per_corner(values, index));
        let output = edited(&bytes, PartEdit { normals: column.clone(), ..PartEdit::default() });
        let back = mesh_of(&output);
        assert_eq!(geometry(&back), geometry(&mesh), "{name}");
        let as_f32 = |column: &Option<Column<DVec3>>| -> Vec<Option<[u32; 3]>> {
            let bits = |normal: DVec3| normal.as_vec3().to_array().map(f32::to_bits);
            at_corners(&mesh, column).into_iter().map(|normal| normal.map(bits)).collect()
        };
        assert_eq!(as_f32(&back.columns().normals), as_f32(&column), "{name}");
        assert_eq!(other_lines(&output), other_lines(&bytes), "{name}");
    }
}

#[test]
fn kept_normals_keep_every_bit_next_to_new_ones() {
    let mut random = Random(4);
    let mut tried = 0;
    for (name, bytes, mesh) in good_files() {
        let Some(stored) = &mesh.columns().normals else { continue };
        let kept = stored.values.len();
        let mut normals = stored.clone();
        normals.values.extend(directions(10, &mut random));
        let index: Vec<u32> = corner_index(stored)
            .iter()
            .map(
                |&slot| {
                    if slot == NONE || random.one_in(3) { (kept + random.below(10)) as u32 } else { slot }
                },
            )
            .collect();
        let normals = Column::per_corner(normals.values, index);
        let output = edited(&bytes, PartEdit { normals: Some(normals.clone()), kept, ..PartEdit::default() });
        let back = mesh_of(&output);
        assert_eq!(geometry(&back), geometry(&mesh), "{name}");
        assert_eq!(other_lines(&output), other_lines(&bytes), "{name}");
        let found = at_corners(&back, &back.columns().normals);
        for (corner, &slot) in corner_index(&normals).iter().enumerate() {
            let (found, asked) = (found[corner].unwrap(), normals.values[slot as usize]);
            // New ones go through the digits of an f32.
            let same =
                if (slot as usize) < kept { found == asked } else { found.as_vec3() == asked.as_vec3() };
            assert!(same, "{name}: corner {corner}");
        }
        tried += 1;
    }
    assert!(tried > 15 || good_files().is_empty());
}

#[test]
fn faces_are_dropped_and_reversed_with_all_that_is_theirs() {
    let mut random = Random(5);
    for (name, bytes, mesh) in good_files() {
        let mut pick =
            |one_in: usize| (0..mesh.face_count() as u32).filter(|_| random.one_in(one_in)).collect();
        let faces = FaceEdit { dropped: pick(4), reversed: pick(3) };
        let expected = mesh.with_faces(&faces);
        let output = edited(&bytes, PartEdit { faces: faces.clone(), ..PartEdit::default() });
        let back = mesh_of(&output);
        assert_eq!(back.faces(), expected.faces(), "{name}");
        let normals = [&back, &expected].map(|mesh| at_corners(mesh, &mesh.columns().normals));
        assert_eq!(normals[0], normals[1], "{name}");
        assert_eq!(
            at_corners(&back, &back.columns().uvs),
            at_corners(&expected, &expected.columns().uvs),
            "{name}"
        );
        let groups =
            [&back, &expected].map(|mesh| mesh.columns().smoothing.as_ref().map(|groups| &groups.of_face));
        assert_eq!(groups[0], groups[1], "{name}");
        assert_eq!(other_lines(&output), other_lines(&bytes), "{name}");
    }
}
