//! Lights and their attenuation.

use super::error::{Place, Result};
use crate::num::{LinearRgb, Radians};
use glam::{DVec3, DVec4};
use serde::Deserialize;
use std::f64::consts::{FRAC_PI_2, PI};

/// A light. Positions and directions are in the world; the colour includes the intensity, and may exceed 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Light {
    /// From everywhere, the same at every point, never attenuated (F7).
    Ambient {
        /// I_a.
        colour: LinearRgb,
    },
    /// From infinitely far away, w = 0 (F13, 1.6.40), with an attenuation of exactly 1 (F10).
    Directional {
        /// The direction from the surface *to* the light, of any length but zero.
        towards: DVec3,
        /// I_i.
        colour: LinearRgb,
    },
    /// From one point to all sides, w = 1 (F11, 1.6.41).
    Point {
        /// Where it is.
        position: DVec3,
        /// I_i.
        colour: LinearRgb,
        /// How it fades with the distance to the lit point.
        attenuation: Attenuation,
    },
    /// From one point into a cone (F12, 1.6.42).
    Spot {
        /// Where it is.
        position: DVec3,
        /// I_i on the axis.
        colour: LinearRgb,
        /// How it fades with the distance to the lit point.
        attenuation: Attenuation,
        /// The cone.
        cone: Cone,
    },
    /// From a surface (F14). A white diffuse surface that is surrounded by it shows its colour.
    Area {
        /// The surface.
        shape: AreaShape,
        /// I_i.
        colour: LinearRgb,
    },
}

/// The cone of a spot: the factor cosᵉ∠(axis, ray) times the soft edge.
///
/// Inside the cut-off angle c a soft edge of width s has the factor ((cos θ − cos c)/(cos(c−s) − cos c))², at most 1, as in
/// glTF's KHR_lights_punctual. It is computed from 1 − cos, because cosines in single precision cannot distinguish the
/// angles of narrow cones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone {
    /// The direction of the light along the middle, of any length but zero.
    pub axis: DVec3,
    /// Half the opening angle: over 0 and up to 90°, or 180° for none.
    pub cut_off: Radians,
    /// Width of the edge over which the light fades, inside the cut-off: 0 for a sharp edge.
    pub soft_edge: Radians,
    /// e: 0 for the same light everywhere in the cone, 1 for the lectures' D·L.
    pub exponent: f64,
}

impl Cone {
    /// The spot of the lectures: I_L (D·L), without cut-off.
    pub fn of_lectures(axis: DVec3) -> Self {
        Self { axis, cut_off: Radians(PI), soft_edge: Radians(0.0), exponent: 1.0 }
    }

    /// The factor in a direction from the light; 0 without a direction.
    pub(crate) fn factor(&self, direction: DVec3) -> f64 {
        let (axis, direction) = (self.axis.normalize_or_zero(), direction.normalize_or_zero());
        let angle = libm::atan2(axis.cross(direction).length(), axis.dot(direction));
        let outer = libm::cos(self.cut_off.0);
        let width = libm::cos(self.cut_off.0 - self.soft_edge.0) - outer;
        let cosine = libm::cos(angle);
        let edge = match width > 0.0 {
            true => ((cosine - outer) / width).clamp(0.0, 1.0),
            false => f64::from(u8::from(angle <= self.cut_off.0)),
        };
        edge * edge * libm::pow(cosine.max(0.0), self.exponent)
    }
}

/// A surface that shines to one side only, evenly at every point and in every direction (Lambert).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AreaShape {
    /// The points centre + a·u + b·v with a and b from −1 to 1. It shines to the side of u × v.
    Rectangle {
        /// The middle.
        centre: DVec3,
        /// From the middle to the middle of one side.
        u: DVec3,
        /// From the middle to the middle of the next side: at a right angle to u.
        v: DVec3,
    },
    /// A disc, computed as a regular polygon of 64 corners and the same area.
    Disc {
        /// The middle.
        centre: DVec3,
        /// The side that it shines to, of any length but zero.
        normal: DVec3,
        /// The radius.
        radius: f64,
    },
}

/// Attenuation by the distance d **to the light** (F9). That by the distance to the *viewer* is a
/// [`DepthCue`](super::DepthCue).
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Attenuation {
    /// 1.
    #[default]
    None,
    /// 1/d²: geometry alone. Infinite at the light.
    InverseSquare,
    /// max(1 − (d/r)⁴, 0)/d² with the range r > 0, as glTF's KHR_lights_punctual recommends.
    InverseSquareWithin(f64),
    /// 1/(d + k) with k ≥ 0: at most 1/k.
    Offset(f64),
    /// 1/(kc + kl·d + kq·d²) with kc, kl, kq ≥ 0, not all of them 0.
    Quadratic(#[serde(deserialize_with = "crate::num::list")] [f64; 3]),
}

impl Attenuation {
    /// kc, kl and kq of the formula 1/(kc + kl·d + kq·d²), which all rules follow within their range.
    pub(super) fn coefficients(self) -> [f64; 3] {
        match self {
            Attenuation::None => [1.0, 0.0, 0.0],
            Attenuation::InverseSquare | Attenuation::InverseSquareWithin(_) => [0.0, 0.0, 1.0],
            Attenuation::Offset(k) => [k, 1.0, 0.0],
            Attenuation::Quadratic(coefficients) => coefficients,
        }
    }

    /// The factor at a distance from the light.
    pub(crate) fn factor(self, distance: f64) -> f64 {
        let [constant, linear, quadratic] = self.coefficients();
        let share = distance / self.range();
        let window = (1.0 - share * share * share * share).max(0.0);
        window / (constant + distance * (linear + distance * quadratic))
    }

    /// The distance beyond which no light arrives.
    pub(super) fn range(self) -> f64 {
        match self {
            Attenuation::InverseSquareWithin(range) => range,
            _ => f64::INFINITY,
        }
    }
}

impl Light {
    /// A light at a homogeneous position (F13): directional for w = 0, else a point at (x, y, z)/w.
    ///
    /// ```
    /// use crease::num::LinearRgb;
    /// use crease::shade::{Attenuation, Light};
    /// use glam::{DVec3, DVec4};
    ///
    /// let far = Light::at(DVec4::new(-4.0, 3.0, 0.0, 0.0), LinearRgb::WHITE, Attenuation::InverseSquare);
    /// assert_eq!(far, Light::Directional { towards: DVec3::new(-4.0, 3.0, 0.0), colour: LinearRgb::WHITE });
    /// ```
    pub fn at(position: DVec4, colour: LinearRgb, attenuation: Attenuation) -> Self {
        let towards = position.truncate();
        if position.w == 0.0 {
            Light::Directional { towards, colour }
        } else {
            Light::Point { position: towards / position.w, colour, attenuation }
        }
    }

    /// Its colour.
    pub fn colour(&self) -> LinearRgb {
        match *self {
            Light::Ambient { colour }
            | Light::Directional { colour, .. }
            | Light::Point { colour, .. }
            | Light::Spot { colour, .. }
            | Light::Area { colour, .. } => colour,
        }
    }

    /// Its kind, as scene files and reports call it.
    pub fn kind(&self) -> &'static str {
        match self {
            Light::Ambient { .. } => "ambient",
            Light::Directional { .. } => "directional",
            Light::Point { .. } => "point",
            Light::Spot { .. } => "spot",
            Light::Area { shape: AreaShape::Rectangle { .. }, .. } => "rectangle",
            Light::Area { shape: AreaShape::Disc { .. }, .. } => "disc",
        }
    }

    /// Whether every number is valid; the error names the light by its `number`.
    ///
    /// # Errors
    /// The first invalid number: not finite, negative, a direction of length 0, an angle out of range, sides that are not at a
    /// right angle.
    pub fn check(&self, number: usize) -> Result<()> {
        let place = Place::Light(number);
        place.colour("colour", self.colour())?;
        match *self {
            Light::Ambient { .. } => Ok(()),
            Light::Directional { towards, .. } => place.direction("direction", towards),
            Light::Point { position, attenuation, .. } => {
                place.position("position", position)?;
                attenuation.check(place)
            }
            Light::Spot { position, attenuation, cone, .. } => {
                place.position("position", position)?;
                attenuation.check(place)?;
                cone.check(place)
            }
            Light::Area { shape, .. } => shape.check(place),
        }
    }
}

impl Attenuation {
    fn check(self, place: Place) -> Result<()> {
        match self {
            Attenuation::None | Attenuation::InverseSquare => Ok(()),
            Attenuation::InverseSquareWithin(range) => place.positive("range", range),
            Attenuation::Offset(k) => place.not_negative("k", k),
            Attenuation::Quadratic([constant, linear, quadratic]) => {
                let named = [("kc", constant), ("kl", linear), ("kq", quadratic)];
                named.into_iter().try_for_each(|(name, value)| place.not_negative(name, value))?;
                // All zero would be light without end everywhere.
                place.positive("kc + kl + kq", constant + linear + quadratic)
            }
        }
    }
}

impl Cone {
    fn check(&self, place: Place) -> Result<()> {
        let Radians(cut_off) = self.cut_off;
        place.direction("axis", self.axis)?;
        if !(cut_off > 0.0 && cut_off <= FRAC_PI_2) && cut_off != PI {
            return Err(place.angle_error(
                "cut-off",
                cut_off,
                "above 0° and up to 90°, or 180° for no cut-off",
            ));
        }
        let Radians(soft) = self.soft_edge;
        if !(soft >= 0.0 && soft <= cut_off) {
            return Err(place.angle_error("soft edge", soft, "0° or more and no wider than the cut-off"));
        }
        place.not_negative("spot exponent", self.exponent)
    }
}

impl AreaShape {
    fn check(&self, place: Place) -> Result<()> {
        match *self {
            AreaShape::Rectangle { centre, u, v } => {
                place.position("centre", centre)?;
                place.direction("side u", u)?;
                place.direction("side v", v)?;
                let (length_u, length_v) = (u.length(), v.length());
                if (u / length_u).dot(v / length_v).abs() > RIGHT_ANGLE {
                    return Err(place.error("pair of sides", format!("{u} and {v}"), "at a right angle"));
                }
                Ok(())
            }
            AreaShape::Disc { centre, normal, radius } => {
                place.position("centre", centre)?;
                place.direction("normal", normal)?;
                place.positive("radius", radius)
            }
        }
    }
}

/// The largest cosine between the sides of a rectangle: sides may be written with six digits.
const RIGHT_ANGLE: f64 = 1e-5;
