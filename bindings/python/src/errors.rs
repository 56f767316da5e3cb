//! Exceptions.

use crate::cli::common::console::HELP;
use crate::cli::common::failure::{Failure, FailureKind};
use crease::io::{self, Place};
use pyo3::create_exception;
use pyo3::exceptions::{PyOSError, PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use std::path::Path;

create_exception!(
    crease_normals,
    ReadError,
    PyValueError,
    "A file cannot be read.\n\n\
     Attributes: `path`; the position as `line` (from 1), `offset` (in bytes, from 0) or `pointer` (JSON pointer into a glTF \
     document), each None if unknown; `help`: the next step."
);
create_exception!(
    crease_normals,
    WriteError,
    PyOSError,
    "An output cannot be made or stored. An existing file is unchanged.\n\n\
     Attribute: `errno`, as of every OSError: ENOENT, EACCES, ENOSPC, EROFS, or None for other reasons."
);

/// A [`ReadError`] with its attributes.
pub fn read_error(py: Python<'_>, path: &Path, error: &io::ReadError) -> PyErr {
    let exception = ReadError::new_err(format!("{}: {error}", path.display()));
    let (mut line, mut offset, mut pointer) = (None, None, None);
    match &error.place {
        Place::File => {}
        Place::Line(number) => line = Some(*number),
        Place::Byte(number) => offset = Some(*number),
        Place::Json(text) => pointer = Some(text.as_str()),
    }
    let value = exception.value(py);
    let set = value
        .setattr("path", path)
        .and_then(|()| value.setattr("line", line))
        .and_then(|()| value.setattr("offset", offset))
        .and_then(|()| value.setattr("pointer", pointer))
        .and_then(|()| value.setattr("help", &error.advice));
    set.map_or_else(|error| error, |()| exception)
}

/// The exception for a failure of the program.
pub fn failure(py: Python<'_>, path: &Path, failure: Failure) -> PyErr {
    if let Some(error) = &failure.read {
        return read_error(py, path, error);
    }
    let (found, help) = failure.message.split_once(HELP).unwrap_or((&failure.message, ""));
    match failure.kind {
        FailureKind::Usage => usage(&failure.message),
        FailureKind::Input => {
            let error = io::ReadError::new(io::Problem::Unsupported, Place::File, found, help);
            read_error(py, path, &error)
        }
        FailureKind::Output => {
            let exception = WriteError::new_err(failure.message.replace(HELP, "; "));
            let set = exception.value(py).setattr("errno", failure.errno);
            set.map_or_else(|error| error, |()| exception)
        }
        FailureKind::Internal => PyRuntimeError::new_err(failure.message.replace(HELP, "; ")),
    }
}

/// A `ValueError` with a message of the program about its options.
pub fn usage(message: &str) -> PyErr {
    PyValueError::new_err(message.replace(HELP, "; "))
}
