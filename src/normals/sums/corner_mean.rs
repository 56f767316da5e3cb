//! The sum of a few faces at a corner, by the rules of all sums.

use crate::normals::faces::shape::FaceState;
use crate::normals::recipe::Slivers;
use crate::normals::sums::request::SlotState;
use crate::num;
use glam::DVec3;

/// What one face adds to one sum: `vector` · `weight`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Term {
    /// The face's vector and its length; see [`CornerTerms`](crate::normals::sums::corner_terms::CornerTerms).
    pub(crate) vector: [f64; 4],
    /// The face's unit normal, to the bit.
    pub(crate) unit: DVec3,
    /// The weight of the corner.
    pub(crate) weight: f64,
    /// The face.
    pub(crate) face: u32,
    /// The state of the face.
    pub(crate) state: FaceState,
}

/// Whether a face adds to sums in the first place.
#[inline(always)]
pub(crate) fn adds(state: FaceState, slivers: Slivers) -> bool {
    state == FaceState::Counted || (state == FaceState::Sliver && slivers == Slivers::Keep)
}

/// The direction of a sum of terms, which come in ascending face index.
///
/// Slivers that are excluded count after all if there is nothing else; if all weights vanish, faces count the same;
/// one face alone gives its normal. If weights exceed the range of numbers, the faces with the largest count the same.
pub(crate) fn mean(terms: &[Term], slivers: Slivers) -> (DVec3, SlotState) {
    let firm = terms.iter().any(|term| adds(term.state, slivers));
    let used = || {
        terms
            .iter()
            .filter(move |term| if firm { adds(term.state, slivers) } else { term.state.has_direction() })
    };
    let Some(first) = used().next() else { return (DVec3::ZERO, SlotState::Empty) };
    if used().all(|term| term.face == first.face) {
        return (first.unit, SlotState::Good);
    }
    let (mut vector, mut weights, mut count) = (DVec3::ZERO, 0.0, 0.0);
    for term in used() {
        let [x, y, z, length] = term.vector;
        vector += DVec3::new(x, y, z) * term.weight;
        weights += length * term.weight;
        count += 1.0;
    }
    if weights == 0.0 {
        return uniform_mean(used().map(|term| term.unit));
    }
    if !weights.is_finite() {
        // Infinity times a vector of zeros is not a number.
        let size = |term: &Term| term.vector[3] * term.weight;
        let is_heavy = |term: &&Term| size(term) >= f64::MAX / (2.0 * count) || size(term).is_nan();
        return uniform_mean(used().filter(is_heavy).map(|term| term.unit));
    }
    let (direction, state, _) = classify(vector, weights, count);
    (direction, state)
}

/// The direction of a plain sum of unit vectors.
pub(crate) fn uniform_mean(units: impl Iterator<Item = DVec3>) -> (DVec3, SlotState) {
    let (vector, count) = units.fold((DVec3::ZERO, 0.0), |(sum, count), unit| (sum + unit, count + 1.0));
    if count == 0.0 {
        return (DVec3::ZERO, SlotState::Empty);
    }
    let (direction, state, _) = classify(vector, count, count);
    (direction, state)
}

/// Direction, state and length of Σ w n̂ over so many terms, given Σ w > 0.
#[inline(always)]
pub(crate) fn classify(vector: DVec3, weights: f64, terms: f64) -> (DVec3, SlotState, f64) {
    if vector == DVec3::ZERO {
        // What cancelled to nothing has no direction at all.
        return (vector, SlotState::Cancelling, 0.0);
    }
    let (direction, length) = num::direction(vector);
    (direction, SlotState::of_sum(weights, length, terms), length)
}
