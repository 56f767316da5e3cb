//! Mesh files: read, normals computed, written with everything else unchanged.

use crate::arrays::{from_rows, wrong};
use crate::cli::args::Verb;
use crate::cli::common::failure::Failure;
use crate::cli::common::output::{Store, Target, folder_of, stem};
use crate::cli::common::stream::file_target;
use crate::cli::normals::request;
use crate::command_line::Line;
use crate::errors::{failure, read_error, usage};
use crate::threads::{Stop, ThreadCount, interruptible};
use crease::io::{self, Emit, Format, Loaded, NonFinite, PartEdit, ReadOptions, WriteOptions};
use crease::mesh::{Column, ColumnIndex, Faces, NONE, PositionsRef};
use crease::num::UnitVec3;
use crease::pipeline::{self, Revision, Task};
use glam::DVec3;
use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use std::borrow::Cow;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

/// Reads a mesh file: OBJ, PLY, STL, glTF, GLB or 3MF.
///
/// Parameters
/// ----------
/// path : str or path
/// format : str, optional
///     "obj", "ply", "stl", "gltf" or "glb"; default: by the content, else by the name.
/// root : str or path, optional
///     Files that the file refers to must be in this folder; default: the folder of the file.
/// allow_extension : sequence of str
///     glTF extensions to accept although they are unknown.
/// force : bool
///     Drop faces whose positions are not finite, in place of an error.
/// threads : int, optional
///
/// Returns
/// -------
/// Mesh
///
/// Raises
/// ------
/// ReadError
///     The file is missing, truncated or wrong. Its attributes have the path and the line or the byte offset.
/// ValueError
///     An unknown format.
#[pyfunction]
#[pyo3(signature = (path, *, format=None, root=None, allow_extension=vec![], force=false, threads=None),
       text_signature = "(path, *, format=None, root=None, allow_extension=(), force=False, threads=None)")]
pub fn read(
    py: Python<'_>,
    path: PathBuf,
    format: Option<&str>,
    root: Option<PathBuf>,
    allow_extension: Vec<String>,
    force: bool,
    threads: Option<ThreadCount>,
) -> PyResult<Mesh> {
    let format = format.map(format_of).transpose()?;
    let non_finite = if force { NonFinite::DropFaces } else { NonFinite::Refuse };
    let options =
        ReadOptions { root, non_finite, allowed_extensions: allow_extension, ..ReadOptions::default() };
    let file = path.clone();
    let loaded = interruptible(py, threads, move |_| io::read(&file, format, &options))?;
    let loaded = loaded.map_err(|error| read_error(py, &path, &error))?;
    let read = Arc::new(loaded);
    Ok(Mesh { path, state: Mutex::new(State { loaded: read.clone(), read, computed: None }) })
}

fn format_of(name: &str) -> PyResult<Format> {
    let format = Format::from_path(Path::new(&format!("mesh.{name}")));
    format.ok_or_else(|| wrong(format!("format is {name:?}; use obj, ply, stl, gltf or glb")))
}

/// A mesh file that was read.
#[pyclass(frozen, module = "crease_normals")]
pub struct Mesh {
    path: PathBuf,
    state: Mutex<State>,
}

struct State {
    /// As it was read.
    read: Arc<Loaded>,
    /// With the vertices that the last computation moved.
    loaded: Arc<Loaded>,
    computed: Option<Arc<Computed>>,
}

/// Normals, and how they were asked for.
struct Computed {
    task: Task,
    write: WriteOptions,
    edits: Vec<PartEdit>,
    /// Vertices were moved, so that the file cannot be edited in its own format.
    has_moved: bool,
}

impl Mesh {
    fn state(&self) -> (Arc<Loaded>, Option<Arc<Computed>>) {
        let state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        (state.loaded.clone(), state.computed.clone())
    }
}

#[pymethods]
impl Mesh {
    /// The path that the file was read from.
    #[getter]
    fn path(&self) -> &Path {
        &self.path
    }

    /// The format of the file: "obj", "ply", "stl", "gltf", "glb" or "3mf".
    #[getter]
    fn format(&self) -> &'static str {
        self.state().0.format.extension()
    }

    /// What was repaired or skipped, as a list of str.
    #[getter]
    fn notes(&self) -> Vec<String> {
        self.state().0.notes.iter().map(ToString::to_string).collect()
    }

    /// The meshes of the file, as a list of Part: one for OBJ and PLY, one for each solid of STL and each mesh of glTF.
    #[getter]
    fn parts(&self) -> Vec<Part> {
        let (loaded, computed) = self.state();
        let part = |number| Part { loaded: loaded.clone(), computed: computed.clone(), number };
        (0..loaded.parts.len()).map(part).collect()
    }

    /// Computes normals, which `write` stores and `parts` have from now on.
    ///
    /// Parameters
    /// ----------
    /// threads : int, optional
    /// **options
    ///     The options of `crease normals`, with underscores: crease=40 (degrees, or "off"), weight="angle", crease_rule="fan",
    ///     groups="honour", hard_edges=("uv", "material"), weld="exact", slivers, precision, emit, when, orient, flip=True, degenerate,
    ///     merge, tangents, normal_format. `python -m crease_normals normals --help` describes them. Not those that convert a written
    ///     file (up, scale).
    ///
    /// Returns
    /// -------
    /// list of dict
    ///     The counts of each part: vertices, faces, splits, edges, faults and more, as in the member `parts` of
    ///     `crease normals --json`.
    ///
    /// Raises
    /// ------
    /// ValueError
    ///     An unknown option or value.
    #[pyo3(signature = (*, threads=None, **options))]
    fn normals<'py>(
        &self,
        py: Python<'py>,
        threads: Option<ThreadCount>,
        options: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let line = Line::new("normals", &self.path, options)?.with_flag("--dry-run");
        let read = self.state.lock().unwrap_or_else(PoisonError::into_inner).read.clone();
        let mut loaded = read.clone();
        let (task, write, moves) = requested(&line).map_err(|error| failure(py, &self.path, error))?;
        let (loaded, computed, report) = interruptible(py, threads, move |stop| {
            if let Some(fraction) = moves {
                let mut moved = (*loaded).clone();
                moved.move_together(fraction);
                loaded = Arc::new(moved);
            }
            let Revision { edits, parts } = pipeline::revise(&loaded, &task, None, &|_| stop.check());
            let report = serde_json::to_string(&parts);
            (loaded, Computed { task, write, edits, has_moved: moves.is_some() }, report)
        })?;
        *self.state.lock().unwrap_or_else(PoisonError::into_inner) =
            State { read, loaded, computed: Some(Arc::new(computed)) };
        let report = report.map_err(|error| wrong(error.to_string()))?;
        py.import("json")?.call_method1("loads", (report,))
    }

    /// Writes the file: in its own format with only the normals changed, else as a new file.
    ///
    /// Parameters
    /// ----------
    /// path : str or path
    ///     It is replaced as a whole or not at all. Without normals computed before, stored ones are kept.
    /// format : str, optional
    ///     "obj", "ply", "stl", "gltf" or "glb"; default: by the name.
    /// sync : bool
    ///     Wait until the output is on the disk.
    /// threads : int, optional
    ///
    /// Returns
    /// -------
    /// list of str
    ///     What the format could not keep.
    ///
    /// Raises
    /// ------
    /// WriteError
    ///     The format cannot hold the mesh, or the file cannot be written.
    /// ValueError
    ///     An unknown format.
    #[pyo3(signature = (path, *, format=None, sync=false, threads=None))]
    fn write(
        &self,
        py: Python<'_>,
        path: PathBuf,
        format: Option<&str>,
        sync: bool,
        threads: Option<ThreadCount>,
    ) -> PyResult<Vec<String>> {
        let to = format.map(format_of).transpose()?;
        if path.is_dir() {
            return Err(wrong(format!("{} is a folder; name a file in it", path.display())));
        }
        let (target, named) = file_target(&path, to).map_err(|message| usage(&message))?;
        let (loaded, computed) = self.state();
        let format = named.unwrap_or(loaded.format);
        if computed.as_ref().is_some_and(|computed| computed.has_moved) && format.edits(loaded.format) {
            return Err(usage(
                "merge with a fraction moves vertices, but an edited file keeps its positions\nhelp: write another format",
            ));
        }
        let emits_faces = computed.as_ref().is_some_and(|computed| computed.task.emit == Emit::Face);
        if emits_faces && !matches!(format, Format::Ply | Format::Stl) {
            let text = format!("emit=\"face\" writes ply or stl, not {}", format.extension());
            return Err(usage(&format!("{text}\nhelp: compute normals with another emit")));
        }
        let result = interruptible(py, threads, move |stop| {
            store(&loaded, computed.as_deref(), format, &target, sync, stop)
        })?;
        result.map_err(|error| failure(py, &self.path, error))
    }

    fn __repr__(&self) -> String {
        let (loaded, _) = self.state();
        let faces: usize = loaded.parts.iter().map(|part| part.mesh.face_count()).sum();
        let vertices: usize = loaded.parts.iter().map(|part| part.mesh.vertex_count()).sum();
        let (parts, path) = (loaded.parts.len(), self.path.display());
        format!("<Mesh {path}: {parts} parts, {vertices} vertices, {faces} faces>")
    }
}

/// The task, the options of the writer and how far vertices move, from a command line.
fn requested(line: &Line) -> Result<(Task, WriteOptions, Option<f64>), Failure> {
    let Verb::Normals(args) = line.parse().map_err(Failure::usage)? else {
        unreachable!("the verb is normals")
    };
    let jobs = request::jobs(&args)?;
    let settings = &jobs.first().expect("the line has an input").settings;
    Ok((settings.task.clone(), settings.write.clone(), settings.merge_distance))
}

fn store(
    loaded: &Loaded,
    computed: Option<&Computed>,
    format: Format,
    target: &Target,
    sync: bool,
    stop: &Stop,
) -> Result<Vec<String>, Failure> {
    let edits = match computed {
        // Facet normals are computed only for this format.
        Some(Computed { task, .. }) if format == Format::Stl => {
            pipeline::revise(loaded, task, Some(format), &|_| stop.check()).edits
        }
        Some(computed) => computed.edits.clone(),
        None => vec![PartEdit::default(); loaded.parts.len()],
    };
    let options = computed.map(|computed| computed.write.clone()).unwrap_or_default();
    let options =
        WriteOptions { stem: target.path().and_then(stem), folder: target.path().map(folder_of), ..options };
    let written = io::write(loaded, edits, format, &options).map_err(Failure::output)?;
    // An interrupted call does not replace the file.
    stop.check();
    let mut notes = written.notes.clone();
    notes.extend(Store::new(sync, false).store(written, target)?.notes);
    Ok(notes.iter().map(ToString::to_string).collect())
}

/// One mesh of a file. Its arrays are copies.
#[pyclass(frozen, module = "crease_normals")]
pub struct Part {
    loaded: Arc<Loaded>,
    computed: Option<Arc<Computed>>,
    number: usize,
}

impl Part {
    fn part(&self) -> &io::Part {
        &self.loaded.parts[self.number]
    }

    fn edit(&self) -> Option<&PartEdit> {
        Some(&self.computed.as_ref()?.edits[self.number])
    }

    /// The faces without those that were dropped, and the corner in the file of each of their corners.
    fn edited_faces(&self) -> (Cow<'_, Faces>, Option<Vec<u32>>) {
        let faces = self.part().mesh.faces();
        match self.edit().filter(|edit| !edit.faces.is_empty()) {
            None => (Cow::Borrowed(faces), None),
            Some(edit) => {
                let (edited, order) = edit.faces.corner_order(faces);
                (Cow::Owned(edited), Some(order))
            }
        }
    }
}

#[pymethods]
impl Part {
    /// The name in the file, possibly empty.
    #[getter]
    fn name(&self) -> &str {
        &self.part().name
    }

    /// Positions: array (n, 3) of float32 or float64, as the file stores them.
    #[getter]
    fn vertices<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        match self.part().mesh.positions() {
            PositionsRef::F32(points) => from_rows(py, points.to_vec()),
            PositionsRef::F64(points) => {
                from_rows(py, points.iter().map(DVec3::to_array).collect::<Vec<_>>())
            }
        }
    }

    /// Faces, as the functions of this module take them: array (m, 3) of uint32 if all are triangles, else a tuple (indices, offsets).
    /// After `Mesh.normals` they are as it has reversed and dropped them.
    #[getter]
    fn faces<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let (faces, _) = self.edited_faces();
        let corners = PyArray1::from_slice(py, faces.corners());
        match faces.offsets() {
            None => Ok(corners.reshape([faces.len(), 3])?.into_any()),
            Some(offsets) => {
                let offsets = PyArray1::from_slice(py, offsets);
                Ok(PyTuple::new(py, [corners, offsets])?.into_any())
            }
        }
    }

    /// The computed normals, else the stored ones, as a tuple (normals, index): array (k, 3) of float64, and one row of it for each
    /// corner (c,), uint32; 4294967295 marks a corner without a normal. None if there are no normals.
    #[getter]
    fn normals<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        let mesh = &self.part().mesh;
        let computed = self.edit().and_then(|edit| edit.normals.as_ref());
        let Some(column) = computed.or(mesh.columns().normals.as_ref()) else { return Ok(None) };
        let mut index = corner_index(column, mesh.faces().corners());
        if let (_, Some(order)) = self.edited_faces() {
            index = order.iter().map(|&corner| index[corner as usize]).collect();
        }
        let unit = |normal: &DVec3| UnitVec3::new(*normal).map_or(*normal, UnitVec3::get).to_array();
        let normals = match computed {
            Some(_) => column.values.iter().map(DVec3::to_array).collect::<Vec<_>>(),
            None => column.values.iter().map(unit).collect(),
        };
        let pair = [from_rows(py, normals)?, PyArray1::from_vec(py, index).into_any()];
        Ok(Some(PyTuple::new(py, pair)?.into_any()))
    }

    fn __repr__(&self) -> String {
        let io::Part { name, mesh, .. } = self.part();
        format!("<Part {name:?}: {} vertices, {} faces>", mesh.vertex_count(), mesh.face_count())
    }
}

fn corner_index(column: &Column<DVec3>, corners: &[u32]) -> Vec<u32> {
    match &column.index {
        ColumnIndex::PerCorner(index) => index.clone(),
        ColumnIndex::PerVertex => {
            let count = column.values.len() as u32;
            corners.iter().map(|&vertex| if vertex < count { vertex } else { NONE }).collect()
        }
    }
}
