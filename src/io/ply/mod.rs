//! The polygon file format (Turk 1994, and the practice of real files), ascii and binary.
//!
//! A header names elements, the columns of each and the number of their rows. Only the elements `vertex`, `face`
//! (or else `tristrips`) and `edge` are understood, and of these only some columns; all others are kept in the document.
//!
//! Ascii rows have a line each in nearly all files, so extra words on a line behind a row are skipped with a warning;
//! if the file then ends too early, it is read again as one stream of words.

// The number types of PLY.
mod scalar;
// The header.
mod header;
// The file as it was read, and the roles of elements and properties.
mod document;
// The body, row by row.
mod rows;
// Bytes to a PLY document and its mesh.
mod read;
// Writing.
mod edit;
// A new PLY from any meshes.
mod new_file;
// How the normals of an element are written back.
mod normal_properties;

pub use document::PlyDocument;
pub(super) use edit::edit;
pub(super) use new_file::write;
pub use read::read;

// Tests of the PLY reader and writers.
#[cfg(test)]
mod tests;
