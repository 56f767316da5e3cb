//! The page of a diagnosis: overview, changes, one section per finding, histograms.

use super::comparison::{self, After};
use super::deviation::worst_places;
use super::finding_map::FindingMap;
use super::histograms::histograms;
use super::legend::Marks;
use super::markers::HeatScale;
use super::model::{Model, OVERVIEW};
use super::texts::Texts;
use super::view_choice::{Sight, camera};
use crate::io::Loaded;
use crate::mesh::Obstacles;
use crate::num::{powers_of_ten, three_digits};
use crate::quality::catalogue::Kind;
use crate::quality::{Diagnosis, Finding, Fix, Severity, Site, Thresholds, survey};
use crate::raster::Camera;
use crate::report::error::Result;
use crate::report::html::{Page, with_code};
use crate::report::picture::Picture;
use crate::report::table::Table;
use crate::text::{Language, Value};
use maud::html;

/// Pixels along the sides of close-ups.
const CLOSE_UP: u32 = 240;

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
    /// The language of the texts.
    pub language: Language,
    /// Those that the findings were found with.
    pub thresholds: &'a Thresholds,
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
        let texts = Texts(self.language);
        let mut page = Page::new(&self.title(diagnosis, texts), &self.lead(diagnosis, texts))
            .in_language(self.language.tag(), &texts.get("contents"))
            .set_by(with_code);
        let camera = camera(&model, diagnosis, self.after.map(|after| after.comparison), self.sight);
        let map = FindingMap::new(loaded, (diagnosis, self.thresholds), false);
        let top = overview(&mut page, (&model, loaded), (diagnosis, &map), camera, texts)?;
        if let Some(fix) = self.fix {
            page.paragraph(&fix_text(fix, diagnosis, texts));
            page.push(html! { pre { code { (fix.command) } } });
        }
        if let (Some(after), Some(camera)) = (self.after, camera) {
            comparison::section(&mut page, &model, after, &later, camera, texts)?;
        }
        weightings(&mut page, diagnosis, texts);
        let has_normals = diagnosis.parts.iter().any(|part| part.estimate.is_some());
        if let Some(camera) = camera.filter(|_| has_normals && !map.is_empty()) {
            let (heat, marks) = model.deviation("", camera, OVERVIEW, &worst_places(diagnosis), texts)?;
            let words = caption("caption-of-deviations", marks, Some(diagnosis), texts);
            page.pictures(&[(&heat, &deviations_in_words(&model, texts))], &words)?;
        }
        let obstacles = model.obstacles();
        let mut drawn = 0;
        for finding in &diagnosis.findings {
            describe(&mut page, finding, texts);
            let worst = finding.places.first().filter(|_| drawn < CLOSE_UPS);
            if let Some(site) = worst {
                let scene = (&model, &*obstacles, camera);
                let is_drawn = close_ups(&mut page, scene, site, (finding.kind.id(), &top), texts)?;
                drawn += usize::from(is_drawn);
            }
            let table = places(finding, texts);
            if !table.is_empty() {
                page.table(&table);
            }
        }
        page.heading(&texts.get("distributions"));
        for (name, caption, plot) in histograms(&surveys, texts) {
            let alternative = texts.with("histogram", &[("name", name.into())]);
            page.drawing(&alternative, &caption, |id| plot.svg(id));
        }
        Ok(page.finish())
    }

    /// The result in a few words.
    fn title(&self, diagnosis: &Diagnosis, texts: Texts) -> String {
        let counts =
            [(Severity::Error, "errors"), (Severity::Warning, "warnings"), (Severity::Note, "notes")];
        let counts = counts.map(|(severity, key)| (diagnosis.count(severity), key));
        let counts = counts.into_iter().filter(|(count, _)| *count > 0);
        let counts: Vec<String> =
            counts.map(|(count, key)| texts.with(key, &[("count", count.into())])).collect();
        let counts = counts.join(", ");
        let key = match (&*counts, self.omitted) {
            ("", 0) => "title-none",
            ("", _) => "title-omitted",
            _ => "title-found",
        };
        texts.with(key, &[("name", self.name.into()), ("counts", counts.into())])
    }

    /// How much was checked.
    fn lead(&self, diagnosis: &Diagnosis, texts: Texts) -> String {
        let faces: usize = diagnosis.parts.iter().map(|part| part.faces).sum();
        let checked = texts.with("checked", &[("faces", faces.to_string().into())]);
        match self.omitted {
            0 => checked,
            omitted => {
                format!("{checked} {}", texts.with("omitted", &[("count", omitted.to_string().into())]))
            }
        }
    }
}

/// Which findings a command fixes, and which remain.
fn fix_text(fix: &Fix, diagnosis: &Diagnosis, texts: Texts) -> String {
    let ids = |is_fixed: bool| {
        let kinds = diagnosis.findings.iter().map(|finding| finding.kind);
        let kinds = kinds.filter(|kind| fix.kinds.contains(kind) == is_fixed);
        kinds.map(|kind| format!("`{}`", kind.id())).collect::<Vec<_>>().join(", ")
    };
    let others = match ids(false) {
        none if none.is_empty() => none,
        others => format!(" {}", texts.with("not-fixed", &[("others", others.into())])),
    };
    format!("{}{others}", texts.with("fix", &[("fixed", ids(true).into())]))
}

/// The pictures of the whole and the list of findings. Returns the id of its heading.
///
/// The first picture has the errors and warnings, or the deviation of stored normals if there are none.
fn overview(
    page: &mut Page,
    (model, loaded): (&Model, &Loaded),
    (diagnosis, map): (&Diagnosis, &FindingMap<'_>),
    camera: Option<Camera>,
    texts: Texts,
) -> Result<String> {
    let top = page.heading(&texts.get("overview"));
    let Some(camera) = camera else {
        page.paragraph(&texts.get("there-is-nothing"));
        return Ok(top);
    };
    let ((first, marks), in_words, words, deviations) = match map.is_empty() {
        true => {
            let heat = model.deviation("", camera, OVERVIEW, &[], texts)?;
            (heat, deviations_in_words(model, texts), "overview-caption", Some(diagnosis))
        }
        false => {
            let found = map.draw(model, loaded, (camera, OVERVIEW), texts)?;
            (found, texts.get("findings-alternative"), "overview-caption-findings", None)
        }
    };
    let (facing, creases) = (model.facing(camera, OVERVIEW)?, model.creases(camera, OVERVIEW)?);
    let pictures: [(&Picture, &str); 3] = [
        (&first, &in_words),
        (&facing, &texts.get("facing-alternative")),
        (&creases, &texts.get("creases-alternative")),
    ];
    page.pictures(&pictures, &caption(words, marks, deviations, texts))?;
    if !diagnosis.findings.is_empty() {
        page.push(html! { ul { @for finding in &diagnosis.findings {
            @let id = finding.kind.id();
            li { a href={ "#" (id) } { (severity(finding, texts)) ": " (id) } ": " (finding.cause.get(texts.0)) }
        } } });
    }
    Ok(top)
}

/// The alternative text of a picture of deviations.
fn deviations_in_words(model: &Model, texts: Texts) -> String {
    texts.with("heat-alternative", &[("scale", model.scale.words(texts).into())])
}

/// The caption of a picture with its marks. That of `deviations` says where they are at edges that smoothing has found.
fn caption(key: &str, marks: Marks, deviations: Option<&Diagnosis>, texts: Texts) -> String {
    let of_edges = [Kind::AveragedCrease, Kind::SplitSeam, Kind::GroupMismatch];
    let is_at_edges =
        deviations.is_some_and(|diagnosis| of_edges.iter().any(|&kind| diagnosis.get(kind).is_some()));
    let marks = [
        (marks.dots, "marks-dots"),
        (is_at_edges, "marks-edges"),
        (marks.lines, "marks-lines"),
        (marks.rings, "marks-rings"),
        (marks.hidden, "marks-hidden"),
    ];
    let shown = marks.into_iter().filter(|(is_shown, _)| *is_shown);
    let shown: String = shown.map(|(_, key)| texts.get(key)).collect();
    texts.with(key, &[("marks", shown.into())])
}

fn weightings(page: &mut Page, diagnosis: &Diagnosis, texts: Texts) {
    let columns = texts.each(["column-submesh", "column-faces", "column-recipe", "column-median"]);
    let mut table = Table::new(&texts.get("recipes"), &columns);
    for (number, part) in diagnosis.parts.iter().enumerate() {
        let Some(estimate) = part.estimate else { continue };
        let name = match part.name.is_empty() {
            true => texts.with("unnamed-submesh", &[("number", number.into())]),
            false => part.name.clone(),
        };
        let recipe = estimate.in_words().get(texts.0).to_owned();
        table.push([name, part.faces.to_string(), recipe, format!("{}°", digits(estimate.median.0, texts))]);
    }
    if !table.is_empty() {
        page.table(&table);
    }
}

/// A number with a power of ten where it would be long.
fn digits(x: f64, texts: Texts) -> String {
    texts.0.localised(&powers_of_ten(&three_digits(x)))
}

fn severity(finding: &Finding, texts: Texts) -> String {
    texts.get(&format!("severity-{}", finding.severity.name()))
}

fn describe(page: &mut Page, finding: &Finding, texts: Texts) {
    let entry = finding.kind.entry();
    page.heading(entry.id);
    let mut details = String::new();
    if let Some(steps) = finding.steps.filter(|&steps| steps > 0.0) {
        let angle = finding.degrees.map_or(String::new(), |degrees| format!("{}°, ", digits(degrees, texts)));
        let steps = digits(steps, texts);
        details += &texts.with("finding-steps", &[("angle", angle.into()), ("steps", steps.into())]);
    }
    if let Some((amount, unit)) = finding.amount.zip(finding.kind.unit())
        && let amount = finding.kind.write_amount(amount)
        && !finding.cause.english().contains(&amount)
    {
        let amount = Value::digits(&powers_of_ten(&amount));
        details += &texts.with("finding-worst", &[("amount", amount), ("unit", unit.into())]);
    }
    if let Some(confidence) = finding.confidence {
        let confidence = Value::digits(&format!("{confidence:.2}"));
        details += &texts.with("finding-confidence", &[("confidence", confidence)]);
    }
    let values = [
        ("severity", severity(finding, texts).into()),
        ("cause", (&finding.cause).into()),
        ("count", finding.count.to_string().into()),
        ("of", finding.of.to_string().into()),
        ("share", Value::digits(&three_digits(100.0 * finding.share()))),
        ("details", details.into()),
    ];
    page.paragraph(&texts.with("finding", &values));
    [entry.meaning(), entry.advice()].iter().for_each(|text| page.paragraph(text.get(texts.0)));
}

/// Pictures of the worst position of a finding: close up and in the whole, or of its node. Whether there is one.
fn close_ups(
    page: &mut Page,
    (model, obstacles, camera): (&Model, &[Obstacles<'_>], Option<Camera>),
    site: &Site,
    (id, top): (&str, &str),
    texts: Texts,
) -> Result<bool> {
    let picture = model.close_up(site, obstacles, CLOSE_UP)?;
    if let Some(picture) = &picture {
        let alternative = texts.with("close-up-alternative", &[("finding", id.into())]);
        let whole = model.whereabouts(site, obstacles, CLOSE_UP)?;
        let caption = match &whole {
            Some((_, true)) => texts.get("close-up-seen"),
            Some((_, false)) => texts.get("close-up-hidden"),
            None => texts.get("close-up-alone"),
        };
        let of_whole = texts.get("whole-alternative");
        let whole = whole.iter().map(|(whole, _)| (whole, of_whole.as_str()));
        let pictures: Vec<(&Picture, &str)> =
            std::iter::once((picture, alternative.as_str())).chain(whole).collect();
        page.pictures(&pictures, &caption)?;
        page.push(html! { p { a href={ "#" (top) } { (texts.get("to-overview")) } } });
    }
    let node = model.node(site, camera, CLOSE_UP)?;
    if let Some(picture) = &node {
        let alternative = texts.get("node-alternative");
        page.pictures(&[(picture, alternative.as_str())], &texts.get("node-caption"))?;
    }
    Ok(picture.is_some() || node.is_some())
}

fn places(finding: &Finding, texts: Texts) -> Table {
    let columns = texts.each([
        "column-location",
        "column-face",
        "column-corner",
        "column-vertex",
        "column-position",
        "column-degrees",
    ]);
    let mut table = Table::new(&texts.get("worst-locations"), &columns);
    // Coordinates have points in both languages: commas separate them.
    let coordinate = |x: f64| powers_of_ten(&three_digits(x));
    for site in finding.places.iter().filter(|site| site.position.is_some()) {
        let number = |number: Option<u32>| number.map_or(String::new(), |number| number.to_string());
        let place = match (&site.line, &site.node) {
            (Some(line), _) => texts.with("line", &[("line", line.to_string().into())]),
            (None, Some(node)) if !node.is_empty() => node.clone(),
            _ => texts.with("primitive", &[("number", site.part.into())]),
        };
        let position = site.position.map(|p| p.to_array().map(coordinate).join(", ")).unwrap_or_default();
        let degrees = site.degrees.map(|degrees| digits(degrees, texts)).unwrap_or_default();
        table.push([place, number(site.face), number(site.corner), number(site.vertex), position, degrees]);
    }
    table.drop_empty_columns();
    table
}
