//! Face, vertex and corner normals (layer 2).

mod again;
mod block;
mod compute;
mod cone;
mod corner_slices;
mod corner_terms;
mod crease;
mod digits;
mod emit;
pub mod encoding;
#[cfg(test)]
mod exact_tests;
mod face;
mod face_field;
mod face_shape;
mod fallback;
mod fans;
mod fault;
mod field;
mod finish;
mod gather;
mod groups;
mod hard;
mod made_up;
mod nearest;
mod part;
mod partition;
mod positions;
mod quadric;
mod recipe;
mod replace;
mod ring_groups;
mod select;
mod single;
mod slices;
mod sliver;
mod sums;
mod tally;
mod term;
#[cfg(test)]
mod test_meshes;
mod weight;

pub use crate::mesh::Weld;
pub(crate) use compute::compute_from;
pub use compute::{compute, compute_on};
pub use corner_slices::corner_normals;
pub(crate) use crease::CreaseTest;
pub(crate) use face::FaceNormals;
pub(crate) use face_field::FaceField;
pub(crate) use face_shape::FaceState;
pub use fault::{Fault, FaultReason, Faults};
pub use field::{EdgeCounts, NormalField, Summary};
pub use recipe::{Crease, CreaseRule, Groups, HardEdges, NormalRecipe, Precision, Scope, Slivers, Weight};
pub use replace::{Broken, LENGTH_TOLERANCE, Replacement, When, replace};
pub use select::{Selection, select};
pub use slices::{Coordinate, Scratch, SliceError, face_normals, vertex_normals};
