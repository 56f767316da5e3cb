//! Histograms of the survey of a file.

use super::texts::Texts;
use crate::quality::Survey;
use crate::report::plot::{Axis, Mark, Plot, Series};
use crate::text::Value;

const BINS: usize = 60;

/// The histograms of some parts together, each with a name and a caption.
pub(super) fn histograms(surveys: &[Survey], texts: Texts) -> Vec<(&'static str, String, Plot)> {
    let all =
        |values: fn(&Survey) -> &Vec<f64>| surveys.iter().flat_map(values).copied().collect::<Vec<f64>>();
    let deviations: Vec<f64> =
        surveys.iter().flat_map(|survey| &survey.deviations).copied().flatten().collect();
    let largest = |values: &[f64], least: f64| values.iter().copied().fold(least, f64::max);
    let (valences, lengths) = (all(|survey| &survey.valences), all(|survey| &survey.edge_lengths));
    let count = deviations.len();
    let ends = [largest(&deviations, 1.0), largest(&valences, 12.0), largest(&lengths, 3.0).min(10.0)];
    let mut plots = [
        ("deviation", deviations, ends[0]),
        ("dihedral-angle", all(|survey| &survey.bends), 180.0),
        ("corner-angle", all(|survey| &survey.corner_angles), 180.0),
        ("valence", valences, ends[1]),
        ("edge-length", lengths, ends[2]),
    ]
    .map(|(name, values, end)| (name, texts.of(name, "caption"), histogram(name, &values, end, texts)));
    plots[0].2 = counted(plots[0].2.clone(), count, &texts.get("histogram-corners"));
    plots.into()
}

/// A histogram of shares as one of counts, by powers of ten: of a million, one shows.
fn counted(mut plot: Plot, all: usize, unit: &str) -> Plot {
    /// The height of an empty bin.
    const NONE: f64 = 0.5;
    let points = plot.series.iter_mut().flat_map(|series| &mut series.points);
    let highest = points.fold(1.0, |most: f64, [_, share]| {
        *share = (*share * all as f64 / 100.0).round().max(NONE);
        most.max(*share)
    });
    plot.y = Axis { range: Some([NONE, 2.0 * highest]), ..Axis::log(unit) };
    plot
}

fn histogram(name: &str, values: &[f64], end: f64, texts: Texts) -> Plot {
    /// The share of a bin that a value may be below its edge by rounding: right angles belong in one bin.
    const ROUNDED: f64 = 1e-3;
    let mut counts = [0usize; BINS];
    for value in values.iter().filter(|value| value.is_finite()) {
        counts[((value / end * BINS as f64 + ROUNDED) as usize).min(BINS - 1)] += 1;
    }
    let edge = |bin: usize| bin as f64 * end / BINS as f64;
    let all = values.len().max(1) as f64;
    let mut points: Vec<[f64; 2]> =
        counts.iter().enumerate().map(|(bin, &count)| [edge(bin), 100.0 * count as f64 / all]).collect();
    points.push([end, 0.0]);
    let fullest = counts.iter().enumerate().max_by_key(|(_, count)| **count).map_or(0, |(bin, _)| bin);
    let unit = texts.of(name, "unit");
    let share = format!("{:.1}", 100.0 * counts[fullest] as f64 / all);
    let [from, to] = [fullest, fullest + 1].map(|bin| Value::digits(&format!("{:.3}", edge(bin))));
    Plot {
        title: texts.of(name, "title"),
        description: texts.with(
            "histogram-words",
            &[
                ("count", values.len().into()),
                ("share", Value::digits(&share)),
                ("from", from),
                ("to", to),
                ("unit", unit.as_str().into()),
            ],
        ),
        x: Axis { range: Some([0.0, end]), ..Axis::linear(&unit) },
        y: Axis::linear(&texts.get("histogram-share")),
        series: vec![Series::new("", points, Mark::Steps)],
        ..Plot::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::Language;

    const ENGLISH: Texts = Texts(Language::English);

    /// The angles of a cube are no two kinds of angles.
    #[test]
    fn right_angles_stand_in_one_bin() {
        let plot = histogram("corner-angle", &[89.9999, 90.0, 90.0001], 180.0, ENGLISH);
        assert_eq!(plot.series[0].points[BINS / 2], [90.0, 100.0]);
    }

    /// One of a million is higher than none, which stands at the end of the axis.
    #[test]
    fn one_of_many_shows() {
        let mut values = vec![0.0; 999_999];
        values.push(90.0);
        let plot = counted(histogram("corner-angle", &values, 180.0, ENGLISH), values.len(), "corners");
        let heights: Vec<f64> = plot.series[0].points.iter().map(|point| point[1]).collect();
        assert_eq!((heights[0], heights[BINS / 2], heights[1]), (999_999.0, 1.0, 0.5));
        assert_eq!(plot.y.range, Some([0.5, 1_999_998.0]));
    }

    #[test]
    fn every_value_is_in_a_bin() {
        let plot = histogram("corner-angle", &[0.0, 10.0, 180.0, 200.0], 180.0, ENGLISH);
        let share: f64 = plot.series[0].points.iter().map(|point| point[1]).sum();
        assert!((share - 100.0).abs() < 1e-9);
        assert_eq!((plot.series[0].points[0][1], plot.series[0].points[BINS - 1][1]), (25.0, 50.0));
    }
}
