//! Consistent and outward orientation of faces.

// Connected components, and which faces of each have the opposite winding to the others.
mod components;
// How deep closed surfaces lie inside each other, by rays from points of them.
mod nesting;
// Closed surfaces: the sign of their volume, and those that face inwards as rooms and cavities.
mod shells;
// The outer side of a surface with a boundary.
mod visibility;
// The policies.
mod policy;
// Cavities that are meshes of their own.
mod cavities;
// Orientation of closed, nested, open and degenerate surfaces.
#[cfg(test)]
mod tests;

pub(crate) use cavities::{Placed, cavities};
pub(crate) use policy::Orientations;
pub use policy::{Confidence, Orient, Orientation, orient};
