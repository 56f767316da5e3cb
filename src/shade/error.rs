//! What is refused, where it stands and what to do about it.

use crate::num::{Degrees, LinearRgb, Radians, Real};
use glam::DVec3;
use std::fmt;

/// A number of a light, a material or a setting that makes no sense.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{place}: {field} is {found}; it must be {expected}")]
pub struct ShadeError {
    /// Where it stands.
    pub place: Place,
    /// Which number.
    pub field: &'static str,
    /// What it is.
    pub found: String,
    /// What it should be.
    pub expected: &'static str,
}

/// Where a number of a scene's lighting stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// A light, counted from 0.
    Light(usize),
    /// The material.
    Material,
    /// The settings.
    Settings,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            // People count from 1.
            Place::Light(number) => write!(f, "light {number}"),
            Place::Material => f.write_str("material"),
            Place::Settings => f.write_str("shading"),
        }
    }
}

/// A colour that is infinite or not a number. It is never drawn.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error(
    "no finite colour at ({}, {}, {}) with the normal ({}, {}, {}){}",
    position[0], position[1], position[2], normal[0], normal[1], normal[2], cause(normal, light)
)]
pub struct NotFinite {
    /// Number of the row's element; 0 for a single point.
    pub index: usize,
    /// The point, in the world; NaN where the scene needs no positions.
    pub position: [f64; 3],
    /// Its normal.
    pub normal: [f64; 3],
    /// The first light, counted from 0, whose part of the colour is not finite, if it is one.
    pub light: Option<usize>,
}

fn cause(normal: &[f64; 3], light: &Option<usize>) -> String {
    match light {
        _ if normal.iter().any(|x| !x.is_finite()) => "; the normal is to blame".to_owned(),
        Some(number) => format!(
            "; light {number} is at the point itself, or its distance, attenuation or colour leaves the range of numbers"
        ),
        None => "; so much light leaves the range of numbers".to_owned(),
    }
}

/// Checks of one place.
#[derive(Clone, Copy)]
pub(super) struct Check(pub(super) Place);

impl Check {
    pub(super) fn text(self, field: &'static str, found: String, expected: &'static str) -> ShadeError {
        ShadeError { place: self.0, field, found, expected }
    }

    pub(super) fn degrees(self, field: &'static str, radians: f64, expected: &'static str) -> ShadeError {
        // As it was written: converting to radians and back costs the last digits.
        let degrees = libm::round(Degrees::from(Radians(radians)).0 * 1e9) / 1e9;
        self.text(field, format!("{degrees}°"), expected)
    }

    fn hold(
        self,
        holds: bool,
        field: &'static str,
        found: impl fmt::Display,
        expected: &'static str,
    ) -> Result<(), ShadeError> {
        if holds { Ok(()) } else { Err(self.text(field, found.to_string(), expected)) }
    }

    pub(super) fn not_negative(self, field: &'static str, value: f64) -> Result<(), ShadeError> {
        self.hold(value >= 0.0 && value.is_finite(), field, value, "finite and not negative")
    }

    pub(super) fn positive(self, field: &'static str, value: f64) -> Result<(), ShadeError> {
        self.hold(value > 0.0 && value.is_finite(), field, value, "finite and over 0")
    }

    pub(super) fn colour(self, field: &'static str, colour: LinearRgb) -> Result<(), ShadeError> {
        let LinearRgb { r, g, b } = colour;
        let holds = colour.is_finite() && r >= 0.0 && g >= 0.0 && b >= 0.0;
        self.hold(holds, field, format!("({r}, {g}, {b})"), "of finite components, none of them negative")
    }

    /// Whether a colour, which has been found finite, is so in the precision of `R` too.
    pub(super) fn in_range<R: Real>(self, field: &'static str, colour: LinearRgb) -> Result<(), ShadeError> {
        // As they were typed: without exponent they have hundreds of digits.
        let found = || format!("{:?}", colour.to_array());
        match colour.largest() <= R::MAX.to_f64() {
            true => Ok(()),
            false => Err(self.text(field, found(), "in the range of numbers: 3.4e38 in single precision")),
        }
    }

    pub(super) fn position(self, field: &'static str, position: DVec3) -> Result<(), ShadeError> {
        self.hold(position.is_finite(), field, position, "of finite coordinates")
    }

    pub(super) fn direction(self, field: &'static str, direction: DVec3) -> Result<(), ShadeError> {
        let holds = direction.is_finite() && direction != DVec3::ZERO;
        self.hold(holds, field, direction, "of finite coordinates, and not zero")
    }
}
