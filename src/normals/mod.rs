//! Face, vertex and corner normals (layer 2).

mod block;
mod corner_terms;
mod emit;
mod face;
mod face_shape;
mod fallback;
mod fault;
mod field;
mod gather;
mod part;
mod partition;
mod positions;
mod recipe;
mod slices;
mod sliver;
mod sums;
mod term;
#[cfg(test)]
mod test_meshes;
mod weight;

pub use crate::mesh::Weld;
pub use fault::{Fault, FaultReason, Faults};
pub use field::{EdgeCounts, NormalField, Summary};
pub use recipe::{Crease, CreaseRule, Groups, HardEdges, NormalRecipe, Precision, Scope, Slivers, Weight};
pub use slices::{Coordinate, Scratch, SliceError, face_normals, vertex_normals};
