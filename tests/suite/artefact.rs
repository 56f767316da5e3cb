//! The verb `artefact` from outside, and the README's pictures of it.

use crate::cli::{code, crease, folder, path, text};
use image::AnimationDecoder;
use image::codecs::gif::GifDecoder;
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::io::Cursor;
use std::path::Path;
use std::process::Output;

fn artefact(args: &[&str]) -> Output {
    crease().arg("artefact").args(args).output().unwrap()
}

/// All files of a folder, by name.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    entries.map(|file| (path(file.file_name().unwrap()), fs::read(&file).unwrap())).collect()
}

fn reports(output: &Output) -> Vec<Value> {
    text(&output.stdout).lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

#[test]
fn all_experiments_agree_with_their_checks_and_any_number_of_threads_writes_the_same() {
    let written = ["1", "3"].map(|threads| {
        let out = folder(&[]);
        let to = path(out.path());
        let output = artefact(&["all", "--size", "192", "-q", "--json", "--threads", threads, "-o", &to]);
        assert_eq!(code(&output), 0, "{}", text(&output.stderr));
        let reports = reports(&output);
        assert!(reports.len() >= 11);
        for report in &reports {
            let name = &report["experiment"];
            assert_eq!((&report["schema"], &report["status"]), (&"crease-artefact/1".into(), &"ok".into()));
            for member in ["claim", "title", "parameters", "command"] {
                assert!(!report[member].is_null(), "{name}: {member}");
            }
            let outcome = &report["outcome"];
            let moved = |case: &str| outcome["moved"][case].as_f64().unwrap().abs();
            assert!(moved("bad") > 2.0 * moved("cured"), "{name}: {}", outcome["moved"]);
            let checked = outcome["measures"].as_array().unwrap().iter().filter(|m| !m["expected"].is_null());
            assert!(checked.count() > 0, "{name} has a number that is checked");
        }
        files(out.path())
    });
    assert!(written[0] == written[1]);
    assert!(written[0].contains_key("index.html"));
    // The README's pictures are among them.
    let kept = files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("data/gallery"));
    assert_eq!(kept.len(), 6);
    for (name, bytes) in kept {
        assert!(
            written[0].get(&name) == Some(&bytes),
            "{name} is another picture than `crease artefact all` writes"
        );
        assert!(bytes.len() < 60_000, "{name} is too large");
    }
}

#[test]
fn pages_come_in_portuguese() {
    let out = folder(&[]);
    let output = artefact(&["orientation", "--size", "64", "--lang", "pt", "-q", "-o", &path(out.path())]);
    assert_eq!(code(&output), 0, "{}", text(&output.stderr));
    let page = fs::read_to_string(out.path().join("orientation.html")).unwrap();
    assert!(page.contains("<html lang=\"pt") && page.contains("Dependência da orientação"), "{page:.300}");
}

#[test]
fn an_animation_has_as_many_frames_as_asked_for() {
    let out = folder(&[]);
    let gif = path(out.path().join("turn.gif"));
    let args = ["orientation", "--size", "48", "-q", "--animate", &gif, "--frames", "5"];
    assert_eq!(code(&artefact(&args)), 0);
    let decoder = GifDecoder::new(Cursor::new(fs::read(&gif).unwrap())).unwrap();
    assert_eq!(decoder.into_frames().count(), 5);
}

#[test]
fn a_polygon_of_ones_own_is_turned_and_what_does_not_suit_is_refused() {
    let square = "v -1 0 0\nv 0 -1 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 4\n";
    let files = folder(&[("square.obj", square), ("empty.obj", "v 0 0 0\n")]);
    let [square, empty] = ["square.obj", "empty.obj"].map(|name| path(files.path().join(name)));
    let output = artefact(&["orientation", "--size", "64", "-q", "--json", "--mesh", &square]);
    assert_eq!(code(&output), 0, "{}", text(&output.stderr));
    assert_eq!(reports(&output)[0]["mesh"], square);
    for (args, exit, says) in [
        (&["orientation", "--mesh", &empty][..], 3, "empty.obj"),
        (&["mach-bands", "--mesh", &square], 2, "has no mesh"),
        (&["mach-bands", "--weight", "area"], 2, "it takes --size, --segments, --light"),
        (&["mach-bands", "--size", "5"], 2, "--size"),
        (&["mach-band"], 2, "mach-bands"),
        (&["mach-bands", "-q", "--size", "64", "-o", "/dev/null/x"], 4, "/dev/null/x"),
    ] {
        let output = artefact(args);
        assert_eq!(code(&output), exit, "{args:?}: {}", text(&output.stderr));
        assert!(text(&output.stderr).contains(says), "{args:?}: {}", text(&output.stderr));
    }
}
