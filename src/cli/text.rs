//! Reports for people.

use super::console::{Console, Style, Verbosity, escaped};
use super::report::{Edges, OutputReport, PartReport, Report, SpotReport};
use super::request::{Job, Request, Target};
use std::collections::BTreeMap;
use std::fmt::Write;

/// How many places of faults, and of broken normals, are printed when details are asked for.
const SPOTS: usize = 10;

/// One input of a batch in one line.
pub fn line(report: &Report, style: Style) -> String {
    let total = Total::of(&report.parts);
    let mut line = title(report, style);
    let _ = write!(line, ": {}", count(total.faces, "face"));
    if report.recipe.emit != "face" {
        let _ = write!(line, ", {}", count(total.splits, "split"));
    }
    if let Some(faults) = faults(&total) {
        let _ = write!(line, "; {faults}");
    }
    if report.output.as_ref().is_some_and(|output| output.unchanged) {
        line.push_str("; unchanged");
    }
    line.push('\n');
    line
}

/// One input in full.
pub fn block(report: &Report, job: &Job, request: &Request, console: &Console) -> String {
    let total = Total::of(&report.parts);
    let mut out = title(report, console.report_style());
    out.push('\n');
    let mut row = |name: &str, text: String| {
        let _ = writeln!(out, "  {name:<9}{text}");
    };
    let bytes = report.input.bytes.map(|bytes| format!(", {}", size(bytes))).unwrap_or_default();
    row("read", format!("{}{bytes}, {}", report.input.format.unwrap_or("?"), mesh(&total)));
    if console.verbosity == Verbosity::Verbose && report.parts.len() > 1 {
        for part in &report.parts {
            row("part", format!("{}: {}", escaped(&part.name), mesh(&Total::of(std::slice::from_ref(part)))));
        }
    }
    if total.faces > 0 {
        // The normals of faces know no edges.
        if report.recipe.emit != "face" {
            row("edges", edges(&total.edges, report.recipe.emit == "vertex"));
        }
        row("normals", normals(report, &total));
        row("faults", faults(&total).unwrap_or_else(|| "none".into()));
    }
    for text in spots(report, console.verbosity == Verbosity::Verbose) {
        row("at", text);
    }
    for (name, text) in remarks(report, &total) {
        row(name, text);
    }
    if let Some(output) = &report.output {
        row("output", written(output, job, request));
    }
    let seconds = &report.seconds;
    let stages =
        format!("read {:.3}, compute {:.3}, write {:.3}", seconds.read, seconds.compute, seconds.write);
    row("time", format!("{:.3} s ({stages})", seconds.total));
    out
}

fn title(report: &Report, style: Style) -> String {
    let mut title = style.paint(Style::BOLD, &escaped(&report.input.path));
    if let Some(path) = report.output.as_ref().and_then(|output| output.path.as_ref()) {
        let _ = write!(title, " -> {}", style.paint(Style::BOLD, &escaped(path)));
    }
    title
}

/// All parts of a file together.
#[derive(Default)]
struct Total {
    parts: usize,
    vertices: usize,
    faces: usize,
    arities: [usize; 3],
    entries: usize,
    referenced: usize,
    splits: usize,
    near_crease: usize,
    kept: usize,
    edges: Edges,
    faults: [BTreeMap<&'static str, usize>; 3],
    replaced: BTreeMap<&'static str, usize>,
    reversed: usize,
    dropped: usize,
    non_finite: usize,
    quadric_fallbacks: usize,
    cone_declined: usize,
    wide_clusters: usize,
    before_groups: usize,
    fast_declined: usize,
    orientation: Option<[usize; ORIENTATION.len()]>,
    /// The least confidence with which an open component was oriented.
    confidence: Option<f64>,
}

/// What is told of orientation, in the order of [`Total::orientation`].
const ORIENTATION: [&str; 9] = [
    "closed",
    "open, outer side told",
    "open, left",
    "not orientable, left",
    "flat, left",
    "undecided, left",
    "cavities",
    "as rooms, left",
    "open, turned",
];

impl Total {
    fn of(parts: &[PartReport]) -> Self {
        let mut total = Self { parts: parts.len(), ..Self::default() };
        for part in parts {
            total.add(part);
        }
        total
    }

    fn add(&mut self, part: &PartReport) {
        self.vertices += part.vertices;
        self.faces += part.faces;
        for (sum, count) in self.arities.iter_mut().zip([part.triangles, part.quads, part.polygons]) {
            *sum += count;
        }
        self.entries += part.entries;
        self.referenced += part.referenced_vertices;
        self.splits += part.splits;
        self.near_crease += part.near_crease;
        self.kept += part.kept_corners;
        self.edges.add(&part.edges);
        let faults = [&part.faults.faces, &part.faults.corners, &part.faults.vertices];
        for (sum, counts) in
            self.faults.iter_mut().zip(faults).chain([(&mut self.replaced, &part.replaced_corners)])
        {
            for (name, count) in counts {
                *sum.entry(name).or_default() += count;
            }
        }
        self.reversed += part.reversed_faces;
        self.dropped += part.dropped_faces;
        self.non_finite += part.non_finite_faces;
        self.quadric_fallbacks += part.quadric_fallbacks;
        self.cone_declined += part.cone_declined;
        self.wide_clusters += part.wide_clusters;
        self.before_groups += part.faces_before_groups;
        self.fast_declined += usize::from(part.fast_declined);
        if let Some(found) = &part.orientation {
            let counts = [
                found.closed,
                found.open_told,
                found.open_left,
                found.non_orientable,
                found.flat,
                found.undecided,
                found.cavities,
                found.rooms,
                found.open_inside_out,
            ];
            let sure = found.confidence.into_iter().chain(self.confidence);
            self.confidence = sure.min_by(f64::total_cmp);
            for (sum, count) in self.orientation.get_or_insert_default().iter_mut().zip(counts) {
                *sum += count;
            }
        }
    }
}

impl Edges {
    fn add(&mut self, other: &Edges) {
        self.smooth += other.smooth;
        self.boundary += other.boundary;
        self.non_manifold += other.non_manifold;
        self.inconsistent += other.inconsistent;
        self.ambiguous += other.ambiguous;
        self.marked += other.marked;
        self.crease += other.crease;
        self.welded += other.welded;
    }
}

fn mesh(total: &Total) -> String {
    let [triangles, quads, polygons] = total.arities;
    let kinds = [(triangles, "triangle"), (quads, "quad"), (polygons, "polygon")];
    let kinds: Vec<String> =
        kinds.iter().filter(|kind| kind.0 > 0).map(|&(n, what)| count(n, what)).collect();
    let parts = if total.parts == 1 { String::new() } else { format!("{}, ", count(total.parts, "part")) };
    let mut text =
        format!("{parts}{}, {}", count_of(total.vertices, "vertex", "vertices"), count(total.faces, "face"));
    if !kinds.is_empty() {
        let _ = write!(text, " ({})", kinds.join(", "));
    }
    text
}

/// The kinds of edges. Where sharp ones are ignored they are as good as smooth.
fn edges(edges: &Edges, ignores_sharp: bool) -> String {
    let (ignored, sharp) = if ignores_sharp { (edges.crease + edges.marked, 0) } else { (0, 1) };
    let smooth = edges.smooth + ignored;
    let hard = [
        (edges.crease * sharp, "over the angle"),
        (edges.marked * sharp, "marked"),
        (edges.boundary, "boundary"),
        (edges.non_manifold, "non-manifold"),
        (edges.inconsistent, "wound inconsistently"),
        (edges.ambiguous, "ambiguous"),
    ];
    let all: usize = smooth + hard.iter().map(|kind| kind.0).sum::<usize>();
    let mut text = format!("{all}: {smooth} smooth");
    for (number, what) in hard.iter().filter(|kind| kind.0 > 0) {
        let _ = write!(text, ", {number} {what}");
    }
    if edges.welded > 0 {
        let _ = write!(text, "; {} joined by position", edges.welded);
    }
    text
}

fn normals(report: &Report, total: &Total) -> String {
    let recipe = &report.recipe;
    let angle = report.parts.iter().find_map(|part| part.crease_degrees);
    if recipe.emit == "face" {
        return format!("{}, one a face", total.faces);
    }
    let sharp = match angle {
        Some(180.0) if recipe.emit != "vertex" => format!("{} rule, crease off", recipe.crease_rule),
        _ if recipe.emit == "vertex" => "no sharp edges".to_owned(),
        Some(angle) => format!("{} rule at {angle}°", recipe.crease_rule),
        None => format!("{} rule by smoothing groups", recipe.crease_rule),
    };
    format!(
        "{} weights, {sharp}: {} for {}, {}",
        recipe.weight,
        total.entries,
        count_of(total.referenced, "vertex", "vertices"),
        count(total.splits, "split")
    )
}

fn faults(total: &Total) -> Option<String> {
    let kinds =
        ["faces", "corners", "vertices"].iter().zip(&total.faults).filter(|(_, counts)| !counts.is_empty());
    let kinds: Vec<String> = kinds.map(|(what, counts)| format!("{what}: {}", listed(counts))).collect();
    (!kinds.is_empty()).then(|| kinds.join("; "))
}

fn listed(counts: &BTreeMap<&'static str, usize>) -> String {
    counts.iter().map(|(name, count)| format!("{count} {}", words(name))).collect::<Vec<_>>().join(", ")
}

/// A reason in words that follow a count.
fn words(reason: &str) -> &str {
    match reason {
        "ZeroArea" => "without area",
        "BelowStorage" => "lower than the rounding of the file",
        "CancellingFan" => "where the faces cancel each other",
        "NonFinite" | "NotFinite" => "not finite",
        "OutOfRange" => "beyond the range of numbers",
        "Unreferenced" => "that no face uses",
        "Missing" => "missing",
        "Zero" => "of length zero",
        "Length" => "not of unit length",
        "AgainstFace" => "against the own face",
        other => other,
    }
}

/// The first places of faults and of broken normals, numbers as in the file and from 0; without details, one of each.
fn spots(report: &Report, in_detail: bool) -> Vec<String> {
    let most = if in_detail { SPOTS } else { 1 };
    let of_kind = |kind: fn(&PartReport) -> &[SpotReport], what: &'static str| {
        let parts = report.parts.iter().enumerate();
        let all = parts.flat_map(move |(number, part)| kind(part).iter().map(move |spot| (number, spot)));
        let several = report.parts.len() > 1;
        all.take(most).map(move |(part, spot)| {
            let part = if several { format!("part {part}, ") } else { String::new() };
            format!("{part}{}: {what}{}", element(spot), words(spot.reason))
        })
    };
    let faults = of_kind(|part| &part.fault_places, "");
    faults.chain(of_kind(|part| &part.broken_places, "stored normal ")).collect()
}

fn element(spot: &SpotReport) -> String {
    match (spot.face, spot.corner, spot.vertex) {
        (Some(face), Some(corner), Some(vertex)) => format!("face {face}, corner {corner} (vertex {vertex})"),
        (Some(face), ..) => format!("face {face}"),
        (None, _, vertex) => format!("vertex {}", vertex.unwrap_or_default()),
    }
}

/// Everything that is not told of every file.
fn remarks(report: &Report, total: &Total) -> Vec<(&'static str, String)> {
    let mut rows = Vec::new();
    if report.recipe.when != "always" && total.faces > 0 {
        let replaced = if total.replaced.is_empty() { "none".into() } else { listed(&total.replaced) };
        rows.push(("replaced", format!("{replaced}; {} kept", count(total.kept, "corner"))));
    }
    if let Some(angle) = report.parts.iter().find_map(|part| part.crease_degrees)
        && total.near_crease > 0
    {
        rows.push((
            "near",
            format!(
                "{} within 0.1° of {angle}°, or as near as the digits tell",
                count(total.near_crease, "edge")
            ),
        ));
    }
    let faces = [
        (total.reversed, "turned round"),
        (total.dropped, "without area dropped"),
        (total.non_finite, "without finite positions dropped"),
        (total.before_groups, "before the first smoothing group count as off"),
    ];
    for (number, what) in faces.iter().filter(|row| row.0 > 0) {
        rows.push(("faces", format!("{number} {what}")));
    }
    if let Some(counts) = &total.orientation {
        let kinds = counts.iter().zip(ORIENTATION).filter(|(number, _)| **number > 0);
        let kinds: Vec<String> = kinds.map(|(number, what)| format!("{number} {what}")).collect();
        let sure = total.confidence.map_or(String::new(), |it| format!(" (confidence {it:.2} or more)"));
        let said = if kinds.is_empty() { "no component".into() } else { kinds.join(", ") };
        rows.push(("orient", said + &sure));
    }
    if total.quadric_fallbacks > 0 {
        rows.push((
            "quadric",
            format!("{} fell back to the angle mean", count(total.quadric_fallbacks, "fit")),
        ));
    }
    if total.cone_declined > 0 {
        let fans = count(total.cone_declined, "fan");
        rows.push(("cone", format!("{fans} too large for the cone rule, cut by the fan rule")));
    }
    if total.wide_clusters > 0 {
        let clusters = count(total.wide_clusters, "cluster");
        rows.push(("weld", format!("{clusters} of positions wider than twice the distance")));
    }
    if total.fast_declined > 0 {
        rows.push((
            "fast",
            format!("out of its range in {}: faithful instead", count(total.fast_declined, "part")),
        ));
    }
    rows
}

fn written(output: &OutputReport, job: &Job, request: &Request) -> String {
    let mut text = format!(
        "{}, {}, {} ({} added)",
        output.format,
        size(output.bytes),
        count_of(output.vertices as usize, "vertex", "vertices"),
        output.added_vertices
    );
    if !output.companions.is_empty() {
        let names: Vec<String> = output.companions.iter().map(|name| escaped(name)).collect();
        let _ = write!(text, ", with {}", names.join(", "));
    }
    if output.unchanged {
        text.push_str(", the same bytes as the input");
    }
    match job.target {
        _ if request.dry_run => text.push_str(", not stored (dry run)"),
        Some(Target::Stdout | Target::File(_)) | None => {}
    }
    text
}

/// A number with what it counts.
pub fn count(number: usize, what: &str) -> String {
    count_of(number, what, &format!("{what}s"))
}

/// The same where the plural is not regular.
pub fn count_of(number: usize, one: &str, many: &str) -> String {
    format!("{number} {}", if number == 1 { one } else { many })
}

/// Bytes in the unit that fits, powers of 1000.
pub fn size(bytes: u64) -> String {
    const UNITS: [(u64, &str); 3] = [(1_000_000_000, "GB"), (1_000_000, "MB"), (1_000, "kB")];
    match UNITS.iter().find(|(unit, _)| bytes >= *unit) {
        Some((unit, name)) => format!("{:.1} {name}", bytes as f64 / *unit as f64),
        None => format!("{bytes} B"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_well() {
        assert_eq!(count(1, "face"), "1 face");
        assert_eq!(count_of(0, "vertex", "vertices"), "0 vertices");
        assert_eq!(
            [size(0), size(999), size(1_000), size(1_949_999), size(2_500_000_000)],
            ["0 B", "999 B", "1.0 kB", "1.9 MB", "2.5 GB"]
        );
    }
}
