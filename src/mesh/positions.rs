//! Positions of vertices in the precision that they came in.

use crate::num::parallel;
use glam::DVec3;
use rayon::prelude::*;

/// The precision of the positions in their source. It determines the height below which the direction of a face is
/// rounding noise.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Storage {
    /// Every coordinate is an `f32` value: binary STL, glTF, PLY `float` and integers, and text that spells the
    /// shortest decimals of such values.
    F32,
    /// Doubles, or other decimal text.
    #[default]
    F64,
}

/// The positions of all vertices of a [`Mesh`](super::Mesh), 12 or 24 bytes each.
///
/// ```
/// use crease::mesh::{Positions, Storage};
/// use glam::DVec3;
///
/// let singles = Positions::from(vec![[0.1_f32, -0.0, 2.0]]);
/// assert_eq!(singles.storage(), Storage::F32);
/// // Widening is exact, so that it can be undone.
/// assert_eq!(Positions::rounded(singles.view().to_vec(), Storage::F32), singles);
/// assert_ne!(singles.view().at(0), DVec3::new(0.1, 0.0, 2.0));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Positions {
    /// Single precision.
    F32(Vec<[f32; 3]>),
    /// Double precision.
    F64(Vec<DVec3>),
}

impl Positions {
    /// Positions rounded to a precision. Where every coordinate is a number of that precision, nothing changes.
    pub fn rounded(points: Vec<DVec3>, storage: Storage) -> Self {
        match storage {
            Storage::F32 => Self::F32(points.par_iter().map(|p| p.as_vec3().to_array()).collect()),
            Storage::F64 => Self::F64(points),
        }
    }

    /// The precision.
    pub fn storage(&self) -> Storage {
        match self {
            Self::F32(_) => Storage::F32,
            Self::F64(_) => Storage::F64,
        }
    }

    /// The positions, borrowed.
    #[inline]
    pub fn view(&self) -> PositionsRef<'_> {
        match self {
            Self::F32(points) => PositionsRef::F32(points),
            Self::F64(points) => PositionsRef::F64(points),
        }
    }

    /// Moves a vertex to the origin.
    pub(super) fn clear(&mut self, vertex: usize) {
        match self {
            Self::F32(points) => points[vertex] = [0.0; 3],
            Self::F64(points) => points[vertex] = DVec3::ZERO,
        }
    }
}

impl Default for Positions {
    fn default() -> Self {
        Self::F64(Vec::new())
    }
}

impl FromIterator<[f32; 3]> for Positions {
    fn from_iter<I: IntoIterator<Item = [f32; 3]>>(points: I) -> Self {
        Self::F32(points.into_iter().collect())
    }
}

impl FromIterator<DVec3> for Positions {
    fn from_iter<I: IntoIterator<Item = DVec3>>(points: I) -> Self {
        Self::F64(points.into_iter().collect())
    }
}

impl From<Vec<[f32; 3]>> for Positions {
    fn from(points: Vec<[f32; 3]>) -> Self {
        Self::F32(points)
    }
}

impl From<Vec<DVec3>> for Positions {
    fn from(points: Vec<DVec3>) -> Self {
        Self::F64(points)
    }
}

/// Borrowed [`Positions`]: a view that is copied like a slice.
///
/// [`at`](Self::at) and [`iter`](Self::iter) widen each position to doubles, which is exact; −0 stays −0. A loop over millions
/// of positions matches the two slices once instead:
///
/// ```
/// use crease::mesh::PositionsRef;
///
/// fn largest_x(positions: PositionsRef) -> f64 {
///     match positions {
///         PositionsRef::F32(points) => points.iter().fold(0.0_f32, |x, p| x.max(p[0])).into(),
///         PositionsRef::F64(points) => points.iter().fold(0.0, |x, p| x.max(p.x)),
///     }
/// }
/// assert_eq!(largest_x(PositionsRef::F32(&[[0.5, 0.0, 0.0], [0.25, 2.0, 0.0]])), 0.5);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PositionsRef<'a> {
    /// Single precision.
    F32(&'a [[f32; 3]]),
    /// Double precision.
    F64(&'a [DVec3]),
}

impl<'a> PositionsRef<'a> {
    /// The number of vertices.
    #[inline]
    pub fn len(self) -> usize {
        match self {
            Self::F32(points) => points.len(),
            Self::F64(points) => points.len(),
        }
    }

    /// Whether there are no vertices.
    pub fn is_empty(self) -> bool {
        self.len() == 0
    }

    /// The precision.
    #[inline]
    pub fn storage(self) -> Storage {
        match self {
            Self::F32(_) => Storage::F32,
            Self::F64(_) => Storage::F64,
        }
    }

    /// The position of a vertex.
    ///
    /// # Panics
    /// If the vertex does not exist.
    #[inline]
    pub fn at(self, vertex: u32) -> DVec3 {
        match self {
            Self::F32(points) => wide(&points[vertex as usize]),
            Self::F64(points) => points[vertex as usize],
        }
    }

    /// All positions, in the order of vertices. Loops inside the iterator, as of `fold` and `for_each`, know the type.
    pub fn iter(self) -> PositionIter<'a> {
        match self {
            Self::F32(points) => PositionIter::F32(points.iter()),
            Self::F64(points) => PositionIter::F64(points.iter()),
        }
    }

    /// The same for several threads.
    pub fn par_iter(self) -> impl IndexedParallelIterator<Item = DVec3> + 'a {
        (0..self.len()).into_par_iter().map(move |vertex| self.at(vertex as u32))
    }

    /// All positions as doubles.
    pub fn to_vec(self) -> Vec<DVec3> {
        match self {
            Self::F32(points) => points.iter().map(wide).collect(),
            Self::F64(points) => points.to_vec(),
        }
    }

    /// The positions of some vertices, in the same precision.
    pub(crate) fn gather(self, vertices: &[u32]) -> Positions {
        match self {
            Self::F32(points) => Positions::F32(vertices.iter().map(|&v| points[v as usize]).collect()),
            Self::F64(points) => Positions::F64(vertices.iter().map(|&v| points[v as usize]).collect()),
        }
    }

    /// The first vertex whose position is not finite.
    pub(crate) fn first_non_finite(self) -> Option<usize> {
        match self {
            Self::F32(points) => parallel::position(points, |p| !p.iter().all(|x| x.is_finite())),
            Self::F64(points) => parallel::position(points, |p| !p.is_finite()),
        }
    }
}

#[inline]
fn wide(point: &[f32; 3]) -> DVec3 {
    DVec3::from(point.map(f64::from))
}

/// The iterator over [`PositionsRef`].
#[derive(Clone, Debug)]
pub enum PositionIter<'a> {
    /// Single precision.
    F32(std::slice::Iter<'a, [f32; 3]>),
    /// Double precision.
    F64(std::slice::Iter<'a, DVec3>),
}

impl Iterator for PositionIter<'_> {
    type Item = DVec3;

    #[inline]
    fn next(&mut self) -> Option<DVec3> {
        match self {
            Self::F32(points) => points.next().map(wide),
            Self::F64(points) => points.next().copied(),
        }
    }

    #[inline]
    fn size_hint(&self) -> (usize, Option<usize>) {
        match self {
            Self::F32(points) => points.size_hint(),
            Self::F64(points) => points.size_hint(),
        }
    }

    #[inline]
    fn fold<B, F: FnMut(B, DVec3) -> B>(self, init: B, f: F) -> B {
        match self {
            Self::F32(points) => points.map(wide).fold(init, f),
            Self::F64(points) => points.copied().fold(init, f),
        }
    }
}

impl ExactSizeIterator for PositionIter<'_> {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_precisions_give_the_same_positions() {
        let singles = [[0.1_f32, -0.0, 1e-45], [f32::MAX, 2.0, -3.5]];
        let doubles = singles.map(|p| DVec3::from(p.map(f64::from)));
        let views = [PositionsRef::F32(&singles), PositionsRef::F64(&doubles)];
        let bits = |p: DVec3| p.to_array().map(f64::to_bits);
        for view in views {
            assert_eq!(view.len(), 2);
            assert_eq!([0, 1].map(|vertex| bits(view.at(vertex))), doubles.map(bits));
            assert!(view.iter().map(bits).eq(doubles.map(bits)));
            // A loop inside the iterator takes the same steps as one outside.
            let mut folded = Vec::new();
            view.iter().for_each(|p| folded.push(bits(p)));
            assert_eq!(folded, doubles.map(bits));
            assert_eq!(view.par_iter().map(bits).collect::<Vec<_>>(), doubles.map(bits));
            assert_eq!(view.to_vec().into_iter().map(bits).collect::<Vec<_>>(), doubles.map(bits));
            assert_eq!(view.first_non_finite(), None);
            let gathered = view.gather(&[1, 0, 1]);
            assert_eq!(gathered.storage(), view.storage());
            assert_eq!(bits(gathered.view().at(1)), bits(doubles[0]));
        }
        // Rounding to single precision undoes widening, −0 included.
        let Positions::F32(rounded) = Positions::rounded(doubles.to_vec(), Storage::F32) else {
            panic!("singles")
        };
        assert_eq!(
            rounded.as_flattened().iter().map(|x| x.to_bits()).collect::<Vec<_>>(),
            singles.as_flattened().iter().map(|x| x.to_bits()).collect::<Vec<_>>()
        );
    }

    #[test]
    fn positions_that_are_not_finite_are_found() {
        for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            let singles = [[0.0; 3], [0.0, bad, 0.0], [bad; 3]];
            let doubles = singles.map(|p| DVec3::from(p.map(f64::from)));
            assert_eq!(PositionsRef::F32(&singles).first_non_finite(), Some(1));
            assert_eq!(PositionsRef::F64(&doubles).first_non_finite(), Some(1));
        }
    }
}
