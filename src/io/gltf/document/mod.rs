//! Document: the typed records of a file.

// The records that geometry needs.
pub mod records;
// Accessors to numbers.
pub mod accessor;
// Cameras.
pub mod camera;
// Materials, cameras and lights.
pub mod appearance;
// The node tree.
pub mod nodes;
// Primitives.
pub mod primitive;
// Vertex columns.
pub mod columns;
// Tangents and morph targets.
pub mod attributes;
// Document content outside meshes and nodes.
pub mod other_content;
// glTF meshes to parts.
pub mod mesh;
