//! Before and after: what `--against` tells.

use super::super::console::{Style, escaped};
use super::report::SiteReport;
use crease::num::three_digits;
use crease::quality::Comparison;
use crease::quality::catalogue::Kind;
use serde::Serialize;
use std::fmt::Write;

/// What is different in another file.
#[derive(Debug, Serialize)]
pub struct AgainstReport {
    pub path: String,
    pub faces: [usize; 2],
    pub unmatched: [usize; 2],
    pub turned: usize,
    pub corners: usize,
    pub gained: usize,
    pub lost: usize,
    pub changed: usize,
    pub visible: usize,
    pub mean: ChangeReport,
    pub largest: ChangeReport,
    pub places: Vec<SiteReport>,
    pub findings: Vec<FindingChange>,
}

/// An angle, and what it does under a key light.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct ChangeReport {
    pub degrees: f64,
    pub steps: f64,
}

#[derive(Debug, Serialize)]
pub struct FindingChange {
    pub id: &'static str,
    pub before: u64,
    pub after: u64,
}

impl AgainstReport {
    pub fn new(path: &str, comparison: &Comparison) -> Self {
        let [mean, largest] = comparison.steps();
        let change = |degrees: f64, steps: f64| ChangeReport { degrees, steps };
        let finding =
            |&(kind, [before, after]): &(Kind, [u64; 2])| FindingChange { id: kind.id(), before, after };
        Self {
            path: path.to_owned(),
            faces: comparison.faces,
            unmatched: comparison.unmatched,
            turned: comparison.turned,
            corners: comparison.corners,
            gained: comparison.gained,
            lost: comparison.lost,
            changed: comparison.changed,
            visible: comparison.visible,
            mean: change(comparison.mean.0, mean),
            largest: change(comparison.largest.0, largest),
            places: comparison.places.iter().map(SiteReport::new).collect(),
            findings: comparison.findings.iter().map(finding).collect(),
        }
    }

    /// The change in words: one line, then what it is made of.
    pub fn text(&self, style: Style, places: usize, place: impl Fn(&SiteReport) -> String) -> String {
        let mut out = format!("  against {}: ", style.paint(Style::BOLD, &escaped(&self.path)));
        let angle = |change: ChangeReport| {
            format!("{}° ({} of 255 grey steps)", three_digits(change.degrees), three_digits(change.steps))
        };
        let _ = match self.changed {
            0 => writeln!(out, "no direction of {} corners changed", self.corners),
            changed => writeln!(
                out,
                "{changed} of {} corners changed, {} visibly, by {} at most and {} in the mean, under a key light",
                self.corners,
                self.visible,
                angle(self.largest),
                angle(self.mean)
            ),
        };
        for (count, what) in [
            (self.gained, "corners have a normal there that have none here"),
            (self.lost, "corners have none there that have one here"),
            (self.turned, "faces go round the other way"),
            (self.unmatched[0], "faces stand here only"),
            (self.unmatched[1], "faces stand there only"),
        ] {
            if count > 0 {
                let _ = writeln!(out, "    {count} {what}");
            }
        }
        for site in self.places.iter().take(places) {
            let _ = writeln!(out, "    at {}", place(site));
        }
        let list = |name: &str, wanted: fn(&FindingChange) -> bool| {
            let reported = self.findings.iter().filter(|it| wanted(it));
            let reported: Vec<String> =
                reported.map(|it| format!("{} {} → {}", it.id, it.before, it.after)).collect();
            if reported.is_empty() { String::new() } else { format!("    {name}: {}\n", reported.join(", ")) }
        };
        out.push_str(&list("gone", |it| it.after == 0));
        out.push_str(&list("new", |it| it.before == 0));
        out.push_str(&list("other counts", |it| it.before != it.after && it.before > 0 && it.after > 0));
        out
    }
}
