//! What is wrong at a byte of a file.

use crate::io::{Place, Problem, ReadError};

/// An error at a byte offset. Its line is counted only once it is reported.
#[derive(Clone, Debug)]
pub(in crate::io) struct Fault {
    pub problem: Problem,
    pub offset: usize,
    pub found: String,
    pub advice: &'static str,
}

impl Fault {
    pub fn new(problem: Problem, offset: usize, found: impl Into<String>, advice: &'static str) -> Self {
        Self { problem, offset, found: found.into(), advice }
    }

    /// The error for the user; `place` is where the offset is.
    pub fn at(self, place: Place) -> ReadError {
        ReadError::new(self.problem, place, self.found, self.advice)
    }
}
