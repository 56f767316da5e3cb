//! An OBJ, and behind a zero byte its material library `m.mtl`, next to the images `t.png` and `t.jpg`.
#![no_main]

use crease::io::Format;
use crease_fuzz::{check_file, fresh_folder, start};
use libfuzzer_sys::fuzz_target;
use std::path::PathBuf;
use std::sync::OnceLock;

static FOLDER: OnceLock<PathBuf> = OnceLock::new();

fuzz_target!(
    init: {
        start();
        let folder = FOLDER.get_or_init(|| fresh_folder("in"));
        for (name, bytes) in [("t.png", &b"\x89PNG\r\n\x1a\n"[..]), ("t.jpg", b"\xff\xd8\xff\xe0")] {
            std::fs::write(folder.join(name), bytes).expect("an image");
        }
    },
    |bytes: &[u8]| {
        let mut halves = bytes.splitn(2, |&byte| byte == 0);
        let obj = halves.next().unwrap_or_default();
        let folder = FOLDER.get().zip(halves.next()).map(|(folder, library)| {
            std::fs::write(folder.join("m.mtl"), library).expect("a library");
            folder.as_path()
        });
        check_file(obj, Format::Obj, folder);
    }
);
