//! Editing a document so that only normals, and what depends on them, change.

// References between records: what may be changed in place.
mod refs;
// New data for accessors.
mod store;
// The primitives of an edit, and their new indices.
mod member;
// The values of vertices.
mod rows;
// Tangents by MikkTSpace.
pub mod mikktspace;
// Tangents that go with new normals.
mod tangents;
// Vertices that agree in everything.
mod merge;
// New normals for primitives that share vertices.
mod group;
// An edit as a whole, and the files that it becomes.
pub mod apply;
// Images in data URIs, which become views of a GLB.
mod data_images;
// A GLB without what nothing uses.
mod compact;
// A GLB compressed by meshopt.
pub mod compress;
