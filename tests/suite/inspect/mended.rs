//! What `crease inspect` suggests mends what it found.

use super::clean::meshes;
use super::planted::{Planted, faults};
use super::{recipe, with_normals};
use crate::cli::{crease, path, text};
use crease::io::{Format, Part, WriteOptions, write_new};
use crease::mesh::Mesh;
use crease::normals::Weight;
use crease::quality::catalogue::{Kind, entries};
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// What the program finds in a file.
fn findings(file: &Path) -> Vec<Value> {
    let output = crease().args(["inspect", "--json", &path(file)]).output().unwrap();
    assert!(output.status.success(), "{}", text(&output.stderr));
    let report: Value = serde_json::from_str(text(&output.stdout)).unwrap();
    report["findings"].as_array().unwrap().clone()
}

fn named<'a>(findings: &'a [Value], id: &str) -> Option<&'a Value> {
    findings.iter().find(|finding| finding["id"] == id)
}

/// A file with a fault.
struct Faulty {
    kind: Kind,
    format: Format,
    bytes: Vec<u8>,
}

impl Faulty {
    fn text(kind: Kind, text: &str) -> Self {
        Self { kind, format: Format::Obj, bytes: text.as_bytes().to_vec() }
    }

    fn mesh(kind: Kind, mesh: Mesh) -> Self {
        // Text has no spelling for what is no number.
        let format = if kind == Kind::NotFinite { Format::Ply } else { Format::Obj };
        let written =
            write_new(&[Part { mesh, ..Part::default() }], format, &WriteOptions::default()).unwrap();
        Self { kind, format, bytes: written.bytes }
    }

    /// A mesh below a node that turns it.
    fn below_node(planted: Planted) -> Self {
        let node = planted.node.expect("it stands somewhere");
        let parts = [Part { mesh: planted.mesh, ..Part::default() }];
        let written = write_new(&parts, Format::Gltf, &WriteOptions::default()).unwrap();
        let mut document: Value = serde_json::from_slice(&written.bytes).unwrap();
        document["nodes"][0]["matrix"] = node.to_cols_array().to_vec().into();
        Self { kind: planted.expected, format: Format::Gltf, bytes: document.to_string().into_bytes() }
    }

    /// Stores the file, carries out what is suggested, and looks again; tells whether anything is.
    fn check(&self, name: &str) -> bool {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join(format!("fault.{}", self.format.extension()));
        fs::write(&file, &self.bytes).unwrap();
        let id = self.kind.id();
        let before = findings(&file);
        let found = named(&before, id).unwrap_or_else(|| panic!("{name}: {id} is not found in {before:?}"));
        let Some(command) = found["command"].as_str() else { return false };
        let words: Vec<&str> = command.split(' ').collect();
        let output = crease().args(&words[1..]).output().unwrap();
        assert!(output.status.success(), "{command}: {}", text(&output.stderr));
        let after = findings(Path::new(words[words.iter().position(|word| *word == "-o").unwrap() + 1]));
        assert!(named(&after, id).is_none(), "{name}: {command} leaves {:?}", named(&after, id));
        true
    }
}

/// Faults that are told of files rather than planted into clean meshes.
fn others(ball: &Mesh) -> Vec<Faulty> {
    let bare = ball.clone().with_normals(None);
    let flat = with_normals(bare.clone(), &recipe(Weight::Angle, 0.0));
    let corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\n";
    let attributes = super::attributes::faulty();
    let attributes = attributes.map(|(kind, bytes)| Faulty { kind, format: Format::Gltf, bytes });
    let mut all = vec![
        Faulty::mesh(Kind::NoNormals, bare),
        Faulty::mesh(Kind::Faceted, flat),
        Faulty::text(Kind::MissingNormals, &format!("{corners}f 1//1 2//1 3//1\nf 1 3 4\n")),
        Faulty::text(Kind::ZeroArea, &format!("{corners}f 1//1 2//1 3//1 4//1\nf 1//1 2//1 2//1\n")),
    ];
    all.extend(attributes);
    all
}

/// Every kind of finding that a command mends is planted somewhere, found, and gone after that command.
#[test]
fn what_is_suggested_mends() {
    let mut mended = BTreeSet::new();
    for clean in meshes().into_iter().filter(|clean| ["icosphere", "bowl", "gear"].contains(&clean.name)) {
        let only_here = |kind: Kind| clean.name != "bowl" || kind == Kind::OpenInsideOut;
        for planted in faults(&clean).into_iter().filter(|planted| only_here(planted.expected)) {
            let kind = planted.expected;
            let faulty = match planted.node {
                Some(_) => Faulty::below_node(planted),
                None => Faulty::mesh(kind, planted.mesh),
            };
            mended.extend(faulty.check(clean.name).then_some(kind));
        }
        if clean.name == "icosphere" {
            let others = others(&clean.mesh);
            mended
                .extend(others.into_iter().filter(|faulty| faulty.check("others")).map(|faulty| faulty.kind));
        }
    }
    let mendable = entries().filter(|entry| entry.remedy.is_some()).map(|entry| entry.kind);
    let untried: Vec<&str> = mendable.filter(|kind| !mended.contains(kind)).map(Kind::id).collect();
    assert!(untried.is_empty(), "not tried: {untried:?}");
}
