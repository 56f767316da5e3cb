//! Bytes to meshes and back (layer 2): OBJ, glTF and GLB, PLY, STL.
//!
//! A file is read into a [`Loaded`]: plain [`Mesh`](crate::mesh::Mesh)es, plus the document that they came from. Writing back to
//! the same format edits that document, so that everything else in it survives byte for byte; writing to
//! another format makes a new file from the meshes.

mod appearance;
mod companion;
mod convert;
mod decimal;
mod dispatch;
mod error;
mod format;
pub mod gltf;
mod instances;
mod left_out;
mod loaded;
mod number;
pub mod obj;
mod open;
pub mod ply;
mod remarks;
mod rounding;
mod shell;
mod singles;
pub mod stl;
mod tally;
mod text;

pub use appearance::{
    Appearance, FileCamera, FileLight, FileLightKind, FileMaterial, FileProjection, FileReflection,
};
pub(crate) use companion::companion;
pub use convert::{write, write_new};
pub use error::{Note, Place, Problem, ReadError, Severity, WriteError};
pub use format::Format;
pub(crate) use gltf::NodeTree;
pub use loaded::{
    Document, Emit, FileNode, Limits, Loaded, NonFinite, NormalFormat, OutputContent, OutputFile, Part,
    PartEdit,
};
pub use loaded::{ReadOptions, TangentPolicy, WriteOptions, Written};
pub(crate) use open::read_whole;
pub use open::{detect, read, read_bytes};
pub use shell::shell_word;
