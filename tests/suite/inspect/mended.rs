//! What `crease inspect` suggests mends what it found.

use super::clean::meshes;
use super::planted::{Planted, faults};
use crate::cli::{crease, path, text};
use crease::io::{Format, Part, WriteOptions, write_new};
use crease::quality::catalogue::Kind;
use serde_json::Value;
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

/// Stores a mesh, carries out what is suggested, and looks again.
fn check(name: &str, planted: Planted) {
    // Text has no spelling for what is no number.
    let format = if planted.expected == Kind::NotFinite { Format::Ply } else { Format::Obj };
    let parts = [Part { mesh: planted.mesh, ..Part::default() }];
    let written = write_new(&parts, format, &WriteOptions::default()).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join(format!("fault.{}", format.extension()));
    fs::write(&file, written.bytes).unwrap();

    let id = planted.expected.id();
    let before = findings(&file);
    let found = named(&before, id).unwrap_or_else(|| panic!("{name}: {id} is not found in {before:?}"));
    let Some(command) = found["command"].as_str() else { return };
    let words: Vec<&str> = command.split(' ').collect();
    let output = crease().args(&words[1..]).output().unwrap();
    assert!(output.status.success(), "{command}: {}", text(&output.stderr));
    let after = findings(Path::new(words[words.iter().position(|word| *word == "-o").unwrap() + 1]));
    assert!(named(&after, id).is_none(), "{name}: {command} leaves {:?}", named(&after, id));
}

#[test]
fn what_is_suggested_mends() {
    for clean in meshes().into_iter().filter(|clean| ["icosphere", "gear"].contains(&clean.name)) {
        faults(&clean).into_iter().for_each(|planted| check(clean.name, planted));
    }
}
