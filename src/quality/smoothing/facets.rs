//! Normals that are flat on a shape that bends smoothly, or smooth on one with sharp edges.

use crate::mesh::Column;
use crate::normals::Crease;
use crate::num::{Degrees, angle_between};
use crate::quality::catalogue::Kind;
use crate::quality::counts::{Spot, Tallies, scan};
use crate::quality::estimate::recipe::REPRODUCED;
use crate::quality::facts::{Facts, Significance};
use crate::quality::finding::Severity;
use crate::quality::geometry::angle_limit::Limit;
use crate::quality::geometry::polygons;
use crate::quality::smoothing::smoothing_findings::{Edge, FEWEST_SHARP};
use crate::quality::thresholds::Thresholds;
use glam::DVec3;
use rayon::prelude::*;
use std::ops::Add;

/// Edges that bend by less, in degrees, do not count.
const FLAT: f64 = 1.0;

/// Edges that bend by less are those of a smooth shape.
const GENTLE: f64 = 30.0;

/// Bent edges that a smooth shape has at least.
const FEWEST_GENTLE: usize = 100;

/// The share of bent edges that are gentle on a smooth shape, at least: a horse of 2400 quads has 0.84, a part of a machine
/// 0.79, one with all its holes 0.60.
const MOSTLY_GENTLE: f64 = 0.75;

/// Edges between gentle and sharp ones for each sharp one, at most, where that alone tells a sharp shape: a machined part has
/// 0.05, a gear with bevels 0.29; round shapes, however coarse, have all kinds: the cage of a cow 0.34, a head 0.6, a person
/// 0.8. So have parts with coarse holes and fillets, 0.4 to 0.9, which their broad flats tell.
const BETWEEN: f64 = 0.3;

/// The share of sharp edges with a broad flat at a side on a sharp shape, at least: parts with holes have 0.66 to 1; heads,
/// animals and people 0 to 0.35, furniture with cushions 0.54.
const FLAT_SIDED: f64 = 0.6;

/// The share of sharp edges with one normal on both sides where all are meant to have, of those whose normals nothing else is
/// wrong with.
const ALL: f64 = 0.98;

/// Triangles that a broad flat would have, at least: one side of a coarse tube has two.
const BROAD: usize = 3;

/// Either, as far as the estimate of how the normals were made allows.
pub(in crate::quality) fn find(
    facts: &Facts<'_>,
    stored: &Column<DVec3>,
    thresholds: &Thresholds,
    found: &mut Tallies,
) {
    let Some(estimate) = facts.estimate.filter(|_| facts.shares_vertices) else { return };
    let sharp_from = Crease::DEFAULT_ANGLE.0 + thresholds.crease.0;
    if estimate.crease.0 == 0.0 && estimate.reproduced >= 0.99 {
        if is_gentle(facts) {
            found.add_mesh(Kind::Faceted, facts.total_area, gentle(facts, thresholds.places));
        }
    } else if !estimate.groups && estimate.crease.0 > sharp_from {
        let bends = Bends::of(facts, [GENTLE, sharp_from]);
        let beyond = bends.beyond as f64;
        if bends.beyond < FEWEST_SHARP {
            return;
        }
        let are_few_between = bends.between as f64 <= BETWEEN * beyond;
        let is_flat_sided = || flat_sided(facts, sharp_from) as f64 >= FLAT_SIDED * beyond;
        // The rim of a lens may be a round edge in few faces.
        let may_be_round = are_few_between && is_gentle(facts) && !is_flat_sided();
        if !are_few_between && !is_flat_sided() {
            return;
        }
        let mut soft = softened(facts, stored, sharp_from, thresholds.places);
        let reported = soft.get(Kind::Soft).count as f64;
        // Where some are kept sharp, those that are not are told one by one.
        let kept = kept_sharp(facts, stored, sharp_from, estimate.is_rule()) as f64;
        if reported < 0.5 * beyond || reported < ALL * (reported + kept) {
            return;
        }
        let has_groups = facts.mesh.columns().smoothing.is_some();
        let tally = soft.tally(Kind::Soft);
        let may_be_meant = has_groups || may_be_round || !estimate.is_rule();
        tally.severity = may_be_meant.then_some(Severity::Note);
        tally.remedy = has_groups.then(|| format!("--crease {} --groups ignore", Crease::DEFAULT_ANGLE.0));
        found.merge(soft);
    }
}

/// How many edges bend by an angle between two others, and by more.
#[derive(Clone, Copy, Default)]
struct Bends {
    between: usize,
    beyond: usize,
}

impl Add for Bends {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { between: self.between + other.between, beyond: self.beyond + other.beyond }
    }
}

impl Bends {
    fn of(facts: &Facts<'_>, [low, high]: [f64; 2]) -> Self {
        let bent = Limit::new(low);
        let count = |face: usize| {
            let bends = facts.mesh.faces().range(face).filter_map(|corner| bend(facts, corner as u32, bent));
            bends.fold(Self::default(), |all, bend| {
                let is_beyond = bend > high;
                all + Self { between: usize::from(!is_beyond), beyond: usize::from(is_beyond) }
            })
        };
        (0..facts.mesh.face_count()).into_par_iter().map(count).reduce(Self::default, Self::add)
    }
}

/// Whether most edges that bend at all bend by little, as on a smooth shape.
fn is_gentle(facts: &Facts<'_>) -> bool {
    let bends = Bends::of(facts, [FLAT, GENTLE]);
    let bent = bends.between + bends.beyond;
    bent >= FEWEST_GENTLE && bends.between as f64 >= MOSTLY_GENTLE * bent as f64
}

/// By how many degrees the edge of a half-edge bends, if that is over a limit; told once for both half-edges.
fn bend(facts: &Facts<'_>, half_edge: u32, limit: Limit) -> Option<f64> {
    let across = facts.topology.across(half_edge).filter(|&across| half_edge < across)?;
    let faces = [half_edge, across].map(|corner| facts.topology.face_of(corner) as usize);
    let is_sound = faces.iter().all(|&face| facts.worth[face] == Significance::Sound);
    let [a, b] = faces.map(|face| facts.face_normal(face));
    limit.exceeded(a, b).filter(|_| is_sound)
}

/// The gentle edges that bend most: what their two sides differ by shows.
fn gentle(facts: &Facts<'_>, most: usize) -> Vec<Spot> {
    let bent = Limit::new(FLAT);
    let mut edges = scan(facts.mesh.face_count(), most, |faces, found| {
        for (face, corner) in faces.flat_map(|face| facts.mesh.faces().range(face).map(move |it| (face, it)))
        {
            if let Some(bend) = bend(facts, corner as u32, bent).filter(|&bend| bend <= GENTLE) {
                found.add(Kind::Faceted, Spot::corner(face, corner, bend), 0.0);
            }
        }
    });
    edges.take(Kind::Faceted).worst
}

/// How many sharp edges have a broad flat at a side.
fn flat_sided(facts: &Facts<'_>, sharp_from: f64) -> usize {
    let sharp = Limit::new(sharp_from);
    let has_flat = |half_edge: u32| {
        let sides = [Some(half_edge), facts.topology.across(half_edge)].into_iter().flatten();
        bend(facts, half_edge, sharp).is_some()
            && sides.into_iter().any(|side| is_broad(facts, facts.topology.face_of(side) as usize))
    };
    (0..facts.mesh.faces().corner_count() as u32)
        .into_par_iter()
        .filter(|&half_edge| has_flat(half_edge))
        .count()
}

/// Whether a face makes a broad flat with those that lie in its plane round it.
fn is_broad(facts: &Facts<'_>, face: usize) -> bool {
    let mut flat = vec![face];
    let (mut next, mut triangles) = (0, 0);
    while let Some(&face) = flat.get(next) {
        next += 1;
        if polygons::bow(facts, face) <= FLAT {
            triangles += facts.mesh.faces().range(face).len() - 2;
            if triangles >= BROAD {
                return true;
            }
            let more: Vec<usize> = level_with(facts, face).filter(|other| !flat.contains(other)).collect();
            flat.extend(more);
        }
    }
    false
}

/// The faces across the edges of one that lie in its plane.
fn level_with(facts: &Facts<'_>, face: usize) -> impl Iterator<Item = usize> {
    let bent = Limit::new(FLAT);
    let across = |corner: usize| Some(facts.topology.face_of(facts.topology.across(corner as u32)?) as usize);
    let others = facts.mesh.faces().range(face).filter_map(across);
    others.filter(move |&other| {
        let is_sound = facts.worth[other] == Significance::Sound;
        is_sound && bent.exceeded(facts.face_normal(face), facts.face_normal(other)).is_none()
    })
}

/// How many sharp edges have stored normals on their two sides that differ. Where a rule made them, they have to be what it makes:
/// next to a stray one, or one that is missing, it was not the edge that set them apart.
fn kept_sharp(facts: &Facts<'_>, stored: &Column<DVec3>, sharp_from: f64, is_rule: bool) -> usize {
    let sharp = Limit::new(sharp_from);
    let follows = |&corner: &usize| {
        let pair = facts.stored_and_right(corner);
        pair.is_some_and(|(stored, right)| Degrees::from(angle_between(stored, right)).0 <= REPRODUCED)
    };
    let is_kept = |half_edge: u32| {
        bend(facts, half_edge, sharp).is_some()
            && Edge::at(facts, stored, half_edge).is_some_and(|edge| {
                !edge.is_shared() && (!is_rule || edge.ends.as_flattened().iter().all(follows))
            })
    };
    let edges = (0..facts.mesh.faces().corner_count() as u32).into_par_iter();
    edges.filter(|&half_edge| is_kept(half_edge)).count()
}

/// Sharp edges with one stored normal on both sides.
fn softened(facts: &Facts<'_>, stored: &Column<DVec3>, sharp_from: f64, most: usize) -> Tallies {
    let sharp = Limit::new(sharp_from);
    scan(facts.mesh.face_count(), most, |faces, found| {
        for face in faces {
            for corner in facts.mesh.faces().range(face) {
                if bend(facts, corner as u32, sharp).is_some()
                    && let Some(edge) = Edge::at(facts, stored, corner as u32).filter(Edge::is_shared)
                {
                    found.add(Kind::Soft, Spot::corner(face, corner, edge.leaning(facts)), 0.0);
                }
            }
        }
    })
}
