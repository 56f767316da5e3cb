//! The exported object that a web worker holds.

use crate::{Answer, Laboratory};
use wasm_bindgen::prelude::wasm_bindgen;

/// A laboratory, and the buffers of its last answer.
#[wasm_bindgen]
#[derive(Default)]
pub struct Door {
    laboratory: Laboratory,
    buffers: Vec<Vec<u8>>,
}

#[wasm_bindgen]
impl Door {
    /// A laboratory without a file.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Answers a request in JSON with JSON. `bytes` is the file of the request `open`, else empty.
    pub fn answer(&mut self, request: &str, bytes: Vec<u8>) -> String {
        let Answer { json, buffers } = self.laboratory.answer(request, bytes);
        self.buffers = buffers;
        json
    }

    /// The number of buffers of the last answer.
    pub fn buffers(&self) -> usize {
        self.buffers.len()
    }

    /// Takes a buffer of the last answer; empty if there is none of this number.
    pub fn take(&mut self, number: usize) -> Vec<u8> {
        self.buffers.get_mut(number).map(std::mem::take).unwrap_or_default()
    }
}
