//! Files: where they go, what becomes of those that are there, and what is left when something fails.

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
    assert!(text(&output.stdout).contains("2 of 3 files done, 1 failed"));
    assert_eq!(text(&output.stderr).lines().count(), 1);
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
fn an_output_may_be_the_input_where_that_is_typed() {
    let work = folder(&[("a.obj", TRIANGLE)]);
    let a = path(work.path().join("a.obj"));
    succeed([&a, "-o", &a]);
    assert!(fs::read_to_string(&a).unwrap().contains("vn "));
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
    fn a_device_is_written_to_and_not_replaced() {
        let work = folder(&[("a.obj", TRIANGLE)]);
        succeed([&path(work.path().join("a.obj")), "-o", "/dev/null", "--to", "obj"]);
        assert!(!fs::metadata("/dev/null").unwrap().is_file());
    }
}
