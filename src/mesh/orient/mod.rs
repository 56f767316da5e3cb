//! Consistent and outward orientation of faces.

// Connected components, and which faces of each run against the others.
mod components;
// The sign of a closed surface's volume.
mod volume;
// How deep closed surfaces lie inside each other, by rays from points of them.
mod nesting;
// Closed surfaces that face inwards: rooms and cavities.
mod rooms;
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
