//! Edges between two sound faces with the stored normals on both sides, and runs: corners that follow one another around a vertex
//! and share a stored normal.

use crate::mesh::Link;
use crate::quality::estimate::means::{PoleCache, SHORT};
use crate::quality::findings::prelude::*;
use crate::quality::findings::stored::origin::Origin;
use crate::quality::thresholds::Thresholds;

/// An edge between two sound faces, with stored normals at all four corners.
pub(crate) struct Edge {
    pub(crate) half_edge: u32,
    across: u32,
    pub(crate) faces: [usize; 2],
    /// The angle between the stored normals of the two sides at each end, in degrees.
    pub(crate) gaps: [f64; 2],
    /// The corners of the two faces at each end.
    pub(crate) ends: [[usize; 2]; 2],
}

impl Edge {
    /// The edge of one of two half-edges; `None` for the other one.
    pub(crate) fn once(facts: &Facts<'_>, half_edge: u32) -> Option<Edge> {
        facts.across_once(half_edge).and_then(|_| Self::at(facts, half_edge))
    }

    pub(crate) fn at(facts: &Facts<'_>, half_edge: u32) -> Option<Edge> {
        let stored = facts.stored?;
        let topology = &facts.topology;
        let across = topology.across(half_edge)?;
        let faces = [half_edge, across].map(|corner| topology.face_of(corner) as usize);
        if !faces.iter().all(|&face| facts.is_sound(face)) {
            return None;
        }
        let ends = [[half_edge, topology.next(across)], [topology.next(half_edge), across]]
            .map(|end| end.map(|corner| corner as usize));
        let gap = |[a, b]: [usize; 2]| {
            let slot = stored.slot(a, facts.vertex(a));
            if slot.is_some() && slot == stored.slot(b, facts.vertex(b)) {
                return facts.stored_unit(a).map(|_| 0.0);
            }
            Some(degrees_between(facts.stored_unit(a)?, facts.stored_unit(b)?))
        };
        let gaps = [gap(ends[0])?, gap(ends[1])?];
        Some(Edge { half_edge, across, faces, gaps, ends })
    }

    /// The edge ahead of a corner, or behind it, and which of its ends is at the corner.
    pub(crate) fn next_to(facts: &Facts<'_>, corner: u32, is_ahead: bool) -> Option<(Edge, usize)> {
        let half_edge = if is_ahead { corner } else { facts.topology.previous(corner) };
        Some((Self::at(facts, half_edge)?, usize::from(!is_ahead)))
    }

    pub(crate) fn is_shared(&self) -> bool {
        self.gaps[0].max(self.gaps[1]) <= SAME
    }

    /// The largest angle in degrees between a normal at the edge and its face.
    pub(crate) fn leaning(&self, facts: &Facts<'_>) -> f64 {
        self.ends.as_flattened().iter().map(|&corner| facts.leaning(corner)).fold(0.0, f64::max)
    }

    /// The dihedral angle, in degrees.
    pub(crate) fn dihedral_angle(&self, facts: &Facts<'_>) -> f64 {
        let [a, b] = self.faces.map(|face| facts.face_normal(face));
        degrees_between(a, b)
    }

    /// Whether both sides have the same normal where the recipe has two, at an end whose fan is not cut by reversed or doubled
    /// faces, and the dihedral angle is larger than an angle.
    pub(crate) fn is_averaged(&self, facts: &Facts<'_>, larger_than: f64) -> bool {
        let is_whole = |corner: usize| facts.is_judged(corner) && !facts.has_two_fans(corner);
        let is_split =
            |&[a, b]: &[usize; 2]| facts.expected(a) != facts.expected(b) && is_whole(a) && is_whole(b);
        self.is_shared() && self.ends.iter().any(is_split) && self.dihedral_angle(facts) > larger_than
    }

    /// Whether it splits the normals of a smooth surface. Not where single corners are outliers or negated: those are findings
    /// of their own.
    pub(crate) fn is_seam(&self, facts: &Facts<'_>) -> bool {
        // An outlier below the threshold is no seam either.
        let limit = facts.thresholds.deviation.0.min(Thresholds::default().deviation.0);
        let is_reported = |&corner: &usize| {
            let Some(unit) = facts.stored_unit(corner) else { return false };
            // Between two seams a face may be alone, with its own normal.
            let is_outlier = || {
                let shares = |is_ahead| {
                    let edge = Self::next_to(facts, corner as u32, is_ahead);
                    edge.is_some_and(|(edge, end)| edge.gaps[end] <= SAME)
                };
                !shares(true) && !shares(false) && Origin::of(facts, corner, unit) != Some(Origin::Run)
            };
            degrees_between(unit, facts.expected(corner)) > limit
                && (facts.leaning(corner) > 90.0 + facts.thresholds.against.0 || is_outlier())
        };
        self.gaps[0].min(self.gaps[1]) > facts.thresholds.seam.0
            && self.is_smooth_by_recipe(facts)
            && !self.ends.as_flattened().iter().any(is_reported)
    }

    /// Whether the edge is split although nothing differs on its two sides.
    pub(crate) fn is_needless(&self, facts: &Facts<'_>) -> bool {
        // Where the recipe has two normals, that there is one is a finding of its own.
        let is_smooth = || self.is_smooth_by_recipe(facts) || self.dihedral_angle(facts) <= SAME;
        if facts.topology.link(self.half_edge) != Link::Welded(self.across)
            || facts.is_cracked(self.half_edge)
            || !is_smooth()
        {
            return false;
        }
        let columns = facts.mesh.columns();
        let is_alike = |&[a, b]: &[usize; 2]| {
            let (u, v) = (facts.vertex(a), facts.vertex(b));
            columns.uvs.as_ref().is_none_or(|uvs| uvs.get(a, u) == uvs.get(b, v))
                && columns.colors.as_ref().is_none_or(|colours| colours[u as usize] == colours[v as usize])
        };
        let [a, b] = self.faces;
        columns.materials.as_ref().is_none_or(|labels| labels.of_face[a] == labels.of_face[b])
            && self.ends.iter().all(is_alike)
    }

    /// Whether the recipe has the same normal on both sides, at both ends.
    fn is_smooth_by_recipe(&self, facts: &Facts<'_>) -> bool {
        self.ends.iter().all(|&[a, b]| facts.expected(a) == facts.expected(b))
    }
}

/// Whether an edge of its face at a corner is averaged and has a dihedral angle larger than this.
pub(crate) fn is_at_averaged(facts: &Facts<'_>, corner: usize, larger_than: f64) -> bool {
    let Some(estimate) = facts.estimate.filter(|_| facts.file.shares_vertices()) else { return false };
    let larger_than = larger_than.max(estimate.sharp_from());
    let edges =
        [true, false].into_iter().filter_map(|is_ahead| Edge::next_to(facts, corner as u32, is_ahead));
    edges.into_iter().any(|(edge, _)| edge.is_averaged(facts, larger_than))
}

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
