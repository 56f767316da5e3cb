//! Runs: corners that follow one another around a vertex and share a stored normal, and what the edges among them explain.

use crate::quality::estimate::pole_cache::{PoleCache, SHORT};
use crate::quality::findings::prelude::*;
use crate::quality::findings::smoothing::edge::Edge;

/// What explains the normal of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Run {
    /// An edge within it is averaged and reported.
    pub(crate) is_averaged: bool,
    /// It has several corners and ends at a seam.
    pub(crate) ends_at_seam: bool,
}

/// The runs of a mesh whose corners share normals, computed when they are needed.
pub(crate) struct Runs<'a> {
    facts: &'a Facts<'a>,
    /// The dihedral angle in degrees from which averaged edges are reported.
    reported_from: f64,
    long: PoleCache<Run>,
}

impl<'a> Runs<'a> {
    /// `None` if the file cannot share normals, or has none.
    pub(crate) fn new(facts: &'a Facts<'a>) -> Option<Self> {
        let estimate = facts.estimate.filter(|_| facts.file.shares_vertices())?;
        let reported_from = estimate.sharp_from() + facts.thresholds.crease.0;
        Some(Self { facts, reported_from, long: PoleCache::default() })
    }

    pub(crate) fn of(&self, corner: u32) -> Run {
        let short = || Some(self.walk(corner, SHORT)).filter(|(_, corners)| corners.len() <= SHORT);
        self.long.of(corner, || short().map(|(run, _)| run), || self.walk(corner, usize::MAX))
    }

    /// A run and its corners; of a long one, more than `most` of them.
    fn walk(&self, start: u32, most: usize) -> (Run, Vec<u32>) {
        let (mut corners, mut ends) = (vec![start], Vec::new());
        let (mut is_averaged, mut is_closed) = (false, false);
        for is_ahead in [true, false] {
            let mut at = start;
            while !is_closed && let Some((edge, end)) = Edge::next_to(self.facts, at, is_ahead) {
                if edge.gaps[end] > SAME {
                    ends.push(edge);
                    break;
                }
                is_averaged |= edge.is_averaged(self.facts, self.reported_from);
                at = edge.ends[end][1] as u32;
                is_closed = at == start;
                if is_closed || corners.len() > most {
                    break;
                }
                corners.push(at);
            }
        }
        let ends_at_seam = corners.len() > 1 && ends.iter().any(|edge| edge.is_seam(self.facts));
        (Run { is_averaged, ends_at_seam }, corners)
    }
}
