//! Answers requests natively, so that tests can compare the bytes with those of the browser.
//!
//!     answers REQUESTS.json FOLDER
//!
//! The file has an object with a request for each name. Writes NAME.json and, for each buffer, NAME.NUMBER to the folder. Prints the
//! milliseconds that each answer takes.

#![allow(clippy::print_stdout, reason = "it prints times")]

use crease_web::Laboratory;
use std::collections::BTreeMap;
use std::error::Error;
use std::fs;
use std::path::PathBuf;
use std::time::Instant;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    let [requests, folder] = &arguments[..] else {
        return Err("usage: answers REQUESTS.json FOLDER".into());
    };
    let requests: BTreeMap<String, serde_json::Value> = serde_json::from_slice(&fs::read(requests)?)?;
    fs::create_dir_all(folder)?;
    let mut laboratory = Laboratory::default();
    for (name, request) in requests {
        let start = Instant::now();
        let answer = laboratory.answer(&request.to_string(), Vec::new());
        println!("{name} {:.3}", start.elapsed().as_secs_f64() * 1e3);
        fs::write(folder.join(format!("{name}.json")), answer.json)?;
        for (number, buffer) in answer.buffers.iter().enumerate() {
            fs::write(folder.join(format!("{name}.{number}")), buffer)?;
        }
    }
    Ok(())
}
