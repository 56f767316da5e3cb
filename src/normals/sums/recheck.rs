//! A second evaluation of slots whose sums do not determine the result.

use crate::normals::faces::positions::Source;
use crate::normals::faces::shape::FaceState;
use crate::normals::sums::accumulate::{UnusualFace, repeats};
use crate::normals::sums::corner_mean::{Term, adds, mean};
use crate::normals::sums::corner_terms::CornerTerms;
use crate::normals::sums::finish::UncertainSlots;
use crate::normals::sums::partition::Bounds;
use crate::normals::sums::request::{SlotState, SumRequest};
use crate::num;
use glam::DVec3;
use rayon::prelude::*;

/// Faces walked at a time.
const BLOCK_FACES: usize = 1024;
/// The fewest slots that a thread takes.
const SMALLEST_SHARE: usize = 512;

/// The results that sums alone do not give: of slots of one face, which get its normal to the bit, of those that nothing
/// was added to, and of those that seem to cancel.
pub(crate) struct Recheck<'a> {
    pub(crate) request: &'a SumRequest<'a>,
    pub(crate) source: &'a Source<'a>,
    /// Faces not simply counted, ascending.
    pub(crate) unusual: &'a [UnusualFace],
}

impl Recheck<'_> {
    /// Results by slot.
    pub(crate) fn run(&self, uncertain: &UncertainSlots) -> Vec<(u32, DVec3, SlotState)> {
        let mut slots: Vec<NotedSlot> = Vec::new();
        slots.extend(uncertain.perhaps_one_face.iter().map(|&slot| (slot, notes::NO_FACE)));
        slots.extend(uncertain.recount.iter().map(|&slot| (slot, notes::RECOUNT)));
        slots.sort_unstable();
        // Each thread takes some slots in a row.
        let share = slots.len().div_ceil(rayon::current_num_threads()).max(SMALLEST_SHARE);
        slots.par_chunks(share).flat_map_iter(|slots| self.evaluate(slots)).collect()
    }

    fn evaluate(&self, uncertain: &[NotedSlot]) -> Vec<(u32, DVec3, SlotState)> {
        let (alone, mut terms) = self.collect(uncertain);
        let mut scalar = CornerTerms::default();
        let mut results = Vec::with_capacity(alone.len());
        for slots in alone.chunk_by(|a, b| a.0 == b.0) {
            let unit = scalar.shape(self.request.faces, self.source, slots[0].0 as usize).unit;
            results.extend(slots.iter().map(|&(_, slot)| (slot, unit, SlotState::Good)));
        }
        // Stable: the terms of a slot stay in ascending face index.
        terms.sort_by_key(|&(slot, _)| slot);
        let mut of_slot = Vec::new();
        for terms in terms.chunk_by(|a, b| a.0 == b.0) {
            of_slot.clear();
            of_slot.extend(terms.iter().map(|&(_, term)| term));
            let (unit, state) = mean(&of_slot, self.request.slivers);
            results.push((terms[0].0, unit, state));
        }
        results
    }

    /// Walks the faces once more: slots of one face, as (face, slot) sorted by face, and the terms of slots to recount.
    #[expect(clippy::type_complexity, reason = "two lists of pairs, named in the line above")]
    fn collect(&self, uncertain: &[NotedSlot]) -> (Vec<(u32, u32)>, Vec<(u32, Term)>) {
        let Self { request, source, .. } = *self;
        let (mut scalar, mut terms) = (CornerTerms::default(), Vec::new());
        let mut notes = Notes::new(uncertain);
        for first in (0..request.faces.len()).step_by(BLOCK_FACES) {
            let faces = first..(first + BLOCK_FACES).min(request.faces.len());
            let slots = request.faces.start(faces.start)..request.faces.start(faces.end);
            if !notes.touch(num::dispatch(Bounds(&request.target[slots]))) {
                continue;
            }
            for face in faces {
                let unusual = self.unusual.binary_search_by_key(&(face as u32), |&(face, _)| face);
                let state = unusual.map_or(FaceState::Counted, |at| self.unusual[at].1);
                let slots = &request.target[request.faces.range(face)];
                let mut filled = false;
                for (corner, &slot) in slots.iter().enumerate() {
                    let Some(note) = notes.of(slot) else { continue };
                    if *note != notes::RECOUNT {
                        if adds(state, request.slivers) {
                            notes::one_more_face(note, face as u32);
                        }
                    } else if state.has_direction() {
                        if !filled {
                            scalar.fill(request.faces, source, request.weight, face, |at| repeats(slots, at));
                            filled = true;
                        }
                        let (vector, unit, weight) = (scalar.vector, scalar.unit, scalar.weights[corner]);
                        terms.push((slot, Term { vector, unit, weight, face: face as u32, state }));
                    }
                }
            }
        }
        let alone = uncertain.iter().filter_map(|&(slot, _)| {
            let face = notes.of(slot).and_then(|note| note.checked_sub(notes::FIRST_FACE))?;
            Some((face, slot))
        });
        let mut alone: Vec<(u32, u32)> = alone.collect();
        alone.sort_unstable();
        (alone, terms)
    }
}

/// A slot, and the note on it to begin with.
type NotedSlot = (u32, u32);

mod notes {
    //! What is known of a slot: one of these, or [`FIRST_FACE`] plus the number of its only face so far.

    /// It is not uncertain.
    pub(super) const NOTHING: u32 = 0;
    /// To be summed term by term.
    pub(super) const RECOUNT: u32 = 1;
    /// Several faces.
    pub(super) const FACES: u32 = 2;
    /// No face so far.
    pub(super) const NO_FACE: u32 = 3;
    /// Face 0.
    pub(super) const FIRST_FACE: u32 = 4;

    /// Takes note of a face.
    pub(super) fn one_more_face(note: &mut u32, face: u32) {
        if *note == NO_FACE {
            *note = FIRST_FACE + face;
        } else if *note != FIRST_FACE + face {
            *note = FACES;
        }
    }
}

/// Notes on the slots from the first uncertain one to the last. Pages of others are never given memory.
struct Notes<'a> {
    first: u32,
    notes: Vec<u32>,
    /// The uncertain slots, ascending.
    uncertain: &'a [NotedSlot],
}

impl<'a> Notes<'a> {
    fn new(uncertain: &'a [NotedSlot]) -> Self {
        let (first, last) = (uncertain[0].0, uncertain[uncertain.len() - 1].0);
        let mut notes = bytemuck::zeroed_vec((last - first) as usize + 1);
        for &(slot, note) in uncertain {
            notes[(slot - first) as usize] = note;
        }
        Self { first, notes, uncertain }
    }

    /// Whether an uncertain slot lies between these two.
    fn touch(&self, (low, high): (u32, u32)) -> bool {
        let next = self.uncertain.partition_point(|&(slot, _)| slot < low);
        self.uncertain.get(next).is_some_and(|&(slot, _)| slot <= high)
    }

    /// The note on an uncertain slot.
    fn of(&mut self, slot: u32) -> Option<&mut u32> {
        let place = slot.wrapping_sub(self.first) as usize;
        self.notes.get_mut(place).filter(|note| **note != notes::NOTHING)
    }
}
