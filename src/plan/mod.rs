//! The cheapest model that a scene requires (layer 6).
//!
//! [`plan`] takes a scene file and a tolerance. It finds the cheapest combination of shading, normals, storage, lights and
//! tessellation whose pictures stay within the tolerance of the scene as declared, and returns the text of the scene that
//! way. Costs are counted ([`cost`]), so that the plan is the same on every machine. [`search`] describes why it is the cheapest.

// What may be omitted.
mod axes;
// Cheaper lights.
mod lights;
// What a model costs.
pub mod cost;
// The text of a scene file, and changes to it.
mod document;
// Texts of scenes to plan.
mod source;
// An object table of the scene file.
mod unit;
// The objects of the scene with any model, drawn from every view.
mod stage;
// The models that an object may have.
mod models;
// Pictures compared.
mod compare;
// A-priori bounds on the error of cheaper models.
mod bounds;
// Views of the reference: cameras around a scene, with lights that turn.
mod views;
// The search.
pub mod search;
// The decisions of a plan, and the planned text.
mod decisions;
// Pictures of a plan and of refused steps.
mod evidence;
// The options of a plan.
mod options;
// The plan of a scene file.
mod planned;
// Mesh files as planned.
mod apply;

pub use apply::{AXES_OF_FILES, Applied, AppliedFile, FileSize, Home, Reference, apply, with_stored_normals};
pub use axes::{Axis, LightModel, Normals, ObjectModel, Source, Terms};
pub use compare::{Difference, Metric};
pub use cost::{Cost, Minimise};
pub use decisions::{Decision, OutlineShift, Plan, limit};
pub use evidence::{Comparison, Evidence, Refusal, Tried};
pub use options::{End, PlanOptions, Progress};
pub use planned::{plan, plan_with_evidence};
pub use source::{most_accurate, scene_text, with_mesh_names, with_size};
pub use stage::PlanError;
pub use views::{Place, TurnOfLights};
