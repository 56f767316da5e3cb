//! Output files: their paths, existing files, and what remains after an error.

use super::{BAD, TRIANGLE, code, data, folder, names, normals, path, succeed, text};
use std::fs;

#[test]
fn a_folder_keeps_its_structure() {
    let files = [("in/b.obj", TRIANGLE), ("in/deep/er/a.obj", TRIANGLE), ("in/.git/c.obj", TRIANGLE)];
    let work = folder(&files);
    let (input, out) = (work.path().join("in"), work.path().join("in/out"));
    let args = |to: &[&str]| {
        let mut args = vec![path(&input), "-r".into(), "--out-dir".into(), path(&out)];
        args.extend(to.iter().map(|arg| (*arg).to_owned()));
        args
    };
    succeed(args(&[]));
    assert_eq!(names(&out), ["b.obj", "deep/er/a.obj"]);
    // What the first run wrote is no input of the second, although it lies within the folder.
    succeed(args(&["--to", "glb"]));
    assert_eq!(names(&out), ["b.glb", "b.obj", "deep/er/a.glb", "deep/er/a.obj"]);
}

#[test]
fn a_bad_file_does_not_stop_a_batch_and_leaves_nothing() {
    let work = folder(&[("a.obj", TRIANGLE), ("b.obj", BAD), ("c.obj", TRIANGLE)]);
    let out = work.path().join("out");
    let inputs = ["a.obj", "b.obj", "c.obj"].map(|name| path(work.path().join(name)));
    let output = normals(inputs.iter().cloned().chain(["--out-dir".into(), path(&out)]));
    assert_eq!(code(&output), 5);
    assert_eq!(names(&out), ["a.obj", "c.obj"]);
    let failed = format!("2 of 3 files done, 1 failed:\n  {}: line 2: ", inputs[1]);
    assert!(text(&output.stdout).contains(&failed), "{}", text(&output.stdout));
    let said = text(&output.stderr);
    assert!(said.starts_with("error: ") && said.lines().nth(1).unwrap().starts_with("help: "), "{said}");
    assert_eq!(said.lines().count(), 2);
}

#[test]
fn in_place_replaces_and_a_failure_leaves_the_input() {
    let work = folder(&[("a.obj", TRIANGLE), ("b.obj", BAD)]);
    let [a, b] = ["a.obj", "b.obj"].map(|name| work.path().join(name));
    assert_eq!(code(&normals([path(&a), path(&b), "--in-place".into()])), 5);
    assert!(fs::read_to_string(&a).unwrap().contains("vn 0 0 1"));
    assert_eq!(fs::read_to_string(&b).unwrap(), BAD);
    assert_eq!(names(work.path()), ["a.obj", "b.obj"]);
}

#[test]
fn an_output_is_the_input_only_in_place() {
    let work = folder(&[("a.obj", TRIANGLE)]);
    let a = path(work.path().join("a.obj"));
    let same = path(work.path().join("../").join(work.path().file_name().unwrap()).join("a.obj"));
    for args in [[&a, "-o", &a], [&a, "-o", &same]] {
        let refused = normals(args);
        assert_eq!(code(&refused), 2);
        assert!(text(&refused.stderr).contains("--in-place"), "{}", text(&refused.stderr));
    }
    assert_eq!(fs::read_to_string(&a).unwrap(), TRIANGLE);
    succeed([&a, "--in-place"]);
    assert!(fs::read_to_string(&a).unwrap().contains("vn "));
}

/// A glTF triangle in a buffer file.
fn external(uri: &str) -> String {
    format!(
        r#"{{"asset":{{"version":"2.0"}},"nodes":[{{"mesh":0}}],"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[0,0,0]}}],
        "bufferViews":[{{"buffer":0,"byteLength":36}}],"buffers":[{{"byteLength":36,"uri":"{uri}"}}]}}"#
    )
}

#[test]
fn a_buffer_outside_comes_next_to_the_output_that_would_not_find_it() {
    let zeros = "\0".repeat(36);
    let files = [("rt/in/a.gltf", external("../shared/b.bin")), ("rt/shared/b.bin", zeros)];
    let files: Vec<(&str, &str)> = files.iter().map(|(name, content)| (*name, content.as_str())).collect();
    let work = folder(&files);
    let at = |name: &str| path(work.path().join(name));
    for when in ["always", "missing"] {
        // From here `../shared/b.bin` leads nowhere.
        let out = at("rt/o.gltf");
        let reported = succeed([&at("rt/in/a.gltf"), "--root", &at("rt"), "-o", &out, "--when", when]);
        assert!(!text(&reported.stdout).contains("the same bytes"), "{}", text(&reported.stdout));
        assert!(fs::read_to_string(&out).unwrap().contains("\"uri\":\"o.b.bin\""));
        succeed([&out, "--dry-run"]);
        // From here it leads to the same file.
        let out = at("rt/in/o.gltf");
        succeed([&at("rt/in/a.gltf"), "--root", &at("rt"), "-o", &out, "--when", when]);
        assert!(fs::read_to_string(&out).unwrap().contains("\"uri\":\"../shared/b.bin\""));
        succeed([&out, "--root", &at("rt"), "--dry-run"]);
    }
    let stream = succeed([&at("rt/in/a.gltf"), "--root", &at("rt"), "-o", "-"]);
    assert!(text(&stream.stdout).contains("\"uri\":\"data:"));
}

#[test]
fn a_file_next_to_the_output_that_is_replaced_is_reported() {
    let work = folder(&[("a.obj", TRIANGLE), ("out/a.bin", "somebody else's")]);
    let args = [path(work.path().join("a.obj")), "-o".into(), path(work.path().join("out/a.gltf"))];
    for said in [true, false] {
        for dry in [true, false] {
            let dry = dry.then(|| "--dry-run".to_owned());
            let output = succeed(args.iter().cloned().chain(dry));
            assert_eq!(text(&output.stderr).contains("a.bin belongs to the output"), said);
        }
    }
}

#[test]
fn companions_of_two_inputs_that_clash_are_refused_in_a_dry_run_too() {
    let with = |color: &str| format!("newmtl x\nKd {color}\n");
    let (red, blue, obj) = (with("1 0 0"), with("0 0 1"), format!("mtllib m.mtl\n{TRIANGLE}"));
    let files = [("1/a.obj", &*obj), ("1/m.mtl", &red), ("2/b.obj", &*obj), ("2/m.mtl", &blue)];
    let work = folder(&files);
    let at = |name: &str| path(work.path().join(name));
    for dry in [&["--dry-run"][..], &[]] {
        let args = [at("1/a.obj"), at("2/b.obj"), "--out-dir".into(), at("out")];
        let output = normals(args.into_iter().chain(dry.iter().map(|arg| (*arg).to_owned())));
        assert_eq!(code(&output), 5);
        let error = text(&output.stderr);
        assert!(error.contains("m.mtl") && error.contains("into different folders"), "{error}");
        assert_eq!(names(work.path()).len(), if dry.is_empty() { 6 } else { 4 });
    }
}

#[test]
fn nothing_is_said_to_go_with_a_stream() {
    let gear = path(data("gear.obj"));
    let output = succeed([&gear, "-o", "-", "--to", "obj"]);
    assert!(!text(&output.stderr).contains("with gear.mtl"), "{}", text(&output.stderr));
    assert!(text(&output.stderr).contains("not copied to a stream, although the output refers to it"));
    let output = succeed([&gear, "-o", "-", "--to", "obj", "--json"]);
    let report: serde_json::Value = serde_json::from_slice(&output.stderr).unwrap();
    assert_eq!(report["output"]["companions"], serde_json::json!([]));
}

#[cfg(target_os = "linux")]
#[test]
fn a_report_that_cannot_be_written_is_a_failure() {
    let full = || fs::File::options().write(true).open("/dev/full").unwrap();
    for extra in [&["--emit", "face", "--json"][..], &["--dry-run"]] {
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_crease"));
        command.arg("normals").arg(data("gear.obj")).args(extra);
        let output = command.stdout(full()).stderr(std::process::Stdio::piped()).spawn().unwrap();
        let output = output.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(4));
        assert!(text(&output.stderr).contains("the report could not be written"), "{extra:?}");
    }
    for args in [&["--version"][..], &["normals", "--help"]] {
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_crease"));
        assert_eq!(command.args(args).stdout(full()).status().unwrap().code(), Some(4), "{args:?}");
    }
}

#[test]
fn what_is_complete_stays_to_the_byte_and_is_not_even_touched_in_place() {
    for (name, to) in
        [("gear.obj", "obj"), ("mirrored.gltf", "gltf"), ("far.ply", "ply"), ("sphere-seam.glb", "glb")]
    {
        let work = folder(&[]);
        let [first, second] = ["first", "second"].map(|stem| work.path().join(format!("{stem}.{to}")));
        succeed([path(data(name)), "-o".into(), path(&first), "--crease".into(), "40".into()]);
        for when in ["missing", "broken"] {
            succeed([&path(&first), "-o", &path(&second), "--when", when]);
            assert!(fs::read(&first).unwrap() == fs::read(&second).unwrap(), "{name} --when {when}");
        }
        let touched = fs::metadata(&first).unwrap().modified().unwrap();
        let output = succeed([&path(&first), "--in-place", "--when", "missing"]);
        assert!(text(&output.stdout).contains("the same bytes as the input"), "{}", text(&output.stdout));
        assert_eq!(fs::metadata(&first).unwrap().modified().unwrap(), touched, "{name}");
    }
}

#[test]
fn a_dry_run_writes_nothing() {
    let work = folder(&[("a.obj", TRIANGLE)]);
    let [a, b] = ["a.obj", "b.obj"].map(|name| path(work.path().join(name)));
    for args in [&[&a, "-o", &b, "--dry-run"][..], &[&a, "--in-place", "--dry-run"], &[&a, "--dry-run"]] {
        let output = succeed(args);
        assert!(text(&output.stdout).contains("not stored"), "{}", text(&output.stdout));
    }
    assert_eq!(names(work.path()), ["a.obj"]);
    assert_eq!(fs::read_to_string(a).unwrap(), TRIANGLE);
}

#[test]
fn companions_follow_and_are_read_from_below_the_root_only() {
    let with_material = format!("mtllib ../shared/m.mtl\n{TRIANGLE}");
    let files = [
        ("in/a.obj", with_material.as_str()),
        ("shared/m.mtl", "newmtl x\n"),
        ("in/b.obj", "mtllib n.mtl\n"),
        ("in/n.mtl", ""),
    ];
    let work = folder(&files);
    let at = |name: &str| path(work.path().join(name));
    let refused = succeed([&at("in/a.obj"), "-o", &at("out/a.obj")]);
    assert!(text(&refused.stderr).contains("warning: ") && text(&refused.stderr).contains("m.mtl"));
    let allowed = succeed([&at("in/a.obj"), "-o", &at("out/a.obj"), "--root", &at("")]);
    assert!(!text(&allowed.stderr).contains("not read"), "{}", text(&allowed.stderr));
    succeed([&at("in/b.obj"), "-o", &at("out/b.obj"), "--sync"]);
    assert_eq!(names(&work.path().join("out")), ["a.obj", "b.obj", "n.mtl"]);
    assert_eq!(names(&work.path().join("shared")), ["m.mtl"], "no companion leaves the output's folder");
}

#[test]
fn a_file_without_faces_goes_through() {
    let work = folder(&[("points.obj", "v 0 0 0\nv 1 2 3\np 1 2\n"), ("empty.obj", "# nothing\n")]);
    for name in ["points", "empty"] {
        let input = path(work.path().join(format!("{name}.obj")));
        for to in ["obj", "ply", "stl", "gltf", "glb"] {
            succeed([&input, "-o", &path(work.path().join(format!("out/{name}.{to}")))]);
        }
        let copy = fs::read(work.path().join(format!("out/{name}.obj"))).unwrap();
        assert_eq!(copy, fs::read(input).unwrap());
    }
}

#[cfg(unix)]
mod unix {
    use super::*;
    use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
    use std::process::Command;

    #[test]
    fn links_are_followed_and_permissions_kept() {
        let work = folder(&[("real/a.obj", TRIANGLE)]);
        let (real, link) = (work.path().join("real/a.obj"), work.path().join("link.obj"));
        symlink("real/a.obj", &link).unwrap();
        fs::set_permissions(&real, fs::Permissions::from_mode(0o600)).unwrap();
        succeed([path(&link), "--in-place".into()]);
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert!(fs::read_to_string(&real).unwrap().contains("vn "));
        assert_eq!(fs::metadata(&real).unwrap().mode() & 0o777, 0o600);
    }

    #[test]
    fn a_new_file_is_as_open_as_the_umask_allows() {
        let work = folder(&[("a.obj", TRIANGLE)]);
        for (umask, expected) in [("022", 0o644), ("077", 0o600), ("002", 0o664)] {
            let script = format!("umask {umask}; exec \"$0\" normals a.obj -o b{umask}.obj");
            let mut shell = Command::new("sh");
            shell.args(["-c", &script, env!("CARGO_BIN_EXE_crease")]).current_dir(work.path());
            assert!(shell.output().unwrap().status.success());
            let mode = fs::metadata(work.path().join(format!("b{umask}.obj"))).unwrap().mode() & 0o777;
            assert_eq!(mode, expected, "umask {umask}");
        }
    }

    #[test]
    fn a_write_protected_file_is_not_replaced() {
        let work = folder(&[("a.obj", TRIANGLE), ("b.obj", "keep me")]);
        let [a, b] = ["a.obj", "b.obj"].map(|name| work.path().join(name));
        fs::set_permissions(&b, fs::Permissions::from_mode(0o444)).unwrap();
        let output = normals([path(&a), "-o".into(), path(&b)]);
        assert_eq!(code(&output), 4);
        assert!(text(&output.stderr).contains("write-protected"));
        assert_eq!(fs::read_to_string(&b).unwrap(), "keep me");
        assert_eq!(names(work.path()), ["a.obj", "b.obj"]);
    }

    #[test]
    fn a_link_to_the_input_is_the_input() {
        let work = folder(&[("a.obj", TRIANGLE)]);
        let (a, link) = (path(work.path().join("a.obj")), path(work.path().join("b.obj")));
        symlink(&a, &link).unwrap();
        assert_eq!(code(&normals([&a, "-o", &link])), 2);
        assert_eq!(fs::read_to_string(a).unwrap(), TRIANGLE);
    }

    #[test]
    fn a_device_is_written_to_and_not_replaced() {
        let work = folder(&[("a.obj", TRIANGLE)]);
        succeed([&path(work.path().join("a.obj")), "-o", "/dev/null", "--to", "obj"]);
        assert!(!fs::metadata("/dev/null").unwrap().is_file());
    }
}
