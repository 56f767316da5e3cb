//! The report on a planned mesh file.

use crate::cli::common::console::escaped;
use crate::cli::common::numbers::{change, row, size};
use crease::io::Note;
use crease::plan::FileSize;
use serde::Serialize;

/// A planned file and its input.
#[derive(Debug, Serialize)]
pub struct FileReport {
    pub input: String,
    pub output: String,
    pub before: FileSize,
    pub after: FileSize,
    pub notes: Vec<Note>,
}

impl FileReport {
    pub fn rows(&self, out: &mut String) {
        let sizes = |of: fn(&FileSize) -> u64| (of(&self.before), of(&self.after));
        let file = change(sizes(|it| it.file_bytes), size);
        row(out, "file", &format!("{} -> {}: {file}", escaped(&self.input), escaped(&self.output)));
        let data = [
            change(sizes(|it| it.vertices), |count| format!("{count} vertices")),
            format!("their data {}", change(sizes(|it| it.vertex_bytes), size)),
            format!("indices {}", change(sizes(|it| it.index_bytes), size)),
        ];
        row(out, "data", &data.join("; "));
    }
}
