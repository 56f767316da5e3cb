//! Tests of the STL reader and writers.

use super::{edit, is_certain, read, write};
use crate::io::{Document, Loaded, NonFinite, Part, PartEdit, Place, Problem};
use crate::io::{ReadError, ReadOptions, WriteError, WriteOptions};
use crate::mesh::{Column, ColumnIndex, FaceEdit, Faces, Mesh, MeshBuilder, NONE, Storage};
use glam::DVec3;

fn load(bytes: impl AsRef<[u8]>) -> Loaded {
    read(bytes.as_ref().to_vec(), None, &ReadOptions::default()).unwrap()
}

fn error(bytes: impl AsRef<[u8]>) -> ReadError {
    read(bytes.as_ref().to_vec(), None, &ReadOptions::default()).unwrap_err()
}

fn edited(loaded: &Loaded, edits: &[PartEdit]) -> Vec<u8> {
    let Document::Stl(document) = &loaded.document else { panic!("no STL document") };
    edit(document, loaded, edits, &WriteOptions::default()).unwrap().bytes
}

fn faces(normals: &[DVec3]) -> PartEdit {
    PartEdit { face_normals: Some(normals.to_vec()), ..PartEdit::default() }
}

/// Facets in z = 0, 1, …, with the normals (0, 0, k) and the attribute bytes k.
fn binary(count: u32) -> Vec<u8> {
    let mut bytes = b"solid it seems, but binary".to_vec();
    bytes.resize(80, b'.');
    bytes.extend(count.to_le_bytes());
    for k in 0..count {
        let z = k as f32;
        for value in [0., 0., z, 0., 0., z, 1., 0., z, 0., 1., z] {
            bytes.extend(value.to_le_bytes());
        }
        bytes.extend((k as u16).to_le_bytes());
    }
    bytes
}

const ASCII: &str = "# made by hand\nsolid a part # of it\n facet normal 0.00e0 0.0 1.0 # up\n  outer loop\n   \
    vertex 0 0 0\n   vertex 1.0 0 0 # b\n   vertex 0 1e0 0\n  endloop\n endfacet\n facet\n outer loop\n \
    vertex 0 0 1\n vertex 1 0 1\n vertex 0 1 1\n endloop\n endfacet\nendsolid a part\nSOLID\nFACET NORMAL nan 0 \
    0 OUTER LOOP VERTEX 0 0 2 VERTEX 1 0 2 VERTEX 0 1 2 ENDLOOP ENDFACET\nENDSOLID\n";

#[test]
fn binary_is_identified_by_its_length() {
    let loaded = load(binary(3));
    let mesh = &loaded.parts[0].mesh;
    assert_eq!((mesh.face_count(), mesh.vertex_count(), mesh.storage()), (3, 9, Storage::F32));
    assert_eq!(mesh.positions().at(7), DVec3::new(1.0, 0.0, 2.0));
    let normals = mesh.columns().normals.as_ref().unwrap();
    assert_eq!(normals.values, [DVec3::ZERO, DVec3::Z, DVec3::Z * 2.0]);
    assert_eq!(normals.index, ColumnIndex::PerCorner(vec![0, 0, 0, 1, 1, 1, 2, 2, 2]));
    assert!(loaded.notes.is_empty());
}

#[test]
fn binary_counts_that_are_wrong() {
    let mut short = binary(3);
    short.truncate(150);
    let error = error(&short);
    assert_eq!((error.problem, error.place), (Problem::Truncated, Place::Byte(150)));
    let mut more = binary(3);
    more[80] = 1;
    let loaded = load(&more);
    assert_eq!(loaded.parts[0].mesh.face_count(), 1);
    assert!(loaded.notes[0].text.contains("enough for 2 more"));
    // What was not read is kept.
    assert_eq!(edited(&loaded, &[faces(&[DVec3::ZERO])]), more);
    let mut uncounted = binary(3);
    uncounted[80] = 0;
    assert_eq!(load(&uncounted).parts[0].mesh.face_count(), 3);
    let mut one_more = binary(3);
    one_more.push(b'\n');
    assert_eq!(load(&one_more).parts[0].mesh.face_count(), 3);
}

#[test]
fn ascii_solids_words_and_comments() {
    let loaded = load(ASCII);
    let names: Vec<_> = loaded.parts.iter().map(|part| part.name.as_str()).collect();
    assert_eq!(names, ["a part", ""]);
    let first = &loaded.parts[0].mesh;
    assert_eq!((first.face_count(), first.vertex_count(), first.storage()), (2, 6, Storage::F64));
    let normals = first.columns().normals.as_ref().unwrap();
    assert_eq!(normals.index, ColumnIndex::PerCorner(vec![0, 0, 0, NONE, NONE, NONE]));
    assert!(loaded.parts[1].mesh.columns().normals.as_ref().unwrap().values[0].x.is_nan());
    let notes: Vec<_> = loaded.notes.iter().map(ToString::to_string).collect();
    assert_eq!(notes, ["line 10: a facet has no normal of three numbers"]);
    for line_end in ["\r\n", "\r"] {
        let other = load(ASCII.replace('\n', line_end));
        assert_eq!(other.parts[0].mesh, loaded.parts[0].mesh);
        assert_eq!(other.notes, loaded.notes);
    }
}

#[test]
fn ascii_edits_change_numbers_only() {
    let loaded = load(ASCII);
    let same = faces(&[DVec3::Z, DVec3::Z]);
    let other = PartEdit::default();
    let with_second = ASCII.replace(" facet\n", " facet normal 0 0 1\n");
    assert_eq!(edited(&loaded, &[other.clone(), other.clone()]), ASCII.as_bytes());
    assert_eq!(
        edited(&loaded, &[same, other.clone()]),
        with_second.as_bytes(),
        "the same number keeps its spelling"
    );
    let reversed = PartEdit {
        faces: FaceEdit { dropped: vec![1], reversed: vec![0] },
        ..faces(&[DVec3::NEG_Z, DVec3::Z])
    };
    let text = String::from_utf8(edited(&loaded, &[reversed, faces(&[DVec3::Z])])).unwrap();
    let expected = ASCII
        .replace("0.00e0 0.0 1.0", "0 0 -1")
        .replace("vertex 1.0 0 0 # b\n   vertex 0 1e0 0\n", "vertex 0 1e0 0 # b\n   vertex 1.0 0 0\n")
        .replace(
            " facet\n outer loop\n vertex 0 0 1\n vertex 1 0 1\n vertex 0 1 1\n endloop\n endfacet\n",
            "",
        )
        .replace("nan 0 0", "0 0 1");
    assert_eq!(text, expected);
    let again = load(&text);
    assert_eq!(again.parts[0].mesh.positions().at(1), DVec3::Y);
}

#[test]
fn incomplete_normals_are_completed() {
    for facet in ["facet normal 1 2", "facet normal", "facet normal x y z", "facet", "facet normal 1 2 3"] {
        let text = format!(
            "solid\n{facet}\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n"
        );
        let written = edited(&load(&text), &[faces(&[DVec3::Y])]);
        let again = load(&written);
        assert_eq!(again.parts[0].mesh.columns().normals.as_ref().unwrap().values, [DVec3::Y], "{facet}");
    }
}

#[test]
fn binary_edits_change_normals_only() {
    let bytes = binary(4);
    let loaded = load(&bytes);
    let written = edited(&loaded, &[faces(&[DVec3::X, DVec3::Y, DVec3::X, DVec3::Y])]);
    assert_eq!(written.len(), bytes.len());
    for (at, (old, new)) in bytes.iter().zip(&written).enumerate() {
        let in_normal = at >= 84 && (at - 84) % 50 < 12;
        assert!(in_normal || old == new, "byte {at}");
    }
    let again = load(&written);
    assert_eq!(again.parts[0].mesh.columns().normals.as_ref().unwrap().values[1], DVec3::Y);
    let edit = PartEdit { faces: FaceEdit { dropped: vec![0, 2], reversed: vec![1] }, ..PartEdit::default() };
    let written = edited(&loaded, &[edit]);
    let mut expected = bytes[..84].to_vec();
    expected[80] = 2;
    expected.extend(&bytes[134..134 + 24]);
    expected.extend(&bytes[134 + 36..134 + 48]);
    expected.extend(&bytes[134 + 24..134 + 36]);
    expected.extend(&bytes[134 + 48..184]);
    expected.extend(&bytes[234..]);
    assert_eq!(written, expected);
}

#[test]
fn normals_that_are_kept_keep_their_bits() {
    let loaded = load(binary(2));
    let column = Column::per_corner(vec![DVec3::ZERO, DVec3::Z, DVec3::X], vec![2, 2, 2, 1, 1, 1]);
    let edit = PartEdit { normals: Some(column), kept: 2, ..faces(&[DVec3::X, DVec3::X]) };
    let again = load(edited(&loaded, &[edit]));
    assert_eq!(again.parts[0].mesh.columns().normals.as_ref().unwrap().values, [DVec3::X, DVec3::Z]);
}

#[test]
fn faults_say_where() {
    let facet =
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
    for (text, expected) in [
        (format!("solid\n{facet}"), "line 9: `endsolid` is missing"),
        (format!("solid\n{}", &facet[..60]), "line 6: the file ends inside a facet"),
        (
            format!("solid\n{}", facet.replace("vertex 0 1 0\n", "")) + "endsolid",
            "line 7: a facet needs 3 vertices, but has 2",
        ),
        (
            format!("solid\n{}", facet.replace("1 0 0", "1 0,5 0")),
            "line 5: a vertex needs 3 numbers, but `0,5`",
        ),
        (format!("solid\n{}", facet.replace("outer loop\n", "")), "line 3: unexpected `vertex`"),
        (
            format!("solid\n{}endsolid", facet.replace("0 1 0", "inf 1 0")),
            "line 6: vertex 2 has the position (inf",
        ),
        (String::new(), "the file is empty"),
        ("hello".to_owned(), "not an STL file (5 bytes)"),
    ] {
        let error = error(&text).to_string();
        assert!(error.starts_with(expected), "{error}");
    }
    let many = "solid\nendsolid\n".repeat(70_000);
    assert_eq!(error(many).problem, Problem::Limit);
    let mut bytes = binary(2);
    bytes[84 + 50 + 24..84 + 50 + 28].copy_from_slice(&f32::NAN.to_le_bytes());
    let error = error(&bytes);
    assert_eq!((error.problem, error.place), (Problem::NonFinite, Place::Byte(84 + 50 + 24)));
    let options = ReadOptions { non_finite: NonFinite::DropFaces, ..ReadOptions::default() };
    assert_eq!(read(bytes, None, &options).unwrap().parts[0].non_finite_faces, [1]);
}

#[test]
fn unusual_texts_are_read_with_a_warning() {
    let facet =
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
    let four = facet.replace("vertex 0 1 0\n", "vertex 1 1 0\nvertex 0 1 0\n");
    for (text, parts, warning) in [
        (facet.to_owned(), 1, "no `solid` line"),
        (format!("solid a\n{facet}solid b\n{facet}endsolid"), 2, "before the `endsolid`"),
        (format!("solid\ncolor 1 0 0\n{facet}endsolid"), 1, "was skipped"),
        (format!("solid\n{four}endsolid"), 1, "read as a polygon"),
    ] {
        let loaded = load(&text);
        assert_eq!(loaded.parts.len(), parts, "{text}");
        assert!(loaded.notes[0].text.contains(warning), "{:?}", loaded.notes);
    }
    assert_eq!(load(format!("solid\n{four}endsolid")).parts[0].mesh.faces().face(0), [0, 1, 2, 3]);
    assert_eq!(load("solid Empty\nendsolid Empty").parts[0].mesh.face_count(), 0);
}

#[test]
fn a_new_file_has_facets_of_all_parts() {
    let positions = vec![DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.0), DVec3::Y * 0.1];
    let mut faces = Faces::new();
    faces.push(&[0, 1, 2, 3]);
    let mesh = MeshBuilder { positions: positions.into(), faces, ..MeshBuilder::default() }.build().unwrap();
    let normal = |index: Vec<u32>| Some(Column::per_corner(vec![DVec3::Z, DVec3::X], index));
    let part = |name: &str, mesh: Mesh| Part { name: name.to_owned(), mesh, ..Part::default() };
    let parts = [
        part("one", mesh.clone().with_normals(normal(vec![0; 4]))),
        part("two", mesh.clone().with_normals(normal(vec![0, 1, 0, 0]))),
    ];
    let written = write(&parts, &WriteOptions::default()).unwrap();
    assert!(
        written.bytes.starts_with(b"crease") && written.bytes[..80].windows(10).any(|w| w == b": one, two")
    );
    let again = load(&written.bytes);
    assert!(is_certain(&written.bytes));
    let values = &again.parts[0].mesh.columns().normals.as_ref().unwrap().values;
    assert_eq!(values, &[DVec3::Z, DVec3::Z, DVec3::ZERO, DVec3::ZERO]);
    assert_eq!(again.parts[0].mesh.positions().at(0), DVec3::ZERO);
    let texts: Vec<_> = written.notes.iter().map(|note| note.text.as_str()).collect();
    assert_eq!(texts.len(), 4, "{texts:?}");
    assert!(texts[3].contains("rounded"));
    let far = MeshBuilder { positions: vec![DVec3::splat(1e300)].into(), ..MeshBuilder::default() }
        .build()
        .unwrap();
    assert!(matches!(write(&[part("", far)], &WriteOptions::default()), Err(WriteError::Unsupported(_))));
}
