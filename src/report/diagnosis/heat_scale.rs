//! The colours of deviations.

use crate::num::{Degrees, LinearRgb, Srgb8, three_digits, viridis};
use crate::quality::Survey;

/// The colour of corners without a valid stored normal; not on the scale.
pub(super) const ABSENT: Srgb8 = Srgb8([240, 80, 200]);

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct HeatScale {
    /// The deviation at the light end.
    pub(super) full: Degrees,
    /// The largest deviation, if it is above that.
    beyond: Option<Degrees>,
    /// Some corners have a deviation.
    pub(super) is_used: bool,
    /// Some corners have none.
    pub(super) is_absent: bool,
}

impl HeatScale {
    /// Round angles that scales end at. Deviations below the first are not visible in a picture.
    const ENDS: [f64; 11] = [1.0, 2.0, 5.0, 10.0, 15.0, 20.0, 30.0, 45.0, 60.0, 90.0, 180.0];

    /// The first round angle that at most one deviation in two hundred exceeds, so that single faults do not compress the
    /// colours of all others.
    pub(super) fn of<'a>(surveys: impl Iterator<Item = &'a Survey>) -> Self {
        let corners: Vec<Option<f64>> = surveys.flat_map(|survey| &survey.deviations).copied().collect();
        let mut all: Vec<f64> = corners.iter().copied().flatten().collect();
        all.sort_unstable_by(f64::total_cmp);
        let nearly_all = all.iter().rev().nth(all.len() / 200).copied().unwrap_or_default();
        let full = Self::ENDS.into_iter().find(|&end| end >= nearly_all).unwrap_or(180.0);
        // Labels have three digits: 90.0004° is not beyond 90°.
        let is_beyond = |largest: &&f64| **largest > full && three_digits(**largest) != three_digits(full);
        Self {
            full: Degrees(full),
            beyond: all.last().filter(is_beyond).map(|&largest| Degrees(largest)),
            is_used: !all.is_empty(),
            is_absent: all.len() < corners.len(),
        }
    }

    pub(super) fn colour(self, deviation: Option<f64>) -> LinearRgb {
        deviation.map_or(LinearRgb::from(ABSENT), |degrees| viridis(degrees / self.full.0))
    }

    /// The labels at the light end and in the middle.
    pub(super) fn labels(self) -> [String; 2] {
        let more = |it: Degrees| format!(" and more, up to {}°", three_digits(it.0));
        [
            format!("{}°{}", self.full.0, self.beyond.map_or(String::new(), more)),
            format!("{}°", self.full.0 / 2.0),
        ]
    }

    /// The same in words, for those who cannot see it.
    pub(super) fn words(self) -> String {
        let scale = format!("from violet, 0°, to yellow, {}", self.labels()[0]);
        match (self.is_used, self.is_absent) {
            (true, true) => format!("{scale}; pink where no normal is stored that has a direction"),
            (false, true) => "pink all over: no normal is stored that has a direction".into(),
            _ => scale,
        }
    }
}

/// The deviation of a corner as a colour to be interpolated: degrees, and 1 in green for a deviation or in blue for none.
pub(super) fn encode(deviation: Option<f64>) -> LinearRgb {
    deviation.map_or(LinearRgb::new(0.0, 0.0, 1.0), |degrees| LinearRgb::new(degrees, 1.0, 0.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scales_end_where_the_data_does() {
        let scale = |deviations: Vec<f64>| {
            let deviations = deviations.into_iter().map(Some).collect();
            HeatScale::of([Survey { deviations, ..Survey::default() }].iter())
        };
        assert_eq!(scale(vec![]).labels(), ["1°", "0.5°"]);
        assert_eq!(scale(vec![0.0, 3.0]).labels(), ["5°", "2.5°"]);
        assert_eq!(scale(vec![30.0; 7]).labels(), ["30°", "15°"]);
        // One in two hundred is left out, two are not.
        let with = |count: usize| [vec![0.0; 200 - count], vec![180.0; count]].concat();
        assert_eq!(scale(with(1)).words(), "from violet, 0°, to yellow, 1° and more, up to 180°");
        let rounded = [vec![90.0; 400], vec![90.0 + 1e-9]].concat();
        assert_eq!(scale(rounded).words(), "from violet, 0°, to yellow, 90°");
        assert_eq!(scale(with(2)).words(), "from violet, 0°, to yellow, 180°");
    }

    #[test]
    fn what_has_no_deviation_has_a_colour_of_its_own() {
        let of =
            |deviations: Vec<Option<f64>>| HeatScale::of([Survey { deviations, ..Survey::default() }].iter());
        let scale = of(vec![Some(3.0), None]);
        assert_eq!(scale.colour(None), LinearRgb::from(ABSENT));
        assert_eq!(
            scale.words(),
            "from violet, 0°, to yellow, 5°; pink where no normal is stored that has a direction"
        );
        assert_eq!(of(vec![None]).words(), "pink all over: no normal is stored that has a direction");
    }
}
