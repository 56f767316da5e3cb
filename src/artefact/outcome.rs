//! What an experiment finds: data and linear pictures, no markup.

use super::{Moved, Text, Threshold};
use crate::raster::Image;
use serde::{Serialize, Serializer};

/// Everything that came of a run.
#[derive(Clone, Debug, Serialize)]
pub struct Outcome {
    /// Whether the claim holds here.
    pub verdict: Verdict,
    /// The number that the cure moves.
    pub moved: Moved,
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
    /// The pictures in series, each of an artefact and what is done about it: another one begins with a picture of an artefact
    /// after one of a cure.
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
        let checked = self.measures.iter().filter(|measure| measure.agrees() == Some(true)).count();
        assert!(checked > 0, "nothing is checked");
        for measure in &self.measures {
            assert_ne!(measure.agrees(), Some(false), "{measure:?}");
        }
        assert!(self.moved.is_present(), "{:?}", self.moved);
        assert!(self.moved.reduction() >= self.moved.factor && self.moved.factor > 1.0, "{:?}", self.moved);
    }

    /// The measure whose English name starts like this.
    pub(super) fn measured(&self, name: &str) -> f64 {
        let named = |measure: &&Measure| measure.name.get(super::Language::English).starts_with(name);
        self.measures.iter().find(named).unwrap_or_else(|| panic!("no measure {name}")).value
    }
}

/// Whether a claim holds.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "verdict", content = "condition", rename_all = "kebab-case")]
pub enum Verdict {
    /// Wherever it was looked at: these conditions.
    Holds(Text),
    /// Under this condition; it fails without.
    HoldsOnlyIf(Text),
    /// Not here, for this reason.
    Fails(Text),
    /// It is not put to the test: with these parameters nothing of its artefact is seen ([`Moved::is_present`]). These would
    /// show it.
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

/// A measured number. As JSON it has one member more where something is known about it: `agrees`.
#[derive(Clone, Debug, PartialEq)]
pub struct Measure {
    /// What it measures.
    pub name: Text,
    /// Its unit; empty for none.
    pub unit: &'static str,
    /// What was found.
    pub value: f64,
    /// What it is held against.
    pub expected: Option<Expected>,
    /// Why it is held against nothing, where with other parameters it is.
    pub beyond: Option<Text>,
}

/// What a number should be, and who says so.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Expected {
    /// Where it has to lie.
    #[serde(flatten)]
    pub range: Range,
    /// The closed form or the other way to compute it, and why the tolerance is what it is.
    pub by: Text,
}

/// Where a number has to lie.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Range {
    /// About the value of a closed form, or of an independent computation.
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
    /// Whether a number lies there; what is not a number lies nowhere.
    fn contains(self, found: f64) -> bool {
        match self {
            Range::Near { value, tolerance } => (found - value).abs() <= tolerance,
            Range::AtMost { at_most } => (0.0..=at_most).contains(&found),
        }
    }
}

impl Measure {
    /// A number that nothing is known about beforehand.
    pub fn new(name: Text, unit: &'static str, value: f64) -> Self {
        Self { name, unit, value, expected: None, beyond: None }
    }

    /// With what it should be.
    #[must_use]
    pub fn expect(self, value: f64, tolerance: f64, by: Text) -> Self {
        let range = Range::Near { value, tolerance };
        Self { expected: Some(Expected { range, by }), ..self }
    }

    /// With a bound that it must not exceed, nor be negative.
    #[must_use]
    pub fn at_most(self, at_most: f64, by: Text) -> Self {
        let range = Range::AtMost { at_most };
        Self { expected: Some(Expected { range, by }), ..self }
    }

    /// With the reason why no law covers it under these parameters.
    #[must_use]
    pub fn beyond(self, why: Text) -> Self {
        Self { beyond: Some(why), ..self }
    }

    /// Whether it is what it should be; `None` where nothing is known.
    pub fn agrees(&self) -> Option<bool> {
        Some(self.expected.as_ref()?.range.contains(self.value))
    }
}

impl Serialize for Measure {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        struct Judged<'a> {
            name: &'a Text,
            unit: &'a str,
            value: f64,
            #[serde(skip_serializing_if = "Option::is_none")]
            expected: Option<&'a Expected>,
            #[serde(skip_serializing_if = "Option::is_none")]
            agrees: Option<bool>,
            #[serde(skip_serializing_if = "Option::is_none")]
            beyond: Option<&'a Text>,
        }
        let Self { name, unit, value, expected, beyond } = self;
        let (expected, agrees, beyond) = (expected.as_ref(), self.agrees(), beyond.as_ref());
        Judged { name, unit, value: *value, expected, agrees, beyond }.serialize(serializer)
    }
}

/// What a picture shows. It follows from what was measured in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Role {
    /// The artefact.
    Bad,
    /// The same without, or with little of it.
    Cured,
    /// A cure that does too little.
    Attempt,
    /// Nothing of the artefact: with these parameters it is not there, and there is nothing to cure.
    Absent,
    /// What lies between two pictures, or a map of an error.
    Difference,
    /// The surface itself.
    Truth,
    /// What there is to see where the artefact is so faint that maps beside it have to show it.
    Seen,
}

/// How much of the artefact a picture has, and from what size on it is seen.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Amount {
    /// What it measures.
    pub name: Text,
    /// Its unit; empty for none.
    pub unit: &'static str,
    /// What was found.
    pub value: f64,
    /// From what size on it is seen.
    pub present: Threshold,
}

/// A picture.
#[derive(Clone, Debug, Serialize)]
pub struct Shot {
    /// Its name within the experiment: lower-case letters, digits and hyphens.
    pub name: &'static str,
    /// What it shows.
    pub role: Role,
    /// What stands below it, in a few words.
    pub label: Text,
    /// What there is to see in it, in a sentence: also for those who cannot see it.
    pub caption: Text,
    /// What its role follows from; none of differences and of the surface itself.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub measured: Option<Amount>,
    /// The picture, with its linear samples.
    #[serde(rename = "size", serialize_with = "size")]
    pub image: Image,
}

impl Shot {
    /// What lies between two pictures.
    pub(super) fn difference(name: &'static str, label: Text, caption: Text, image: Image) -> Self {
        Self { name, role: Role::Difference, label, caption, measured: None, image }
    }

    /// What maps of an artefact are of.
    pub(super) fn seen(name: &'static str, label: Text, caption: Text, image: Image) -> Self {
        Self { name, role: Role::Seen, label, caption, measured: None, image }
    }

    /// The surface itself.
    pub(super) fn truth(name: &'static str, label: Text, caption: Text, image: Image) -> Self {
        Self { name, role: Role::Truth, label, caption, measured: None, image }
    }
}

/// A picture as its size.
fn size<S: Serializer>(image: &Image, serializer: S) -> Result<S::Ok, S::Error> {
    image.size.serialize(serializer)
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
    /// Across.
    pub x: Scale,
    /// Upwards.
    pub y: Scale,
    /// What is drawn.
    pub curves: Vec<Curve>,
}

/// An axis of a chart.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Scale {
    /// What it measures, with its unit.
    pub label: Text,
    /// Whether powers of ten are equally far apart.
    pub logarithmic: bool,
}

impl Scale {
    /// An even one.
    pub fn linear(label: Text) -> Self {
        Self { label, logarithmic: false }
    }

    /// One of powers of ten.
    pub fn log(label: Text) -> Self {
        Self { label, logarithmic: true }
    }
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
    /// A dotted line: what theory says, or a border.
    Guide,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_have_one_side_and_closed_forms_two() {
        let measure = |value| Measure::new(Text::same("x"), "", value);
        for (measure, agrees) in [
            (measure(1.5).expect(1.0, 0.5, Text::same("y")), true),
            (measure(0.4).expect(1.0, 0.5, Text::same("y")), false),
            (measure(0.0).at_most(1.0, Text::same("y")), true),
            (measure(1.0).at_most(1.0, Text::same("y")), true),
            (measure(1.1).at_most(1.0, Text::same("y")), false),
            (measure(-0.1).at_most(1.0, Text::same("y")), false),
            (measure(f64::NAN).at_most(1.0, Text::same("y")), false),
        ] {
            assert_eq!(measure.agrees(), Some(agrees), "{measure:?}");
            let json = serde_json::to_value(&measure).unwrap();
            assert_eq!(json["agrees"], agrees);
            let has = |member: &str| !json["expected"][member].is_null();
            assert_ne!(has("value") && has("tolerance"), has("at_most"), "{json}");
        }
        let json = serde_json::to_value(measure(1.0)).unwrap();
        assert_eq!(json.as_object().unwrap().len(), 3, "{json}");
    }

    #[test]
    fn a_series_begins_with_an_artefact_after_a_cure() {
        use Role::{Absent, Attempt, Bad, Cured, Difference, Truth};
        let lengths = |roles: &[Role]| -> Vec<usize> {
            let image = crate::artefact::stage::picture([1, 1], vec![[0.0; 3]], vec![1]);
            let shot = |&role: &Role| Shot {
                role,
                ..Shot::truth("x", Text::same("x"), Text::same("y"), image.clone())
            };
            let outcome = Outcome {
                verdict: Verdict::Holds(Text::same("z")),
                moved: Moved {
                    name: Text::same("x"),
                    unit: "",
                    bad: 1.0,
                    present: Threshold::HALF_PIXEL,
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
