//! How good the diagnosis is: what was planted against what was found, as the table and the curve of the documentation.

use super::clean::{Clean, meshes};
use super::planted::{Planted, at_corners, everywhere, faults, recall_and_precision, split_seam, turned};
use crease::num::three_digits;
use crease::quality::Severity;
use crease::quality::catalogue::Kind;
use glam::{DMat3, DVec3};
use std::fmt::Write;
use std::path::Path;

/// The meshes that are always there: the tables are of these.
const OWN: [&str; 5] = ["icosphere", "torus", "wave", "bowl", "gear"];

/// What came of a fault on a mesh.
struct Outcome {
    recall: f64,
    precision: f64,
    /// Errors and warnings that are not what was planted.
    others: Vec<&'static str>,
}

fn outcome(planted: &Planted) -> Outcome {
    let diagnosis = planted.diagnosis();
    let (recall, precision) =
        diagnosis.get(planted.expected).map_or((0.0, 1.0), |finding| recall_and_precision(planted, finding));
    let others =
        diagnosis.findings.iter().filter(|it| it.severity > Severity::Note && it.kind != planted.expected);
    Outcome { recall, precision, others: others.map(|it| it.kind.id()).collect() }
}

/// A row of the confusion table.
struct Row {
    what: &'static str,
    expected: Kind,
    meshes: Vec<&'static str>,
    worst: [f64; 2],
    others: Vec<&'static str>,
}

#[test]
fn planted_faults_are_found_where_they_are_and_named() {
    let (mut rows, mut misses): (Vec<Row>, Vec<String>) = (Vec::new(), Vec::new());
    for clean in meshes() {
        for planted in faults(&clean) {
            let Outcome { recall, precision, others } = outcome(&planted);
            if recall < 0.99 || precision < 0.99 || !others.is_empty() {
                misses.push(format!(
                    "{}, {}: {} with recall {recall:.3} and precision {precision:.3}, beside {others:?}",
                    clean.name,
                    planted.what,
                    planted.expected.id()
                ));
            }
            if !OWN.contains(&clean.name) {
                continue;
            }
            let at = rows.iter().position(|row| row.what == planted.what && row.expected == planted.expected);
            let at = at.unwrap_or_else(|| {
                let (what, expected) = (planted.what, planted.expected);
                rows.push(Row { what, expected, meshes: Vec::new(), worst: [1.0; 2], others: Vec::new() });
                rows.len() - 1
            });
            let row = &mut rows[at];
            row.meshes.push(clean.name);
            row.worst = [row.worst[0].min(recall), row.worst[1].min(precision)];
            row.others.extend(others);
        }
    }
    assert!(misses.is_empty(), "{} misses:\n{}", misses.len(), misses.join("\n"));
    hold("planted.md", &table(&rows));
}

fn table(rows: &[Row]) -> String {
    let mut out = String::from(
        "| planted | named | recall | precision | other errors and warnings | on |\n|---|---|---:|---:|---|---|\n",
    );
    for row in rows {
        let others = if row.others.is_empty() { "none".to_owned() } else { row.others.join(", ") };
        let on = if row.meshes.len() == OWN.len() { "all".to_owned() } else { row.meshes.join(", ") };
        let [recall, precision] = row.worst.map(three_digits);
        let _ = writeln!(
            out,
            "| {} | `{}` | {recall} | {precision} | {others} | {on} |",
            row.what,
            row.expected.id()
        );
    }
    out
}

/// Sizes of faults, as multiples of their threshold.
const SIZES: [f64; 7] = [0.25, 0.5, 0.75, 0.95, 1.05, 1.5, 2.0];

/// A fault of a size that can be chosen.
type Sized = (&'static str, Kind, fn(&Clean, f64) -> Option<Planted>);

/// Faults with a threshold, by multiples of it.
const SIZED: [Sized; 5] = [
    ("tilted corners, of 15°", Kind::Stray, |clean, size| {
        Some(at_corners(clean, "", Kind::Stray, |n| turned(n, 15.0 * size)))
    }),
    ("too long, of 0.674 %", Kind::NotUnit, |clean, size| {
        Some(at_corners(clean, "", Kind::NotUnit, |n| n * (1.0 + 0.00674 * size)))
    }),
    ("a little too long, of 0.1 %", Kind::LooseLength, |clean, size| {
        Some(at_corners(clean, "", Kind::LooseLength, |n| n * (1.0 + 0.001 * size)))
    }),
    ("all turned, of 5°", Kind::Rotated, |clean, size| {
        let axis = DVec3::new(1.0, 2.0, 3.0).normalize();
        let rotation = DMat3::from_axis_angle(axis, (5.0 * size).to_radians());
        Some(everywhere(clean, "", Kind::Rotated, |n| rotation * n))
    }),
    ("split edges, of 2°", Kind::SplitSeam, |clean, size| split_seam(clean, 2.0 * size)),
];

/// Recall on all meshes of our own together, by size.
#[test]
fn recall_by_the_size_of_faults() {
    let clean: Vec<Clean> =
        meshes().into_iter().filter(|clean| ["icosphere", "bowl"].contains(&clean.name)).collect();
    let mut out = String::from("| fault, of threshold | named |");
    SIZES.iter().for_each(|size| _ = write!(out, " {size}× |"));
    let _ = write!(out, "\n|---|---|{}\n", "---:|".repeat(SIZES.len()));
    for (what, expected, plant) in SIZED {
        let _ = write!(out, "| {what} | `{}` |", expected.id());
        for size in SIZES {
            let planted: Vec<Planted> = clean.iter().filter_map(|clean| plant(clean, size)).collect();
            let recalls: Vec<f64> = planted.iter().map(|planted| outcome(planted).recall).collect();
            let recall = recalls.iter().sum::<f64>() / recalls.len() as f64;
            if size >= 2.0 {
                assert!(recall >= 0.99, "{what}: {recall}");
            }
            let _ = write!(out, " {} |", three_digits(recall));
        }
        out.push('\n');
    }
    hold("recall.md", &out);
}

/// Holds a table of the documentation to what was measured; `CREASE_BLESS=1` writes it again.
fn hold(name: &str, measured: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/quality/measured").join(name);
    if std::env::var_os("CREASE_BLESS").is_some_and(|value| value == "1") {
        std::fs::write(&path, measured).unwrap();
        panic!("{name} is written; look at it, and run again without CREASE_BLESS");
    }
    let told = std::fs::read_to_string(&path).unwrap_or_default();
    assert_eq!(told, measured, "{name} does not say what is measured; CREASE_BLESS=1 writes it again");
}
