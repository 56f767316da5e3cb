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
        assert_eq!(reports.len(), 16);
        for report in &reports {
            let name = &report["experiment"];
            assert_eq!((&report["schema"], &report["status"]), (&"crease-artefact/2".into(), &"ok".into()));
            for member in ["claim", "title", "parameters", "command"] {
                assert!(!report[member].is_null(), "{name}: {member}");
            }
            let outcome = &report["outcome"];
            let moved = |case: &str| outcome["moved"][case].as_f64().unwrap().abs();
            assert!(
                moved("bad") > outcome["moved"]["present"]["value"].as_f64().unwrap(),
                "{name}: {}",
                outcome["moved"]
            );
            assert!(moved("factor") >= 2.0, "{name}: {}", outcome["moved"]);
            assert!(moved("bad") >= moved("factor") * moved("cured"), "{name}: {}", outcome["moved"]);
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
        assert!(bytes.len() < 80_000, "{name} is too large");
    }
}

#[test]
fn what_acts_on_the_animation_alone_is_reported() {
    let args = ["orientation", "--size", "33", "--interpolation", "affine"];
    let output = artefact(&args);
    assert_eq!(code(&output), 0, "{}", text(&output.stderr));
    assert!(text(&output.stderr).contains("note: --interpolation applies to the animation only"));
    let out = folder(&[]);
    let gif = path(out.path().join("turn.gif"));
    let drawn = artefact(&[&args[..], &["--animate", &gif, "--frames", "2"]].concat());
    assert!(!text(&drawn.stderr).contains("animation only"), "{}", text(&drawn.stderr));
}

#[test]
fn pages_come_in_portuguese() {
    let out = folder(&[]);
    let output = artefact(&["orientation", "--size", "64", "--lang", "pt", "-q", "-o", &path(out.path())]);
    assert_eq!(code(&output), 0, "{}", text(&output.stderr));
    let page = fs::read_to_string(out.path().join("orientation.html")).unwrap();
    assert!(
        page.contains("<html lang=\"pt")
            && page.contains("A interpolação por varredura depende da orientação"),
        "{page:.300}"
    );
}

#[test]
fn an_animation_has_as_many_frames_as_asked_for() {
    let out = folder(&[]);
    let gif = path(out.path().join("turn.gif"));
    let args = ["orientation", "--size", "48", "-q", "--json", "--animate", &gif, "--frames", "5"];
    let output = artefact(&args);
    assert_eq!(code(&output), 0);
    let command = reports(&output)[0]["command"].as_str().unwrap().to_owned();
    assert!(command.ends_with(&format!(" --animate {gif} --frames 5")), "{command}");
    let decoder = GifDecoder::new(Cursor::new(fs::read(&gif).unwrap())).unwrap();
    assert_eq!(decoder.into_frames().count(), 5);
}

#[test]
fn a_polygon_of_ones_own_is_turned_and_what_does_not_suit_is_refused() {
    let square = "v -1 0 0\nv 0 -1 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 4\n";
    let nan = "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let twice = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3 2\n";
    let crossed = "v 0 0 0\nv 3 3 0\nv 3 0 0\nv 0 1 0\nf 1 2 3 4\n";
    let thin = "v 0 0 0\nv 9 0 0\nv 9 0.01 0\nv 0 0.01 0\nf 1 2 3 4\n";
    // Bow ties with equal halves: their areas cancel, in the second one up to rounding.
    let tie = "v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 4\n";
    let tilted = "v 0.1 0.2 0.3\nv 0.8 1.3 1.1\nv 0.8 0.2 0.7\nv 0.1 1.3 0.7\nf 1 2 3 4\n";
    let needle = "v 0 0 0\nv 0.1 0.3 0.2\nv 0.2 0.6 0.4\nv 0.3 0.9 0.6\nf 1 2 3 4\n";
    let files = folder(&[
        ("tie.obj", tie),
        ("tilted.obj", tilted),
        ("needle.obj", needle),
        ("square.obj", square),
        ("empty.obj", "v 0 0 0\n"),
        ("nan.obj", nan),
        ("twice.obj", twice),
        ("crossed.obj", crossed),
        ("thin.obj", thin),
    ]);
    let [square, empty, nan, twice, crossed, thin] =
        ["square.obj", "empty.obj", "nan.obj", "twice.obj", "crossed.obj", "thin.obj"]
            .map(|name| path(files.path().join(name)));
    let [tie, tilted, needle] =
        ["tie.obj", "tilted.obj", "needle.obj"].map(|name| path(files.path().join(name)));
    let output = artefact(&["orientation", "--size", "64", "-q", "--json", "--mesh", &square]);
    assert_eq!(code(&output), 0, "{}", text(&output.stderr));
    assert_eq!(reports(&output)[0]["mesh"], square);
    for (args, exit, says) in [
        (&["orientation", "--mesh", &empty][..], 3, "empty.obj"),
        (&["orientation", "--mesh", &twice], 3, "twice.obj` has corners 1 and 3 at one position"),
        (&["orientation", "--mesh", &crossed], 3, "crossed.obj` crosses itself at edges 0 and 2"),
        (&["orientation", "--mesh", &tie], 3, "tie.obj` crosses itself at edges 0 and 2"),
        (&["orientation", "--mesh", &tilted], 3, "tilted.obj` crosses itself at edges 0 and 2"),
        (
            &["orientation", "--mesh", &needle],
            3,
            "needle.obj` has no area\nhelp: give a mesh whose first polygon",
        ),
        (&["false-smoothing", "--mesh", &needle], 3, "needle.obj` covers no pixel of a picture of"),
        (&["silhouette", "--mesh", &needle], 3, "or a mesh whose faces have an area"),
        (
            &["orientation", "--mesh", &thin],
            3,
            "pixels wide in a picture of 321 pixels\nhelp: give a larger picture",
        ),
        (&["mach-bands", "--mesh", &square], 2, "has no mesh"),
        (&["mach-bands", "--weight", "area"], 2, "it takes --size, --segments, --light"),
        (&["mach-bands", "--size", "5"], 2, "--size"),
        (&["mach-band"], 2, "mach-bands"),
        (&["mach-bands", "--exponent", "1e308"], 2, "no exponent"),
        (
            &["lost-highlight", "--exponent", "1e308"],
            2,
            "--exponent is 1e308, out of range\nhelp: give a number",
        ),
        (&["silhouette", "--animate", "x.gif"], 2, "these have one: orientation"),
        (&["orientation", "--animate", "turn.png"], 2, "use turn.gif"),
        (&["orientation", "--animate", "-"], 2, "turn.gif"),
        (&["list", "-o", "out"], 2, "`list` ignores -o"),
        (&["list", "--segments", "12"], 2, "`list` ignores --segments"),
        (&["list", "--animate", "x.gif"], 2, "`list` ignores --animate"),
        (&["all", "--segments", "2"], 2, "--segments is 2, out of range\nhelp: give a number from 3 to 1024"),
        (&["all", "--light", "200"], 2, "--light is 200, out of range\nhelp: give an angle"),
        (&["silhouette", "--mesh", "no.obj"], 3, "no.obj: there is no such file"),
        (&["silhouette", "--mesh", &square, "--finer", "no.obj"], 3, "no.obj: there is no such file"),
        (&["silhouette", "--mesh", &nan], 3, "`crease normals --force`"),
        (&["silhouette", "--mesh", &nan], 3, "nan.obj"),
        (&["mach-bands", "-q", "--size", "64", "-o", "/dev/null/x"], 4, "/dev/null is a file, not a folder"),
        (&["mach-bands", "-q", "--size", "64", "-o", &square], 4, "square.obj is a file, not a folder"),
    ] {
        let output = artefact(args);
        assert_eq!(code(&output), exit, "{args:?}: {}", text(&output.stderr));
        assert!(text(&output.stderr).contains(says), "{args:?}: {}", text(&output.stderr));
    }
}

/// A value out of the range of some experiments omits these, and the others run.
#[test]
fn all_leaves_out_what_does_not_take_a_value() {
    let output = artefact(&["all", "--segments", "3", "--size", "32", "--json"]);
    assert_eq!(code(&output), 0, "{}", text(&output.stderr));
    let reports = reports(&output);
    assert_eq!(reports.len(), 16);
    for report in &reports {
        let is_out = report["ranges"]["segments"][0].as_f64().is_some_and(|fewest| fewest > 3.0);
        let status = if is_out { "left-out" } else { "ok" };
        assert_eq!((&report["status"], report["outcome"].is_null()), (&status.into(), is_out), "{report}");
        let id = report["experiment"].as_str().unwrap();
        let reported = text(&output.stderr).contains(&format!("`{id}` is omitted: --segments is 3"));
        assert_eq!(reported, is_out, "{id}: {}", text(&output.stderr));
    }
    let left_out = reports.iter().filter(|report| report["status"] == "left-out").count();
    assert!((1..14).contains(&left_out), "{left_out}");
}

/// A note names the experiments that an option changes if not all of them take it.
#[test]
fn all_reports_what_an_option_changes() {
    let output = artefact(&["all", "--crease", "30", "--exponent", "9", "--size", "32", "--json"]);
    assert_eq!(code(&output), 0, "{}", text(&output.stderr));
    for knob in ["crease", "exponent"] {
        let takes = |report: &&Value| report["takes"].as_array().unwrap().contains(&knob.into());
        let reports = reports(&output);
        let ids: Vec<&str> =
            reports.iter().filter(takes).map(|it| it["experiment"].as_str().unwrap()).collect();
        assert!((1..14).contains(&ids.len()), "{ids:?}");
        let reported = format!("note: --{knob} changes only {}\n", ids.join(", "));
        assert!(text(&output.stderr).contains(&reported), "{reported} in {}", text(&output.stderr));
        for report in &reports {
            let unheeded = report["unheeded"].as_array().is_some_and(|all| all.contains(&knob.into()));
            assert_ne!(unheeded, takes(&report), "{}: {knob}", report["experiment"]);
        }
    }
    let plain = artefact(&["all", "--size", "32", "--json"]);
    assert!(!text(&plain.stderr).contains("only"), "{}", text(&plain.stderr));
}

#[test]
fn the_list_reports_parameters_and_their_ranges() {
    let listed = reports(&artefact(&["list", "--json"]));
    assert_eq!(listed.len(), 16);
    for report in &listed {
        let takes = report["takes"].as_array().unwrap().iter().filter(|knob| **knob != "mesh");
        for knob in takes.map(|knob| knob.as_str().unwrap()) {
            let (value, range) = (&report["parameters"][knob], report["ranges"][knob].as_array().unwrap());
            let fits = match value.as_f64() {
                Some(value) => (range[0].as_f64().unwrap()..=range[1].as_f64().unwrap()).contains(&value),
                None => range.contains(value),
            };
            assert!(fits, "{}: {knob} is {value} of {range:?}", report["experiment"]);
        }
    }
}

/// Every experiment that takes a user mesh according to the list uses it.
#[test]
fn a_mesh_of_ones_own_works_where_the_list_says_so() {
    let gear = path(Path::new(env!("CARGO_MANIFEST_DIR")).join("data/gear.obj"));
    let listed = reports(&artefact(&["list", "--json"]));
    let takes = |report: &&Value| !report["own_mesh"].is_null();
    let ids: Vec<&str> =
        listed.iter().filter(takes).map(|report| report["experiment"].as_str().unwrap()).collect();
    assert_eq!(ids, ["silhouette", "orientation", "false-smoothing"]);
    for id in ids {
        let output = artefact(&[id, "--size", "96", "-q", "--json", "--mesh", &gear]);
        assert_eq!(code(&output), 0, "{id}: {}", text(&output.stderr));
        let report = &reports(&output)[0];
        assert_eq!(report["mesh"], gear);
        assert!(report["command"].as_str().unwrap().contains(" --mesh "), "{id}: {}", report["command"]);
        // The formulas of a cube or a ball do not hold for a gear.
        assert_eq!(report["formulas"].as_array().map(Vec::len), Some(0), "{id}");
        assert!(!report["outcome"]["verdict"]["verdict"].is_null(), "{id}");
    }
}

#[test]
fn outlines_are_held_against_a_finer_mesh_or_the_mesh_itself() {
    let files = folder(&[]);
    let [coarse, fine] = [("coarse.obj", "16x8"), ("fine.obj", "96x48")].map(|(name, segments)| {
        let file = path(files.path().join(name));
        let made = crease().args(["surface", "sphere", "-q", "--segments", segments, "-o", &file]).output();
        assert_eq!(code(&made.unwrap()), 0);
        file
    });
    let run = |more: &[&str]| {
        let args = ["silhouette", "--size", "128", "-q", "--json", "--mesh", &coarse];
        let output = artefact(&[&args[..], more].concat());
        assert_eq!(code(&output), 0, "{}", text(&output.stderr));
        reports(&output).remove(0)
    };
    let (own, finer) = (run(&[]), run(&["--finer", &fine]));
    assert_eq!((own["finer"].is_null(), &finer["finer"]), (true, &fine.clone().into()));
    assert!(finer["command"].as_str().unwrap().contains(" --finer "));
    let moved = |report: &Value, case: &str| report["outcome"]["moved"][case].as_f64().unwrap();
    // The curved triangles are as close to the ball as the finer mesh: the two measures exceed one pixel and agree within a fifth
    // of a pixel.
    assert!(moved(&finer, "bad") > 1.0, "{}", finer["outcome"]["moved"]);
    assert!((moved(&own, "bad") - moved(&finer, "bad")).abs() < 0.2, "{}", own["outcome"]["moved"]);
    assert!(moved(&finer, "cured") < 0.5 * moved(&finer, "bad"), "{}", finer["outcome"]["moved"]);
}
