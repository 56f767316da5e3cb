//! Writer: new files from meshes.

// Triangles and vertices of a new file.
pub mod vertices;
// Binary data and the JSON that describes it.
pub mod data;
// Materials of other formats.
pub mod material;
// Objects as nodes.
pub mod objects;
// A new glTF file.
pub mod new_file;
