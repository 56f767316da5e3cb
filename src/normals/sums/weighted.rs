//! Weighted sums of face normals over vertices or smooth groups.

use crate::mesh::FacesRef;
use crate::normals::faces::output::Emit;
use crate::normals::faces::positions::{Positions, Source, Visitor};
use crate::normals::recipe::{Slivers, Weight};
use crate::normals::sums::accumulate::{Accumulate, Part, Sum, UnusualFace, Walk};
use crate::normals::sums::finish::{Finish, UncertainSlots};
use crate::normals::sums::partition::Partition;
use crate::normals::sums::recheck::Recheck;
use crate::normals::sums::weight::{CornerWeight, WeightVisitor, visit_weight};
use crate::num;
use glam::DVec3;
use rayon::prelude::*;
use std::marker::PhantomData;
use std::ops::Range;

/// A sum with more than this times its own length in weights has cancelled.
pub(crate) const CANCELLING: f64 = 1e6;

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

/// What to add up, and where. A *slot* is whatever a sum belongs to: a vertex, a smooth group.
#[derive(Clone, Copy)]
pub(crate) struct SumRequest<'a> {
    /// The faces.
    pub(crate) faces: FacesRef<'a>,
    /// The positions of vertices.
    pub(crate) positions: Positions<'a>,
    /// The slot of each corner, [`NONE`](crate::mesh::NONE) to leave it out.
    pub(crate) target: &'a [u32],
    /// How many slots there are.
    pub(crate) slots: usize,
    /// How much each face counts.
    pub(crate) weight: Weight,
    /// What slivers count.
    pub(crate) slivers: Slivers,
}

/// One direction a slot.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Sums {
    /// Unit vectors. Of a cancelling slot the direction of what is left, of an empty one zero.
    pub(crate) unit: Vec<DVec3>,
    /// What each is worth.
    pub(crate) state: Vec<SlotState>,
}

/// Memory that can be used again by the next call.
#[derive(Default)]
pub(crate) struct SumScratch {
    /// Their sums are zero between calls.
    parts: Vec<Part>,
}

/// What is worth knowing beside the sums themselves.
#[derive(Default)]
pub(crate) struct Outcome {
    /// The faces that are not simply counted, ascending.
    pub(crate) odd: Vec<UnusualFace>,
    /// Whether it is certain that every slot is [`SlotState::Good`].
    pub(crate) all_good: bool,
    /// Whether a face has a vertex that does not exist. Then nothing was computed.
    pub(crate) vertex_missing: bool,
}

/// Adds up Σ w n̂ for every slot, each sum in ascending face index whatever the number of threads.
///
/// Faces without direction add nothing, nor do slivers with [`Slivers::Exclude`], unless a slot has no other face. If
/// all weights of a slot vanish, its faces count the same. A slot with one face gets that face's normal to the bit.
pub(crate) fn weighted_sums(request: &SumRequest) -> Sums {
    let mut sums =
        Sums { unit: bytemuck::zeroed_vec(request.slots), state: vec![SlotState::Empty; request.slots] };
    weighted_sums_into(request, &mut SumScratch::default(), &mut sums.unit, &mut sums.state);
    sums
}

/// The same into the caller's slices, one entry a slot.
pub(crate) fn weighted_sums_into<O: Emit>(
    request: &SumRequest,
    scratch: &mut SumScratch,
    unit: &mut [O],
    state: &mut [SlotState],
) -> Outcome {
    request.positions.visit(WithSource { request, scratch, unit, state })
}

struct WithSource<'a, O> {
    request: &'a SumRequest<'a>,
    scratch: &'a mut SumScratch,
    unit: &'a mut [O],
    state: &'a mut [SlotState],
}

impl<O: Emit> Visitor for WithSource<'_, O> {
    type Output = Outcome;

    fn visit<S: Source>(self, source: S) -> Self::Output {
        visit_weight(self.request.weight, WithWeight { all: self, source })
    }
}

struct WithWeight<'a, S, O> {
    all: WithSource<'a, O>,
    source: S,
}

impl<S: Source, O: Emit> WeightVisitor for WithWeight<'_, S, O> {
    type Output = Outcome;

    fn visit<W: CornerWeight>(self) -> Self::Output {
        let Self { all: WithSource { request, scratch, unit, state }, source } = self;
        let SumRequest { faces, target, slots, .. } = *request;
        let partition = Partition::new(faces, target);
        // Whatever stops the work half way, the next call does not find its sums.
        let mut memory = std::mem::take(&mut scratch.parts);
        memory.resize_with(partition.parts().max(memory.len()), Part::default);
        let parts = &mut memory[..partition.parts()];
        let alone = parts.len() == 1;

        let accumulate = |walk: Walk, sums: &mut [Sum], odd: &mut Vec<UnusualFace>| {
            num::dispatch(Accumulate { request, source, walk, sums, odd, weight: PhantomData::<W> })
        };
        let add_share = |(number, part): (usize, &mut Part)| {
            let Part { sums, touched, odd, .. } = part;
            sums.reserve(slots);
            touched.clear();
            odd.clear();
            let walk = Walk::Share(partition.share(number), (!alone).then_some(touched));
            accumulate(walk, sums.get(slots), odd)
        };
        if !for_each_part(parts, add_share).into_iter().all(|found| found) {
            return Outcome { vertex_missing: true, ..Outcome::default() };
        }

        let owned = owned_slots(parts, slots);
        let outside_range = for_each_part(parts, |(number, part)| {
            part.hand_over(request, partition.share(number), owned[number].start)
        });
        let (mut unit_left, mut state_left, mut work) = (&mut *unit, &mut *state, Vec::new());
        for (part, owned) in parts.iter_mut().zip(owned) {
            let unit = unit_left.split_off_mut(..owned.len()).expect("one for each slot");
            let state = state_left.split_off_mut(..owned.len()).expect("one for each slot");
            work.push((part, owned, unit, state));
        }
        for_each_part(&mut work, |(number, (part, owned, unit, state))| {
            let Part { sums, odd, doubts, .. } = &mut **part;
            let sums = &mut sums.get(slots)[..owned.end];
            let found = odd.len();
            for faces in &outside_range[number + 1..] {
                accumulate(Walk::Listed(faces, owned.start), sums, odd);
            }
            // The parts in whose share these faces are have found them too.
            odd.truncate(found);
            doubts.clear();
            let (sums, first) = (&mut sums[owned.start..], owned.start as u32);
            num::dispatch(Finish { sums, first, unit, state, doubts, areas: W::BY_AREA && W::EVEN });
        });

        // Shares ascend, and so do the faces in them; slots do too.
        let odd: Vec<UnusualFace> = parts.iter().flat_map(|part| part.odd.iter().copied()).collect();
        let mut doubts = UncertainSlots::default();
        parts.iter().for_each(|part| doubts.join(&part.doubts));
        scratch.parts = memory;
        let again = Recheck::<S, W> { request, source, odd: &odd, weight: PhantomData };
        for (slot, vector, worth) in again.run(&doubts) {
            unit[slot as usize] = O::emit(vector);
            state[slot as usize] = worth;
        }
        Outcome { odd, all_good: !doubts.not_all_good, vertex_missing: false }
    }
}

/// The slots that each part owns: from where earlier parts end up to the highest that it touches; the last one the rest.
fn owned_slots(parts: &[Part], slots: usize) -> Vec<Range<usize>> {
    let mut start = 0;
    let owned = parts.iter().enumerate().map(|(number, part)| {
        let end = if number + 1 == parts.len() { slots } else { part.touched.end().clamp(start, slots) };
        std::mem::replace(&mut start, end)..end
    });
    owned.collect()
}

/// Does work for each of some parts at the same time; for one alone without asking for threads.
fn for_each_part<P: Send, R: Send>(
    parts: &mut [P],
    work: impl Fn((usize, &mut P)) -> R + Sync + Send,
) -> Vec<R> {
    match parts {
        [part] => vec![work((0, part))],
        parts => parts.par_iter_mut().enumerate().map(work).collect(),
    }
}
