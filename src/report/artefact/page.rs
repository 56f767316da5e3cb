//! Pages that open from disk, on paper and on a projector.

use super::formula::mathml;
use super::pictures::{chart_plot, picture_name, thumbnail};
use super::running::running;
use super::tables::{measure_table, verdict_in_short, verdict_text};
use super::words;
use crate::artefact::{Experiment, Language, Outcome, Role, Setup, Shot};
use crate::report::{Page, Picture, ReportError, escape_html};

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
) -> Result<String, ReportError> {
    let mut page = page(experiment.title().get(language), experiment.claim().get(language), language);
    if in_gallery {
        let all = words::ALL;
        let all = escape_html(all.get(language));
        page.raw(&format!("<p class=\"up\"><a href=\"index.html\">{all}</a></p>\n"));
    }
    claim(experiment, setup, language, &mut page);
    page.heading(words::VERDICT.get(language));
    page.raw(&verdict(outcome, language));
    page.heading(words::PICTURES.get(language));
    // An artefact and its cures stay in one row.
    for series in outcome.series() {
        page.raw("<div class=\"shots\">\n");
        for shot in series {
            page.raw(&figure(experiment, shot, language)?);
        }
        page.raw("</div>\n");
    }
    page.heading(words::MOVED.get(language));
    page.paragraph(&words::moved(&outcome.moved, language));
    page.heading(words::MEASURED.get(language));
    page.table(&measure_table(outcome, language));
    if !outcome.charts.is_empty() {
        page.heading(words::PLOTS.get(language));
    }
    for chart in &outcome.charts {
        let plot = chart_plot(chart, language);
        page.drawing(chart.name, chart.caption.get(language), |id| plot.svg(id));
    }
    // On paper the command does not stand alone on a page.
    page.raw("<div class=\"end\">\n");
    page.heading(words::EXPLAINED.get(language));
    outcome.notes.iter().for_each(|note| page.paragraph(note.get(language)));
    page.heading(words::REPRODUCE.get(language));
    page.paragraph(words::COMMAND.get(language));
    let command = escape_html(&experiment.command(setup, language)).into_owned();
    page.raw(&format!("<pre><code>{command}</code></pre>\n</div>\n"));
    Ok(page.finish())
}

/// What thumbnails show of the first series: the artefact that stands before the first cure, that, and the first difference.
fn thumbnails(series: &[Shot]) -> impl Iterator<Item = &Shot> {
    let is_one_of = |roles: &'static [Role]| move |shot: &&Shot| roles.contains(&shot.role);
    let cure = series.iter().position(|shot| matches!(shot.role, Role::Cured | Role::Attempt));
    let before = &series[..cure.unwrap_or(series.len())];
    let artefact = before.iter().rfind(is_one_of(&[Role::Bad, Role::Absent]));
    let difference = series.iter().find(is_one_of(&[Role::Difference]));
    [artefact, cure.map(|cure| &series[cure]), difference].into_iter().flatten()
}

/// The index of some experiments, with thumbnails: the artefact, its cure, and what lies between them where that is drawn.
///
/// # Errors
/// Pictures that cannot be made into files.
pub fn index_page(found: &[(&Experiment, &Outcome)], language: Language) -> Result<String, ReportError> {
    let mut page = page(words::LABORATORY.get(language), words::LEAD.get(language), language);
    page.raw("<div class=\"cards\">\n");
    for (experiment, outcome) in found {
        let first = outcome.series().next().unwrap_or_default();
        let thumbnails = thumbnails(first)
            .map(|shot| super::super::html::image(&thumbnail(&shot.image), shot.caption.get(language)));
        let thumbnails: Vec<String> = thumbnails.collect::<Result<_, _>>()?;
        page.raw(&format!(
            "<a class=\"card\" href=\"{}\">\n<span class=\"row\">{}</span>\n<strong>{}</strong>\n<span>{}</span>\n<em>{}</em>\n\
             </a>\n",
            escape_html(&page_name(experiment)),
            thumbnails.join(""),
            escape_html(experiment.title().get(language)),
            running(experiment.claim().get(language)),
            running(&verdict_in_short(outcome, language)),
        ));
    }
    page.raw("</div>\n");
    Ok(page.finish())
}

fn page(title: &str, lead: &str, language: Language) -> Page {
    Page::new(title, lead).in_language(language.tag(), words::CONTENTS.get(language)).set_by(running)
}

/// Who claims it, and the closed forms.
fn claim(experiment: &Experiment, setup: &Setup, language: Language, page: &mut Page) {
    page.heading(words::CLAIM.get(language));
    page.paragraph(experiment.claim().get(language));
    page.list(experiment.sources().iter().map(|source| source.get(language)));
    if setup.mesh.is_some() {
        page.paragraph(words::NO_FORMULAS.get(language));
    }
    for formula in experiment.closed_forms(setup) {
        page.raw(&mathml(formula.notation.get(language)));
        page.raw("\n");
        page.paragraph(formula.says.get(language));
    }
}

fn verdict(outcome: &Outcome, language: Language) -> String {
    let [name, condition] = verdict_text(outcome, language);
    let (name, condition) = (escape_html(&name), running(&condition));
    format!("<p class=\"verdict\"><strong>{name}</strong>: {condition}</p>\n")
}

fn figure(experiment: &Experiment, shot: &Shot, language: Language) -> Result<String, ReportError> {
    let picture = Picture::from(shot.image.clone());
    let image = super::super::html::image(&picture, shot.caption.get(language))?;
    let role = words::role(shot.role);
    let [role, label, caption] = [&role, &shot.label, &shot.caption].map(|text| running(text.get(language)));
    let file = picture_name(experiment, shot.name);
    Ok(format!(
        "<figure>\n{image}\n<figcaption><strong>{label}</strong> ({role}). {caption} <code>{file}.png</code></figcaption>\n\
         </figure>\n"
    ))
}
