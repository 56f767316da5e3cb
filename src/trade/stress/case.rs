//! What a case is, and what came out of it.

use crate::trade::stress::group::Group;

/// In what an error is counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Unit {
    /// Units of the last place of the true `f32` component: the largest of the three.
    Ulps,
    /// The angle to the true direction, in degrees.
    Degrees,
    /// |got − true| / |true|.
    Relative,
    /// |got − true|, of colours and directions, for which 1 is much.
    Absolute,
    /// Wrong answers: pixels, edges, faults that are told apart wrongly.
    Wrong,
}

impl Unit {
    /// The name used in reports.
    pub fn name(self) -> &'static str {
        match self {
            Unit::Ulps => "ulps",
            Unit::Degrees => "degrees",
            Unit::Relative => "relative",
            Unit::Absolute => "absolute",
            Unit::Wrong => "wrong",
        }
    }

    /// From where on an error can be seen: half a step of an 8-bit picture. A white surface changes by that much when its
    /// normal turns by asin(1/510) = 0.1123°, which is ten thousand ulps; one wrong pixel or edge is seen.
    pub fn visible(self) -> f64 {
        match self {
            Unit::Ulps => 1e4,
            Unit::Degrees => 0.1123,
            Unit::Relative | Unit::Absolute => 1.0 / 510.0,
            Unit::Wrong => 1.0,
        }
    }
}

/// What an error may be, and why.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Bound {
    /// The largest that is allowed.
    pub most: f64,
    /// In this unit.
    #[serde(skip)]
    pub unit: Unit,
    /// Where the number comes from.
    pub source: &'static str,
}

impl Bound {
    /// A bound with its source.
    pub const fn new(most: f64, unit: Unit, source: &'static str) -> Self {
        Self { most, unit, source }
    }

    /// No wrong answer at all.
    pub const fn none_wrong(source: &'static str) -> Self {
        Self::new(0.0, Unit::Wrong, source)
    }

    /// Whether errors keep to it.
    pub fn holds(&self, worst: &Worst) -> bool {
        worst.undefined == 0 && worst.error <= self.most
    }
}

/// The worst of many results.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Worst {
    /// The largest error of those that are numbers.
    pub error: f64,
    /// How many results are no numbers, or no directions.
    pub undefined: usize,
}

impl Worst {
    /// So many wrong answers.
    pub(super) fn wrong(count: usize) -> Self {
        Self { error: count as f64, undefined: 0 }
    }

    /// Takes one more error in; NaN stands for a result that is none.
    pub(super) fn add(&mut self, error: f64) {
        if error.is_nan() {
            self.undefined += 1;
        } else {
            self.error = self.error.max(error);
        }
    }
}

impl FromIterator<f64> for Worst {
    fn from_iter<I: IntoIterator<Item = f64>>(errors: I) -> Self {
        let mut worst = Self::default();
        errors.into_iter().for_each(|error| worst.add(error));
        worst
    }
}

/// What was measured in a case.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Measured {
    /// How many results there are.
    pub samples: usize,
    /// Of [`Precision::Faithful`](crate::normals::Precision), or of `f64` where there is no such choice.
    pub faithful: Worst,
    /// Of [`Precision::Fast`](crate::normals::Precision), or of `f32` where there is no such choice.
    pub fast: Option<Worst>,
    /// How many of the samples `fast` has left to `faithful`, being out of its range.
    pub declined: usize,
    /// Of the formula in plain `f32`.
    pub plain: Option<Worst>,
}

/// One case of the catalogue.
pub struct StressCase {
    /// Where it belongs.
    pub group: Group,
    /// Its name, of its own in the group.
    pub name: String,
    /// What is computed.
    pub what: &'static str,
    /// What is expected, in words.
    pub expectation: &'static str,
    /// What `faithful` is held to.
    pub bound: Bound,
    /// What `fast` is held to, where it concerns it: with the answers that it leaves to `faithful`.
    pub fast_bound: Option<Bound>,
    /// In what the plain formula's error is counted.
    pub plain_unit: Unit,
    /// The plain formula.
    pub plain_formula: &'static str,
    pub(super) measure: Box<dyn Fn() -> Measured + Send + Sync>,
}

impl StressCase {
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

/// What came out of a case.
#[derive(Clone, Copy, Debug)]
pub struct StressResult<'a> {
    /// The case.
    pub case: &'a StressCase,
    /// The numbers.
    pub measured: Measured,
    /// Whether `faithful` keeps to its bound.
    pub faithful_holds: bool,
    /// Whether `fast` does, if it concerns it.
    pub fast_holds: bool,
}

impl StressResult<'_> {
    /// Whether the expectation holds.
    pub fn holds(&self) -> bool {
        self.faithful_holds && self.fast_holds
    }

    /// Whether plain `f32` code fails so that it can be seen: a result that is no number, or an error of
    /// [`Unit::visible`] or more. Not where `faithful` fails as well, with half of that error or more: what is lost to
    /// storage is lost to both.
    pub fn plain_fails(&self) -> bool {
        let seen = |worst: Worst, unit: Unit| worst.undefined > 0 || worst.error >= unit.visible();
        let faithful = self.measured.faithful;
        self.measured.plain.is_some_and(|plain| {
            let both = seen(faithful, self.case.bound.unit) && plain.error <= 2.0 * faithful.error;
            seen(plain, self.case.plain_unit) && !both
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trade::stress::{cases_of, catalogue};

    #[test]
    fn bounds_are_broken_by_more_and_by_nothing() {
        let bound = Bound::new(1.0, Unit::Ulps, "a test");
        assert!(bound.holds(&Worst { error: 1.0, undefined: 0 }));
        assert!(!bound.holds(&Worst { error: 1.0 + f64::EPSILON, undefined: 0 }));
        assert!(!bound.holds(&Worst { error: f64::INFINITY, undefined: 0 }));
        assert!(!bound.holds(&[0.0, f64::NAN].into_iter().collect()));
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
            assert!(case.bound.most.is_finite() && !case.bound.source.is_empty(), "{case:?}");
            assert!(!case.what.is_empty() && !case.expectation.is_empty() && !case.plain_formula.is_empty());
        }
    }
}
