//! Container: GLB chunks, buffers and their addresses.

// Data URIs and file names.
pub(super) mod uri;
// The GLB container.
pub(super) mod glb;
// The bytes of buffers.
pub(super) mod buffers;
// A changed document as files.
pub(super) mod package;
