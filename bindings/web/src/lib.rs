//! The laboratory in a browser: requests in JSON, answers in JSON and buffers of bytes.
//!
//! [`Laboratory::answer`] is the only door. A web worker calls it through [`Door`], which exists in WebAssembly only. Natively
//! [`write_answers`] calls it with the same requests, so that tests can compare the bytes.

// One request, one answer.
mod laboratory;
// The built-in meshes.
mod shapes;
// The mesh that is examined, with its normals.
mod subject;
// What a picture of it shows: normals, view, lamp, material.
mod view;
// Pictures of the mesh, and the numbers of a pixel.
mod pictures;
// The angle to other normals, pixel by pixel and corner by corner.
mod deviation;
// The mesh as a file, and the commands that make it.
mod saving;
// The findings of a mesh.
mod inspection;
// The experiments.
mod experiments;
// The exercises of the lectures.
mod exercises;
// Answers as files, natively.
#[cfg(not(target_arch = "wasm32"))]
mod answers;
// The exported object.
#[cfg(target_arch = "wasm32")]
mod door;

#[cfg(not(target_arch = "wasm32"))]
pub use answers::write_answers;
#[cfg(target_arch = "wasm32")]
pub use door::Door;
pub use laboratory::{Answer, Laboratory};
