//! The integration suite.

#![allow(clippy::print_stdout, reason = "a test says what it skips")]

mod artefact;
mod artefact_sweep;
mod axes;
mod batch;
mod cli;
mod colours;
mod compressed;
mod convert;
mod data;
mod docs;
mod f32_text;
mod flat;
mod gltf;
mod gltf_compact;
mod gltf_edit;
mod gltf_hostile;
mod gltf_synthetic;
mod hostile;
mod inspect;
mod invariance;
mod laboratory;
mod lectures;
mod merge;
mod meshes;
mod obj;
mod orient;
mod pipeline;
mod plan;
mod ply;
mod random;
mod raster;
mod reference;
mod render;
mod scenes;
mod shade;
mod stl;
mod stress;
mod surface;
mod tangents;
mod textures;
mod theory;
mod trade;
mod triangulate;
