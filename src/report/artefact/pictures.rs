//! Pictures of experiments: panels, thumbnails, plots.

use crate::artefact::{Chart, Drawn, Experiment, Language, Outcome, Scale, Shot};
use crate::num::Transfer;
use crate::raster::{Image, Pixels};
use crate::report::{Axis, Mark, Panel, Picture, Plot, ReportError, Series, panels};

/// The name of the file that a picture or plot of an experiment is written to, without its ending.
pub fn picture_name(experiment: &Experiment, name: &str) -> String {
    format!("{}-{name}", experiment.id)
}

/// All pictures of an experiment on one sheet, with their labels.
///
/// # Errors
/// If there is no picture.
pub fn experiment_sheet(outcome: &Outcome, language: Language) -> Result<Picture, ReportError> {
    let panel = |shot: &Shot| Panel {
        caption: shot.label.get(language).to_owned(),
        picture: shot.image.clone().into(),
    };
    panels(&outcome.shots.iter().map(panel).collect::<Vec<_>>())
}

/// A chart as a plot.
pub fn chart_plot(chart: &Chart, language: Language) -> Plot {
    let axis = |scale: &Scale| match scale.logarithmic {
        true => Axis::log(scale.label.get(language)),
        false => Axis::linear(scale.label.get(language)),
    };
    let series = chart.curves.iter().map(|curve| {
        let mark = match curve.drawn {
            Drawn::Curve => Mark::Curve,
            Drawn::Points => Mark::Points,
            Drawn::Line => Mark::Line,
            Drawn::Guide => Mark::Guide,
        };
        Series::new(curve.name.get(language), curve.points.clone(), mark)
    });
    Plot {
        title: chart.title.get(language).to_owned(),
        description: chart.caption.get(language).to_owned(),
        x: axis(&chart.x),
        y: axis(&chart.y),
        series: series.collect(),
        decimal_mark: language.decimal_mark(),
        ..Plot::default()
    }
}

/// The side of a thumbnail, at the most.
const THUMBNAIL: u32 = 160;

/// A picture made small by means over squares of pixels, in linear light.
pub(super) fn thumbnail(image: &Image) -> Picture {
    let factor = image.size[0].max(image.size[1]).div_ceil(THUMBNAIL).max(1);
    let size = image.size.map(|side| (side / factor).max(1));
    let linear = image.linear.as_deref().unwrap_or_default();
    let mean = |x: u32, y: u32| {
        let mut sum = [0.0; 3];
        for (row, column) in (0..factor).flat_map(|row| (0..factor).map(move |column| (row, column))) {
            let index = image.index(x * factor + column, y * factor + row);
            let colour = index.and_then(|index| linear.get(index)).copied().unwrap_or_default();
            sum.iter_mut()
                .zip(colour)
                .for_each(|(sum, component)| *sum += f64::from(component.clamp(0.0, 1.0)));
        }
        sum.map(|sum| Transfer::Srgb.to_u8(sum / f64::from(factor * factor)))
    };
    let pixels = (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| (x, y))).map(|(x, y)| mean(x, y));
    Picture { size, pixels: Pixels::Eight(pixels.collect()) }
}
