//! Bytes to meshes and back (layer 2): OBJ, glTF and GLB, PLY, STL; from 3MF.
//!
//! A file is read into a [`Loaded`]: plain [`Mesh`](crate::mesh::Mesh)es, plus the document that they came from. Writing back to
//! the same format edits that document, so that everything else in it survives byte for byte; writing to
//! another format makes a new file from the meshes.

// The file formats.
mod format;
// Errors and notes with their places.
mod error;
// Options of readers and writers, and what a writer returns.
mod options;
// Materials, cameras and lights of a file.
mod appearance;
// Text and numbers in text.
mod text;
// Files that an input refers to.
mod companion_files;
// One mesh of a file, and the edit of it.
mod part;
// A file as it was read.
mod loaded;
// What readers and writers of all formats check.
mod mesh_checks;
// Vertices split for formats that store every value per vertex.
mod split_mesh;
// The formats.
pub mod gltf;
// Wavefront OBJ (appendix B1 of the Advanced Visualizer manual, and the practice of real files).
pub mod obj;
// The polygon file format (Turk 1994, and the practice of real files), ascii and binary.
pub mod ply;
// Stereolithography, ascii and binary (3D Systems 1988, and the practice of real files).
pub mod stl;
// 3MF, which is read only.
pub mod threemf;
// Reading a file of any format: opening it, detecting its format, calling its reader.
mod read;
// Writing a file of any format: edited in its own document, or new.
mod write;

pub use appearance::{
    Appearance, FileCamera, FileImage, FileImages, FileLight, FileLightKind, FileMaterial, FileOptics,
    FileProjection, FileReflection, ImageKind,
};
pub(crate) use companion_files::companion;
pub use error::{Note, Place, Problem, ReadError, Severity, WriteError};
pub use format::Format;
pub(crate) use gltf::NodeTree;
pub use loaded::{Document, Loaded};
pub use options::{
    Emit, Limits, MaterialFallback, Merge, MeshCompression, NonFinite, NormalFormat, ReadLog, ReadOptions,
    TangentPolicy,
};
pub use options::{OutputContent, OutputFile, WriteOptions, Written};
pub use part::{FileNode, Part, PartEdit};
pub(crate) use read::read_whole;
pub use read::{detect, read, read_bytes};
pub use text::shell_word;
pub use write::{write, write_new};
