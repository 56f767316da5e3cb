//! Batches from a manifest, in shards, with a journal.

use crate::cli::{code, crease, data, folder, path, succeed, text};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::time::Duration;

/// A folder with so many copies of a small mesh, and a manifest that names them.
fn files(count: usize) -> tempfile::TempDir {
    let work = folder(&[]);
    fs::create_dir(work.path().join("in")).unwrap();
    let names: Vec<String> = (0..count).map(|number| format!("in/{number:04}.obj")).collect();
    for (number, name) in names.iter().enumerate() {
        // Each has other positions.
        let text = format!("v 0 0 0\nv {} 0 0\nv 0 1 0\nf 1 2 3\n", number + 1);
        fs::write(work.path().join(name), text).unwrap();
    }
    fs::write(work.path().join("list"), names.join("\n")).unwrap();
    work
}

/// Runs `crease normals` in a folder.
fn run(folder: &Path, args: &[&str]) -> (i32, String, String) {
    let output = crease().arg("normals").args(args).current_dir(folder).output().unwrap();
    (code(&output), text(&output.stdout).to_owned(), text(&output.stderr).to_owned())
}

fn outputs(folder: &Path) -> BTreeSet<String> {
    let Ok(list) = fs::read_dir(folder.join("out/in")) else { return BTreeSet::new() };
    list.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
}

fn statuses(json: &str, status: &str) -> usize {
    json.lines().filter(|line| line.contains(&format!("\"status\":\"{status}\""))).count()
}

const TO_OUT: [&str; 4] = ["--manifest", "list", "--out-dir", "out"];

#[test]
fn shards_together_do_all_and_none_twice() {
    let work = files(20);
    let mut all = BTreeSet::new();
    for shard in ["0/3", "1/3", "2/3"] {
        let before = outputs(work.path());
        let (status, _, errors) = run(work.path(), &[&TO_OUT[..], &["--shard", shard, "-q"]].concat());
        assert_eq!(status, 0, "{errors}");
        let new: BTreeSet<_> = outputs(work.path()).difference(&before).cloned().collect();
        assert!(!new.is_empty() && all.is_disjoint(&new), "{shard}: {new:?}");
        all.extend(new);
    }
    assert_eq!(all.len(), 20);
}

#[test]
fn a_journal_skips_what_is_done_and_redoes_what_changed() {
    let work = files(6);
    let args = [&TO_OUT[..], &["--journal", "journal", "--json"]].concat();
    let statuses_of = |args: &[&str]| {
        let (status, json, errors) = run(work.path(), args);
        assert_eq!(status, 0, "{errors}");
        ["ok", "skipped"].map(|status| statuses(&json, status))
    };
    assert_eq!(statuses_of(&args), [6, 0]);
    assert_eq!(statuses_of(&args), [0, 6]);
    // An input, an output, and an output that is gone.
    fs::write(work.path().join("in/0001.obj"), "v 0 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n").unwrap();
    fs::write(work.path().join("out/in/0002.obj"), "damaged").unwrap();
    fs::remove_file(work.path().join("out/in/0003.obj")).unwrap();
    assert_eq!(statuses_of(&args), [3, 3]);
    assert_eq!(statuses_of(&args), [0, 6]);
    let other = [&args[..], &["--weight", "area"]].concat();
    assert_eq!(statuses_of(&other), [6, 0], "other options");
    // The end of the report for people.
    let (_, report, _) =
        run(work.path(), &[&TO_OUT[..], &["--journal", "journal", "--weight", "area"]].concat());
    assert!(report.contains("6 files done (6 of them before)"), "{report}");
}

#[test]
fn a_buffer_that_changed_is_noticed() {
    let work = folder(&[]);
    let gltf = path(work.path().join("a.gltf"));
    succeed([&*path(data("part.stl")), "-o", &gltf, "-q"]);
    let args = ["a.gltf", "--out-dir", "out", "--journal", "journal", "--json", "--to", "glb"];
    assert_eq!(statuses(&run(work.path(), &args).1, "ok"), 1);
    assert_eq!(statuses(&run(work.path(), &args).1, "skipped"), 1);
    let buffer = work.path().join("a.bin");
    let mut bytes = fs::read(&buffer).unwrap();
    bytes[2] ^= 1;
    fs::write(&buffer, bytes).unwrap();
    assert_eq!(statuses(&run(work.path(), &args).1, "ok"), 1);
}

#[test]
fn files_replaced_in_place_are_done_once() {
    let work = files(3);
    let args = ["--manifest", "list", "--in-place", "--journal", "journal", "--json"];
    assert_eq!(statuses(&run(work.path(), &args).1, "ok"), 3);
    assert_eq!(statuses(&run(work.path(), &args).1, "skipped"), 3);
}

#[test]
fn what_cannot_be_compared_is_never_skipped() {
    let work = folder(&[]);
    let triangle = |x: u32| format!("v 0 0 0\nv {x} 0 0\nv 0 1 0\nf 1 2 3\n");
    for x in 1..3 {
        let args = ["normals", "-", "--format", "obj", "-o", "s.obj", "--journal", "journal", "-q"];
        let output = crease().args(args).current_dir(work.path()).write_stdin(triangle(x)).output().unwrap();
        assert_eq!(code(&output), 0);
        let written = fs::read_to_string(work.path().join("s.obj")).unwrap();
        assert!(written.contains(&format!("v {x} 0 0")), "{written}");
    }
    // A file that is newer than the run, as one that changed during it.
    let input = work.path().join("late.obj");
    fs::write(&input, triangle(1)).unwrap();
    let later = std::time::SystemTime::now() + Duration::from_secs(3600);
    fs::File::options().append(true).open(&input).unwrap().set_modified(later).unwrap();
    let args = ["late.obj", "--out-dir", "out", "--journal", "journal", "--json"];
    for _ in 0..2 {
        assert_eq!(statuses(&run(work.path(), &args).1, "ok"), 1);
    }
}

/// What one share writes is no input of another, and no output of it either.
#[test]
fn collisions_are_found_across_shares() {
    let work = files(2);
    for (lines, options, found) in [
        (["in/0000.obj:in/0001.obj", "in/0001.obj:x.ply"], vec![], "overwrite the input in/0001.obj"),
        (
            ["in/0000.obj:in/0001.obj", "in/0001.obj:x.ply"],
            vec!["--in-place"],
            "overwrite the input in/0001.obj",
        ),
        (["in/0000.obj:x.ply", "in/0001.obj:x.ply"], vec![], "would both be written to x.ply"),
    ] {
        let line = |line: &str| {
            let (input, output) = line.split_once(':').unwrap();
            format!(r#"{{"input": "{input}", "output": "{output}"}}"#)
        };
        fs::write(work.path().join("list"), lines.map(line).join("\n")).unwrap();
        for shard in ["0/7", "3/7"] {
            let args = [&["--manifest", "list", "--shard", shard], &options[..]].concat();
            let (status, _, errors) = run(work.path(), &args);
            assert!(status == 2 && errors.contains(found), "{args:?}: {status}: {errors}");
        }
    }
}

/// A companion of an output that is skipped is not replaced by that of another input.
#[test]
fn companions_of_skipped_outputs_stay() {
    let work = folder(&[]);
    for (folder, x) in [("a", 1), ("b", 2)] {
        fs::create_dir(work.path().join(folder)).unwrap();
        let text = format!("v 0 0 0\nv {x} 0 0\nv 0 1 0\nf 1 2 3\n");
        fs::write(work.path().join(folder).join("m.obj"), text).unwrap();
    }
    let lines = [("a", "gltf"), ("b", "GLTF")]
        .map(|(input, ending)| format!(r#"{{"input": "{input}/m.obj", "output": "m.{ending}"}}"#));
    fs::write(work.path().join("list"), lines.join("\n")).unwrap();
    for _ in 0..3 {
        let (status, _, errors) = run(work.path(), &["--manifest", "list", "--journal", "journal"]);
        assert!(status == 5 && errors.contains("b/m.obj: "), "{status}: {errors}");
    }
}

#[test]
fn failures_are_in_the_journal_and_are_retried() {
    let work = files(3);
    fs::write(work.path().join("in/0001.obj"), "v 0 0 nan\nf 1 1 1\n").unwrap();
    let args = [&TO_OUT[..], &["--journal", "journal", "-q"]].concat();
    assert_eq!(run(work.path(), &args).0, 5);
    let journal = |action: &str| {
        let output = crease().args(["journal", action, "journal"]).current_dir(work.path()).output().unwrap();
        assert_eq!(code(&output), 0);
        text(&output.stdout).to_owned()
    };
    assert_eq!(journal("failed"), "{\"input\":\"in/0001.obj\"}\n");
    let summary = journal("summary");
    assert!(summary.starts_with("3 files: 2 done, 1 failed") && summary.contains("1 failed: "), "{summary}");
    fs::write(work.path().join("in/0001.obj"), "v 0 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n").unwrap();
    let (status, json, _) = run(work.path(), &[&args[..4], &["--journal", "journal", "--json"]].concat());
    assert_eq!((status, statuses(&json, "ok"), statuses(&json, "skipped")), (0, 1, 2));
    assert_eq!(journal("failed"), "");
    assert_eq!(journal("merge").lines().count(), 3, "the last entry of each file");
    // Outputs that cannot be written, for one reason, are one line of the summary.
    fs::write(work.path().join("file"), "").unwrap();
    let args = ["--manifest", "list", "--out-dir", "file", "--journal", "journal", "-q"];
    assert_eq!(run(work.path(), &args).0, 5);
    let summary = journal("summary");
    assert!(summary.lines().filter(|line| line.contains("failed: ")).count() == 1, "{summary}");
}

/// Whatever is at work at the same time, the outputs, reports and their order are the same.
#[test]
fn jobs_within_any_memory_write_and_report_the_same() {
    let work = files(40);
    fs::write(work.path().join("in/0007.obj"), "v 0 0 nan\nf 1 1 1\n").unwrap();
    fs::write(work.path().join("in/0021.obj"), "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    let all = |jobs: &str, memory: &str| {
        let args =
            ["--manifest", "list", "--out-dir", jobs, "--to", "gltf", "--jobs", jobs, "--memory", memory];
        let (status, report, errors) = run(work.path(), &args);
        assert_eq!(status, 5, "{errors}");
        let folder = work.path().join(jobs).join("in");
        let mut files: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
        files.sort();
        let bytes: Vec<_> = files.iter().map(|path| fs::read(path).unwrap()).collect();
        let names: Vec<_> = files.iter().map(|path| path.file_name().unwrap().to_owned()).collect();
        let report = report.replace(&format!("{jobs}/in"), "out/in");
        (names, bytes, report.lines().map(str::to_owned).collect::<Vec<_>>(), errors)
    };
    let one = all("1", "8G");
    assert_eq!(one.0.len(), 2 * 39, "a buffer each");
    for (jobs, memory) in [("2", "1"), ("8", "1G"), ("3", "4K")] {
        assert_eq!(all(jobs, memory), one, "{jobs} jobs, {memory}");
    }
}

/// Each has a companion of the same name with other content: the later one fails, whichever is ready first.
#[test]
fn of_two_companions_with_one_name_the_first_is_written() {
    let work = folder(&[]);
    // The first takes a hundred times as long as the second.
    let large = path(work.path().join("large.obj"));
    let made =
        crease().args(["surface", "wave", "--segments", "120x120", "-o", &large, "-q"]).output().unwrap();
    assert_eq!(code(&made), 0);
    let large = fs::read(large).unwrap();
    for (folder, text) in [("a", &large[..]), ("b", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")] {
        fs::create_dir(work.path().join(folder)).unwrap();
        fs::write(work.path().join(folder).join("m.obj"), text).unwrap();
    }
    // The buffers of both would be `m.bin`.
    let lines = [("a", "gltf"), ("b", "GLTF")]
        .map(|(input, ending)| format!(r#"{{"input": "{input}/m.obj", "output": "m.{ending}"}}"#));
    fs::write(work.path().join("list"), lines.join("\n")).unwrap();
    let (status, _, errors) = run(work.path(), &["--manifest", "list", "--jobs", "2"]);
    assert!(status == 5 && errors.contains("b/m.obj: ") && errors.contains("another output"), "{errors}");
    assert!(work.path().join("m.gltf").is_file() && !work.path().join("m.GLTF").exists());
}

#[test]
fn a_line_may_have_options_of_its_own() {
    let work = files(3);
    let lines = [
        r#"{"input": "in/0000.obj", "output": "a.ply", "options": ["--to", "ply"]}"#,
        r#"{"input": "in/0001.obj", "output": "b.glb", "options": ["--normal-format=i8", "--crease", "7"]}"#,
        "in/0002.obj",
    ];
    fs::write(work.path().join("list"), lines.join("\n")).unwrap();
    let args = ["--manifest", "list", "--out-dir", "out", "--crease", "30", "--json", "--journal", "journal"];
    let (status, json, errors) = run(work.path(), &args);
    assert_eq!(status, 0, "{errors}");
    let creases: Vec<&str> = json
        .lines()
        .map(|line| line.split("\"crease\":").nth(2).unwrap().split(',').next().unwrap())
        .collect();
    assert_eq!(creases, ["30.0", "7.0", "30.0"], "{json}");
    assert!(work.path().join("a.ply").is_file() && work.path().join("out/in/0002.obj").is_file());
    let glb = fs::read(work.path().join("b.glb")).unwrap();
    assert!(String::from_utf8_lossy(&glb).contains("KHR_mesh_quantization"));
    // Other options of one line: that file alone is done anew.
    fs::write(work.path().join("list"), lines.join("\n").replace('7', "8")).unwrap();
    let (_, json, _) = run(work.path(), &args);
    assert_eq!([statuses(&json, "ok"), statuses(&json, "skipped")], [1, 2]);
    for (options, found) in [
        (r#""--creese""#, "error: list:1: unknown option --creese"),
        (r#""--to", "glb", "--in-place", "--normal-format", "i4""#, "error: list:1: --in-place is the same"),
        (r#""--emit", "face""#, "error: list:1: --emit face writes"),
        (r#""--jobs", "2""#, "--jobs is the same for all inputs"),
        (r#""--crease", "x""#, "wrong value"),
        (r#""x.obj""#, "cannot be used with"),
    ] {
        fs::write(work.path().join("list"), format!(r#"{{"input": "in/0000.obj", "options": [{options}]}}"#))
            .unwrap();
        let (status, _, errors) = run(work.path(), &["--manifest", "list", "--out-dir", "x"]);
        assert!(status == 2 && errors.contains(found), "{options}: {status}: {errors}");
    }
}

/// The list of failed files is a manifest that does what the first one asked for.
#[test]
fn failed_files_are_done_as_their_lines_ask() {
    let mesh = "v 0 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n";
    let lines = [
        "in/0000.obj",
        r#"{"input": "in/0001.obj", "output": "b.glb", "options": ["--normal-format=i8", "--crease", "7"]}"#,
        r#"{"input": "in/0002.obj", "options": ["--to", "ply"]}"#,
        r#"{"input": "in/0003.obj", "output": "d.stl"}"#,
    ];
    let names = ["out/in/0000.obj", "b.glb", "out/in/0002.ply", "d.stl"];
    let outcome = |fails: bool| {
        let work = files(4);
        for number in 0..4 {
            let text = if fails { "v 0 0 nan\nf 1 1 1\n" } else { mesh };
            fs::write(work.path().join(format!("in/{number:04}.obj")), text).unwrap();
        }
        fs::write(work.path().join("list"), lines.join("\n")).unwrap();
        let args = ["--out-dir", "out", "--weight", "area", "--journal", "journal", "-q"];
        let run_list = |list: &str| run(work.path(), &[&["--manifest", list], &args[..]].concat());
        assert_eq!(run_list("list").0, if fails { 5 } else { 0 });
        if fails {
            let (_, list, _) = run_verb(work.path(), &["journal", "failed", "journal"]);
            assert_eq!(list.lines().count(), 4);
            fs::write(work.path().join("failed"), list).unwrap();
            (0..4)
                .for_each(|number| fs::write(work.path().join(format!("in/{number:04}.obj")), mesh).unwrap());
            let (status, _, errors) = run_list("failed");
            assert_eq!(status, 0, "{errors}");
            // The first list finds the entries of the second.
            let (_, report, _) = run(work.path(), &[&["--manifest", "list"], &args[..6]].concat());
            assert!(report.contains("4 files done (4 of them before)"), "{report}");
        }
        names.map(|name| fs::read(work.path().join(name)).unwrap())
    };
    assert!(outcome(true) == outcome(false));
}

/// Killed before or after the file is replaced, with or without the last line of the journal.
#[test]
fn a_file_is_not_flipped_twice_after_a_kill() {
    let work = files(1);
    let [input, journal] = ["in/0000.obj", "journal"].map(|name| work.path().join(name));
    let old = fs::read(&input).unwrap();
    let args = ["--manifest", "list", "--in-place", "--flip", "--journal", "journal", "-q"];
    assert_eq!(run(work.path(), &args).0, 0);
    let (flipped, entries) = (fs::read(&input).unwrap(), fs::read_to_string(&journal).unwrap());
    assert!(old != flipped && entries.lines().count() == 2, "{entries}");
    let (first, _) = entries.split_at(entries.find('\n').unwrap() + 1);
    for (found, kept) in [(&old, ""), (&old, first), (&flipped, first), (&flipped, &entries)] {
        fs::write(&input, found).unwrap();
        fs::write(&journal, kept).unwrap();
        assert_eq!(run(work.path(), &args).0, 0);
        assert!(fs::read(&input).unwrap() == flipped, "{kept}");
    }
}

#[test]
fn killed_runs_flip_each_file_once() {
    let work = files(60);
    let read = || (0..60).map(|number| fs::read(work.path().join(format!("in/{number:04}.obj"))).unwrap());
    let args = ["--manifest", "list", "--in-place", "--flip", "--journal", "journal", "-q", "--jobs", "2"];
    let old: Vec<_> = read().collect();
    for kill in 0..6 {
        let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_crease"))
            .arg("normals")
            .args(args)
            .current_dir(work.path())
            .spawn()
            .unwrap();
        std::thread::sleep(Duration::from_millis(15 + 9 * kill));
        child.kill().unwrap();
        child.wait().unwrap();
    }
    assert_eq!(run(work.path(), &args).0, 0);
    for (old, new) in old.iter().zip(read()) {
        let [old, new] = [old, &new].map(|bytes| text(bytes).lines().last().unwrap().to_owned());
        assert_eq!([&*old, &*new], ["f 1 2 3", "f 1//1 3//1 2//1"]);
    }
}

#[test]
fn without_keep_going_a_batch_stops_at_the_first_failure() {
    let work = files(6);
    fs::remove_file(work.path().join("in/0002.obj")).unwrap();
    let (status, report, _) = run(work.path(), &[&TO_OUT[..], &["--keep-going=false"]].concat());
    assert_eq!((status, outputs(work.path()).len()), (5, 2));
    assert!(report.contains("2 of 6 files done, 3 not processed, 1 failed:"), "{report}");
    let (status, report, _) = run(work.path(), &[&TO_OUT[..], &["--keep-going"]].concat());
    assert_eq!((status, outputs(work.path()).len()), (5, 5));
    assert!(report.contains("5 of 6 files done, 1 failed:"), "{report}");
}

#[test]
fn a_file_counts_once_whatever_was_done_with_it() {
    let work = files(3);
    fs::write(work.path().join("in/0001.obj"), "v 0 0 nan\nf 1 1 1\n").unwrap();
    assert_eq!(run(work.path(), &[&TO_OUT[..], &["--journal", "journal", "-q"]].concat()).0, 5);
    let inspect = ["inspect", "--manifest", "list", "--journal", "journal", "--json"];
    assert_eq!(run_verb(work.path(), &inspect).0, 5);
    let (_, summary, _) = run_verb(work.path(), &["journal", "summary", "journal"]);
    assert!(summary.starts_with("3 files: 2 done, 1 failed"), "{summary}");
    assert!(["inspect", "normals"].iter().all(|verb| summary.contains(&format!("{verb}: 2 done, 1 failed"))));
    let (_, json, _) = run_verb(work.path(), &["journal", "summary", "journal", "--json"]);
    assert!(
        json.contains(r#""verbs":{"inspect":{"done":2,"failed":1},"normals":{"done":2,"failed":1}}"#),
        "{json}"
    );
    // Findings of files that are skipped.
    let (_, json, _) = run_verb(work.path(), &inspect);
    let skipped: Vec<&str> = json.lines().filter(|line| line.contains("skipped")).collect();
    assert!(skipped.len() == 2 && skipped[0].contains(r#""verdict":"note","findings":[{"id":"#), "{json}");
    assert!(!skipped[0].contains("counts"), "{json}");
}

/// 3MF has no normals: an output folder receives a GLB.
#[test]
fn formats_that_are_not_written_become_glb_in_a_folder() {
    let work = folder(&[]);
    let work = work.path();
    fs::copy(data("pyramids.3mf"), work.join("pyramids.3mf")).unwrap();
    assert_eq!(run(work, &["pyramids.3mf", "--out-dir", "out", "-q"]).0, 0);
    assert!(fs::read(work.join("out/pyramids.glb")).unwrap().starts_with(b"glTF"));
    for args in [&["pyramids.3mf", "--in-place"][..], &["pyramids.3mf", "-o", "b.3mf"]] {
        let (status, _, errors) = run(work, args);
        assert!(
            status == 2 && errors.contains("3MF has no normals") | errors.contains("unknown output format"),
            "{errors}"
        );
    }
}

/// Standard input has no name for an output, and is no input that a journal could compare.
#[test]
fn lines_that_no_verb_can_do_are_refused_with_their_number() {
    let work = files(1);
    for verb in ["normals", "inspect", "render"] {
        let args: &[&str] = if verb == "inspect" { &[] } else { &["--out-dir", "out"] };
        for (line, expected, found) in [
            ("-", 3, "list:2: `-` is standard input"),
            (r#"{"input": "-"}"#, 3, "list:2: `-` is standard input"),
            (r#"{"input": "in/0000.obj", "options": 7}"#, 3, "list:2: not an object with"),
            (r#"{"input": "in/0000.obj", "options": ["--creese"]}"#, 2, "list:2: unknown option --creese"),
        ] {
            fs::write(work.path().join("list"), format!("in/0000.obj\n{line}\n")).unwrap();
            let (status, _, errors) = run_verb(work.path(), &[&[verb, "--manifest", "list"], args].concat());
            let message = format!("error: {found}");
            assert!(status == expected && errors.starts_with(&message), "{verb} {line}: {status}: {errors}");
        }
    }
}

#[test]
fn a_journal_has_one_writer_at_a_time() {
    let work = files(2);
    let args = [&TO_OUT[..], &["--journal", "journal", "-q"]].concat();
    assert_eq!(run(work.path(), &args).0, 0);
    let path = work.path().join("journal");
    let before = fs::read(&path).unwrap();
    let other = fs::File::options().append(true).open(&path).unwrap();
    other.lock().unwrap();
    let (status, _, errors) = run(work.path(), &args);
    assert!(
        status == 2 && errors.contains("the journal journal\nhelp: give each share"),
        "{status}: {errors}"
    );
    assert_eq!(fs::read(&path).unwrap(), before);
    // Closing it is not enough: processes that other tests begin meanwhile have copies of it until their programs start.
    other.unlock().unwrap();
    assert_eq!(run(work.path(), &args).0, 0);
}

/// Runs a verb in a folder.
fn run_verb(folder: &Path, args: &[&str]) -> (i32, String, String) {
    let output = crease().args(args).current_dir(folder).output().unwrap();
    (code(&output), text(&output.stdout).to_owned(), text(&output.stderr).to_owned())
}

#[test]
fn files_are_inspected_from_a_list_and_findings_are_counted() {
    let work = files(4);
    // Two faces with opposite winding.
    let reversed = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 3 4\n";
    fs::write(work.path().join("in/0002.obj"), reversed).unwrap();
    let args =
        ["inspect", "--manifest", "list", "--journal", "journal", "--jobs", "2", "--fail-on", "warning"];
    let (status, report, errors) = run_verb(work.path(), &args);
    assert!(status == 1 && report.lines().count() == 6, "{status}: {report}{errors}");
    assert_eq!(report.lines().last(), Some("-v lists the findings of each file"));
    let (status, report, _) = run_verb(work.path(), &args);
    assert!(status == 1 && report.contains("4 files done (4 of them before)"), "{status}: {report}");
    let (_, summary, _) = run_verb(work.path(), &["journal", "summary", "journal"]);
    assert!(summary.contains("inconsistent-winding: 1 file (1 element)"), "{summary}");
    fs::write(work.path().join("in/0002.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    assert_eq!(run_verb(work.path(), &args).0, 0);
    fs::write(work.path().join("list"), r#"{"input": "in/0000.obj", "output": "x"}"#).unwrap();
    let (status, _, errors) = run_verb(work.path(), &args);
    assert!(status == 2 && errors.contains("`inspect` has no `output`"), "{status}: {errors}");
}

#[test]
fn pictures_are_drawn_from_a_list_until_a_mesh_of_a_scene_changes() {
    let work = files(2);
    fs::write(work.path().join("scene.toml"), "[[object]]\nmesh = \"in/0001.obj\"\n").unwrap();
    let lines =
        ["in/0000.obj", r#"{"input": "scene.toml", "output": "s.png", "options": ["--size", "30x20"]}"#];
    fs::write(work.path().join("list"), lines.join("\n")).unwrap();
    let args = "render --manifest list --out-dir out --size 40x30 --journal journal --jobs 2 --json";
    let args: Vec<&str> = args.split(' ').collect();
    let drawn = || {
        let (status, json, errors) = run_verb(work.path(), &args);
        assert_eq!(status, 0, "{errors}");
        ["ok", "skipped"].map(|status| statuses(&json, status))
    };
    assert_eq!(drawn(), [2, 0]);
    let sides = |name: &str| fs::read(work.path().join(name)).unwrap()[16..24].to_vec();
    assert_eq!(sides("s.png"), [0, 0, 0, 30, 0, 0, 0, 20]);
    assert_eq!(sides("out/in/0000.png"), [0, 0, 0, 40, 0, 0, 0, 30]);
    assert_eq!(drawn(), [0, 2]);
    fs::write(work.path().join("in/0001.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    assert_eq!(drawn(), [1, 1]);
    fs::write(work.path().join("list"), "in/0000.obj\nin/0000.obj\n").unwrap();
    let (status, _, errors) = run_verb(work.path(), &args);
    assert!(status == 2 && errors.contains("would both be written to"), "{status}: {errors}");
}

/// Killed at any moment, a batch leaves whole outputs and a journal that the next run goes on from. With `CREASE_LONG`, 2000 files
/// and twenty kills.
#[test]
fn a_killed_batch_goes_on() {
    let (count, kills) = if std::env::var_os("CREASE_LONG").is_some() { (2000, 20) } else { (150, 5) };
    let work = files(count);
    let args = [&TO_OUT[..], &["--journal", "journal", "--json", "--jobs", "2"]].concat();
    let mut ok = 0;
    for kill in 1..=kills {
        let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_crease"))
            .arg("normals")
            .args(&args)
            .current_dir(work.path())
            .stdout(std::process::Stdio::piped())
            .spawn()
            .unwrap();
        // Moments that differ by more than a file takes.
        std::thread::sleep(Duration::from_millis(20 + 37 * (kill * 7 % kills)));
        child.kill().unwrap();
        let output = child.wait_with_output().unwrap();
        ok += statuses(&String::from_utf8_lossy(&output.stdout), "ok");
    }
    let (status, json, errors) = run(work.path(), &args);
    assert_eq!(status, 0, "{errors}");
    ok += statuses(&json, "ok");
    // Each kill loses at most the two files in work. Reports may be lost although their entries are there.
    let lost = 2 * kills as usize;
    assert!(ok <= count + lost, "{ok} files were done");
    let journal = fs::read_to_string(work.path().join("journal")).unwrap();
    let entries = journal.lines().filter(|line| line.starts_with('{') && line.ends_with('}')).count();
    assert!((count..=count + lost).contains(&entries), "{entries} entries");
    assert_eq!(outputs(work.path()).iter().filter(|name| name.ends_with(".obj")).count(), count);
    // The same bytes as in one go.
    let (status, ..) = run(work.path(), &["--manifest", "list", "--out-dir", "again", "-q"]);
    assert_eq!(status, 0);
    for name in outputs(work.path()).iter().filter(|name| name.ends_with(".obj")) {
        let [a, b] =
            ["out/in", "again/in"].map(|folder| fs::read(work.path().join(folder).join(name)).unwrap());
        assert!(a == b, "{name}");
    }
}

#[test]
fn wrong_lists_and_shares_are_refused_before_work() {
    let work = files(2);
    for (args, expected, found) in [
        (vec!["--manifest", "list"], 2, "list:1: no output for in/0000.obj"),
        (vec!["--manifest", "nowhere", "--out-dir", "out"], 3, "check the path of the manifest"),
        (vec!["--manifest", "list", "in/0000.obj", "--out-dir", "out"], 2, "--manifest"),
        (vec!["in/0000.obj", "--out-dir", "out", "--shard", "3/3"], 2, "from 0 to N − 1"),
        (vec!["in/0000.obj", "--out-dir", "out", "--journal", "in"], 4, "journal"),
        (vec!["in/0000.obj", "--out-dir", "out", "--journal", "list"], 4, "list is not a journal"),
        (vec!["in/0000.obj", "--out-dir", "out", "--journal", "/dev/null"], 4, "not a regular file"),
        (vec!["in/0000.obj", "--out-dir", "out", "--memory", "8X"], 2, "a number of bytes such as 8G"),
    ] {
        let (status, _, errors) = run(work.path(), &args);
        assert!(status == expected && errors.contains(found), "{args:?}: {status}: {errors}");
    }
    assert!(outputs(work.path()).is_empty());
    let summary = crease().args(["journal", "summary", "list"]).current_dir(work.path()).output().unwrap();
    assert!(code(&summary) == 3 && text(&summary.stderr).contains("list is not a journal"));
}
