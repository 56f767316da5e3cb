//! The scenes through the program, as their own comments say.

use super::{folder, names};
use crate::cli::{crease, text};
use crate::lectures::all_digits;
use std::fs;
use std::path::Path;
use std::process::Output;

/// Runs a command line that names a scene of the repository, in another folder.
fn run(command: &str, more: &[&str], here: &Path) -> Output {
    let words = command.split_whitespace().skip(1).map(|word| match word.strip_prefix("data/scenes/") {
        Some(name) => folder().join(name).into_os_string(),
        None => word.into(),
    });
    crease().args(words).args(more).current_dir(here).output().unwrap()
}

/// The commands in the comments of a scene.
fn commands(name: &str) -> Vec<String> {
    let text = fs::read_to_string(folder().join(name)).unwrap();
    let comments = text.lines().filter_map(|line| line.strip_prefix("#   crease "));
    comments.map(|rest| format!("crease {}", rest.split(" #").next().unwrap())).collect()
}

#[test]
fn commands_in_the_comments_work() {
    let here = tempfile::tempdir().unwrap();
    for name in names().iter().filter(|name| name.ends_with(".toml")) {
        let commands = commands(name);
        assert!(!commands.is_empty(), "{name} names no command");
        for command in commands {
            let output = run(&command, &[], here.path());
            let said = text(&output.stderr);
            assert!(output.status.success(), "{command}: {said}");
            // Only the scenes of the lectures may reflect more light than arrives.
            assert!(!said.contains("warning") || name.starts_with("lectures/"), "{command}: {said}");
            // A probe prints what the picture shows there; other commands do not.
            assert_eq!(
                text(&output.stdout).contains("in the picture ["),
                command.contains("--probe"),
                "{command}"
            );
        }
    }
    let pictures = fs::read_dir(here.path()).unwrap().count();
    assert!(pictures >= 12, "{pictures}");
}

/// What each command of the lectures' scenes prints, in their order.
const NUMBERS: &[(&str, &[[&str; 3]])] = &[
    ("example-01", &[["5.058800000"; 3], ["5.097096"; 3]]),
    ("example-02", &[["0.246250980"; 3], ["0.247001881"; 3]]),
    (
        "example-03",
        &[["0.152406275", "0.158421961", "0.155414118"], ["0.152425047", "0.158487665", "0.155456356"]],
    ),
    (
        "exercise-1-6-16",
        &[["0.600000000", "0.700000000", "0.000000000"], ["0.700000000", "0.800000000", "0.100000000"]],
    ),
    (
        "exercise-1-6-17",
        &[
            ["0.600000000", "0.800000000", "0.000000000"],
            ["0.900000000", "1.100000000", "0.300000000"],
            ["0.900000000", "1.100000000", "0.300000000"],
        ],
    ),
    ("exercise-1-6-18", &[["0.400000000", "0.800000000", "0.200000000"]; 2]),
    (
        "exercise-1-6-19",
        &[["0.353553391", "0.553553391", "0.000000000"], ["0.703553", "0.903553", "0.000000"]],
    ),
    ("exercise-1-6-23", &[["0.750000000", "0.000000000", "0.000000000"]]),
    ("exercise-1-6-24", &[["0.600000000", "0.400000000", "0.600000000"]]),
    (
        "exercise-1-6-25",
        &[
            ["0.100000000", "0.500000000", "0.500000000"],
            ["0.200000000", "0.300000000", "0.100000000"],
            ["0.150000000", "0.400000000", "0.300000000"],
        ],
    ),
    ("exercise-1-6-29", &[["0.000000000"; 3]]),
    ("exercise-1-6-31", &[["0.164689217", "0.209378433", "0.056000000"]]),
];

#[test]
fn probes_print_the_numbers_of_the_lectures() {
    let here = tempfile::tempdir().unwrap();
    let scenes = names().iter().filter(|name| name.starts_with("lectures/")).count();
    assert_eq!(scenes, NUMBERS.len());
    for (name, expected) in NUMBERS {
        let commands = commands(&format!("lectures/{name}.toml"));
        assert_eq!(commands.len(), expected.len(), "{name}");
        for (command, expected) in commands.iter().zip(*expected) {
            let output = run(command, &["--json"], here.path());
            let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
            let linear = &report["probe"]["linear"];
            println!("{command}: {linear}");
            all_digits([0, 1, 2].map(|k| linear[k].as_f64().unwrap()), *expected);
        }
    }
}
