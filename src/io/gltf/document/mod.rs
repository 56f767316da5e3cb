//! Document: the typed records of a file.

// The records that geometry needs.
pub(super) mod records;
// Accessors to numbers.
pub(super) mod accessor;
// Cameras.
pub(super) mod camera;
// Materials, cameras and lights.
pub(super) mod appearance;
// The node tree.
pub(super) mod nodes;
// Primitives.
pub(super) mod primitive;
// Vertex columns.
pub(super) mod columns;
// Tangents and morph targets.
pub(super) mod attributes;
// Document content outside meshes and nodes.
pub(super) mod other_content;
// glTF meshes to parts.
pub(super) mod mesh;
