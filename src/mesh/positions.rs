//! Positions of vertices, read in the precision that they are stored in.

use glam::DVec3;
use rayon::prelude::*;

/// The positions of all vertices of a [`Mesh`](super::Mesh): a view that is copied like a slice.
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

    /// The position of a vertex.
    ///
    /// # Panics
    /// If the vertex does not exist.
    #[inline]
    pub fn at(self, vertex: u32) -> DVec3 {
        self.number(vertex as usize)
    }

    #[inline]
    fn number(self, vertex: usize) -> DVec3 {
        match self {
            Self::F32(points) => DVec3::from(points[vertex].map(f64::from)),
            Self::F64(points) => points[vertex],
        }
    }

    /// All positions, in the order of vertices.
    pub fn iter(self) -> impl DoubleEndedIterator<Item = DVec3> + ExactSizeIterator + Clone + 'a {
        (0..self.len()).map(move |vertex| self.number(vertex))
    }

    /// The same for several threads.
    pub fn par_iter(self) -> impl IndexedParallelIterator<Item = DVec3> + 'a {
        (0..self.len()).into_par_iter().map(move |vertex| self.number(vertex))
    }

    /// All positions as doubles.
    pub fn to_vec(self) -> Vec<DVec3> {
        self.iter().collect()
    }
}
