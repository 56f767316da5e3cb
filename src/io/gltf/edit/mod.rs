//! Editing a document so that only normals, and what depends on them, change.

// Encoding of normals.
pub mod encode;
// Tangents by MikkTSpace.
mod tangents;
// References between records: what may be changed in place.
mod refs;
// Notes.
mod remarks;
// New data for accessors.
pub mod store;
// The corners and primitives of an edit.
mod member;
// New indices, and the extensions that forbid them.
mod indices;
// The values of vertices.
mod rows;
// New normals for primitives that share vertices.
mod group;
// A changed document as files.
mod package;
// An edit as a whole.
pub mod apply;
