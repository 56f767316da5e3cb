//! glTF 2.0, as `.gltf` and `.glb`: read, edited without loss, written new.
//!
//! Reading gives one [`Part`](super::Part) a glTF mesh, with all its primitives in it. Editing changes the
//! document's own text and bytes in the few places that must change: JSON is spliced by byte span, binary data
//! are patched in place or appended, and all else stays as it was, extensions and extras and the spelling of
//! numbers included.
//!
//! Standard: Khronos, *glTF 2.0 Specification*, 2021, with `KHR_mesh_quantization`.

// JSON with the position of every value.
mod json;
// Known extensions.
mod extensions;
// GLB chunks, buffers and their addresses.
mod container;
// The typed records of a file, and what they describe.
mod document;
// Reading a file.
mod reader;
// New files from meshes.
mod writer;
// Changes to a document.
mod edit;

pub(super) use document::appearance::appearance;
pub use document::gltf_document::GltfDocument;
pub(crate) use document::nodes::NodeTree;
pub use edit::apply::edit;
pub use reader::read;
pub use writer::new_file::write;
pub(super) use writer::new_file::write_with_materials;
