//! The cone rule: each corner averages the faces of its fan that face nearly its own way.

use super::crease::CreaseTest;
use super::fans::FanWalker;
use super::groups::{FanScratch, Members, SmoothGroups};
use crate::mesh::NONE;
use rustc_hash::FxHashMap;

/// Fans of more corners than this are cut by the fan rule instead. Time and memory of the cone rule are quadratic
/// in the valence: 16 MiB of hostile fans of this size need some 300 MB, of a thousand corners ten times that.
pub(crate) const MAX_CONE_FAN: usize = 128;

impl SmoothGroups {
    /// Groups under the cone rule. Also returns how many fans were too large and cut by the fan rule.
    ///
    /// Quadratic in the valence of a vertex, up to [`MAX_CONE_FAN`].
    pub(crate) fn by_cone(walker: &FanWalker, vertex_count: usize) -> (Self, usize) {
        let corner_count = walker.faces.corners().len();
        let mut group = vec![NONE; corner_count];
        let mut members = Members { offsets: vec![0], corners: Vec::new() };
        let mut scratch = FanScratch::default();
        let (mut set, mut declined) = (Vec::new(), 0);
        for start in 0..corner_count as u32 {
            if group[start as usize] != NONE {
                continue;
            }
            walker.stretch(start, &mut scratch.stretch);
            let corners = scratch.stretch.corners.clone();
            if corners.len() > MAX_CONE_FAN {
                declined += 1;
                walker.cuts(&scratch.stretch, &mut scratch.places, &mut scratch.cuts);
                let mut pieces: Vec<(u32, u32)> = Vec::new();
                super::groups::for_each_piece(&scratch.stretch, &scratch.cuts, |c, piece| {
                    pieces.push((piece, c))
                });
                pieces.sort_unstable();
                for piece in pieces.chunk_by(|a, b| a.0 == b.0) {
                    let set: Vec<u32> = piece.iter().map(|&(_, corner)| corner).collect();
                    let number = members.push(&set);
                    set.iter().for_each(|&corner| group[corner as usize] = number);
                }
                continue;
            }
            walker.deciding_places(&scratch.stretch, &mut scratch.places);
            let deciding: Vec<u32> = scratch.places.iter().map(|&place| corners[place]).collect();
            let mut known: FxHashMap<Vec<u32>, u32> = FxHashMap::default();
            for &corner in &corners {
                set.clear();
                if !deciding.contains(&corner) && !matches!(walker.crease, CreaseTest::Every) {
                    set.extend_from_slice(&corners);
                } else {
                    let own = walker.normal(corner);
                    set.push(corner);
                    set.extend(deciding.iter().copied().filter(|&other| {
                        other != corner
                            && match walker.crease {
                                CreaseTest::Every => false,
                                CreaseTest::None => true,
                                CreaseTest::Over { limit, .. } => !limit.exceeded(own, walker.normal(other)),
                            }
                    }));
                }
                set.sort_unstable();
                group[corner as usize] = *known.entry(set.clone()).or_insert_with(|| members.push(&set));
            }
        }
        let mut groups = Self::from_groups(walker.faces, vertex_count, &group);
        groups.members = Some(groups.members_by_slot(&group, &members));
        (groups, declined)
    }

    /// Members in the order of slots: a slot that is no group's own has none.
    fn members_by_slot(&self, group: &[u32], members: &Members) -> Members {
        let mut of_slot = vec![NONE; self.entry_vertex.len()];
        for (corner, &entry) in self.corner_entry.iter().enumerate() {
            of_slot[self.slot(entry) as usize] = group[corner];
        }
        let mut ordered = Members { offsets: vec![0], corners: Vec::new() };
        for number in of_slot {
            if number == NONE {
                ordered.push(&[]);
            } else {
                ordered.push(members.row(number));
            }
        }
        ordered
    }
}

impl Members {
    fn push(&mut self, row: &[u32]) -> u32 {
        self.corners.extend_from_slice(row);
        self.offsets.push(self.corners.len() as u32);
        self.offsets.len() as u32 - 2
    }

    /// The corners of one row.
    pub(crate) fn row(&self, number: u32) -> &[u32] {
        let number = number as usize;
        &self.corners[self.offsets[number] as usize..self.offsets[number + 1] as usize]
    }
}
