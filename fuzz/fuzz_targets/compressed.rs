//! GLB files with meshopt or Draco data, always with lengths that suit the content, so that mutations reach the decoders.
#![no_main]

use crease::io::Format;
use crease_fuzz::{check_file, repaired_glb, start};
use libfuzzer_sys::fuzz_target;

fuzz_target!(init: start(), |bytes: &[u8]| {
    if let Some(repaired) = repaired_glb(bytes) {
        check_file(&repaired, Format::Glb, None);
    }
});
