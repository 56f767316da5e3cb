//! The settings of lighting: viewer, guards, depth cue, terminator, tone rule.

use super::error::{Place, Result};
use crate::num::{Real, names};
use glam::DVec3;
use serde::Deserialize;

/// All settings of shading.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ShadeSettings {
    /// The viewer.
    pub viewer: Viewer,
    /// The coordinate system of points.
    pub frame: Frame,
    /// The guards that are on.
    pub guards: Guards,
    /// Attenuation by the distance to the viewer.
    pub depth_cue: Option<DepthCue>,
    /// Flip normals with N·V < 0. A rasterizer flips normals by the visible side of the face instead: a normal interpolated near
    /// a silhouette may point away from the viewer.
    pub two_sided: bool,
    /// The treatment of light that reaches a face from behind.
    pub terminator: Terminator,
    /// The treatment of colours out of range.
    pub tone: ToneRule,
}

/// The treatment of light that reaches a face from behind, N·L > 0 ≥ N_g·L for its normal N_g. It needs normals of faces:
/// see [`Shader::shade_on`](super::Shader::shade_on).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Terminator {
    /// It is kept: only N counts. Right for smooth surfaces without shadows.
    #[default]
    Smooth,
    /// It is removed where N_g·L ≤ 0, as by the face's own shadow. The border of light follows the edges of faces, and
    /// a whole face becomes lit at once when the light moves.
    Hard,
    /// It is removed gradually, highlights too: times −g³ + g² + g for g = N_g·L/((N·L)(N_g·N)) < 1
    /// (M. J.-Y. Chiang, Y. K. Li, B. Burley, *Taming the shadow terminator*, SIGGRAPH 2019 Talks).
    Soft,
}

/// Where the viewer is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Viewer {
    /// At a point of the world: V differs from point to point.
    At(DVec3),
    /// Infinitely far away: V is this direction from the surface to the viewer.
    Towards(DVec3),
}

impl Default for Viewer {
    /// Far away on the z axis.
    fn default() -> Self {
        Viewer::Towards(DVec3::Z)
    }
}

/// Points are given as (world − origin)/unit, so that single precision serves meshes of any size and position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// The world position of (0, 0, 0).
    pub origin: DVec3,
    /// The length of 1, over 0. A power of two changes no digit.
    pub unit: f64,
}

impl Default for Frame {
    /// World coordinates.
    fn default() -> Self {
        Self { origin: DVec3::ZERO, unit: 1.0 }
    }
}

impl Frame {
    /// A position of the world in this frame.
    pub fn to_local(self, position: DVec3) -> DVec3 {
        (position - self.origin) / self.unit
    }

    /// The world position of a point of this frame.
    pub fn to_world(self, position: DVec3) -> DVec3 {
        position * self.unit + self.origin
    }
}

/// Attenuation by the distance d **to the viewer**: all but ambient light is divided by d + k (F17; exercises 1.6.6, 1.6.11).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DepthCue {
    /// k, 0 or more.
    pub k: f64,
}

/// Conditions that the lectures' formulas omit. All are on by default.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Guards {
    /// No highlight where N·L ≤ 0 (F4).
    pub highlight: bool,
    /// Diffuse light is 0 where N·L < 0, not negative (F3).
    pub diffuse: bool,
    /// A spot does not shine where D·L ≤ 0, and its light is never negative (F12). Off, cosᵉ keeps the sign of cos.
    pub spot: bool,
    /// Normals are made unit vectors again (F22). Pictures switch it off only for interpolated normals under Phong's shading.
    pub renormalise: bool,
    /// cosⁿ below the smallest normal number is 0.
    pub underflow: bool,
}

impl Default for Guards {
    fn default() -> Self {
        Self { highlight: true, diffuse: true, spot: true, renormalise: true, underflow: true }
    }
}

impl Guards {
    /// The names of all guards.
    pub const NAMES: [&'static str; 5] = ["highlight", "diffuse", "spot", "renormalise", "underflow"];

    /// The formulas as the lectures print them: every guard off.
    pub fn literal() -> Self {
        Self { highlight: false, diffuse: false, spot: false, renormalise: false, underflow: false }
    }

    /// Switches one guard by its name; false if there is none of that name.
    ///
    /// ```
    /// use crease::shade::Guards;
    ///
    /// let mut guards = Guards::default();
    /// assert!(guards.set("highlight", false) && !guards.highlight);
    /// assert!(!guards.set("lowlight", false));
    /// ```
    pub fn set(&mut self, name: &str, on: bool) -> bool {
        let guard = match name {
            "highlight" => &mut self.highlight,
            "diffuse" => &mut self.diffuse,
            "spot" => &mut self.spot,
            "renormalise" => &mut self.renormalise,
            "underflow" => &mut self.underflow,
            _ => return false,
        };
        *guard = on;
        true
    }
}

impl ShadeSettings {
    pub(super) fn check(&self) -> Result<()> {
        let place = Place::Settings;
        place.position("origin", self.frame.origin)?;
        place.positive("unit", self.frame.unit)?;
        match self.viewer {
            Viewer::At(position) => place.position("viewer", position)?,
            Viewer::Towards(direction) => place.direction("direction to the viewer", direction)?,
        }
        match (self.depth_cue, self.viewer) {
            (Some(DepthCue { k }), Viewer::At(_)) => place.not_negative("depth cue k", k),
            (Some(_), Viewer::Towards(_)) => {
                Err(place.error("viewer", "infinitely far away".into(), "at a point, for depth cueing"))
            }
            (None, _) => Ok(()),
        }
    }
}

/// The rule that brings a colour into the range from 0 to 1 (F25; exercise 1.6.17b).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ToneRule {
    /// Each component is clamped to 0…1: the hue of a bright colour changes.
    #[default]
    Clamp,
    /// A colour with a component over 1 is divided by its largest: the hue stays. Then clamped at 0.
    #[serde(rename = "max")]
    DivideByMax,
}

names! { ToneRule: Clamp = "clamp", DivideByMax = "max" }

impl ToneRule {
    /// The colour, each component in 0…1.
    ///
    /// ```
    /// use crease::shade::ToneRule;
    ///
    /// assert_eq!(ToneRule::Clamp.apply([0.9, 1.25, 0.5]), [0.9, 1.0, 0.5]);
    /// assert_eq!(ToneRule::DivideByMax.apply([0.9, 1.25, 0.5]), [0.72, 1.0, 0.4]);
    /// ```
    #[inline(always)]
    pub fn apply<R: Real>(self, colour: [R; 3]) -> [R; 3] {
        let [r, g, b] = colour;
        let scaled = match self {
            ToneRule::Clamp => colour,
            ToneRule::DivideByMax => {
                let largest = larger(larger(r, g), larger(b, R::ONE));
                [r / largest, g / largest, b / largest]
            }
        };
        let [r, g, b] = scaled;
        [clamped(r), clamped(g), clamped(b)]
    }
}

#[inline(always)]
fn larger<R: Real>(a: R, b: R) -> R {
    if a > b { a } else { b }
}

#[inline(always)]
fn clamped<R: Real>(x: R) -> R {
    let x = if x < R::ZERO { R::ZERO } else { x };
    if x > R::ONE { R::ONE } else { x }
}
