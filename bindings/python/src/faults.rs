//! Faults as an array.

use crease::normals::{Fault, FaultReason, Faults};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;

const ELEMENTS: [&str; 3] = ["face", "corner", "vertex"];

const REASONS: [FaultReason; 6] = [
    FaultReason::ZeroArea,
    FaultReason::BelowStorage,
    FaultReason::CancellingFan,
    FaultReason::NonFinite,
    FaultReason::OutOfRange,
    FaultReason::Unreferenced,
];

/// A structured array with one row for each fault: `element` (str), `index` (uint32) and `reason` (str).
pub fn fault_array<'py>(py: Python<'py>, faults: &Faults) -> PyResult<Bound<'py, PyAny>> {
    let numpy = py.import("numpy")?;
    let lists = [&faults.faces, &faults.corners, &faults.vertices];
    let all = || lists.into_iter().flatten();
    let code = |fault: &Fault| REASONS.iter().position(|&reason| reason == fault.reason).unwrap_or_default();
    let elements =
        (0_usize..).zip(lists).flat_map(|(element, list)| std::iter::repeat_n(element, list.len()));
    let elements = PyArray1::from_iter(py, elements);
    let reasons = PyArray1::from_iter(py, all().map(code));
    let named = |names: Vec<&str>, codes| numpy.call_method1("array", (names,))?.get_item(codes);

    let kwargs = PyDict::new(py);
    kwargs.set_item("dtype", vec![("element", "U6"), ("index", "u4"), ("reason", "U13")])?;
    let array = numpy.call_method("empty", (all().count(),), Some(&kwargs))?;
    array.set_item("element", named(ELEMENTS.to_vec(), elements)?)?;
    array.set_item("index", PyArray1::from_iter(py, all().map(|fault| fault.index)))?;
    array.set_item("reason", named(REASONS.map(FaultReason::name).to_vec(), reasons)?)?;
    Ok(array)
}
