//! Axes: their scale, ends and ticks.

use crate::num::powers_of_ten;

/// The scale of an axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scale {
    /// Linear.
    #[default]
    Linear,
    /// Logarithmic.
    Log,
}

/// An axis of a plot.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Axis {
    /// The label, with the unit.
    pub label: String,
    /// The scale.
    pub scale: Scale,
    /// The ends; by default those of the points.
    pub range: Option<[f64; 2]>,
}

impl Axis {
    /// A linear axis.
    pub fn linear(label: &str) -> Self {
        Self { label: label.to_owned(), ..Self::default() }
    }

    /// A logarithmic axis.
    pub fn log(label: &str) -> Self {
        Self { label: label.to_owned(), scale: Scale::Log, range: None }
    }

    /// Whether a number can be shown on the axis.
    pub(super) fn takes(&self, x: f64) -> bool {
        x.is_finite() && (self.scale == Scale::Linear || x > 0.0)
    }

    pub(super) fn fit(&self, numbers: impl Iterator<Item = f64>) -> Fitted {
        let found = numbers.fold(None, |ends: Option<[f64; 2]>, x| {
            Some(ends.map_or([x, x], |[low, high]| [low.min(x), high.max(x)]))
        });
        let given =
            self.range.filter(|range| range.iter().all(|&end| self.takes(end)) && range[0] < range[1]);
        let [low, high] = given.or(found).unwrap_or([1.0, 10.0]).map(|x| self.scale.place(x));
        // A single number gets room on both sides; others a little, and as much as keeps labels to four digits where they
        // are nearly equal; unless the ends were given.
        let least = match self.scale {
            Scale::Linear => 0.005 * low.abs().max(high.abs()),
            Scale::Log => 0.003,
        };
        let room = match high > low {
            true => f64::max(0.04 * (high - low), least - 0.5 * (high - low)),
            false => 0.5 * low.abs().max(1.0),
        };
        let room = if given.is_some() { 0.0 } else { room };
        Fitted { scale: self.scale, low: low - room, high: high + room }
    }
}

impl Scale {
    /// The coordinate of a number, in numbers or decades.
    fn place(self, x: f64) -> f64 {
        match self {
            Scale::Linear => x,
            Scale::Log => libm::log10(x),
        }
    }
}

pub(super) struct Fitted {
    scale: Scale,
    low: f64,
    high: f64,
}

impl Fitted {
    /// The position of a number, as a share of the axis.
    pub(super) fn share(&self, x: f64) -> f64 {
        (self.scale.place(x) - self.low) / (self.high - self.low)
    }

    pub(super) fn ticks(&self) -> Vec<(f64, String)> {
        match self.scale {
            Scale::Linear => self.even_ticks(),
            Scale::Log if self.high - self.low < 0.8 => {
                // Less than a decade: as if it were linear, between the same ends.
                let [low, high] = [self.low, self.high].map(libm::exp10);
                Fitted { scale: Scale::Linear, low, high }.even_ticks()
            }
            Scale::Log => self.decades(),
        }
    }

    /// Multiples of 1, 2 or 5 times a power of ten: four to ten of them.
    fn even_ticks(&self) -> Vec<(f64, String)> {
        let length = self.high - self.low;
        let decade = libm::floor(libm::log10(length / 5.0));
        let step = [1.0, 2.0, 5.0, 10.0].into_iter().map(|factor| factor * libm::exp10(decade));
        let step = step.into_iter().find(|step| length / step <= 8.0).unwrap_or(length);
        let decimals = (-libm::floor(libm::log10(step))).max(0.0) as usize;
        let (first, last) = (libm::ceil(self.low / step) as i64, libm::floor(self.high / step) as i64);
        // All in one form: that of the largest.
        let largest = step * first.abs().max(last.abs()) as f64;
        let has_powers = decimals > 4 && largest < SMALL;
        (first..=last)
            .map(|k| {
                let x = k as f64 * step;
                let text = format!("{x:.decimals$}");
                // From the decimal text, as products of a step have digits of their own.
                (x, if has_powers { short(text.parse().unwrap_or(x)) } else { powers_of_ten(&text) })
            })
            .collect()
    }

    /// Powers of ten, written every so many; between them 2 and 5 if there is room.
    fn decades(&self) -> Vec<(f64, String)> {
        let (first, last) = (libm::floor(self.low) as i32, libm::ceil(self.high) as i32);
        let spread = self.high - self.low;
        let every = (spread / 8.0).ceil().max(1.0) as i32;
        let mut ticks = Vec::new();
        for decade in first..=last {
            for factor in [1.0, 2.0, 5.0] {
                // From the decimal text, so that the number is the nearest one there is.
                let x: f64 = format!("{factor}e{decade}").parse().unwrap_or(1.0);
                let inside = (self.low..=self.high).contains(&libm::log10(x));
                let written = (factor == 1.0 && decade.rem_euclid(every) == 0) || spread < 2.5;
                if inside && (factor == 1.0 || spread < 4.0) {
                    ticks.push((x, if written { short(x) } else { String::new() }));
                }
            }
        }
        ticks
    }
}

/// Smaller numbers are written with powers of ten.
const SMALL: f64 = 0.001;

/// A number in few characters, with a power of ten where it would be long.
fn short(x: f64) -> String {
    match x.abs() {
        0.0 => return "0".into(),
        magnitude if (SMALL..100_000.0).contains(&magnitude) => return format!("{x}"),
        _ => {}
    }
    powers_of_ten(&format!("{x:e}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(axis: &Axis, numbers: &[f64]) -> Vec<String> {
        let ticks = axis.fit(numbers.iter().copied()).ticks();
        ticks.into_iter().map(|(_, text)| text).filter(|text| !text.is_empty()).collect()
    }

    #[test]
    fn ticks_are_round_numbers() {
        assert_eq!(written(&Axis::linear(""), &[0.0, 1.0]), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(written(&Axis::linear(""), &[-3.0, 40.0]), ["0", "10", "20", "30", "40"]);
        assert_eq!(written(&Axis::linear(""), &[-1.0, 1.0]), ["−1.0", "−0.5", "0.0", "0.5", "1.0"]);
        let decades = ["10⁻⁸", "10⁻⁶", "10⁻⁴", "0.01", "1"];
        assert_eq!(written(&Axis::log(""), &[1e-9, 1.0]), decades);
        let around = ["−2 × 10⁻⁵", "−10⁻⁵", "0", "10⁻⁵", "2 × 10⁻⁵"];
        assert_eq!(written(&Axis::linear(""), &[-2e-5, 2e-5]), around);
        let thousandths = ["0.00096", "0.00098", "0.00100", "0.00102", "0.00104"];
        assert_eq!(written(&Axis::linear(""), &[0.000_96, 0.001_04]), thousandths);
        assert_eq!(written(&Axis::log(""), &[1e5, 1e7])[..3], ["10⁵", "2 × 10⁵", "5 × 10⁵"]);
        assert_eq!(written(&Axis::log(""), &[1.0, 60.0]), ["1", "2", "5", "10", "20", "50"]);
        assert_eq!(written(&Axis::log(""), &[2.0, 4.0]), ["2.0", "2.5", "3.0", "3.5", "4.0"]);
    }

    /// Errors of a mesh that no weight does well at: labels were `89.988648`, wider than the margin.
    #[test]
    fn numbers_that_are_nearly_equal_get_short_labels() {
        for axis in [Axis::linear(""), Axis::log("")] {
            for numbers in [[89.988_648, 89.988_652], [1e-3, 1.000_001e-3], [12_345.0, 12_345.1]] {
                let labels = written(&axis, &numbers);
                assert!(labels.len() >= 2 && labels.iter().all(|label| label.len() <= 8), "{labels:?}");
            }
        }
    }

    #[test]
    fn every_number_lies_within_its_axis() {
        for (axis, numbers) in [
            (Axis::linear(""), vec![3.0]),
            (Axis::linear(""), vec![0.0]),
            (Axis::log(""), vec![1e-300, 1e300]),
            (Axis::log(""), vec![7.0]),
            (Axis::log(""), Vec::new()),
        ] {
            let fitted = axis.fit(numbers.iter().copied());
            assert!(numbers.iter().all(|&x| (0.0..=1.0).contains(&fitted.share(x))), "{numbers:?}");
            assert!(fitted.ticks().iter().all(|&(x, _)| (-1e-9..=1.0 + 1e-9).contains(&fitted.share(x))));
            assert!(!fitted.ticks().is_empty());
        }
        let given = Axis { range: Some([0.0, 2.0]), ..Axis::linear("") }.fit([9.0].into_iter());
        assert_eq!((given.share(0.0), given.share(2.0)), (0.0, 1.0));
    }
}
