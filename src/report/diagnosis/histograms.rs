//! Histograms of the survey of a file.

use crate::quality::Survey;
use crate::report::plot::{Axis, Mark, Plot, Series};

/// Bins of a histogram.
const BINS: usize = 60;

/// The histograms of some parts together, each with a name and a caption.
pub(super) fn histograms(surveys: &[Survey]) -> Vec<(&'static str, &'static str, Plot)> {
    let all =
        |values: fn(&Survey) -> &Vec<f64>| surveys.iter().flat_map(values).copied().collect::<Vec<f64>>();
    let deviations: Vec<f64> =
        surveys.iter().flat_map(|survey| &survey.deviations).copied().flatten().collect();
    let farthest = deviations.iter().copied().fold(1.0, f64::max);
    let valences = all(|survey| &survey.valences);
    let most = valences.iter().copied().fold(12.0, f64::max);
    let lengths = all(|survey| &survey.edge_lengths);
    let longest = lengths.iter().copied().fold(3.0, f64::max).min(10.0);
    vec![
        (
            "deviation",
            "Right normals stand at the left end; faults stand apart from it, by powers of ten, so that a single corner shows. What \
             has no direction is left out.",
            counted(
                histogram("Deviation of stored normals", "degrees", &deviations, farthest),
                deviations.len(),
            ),
        ),
        (
            "dihedral angle",
            "A gap between gentle and sharp edges is where a crease angle belongs.",
            histogram("How far edges bend", "degrees", &all(|survey| &survey.bends), 180.0),
        ),
        (
            "corner angle",
            "Many near 0° or 180°: needles, whose normals are easily off.",
            histogram(
                "Angles of faces at their corners",
                "degrees",
                &all(|survey| &survey.corner_angles),
                180.0,
            ),
        ),
        (
            "valence",
            "How many faces meet at a vertex; poles stand far to the right.",
            histogram("Faces round a vertex", "faces", &valences, most),
        ),
        (
            "edge length",
            "Over the median; what is longer than ten times is counted in the last bin.",
            histogram("Lengths of edges", "median lengths", &lengths, longest),
        ),
    ]
}

/// A histogram of shares as one of counts, by powers of ten: of a million, one shows.
fn counted(mut plot: Plot, all: usize) -> Plot {
    /// The height of an empty bin.
    const NONE: f64 = 0.5;
    let points = plot.series.iter_mut().flat_map(|series| &mut series.points);
    let highest = points.fold(1.0, |most: f64, [_, share]| {
        *share = (*share * all as f64 / 100.0).round().max(NONE);
        most.max(*share)
    });
    plot.y = Axis { range: Some([NONE, 2.0 * highest]), ..Axis::log("corners") };
    plot
}

fn histogram(title: &str, unit: &str, values: &[f64], end: f64) -> Plot {
    /// The share of a bin that a value may be below its edge by rounding: right angles are to stand in one bin.
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
    Plot {
        title: title.to_owned(),
        description: format!(
            "A histogram of {} values; most, {:.1} %, lie between {:.3} and {:.3} {unit}.",
            values.len(),
            100.0 * counts[fullest] as f64 / all,
            edge(fullest),
            edge(fullest + 1)
        ),
        size: [560, 260],
        x: Axis { range: Some([0.0, end]), ..Axis::linear(unit) },
        y: Axis::linear("per cent"),
        series: vec![Series { points, mark: Mark::Steps, ..Series::default() }],
        ..Plot::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The angles of a cube are no two kinds of angles.
    #[test]
    fn right_angles_stand_in_one_bin() {
        let plot = histogram("t", "degrees", &[89.9999, 90.0, 90.0001], 180.0);
        assert_eq!(plot.series[0].points[BINS / 2], [90.0, 100.0]);
    }

    /// One of a million is higher than none, which stands at the end of the axis.
    #[test]
    fn one_of_many_shows() {
        let mut values = vec![0.0; 999_999];
        values.push(90.0);
        let plot = counted(histogram("t", "degrees", &values, 180.0), values.len());
        let heights: Vec<f64> = plot.series[0].points.iter().map(|point| point[1]).collect();
        assert_eq!((heights[0], heights[BINS / 2], heights[1]), (999_999.0, 1.0, 0.5));
        assert_eq!(plot.y.range, Some([0.5, 1_999_998.0]));
    }

    #[test]
    fn every_value_is_in_a_bin() {
        let plot = histogram("t", "degrees", &[0.0, 10.0, 180.0, 200.0], 180.0);
        let share: f64 = plot.series[0].points.iter().map(|point| point[1]).sum();
        assert!((share - 100.0).abs() < 1e-9);
        assert_eq!((plot.series[0].points[0][1], plot.series[0].points[BINS - 1][1]), (25.0, 50.0));
    }
}
