//! Edges that stored normals smooth or split against their recipe: averaged creases, seams, and edges against smoothing groups.

use crate::mesh::DisjointSets;
use crate::normals::Crease;
use crate::num::parallel;
use crate::quality::findings::prelude::*;
use crate::quality::findings::smoothing::edge::Edge;

/// The share of edges that the crease angle has to put on the right side before the others are faults.
const RULE: f64 = 0.98;

/// Sharp edges that a shape has at least if it has any: a cube has twelve. Fewer may be bad faces of a smooth one.
pub(crate) const FEWEST_SHARP: usize = 8;

/// The largest ratio of the median dihedral angle of split edges to the upper quartile of smooth ones at which the split edges are
/// a cut: cuts through balls, tori and teapots, coarse and fine, have 1.02 at most; marked edges of lanterns, spiders and pirates
/// 1.6 at least.
const CUT: f64 = 1.25;

pub(crate) fn search(facts: &Facts<'_>, found: &mut Found) {
    if facts.stored.is_none() {
        return search_cracks(facts, found);
    }
    // Facets have one normal each.
    let Some(estimate) = facts.estimate.filter(|_| facts.file.shares_vertices()) else { return };
    let averaged_from = estimate.sharp_from() + facts.thresholds.crease.0;
    let mut edges = facts.scan_corners(|_, corner, found| {
        if let Some(edge) = Edge::once(facts, corner as u32) {
            check(facts, &edge, averaged_from, found);
        }
    });
    let follows = estimate.is_departed_from() && estimate.separated >= RULE;
    // Computing all normals leaves the others unchanged only if these follow a recipe. So high an angle smooths other sharp edges.
    let is_soft = !estimate.groups && estimate.crease.0 > Crease::DEFAULT_ANGLE.0 + facts.thresholds.crease.0;
    let restores = estimate.is_rule() || (estimate.is_departed_from() && !is_soft);
    for finding in [Kind::AveragedCrease, Kind::SplitSeam, Kind::CrackedSeam] {
        let is_crease = finding == Kind::AveragedCrease;
        let count = edges.count(finding);
        let is_certain = || {
            let is_few = is_crease && count < FEWEST_SHARP as u64;
            (follows || (estimate.is_departed_from() && !is_crease && is_cut(facts)))
                && (!is_few || has_sharp_edges(facts))
        };
        let severity = (count > 0 && !is_certain()).then_some(Severity::Note);
        let tally = edges.tally(finding);
        tally.remedy = Some(estimate.options(facts.mesh.columns().smoothing.is_some()));
        tally.may_be_meant = !restores;
        tally.severity = severity;
    }
    if edges.count(Kind::NeedlessSeam) > 0 {
        edges.tally(Kind::NeedlessSeam).sum = mergeable_vertices(facts);
    }
    found.merge(edges);
}

fn check(facts: &Facts<'_>, edge: &Edge, averaged_from: f64, found: &mut Found) {
    let spot = Spot::corner(edge.faces[0], edge.half_edge as usize, 0.0);
    let [low, high] = [edge.gaps[0].min(edge.gaps[1]), edge.gaps[0].max(edge.gaps[1])];
    let groups = facts.mesh.columns().smoothing.as_ref();
    let groups = groups.map(|groups| edge.faces.map(|face| groups.of_face[face]));
    // Two groups meet where the surface was meant to be sharp.
    let is_border = groups.is_some_and(|[a, b]| a != b && a != 0 && b != 0);
    if edge.is_averaged(facts, averaged_from) {
        found.add(Kind::AveragedCrease, spot.by(edge.leaning(facts)), 0.0);
    } else if low > facts.thresholds.seam.0 && !is_border && edge.is_seam(facts) {
        let is_cracked = facts.is_cracked(edge.half_edge);
        found.add(if is_cracked { Kind::CrackedSeam } else { Kind::SplitSeam }, spot.by(high), 0.0);
    } else if high == 0.0 && edge.is_needless(facts) {
        found.add(Kind::NeedlessSeam, spot, 0.0);
    }
    if let Some([a, b]) = groups {
        let is_smooth = a == b && a != 0;
        // A flat edge looks the same either way.
        let is_mismatch = match is_smooth {
            true => low > facts.thresholds.seam.0,
            false => high <= SAME && edge.dihedral_angle(facts) > SAME,
        };
        if is_mismatch {
            found.add(Kind::GroupMismatch, spot.by(edge.dihedral_angle(facts)), 0.0);
        }
    }
}

/// Finds edges that computed normals will split because the edges of the two faces only nearly coincide.
fn search_cracks(facts: &Facts<'_>, found: &mut Found) {
    if !facts.has_near_edges {
        return;
    }
    let topology = &facts.topology;
    for half_edge in (0..facts.mesh.faces().corner_count() as u32).filter(|&it| facts.is_cracked(it)) {
        let Some(across) = facts.across_once(half_edge) else { continue };
        let ends = [[half_edge, topology.next(across)], [topology.next(half_edge), across]];
        let normals = ends.map(|end| end.map(|corner| facts.expected(corner as usize)));
        if normals.iter().all(|[a, b]| a == b) {
            let faces = [half_edge, across].map(|corner| topology.face_of(corner) as usize);
            let angle = degrees_between(facts.face_normal(faces[0]), facts.face_normal(faces[1]));
            found.add(Kind::CrackedSeam, Spot::corner(faces[0], half_edge as usize, angle), 0.0);
        }
    }
    found.tally(Kind::CrackedSeam).severity = Some(Severity::Note);
}

/// Whether normals differ on the two sides of any edge that is not flat.
fn has_sharp_edges(facts: &Facts<'_>) -> bool {
    let is_sharp = |edge: Edge| !edge.is_shared() && edge.dihedral_angle(facts) > SAME;
    let is_found = |half_edge: usize| Edge::once(facts, half_edge as u32).is_some_and(is_sharp);
    parallel::ranges(facts.mesh.faces().corner_count(), |mut range| range.any(is_found)).contains(&true)
}

/// Whether edges that split normals have no larger dihedral angles than those that do not: a cut through a smooth surface goes
/// anywhere, while edges are marked as sharp where a surface bends.
fn is_cut(facts: &Facts<'_>) -> bool {
    let angles = |is_wanted: fn(&Facts<'_>, &Edge) -> bool| {
        let angle = |half_edge: usize| {
            let edge = Edge::once(facts, half_edge as u32).filter(|edge| is_wanted(facts, edge))?;
            Some(edge.dihedral_angle(facts)).filter(|&angle| angle > SAME)
        };
        let mut angles = parallel::filter_map(facts.mesh.faces().corner_count(), angle);
        angles.sort_unstable_by(f64::total_cmp);
        angles
    };
    let smooth = angles(|_, edge| edge.is_shared());
    let split = angles(|facts, edge| edge.gaps[0].min(edge.gaps[1]) > facts.thresholds.seam.0);
    let [upper, median] = [smooth.get(smooth.len() * 3 / 4), split.get(split.len() / 2)];
    upper.zip(median).is_some_and(|(upper, median)| *median <= CUT * upper)
}

/// How many vertices fewer there would be without needless seams.
fn mergeable_vertices(facts: &Facts<'_>) -> u64 {
    let mut sets = DisjointSets::new(facts.mesh.vertex_count());
    let edges = (0..facts.mesh.faces().corner_count() as u32).filter_map(|it| Edge::once(facts, it));
    for edge in edges.filter(|edge| edge.gaps == [0.0; 2] && edge.is_needless(facts)) {
        edge.ends.iter().for_each(|&[a, b]| sets.union(facts.vertex(a), facts.vertex(b)));
    }
    (0..facts.mesh.vertex_count() as u32).filter(|&vertex| sets.find(vertex) != vertex).count() as u64
}
