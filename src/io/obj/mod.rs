//! Wavefront OBJ (appendix B1 of the Advanced Visualizer manual, and the practice of real files).
//!
//! The file is parsed as bytes, in pieces of a mebibyte on all threads, which are appended in file order, so that
//! any number of threads gives the same mesh. The text itself is the document: it is kept, and an edit parses it
//! again, because the offsets of a million faces would cost more memory than they save time.
//!
//! Supported are polygons of any size; `v` with a weight (ignored) or a colour; `vt`, `vn`; smoothing groups;
//! `o`, or else `g`, as the object of a face; `usemtl`; `l` and `p`; indices that count back; `\` continuation;
//! comments anywhere; all line ends; any encoding that keeps ASCII. Forward references are accepted. Everything
//! else is kept in the document and noted.

// Bytes to tokens and numbers.
mod cursor;
// Bytes to statements: keywords, statements in order, and the pieces that are parsed in parallel.
mod statements;
// The notes on a file, and the offsets of bad references.
mod notes;
// One piece of the file, parsed on its own.
mod piece;
// All pieces together, and the labels of faces.
mod merge;
// Material libraries.
mod mtl;
// The texture statements of material libraries.
mod texture_statements;
// The file as it was read, and its line numbers.
mod document;
// Bytes to an OBJ document and its mesh.
mod read;
// A new OBJ from any meshes.
mod new_file;
// A new material library.
mod new_library;
// Writing an OBJ back into its own text.
mod edit;

pub use document::{ObjDocument, ObjLines};
pub(super) use edit::edit;
pub(super) use new_file::write;
pub use read::read;

// Tests of the OBJ reader.
#[cfg(test)]
mod tests;
