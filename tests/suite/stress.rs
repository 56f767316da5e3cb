//! The numerical extremes: every expectation of the catalogue, and `crease stress` from outside.

use assert_cmd::Command;
use crease::trade::stress::{Group, Measured, StressCase, cases_of, catalogue};
use serde_json::Value;
use std::process::Output;

/// What the issue asks plain code to fail in, at least.
const PLAIN_FAILS: usize = 10;

/// Cases of more faces than this take most of the time, and the code of those of fewer.
fn is_quick(case: &StressCase) -> bool {
    case.name != "1000000 faces"
}

#[test]
fn every_expectation_holds_and_plain_code_fails_in_many() {
    let (mut plain_fails, mut declined, mut broken) = (0, 0, Vec::new());
    for case in catalogue() {
        let result = case.run();
        if !result.holds() {
            broken.push(format!("{case:?}: {:?}", result.measured));
        }
        assert!(result.measured.samples > 0, "{case:?}");
        assert_eq!(result.measured.fast.is_some(), case.fast_bound.is_some(), "{case:?}");
        plain_fails += usize::from(result.plain_fails());
        declined += usize::from(result.measured.declined > 0);
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
    assert!(plain_fails >= PLAIN_FAILS, "only {plain_fails}");
    assert!(declined > 20, "fast leaves its range in {declined} cases only");
}

/// The reference is not the code itself: where results are rounded, the error shows it.
#[test]
fn errors_are_those_of_rounding_and_no_less() {
    let worst = |group: Group| {
        let errors =
            cases_of(group).into_iter().filter(is_quick).map(|case| case.run().measured.faithful.error);
        errors.fold(0.0, f64::max)
    };
    assert!((0.45..=0.501).contains(&worst(Group::Magnitude)), "half an ulp of f32");
    assert!((0.45..=0.501).contains(&worst(Group::Needle)));
    assert!(worst(Group::Unit) > 1e-17 && worst(Group::Angle) > 1e-17 && worst(Group::Attenuation) > 1e-17);
}

/// The figures that were printed before this program was written.
#[test]
fn plain_code_fails_as_the_reference_says() {
    let plain = |group: Group, name: &str| {
        let cases = cases_of(group);
        let case = cases.iter().find(|case| case.name == name).unwrap_or_else(|| panic!("no case {name}"));
        case.run().measured.plain.unwrap()
    };
    // −128 for −75.1656036.
    assert!((plain(Group::Product, "Pharr's").error - (128.0 / 75.165_603_6 - 1.0)).abs() < 1e-6);
    // 1.84° and .154° on another sample.
    let thin = |name| plain(Group::Needle, name).error;
    assert!(
        (0.1..4.0).contains(&thin("height/length 1e-5")) && (0.01..0.4).contains(&thin("height/length 1e-4"))
    );
    // Storage: .63° at 1e4, 5.6° at 1e5, 41° at 1e6 on another sample of scalene triangles.
    for (name, figure) in [("1e4, storage", 0.63), ("1e5, storage", 5.6), ("1e6, storage", 41.0)] {
        let error = plain(Group::Offset, name).error;
        assert!((0.05..1.5).contains(&(error / figure)), "{name}: {error}");
    }
}

#[test]
fn the_same_errors_to_the_bit_at_any_number_of_threads() {
    let run = |threads: usize| -> Vec<Measured> {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            catalogue().iter().filter(|case| is_quick(case)).map(|case| case.run().measured).collect()
        })
    };
    // Of equal numbers only 0 has two signs, and no error is −0.
    let [one, two, three] = [1, 2, 3].map(run);
    assert_eq!(one, two);
    assert_eq!(one, three);
}

fn stress(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_crease")).arg("stress").args(args).output().unwrap()
}

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).unwrap()
}

fn keys(value: &Value) -> Vec<&str> {
    value.as_object().unwrap().keys().map(String::as_str).collect()
}

#[test]
fn the_table_reports_case_bound_error_and_verdict() {
    let output = stress(&["--only", "product,non-finite"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let table = text(&output.stdout);
    assert!(table.starts_with("non-finite: positions that are infinite or not a number\n"), "{table}");
    assert!(table.contains("\n  expected: within 2 roundings of the difference, or exactly 0\n"), "{table}");
    let row = table.lines().find(|line| line.contains("Pharr's")).unwrap();
    let cells: Vec<&str> = row.split_whitespace().collect();
    assert_eq!(cells, ["Pharr's", "2.3e-16", "rel", "0", "rel", "none", "0.703", "rel", "✗", "holds"]);
    let summary = table.lines().last().unwrap();
    assert!(
        summary.starts_with("6 cases: all expectations hold. Plain f32 code fails visibly in 6 of them (✗).")
    );
    let verbose = stress(&["--only", "product", "-v"]);
    assert!(text(&verbose.stdout).contains("      bound: 2u, u = 2^-53: Jeannerod, Louvet & Muller"));
    assert!(text(&verbose.stdout).contains("      plain: a·b - c·d"));
    assert_eq!(text(&stress(&["--only", "product", "-q"]).stdout), "");
}

#[test]
fn the_report_has_its_schema() {
    let output = stress(&["--only", "highlight", "--only", "encoding", "--json"]);
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(text(&output.stdout).lines().count(), 1);
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(keys(&report), ["cases", "crease", "schema", "seconds", "status", "summary"]);
    assert_eq!((&report["schema"], &report["status"]), (&"crease-stress/1".into(), &"ok".into()));
    let cases = report["cases"].as_array().unwrap();
    let count = cases_of(Group::Highlight).len() + cases_of(Group::Encoding).len();
    assert_eq!((cases.len(), &report["summary"]["cases"]), (count, &count.into()));
    let fails = cases.iter().filter(|case| case["plain"]["fails"] == true).count();
    assert_eq!((&report["summary"]["plain_fails"], &report["summary"]["broken"]), (&fails.into(), &0.into()));
    for case in cases {
        let known = ["expectation", "faithful", "fast", "group", "holds", "name", "plain", "samples", "what"];
        assert!(keys(case).iter().all(|key| known.contains(key) || *key == "without_fast"), "{case}");
        assert_ne!(case.get("fast").is_some(), case.get("without_fast").is_some(), "{case}");
        assert_eq!(keys(&case["faithful"]), ["bound", "undefined", "unit", "worst"]);
        assert_eq!(keys(&case["faithful"]["bound"]), ["most", "source"]);
        if case["group"] == "highlight" {
            assert_eq!(keys(&case["fast"]), ["bound", "declined", "undefined", "unit", "worst"]);
            assert_eq!(keys(&case["plain"]), ["fails", "formula", "undefined", "unit", "worst"]);
        } else {
            assert!(case.get("fast").is_none(), "{case}");
        }
        assert!(
            case["faithful"]["worst"].as_f64().unwrap()
                <= case["faithful"]["bound"]["most"].as_f64().unwrap()
        );
    }
    let opposite = cases.iter().find(|case| case["name"] == "H at L = -V").unwrap();
    assert_eq!((&opposite["plain"]["undefined"], &opposite["plain"]["fails"]), (&500.into(), &true.into()));
}

#[test]
fn cases_can_be_listed_and_chosen_and_wrong_names_are_refused() {
    let all = stress(&["--list"]);
    assert_eq!(all.status.code(), Some(0));
    for case in catalogue() {
        assert!(text(&all.stdout).contains(&format!("\n  {} ", case.name)), "{case:?}");
    }
    let some = stress(&["--list", "--only", "needle"]);
    assert_eq!(text(&some.stdout).lines().count(), 1 + cases_of(Group::Needle).len());
    for args in [&["--only", "nothing"][..], &["--list", "--json"], &["--threads", "0"], &["mesh.obj"]] {
        assert_eq!(stress(args).status.code(), Some(2), "{args:?}");
    }
    let help = stress(&["--help"]);
    for group in Group::ALL {
        assert!(text(&help.stdout).contains(&format!("- {}: ", group.name())), "{group:?}");
    }
}

#[test]
fn the_program_gives_the_same_report_with_one_thread() {
    let report = |threads: &str| {
        let output = stress(&["--only", "fan,needle,raster", "--json", "--threads", threads]);
        let mut report: Value = serde_json::from_slice(&output.stdout).unwrap();
        report["seconds"] = Value::Null;
        report
    };
    assert_eq!(report("1"), report("3"));
}
