//! Tests of the PLY reader and writers.

use super::scalar::{Encoding, Scalar};
use super::{edit, read, write};
use crate::io::{Document, Emit, Loaded, NonFinite, Part, PartEdit, Place, Problem};
use crate::io::{ReadError, ReadOptions, WriteOptions, Written};
use crate::mesh::{Column, FaceEdit, FaceLabels, Faces, Mesh, MeshBuilder, NONE, Storage};
use glam::{DVec2, DVec3};

fn load(bytes: impl AsRef<[u8]>) -> Loaded {
    read(bytes.as_ref().to_vec(), None, &ReadOptions::default()).unwrap()
}

fn error(bytes: impl AsRef<[u8]>) -> ReadError {
    read(bytes.as_ref().to_vec(), None, &ReadOptions::default()).unwrap_err()
}

fn write_back(loaded: &Loaded, change: PartEdit, emit: Emit) -> Written {
    let Document::Ply(document) = &loaded.document else { panic!("no PLY document") };
    edit(document, loaded, &[change], &WriteOptions { emit, ..WriteOptions::default() }).unwrap()
}

fn edited(loaded: &Loaded, change: PartEdit) -> String {
    String::from_utf8(write_back(loaded, change, Emit::Corner).bytes).unwrap()
}

fn normals(values: &[DVec3], index: Vec<u32>) -> PartEdit {
    PartEdit { normals: Some(Column::per_corner(values.to_vec(), index)), ..PartEdit::default() }
}

/// Two triangles over the square, with much that must be carried along.
const ASCII: &str = "ply\nformat ascii 1.0\ncomment caf\u{e9} \n\nelement vertex 4\nproperty float x\nproperty float \
    y\n  property   float z # odd\nproperty uchar quality\nelement face 2\nproperty list uchar int vertex_indices\n\
    property int id\nobj_info x\nelement camera 1\nproperty list uchar float knobs\nend_header\n0 0 0 7\n1.0 0 0 8 \
    \n\n  1e0 1 0 9\n0 1 0 10\n3 0 1 2 100\n3   0 2 3 101\n2 0.5 0.25\n";

/// The same geometry in binary, with normals of this type.
fn binary(encoding: Encoding, normal: Scalar, unit: f64) -> Vec<u8> {
    let name = if encoding == Encoding::Big { "binary_big_endian" } else { "binary_little_endian" };
    let number = normal.name(true);
    let mut out = format!(
        "ply\r\nformat {name} 1.0\r\nelement face 2\r\nproperty list uchar uchar vertex_indices\r\nelement vertex \
         4\r\nproperty double x\r\nproperty double y\r\nproperty double z\r\nproperty {number} nx\r\nproperty \
         {number} ny\r\nproperty {number} nz\r\nproperty ushort tag\r\nend_header\r\n"
    )
    .into_bytes();
    out.extend([3, 0, 1, 2, 3, 0, 2, 3]);
    for (tag, [x, y]) in [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].into_iter().enumerate() {
        for value in [x, y, 0.1] {
            Scalar::F64.push(&mut out, value, encoding);
        }
        for value in [0.0, 0.0, unit] {
            normal.push(&mut out, value, encoding);
        }
        Scalar::U16.push(&mut out, tag as f64 + 500.0, encoding);
    }
    out
}

#[test]
fn ascii_is_read_as_it_comes() {
    let loaded = load(ASCII);
    let mesh = &loaded.parts[0].mesh;
    assert_eq!(mesh.positions().to_vec(), [DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.0), DVec3::Y]);
    assert_eq!(mesh.faces().corners(), [0, 1, 2, 0, 2, 3]);
    assert_eq!(mesh.storage(), Storage::F32);
    assert!(loaded.notes.is_empty() && mesh.columns().normals.is_none());
    for line_end in ["\r\n", "\r"] {
        assert_eq!(load(ASCII.replace('\n', line_end)).parts[0].mesh, *mesh, "{line_end:?}");
    }
    let mut latin = ASCII.replace('\u{e9}', "?").into_bytes();
    let at = latin.iter().position(|byte| *byte == b'?').unwrap();
    latin[at] = 0xe9;
    assert_eq!(load(latin).parts[0].mesh, *mesh);
    // Rows over several lines, and all in one.
    let body = ASCII.find("0 0 0 7").unwrap();
    let (header, rows) = ASCII.split_at(body);
    for separator in ["\n", " "] {
        let rows: Vec<&str> = rows.split_whitespace().collect();
        assert_eq!(load(format!("{header}{}", rows.join(separator))).parts[0].mesh, *mesh, "{separator:?}");
    }
}

#[test]
fn binary_is_read_in_both_orders_and_all_types() {
    for encoding in [Encoding::Little, Encoding::Big] {
        for (scalar, unit) in
            [(Scalar::F32, 1.0), (Scalar::F64, 1.0), (Scalar::I16, 32767.0), (Scalar::I8, 127.0)]
        {
            let loaded = load(binary(encoding, scalar, unit));
            let mesh = &loaded.parts[0].mesh;
            assert_eq!(mesh.faces().corners(), [0, 1, 2, 0, 2, 3]);
            assert_eq!(mesh.positions().at(2), DVec3::new(1.0, 1.0, 0.1));
            assert_eq!(mesh.columns().normals, Some(Column::per_vertex(vec![DVec3::Z; 4])));
            assert_eq!(mesh.storage(), Storage::F64);
        }
    }
    let raw = load(binary(Encoding::Little, Scalar::I8, 1.0));
    assert_eq!(raw.parts[0].mesh.columns().normals, Some(Column::per_vertex(vec![DVec3::Z; 4])));
}

#[test]
fn storage_goes_by_type_and_value() {
    let file = |scalar: Scalar, value: f64| {
        let mut out = format!(
            "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty {0} x\nproperty {0} y\nproperty {0} \
             z\nend_header\n",
            scalar.name(false)
        )
        .into_bytes();
        for value in [value; 3] {
            scalar.push(&mut out, value, Encoding::Little);
        }
        load(out).parts[0].mesh.storage()
    };
    for (scalar, value, storage) in [
        (Scalar::U8, 200.0, Storage::F32),
        (Scalar::F32, 0.1, Storage::F32),
        (Scalar::I32, 16_777_216.0, Storage::F32),
        (Scalar::I32, 16_777_217.0, Storage::F64),
        (Scalar::F64, 1.0, Storage::F64),
    ] {
        assert_eq!(file(scalar, value), storage, "{scalar:?} {value}");
    }
}

#[test]
fn attributes_of_vertices_and_corners() {
    let text = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
        property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float s\nproperty float t\nelement \
        face 1\nproperty list uchar int vertex_index\nproperty list uchar float texcoord\nproperty float nx\n\
        property float ny\nproperty float nz\nelement edge 1\nproperty int vertex1\nproperty int vertex2\n\
        end_header\n0 0 0 255 0 51 0.5 1\n1 0 0 0 0 0 0 0\n0 1 0 0 0 0 0 0\n3 0 1 2 6 0 0 1 0 1 1 0 1 0\n0 2\n";
    let columns = load(text).parts[0].mesh.columns().clone();
    assert_eq!(columns.colors.unwrap()[0], [1.0, 0.0, 0.2, 1.0]);
    assert_eq!(columns.uvs.unwrap().values[0], DVec2::new(0.5, 1.0));
    assert_eq!(columns.normals, Some(Column::per_corner(vec![DVec3::Y], vec![0; 3])));
    assert_eq!(columns.lines, [[0, 2]]);
    let columns = load(text.replace("float s\n", "float p\n")).parts[0].mesh.columns().clone();
    let uvs = Column::per_corner(vec![DVec2::ZERO, DVec2::X, DVec2::ONE], vec![0, 1, 2]);
    assert_eq!(columns.uvs, Some(uvs));
    assert!(columns.points.is_empty());
}

#[test]
fn strips_restart_and_turn() {
    let text = "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n\
        element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 0 0\n2 \
        1 0\n9 0 1 2 3 -1 1 4 3 5\n";
    let loaded = load(text);
    let mesh = &loaded.parts[0].mesh;
    assert_eq!(mesh.faces().corners(), [0, 1, 2, 2, 1, 3, 1, 4, 3, 3, 4, 5]);
    // Nothing splits: the strips stay.
    let index = vec![0; 12];
    let written = edited(&loaded, normals(&[DVec3::Z], index.clone()));
    let rows = " 0 0 1\n";
    assert!(written.contains("tristrips") && written.contains(&format!("2 1 0{rows}9 0 1 2 3 -1 1 4 3 5\n")));
    let mut other = index;
    other[3] = 1;
    let written = edited(&loaded, normals(&[DVec3::Z, DVec3::X], other));
    let again = load(&written).parts[0].mesh.clone();
    assert_eq!(again.faces().corners(), [0, 1, 2, 6, 1, 3, 1, 4, 3, 3, 4, 5]);
    assert!(written.contains("element face 4\n"));
}

#[test]
fn ascii_edits_insert_normals_and_keep_the_rest() {
    let loaded = load(ASCII);
    assert_eq!(edited(&loaded, PartEdit::default()), ASCII);
    let inserted = ASCII
        .replace("z # odd\n", "z # odd\nproperty float nx\nproperty float ny\nproperty float nz\n")
        .replace("0 0 0 7", "0 0 0 0 0 1 7")
        .replace("1.0 0 0 8", "1.0 0 0 0 0 1 8")
        .replace("1e0 1 0 9", "1e0 1 0 0 0 1 9")
        .replace("0 1 0 10", "0 1 0 0 0 1 10");
    assert_eq!(edited(&loaded, normals(&[DVec3::Z], vec![0; 6])), inserted);
    // Split at vertices 0 and 2: copies come behind, blank lines do not go with them.
    let split = edited(&loaded, normals(&[DVec3::Z, DVec3::X], vec![0, 0, 0, 1, 1, 1]));
    let expected = inserted
        .replace("vertex 4", "vertex 6")
        .replace("0 1 0 0 0 1 10\n", "0 1 0 1 0 0 10\n0 0 0 1 0 0 7\n1e0 1 0 1 0 0 9\n")
        .replace("3   0 2 3 101", "3 4 5 3 101");
    assert_eq!(split, expected);
    // A second run on its own output changes nothing.
    let again = load(&split);
    let index = again.parts[0].mesh.faces().corners().to_vec();
    let column = again.parts[0].mesh.columns().normals.clone().unwrap();
    assert_eq!(edited(&again, normals(&column.values, index)), split);
}

#[test]
fn faces_are_dropped_and_turned() {
    let loaded = load(ASCII);
    let faces = FaceEdit { dropped: vec![0], reversed: vec![1] };
    let written = edited(&loaded, PartEdit { faces, ..PartEdit::default() });
    let expected =
        ASCII.replace("face 2", "face 1").replace("3 0 1 2 100\n", "").replace("3   0 2 3", "3 0 3 2");
    assert_eq!(written, expected);
}

#[test]
fn binary_edits_patch_in_the_type_that_is_there() {
    for encoding in [Encoding::Little, Encoding::Big] {
        let bytes = binary(encoding, Scalar::I16, 32767.0);
        let loaded = load(&bytes);
        let written = write_back(&loaded, normals(&[DVec3::NEG_X], vec![0; 6]), Emit::Corner).bytes;
        assert_eq!(written.len(), bytes.len());
        let first = bytes.len() - 4 * 32;
        for (at, (old, new)) in bytes.iter().zip(&written).enumerate() {
            let in_normal = at >= first && (24..30).contains(&((at - first) % 32));
            assert!(in_normal || old == new, "byte {at}");
        }
        let again = load(&written);
        assert_eq!(again.parts[0].mesh.columns().normals, Some(Column::per_vertex(vec![DVec3::NEG_X; 4])));
    }
    // Too coarse: the type changes, and the numbers of kept normals stay.
    let loaded = load(binary(Encoding::Big, Scalar::I8, 127.0));
    let column =
        Column::per_corner(vec![DVec3::Z, DVec3::Z, DVec3::Z, DVec3::Z, DVec3::X], vec![0, 1, 4, 0, 4, 3]);
    let change = PartEdit { normals: Some(column), kept: 4, ..PartEdit::default() };
    let written = write_back(&loaded, change, Emit::Corner);
    assert!(written.bytes.windows(19).any(|w| w == b"property float64 nx"));
    assert_eq!(written.notes.len(), 1);
    let again = load(&written.bytes);
    let expected = vec![DVec3::Z, DVec3::Z, DVec3::X, DVec3::Z];
    assert_eq!(again.parts[0].mesh.columns().normals, Some(Column::per_vertex(expected)));
}

#[test]
fn kept_normals_keep_their_bits() {
    // Stored normals that no rounding would give back: not of unit length, and a NaN with a payload.
    let mut bytes = binary(Encoding::Little, Scalar::F32, 0.9);
    let last = bytes.len() - 6;
    bytes[last..last + 4].copy_from_slice(&0x7fc0_1234_u32.to_le_bytes());
    let loaded = load(&bytes);
    let values: Vec<DVec3> = loaded.parts[0].mesh.columns().normals.clone().unwrap().values;
    let column = Column::per_corner([values, vec![DVec3::X]].concat(), vec![0, 4, 2, 0, 2, 3]);
    let change = PartEdit { normals: Some(column), kept: 4, ..PartEdit::default() };
    let written = write_back(&loaded, change, Emit::Corner).bytes;
    let mut expected = bytes.clone();
    let second = bytes.len() - 3 * 38;
    assert_eq!(expected.len() - 4 * 38, written.len() - 4 * 38);
    expected[second + 24..second + 36].copy_from_slice(&[0, 0, 128, 63, 0, 0, 0, 0, 0, 0, 0, 0]);
    assert_eq!(written, expected);
}

#[test]
fn indices_widen_when_splits_need_it() {
    // 200 vertices, each in two triangles of their own side.
    let count = 200_u8;
    let mut bytes =
        b"ply\nformat binary_little_endian 1.0\nelement vertex 200\nproperty float x\nproperty float y\n\
        property float z\nelement face 200\nproperty list uint8 uint8 vertex_indices\nend_header\n"
            .to_vec();
    for k in 0..count {
        for v in [f64::from(k), f64::from(k % 7), 0.0] {
            Scalar::F32.push(&mut bytes, v, Encoding::Little);
        }
    }
    for k in 0..count {
        bytes.extend([3, k, (k + 1) % count, (k + 2) % count]);
    }
    let loaded = load(&bytes);
    let index: Vec<u32> = (0..600).map(|corner| corner / 3 % 2).collect();
    let written = write_back(&loaded, normals(&[DVec3::Z, DVec3::X], index), Emit::Corner);
    let again = load(&written.bytes);
    let (old, new) = (&loaded.parts[0].mesh, &again.parts[0].mesh);
    assert!(new.vertex_count() > 256 && written.added_vertices == new.vertex_count() as u64 - 200);
    let place = |mesh: &Mesh, corner: usize| mesh.positions().at(mesh.faces().corners()[corner]);
    let column = new.columns().normals.as_ref().unwrap();
    for corner in 0..600 {
        assert_eq!(place(old, corner), place(new, corner));
        let expected = if corner / 3 % 2 == 0 { DVec3::Z } else { DVec3::X };
        assert_eq!(column.get(corner, new.faces().corners()[corner]), Some(&expected));
    }
    assert!(written.bytes.windows(16).any(|window| window == b"list uint8 int32"));
}

#[test]
fn normals_of_faces() {
    let loaded = load(ASCII);
    let change = PartEdit { face_normals: Some(vec![DVec3::X, DVec3::Y]), ..PartEdit::default() };
    let written = write_back(&loaded, change.clone(), Emit::Face).bytes;
    let expected = ASCII
        .replace("id\n", "id\nproperty float nx\nproperty float ny\nproperty float nz\n")
        .replace(" 100\n", " 100 1 0 0\n")
        .replace(" 101\n", " 101 0 1 0\n");
    assert_eq!(String::from_utf8(written.clone()).unwrap(), expected);
    // Stored normals are overwritten in place, and those of reversed faces are negated.
    let again = load(&written);
    let reversed = PartEdit { faces: FaceEdit { dropped: vec![], reversed: vec![1] }, ..PartEdit::default() };
    let turned = expected.replace("3   0 2 3 101 0 1 0", "3 0 3 2 101 0 -1 0");
    assert_eq!(edited(&again, reversed), turned);
}

#[test]
fn rows_that_do_not_fit_the_header() {
    let long = load(ASCII.replace("2 0.5 0.25", "2 0.5 0.25 9 9").replace("1 0 9\n", "1 0 9 4 5\n"));
    assert_eq!(long.parts[0].mesh, load(ASCII).parts[0].mesh);
    let notes: Vec<_> = long.notes.iter().map(ToString::to_string).collect();
    assert_eq!(
        notes,
        ["line 20: a row has more values than the header defines; they were skipped (and 1 more like it)"]
    );
    for (from, to, expected) in [
        ("0 1 0 10", "0 1 x 10", "line 21: `x` is not a number"),
        ("3 0 1 2 100", "3 0 1 4 100", "line 22: face 0 refers to vertex 4, but there are only 4"),
        ("3 0 1 2 100", "3 0 1 -2 100", "line 22: -2 is not a vertex index"),
        ("3 0 1 2 100", "-3 0 1 2 100", "line 22: `-3` is not a valid list length"),
        ("3 0 1 2 100", "3000000000 0 1 2 100", "line 25: the file ends inside a row of `face`"),
        ("1.0 0 0 8", "inf 0 0 8", "line 18: vertex 1 has the position (inf, 0, 0)"),
        ("2 0.5 0.25\n", "", "line 24: 1 row of `camera` need at least 1 byte"),
        ("2 0.5 0.25\n", "2 0.5", "line 24: the file ends inside a row of `camera`"),
        ("element vertex 4", "element vertex -4", "line 5: `-4` is not a valid row count"),
        ("property int id", "property list float int id", "line 12: the count of the list"),
        ("property int id", "property text id", "line 12: unknown number type `text`"),
        ("vertex_indices", "vertices", "line 10: the element `face` has no integer list"),
        ("float x", "float w", "line 5: the vertices have no scalar properties"),
        ("element vertex", "element points", "the header has no element `vertex`"),
        ("end_header", "end", "line 16: unknown header line `end`"),
        ("format ascii", "format text", "line 2: unknown format `text`"),
        ("ply\n", "plywood\n", "not a PLY file: the first line is not `ply`"),
    ] {
        let error = error(ASCII.replace(from, to)).to_string();
        assert!(error.starts_with(expected), "{error}");
    }
    let cut = &binary(Encoding::Little, Scalar::F32, 1.0)[..400];
    assert_eq!(error(cut).problem, Problem::Truncated);
    assert!(matches!(error(cut).place, Place::Byte(_)));
}

#[test]
fn counts_that_lie_cost_nothing() {
    for count in ["4000000000", "18446744073709551615"] {
        let lie = ASCII.replace("vertex 4", &format!("vertex {count}"));
        assert_eq!(error(lie).problem, Problem::Truncated);
        let empty = ASCII
            .replace("element camera 1\nproperty list uchar float knobs\n", &format!("element x {count}\n"));
        assert_eq!(load(empty).parts[0].mesh.face_count(), 2);
    }
}

#[test]
fn non_finite_positions_drop_faces_on_request() {
    let options = ReadOptions { non_finite: NonFinite::DropFaces, ..ReadOptions::default() };
    let loaded = read(ASCII.replace("1.0 0 0 8", "nan 0 0 8").into_bytes(), None, &options).unwrap();
    assert_eq!(loaded.parts[0].non_finite_faces, [0]);
}

#[test]
fn vertices_alone_are_points() {
    let text = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n\
        element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n2 0 1\n";
    let loaded = load(text);
    assert_eq!(loaded.parts[0].mesh.columns().points, [0, 1]);
    assert!(loaded.notes[0].text.contains("fewer than 3 corners"));
}

#[test]
fn a_new_file_has_all_that_ply_can_hold() {
    let mut faces = Faces::new();
    faces.push(&[0, 1, 2]);
    faces.push(&[0, 2, 3, 4]);
    let mut mesh = MeshBuilder {
        positions: [[0., 0.], [1., 0.], [1., 1.], [0.5, 2.], [0., 1.]]
            .map(|[x, y]| DVec3::new(x, y, 0.0))
            .to_vec()
            .into(),
        faces,
        ..MeshBuilder::default()
    };
    mesh.columns.normals = Some(Column::per_corner(vec![DVec3::Z, DVec3::X], vec![0, 0, 0, 1, 1, 1, NONE]));
    mesh.columns.uvs = Some(Column::per_vertex(vec![DVec2::new(0.5, 0.25); 5]));
    mesh.columns.colors = Some(vec![[1.0, 0.2, 0.0, 0.4]; 5]);
    mesh.columns.lines = vec![vec![0, 1, 2]];
    mesh.columns.materials = Some(FaceLabels { of_face: vec![0, 0], names: vec!["m".to_owned()] });
    let part = Part { mesh: mesh.build().unwrap(), ..Part::default() };
    let written = write(&[part.clone(), part.clone()], &WriteOptions::default()).unwrap();
    let again = load(&written.bytes);
    let mesh = &again.parts[0].mesh;
    assert_eq!((mesh.vertex_count(), written.vertices, written.added_vertices), (14, 14, 4));
    assert_eq!(mesh.storage(), Storage::F32, "floats hold all of these doubles");
    assert_eq!(mesh.faces().face(1), [5, 6, 3, 4]);
    assert_eq!(mesh.faces().face(3), [12, 13, 10, 11]);
    let columns = mesh.columns();
    let normal = |vertex: usize| columns.normals.as_ref().unwrap().values[vertex];
    assert_eq!([normal(0), normal(5), normal(4), normal(13)], [DVec3::Z, DVec3::X, DVec3::Z, DVec3::X]);
    assert_eq!(columns.uvs.as_ref().unwrap().values[13], DVec2::new(0.5, 0.25));
    assert_eq!(columns.colors.as_ref().unwrap()[13], [1.0, 0.2, 0.0, 0.4]);
    assert_eq!(columns.lines, [[0, 1], [1, 2], [7, 8], [8, 9]]);
    let notes: Vec<_> = written.notes.iter().map(|note| note.text.as_str()).collect();
    assert_eq!(notes.len(), 3, "{notes:?}");
    let by_face = part
        .mesh
        .clone()
        .with_normals(Some(Column::per_corner(vec![DVec3::Y, DVec3::X], vec![0, 0, 0, 1, 1, 1, 1])));
    let options = WriteOptions { emit: Emit::Face, ..WriteOptions::default() };
    let written = write(&[Part { mesh: by_face, ..Part::default() }], &options).unwrap();
    let again = load(&written.bytes).parts[0].mesh.clone();
    assert_eq!(again.vertex_count(), 5);
    assert_eq!(again.columns().normals.as_ref().unwrap().values, [DVec3::Y, DVec3::X]);
}
