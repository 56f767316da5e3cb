//! The cheapest model that a scene requires (layer 6).
//!
//! [`plan`] takes a scene file and a tolerance. It finds the cheapest combination of shading, normals, storage, lights and
//! tessellation whose pictures stay within the tolerance of the scene as declared, and returns the text of the scene that
//! way. Costs are counted ([`cost`]), so that the plan is the same on every machine. [`search`] describes why it is the cheapest.

// What may be left out.
mod axes;
// Cheaper lights.
mod lights;
// What a model costs.
pub mod cost;
// The text of a scene file, and changes to it.
mod document;
// The objects of the scene with any model, drawn from every view.
mod stage;
// The models that an object may have.
mod models;
// Pictures compared.
mod compare;
// Bounds on the error of a change.
mod bounds;
// Views around a scene.
mod views;
// Pictures of models, compared with the reference.
mod trials;
// The search.
pub mod search;
// The plan of a scene file.
mod planned;

pub use axes::{Axis, LightModel, Normals, ObjectModel, Source, Terms};
pub use compare::Difference;
pub use cost::{Cost, Minimise};
pub use document::{scene_text, with_size};
pub use planned::{Decision, Plan, PlanOptions, plan};
pub use stage::PlanError;
