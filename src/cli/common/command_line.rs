//! The words that the program was called with. They are not those of the process if Python runs the program.

use std::ffi::OsString;
use std::sync::OnceLock;

static WORDS: OnceLock<Vec<OsString>> = OnceLock::new();

/// Keeps the command line of the process. Its first word is the name of the program.
pub fn remember(line: &[OsString]) {
    WORDS.get_or_init(|| line[1..].to_vec());
}

/// The words after the name of the program.
pub fn words() -> &'static [OsString] {
    WORDS.get().map_or(&[], Vec::as_slice)
}
