//! Tables and sentences.

use super::words::{self, text};
use crate::artefact::{EXPERIMENTS, Expected, Language, Measure, Outcome, Range, Verdict};
use crate::report::Table;
use crate::text::Value;

/// All numbers of an experiment beside what they should be.
pub fn measure_table(outcome: &Outcome, language: Language) -> Table {
    let keys = [
        "column-quantity",
        "column-measured",
        "column-expected",
        "column-within",
        "column-agrees",
        "column-by",
    ];
    let mut table = table("numbers", &keys, language);
    for measure in &outcome.measures {
        let Measure { name, unit, value, expected, beyond } = measure;
        let nothing = || text("nothing", language);
        let mut row = vec![name.get(language).to_owned(), language.quantity(*value, unit)];
        if let Some(expected) = expected {
            let agrees = text(if measure.agrees() == Some(true) { "yes" } else { "no" }, language);
            let (wanted, within) = match expected.range {
                Range::Near { value, tolerance } => {
                    (language.quantity(value, unit), language.short(tolerance, ""))
                }
                Range::AtMost { .. } => {
                    (words::wanted(expected.range, unit).get(language).to_owned(), nothing())
                }
            };
            row.extend([wanted, within, agrees, expected.by.get(language).to_owned()]);
        } else {
            let why = beyond.as_ref().map_or_else(nothing, |why| why.get(language).to_owned());
            row.extend([nothing(), nothing(), nothing(), why]);
        }
        table.push(row);
    }
    table
}

/// A sentence for each number that is not what it should be: what it is, what was found, what was expected, and by what.
pub fn misses(outcome: &Outcome, language: Language) -> Vec<String> {
    let missed = outcome.measures.iter().filter(|measure| measure.agrees() == Some(false));
    let sentence = |Measure { name, unit, value, expected, .. }: &Measure| {
        let Expected { range, by } = expected.as_ref()?;
        let miss = words::miss(&[
            ("name", name.into()),
            ("found", Value::Number(*value, unit)),
            ("wanted", words::wanted(*range, unit).into()),
            ("by", by.into()),
        ]);
        Some(miss.get(language).to_owned())
    };
    missed.filter_map(sentence).collect()
}

/// All experiments: id, title, options, and what is measured on a user's mesh.
pub fn list_table(language: Language) -> Table {
    let keys = ["column-experiment", "column-title", "column-options", "column-own-mesh"];
    let mut table = table("experiments", &keys, language);
    for experiment in EXPERIMENTS {
        let options: Vec<String> = experiment.takes.iter().map(|name| format!("--{}", name.name())).collect();
        let animated = if experiment.is_animated() { " --animate" } else { "" };
        let options = options.join(" ") + animated;
        let own_mesh = experiment.own_mesh().map_or(String::new(), |text| text.get(language).to_owned());
        let title = experiment.title();
        table.push([experiment.id, title.get(language), &options, &own_mesh]);
    }
    table
}

fn table(caption: &str, columns: &[&str], language: Language) -> Table {
    let columns: Vec<String> = columns.iter().map(|key| text(key, language)).collect();
    Table::new(&text(caption, language), &columns.iter().map(String::as_str).collect::<Vec<_>>())
}

/// The verdict as its name and its condition: with the numbers where nothing of the artefact is visible, and where the cure
/// fails.
pub fn verdict_text(outcome: &Outcome, language: Language) -> [String; 2] {
    let condition = outcome.verdict.condition();
    let (key, condition) = match &outcome.verdict {
        Verdict::Absent(_) => ("absent", words::absent(outcome, condition)),
        other => {
            let key = match other {
                Verdict::Holds(_) => "holds",
                Verdict::HoldsOnlyIf(_) => "holds-only-if",
                _ => "fails",
            };
            let is_cured = outcome.effect.is_cured();
            (key, if is_cured { condition.clone() } else { words::cure_fails(&outcome.effect, condition) })
        }
    };
    [text(key, language), condition.get(language).to_owned()]
}

/// The verdict as a sentence, with the first of its conditions.
pub(super) fn verdict_in_short(outcome: &Outcome, language: Language) -> String {
    let [name, condition] = verdict_text(outcome, language);
    let first = condition.split_inclusive(". ").next().unwrap_or_default().trim_end();
    let colon = if matches!(outcome.verdict, Verdict::HoldsOnlyIf(_)) { "" } else { ":" };
    format!("{name}{colon} {first}")
}
