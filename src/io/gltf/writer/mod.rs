//! Writer: new files from meshes.

// Triangles and vertices of a new file.
pub(super) mod vertices;
// Binary data and the JSON that describes it.
pub(super) mod data;
// Materials of other formats.
pub(super) mod material;
// Objects as nodes.
pub(super) mod objects;
// A new glTF file.
pub(super) mod new_file;
