//! Winding: faces and components that face the wrong way.

// Faces against their neighbours, and surfaces that have no two sides.
pub(crate) mod neighbours;
// Components that face inwards.
pub(crate) mod components;
