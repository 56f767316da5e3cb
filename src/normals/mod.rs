//! Face, vertex and corner normals (layer 2).

// From a mesh and a recipe to a field of normals.
mod compute;
// What determines a normal.
mod recipe;
// Why a corner has a fallback normal.
mod fault;
// The result.
mod field;
// Faces: positions as the kernels read them, direction and area, slivers.
mod faces;
// Sums: weighted sums of face normals over vertices or smooth groups.
mod sums;
// Creases: which edges are sharp, and which corners share a normal.
mod creases;
// Fits: normals of surfaces fitted to the neighbourhood of a vertex.
mod fits;
// Fallback: normals for corners whose sum has no direction, and the choice between stored and computed normals.
mod fallback;
// Encoding: normals in few bits.
pub mod encoding;
// Memory that is used again.
mod scratch;
// Slices: the same kernels for the caller's own arrays.
mod slices;

pub use crate::mesh::Weld;
pub(crate) use compute::compute_from;
pub use compute::{compute, compute_observed, compute_on, compute_reusing, compute_wider, compute_with};
pub use creases::chains::CreaseChains;
pub use creases::dihedral_test::crease_slack;
pub(crate) use creases::dihedral_test::{CreaseTest, SLACK_DEGREES};
pub(crate) use fallback::fallback_normals::FaceField;
pub use fallback::replace::{Broken, LENGTH_TOLERANCE, When};
pub use fallback::select::{Selection, select};
pub use fault::{Fault, FaultReason, Faults};
pub use field::{EdgeCounts, Extras, NearCancellation, NormalField, Summary};
pub use fits::choice::Choice;
pub use fits::differences::FitDifferences;
pub use fits::fitted_normals::FitFailures;
pub use fits::jet::JetFallbacks;
pub use fits::progress::FitObserver;
pub use recipe::{
    Averaging, Crease, CreaseRule, Groups, HardEdges, NormalRecipe, Precision, Scope, Slivers, Weight,
};
pub use scratch::Scratch;
pub use slices::corner_normals::corner_normals;
pub use slices::vertex_normals::{Coordinate, SliceError, face_normals, vertex_normals};

// Meshes for tests of kernels.
#[cfg(test)]
mod test_meshes;
// Face normals against exact arithmetic.
#[cfg(test)]
mod exact_tests;
