//! From sums to unit vectors.

use crate::normals::faces::component::Component;
use crate::normals::sums::corner_mean::classify;
use crate::normals::sums::request::{CLEAR, SlotState, Sum};
use crate::num::{self, Kernel, LANES, Lanes, Scalars, Vectors};
use glam::DVec3;

/// Slots whose sums do not determine the result, by their numbers in the mesh.
#[derive(Default)]
pub(crate) struct UncertainSlots {
    /// All faces at them point the same way: it may be only one.
    pub(crate) perhaps_one_face: Vec<u32>,
    /// Nothing was added to them, or perhaps it cancelled.
    pub(crate) recount: Vec<u32>,
    /// Whether some slot may not be [`SlotState::Good`].
    pub(crate) not_all_good: bool,
}

impl UncertainSlots {
    /// Appends others.
    pub(crate) fn join(&mut self, other: &Self) {
        self.perhaps_one_face.extend_from_slice(&other.perhaps_one_face);
        self.recount.extend_from_slice(&other.recount);
        self.not_all_good |= other.not_all_good;
    }

    pub(crate) fn clear(&mut self) {
        self.perhaps_one_face.clear();
        self.recount.clear();
        self.not_all_good = false;
    }
}

/// A sum shorter than its weights by less than this comes from faces that point the same way to the last bits.
const SAME_WAY: f64 = 1.0 + 64.0 * f64::EPSILON;

/// Turns sums into unit vectors.
pub(crate) struct Finish<'a, O> {
    /// The sums of some slots in a row. Set to zero on the way, for the next call.
    pub(crate) sums: &'a mut [Sum],
    /// The first of those slots.
    pub(crate) first: u32,
    /// Where to write unit vectors.
    pub(crate) unit: &'a mut [[O; 3]],
    pub(crate) state: &'a mut [SlotState],
    pub(crate) uncertain: &'a mut UncertainSlots,
    /// See [`sums_area_vectors`](crate::normals::sums::request::SumRequest::sums_area_vectors).
    pub(crate) areas: bool,
}

impl<O: Component> Kernel for Finish<'_, O> {
    type Output = ();

    #[inline(always)]
    fn run<A: Lanes>(self, arch: A) {
        let Self { sums, first, unit, state, uncertain, areas } = self;
        // No length is below 0: slots of one face are then not searched for.
        let same_way = if areas { 0.0 } else { SAME_WAY };
        state.fill(SlotState::Good);
        let groups = sums.chunks_mut(LANES).zip(unit.chunks_mut(LANES)).zip(state.chunks_mut(LANES));
        for (first, ((sums, unit), state)) in (first..).step_by(LANES).zip(groups) {
            if !finish_group(arch, sums, unit, same_way) {
                for (slot, ((&sum, unit), state)) in (first..).zip(sums.iter().zip(unit).zip(state)) {
                    let (vector, found) = finish_one(sum, slot, areas, uncertain);
                    (*unit, *state) = (O::emit(vector), found);
                }
            }
            sums.fill([0.0; 4]);
        }
    }
}

/// Eight sums at once; false if one of them needs [`finish_one`].
#[inline(always)]
fn finish_group<A: Lanes, O: Component>(arch: A, sums: &[Sum], unit: &mut [[O; 3]], same_way: f64) -> bool {
    let (Ok(sums), Ok(unit)) = (<&[Sum; LANES]>::try_from(sums), <&mut [[O; 3]; LANES]>::try_from(unit))
    else {
        return false;
    };
    let [x, y, z, weights] = arch.columns(sums.each_ref());
    let weights = Scalars::new(arch, weights);
    let squared = Vectors::new(arch, [x, y, z]).squared_length();
    let length = squared.sqrt();
    let reciprocal = arch.to_array((Scalars::splat(arch, 1.0) / length).value);
    let (shortest, longest) = num::PLAIN_SQUARES;
    let ordinary = Scalars::splat(arch, shortest).less(squared)
        & squared.less(Scalars::splat(arch, longest))
        & weights.less(Scalars::splat(arch, CLEAR) * length)
        & (Scalars::splat(arch, same_way) * length).less(weights);
    for (row, (unit, sum)) in unit.iter_mut().zip(sums).enumerate() {
        *unit = O::emit_row(arch, sum, reciprocal[A::lane(row)]);
    }
    ordinary.row_bits() == u8::MAX
}

/// One sum.
fn finish_one(
    [x, y, z, weights]: Sum,
    slot: u32,
    areas: bool,
    uncertain: &mut UncertainSlots,
) -> (DVec3, SlotState) {
    // Weights of faces of extreme shape may exceed the range of numbers.
    if weights == 0.0 || !weights.is_finite() {
        uncertain.recount.push(slot);
        uncertain.not_all_good = true;
        return (DVec3::ZERO, SlotState::Empty);
    }
    // How many terms there are is not known here: what may have cancelled is counted.
    let (vector, found, length) = classify(DVec3::new(x, y, z), weights, f64::INFINITY);
    uncertain.not_all_good |= found != SlotState::Good;
    if found == SlotState::Cancelling {
        uncertain.recount.push(slot);
    } else if !areas && weights <= SAME_WAY * length {
        uncertain.perhaps_one_face.push(slot);
    }
    (vector, found)
}
