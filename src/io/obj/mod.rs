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

// Bytes to tokens and statements.
mod cursor;
mod statements;
// The notes on a file.
mod notes;
// Arguments, indices, and a piece of the file.
mod arguments;
mod indices;
mod piece;
// The labels of faces, and the offsets of bad references.
mod bad_references;
mod face_labels;
// All pieces together.
mod merge;
// Material libraries.
mod mtl_files;
mod mtl_materials;
// The file as it was read.
mod document;
mod line_numbers;
mod read;
// Writing.
mod edit;
mod new_file;
mod normal_numbers;

pub use document::ObjDocument;
pub(super) use edit::edit;
pub use line_numbers::ObjLines;
pub(super) use new_file::write;
pub use read::read;

#[cfg(test)]
mod tests;
