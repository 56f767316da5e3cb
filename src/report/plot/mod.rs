//! Plots as SVG: points, lines and bars over linear or logarithmic axes, with a legend.

// Axes and their ticks.
mod axis;
// A plot and its series.
mod series;
// Colours, dashes and signs of series.
mod series_style;
// The plot as SVG.
mod draw;
// Assertions for tests of all plots: no text overlaps another, and series differ without colour.
#[cfg(test)]
mod legibility_tests;
// Tests.
#[cfg(test)]
mod tests;

pub use axis::{Axis, Scale};
pub use series::{Mark, Plot, Series};
