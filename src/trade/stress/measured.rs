//! The results of a case: their errors, and how many are no numbers or have no direction.

use crate::trade::exact;
use glam::DVec3;

/// A result: its error, or the reason why it has none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Outcome {
    Error(f64),
    NotANumber,
    Infinite,
    /// A vector shorter than half of a unit vector.
    ZeroVector,
}

impl From<f64> for Outcome {
    /// An error; NaN if the result is not a number.
    fn from(error: f64) -> Self {
        if error.is_nan() { Self::NotANumber } else { Self::Error(error) }
    }
}

impl Outcome {
    /// A computed number, and the error of a finite one.
    pub(super) fn number(computed: f64, error: impl FnOnce(f64) -> f64) -> Self {
        if computed.is_infinite() {
            return Self::Infinite;
        }
        if computed.is_nan() { Self::NotANumber } else { Self::Error(error(computed)) }
    }

    /// A computed unit vector, and the error of one with a direction.
    pub(super) fn vector(computed: DVec3, error: impl FnOnce(DVec3) -> f64) -> Self {
        if computed.is_nan() {
            Self::NotANumber
        } else if !computed.is_finite() {
            Self::Infinite
        } else if computed.length() < 0.5 {
            Self::ZeroVector
        } else {
            Self::Error(error(computed))
        }
    }

    /// The angle between a computed unit vector and the true one, in degrees.
    pub(super) fn degrees(computed: DVec3, truth: &exact::Vector) -> Self {
        Self::vector(computed, |computed| exact::degrees_to(computed, truth))
    }
}

/// The worst of many results.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Worst {
    /// The largest error of those that are numbers.
    pub error: f64,
    /// How many results are not a number, or have a component that is not.
    pub nan: usize,
    /// How many other results are infinite.
    pub infinite: usize,
    /// How many unit vectors are zero, or shorter than 1/2.
    pub zero: usize,
}

impl Worst {
    pub(super) fn wrong(count: usize) -> Self {
        Self { error: count as f64, ..Self::default() }
    }

    pub(super) fn not_a_number(count: usize) -> Self {
        Self { nan: count, ..Self::default() }
    }

    /// How many results have no error, as they are no numbers or have no direction.
    pub fn undefined(&self) -> usize {
        self.nan + self.infinite + self.zero
    }

    /// Includes one more result.
    pub(super) fn add(&mut self, outcome: impl Into<Outcome>) {
        match outcome.into() {
            Outcome::Error(error) => self.error = self.error.max(error),
            Outcome::NotANumber => self.nan += 1,
            Outcome::Infinite => self.infinite += 1,
            Outcome::ZeroVector => self.zero += 1,
        }
    }
}

impl<O: Into<Outcome>> FromIterator<O> for Worst {
    fn from_iter<I: IntoIterator<Item = O>>(outcomes: I) -> Self {
        let mut worst = Self::default();
        outcomes.into_iter().for_each(|outcome| worst.add(outcome));
        worst
    }
}

/// The errors of a case.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Measured {
    /// The number of results.
    pub samples: usize,
    /// Errors of [`Precision::Faithful`](crate::normals::Precision), or of `f64` where there is no such choice.
    pub faithful: Worst,
    /// Errors of [`Precision::Fast`](crate::normals::Precision), or of `f32` where there is no such choice.
    pub fast: Option<Worst>,
    /// How many of the samples are out of the range of `fast`, which left them to `faithful`.
    pub declined: usize,
    /// Errors of the formula in plain `f32`.
    pub plain: Option<Worst>,
    /// Errors of the plain formula in exact arithmetic, which are those of its definition. 0 where the reference is that
    /// formula.
    pub definition: Worst,
}

impl Measured {
    /// Pairs of results: of `faithful` and the plain formula.
    pub(super) fn pairs<O: Into<Outcome>>(outcomes: impl IntoIterator<Item = [O; 2]>) -> Self {
        let outcomes = outcomes.into_iter().map(|pair| pair.map(Into::into));
        let outcomes = outcomes.map(|[faithful, plain]| [faithful, Outcome::Error(0.0), plain]);
        Self { fast: None, ..Self::triples(outcomes) }
    }

    /// Triples of results: of `faithful`, `fast` and the plain formula.
    pub(super) fn triples<O: Into<Outcome>>(outcomes: impl IntoIterator<Item = [O; 3]>) -> Self {
        let (mut samples, mut worst) = (0, [Worst::default(); 3]);
        for triple in outcomes {
            samples += 1;
            worst.iter_mut().zip(triple).for_each(|(worst, outcome)| worst.add(outcome));
        }
        let [faithful, fast, plain] = worst;
        Self { samples, faithful, fast: Some(fast), plain: Some(plain), ..Self::default() }
    }

    /// Numbers of wrong results: of `faithful`, of the plain formula, and of the same in exact arithmetic.
    pub(super) fn wrong(samples: usize, wrong: [usize; 3]) -> Self {
        let [faithful, plain, definition] = wrong.map(Worst::wrong);
        Self { samples, faithful, plain: Some(plain), definition, ..Self::default() }
    }

    /// The same of a plain formula that has no other result in exact arithmetic.
    pub(super) fn by_definition(self) -> Self {
        Self { definition: self.plain.unwrap_or_default(), ..self }
    }
}
