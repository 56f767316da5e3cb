//! The page of a diagnosis: overview, changes, one section per finding, histograms. Its texts are in page.en.ftl.

use super::comparison::{self, After};
use super::deviation::worst_places;
use super::histograms::histograms;
use super::legend::Marks;
use super::markers::HeatScale;
use super::model::{Model, OVERVIEW};
use super::view_choice::{Sight, camera};
use crate::io::Loaded;
use crate::mesh::Obstacles;
use crate::num::{powers_of_ten, three_digits};
use crate::quality::catalogue::Kind;
use crate::quality::{Diagnosis, Finding, Fix, Severity, Site, survey};
use crate::raster::Camera;
use crate::report::error::Result;
use crate::report::html::{Page, with_code};
use crate::report::picture::Picture;
use crate::report::table::Table;
use crate::text::{Catalogue, Language, Value, catalogue};
use maud::html;

/// Pixels along the sides of close-ups.
const CLOSE_UP: u32 = 240;

static TEXTS: Catalogue = catalogue!("page", en);

fn text(key: &str, values: &[(&'static str, Value)]) -> String {
    TEXTS.with(key, values).get(Language::English).to_owned()
}

const CLOSE_UPS: usize = 12;

/// The page of a diagnosis, and what is on it in addition to the findings.
#[derive(Clone, Copy, Debug)]
pub struct DiagnosisPage<'a> {
    /// The name of the file.
    pub name: &'a str,
    /// The command that fixes what can be fixed together.
    pub fix: Option<&'a Fix>,
    /// How many findings are not in the diagnosis because they were not selected.
    pub omitted: usize,
    /// The file after a change: both are shown side by side, with what changed.
    pub after: Option<After<'a>>,
    /// The view of the pictures of the whole.
    pub sight: Sight,
}

impl DiagnosisPage<'_> {
    /// The page in HTML. It opens from disk without other files: pictures of the worst positions, each finding with its
    /// explanation and its worst position close up, and histograms.
    ///
    /// # Errors
    /// Pictures that cannot be drawn or made into files.
    pub fn html(&self, loaded: &Loaded, diagnosis: &Diagnosis) -> Result<String> {
        let surveys = survey(loaded);
        // The same colours before and after.
        let later = self.after.map(|after| survey(after.loaded)).unwrap_or_default();
        let model = Model::new(loaded, &surveys, HeatScale::of(surveys.iter().chain(&later)))?;
        let mut page = Page::new(&self.title(diagnosis), &self.lead(diagnosis)).set_by(with_code);
        let camera = camera(&model, diagnosis, self.after.map(|after| after.comparison), self.sight);
        overview(&mut page, &model, diagnosis, camera)?;
        if let Some(fix) = self.fix {
            page.paragraph(&fix_text(fix, diagnosis));
            page.push(html! { pre { code { (fix.command) } } });
        }
        if let (Some(after), Some(camera)) = (self.after, camera) {
            comparison::section(&mut page, &model, after, &later, camera)?;
        }
        weightings(&mut page, diagnosis);
        let obstacles = model.obstacles();
        let mut drawn = 0;
        for finding in &diagnosis.findings {
            describe(&mut page, finding);
            let worst = finding.places.first().filter(|_| drawn < CLOSE_UPS);
            if let Some(site) = worst {
                let id = finding.kind.id();
                drawn += usize::from(close_ups(&mut page, (&model, &obstacles, camera), site, id)?);
            }
            let table = places(finding);
            if !table.is_empty() {
                page.table(&table);
            }
        }
        page.heading("Distributions");
        for (name, caption, plot) in histograms(&surveys) {
            page.drawing(&format!("histogram of {name}"), &caption, |id| plot.svg(id));
        }
        Ok(page.finish())
    }

    /// The result in a few words.
    fn title(&self, diagnosis: &Diagnosis) -> String {
        let counts =
            Severity::ALL.into_iter().rev().map(|severity| (diagnosis.count(severity), severity.name()));
        let counts = counts.filter(|(count, _)| *count > 0);
        let counts =
            counts.map(|(count, name)| format!("{count} {name}{}", if count == 1 { "" } else { "s" }));
        let counts = counts.collect::<Vec<_>>().join(", ");
        let key = match (&*counts, self.omitted) {
            ("", 0) => "title-none",
            ("", _) => "title-omitted",
            _ => "title-found",
        };
        text(key, &[("name", self.name.into()), ("counts", counts.into())])
    }

    /// How much was checked.
    fn lead(&self, diagnosis: &Diagnosis) -> String {
        let faces: usize = diagnosis.parts.iter().map(|part| part.faces).sum();
        let checked = text("checked", &[("faces", faces.to_string().into())]);
        match self.omitted {
            0 => checked,
            omitted => format!("{checked} {}", text("omitted", &[("count", omitted.to_string().into())])),
        }
    }
}

/// Which findings a command fixes, and which remain.
fn fix_text(fix: &Fix, diagnosis: &Diagnosis) -> String {
    let ids = |is_fixed: bool| {
        let kinds = diagnosis.findings.iter().map(|finding| finding.kind);
        let kinds = kinds.filter(|kind| fix.kinds.contains(kind) == is_fixed);
        kinds.map(|kind| format!("`{}`", kind.id())).collect::<Vec<_>>().join(", ")
    };
    let others = match ids(false) {
        none if none.is_empty() => none,
        others => format!(" {}", text("not-fixed", &[("others", others.into())])),
    };
    format!("{}{others}", text("fix", &[("fixed", ids(true).into())]))
}

fn overview(page: &mut Page, model: &Model, diagnosis: &Diagnosis, camera: Option<Camera>) -> Result<()> {
    page.heading("Overview");
    let Some(camera) = camera else {
        page.paragraph("There are no faces to show.");
        return Ok(());
    };
    let (heat, marks) = model.deviation("", camera, OVERVIEW, &worst_places(diagnosis))?;
    let (facing, creases) = (model.facing(camera, OVERVIEW)?, model.creases(camera, OVERVIEW)?);
    let pictures: [(&Picture, &str); 3] = [
        (&heat, &text("heat-alternative", &[("scale", model.scale.words().into())])),
        (&facing, &text("facing-alternative", &[])),
        (&creases, &text("creases-alternative", &[])),
    ];
    page.pictures(&pictures, &caption(marks, diagnosis))?;
    if !diagnosis.findings.is_empty() {
        page.push(html! { ul { @for finding in &diagnosis.findings {
            @let id = finding.kind.id();
            li { a href={ "#" (id) } { (finding.severity.name()) ": " (id) } ": " (finding.cause) }
        } } });
    }
    Ok(())
}

fn caption(marks: Marks, diagnosis: &Diagnosis) -> String {
    let of_edges = [Kind::AveragedCrease, Kind::SplitSeam, Kind::GroupMismatch];
    let marks = [
        (marks.dots, "marks-dots"),
        (of_edges.iter().any(|&kind| diagnosis.get(kind).is_some()), "marks-edges"),
        (marks.lines, "marks-lines"),
        (marks.rings, "marks-rings"),
        (marks.hidden, "marks-hidden"),
    ];
    let shown = marks.into_iter().filter(|(is_shown, _)| *is_shown);
    let shown: String = shown.map(|(_, key)| text(key, &[])).collect();
    text("overview-caption", &[("marks", shown.into())])
}

fn weightings(page: &mut Page, diagnosis: &Diagnosis) {
    let columns = ["submesh", "faces", "recipe", "median"];
    let mut table = Table::new("Recipes that reproduce the stored normals best", &columns);
    for (number, part) in diagnosis.parts.iter().enumerate() {
        let Some(estimate) = part.estimate else { continue };
        let name = if part.name.is_empty() { format!("submesh {number}") } else { part.name.clone() };
        table.push([
            name,
            part.faces.to_string(),
            estimate.in_words(),
            format!("{}°", digits(estimate.median.0)),
        ]);
    }
    if !table.is_empty() {
        page.table(&table);
    }
}

/// A number with a power of ten where it would be long.
fn digits(x: f64) -> String {
    powers_of_ten(&three_digits(x))
}

fn describe(page: &mut Page, finding: &Finding) {
    let entry = finding.kind.entry();
    page.heading(entry.id);
    let share = three_digits(100.0 * finding.share());
    let mut text = format!(
        "{}: {}. {} of {} ({share} %)",
        finding.severity.name(),
        finding.cause,
        finding.count,
        finding.of
    );
    if let Some(steps) = finding.steps.filter(|&steps| steps > 0.0) {
        let angle = finding.degrees.map_or(String::new(), |degrees| format!("{}°, ", digits(degrees)));
        text += &format!("; up to {angle}{} of 255 grey steps under a key light", digits(steps));
    }
    if let Some((amount, unit)) = finding.amount.zip(finding.kind.unit())
        && let amount = finding.kind.write_amount(amount)
        && !finding.cause.contains(&amount)
    {
        text += &format!("; at worst {} {unit}", powers_of_ten(&amount));
    }
    if let Some(confidence) = finding.confidence {
        text += &format!("; confidence {confidence:.2}");
    }
    text.push('.');
    page.paragraph(&text);
    [entry.meaning(), entry.advice()].iter().for_each(|text| page.paragraph(text.get(Language::English)));
}

/// Pictures of the worst position of a finding: close up and in the whole, or of its node. Whether there is one.
fn close_ups(
    page: &mut Page,
    (model, obstacles, camera): (&Model, &[Obstacles<'_>], Option<Camera>),
    site: &Site,
    id: &str,
) -> Result<bool> {
    let picture = model.close_up(site, obstacles, CLOSE_UP)?;
    if let Some(picture) = &picture {
        let alternative = text("close-up-alternative", &[("finding", id.into())]);
        let whole = model.whereabouts(site, obstacles, CLOSE_UP)?;
        let caption = match &whole {
            Some((_, true)) => text("close-up-seen", &[]),
            Some((_, false)) => text("close-up-hidden", &[]),
            None => text("close-up-alone", &[]),
        };
        let of_whole = text("whole-alternative", &[]);
        let whole = whole.iter().map(|(whole, _)| (whole, of_whole.as_str()));
        let pictures: Vec<(&Picture, &str)> =
            std::iter::once((picture, alternative.as_str())).chain(whole).collect();
        page.pictures(&pictures, &caption)?;
        page.push(html! { p { a href="#overview" { "To the overview" } } });
    }
    let node = model.node(site, camera, CLOSE_UP)?;
    if let Some(picture) = &node {
        let alternative = text("node-alternative", &[]);
        page.pictures(&[(picture, alternative.as_str())], &text("node-caption", &[]))?;
    }
    Ok(picture.is_some() || node.is_some())
}

fn places(finding: &Finding) -> Table {
    let columns = ["location", "face", "corner", "vertex", "position", "degrees"];
    let mut table = Table::new("Worst locations", &columns);
    for site in finding.places.iter().filter(|site| site.position.is_some()) {
        let number = |number: Option<u32>| number.map_or(String::new(), |number| number.to_string());
        let place = match (&site.line, &site.node) {
            (Some(line), _) => format!("line {line}"),
            (None, Some(node)) if !node.is_empty() => node.clone(),
            _ => format!("primitive {}", site.part),
        };
        let position = site.position.map(|p| p.to_array().map(digits).join(", ")).unwrap_or_default();
        let degrees = site.degrees.map(digits).unwrap_or_default();
        table.push([place, number(site.face), number(site.corner), number(site.vertex), position, degrees]);
    }
    table.drop_empty_columns();
    table
}
