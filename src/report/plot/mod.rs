//! Plots as SVG, written plainly: points, lines and bars over linear or logarithmic axes, with a legend.

mod axis;
#[cfg(test)]
mod checks;
mod draw;
mod legend;
mod look;

pub use axis::{Axis, Scale};

/// A plot.
///
/// Series differ in colour (those of Okabe & Ito, which the colour-blind tell apart), in their signs and in their dashes, so
/// that a plot can be read in black and white. To the left there is room for the widest number.
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
    /// What it is called.
    pub title: String,
    /// What it shows, in words, for those who cannot see it.
    pub description: String,
    /// Width and height in pixels of the page, legend included.
    pub size: [u32; 2],
    /// Across.
    pub x: Axis,
    /// Upwards.
    pub y: Axis,
    /// What is shown.
    pub series: Vec<Series>,
    /// What stands before the decimals of numbers along the axes: a point, or in other languages than English a comma.
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

/// Points that belong together.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Series {
    /// Its name in the legend; empty for none.
    pub name: String,
    /// x and y. What is not finite, or not positive on a logarithmic axis, is left out.
    pub points: Vec<[f64; 2]>,
    /// Names beside the points, if there are as many as those.
    pub labels: Vec<String>,
    /// How they are drawn.
    pub mark: Mark,
    /// Which of eight colours, counted round; by default its place among the series.
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
    /// A line through many points; a few signs say which.
    Curve,
    /// A grey dashed line of steps without signs: the border of what others are better than.
    Frontier,
    /// A dotted grey line: a slope to compare with. The first of a plot has no signs, others a few hollow ones.
    Guide,
    /// The outline of bars that begin at each point's x and end at the next one's: a histogram. The last y is not used.
    Steps,
}

impl Plot {
    /// The plot as an element of a page; parts of it get ids that begin with the given one and a dot.
    pub fn svg(&self, id: &str) -> String {
        draw::svg(self, id)
    }

    /// A number along an axis with the plot's decimal mark.
    fn written(&self, number: String) -> String {
        match self.decimal_mark {
            '.' => number,
            mark => number.replace('.', &mark.to_string()),
        }
    }
}

#[cfg(test)]
mod tests;
