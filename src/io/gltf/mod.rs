//! glTF 2.0, as `.gltf` and `.glb`: read, edited without loss, written new.
//!
//! Reading gives one [`Part`](super::Part) a glTF mesh, with all its primitives in it. Editing changes the
//! document's own text and bytes in the few places that must change: JSON is spliced by byte span, binary data
//! are patched in place or appended, and all else stays as it was, extensions and extras and the spelling of
//! numbers included.
//!
//! Standard: Khronos, *glTF 2.0 Specification*, 2021, with `KHR_mesh_quantization`.

// JSON with the byte span of every value.
mod json;
// Typed access to JSON objects, with errors that name the position.
mod fields;
// Changes to a JSON text that leave every other byte alone.
mod splice;
// The GLB container.
mod glb;
// The bytes of buffers, and their addresses.
mod buffers;
// Compressed data to plain ones.
mod compressed;
// Known extensions.
mod extensions;
// The typed records that geometry needs.
mod records;
// Accessors to numbers.
mod accessor;
// A document that is kept for editing.
mod document;
// Primitives and meshes to parts.
mod mesh;
// The vertex columns of a part.
mod columns;
// The node tree.
mod nodes;
// Materials, cameras and lights.
mod appearance;
// Images of materials for other formats.
mod material_images;
// What materials need tangents for.
mod tangent_space;
// Reading a file.
mod read;
// New binary data, and the JSON that describes them.
mod data;
// A new file from meshes.
mod new_file;
// Changes to a document.
mod edit;

pub(super) use appearance::appearance;
pub use document::{GeometryBytes, GltfDocument};
pub use edit::apply::edit;
pub(super) use material_images::materials_with_images;
pub(super) use new_file::write;
pub(crate) use nodes::NodeTree;
pub use read::read;
