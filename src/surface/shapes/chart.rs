//! Surfaces by two parameters.

use crate::num::UnitVec3;
use glam::DVec3;
use std::f64::consts::TAU;

/// A point of a surface with its exact normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Where it is.
    pub position: DVec3,
    /// The normal there: outward, or to the front.
    pub normal: UnitVec3,
}

/// How the edges of the square of parameters lie on a surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Chart {
    /// The side u = 1 is the side u = 0.
    pub wraps_u: bool,
    /// The side v = 1 is the side v = 0.
    pub wraps_v: bool,
    /// All of the side v = 0 is one point.
    pub pole_low: bool,
    /// All of the side v = 1 is one point.
    pub pole_high: bool,
}

impl Chart {
    /// Four sides, none of which meets itself or another.
    pub const SHEET: Self = Self { wraps_u: false, wraps_v: false, pole_low: false, pole_high: false };
    /// Closed around the axis, open at both ends.
    pub const TUBE: Self = Self { wraps_u: true, ..Self::SHEET };
    /// Closed around the axis and at both ends.
    pub const BALL: Self = Self { pole_low: true, pole_high: true, ..Self::TUBE };
    /// Closed both ways.
    pub const RING: Self = Self { wraps_v: true, ..Self::TUBE };
}

/// A surface by two parameters u and v from 0 to 1, such that ∂u × ∂v points along the normal.
pub trait Parametric: Sync {
    /// How the sides of the square lie.
    fn chart(&self) -> Chart;

    /// The point of two parameters, any numbers where the chart wraps; `None` where the surface has no normal.
    fn at(&self, u: f64, v: f64) -> Option<Sample>;
}

/// Sine and cosine of a part of a full turn. Quarter turns are exact, whole turns change no bit, and points at the same
/// position in different octants have the same digits.
pub(crate) fn circle(turns: f64) -> (f64, f64) {
    let turns = turns - turns.round();
    let quarters = (4.0 * turns).round();
    let (sin, cos) = libm::sincos(TAU * (turns - quarters / 4.0));
    match quarters as i32 {
        0 => (sin, cos),
        1 => (cos, -sin),
        -1 => (-cos, sin),
        _ => (-sin, -cos),
    }
}

/// The point at a part of a full turn on the circle of a radius and a height about the y axis, from +z towards +x.
pub(crate) fn on_circle(turns: f64, radius: f64, height: f64) -> DVec3 {
    let (sin, cos) = circle(turns);
    DVec3::new(radius * sin, height, radius * cos)
}

/// The point of the unit sphere at a part of a full turn and at a latitude from the −y pole (0) to the +y pole (1).
pub(crate) fn on_sphere(u: f64, v: f64) -> DVec3 {
    let (height, radius) = circle((v - 0.5) / 2.0);
    on_circle(u, radius, height)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarters_of_the_circle_are_exact_and_octants_agree() {
        for (turns, expected) in [
            (0.0, (0.0, 1.0)),
            (0.25, (1.0, 0.0)),
            (0.5, (0.0, -1.0)),
            (0.75, (-1.0, 0.0)),
            (-3.0, (0.0, 1.0)),
        ] {
            assert_eq!(circle(turns), expected, "{turns}");
        }
        for i in 0..=64 {
            let turns = f64::from(i) / 256.0;
            let (sin, cos) = circle(turns);
            assert!(
                (sin - libm::sin(TAU * turns)).abs() < 2e-16 && (cos - libm::cos(TAU * turns)).abs() < 2e-16
            );
            assert_eq!(circle(turns + 0.25), (cos, -sin));
            assert_eq!(circle(-turns), (-sin, cos));
            assert_eq!(circle(turns + 7.0), (sin, cos));
            // The middle of a quarter is the end of two octants and computed by one of them.
            if i != 32 {
                assert_eq!(circle(0.25 - turns), (cos, sin));
            }
        }
    }
}
