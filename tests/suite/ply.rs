//! PLY: real files against their manifest, edits that change nothing but normals, broken files.

use crate::flat::flat;
use crate::meshes::{Row, rows};
use crate::random::Random;
use crease::io::{self, Emit, Format, Loaded, PartEdit, ReadError, ReadOptions, Severity, WriteOptions};
use crease::mesh::{Column, Mesh};
use glam::DVec3;

fn read(bytes: &[u8]) -> Result<Loaded, ReadError> {
    io::read_bytes(bytes.to_vec(), Some(Format::Ply), None, &ReadOptions::default())
}

fn mesh_of(bytes: &[u8]) -> Mesh {
    read(bytes).unwrap_or_else(|error| panic!("{error}")).parts.remove(0).mesh
}

fn write(loaded: &Loaded, edit: PartEdit) -> Vec<u8> {
    io::write(loaded, &[edit], Format::Ply, &WriteOptions::default()).unwrap().bytes
}

fn files() -> Vec<Row> {
    let mut files = rows("ply/", &["ply"]);
    files.extend(rows("ref/", &["ply"]));
    files
}

#[test]
fn real_files_are_what_the_manifest_says() {
    for row in files() {
        let loaded = io::read(&row.path, None, &ReadOptions::default())
            .unwrap_or_else(|e| panic!("{}: {e}", row.name()));
        let mesh = &loaded.parts[0].mesh;
        let arity = |low: usize, high: usize| {
            mesh.faces().ranges().filter(|range| (low..=high).contains(&range.len())).count()
        };
        assert_eq!(mesh.vertex_count(), row.number("verts"), "{}", row.name());
        for (column, found) in [
            ("faces", mesh.face_count()),
            ("tris", arity(3, 3)),
            ("quads", arity(4, 4)),
            ("ngons", arity(5, usize::MAX)),
            ("max_arity", mesh.faces().max_arity()),
        ] {
            assert_eq!(found, row.number(column), "{}: {column}", row.name());
        }
        let (low, high) = mesh.bounds().unwrap();
        for (column, corner) in [("bbox_min", low), ("bbox_max", high)] {
            for (text, value) in row.text(column).split(',').zip(corner.to_array()) {
                let expected: f64 = text.parse().unwrap();
                // The manifest gives six digits.
                assert!(
                    (value - expected).abs() <= 1e-5 * expected.abs(),
                    "{}: {column} {value}",
                    row.name()
                );
            }
        }
        let per_vertex =
            mesh.columns().normals.as_ref().is_some_and(|column| column.values.len() == mesh.vertex_count());
        assert!(per_vertex || row.text("normals") != "vertex", "{}", row.name());
        assert_eq!(io::detect(&row.bytes(), None), Some(Format::Ply));
        let warned = loaded.notes.iter().any(|note| note.severity == Severity::Warning);
        let expected = row.name().contains("inconsistent") || mesh.face_count() == 0;
        assert_eq!(warned, expected, "{}: {:?}", row.name(), loaded.notes);
    }
}

/// The lines of a header and where the body starts.
fn header(bytes: &[u8]) -> (Vec<String>, usize) {
    let end = if bytes[3] == b'\r' && bytes[4] != b'\n' { b'\r' } else { b'\n' };
    let (mut lines, mut at) = (Vec::new(), 0);
    for line in bytes.split_inclusive(|byte| *byte == end) {
        at += line.len();
        lines.push(String::from_utf8_lossy(line).trim().to_owned());
        if lines.last().is_some_and(|line| line == "end_header") {
            break;
        }
    }
    (lines, at)
}

/// The size of a number type.
fn size(name: &str) -> usize {
    match name {
        "char" | "uchar" | "int8" | "uint8" => 1,
        "short" | "ushort" | "int16" | "uint16" => 2,
        "double" | "float64" => 8,
        _ => 4,
    }
}

/// A file with the normals of its vertices cut out of header and rows, found without the library's reader. Only for files whose
/// vertices are the first element; else `None`.
fn without_normals(bytes: &[u8]) -> Option<(Vec<String>, Vec<u8>)> {
    let (lines, body) = header(bytes);
    let words = |line: &str| line.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
    let first = lines.iter().position(|line| words(line).first().is_some_and(|word| word == "element"))?;
    let element = words(&lines[first]);
    if element[1] != "vertex" {
        return None;
    }
    let count: usize = element[2].parse().unwrap();
    let of_vertex = lines[first + 1..].iter().take_while(|line| !line.trim_start().starts_with("element"));
    let properties: Vec<Vec<String>> = of_vertex
        .map(|line| words(line))
        .filter(|line| line.first().is_some_and(|word| word == "property"))
        .collect();
    let is_normal = |property: &[String]| ["nx", "ny", "nz"].contains(&property[2].as_str());
    let kept: Vec<String> = lines
        .iter()
        .filter(|line| {
            let line = words(line);
            !(line.first().is_some_and(|word| word == "property") && line.len() > 2 && is_normal(&line))
        })
        .cloned()
        .collect();
    let mut rest = Vec::new();
    let mut at = body;
    if lines.iter().any(|line| line.contains("ascii")) {
        let text = String::from_utf8_lossy(&bytes[body..]);
        let mut lines = text.lines();
        for line in lines.by_ref().filter(|line| !line.trim().is_empty()).take(count) {
            let words = line.split_whitespace().enumerate();
            for (_, word) in
                words.filter(|(k, _)| properties.get(*k).is_none_or(|property| !is_normal(property)))
            {
                rest.extend(word.bytes());
                rest.push(b' ');
            }
            rest.push(b'\n');
        }
        for line in lines {
            rest.extend(line.trim_end().bytes());
            rest.push(b'\n');
        }
        return Some((kept, rest));
    }
    for _ in 0..count {
        for property in &properties {
            let next = at + size(&property[1]);
            if !is_normal(property) {
                rest.extend(&bytes[at..next]);
            }
            at = next;
        }
    }
    rest.extend(&bytes[at..]);
    Some((kept, rest))
}

/// Normals that no file has, one a vertex.
fn spread(mesh: &Mesh) -> PartEdit {
    let direction = |v: usize| DVec3::new((v % 7) as f64 - 3.0, (v % 5) as f64 - 2.0, 1.0).normalize();
    let values = (0..mesh.vertex_count()).map(direction).collect();
    PartEdit { normals: Some(Column::per_vertex(values)), ..PartEdit::default() }
}

#[test]
fn edits_change_nothing_but_normals() {
    let mut compared = 0;
    for row in files() {
        let bytes = row.bytes();
        let loaded = read(&bytes).unwrap();
        assert!(write(&loaded, PartEdit::default()) == bytes, "{}", row.name());
        let mesh = &loaded.parts[0].mesh;
        let written = write(&loaded, spread(mesh));
        if mesh.face_count() == 0 {
            assert!(written == bytes, "{}", row.name());
            continue;
        }
        if let (Some(old), Some(new)) = (without_normals(&bytes), without_normals(&written)) {
            assert_eq!(old.0, new.0, "{}", row.name());
            assert!(old.1 == new.1, "{}: the rows differ", row.name());
            compared += 1;
        }
        let again = read(&written).unwrap();
        let new = &again.parts[0].mesh;
        assert_eq!((new.positions(), new.faces()), (mesh.positions(), mesh.faces()), "{}", row.name());
        let expected = spread(mesh).normals.unwrap().values;
        for (normal, expected) in new.columns().normals.as_ref().unwrap().values.iter().zip(expected) {
            // 16-bit integers are the coarsest type that is kept.
            assert!((*normal - expected).length() < 3e-5, "{}", row.name());
        }
        assert!(write(&again, spread(new)) == written, "{}: the second time", row.name());
    }
    assert!(compared == 0 || compared > 25, "only {compared} compared");
}

#[test]
fn splits_keep_all_attributes() {
    for row in files() {
        let loaded = read(&row.bytes()).unwrap();
        let mesh = &loaded.parts[0].mesh;
        if mesh.face_count() == 0 {
            continue;
        }
        let again = mesh_of(&write(&loaded, flat(&loaded.parts[0])));
        let normals = flat(&loaded.parts[0]).normals.unwrap();
        let corners = mesh.faces().corners().iter().zip(again.faces().corners()).enumerate();
        for (corner, (&old, &new)) in corners {
            let (o, n) = (old as usize, new as usize);
            assert_eq!(mesh.positions().at(o as u32), again.positions().at(n as u32), "{}", row.name());
            let normal = again.columns().normals.as_ref().unwrap().get(corner, new).unwrap();
            assert!((*normal - *normals.get(corner, old).unwrap()).length() < 3e-5, "{}", row.name());
            let colors = [(mesh, o), (&again, n)]
                .map(|(mesh, v)| mesh.columns().colors.as_ref().map(|colors| colors[v]));
            assert_eq!(colors[0], colors[1], "{}", row.name());
            let uvs = [(mesh, old), (&again, new)]
                .map(|(mesh, v)| mesh.columns().uvs.as_ref().and_then(|uvs| uvs.get(corner, v).copied()));
            assert_eq!(uvs[0], uvs[1], "{}", row.name());
        }
        let options = WriteOptions { emit: Emit::Face, ..WriteOptions::default() };
        let by_face = io::write(&loaded, &[flat(&loaded.parts[0])], Format::Ply, &options);
        assert_eq!(by_face.is_err(), row.name().contains("tristrips"), "{}", row.name());
    }
}

#[test]
fn twins_are_the_same() {
    let all = files();
    let find = |name: &str| all.iter().find(|row| row.name() == name).map(|row| mesh_of(&row.bytes()));
    for (a, b) in [
        ("ply/platonic_shelf_le.ply", "ply/platonic_shelf_be.ply"),
        ("ply/platonic_shelf_le.ply", "ply/platonic_shelf_ascii.ply"),
        ("ply/icosahedron_le.ply", "ply/icosahedron_ascii.ply"),
    ] {
        let (Some(a), Some(b)) = (find(a), find(b)) else { continue };
        assert_eq!(a.faces(), b.faces());
        for (a, b) in a.positions().iter().zip(b.positions().iter()) {
            // The text has six digits.
            assert!((a - b).length() < 1e-5 * a.length().max(1.0), "{a} {b}");
        }
    }
}

#[test]
fn broken_files_end_as_the_manifest_expects() {
    for row in rows("bad/", &["ply"]) {
        let result = read(&row.bytes());
        match row.text("expect").split(' ').next().unwrap() {
            "reject" => assert!(result.is_err(), "{}", row.name()),
            "load" => assert_eq!(
                result.unwrap().parts[0].mesh.vertex_count(),
                row.number("verts"),
                "{}",
                row.name()
            ),
            _ => drop(result),
        }
    }
}

/// A small file with everything, in each encoding, made from the ascii one.
fn small_files() -> Vec<Vec<u8>> {
    let ascii = "ply\nformat ascii 1.0\ncomment c\nelement vertex 5\nproperty float x\nproperty float y\nproperty \
        float z\nproperty float nx\nproperty float ny\nproperty float nz\nproperty uchar red\nproperty uchar green\n\
        property uchar blue\nproperty float s\nproperty float t\nelement face 3\nproperty list uchar int \
        vertex_indices\nproperty list uchar float texcoord\nelement edge 1\nproperty int vertex1\nproperty int \
        vertex2\nend_header\n0 0 0 0 0 1 1 2 3 0 0\n1 0 0 0 0 1 1 2 3 1 0\n1 1 0 0 0 1 1 2 3 1 1\n0 1 0 0 0 1 1 2 3 0 \
        1\n2 2 2 0 1 0 1 2 3 0 1\n3 0 1 2 0\n4 0 1 2 3 2 0.5 0.5\n3 0 2 3 0\n0 4\n";
    let rest = "element vertex 3\nproperty short x\nproperty char y\nproperty double z\nproperty short nx\nproperty \
        short ny\nproperty short nz\nelement tristrips 1\nproperty list ushort int vertex_indices\nend_header\n";
    let mut files = vec![ascii.as_bytes().to_vec()];
    for (format, big) in [("binary_little_endian", false), ("binary_big_endian", true)] {
        let mut bytes = format!("ply\r\nformat {format} 1.0\r\n{}", rest.replace('\n', "\r\n")).into_bytes();
        let mut push = |number: &[u8]| {
            let mut number = number.to_vec();
            if big {
                number.reverse();
            }
            bytes.extend(number);
        };
        for k in 0..3_i16 {
            push(&k.to_le_bytes());
            push(&[(k * k) as u8]);
            push(&(f64::from(k) * 0.3).to_le_bytes());
            for normal in [0, 0, 32767_i16] {
                push(&normal.to_le_bytes());
            }
        }
        push(&5_u16.to_le_bytes());
        for index in [0, 1, 2, -1, 0_i32] {
            push(&index.to_le_bytes());
        }
        files.push(bytes);
    }
    files
}

#[test]
fn beginnings_and_flips_do_no_harm() {
    for bytes in small_files() {
        read(&bytes).unwrap();
        let whole = bytes.trim_ascii_end().len();
        for length in 0..bytes.len() {
            // In ascii the last digits of a number may be missing, which no reader can detect; here it has one digit.
            assert!(read(&bytes[..length]).is_err() || length >= whole, "{length} bytes");
        }
        let mut random = Random(11);
        for _ in 0..6000 {
            let mut broken = bytes.clone();
            for _ in 0..1 + random.below(3) {
                let at = random.below(broken.len());
                broken[at] = random.next() as u8;
            }
            let Ok(loaded) = read(&broken) else { continue };
            let written =
                io::write(&loaded, &[flat(&loaded.parts[0])], Format::Ply, &WriteOptions::default());
            let Ok(written) = written else { continue };
            let again = mesh_of(&written.bytes);
            assert_eq!(again.face_count(), loaded.parts[0].mesh.face_count());
            if again.face_count() > 0 {
                let normals = &again.columns().normals.as_ref().unwrap().values;
                // 16-bit integers are the coarsest type that is kept, and stored ones of unused vertices stay.
                assert!(normals.iter().all(|normal| (normal.length() - 1.0).abs() < 0.007));
            }
        }
    }
}
