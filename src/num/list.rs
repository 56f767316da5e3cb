//! Lists of a fixed length in files. Deserialised as an array, a longer list would lose its end silently.

use glam::DVec3;
use serde::{Deserialize, Deserializer};

/// A list of exactly `N` values.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(try_from = "Vec<T>", bound(deserialize = "T: Deserialize<'de>"))]
pub(crate) struct List<T, const N: usize>(pub(crate) [T; N]);

impl<T, const N: usize> TryFrom<Vec<T>> for List<T, N> {
    type Error = String;

    fn try_from(values: Vec<T>) -> Result<Self, String> {
        let found = |values: Vec<T>| {
            format!("found a list of length {}, expected a list of length {N}", values.len())
        };
        values.try_into().map(Self).map_err(found)
    }
}

impl From<List<f64, 3>> for DVec3 {
    fn from(List(coordinates): List<f64, 3>) -> Self {
        coordinates.into()
    }
}

/// The values of such a list, for `deserialize_with`.
pub(crate) fn list<'de, D: Deserializer<'de>, T: Deserialize<'de>, const N: usize>(
    deserializer: D,
) -> Result<[T; N], D::Error> {
    List::deserialize(deserializer).map(|List(values)| values)
}
