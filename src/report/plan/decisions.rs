//! The decisions of a plan in words.

use crate::plan::{Axis, Decision, Metric, Minimise};
use crate::text::{Catalogue, Language, Text, Value, catalogue};

/// The texts of the page.
pub(super) static TEXTS: Catalogue = catalogue!("page");

/// A text of the page.
pub(super) fn text(key: &str, values: &[(&'static str, Value)], language: Language) -> String {
    TEXTS.with(key, values).get(language).to_owned()
}

/// A difference by a metric: `1.3 steps`.
pub(super) fn difference(value: f64, metric: Metric) -> Value {
    let key = match metric {
        Metric::Steps => "steps",
        Metric::Flip => "flip",
    };
    TEXTS.with(key, &[("value", value.into())]).into()
}

/// A cost: `1140 bytes`.
pub(super) fn cost(value: u64, minimise: Minimise) -> Text {
    let key = match minimise {
        Minimise::Work => "operations",
        Minimise::Bytes => "bytes",
        Minimise::Vertices => "vertices",
    };
    TEXTS.with(key, &[("value", (value as f64).into())])
}

/// The key of a cost's name.
pub(super) fn name_of(minimise: Minimise) -> &'static str {
    match minimise {
        Minimise::Work => "plot-work",
        Minimise::Bytes => "plot-bytes",
        Minimise::Vertices => "plot-vertices",
    }
}

/// The name of an axis.
pub(super) fn axis(axis: Axis, language: Language) -> String {
    text(&format!("axis-{}", axis.name()), &[], language)
}

/// A value of an axis in words. Numbers and names of formats stay.
pub(super) fn value(name: &str, language: Language) -> String {
    let words: Vec<String> = name.split(", ").map(|word| one_value(word, language)).collect();
    words.join(", ")
}

fn one_value(name: &str, language: Language) -> String {
    let key = format!("value-{}", name.to_lowercase().replace(' ', "-"));
    if TEXTS.has(&key) { text(&key, &[], language) } else { name.to_owned() }
}

/// The sentence for a decision: what is changed, why that is possible, and by how much a pixel differs.
pub(super) fn sentence(decision: &Decision, metric: Metric, language: Language) -> String {
    let mut key = format!("because-{}", decision.axis.name());
    let details = [("radii", decision.radii.is_some()), ("angle", decision.angle.is_some())];
    for (detail, is_known) in details {
        let longer = format!("{key}-{detail}");
        if is_known && TEXTS.has(&longer) {
            key = longer;
        }
    }
    let name = |name: &str| Value::from(value(name, language));
    let values = [
        ("what", Value::from(what(&decision.what, language))),
        ("from", name(&decision.from)),
        ("to", name(&decision.to)),
        ("angle", Value::quantity(decision.angle.unwrap_or(0.0), "°")),
        ("radii", decision.radii.unwrap_or(0.0).into()),
        ("difference", difference(decision.measured, metric)),
    ];
    text(&key, &values, language)
}

/// An object by its name, or a light by its number.
pub(super) fn what(name: &str, language: Language) -> String {
    match name.split_once(' ') {
        Some(("light", number)) => text("light", &[("number", number.to_owned().into())], language),
        Some(("object", number)) => text("object", &[("number", number.to_owned().into())], language),
        _ if name == "picture" => text("picture", &[], language),
        _ => name.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_axis_has_a_name_and_a_reason() {
        for axis in Axis::ALL.into_iter().chain([Axis::Antialiasing]) {
            for key in ["axis", "because"] {
                let key = format!("{key}-{}", axis.name());
                assert!(TEXTS.has(&key), "{key}");
            }
        }
    }

    #[test]
    fn values_are_in_the_language_of_the_page() {
        let name = |name| Language::ALL.map(|language| value(name, language));
        assert_eq!(name("point, attenuated"), ["point, attenuated", "pontual, com atenuação"]);
        assert_eq!(name("as declared"), ["as declared", "como declarado"]);
        assert_eq!(name("oct12"), ["oct12", "oct12"]);
        assert_eq!(Language::ALL.map(|language| what("light 2", language)), ["light 2", "luz 2"]);
    }
}
