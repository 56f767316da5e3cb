//! Names and angles in arguments.

use crease::mesh::Weld;
use crease::normals::{Averaging, Precision, Slivers, Weight};
use crease::num::Degrees;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyBool;

/// The value that a name chooses.
fn chosen<T: Copy>(argument: &str, name: &str, choices: &[(&str, T)]) -> PyResult<T> {
    let found = choices.iter().find(|(known, _)| *known == name).map(|&(_, value)| value);
    found.ok_or_else(|| {
        let names: Vec<String> = choices.iter().map(|(known, _)| format!("{known:?}")).collect();
        PyValueError::new_err(format!("{argument} is {name:?}; use one of {}", names.join(", ")))
    })
}

pub fn averaging(weight: &str, slivers: &str, precision: &str) -> PyResult<Averaging> {
    let weights = Weight::ALL.map(|weight| (weight.name(), weight));
    Ok(Averaging {
        weight: chosen("weight", weight, &weights)?,
        slivers: chosen("slivers", slivers, &[("exclude", Slivers::Exclude), ("keep", Slivers::Keep)])?,
        precision: chosen(
            "precision",
            precision,
            &[("faithful", Precision::Faithful), ("fast", Precision::Fast)],
        )?,
    })
}

/// A crease angle in degrees; `None` is 180°, at which no edge is a crease.
pub fn crease_angle(degrees: Option<f64>) -> PyResult<Degrees> {
    match degrees {
        None => Ok(Degrees(180.0)),
        Some(angle) if (0.0..=180.0).contains(&angle) => Ok(Degrees(angle)),
        Some(angle) => {
            let text = format!("crease is {angle}; an angle from 0 to 180 degrees, or None, was expected");
            Err(PyValueError::new_err(text))
        }
    }
}

/// `"off"`, `"exact"`, or a fraction of the diagonal.
pub enum WeldArgument {
    Fraction(f64),
    Name(String),
}

impl FromPyObject<'_, '_> for WeldArgument {
    type Error = PyErr;

    fn extract(given: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        if let Ok(name) = given.extract() {
            return Ok(Self::Name(name));
        }
        // True is a number too.
        let fraction = given.extract().ok().filter(|_| !given.is_instance_of::<PyBool>());
        fraction.map(Self::Fraction).ok_or_else(|| {
            PyValueError::new_err(format!(
                "weld is {}; use \"off\", \"exact\" or a fraction of the diagonal from 0 to 1",
                &*given
            ))
        })
    }
}

impl WeldArgument {
    pub fn weld(&self) -> PyResult<Weld> {
        match self {
            Self::Fraction(fraction) if (0.0..=1.0).contains(fraction) => Ok(Weld::Relative(*fraction)),
            Self::Fraction(fraction) => {
                let text = format!("weld is {fraction}; a fraction of the diagonal from 0 to 1 was expected");
                Err(PyValueError::new_err(text))
            }
            Self::Name(name) => chosen("weld", name, &[("off", Weld::Off), ("exact", Weld::Exact)]),
        }
    }
}
