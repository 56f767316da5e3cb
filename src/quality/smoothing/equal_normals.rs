//! Corners round a vertex that have one normal together, and what the edges among them say of it.

use crate::mesh::Column;
use crate::quality::facts::Facts;
use crate::quality::smoothing::smoothing_findings::{Edge, SAME, WAYS};
use crate::quality::stored::vertex_fans::{SHORT, VertexFans};
use crate::quality::thresholds::Thresholds;
use glam::DVec3;

/// What explains the normal that a run of corners has: corners that follow one another round a vertex, with one normal across
/// each edge between two of them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(in crate::quality) struct Run {
    /// Whether it goes over an edge that is averaged and told as such.
    pub(in crate::quality) is_averaged: bool,
    /// Whether there are several corners and an edge that it ends at is a seam.
    pub(in crate::quality) ends_at_seam: bool,
}

/// The runs of a mesh whose corners share normals, as they are asked for.
pub(in crate::quality) struct Runs<'a> {
    facts: &'a Facts<'a>,
    stored: &'a Column<DVec3>,
    thresholds: &'a Thresholds,
    /// The bend in degrees from which on averaged edges are told.
    told_from: f64,
    long: VertexFans<Run>,
}

impl<'a> Runs<'a> {
    /// `None` if the file cannot share normals, or has none.
    pub(in crate::quality) fn new(facts: &'a Facts<'a>, thresholds: &'a Thresholds) -> Option<Self> {
        let stored = facts.stored.filter(|_| facts.shares_vertices)?;
        let told_from = facts.estimate?.sharp_from() + thresholds.crease.0;
        Some(Self { facts, stored, thresholds, told_from, long: VertexFans::default() })
    }

    /// The one that a corner is of.
    pub(in crate::quality) fn of(&self, corner: u32) -> Run {
        let short = || Some(self.walk(corner, SHORT)).filter(|(_, corners)| corners.len() <= SHORT);
        self.long.of(corner, || short().map(|(run, _)| run), || self.walk(corner, usize::MAX))
    }

    /// What a run is, and its corners; of a long one, that it has more corners than `most`.
    fn walk(&self, start: u32, most: usize) -> (Run, Vec<u32>) {
        let (mut corners, mut ends) = (vec![start], Vec::new());
        let (mut is_averaged, mut is_round) = (false, false);
        for way in WAYS {
            if is_round {
                break;
            }
            for (edge, end) in way.edges(self.facts, self.stored, start) {
                if edge.gaps[end] > SAME {
                    ends.push(edge);
                    break;
                }
                is_averaged |= edge.is_averaged(self.facts, self.told_from);
                let next = edge.ends[end][1] as u32;
                is_round = next == start;
                if is_round || corners.len() > most {
                    break;
                }
                corners.push(next);
            }
        }
        let is_seam = |edge: &Edge| edge.is_seam(self.facts, self.stored, self.thresholds);
        let ends_at_seam = corners.len() > 1 && ends.iter().any(is_seam);
        (Run { is_averaged, ends_at_seam }, corners)
    }
}
