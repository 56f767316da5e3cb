//! Tests of the OBJ reader.

use super::read;
use super::statements::next_line_start;
use crate::io::{Loaded, NonFinite, Place, Problem, ReadError, ReadOptions, Severity};
use crate::mesh::{ColumnIndex, Mesh, NONE};
use glam::{DVec2, DVec3};

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

fn try_load(text: impl AsRef<[u8]>) -> Result<Loaded, ReadError> {
    read(text.as_ref().to_vec(), None, &ReadOptions::default())
}

fn load(text: impl AsRef<[u8]>) -> Loaded {
    try_load(text).unwrap()
}

fn mesh(text: impl AsRef<[u8]>) -> Mesh {
    load(text).parts.remove(0).mesh
}

fn faces(text: impl AsRef<[u8]>) -> Vec<Vec<u32>> {
    mesh(text).faces().iter().map(<[u32]>::to_vec).collect()
}

fn error(text: impl AsRef<[u8]>) -> String {
    try_load(text).unwrap_err().to_string()
}

fn notes(text: impl AsRef<[u8]>) -> Vec<String> {
    load(text).notes.iter().map(ToString::to_string).collect()
}

fn index<T>(column: Option<&crate::mesh::Column<T>>) -> &[u32] {
    match &column.unwrap().index {
        ColumnIndex::PerCorner(index) => index,
        ColumnIndex::PerVertex => panic!("OBJ indexes corners"),
    }
}

#[test]
fn polygons_of_any_size() {
    let text = format!("{TRIANGLE}v 1 1 0\nv 2 2 0\nf 1 2 3\nf 1 2 4 3\nf 5 4 3 2 1\n");
    assert_eq!(faces(&text), [vec![0, 1, 2], vec![0, 1, 3, 2], vec![4, 3, 2, 1, 0]]);
    assert!(mesh(format!("{TRIANGLE}f 1 2 3\nfo 3 2 1\n")).faces().is_triangles());
    let many: String = (0..20_000).map(|i| format!("v {i} 0 0\n")).collect();
    let corners: String = (1..=20_000).map(|i| format!(" {i}")).collect();
    assert_eq!(mesh(format!("{many}f{corners}")).faces().max_arity(), 20_000);
}

#[test]
fn every_corner_form_alone_and_mixed() {
    let text = format!(
        "{TRIANGLE}vt 0 0\nvt 1 0.5\nvn 0 0 1\nvn 0 1 0\nf 1 2/2 3//2\nf 1/1/1 2/ 3//\nf 1/2/ 2/-2/-1 3\n"
    );
    let mesh = mesh(text);
    let columns = mesh.columns();
    assert_eq!(index(columns.uvs.as_ref()), [NONE, 1, NONE, 0, NONE, NONE, 1, 0, NONE]);
    assert_eq!(index(columns.normals.as_ref()), [NONE, NONE, 1, 0, NONE, NONE, NONE, 1, NONE]);
    assert_eq!(columns.uvs.as_ref().unwrap().values[1], DVec2::new(1.0, 0.5));
    assert_eq!(columns.normals.as_ref().unwrap().values, [DVec3::Z, DVec3::Y]);
}

#[test]
fn attributes_that_come_late_leave_earlier_corners_without() {
    let mesh = mesh(format!("{TRIANGLE}f 1 2 3\nvn 0 0 1\nvt 1\nf 1/1 2//1 3\nf 3 2 1\n"));
    assert_eq!(index(mesh.columns().normals.as_ref()), [NONE, NONE, NONE, NONE, 0, NONE, NONE, NONE, NONE]);
    assert_eq!(mesh.columns().uvs.as_ref().unwrap().values, [DVec2::new(1.0, 0.0)]);
}

#[test]
fn unreferenced_normals_are_no_column() {
    assert!(mesh(format!("{TRIANGLE}vn 0 0 1\nvt 0 0\nf 1 2 3\n")).columns().normals.is_none());
}

#[test]
fn indices_count_back_from_where_they_stand_and_forward() {
    assert_eq!(faces(format!("{TRIANGLE}f -3 -2 -1\nv 1 1 1\nf -1 -2 -3\n")), [[0, 1, 2], [3, 2, 1]]);
    assert_eq!(faces(format!("f 3 2 1\n{TRIANGLE}")), [[2, 1, 0]]);
}

#[test]
fn vertex_indices_out_of_range_are_errors_with_their_line() {
    assert_eq!(
        error(format!("{TRIANGLE}\n# x\nf 1 2 3\nf 1 2 4\n")),
        "line 7: vertex index 4 is out of range (the file has 3); correct the index, or add the missing vertices; the file may \
         be cut off"
    );
    assert!(
        error(format!("{TRIANGLE}f -1 -2 -4\n{TRIANGLE}"))
            .starts_with("line 4: vertex index -4 is out of range")
    );
    assert!(error(format!("{TRIANGLE}f 1 0 2\n")).starts_with("line 4: index 0 is not valid"));
    assert!(error(format!("{TRIANGLE}l 1 9\n")).starts_with("line 4: vertex index 9"));
    assert!(error(format!("{TRIANGLE}p 1 2\\\n 5\n")).starts_with("line 5: vertex index 5"));
    let huge = error(format!("{TRIANGLE}f 1 2 99999999999999999999999\n"));
    assert!(huge.starts_with("line 4: vertex index 9"), "{huge}");
    assert!(error(format!("{TRIANGLE}f 1 2 -9223372036854775809\n")).starts_with("line 4: vertex index -9"));
}

#[test]
fn other_indices_out_of_range_are_warnings() {
    let text = format!("{TRIANGLE}vn 0 0 1\nf 1//1 2//0 3//7\nf 1/3 2 3//-2\n");
    assert_eq!(index(mesh(&text).columns().normals.as_ref()), [0, NONE, NONE, NONE, NONE, NONE]);
    let notes = notes(&text);
    assert_eq!(notes.len(), 2);
    assert!(
        notes[0].starts_with("line 5: a corner refers to a normal")
            && notes[0].ends_with("(and 2 more like it)")
    );
    assert!(notes[1].starts_with("line 6: a corner refers to a texture coordinate"));
}

#[test]
fn lines_end_and_go_on_as_they_like() {
    let expected = faces(format!("{TRIANGLE}f 1 2 3\n"));
    for text in [
        "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r",
        "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3",
        "\u{feff}v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3",
        "v 0 \\\n 0 0\nv 1 0\\\r\n0\nv \\\r0 1 0\nf 1\\ \n2 \\\n\\\n3\n",
        "  v\t0 \t 0   0 # a\n\n\t\nv 1 0 0#b\nv 0 1 0 #\\\nf 1 2 3 # 4 5\\",
        "# C:\\path\\\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nfoo bar \\\nf 1 2 9\nf 1 2 3\n",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\n# \0\u{fe}\nf 1 2 3\n",
    ] {
        let mesh = mesh(text);
        assert_eq!(mesh.positions().to_vec(), [DVec3::ZERO, DVec3::X, DVec3::Y], "{text:?}");
        let faces: Vec<_> = mesh.faces().iter().map(<[u32]>::to_vec).collect();
        assert_eq!(faces, expected, "{text:?}");
    }
}

#[test]
fn faults_name_line_and_column() {
    assert!(
        error("v 0 0 0\nv 1 0,5 0\n")
            .starts_with("line 2: column 5: `0,5` is not a number; write decimals with")
    );
    assert!(
        error("\r\n\r\rv 1 0 1d0").starts_with("line 4: column 7: `1d0` is not a number; write exponents")
    );
    assert!(error("v 1 2\n").starts_with("line 1: column 6: a vertex has 2 numbers, but 3 are needed"));
    assert!(error("vn 1 \n").starts_with("line 1: column 6: a normal has 1 number,"));
    assert!(error("vt\n").starts_with("line 1: column 3: a texture coordinate has 0 numbers"));
    assert!(error("v 0 \0\0 0\n").starts_with("line 1: column 5: `\\x00\\x00` is not a number"));
    for corner in ["1.5", "a", "/1", "1/2/3/4", "1//2/3", "1/x", "--1", "1-2"] {
        let error = error(format!("{TRIANGLE}f 1 2 {corner}\n"));
        assert!(
            error.starts_with("line 4: column 7: `") && error.contains("not a vertex reference"),
            "{error}"
        );
    }
}

#[test]
fn positions_that_are_not_finite() {
    let text = format!("{TRIANGLE}v 0 1e400 nan\nf 1 2 3\nf 1 2 4\n");
    let error = try_load(&text).unwrap_err();
    assert_eq!((error.problem, error.place.clone()), (Problem::NonFinite, Place::Line(4)));
    assert!(error.found.contains("(0, 1e400, nan), which is not finite"), "{error}");
    let error = try_load("v 0 1e400 -1e999\n").unwrap_err();
    assert!(error.found.contains("(0, 1e400, -1e999), which is beyond the range of doubles"), "{error}");
    let options = ReadOptions { non_finite: NonFinite::DropFaces, ..ReadOptions::default() };
    let part = read(text.into_bytes(), None, &options).unwrap().parts.remove(0);
    assert_eq!(part.non_finite_faces, [1]);
    assert_eq!(part.mesh.face_count(), 2);
}

#[test]
fn numbers_behind_a_position() {
    let text = "v 0 0 0 0.5\nv 1 0 0 0.1 0.2 0.3\nv 0 1 0 0.1 0.2 0.3 0.4\nv 1 1 0 1 2\n";
    let colors = mesh(text).columns().colors.clone().unwrap();
    let white = [1.0; 4];
    assert_eq!(colors, [white, [0.1, 0.2, 0.3, 1.0], [0.1, 0.2, 0.3, 0.4], white]);
    assert_eq!(notes(text).len(), 3, "{:?}", notes(text));
    assert!(mesh("v 0 0 0 1\nv 0 0 0 2\n").columns().colors.is_none());
    let colors = mesh("v 0 0 0 0.5 nan inf\nv 0 0 0 0.5 0.5 0.5\n").columns().colors.clone().unwrap();
    assert_eq!(colors, [[0.5, 0.0, 0.0, 1.0], [0.5, 0.5, 0.5, 1.0]]);
    let colors = mesh("v 0 0 0 255 0 51\nv 0 0 0\n").columns().colors.clone().unwrap();
    assert_eq!(colors, [[1.0, 0.0, 0.2, 1.0 / 255.0], white]);
}

#[test]
fn smoothing_groups_are_names() {
    let text = format!(
        "{TRIANGLE}f 1 2 3\ns 2\nf 1 2 3\ns off\nf 1 2 3\ns 4294967296\nf 1 2 3\ns on\nf 1 2 3\ns 00\nf 1 2 3\n\
         s\nf 1 2 3\ns 4294967296\nf 1 2 3\ns 2 # x\nf 1 2 3\n"
    );
    let groups = mesh(&text).columns().smoothing.clone().unwrap();
    let (huge, on) = (NONE - 1, NONE - 2);
    assert_eq!(groups.of_face, [0, 2, 0, huge, on, 0, 0, huge, 2]);
    assert_eq!(groups.before_first, 1);
    assert_eq!(notes(&text).len(), 1);
    assert!(mesh(format!("{TRIANGLE}f 1 2 3\n")).columns().smoothing.is_none());
    assert!(mesh(format!("{TRIANGLE}f 1 2 3\ns 1\n")).columns().smoothing.is_some());
}

#[test]
fn objects_are_o_or_else_g() {
    let text =
        format!("{TRIANGLE}f 1 2 3\ng a b\nusemtl x #1\nf 1 2 3\ng\nusemtl \nf 1 2 3\ng a b\nf 1 2 3\n");
    let columns = mesh(&text).columns().clone();
    let objects = columns.objects.unwrap();
    assert_eq!((objects.names, objects.of_face), (vec!["a b".to_owned()], vec![NONE, 0, NONE, 0]));
    let materials = columns.materials.unwrap();
    assert_eq!((materials.names, materials.of_face), (vec!["x #1".to_owned()], vec![NONE, 0, NONE, NONE]));
    let objects = mesh(format!("o whole\n{text}")).columns().objects.clone().unwrap();
    assert_eq!((objects.names, objects.of_face), (vec!["whole".to_owned()], vec![0; 4]));
    assert_eq!(load(format!("o whole\n{text}")).parts[0].name, "whole");
    let latin = [TRIANGLE.as_bytes(), b"g gr\xfc\xdf\nf 1 2 3\n"].concat();
    assert_eq!(mesh(latin).columns().objects.as_ref().unwrap().names, ["grüß"]);
}

#[test]
fn lines_and_points() {
    let mesh = mesh(format!("{TRIANGLE}l 1 2/1 -1\nl 3\np 1 3\np 2\nl 2 1\n"));
    assert_eq!(mesh.columns().lines, [vec![0, 1, 2], vec![1, 0]]);
    assert_eq!(mesh.columns().points, [0, 2, 1]);
}

#[test]
fn what_is_skipped_is_said_once() {
    let text = format!(
        "{TRIANGLE}f 1 2\nf\nf 1 9\nfoo\nbar 1\nvp 1\nsurf 0 1 1/1/1 2/2/2\nend\nlod 1\nl 1\nf 1 2 3\n"
    );
    assert_eq!(faces(&text), [[0, 1, 2]]);
    assert_eq!(
        notes(&text),
        [
            "line 4: a face with fewer than 3 corners was skipped (and 2 more like it)",
            "line 7: the unknown statement `foo` was ignored (and 1 more like it)",
            "line 9: the statement `vp` of free-form curves and surfaces was ignored (and 2 more like it)",
            "line 13: a line with fewer than 2 vertices was skipped",
        ]
    );
    assert!(load(&text).notes.iter().all(|note| note.severity == Severity::Warning));
}

#[test]
fn other_encodings_and_other_files_are_refused_by_name() {
    for (bytes, name) in [
        (&b"\xff\xfev\0 \x000\0"[..], "UTF-16"),
        (b"\xfe\xff\0v\0 \x000", "UTF-16"),
        (b"v\0 \x000\0", "UTF-16"),
        (b"\0v\0 \x000", "UTF-16"),
        (b"\xff\xfe\0\0v\0\0\0", "UTF-32"),
    ] {
        let error = try_load(bytes).unwrap_err();
        assert!(error.found.contains(name) && error.advice.contains("UTF-8"), "{error}");
    }
    assert!(error("\n<html>\n").starts_with("line 2: not an OBJ file; it starts with `<html>`"));
    assert_eq!(mesh("# nothing\n").vertex_count(), 0);
    assert_eq!(mesh("").vertex_count(), 0);
}

#[test]
fn uvs_that_are_not_finite_are_absent() {
    let text = format!("{TRIANGLE}vt 0 nan\nvt 1 1\nf 1/1 2/2 3/1\n");
    let mesh = mesh(&text);
    assert_eq!(index(mesh.columns().uvs.as_ref()), [NONE, 1, NONE]);
    assert!(mesh.columns().uvs.as_ref().unwrap().values.iter().all(|uv| uv.is_finite()));
    assert!(notes(&text)[0].starts_with("line 4: a texture coordinate is not finite"));
}

#[test]
fn pieces_break_between_statements_only() {
    let text = "v 0 0 0\r\nv 1 0 0 \\\r\n# v\nv 0 1 0\\ \n\nf 1 2 3";
    for at in 0..=text.len() {
        let start = next_line_start(text.as_bytes(), at);
        let (before, after) = text.split_at(start);
        assert!(start > at || start == text.len());
        assert!(before.is_empty() || after.is_empty() || before.ends_with('\n'), "{at}");
        let line = before.strip_suffix('\n').unwrap_or(before).trim_end_matches(['\r', ' ']);
        assert!(!line.ends_with('\\'), "{at}");
        assert!(!(before.ends_with('\r') && after.starts_with('\n')), "{at}");
    }
}
