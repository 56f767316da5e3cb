//! The settings of lighting.

use super::error::{Check, Place, ShadeError};
use super::tone::ToneRule;
use glam::DVec3;
use serde::Deserialize;

/// All settings of shading.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ShadeSettings {
    /// Who looks.
    pub viewer: Viewer,
    /// What the coordinates of points are counted from and in.
    pub frame: Frame,
    /// Which of the guards are on.
    pub guards: Guards,
    /// Fading with the distance to the viewer, if wanted.
    pub depth_cue: Option<DepthCue>,
    /// Light the side that the viewer sees: the normal is turned where N·V < 0. A rasterizer that knows which way a
    /// triangle faces hands over its normals already turned and leaves this off, for a normal interpolated near a
    /// silhouette may point away from the viewer on a triangle that faces him.
    pub two_sided: bool,
    /// What becomes of light that reaches a face from behind.
    pub terminator: Terminator,
    /// What becomes of colours out of range.
    pub tone: ToneRule,
}

/// What becomes of light on a point whose own normal N still turns to it while its face, with the normal N_g, does so
/// hardly or not: N·L > 0 ≥ N_g·L. It needs normals of faces: see [`Shader::shade_on`](super::Shader::shade_on).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Terminator {
    /// It stays: only N counts. Right for smooth surfaces without shadows.
    #[default]
    Smooth,
    /// It goes where N_g·L ≤ 0, as where a ray casts the face's own shadow: the border of light runs along the edges of
    /// faces, and whole faces light up at once when the light turns.
    Hard,
    /// As [`Hard`](Self::Hard), but it goes gradually: times −g³ + g² + g for g = N_g·L/((N·L)(N_g·N)) < 1
    /// (M. J.-Y. Chiang, Y. K. Li, B. Burley, *Taming the shadow terminator*, SIGGRAPH 2019 Talks). Applied to highlights too,
    /// so that nothing of a light is left behind the face.
    Soft,
}

/// Where the viewer is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Viewer {
    /// At a point of the world: V differs from point to point.
    At(DVec3),
    /// Infinitely far away: V is this direction, from the surface to the viewer, everywhere.
    Towards(DVec3),
}

impl Default for Viewer {
    /// Far away on the z axis.
    fn default() -> Self {
        Viewer::Towards(DVec3::Z)
    }
}

/// Points are handed over as (world − origin)/unit, so that single precision serves meshes of any size at any place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// The world position of (0, 0, 0).
    pub origin: DVec3,
    /// The length of 1, over 0. A power of two changes no digit.
    pub unit: f64,
}

impl Default for Frame {
    /// The world's own.
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

/// Fading with the distance d **to the viewer**: everything but ambient light is divided by d + k (F17; exercises
/// 1.6.6 and 1.6.11). Fading with the distance to a light is its [`Attenuation`](super::Attenuation).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DepthCue {
    /// k, 0 or more.
    pub k: f64,
}

/// What the lectures' formulas leave out, each by name. All are on by default.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Guards {
    /// No highlight where N·L ≤ 0: a light behind the face has none (F4).
    pub highlight: bool,
    /// Diffuse light is 0 where N·L < 0, not negative (F3).
    pub diffuse: bool,
    /// A spot does not shine where D·L ≤ 0, nor with less than nothing (F12). Off, cosᵉ keeps the sign of cos.
    pub spot: bool,
    /// Interpolated normals are made unit vectors again (F22). Shaders hold it of all normals that they are given; pictures lift
    /// it only under Phong's shading of faces, where normals are interpolated.
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
    /// Whether every number makes sense.
    pub(super) fn check(&self) -> Result<(), ShadeError> {
        let check = Check(Place::Settings);
        check.position("origin", self.frame.origin)?;
        check.positive("unit", self.frame.unit)?;
        match self.viewer {
            Viewer::At(position) => check.position("viewer", position)?,
            Viewer::Towards(direction) => check.direction("direction to the viewer", direction)?,
        }
        match (self.depth_cue, self.viewer) {
            (Some(DepthCue { k }), Viewer::At(_)) => check.not_negative("depth cue k", k),
            (Some(_), Viewer::Towards(_)) => {
                Err(check.text("viewer", "infinitely far away".into(), "at a point, for depth cueing"))
            }
            (None, _) => Ok(()),
        }
    }
}
