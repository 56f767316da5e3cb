//! From sums in single precision to unit vectors.

use crate::normals::faces::component::Component;
use crate::normals::sums::block::ALL;
use crate::normals::sums::request::SlotState;
use crate::num::{EightLanes, Kernel, LANES, Lanes, Scalars, Vectors};

/// Sums that shrink to less than this share of their weights lose three of the seven digits of an `f32`.
const LEAST_SUM: f64 = 1e-3;

/// Turns sums into unit vectors.
pub(crate) struct FinishSingles<'a, O> {
    /// The sums of some slots in a row. Set to zero on the way, for the next call.
    pub(crate) sums: &'a mut [[f32; 4]],
    /// The first of those slots.
    pub(crate) first: u32,
    /// Up to this sum of weights a sum does not have too many faces.
    pub(crate) most_weight: f32,
    pub(crate) unit: &'a mut [[O; 3]],
    pub(crate) state: &'a mut [SlotState],
    /// Takes the slots whose sums are out of range.
    pub(crate) recount: &'a mut Vec<u32>,
}

impl<O: Component> Kernel for FinishSingles<'_, O> {
    /// Whether all sums of weights are up to the largest.
    type Output = bool;

    #[inline(always)]
    fn run<A: Lanes>(self, arch: A) -> bool {
        let Self { sums, first, most_weight, unit, state, recount } = self;
        let arch = arch.singles();
        let mut are_light = true;
        state.fill(SlotState::Good);
        let groups = sums.chunks_mut(LANES).zip(unit.chunks_mut(LANES)).zip(state.chunks_mut(LANES));
        for (first, ((sums, unit), state)) in (first..).step_by(LANES).zip(groups) {
            if !finish_group(arch, sums, most_weight, unit) {
                for (slot, ((sum, unit), state)) in (first..).zip(sums.iter().zip(unit).zip(state)) {
                    let [x, y, z, weights] = *sum;
                    let length = (x * x + y * y + z * z).sqrt();
                    are_light &= weights <= most_weight;
                    if weights == 0.0 {
                        (*unit, *state) = (O::emit_single([0.0, 0.0, 1.0]), SlotState::Empty);
                    } else if weights.is_normal() && length >= LEAST_SUM as f32 * weights {
                        let reciprocal = 1.0 / length;
                        *unit = O::emit_single([x * reciprocal, y * reciprocal, z * reciprocal]);
                    } else {
                        recount.push(slot);
                    }
                }
            }
            sums.fill([0.0; 4]);
        }
        are_light
    }
}

/// Eight sums at once; false if one of them needs a closer look.
#[inline(always)]
fn finish_group<A: EightLanes<Element = f32>, O: Component>(
    arch: A,
    sums: &[[f32; 4]],
    most_weight: f32,
    unit: &mut [[O; 3]],
) -> bool {
    let (Ok(sums), Ok(unit)) = (<&[[f32; 4]; LANES]>::try_from(sums), <&mut [[O; 3]; LANES]>::try_from(unit))
    else {
        return false;
    };
    let [x, y, z, weights] = arch.columns(sums.each_ref());
    let (vector, weights) = (Vectors::new(arch, [x, y, z]), Scalars::new(arch, weights));
    let length = vector.squared_length().sqrt();
    let range =
        [f32::MIN_POSITIVE, most_weight.min(f32::MAX)].map(|end| Scalars::splat(arch, f64::from(end)));
    let in_range = (Scalars::splat(arch, LEAST_SUM) * weights).less(length)
        & range[0].less(weights)
        & weights.less(range[1]);
    if in_range.row_bits() != ALL {
        return false;
    }
    let Vectors { x, y, z } = vector.scaled(Scalars::splat(arch, 1.0) / length);
    let rows = arch.rows([x.value, y.value, z.value, z.value]).0;
    for (unit, [x, y, z, _]) in unit.iter_mut().zip(rows) {
        *unit = O::emit_single([x, y, z]);
    }
    true
}
