//! Document: the typed records of a file, and the meshes, nodes and looks that they describe.

// The records that geometry needs.
pub mod records;
// Accessors to numbers.
pub mod accessor;
// A document that is kept for editing.
pub mod gltf_document;
// Primitives to triangles, lines and points.
pub mod primitive;
// glTF meshes to parts.
pub mod mesh;
// The vertex columns of a part.
pub mod columns;
// The node tree.
pub mod nodes;
// Cameras.
pub mod camera;
// Materials, cameras and lights.
pub mod appearance;
// Content outside meshes and nodes.
pub mod content;
