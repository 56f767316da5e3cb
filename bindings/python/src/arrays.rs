//! Vertices and faces from arrays, and arrays for results. C-contiguous arrays of `float32`, `float64` and `uint32` are used in place,
//! others are converted once.

use crease::mesh::{Faces, Positions};
use crease::normals::Coordinate;
use glam::DVec3;
use numpy::{
    BorrowError, Element, PyArray1, PyArray2, PyArrayDescr, PyArrayDescrMethods, PyArrayMethods,
    PyReadonlyArray1, PyReadonlyArray2, PyReadwriteArray2, PyUntypedArray, PyUntypedArrayMethods, dtype,
};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyList, PyTuple};
use rayon::prelude::*;

/// `f32` or `f64`.
pub trait Number: Coordinate + Element + Copy + Send + Sync {
    fn is_number(self) -> bool;
    fn positions(points: &[[Self; 3]]) -> Positions;
    /// The nearest numbers of this type.
    fn rounded(normal: DVec3) -> [Self; 3];
}

impl Number for f32 {
    fn is_number(self) -> bool {
        self.is_finite()
    }

    fn positions(points: &[[f32; 3]]) -> Positions {
        Positions::F32(points.to_vec())
    }

    fn rounded(normal: DVec3) -> [f32; 3] {
        normal.as_vec3().to_array()
    }
}

impl Number for f64 {
    fn is_number(self) -> bool {
        self.is_finite()
    }

    fn positions(points: &[[f64; 3]]) -> Positions {
        Positions::F64(points.iter().copied().map(DVec3::from).collect())
    }

    fn rounded(normal: DVec3) -> [f64; 3] {
        normal.to_array()
    }
}

pub enum Vertices<'py> {
    Single(PyReadonlyArray2<'py, f32>),
    Double(PyReadonlyArray2<'py, f64>),
}

impl<'py> Vertices<'py> {
    pub fn new(given: &Bound<'py, PyAny>) -> PyResult<Self> {
        let py = given.py();
        let array = as_array(given)?;
        if array.ndim() != 2 || array.shape()[1] != 3 {
            return Err(wrong(format!("vertices has the shape {}; (n, 3) was expected", shape(&array))));
        }
        if array.shape()[0] == 0 {
            return Err(wrong("vertices is empty"));
        }
        let kind = array.dtype().kind();
        match kind {
            b'f' | b'i' | b'u' => {}
            _ => {
                let found = array.dtype();
                return Err(wrong(format!("vertices has the dtype {found}; use float32 or float64")));
            }
        }
        match kind == b'f' && array.dtype().itemsize() == 4 {
            true => Ok(Self::Single(borrowed(required(&array, dtype::<f32>(py))?, "vertices")?)),
            false => Ok(Self::Double(borrowed(required(&array, dtype::<f64>(py))?, "vertices")?)),
        }
    }
}

/// The rows of an array of three columns.
pub fn rows<'a, T: Element>(array: &'a PyReadonlyArray2<'_, T>) -> &'a [[T; 3]] {
    array.as_slice().expect("the array is C-contiguous").as_chunks().0
}

/// Refuses positions that are infinite or not a number.
pub fn check_finite<T: Number + Into<f64>>(points: &[[T; 3]]) -> Result<(), String> {
    const BLOCK: usize = 1 << 13;
    let is_finite = |point: &[T; 3]| point.iter().fold(true, |all, x| all & x.is_number());
    let all_finite = |block: &[[T; 3]]| block.iter().fold(true, |all, point| all & is_finite(point));
    let first = points.par_chunks(BLOCK).position_first(|block| !all_finite(block));
    let Some(row) = first.and_then(|block| {
        points[block * BLOCK..].iter().position(|point| !is_finite(point)).map(|row| block * BLOCK + row)
    }) else {
        return Ok(());
    };
    let [x, y, z] = points[row].map(Into::into);
    Err(format!(
        "vertices[{row}] is ({x}, {y}, {z}), which is not finite; remove it and the faces that use it"
    ))
}

/// Indices in their array, or converted.
enum Indices<'py> {
    Borrowed(PyReadonlyArray1<'py, u32>),
    Converted(Vec<u32>),
}

impl Indices<'_> {
    fn as_slice(&self) -> &[u32] {
        match self {
            Self::Borrowed(array) => array.as_slice().expect("the array is C-contiguous"),
            Self::Converted(indices) => indices,
        }
    }
}

pub struct FaceArrays<'py> {
    corners: Indices<'py>,
    /// `None` for triangles.
    offsets: Option<Indices<'py>>,
}

impl<'py> FaceArrays<'py> {
    /// Triangles as an array (m, 3), or polygons as a tuple of the vertices of all corners and where each face starts.
    pub fn new(given: &Bound<'py, PyAny>) -> PyResult<Self> {
        if let Ok(list) = given.cast::<PyList>()
            && list.len() == 2
            && list.iter().all(|item| item.cast::<PyUntypedArray>().is_ok_and(|item| item.ndim() == 1))
        {
            return Self::new(&list.to_tuple());
        }
        let found = match given.cast::<PyTuple>() {
            Ok(pair) if pair.len() == 2 => Self::polygons(&pair.get_item(0)?, &pair.get_item(1)?)?,
            Ok(other) => {
                let text =
                    format!("faces is a tuple of {}; use an array, or (indices, offsets)", other.len());
                return Err(wrong(text));
            }
            Err(_) => Self::triangles(given)?,
        };
        if found.corners.as_slice().is_empty() {
            return Err(wrong("faces is empty"));
        }
        Ok(found)
    }

    fn triangles(given: &Bound<'py, PyAny>) -> PyResult<Self> {
        let array = as_array(given)?;
        if array.ndim() != 2 || array.shape()[1] != 3 {
            let text = "(m, 3) was expected; pass polygons as (indices, offsets)";
            return Err(wrong(format!("faces has the shape {}; {text}", shape(&array))));
        }
        Ok(Self { corners: indices(&array, "faces", true)?, offsets: None })
    }

    fn polygons(corners: &Bound<'py, PyAny>, offsets: &Bound<'py, PyAny>) -> PyResult<Self> {
        let one_dimension = |given: &Bound<'py, PyAny>, name: &str| {
            let array = as_array(given)?;
            if array.ndim() != 1 {
                let text = format!(
                    "the {name} of faces have the shape {}; one dimension was expected",
                    shape(&array)
                );
                return Err(wrong(text));
            }
            indices(&array, name, false)
        };
        let (corners, offsets) = (one_dimension(corners, "indices")?, one_dimension(offsets, "offsets")?);
        let (starts, count) = (offsets.as_slice(), corners.as_slice().len());
        if starts.first() != Some(&0) || starts.last().map(|&last| last as usize) != Some(count) {
            let text = format!("offsets must start with 0 and end with {count}, the number of indices");
            return Err(wrong(text));
        }
        if let Some(face) = starts.windows(2).position(|pair| pair[1] < pair[0].saturating_add(3)) {
            let (start, end) = (starts[face], starts[face + 1]);
            return Err(wrong(format!(
                "offsets[{face}] is {start} and offsets[{}] is {end}; a face needs 3 corners",
                face + 1
            )));
        }
        Ok(Self { corners, offsets: Some(offsets) })
    }

    /// The triangles; `None` for polygons.
    pub fn as_triangles(&self) -> Option<&[[u32; 3]]> {
        self.offsets.is_none().then(|| self.corners.as_slice().as_chunks().0)
    }

    pub fn corners(&self) -> &[u32] {
        self.corners.as_slice()
    }

    pub fn len(&self) -> usize {
        self.offsets.as_ref().map_or(self.corners().len() / 3, |offsets| offsets.as_slice().len() - 1)
    }

    pub fn to_faces(&self) -> Faces {
        match &self.offsets {
            None => Faces::triangles(self.corners().to_vec()),
            Some(offsets) => Faces::polygons(self.corners().to_vec(), offsets.as_slice().to_vec()),
        }
    }

    /// How an error names a corner.
    pub fn out_of_range(&self, count: usize) -> Option<String> {
        let corner = self.corners().iter().position(|&vertex| vertex as usize >= count)?;
        let name = match self.offsets {
            None => format!("faces[{}, {}]", corner / 3, corner % 3),
            Some(_) => format!("indices[{corner}]"),
        };
        let vertex = self.corners()[corner];
        Some(format!("{name} is {vertex}, but vertices has {count} rows; indices count from 0"))
    }

    /// An array of one number for each corner, in the shape of the indices.
    pub fn like_corners(&self, py: Python<'py>, index: Vec<u32>) -> PyResult<Bound<'py, PyAny>> {
        let flat = PyArray1::from_vec(py, index);
        match self.offsets {
            None => Ok(flat.reshape([self.len(), 3])?.into_any()),
            Some(_) => Ok(flat.into_any()),
        }
    }

    /// These faces with other vertices; polygons keep their offsets.
    pub fn with_corners(
        &self,
        given: &Bound<'py, PyAny>,
        corners: Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        if self.offsets.is_none() {
            return Ok(corners);
        }
        Ok(PyTuple::new(given.py(), [corners, given.get_item(1)?])?.into_any())
    }
}

/// The array for a result of `n` rows: the caller's, or a new one.
pub fn output<'py, T: Element>(
    py: Python<'py>,
    given: Option<&Bound<'py, PyAny>>,
    n: usize,
) -> PyResult<PyReadwriteArray2<'py, T>> {
    let Some(given) = given else {
        // Without zeros, which a result overwrites.
        let empty = py.import("numpy")?.call_method1("empty", ((n, 3), dtype::<T>(py)))?;
        return Ok(empty.cast_into::<PyArray2<T>>()?.readwrite());
    };
    let fits = given.cast::<PyArray2<T>>().ok().filter(|out| out.shape() == [n, 3] && out.is_c_contiguous());
    let Some(out) = fits else {
        let expected = dtype::<T>(py);
        return Err(wrong(format!("out must be a C-contiguous array of {expected} with the shape ({n}, 3)")));
    };
    out.try_readwrite().map_err(|error| match error {
        BorrowError::NotWriteable => wrong("out is read-only; pass an array that can be written"),
        _ => wrong("another thread uses out; pass an array of its own"),
    })
}

/// Refuses an array for results that shares memory with an argument.
pub fn check_separate(out: Option<&Bound<'_, PyAny>>, arguments: [&Bound<'_, PyAny>; 2]) -> PyResult<()> {
    let Some(out) = out.filter(|out| out.cast::<PyUntypedArray>().is_ok()) else { return Ok(()) };
    let parts = arguments.into_iter().flat_map(|given| match given.cast::<PyTuple>() {
        Ok(pair) => pair.iter().collect(),
        Err(_) => vec![given.clone()],
    });
    for part in parts.filter(|part| part.cast::<PyUntypedArray>().is_ok()) {
        if out.py().import("numpy")?.call_method1("may_share_memory", (out, part))?.is_truthy()? {
            return Err(wrong("out shares memory with vertices or faces; pass an array of its own"));
        }
    }
    Ok(())
}

/// An array of rows, without a copy.
pub fn from_rows<T: Element>(py: Python<'_>, rows: Vec<[T; 3]>) -> PyResult<Bound<'_, PyAny>> {
    let count = rows.len();
    Ok(PyArray1::from_vec(py, rows.into_flattened()).reshape([count, 3])?.into_any())
}

pub fn wrong(text: impl Into<String>) -> PyErr {
    PyValueError::new_err(text.into())
}

fn as_array<'py>(given: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyUntypedArray>> {
    if let Ok(array) = given.cast::<PyUntypedArray>() {
        return Ok(array.clone());
    }
    Ok(given.py().import("numpy")?.call_method1("asarray", (given,))?.cast_into()?)
}

/// The shape of an array, as Python prints it.
fn shape(array: &Bound<'_, PyUntypedArray>) -> String {
    let sizes: Vec<String> = array.shape().iter().map(usize::to_string).collect();
    match &sizes[..] {
        [one] => format!("({one},)"),
        sizes => format!("({})", sizes.join(", ")),
    }
}

/// The array itself if it has the type, is C-contiguous and aligned; else a copy that is.
fn required<'py>(
    array: &Bound<'py, PyUntypedArray>,
    dtype: Bound<'py, PyArrayDescr>,
) -> PyResult<Bound<'py, PyAny>> {
    array.py().import("numpy")?.call_method1("require", (array, dtype, ["C_CONTIGUOUS", "ALIGNED"]))
}

fn borrowed<'py, T: Element>(array: Bound<'py, PyAny>, name: &str) -> PyResult<PyReadonlyArray2<'py, T>> {
    let array = array.cast_into::<PyArray2<T>>()?;
    let readonly = array.try_readonly();
    readonly.map_err(|_| wrong(format!("another thread writes to {name}; wait until it ends")))
}

/// The numbers of an array as unsigned 32-bit ones.
fn indices<'py>(
    array: &Bound<'py, PyUntypedArray>,
    name: &str,
    is_triangles: bool,
) -> PyResult<Indices<'py>> {
    let py = array.py();
    let kind = array.dtype().kind();
    if !matches!(kind, b'i' | b'u') {
        let found = array.dtype();
        return Err(wrong(format!("{name} has the dtype {found}; use uint32 or another integer type")));
    }
    let flat = |dtype| required(array, dtype)?.call_method1("reshape", (-1,));
    if kind == b'u' && array.dtype().itemsize() == 4 {
        let flat = flat(dtype::<u32>(py))?.cast_into::<PyArray1<u32>>()?;
        let readonly = flat.try_readonly();
        let readonly =
            readonly.map_err(|_| wrong(format!("another thread writes to {name}; wait until it ends")));
        return Ok(Indices::Borrowed(readonly?));
    }
    let converted = match (kind, array.dtype().itemsize()) {
        (_, 4) => converted::<i32>(flat(dtype::<i32>(py))?)?,
        (b'u', 8) => converted::<u64>(flat(dtype::<u64>(py))?)?,
        _ => converted::<i64>(flat(dtype::<i64>(py))?)?,
    };
    converted.map(Indices::Converted).map_err(|(at, found)| {
        let place = if is_triangles { format!("{}, {}", at / 3, at % 3) } else { at.to_string() };
        let reason = if found < 0 { "indices count from 0" } else { "the largest index is 4294967294" };
        wrong(format!("{name}[{place}] is {found}; {reason}"))
    })
}

/// Integers as unsigned 32-bit ones, or the first that is none, with its position.
fn converted<T: Element + Copy + Into<i128> + Send + Sync>(
    array: Bound<'_, PyAny>,
) -> PyResult<Result<Vec<u32>, (usize, i128)>> {
    let array = array.cast_into::<PyArray1<T>>()?;
    let readonly = array.try_readonly().map_err(|error| wrong(error.to_string()))?;
    let numbers = readonly.as_slice()?;
    let indices: Vec<u32> = numbers.iter().map(|&number| number.into() as u32).collect();
    let is_same = numbers
        .iter()
        .zip(&indices)
        .fold(true, |all, (&number, &index)| all & (number.into() == i128::from(index)));
    if is_same {
        return Ok(Ok(indices));
    }
    let wrong = numbers.iter().map(|&number| number.into()).enumerate();
    let mut wrong = wrong.filter(|(_, number): &(usize, i128)| u32::try_from(*number).is_err());
    Ok(Err(wrong.next().unwrap_or_default()))
}
