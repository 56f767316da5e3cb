//! Counting edges by what they are, for reports.

use super::crease::CreaseTest;
use super::fans::FanWalker;
use super::{EdgeCounts, FaceState};
use crate::mesh::Link;
use rayon::prelude::*;

/// Counts the edges of a mesh, each once, and those near the crease angle.
pub(crate) fn edge_counts(walker: &FanWalker) -> (EdgeCounts, usize) {
    const CHUNK: usize = 1 << 14;
    let corner_count = walker.faces.corners().len();
    let (mut counts, near) = (0..corner_count.div_ceil(CHUNK))
        .into_par_iter()
        .map(|chunk| {
            let (mut counts, mut near) = (EdgeCounts::default(), 0);
            for half_edge in chunk * CHUNK..((chunk + 1) * CHUNK).min(corner_count) {
                tally(walker, half_edge as u32, &mut counts, &mut near);
            }
            (counts, near)
        })
        .reduce(|| (EdgeCounts::default(), 0), |(a, n), (b, m)| (a + b, n + m));
    counts.non_manifold = walker.topology.non_manifold_edges();
    counts.ambiguous = walker.topology.ambiguous_edges();
    (counts, near)
}

fn tally(walker: &FanWalker, half_edge: u32, counts: &mut EdgeCounts, near: &mut usize) {
    let across = match walker.topology.link(half_edge) {
        Link::Twin(across) => across,
        Link::Welded(across) => {
            counts.welded += usize::from(half_edge < across);
            across
        }
        Link::Inconsistent(across) => {
            counts.inconsistent += usize::from(half_edge < across);
            return;
        }
        Link::Boundary => {
            counts.boundary += 1;
            return;
        }
        Link::NonManifold | Link::Ambiguous | Link::Collapsed => return,
    };
    if half_edge > across {
        return;
    }
    if walker.marks.is_marked(half_edge, across) {
        counts.marked += 1;
        return;
    }
    let state = |corner| walker.normals.state[walker.topology.face_of(corner) as usize];
    let decided = state(half_edge) == FaceState::Counted && state(across) == FaceState::Counted;
    let (a, b) = (walker.normal(half_edge), walker.normal(across));
    *near += usize::from(decided && walker.crease.is_near(a, b));
    let is_crease = match walker.crease {
        CreaseTest::Every => true,
        CreaseTest::None => false,
        CreaseTest::Over { limit, .. } => decided && limit.exceeded(a, b),
    };
    if is_crease { counts.crease += 1 } else { counts.smooth += 1 }
}

impl std::ops::Add for EdgeCounts {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            smooth: self.smooth + other.smooth,
            boundary: self.boundary + other.boundary,
            non_manifold: self.non_manifold + other.non_manifold,
            inconsistent: self.inconsistent + other.inconsistent,
            ambiguous: self.ambiguous + other.ambiguous,
            marked: self.marked + other.marked,
            crease: self.crease + other.crease,
            welded: self.welded + other.welded,
        }
    }
}
