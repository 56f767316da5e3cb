//! The images of materials: those of a document for other formats, and those of other formats in a new file.

// The images of a document.
pub mod images;
// The images and textures of a new file.
pub mod new_textures;
