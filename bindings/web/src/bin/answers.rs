//! Answers requests natively: `answers REQUESTS.json FOLDER` (see [`crease_web::write_answers`]). Prints the milliseconds that each
//! answer takes.

#![allow(clippy::print_stdout, reason = "it prints times")]

use std::error::Error;
use std::path::PathBuf;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    let [requests, folder] = &arguments[..] else {
        return Err("usage: answers REQUESTS.json FOLDER".into());
    };
    let print =
        |name: &str, _: &_, time: std::time::Duration| println!("{name} {:.3}", time.as_secs_f64() * 1e3);
    Ok(crease_web::write_answers(requests, folder, print)?)
}
