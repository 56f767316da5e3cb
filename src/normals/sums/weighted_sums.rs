//! Weighted sums of face normals over vertices or smooth groups.

use crate::normals::faces::component::Component;
use crate::normals::faces::positions::Source;
use crate::normals::sums::accumulate::{Part, UnusualFace, Walk, add_faces};
use crate::normals::sums::finish::{Finish, UncertainSlots};
use crate::normals::sums::partition::Partition;
use crate::normals::sums::recheck::Recheck;
use crate::normals::sums::request::{SlotState, Sum, SumRequest, Sums};
use crate::normals::sums::scatter::SumNumber;
use crate::num::{self, Real};
use rayon::prelude::*;
use std::ops::Range;

/// Memory that the next call reuses. Sums are zero between calls.
#[derive(Default)]
pub(crate) struct SumScratch {
    parts: Vec<Part<f64>>,
    pub(crate) single_parts: Vec<Part<f32>>,
    pub(crate) single_positions: Vec<[f32; 3]>,
}

/// What is known in addition to the sums themselves.
#[derive(Default)]
pub(crate) struct Outcome {
    /// The faces that are not simply counted, ascending.
    pub(crate) unusual: Vec<UnusualFace>,
    /// Whether it is certain that every slot is [`SlotState::Good`].
    pub(crate) all_good: bool,
    /// Whether a face has a vertex that does not exist. Then nothing was computed.
    pub(crate) vertex_missing: bool,
}

/// Σ w n̂ of every slot, each sum in ascending face index whatever the number of threads.
///
/// Faces without direction add nothing, nor do slivers with [`Slivers::Exclude`](crate::normals::Slivers::Exclude), unless
/// a slot has no other face. If all weights of a slot vanish, its faces count the same. A slot with one face has that
/// face's normal to the bit.
pub(crate) fn weighted_sums(request: &SumRequest, scratch: &mut SumScratch) -> (Sums, Outcome) {
    let mut sums = Sums::new(request.slots);
    let unit: &mut [[f64; 3]] = bytemuck::cast_slice_mut(&mut sums.unit);
    let outcome = weighted_sums_into(request, scratch, unit, &mut sums.state);
    (sums, outcome)
}

/// The same into the caller's slices, one entry a slot.
pub(crate) fn weighted_sums_into<O: Component>(
    request: &SumRequest,
    scratch: &mut SumScratch,
    unit: &mut [[O; 3]],
    state: &mut [SlotState],
) -> Outcome {
    let source = &Source::new(request.positions);
    let partition = Partition::new(request.faces, request.target);
    // Whatever stops the work half way, the next call does not find its sums.
    let mut memory = std::mem::take(&mut scratch.parts);
    memory.resize_with(partition.parts().max(memory.len()), Part::default);
    let parts = &mut memory[..partition.parts()];
    let add = |walk: Walk, sums: &mut [Sum], unusual: &mut Vec<UnusualFace>| {
        add_faces(request, source, walk, sums, unusual)
    };
    let Some(owned) = accumulate(request, partition, parts, &add) else {
        return Outcome { vertex_missing: true, ..Outcome::default() };
    };
    let areas = request.sums_area_vectors();
    finish(request.slots, parts, &owned, unit, state, &|part, owned, unit, state| {
        part.uncertain.clear();
        let first = owned.start as u32;
        let (sums, uncertain) = (&mut part.sums.get(request.slots)[owned], &mut part.uncertain);
        num::dispatch(Finish { sums, first, unit, state, uncertain, areas });
        true
    });

    // Shares ascend, and so do the faces in them; slots do too.
    let unusual: Vec<UnusualFace> = parts.iter().flat_map(|part| part.unusual.iter().copied()).collect();
    let mut uncertain = UncertainSlots::default();
    parts.iter().for_each(|part| uncertain.join(&part.uncertain));
    scratch.parts = memory;
    let recheck = Recheck { request, source, unusual: &unusual };
    for (slot, vector, found) in recheck.run(&uncertain) {
        unit[slot as usize] = O::emit(vector);
        state[slot as usize] = found;
    }
    Outcome { unusual, all_good: !uncertain.not_all_good, vertex_missing: false }
}

/// Adds the faces of a walk to sums; false if that cannot be done.
pub(crate) type Add<'a, T> = dyn Fn(Walk, &mut [[T; 4]], &mut Vec<UnusualFace>) -> bool + Sync + 'a;

/// Sums of all parts, and the slots that each owns; `None` if some faces cannot be added.
pub(crate) fn accumulate<T: SumNumber>(
    request: &SumRequest,
    partition: Partition,
    parts: &mut [Part<T>],
    add: &Add<T>,
) -> Option<Vec<Range<usize>>> {
    let slots = request.slots;
    let alone = parts.len() == 1;
    let add_share = |(number, part): (usize, &mut Part<T>)| {
        let Part { sums, touched, unusual, .. } = part;
        sums.reserve(slots);
        touched.clear();
        unusual.clear();
        let walk = Walk::Share(partition.share(number), (!alone).then_some(touched));
        add(walk, sums.get(slots), unusual)
    };
    if !for_each_part(parts, add_share).into_iter().all(|found| found) {
        return None;
    }
    let owned = owned_slots(parts, slots);
    let outside = for_each_part(parts, |(number, part)| {
        part.hand_over(request, partition.share(number), owned[number].start)
    });
    for_each_part(parts, |(number, part)| {
        let Part { sums, unusual, .. } = part;
        // The parts in whose share these faces are have found the unusual ones too.
        let found = unusual.len();
        for faces in &outside[number + 1..] {
            let sums = &mut sums.get(slots)[..owned[number].end];
            add(Walk::Listed(faces, owned[number].start), sums, unusual);
        }
        unusual.truncate(found);
    });
    Some(owned)
}

/// What [`finish`] does to a part, the slots that it owns and their entries; returns whether it went well.
type Finishing<'a, T, O> =
    dyn Fn(&mut Part<T>, Range<usize>, &mut [[O; 3]], &mut [SlotState]) -> bool + Sync + 'a;

/// Does the same to the sums that each part owns and to the entries of two slices that belong to them; returns whether all
/// went well.
pub(crate) fn finish<T: Real + bytemuck::Pod, O: Send>(
    slots: usize,
    parts: &mut [Part<T>],
    owned: &[Range<usize>],
    mut unit: &mut [[O; 3]],
    mut state: &mut [SlotState],
    work: &Finishing<T, O>,
) -> bool {
    debug_assert_eq!((unit.len(), state.len()), (slots, slots));
    let mut shares = Vec::new();
    for (part, owned) in parts.iter_mut().zip(owned) {
        let unit = unit.split_off_mut(..owned.len()).expect("one for each slot");
        let state = state.split_off_mut(..owned.len()).expect("one for each slot");
        shares.push((part, owned.clone(), unit, state));
    }
    let done =
        for_each_part(&mut shares, |(_, (part, owned, unit, state))| work(part, owned.clone(), unit, state));
    done.into_iter().all(|done| done)
}

/// The slots that each part owns: from where earlier parts end up to the highest that it touches; the last one the rest.
fn owned_slots<T>(parts: &[Part<T>], slots: usize) -> Vec<Range<usize>> {
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
