//! The report of `crease inspect` on one input file, and explanations of findings, as text.

use super::json::{Against, Counts, InspectReport};
use crate::cli::common::console::{Style, escaped};
use crate::cli::common::numbers::{count, count_of};
use crease::num::{Degrees, three_digits};
use crease::quality::catalogue::Kind;
use crease::quality::{Element, Finding, Fix, PartDiagnosis, Severity, Site};
use std::fmt::Write;

pub struct Layout {
    pub style: Style,
    /// Details of each finding, and every part.
    pub verbose: bool,
    /// Notes are counted, not listed.
    pub hides_notes: bool,
    /// No findings are selected by id, so that `--severity` shows those that are hidden.
    pub selects_by_severity: bool,
    pub places: usize,
}

impl Layout {
    /// The verdict in one line, with the ids of the findings: the report on a file of a batch.
    pub fn brief(&self, report: &InspectReport) -> String {
        let ids: Vec<&str> = self.shown(report).iter().map(|finding| finding.kind.id()).collect();
        let line = self.line(report);
        match &ids[..] {
            [] => line,
            ids => format!("{} · {}\n", line.trim_end(), ids.join(", ")),
        }
    }

    fn shown<'a>(&self, report: &'a InspectReport) -> Vec<&'a Finding> {
        let all = report.findings.iter().map(|report| &report.finding);
        all.filter(|finding| !(self.hides_notes && finding.severity == Severity::Note)).collect()
    }

    fn line(&self, report: &InspectReport) -> String {
        let (mut shown, mut hidden) = (report.counts, report.hidden);
        if self.hides_notes {
            hidden.note += std::mem::take(&mut shown.note);
        }
        let pronoun = if hidden.error + hidden.warning + hidden.note == 1 { "it" } else { "them" };
        let (shown, hidden) = (self.counted(shown), self.counted(hidden));
        let hint = match self.selects_by_severity {
            true => format!(" (--severity note shows {pronoun})"),
            false => String::new(),
        };
        let nothing = if self.selects_by_severity { "no errors or warnings" } else { "no selected findings" };
        let verdict = match (&*shown, &*hidden) {
            ("", "") => "No problems found.".into(),
            ("", hidden) => format!("{nothing}; {hidden} hidden{hint}"),
            (shown, "") => shown.into(),
            (shown, hidden) => format!("{shown}; {hidden} hidden{hint}"),
        };
        format!("{}: {verdict}\n", self.style.paint(Style::BOLD, &escaped(&report.input.path)))
    }

    fn counted(&self, counts: Counts) -> String {
        let severities = [
            (counts.error, Severity::Error),
            (counts.warning, Severity::Warning),
            (counts.note, Severity::Note),
        ];
        let counted = severities.into_iter().filter(|(number, _)| *number > 0);
        let counted = counted
            .map(|(number, severity)| self.style.paint(colour(severity), &count(number, severity.name())));
        counted.collect::<Vec<_>>().join(", ")
    }

    /// The verdict, every finding, the fix, and how the normals were made.
    pub fn block(&self, report: &InspectReport) -> String {
        let mut out = self.line(report);
        let shown = self.shown(report);
        for finding in &shown {
            out.push_str(&self.finding(finding, report));
        }
        out.push_str(&fix(&shown, report));
        let has_recipe =
            |it: &&PartDiagnosis| self.verbose || report.parts.len() == 1 && it.estimate.is_some();
        for part in report.parts.iter().filter(has_recipe) {
            let _ = writeln!(out, "  {}", recipe(part));
        }
        if let Some(against) = &report.against {
            out.push_str(&self.comparison(against, report));
        }
        let written: Vec<String> =
            report.written.iter().map(|(what, path)| format!("{what}: {}", escaped(path))).collect();
        if !written.is_empty() {
            let _ = writeln!(out, "  {}", written.join(" · "));
        }
        out
    }

    /// A finding in one line, and its details if they are wanted.
    fn finding(&self, finding: &Finding, report: &InspectReport) -> String {
        let entry = finding.kind.entry();
        let label = self.style.paint(colour(finding.severity), finding.severity.name());
        let counts_elements = entry.element != Element::Mesh || finding.of > 1;
        let is_somewhere = |site: &&Site| site.position.is_some() || entry.element == Element::Node;
        let mut sites = finding.places.iter().take(self.places).filter(is_somewhere);
        let id = self.style.paint(Style::BOLD, entry.id);
        if !self.verbose {
            let sites: Vec<String> = sites.map(|site| place(site, report)).collect();
            let sites =
                if sites.is_empty() { String::new() } else { format!("; at {}", sites.join("; at ")) };
            let number = if counts_elements { format!("{}: ", elements(finding)) } else { String::new() };
            return format!("  {label} {id}: {number}{}{sites}\n", finding.cause.english());
        }
        let mut lines = Vec::new();
        let percent = |share: f64| format!("{} %", three_digits(100.0 * share));
        if counts_elements {
            let area = finding.area_share.filter(|&share| share > 0.0);
            let area = area.map_or(String::new(), |share| format!(", {} of the area", percent(share)));
            lines.push(format!("{} ({}){area}", elements(finding), percent(finding.share())));
        }
        if let Some(steps) = finding.steps.filter(|&steps| steps > 0.0) {
            let steps = three_digits(steps);
            let angle =
                finding.degrees.map_or(String::new(), |degrees| format!("{}°: ", three_digits(degrees)));
            lines.push(format!("up to {angle}{steps} of 255 grey steps under a key light"));
        }
        if let Some((value, unit)) = finding.amount.zip(finding.kind.unit()) {
            let value = finding.kind.write_amount(value);
            if !finding.cause.english().contains(&value) {
                lines.push(format!("at worst {value} {}", unit.english()));
            }
        }
        lines.extend(finding.confidence.map(|confidence| format!("confidence {confidence:.2}")));
        lines.extend(sites.by_ref().map(|site| format!("at {}", place(site, report))));
        let lines: String = lines.iter().map(|line| format!("    {line}\n")).collect();
        format!("  {label} {id}: {}\n{lines}", finding.cause.english())
    }

    /// What is different in another file: one line, then the details.
    fn comparison(&self, against: &Against, report: &InspectReport) -> String {
        let Against { path, comparison } = against;
        let [mean_steps, largest_steps] = comparison.steps();
        let angle = |Degrees(degrees): Degrees, steps: f64| {
            format!("{}° ({} of 255 grey steps)", three_digits(degrees), three_digits(steps))
        };
        let summary = match comparison.changed {
            0 => format!("no normals changed ({})", count(comparison.corners, "corner")),
            changed => format!(
                "{changed} of {} corners changed, {} visibly, by at most {} and on average {}, under a key light",
                comparison.corners,
                comparison.visible,
                angle(comparison.largest, largest_steps),
                angle(Degrees(comparison.angles.mean), mean_steps)
            ),
        };
        let [here, there] = [&report.input.path, path].map(|path| format!("only in {}", escaped(path)));
        let counts = [
            (comparison.gained, ["corner has", "corners have"], &*format!("a normal {there}")),
            (comparison.lost, ["corner has", "corners have"], &*format!("a normal {here}")),
            (comparison.turned, ["face has", "faces have"], "reversed winding"),
            (comparison.unmatched[0], ["face is", "faces are"], &*here),
            (comparison.unmatched[1], ["face is", "faces are"], &*there),
        ];
        let counts = counts.into_iter().filter(|(number, ..)| *number > 0);
        let mut lines: Vec<String> = counts
            .map(|(number, [one, many], what)| format!("{} {what}", count_of(number, one, many)))
            .collect();
        if comparison.changed > 0 {
            let percentiles =
                comparison.percentiles().map(|(name, angle)| format!("{name} {}°", three_digits(angle)));
            lines.push(format!(
                "angle: rms {}°, {}",
                three_digits(comparison.angles.rms),
                percentiles.join(", ")
            ));
        }
        let places = comparison.places.iter().take(self.places);
        lines.extend(places.map(|site| format!("at {}", place(site, report))));
        let mut list = |name: &str, is_wanted: fn([u64; 2]) -> bool| {
            let findings = comparison.findings.iter().filter(|(_, counts)| is_wanted(*counts));
            let findings: Vec<String> =
                findings.map(|(kind, [before, after])| format!("{} {before} → {after}", kind.id())).collect();
            if !findings.is_empty() {
                lines.push(format!("{name}: {}", findings.join(", ")));
            }
        };
        list("gone", |[_, after]| after == 0);
        list("new", |[before, _]| before == 0);
        list("other counts", |[before, after]| before != after && before > 0 && after > 0);
        let lines: String = lines.iter().map(|line| format!("    {line}\n")).collect();
        format!("  against {}: {summary}\n{lines}", self.style.paint(Style::BOLD, &escaped(path)))
    }
}

fn colour(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => Style::RED,
        Severity::Warning => Style::YELLOW,
        Severity::Note => Style::BOLD,
    }
}

/// `38 of 1260 corners`.
fn elements(finding: &Finding) -> String {
    format!("{} of {} {}", finding.count, finding.of, plural(finding.kind.entry().element))
}

fn plural(element: Element) -> String {
    match element {
        Element::Vertex => "vertices".to_owned(),
        Element::Mesh => "meshes".to_owned(),
        element => format!("{}s", element.name()),
    }
}

/// The command that fixes findings of which one is shown, and which it fixes.
fn fix(shown: &[&Finding], report: &InspectReport) -> String {
    let ids = |is_fixed: bool, kinds: &[Kind]| {
        let ids = shown.iter().map(|finding| finding.kind).filter(|kind| kinds.contains(kind) == is_fixed);
        ids.map(Kind::id).collect::<Vec<_>>().join(", ")
    };
    let Some(Fix { command, kinds }) = &report.fix else { return String::new() };
    match (ids(true, kinds), ids(false, kinds)) {
        (fixed, _) if fixed.is_empty() => String::new(),
        (fixed, others) => {
            let others = if others.is_empty() { others } else { format!("; not fixed: {others}") };
            format!("  fix: {}\n    fixed: {fixed}{others}\n", escaped(command))
        }
    }
}

/// The size of a part, the recipe that reproduces its normals best, and their precision.
fn recipe(part: &PartDiagnosis) -> String {
    let name = if part.name.is_empty() { String::new() } else { format!("{}: ", escaped(&part.name)) };
    let recipe = match &part.estimate {
        Some(estimate) => format!("; {}", estimate.in_words().english()),
        None => String::new(),
    };
    let rounded = part.precision.as_ref().map_or(String::new(), |precision| {
        format!("; rounded to {}: by at most {}°", precision.grid.english(), three_digits(precision.error.0))
    });
    let (faces, vertices) = (count(part.faces, "face"), count_of(part.vertices, "vertex", "vertices"));
    format!("{name}{faces}, {vertices}{recipe}{rounded}")
}

fn place(site: &Site, report: &InspectReport) -> String {
    let mut said = Vec::new();
    match (&site.node, report.parts.get(site.part)) {
        (Some(node), _) if !node.is_empty() => said.push(format!("node {}", escaped(node))),
        (_, Some(part)) if report.parts.len() > 1 => {
            said.push(format!("submesh {} {}", site.part, escaped(&part.name)).trim_end().to_owned());
        }
        _ => {}
    }
    said.extend(site.line.map(|line| format!("line {line}")));
    said.extend(site.face.map(|face| format!("face {face}")));
    said.extend(site.corner.map(|corner| format!("corner {corner}")));
    said.extend(site.vertex.map(|vertex| format!("vertex {vertex}")));
    if let Some(position) = site.position {
        let [x, y, z] = position.to_array().map(three_digits);
        said.push(format!("({x}, {y}, {z})"));
    }
    let degrees = site.degrees.filter(|&degrees| degrees > 0.0);
    said.extend(degrees.map(|degrees| format!("{}°", three_digits(degrees))));
    said.join(", ")
}
