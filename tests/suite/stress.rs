//! The numerical extremes: every expectation of the catalogue, and `crease stress` from outside.

use assert_cmd::Command;
use crease::trade::stress::{Cause, Group, Measured, StressCase, StressResult, cases_of, catalogue};
use glam::{DVec3, Vec3};
use serde_json::Value;
use std::f64::consts::TAU;
use std::process::Output;
use std::sync::LazyLock;

/// The least numbers of cases in which plain code fails: by rounding and by definition.
const PLAIN_FAILS: [usize; 2] = [10, 15];

/// What all cases measure, on all threads. Most of it is exact arithmetic, so tests share it.
static MEASURED: LazyLock<Vec<StressResult<'static>>> =
    LazyLock::new(|| CATALOGUE.iter().map(StressCase::run).collect());
static CATALOGUE: LazyLock<Vec<StressCase>> = LazyLock::new(catalogue);

/// Cases of more faces than this take most of the time, and the code of those of fewer.
fn is_quick(case: &StressCase) -> bool {
    case.name != "1000000 faces"
}

#[test]
fn every_expectation_holds_and_plain_code_fails_in_many() {
    let (mut causes, mut declined, mut broken) = (Vec::new(), 0, Vec::new());
    for result in &*MEASURED {
        let case = result.case;
        if !result.holds() {
            broken.push(format!("{case:?}: {:?}", result.measured));
        }
        assert!(result.measured.samples > 0, "{case:?}");
        assert_eq!(result.measured.fast.is_some(), case.fast_bound.is_some(), "{case:?}");
        causes.extend(result.plain_failure());
        declined += usize::from(result.measured.declined > 0);
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
    for (cause, least) in [Cause::Rounding, Cause::Definition].into_iter().zip(PLAIN_FAILS) {
        let count = causes.iter().filter(|&&found| found == cause).count();
        assert!(count >= least, "only {count} by {}", cause.name());
    }
    assert!(declined > 20, "fast leaves its range in {declined} cases only");
}

/// The reference is not the code itself: where results are rounded, the error shows it.
#[test]
fn errors_are_those_of_rounding_and_no_less() {
    let worst = |group: Group| {
        let of_group = MEASURED.iter().filter(|result| result.case.group == group && is_quick(result.case));
        of_group.map(|result| result.measured.faithful.error).fold(0.0, f64::max)
    };
    assert!((0.45..=0.501).contains(&worst(Group::Magnitude)), "half an ulp of f32");
    assert!((0.45..=0.501).contains(&worst(Group::Needle)));
    assert!(worst(Group::Unit) > 1e-17 && worst(Group::Angle) > 1e-17 && worst(Group::Attenuation) > 1e-17);
}

/// A case by its name, run: its errors, and why plain code fails.
fn run(group: Group, name: &str) -> (Measured, Option<Cause>) {
    let cases = cases_of(group);
    let case = cases.iter().find(|case| case.name == name).unwrap_or_else(|| panic!("no case {name}"));
    let result = case.run();
    (result.measured, result.plain_failure())
}

/// A formula that is wrong in exact arithmetic too fails by its definition, whatever the precision.
#[test]
fn failures_by_definition_are_separate_from_those_by_rounding() {
    let octahedral = |case: &StressCase| case.name.starts_with("oct ");
    let rows: Vec<StressCase> = cases_of(Group::Encoding).into_iter().filter(octahedral).collect();
    assert_eq!(rows.len(), 10);
    for row in rows {
        assert_eq!(row.run().plain_failure(), Some(Cause::Definition), "{row:?}: the sign of 0 is 0");
    }
    for (group, name) in [
        (Group::Fan, "quadric on two rings, f64"),
        (Group::Fan, "quadric on two rings, f32"),
        (Group::Fan, "quadric on two rings, 6 decimals"),
        (Group::Fan, "quadric on two rings, 4 decimals"),
        (Group::Fan, "opposite faces"),
        (Group::Highlight, "light from behind"),
        (Group::Highlight, "H at L = -V"),
        (Group::Needle, "sliver threshold"),
        (Group::Needle, "vertex next to a sliver"),
        (Group::Degenerate, "exactly collinear"),
        (Group::NonFinite, "infinity"),
        (Group::Raster, "behind the eye"),
        (Group::Raster, "a million pixels"),
        (Group::Crease, "prisms in f32"),
    ] {
        assert_eq!(run(group, name).1, Some(Cause::Definition), "{name}");
    }
    for (group, name) in [
        (Group::Magnitude, "faces at 1e30"),
        (Group::Needle, "height/length 1e-7"),
        (Group::Degenerate, "one spacing off a line"),
        (Group::Valence, "tilt 2e-3, 8 faces"),
        (Group::Angle, "exactly 0 and pi"),
        (Group::Unit, "largest f64"),
        (Group::Product, "Pharr's"),
        (Group::Highlight, "(N·H)^n, n = 100000"),
        (Group::Attenuation, "1/d^2 at d = 1e-20"),
    ] {
        let (measured, cause) = run(group, name);
        assert_eq!(cause, Some(Cause::Rounding), "{name}");
        assert!(measured.definition.error < 1e-3 && measured.definition.undefined() == 0, "{name}");
    }
}

/// v / √(v·v) of a large vector is v/∞ = 0, of a small one v/0 = ∞, of zero 0/0.
#[test]
fn undefined_results_are_counted_by_kind() {
    let kinds = |group, name| {
        let plain = run(group, name).0.plain.unwrap();
        assert_eq!(plain.undefined(), plain.nan + plain.infinite + plain.zero);
        [plain.nan, plain.infinite, plain.zero]
    };
    let [nan, infinite, zero] = kinds(Group::Unit, "squares beyond f32");
    assert!(nan == 0 && infinite == 0 && zero > 400, "{nan} {infinite} {zero}");
    let [nan, infinite, zero] = kinds(Group::Unit, "subnormal f32");
    assert!(infinite > 400 && zero == 0, "{nan} {infinite} {zero}");
    assert_eq!(kinds(Group::Unit, "subnormal f64"), [500, 0, 0]);
    assert_eq!(kinds(Group::Highlight, "H at L = -V"), [500, 0, 0]);
    assert_eq!(kinds(Group::Attenuation, "1/d^2 at d = 1e-30")[1], 200);
}

/// The tip of the cones of the catalogue, and the points of its rim.
fn cone(sides: usize, height: f32) -> (Vec3, Vec<Vec3>) {
    let tilt = (0.5 / f64::from(height)).min(0.2);
    let rim = |k: usize| {
        let turn = TAU * k as f64 / sides as f64;
        let radius = 1.0 + tilt * (libm::sin(turn + 0.5) + libm::sin(2.0 * turn));
        Vec3::new((radius * libm::cos(turn)) as f32, (radius * libm::sin(turn)) as f32, 0.0)
    };
    (Vec3::new(0.0, 0.0, height), (0..sides).map(rim).collect())
}

/// The largest error of the angle mean with plain `acos`, in degrees, and whether one is not a number.
fn error_with_acos(sides: &[usize], height: f32) -> (f64, bool) {
    let (mut worst, mut is_undefined) = (0.0_f64, false);
    for &sides in sides {
        let (tip, rim) = cone(sides, height);
        let (mut plain, mut truth) = (Vec3::ZERO, DVec3::ZERO);
        for (a, b) in rim.iter().zip(rim.iter().cycle().skip(1)) {
            let (e1, e2) = (a - tip, b - tip);
            let angle = libm::acosf((e1 / e1.dot(e1).sqrt()).dot(e2 / e2.dot(e2).sqrt()));
            let normal = e1.cross(e2);
            plain += normal / normal.dot(normal).sqrt() * angle;
            let [e1, e2] = [a, b].map(|point| point.as_dvec3() - tip.as_dvec3());
            let normal = e1.cross(e2);
            truth += normal.normalize() * libm::atan2(normal.length(), e1.dot(e2));
        }
        let plain = (plain / plain.dot(plain).sqrt()).as_dvec3();
        let degrees = libm::atan2(plain.cross(truth).length(), plain.dot(truth)).to_degrees();
        (worst, is_undefined) = (worst.max(degrees), is_undefined | degrees.is_nan());
    }
    (worst, is_undefined)
}

/// Rows of cone tips and large fans, recomputed by code of their own. Where acos returns NaN, other weights make the figure.
#[test]
fn cone_tips_and_large_fans_fail_as_plain_acos_does() {
    let rows = [
        (Group::Valence, "1000 faces", &[1000][..], 10.0),
        (Group::Fan, "cone tips of height 100", &[3, 8, 64], 100.0),
        (Group::Fan, "cone tips of height 10000", &[3, 8, 64], 1e4),
    ];
    for (group, name, sides, height) in rows {
        let (plain, (expected, is_undefined)) =
            (run(group, name).0.plain.unwrap(), error_with_acos(sides, height));
        assert_eq!(plain.nan > 0, is_undefined, "{name}");
        assert!(is_undefined || (plain.error / expected - 1.0).abs() < 1e-6, "{name}: {plain:?}, {expected}");
    }
}

/// The figures that were printed before this program was written.
#[test]
fn plain_code_fails_as_the_reference_says() {
    let plain = |group: Group, name: &str| run(group, name).0.plain.unwrap();
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
    // The shared results are from all threads of the machine; `the_program_gives_the_same_report_with_one_thread` has one.
    let threads = rayon::current_num_threads() + 1;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    let measured: &[StressResult<'_>] = &MEASURED;
    pool.install(|| {
        // Of equal numbers only 0 has two signs, and no error is −0.
        for StressResult { case, measured, .. } in measured.iter().filter(|result| is_quick(result.case)) {
            assert_eq!(case.run().measured, *measured, "{case:?}");
        }
    });
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
    // The columns of both causes.
    let heading = table.lines().rfind(|line| line.contains("f32: overflow or rounding")).unwrap();
    let column =
        |line: &str, text: &str| line.chars().count() - line.split_once(text).unwrap().1.chars().count();
    assert_eq!(column(row, "0.703") - 5, column(heading, "f32: overflow") - 13);
    let infinity = table.lines().find(|line| line.starts_with("  minus infinity")).unwrap();
    assert_eq!(column(infinity, "NaN x7") - 6, column(heading, "f32: definition") - 15);
    let summary = table.lines().last().unwrap();
    let expected = "6 cases: all expectations hold. Plain f32 code fails visibly (✗) in 3 by overflow or rounding, in 3 by definition.";
    assert!(summary.starts_with(expected), "{summary}");
    let verbose = stress(&["--only", "product", "-v"]);
    assert!(text(&verbose.stdout).contains("      bound: 2u, u = 2^-53: Jeannerod, Louvet & Muller"));
    assert!(text(&verbose.stdout).contains("      plain: a·b - c·d; in exact arithmetic: 0 rel\n"));
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
    let summary = &report["summary"];
    assert_eq!((&summary["plain_fails"], &summary["broken"]), (&fails.into(), &0.into()));
    for cause in ["rounding", "definition"] {
        let count = cases.iter().filter(|case| case["plain"]["cause"] == cause).count();
        assert_eq!(summary[format!("plain_fails_by_{cause}")], count, "{cause}");
    }
    for case in cases {
        let known = ["expectation", "faithful", "fast", "group", "holds", "name", "plain", "samples", "what"];
        assert!(keys(case).iter().all(|key| known.contains(key) || *key == "without_fast"), "{case}");
        assert_ne!(case.get("fast").is_some(), case.get("without_fast").is_some(), "{case}");
        let error = ["infinite", "nan", "undefined", "unit", "worst", "zero"];
        assert_eq!(keys(&case["plain"]["definition"]), error);
        let error_with = |more: &[&'static str]| {
            let mut keys = [&error[..], more].concat();
            keys.sort_unstable();
            keys
        };
        assert_eq!(keys(&case["faithful"]), error_with(&["bound"]));
        let cause: &[&str] = if case["plain"]["fails"] == true { &["cause"] } else { &[] };
        assert_eq!(keys(&case["plain"]), error_with(&[&["definition", "fails", "formula"], cause].concat()));
        assert_eq!(keys(&case["faithful"]["bound"]), ["most", "source"]);
        if case["group"] == "highlight" {
            assert_eq!(keys(&case["fast"]), error_with(&["bound", "declined"]));
        } else {
            assert!(case.get("fast").is_none(), "{case}");
        }
        assert!(
            case["faithful"]["worst"].as_f64().unwrap()
                <= case["faithful"]["bound"]["most"].as_f64().unwrap()
        );
    }
    let opposite = cases.iter().find(|case| case["name"] == "H at L = -V").unwrap();
    let plain = &opposite["plain"];
    assert_eq!(
        (&plain["undefined"], &plain["nan"], &plain["fails"]),
        (&500.into(), &500.into(), &true.into())
    );
    assert_eq!(plain["cause"], "definition");
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
