//! Findings about stored normals, corner by corner.

use super::catalogue::Kind;
use super::facts::{Facts, Worth};
use super::finding::Severity;
use super::limit::Limit;
use super::runs::{Run, Runs};
use super::tally::{Spot, Tallies, scan};
use super::{Estimate, Precision, Thresholds};
use super::{facets, quantisation, smoothing, turned};
use crate::mesh::Column;
use crate::num::{Degrees, angle_between};
use glam::DVec3;

/// From here on, in degrees, a normal counts as the opposite of the right one, and an edge as a fold.
const OPPOSITE: f64 = 135.0;

/// The share of corners against their faces from which on it is all of them.
const ALL: f64 = 0.9;

/// The share of corners up to which strays are exceptions.
pub(super) const FEW: f64 = 0.15;

/// Everything about the normals that a part has in its file; gives the precision that they were stored with.
pub(super) fn find(facts: &Facts<'_>, thresholds: &Thresholds, found: &mut Tallies) -> Option<Precision> {
    let Some(stored) = facts.stored else {
        found.add(Kind::NoNormals, Spot::mesh(), facts.total_area);
        return None;
    };
    let deviation = Limit::new(thresholds.deviation.0);
    let runs = Runs::new(facts, thresholds);
    let corners = scan(facts.mesh.face_count(), thresholds.places, |faces, found| {
        faces.for_each(|face| look_at((facts, runs.as_ref()), stored, face, deviation, thresholds, found));
    });
    let judged = Judged::new(facts, &corners);
    found.merge(corners);
    let is_turned_as_a_whole = turned::find(facts, thresholds, found);
    if is_turned_as_a_whole {
        // One cause explains them all.
        for kind in [Kind::Flipped, Kind::AgainstFace, Kind::Stray] {
            found.take(kind);
        }
    } else if judged.against >= ALL * judged.sound {
        for kind in [Kind::AgainstFace, Kind::Stray, Kind::Flipped] {
            found.rename(kind, Kind::Inverted);
        }
    } else {
        grade_strays(facts, found, judged.sound);
    }
    like_the_rest(facts, found);
    facets::find(facts, stored, thresholds, found);
    quantisation::find(facts, facts.written.unwrap_or(stored), thresholds, found)
}

/// Single normals are replaced by ones that are made as the rest is, or they would be strays.
fn like_the_rest(facts: &Facts<'_>, found: &mut Tallies) {
    let is_usual = |it: &Estimate| it.is_default() && facts.mesh.columns().smoothing.is_none();
    let Some(estimate) = facts.estimate.filter(|estimate| !is_usual(estimate)) else { return };
    for kind in [
        Kind::MissingNormals,
        Kind::NotFinite,
        Kind::ZeroNormals,
        Kind::NotUnit,
        Kind::Flipped,
        Kind::AgainstFace,
    ] {
        let own = kind.entry().remedy.unwrap_or_default();
        found.tally(kind).remedy = Some(format!("{own} {}", estimate.options()));
    }
}

/// How many corners could be told to be against their faces, and how many are.
struct Judged {
    sound: f64,
    against: f64,
}

impl Judged {
    fn new(facts: &Facts<'_>, found: &Tallies) -> Self {
        let corners = (0..facts.mesh.face_count())
            .filter(|&face| facts.worth[face] == Worth::Sound)
            .map(|face| facts.mesh.faces().range(face).len());
        let against = found.get(Kind::Flipped).count + found.get(Kind::AgainstFace).count;
        Self { sound: corners.sum::<usize>() as f64, against: against as f64 }
    }
}

fn look_at(
    (facts, runs): (&Facts<'_>, Option<&Runs<'_>>),
    stored: &Column<DVec3>,
    face: usize,
    deviation: Limit,
    thresholds: &Thresholds,
    found: &mut Tallies,
) {
    let range = facts.mesh.faces().range(face);
    let corners = facts.mesh.faces().corners();
    let area = facts.area[face] / range.len() as f64;
    for corner in range {
        let spot = Spot::corner(face, corner, 0.0);
        let Some(&normal) = stored.get(corner, corners[corner]) else {
            found.add(Kind::MissingNormals, Spot { is_angle: false, ..spot }, area);
            continue;
        };
        let length = normal.length();
        let off = (length - 1.0).abs();
        if !normal.is_finite() {
            found.add(Kind::NotFinite, Spot { is_angle: false, ..spot }, area);
        } else if length == 0.0 {
            // Nothing right could stand at a corner of a face without direction.
            if facts.worth[face] != Worth::Silent {
                found.add(Kind::ZeroNormals, Spot { is_angle: false, ..spot }, area);
            }
        } else if off > thresholds.length {
            found.add(Kind::NotUnit, Spot { weight: off, is_angle: false, ..spot }, area);
        } else if off > thresholds.strict_length {
            found.add(Kind::LooseLength, Spot { weight: off, is_angle: false, ..spot }, area);
        }
        if facts.worth[face] == Worth::Sound
            && facts.is_judged(corner)
            && let Some(unit) = facts.stored_unit(corner)
            && let Some(off) = deviation.exceeded(unit, facts.expected(corner))
            && let Some(kind) = direction((facts, runs), face, corner, (unit, off), thresholds)
        {
            found.add(kind, spot.by(off), area);
        }
    }
}

/// What is wrong with the direction of a normal that is off by so many degrees; `None` if an edge explains it.
fn direction(
    (facts, runs): (&Facts<'_>, Option<&Runs<'_>>),
    face: usize,
    corner: usize,
    (normal, off): (DVec3, f64),
    thresholds: &Thresholds,
) -> Option<Kind> {
    let from_face = Degrees::from(angle_between(normal, facts.face_normal(face))).0;
    match from_face > 90.0 + thresholds.against.0 {
        // Smoothed over a fold, as when a polygon that crosses itself was cut into triangles, it is right for one side.
        true if is_folded_over(facts, face) => None,
        true if off > OPPOSITE => Some(Kind::Flipped),
        true => Some(Kind::AgainstFace),
        // An edge that should be sharp explains its corners, and so does one that should not be.
        false if smoothing::is_averaged(facts, corner, 0.0) => None,
        false if runs.is_some_and(|runs| runs.of(corner as u32) != Run::default()) => None,
        // The fan may be another one than that which the normal was made from.
        false if facts.has_two_fans(corner) => None,
        false => Some(Kind::Stray),
    }
}

/// Whether an edge of a face is a fold with one normal on both sides.
fn is_folded_over(facts: &Facts<'_>, face: usize) -> bool {
    facts.mesh.faces().range(face).any(|corner| smoothing::is_averaged(facts, corner, OPPOSITE))
}

/// Strays are faults where all others follow a rule; where none does, or many follow it loosely, the normals are of another
/// making.
fn grade_strays(facts: &Facts<'_>, found: &mut Tallies, sound: f64) {
    let strays = found.get(Kind::Stray).count as f64;
    let far = [Kind::Stray, Kind::Flipped, Kind::AgainstFace].map(|kind| found.get(kind).count as f64);
    let is_tight = |reproduced: f64| far.iter().sum::<f64>() >= 0.5 * (1.0 - reproduced) * sound;
    match facts.estimate {
        Some(estimate) if estimate.is_rule() && is_tight(estimate.reproduced) && strays <= FEW * sound => {
            found.tally(Kind::Stray).remedy = Some(estimate.options());
        }
        _ => found.rename(Kind::Stray, Kind::Custom),
    }
    if facts.estimate.is_none_or(|estimate| !estimate.is_rule()) {
        let against = found.tally(Kind::AgainstFace);
        against.severity = Some(Severity::Note);
        against.may_be_meant = true;
    }
}
