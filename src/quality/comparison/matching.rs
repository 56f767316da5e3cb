//! Which corners of two files are the same corner of the same face.
//!
//! Faces are matched by the positions of their corners, in single precision, since most formats keep no more. The order of faces and
//! vertices, splits and the cut into parts do not matter. Faces that are several times at one position are matched in their
//! order. Of the rest, polygons are matched with the triangles that they became, and polygons that became other polygons as
//! triangles.

use crate::mesh::Faces;
use crate::num::parallel;
use crate::quality::comparison::side::cuts;
use crate::quality::comparison::side::{MOST_CORNERS, Side};
use rayon::prelude::*;

/// The most faces at one position of which one that runs the same way is preferred.
const CANDIDATES: usize = 8;

/// The corners that two files share.
#[derive(Default)]
pub(crate) struct Matching {
    /// Corners before and after, ascending, each pair once.
    pub(crate) pairs: Vec<[u32; 2]>,
    /// The number of faces of each file without a counterpart, or with a triangle without one.
    pub(crate) unmatched: [usize; 2],
    /// The number of faces, or of their triangles, that run the other way.
    pub(crate) reversed: usize,
}

impl Matching {
    /// Matches whole faces, polygons with triangles, and the rest as triangles.
    pub(crate) fn find(sides: &[Side<'_>; 2]) -> Self {
        let mut found = Self::default();
        let faces = sides.each_ref().map(Side::whole);
        let mut missing = found.pair_up(sides, &faces);
        for polygons in [0, 1] {
            found.pair_cut(sides, &faces, &mut missing, polygons);
        }
        if missing.iter().all(|missing| missing.contains(&true)) {
            let cut = [0, 1].map(|side| sides[side].triangles(&missing[side]));
            let [(before, owners), (after, others)] = cut;
            let left = found.pair_up(sides, &[before, after]);
            for (missing, (left, owners)) in missing.iter_mut().zip(left.iter().zip([owners, others])) {
                missing.fill(false);
                for (&face, _) in owners.iter().zip(left).filter(|(_, left)| **left) {
                    missing[face as usize] = true;
                }
            }
        }
        found.unmatched = missing.map(|missing| missing.into_iter().filter(|&missing| missing).count());
        found.pairs.par_sort_unstable();
        // Two triangles of a polygon share corners.
        found.pairs.dedup();
        found
    }

    /// Pairs the corners of polygons of one side with those of the triangles that they became on the other.
    fn pair_cut(
        &mut self,
        sides: &[Side<'_>; 2],
        faces: &[Faces; 2],
        missing: &mut [Vec<bool>; 2],
        polygons: usize,
    ) {
        let triangles = 1 - polygons;
        let order = [polygons, triangles];
        for cut in cuts(order.map(|i| &sides[i]), order.map(|i| &faces[i]), order.map(|i| &missing[i][..])) {
            let in_order = |[polygon, triangle]: [u32; 2]| {
                if polygons == 0 { [polygon, triangle] } else { [triangle, polygon] }
            };
            self.pairs.extend(cut.pairs.into_iter().map(in_order));
            self.reversed += cut.reversed;
            missing[polygons][cut.face as usize] = false;
            cut.triangles.into_iter().for_each(|triangle| missing[triangles][triangle as usize] = false);
        }
    }

    /// Pairs the corners of faces at the same positions. Returns a mark for each face of each side without a counterpart.
    fn pair_up(&mut self, sides: &[Side<'_>; 2], faces: &[Faces; 2]) -> [Vec<bool>; 2] {
        let keys = [0, 1].map(|side| keys(&sides[side], &faces[side]));
        let mut missing = [0, 1].map(|side| vec![true; faces[side].len()]);
        let mut rest = keys[1].as_slice();
        for run in keys[0].chunk_by(|a, b| a.0 == b.0) {
            rest = &rest[rest.partition_point(|key| key.0 < run[0].0)..];
            let (mut same, other) = rest.split_at(rest.partition_point(|key| key.0 == run[0].0));
            rest = other;
            for &(_, before) in run {
                while same.first().is_some_and(|&(_, after)| !missing[1][after as usize]) {
                    same = &same[1..];
                }
                let first = faces[0].face(before as usize);
                let candidates = same.iter().take(CANDIDATES).map(|&(_, after)| after);
                let aligned = candidates.filter(|&after| missing[1][after as usize]).filter_map(|after| {
                    Some((after, Alignment::find(sides, first, faces[1].face(after as usize))?))
                });
                let best = aligned.min_by_key(|(_, alignment)| alignment.is_reversed);
                let Some((after, alignment)) = best else { continue };
                let second = faces[1].face(after as usize);
                let pair = |i: usize| [first[i], second[alignment.at(i, second.len())]];
                self.pairs.extend((0..first.len()).map(pair));
                self.reversed += usize::from(alignment.is_reversed);
                missing[0][before as usize] = false;
                missing[1][after as usize] = false;
            }
        }
        missing
    }
}

/// How the corners of a face correspond to those of another.
#[derive(Clone, Copy)]
struct Alignment {
    /// The index of the first corner of the one in the other.
    start: usize,
    /// Whether the other runs the other way.
    is_reversed: bool,
}

impl Alignment {
    fn find(sides: &[Side<'_>; 2], before: &[u32], after: &[u32]) -> Option<Self> {
        let count = before.len();
        if after.len() != count {
            return None;
        }
        // Polygons of very many corners are still matched as triangles.
        let starts = if count > MOST_CORNERS { 1 } else { count };
        let alignments = [false, true];
        let alignments =
            alignments.into_iter().flat_map(|is_reversed| (0..starts).map(move |start| (start, is_reversed)));
        alignments.map(|(start, is_reversed)| Self { start, is_reversed }).find(|at| {
            (0..count).all(|i| sides[0].place(before[i]) == sides[1].place(after[at.at(i, count)]))
        })
    }

    fn at(self, corner: usize, count: usize) -> usize {
        (self.start + if self.is_reversed { count - corner } else { corner }) % count
    }
}

/// A hash of the positions of the corners of each face, which does not depend on their order; sorted.
fn keys(side: &Side<'_>, faces: &Faces) -> Vec<(u64, u32)> {
    let mix = |place: [u32; 3]| {
        place.iter().fold(0u64, |hash, &bits| {
            (hash ^ u64::from(bits)).wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(29)
        })
    };
    let key = |face: usize| {
        faces.face(face).iter().fold(0u64, |sum, &corner| sum.wrapping_add(mix(side.place(corner))))
    };
    let mut keys = parallel::map(faces.len(), |face| (key(face), face as u32));
    keys.par_sort_unstable();
    keys
}
