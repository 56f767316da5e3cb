//! The words that the program was called with. They are not those of the process if Python runs the program.

use std::ffi::OsString;
use std::sync::{PoisonError, RwLock};

static WORDS: RwLock<Vec<OsString>> = RwLock::new(Vec::new());

/// Keeps a command line. Its first word is the name of the program.
pub fn remember(line: &[OsString]) {
    *WORDS.write().unwrap_or_else(PoisonError::into_inner) = line[1..].to_vec();
}

/// The words after the name of the program.
pub fn words() -> Vec<OsString> {
    WORDS.read().unwrap_or_else(PoisonError::into_inner).clone()
}
