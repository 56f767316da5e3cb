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
// An object table of the scene file.
mod unit;
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
// The decisions of a plan, and the planned text.
mod decisions;
// The plan of a scene file.
mod planned;
// Mesh files as planned.
mod apply;

pub use apply::{AXES_OF_FILES, Applied, AppliedFile, FileSize, Home, Reference, apply, with_stored_normals};
pub use axes::{Axis, LightModel, Normals, ObjectModel, Source, Terms};
pub use compare::Difference;
pub use cost::{Cost, Minimise};
pub use decisions::{Decision, Plan};
pub use document::{scene_text, with_size};
pub use planned::{PlanOptions, plan};
pub use stage::PlanError;
