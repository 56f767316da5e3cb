//! Invalid numbers of lights, materials and settings, and colours that are not finite.

use crate::num::{Degrees, LinearRgb, Radians, Real};
use glam::DVec3;
use std::fmt;

pub(super) type Result<T, E = ShadeError> = std::result::Result<T, E>;

/// An invalid number of a light, a material or the settings.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{place}: {field} is {found}; it must be {expected}")]
pub struct ShadeError {
    /// What it belongs to.
    pub place: Place,
    /// Which number.
    pub field: &'static str,
    /// The value that was found.
    pub found: String,
    /// What it should be.
    pub expected: &'static str,
}

/// The part of a scene's lighting that a number belongs to.
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
    /// The first light, counted from 0, with a term that is not finite, if there is one.
    pub light: Option<usize>,
}

fn cause(normal: &[f64; 3], light: &Option<usize>) -> String {
    match light {
        _ if normal.iter().any(|x| !x.is_finite()) => "; the normal is not finite".to_owned(),
        Some(number) => format!(
            "; light {number} is at the point itself, or its distance, attenuation or colour exceeds the range of numbers"
        ),
        None => "; the sum of all light exceeds the range of numbers".to_owned(),
    }
}

/// Checks of numbers that belong to this part of the lighting.
impl Place {
    pub(super) fn error(self, field: &'static str, found: String, expected: &'static str) -> ShadeError {
        ShadeError { place: self, field, found, expected }
    }

    /// The error of an angle, in degrees as written: the conversion to radians and back loses the last digits.
    pub(super) fn angle_error(self, field: &'static str, angle: f64, expected: &'static str) -> ShadeError {
        let degrees = libm::round(Degrees::from(Radians(angle)).0 * 1e9) / 1e9;
        self.error(field, format!("{degrees}°"), expected)
    }

    fn hold(
        self,
        holds: bool,
        field: &'static str,
        found: impl fmt::Display,
        expected: &'static str,
    ) -> Result<()> {
        if holds { Ok(()) } else { Err(self.error(field, found.to_string(), expected)) }
    }

    pub(super) fn not_negative(self, field: &'static str, value: f64) -> Result<()> {
        self.hold(value >= 0.0 && value.is_finite(), field, value, "finite and not negative")
    }

    pub(super) fn positive(self, field: &'static str, value: f64) -> Result<()> {
        self.hold(value > 0.0 && value.is_finite(), field, value, "finite and above 0")
    }

    pub(super) fn colour(self, field: &'static str, colour: LinearRgb) -> Result<()> {
        let LinearRgb { r, g, b } = colour;
        let holds = colour.is_finite() && r >= 0.0 && g >= 0.0 && b >= 0.0;
        self.hold(holds, field, format!("({r}, {g}, {b})"), "of finite components, none of them negative")
    }

    /// Whether a finite colour is in the range of `R`. The error writes exponents, not hundreds of digits.
    pub(super) fn in_range<R: Real>(self, field: &'static str, colour: LinearRgb) -> Result<()> {
        let expected = "in the range of numbers: 3.4e38 in single precision";
        let found = || format!("{:?}", colour.to_array());
        if colour.largest() <= R::MAX.to_f64() { Ok(()) } else { Err(self.error(field, found(), expected)) }
    }

    pub(super) fn position(self, field: &'static str, position: DVec3) -> Result<()> {
        self.hold(position.is_finite(), field, position, "of finite coordinates")
    }

    pub(super) fn direction(self, field: &'static str, direction: DVec3) -> Result<()> {
        let holds = direction.is_finite() && direction != DVec3::ZERO;
        self.hold(holds, field, direction, "of finite coordinates, and not zero")
    }
}
