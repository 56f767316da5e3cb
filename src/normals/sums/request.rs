//! What to sum, and what a sum can turn out to be.

use crate::mesh::{FacesRef, PositionsRef};
use crate::normals::recipe::{Slivers, Weight};
use glam::DVec3;

/// A sum with more than this times its own length in weights has cancelled.
pub(crate) const CANCELLING: f64 = 1e6;

/// A running sum: Σ w n̂ and Σ w.
pub(crate) type Sum = [f64; 4];

/// Which faces to sum, and to which slots. A *slot* is whatever a sum belongs to: a vertex, a smooth group.
#[derive(Clone, Copy)]
pub(crate) struct SumRequest<'a> {
    pub(crate) faces: FacesRef<'a>,
    /// The positions of vertices.
    pub(crate) positions: PositionsRef<'a>,
    /// The slot of each corner, [`NONE`](crate::mesh::NONE) to leave it out.
    pub(crate) target: &'a [u32],
    /// The number of slots.
    pub(crate) slots: usize,
    pub(crate) weight: Weight,
    pub(crate) slivers: Slivers,
}

impl SumRequest<'_> {
    /// Whether terms are plain area vectors. Then the sum of a slot with one face has that face's bits, but Σ w is only an
    /// upper bound.
    pub(crate) fn sums_area_vectors(&self) -> bool {
        self.weight.has_area_factor() && self.weight.is_equal_at_corners()
    }
}

/// What became of a slot's sum.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u8)]
pub(crate) enum SlotState {
    /// It has a direction.
    Good,
    /// Σ|w| / |Σ w n̂| is above 10^6: what is left is rounding.
    Cancelling,
    /// No face with a direction adds to it.
    #[default]
    Empty,
}

impl Sums {
    /// Without any direction yet.
    pub(crate) fn new(slots: usize) -> Self {
        Self { unit: bytemuck::zeroed_vec(slots), state: vec![SlotState::Empty; slots] }
    }
}

/// One direction for each slot.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Sums {
    /// Unit vectors. Of a cancelling slot the direction of what is left, of an empty one zero.
    pub(crate) unit: Vec<DVec3>,
    /// One for each unit vector.
    pub(crate) state: Vec<SlotState>,
}
