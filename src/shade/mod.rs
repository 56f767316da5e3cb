//! Light on a point (layer 2).

mod area;
mod error;
mod explain;
mod formula;
mod light;
mod material;
mod rows;
mod settings;
mod shader;
mod source;
mod tone;

pub use error::{NotFinite, Place, ShadeError};
pub use explain::{Explanation, HighlightExplanation, LightExplanation, Probe, Term};
pub use light::{AreaShape, Attenuation, Cone, Light};
pub use material::{EnergyGain, Material, Reflectance, Reflection, blinn_exponent, phong_exponent};
pub use rows::SurfaceRows;
pub use settings::{DepthCue, Frame, Guards, ShadeSettings, Viewer};
pub use shader::{Shader, SurfacePoint};
pub use tone::ToneRule;
