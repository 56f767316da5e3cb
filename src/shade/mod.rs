//! Light on a point (layer 2): lights, materials, attenuation, Phong's and Blinn's highlights, tone rules.
//!
//! The model is local: I = Σ I_a K_a + Σ f I_i (K_d N·L + K_s cosⁿ), in linear red, green and blue. There are no shadows,
//! no inter-reflection and no transparency.
//!
//! - [`Shader::new`] resolves [`Light`]s, one [`Material`] and [`ShadeSettings`], and omits every term that this combination
//!   does not need, such as black lights or positions ([`needs_positions`](Shader::needs_positions)).
//! - [`Shader::shade`] lights one point, [`Shader::shade_rows`] many at once with the same bits.
//! - [`Probe`] reports every vector, factor and term of a colour, before and after the guards.
//!
//! # Guards
//! [`Guards`] are the conditions that the lectures' formulas omit; [`Guards::literal`] switches all of them off. In any mode a
//! half-vector of 0/0 gives no highlight, and a colour that is not finite is an error ([`NotFinite`]). [`Terminator`] decides
//! about light on a face that turns away from it while the interpolated normal does not.
//!
#![doc = include_str!("formulas.md")]

// What is refused, with its place.
mod error;
// Vectors and the formulas of the lectures.
mod formula;
// Viewer, guards, depth cue, terminator, tone rule.
mod settings;
// Lights.
mod light;
// Materials.
mod material;
// Reflection and refraction at a smooth surface.
mod optics;
// Irradiance of area lights.
mod area;
// Lights in the frame and precision of a shader, and their terms on a material.
mod source;
// The light on a point.
mod shader;
// The light on rows of points.
mod rows;
// The terms of the light on a point.
mod explain;

pub use error::{NotFinite, Place, ShadeError};
pub use explain::{Explanation, HighlightExplanation, LightExplanation, Probe, Term};
pub use light::{AreaShape, Attenuation, Cone, Light};
pub use material::{
    EnergyGain, Material, Reflectance, Reflection, blinn_exponent, phong_exponent, roughness_exponent,
};
pub use optics::{
    Fresnel, Optics, brewster_angle, critical_angle, fresnel, reflect, refract, refraction_angle,
};
pub use rows::SurfaceRows;
pub use settings::{DepthCue, Frame, Guards, ShadeSettings, Terminator, ToneRule, Viewer};
pub(crate) use shader::SeenFrom;
pub use shader::{Shader, SurfacePoint};
