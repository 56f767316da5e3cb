//! Text and numbers in text: what the readers and writers of text formats share.

// The words of a text, and where its lines end.
pub(super) mod words;
// Line numbers of byte offsets.
pub(super) mod line_numbers;
// Text to numbers.
pub(super) mod parse_number;
// Numbers to text.
pub(super) mod format_number;
// Coordinates that were printed from single precision.
pub(super) mod f32_text;
// Text that is copied with changes.
pub(super) mod changes;
// What is wrong at a byte of a file.
pub(super) mod fault;
// Pieces of messages.
pub(super) mod message;
// File names in commands.
pub(super) mod shell_word;

pub(super) use message::{counted, shown};
