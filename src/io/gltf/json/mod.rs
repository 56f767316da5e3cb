//! JSON: a document with the position of every value.

// JSON with byte spans.
pub mod tree;
// Typed access with errors that name the position.
pub mod fields;
// Changes that leave every other byte alone.
pub mod splice;
