//! No output may replace an input or another output.

use super::output::resolve_parent;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The files that a run reads and writes.
pub struct Files<'a> {
    inputs: BTreeMap<PathBuf, &'a Path>,
    /// Each output with the name of what it is made of.
    outputs: BTreeMap<PathBuf, String>,
}

impl<'a> Files<'a> {
    /// Inputs that do not exist are reported when they are read.
    pub fn read(inputs: impl IntoIterator<Item = &'a Path>) -> Self {
        let real = |path: &'a Path| Some((path.canonicalize().ok()?, path));
        Self { inputs: inputs.into_iter().filter_map(real).collect(), outputs: BTreeMap::new() }
    }

    /// # Errors
    /// If the output is an input.
    pub fn check(&self, output: &Path) -> Result<(), String> {
        match self.inputs.get(&resolve_parent(output)) {
            Some(input) => {
                let input = input.display();
                Err(format!("this would overwrite the input {input}\nhelp: name another output"))
            }
            None => Ok(()),
        }
    }

    /// Adds an output that is made of an input.
    ///
    /// # Errors
    /// If it is another output too.
    pub fn write(&mut self, output: &Path, of: String) -> Result<(), String> {
        let Some(other) = self.outputs.insert(resolve_parent(output), of.clone()) else { return Ok(()) };
        let both = if other == of { "two outputs".into() } else { format!("{other} and {of}") };
        Err(format!("{both} would both be written to {}\nhelp: name a file for each", output.display()))
    }
}
