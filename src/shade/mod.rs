//! Light on a point (layer 2): lights, materials, attenuation, Phong's and Blinn's highlights, tone rules.
//!
//! The model is local: I = Σ I_a K_a + Σ f I_i (K_d N·L + K_s cosⁿ), in linear red, green and blue. There are no shadows,
//! no inter-reflection and no transparency.
//!
//! - [`Shader::new`] resolves [`Light`]s, one [`Material`] and [`ShadeSettings`] to what this combination needs. A light
//!   without colour, a reflection without coefficient, a highlight whose half-vector is the same everywhere, positions
//!   and a viewer that nothing asks for: what is not there is not computed ([`needs_positions`](Shader::needs_positions)).
//! - [`Shader::shade`] lights one point, [`Shader::shade_rows`] many at once with the same bits.
//! - [`Probe`] reports every vector, factor and term of a colour, before and after the guards.
//!
//! # Guards
//! The lectures' formulas leave out what keeps them sound; [`Guards`] adds it, each by name, and
//! [`Guards::literal`] is the formulas as printed. In any mode a half-vector of 0/0 gives no highlight, and a colour
//! that is not finite is an error ([`NotFinite`]), never a colour.
//!
//! [`Terminator`] is what becomes of light on a face that turns away from it while the interpolated normal does not: nothing by
//! default, for there are no shadows here.
//!
//! # The formulas of the lectures
//! S0 is Medeiros Filho, *Iluminação e Sombreamento* (2017), S3 Ting, *Tonalização* (2008), S4 Vieira, *Iluminação local*.
//! Each formula has a test in the integration suite. That of a formula about light on a point bears its number, as
//! `shade::formulas::f3_lambert_is_the_cosine_and_nothing_from_behind`; what lies above this module names its own.
//!
//! | | formula | where |
//! |---|---|---|
//! | F1 | I = I_d + I_e + I_abs + I_ref, so k_d + k_s ≤ 1 (S0 1.2) | [`Material::gain`], a warning about K = k·O of each component: exercise 1.6.19 breaks it |
//! | F2 | law of reflection (S0 1.2, S3, S4) | [`reflect`] |
//! | F3 | Lambert: I_i k_d (N·L) (S0 1.3.1.1) | diffuse term; clamped at 0 by the guard `diffuse` |
//! | F4 | Phong: I_i k_s (V·R)ⁿ if V·R > 0 (S0 1.3.1.2) | [`Reflection::Phong`]; nothing from behind by the guard `highlight` |
//! | F5 | R = 2N(N·L) − L (S0 1.3.1.2, S3) | [`reflect`], [`LightExplanation::reflected`] |
//! | F6 | Blinn: H = (L+V)/‖L+V‖, I_i k_s (N·H)ⁿ (S0 1.3.1.3, S3) | [`Reflection::Blinn`]; exponents: [`blinn_exponent`] |
//! | F7 | ambient I_a k_a, never attenuated (S0 1.3.1.5) | [`Light::Ambient`] |
//! | F8 | the sum of the three (S0 1.3.1.6) | [`Shader::shade`] |
//! | F9 | attenuation 1/d², 1/(k₂d²+k₁d+k), 1/(d+k) (S0 1.3.1.7) | [`Attenuation`] |
//! | F10 | exactly 1 for a light at infinity (S0 1.6.26) | [`Light::Directional`] |
//! | F11 | point light I_L/(kc+kl·d+kq·d²) (S0 1.6.41) | [`Light::Point`] |
//! | F12 | spot I_L (D·L)/(kc+kl·d+kq·d²) (S0 1.6.42, S3) | [`Light::Spot`], [`Cone::of_lectures`]; guard `spot` |
//! | F13 | directional is w = 0, point w = 1 (S0 1.6.40, S3) | [`Light::at`] |
//! | F14 | extended source (S3, without formula) | [`Light::Area`]: Lambert's polygon, clipped at the horizon |
//! | F15 | I_c with k and O apart or merged (S0 1.3.1.8) | [`Reflectance`] |
//! | F16 | sum over lights, each with its own d, L, V, R (S0 1.3.1.9, S4) | [`Shader::shade`] |
//! | F17 | depth cueing: all but ambient over d+K, d to the viewer (S0 1.6.6, 1.6.11) | [`DepthCue`] |
//! | F18 | flat: one evaluation for each polygon (S0 1.5.1) | module `raster`; `raster::shading::flat_faces_have_one_colour_each` |
//! | F19 | Gouraud along edges and scanlines (S0 1.5.2.1) | module `raster`: `raster::interpolation::the_scanline_diamond_turns_its_centre`, `scenes::lectures::exercise_1_6_24` |
//! | F20 | vertex normal as the mean of face normals (S0 1.5.2.1) | [`Weight::Uniform`](crate::normals::Weight): `reference::uniform_fans_agree_with_vtk` |
//! | F21 | n = (P1−P0)×(P2−P0)/‖…‖ (S0 1.6.21a) | [`face_normals`](fn@crate::normals::face_normals): `stress::every_expectation_holds_and_plain_code_fails_in_many` against rationals |
//! | F22 | Phong: normals along edges and spans (S0 1.5.2.2, S3) | module `raster`; renormalised by the guard `renormalise`: `raster::interpolation::gouraud_stays_within_its_corners_and_phong_does_not`, `raster::shading::phong_converges_to_exact_with_order_2` |
//! | F23 | Gouraud depends on the triangulation (S3) | module `raster`: `raster::interpolation::triangles_depend_on_the_diagonal_instead` |
//! | F24 | cost: wireframe, flat, Gouraud, Phong (S0 1.6.10) | `crease render --compare wireframe,flat,gouraud,phong` reports each one's time; the README has a table |
//! | F25 | out of range: clamp or divide by the largest (S0 1.6.17b) | [`ToneRule`] |
//! | F26 | artefacts of interpolated shading (S0 1.5.2.3 and exercises) | module `artefact`, an experiment each: `artefact::all_experiments_agree_with_their_checks_and_any_number_of_threads_writes_the_same` |
//! | F27 | Mach bands worse in Gouraud than in Phong (S0 table 1; false in general) | `theory::bands::phong_is_worse_than_gouraud_beyond_70_degrees`; `crease artefact mach-bands` |
//! | F28 | the eye is sensitive to the second derivative (S0 1.6.13) | jumps of the slope, which are what it sees: `theory::bands::steps_and_jumps_are_those_of_the_formulas`; `crease artefact mach-bands` |
//! | F29 | Snell, Fresnel (S3) | [`refraction_angle`], [`refract`], [`fresnel`], [`brewster_angle`], [`critical_angle`] |

// What is refused, with its place.
mod error;
// Vectors and the formulas of the lectures.
mod formula;
// Colours out of range.
mod tone;
// Viewer, guards, depth cue, terminator.
mod settings;
// Lights.
mod light;
// Materials.
mod material;
// Reflection and refraction at a smooth surface.
mod optics;
// Irradiance of area lights.
mod area;
// Lights in the frame and precision of a shader.
mod source;
// One light on one material.
mod term;
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
pub use optics::{Fresnel, brewster_angle, critical_angle, fresnel, reflect, refract, refraction_angle};
pub use rows::SurfaceRows;
pub use settings::{DepthCue, Frame, Guards, ShadeSettings, Terminator, Viewer};
pub use shader::{Shader, SurfacePoint};
pub use tone::ToneRule;
