//! Memory that calls reuse. Fresh memory costs more than the sums: the system clears each page.

use crease::normals::Scratch;
use std::sync::{Mutex, PoisonError};

/// Most elements of a mesh whose memory stays for the next call. After calls of all kinds on two million elements, 150 MB stay.
const MOST: usize = 1 << 21;

/// Calls work with the memory of an earlier call, if no other thread uses it. `elements` is the number of results.
pub fn with_scratch<R>(elements: usize, work: impl FnOnce(&mut Scratch) -> R) -> R {
    static SPARE: Mutex<Option<Scratch>> = Mutex::new(None);
    let spare = || SPARE.lock().unwrap_or_else(PoisonError::into_inner);
    let mut scratch = spare().take().unwrap_or_default();
    let result = work(&mut scratch);
    if elements <= MOST {
        *spare() = Some(scratch);
    }
    result
}
