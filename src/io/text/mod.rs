//! Text and numbers in text: what the readers and writers of text formats share.

// The words of a text, and where its lines end.
mod words;
// Text to numbers and back.
mod numbers;
// Coordinates that were printed from single precision.
mod f32_text;
// Text that is copied with changes.
mod changes;
// Errors at a byte, line numbers, and pieces of messages.
mod message;

pub(super) use changes::{Changes, Copier};
pub(super) use f32_text::storage_of_text;
pub use message::shell_word;
pub(super) use message::{at_byte, counted, in_text, line_and_column, line_place, line_places, shown};
pub(super) use numbers::{float, float_prefix, integer_prefix, push_f32, push_f64, push_integer, push_row};
pub(super) use words::{Words, is_blank, line_end_length, next_word, without_byte_order_mark};
