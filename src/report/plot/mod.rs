//! Plots as SVG: points, lines and bars over linear or logarithmic axes, with a legend.

// Axes and their ticks.
mod axis;
// A plot and its series of points, and styles in which series differ in colour, and without it in dashes and signs.
mod series;
// The plot as SVG.
mod draw;
// A plot as pixels.
mod picture;
// Assertions for tests of all plots: no text overlaps another, and series differ without colour.
#[cfg(test)]
mod legibility_tests;
// Tests.
#[cfg(test)]
mod tests;

pub use axis::{Axis, Scale};
pub use series::{Mark, Plot, Series};
