//! A plot and its series of points, and styles in which series differ in colour, and without it in dashes and signs.

use super::axis::Axis;
use crate::text::Language;
use std::fmt::Write;

/// A plot.
///
/// Series differ in colour (those of Okabe & Ito, which the colour-blind can distinguish), in their signs and in their dashes,
/// so that a plot can be read in black and white. Its text is legible 390 pixels wide, on a telephone: long labels are broken,
/// and names of series are below the plot.
///
/// ```
/// use crease::report::{Axis, Mark, Plot, Series};
///
/// let points = vec![[1.0, 0.1], [2.0, 0.026], [4.0, 0.006]];
/// let plot = Plot {
///     title: "Error against cost".into(),
///     description: "The error falls as the square of the cost.".into(),
///     x: Axis::log("ns per triangle"),
///     y: Axis::log("degrees"),
///     series: vec![Series { name: "max".into(), points, mark: Mark::Line, ..Series::default() }],
///     ..Plot::default()
/// };
/// assert!(plot.svg("cost").starts_with("<svg role=\"img\""));
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Plot {
    /// The title.
    pub title: String,
    /// A description in words, for those who cannot see it.
    pub description: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// The data.
    pub series: Vec<Series>,
    /// The language of numbers along the axes.
    pub language: Language,
}

/// A series of points.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Series {
    /// Its name in the legend; empty for none.
    pub name: String,
    /// x and y. Points that are not finite, or not positive on a logarithmic axis, are omitted.
    pub points: Vec<[f64; 2]>,
    /// How the points are drawn.
    pub mark: Mark,
    /// The number of one of eight colours, modulo eight; by default the position among the series.
    pub colour: Option<usize>,
}

impl Series {
    /// Points drawn in one way, in the colour of the series' position.
    pub fn new(name: &str, points: Vec<[f64; 2]>, mark: Mark) -> Self {
        Self { name: name.to_owned(), points, mark, colour: None }
    }
}

/// How a series is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mark {
    /// A sign at each point.
    #[default]
    Points,
    /// A hollow sign at each point.
    Hollow,
    /// Signs, and straight lines between one and the next.
    Line,
    /// A line through many points, with a few signs.
    Curve,
    /// A grey dashed line of steps without signs: a Pareto frontier.
    Frontier,
    /// A dotted grey line: a slope to compare with. The first of a plot has no signs, others a few hollow ones.
    Guide,
    /// The outline of bars that begin at each point's x and end at the next one's: a histogram. The last y is not used.
    Steps,
}

/// The colours of M. Okabe and K. Ito, *Color universal design*, 2002. A brown replaces their yellow, too light on white; it
/// differs from the others and the grey of guides without full colour vision too.
const COLOURS: [&str; 8] =
    ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#000000", "#e69f00", "#56b4e9", "#663311"];
const GREY: &str = "#767676";
/// Lengths of dashes and gaps, in pixels. There are five and six signs, so that thirty series differ in one of them.
const DASHES: [&str; 5] = ["none", "9 4", "5 3", "10 3 2 3", "6 3 2 3 2 3"];
const FRONTIER: &str = "6 4";
/// Of guides: others than those of curves.
const GUIDES: [&str; 3] = ["2 4", "12 6", "12 4 2 4"];

pub(super) const SIGN: f64 = 4.0;
const SIGNS: usize = 6;
/// How many signs a curve has.
const FEW: usize = 4;

#[derive(Clone, Copy, Debug)]
pub(super) struct SeriesStyle {
    pub(super) colour: &'static str,
    /// The dashes as in SVG; not used for points.
    pub(super) dash: &'static str,
    /// The number of its sign, if it has one.
    sign: Option<usize>,
    filling: &'static str,
    /// Its number, which shifts the signs of a curve against those of its neighbours.
    number: usize,
}

/// The styles of all series of a plot. The first guide is a dotted line; others have hollow signs, of the form that the curve of
/// the same number has.
pub(super) fn series_styles(all: &[Series]) -> Vec<SeriesStyle> {
    let mut guides = 0_usize;
    let style = |(place, series): (usize, &Series)| match series.mark {
        Mark::Frontier => {
            SeriesStyle { colour: GREY, dash: FRONTIER, sign: None, filling: GREY, number: place }
        }
        Mark::Guide => {
            guides += 1;
            let number = guides - 1;
            let sign = (number > 0).then_some(number % SIGNS);
            SeriesStyle { colour: GREY, dash: GUIDES[number % GUIDES.len()], sign, filling: "#fff", number }
        }
        _ => {
            let number = series.colour.unwrap_or(place);
            let (colour, dash) = (COLOURS[number % COLOURS.len()], DASHES[number % DASHES.len()]);
            let sign = (series.mark != Mark::Steps).then_some(number % SIGNS);
            let filling = if series.mark == Mark::Hollow { "#fff" } else { colour };
            SeriesStyle { colour, dash, sign, filling, number }
        }
    };
    all.iter().enumerate().map(style).collect()
}

impl SeriesStyle {
    /// The points with a sign, of this number of points: all that were measured, and a few of a curve.
    pub(super) fn signed(&self, mark: Mark, count: usize) -> Vec<usize> {
        match (self.sign, mark) {
            (None, _) => Vec::new(),
            (_, Mark::Points | Mark::Hollow | Mark::Line) => (0..count).collect(),
            _ => {
                // Twice the number modulo five: neighbours are far from each other.
                let first = 0.1 + (2 * self.number % 5) as f64 / 5.0;
                let place = |k: usize| ((k as f64 + first) / FEW as f64 * count as f64) as usize;
                let mut places: Vec<usize> = (0..FEW).map(place).filter(|&place| place < count).collect();
                places.dedup();
                places
            }
        }
    }

    /// One of six signs, which differ in form.
    pub(super) fn draw_sign(&self, out: &mut String, [x, y]: [f64; 2]) {
        let Some(sign) = self.sign else { return };
        let s = SIGN;
        let path = match sign {
            0 => format!("M{:.1} {y:.1}a{s} {s} 0 1 0 {} 0a{s} {s} 0 1 0 {} 0Z", x - s, 2.0 * s, -2.0 * s),
            1 => format!("M{:.1} {:.1}h{}v{}h{}Z", x - s, y - s, 2.0 * s, 2.0 * s, -2.0 * s),
            2 => format!("M{x:.1} {:.1}l{s} {}h{}Z", y - s, 2.0 * s, -2.0 * s),
            3 => format!("M{x:.1} {:.1}l{s} {s}l{} {s}l{} {}Z", y - s, -s, -s, -s),
            4 => format!("M{x:.1} {:.1}l{s} {}h{}Z", y + s, -2.0 * s, -2.0 * s),
            _ => {
                let t = 2.0 * s;
                format!("M{:.1} {:.1}l{t} {t}m0 {}l{} {t}", x - s, y - s, -t, -t)
            }
        };
        let Self { colour, filling, .. } = self;
        let _ = writeln!(
            out,
            "<path d=\"{path}\" fill=\"{filling}\" fill-opacity=\"0.75\" stroke=\"{colour}\" stroke-width=\"1.4\"/>",
        );
    }

    /// The style without colour: the dash of its line, and the sign with whether it is hollow.
    #[cfg(test)]
    pub(super) fn in_grey(&self, mark: Mark) -> (Option<&'static str>, Option<(usize, bool)>) {
        let line = (!matches!(mark, Mark::Points | Mark::Hollow)).then_some(self.dash);
        (line, self.sign.map(|sign| (sign, self.filling != self.colour)))
    }
}
