//! STL: real files against their manifest, edits that change nothing but normals, broken files.

use crate::flat::{face_normals, flat};
use crate::meshes::{Row, rows};
use crate::random::Random;
use crease::io::{self, Format, Loaded, PartEdit, ReadError, ReadOptions, Severity, WriteOptions};
use crease::normals::{NormalRecipe, Scope, Weight, When};
use crease::pipeline::{self, Task};
use glam::DVec3;

fn read(bytes: &[u8]) -> Result<Loaded, ReadError> {
    io::read_bytes(bytes.to_vec(), Some(Format::Stl), None, &ReadOptions::default())
}

fn write(loaded: &Loaded, edits: &[PartEdit]) -> Vec<u8> {
    io::write(loaded, edits, Format::Stl, &WriteOptions::default()).unwrap().bytes
}

fn files() -> Vec<Row> {
    rows("stl/", &["stl", "STL"])
}

fn is_binary(bytes: &[u8]) -> bool {
    bytes.len() > 84 && bytes[..84].contains(&0) || bytes.get(80..84).is_some_and(|count| count[3] < 9)
}

#[test]
fn real_files_are_what_the_manifest_says() {
    for row in files() {
        let loaded = io::read(&row.path, None, &ReadOptions::default())
            .unwrap_or_else(|e| panic!("{}: {e}", row.name()));
        let faces: usize = loaded.parts.iter().map(|part| part.mesh.face_count()).sum();
        let vertices: usize = loaded.parts.iter().map(|part| part.mesh.vertex_count()).sum();
        // The manifest's tool took this binary file, whose header begins with `solid`, for text.
        let expected = match row.name() {
            "stl/HalfDonut_binary.stl" => 288,
            _ => row.number("faces"),
        };
        assert_eq!((faces, vertices), (expected, 3 * expected), "{}", row.name());
        let solids = row.text("notes").contains("solids=").then(|| row.noted("solids"));
        assert_eq!(loaded.parts.len(), solids.unwrap_or(1), "{}", row.name());
        assert_eq!(io::detect(&row.bytes(), Some(&row.path)), Some(Format::Stl), "{}", row.name());
        assert!(
            loaded.notes.iter().all(|note| note.severity == Severity::Note)
                || row.name().contains("no_normal")
        );
    }
}

/// A facet whose stored normal is against it at two corners, but not at the first one, where a larger facet decides: it has the new normal.
#[test]
fn a_facet_with_one_good_corner_has_the_new_normal() {
    let text = "solid s\nfacet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n\
         facet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 -3 0\nvertex -3 0 0\nendloop\nendfacet\nendsolid s\n";
    let loaded = read(text.as_bytes()).unwrap();
    let recipe = NormalRecipe { weight: Weight::Area, scope: Scope::Vertex, ..NormalRecipe::default() };
    let task = Task { recipe, emit: io::Emit::Vertex, when: When::Broken, ..Task::default() };
    let revision = pipeline::revise(&loaded, &task, Some(Format::Stl), &|_| {});
    let written = String::from_utf8(write(&loaded, &revision.edits)).unwrap();
    assert_eq!(written, text.replacen("normal 0 0 -1", "normal 0 0 1", 1));
}

/// An ascii file without the numbers of its normals, blanks and line ends aside.
fn without_normals(text: &[u8]) -> Vec<String> {
    let text = String::from_utf8_lossy(text);
    let mut words = Vec::new();
    let mut skip = 0;
    for word in text.split_whitespace() {
        if skip > 0 && word.parse::<f64>().is_ok() {
            skip -= 1;
            continue;
        }
        skip = 0;
        if word.eq_ignore_ascii_case("normal") {
            skip = 3;
        } else {
            words.push(word.to_owned());
        }
    }
    words
}

#[test]
fn edits_change_nothing_but_normals() {
    for row in files() {
        let bytes = row.bytes();
        let loaded = read(&bytes).unwrap();
        assert_eq!(write(&loaded, &[]), bytes, "{}", row.name());
        let edits: Vec<PartEdit> = loaded.parts.iter().map(flat).collect();
        let written = write(&loaded, &edits);
        if is_binary(&bytes) {
            assert_eq!(written.len(), bytes.len(), "{}", row.name());
            let facets = 84 + 50 * loaded.parts[0].mesh.face_count();
            for (at, (old, new)) in bytes.iter().zip(&written).enumerate() {
                let in_normal = at >= 84 && at < facets && (at - 84) % 50 < 12;
                assert!(in_normal || old == new, "{}: byte {at}", row.name());
            }
        } else {
            assert_eq!(without_normals(&written), without_normals(&bytes), "{}", row.name());
        }
        let again = read(&written).unwrap();
        for (part, other) in loaded.parts.iter().zip(&again.parts) {
            assert_eq!(part.mesh.positions(), other.mesh.positions(), "{}", row.name());
            let Some(stored) = &other.mesh.columns().normals else { continue };
            for (normal, expected) in stored.values.iter().zip(face_normals(&part.mesh)) {
                // One rounding to f32 in each component.
                assert!((*normal - expected).length() < 1.1e-7, "{}", row.name());
            }
        }
        let edits: Vec<PartEdit> = again.parts.iter().map(flat).collect();
        assert_eq!(write(&again, &edits), written, "{}: the second time", row.name());
    }
}

#[test]
fn ascii_and_binary_twins_are_the_same() {
    let all = files();
    let find = |name: &str| all.iter().find(|row| row.name() == name);
    for (ascii, binary) in [
        ("stl/HalfDonut_ascii.stl", "stl/HalfDonut_binary.stl"),
        ("stl/icosahedron_ascii.stl", "stl/icosahedron_binary.stl"),
        ("stl/Spider_ascii_flipped.stl", "stl/Spider_binary_flipped.stl"),
    ] {
        let (Some(ascii), Some(binary)) = (find(ascii), find(binary)) else { continue };
        let [a, b] = [ascii, binary].map(|row| read(&row.bytes()).unwrap().parts.remove(0).mesh);
        assert_eq!(a.face_count(), b.face_count());
        for (a, b) in a.positions().iter().zip(b.positions().iter()) {
            // Spider's text has six digits.
            assert!((a - b).length() < 1e-5 * b.length().max(1.0), "{}: {a} and {b}", ascii.name());
        }
    }
}

#[test]
fn broken_files_end_as_the_manifest_expects() {
    for row in rows("bad/", &["stl"]) {
        let result = read(&row.bytes());
        match row.text("expect").split(' ').next().unwrap() {
            "reject" => assert!(result.is_err(), "{}", row.name()),
            "load" => {
                let loaded = result.unwrap_or_else(|error| panic!("{}: {error}", row.name()));
                let faces: usize = loaded.parts.iter().map(|part| part.mesh.face_count()).sum();
                assert_eq!(faces, row.number("faces"), "{}", row.name());
                let warns = loaded.notes.iter().any(|note| note.severity == Severity::Warning);
                assert_eq!(warns, row.text("expect").contains("warning"), "{}", row.name());
            }
            _ => drop(result),
        }
    }
}

fn small_files() -> Vec<Vec<u8>> {
    let facet = "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n endloop\nendfacet\n";
    let ascii = format!("solid a # b\n{facet}{facet}endsolid a\nsolid\n{facet}endsolid\n");
    let mut binary = b"solid header".to_vec();
    binary.resize(80, b' ');
    binary.extend(3_u32.to_le_bytes());
    for k in 0..36 {
        binary.extend(libm::sinf(k as f32 * 0.7).to_le_bytes());
        if k % 12 == 11 {
            binary.extend([1, 2]);
        }
    }
    vec![ascii.into_bytes(), binary]
}

/// Whatever can be read can be written, and then has unit normals.
fn try_bytes(bytes: &[u8]) {
    let Ok(loaded) = read(bytes) else { return };
    let edits: Vec<PartEdit> = loaded.parts.iter().map(flat).collect();
    let again = read(&write(&loaded, &edits)).unwrap();
    let stored = again.parts.iter().filter_map(|part| part.mesh.columns().normals.as_ref());
    assert!(stored.flat_map(|normals| &normals.values).all(|n: &DVec3| (n.length() - 1.0).abs() < 1e-6));
}

#[test]
fn beginnings_and_flips_do_no_harm() {
    for bytes in small_files() {
        for length in 0..bytes.len() {
            let result = read(&bytes[..length]);
            // The last line end, and what is behind `endsolid` of a whole solid, may be missing.
            let may_load = bytes[..length].windows(8).any(|word| word == b"endsolid");
            assert!(result.is_err() || may_load, "{length} bytes");
        }
        let mut random = Random(7);
        for _ in 0..5000 {
            let mut broken = bytes.clone();
            for _ in 0..1 + random.below(3) {
                let at = random.below(broken.len());
                broken[at] = random.next() as u8;
            }
            try_bytes(&broken);
        }
    }
}
