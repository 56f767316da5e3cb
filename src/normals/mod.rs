//! Face, vertex and corner normals (layer 2).

mod fault;
mod field;
mod recipe;

pub use crate::mesh::Weld;
pub use fault::{Fault, FaultReason, Faults};
pub use field::{EdgeCounts, NormalField, Summary};
pub use recipe::{Crease, CreaseRule, Groups, HardEdges, NormalRecipe, Precision, Scope, Slivers, Weight};
