//! The Python module `crease_normals._native`: normals of NumPy arrays, mesh files, and the program.

// Vertices and faces from arrays, and arrays for results.
mod arrays;
// Options of the program from keyword arguments.
mod command_line;
// Exceptions.
mod errors;
// Faults as an array.
mod faults;
// Normals of arrays.
mod kernels;
// Mesh files.
mod mesh_file;
// Names and angles in arguments.
mod recipe;
mod scratch;
// Threads, the interpreter lock and Ctrl-C.
mod threads;
// Diagnosis, pictures, plans, and the program as a whole.
mod verbs;

// The program, compiled into the module: the wheel has one binary file.
#[path = "../../../src/cli/mod.rs"]
mod cli;

use pyo3::pymodule;

/// Normals of NumPy arrays, mesh files, and the program.
#[pymodule]
mod _native {
    #[pymodule_export]
    use crate::errors::{ReadError, WriteError};
    #[pymodule_export]
    use crate::kernels::{corner_normals, face_normals, split, vertex_normals};
    #[pymodule_export]
    use crate::mesh_file::{Mesh, Part, read};
    #[pymodule_export]
    use crate::verbs::{check_batch, inspect, plan, program, render};

    #[pymodule_export]
    const __VERSION__: &str = env!("CARGO_PKG_VERSION");
}
