//! Normals of arrays.

use crate::arrays::{
    FaceArrays, Number, Vertices, check_finite, check_separate, from_rows, output, rows, wrong,
};
use crate::faults::fault_array;
use crate::recipe::{WeldArgument, averaging, crease_angle};
use crate::scratch::with_scratch;
use crate::threads::{ThreadCount, interruptible, without_lock};
use crease::mesh::{ColumnIndex, Mesh, MeshBuilder, Weld};
use crease::normals::{
    self, Averaging, Crease, Extras, Fault, Faults, Groups, NormalField, NormalRecipe, Scope, Scratch,
    SliceError,
};
use crease::num::Degrees;
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use rayon::prelude::*;

type Given<'a, 'py> = &'a Bound<'py, PyAny>;

/// Unit normals of vertices: means of the normals of their faces.
///
/// Parameters
/// ----------
/// vertices : array (n, 3)
///     Positions in any unit. C-contiguous float32 and float64 are read in place; other types and layouts are converted
///     once, to float64 unless they are float32.
/// faces : array (m, 3) of integers, or tuple (indices, offsets)
///     Triangles, counter-clockwise from outside, indices from 0. C-contiguous uint32 is read in place; other integers are
///     converted once. Polygons are a tuple: the vertices of all corners (c,), and where each face starts (m + 1,), from 0 to c.
/// weight : str
///     "angle" at the corner (Thürmer and Wüthrich 1998); "area" of the face; "uniform" (Gouraud 1971); "angle-area", their
///     product; "max", the area over the squared lengths of both edges (Max 1999); "edge", one over the lengths of both edges (Max
///     1999); the fits "quadric" (least squares, two-ring) and "jet" of degree 3 (Cazals and Pouget 2005); or "best", which chooses
///     by the mesh. Fits and polygons copy the mesh.
/// slivers : str
///     "exclude" ignores faces whose height is below the rounding of their coordinates; "keep" counts them.
/// precision : str
///     "faithful": sums in double precision. "fast": sums in single precision, eight triangles at a time.
/// threads : int, optional
///     Maximum number of threads; default: one for each processor. It changes no bit of the result.
/// out : array (n, 3), optional
///     C-contiguous, writeable, of the same type as the result; it is filled and returned.
/// return_faults : bool
///     Also return the elements that have a fallback normal or are ignored.
///
/// Returns
/// -------
/// normals : array (n, 3)
///     float32 if vertices is float32, else float64. All are finite and of unit length. A vertex without a defined normal has
///     a fallback: the sum of the normals of its faces without weights, else the first of them, else +z.
/// faults : structured array, with return_faults only
///     element ("face", "corner", "vertex"), index (uint32) and reason ("ZeroArea", "BelowStorage", "CancellingFan",
///     "OutOfRange", "Unreferenced").
///
/// Raises
/// ------
/// ValueError
///     Wrong shape or type, no vertices or faces, a position that is not finite, an index that is negative or out of range, an
///     unknown name, or an `out` that does not fit or is read-only. In these cases `out` stays unchanged.
///
/// Notes
/// -----
/// The interpreter lock is released: other threads must not change the arrays during the call. Ctrl-C ends fits and
/// polygons at once, other calls when they are done.
#[pyfunction]
#[pyo3(signature = (vertices, faces, *, weight="angle", slivers="exclude", precision="faithful", threads=None, out=None, return_faults=false))]
#[expect(clippy::too_many_arguments, reason = "one for each argument in Python")]
pub fn vertex_normals<'py>(
    py: Python<'py>,
    vertices: Given<'_, 'py>,
    faces: Given<'_, 'py>,
    weight: &str,
    slivers: &str,
    precision: &str,
    threads: Option<ThreadCount>,
    out: Option<Given<'_, 'py>>,
    return_faults: bool,
) -> PyResult<Bound<'py, PyAny>> {
    let averaging = averaging(weight, slivers, precision)?;
    check_separate(out, [vertices, faces])?;
    let faces = FaceArrays::new(faces)?;
    let (normals, faults) = match Vertices::new(vertices)? {
        Vertices::Single(array) => of_vertices(py, &array, &faces, averaging, threads, out)?,
        Vertices::Double(array) => of_vertices(py, &array, &faces, averaging, threads, out)?,
    };
    with_faults(normals, &faults, return_faults)
}

/// Unit normals of faces.
///
/// Triangle: (P1 − P0) × (P2 − P0), made unit. Polygon: its vector area, made unit. With float32 each component is
/// within 1 ulp of the exact value; with float64 the normal is within 1e-12 rad. A face without a direction has the unit sum
/// of the normals of its neighbours, else +z, and is in the faults with its reason.
///
/// Parameters
/// ----------
/// vertices : array (n, 3)
/// faces : array (m, 3) of integers, or tuple (indices, offsets)
/// threads : int, optional
/// out : array (m, 3), optional
/// return_faults : bool
///     All as for `vertex_normals`.
///
/// Returns
/// -------
/// normals : array (m, 3)
///     float32 if vertices is float32, else float64; finite and of unit length.
/// faults : structured array, with return_faults only
///
/// Raises
/// ------
/// ValueError
///     As `vertex_normals`.
#[pyfunction]
#[pyo3(signature = (vertices, faces, *, threads=None, out=None, return_faults=false))]
pub fn face_normals<'py>(
    py: Python<'py>,
    vertices: Given<'_, 'py>,
    faces: Given<'_, 'py>,
    threads: Option<ThreadCount>,
    out: Option<Given<'_, 'py>>,
    return_faults: bool,
) -> PyResult<Bound<'py, PyAny>> {
    check_separate(out, [vertices, faces])?;
    let faces = FaceArrays::new(faces)?;
    let (normals, faults) = match Vertices::new(vertices)? {
        Vertices::Single(array) => of_faces(py, &array, &faces, threads, out)?,
        Vertices::Double(array) => of_faces(py, &array, &faces, threads, out)?,
    };
    with_faults(normals, &faults, return_faults)
}

/// Indexed normals of corners: one for each vertex and smooth group, so that creases stay sharp.
///
/// Edges with a dihedral angle above the crease angle are sharp, and so are edges of one face, of more than two, and between faces
/// of opposite winding. They divide the faces around a vertex into smooth groups.
///
/// Parameters
/// ----------
/// vertices : array (n, 3)
/// faces : array (m, 3) of integers, or tuple (indices, offsets)
///     As for `vertex_normals`.
/// crease : float or None
///     The crease angle in degrees, from 0 (each face is flat) to 180. None: no angle is a crease.
/// weld : "off", "exact" or float
///     Whether edges that have equal positions but different vertices are joined, as in meshes from STL: "exact", or closer than
///     this fraction of the bounding box's diagonal.
/// weight, slivers, precision, threads, return_faults
///     As for `vertex_normals`.
///
/// Returns
/// -------
/// normals : array (k, 3)
///     float32 if vertices is float32, else float64; ordered by vertex, finite and of unit length.
/// index : array (m, 3) of uint32; (c,) for polygons
///     The row of `normals` for each corner of `faces`.
/// faults : structured array, with return_faults only
///
/// Raises
/// ------
/// ValueError
///     As `vertex_normals`, and if the crease angle is out of range.
#[pyfunction]
#[pyo3(signature = (vertices, faces, *, crease=Some(40.0), weld=WeldArgument::Name("off".into()), weight="angle", slivers="exclude", precision="faithful", threads=None, return_faults=false),
       text_signature = "(vertices, faces, *, crease=40, weld='off', weight='angle', slivers='exclude', precision='faithful', threads=None, return_faults=False)")]
#[expect(clippy::too_many_arguments, reason = "one for each argument in Python")]
pub fn corner_normals<'py>(
    py: Python<'py>,
    vertices: Given<'_, 'py>,
    faces: Given<'_, 'py>,
    crease: Option<f64>,
    weld: WeldArgument,
    weight: &str,
    slivers: &str,
    precision: &str,
    threads: Option<ThreadCount>,
    return_faults: bool,
) -> PyResult<Bound<'py, PyAny>> {
    let smoothing = Smoothing {
        crease: crease_angle(crease)?,
        weld: weld.weld()?,
        averaging: averaging(weight, slivers, precision)?,
        threads,
    };
    let faces = FaceArrays::new(faces)?;
    let (normals, index, faults) = match Vertices::new(vertices)? {
        Vertices::Single(array) => indexed(py, &array, &faces, &smoothing)?,
        Vertices::Double(array) => indexed(py, &array, &faces, &smoothing)?,
    };
    let mut results = vec![normals, faces.like_corners(py, index)?];
    if return_faults {
        results.push(fault_array(py, &faults)?);
    }
    Ok(PyTuple::new(py, results)?.into_any())
}

/// Vertex buffers for a GPU: each vertex has one normal, and vertices on creases are repeated.
///
/// Parameters
/// ----------
/// vertices, faces, crease, weld, weight, slivers, precision, threads, return_faults
///     As for `corner_normals`.
///
/// Returns
/// -------
/// vertices : array (k, 3)
///     Positions, of the same type as the normals. Vertices that no face uses are omitted.
/// faces : array (m, 3) of uint32, or tuple (indices, offsets)
///     The same faces with the new vertices.
/// normals : array (k, 3)
///     As from `corner_normals`: float32 if vertices is float32, else float64.
/// source : array (k,) of uint32
///     The row of the given vertices that each new vertex copies, to copy uv and other attributes: `uv[source]`.
/// faults : structured array, with return_faults only
///
/// Raises
/// ------
/// ValueError
///     As `corner_normals`.
#[pyfunction]
#[pyo3(signature = (vertices, faces, *, crease=Some(40.0), weld=WeldArgument::Name("off".into()), weight="angle", slivers="exclude", precision="faithful", threads=None, return_faults=false),
       text_signature = "(vertices, faces, *, crease=40, weld='off', weight='angle', slivers='exclude', precision='faithful', threads=None, return_faults=False)")]
#[expect(clippy::too_many_arguments, reason = "one for each argument in Python")]
pub fn split<'py>(
    py: Python<'py>,
    vertices: Given<'_, 'py>,
    faces: Given<'_, 'py>,
    crease: Option<f64>,
    weld: WeldArgument,
    weight: &str,
    slivers: &str,
    precision: &str,
    threads: Option<ThreadCount>,
    return_faults: bool,
) -> PyResult<Bound<'py, PyAny>> {
    let smoothing = Smoothing {
        crease: crease_angle(crease)?,
        weld: weld.weld()?,
        averaging: averaging(weight, slivers, precision)?,
        threads,
    };
    let arrays = FaceArrays::new(faces)?;
    let (positions, source, normals, index, faults) = match Vertices::new(vertices)? {
        Vertices::Single(array) => divided(py, &array, &arrays, &smoothing)?,
        Vertices::Double(array) => divided(py, &array, &arrays, &smoothing)?,
    };
    let index = arrays.like_corners(py, index)?;
    let mut results = vec![positions, arrays.with_corners(faces, index)?, normals, source];
    if return_faults {
        results.push(fault_array(py, &faults)?);
    }
    Ok(PyTuple::new(py, results)?.into_any())
}

/// What determines the normals of corners, and the threads that must not.
struct Smoothing {
    crease: Degrees,
    weld: Weld,
    averaging: Averaging,
    threads: Option<ThreadCount>,
}

fn with_faults<'py>(
    normals: Bound<'py, PyAny>,
    faults: &Faults,
    wanted: bool,
) -> PyResult<Bound<'py, PyAny>> {
    if !wanted {
        return Ok(normals);
    }
    let py = normals.py();
    Ok(PyTuple::new(py, [normals, fault_array(py, faults)?])?.into_any())
}

/// Why arrays are refused. The exception is made when the interpreter lock is held again.
enum Refusal {
    NotFinite(String),
    Slices(SliceError),
}

impl From<String> for Refusal {
    fn from(text: String) -> Self {
        Self::NotFinite(text)
    }
}

impl From<SliceError> for Refusal {
    fn from(error: SliceError) -> Self {
        Self::Slices(error)
    }
}

impl Refusal {
    /// In terms of the arguments, of which `vertices` has `count` rows.
    fn exception(self, faces: &FaceArrays<'_>, count: usize) -> PyErr {
        wrong(match self {
            Self::NotFinite(text) => text,
            Self::Slices(error) => faces.out_of_range(count).unwrap_or_else(|| error.to_string()),
        })
    }
}

fn of_vertices<'py, T: Number + Into<f64>>(
    py: Python<'py>,
    array: &PyReadonlyArray2<'py, T>,
    faces: &FaceArrays<'py>,
    averaging: Averaging,
    threads: Option<ThreadCount>,
    out: Option<Given<'_, 'py>>,
) -> PyResult<(Bound<'py, PyAny>, Faults)> {
    let points = rows(array);
    let mut target = output::<T>(py, out, points.len())?;
    let normals = target.as_slice_mut()?.as_chunks_mut().0;
    let faults = match faces.as_triangles().filter(|_| !averaging.weight.is_fit()) {
        Some(triangles) => without_lock(py, threads, || {
            check_finite(points)?;
            let compute =
                |scratch: &mut _| normals::vertex_normals(points, triangles, averaging, scratch, normals);
            with_scratch(points.len(), compute).map_err(Refusal::from)
        })?
        .map_err(|refusal| refusal.exception(faces, points.len()))?,
        None => {
            let recipe = recipe(averaging, Scope::Vertex, Degrees(180.0), Weld::Off);
            let (mesh, field) = field(py, points, faces, recipe, Extras::NONE, threads)?;
            normals.fill(T::rounded(glam::DVec3::Z));
            for (&vertex, &normal) in field.entry_vertex.iter().zip(&field.normals.values) {
                normals[vertex as usize] = T::rounded(normal);
            }
            of_vertices_in(&mesh, field.faults)
        }
    };
    Ok((target.as_any().clone(), faults))
}

/// Faults of corners as those of their vertices, where all corners of a vertex share a normal.
fn of_vertices_in(mesh: &Mesh, faults: Faults) -> Faults {
    let corners = mesh.faces().corners();
    let vertex = |fault: Fault| Fault { index: corners[fault.index as usize], ..fault };
    let mut vertices: Vec<Fault> = faults.corners.into_iter().map(vertex).chain(faults.vertices).collect();
    vertices.sort_unstable();
    vertices.dedup_by_key(|fault| fault.index);
    Faults { corners: Vec::new(), vertices, ..faults }
}

fn of_faces<'py, T: Number + Into<f64>>(
    py: Python<'py>,
    array: &PyReadonlyArray2<'py, T>,
    faces: &FaceArrays<'py>,
    threads: Option<ThreadCount>,
    out: Option<Given<'_, 'py>>,
) -> PyResult<(Bound<'py, PyAny>, Faults)> {
    let points = rows(array);
    let mut target = output::<T>(py, out, faces.len())?;
    let normals = target.as_slice_mut()?.as_chunks_mut().0;
    let faults = match faces.as_triangles() {
        Some(triangles) => without_lock(py, threads, || {
            check_finite(points)?;
            let compute = |scratch: &mut _| normals::face_normals(points, triangles, scratch, normals);
            with_scratch(triangles.len(), compute).map_err(Refusal::from)
        })?
        .map_err(|refusal| refusal.exception(faces, points.len()))?,
        None => {
            let recipe = recipe(Averaging::default(), Scope::Vertex, Degrees(180.0), Weld::Off);
            let extras = Extras { face_normals: true, edge_counts: false };
            let (_, field) = field(py, points, faces, recipe, extras, threads)?;
            for (target, &normal) in normals.iter_mut().zip(&field.face_normals) {
                *target = T::rounded(normal);
            }
            Faults { faces: field.faults.faces, ..Faults::default() }
        }
    };
    Ok((target.as_any().clone(), faults))
}

/// Normals as an array, the entry of each corner, and the faults.
fn indexed<'py, T: Number + Into<f64>>(
    py: Python<'py>,
    array: &PyReadonlyArray2<'py, T>,
    faces: &FaceArrays<'py>,
    smoothing: &Smoothing,
) -> PyResult<(Bound<'py, PyAny>, Vec<u32>, Faults)> {
    let (normals, index, faults) = of_corners(py, rows(array), faces, smoothing)?;
    Ok((from_rows(py, normals)?, index, faults))
}

/// Positions, sources and normals of the new vertices, the new vertex of each corner, and the faults.
#[expect(clippy::type_complexity, reason = "the results of one function in Python")]
fn divided<'py, T: Number + Into<f64>>(
    py: Python<'py>,
    array: &PyReadonlyArray2<'py, T>,
    faces: &FaceArrays<'py>,
    smoothing: &Smoothing,
) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>, Bound<'py, PyAny>, Vec<u32>, Faults)> {
    let points = rows(array);
    let (normals, index, faults) = of_corners(py, points, faces, smoothing)?;
    let corners = faces.corners();
    let (positions, source) = without_lock(py, smoothing.threads, || {
        let mut source = vec![0; normals.len()];
        for (&entry, &vertex) in index.iter().zip(corners) {
            source[entry as usize] = vertex;
        }
        let positions: Vec<[T; 3]> = source.par_iter().map(|&vertex: &u32| points[vertex as usize]).collect();
        (positions, source)
    })?;
    let source = numpy::PyArray1::from_vec(py, source).into_any();
    Ok((from_rows(py, positions)?, source, from_rows(py, normals)?, index, faults))
}

fn of_corners<T: Number + Into<f64>>(
    py: Python<'_>,
    points: &[[T; 3]],
    faces: &FaceArrays<'_>,
    smoothing: &Smoothing,
) -> PyResult<(Vec<[T; 3]>, Vec<u32>, Faults)> {
    let &Smoothing { crease, weld, averaging, threads } = smoothing;
    let plain = faces.as_triangles().filter(|_| !averaging.weight.is_fit() && weld == Weld::Off);
    if let Some(triangles) = plain {
        let result = without_lock(py, threads, || {
            check_finite(points)?;
            let (mut normals, mut index) = (Vec::new(), vec![0; 3 * triangles.len()]);
            let scratch = &mut Scratch::new();
            normals::corner_normals(points, triangles, averaging, crease, scratch, &mut normals, &mut index)
                .map(|faults| (normals, index, faults))
                .map_err(Refusal::from)
        })?;
        return result.map_err(|refusal| refusal.exception(faces, points.len()));
    }
    let recipe = recipe(averaging, Scope::Corner, crease, weld);
    let (mesh, field) = field(py, points, faces, recipe, Extras::NONE, threads)?;
    let values = field.normals.values.iter().map(|&normal| T::rounded(normal)).collect();
    let index = match field.normals.index {
        ColumnIndex::PerCorner(index) => index,
        ColumnIndex::PerVertex => mesh.faces().corners().to_vec(),
    };
    Ok((values, index, field.faults))
}

fn recipe(averaging: Averaging, scope: Scope, crease: Degrees, weld: Weld) -> NormalRecipe {
    let Averaging { weight, slivers, precision } = averaging;
    let groups = Groups::Ignore;
    NormalRecipe {
        weight,
        slivers,
        precision,
        scope,
        crease: Crease::Angle(crease),
        weld,
        groups,
        ..NormalRecipe::default()
    }
}

/// The normals of a mesh that is a copy of the arrays.
fn field<T: Number + Into<f64>>(
    py: Python<'_>,
    points: &[[T; 3]],
    faces: &FaceArrays<'_>,
    recipe: NormalRecipe,
    extras: Extras,
    threads: Option<ThreadCount>,
) -> PyResult<(Mesh, NormalField)> {
    without_lock(py, threads, || check_finite(points))?.map_err(wrong)?;
    if let Some(text) = faces.out_of_range(points.len()) {
        return Err(wrong(text));
    }
    let builder =
        MeshBuilder { positions: T::positions(points), faces: faces.to_faces(), ..MeshBuilder::default() };
    let result = interruptible(py, threads, move |stop| {
        let mesh = builder.build().map_err(|error| error.to_string())?;
        let field = normals::compute_observed(&mesh, &recipe, extras, &|_, _| stop.check());
        Ok::<_, String>((mesh, field))
    })?;
    result.map_err(wrong)
}
