//! The gallery's structure, in both languages.

use super::notation::running;
use super::*;
use crate::artefact::{EXPERIMENTS, Language, Outcome, Parameters, Setup};
use crate::report::escape_html;
use serde_json::Value;
use std::collections::BTreeSet;
use std::sync::LazyLock;

/// All experiments at a small size.
static OUTCOMES: LazyLock<Vec<Outcome>> = LazyLock::new(|| {
    let run = |experiment: &crate::artefact::Experiment| {
        let parameters = Parameters { size: 48, ..experiment.defaults };
        experiment.run(&Setup { parameters, mesh: None }).unwrap()
    };
    EXPERIMENTS.into_iter().map(run).collect()
});

fn pages(language: Language) -> Vec<(String, String)> {
    let page = |(experiment, outcome): (&crate::artefact::Experiment, &Outcome)| {
        let setup = Setup { parameters: experiment.defaults, mesh: None };
        (page_name(experiment), experiment_page(experiment, &setup, outcome, language, true).unwrap())
    };
    let mut pages: Vec<(String, String)> = EXPERIMENTS.into_iter().zip(&*OUTCOMES).map(page).collect();
    let found: Vec<_> = EXPERIMENTS.into_iter().zip(&*OUTCOMES).collect();
    pages.push(("index.html".into(), index_page(&found, language).unwrap()));
    pages
}

/// The values of an attribute.
fn values<'a>(page: &'a str, attribute: &str) -> Vec<&'a str> {
    let start = format!(" {attribute}=\"");
    page.split(&start).skip(1).map(|rest| rest.split('"').next().unwrap_or_default()).collect()
}

#[test]
fn pages_stand_by_themselves() {
    for language in Language::ALL {
        let pages = pages(language);
        let names: BTreeSet<&str> = pages.iter().map(|(name, _)| name.as_str()).collect();
        for (name, page) in &pages {
            assert!(page.contains(&format!("<html lang=\"{}\">", language.tag())), "{name}");
            for outside in ["http://", "https://", "//cdn", "<script", "<link", "@import", "<iframe"] {
                assert!(!page.contains(outside), "{name} has {outside}");
            }
            let ids = values(page, "id");
            let known: BTreeSet<&str> = ids.iter().copied().collect();
            assert_eq!(known.len(), ids.len(), "{name}: an id twice");
            for link in values(page, "href") {
                let found = match link.strip_prefix('#') {
                    Some(id) => known.contains(id),
                    None => names.contains(link),
                };
                assert!(found, "{name}: {link} leads nowhere");
            }
            let labels = values(page, "aria-labelledby").into_iter().flat_map(str::split_whitespace);
            labels.for_each(|id| assert!(known.contains(id), "{name}: no {id}"));
            let clips = page.split("url(#").skip(1).map(|rest| rest.split(')').next().unwrap());
            clips.for_each(|id| assert!(known.contains(id), "{name}: no {id}"));
            let between = |start: &str, end: &str| -> Vec<String> {
                let parts = page.split(start).skip(1);
                parts.filter_map(|part| Some(part.split_once(end)?.0.to_owned())).collect()
            };
            let headings: Vec<String> = between("<h2 ", "</h2>")
                .iter()
                .filter_map(|h| Some(h.split_once('>')?.1.to_owned()))
                .collect();
            for caption in between("<caption>", "</caption>") {
                assert!(!headings.contains(&caption), "{name}: `{caption}` is a heading and a caption");
            }
            assert_eq!(page.matches("<img ").count(), values(page, "alt").len(), "{name}");
            assert!(values(page, "alt").iter().all(|alt| alt.len() > 10), "{name}: a picture without words");
            assert!(
                values(page, "src").iter().all(|src| src.starts_with("data:image/png;base64,")),
                "{name}"
            );
        }
    }
}

/// Every object of exactly an English and a Portuguese text.
fn texts(value: &Value, found: &mut Vec<[String; 2]>) {
    match value {
        Value::Object(members) => {
            if let (2, Some(Value::String(en)), Some(Value::String(pt))) =
                (members.len(), members.get("en"), members.get("pt"))
            {
                found.push([en.clone(), pt.clone()]);
            }
            members.values().for_each(|member| texts(member, found));
        }
        Value::Array(items) => items.iter().for_each(|item| texts(item, found)),
        _ => {}
    }
}

/// Names, functions and marks of notation that both languages write alike.
const ALIKE: [&str; 18] = [
    "Gouraud", "Phong", "sin", "cos", "tan", "arcsin", "arccos", "arctan", "max", "rms", "frac", "sqrt",
    "quad", "mathrm", "left", "right", "px", "DoG",
];

/// Whether a text may be the same in both languages: names, symbols and numbers without a word.
fn is_alike(text: &str) -> bool {
    let letters = |c: char| !c.is_ascii_alphabetic();
    text.split(letters).all(|word| word.len() < 2 || ALIKE.contains(&word))
}

#[test]
fn portuguese_pages_have_no_english_left() {
    let pages = pages(Language::Portuguese);
    for (number, (experiment, outcome)) in EXPERIMENTS.into_iter().zip(&*OUTCOMES).enumerate() {
        let mut all = Vec::new();
        let setup = Setup { parameters: experiment.defaults, mesh: None };
        let formulas = experiment.closed_forms(&setup).into_iter();
        let said = [experiment.title(), experiment.claim()]
            .into_iter()
            .chain(experiment.sources())
            .chain(formulas.flat_map(|formula| [formula.notation, formula.says]));
        said.for_each(|text| texts(&serde_json::to_value(&text).unwrap(), &mut all));
        texts(&serde_json::to_value(outcome).unwrap(), &mut all);
        assert!(all.len() > 20, "{}: only {} texts", experiment.id, all.len());
        let (_, page) = &pages[number];
        for [en, pt] in all {
            // No space at an end may make two texts of one.
            assert!([&en, &pt].iter().all(|text| text.trim() == **text), "{}: {en:?} {pt:?}", experiment.id);
            assert!(en != pt || is_alike(&en), "{}: not translated: {en}", experiment.id);
            // A short word may be a part of a Portuguese one.
            let is_reported = en != pt && en.len() > 12 && !pt.contains(&en);
            let is_left = || page.contains(&*escape_html(&en)) || page.contains(&running(&en));
            assert!(!is_reported || !is_left(), "{}: English left: {en}", experiment.id);
        }
    }
}

/// On paper, on a projector and without colour vision.
#[test]
fn plots_are_legible() {
    for (language, outcome) in
        Language::ALL.into_iter().flat_map(|language| OUTCOMES.iter().map(move |o| (language, o)))
    {
        outcome.charts.iter().for_each(|chart| chart_plot(chart, language).assert_legible());
    }
}

/// What people read of a page: words between tags, and those for who cannot see pictures and formulas; no commands.
fn words_of(page: &str) -> String {
    let mut words = ["alt", "alttext", "title"].map(|name| values(page, name).join("\n")).join("\n");
    let body = page.split_once("<body").unwrap().1;
    for element in body.split('<') {
        let (tag, text) = element.split_once('>').unwrap_or_default();
        if !tag.starts_with("code") {
            words.push('\n');
            words.push_str(text);
        }
    }
    words
}

/// No mark of the formulas' notation is left where people read: not in running text, not in plots.
#[test]
fn scripts_are_typeset() {
    let mut below_and_above = 0;
    for (name, page) in Language::ALL.into_iter().flat_map(pages) {
        let body = page.split_once("<body").unwrap().1;
        for element in body.split('<') {
            let (tag, text) = element.split_once('>').unwrap_or_default();
            below_and_above += usize::from(["sub", "sup"].contains(&tag));
            let is_read = !tag.starts_with("code");
            assert!(!is_read || !text.contains(['_', '^', '`', '{', '\\']), "{name}: <{tag}> {text}");
        }
    }
    assert!(below_and_above > 40, "{below_and_above}");
}

/// Decimal numbers of a text: digits with one of the marks between. Those with more are numbers of sections.
fn decimals(text: &str, mark: char) -> Vec<&str> {
    let numbers =
        text.split(|c: char| !c.is_ascii_digit() && c != mark).map(|number| number.trim_matches(mark));
    numbers.filter(|number| number.matches(mark).count() == 1).collect()
}

#[test]
fn portuguese_numbers_have_a_comma() {
    let mut commas = 0;
    for (name, page) in pages(Language::Portuguese) {
        let words = words_of(&page);
        assert_eq!(decimals(&words, '.'), [""; 0], "{name}");
        commas += decimals(&words, ',').len();
    }
    assert!(commas > 300, "{commas}");
    let english = pages(Language::English);
    assert!(english.iter().map(|(_, page)| decimals(&words_of(page), '.').len()).sum::<usize>() > 300);
}

#[test]
fn sheets_and_names_are_made_of_every_picture() {
    for (experiment, outcome) in EXPERIMENTS.into_iter().zip(&*OUTCOMES) {
        let sheet = experiment_sheet(outcome, Language::English).unwrap();
        // Two rows of three at most: of the largest picture and the widest label.
        let largest = |axis: usize| outcome.shots.iter().map(|shot| shot.image.size[axis]).max().unwrap();
        assert!(
            sheet.size[0] > 96 && sheet.size[1] < 2 * (largest(1).max(240) + 140),
            "{}: {:?}",
            experiment.id,
            sheet.size
        );
        let names =
            outcome.shots.iter().map(|shot| shot.name).chain(outcome.charts.iter().map(|chart| chart.name));
        let names: Vec<&str> = names.collect();
        let different: BTreeSet<&&str> = names.iter().collect();
        assert_eq!(different.len(), names.len(), "{}", experiment.id);
    }
}

/// What every experiment owes: the artefact in one picture, its cure in another, and a number that became smaller.
#[test]
fn every_experiment_shows_its_artefact_and_its_cure() {
    use crate::artefact::Role;
    for (experiment, outcome) in EXPERIMENTS.into_iter().zip(&*OUTCOMES) {
        let has = |role| outcome.shots.iter().any(|shot| shot.role == role);
        assert!(has(Role::Bad) && has(Role::Cured), "{}", experiment.id);
        assert!(
            outcome.effect.is_present() && outcome.effect.reduction() >= outcome.effect.factor,
            "{}: {:?}",
            experiment.id,
            outcome.effect
        );
    }
}

/// The font of sheets is a part of a font.
#[test]
fn sheets_have_all_letters_of_their_labels() {
    use crate::report::panel::has_letters;
    for (experiment, outcome) in EXPERIMENTS.into_iter().zip(&*OUTCOMES) {
        let labels = outcome.shots.iter().map(|shot| &shot.label);
        let of_charts = outcome.charts.iter().flat_map(|chart| {
            let curves = chart.curves.iter().map(|curve| &curve.name);
            [&chart.title, &chart.x.label, &chart.y.label].into_iter().chain(curves)
        });
        for label in labels.chain(of_charts) {
            for language in Language::ALL {
                let text = label.get(language);
                assert!(has_letters(text), "{}: {text}", experiment.id);
            }
        }
    }
}

#[test]
fn every_experiment_has_a_map_of_the_difference_or_can_make_one() {
    use crate::artefact::{Role, Shot};
    for (experiment, outcome) in EXPERIMENTS.into_iter().zip(&*OUTCOMES) {
        let given = outcome.shots.iter().any(|shot| shot.role == Role::Difference);
        let made: Vec<Shot> = outcome.series().filter_map(Shot::difference).collect();
        assert!(given || !made.is_empty(), "{}", experiment.id);
        for shot in made {
            let full = shot.map.unwrap().full;
            assert!(full >= 2.0, "{}: {full}", experiment.id);
        }
    }
}
