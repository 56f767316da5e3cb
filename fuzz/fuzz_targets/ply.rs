//! Any bytes as PLY.
#![no_main]

use crease::io::Format;
use crease_fuzz::{check_file, start};
use libfuzzer_sys::fuzz_target;

fuzz_target!(init: start(), |bytes: &[u8]| check_file(bytes, Format::Ply, None));
