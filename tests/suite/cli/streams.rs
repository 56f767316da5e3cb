//! Standard input, output and error.

use super::{TRIANGLE, code, crease, data, folder, normals, path, succeed, text};
use std::fs;
use std::process::{Command, Stdio};

#[test]
fn a_mesh_goes_through_the_pipe_and_its_report_goes_aside() {
    let work = folder(&[]);
    for (name, format) in
        [("gear.obj", "obj"), ("part-binary.stl", "stl"), ("far.ply", "ply"), ("morph.gltf", "gltf")]
    {
        let file = work.path().join(format!("out.{format}"));
        succeed([path(data(name)), "-o".into(), path(&file)]);
        for typed in [&["--format", format][..], &[]] {
            let piped = crease()
                .args(["normals", "-", "-o", "-"])
                .args(typed)
                .write_stdin(fs::read(data(name)).unwrap())
                .output()
                .unwrap();
            assert_eq!(code(&piped), 0, "{}", text(&piped.stderr));
            assert!(piped.stdout == fs::read(&file).unwrap(), "{name} {typed:?}");
            assert!(text(&piped.stderr).contains("  normals  "), "{}", text(&piped.stderr));
        }
    }
}

#[test]
fn another_format_goes_to_the_pipe_in_one_piece() {
    let input = fs::read(data("part.stl")).unwrap();
    for (to, magic) in [("ply", "ply\n"), ("glb", "glTF"), ("gltf", "{"), ("obj", "")] {
        let piped =
            crease().args(["normals", "-", "--to", to, "-o", "-", "-q"]).write_stdin(input.clone()).output();
        let piped = piped.unwrap();
        assert_eq!(code(&piped), 0, "{}", text(&piped.stderr));
        assert!(piped.stdout.starts_with(magic.as_bytes()) && piped.stdout.len() > 1000, "{to}");
        assert!(piped.stderr.is_empty(), "quiet");
    }
}

#[test]
fn json_next_to_a_mesh_on_standard_output_can_be_parsed() {
    for (input, expected) in [(fs::read(data("gear.obj")).unwrap(), 0), (b"f 1 2 3".to_vec(), 3)] {
        let args = ["normals", "-", "--format", "obj", "-o", "-", "--json"];
        let output = crease().args(args).write_stdin(input).output().unwrap();
        assert_eq!(code(&output), expected);
        let report: serde_json::Value =
            serde_json::from_slice(&output.stderr).expect("one object and nothing else");
        assert_eq!(report["status"], if expected == 0 { "ok" } else { "failed" });
        assert_eq!(output.stdout.is_empty(), expected != 0);
    }
}

#[test]
fn a_reader_that_goes_away_is_no_failure() {
    let input = path(data("gear.obj"));
    let mut reports = vec![input.as_str(); 64];
    reports.extend(["--dry-run", "--json"]);
    for args in [&[input.as_str(), "-o", "-"][..], &reports] {
        let mut child = Command::new(env!("CARGO_BIN_EXE_crease"))
            .arg("normals")
            .args(args)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        assert_eq!(code(&output), 0, "{}", text(&output.stderr));
        assert!(!text(&output.stderr).contains("error"), "{}", text(&output.stderr));
    }
}

#[test]
fn colour_is_for_terminals_unless_asked_for() {
    let run = |variables: &[(&str, &str)], color: Option<&str>| {
        let mut command = crease();
        command.args(["normals", "--dry-run"]).arg(data("gear.obj")).envs(variables.iter().copied());
        command.args(color.map(|choice| format!("--color={choice}")));
        let output = command.output().unwrap();
        assert_eq!(code(&output), 0);
        output.stdout.contains(&0x1b)
    };
    assert!(!run(&[], None), "a pipe is no terminal");
    assert!(run(&[], Some("always")));
    assert!(run(&[("NO_COLOR", "1")], Some("always")), "what is typed comes first");
    assert!(run(&[("CLICOLOR_FORCE", "1")], None));
    assert!(!run(&[("CLICOLOR_FORCE", "1"), ("NO_COLOR", "1")], None));
    assert!(!run(&[("CLICOLOR_FORCE", "1")], Some("never")));
}

#[test]
fn quiet_says_nothing_and_verbose_more() {
    let input = path(data("gear.obj"));
    let quiet = succeed([&input, "--dry-run", "-q"]);
    assert!(quiet.stdout.is_empty() && quiet.stderr.is_empty());
    let work = folder(&[("a.obj", TRIANGLE), ("b.obj", TRIANGLE)]);
    let both = ["a.obj", "b.obj"].map(|name| path(work.path().join(name)));
    let lines = |more: &[&str]| {
        let output =
            succeed(both.iter().map(String::as_str).chain(["--dry-run"]).chain(more.iter().copied()));
        text(&output.stdout).lines().count()
    };
    assert_eq!(lines(&[]), 3, "one a file, and the sum");
    assert!(lines(&["-v"]) > 10);
    let bad = normals([&path(work.path().join("nowhere.obj")), "--dry-run", "-q"]);
    assert!(text(&bad.stderr).starts_with("error: "), "errors are said even then");
}

#[test]
fn names_cannot_steer_the_terminal() {
    let work = folder(&[("evil\u{1b}[2J.obj", TRIANGLE), ("bad\u{1b}[2J.obj", "f 1 2 3\n")]);
    let [evil, bad] = ["evil\u{1b}[2J.obj", "bad\u{1b}[2J.obj"].map(|name| path(work.path().join(name)));
    let good = succeed([&evil, "-o", &path(work.path().join("o\u{7}.obj"))]);
    let bad = normals([&bad, "--dry-run"]);
    let said = [good.stdout, good.stderr, bad.stdout, bad.stderr].concat();
    assert!(!said.contains(&0x1b) && !said.contains(&7), "{}", text(&said).escape_debug());
    assert!(text(&said).contains("evil\\u{1b}[2J.obj"));
}
