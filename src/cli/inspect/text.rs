//! What `crease inspect` tells people.

use super::super::console::{Style, escaped};
use super::report::{Counts, FindingReport, InspectReport, PrecisionReport, SiteReport};
use crease::num::three_digits;
use crease::quality::Severity;
use crease::quality::catalogue::{Entry, entries};
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
    let mut reported = Vec::new();
    for (count, name, colour) in [
        (counts.error, "error", Style::RED),
        (counts.warning, "warning", Style::YELLOW),
        (counts.note, "note", Style::BOLD),
    ] {
        if count > 0 {
            reported
                .push(style.paint(colour, &format!("{count} {name}{}", if count == 1 { "" } else { "s" })));
        }
    }
    reported.join(", ")
}

/// The verdict, how the normals were made, and every finding.
pub fn block(report: &InspectReport, style: Style, verbose: bool, places: usize) -> String {
    let mut out = line(report, style);
    for part in
        report.parts.iter().filter(|part| verbose || report.parts.len() == 1 && part.estimate.is_some())
    {
        let name = if part.name.is_empty() { String::new() } else { format!("{}: ", escaped(&part.name)) };
        let made = match &part.estimate {
            Some(estimate) if estimate.reproduced < 0.5 => "; no rule reproduces the stored normals".into(),
            Some(estimate) => format!(
                "; stored normals{} are best reproduced by --weight {} --crease {}{}: {} % of corners within 5°",
                if estimate.turned { ", turned back," } else { "" },
                estimate.weight,
                estimate.crease,
                if estimate.groups { " and smoothing groups" } else { "" },
                three_digits(100.0 * estimate.reproduced)
            ),
            None => String::new(),
        };
        let rounded = match &part.precision {
            Some(PrecisionReport { grid, degrees, .. }) => {
                format!("; rounded to {grid}: by at most {}°", three_digits(*degrees))
            }
            None => String::new(),
        };
        let _ = writeln!(out, "  {name}{} faces, {} vertices{made}{rounded}", part.faces, part.vertices);
    }
    report.findings.iter().for_each(|finding| out.push_str(&paragraph(finding, report, style, places)));
    if let Some(against) = &report.against {
        out.push_str(&against.text(style, places, |site| place(site, report)));
    }
    out
}

fn paragraph(finding: &FindingReport, report: &InspectReport, style: Style, places: usize) -> String {
    let colour = match finding.severity {
        Severity::Error => Style::RED,
        Severity::Warning => Style::YELLOW,
        Severity::Note => Style::BOLD,
    };
    let label = style.paint(colour, finding.severity.name());
    let mut out = format!("  {label} {}: {}\n", style.paint(Style::BOLD, finding.id), finding.cause);
    if finding.element != "mesh" || finding.of > 1 {
        let plural = match finding.element {
            "vertex" => "vertices".to_owned(),
            "mesh" => "meshes".to_owned(),
            name => format!("{name}s"),
        };
        let percent = |share: f64| format!("{} %", three_digits(100.0 * share));
        let area = match finding.area_share {
            Some(share) if share > 0.0 => format!(", {} of the area", percent(share)),
            _ => String::new(),
        };
        let _ = writeln!(
            out,
            "    {} of {} {plural} ({}){area}",
            finding.count,
            finding.of,
            percent(finding.share)
        );
    }
    if let Some(steps) = finding.steps.filter(|&steps| steps > 0.0) {
        let steps = three_digits(steps);
        let angle = finding.degrees.map_or(String::new(), |degrees| format!("{}°: ", three_digits(degrees)));
        let _ = writeln!(out, "    up to {angle}{steps} of 255 grey steps under a key light");
    }
    if let Some(measure) = finding.measure.as_ref().filter(|it| !finding.cause.contains(&it.reported)) {
        let _ = writeln!(out, "    at worst {} {}", measure.reported, measure.unit);
    }
    if let Some(confidence) = finding.confidence {
        let _ = writeln!(out, "    confidence {confidence:.2}");
    }
    let is_somewhere = |site: &&SiteReport| site.position.is_some() || finding.element == "node";
    for site in finding.places.iter().take(places).filter(is_somewhere) {
        let _ = writeln!(out, "    at {}", place(site, report));
    }
    if let Some(command) = &finding.command {
        let _ = writeln!(out, "    mend: {}", escaped(command));
    }
    out
}

fn place(site: &SiteReport, report: &InspectReport) -> String {
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
    if let Some([x, y, z]) = site.position {
        said.push(format!("({}, {}, {})", three_digits(x), three_digits(y), three_digits(z)));
    }
    said.extend(
        site.degrees.filter(|&degrees| degrees > 0.0).map(|degrees| format!("{}°", three_digits(degrees))),
    );
    said.join(", ")
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
