//! Normals against the shape: flat ones on a smooth shape, and smooth ones on a shape with sharp edges.

use crate::normals::Crease;
use crate::num::parallel;
use crate::quality::estimate::recipe::REPRODUCED;
use crate::quality::findings::geometry::face_shape::bow;
use crate::quality::findings::prelude::*;
use crate::quality::findings::smoothing::edge::Edge;
use crate::quality::findings::smoothing::seams::FEWEST_SHARP;

/// Edges of a smaller dihedral angle, in degrees, do not count.
const FLAT: f64 = 1.0;

/// Edges of a smaller dihedral angle, in degrees, are those of a smooth shape.
const GENTLE: f64 = 30.0;

/// The fewest edges above [`FLAT`] that a smooth shape has.
const FEWEST: usize = 100;

/// The smallest share of these that are gentle on a smooth shape: a horse of 2400 quads has 0.84, a machine part 0.79, one with
/// all its holes 0.60.
const MOSTLY_GENTLE: f64 = 0.75;

/// Finds flat normals on a smooth shape.
pub(crate) fn search_facets(facts: &Facts<'_>, found: &mut Found) {
    let Some(estimate) = facts.estimate.filter(|_| facts.file.shares_vertices()) else { return };
    if estimate.crease.0 == 0.0 && estimate.reproduced >= 0.99 && is_gentle(facts) {
        let flat = Limit::new(FLAT);
        // The largest angles: that between the normals of the two sides.
        let mut gentle = facts.scan_corners(|face, corner, found| {
            if let Some(angle) = angle_over(facts, corner as u32, flat).filter(|&it| it <= GENTLE) {
                found.add((), Spot::corner(face, corner, angle), 0.0);
            }
        });
        found.add_mesh(Kind::Faceted, facts.total_area, gentle.take(()).worst);
    }
}

/// The dihedral angle of an edge between sound faces, in degrees, if it is over a limit; `None` for the second half-edge.
fn angle_over(facts: &Facts<'_>, half_edge: u32, limit: Limit) -> Option<f64> {
    let across = facts.across_once(half_edge)?;
    let [a, b] = [half_edge, across].map(|corner| facts.topology.face_of(corner) as usize);
    let angle = limit.exceeded(facts.face_normal(a), facts.face_normal(b))?;
    (facts.is_sound(a) && facts.is_sound(b)).then_some(angle)
}

/// How many edges have a dihedral angle between two others, in degrees, and how many a larger one.
fn count_edges(facts: &Facts<'_>, [low, high]: [f64; 2]) -> [usize; 2] {
    let limit = Limit::new(low);
    let angle = |half_edge: usize| angle_over(facts, half_edge as u32, limit);
    let angles = parallel::filter_map(facts.mesh.faces().corner_count(), angle);
    let larger = angles.iter().filter(|&&angle| angle > high).count();
    [angles.len() - larger, larger]
}

/// Whether most edges that are not flat have small dihedral angles, as on a smooth shape.
fn is_gentle(facts: &Facts<'_>) -> bool {
    let [gentle, others] = count_edges(facts, [FLAT, GENTLE]);
    let all = gentle + others;
    all >= FEWEST && gentle as f64 >= MOSTLY_GENTLE * all as f64
}

/// The largest number of edges between gentle and sharp ones for each sharp one on a sharp shape: a machined part has 0.05, a gear
/// with bevels 0.29. Round shapes, however coarse, have edges of all angles: the cage of a cow 0.34, a head 0.6, a person 0.8. So
/// have parts with coarse holes and fillets, 0.4 to 0.9, but these have broad flats.
const BETWEEN: f64 = 0.3;

/// The smallest share of sharp edges next to a broad flat on a sharp shape: parts with holes have 0.66 to 1; heads, animals and
/// people 0 to 0.35, furniture with cushions 0.54.
const FLAT_SIDED: f64 = 0.6;

/// The smallest share of sharp edges with the same normal on both sides, of those whose normals have no other fault.
const ALL: f64 = 0.98;

/// The fewest triangles of a broad flat: one side of a coarse tube has two.
const BROAD: usize = 3;

pub(crate) fn search_soft(facts: &Facts<'_>, found: &mut Found) {
    let Some(estimate) = facts.estimate.filter(|_| facts.file.shares_vertices()) else { return };
    let sharp_from = Crease::DEFAULT_ANGLE.0 + facts.thresholds.crease.0;
    if estimate.groups || estimate.crease.0 <= sharp_from {
        return;
    }
    let [between, sharp] = count_edges(facts, [GENTLE, sharp_from]);
    if sharp < FEWEST_SHARP {
        return;
    }
    let are_few_between = between as f64 <= BETWEEN * sharp as f64;
    let is_flat_sided = || count_flat_sided(facts, sharp_from) as f64 >= FLAT_SIDED * sharp as f64;
    // The rim of a lens may be a round edge of few faces.
    let may_be_round = are_few_between && is_gentle(facts) && !is_flat_sided();
    if !are_few_between && !is_flat_sided() {
        return;
    }
    let mut soft = smooth_sharp_edges(facts, sharp_from);
    let count = soft.count(Kind::Soft) as f64;
    // If some edges are kept sharp, those that are not are findings of their own.
    let kept = count_kept_sharp(facts, sharp_from, estimate.is_rule()) as f64;
    if count >= 0.5 * sharp as f64 && count >= ALL * (count + kept) {
        let has_groups = facts.mesh.columns().smoothing.is_some();
        let tally = soft.tally(Kind::Soft);
        let may_be_meant = has_groups || may_be_round || !estimate.is_rule();
        tally.severity = may_be_meant.then_some(Severity::Note);
        tally.remedy = has_groups.then(|| format!("--crease {} --groups ignore", Crease::DEFAULT_ANGLE.0));
        found.merge(soft);
    }
}

/// How many sharp edges have a broad flat on a side.
fn count_flat_sided(facts: &Facts<'_>, sharp_from: f64) -> usize {
    let sharp = Limit::new(sharp_from);
    let has_flat = |half_edge: u32| {
        let sides = [Some(half_edge), facts.topology.across(half_edge)];
        angle_over(facts, half_edge, sharp).is_some()
            && sides.into_iter().flatten().any(|side| is_broad(facts, facts.face_of(side as usize)))
    };
    parallel::count(facts.mesh.faces().corner_count(), has_flat)
}

fn is_broad(facts: &Facts<'_>, face: usize) -> bool {
    let limit = Limit::new(FLAT);
    let mut flat = vec![face];
    let (mut next, mut triangles) = (0, 0);
    while let Some(&face) = flat.get(next) {
        next += 1;
        if bow(facts, face) > FLAT {
            continue;
        }
        triangles += facts.corners_of(face).len() - 2;
        if triangles >= BROAD {
            return true;
        }
        let across = facts.corners_of(face).filter_map(|corner| facts.topology.across(corner as u32));
        let others = across.map(|across| facts.topology.face_of(across) as usize);
        let is_level =
            |other: usize| limit.exceeded(facts.face_normal(face), facts.face_normal(other)).is_none();
        let is_new = |&it: &usize| facts.is_sound(it) && is_level(it) && !flat.contains(&it);
        let level: Vec<usize> = others.filter(is_new).collect();
        flat.extend(level);
    }
    false
}

/// How many sharp edges have different normals on their two sides. If a recipe made them, they have to be the expected ones: next
/// to an outlier or a missing normal, the reason is not the edge.
fn count_kept_sharp(facts: &Facts<'_>, sharp_from: f64, is_rule: bool) -> usize {
    let sharp = Limit::new(sharp_from);
    let follows = |&corner: &usize| {
        let pair = facts.stored_and_expected(corner);
        pair.is_some_and(|(stored, expected)| degrees_between(stored, expected) <= REPRODUCED)
    };
    let is_kept =
        |edge: &Edge| !edge.is_shared() && (!is_rule || edge.ends.as_flattened().iter().all(follows));
    parallel::count(facts.mesh.faces().corner_count(), |half_edge| {
        angle_over(facts, half_edge, sharp).is_some()
            && Edge::once(facts, half_edge).is_some_and(|edge| is_kept(&edge))
    })
}

/// Sharp edges with the same stored normal on both sides.
fn smooth_sharp_edges(facts: &Facts<'_>, sharp_from: f64) -> Found {
    let sharp = Limit::new(sharp_from);
    facts.scan_corners(|face, corner, found| {
        if angle_over(facts, corner as u32, sharp).is_some()
            && let Some(edge) = Edge::once(facts, corner as u32).filter(Edge::is_shared)
        {
            found.add(Kind::Soft, Spot::corner(face, corner, edge.leaning(facts)), 0.0);
        }
    })
}
