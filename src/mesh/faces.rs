//! Faces as polygons of any size, in compressed rows.

use std::ops::Range;

/// The polygons of a mesh: for every face the vertices of its corners, in order.
///
/// A *corner* is one vertex of one face. Corners are numbered through: face 0 has the first ones, face 1
/// the next, and so on; everything that varies around a vertex (normals, uv) is stored per corner number.
/// The edge that leaves corner `c` towards the next corner of its face is *half-edge* `c`.
///
/// When every face is a triangle no offsets are stored: corner `c` belongs to face `c / 3`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Faces {
    corners: Vec<u32>,
    /// Where each face starts, with the total at the end; `None` while all faces are triangles.
    offsets: Option<Vec<u32>>,
}

impl Faces {
    /// An empty list.
    pub fn new() -> Self {
        Self::default()
    }

    /// Triangles from a flat list of vertices, three a face.
    ///
    /// # Panics
    /// If the length is not a multiple of three.
    pub fn triangles(corners: Vec<u32>) -> Self {
        assert!(corners.len().is_multiple_of(3), "{} corners do not make whole triangles", corners.len());
        Self { corners, offsets: None }
    }

    /// Polygons from a flat list of vertices and where each face starts in it, with the total at the end. If all
    /// are triangles they are stored as such.
    ///
    /// # Panics
    /// If the offsets do not ascend from 0 to the number of corners.
    pub fn polygons(corners: Vec<u32>, offsets: Vec<u32>) -> Self {
        let ends = (offsets.first().copied(), offsets.last().map(|&last| last as usize));
        assert_eq!(ends, (Some(0), Some(corners.len())), "offsets run from 0 to the number of corners");
        assert!(offsets.is_sorted(), "offsets ascend");
        let is_triangles = offsets.windows(2).all(|pair| pair[1] - pair[0] == 3);
        Self { corners, offsets: (!is_triangles).then_some(offsets) }
    }

    /// The same polygons over other vertices, one for each corner.
    pub(crate) fn with_corners(&self, corners: Vec<u32>) -> Self {
        assert_eq!(corners.len(), self.corners.len(), "one vertex a corner");
        Self { corners, offsets: self.offsets.clone() }
    }

    /// An empty list with room for `corners` corners.
    pub fn with_capacity(corners: usize) -> Self {
        Self { corners: Vec::with_capacity(corners), offsets: None }
    }

    /// Appends a face. Faces of fewer than three corners are stored too; [`MeshBuilder`] refuses them.
    ///
    /// [`MeshBuilder`]: super::MeshBuilder
    pub fn push(&mut self, face: &[u32]) {
        if face.len() != 3 && self.offsets.is_none() {
            self.offsets = Some((0..=self.corners.len() as u32).step_by(3).collect());
        }
        self.corners.extend_from_slice(face);
        if let Some(offsets) = &mut self.offsets {
            offsets.push(self.corners.len() as u32);
        }
    }

    /// The number of faces.
    pub fn len(&self) -> usize {
        self.view().len()
    }

    /// Whether there is no face.
    pub fn is_empty(&self) -> bool {
        self.corners.is_empty() && self.len() == 0
    }

    /// Whether the list is stored as plain triangles.
    pub fn is_triangles(&self) -> bool {
        self.offsets.is_none()
    }

    /// The number of corners of all faces.
    pub fn corner_count(&self) -> usize {
        self.corners.len()
    }

    /// The vertex of every corner.
    pub fn corners(&self) -> &[u32] {
        &self.corners
    }

    /// Where each face starts, with the total at the end; `None` for plain triangles.
    pub fn offsets(&self) -> Option<&[u32]> {
        self.offsets.as_deref()
    }

    /// The corner numbers of one face.
    #[inline]
    pub fn range(&self, face: usize) -> Range<usize> {
        self.view().range(face)
    }

    /// The vertices of one face.
    #[inline]
    pub fn face(&self, face: usize) -> &[u32] {
        &self.corners[self.range(face)]
    }

    /// The triangles of a face from its first corner, by their vertices.
    #[inline]
    pub(crate) fn fan(&self, face: u32) -> impl Iterator<Item = [u32; 3]> {
        let vertices = self.face(face as usize);
        vertices[1..].windows(2).map(|edge| [vertices[0], edge[0], edge[1]])
    }

    /// Each face's corner numbers, in order.
    pub fn ranges(&self) -> impl ExactSizeIterator<Item = Range<usize>> + '_ {
        (0..self.len()).map(|face| self.range(face))
    }

    /// Each face's vertices, in order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &[u32]> + '_ {
        (0..self.len()).map(|face| self.face(face))
    }

    /// The face that each corner belongs to.
    pub fn owners(&self) -> Vec<u32> {
        self.view().owners()
    }

    /// The faces, borrowed.
    #[inline]
    pub(crate) fn view(&self) -> FacesRef<'_> {
        FacesRef { corners: &self.corners, offsets: self.offsets.as_deref() }
    }

    /// The largest number of corners of a face; 0 without faces.
    pub fn max_arity(&self) -> usize {
        self.ranges().map(|range| range.len()).max().unwrap_or(0)
    }
}

/// Borrowed faces: of a mesh, or triangles of a caller's own slice.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FacesRef<'a> {
    corners: &'a [u32],
    /// As in [`Faces`].
    offsets: Option<&'a [u32]>,
}

impl<'a> FacesRef<'a> {
    /// Triangles of a slice.
    pub(crate) fn triangles(triangles: &'a [[u32; 3]]) -> Self {
        Self { corners: triangles.as_flattened(), offsets: None }
    }

    /// The number of faces.
    #[inline]
    pub(crate) fn len(self) -> usize {
        match self.offsets {
            Some(offsets) => offsets.len() - 1,
            None => self.corners.len() / 3,
        }
    }

    /// Whether all faces are triangles.
    #[inline]
    pub(crate) fn is_triangles(self) -> bool {
        self.offsets.is_none()
    }

    /// The vertex of every corner.
    #[inline]
    pub(crate) fn corners(self) -> &'a [u32] {
        self.corners
    }

    /// The number of the first corner of a face, or the total for the face past the last.
    #[inline(always)]
    pub(crate) fn start(self, face: usize) -> usize {
        match self.offsets {
            Some(offsets) => offsets[face] as usize,
            None => 3 * face,
        }
    }

    /// The corner numbers of one face.
    #[inline(always)]
    pub(crate) fn range(self, face: usize) -> Range<usize> {
        self.start(face)..self.start(face + 1)
    }

    /// The vertices of one face.
    #[inline(always)]
    pub(crate) fn face(self, face: usize) -> &'a [u32] {
        &self.corners[self.range(face)]
    }

    /// The face that each corner belongs to.
    fn owners(self) -> Vec<u32> {
        let mut owners = Vec::with_capacity(self.corners.len());
        for face in 0..self.len() {
            owners.extend(std::iter::repeat_n(face as u32, self.range(face).len()));
        }
        owners
    }

    /// The face of each corner and where each face starts; both empty for plain triangles, where arithmetic replaces them.
    pub(crate) fn owners_and_starts(self) -> (Vec<u32>, Vec<u32>) {
        self.offsets.map_or_else(Default::default, |offsets| (self.owners(), offsets.to_vec()))
    }
}

/// The next corner of the same triangle, where there are only triangles.
#[inline(always)]
pub(crate) fn next_in_triangle(corner: u32) -> u32 {
    if corner % 3 == 2 { corner - 2 } else { corner + 1 }
}

/// The previous corner of the same triangle, where there are only triangles.
#[inline(always)]
pub(crate) fn previous_in_triangle(corner: u32) -> u32 {
    if corner.is_multiple_of(3) { corner + 2 } else { corner - 1 }
}

/// Whether a face has fewer than three distinct vertices, or positions.
pub(super) fn is_collapsed<T: PartialEq>(mut vertices: impl Iterator<Item = T>) -> bool {
    let Some(first) = vertices.next() else { return true };
    let Some(second) = vertices.find(|v| *v != first) else { return true };
    !vertices.any(|v| v != first && v != second)
}
