//! Stereolithography, ascii and binary (3D Systems 1988, and the practice of real files).
//!
//! A binary file is detected by its length, 84 bytes and 50 a facet, before anything else: its header may begin
//! with `solid`. Facets do not share vertices; each corner of the mesh has one of its own, and corners of one facet
//! share the stored normal. Every solid of an ascii file is a part.

// The file as it was read, and the detection of its layout.
mod document;
// Ascii STL.
mod ascii;
// Bytes to an STL document and its meshes; binary STL.
mod read;
// A new binary STL from any meshes.
mod new_file;
// Writing an STL back into its own bytes.
mod edit;

pub use document::StlDocument;
pub(super) use document::is_certain;
pub(super) use edit::edit;
pub(super) use new_file::write;
pub use read::read;

// Tests of the STL reader and writers.
#[cfg(test)]
mod tests;
