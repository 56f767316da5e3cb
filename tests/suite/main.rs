//! The integration suite.

mod data;
mod gltf;
mod gltf_edit;
mod meshes;
mod obj;
