//! Help, completions, and command lines that are refused before anything is read or written.

use super::{BAD, TRIANGLE, code, crease, data, folder, names, normals, path, text};

/// Every option that the verb promises, with its values.
const OPTIONS: &[(&str, &[&str])] = &[
    ("-o, --output", &[]),
    ("--out-dir", &[]),
    ("--in-place", &[]),
    ("--recursive", &[]),
    ("--format", &["obj", "ply", "stl", "gltf", "glb"]),
    ("--to", &["obj", "ply", "stl", "gltf", "glb"]),
    ("--emit", &["corner", "vertex", "face", "[default: corner]"]),
    (
        "--weight",
        &[
            "uniform",
            "area",
            "angle",
            "angle-area",
            "max",
            "edge",
            "quadric",
            "jet",
            "best",
            "[default: angle]",
        ],
    ),
    ("--crease", &["DEG|off", "default: 40"]),
    ("--crease-rule", &["fan", "cone", "[default: fan]"]),
    ("--groups", &["honour", "ignore", "[default: honour]"]),
    ("--hard-edges", &["uv", "material", "authored"]),
    ("--when", &["always", "missing", "broken", "[default: always]"]),
    ("--weld", &["exact|off|REL", "[default: exact]"]),
    ("--slivers", &["exclude", "keep", "[default: exclude]"]),
    ("--degenerate", &["keep", "drop", "[default: keep]"]),
    ("--flip", &[]),
    ("--orient", &["keep", "consistent", "outward", "[default: keep]"]),
    ("--precision", &["faithful", "fast", "[default: faithful]"]),
    ("--tangents", &["auto", "drop", "keep", "regenerate", "[default: auto]"]),
    ("--normal-format", &["same", "f32", "i16", "i8", "[default: same]"]),
    ("--compress", &["none", "meshopt", "[default: none]"]),
    ("--root", &[]),
    ("--threads", &[]),
    ("--json", &[]),
    ("-q, --quiet", &[]),
    ("-v, --verbose", &[]),
    ("--dry-run", &[]),
    ("--force", &[]),
    ("--sync", &[]),
    ("--color", &["auto", "always", "never", "[default: auto]"]),
];

#[test]
fn help_has_every_option_with_its_values_and_examples() {
    let output = normals(["--help"]);
    assert_eq!(code(&output), 0);
    let help = text(&output.stdout);
    for (option, values) in OPTIONS {
        let start = help.find(&format!(" {option} ")).or_else(|| help.find(&format!(" {option}\n")));
        let start = start.unwrap_or_else(|| panic!("no {option} in\n{help}"));
        let end = help[start + option.len()..]
            .find("\n      --")
            .map_or(help.len(), |at| start + option.len() + at);
        for value in *values {
            assert!(help[start..end].contains(value), "no {value} in\n{}", &help[start..end]);
        }
    }
    assert!(help.contains("Examples:\n  crease normals"));
    assert!(help.contains("Exit codes:"));
}

/// A text that is missing shows as its key in braces.
#[test]
fn every_help_has_all_of_its_texts() {
    let output = crease().arg("--help").output().unwrap();
    let list = text(&output.stdout);
    let verbs =
        list.split("Verbs:").nth(1).unwrap().lines().skip(1).take_while(|line| line.starts_with("  "));
    let verbs: Vec<&str> = verbs.filter_map(|line| line.split_whitespace().next()).collect();
    assert!(verbs.len() > 8 && verbs.contains(&"plan"), "{verbs:?}");
    for verb in verbs {
        let output = crease().args([verb, "--help"]).output().unwrap();
        let help = text(&output.stdout);
        let missing = help
            .match_indices('{')
            .find(|(at, _)| help[at + 1..].starts_with(|c: char| c.is_ascii_lowercase()));
        assert!(missing.is_none(), "{verb}: {}", &help[missing.unwrap().0..][..30]);
    }
}

#[test]
fn the_program_reports_its_verbs_and_version() {
    let help = crease().arg("--help").output().unwrap();
    for verb in ["normals", "stress", "surface", "completions", "man"] {
        assert!(text(&help.stdout).contains(&format!("\n  {verb} ")), "{verb}");
    }
    let version = crease().arg("--version").output().unwrap();
    assert_eq!(text(&version.stdout), format!("crease {}\n", env!("CARGO_PKG_VERSION")));
}

#[test]
fn a_root_that_is_no_folder_is_wrong_usage() {
    for root in [path(data("nowhere")), path(data("gear.obj"))] {
        let output = normals([&path(data("gear.obj")), "--dry-run", "--root", &root]);
        assert_eq!(code(&output), 2);
        assert!(text(&output.stderr).contains("--root"), "{}", text(&output.stderr));
    }
}

#[test]
fn completions_and_manual_pages_know_the_options() {
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let output = crease().args(["completions", shell]).output().unwrap();
        assert!(output.status.success() && text(&output.stdout).contains("crease-rule"), "{shell}");
    }
    let program = crease().arg("man").output().unwrap();
    assert!(text(&program.stdout).starts_with(".ie") && text(&program.stdout).contains(".TH crease 1"));
    let verb = crease().args(["man", "normals"]).output().unwrap();
    assert!(text(&verb.stdout).contains(".TH crease-normals 1"), "{}", text(&verb.stdout));
    assert!(text(&verb.stdout).contains("crease\\-rule"));
    let page = text(&verb.stdout);
    for piece in [
        ".SH \"EXAMPLES\"\n.nf\n\\&crease normals",
        ".SH \"EXIT CODES\"",
        "\\fIINPUT\\fR",
        "\\fB\\-\\-weight\\fR",
    ] {
        assert!(page.contains(piece), "no {piece:?} in\n{page}");
    }
    assert!(!page.contains("EXTRA"));
    assert_eq!(code(&crease().args(["man", "nothing"]).output().unwrap()), 2);
}

#[test]
fn wrong_command_lines_are_refused_with_a_reason() {
    let work =
        folder(&[("a.obj", TRIANGLE), ("b.obj", TRIANGLE), ("sub/a.obj", TRIANGLE), ("x.mesh", TRIANGLE)]);
    let at = |name: &str| path(work.path().join(name));
    let [a, b, out] = [at("a.obj"), at("b.obj"), at("out")];
    let before = names(work.path());
    let table: &[(&[&str], &str)] = &[
        (&[], "<INPUT>"),
        (&[&a], "--output, --out-dir and --in-place"),
        (&[&a, "--json"], "--output, --out-dir and --in-place"),
        (&[&a, "--emit", "face"], "--output, --out-dir and --in-place"),
        (&[&a, "-o", &out, "--in-place"], "cannot be used with"),
        (&[&a, "-o", &out, "--out-dir", &out], "cannot be used with"),
        (&[&a, "--in-place", "--out-dir", &out], "cannot be used with"),
        (&[&a, &b, "-o", "c.obj"], "--out-dir takes several"),
        (&[&a, &b, "-o", "-"], "--out-dir takes several"),
        (&[&a, "-o", &out], "choose with --to"),
        (&[&a, "-o", &at("c.ply"), "--to", "obj"], "--to is obj"),
        (&[&a, "-o", &at("sub")], "is a folder"),
        (&[&a, "--in-place", "--to", "ply"], "--in-place cannot convert"),
        (&[&at("x.mesh"), "--in-place", "--to", "ply"], "name it with --format"),
        (&[&at("sub"), "--out-dir", &out], "--recursive"),
        (&[&a, &at("sub/a.obj"), "--out-dir", &out], "would both be written"),
        (&[&a, &a, "--in-place"], "would both be written"),
        (&[&a, "--out-dir", &at("")], "would overwrite the input"),
        (&[&at(""), "--recursive", "--out-dir", &at("")], "would overwrite the input"),
        (&["-", "--in-place"], "standard input"),
        (&["-", "--out-dir", &out], "standard input"),
        (&["-", "-", "--dry-run"], "only once"),
        (&[&a, "--emit", "face", "-o", &at("c.glb")], "writes ply or stl"),
        (&[&a, "--emit", "face", "--in-place"], "writes ply or stl"),
        (&[&a, "-q", "-v", "--dry-run"], "cannot be used with"),
        (&[&a, "--crease", "-1", "--dry-run"], "0 to 180"),
        (&[&a, "--crease", "181", "--dry-run"], "0 to 180"),
        (&[&a, "--crease", "nan", "--dry-run"], "0 to 180"),
        (&[&a, "--weld", "0", "--dry-run"], "fraction"),
        (&[&a, "--weld", "-0.1", "--dry-run"], "fraction"),
        (&[&a, "--weld", "inf", "--dry-run"], "fraction"),
        (&[&a, "--threads", "0", "--dry-run"], "from 1 to 1024"),
        (&[&a, "--weight", "heavy", "--dry-run"], "angle-area"),
        (&[&a, "--bogus"], "--bogus"),
    ];
    for (args, expected) in table {
        let output = normals(*args);
        let message = text(&output.stderr);
        assert_eq!(code(&output), 2, "{args:?}: {message}");
        assert!(message.contains(expected), "{args:?}: {message}");
        assert!(message.starts_with("error: ") && message.contains("\nhelp: "), "{args:?}: {message}");
        assert!(output.stdout.is_empty(), "{args:?}");
    }
    assert_eq!(names(work.path()), before, "nothing is written");
}

#[test]
fn each_kind_of_failure_has_its_code() {
    let work = folder(&[("good.obj", TRIANGLE), ("bad.obj", BAD), ("empty/readme.txt", "")]);
    let at = |name: &str| path(work.path().join(name));
    let out = at("out");
    let table: &[(&[&str], i32)] = &[
        (&[&at("good.obj"), "--dry-run"], 0),
        (&[&at("bad.obj"), "--dry-run"], 3),
        (&[&at("nowhere.obj"), "--dry-run"], 3),
        (&[&at("empty"), "--recursive", "--dry-run"], 3),
        (&[&at("good.obj"), "-o", &at("good.obj/x.obj")], 4),
        (&[&at("good.obj"), &at("bad.obj"), "--out-dir", &out], 5),
        (&[&at("bad.obj"), &at("nowhere.obj"), "--out-dir", &out], 5),
        (&[&path(data("gear.obj")), "--dry-run"], 0),
    ];
    for (args, expected) in table {
        let output = normals(*args);
        assert_eq!(code(&output), *expected, "{args:?}: {}", text(&output.stderr));
        assert_eq!(output.stderr.is_empty(), *expected == 0, "{args:?}: {}", text(&output.stderr));
    }
    assert_eq!(names(&work.path().join("out")), ["good.obj"]);
}

#[test]
fn an_error_names_file_place_and_remedy() {
    let work = folder(&[("bad.obj", BAD)]);
    let output = normals([path(work.path().join("bad.obj")), "--dry-run".into()]);
    let message = text(&output.stderr);
    assert!(message.starts_with("error: ") && message.contains("bad.obj: line 2: "), "{message}");
}
