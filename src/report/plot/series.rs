//! A plot and its series of points.

use super::axis::Axis;

/// A plot.
///
/// Series differ in colour (those of Okabe & Ito, which the colour-blind can distinguish), in their signs and in their dashes,
/// so that a plot can be read in black and white. The left margin has room for the widest number.
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
#[derive(Clone, Debug, PartialEq)]
pub struct Plot {
    /// The title.
    pub title: String,
    /// A description in words, for those who cannot see it.
    pub description: String,
    /// Width and height in pixels of the page, legend included.
    pub size: [u32; 2],
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// The data.
    pub series: Vec<Series>,
    /// The decimal mark of numbers along the axes: a point, or in other languages than English a comma.
    pub decimal_mark: char,
}

impl Default for Plot {
    /// Empty, with linear axes, 760 × 420.
    fn default() -> Self {
        Self {
            title: String::new(),
            description: String::new(),
            size: [760, 420],
            x: Axis::default(),
            y: Axis::default(),
            series: Vec::new(),
            decimal_mark: '.',
        }
    }
}

/// A series of points.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Series {
    /// Its name in the legend; empty for none.
    pub name: String,
    /// x and y. Points that are not finite, or not positive on a logarithmic axis, are omitted.
    pub points: Vec<[f64; 2]>,
    /// Labels next to the points, in their order.
    pub labels: Vec<String>,
    /// How the points are drawn.
    pub mark: Mark,
    /// The number of one of eight colours, modulo eight; by default the position among the series.
    pub colour: Option<usize>,
}

/// How a series is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mark {
    /// A sign at each point.
    #[default]
    Points,
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
