//! The result of an experiment: data and linear pictures, no markup.

use super::effect::{Effect, Role, Shot, judged};
use crate::text::Text;
use serde::Serialize;

/// The results of a run.
#[derive(Clone, Debug, Serialize)]
pub struct Outcome {
    /// Whether the claim holds here.
    pub verdict: Verdict,
    /// The number that the cure changes.
    #[serde(rename = "moved", serialize_with = "judged")]
    pub effect: Effect,
    /// All numbers.
    pub measures: Vec<Measure>,
    /// Pictures: the artefact, its cure, the difference.
    pub shots: Vec<Shot>,
    /// Curves.
    pub charts: Vec<Chart>,
    /// Paragraphs that explain what is seen.
    pub notes: Vec<Text>,
}

impl Outcome {
    /// The pictures in series: each begins with a picture of an artefact after one of a cure.
    pub fn series(&self) -> impl Iterator<Item = &[Shot]> {
        let mut rest = &self.shots[..];
        std::iter::from_fn(move || {
            let is_cure = |shot: &Shot| matches!(shot.role, Role::Cured | Role::Attempt);
            let cure = rest.iter().position(is_cure).unwrap_or(rest.len());
            let next = rest.iter().skip(cure).position(|shot| shot.role == Role::Bad);
            let (series, others) = rest.split_at(next.map_or(rest.len(), |next| cure + next));
            rest = others;
            (!series.is_empty()).then_some(series)
        })
    }
}

#[cfg(test)]
impl Outcome {
    /// What every experiment's own tests start from: numbers agree with their closed forms, the artefact is there, and the cure
    /// reduces it by the factor that is stated.
    pub(super) fn prove(&self) {
        let checked = self.measures.iter().filter(|measure| measure.agrees == Some(true)).count();
        assert!(checked > 0, "nothing is checked");
        for measure in &self.measures {
            assert_ne!(measure.agrees, Some(false), "{measure:?}");
        }
        assert!(self.effect.is_present(), "{:?}", self.effect);
        assert!(
            self.effect.reduction() >= self.effect.factor && self.effect.factor > 1.0,
            "{:?}",
            self.effect
        );
    }

    /// The measure whose English name starts like this.
    pub(super) fn measured(&self, name: &str) -> f64 {
        let named = |measure: &&Measure| measure.name.get(crate::text::Language::English).starts_with(name);
        self.measures.iter().find(named).unwrap_or_else(|| panic!("no measure {name}")).value
    }
}

/// Whether a claim holds.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "verdict", content = "condition", rename_all = "kebab-case")]
pub enum Verdict {
    /// It holds under the tested conditions, which are these.
    Holds(Text),
    /// It holds only under this condition.
    HoldsOnlyIf(Text),
    /// It fails here, for this reason.
    Fails(Text),
    /// It is not tested, because the artefact is not visible with these parameters ([`Effect::is_present`]). The text names
    /// parameters that show it.
    Absent(Text),
}

impl Verdict {
    /// The condition, reason or advice.
    pub fn condition(&self) -> &Text {
        match self {
            Verdict::Holds(text)
            | Verdict::HoldsOnlyIf(text)
            | Verdict::Fails(text)
            | Verdict::Absent(text) => text,
        }
    }
}

/// A measured number.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Measure {
    /// What it measures.
    pub name: Text,
    /// Its unit; empty for none.
    pub unit: &'static str,
    /// The measured value.
    pub value: f64,
    /// The expected value.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub expected: Option<Expected>,
    /// Whether it is in the expected range; `None` if none is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub agrees: Option<bool>,
    /// The reason why it has no expected value, if it has one with other parameters.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub beyond: Option<Text>,
}

/// The expected value of a number, and its source.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Expected {
    /// The range in which the number has to be.
    #[serde(flatten)]
    pub range: Range,
    /// The closed form or the other way to compute it, and why the tolerance is what it is.
    pub by: Text,
}

/// The range in which a number has to be.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Range {
    /// Near the value of a closed form, or of an independent computation.
    Near {
        /// That value.
        value: f64,
        /// How far the measured one may be from it.
        tolerance: f64,
    },
    /// Under a bound. What is bounded is never negative.
    AtMost {
        /// The bound, with what rounding leaves open.
        at_most: f64,
    },
}

impl Range {
    /// Whether a number is in the range; NaN never is.
    pub fn contains(self, found: f64) -> bool {
        match self {
            Range::Near { value, tolerance } => (found - value).abs() <= tolerance,
            Range::AtMost { at_most } => (0.0..=at_most).contains(&found),
        }
    }
}

/// Curves over common axes.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Chart {
    /// Its name within the experiment: lower-case letters, digits and hyphens.
    pub name: &'static str,
    /// Its title.
    pub title: Text,
    /// What it shows, in words.
    pub caption: Text,
    /// The horizontal axis.
    pub x: Scale,
    /// The vertical axis.
    pub y: Scale,
    /// What is drawn.
    pub curves: Vec<Curve>,
}

/// An axis of a chart.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Scale {
    /// What it measures, with its unit.
    pub label: Text,
    /// Whether powers of ten are at equal distances.
    pub logarithmic: bool,
}

/// Points that belong together.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Curve {
    /// Its name.
    pub name: Text,
    /// How it is drawn.
    pub drawn: Drawn,
    /// x and y.
    pub points: Vec<[f64; 2]>,
}

/// How a curve is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Drawn {
    /// A line through many points.
    Curve,
    /// Signs at the points: what was measured.
    Points,
    /// Signs, and lines between them.
    Line,
    /// A dotted line: a prediction of theory, or a border.
    Guide,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_have_one_side_and_closed_forms_two() {
        let measure = |value, range: Option<Range>| Measure {
            name: Text::same("x"),
            unit: "",
            value,
            expected: range.map(|range| Expected { range, by: Text::same("y") }),
            agrees: range.map(|range| range.contains(value)),
            beyond: None,
        };
        let near = Some(Range::Near { value: 1.0, tolerance: 0.5 });
        let bound = Some(Range::AtMost { at_most: 1.0 });
        for (measure, agrees) in [
            (measure(1.5, near), true),
            (measure(0.4, near), false),
            (measure(0.0, bound), true),
            (measure(1.0, bound), true),
            (measure(1.1, bound), false),
            (measure(-0.1, bound), false),
            (measure(f64::NAN, bound), false),
        ] {
            assert_eq!(measure.agrees, Some(agrees), "{measure:?}");
            let json = serde_json::to_value(&measure).unwrap();
            assert_eq!(json["agrees"], agrees);
            let has = |member: &str| !json["expected"][member].is_null();
            assert_ne!(has("value") && has("tolerance"), has("at_most"), "{json}");
        }
        let json = serde_json::to_value(measure(1.0, None)).unwrap();
        assert_eq!(json.as_object().unwrap().len(), 3, "{json}");
    }

    #[test]
    fn a_series_begins_with_an_artefact_after_a_cure() {
        use Role::{Absent, Attempt, Bad, Cured, Difference, Truth};
        let lengths = |roles: &[Role]| -> Vec<usize> {
            let image = crate::artefact::drawing::picture([1, 1], vec![[0.0; 3]], vec![1]);
            let shot = |&role: &Role| Shot {
                name: "x",
                role,
                label: Text::same("x"),
                caption: Text::same("y"),
                measured: None,
                map: None,
                image: image.clone(),
            };
            let outcome = Outcome {
                verdict: Verdict::Holds(Text::same("z")),
                effect: Effect {
                    name: Text::same("x"),
                    unit: "",
                    bad: 1.0,
                    present: crate::artefact::Threshold::half_pixel(),
                    cure: Text::same("y"),
                    cured: 0.0,
                    factor: 2.0,
                },
                measures: Vec::new(),
                shots: roles.iter().map(shot).collect(),
                charts: Vec::new(),
                notes: Vec::new(),
            };
            outcome.series().map(<[Shot]>::len).collect()
        };
        for (roles, expected) in [
            (&[][..], &[][..]),
            (&[Bad, Bad, Cured], &[3]),
            (&[Truth, Bad, Cured, Bad, Attempt, Difference], &[3, 3]),
            (&[Bad, Difference, Cured, Truth, Bad, Cured], &[4, 2]),
            (&[Bad, Truth, Cured, Cured], &[4]),
            (&[Absent; 4], &[4]),
        ] {
            assert_eq!(lengths(roles), expected, "{roles:?}");
        }
    }
}
