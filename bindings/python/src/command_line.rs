//! Options of the program from keyword arguments: `crease_rule="cone"` is `--crease-rule cone`.

use crate::cli::args::{Cli, Verb};
use crate::cli::common::console::HELP;
use crate::cli::usage::explanation;
use crate::errors::usage;
use clap::Parser;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyList, PyTuple};
use std::ffi::OsString;
use std::path::Path;

/// Options that name outputs, streams, threads or batches: functions have arguments for these, or return the result.
const EXCLUDED: [&str; 27] = [
    "output",
    "out_dir",
    "in_place",
    "to",
    "dry_run",
    "recursive",
    "json",
    "quiet",
    "verbose",
    "threads",
    "color",
    "help",
    "compare",
    "turntable",
    "probe",
    "html",
    "heatmap",
    "explain",
    "against",
    "sync",
    "manifest",
    "shard",
    "journal",
    "retries",
    "keep_going",
    "jobs",
    "memory",
];
/// Options of `normals` that convert what is written. `Mesh.write` does not convert.
const CONVERSIONS: [&str; 2] = ["up", "scale"];

/// The line of a verb about a file.
pub struct Line(Vec<OsString>);

impl Line {
    /// `crease VERB FILE --json`, and an option for each keyword argument. `True` is an option without a value; `None` and `False` omit
    /// it; a list repeats it; a tuple is joined by commas; a dictionary is a field `name=value` for each item.
    pub fn new(verb: &str, file: &Path, options: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        let mut line: Vec<OsString> = ["crease", verb, "--json"].map(OsString::from).to_vec();
        for (name, value) in options.into_iter().flatten() {
            let name: String = name.extract()?;
            let converts = verb == "normals" && CONVERSIONS.contains(&name.as_str());
            if converts || EXCLUDED.contains(&name.as_str()) {
                return Err(usage(&format!(
                    "unexpected option {name}{HELP}use the program for it: python -m crease_normals {verb}"
                )));
            }
            push(&mut line, &name, &value)?;
        }
        line.extend([OsString::from("--"), file.into()]);
        Ok(Self(line))
    }

    /// Adds an option without a value.
    pub fn with_flag(mut self, flag: &str) -> Self {
        self.0.insert(2, flag.into());
        self
    }

    pub fn parse(&self) -> Result<Verb, String> {
        parse(&self.0[1].to_string_lossy(), &self.0)
    }
}

/// The arguments of a verb from a command line.
pub fn parse(verb: &str, line: &[OsString]) -> Result<Verb, String> {
    Cli::try_parse_from(line).map(|cli| cli.verb).map_err(|error| explanation(verb, &error))
}

fn push(line: &mut Vec<OsString>, name: &str, value: &Bound<'_, PyAny>) -> PyResult<()> {
    let option = format!("--{}", name.trim_end_matches('_').replace('_', "-"));
    if value.is_none() {
        return Ok(());
    }
    if let Ok(flag) = value.cast::<PyBool>() {
        if flag.is_true() {
            line.push(option.into());
        }
        return Ok(());
    }
    if let Ok(list) = value.cast::<PyList>() {
        return list.iter().try_for_each(|value| push(line, name, &value));
    }
    let text = match value.cast::<PyDict>() {
        Ok(fields) => {
            let field = |(name, value): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
                Ok(format!("{}={}", name.str()?.to_cow()?.replace('_', "-"), joined(&value, ",")?))
            };
            let fields: Vec<String> = fields.iter().map(field).collect::<PyResult<_>>()?;
            fields.join(" ")
        }
        Err(_) => joined(value, if name == "size" { "x" } else { "," })?,
    };
    line.push(format!("{option}={text}").into());
    Ok(())
}

/// The text of a value; the items of a tuple with a separator.
fn joined(value: &Bound<'_, PyAny>, separator: &str) -> PyResult<String> {
    match value.cast::<PyTuple>() {
        Ok(tuple) => {
            let items: Vec<String> =
                tuple.iter().map(|item| Ok(item.str()?.to_cow()?.into_owned())).collect::<PyResult<_>>()?;
            Ok(items.join(separator))
        }
        Err(_) => Ok(value.str()?.to_cow()?.into_owned()),
    }
}
