//! README and docs: every command runs and prints what the page shows, every link leads somewhere, every word is plain.

mod commands;
mod words;

use std::fs;
use std::path::{Path, PathBuf};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// README.md and all pages of docs/ and data/, with their text.
fn pages() -> Vec<(PathBuf, String)> {
    let docs = fs::read_dir(root().join("docs")).unwrap().map(|entry| entry.unwrap().path());
    let mut paths: Vec<PathBuf> = docs.filter(|path| path.extension().is_some_and(|e| e == "md")).collect();
    let others = ["README.md", "CHANGELOG.md", "CONTRIBUTING.md", "data/README.md"];
    paths.extend(others.map(|name| root().join(name)));
    paths.sort();
    paths.into_iter().map(|path| (path.clone(), fs::read_to_string(path).unwrap())).collect()
}

/// Sources that a page names are in the repository. `ID` is a placeholder.
#[test]
fn named_sources_exist() {
    let of = |folder: &str| [".rs", ".ftl"].map(|ending| sources(&root().join(folder), ending)).concat();
    let all: Vec<String> = ["src", "tests", "benches", "bindings/web/src", "bindings/python/src"]
        .map(of)
        .concat()
        .into_iter()
        .map(|it| it.0)
        .collect();
    let exists = |name: &str| {
        let inside = format!("/{name}");
        all.iter().any(|path| format!("/{path}").ends_with(&inside))
    };
    let is_source = |code: &&str| {
        let is_name = code.chars().all(|c| c.is_ascii_alphanumeric() || "_-./".contains(c));
        is_name && !code.contains("ID") && (code.ends_with(".rs") || code.ends_with(".ftl"))
    };
    let (mut missing, mut count) = (Vec::new(), 0);
    for (page, text) in pages() {
        for name in text.split('`').skip(1).step_by(2).filter(is_source) {
            count += 1;
            if !exists(name) {
                missing.push(format!("{}: {name}", page.display()));
            }
        }
    }
    assert!(missing.is_empty() && count >= 40, "{missing:?} of {count}");
    assert!(exists("src/normals/compute.rs") && exists("creases/fans.rs") && !exists("no_such_file.rs"));
}

/// All files of a kind below a folder, with their paths from the root.
fn sources(folder: &Path, ending: &str) -> Vec<(String, String)> {
    let mut found = Vec::new();
    for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        if path.is_dir() {
            found.extend(sources(&path, ending));
        } else if path.to_string_lossy().ends_with(ending) {
            let name = path.strip_prefix(root()).unwrap().to_string_lossy().replace('\\', "/");
            found.push((name, fs::read_to_string(path).unwrap()));
        }
    }
    found.sort();
    found
}

#[test]
fn links_lead_somewhere() {
    let slug = |heading: &str| -> String {
        let kept = heading.to_lowercase();
        kept.chars()
            .filter(|c| c.is_alphanumeric() || " -_".contains(*c))
            .map(|c| if c == ' ' { '-' } else { c })
            .collect()
    };
    let headings = |text: &str| -> Vec<String> {
        text.lines()
            .filter(|line| line.starts_with('#'))
            .map(|line| slug(line.trim_start_matches('#').trim()))
            .collect()
    };
    let (mut broken, mut count) = (Vec::new(), 0);
    for (page, text) in pages() {
        for link in text.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            count += 1;
            let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
            let target = if file.is_empty() { page.clone() } else { page.parent().unwrap().join(file) };
            let has_anchor = || {
                anchor.is_empty()
                    || fs::read_to_string(&target)
                        .is_ok_and(|text| headings(&text).iter().any(|h| h == anchor))
            };
            if !target.exists() || !has_anchor() {
                broken.push(format!("{}: {link}", page.display()));
            }
        }
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
    assert!(count >= 40, "only {count} links were found");
}

#[test]
fn the_readme_is_short_and_its_library_examples_work() {
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    assert!(readme.lines().count() <= 250, "{} lines", readme.lines().count());
    let marked = include_str!("docs.rs").split("// README example: begin\n").skip(1);
    let examples: Vec<&str> = marked.filter_map(|rest| rest.split("// README example: end").next()).collect();
    assert_eq!(examples.len(), 2);
    for line in examples.concat().lines().map(str::trim).filter(|line| !line.is_empty()) {
        assert!(readme.contains(line), "not in the README: {line}");
    }
    slices().unwrap();
    // The example reads from the working folder, which other tests use too: there is no such file in it.
    assert!(files().is_err());
}

#[rustfmt::skip]
fn files() -> Result<(), Box<dyn std::error::Error>> {
    // README example: begin
    use crease::{io, pipeline};

    let loaded = io::read("gear.obj".as_ref(), None, &io::ReadOptions::default())?;
    let revision = pipeline::revise(&loaded, &pipeline::Task::default(), Some(io::Format::Glb), &|_| {});
    let written = io::write(&loaded, revision.edits, io::Format::Glb, &io::WriteOptions::default())?;
    std::fs::write("gear.glb", written.bytes)?;
    // README example: end
    Ok(())
}

#[rustfmt::skip]
fn slices() -> Result<(), Box<dyn std::error::Error>> {
    // README example: begin
    use crease::normals::{Averaging, Scratch, Weight, vertex_normals};

    let positions = [[0.0_f32, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, -1.0], [-1.0, 0.0, -1.0]];
    let triangles = [[0, 2, 1], [0, 1, 3]];
    let (mut normals, mut scratch) = ([[0.0; 3]; 4], Scratch::new()); // reuse the scratch for the next mesh
    let averaging = Averaging { weight: Weight::Angle, ..Averaging::default() };
    let faults = vertex_normals(&positions, &triangles, averaging, &mut scratch, &mut normals)?;
    assert_eq!(normals[0], [0.0, 0.0, 1.0]);
    // README example: end
    assert!(faults.is_empty());
    Ok(())
}
