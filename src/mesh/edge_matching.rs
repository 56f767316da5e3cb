//! Matching half-edges to edges, vertex by vertex.
//!
//! The corners at `a` see all half-edges of an edge {a, b}: those that leave for `b`, and those that arrive from `b`. So each
//! vertex can be matched by itself, in parallel and in any order, without a table of edges.

use super::faces::{FacesRef, is_collapsed, next_in_triangle, previous_in_triangle};
use super::link::{Link, PackedLink};
use super::rings::{Rings, Scatter};
use crate::num::parallel;

/// No vertex: a half-edge that collapsed, or the padding of a short ring.
const NOWHERE: u32 = u32::MAX;

/// Rings up to this valence are compared all with all in fixed arrays, which compilers turn into vector
/// compares; longer ones are sorted. Six is the mean valence of a triangle mesh.
const SMALL: usize = 16;

/// One corner of a ring: the half-edge that leaves the vertex here, and the one that arrives.
#[derive(Clone, Copy)]
struct Spoke {
    leaving: u32,
    to: u32,
    arriving: u32,
    from: u32,
}

/// Finds the [`Link`] of each half-edge by vertex index.
pub(crate) struct EdgeMatcher<'a> {
    faces: FacesRef<'a>,
    owners: &'a [u32],
    /// Faces of fewer than three distinct vertices; empty for triangles, which are checked by their corners.
    collapsed: Vec<bool>,
}

impl<'a> EdgeMatcher<'a> {
    pub(crate) fn new(faces: FacesRef<'a>, owners: &'a [u32]) -> Self {
        let polygons = if faces.is_triangles() { 0 } else { faces.len() };
        let collapsed = (0..polygons).map(|face| is_collapsed(faces.face(face).iter())).collect();
        Self { faces, owners, collapsed }
    }

    /// The link of every half-edge.
    pub(super) fn links(&self, rings: &Rings) -> Scatter {
        let links = Scatter::new(self.faces.corners().len(), 0);
        parallel::ranges(rings.len(), |vertices| {
            for vertex in vertices {
                self.match_ring(vertex as u32, rings.at(vertex), |half_edge, link| {
                    links.set(half_edge, PackedLink::new(link).0);
                });
            }
        });
        links
    }

    /// Finds the links of the half-edges that leave a vertex, given the corners at it.
    #[inline]
    pub(crate) fn match_ring(&self, vertex: u32, ring: &[u32], set: impl FnMut(u32, Link)) {
        let spokes = ring.iter().map(|&corner| self.spoke(vertex, corner));
        match ring.len() {
            0..=8 => match_small::<8>(spokes, set),
            9..=SMALL => match_small::<SMALL>(spokes, set),
            _ => match_large(spokes, set),
        }
    }

    #[inline(always)]
    fn spoke(&self, vertex: u32, corner: u32) -> Spoke {
        let corners = self.faces.corners();
        let (next, previous, collapsed) = if self.owners.is_empty() {
            let (next, previous) = (next_in_triangle(corner), previous_in_triangle(corner));
            (next, previous, corners[next as usize] == corners[previous as usize])
        } else {
            let face = self.owners[corner as usize] as usize;
            let range = self.faces.range(face);
            let (start, last) = (range.start as u32, range.end as u32 - 1);
            let next = if corner == last { start } else { corner + 1 };
            let previous = if corner == start { last } else { corner - 1 };
            (next, previous, self.collapsed[face])
        };
        let (mut to, mut from) = (corners[next as usize], corners[previous as usize]);
        // A triangle with two equal vertices is no surface: its edges must not separate the faces on its two sides.
        // A polygon that merely repeats a vertex remains, without the empty edge.
        let collapsed = collapsed || (self.owners.is_empty() && (to == vertex || from == vertex));
        if collapsed || to == vertex {
            to = NOWHERE;
        }
        if collapsed || from == vertex {
            from = NOWHERE;
        }
        Spoke { leaving: corner, to, arriving: previous, from }
    }
}

/// The link of a half-edge, from the number of half-edges along it and against it.
#[inline]
fn decide(same: u32, against: u32, twin: impl FnOnce() -> u32, double: impl FnOnce() -> u32) -> Link {
    match (same, against) {
        (1, 1) => Link::Twin(twin()),
        (1, 0) => Link::Boundary,
        (2, 0) => Link::Inconsistent(double()),
        _ => Link::NonManifold,
    }
}

fn match_small<const N: usize>(ring: impl Iterator<Item = Spoke>, mut set: impl FnMut(u32, Link)) {
    let (mut to, mut from) = ([NOWHERE; N], [NOWHERE; N]);
    let mut spokes = [Spoke { leaving: 0, to: NOWHERE, arriving: 0, from: NOWHERE }; N];
    let mut count = 0;
    for spoke in ring {
        (to[count], from[count], spokes[count]) = (spoke.to, spoke.from, spoke);
        count += 1;
    }
    for (i, spoke) in spokes[..count].iter().enumerate() {
        if spoke.to == NOWHERE {
            set(spoke.leaving, Link::Collapsed);
            continue;
        }
        let [same, same_at, against, against_at] = counts(&to, &from, spoke.to).to_le_bytes();
        let link = decide(
            same.into(),
            against.into(),
            || spokes[against_at as usize - 1].arriving,
            || spokes[same_at as usize - 2 - i].leaving,
        );
        set(spoke.leaving, link);
    }
}

/// How many entries of `to` equal a vertex, the sum of their indices counted from 1, and the same for `from`, a byte each.
///
/// Written lane by lane, which compilers turn into a few vector compares.
#[inline]
fn counts<const N: usize>(to: &[u32; N], from: &[u32; N], vertex: u32) -> u32 {
    const { assert!(N * (N + 1) / 2 < 256, "the sum of all indices must fit a byte") };
    let all_ones_if = |equal: bool| 0u32.wrapping_sub(u32::from(equal));
    let mut lanes = [0; N];
    for (index, lane) in lanes.iter_mut().enumerate() {
        let one = 1 | (index as u32 + 1) << 8;
        *lane = all_ones_if(to[index] == vertex) & one | all_ones_if(from[index] == vertex) & one << 16;
    }
    lanes.iter().sum()
}

fn match_large(ring: impl Iterator<Item = Spoke>, mut set: impl FnMut(u32, Link)) {
    let mut ends: Vec<(u32, bool, u32)> = Vec::new();
    for spoke in ring {
        if spoke.to == NOWHERE {
            set(spoke.leaving, Link::Collapsed);
        }
        ends.extend((spoke.to != NOWHERE).then_some((spoke.to, false, spoke.leaving)));
        ends.extend((spoke.from != NOWHERE).then_some((spoke.from, true, spoke.arriving)));
    }
    ends.sort_unstable();
    for edge in ends.chunk_by(|a, b| a.0 == b.0) {
        let same = edge.partition_point(|end| !end.1);
        for (i, &(_, _, leaving)) in edge[..same].iter().enumerate() {
            let link = decide(same as u32, (edge.len() - same) as u32, || edge[same].2, || edge[1 - i].2);
            set(leaving, link);
        }
    }
}
