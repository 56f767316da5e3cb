//! The integration suite.

mod data;
mod gltf;
mod gltf_edit;
mod hostile;
mod meshes;
mod obj;
mod orient;
mod random;
