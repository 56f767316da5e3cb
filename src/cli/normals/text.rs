//! The report on one input file, as text.

use super::json::{Part, Report};
use crate::cli::common::choice::Choose;
use crate::cli::common::console::{Console, Style, Verbosity, escaped};
use crate::cli::common::numbers::{count, count_of, counts_above_zero, face_kinds, row, seconds, size};
use crate::cli::common::report::MeshOutput;
use crease::io::Emit;
use crease::mesh::Orientation;
use crease::normals::{
    Choice, CreaseChains, EdgeCounts, FitFailures, JetFallbacks, NearCancellation, Weight, When, crease_slack,
};
use crease::num::{Degrees, three_digits};
use crease::pipeline::{Counts, FaultPlace, PartOutcome, Spot};
use std::fmt::Write;
use std::ops::Add;

/// How many places of faults, and of broken normals, are printed when details are asked for.
const PLACES: usize = 10;

pub fn line(report: &Report, style: Style) -> String {
    let mut line = title(report, style);
    let _ = write!(line, ": {}", count(sum(&report.parts, |part| part.faces), "face"));
    if report.recipe.emit != Emit::Face {
        let _ = write!(line, ", {}", splits(&report.parts));
    }
    if let Some(faults) = faults(&report.parts) {
        let _ = write!(line, "; {faults}");
    }
    if report.output.as_ref().is_some_and(|output| output.unchanged) {
        line.push_str("; unchanged");
    }
    line.push('\n');
    line
}

pub fn block(report: &Report, console: &Console) -> String {
    let verbose = console.verbosity == Verbosity::Verbose;
    let parts = &report.parts[..];
    let mut out = title(report, console.report_style);
    out.push('\n');
    let bytes = report.input.bytes.map(|bytes| format!(", {}", size(bytes))).unwrap_or_default();
    let format = report.input.format.map_or("?", |format| format.extension());
    row(&mut out, "read", &format!("{format}{bytes}, {}", mesh(parts)));
    if verbose && parts.len() > 1 {
        for part in parts {
            let mesh = mesh(std::slice::from_ref(part));
            row(&mut out, "submesh", &format!("{}: {mesh}", escaped(&part.outcome.name)));
        }
    }
    if sum(parts, |part| part.faces) > 0 {
        // Edges do not matter to the normals of faces. They are not counted where no edge can be sharp.
        let counted = parts.iter().any(|part| part.outcome.edges != EdgeCounts::default());
        if counted && report.recipe.emit != Emit::Face {
            row(&mut out, "edges", &edges(parts, report.recipe.emit == Emit::Vertex));
        }
        row(&mut out, "normals", &normals(report));
        row(&mut out, "faults", &faults(parts).unwrap_or_else(|| "none".into()));
    }
    for text in places(parts, if verbose { PLACES } else { 1 }) {
        row(&mut out, "at", &text);
    }
    for (label, text) in remarks(report) {
        row(&mut out, label, &text);
    }
    if let Some(output) = &report.output {
        row(&mut out, "output", &written(output, report.dry_run));
    }
    let times = &report.seconds;
    let stages = [("read", times.read), ("compute", times.compute), ("write", times.write)];
    row(&mut out, "time", &seconds(times.total, &stages));
    out
}

fn title(report: &Report, style: Style) -> String {
    style.title(&report.input.path, report.output.as_ref().and_then(|output| output.path.as_deref()))
}

fn sum(parts: &[Part], of: impl Fn(&PartOutcome) -> usize) -> usize {
    parts.iter().map(|part| of(&part.outcome)).sum()
}

fn splits(parts: &[Part]) -> String {
    count(sum(parts, |part| part.splits), "split")
}

fn mesh(parts: &[Part]) -> String {
    let kinds = face_kinds([
        sum(parts, |part| part.triangles),
        sum(parts, |part| part.quads),
        sum(parts, |part| part.polygons),
    ]);
    let number = if parts.len() == 1 {
        String::new()
    } else {
        format!("{}, ", count_of(parts.len(), "submesh", "submeshes"))
    };
    let vertices = count_of(sum(parts, |part| part.vertices), "vertex", "vertices");
    let faces = count(sum(parts, |part| part.faces), "face");
    let kinds = if kinds.is_empty() { kinds } else { format!(" ({kinds})") };
    format!("{number}{vertices}, {faces}{kinds}")
}

/// The kinds of edges. Ignored sharp edges count as smooth.
fn edges(parts: &[Part], ignores_sharp: bool) -> String {
    let of = |kind: fn(&EdgeCounts) -> usize| sum(parts, |part| kind(&part.edges));
    let (crease, marked) = (of(|edges| edges.crease), of(|edges| edges.marked));
    let (ignored, sharp) = if ignores_sharp { (crease + marked, 0) } else { (0, 1) };
    let smooth = of(|edges| edges.smooth) + ignored;
    let hard = [
        (crease * sharp, "over the angle"),
        (marked * sharp, "marked"),
        (of(|edges| edges.boundary), "boundary"),
        (of(|edges| edges.non_manifold), "non-manifold"),
        (of(|edges| edges.inconsistent), "wound inconsistently"),
        (of(|edges| edges.ambiguous), "ambiguous"),
    ];
    let all: usize = smooth + hard.iter().map(|kind| kind.0).sum::<usize>();
    let mut text = format!("{all}: {smooth} smooth");
    for kind in counts_above_zero(&hard) {
        let _ = write!(text, ", {kind}");
    }
    let welded = of(|edges| edges.welded);
    if welded > 0 {
        let _ = write!(text, "; {welded} joined by position");
    }
    text
}

fn crease_degrees(parts: &[Part]) -> Option<f64> {
    parts.iter().find_map(|part| part.outcome.crease_degrees)
}

fn normals(report: &Report) -> String {
    let (recipe, parts) = (report.recipe, &report.parts[..]);
    let rule = recipe.crease_rule.choice();
    let sharp = match (recipe.emit, crease_degrees(parts)) {
        (Emit::Face, _) => return format!("{}, one per face", sum(parts, |part| part.faces)),
        (Emit::Vertex, _) => "no sharp edges".to_owned(),
        (Emit::Corner, Some(180.0)) => format!("{rule} rule, crease off"),
        (Emit::Corner, Some(angle)) => format!("{rule} rule at {angle}°"),
        (Emit::Corner, None) => format!("{rule} rule by smoothing groups"),
    };
    let referenced = sum(parts, |part| part.referenced_vertices);
    format!(
        "{} weights, {sharp}: {} for {}, {}",
        recipe.weight.choice(),
        sum(parts, |part| part.entries),
        count_of(referenced, "vertex", "vertices"),
        splits(parts)
    )
}

/// Counts by reason over all parts, in words.
fn listed(parts: &[Part], of: fn(&PartOutcome) -> &Counts) -> Option<String> {
    let mut sums = Counts::new();
    for (name, count) in parts.iter().flat_map(|part| of(&part.outcome)) {
        *sums.entry(*name).or_default() += count;
    }
    let texts: Vec<String> = sums.iter().map(|(name, count)| format!("{count} {}", words(name))).collect();
    (!texts.is_empty()).then(|| texts.join(", "))
}

fn faults(parts: &[Part]) -> Option<String> {
    let kinds = [
        ("faces", listed(parts, |part| &part.faults.faces)),
        ("corners", listed(parts, |part| &part.faults.corners)),
        ("vertices", listed(parts, |part| &part.faults.vertices)),
    ];
    let kinds = kinds.into_iter().filter_map(|(what, listed)| Some(format!("{what}: {}", listed?)));
    Some(kinds.collect::<Vec<_>>().join("; ")).filter(|text| !text.is_empty())
}

/// A reason in words that follow a count.
fn words(reason: &str) -> &str {
    match reason {
        "ZeroArea" => "without area",
        "BelowStorage" => "with a height below the rounding of the file",
        "CancellingFan" => "where the faces cancel each other",
        "NonFinite" | "NotFinite" => "not finite",
        "OutOfRange" => "out of range",
        "Unreferenced" => "not used by a face",
        "Missing" => "missing",
        "Zero" => "of length zero",
        "Length" => "not of unit length",
        "AgainstFace" => "against their face",
        other => other,
    }
}

/// The first places of faults and of broken normals, with numbers as in the file, from 0.
fn places(parts: &[Part], most: usize) -> Vec<String> {
    let at = |number: usize, FaultPlace { spot, reason }: &FaultPlace, what: &str| {
        let part = if parts.len() > 1 { format!("submesh {number}, ") } else { String::new() };
        let element = match spot {
            Spot::Face(face) => format!("face {face}"),
            Spot::Corner { face, corner, vertex } => {
                format!("face {face}, corner {corner} (vertex {vertex})")
            }
            Spot::Vertex(vertex) => format!("vertex {vertex}"),
        };
        format!("{part}{element}: {what}{}", words(reason))
    };
    let first = |of: fn(&PartOutcome) -> &[FaultPlace], what: &'static str| {
        let places = parts
            .iter()
            .enumerate()
            .flat_map(move |(number, part)| of(&part.outcome).iter().map(move |place| (number, place)));
        places.take(most).map(|(number, place)| at(number, place, what)).collect::<Vec<_>>()
    };
    let faults = first(|part| &part.fault_places, "");
    [faults, first(|part| &part.broken_places, "stored normal ")].concat()
}

fn remarks(report: &Report) -> Vec<(&'static str, String)> {
    let parts = &report.parts[..];
    let of = |field: fn(&PartOutcome) -> usize| sum(parts, field);
    let mut rows = Vec::new();
    if report.recipe.when != When::Always && of(|part| part.faces) > 0 {
        let replaced = listed(parts, |part| &part.replaced_corners).unwrap_or_else(|| "none".into());
        rows.push((
            "replaced",
            format!("{replaced}; {} kept", count(of(|part| part.kept_corners), "corner")),
        ));
    }
    let near = of(|part| part.near_crease);
    if let Some(angle) = crease_degrees(parts)
        && near > 0
    {
        let near = count(near, "edge");
        let slack = crease_slack(Degrees(angle)).0;
        let text = format!(
            "{near} within 0.1° of the crease angle ({angle}°; up to {slack}° more counts as smooth)"
        );
        rows.push(("near", text));
    }
    let sums =
        parts.iter().map(|part| part.outcome.near_cancellation).fold(NearCancellation::default(), Add::add);
    if sums.normals > 0 {
        let degrees = three_digits(sums.bound.to_degrees());
        let normals = count(sums.normals, "normal");
        rows.push(("accuracy", format!("{normals} from faces that nearly cancel: error up to {degrees}°")));
    }
    let chains = parts.iter().map(|part| part.outcome.crease_chains).fold(CreaseChains::default(), Add::add);
    if report.recipe.emit == Emit::Corner && chains.are_scattered() {
        let text =
            "scattered: most chains of crease edges are shorter than 3 edges, as on a scan; try --crease off";
        rows.push(("creases", text.to_owned()));
    }
    let faces = counts_above_zero(&[
        (of(|part| part.reversed_faces), "reversed"),
        (of(|part| part.dropped_faces), "without area dropped"),
        (of(|part| part.non_finite_faces), "without finite positions dropped"),
        (of(|part| part.faces_before_groups), "before the first smoothing group (treated as off)"),
    ]);
    rows.extend(faces.into_iter().map(|text| ("faces", text)));
    rows.extend(orientation(parts).map(|text| ("orient", text)));
    let exceptions = [
        ("quadric", of(|part| part.quadric_fallbacks), "fit", "fell back to angle weights"),
        ("cone", of(|part| part.cone_declined), "fan", "too large for the cone rule, cut by the fan rule"),
        ("weld", of(|part| part.wide_clusters), "cluster", "of positions wider than twice the distance"),
    ];
    rows.extend(best(parts).into_iter().map(|text| ("best", text)));
    rows.extend(jet(parts).into_iter().map(|text| ("jet", text)));
    for (label, number, what, text) in exceptions.iter().filter(|row| row.1 > 0) {
        rows.push((label, format!("{} {text}", count(*number, what))));
    }
    let declined = of(|part| part.fast_declined.into());
    if declined > 0 {
        rows.push((
            "fast",
            format!("fast is not applicable to {}; faithful used", count(declined, "primitive")),
        ));
    }
    rows
}

/// Submeshes whose choice of `--weight best` is explained one by one, at most.
const EXPLAINED: usize = 4;

/// What `--weight best` chose: with its estimates, or for many submeshes the counts.
fn best(parts: &[Part]) -> Vec<String> {
    let found = || parts.iter().filter_map(|part| Some((part, part.outcome.best?)));
    match found().count() {
        0 | 1 => found().map(|(_, choice)| reason("", &choice)).collect(),
        2..=EXPLAINED => found()
            .map(|(part, choice)| reason(&format!(" for {}", escaped(&part.outcome.name)), &choice))
            .collect(),
        _ => {
            let weights = [Weight::Jet, Weight::Quadric, Weight::Angle];
            let submeshes = |weight| found().filter(|(_, choice)| choice.weight == weight).count();
            let chosen = weights.map(|weight| (submeshes(weight), weight.name()));
            let chosen = chosen.iter().filter(|it| it.0 > 0);
            let texts = chosen.map(|it| format!("{} for {}", it.1, count_of(it.0, "submesh", "submeshes")));
            vec![texts.collect::<Vec<_>>().join(", ")]
        }
    }
}

fn reason(of: &str, &Choice { weight, sampled, fitted, noise, jet, quadric, angle }: &Choice) -> String {
    let name = weight.name();
    if 2 * fitted < sampled || sampled == 0 {
        return format!("{name}{of}: surfaces can be fitted at {fitted} of {sampled} normals only");
    }
    let [noise, jet, quadric, angle] = [noise, jet, quadric, angle].map(three_digits);
    format!("{name}{of}: estimated rms errors jet {jet}°, quadric {quadric}°, angle {angle}°; noise {noise}°")
}

/// Where jets are of lower degree, by the reason.
fn jet(parts: &[Part]) -> Vec<String> {
    let all = || parts.iter().filter_map(|part| part.outcome.jet_fallbacks);
    let of = |failures: fn(JetFallbacks) -> FitFailures| {
        let failures = || all().map(failures);
        let reasons = counts_above_zero(&[
            (failures().map(|it| it.folded).sum(), "at folds of more than 90°"),
            (failures().map(|it| it.few_neighbours).sum(), "with too few neighbours"),
            (failures().map(|it| it.ill_conditioned).sum(), "ill-conditioned"),
            (failures().map(|it| it.unconfirmed).sum(), "not confirmed by the neighbours"),
        ]);
        (failures().map(|it| it.total()).sum::<usize>(), reasons.join(", "))
    };
    let rows =
        [(of(|it| it.degree_3), "not of degree 3"), (of(|it| it.degree_2), "fell back to angle weights")];
    let rows = rows.into_iter().filter(|((number, _), _)| *number > 0);
    rows.map(|((number, reasons), text)| format!("{} {text}: {reasons}", count(number, "fit"))).collect()
}

/// What `--orient` found, if it was asked for.
fn orientation(parts: &[Part]) -> Option<String> {
    let found = || parts.iter().filter_map(|part| part.outcome.orientation.as_ref());
    found().next()?;
    let of = |count: fn(&Orientation) -> usize| found().map(count).sum();
    let kinds = counts_above_zero(&[
        (of(|it| it.closed), "closed"),
        (of(|it| it.open_told), "open, outer side determined"),
        (of(|it| it.open_left), "open, unchanged"),
        (of(|it| it.non_orientable), "not orientable, unchanged"),
        (of(|it| it.flat), "flat, unchanged"),
        (of(|it| it.undecided), "undecided, unchanged"),
        (of(|it| it.cavities), "cavities"),
        (of(|it| it.rooms), "rooms, unchanged"),
        (of(|it| it.open_inside_out), "open, reversed"),
    ]);
    let confidence = found().filter(|it| it.open_told > 0).map(|it| it.confidence).min_by(f64::total_cmp);
    let confidence = confidence.map_or(String::new(), |it| format!(" (confidence {it:.2} or more)"));
    let kinds = if kinds.is_empty() { "no component".into() } else { kinds.join(", ") };
    Some(kinds + &confidence)
}

fn written(output: &MeshOutput, dry_run: bool) -> String {
    let vertices = count_of(output.vertices as usize, "vertex", "vertices");
    let change = match output.merged_vertices {
        0 => format!("{} added", output.added_vertices),
        merged => format!("{merged} merged"),
    };
    let mut text = format!("{}, {}, {vertices} ({change})", output.format, size(output.bytes));
    if let Some(moved) = &output.moved {
        let vertices = count_of(moved.vertices, "vertex", "vertices");
        let _ = write!(text, ", {vertices} moved by at most {:.3e}", moved.longest);
    }
    if !output.conversion.is_empty() {
        let _ = write!(text, ", {}", output.conversion);
    }
    if !output.companions.is_empty() {
        let names: Vec<String> = output.companions.iter().map(|name| escaped(name)).collect();
        let _ = write!(text, ", with {}", names.join(", "));
    }
    if output.unchanged {
        text.push_str(", the same bytes as the input");
    }
    if dry_run {
        text.push_str(", not stored (dry run)");
    }
    text
}
