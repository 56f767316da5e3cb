//! The integration suite.

mod data;
mod gltf;
