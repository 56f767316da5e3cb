//! `crease surface`: write an analytic surface as a mesh with its exact normals.

/// Options.
pub mod args;
/// The report as JSON and as text.
mod report;
/// Options made into a surface and a tessellation.
mod request;
/// Making the mesh.
pub mod run;
