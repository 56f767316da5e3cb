//! Real files: the counts of the manifest, the errors of bad files, and a comparison with `tobj`.

use super::{at_corners, mesh_of, read};
use crate::meshes::rows;
use crease::io::{NonFinite, Problem, ReadOptions, Severity, obj};
use crease::mesh::Mesh;
use glam::{DVec2, DVec3};
use std::collections::BTreeSet;

#[test]
fn good_files_have_the_counts_of_the_manifest() {
    for row in rows("obj/", &["obj"]) {
        let name = row.name();
        let loaded = match read(&row.bytes()) {
            Ok(loaded) => loaded,
            // Text such as `3.1+e2` is no number.
            Err(error) if row.text("expect") == "either" => {
                assert_eq!(error.problem, Problem::Syntax, "{name}");
                continue;
            }
            Err(error) => panic!("{name}: {error}"),
        };
        let mesh = &loaded.parts[0].mesh;
        let arity = |wanted: fn(usize) -> bool| mesh.faces().iter().filter(|face| wanted(face.len())).count();
        assert_eq!(mesh.vertex_count(), row.number("verts"), "{name}");
        assert_eq!(mesh.face_count(), row.number("faces"), "{name}");
        assert_eq!(arity(|corners| corners == 3), row.number("tris"), "{name}");
        assert_eq!(arity(|corners| corners == 4), row.number("quads"), "{name}");
        assert_eq!(arity(|corners| corners > 4), row.number("ngons"), "{name}");
        assert_eq!(mesh.faces().max_arity(), row.number("max_arity"), "{name}");
        let columns = mesh.columns();
        assert_eq!(columns.lines.len(), row.noted("lines"), "{name}");
        assert_eq!(columns.points.is_empty(), row.noted("points") == 0, "{name}");
        check_normals(
            mesh,
            &row,
            loaded.notes.iter().any(|note| note.text.contains("normal that does not exist")),
        );
        check_smoothing(mesh, &row);
    }
}

fn check_normals(mesh: &Mesh, row: &crate::meshes::Row, some_are_missing: bool) {
    let corners = at_corners(mesh, &mesh.columns().normals);
    let with = corners.iter().flatten().count();
    let (name, all) = (row.name(), corners.len());
    match row.text("normals") {
        "no" => assert_eq!(with, 0, "{name}"),
        "some" => assert!(with > 0 && with < all, "{name}"),
        // The manifest counts references, also those that lead nowhere.
        "all" => assert!(with == all || some_are_missing, "{name}"),
        other => panic!("{name}: {other}"),
    }
    if let Some(normals) = &mesh.columns().normals {
        assert_eq!(normals.values.len(), row.noted("vn"), "{name}");
    }
}

/// The manifest counts groups other than `off`.
fn check_smoothing(mesh: &Mesh, row: &crate::meshes::Row) {
    let (count, off) =
        row.text("smoothing_groups").split_once('+').unwrap_or((row.text("smoothing_groups"), ""));
    let groups: BTreeSet<u32> = mesh
        .columns()
        .smoothing
        .iter()
        .flat_map(|groups| &groups.of_face)
        .copied()
        .filter(|&id| id != 0)
        .collect();
    assert_eq!(groups.len().to_string(), count, "{}", row.name());
    if off == "off" {
        assert!(mesh.columns().smoothing.is_some(), "{}", row.name());
    }
}

#[test]
fn bad_files_are_refused_or_load_with_warnings() {
    for row in rows("bad/", &["obj"]) {
        let name = row.name();
        let loaded = read(&row.bytes());
        match (row.text("expect"), &loaded) {
            ("load", Ok(loaded)) => {
                assert_eq!(loaded.parts[0].mesh.face_count(), row.number("faces"), "{name}")
            }
            ("load with warning", Ok(_)) => {}
            ("reject", Err(error)) => assert!(!error.advice.is_empty(), "{name}"),
            (either, Ok(_)) if either.starts_with("either") => {}
            (either, Err(error)) if either.starts_with("either") => {
                assert!(!error.advice.is_empty() && error.to_string().contains("line "), "{name}: {error}");
            }
            (expect, Ok(_)) => panic!("{name} loads, but the manifest says: {expect}"),
            (expect, Err(error)) => panic!("{name}: {error}; but the manifest says: {expect}"),
        }
    }
}

#[test]
fn what_is_skipped_in_bad_files_is_said() {
    for row in rows("bad/", &["obj"]) {
        let stem = row.name().trim_start_matches("bad/").trim_end_matches(".obj");
        let expected: &[&str] = match stem {
            "made-obj_two_corner_face" | "tiny-invalid-face-definition" | "tri-notenoughindices" => {
                &["fewer than 3"]
            }
            "made-obj_smoothing_weird" => &["is not a number of a smoothing group"],
            "made-obj_vn_oob" => &["line 10: a corner refers to a normal that does not exist"],
            _ => continue,
        };
        let notes = read(&row.bytes()).unwrap().notes;
        for text in expected {
            let said = notes
                .iter()
                .any(|note| note.severity == Severity::Warning && note.to_string().contains(text));
            assert!(said, "{stem}: {notes:?}");
        }
    }
}

#[test]
fn faces_at_positions_that_are_not_finite_can_be_dropped() {
    let options = ReadOptions { non_finite: NonFinite::DropFaces, ..ReadOptions::default() };
    for row in rows("bad/", &["obj"]) {
        let dropped: &[u32] = match row.name() {
            "bad/made-obj_nan_inf.obj" => &[0, 2],
            "bad/made-obj_float_overflow.obj" | "bad/draco-inf_nan.obj" => &[0],
            _ => continue,
        };
        assert_eq!(read(&row.bytes()).unwrap_err().problem, Problem::NonFinite, "{}", row.name());
        let part = obj::read(row.bytes(), None, &options).unwrap().parts.remove(0);
        assert_eq!(part.non_finite_faces, dropped, "{}", row.name());
        assert!(part.mesh.positions().iter().all(|position| position.is_finite()));
    }
}

#[test]
fn libraries_outside_the_folder_are_not_read() {
    for row in rows("bad/made-obj_mtllib", &["obj"]) {
        let loaded = obj::read(row.bytes(), row.path.parent(), &ReadOptions::default()).unwrap();
        let said: Vec<String> = loaded.notes.iter().map(ToString::to_string).collect();
        assert!(said.iter().any(|note| note.contains("outside the input's folder")), "{said:?}");
        assert!(said.iter().any(|note| note.contains("a network path or URL")), "{said:?}");
    }
}

/// Faces as `tobj` has them: the position and, if the file has them, texture coordinate of each corner.
type Corners = Vec<(DVec3, Option<DVec2>, Option<DVec3>)>;

fn faces_of_tobj(bytes: &[u8]) -> Option<Vec<Corners>> {
    let options =
        tobj::LoadOptions { ignore_lines: true, ignore_points: true, ..tobj::LoadOptions::default() };
    let no_materials = |_: &std::path::Path| Err(tobj::LoadError::GenericFailure);
    // It multiplies without a check where overflow checks are on.
    let loaded = std::panic::catch_unwind(|| tobj::load_obj_buf(&mut &bytes[..], &options, no_materials));
    let (models, _) = loaded.ok()?.ok()?;
    let mut faces = Vec::new();
    for tobj::Model { mesh, .. } in models {
        let three = |values: &[f32], at: u32| {
            let at = 3 * at as usize;
            DVec3::new(values[at].into(), values[at + 1].into(), values[at + 2].into())
        };
        let mut corner = 0;
        let triangles = vec![3; mesh.indices.len() / 3];
        for &arity in if mesh.face_arities.is_empty() { &triangles } else { &mesh.face_arities } {
            let corners = (corner..corner + arity as usize).map(|corner| {
                let uv = mesh.texcoord_indices.get(corner).map(|&uv| {
                    DVec2::new(
                        mesh.texcoords[2 * uv as usize].into(),
                        mesh.texcoords[2 * uv as usize + 1].into(),
                    )
                });
                let normal = mesh.normal_indices.get(corner).map(|&normal| three(&mesh.normals, normal));
                (three(&mesh.positions, mesh.indices[corner]), uv, normal)
            });
            faces.push(corners.collect());
            corner += arity as usize;
        }
    }
    Some(faces)
}

/// Where `tobj` is known to be wrong or to give up.
const TOBJ_IS_WRONG: &[(&str, &str)] = &[
    ("obj/cube-vertex-w-component.obj", "divides by w"),
    ("obj/box-mixed-attributes.obj", "makes up attributes of corners that have none"),
    ("obj/line-prim.obj", "makes triangles of polylines"),
    ("obj/wallhole.obj", "gives up at continued lines"),
    ("obj/number_formats.obj", "has numbers that are none"),
    ("obj/multiple_spaces.obj", "gives up at a third texture coordinate"),
];

#[test]
fn tobj_agrees_where_it_is_right() {
    let mut agreed = 0;
    for row in
        rows("obj/", &["obj"]).iter().filter(|row| TOBJ_IS_WRONG.iter().all(|(name, _)| row.name() != *name))
    {
        let Some(theirs) = faces_of_tobj(&row.bytes()) else {
            println!("tobj does not read {}", row.name());
            continue;
        };
        let mesh = mesh_of(&row.bytes());
        let (uvs, normals) =
            (at_corners(&mesh, &mesh.columns().uvs), at_corners(&mesh, &mesh.columns().normals));
        assert_eq!(mesh.face_count(), theirs.len(), "{}", row.name());
        // It rounds to f32 from the text, as the comparison does: one unit in the last place apart at most, where
        // rounding twice differs.
        let close = |ours: f64, theirs: f64| (ours - theirs).abs() <= f64::from(f32::EPSILON) * theirs.abs();
        for (range, theirs) in mesh.faces().ranges().zip(theirs) {
            assert_eq!(range.len(), theirs.len(), "{}", row.name());
            for (corner, (position, uv, normal)) in range.zip(theirs) {
                let ours = mesh.positions().at(mesh.faces().corners()[corner]);
                assert!(
                    (0..3).all(|axis| close(ours[axis], position[axis])),
                    "{}: corner {corner}",
                    row.name()
                );
                if let (Some(ours), Some(theirs)) = (uvs[corner], uv) {
                    assert!(
                        (0..2).all(|axis| close(ours[axis], theirs[axis])),
                        "{}: corner {corner}",
                        row.name()
                    );
                }
                if let (Some(ours), Some(theirs)) = (normals[corner], normal) {
                    assert!(
                        (0..3).all(|axis| close(ours[axis], theirs[axis])),
                        "{}: corner {corner}",
                        row.name()
                    );
                }
            }
        }
        agreed += 1;
    }
    assert!(agreed >= 35 || rows("obj/", &["obj"]).is_empty(), "tobj was asked about {agreed} files only");
}
