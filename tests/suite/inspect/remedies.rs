//! The command that `crease inspect` suggests fixes what it found.

use super::clean::meshes;
use super::planted::{Planted, faults};
use super::{recipe, with_normals};
use crate::cli::{crease, path, text};
use crate::meshes::{Row, rows};
use crease::io::{Format, Part, ReadOptions, WriteOptions, read, write_new};
use crease::mesh::Mesh;
use crease::normals::Weight;
use crease::quality::catalogue::{Kind, entries};
use rayon::prelude::*;
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// The report of the program on a file.
fn report(file: &Path, options: &[&str]) -> Value {
    let output = crease().args(["inspect", "--json", &path(file)]).args(options).output().unwrap();
    assert!(output.status.success(), "{}", text(&output.stderr));
    serde_json::from_str(text(&output.stdout)).unwrap()
}

/// What the program finds in a file.
fn findings(file: &Path) -> Vec<Value> {
    report(file, &[])["findings"].as_array().unwrap().clone()
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
        // OBJ text cannot store values that are not finite.
        let format = if kind == Kind::NotFinite { Format::Ply } else { Format::Obj };
        let written =
            write_new(&[Part { mesh, ..Part::default() }], format, &WriteOptions::default()).unwrap();
        Self { kind, format, bytes: written.bytes }
    }

    /// A mesh below a node with a matrix.
    fn below_node(planted: Planted) -> Self {
        let node = planted.node.expect("it stands somewhere");
        let parts = [Part { mesh: planted.mesh, ..Part::default() }];
        let written = write_new(&parts, Format::Gltf, &WriteOptions::default()).unwrap();
        let mut document: Value = serde_json::from_slice(&written.bytes).unwrap();
        document["nodes"][0]["matrix"] = node.to_cols_array().to_vec().into();
        Self { kind: planted.expected, format: Format::Gltf, bytes: document.to_string().into_bytes() }
    }

    /// Stores the file, runs the suggested command and inspects its output. Returns whether a command is suggested.
    fn check(&self, name: &str) -> bool {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join(format!("fault.{}", self.format.extension()));
        fs::write(&file, &self.bytes).unwrap();
        let id = self.kind.id();
        let before = findings(&file);
        let found = named(&before, id).unwrap_or_else(|| panic!("{name}: {id} is not found in {before:?}"));
        let Some(command) = found["command"].as_str() else { return false };
        let after = findings(&carried_out(command, folder.path()));
        assert!(named(&after, id).is_none(), "{name}: {command} leaves {:?}", named(&after, id));
        true
    }
}

/// Runs a command in a folder and returns the path of the file that it writes.
fn carried_out(command: &str, folder: &Path) -> PathBuf {
    let words: Vec<&str> = command.split(' ').collect();
    let output = crease().current_dir(folder).args(&words[1..]).output().unwrap();
    assert!(output.status.success(), "{command}: {}", text(&output.stderr));
    folder.join(words[words.iter().position(|word| *word == "-o").unwrap() + 1])
}

/// Faulty files that are not made from the faults of clean meshes.
fn others(ball: &Mesh) -> Vec<Faulty> {
    let bare = ball.clone().with_normals(None);
    let flat = with_normals(bare.clone(), &recipe(Weight::Angle, 0.0));
    let cut = super::seams::cut(&bare, glam::DVec3::X, 1e-9);
    let corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\n";
    let attributes = super::attributes::faulty();
    let attributes = attributes.map(|(kind, bytes)| Faulty { kind, format: Format::Gltf, bytes });
    let mut all = vec![
        Faulty::mesh(Kind::NoNormals, bare),
        Faulty::mesh(Kind::Faceted, flat),
        Faulty::mesh(Kind::CrackedSeam, with_normals(cut.clone(), &recipe(Weight::Angle, 40.0))),
        Faulty::mesh(Kind::CrackedSeam, cut),
        Faulty::text(Kind::MissingNormals, &format!("{corners}f 1//1 2//1 3//1\nf 1 3 4\n")),
        Faulty::text(Kind::ZeroArea, &format!("{corners}f 1//1 2//1 3//1 4//1\nf 1//1 2//1 2//1\n")),
    ];
    all.extend(attributes);
    all
}

/// Every kind of finding that a command fixes is planted in a file, found, and gone after that command.
#[test]
fn suggested_commands_fix_planted_faults() {
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

/// Copies a file, and the files that it names, into a folder in which the test may write.
fn copied(row: &Row, folder: &Path) -> PathBuf {
    let next_to = row.path.parent().unwrap();
    let is_alone = ["stl", "ply", "obj", "gltf"].iter().any(|shared| next_to.ends_with(shared));
    let names = |path: &Path| path.file_stem() == row.path.file_stem();
    for entry in fs::read_dir(next_to).unwrap() {
        let path = entry.unwrap().path();
        if path.is_file() && (!is_alone || names(&path)) {
            fs::copy(&path, folder.join(path.file_name().unwrap())).unwrap();
        }
    }
    folder.join(row.path.file_name().unwrap())
}

/// Findings that appear only after another fix, and whether their own command fixes them then. The stored normals of the box lie in the
/// plane of their face and contradict those computed for its other faces. Those of the pirate are authored, so they are kept and have
/// no command; they are compared with a recipe when the faces agree.
const UNCOVERED: [(&str, &str, bool); 2] = [
    ("obj/box-incomplete-normals.obj", "stray-normals", true),
    ("gltf/pirate_quantized.glb", "stray-normals", false),
];

/// Asserts that the commands suggested for a real file remove their findings and cause no error or warning of another kind.
fn check_real(row: &Row) -> Vec<String> {
    let folder = tempfile::tempdir().unwrap();
    let file = copied(row, folder.path());
    let report = report(&file, &[]);
    let before = report["findings"].as_array().unwrap().clone();
    let mut by_command: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    if let Some(command) = report["fix"]["command"].as_str() {
        let fixed = report["fix"]["findings"].as_array().unwrap();
        by_command.insert(command, fixed.iter().map(|id| id.as_str().unwrap()).collect());
    }
    for finding in &before {
        if let Some(command) = finding["command"].as_str() {
            by_command.entry(command).or_default().push(finding["id"].as_str().unwrap());
        }
    }
    let mut failures = Vec::new();
    for (command, ids) in by_command {
        let after = findings(&carried_out(command, folder.path()));
        let left = ids.iter().filter(|id| named(&after, id).is_some());
        failures.extend(left.map(|id| format!("{}: {command} leaves {id}", row.name())));
        // A note that has become a warning is new as well.
        let was_grave = |id: &str| named(&before, id).is_some_and(|it| it["severity"] != "note");
        let new = after.iter().filter(|it| it["severity"] != "note");
        let new = new.map(|it| it["id"].as_str().unwrap()).filter(|id| !was_grave(id));
        for id in new {
            let next = named(&after, id).and_then(|it| it["command"].as_str());
            match next {
                _ if !UNCOVERED.contains(&(row.name(), id, next.is_some())) => {
                    failures.push(format!("{}: {command} brings {id}", row.name()));
                }
                Some(next) => {
                    let last = findings(&carried_out(next, folder.path()));
                    let graver = last.iter().filter(|it| it["severity"] != "note");
                    failures.extend(graver.map(|it| format!("{}: {next} leaves {}", row.name(), it["id"])));
                }
                None => {}
            }
        }
    }
    failures
}

/// The same for unchanged real meshes. `CREASE_LONG` includes the large ones.
#[test]
fn suggested_commands_fix_real_meshes() {
    let most = if std::env::var_os("CREASE_LONG").is_some() { u64::MAX } else { 100_000 };
    let folders = [
        ("obj", &["obj"][..]),
        ("ply", &["ply"]),
        ("stl", &["stl", "STL"]),
        ("gltf", &["gltf", "glb"]),
        ("ref", &["ply"]),
    ];
    let rows: Vec<Row> =
        folders.into_iter().flat_map(|(folder, extensions)| rows(folder, extensions)).collect();
    let is_wanted = |row: &&Row| {
        let is_small = fs::metadata(&row.path).is_ok_and(|it| it.len() <= most);
        is_small && read(&row.path, None, &ReadOptions::default()).is_ok()
    };
    let failures: Vec<String> = rows.par_iter().filter(is_wanted).flat_map(check_real).collect();
    assert!(failures.is_empty(), "{} failures:\n{}", failures.len(), failures.join("\n"));
}

/// Text, JSON and page have one command, and name the findings that it fixes and those that remain.
#[test]
fn every_report_has_the_same_command_and_what_it_fixes() {
    let corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nvn 0 0 -1\n";
    let faulty = format!("{corners}f 1//1 2//1 3//1\nf 1//1 3//2 4//1\nf 1//1 2//1 2//1\n");
    let folder = tempfile::tempdir().unwrap();
    let [file, page] = ["a.obj", "a.html"].map(|name| folder.path().join(name));
    fs::write(&file, faulty).unwrap();
    let ids = |list: &Value, key: &str| -> Vec<String> {
        let list = list.as_array().unwrap().iter();
        list.map(|it| if key.is_empty() { it } else { &it[key] }.as_str().unwrap().to_owned()).collect()
    };
    for (options, option, fixes_area) in
        [(&[][..], "", false), (&["--severity", "note"], " --degenerate drop", true)]
    {
        let report = report(&file, &[options, &["--html", &path(&page)]].concat());
        let (found, fix) = (ids(&report["findings"], "id"), &report["fix"]);
        let (command, fixed) = (fix["command"].as_str().unwrap(), ids(&fix["findings"], ""));
        assert!(command.contains(option) && found.contains(&"zero-area-faces".into()), "{command}");
        assert_eq!(fixed.contains(&"zero-area-faces".into()), fixes_area, "{fixed:?}");
        let left: Vec<String> = found.iter().filter(|id| !fixed.contains(id)).cloned().collect();

        let said = crease().args(["inspect", "-v", &path(&file)]).args(options).output().unwrap();
        let not_fixed =
            if left.is_empty() { String::new() } else { format!("; not fixed: {}", left.join(", ")) };
        let lines = format!("  fix: {command}\n    fixed: {}{not_fixed}\n", fixed.join(", "));
        assert!(text(&said.stdout).contains(&lines), "{lines}{}", text(&said.stdout));

        let html = fs::read_to_string(&page).unwrap();
        let code =
            |ids: &[String]| ids.iter().map(|id| format!("<code>{id}</code>")).collect::<Vec<_>>().join(", ");
        assert!(html.contains(&format!("The command below fixes {}.", code(&fixed))), "{html}");
        assert!(left.is_empty() || html.contains(&format!("It does not fix {}.", code(&left))));
        assert!(html.contains(&format!("<pre><code>{}</code>", command.replace('\'', "&#39;"))));
        let counts =
            ["error", "warning", "note"].map(|name| (report["counts"][name].as_u64().unwrap(), name));
        let counts = counts.iter().filter(|(count, _)| *count > 0);
        let counts =
            counts.map(|(count, name)| format!("{count} {name}{}", if *count == 1 { "" } else { "s" }));
        let title = format!("{}: {}", path(&file), counts.collect::<Vec<_>>().join(", "));
        assert!(
            html.contains(&format!("<title>{title}</title>")) && html.contains(&format!("<h1>{title}</h1>"))
        );

        let after = ids(&findings(&carried_out(command, folder.path())).into(), "id");
        assert!(!fixed.iter().any(|id| after.contains(id)), "{command} leaves {after:?}");
        assert_eq!(after.contains(&"zero-area-faces".into()), !fixes_area, "{command}");
    }

    fs::write(&file, "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n").unwrap();
    for (options, title) in
        [(&[][..], "No problems found in "), (&["--only", "soft-normals"], "No problems found in ")]
    {
        let report = report(&file, &[options, &["--html", &path(&page)]].concat());
        assert!(report["fix"].is_null());
        assert!(fs::read_to_string(&page).unwrap().contains(&format!("<title>{title}")), "{options:?}");
    }
    let bare = folder.path().join("bare.obj");
    fs::write(&bare, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    report(&bare, &["--severity", "warning", "--html", &path(&page)]);
    assert!(fs::read_to_string(&page).unwrap().contains("<title>No selected findings in "));
}
