//! What to sum, and what a sum can turn out to be.

use crate::mesh::{FacesRef, PositionsRef};
use crate::normals::recipe::{Slivers, Weight};
use glam::DVec3;

/// A sum with at most this times its own length in weights is right to 10⁻⁶ rad (up to 9000 faces). Others need a
/// look at their number of terms: see [`SlotState::of_sum`].
pub(crate) const CLEAR: f64 = 1e6;

/// What the terms of a sum add to its error, in units of 2⁻⁵³: a face's direction and its weight are right to 8 each.
const TERM_ERROR: f64 = 16.0;

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
    /// It has a direction, right to 10⁻⁶ rad.
    Good,
    /// Its terms nearly cancel: the direction is right to 10⁻⁵ rad.
    Within1e5,
    /// The same, to 10⁻⁴ rad.
    Within1e4,
    /// The same, to 10⁻³ rad.
    Within1e3,
    /// Its terms cancel: the remainder may be rounding.
    Cancelling,
    /// No face with a direction adds to it.
    #[default]
    Empty,
}

impl SlotState {
    /// The state of a sum of so many terms, by κ = Σ|w| / |Σ w n̂|. Rounding turns the sum by at most
    /// 2⁻⁵³ · (terms + 4) · κ rad (Higham 2002, §4.2, with 4 for its length and direction), and errors of the terms by
    /// as many times κ as they have.
    pub(crate) fn of_sum(weights: f64, length: f64, terms: f64) -> Self {
        if weights <= CLEAR * length {
            return Self::Good;
        }
        match 0.5 * f64::EPSILON * (terms + 4.0 + TERM_ERROR) * (weights / length) {
            ..=1e-6 => Self::Good,
            ..=1e-5 => Self::Within1e5,
            ..=1e-4 => Self::Within1e4,
            ..=1e-3 => Self::Within1e3,
            _ => Self::Cancelling,
        }
    }

    /// Whether the sum's direction is the normal.
    pub(crate) fn has_normal(self) -> bool {
        !matches!(self, Self::Cancelling | Self::Empty)
    }

    /// The bound on the error in radians, if the terms nearly cancel and the direction is kept.
    pub(crate) fn near_cancellation(self) -> Option<f64> {
        match self {
            Self::Within1e5 => Some(1e-5),
            Self::Within1e4 => Some(1e-4),
            Self::Within1e3 => Some(1e-3),
            Self::Good | Self::Cancelling | Self::Empty => None,
        }
    }
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
    /// Unit vectors. Of a cancelling slot the direction of the remainder, of an empty one zero.
    pub(crate) unit: Vec<DVec3>,
    /// One for each unit vector.
    pub(crate) state: Vec<SlotState>,
}
