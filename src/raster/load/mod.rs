//! Scenes from files: mesh files, glTF documents, and scenes written in TOML.

// Rotation by degrees.
mod rotation;
// How the normals of an object are computed and stored.
mod normal_settings;
// A scene that owns its meshes, read from a file of any kind.
mod scene_file;
// Meshes with their normals, divided by material.
mod scene_mesh;
// Materials, cameras and lights of mesh files.
mod appearance;
// A mesh or glTF file as a scene.
mod loaded_file;
// Scenes of unusual size or place.
mod recentre;
// Scenes written in TOML.
mod toml;

pub use normal_settings::{NormalSettings, StoredFormat};
pub use recentre::Recentring;
pub use rotation::rotation;
pub use scene_file::{LoadOptions, SceneFile, SceneMesh, SceneObject, SceneShape, default_lights, load};
pub(crate) use scene_file::{is_scene, read_text};
