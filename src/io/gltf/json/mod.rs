//! JSON: a document with the position of every value.

// JSON with byte spans.
pub(super) mod tree;
// Typed access with errors that name the position.
pub(super) mod fields;
// Changes that leave every other byte alone.
pub(super) mod splice;
