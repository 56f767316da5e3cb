//! Any bytes as the JSON of a glTF.
#![no_main]

use crease::io::Format;
use crease_fuzz::{check_file, start};
use libfuzzer_sys::fuzz_target;

fuzz_target!(init: start(), |bytes: &[u8]| check_file(bytes, Format::Gltf, None));
