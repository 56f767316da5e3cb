//! Pages of experiments: for a browser, paper and a projector, and their pictures.

use super::notation::{mathml, running};
use super::tables;
use super::tables::{measure_table, verdict_in_short, verdict_text};
use crate::artefact::{Chart, Drawn, Experiment, Language, MapScale, Outcome, Role, Scale, Setup, Shot};
use crate::num::{Transfer, three_digits, viridis};
use crate::raster::{Image, Pixels};
use crate::report::error::Result;
use crate::report::html::image;
use crate::report::panel::panels_in;
use crate::report::{Axis, ColourScale, Legend, Mark, Page, Panel, Picture, Plot, Series};
use maud::{Markup, PreEscaped, html};

/// The name of an experiment's page in the gallery.
pub fn page_name(experiment: &Experiment) -> String {
    format!("{}.html", experiment.id)
}

/// The page of one experiment: claim, verdict, pictures, numbers, plots, and the command that does it again. In the gallery
/// it has a way back to the index.
///
/// # Errors
/// Pictures that cannot be made into files.
pub fn experiment_page(
    experiment: &Experiment,
    setup: &Setup,
    outcome: &Outcome,
    language: Language,
    in_gallery: bool,
) -> Result<String> {
    let text = |key| tables::text(key, language);
    let mut page = page(experiment.title().get(language), experiment.claim().get(language), language);
    if in_gallery {
        page.raw(&html! { p.up { a href="index.html" { (text("all")) } } "\n" }.into_string());
    }
    claim(experiment, setup, language, &mut page);
    page.heading(&text("verdict"));
    let [name, condition] = verdict_text(outcome, language);
    page.raw(&html! { p.verdict { strong { (name) } ": " (set(&condition)) } "\n" }.into_string());
    page.heading(&text("pictures"));
    for series in outcome.series() {
        page.raw(&figures(experiment, series, language)?.into_string());
    }
    page.heading(&text("effect"));
    page.paragraph(tables::effect(&outcome.effect).get(language));
    page.heading(&text("measured"));
    page.table(&measure_table(outcome, language));
    if !outcome.charts.is_empty() {
        page.heading(&text("plots"));
    }
    for chart in &outcome.charts {
        let plot = chart_plot(chart, language);
        page.drawing(chart.name, chart.caption.get(language), |id| plot.svg(id));
    }
    // On paper the command does not stand alone on a page.
    page.raw("<div class=\"end\">\n");
    page.heading(&text("explained"));
    outcome.notes.iter().for_each(|note| page.paragraph(note.get(language)));
    page.heading(&text("reproduce"));
    page.paragraph(&text("command"));
    let command = experiment.command(setup, language);
    page.raw(&html! { pre { code { (command) } } "\n" }.into_string());
    page.paragraph(&tables::live(&laboratory_link(experiment, setup), language));
    page.raw("</div>\n");
    Ok(page.finish())
}

/// The page of the laboratory in a browser that shows the same run.
fn laboratory_link(experiment: &Experiment, setup: &Setup) -> String {
    let changed = experiment.takes.iter().filter_map(|&name| {
        let [own, usual] = [&setup.parameters, &experiment.defaults].map(|parameters| parameters.value(name));
        Some(format!("{}:{}", name.name(), own.filter(|own| Some(own) != usual.as_ref())?))
    });
    let changed: Vec<String> = changed.collect();
    let parameters = if changed.is_empty() { "" } else { "&parameters=" };
    format!("lab.html#room=artefacts&experiment={}{parameters}{}", experiment.id, changed.join(","))
}

/// The thumbnails of the first series: the artefact before the first cure, that cure, and the first difference.
fn thumbnails(series: &[Shot]) -> impl Iterator<Item = &Shot> {
    let is_one_of = |roles: &'static [Role]| move |shot: &&Shot| roles.contains(&shot.role);
    let cure = series.iter().position(|shot| matches!(shot.role, Role::Cured | Role::Attempt));
    let before = &series[..cure.unwrap_or(series.len())];
    let artefact = before.iter().rfind(is_one_of(&[Role::Bad, Role::Absent]));
    let difference = series.iter().find(is_one_of(&[Role::Difference]));
    [artefact, cure.map(|cure| &series[cure]), difference].into_iter().flatten()
}

/// The index of some experiments, with thumbnails: the artefact, its cure, and their difference if it is drawn.
///
/// # Errors
/// Pictures that cannot be made into files.
pub fn index_page(found: &[(&Experiment, &Outcome)], language: Language) -> Result<String> {
    let text = |key| tables::text(key, language);
    let mut page = page(&text("laboratory"), &text("lead"), language);
    let card = |experiment: &Experiment, outcome: &Outcome| -> Result<Markup> {
        let thumbnails = thumbnails(outcome.series().next().unwrap_or_default());
        let images = thumbnails
            .map(|shot| image(&thumbnail(&shot.image), shot.caption.get(language)).map(PreEscaped))
            .collect::<Result<Vec<_>, _>>()?;
        Ok(html! {
            a.card href=(page_name(experiment)) {
                span.row { @for image in images { (image) } }
                strong { (experiment.title().get(language)) }
                span { (set(experiment.claim().get(language))) }
                em { (set(&verdict_in_short(outcome, language))) }
            }
        })
    };
    let cards = found.iter().map(|(experiment, outcome)| card(experiment, outcome));
    let cards = cards.collect::<Result<Vec<_>, _>>()?;
    page.raw(&html! { div.cards { @for card in cards { (card) } } "\n" }.into_string());
    Ok(page.finish())
}

fn page(title: &str, lead: &str, language: Language) -> Page {
    Page::new(title, lead).in_language(language.tag(), &tables::text("contents", language)).set_by(running)
}

fn set(text: &str) -> Markup {
    PreEscaped(running(text))
}

fn claim(experiment: &Experiment, setup: &Setup, language: Language, page: &mut Page) {
    page.heading(&tables::text("claim", language));
    page.paragraph(experiment.claim().get(language));
    page.list(experiment.sources().iter().map(|source| source.get(language)));
    if setup.mesh.is_some() {
        page.paragraph(&tables::text("no-formulas", language));
    }
    for formula in experiment.closed_forms(setup) {
        page.raw(&format!(
            "<div class=\"formula\" tabindex=\"0\">{}</div>",
            mathml(formula.notation.get(language))
        ));
        page.raw("\n");
        page.paragraph(formula.says.get(language));
    }
}

/// An artefact and its cures, in one row.
fn figures(experiment: &Experiment, series: &[Shot], language: Language) -> Result<Markup> {
    let figure = |shot: &Shot| -> Result<Markup> {
        let picture = image(&Picture::from(shot.image.clone()), shot.caption.get(language))?;
        let role = tables::text(tables::role(shot.role), language);
        let file = picture_name(experiment, shot.name);
        Ok(html! {
            figure {
                (PreEscaped(picture))
                figcaption {
                    strong { (set(shot.label.get(language))) } " (" (role) "). "
                    (set(shot.caption.get(language))) " " code { (file) ".png" }
                }
            }
        })
    };
    let figures = series.iter().map(figure).collect::<Result<Vec<_>, _>>()?;
    Ok(html! { div.shots { @for figure in figures { (figure) } } "\n" })
}

/// The name of the file that a picture or plot of an experiment is written to, without its ending.
pub fn picture_name(experiment: &Experiment, name: &str) -> String {
    format!("{}-{name}", experiment.id)
}

/// The most panels of a sheet, so that each is readable on a slide, and the most in a row.
const MOST_PANELS: usize = 6;
const COLUMNS: usize = 3;

/// The pictures of a sheet with `most` panels: the first series, then of each other one an artefact and its cure, then what there is
/// room for; in the order of the experiment.
fn sheet_shots(outcome: &Outcome, most: usize) -> Vec<&Shot> {
    let series: Vec<&[Shot]> = outcome.series().collect();
    let place = |shot: &Shot| outcome.shots.iter().position(|other| std::ptr::eq(other, shot));
    let first = series.first().map_or(0, |series| series.len());
    let others = series.iter().skip(1).flat_map(|series| thumbnails(series).take(2).filter_map(place));
    let mut wanted: Vec<usize> = Vec::new();
    for place in (0..first).chain(others).chain(first..outcome.shots.len()) {
        if wanted.len() < most && !wanted.contains(&place) {
            wanted.push(place);
        }
    }
    wanted.sort_unstable();
    wanted.into_iter().map(|place| &outcome.shots[place]).collect()
}

/// A sheet of an experiment for a slide: at most six panels with labels, the last one its first curve. Maps have their scale below.
///
/// # Errors
/// If there is no picture.
pub fn experiment_sheet(outcome: &Outcome, language: Language) -> Result<Picture> {
    let shots = sheet_shots(outcome, MOST_PANELS - outcome.charts.len().min(1));
    let panel = |shot: &&Shot| {
        let picture = Picture::from(shot.image.clone());
        let picture = shot.map.map_or(picture.clone(), |map| map_legend(map, language).below(&picture));
        Panel { caption: shot.label.get(language).to_owned(), picture }
    };
    let mut sheet: Vec<Panel> = shots.iter().map(panel).collect();
    if let Some(chart) = outcome.charts.first() {
        let largest = |axis: usize| sheet.iter().map(|panel| panel.picture.size[axis]).max().unwrap_or(0);
        let size = [largest(0), largest(1)].map(|side| side.max(LEAST_CHART));
        let picture = chart_plot(chart, language).picture(size);
        sheet.push(Panel { caption: chart.title.get(language).to_owned(), picture });
    }
    panels_in(&sheet, COLUMNS)
}

/// The least side of a curve on a sheet, in pixels: narrower ones have no room for the names of their curves.
const LEAST_CHART: u32 = 240;

fn map_legend(MapScale { full, unit }: MapScale, language: Language) -> Legend {
    let written = |value: f64| {
        let number = three_digits(value).replace('.', &language.decimal_mark().to_string());
        let space = if unit.is_empty() || unit == "°" { "" } else { " " };
        format!("{number}{space}{unit}")
    };
    let coded = |share: f64| viridis(share).to_array().map(|light| Transfer::Srgb.encode(light) as f32);
    let colours = (0..=64).map(|step| coded(f64::from(step) / 64.0)).collect();
    let labels = vec![(1.0, written(full)), (0.0, "0".into()), (0.5, written(0.5 * full))];
    Legend { scales: vec![ColourScale { colours, labels }], ..Legend::default() }
}

/// A chart as a plot.
pub fn chart_plot(chart: &Chart, language: Language) -> Plot {
    let axis = |scale: &Scale| match scale.logarithmic {
        true => Axis::log(scale.label.get(language)),
        false => Axis::linear(scale.label.get(language)),
    };
    let series = chart.curves.iter().map(|curve| {
        let mark = match curve.drawn {
            Drawn::Curve => Mark::Curve,
            Drawn::Points => Mark::Points,
            Drawn::Line => Mark::Line,
            Drawn::Guide => Mark::Guide,
        };
        Series::new(curve.name.get(language), curve.points.clone(), mark)
    });
    Plot {
        title: chart.title.get(language).to_owned(),
        description: chart.caption.get(language).to_owned(),
        x: axis(&chart.x),
        y: axis(&chart.y),
        series: series.collect(),
        language,
    }
}

/// The side of a thumbnail, at the most.
const THUMBNAIL: u32 = 160;

/// A picture made small by means over squares of pixels, in linear light.
pub(super) fn thumbnail(image: &Image) -> Picture {
    let factor = image.size[0].max(image.size[1]).div_ceil(THUMBNAIL).max(1);
    let size = image.size.map(|side| (side / factor).max(1));
    let linear = image.linear.as_deref().unwrap_or_default();
    let mean = |x: u32, y: u32| {
        let mut sum = [0.0; 3];
        for (row, column) in (0..factor).flat_map(|row| (0..factor).map(move |column| (row, column))) {
            let index = image.index(x * factor + column, y * factor + row);
            let colour = index.and_then(|index| linear.get(index)).copied().unwrap_or_default();
            sum.iter_mut()
                .zip(colour)
                .for_each(|(sum, component)| *sum += f64::from(component.clamp(0.0, 1.0)));
        }
        sum.map(|sum| Transfer::Srgb.to_u8(sum / f64::from(factor * factor)))
    };
    let pixels = (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| (x, y))).map(|(x, y)| mean(x, y));
    Picture { size, pixels: Pixels::Eight(pixels.collect()) }
}
