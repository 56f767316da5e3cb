//! Findings about edges: what stored normals do across them, against how far they bend.

use crate::mesh::{Column, DisjointSets, Link, SmoothingGroups};
use crate::normals::Crease;
use crate::num::{Degrees, angle_between};
use crate::quality::catalogue::Kind;
use crate::quality::counts::{Spot, Tallies, scan};
use crate::quality::facts::{Facts, Significance};
use crate::quality::finding::Severity;
use crate::quality::stored::outliers::Ground;
use crate::quality::thresholds::Thresholds;
use glam::DVec3;
use rayon::prelude::*;

/// Two stored normals closer than this, in degrees, are one as far as pictures go.
pub(in crate::quality) const SAME: f64 = 1.0;

/// The share of bent edges that the estimated crease angle has to put on the right side before the others are faults.
const RULE: f64 = 0.98;

/// Sharp edges that a shape has at least that has any: a cube has twelve. Fewer may be faces that came out badly on a smooth one.
pub(in crate::quality) const FEWEST_SHARP: usize = 8;

/// Everything about which edges stored normals are smooth over.
pub(in crate::quality) fn find(facts: &Facts<'_>, thresholds: &Thresholds, found: &mut Tallies) {
    if facts.stored.is_none() {
        return cracks(facts, found);
    }
    let (Some(stored), Some(estimate)) = (facts.stored, facts.estimate) else { return };
    // Facets have one normal each.
    if !facts.shares_vertices {
        return;
    }
    let groups = facts.mesh.columns().smoothing.as_ref();
    let crease = estimate.sharp_from();
    let mut edges = scan(facts.mesh.face_count(), thresholds.places, |faces, found| {
        for face in faces {
            for half_edge in facts.mesh.faces().range(face) {
                if let Some(edge) = Edge::at(facts, stored, half_edge as u32) {
                    edge.judge(facts, stored, crease, groups, thresholds, found);
                }
            }
        }
    });
    let follows = estimate.is_departed_from() && estimate.separated >= RULE;
    // Computing all again leaves the rest as it is only where that is of a rule; so high an angle rounds what else is sharp.
    let is_soft = !estimate.groups && estimate.crease.0 > Crease::DEFAULT_ANGLE.0 + thresholds.crease.0;
    let restores = estimate.is_rule() || (estimate.is_departed_from() && !is_soft);
    for kind in [Kind::AveragedCrease, Kind::SplitSeam, Kind::CrackedSeam] {
        let is_any_seam = || kind != Kind::AveragedCrease && are_anywhere(facts, stored, thresholds);
        let count = edges.get(kind).count;
        let is_lone =
            || kind == Kind::AveragedCrease && count < FEWEST_SHARP as u64 && !are_any_sharp(facts, stored);
        let is_meant = count > 0 && (!(follows || estimate.is_departed_from() && is_any_seam()) || is_lone());
        let tally = edges.tally(kind);
        tally.remedy = Some(estimate.options());
        tally.may_be_meant = !restores;
        if is_meant {
            tally.severity = Some(Severity::Note);
        }
    }
    if edges.get(Kind::NeedlessSeam).count > 0 {
        edges.tally(Kind::NeedlessSeam).mergeable = mergeable(facts, stored);
    }
    found.merge(edges);
}

/// Edges that computing normals will split because they only nearly coincide.
fn cracks(facts: &Facts<'_>, found: &mut Tallies) {
    if facts.near.is_none() {
        return;
    }
    for half_edge in (0..facts.mesh.faces().corner_count() as u32).filter(|&it| facts.is_cracked(it)) {
        let topology = &facts.topology;
        let Some(across) = topology.across(half_edge).filter(|&across| half_edge < across) else { continue };
        let goes_on = [[half_edge, topology.next(across)], [topology.next(half_edge), across]]
            .map(|ends| ends.map(|corner| facts.expected(corner as usize)))
            .iter()
            .all(|[a, b]| a == b);
        if goes_on {
            let faces = [half_edge, across].map(|it| topology.face_of(it) as usize);
            let bend = degrees(facts.face_normal(faces[0]), facts.face_normal(faces[1]));
            found.add(Kind::CrackedSeam, Spot::corner(faces[0], half_edge as usize, bend), 0.0);
        }
    }
    found.tally(Kind::CrackedSeam).severity = Some(Severity::Note);
}

/// Whether normals are kept apart on the two sides of any edge that bends.
fn are_any_sharp(facts: &Facts<'_>, stored: &Column<DVec3>) -> bool {
    let is_sharp = |edge: Edge| edge.gaps[0].max(edge.gaps[1]) > SAME && edge.bend(facts) > SAME;
    let edges = (0..facts.mesh.faces().corner_count() as u32).into_par_iter();
    edges.any(|half_edge| Edge::at(facts, stored, half_edge).is_some_and(is_sharp))
}

/// Whether edges that split normals bend no more than those that do not: a cut through a smooth surface goes where it may, while
/// edges that were marked as sharp by hand are where a surface bends.
fn are_anywhere(facts: &Facts<'_>, stored: &Column<DVec3>, thresholds: &Thresholds) -> bool {
    /// How much further than three in four of the smooth edges the middle one of the split edges may bend: cuts through balls,
    /// tori and teapots, coarse and fine, have 1.02 at most; marked edges of lanterns, spiders and pirates 1.6 at least.
    const FURTHER: f64 = 1.25;
    let edges = (0..facts.mesh.faces().corner_count() as u32).into_par_iter();
    let edges = edges.filter_map(|half_edge| Edge::at(facts, stored, half_edge));
    let bends = edges.map(|edge| (edge.bend(facts), edge.is_shared(), edge.gaps[0].min(edge.gaps[1])));
    let bends: Vec<_> = bends.filter(|&(bend, ..)| bend > SAME).collect();
    let ascending = |is: &dyn Fn(bool, f64) -> bool| {
        let wanted = bends.iter().filter(|&&(_, is_shared, gap)| is(is_shared, gap));
        let mut wanted: Vec<f64> = wanted.map(|&(bend, ..)| bend).collect();
        wanted.sort_unstable_by(f64::total_cmp);
        wanted
    };
    let smooth = ascending(&|is_shared, _| is_shared);
    let split = ascending(&|_, gap| gap > thresholds.seam.0);
    let [upper, middle] = [smooth.get(smooth.len() * 3 / 4), split.get(split.len() / 2)];
    upper.zip(middle).is_some_and(|(upper, middle)| *middle <= FURTHER * upper)
}

/// How many vertices fewer there would be without needless seams.
fn mergeable(facts: &Facts<'_>, stored: &Column<DVec3>) -> usize {
    let corners = facts.mesh.faces().corners();
    let mut sets = DisjointSets::new(facts.mesh.vertex_count());
    let edges = (0..corners.len() as u32).filter_map(|half_edge| Edge::at(facts, stored, half_edge));
    let needless = edges.filter(|edge| edge.gaps == [0.0; 2] && edge.is_needless(facts));
    let pairs = needless.flat_map(|edge| edge.ends).map(|[a, b]| [corners[a], corners[b]]);
    pairs.for_each(|[a, b]| sets.union(a, b));
    (0..facts.mesh.vertex_count() as u32).filter(|&vertex| sets.find(vertex) != vertex).count()
}

/// Whether one of the two edges of its face at a corner bends by more than this and has one normal on both sides, where the
/// rule of the mesh has two.
pub(in crate::quality) fn is_averaged(facts: &Facts<'_>, corner: usize, from: f64) -> bool {
    let (Some(stored), Some(estimate)) = (facts.stored, facts.estimate) else { return false };
    let from = from.max(estimate.sharp_from());
    let edges = WAYS.into_iter().filter_map(|way| way.edge(facts, stored, corner as u32));
    facts.shares_vertices && edges.into_iter().any(|(edge, _)| edge.is_averaged(facts, from))
}

/// A way round a vertex.
#[derive(Clone, Copy)]
pub(in crate::quality) enum Way {
    /// Over the edge that leaves a corner.
    Forward,
    /// Over the edge that comes in to it.
    Back,
}

pub(in crate::quality) const WAYS: [Way; 2] = [Way::Forward, Way::Back];

impl Way {
    /// The next edge from a corner, and which of its ends the vertex is.
    fn edge(self, facts: &Facts<'_>, stored: &Column<DVec3>, corner: u32) -> Option<(Edge, usize)> {
        match self {
            Way::Forward => Some((Edge::either_way(facts, stored, corner)?, 0)),
            Way::Back => Some((Edge::either_way(facts, stored, facts.topology.previous(corner))?, 1)),
        }
    }

    /// The edges from a corner on, up to a rim; without end where there is none.
    pub(in crate::quality) fn edges<'a>(
        self,
        facts: &'a Facts<'_>,
        stored: &'a Column<DVec3>,
        corner: u32,
    ) -> impl Iterator<Item = (Edge, usize)> {
        let mut at = corner;
        std::iter::from_fn(move || {
            let (edge, end) = self.edge(facts, stored, at)?;
            at = edge.ends[end][1] as u32;
            Some((edge, end))
        })
    }

    /// Whether a corner has one normal with the one beyond that edge.
    fn shares(self, facts: &Facts<'_>, stored: &Column<DVec3>, corner: u32) -> bool {
        self.edge(facts, stored, corner).is_some_and(|(edge, end)| edge.gaps[end] <= SAME)
    }
}

/// The angle between two directions, in degrees.
fn degrees(a: DVec3, b: DVec3) -> f64 {
    Degrees::from(angle_between(a, b)).0
}

/// An edge between two sound faces, with the stored normals on both sides at both ends.
pub(in crate::quality) struct Edge {
    half_edge: u32,
    across: u32,
    faces: [usize; 2],
    /// How far the stored normals of the two sides are apart at each end, in degrees.
    pub(in crate::quality) gaps: [f64; 2],
    /// Corners of the two faces at each end.
    pub(in crate::quality) ends: [[usize; 2]; 2],
}

impl Edge {
    /// The edge of a half-edge, told once for both.
    pub(in crate::quality) fn at(facts: &Facts<'_>, stored: &Column<DVec3>, half_edge: u32) -> Option<Edge> {
        let is_first = facts.topology.across(half_edge).is_some_and(|across| half_edge < across);
        if is_first { Self::either_way(facts, stored, half_edge) } else { None }
    }

    /// The edge of a half-edge.
    fn either_way(facts: &Facts<'_>, stored: &Column<DVec3>, half_edge: u32) -> Option<Edge> {
        let across = facts.topology.across(half_edge)?;
        let faces = [half_edge, across].map(|corner| facts.topology.face_of(corner) as usize);
        if faces.iter().any(|&face| facts.worth[face] != Significance::Sound) {
            return None;
        }
        let ends = [
            [half_edge, facts.topology.next(across)].map(|corner| corner as usize),
            [facts.topology.next(half_edge), across].map(|corner| corner as usize),
        ];
        let corners = facts.mesh.faces().corners();
        let gap = |[a, b]: [usize; 2]| {
            if stored.slot(a, corners[a]).is_some_and(|slot| Some(slot) == stored.slot(b, corners[b])) {
                return facts.stored_unit(a).map(|_| 0.0);
            }
            Some(degrees(facts.stored_unit(a)?, facts.stored_unit(b)?))
        };
        let gaps = [gap(ends[0])?, gap(ends[1])?];
        Some(Edge { half_edge, across, faces, gaps, ends })
    }

    /// Whether its two sides have one normal, at both ends.
    pub(in crate::quality) fn is_shared(&self) -> bool {
        self.gaps[0].max(self.gaps[1]) <= SAME
    }

    /// How far the normals at it are from their faces, at most.
    pub(in crate::quality) fn leaning(&self, facts: &Facts<'_>) -> f64 {
        self.ends.as_flattened().iter().map(|&corner| facts.leaning(corner)).fold(0.0, f64::max)
    }

    /// How far it bends, in degrees.
    fn bend(&self, facts: &Facts<'_>) -> f64 {
        let [a, b] = self.faces.map(|face| facts.face_normal(face));
        degrees(a, b)
    }

    fn judge(
        &self,
        facts: &Facts<'_>,
        stored: &Column<DVec3>,
        crease: f64,
        groups: Option<&SmoothingGroups>,
        thresholds: &Thresholds,
        found: &mut Tallies,
    ) {
        let spot = Spot::corner(self.faces[0], self.half_edge as usize, 0.0);
        let [low, high] = [self.gaps[0].min(self.gaps[1]), self.gaps[0].max(self.gaps[1])];
        let of_groups = groups.map(|groups| self.faces.map(|face| groups.of_face[face]));
        // Two groups meet where the surface was meant to be sharp.
        let is_border = of_groups.is_some_and(|[a, b]| a != b && a != 0 && b != 0);
        if self.is_averaged(facts, crease + thresholds.crease.0) {
            found.add(Kind::AveragedCrease, spot.by(self.leaning(facts)), 0.0);
        } else if low > thresholds.seam.0 && !is_border && self.is_seam(facts, stored, thresholds) {
            let is_cracked = facts.is_cracked(self.half_edge);
            found.add(if is_cracked { Kind::CrackedSeam } else { Kind::SplitSeam }, spot.by(high), 0.0);
        } else if high == 0.0 && facts.shares_vertices && self.is_needless(facts) {
            found.add(Kind::NeedlessSeam, spot, 0.0);
        }
        if let Some([a, b]) = of_groups {
            let meant_smooth = a == b && a != 0;
            // A flat edge looks the same either way.
            if (meant_smooth && low > thresholds.seam.0)
                || (!meant_smooth && high <= SAME && self.bend(facts) > SAME)
            {
                found.add(Kind::GroupMismatch, spot.by(self.bend(facts)), 0.0);
            }
        }
    }

    /// Whether it splits the normals of a surface that goes on: not where single corners stray or are turned round, which is
    /// told as that.
    pub(in crate::quality) fn is_seam(
        &self,
        facts: &Facts<'_>,
        stored: &Column<DVec3>,
        thresholds: &Thresholds,
    ) -> bool {
        // A stray that is not asked for is no seam either.
        let told_from = thresholds.deviation.0.min(Thresholds::default().deviation.0);
        let is_reported = |&corner: &usize| {
            let Some(unit) = facts.stored_unit(corner) else { return false };
            // Between two seams a face may stand alone, with its own normal.
            let outliers = || {
                !WAYS.into_iter().any(|way| way.shares(facts, stored, corner as u32))
                    && Ground::of(facts, corner, unit) != Some(Ground::Run)
            };
            degrees(unit, facts.expected(corner)) > told_from
                && (facts.leaning(corner) > 90.0 + thresholds.against.0 || outliers())
        };
        self.gaps[0].min(self.gaps[1]) > thresholds.seam.0
            && self.goes_on(facts)
            && !self.ends.as_flattened().iter().any(is_reported)
    }

    /// Whether both sides have one normal where the rule of the mesh has two, at an end where faces that run against the others
    /// or stand twice do not cut the fan.
    pub(in crate::quality) fn is_averaged(&self, facts: &Facts<'_>, from: f64) -> bool {
        let is_split = |&[a, b]: &[usize; 2]| {
            let is_whole = |corner: usize| facts.is_judged(corner) && !facts.has_two_fans(corner);
            facts.expected(a) != facts.expected(b) && is_whole(a) && is_whole(b)
        };
        self.is_shared() && self.ends.iter().any(is_split) && self.bend(facts) > from
    }

    /// Whether the recipe that fits best has one normal on both sides, at both ends.
    fn goes_on(&self, facts: &Facts<'_>) -> bool {
        self.ends.iter().all(|&[a, b]| facts.expected(a) == facts.expected(b))
    }

    /// Whether the edge is cut although nothing differs on its two sides.
    fn is_needless(&self, facts: &Facts<'_>) -> bool {
        // Where the rule has two normals, that there is one is told, or passes.
        let is_smooth = || self.goes_on(facts) || self.bend(facts) <= SAME;
        if facts.topology.link(self.half_edge) != Link::Welded(self.across)
            || facts.is_cracked(self.half_edge)
            || !is_smooth()
        {
            return false;
        }
        let columns = facts.mesh.columns();
        let corners = facts.mesh.faces().corners();
        let alike = |a: usize, b: usize| {
            let (u, v) = (corners[a], corners[b]);
            columns.uvs.as_ref().is_none_or(|uvs| uvs.get(a, u) == uvs.get(b, v))
                && columns.colors.as_ref().is_none_or(|colours| colours[u as usize] == colours[v as usize])
        };
        let material = columns
            .materials
            .as_ref()
            .is_none_or(|it| it.of_face[self.faces[0]] == it.of_face[self.faces[1]]);
        material && self.ends.iter().all(|&[a, b]| alike(a, b))
    }
}

impl Facts<'_> {
    /// How far the normal that a corner is shaded with is from its face, in degrees.
    pub(in crate::quality) fn leaning(&self, corner: usize) -> f64 {
        let face = self.topology.face_of(corner as u32) as usize;
        degrees(self.shaded(corner), self.face_normal(face))
    }
}
