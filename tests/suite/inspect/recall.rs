//! Recall and precision of the diagnosis on planted faults, as the tables of the documentation have them.

use super::clean::{Clean, meshes};
use super::planted::{
    Planted, at_corners, averaged_crease, everywhere, faults, recall_and_precision, split_seam, turned,
};
use super::whole_meshes::{by_chance, turned_any_way, zigzag};
use super::{attributes, inspect};
use crate::random::Random;
use crease::num::three_digits;
use crease::quality::Severity;
use crease::quality::catalogue::{Family, Kind};
use glam::{DMat3, DVec3};
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::Path;

/// The meshes that are always available: the tables cover these.
const OWN: [&str; 5] = ["icosphere", "torus", "wave", "bowl", "gear"];

/// The result of planting a fault into a mesh.
struct Outcome {
    recall: f64,
    precision: f64,
    /// All other findings.
    others: Vec<(Kind, Severity)>,
}

fn outcome(planted: &Planted) -> Outcome {
    let diagnosis = planted.diagnosis();
    let (recall, precision) =
        diagnosis.get(planted.expected).map_or((0.0, 1.0), |finding| recall_and_precision(planted, finding));
    let others = diagnosis.findings.iter().filter(|it| it.kind != planted.expected);
    Outcome { recall, precision, others: others.map(|it| (it.kind, it.severity)).collect() }
}

/// A row of the table.
struct Row {
    what: &'static str,
    expected: Kind,
    meshes: Vec<&'static str>,
    worst: [f64; 2],
    others: BTreeSet<&'static str>,
}

/// How often which kind was planted and which was reported.
#[derive(Default)]
struct Confusion {
    planted: BTreeMap<Kind, usize>,
    reported: BTreeMap<(Kind, Kind), usize>,
}

#[test]
fn planted_faults_are_found_where_they_are_and_named() {
    let (mut rows, mut misses): (Vec<Row>, Vec<String>) = (Vec::new(), Vec::new());
    let mut confusion = Confusion::default();
    for clean in meshes() {
        let with_attributes = (clean.name == "torus").then(attributes::planted).into_iter().flatten();
        let all: Vec<Planted> = faults(&clean).into_iter().chain(with_attributes).collect();
        let of_clean = inspect(&clean.mesh, 1).findings;
        let has = |kind: Kind, severity: Severity| {
            of_clean.iter().any(|it| it.kind == kind && it.severity >= severity)
        };
        let outcomes: Vec<Outcome> = all.par_iter().map(outcome).collect();
        for (planted, Outcome { recall, precision, others }) in all.iter().zip(outcomes) {
            let graver = others.iter().filter(|(kind, it)| *it > Severity::Note && !has(*kind, *it));
            let graver: Vec<&'static str> = graver.map(|(kind, _)| kind.id()).collect();
            if recall < 0.99 || precision < 0.99 || !graver.is_empty() {
                misses.push(format!(
                    "{}, {}: {} with recall {recall:.3} and precision {precision:.3}, and {graver:?}",
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
                let others = BTreeSet::new();
                rows.push(Row { what, expected, meshes: Vec::new(), worst: [1.0; 2], others });
                rows.len() - 1
            });
            let row = &mut rows[at];
            row.meshes.push(clean.name);
            row.worst = [row.worst[0].min(recall), row.worst[1].min(precision)];
            row.others.extend(graver);
            *confusion.planted.entry(planted.expected).or_default() += 1;
            let is_new = |kind: &Kind| kind.entry().family != Family::Shading && !has(*kind, Severity::Note);
            let others = others.into_iter().map(|(kind, _)| kind).filter(is_new);
            for kind in others.chain((recall > 0.0).then_some(planted.expected)) {
                *confusion.reported.entry((planted.expected, kind)).or_default() += 1;
            }
        }
    }
    assert!(misses.is_empty(), "{} misses:\n{}", misses.len(), misses.join("\n"));
    hold(&[("planted.md", table(&rows)), ("confusion.md", confusion.table())]);
}

fn table(rows: &[Row]) -> String {
    let mut out = String::from(
        "| planted | named | recall | precision | other errors and warnings | on |\n|---|---|---:|---:|---|---|\n",
    );
    for row in rows {
        let others: Vec<&str> = row.others.iter().copied().collect();
        let others = if others.is_empty() { "none".to_owned() } else { others.join(", ") };
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

impl Confusion {
    /// Rows are what was planted, columns what was reported, both in the order of the catalogue; what was not planted but
    /// reported comes last.
    fn table(&self) -> String {
        let reported: BTreeSet<Kind> = self.reported.keys().map(|&(_, kind)| kind).collect();
        let unplanted = reported.into_iter().filter(|kind| !self.planted.contains_key(kind));
        let columns: Vec<Kind> = self.planted.keys().copied().chain(unplanted).collect();
        let mut out = String::from("| planted ↓, reported → | runs |");
        (1..=columns.len()).for_each(|number| _ = write!(out, " {number} |"));
        let _ = write!(out, "\n|---|---:|{}\n", "---:|".repeat(columns.len()));
        for (row, (&planted, &runs)) in self.planted.iter().enumerate() {
            let _ = write!(out, "| {} `{}` | {runs} |", row + 1, planted.id());
            for &kind in &columns {
                match self.reported.get(&(planted, kind)) {
                    Some(count) => _ = write!(out, " {count} |"),
                    None => out.push_str(" · |"),
                }
            }
            out.push('\n');
        }
        let last = columns.iter().enumerate().skip(self.planted.len());
        let last: Vec<String> = last.map(|(at, kind)| format!("{} `{}`", at + 1, kind.id())).collect();
        if !last.is_empty() {
            let _ = writeln!(out, "\nOnly reported, as notes: {}.", last.join(", "));
        }
        out
    }
}

/// Sizes of faults, as multiples of their threshold.
const SIZES: [f64; 7] = [0.25, 0.5, 0.75, 0.95, 1.05, 1.5, 2.0];

/// A fault with a size.
type Sized = (&'static str, Kind, fn(&Clean, f64) -> Option<Planted>);

/// Faults with a threshold, by multiples of it.
const SIZED: [Sized; 5] = [
    ("tilted corners, of 15°", Kind::Outlier, |clean, size| {
        Some(at_corners(clean, "", Kind::Outlier, |n| turned(n, 15.0 * size)))
    }),
    ("too long, of 0.674 %", Kind::NotUnit, |clean, size| {
        Some(at_corners(clean, "", Kind::NotUnit, |n| n * (1.0 + 0.00674 * size)))
    }),
    ("a little too long, of 0.1 %", Kind::LooseLength, |clean, size| {
        Some(at_corners(clean, "", Kind::LooseLength, |n| n * (1.0 + 0.001 * size)))
    }),
    ("all rotated, of 5°", Kind::Rotated, |clean, size| {
        let axis = DVec3::new(1.0, 2.0, 3.0).normalize();
        let rotation = DMat3::from_axis_angle(axis, (5.0 * size).to_radians());
        Some(everywhere(clean, "", Kind::Rotated, |n| rotation * n))
    }),
    ("split edges, of 2°", Kind::SplitSeam, |clean, size| split_seam(clean, 2.0 * size)),
];

/// Shares of all corners, in per cent, for faults that have no size.
const SHARES: [f64; 6] = [0.1, 1.0, 5.0, 10.0, 14.0, 30.0];

/// Bits of each component, from more than the threshold needs down to few.
const BITS: [u32; 7] = [16, 12, 11, 10, 9, 8, 6];

/// Recall on a round and an uneven mesh together: by size, or by share and by bits for faults that have no size.
#[test]
fn recall_by_the_size_of_faults() {
    let clean: Vec<Clean> =
        meshes().into_iter().filter(|clean| ["icosphere", "bowl"].contains(&clean.name)).collect();
    let mean = |planted: Vec<Planted>| {
        let recalls: Vec<f64> = planted.par_iter().map(|planted| outcome(planted).recall).collect();
        recalls.iter().sum::<f64>() / recalls.len() as f64
    };
    let mut sized = Curve::new("fault, of threshold", SIZES.map(|size| format!("{size}×")));
    for (what, expected, plant) in SIZED {
        let recalls =
            SIZES.map(|size| mean(clean.iter().filter_map(|clean| plant(clean, size)).collect::<Vec<_>>()));
        assert!(recalls[SIZES.len() - 1] >= 0.99, "{what}: {recalls:?}");
        sized.row(what, expected, recalls);
    }
    // On strips with one dihedral angle, which is the size.
    let averaged = SIZES.map(|size| mean(averaged_crease(&zigzag(40.0 + 10.0 * size)).into_iter().collect()));
    assert!(averaged[SIZES.len() - 1] >= 0.99, "{averaged:?}");
    sized.row("averaged edges, of 10° past 40°", Kind::AveragedCrease, averaged);

    let mut shares = Curve::new("share of corners", SHARES.map(|share| format!("{share} %")));
    let by_share = |kind: Kind, change: fn(DVec3, &mut Random) -> DVec3| {
        SHARES.map(|share| {
            mean(clean.iter().map(|it| by_chance(it, ("", kind, share / 100.0), change)).collect())
        })
    };
    shares.row("negated", Kind::Flipped, by_share(Kind::Flipped, |n, _| -n));
    let tilted = by_share(Kind::Outlier, |n, random| turned_any_way(n, 30.0, random));
    shares.row("tilted by 30° in any direction", Kind::Outlier, tilted);

    let mut bits = Curve::new("bits of a component", BITS.map(|bits| bits.to_string()));
    let rounded = BITS.map(|bits| {
        let steps = f64::from((1u32 << (bits - 1)) - 1);
        let round = |n: DVec3| (n * steps).round() / steps;
        mean(clean.iter().map(|it| everywhere(it, "", Kind::Quantised, round)).collect())
    });
    bits.row("rounded, of 0.05°", Kind::Quantised, rounded);
    hold(&[("recall.md", [sized, shares, bits].map(|curve| curve.out).join("\n"))]);
}

/// A table of recall by size, share or bits.
struct Curve {
    out: String,
}

impl Curve {
    fn new<const N: usize>(over: &str, columns: [String; N]) -> Self {
        let columns: String = columns.iter().map(|column| format!(" {column} |")).collect();
        Self { out: format!("| {over} | named |{columns}\n|---|---|{}\n", "---:|".repeat(N)) }
    }

    fn row<const N: usize>(&mut self, what: &str, named: Kind, recalls: [f64; N]) {
        let recalls: String = recalls.iter().map(|&recall| format!(" {} |", three_digits(recall))).collect();
        let _ = writeln!(self.out, "| {what} | `{}` |{recalls}", named.id());
    }
}

/// Asserts that the tables of the documentation match the measurement; `CREASE_BLESS=1` writes them.
fn hold(tables: &[(&str, String)]) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/quality/measured");
    if std::env::var_os("CREASE_BLESS").is_some_and(|value| value == "1") {
        tables.iter().for_each(|(name, measured)| std::fs::write(folder.join(name), measured).unwrap());
        panic!("the tables are written; check them, and run again without CREASE_BLESS");
    }
    for (name, measured) in tables {
        let reported = std::fs::read_to_string(folder.join(name)).unwrap_or_default();
        assert_eq!(reported, *measured, "{name} does not match the measurement; CREASE_BLESS=1 writes it");
    }
}
