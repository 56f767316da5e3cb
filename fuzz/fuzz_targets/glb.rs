//! Any bytes as GLB: as they are, and with the lengths in its header made to suit the content.
#![no_main]

use crease::io::Format;
use crease_fuzz::{check_file, repaired_glb, start};
use libfuzzer_sys::fuzz_target;

fuzz_target!(init: start(), |bytes: &[u8]| {
    check_file(bytes, Format::Glb, None);
    if let Some(repaired) = repaired_glb(bytes).filter(|repaired| repaired != bytes) {
        check_file(&repaired, Format::Glb, None);
    }
});
