//! Container: GLB chunks, buffers and their addresses.

// Data URIs and file names.
pub mod uri;
// The GLB container.
pub mod glb;
// The bytes of buffers.
pub mod buffers;
