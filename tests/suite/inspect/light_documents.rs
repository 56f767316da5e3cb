//! The diagnosis of a file does not depend on the data that only writing needs.

use super::{recipe, surface, with_normals};
use crease::io::{
    Document, Emit, Format, Loaded, Part, ReadOptions, WriteError, WriteOptions, read, read_bytes, write,
    write_new,
};
use crease::mesh::Column;
use crease::normals::{Weight, compute};
use crease::quality::catalogue::Kind;
use crease::quality::{Diagnosis, Thresholds, diagnose};
use crease::surface::{Sphere, Surface};
use std::path::Path;

fn reported(file: &Loaded) -> Diagnosis {
    diagnose(file, &Thresholds::default(), &|_| {})
}

#[test]
fn files_are_reported_alike_without_their_source() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("data");
    let (mut formats, mut findings) = (Vec::new(), 0);
    for entry in folder.read_dir().unwrap() {
        let path = entry.unwrap().path();
        let Some(format) = Format::from_path(&path) else { continue };
        let file = read(&path, None, &ReadOptions::default()).unwrap();
        let before = reported(&file);
        findings += before.findings.len();
        assert_eq!(reported(&file.without_source()), before, "{}", path.display());
        formats.push(format);
    }
    assert!(findings > 10, "{findings}");
    for format in [Format::Obj, Format::Ply, Format::Stl, Format::Gltf, Format::Glb] {
        assert!(formats.contains(&format), "{format}");
    }
}

/// A ball as STL stores it. One facet in 50 has an inverted normal, and another one has reversed winding.
fn ball() -> Loaded {
    let mesh =
        with_normals(surface(&Surface::from(Sphere::default()), [24, 12]), &recipe(Weight::Angle, 0.0));
    let normals = compute(&mesh, &recipe(Weight::Angle, 0.0)).face_normals;
    let normals =
        normals.iter().enumerate().map(|(face, &normal)| if face % 50 == 7 { -normal } else { normal });
    let index = (0..mesh.faces().corner_count() as u32).map(|corner| corner / 3).collect();
    let mesh = mesh.with_normals(Some(Column::per_corner(normals.collect(), index)));
    let part = Part { mesh, ..Part::default() };
    let options = WriteOptions { emit: Emit::Face, ..WriteOptions::default() };
    let mut bytes = write_new(&[part], Format::Stl, &options).unwrap().bytes;
    // Its second and third vertex.
    let facet = 84 + 50 * 130;
    let (second, third) = bytes[facet + 24..facet + 48].split_at_mut(12);
    second.swap_with_slice(third);
    read_bytes(bytes, Some(Format::Stl), None, &ReadOptions::default()).unwrap()
}

/// Vertices are shared but keep their numbers in the file, three for each facet.
#[test]
fn facets_that_share_their_vertices_are_reported_alike() {
    let file = ball();
    let before = reported(&file);
    let flipped = before.get(Kind::Flipped).unwrap();
    assert_eq!(flipped.count % 3, 0);
    let places = flipped.places.iter().chain(&before.get(Kind::InconsistentWinding).unwrap().places);
    for site in places.filter(|site| site.vertex.is_some()) {
        assert_eq!(site.vertex, Some(3 * site.face.unwrap() + site.corner.unwrap()));
    }
    let corners = file.parts[0].mesh.vertex_count();
    let file = file.without_source();
    assert!(5 * file.parts[0].mesh.vertex_count() < corners);
    let after = reported(&file);
    assert_eq!(after.parts, before.parts);
    let counts = |diagnosis: &Diagnosis| -> Vec<(Kind, u64)> {
        diagnosis.findings.iter().map(|finding| (finding.kind, finding.count)).collect()
    };
    assert_eq!(counts(&after), counts(&before));
    assert_eq!(after, before);
}

#[test]
fn a_text_that_was_let_go_of_is_not_rewritten() {
    let text = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let file = read_bytes(text.to_vec(), Some(Format::Obj), None, &ReadOptions::default()).unwrap();
    assert!(file.document.is_unchanged(text));
    let file = file.without_source().without_source();
    let Document::Obj(document) = &file.document else { panic!("it was OBJ") };
    assert_eq!((document.lines().of_face(0), document.lines().of_vertex(2)), (Some(4), Some(3)));
    assert!(!file.document.is_unchanged(text));
    let refused = write(&file, &[], Format::Obj, &WriteOptions::default());
    assert!(matches!(refused, Err(WriteError::Unsupported(_))));
    assert!(write(&file, &[], Format::Ply, &WriteOptions::default()).is_ok());
}
