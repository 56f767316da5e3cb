use crate::io::{Format, Limits, Loaded, Problem, ReadError, ReadOptions, Severity, read_bytes};
use glam::DVec3;
use std::io::{Cursor, Write};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

const RELATIONS: &str = "<Relationships><Relationship Target='/3D/3dmodel.model' Id='r' \
    Type='http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel'/></Relationships>";

const TRIANGLE: &str = "<mesh><vertices><vertex x='0' y='0' z='0'/><vertex x='1' y='0' z='0'/><vertex x='0' y='1' z='0'/>\
    </vertices><triangles><triangle v1='0' v2='1' v3='2'/></triangles></mesh>";

fn archive(parts: &[(&str, &str)], method: CompressionMethod) -> Vec<u8> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, text) in parts {
        zip.start_file(*name, SimpleFileOptions::default().compression_method(method)).unwrap();
        zip.write_all(text.as_bytes()).unwrap();
    }
    zip.finish().unwrap().into_inner()
}

fn package(model: &str) -> Vec<u8> {
    archive(&[("_rels/.rels", RELATIONS), ("3D/3dmodel.model", model)], CompressionMethod::Deflated)
}

fn read(bytes: Vec<u8>) -> Result<Loaded, ReadError> {
    read_bytes(bytes, None, None, &ReadOptions::default())
}

/// A model with these resources and this build.
fn model(resources: &str, build: &str) -> String {
    format!("<model unit='inch'><resources>{resources}</resources><build>{build}</build></model>")
}

#[test]
fn objects_are_placed_by_items_and_components_of_several_parts() {
    let main = model(
        "<object id='1'><components><component objectid='7' p:path='/3D/Objects/a.model' \
        transform='0 1 0 -1 0 0 0 0 1 10 0 0'/><component p:path='/3D/Objects/a.model' objectid='7'/></components></object>",
        "<item objectid='1' transform='2 0 0 0 2 0 0 0 2 0 0 5'/>",
    );
    let other = model(&format!("<object id='7' name='a &amp; b' pid='3'>{TRIANGLE}</object>"), "");
    let parts = [("_rels/.rels", RELATIONS), ("3D/3dmodel.model", &main), ("3D/Objects/a.model", &other)];
    let loaded = read(archive(&parts, CompressionMethod::Deflated)).unwrap();
    assert_eq!((loaded.format, loaded.parts.len(), loaded.nodes.len()), (Format::ThreeMf, 1, 2));
    assert_eq!(loaded.node_paths(&[1]), ["a & b"]);
    // Scaled after it was rotated by 90° and moved: (x, y) becomes (10 − y, x).
    let corner = |node: usize, at| loaded.nodes[node].world_from_part.transform_point3(at);
    assert_eq!(corner(0, DVec3::X), DVec3::new(20.0, 2.0, 5.0));
    assert_eq!(corner(1, DVec3::X), DVec3::new(2.0, 0.0, 5.0));
    let notes: Vec<_> = loaded.notes.iter().map(|note| (note.severity, &*note.text)).collect();
    let unit = (Severity::Note, "positions are in inches (--scale in), with z up (--up z)");
    assert_eq!(notes, [unit, (Severity::Warning, "materials and colours are omitted")]);
}

/// The limit holds for the package: here half of it and one more in each of two parts.
#[test]
fn parts_count_together() {
    let crowd = "<object id='1'/>".repeat(1 << 15);
    let main = model(&crowd, "<item objectid='1' p:path='/b.model'/>");
    let other = model(&crowd, "");
    let parts = [("_rels/.rels", RELATIONS), ("3D/3dmodel.model", &main), ("b.model", &other)];
    let error = read(archive(&parts, CompressionMethod::Deflated)).unwrap_err();
    assert!(error.problem == Problem::Limit && error.found.contains("in `b.model`"), "{error:?}");
}

#[test]
fn an_unknown_unit_is_reported() {
    let text = model(&format!("<object id='1'>{TRIANGLE}</object>"), "").replace("inch", "parsec");
    assert_eq!(
        read(package(&text)).unwrap().notes[0].text,
        "positions are in an unknown unit, with z up (--up z)"
    );
}

#[test]
fn an_object_without_items_is_placed_once_and_other_elements_are_named() {
    let mesh = TRIANGLE.replace("</mesh>", "<b:beamlattice><b:beams/></b:beamlattice></mesh>");
    let loaded = read(package(&model(&format!("<object id='1'>{mesh}</object>"), ""))).unwrap();
    assert_eq!((loaded.parts[0].mesh.face_count(), loaded.nodes.len()), (1, 0));
    assert_eq!(loaded.notes[1].text, "omitted from meshes: `beamlattice`, `beams`");
}

#[test]
fn packages_with_errors_are_refused_with_the_place_and_the_fact() {
    let object = |text: &str| model(&format!("<object id='1'>{text}</object>"), "<item objectid='1'/>");
    let component = |id: u32, of: u32| {
        format!("<object id='{id}'><components><component objectid='{of}'/></components></object>")
    };
    // Each object has two of the next one: 2^40 placements of nothing.
    let doubling: String = (1..40)
        .map(|id| {
            let next = format!("<component objectid='{}'/>", id + 1).repeat(2);
            format!("<object id='{id}'><components>{next}</components></object>")
        })
        .chain(["<object id='40'/>".to_owned()])
        .collect();
    let chain: String =
        (1..100).map(|id| component(id, id + 1)).chain(["<object id='100'/>".to_owned()]).collect();
    let crowd = "<object id='1'/>".repeat(70_000);
    let item = "<item objectid='1'/>";
    for (text, problem, found) in [
        (
            object(&TRIANGLE.replace("v3='2'", "v3='3'")),
            Problem::Range,
            "triangle 0: vertex index 3 is out of range",
        ),
        (
            object(&TRIANGLE.replace("v3='2'", "v3='-1'")),
            Problem::Syntax,
            "`-1` is not a number: `v3` of a `triangle`",
        ),
        (object(&TRIANGLE.replace("y='1'", "")), Problem::Syntax, "a `vertex` has no `y`"),
        (object(&TRIANGLE.replace("y='1'", "y='nan'")), Problem::NonFinite, "vertex 2"),
        (model("", item), Problem::Range, "object 1 is used, but `/3D/3dmodel.model` has none"),
        (model(&component(1, 1), item), Problem::Range, "object 1 is a component of itself"),
        (
            model(&(component(1, 2) + &component(2, 1)), item),
            Problem::Range,
            "object 1 is a component of itself",
        ),
        (model(&doubling, item), Problem::Limit, "the build places more than 65536 objects"),
        (model(&chain, item), Problem::Limit, "nested more than 64 deep"),
        (model(&crowd, ""), Problem::Limit, "more than 65536 objects, components and items"),
        (
            object(TRIANGLE).replace("'/></build>", "' transform='1 0 0'/></build>"),
            Problem::Syntax,
            "12 numbers",
        ),
        (
            object(TRIANGLE).replace("'/></build>", "' p:path='/a.model'/></build>"),
            Problem::Companion,
            "`a.model`",
        ),
        (
            object(TRIANGLE).replace("<model", "<model xmlns:b='urn:beams' requiredextensions='b'"),
            Problem::Unsupported,
            "requires the extension b (urn:beams)",
        ),
        (
            format!("<!DOCTYPE a [<!ENTITY a 'b'>]>{}", object(TRIANGLE)),
            Problem::Unsupported,
            "document types",
        ),
        (object(TRIANGLE).replace("</build>", ""), Problem::Syntax, "in `3D/3dmodel.model`, byte "),
        ("<model><resources>".into(), Problem::Truncated, "an element has no end"),
    ] {
        let error = read(package(&text)).unwrap_err();
        let shown = &text[..text.len().min(300)];
        assert!(error.problem == problem && error.found.contains(found), "{shown}: {error:?}");
        assert!(!error.advice.is_empty());
    }
    let parts = [("_rels/.rels", "<Relationships/>"), ("3D/3dmodel.model", "<model/>")];
    let found = |parts| read(archive(parts, CompressionMethod::Stored)).unwrap_err().found;
    assert!(found(&parts).contains("names no 3D model"));
    assert!(found(&parts[1..]).contains("`_rels/.rels` cannot be read"));
}

/// A thousandth of what it unpacks to.
#[test]
fn what_unpacks_to_too_much_is_refused() {
    let bytes = package(&model(&" ".repeat(1 << 20), ""));
    assert!(bytes.len() < 4000);
    let limits = Limits { bytes: 1 << 19, ..Limits::default() };
    let error = read_bytes(bytes, None, None, &ReadOptions { limits, ..ReadOptions::default() }).unwrap_err();
    assert!(error.problem == Problem::Limit && error.found.contains("unpacked"), "{error:?}");
}

#[test]
fn damaged_packages_load_or_are_refused() {
    let text = model(&format!("<object id='1' name='a'>{TRIANGLE}</object>"), "<item objectid='1'/>");
    let try_read = |bytes: Vec<u8>| {
        if let Err(error) = read_bytes(bytes, Some(Format::ThreeMf), None, &ReadOptions::default()) {
            assert!(!error.found.is_empty() && !error.advice.is_empty(), "{error:?}");
        }
    };
    let whole = package(&text);
    (0..whole.len()).for_each(|length| try_read(whole[..length].to_vec()));
    let mut state = 7_u64;
    let mut random = |below: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % below
    };
    for _ in 0..2000 {
        let mut bytes = whole.clone();
        let at = random(bytes.len());
        bytes[at] = random(256) as u8;
        try_read(bytes);
        // The checksum of the archive stays right.
        let mut text = text.clone().into_bytes();
        let at = random(text.len());
        text[at] = b" '</>&=a0-."[random(11)];
        try_read(package(std::str::from_utf8(&text).unwrap()));
    }
}
