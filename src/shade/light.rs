//! Lights: what shines, from where, and how it fades.

use super::error::{Check, Place, ShadeError};
use crate::num::{LinearRgb, Radians};
use glam::{DVec3, DVec4};
use std::f64::consts::{FRAC_PI_2, PI};

/// A light. Positions and directions are in the world; the colour is intensity and colour in one, and may exceed 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Light {
    /// From everywhere, the same at every point, never attenuated (F7): it replaces the light that other surfaces reflect.
    Ambient {
        /// I_a.
        colour: LinearRgb,
    },
    /// From infinitely far away: a homogeneous position with w = 0 (F13, 1.6.40). Its attenuation is exactly 1 (F10).
    Directional {
        /// The way from the surface *to* the light, of any length but zero.
        towards: DVec3,
        /// I_i.
        colour: LinearRgb,
    },
    /// From one point to all sides: a homogeneous position with w = 1 (F11, 1.6.41).
    Point {
        /// Where it is.
        position: DVec3,
        /// I_i.
        colour: LinearRgb,
        /// How it fades with the distance to the lit point.
        attenuation: Attenuation,
    },
    /// From one point into a cone (F12, 1.6.42): the lectures' three knobs are direction, cut-off and exponent.
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
    /// From a surface (F14). Its colour is what a white diffuse surface that sees nothing else than it would show.
    Area {
        /// The surface.
        shape: AreaShape,
        /// I_i.
        colour: LinearRgb,
    },
}

/// Where a spot shines: the factor cosᵉ∠(axis, ray) times the soft edge.
///
/// Inside the cut-off angle c the soft edge of width s has the factor ((cos θ − cos c)/(cos(c−s) − cos c))², 1 at the
/// most: the falloff of glTF's KHR_lights_punctual. It is computed from versines, 1 − cos, which distinguish narrow
/// cones that cosines in single precision cannot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone {
    /// The way that the light goes along the middle, of any length but zero.
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
}

/// A surface that shines, to one side only, the same at every point and in every direction (Lambert).
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
    /// A round surface, taken as a regular polygon of 64 corners and the same area.
    Disc {
        /// The middle.
        centre: DVec3,
        /// The side that it shines to, of any length but zero.
        normal: DVec3,
        /// The radius.
        radius: f64,
    },
}

/// How light fades with the distance d **to the light**. Fading with the distance to the *viewer* is a
/// [`DepthCue`](super::DepthCue): the lectures give both the same symbol (F9, F17).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Attenuation {
    /// 1.
    #[default]
    None,
    /// 1/d²: geometry alone. Infinite at the light.
    InverseSquare,
    /// max(1 − (d/r)⁴, 0)/d²: nothing beyond the range r, as glTF's KHR_lights_punctual recommends.
    InverseSquareWithin {
        /// r.
        range: f64,
    },
    /// 1/(d + k): at most 1/k.
    Offset {
        /// k.
        k: f64,
    },
    /// 1/(kc + kl·d + kq·d²).
    Quadratic {
        /// kc.
        constant: f64,
        /// kl.
        linear: f64,
        /// kq.
        quadratic: f64,
    },
}

impl Attenuation {
    /// kc, kl and kq: every rule is 1/(kc + kl·d + kq·d²), apart from the range of one.
    pub(super) fn coefficients(self) -> [f64; 3] {
        match self {
            Attenuation::None => [1.0, 0.0, 0.0],
            Attenuation::InverseSquare | Attenuation::InverseSquareWithin { .. } => [0.0, 0.0, 1.0],
            Attenuation::Offset { k } => [k, 1.0, 0.0],
            Attenuation::Quadratic { constant, linear, quadratic } => [constant, linear, quadratic],
        }
    }

    /// The distance beyond which nothing is left: infinite but for one rule.
    pub(super) fn range(self) -> f64 {
        match self {
            Attenuation::InverseSquareWithin { range } => range,
            _ => f64::INFINITY,
        }
    }
}

impl Light {
    /// A light at a homogeneous position (F13): directional for w = 0, where the attenuation does not count, and a
    /// point at (x, y, z)/w otherwise.
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

    /// Whether every number makes sense; `number` is the light's among its scene's, from 0, for the error to name.
    ///
    /// # Errors
    /// The first number that does not: what is not finite, negative colours and attenuations, directions of length 0,
    /// angles that are no cone's, sides that are no rectangle's.
    pub fn check(&self, number: usize) -> Result<(), ShadeError> {
        let check = Check(Place::Light(number));
        check.colour("colour", self.colour())?;
        match *self {
            Light::Ambient { .. } => Ok(()),
            Light::Directional { towards, .. } => check.direction("direction", towards),
            Light::Point { position, attenuation, .. } => {
                check.position("position", position)?;
                attenuation.check(check)
            }
            Light::Spot { position, attenuation, cone, .. } => {
                check.position("position", position)?;
                attenuation.check(check)?;
                cone.check(check)
            }
            Light::Area { shape, .. } => shape.check(check),
        }
    }
}

impl Attenuation {
    fn check(self, check: Check) -> Result<(), ShadeError> {
        match self {
            Attenuation::None | Attenuation::InverseSquare => Ok(()),
            Attenuation::InverseSquareWithin { range } => check.positive("range", range),
            Attenuation::Offset { k } => check.not_negative("k", k),
            Attenuation::Quadratic { constant, linear, quadratic } => {
                let named = [("kc", constant), ("kl", linear), ("kq", quadratic)];
                named.into_iter().try_for_each(|(name, value)| check.not_negative(name, value))?;
                // All zero would be light without end everywhere.
                check.positive("kc + kl + kq", constant + linear + quadratic)
            }
        }
    }
}

impl Cone {
    fn check(&self, check: Check) -> Result<(), ShadeError> {
        let Radians(cut_off) = self.cut_off;
        check.direction("axis", self.axis)?;
        if !(cut_off > 0.0 && cut_off <= FRAC_PI_2) && cut_off != PI {
            return Err(check.degrees("cut-off", cut_off, "over 0° and up to 90°, or 180° for no cut-off"));
        }
        let Radians(soft) = self.soft_edge;
        if !(soft >= 0.0 && soft <= cut_off) {
            return Err(check.degrees("soft edge", soft, "0° or more and no wider than the cut-off"));
        }
        check.not_negative("spot exponent", self.exponent)
    }
}

impl AreaShape {
    fn check(&self, check: Check) -> Result<(), ShadeError> {
        match *self {
            AreaShape::Rectangle { centre, u, v } => {
                check.position("centre", centre)?;
                check.direction("side u", u)?;
                check.direction("side v", v)?;
                let (length_u, length_v) = (u.length(), v.length());
                if (u / length_u).dot(v / length_v).abs() > RIGHT_ANGLE {
                    return Err(check.text("pair of sides", format!("{u} and {v}"), "at a right angle"));
                }
                Ok(())
            }
            AreaShape::Disc { centre, normal, radius } => {
                check.position("centre", centre)?;
                check.direction("normal", normal)?;
                check.positive("radius", radius)
            }
        }
    }
}

/// How far the sides of a rectangle may be from a right angle: what is left of one written with six digits.
const RIGHT_ANGLE: f64 = 1e-5;
