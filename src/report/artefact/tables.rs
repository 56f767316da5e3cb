//! The texts of the pages: tables and sentences.

use crate::artefact::{
    EXPERIMENTS, Effect, Expected, Language, Measure, Outcome, Range, Role, Text, Verdict,
};
use crate::report::Table;
use crate::text::{Catalogue, Value, catalogue};

static TEXTS: Catalogue = catalogue!("texts");

pub(super) fn text(key: &str, language: Language) -> String {
    TEXTS.get(key).get(language).to_owned()
}

/// Where an experiment is shown live.
pub(super) fn live(link: &str, language: Language) -> String {
    TEXTS.with("live", &[("link", link.into())]).get(language).to_owned()
}

pub(super) fn role(role: Role) -> &'static str {
    match role {
        Role::Bad => "role-bad",
        Role::Cured => "role-cured",
        Role::Attempt => "role-attempt",
        Role::Absent => "role-absent",
        Role::Difference => "role-difference",
        Role::Truth => "role-truth",
        Role::Seen => "role-seen",
    }
}

/// The number that the cure changes, before and after, and its threshold.
pub(super) fn effect(effect: &Effect) -> Text {
    let key = if effect.is_present() { "effect-present" } else { "effect-absent" };
    TEXTS.with(key, &values(effect))
}

/// Why nothing is visible, what would show it, and which pictures show it nevertheless because their conditions are their own.
fn absent(outcome: &Outcome, shown_by: &Text) -> Text {
    let is_present = outcome.effect.is_present();
    let key = if is_present { "absent-in-pictures" } else { "absent-below-threshold" };
    let mut values = values(&outcome.effect);
    values.push(("shown-by", shown_by.into()));
    let said = TEXTS.with(key, &values);
    let shown: Vec<&Text> =
        outcome.shots.iter().filter(|shot| shot.role == Role::Bad).map(|shot| &shot.label).collect();
    if shown.is_empty() {
        return said;
    }
    let labels = |language| shown.iter().map(|label| label.get(language)).collect::<Vec<_>>().join("; ");
    TEXTS.with("shown-in", &[("said", said.into()), ("labels", Text::each(labels).into())])
}

/// A condition, and that the cure did too little.
fn cure_fails(effect: &Effect, condition: &Text) -> Text {
    let mut values = values(effect);
    values.push(("condition", condition.into()));
    TEXTS.with("cure-fails", &values)
}

fn values(effect: &Effect) -> Vec<(&'static str, Value)> {
    let number = |x| Value::quantity(effect.reported(x), effect.unit);
    let less = match effect.reduction() {
        f64::INFINITY => TEXTS.get("gone"),
        _ if effect.reported(effect.cured) == 0.0 => TEXTS.get("gone-but-for-rounding"),
        times => TEXTS.with("times-less", &[("times", times.into())]),
    };
    vec![
        ("name", (&effect.name).into()),
        ("bad", number(effect.bad)),
        ("from", Value::quantity(effect.present.value, effect.unit)),
        ("why", (&effect.present.why).into()),
        ("cure", (&effect.cure).into()),
        ("cured", number(effect.cured)),
        ("less", less.into()),
        ("factor", effect.factor.into()),
    ]
}

fn wanted(range: Range, unit: &'static str) -> Text {
    match range {
        Range::Near { value, tolerance } => {
            let values =
                [("value", Value::Number(value, unit)), ("tolerance", Value::Number(tolerance, unit))];
            TEXTS.with("near", &values)
        }
        Range::AtMost { at_most } => TEXTS.with("at-most", &[("value", Value::Number(at_most, unit))]),
    }
}

/// All numbers of an experiment with their expected values.
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
        let Measure { name, unit, value, expected, agrees, beyond } = measure;
        let nothing = || text("nothing", language);
        let mut row = vec![name.get(language).to_owned(), language.quantity(*value, unit)];
        if let Some(expected) = expected {
            let agrees = text(if *agrees == Some(true) { "yes" } else { "no" }, language);
            let (wanted, within) = match expected.range {
                Range::Near { value, tolerance } => {
                    (language.quantity(value, unit), language.short(tolerance, ""))
                }
                Range::AtMost { .. } => (wanted(expected.range, unit).get(language).to_owned(), nothing()),
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

/// A sentence for each number that is not as expected: its name, its value, the expected value, and the source of that.
pub fn misses(outcome: &Outcome, language: Language) -> Vec<String> {
    let missed = outcome.measures.iter().filter(|measure| measure.agrees == Some(false));
    let sentence = |Measure { name, unit, value, expected, .. }: &Measure| {
        let Expected { range, by } = expected.as_ref()?;
        let values = [
            ("name", name.into()),
            ("found", Value::Number(*value, unit)),
            ("wanted", wanted(*range, unit).into()),
            ("by", by.into()),
        ];
        Some(TEXTS.with("miss", &values).get(language).to_owned())
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
    Table::new(&text(caption, language), &columns)
}

/// The verdict as its name and its condition: with the numbers where nothing of the artefact is visible, and where the cure
/// fails.
pub fn verdict_text(outcome: &Outcome, language: Language) -> [String; 2] {
    let condition = outcome.verdict.condition();
    let key = match &outcome.verdict {
        Verdict::Absent(_) => "absent",
        Verdict::Holds(_) => "holds",
        Verdict::HoldsOnlyIf(_) => "holds-only-if",
        Verdict::Fails(_) => "fails",
    };
    let condition = match &outcome.verdict {
        Verdict::Absent(_) => absent(outcome, condition),
        _ if outcome.effect.is_cured() => condition.clone(),
        _ => cure_fails(&outcome.effect, condition),
    };
    [text(key, language), condition.get(language).to_owned()]
}

/// The verdict as a sentence.
pub fn verdict_sentence(outcome: &Outcome, language: Language) -> String {
    let [name, condition] = verdict_text(outcome, language);
    let colon = if matches!(outcome.verdict, Verdict::HoldsOnlyIf(_)) { "" } else { ":" };
    format!("{name}{colon} {condition}")
}

/// The verdict as a sentence, with the first of its conditions.
pub(super) fn verdict_in_short(outcome: &Outcome, language: Language) -> String {
    let verdict = verdict_sentence(outcome, language);
    verdict.split_inclusive(". ").next().unwrap_or_default().trim_end().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::artefact::{Expected, Measure, Threshold, Verdict};
    use crate::report::{measure_table, misses};

    fn vanished() -> Effect {
        let name = Text::same("x");
        Effect {
            name: name.clone(),
            unit: "",
            bad: 0.25,
            present: Threshold::half_step_of_tilt(),
            cure: name,
            cured: 0.0,
            factor: 2.0,
        }
    }

    #[test]
    fn what_vanished_is_not_infinitely_less() {
        let vanished = vanished();
        let said = |vanished: &Effect| {
            let text = effect(vanished);
            Language::ALL.map(|language| text.get(language).to_owned())
        };
        let [en, pt] = said(&vanished);
        assert!(
            en.contains("0 after the cure (x): gone.") && pt.contains("0 depois da cura (x): sumiu."),
            "{en} {pt}"
        );
        assert!(en.contains("x: 0.25"), "{en}");
        let [_, halved] = said(&Effect { cured: 0.1, ..vanished.clone() });
        assert!(halved.contains("2,5 vezes menor. O artefato é visível acima de 0,112 ("), "{halved}");
        let rounded = Effect { cured: 1e-6, ..vanished };
        let [en, pt] = said(&rounded);
        assert!(en.contains("0 after the cure (x): gone, except for rounding."), "{en}");
        assert!(pt.contains("0 depois da cura (x): sumiu, salvo arredondamento."), "{pt}");
    }

    #[test]
    fn misses_tell_what_was_found_and_what_was_expected() {
        let by = || Text::same("z");
        let measure = |value: f64, range: Option<Range>| Measure {
            name: Text::same("x"),
            unit: "px",
            value,
            expected: range.map(|range| Expected { range, by: by() }),
            agrees: range.map(|range| range.contains(value)),
            beyond: None,
        };
        let near = Some(Range::Near { value: 1.0, tolerance: 0.25 });
        let measures = vec![
            measure(1.5, near),
            measure(1.5, Some(Range::AtMost { at_most: 1.0 })),
            measure(1.0, near),
            measure(1.0, None),
        ];
        let effect = vanished();
        let verdict = Verdict::Holds(by());
        let outcome = Outcome { verdict, effect, measures, shots: vec![], charts: vec![], notes: vec![] };
        assert_eq!(
            misses(&outcome, Language::English),
            [
                "x: measured 1.5 px, expected 1 px ± 0.25 px (z)",
                "x: measured 1.5 px, expected at most 1 px (z)"
            ]
        );
        assert_eq!(
            misses(&outcome, Language::Portuguese),
            [
                "x: medido 1,5 px, esperado 1 px ± 0,25 px (z)",
                "x: medido 1,5 px, esperado no máximo 1 px (z)"
            ]
        );
        let table = measure_table(&outcome, Language::Portuguese).to_text();
        assert!(table.contains("no máximo 1 px") && table.contains("NÃO"), "{table}");
    }

    #[test]
    fn units_are_separate_from_numbers() {
        assert_eq!(Language::Portuguese.quantity(70.5, "°"), "70,5°");
        assert_eq!(Language::English.quantity(3.0, "px"), "3 px");
    }
}
