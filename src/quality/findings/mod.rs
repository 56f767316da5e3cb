//! All findings, one file for each or for a close family: limits and search.

// The names that most findings use.
pub(crate) mod prelude;
// What findings say in addition to their titles.
pub(crate) mod remarks;
// Geometry: faces, edges and vertices that spoil normals.
pub(crate) mod geometry;
// Winding: faces and components that face the wrong way.
pub(crate) mod winding;
// Smoothing: the edges across which stored normals are smooth.
pub(crate) mod smoothing;
// Stored: the normals of the file, corner by corner.
pub(crate) mod stored;
// Storage: the precision in which normals are stored.
pub(crate) mod storage;
// Shading: what even correct normals show.
pub(crate) mod shading;
