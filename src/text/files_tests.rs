//! All Fluent files of the source tree, read as text: keys, placeholders, and their use in the code.

use fluent_bundle::FluentResource;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// The messages of a file with the placeholders of each.
fn messages(source: &str) -> Result<BTreeMap<String, BTreeSet<String>>, String> {
    FluentResource::try_new(source.to_owned()).map_err(|(_, errors)| format!("{errors:?}"))?;
    let mut found: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    let mut current = None;
    for line in source.lines() {
        if line.starts_with(|c: char| c.is_ascii_lowercase()) {
            let key = line.split([' ', '=']).next().unwrap_or("").to_owned();
            if found.insert(key.clone(), BTreeSet::new()).is_some() {
                return Err(format!("{key} is defined twice"));
            }
            current = Some(key);
        }
        let Some(placeholders) = current.as_ref().and_then(|key| found.get_mut(key)) else { continue };
        for part in line.split('$').skip(1) {
            let name: String = part.chars().take_while(|c| c.is_ascii_alphanumeric() || *c == '-').collect();
            placeholders.insert(name);
        }
    }
    Ok(found)
}

fn files(folder: &Path, extension: &str, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files(&path, extension, found);
        } else if path.extension().is_some_and(|own| own == extension) {
            found.push(path);
        }
    }
}

fn source() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

/// All string literals of the source files below a folder, roughly: what stands between two quotation marks.
fn literals(folder: &Path) -> BTreeSet<String> {
    let mut paths = Vec::new();
    files(folder, "rs", &mut paths);
    let texts = paths.iter().map(|path| std::fs::read_to_string(path).unwrap());
    let is_key = |text: &&str| !text.is_empty() && !text.contains(char::is_whitespace);
    texts.flat_map(|text| text.split('"').filter(is_key).map(str::to_owned).collect::<Vec<_>>()).collect()
}

/// `item` for `item-2` and `item-2-caption`: keys of lists are made of a stem and a number.
fn stem(key: &str) -> Option<&str> {
    let digit = key.find(|c: char| c.is_ascii_digit())?;
    key[..digit].strip_suffix('-')
}

#[test]
fn languages_have_the_same_keys_and_placeholders() {
    let mut paths = Vec::new();
    files(&source(), "ftl", &mut paths);
    for path in &paths {
        let name = path.to_str().unwrap();
        let english =
            messages(&std::fs::read_to_string(path).unwrap()).unwrap_or_else(|e| panic!("{name}: {e}"));
        let Some(start) = name.strip_suffix(".en.ftl") else {
            assert!(name.ends_with(".pt.ftl"), "{name} has no language");
            let other = name.replace(".pt.ftl", ".en.ftl");
            assert!(Path::new(&other).exists(), "{name} has no English text");
            continue;
        };
        let Ok(other) = std::fs::read_to_string(format!("{start}.pt.ftl")) else { continue };
        let portuguese = messages(&other).unwrap_or_else(|e| panic!("{start}.pt.ftl: {e}"));
        let keys = |texts: &BTreeMap<String, _>| texts.keys().cloned().collect::<BTreeSet<_>>();
        let differing: Vec<_> = keys(&english).symmetric_difference(&keys(&portuguese)).cloned().collect();
        assert!(differing.is_empty(), "{start}: in one language only: {differing:?}");
        for (key, placeholders) in &english {
            assert_eq!(placeholders, &portuguese[key], "{start}: placeholders of {key} differ");
        }
    }
}

#[test]
fn every_key_is_used() {
    let mut paths = Vec::new();
    files(&source(), "ftl", &mut paths);
    // The keys of the program's help are names of options and values; a test of `cli` compares them.
    for path in paths.iter().filter(|path| !path.starts_with(source().join("cli"))) {
        let module = path.strip_prefix(source()).unwrap().components().next().unwrap();
        let used = literals(&source().join(module));
        let stems: BTreeSet<&str> =
            used.iter().filter_map(|text| text.strip_suffix("-{").or(Some(text))).collect();
        for key in messages(&std::fs::read_to_string(path).unwrap()).unwrap().keys() {
            // Findings have their texts by id and part.
            let of_finding =
                || key.rsplit_once('-').is_some_and(|(id, part)| used.contains(id) && used.contains(part));
            // `format!("axis-{}", …)` makes the keys of all axes.
            let is_made = || {
                let starts = used.iter().filter_map(|text| text.strip_suffix("{}"));
                starts.into_iter().any(|start| start.ends_with('-') && key.starts_with(start))
            };
            let is_used = used.contains(key)
                || of_finding()
                || is_made()
                || stem(key).is_some_and(|stem| stems.contains(stem));
            assert!(is_used, "{}: no source file of its module names {key}", path.display());
        }
    }
}

#[test]
fn every_key_that_the_code_names_exists() {
    let mut paths = Vec::new();
    files(&source(), "rs", &mut paths);
    for path in paths.iter().filter(|path| !path.starts_with(source().join("text"))) {
        let text = std::fs::read_to_string(path).unwrap();
        // A file that names a catalogue of its own has its keys there; others use one of their folder's.
        let own: Vec<&str> =
            text.split("catalogue!(\"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
        let folder = path.parent().unwrap();
        let mut catalogues = Vec::new();
        if own.is_empty() {
            files(folder, "ftl", &mut catalogues);
            files(folder.parent().unwrap(), "ftl", &mut catalogues);
        }
        catalogues.extend(own.iter().map(|name| folder.join(format!("{name}.en.ftl"))));
        let known: BTreeSet<String> = catalogues
            .iter()
            .flat_map(|path| messages(&std::fs::read_to_string(path).unwrap()).unwrap().into_keys())
            .collect();
        for (call, parts) in CALLS {
            for rest in text.split(call).skip(1) {
                let Some(name) = rest.trim_start().strip_prefix('"').and_then(|rest| rest.split('"').next())
                else {
                    continue;
                };
                for part in *parts {
                    let key = format!("{name}{part}");
                    assert!(known.contains(&key), "{}: no text for {key}", path.display());
                }
            }
        }
    }
}

/// Calls that name a key, or the start of keys with these ends.
const CALLS: &[(&str, &[&str])] = &[
    ("TEXTS.get(", &[""]),
    ("TEXTS.with(", &[""]),
    ("SHARED.get(", &[""]),
    ("REMARKS.get(", &[""]),
    ("REMARKS.with(", &[""]),
    ("texts.get(", &[""]),
    ("texts.with(", &[""]),
    ("out.text(", &[""]),
    ("Check::Untested(", &[""]),
    ("out.measure(", &["-measure"]),
    ("out.effect(", &["-effect", "-cure"]),
    ("out.bad(", &["-title", "-caption"]),
    ("out.cured(", &["-title", "-caption"]),
    ("out.truth(", &["-title", "-caption"]),
    ("out.seen(", &["-title", "-caption"]),
    ("out.difference(", &["-title", "-caption"]),
    ("out.curve(", &["-curve"]),
    ("out.chart(", &["-title", "-caption", "-x", "-y"]),
];

#[test]
fn faults_of_files_are_found() {
    assert!(messages("a = x { $n }\na = y\n").is_err());
    assert!(messages("a = { $n\n").is_err());
    assert_eq!(messages("a = x { $n }\n  y { $m }\n").unwrap()["a"].len(), 2);
    assert_eq!(
        (stem("formula-1-says"), stem("formula-12"), stem("plain")),
        (Some("formula"), Some("formula"), None)
    );
}
