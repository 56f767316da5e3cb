//! The page.

use super::change::{self, After};
use super::heat::{HeatScale, Marks};
use super::pictures::{Model, worst_places};
use super::plots::histograms;
use super::sight::{self, Sight};
use crate::io::Loaded;
use crate::mesh::Obstacles;
use crate::num::{powers_of_ten, three_digits};
use crate::quality::catalogue::Kind;
use crate::quality::{Diagnosis, Finding, Severity, survey};
use crate::raster::Camera;
use crate::report::html::with_code;
use crate::report::{Page, Picture, ReportError, Table, escape_html};
use std::fmt::Write;

/// Pixels along the sides of overviews, and of close-ups.
const SIDES: [u32; 2] = [320, 240];

/// Findings that get close-ups of their own.
const CLOSE_UPS: usize = 12;

/// The diagnosis of a file as a page of HTML that opens from disk with nothing else: pictures from where the worst places
/// face, each finding with its explanation, its worst place close up and the command that mends it, and histograms.
/// `name` is what the file is called, `output` what mended it would be. With a file that came `after`, both are shown side
/// by side, and what changed.
///
/// # Errors
/// Pictures that cannot be drawn or made into files.
pub fn diagnosis_page(
    loaded: &Loaded,
    diagnosis: &Diagnosis,
    after: Option<After<'_>>,
    [name, output]: [&str; 2],
    sight: Sight,
) -> Result<String, ReportError> {
    let surveys = survey(loaded);
    // Colours mean the same before and after.
    let later = after.map(|after| survey(after.loaded)).unwrap_or_default();
    let model = Model::new(loaded, &surveys, HeatScale::of(surveys.iter().chain(&later)))?;
    let mut page = Page::new(&format!("Normals of {name}"), &verdict(diagnosis)).set_by(with_code);
    let camera = sight::camera(&model, diagnosis, after.map(|after| after.comparison), sight);
    overview(&mut page, &model, diagnosis, camera)?;
    if let (Some(after), Some(camera)) = (after, camera) {
        change::section(&mut page, &model, after, &later, camera, SIDES[0])?;
    }
    rules(&mut page, diagnosis);
    let obstacles = model.obstacles();
    let mut drawn = 0;
    for finding in &diagnosis.findings {
        let wanted = drawn < CLOSE_UPS;
        drawn +=
            usize::from(section(&mut page, (&model, &obstacles, camera), finding, (name, output), wanted)?);
    }
    page.heading("Distributions");
    for (name, caption, plot) in histograms(&surveys) {
        page.drawing(&format!("histogram of {name}"), caption, |id| plot.svg(id));
    }
    Ok(page.finish())
}

fn verdict(diagnosis: &Diagnosis) -> String {
    let counted = |severity: Severity| match diagnosis.count(severity) {
        1 => format!("1 {}", severity.name()),
        count => format!("{count} {}s", severity.name()),
    };
    let [notes, warnings, errors] = Severity::ALL.map(counted);
    let faces: usize = diagnosis.parts.iter().map(|part| part.faces).sum();
    format!("{errors}, {warnings}, {notes} in {faces} faces.")
}

fn overview(
    page: &mut Page,
    model: &Model,
    diagnosis: &Diagnosis,
    camera: Option<Camera>,
) -> Result<(), ReportError> {
    page.heading("Overview");
    let Some(camera) = camera else {
        page.paragraph("There are no faces to show.");
        return Ok(());
    };
    let (heat, marks) = model.deviation(camera, SIDES[0], &worst_places(diagnosis))?;
    let (facing, creases) = (model.facing(camera, SIDES[0])?, model.creases(camera, SIDES[0])?);
    let pictures: [(&Picture, &str); 3] = [
        (
            &heat,
            &format!("the mesh coloured by the deviation of its stored normals, {}", model.scale.words()),
        ),
        (&facing, "the mesh with front faces light blue and back faces dark red"),
        (&creases, "the mesh lit, with lines along creases and seams"),
    ];
    page.pictures(&pictures, &caption(marks, diagnosis))?;
    let mut links = String::from("<ul>\n");
    for finding in &diagnosis.findings {
        let (id, severity, cause) = (finding.kind.id(), finding.severity.name(), escape_html(&finding.cause));
        let _ = writeln!(links, "<li><a href=\"#{id}\">{severity}: {id}</a>: {cause}</li>");
    }
    links.push_str("</ul>\n");
    if !diagnosis.findings.is_empty() {
        page.raw(&links);
    }
    Ok(())
}

/// What there is to see in the pictures of the overview.
fn caption(marks: Marks, diagnosis: &Diagnosis) -> String {
    let of_edges = [Kind::AveragedCrease, Kind::SplitSeam, Kind::GroupMismatch];
    let reported = [
        (marks.dots, "; dots are on what is far off and too small to be seen"),
        (
            of_edges.iter().any(|&kind| diagnosis.get(kind).is_some()),
            "; where edges are smooth or split against it, which the findings tell of the edges, all corners at them are off",
        ),
        (marks.lines, "; grey lines are where that rule has two normals at an edge"),
        (marks.rings, "; red rings mark the worst place of each error and warning"),
        (marks.hidden, "; worst places that lie behind have no ring"),
    ];
    let reported: String =
        reported.into_iter().filter(|(is_there, _)| *is_there).map(|(_, words)| words).collect();
    format!(
        "Left: how far stored normals are from those that the rule of their mesh gives{reported}. Middle: front faces \
         light blue, back faces dark red. Right: lit, with orange lines where the normals of two sides differ."
    )
}

/// How the normals of each part were made.
fn rules(page: &mut Page, diagnosis: &Diagnosis) {
    let columns = ["part", "faces", "weight", "crease angle", "within 5°", "median"];
    let mut table = Table::new("How the stored normals were made, as far as they tell", &columns);
    for (number, part) in diagnosis.parts.iter().enumerate() {
        let Some(estimate) = part.estimate else { continue };
        let name = if part.name.is_empty() { format!("part {number}") } else { part.name.clone() };
        let fits = estimate.fits_most();
        let groups = if estimate.groups { " and smoothing groups" } else { "" };
        table.push([
            name,
            part.faces.to_string(),
            if fits { estimate.weight.name().to_owned() } else { "no rule".to_owned() },
            if fits { format!("{}°{}", estimate.crease.0, groups) } else { String::new() },
            format!(
                "{} %{}",
                three_digits(100.0 * estimate.reproduced),
                if estimate.turned { ", turned back" } else { "" }
            ),
            format!("{}°", powers_of_ten(&three_digits(estimate.median.0))),
        ]);
    }
    if !table.is_empty() {
        page.table(&table);
    }
}

/// One finding; tells whether it has a picture.
fn section(
    page: &mut Page,
    (model, obstacles, camera): (&Model, &[Obstacles<'_>], Option<Camera>),
    finding: &Finding,
    (name, output): (&str, &str),
    wanted: bool,
) -> Result<bool, ReportError> {
    let entry = finding.kind.entry();
    page.heading(entry.id);
    let mut said = format!("{}: {}. ", finding.severity.name(), finding.cause);
    let _ = write!(said, "{} of {} ({} %)", finding.count, finding.of, three_digits(100.0 * finding.share()));
    let reported = |number: f64| powers_of_ten(&three_digits(number));
    if let Some(steps) = finding.steps.filter(|&steps| steps > 0.0) {
        let angle = finding.degrees.map_or(String::new(), |degrees| format!("{}°, ", reported(degrees)));
        let _ = write!(said, "; up to {angle}{} of 255 grey steps under a key light", reported(steps));
    }
    if let Some((amount, unit)) = finding.amount.zip(finding.kind.unit())
        && let amount = finding.kind.write_amount(amount)
        && !finding.cause.contains(&amount)
    {
        let _ = write!(said, "; at worst {} {unit}", powers_of_ten(&amount));
    }
    if let Some(confidence) = finding.confidence {
        let _ = write!(said, "; confidence {confidence:.2}");
    }
    said.push('.');
    page.paragraph(&said);
    page.paragraph(&entry.meaning());
    page.paragraph(&entry.advice());
    if let Some(command) = finding.command(name, output) {
        page.raw(&format!("<pre><code>{}</code></pre>\n", escape_html(&command)));
    }
    let worst = finding.places.first().filter(|_| wanted);
    let picture = worst.map(|site| model.close_up(site, obstacles, SIDES[1])).transpose()?.flatten();
    if let Some(picture) = &picture {
        let alternative =
            format!("the worst place of {}, close up, seen from in front of its face", entry.id);
        let close = "the worst place, seen from in front of its face, with the edges of faces; what covers it is cut away.";
        let mut pictures = vec![(picture, alternative.as_str())];
        let whole = worst.map(|site| model.whereabouts(site, obstacles, SIDES[1])).transpose()?.flatten();
        let caption = match &whole {
            Some((_, true)) => format!("Left: {close} Right: the ring is round it in the whole."),
            Some((_, false)) => {
                format!(
                    "Left: {close} Right: the ring is round it in the whole, where it lies behind what is seen."
                )
            }
            None => format!("This is {close}"),
        };
        pictures
            .extend(whole.iter().map(|(whole, _)| (whole, "the whole mesh, with a ring round that place")));
        page.pictures(&pictures, &caption)?;
        page.raw("<p><a href=\"#overview\">To the overview</a></p>\n");
    }
    let node = worst.map(|site| model.node(site, camera, SIDES[1])).transpose()?.flatten();
    if let Some(picture) = &node {
        let caption = "The whole mesh, with a ring round the middle of what the first of these nodes shows.";
        page.pictures(&[(picture, "the whole mesh, with a ring round a node")], caption)?;
    }
    let columns = ["place", "face", "corner", "vertex", "position", "degrees"];
    let mut table = Table::new("The worst places", &columns);
    for site in finding.places.iter().filter(|site| site.position.is_some()) {
        let number = |number: Option<u32>| number.map_or(String::new(), |number| number.to_string());
        let place = match (&site.line, &site.node) {
            (Some(line), _) => format!("line {line}"),
            (None, Some(node)) if !node.is_empty() => node.clone(),
            _ => format!("part {}", site.part),
        };
        let shown = |x: f64| powers_of_ten(&three_digits(x));
        let position = site.position.map(|p| p.to_array().map(shown).join(", ")).unwrap_or_default();
        let degrees = site.degrees.map(shown).unwrap_or_default();
        table.push([place, number(site.face), number(site.corner), number(site.vertex), position, degrees]);
    }
    table.drop_empty_columns();
    if !table.is_empty() {
        page.table(&table);
    }
    Ok(picture.is_some() || node.is_some())
}
