//! Tables and sentences.

use super::words;
use crate::artefact::{EXPERIMENTS, Expected, Language, Measure, Outcome, Range, Verdict};
use crate::report::Table;

/// All numbers of an experiment beside what they should be.
pub fn measure_table(outcome: &Outcome, language: Language) -> Table {
    let columns = [words::QUANTITY, words::FOUND, words::EXPECTED, words::WITHIN, words::AGREES, words::BY];
    let columns: Vec<&str> = columns.iter().map(|column| column.get(language)).collect();
    let mut table = Table::new(words::NUMBERS.get(language), &columns);
    for measure in &outcome.measures {
        let Measure { name, unit, value, expected, beyond } = measure;
        let nothing = || words::NOTHING.get(language).to_owned();
        let mut row = vec![name.get(language).to_owned(), language.quantity(*value, unit)];
        if let Some(expected) = expected {
            let agrees = if measure.agrees() == Some(true) { words::YES } else { words::NO };
            let (wanted, within) = match expected.range {
                Range::Near { value, tolerance } => {
                    (language.quantity(value, unit), language.short(tolerance, ""))
                }
                Range::AtMost { .. } => (words::wanted(expected.range, unit, language), nothing()),
            };
            row.extend([
                wanted,
                within,
                agrees.get(language).to_owned(),
                expected.by.get(language).to_owned(),
            ]);
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
        let (found, wanted) = (language.quantity(*value, unit), words::wanted(*range, unit, language));
        Some(words::miss([name.get(language), &found, &wanted, by.get(language)], language))
    };
    missed.filter_map(sentence).collect()
}

/// All experiments: id, title, options, and what a mesh of one's own is looked at for.
pub fn list_table(language: Language) -> Table {
    let columns = [words::EXPERIMENT, words::TITLE, words::OPTIONS, words::OWN_MESH];
    let columns: Vec<&str> = columns.iter().map(|column| column.get(language)).collect();
    let mut table = Table::new(words::EXPERIMENTS.get(language), &columns);
    for experiment in EXPERIMENTS {
        let options: Vec<String> = experiment.takes.iter().map(|knob| format!("--{}", knob.name())).collect();
        let animated = if experiment.is_animated() { " --animate" } else { "" };
        let options = options.join(" ") + animated;
        let own_mesh = experiment.own_mesh().map_or(String::new(), |text| text.get(language).to_owned());
        let title = experiment.title();
        table.push([experiment.id, title.get(language), &options, &own_mesh]);
    }
    table
}

/// The verdict as its name and its condition: with the numbers where nothing of the artefact is seen, and where the cure fails.
pub fn verdict_text(outcome: &Outcome, language: Language) -> [String; 2] {
    let name = match &outcome.verdict {
        Verdict::Holds(_) => words::HOLDS,
        Verdict::HoldsOnlyIf(_) => words::HOLDS_ONLY_IF,
        Verdict::Fails(_) => words::FAILS,
        Verdict::Absent(_) => words::ABSENT,
    };
    let condition = outcome.verdict.condition().get(language);
    let condition = match &outcome.verdict {
        Verdict::Absent(_) => words::absent(outcome, condition, language),
        _ if !outcome.moved.is_cured() => format!("{condition} {}", words::uncured(&outcome.moved, language)),
        _ => condition.to_owned(),
    };
    [name.get(language).to_owned(), condition]
}

/// The verdict as a sentence, with the first of its conditions.
pub(super) fn verdict_in_short(outcome: &Outcome, language: Language) -> String {
    let [name, condition] = verdict_text(outcome, language);
    let first = condition.split_inclusive(". ").next().unwrap_or_default().trim_end();
    let colon = if matches!(outcome.verdict, Verdict::HoldsOnlyIf(_)) { "" } else { ":" };
    format!("{name}{colon} {first}")
}
