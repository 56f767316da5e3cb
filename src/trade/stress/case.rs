//! The groups of the catalogue, a case, and its result.

use super::measured::{Measured, Worst};
use crate::num::names;
use crate::text::{Catalogue, Language, catalogue};
use crate::trade::described::described;

described! {
    /// What is extreme about a case.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
    Group {
        Magnitude = "magnitude": "coordinates from 1e-45 to 3e38, and mixed in one triangle",
        Offset = "offset": "triangles of size 1 far from the origin: arithmetic and storage separately",
        Needle = "needle": "faces much longer than high, and the sliver threshold",
        Degenerate = "degenerate": "exactly collinear and duplicate points",
        NonFinite = "non-finite": "positions that are infinite or not a number",
        Valence = "valence": "vertices of 3 to a million faces, and fans that nearly cancel",
        Fan = "fan": "opposite faces, folds, edges of three faces, tips of cones",
        Angle = "angle": "corners near 0 and 180 degrees",
        Crease = "crease": "dihedral angles exactly at the crease angle",
        Unit = "unit": "unit vectors of subnormal and of huge ones",
        Product = "product": "differences of nearly equal products",
        Highlight = "highlight": "powers of cosines up to a million, opposite and grazing light",
        Attenuation = "attenuation": "light very close to its source",
        Raster = "raster": "triangles far outside the picture, behind the camera, very large, or thinner than a pixel",
        Encoding = "encoding": "normals in few bits, at the poles and on the edges of the octahedron",
    }
}

impl Group {
    /// The reason why cases of the group have no `fast`.
    pub const fn without_fast(self) -> &'static str {
        match self {
            Group::NonFinite => "reading and checking positions is the same for both",
            Group::Angle | Group::Product => "fast uses the same function",
            Group::Unit => "normalised in f64 only",
            Group::Crease => "counted for the report from the same face normals",
            Group::Raster => "drawing has no fast variant",
            Group::Encoding => "encoding has no fast variant",
            Group::Fan => "quadrics are fitted in f64, whatever the precision of the mean",
            _ => "there is no fast variant",
        }
    }
}

static TEXTS: Catalogue = catalogue!("texts", en);

fn text(key: &str) -> String {
    TEXTS.get(key).get(Language::English).to_owned()
}

described! {
    /// Why a plain formula fails.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
    Cause {
        Rounding = "rounding": "overflow or rounding: the formula holds in exact arithmetic",
        Definition = "definition": "the formula fails in exact arithmetic too",
    }
}

/// The unit of an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Unit {
    /// Units of the last place of the true `f32` component: the largest of the three.
    Ulps,
    /// The angle to the true direction, in degrees.
    Degrees,
    /// |computed − true| / |true|.
    Relative,
    /// |computed − true|, of colours and directions, whose largest value is 1.
    Absolute,
    /// The number of wrong answers: pixels, edges, or faults with a wrong reason.
    Wrong,
}

names! { Unit:
    Ulps = "ulps", Degrees = "degrees", Relative = "relative", Absolute = "absolute", Wrong = "wrong",
}

impl Unit {
    /// The smallest visible error: half a step of an 8-bit picture. A white surface changes by that much when its
    /// normal turns by asin(1/510) = 0.1123°, which is ten thousand ulps; one wrong pixel or edge is visible.
    pub fn visible(self) -> f64 {
        match self {
            Unit::Ulps => 1e4,
            Unit::Degrees => 0.1123,
            Unit::Relative | Unit::Absolute => 1.0 / 510.0,
            Unit::Wrong => 1.0,
        }
    }
}

/// The largest error that is allowed, and why.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Bound {
    /// The largest error.
    pub most: f64,
    /// Its unit.
    #[serde(skip)]
    pub unit: Unit,
    #[serde(serialize_with = "as_text")]
    source: &'static str,
}

fn as_text<S: serde::Serializer>(key: &str, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(&text(key))
}

impl Bound {
    pub(super) const fn new(most: f64, unit: Unit, source: &'static str) -> Self {
        Self { most, unit, source }
    }

    pub(super) const fn none_wrong(source: &'static str) -> Self {
        Self::new(0.0, Unit::Wrong, source)
    }

    /// The derivation of the bound, or the document that states it.
    pub fn source(&self) -> String {
        text(self.source)
    }

    /// Whether errors are within the bound.
    pub fn holds(&self, worst: &Worst) -> bool {
        worst.undefined() == 0 && worst.error <= self.most
    }
}

/// One case of the catalogue.
pub struct StressCase {
    /// The group that it is part of.
    pub group: Group,
    /// Its name, unique in the group.
    pub name: String,
    /// The bound of `faithful`.
    pub bound: Bound,
    /// The bound of `fast`, where the case concerns it: with the answers that it leaves to `faithful`.
    pub fast_bound: Option<Bound>,
    /// The unit of the plain formula's error.
    pub plain_unit: Unit,
    /// The first part of the keys of its texts.
    texts: &'static str,
    measure: Box<dyn Fn() -> Measured + Send + Sync>,
}

impl StressCase {
    /// A case with the bounds of `faithful` and `fast`. Plain formulas are far from counting ulps: their error is in degrees
    /// then.
    pub(super) fn new(
        group: Group,
        texts: &'static str,
        name: impl Into<String>,
        (bound, fast_bound): (Bound, Option<Bound>),
        measure: impl Fn() -> Measured + Send + Sync + 'static,
    ) -> Self {
        let plain_unit = if bound.unit == Unit::Ulps { Unit::Degrees } else { bound.unit };
        Self { group, name: name.into(), bound, fast_bound, plain_unit, texts, measure: Box::new(measure) }
    }

    /// A description of the input and of what is counted.
    pub fn what(&self) -> String {
        self.text("what")
    }

    /// The expectation, in words.
    pub fn expectation(&self) -> String {
        self.text("expected")
    }

    /// The plain formula.
    pub fn plain_formula(&self) -> String {
        self.text("plain")
    }

    fn text(&self, part: &str) -> String {
        text(&format!("{}-{part}", self.texts))
    }

    /// Runs the case. The same bits on any number of threads.
    pub fn run(&self) -> StressResult<'_> {
        let measured = (self.measure)();
        let fast = measured.fast.zip(self.fast_bound);
        StressResult {
            case: self,
            measured,
            faithful_holds: self.bound.holds(&measured.faithful),
            fast_holds: fast.is_none_or(|(worst, bound)| bound.holds(&worst)),
        }
    }
}

impl std::fmt::Debug for StressCase {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        write!(f, "{}: {}", self.group.name(), self.name)
    }
}

/// The result of a case.
#[derive(Clone, Copy, Debug)]
pub struct StressResult<'a> {
    /// The case.
    pub case: &'a StressCase,
    /// The errors.
    pub measured: Measured,
    /// Whether `faithful` is within its bound.
    pub faithful_holds: bool,
    /// Whether `fast` is within its bound, if it has one.
    pub fast_holds: bool,
}

impl StressResult<'_> {
    /// Whether the expectation holds.
    pub fn holds(&self) -> bool {
        self.faithful_holds && self.fast_holds
    }

    /// Why plain `f32` code fails visibly: by an undefined result, or by an error of [`Unit::visible`] or more. `None`
    /// also where `faithful` has half of that error or more and is visibly wrong too: storage loses the same for both.
    pub fn plain_failure(&self) -> Option<Cause> {
        let faithful = self.measured.faithful;
        let is_visible = |worst: Worst, unit: Unit| worst.undefined() > 0 || worst.error >= unit.visible();
        let fails = |worst: Worst| {
            let both = is_visible(faithful, self.case.bound.unit) && worst.error <= 2.0 * faithful.error;
            is_visible(worst, self.case.plain_unit) && !both
        };
        let by_definition = fails(self.measured.definition);
        let cause = if by_definition { Cause::Definition } else { Cause::Rounding };
        self.measured.plain.is_some_and(fails).then_some(cause)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trade::stress::{cases_of, catalogue};

    #[test]
    fn bounds_are_broken_by_more_and_by_nothing() {
        let bound = Bound::new(1.0, Unit::Ulps, "a test");
        for (errors, holds) in [
            ([0.0, 1.0], true),
            ([0.0, 1.0 + f64::EPSILON], false),
            ([0.0, f64::INFINITY], false),
            ([0.0, f64::NAN], false),
        ] {
            assert_eq!(bound.holds(&errors.into_iter().collect()), holds, "{errors:?}");
        }
        assert!(!Bound::none_wrong("a test").holds(&Worst::wrong(1)));
    }

    #[test]
    fn a_case_holds_if_both_ways_do() {
        let cases = cases_of(Group::Attenuation);
        let mut result = cases[0].run();
        assert!(result.holds());
        result.fast_holds = false;
        assert!(!result.holds());
        // What is measured is judged: with half the error allowed, it breaks.
        let mut case = cases_of(Group::Attenuation).swap_remove(0);
        case.bound.most = 0.5 * result.measured.faithful.error;
        assert!(!case.run().holds());
        case.bound.most = 1.0;
        case.fast_bound =
            case.fast_bound.map(|bound| Bound { most: 0.5 * result.measured.fast.unwrap().error, ..bound });
        assert!(case.run().faithful_holds && !case.run().fast_holds);
    }

    #[test]
    fn every_case_has_a_name_of_its_own_a_finite_bound_and_a_source() {
        let cases = catalogue();
        let mut names: Vec<(Group, &str)> =
            cases.iter().map(|case| (case.group, case.name.as_str())).collect();
        names.sort();
        names.dedup();
        assert_eq!(names.len(), cases.len());
        for group in Group::ALL {
            assert!(cases.iter().any(|case| case.group == group), "{group:?}");
        }
        for case in &cases {
            assert!(case.bound.most.is_finite(), "{case:?}");
            let sources =
                [Some(case.bound), case.fast_bound].into_iter().flatten().map(|bound| bound.source());
            for text in sources.chain([case.what(), case.expectation(), case.plain_formula()]) {
                assert!(!text.is_empty() && !text.starts_with('{'), "{case:?}: {text}");
            }
        }
    }
}
