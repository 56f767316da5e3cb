//! The report of `crease inspect` on one input file, and explanations of findings, as text.

use super::json::{Against, Counts, FindingReport, InspectReport};
use crate::cli::common::console::{Style, escaped};
use crate::cli::common::numbers::{count, counts_above_zero};
use crease::num::{Degrees, three_digits};
use crease::quality::catalogue::{Entry, entries};
use crease::quality::{Element, Severity, Site};
use std::fmt::Write;

/// The verdict in one line.
pub fn line(report: &InspectReport, style: Style) -> String {
    let name = style.paint(Style::BOLD, &escaped(&report.input.path));
    let (reported, hidden) = (counted(report.counts, style), counted(report.hidden, style));
    let reported = match (reported.is_empty(), hidden.is_empty()) {
        (true, true) => "nothing found".into(),
        (true, false) => format!("nothing of what was asked for; not told: {hidden}"),
        (false, true) => reported,
        (false, false) => format!("{reported}; not told: {hidden}"),
    };
    format!("{name}: {reported}\n")
}

fn counted(counts: Counts, style: Style) -> String {
    let severities =
        [(counts.error, Severity::Error), (counts.warning, Severity::Warning), (counts.note, Severity::Note)];
    let reported = severities.into_iter().filter(|(number, _)| *number > 0);
    let reported =
        reported.map(|(number, severity)| style.paint(colour(severity), &count(number, severity.name())));
    reported.collect::<Vec<_>>().join(", ")
}

fn colour(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => Style::RED,
        Severity::Warning => Style::YELLOW,
        Severity::Note => Style::BOLD,
    }
}

/// The verdict, how the normals were made, and every finding.
pub fn block(report: &InspectReport, style: Style, verbose: bool, places: usize) -> String {
    let mut out = line(report, style);
    let is_shown = |has_estimate| verbose || report.parts.len() == 1 && has_estimate;
    for part in report.parts.iter().filter(|part| is_shown(part.estimate.is_some())) {
        let name = if part.name.is_empty() { String::new() } else { format!("{}: ", escaped(&part.name)) };
        let made = match &part.estimate {
            Some(estimate) if estimate.reproduced < 0.5 => "; no rule reproduces the stored normals".into(),
            Some(estimate) => format!(
                "; stored normals{} are best reproduced by --weight {} --crease {}{}: {} % of corners within 5°",
                if estimate.turned { ", turned back," } else { "" },
                estimate.weight.name(),
                estimate.crease.0,
                if estimate.groups { " and smoothing groups" } else { "" },
                three_digits(100.0 * estimate.reproduced)
            ),
            None => String::new(),
        };
        let rounded = part.precision.as_ref().map_or(String::new(), |precision| {
            format!("; rounded to {}: by at most {}°", precision.grid, three_digits(precision.error.0))
        });
        let _ = writeln!(out, "  {name}{} faces, {} vertices{made}{rounded}", part.faces, part.vertices);
    }
    report.findings.iter().for_each(|finding| out.push_str(&paragraph(finding, report, style, places)));
    if let Some(against) = &report.against {
        out.push_str(&comparison(against, report, style, places));
    }
    out
}

fn paragraph(item: &FindingReport, report: &InspectReport, style: Style, places: usize) -> String {
    let FindingReport { finding, command } = item;
    let entry = finding.kind.entry();
    let label = style.paint(colour(finding.severity), finding.severity.name());
    let mut lines = Vec::new();
    if entry.element != Element::Mesh || finding.of > 1 {
        let plural = match entry.element {
            Element::Vertex => "vertices".to_owned(),
            Element::Mesh => "meshes".to_owned(),
            element => format!("{}s", element.name()),
        };
        let percent = |share: f64| format!("{} %", three_digits(100.0 * share));
        let area = finding.area_share.filter(|&share| share > 0.0);
        let area = area.map_or(String::new(), |share| format!(", {} of the area", percent(share)));
        let share = percent(finding.share());
        lines.push(format!("{} of {} {plural} ({share}){area}", finding.count, finding.of));
    }
    if let Some(steps) = finding.steps.filter(|&steps| steps > 0.0) {
        let steps = three_digits(steps);
        let angle = finding.degrees.map_or(String::new(), |degrees| format!("{}°: ", three_digits(degrees)));
        lines.push(format!("up to {angle}{steps} of 255 grey steps under a key light"));
    }
    if let Some((value, unit)) = finding.amount.zip(finding.kind.unit()) {
        let value = finding.kind.write_amount(value);
        if !finding.cause.contains(&value) {
            lines.push(format!("at worst {value} {unit}"));
        }
    }
    lines.extend(finding.confidence.map(|confidence| format!("confidence {confidence:.2}")));
    let is_somewhere = |site: &&Site| site.position.is_some() || entry.element == Element::Node;
    let sites = finding.places.iter().take(places).filter(is_somewhere);
    lines.extend(sites.map(|site| format!("at {}", place(site, report))));
    lines.extend(command.iter().map(|command| format!("mend: {}", escaped(command))));
    let lines: String = lines.iter().map(|line| format!("    {line}\n")).collect();
    format!("  {label} {}: {}\n{lines}", style.paint(Style::BOLD, entry.id), finding.cause)
}

fn place(site: &Site, report: &InspectReport) -> String {
    let mut said = Vec::new();
    match (&site.node, report.parts.get(site.part)) {
        (Some(node), _) if !node.is_empty() => said.push(format!("node {}", escaped(node))),
        (_, Some(part)) if report.parts.len() > 1 => {
            said.push(format!("part {} {}", site.part, escaped(&part.name)).trim_end().to_owned());
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

/// What is different in another file: one line, then the details.
fn comparison(against: &Against, report: &InspectReport, style: Style, places: usize) -> String {
    let Against { path, comparison } = against;
    let [mean_steps, largest_steps] = comparison.steps();
    let angle = |Degrees(degrees): Degrees, steps: f64| {
        format!("{}° ({} of 255 grey steps)", three_digits(degrees), three_digits(steps))
    };
    let summary = match comparison.changed {
        0 => format!("no direction of {} corners changed", comparison.corners),
        changed => format!(
            "{changed} of {} corners changed, {} visibly, by {} at most and {} in the mean, under a key light",
            comparison.corners,
            comparison.visible,
            angle(comparison.largest, largest_steps),
            angle(comparison.mean, mean_steps)
        ),
    };
    let mut lines = counts_above_zero(&[
        (comparison.gained, "corners have a normal there that have none here"),
        (comparison.lost, "corners have none there that have one here"),
        (comparison.turned, "faces go round the other way"),
        (comparison.unmatched[0], "faces stand here only"),
        (comparison.unmatched[1], "faces stand there only"),
    ]);
    lines.extend(comparison.places.iter().take(places).map(|site| format!("at {}", place(site, report))));
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
    format!("  against {}: {summary}\n{lines}", style.paint(Style::BOLD, &escaped(path)))
}

/// What the catalogue says of one finding.
pub fn explanation(entry: &Entry, style: Style) -> String {
    let mend = match entry.remedy {
        Some(options) => {
            let command = format!("crease normals INPUT -o OUTPUT {options}");
            format!(
                "{}, and what a file needs besides; inspect tells no command where it may be meant",
                command.trim_end()
            )
        }
        None => "no command does; see above".to_owned(),
    };
    format!(
        "{} ({} at most; {}; counts {})\n  {}.\n  {}\n  What to do: {}\n  Mended by: {mend}\n",
        style.paint(Style::BOLD, entry.id),
        entry.severity.name(),
        entry.family.name(),
        entry.element.name(),
        capital(&entry.title()),
        entry.meaning(),
        entry.advice()
    )
}

/// What the catalogue says of all of them.
pub fn catalogue(style: Style) -> String {
    entries().map(|entry| explanation(entry, style)).collect::<Vec<_>>().join("\n")
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
