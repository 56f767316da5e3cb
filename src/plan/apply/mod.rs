//! Mesh files as planned: what a plan may change in them, and their text and bytes.

// The mesh files of a scene.
mod file_objects;
// The models that mesh files hold.
mod models;
// The files as planned.
mod written_files;

pub use file_objects::{Reference, with_stored_normals};
pub use models::AXES_OF_FILES;
pub(super) use models::{FileModels, name_storage};
pub use written_files::{Applied, AppliedFile, FileSize, Home, apply};
