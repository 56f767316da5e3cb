//! Answers to a file of requests, as files: the bits that a browser has to have.

use crate::{Answer, Laboratory};
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

/// Answers the requests of a file, an object with a request for each name. Writes `NAME.json` and, for each buffer, `NAME.NUMBER` to
/// the folder, and calls `answered` with each name, its answer and the time that it took.
///
/// # Errors
/// A file that cannot be read or written, or that is not such an object.
pub fn write_answers(
    requests: &Path,
    folder: &Path,
    mut answered: impl FnMut(&str, &Answer, Duration),
) -> std::io::Result<()> {
    let requests: BTreeMap<String, Value> = serde_json::from_slice(&fs::read(requests)?)?;
    fs::create_dir_all(folder)?;
    let mut laboratory = Laboratory::default();
    for (name, request) in requests {
        let start = Instant::now();
        let answer = laboratory.answer(&request.to_string(), Vec::new());
        answered(&name, &answer, start.elapsed());
        fs::write(folder.join(format!("{name}.json")), &answer.json)?;
        for (number, buffer) in answer.buffers.iter().enumerate() {
            fs::write(folder.join(format!("{name}.{number}")), buffer)?;
        }
    }
    Ok(())
}
