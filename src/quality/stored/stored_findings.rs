//! Findings about stored normals, corner by corner.

use crate::mesh::Column;
use crate::num::{Degrees, angle_between};
use crate::quality::catalogue::Kind;
use crate::quality::counts::{Gathered, Gauge, Spot, Tallies, Tally, gather, scan};
use crate::quality::effect::lost_light::{key_light_lost, key_light_scaled};
use crate::quality::estimate::recipe::Estimate;
use crate::quality::estimate::recipe::{LETTER, REPRODUCED, SAME};
use crate::quality::facts::{Facts, Significance};
use crate::quality::finding::Severity;
use crate::quality::geometry::angle_limit::Limit;
use crate::quality::smoothing::equal_normals::{Run, Runs};
use crate::quality::smoothing::facets;
use crate::quality::smoothing::smoothing_findings;
use crate::quality::storage::quantisation;
use crate::quality::storage::quantisation::Precision;
use crate::quality::stored::outliers::{AGAINST, Ground, Waiting};
use crate::quality::stored::rotated;
use crate::quality::thresholds::Thresholds;
use glam::DVec3;

/// From here on, in degrees, a normal counts as the opposite of the right one, and an edge as a fold.
const OPPOSITE: f64 = 135.0;

/// The share of corners against their faces from which on it is all of them.
const ALL: f64 = 0.9;

/// Normals whose direction is a fault.
const FAULTS: [Kind; 3] = [Kind::Flipped, Kind::AgainstFace, Kind::Stray];

/// What strays are told as, once it is known.
const OUTLIERS: [Kind; 2] = [Kind::Stray, Kind::Custom];

/// Everything about the normals that a part has in its file; gives the precision that they were stored with.
pub(in crate::quality) fn find(
    facts: &Facts<'_>,
    thresholds: &Thresholds,
    found: &mut Tallies,
) -> Option<Precision> {
    let Some(stored) = facts.stored else {
        found.add_mesh(Kind::NoNormals, facts.total_area, flattest(facts, thresholds.places));
        return None;
    };
    let deviation = Limit::new(thresholds.deviation.0);
    let runs = Runs::new(facts, thresholds);
    let corners: Corners = gather(facts.mesh.face_count(), thresholds.places, |faces, corners| {
        faces.for_each(|face| look_at((facts, runs.as_ref()), stored, face, deviation, thresholds, corners));
    });
    let judged = Judged::new(facts, &corners);
    found.merge(corners.found);
    let (waiting, apart) = (corners.waiting, corners.apart);
    let is_turned_as_a_whole = rotated::find(facts, thresholds, found);
    if is_turned_as_a_whole {
        // One cause explains them all.
        for kind in AGAINST.into_iter().chain(OUTLIERS) {
            found.take(kind);
        }
    } else if judged.against >= ALL * judged.sound {
        for kind in AGAINST.into_iter().chain(OUTLIERS) {
            found.rename(kind, Kind::Inverted);
        }
        let waiting = waiting.into_tallies().chain(apart.into_tallies());
        waiting.for_each(|tally| found.absorb(Kind::Inverted, tally));
    } else {
        grade_outliers(facts, waiting, found, judged.sound);
        grade_regions(apart, found, thresholds.places);
    }
    like_the_rest(facts, found);
    facets::find(facts, stored, thresholds, found);
    quantisation::find(facts, facts.written.unwrap_or(stored), thresholds, found)
}

/// The corners at which flat normals, as glTF asks for, are furthest from smooth ones.
fn flattest(facts: &Facts<'_>, most: usize) -> Vec<Spot> {
    // By the square of the chord, which is larger where the angle is, and costs less.
    let mut off = scan(facts.mesh.face_count(), most, |faces, found| {
        for face in faces.filter(|&face| facts.worth[face] != Significance::Silent) {
            let normal = facts.face_normal(face);
            for corner in facts.mesh.faces().range(face) {
                let chord = (normal - facts.expected(corner)).length_squared();
                found.add(Kind::NoNormals, Spot::corner(face, corner, chord), 0.0);
            }
        }
    });
    let by_angle = |spot: Spot| {
        let angle =
            angle_between(facts.face_normal(spot.face as usize), facts.expected(spot.corner as usize));
        spot.by(Degrees::from(angle).0)
    };
    let worst = off.take(Kind::NoNormals).worst;
    // A mesh without any direction has a place all the same: everywhere.
    if worst.is_empty() { vec![Spot::mesh().by(0.0)] } else { worst.into_iter().map(by_angle).collect() }
}

/// Single normals are replaced by ones that are made as the rest is, or they would be strays. Where nothing tells how that is,
/// what is computed without being asked for is as good as any.
fn like_the_rest(facts: &Facts<'_>, found: &mut Tallies) {
    let is_usual = |it: &Estimate| it.is_default() && facts.mesh.columns().smoothing.is_none();
    let is_wanted = |it: &Estimate| it.fits_most() && !is_usual(it);
    let Some(estimate) = facts.estimate.filter(is_wanted) else { return };
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
    fn new(facts: &Facts<'_>, corners: &Corners) -> Self {
        let sound = (0..facts.mesh.face_count())
            .filter(|&face| facts.worth[face] == Significance::Sound)
            .map(|face| facts.mesh.faces().range(face).len());
        let against = corners.waiting.against() + corners.apart.against();
        let against = count(&corners.found, AGAINST) + against as f64;
        Self { sound: sound.sum::<usize>() as f64, against }
    }
}

/// How many corners are of some kinds.
fn count(found: &Tallies, kinds: impl IntoIterator<Item = Kind>) -> f64 {
    kinds.into_iter().map(|kind| found.get(kind).count).sum::<u64>() as f64
}

/// What looking at one corner after the other tells.
struct Corners {
    found: Tallies,
    waiting: Waiting,
    /// What waits on pieces of surface that the rule says nothing about.
    apart: Waiting,
}

impl Gathered for Corners {
    fn new(most: usize) -> Self {
        Self { found: Tallies::new(most), waiting: Waiting::new(most), apart: Waiting::new(most) }
    }

    fn merge(&mut self, other: Self) {
        self.found.merge(other.found);
        self.waiting.merge(other.waiting);
        self.apart.merge(other.apart);
    }
}

fn look_at(
    (facts, runs): (&Facts<'_>, Option<&Runs<'_>>),
    stored: &Column<DVec3>,
    face: usize,
    deviation: Limit,
    thresholds: &Thresholds,
    Corners { found, waiting, apart }: &mut Corners,
) {
    let range = facts.mesh.faces().range(face);
    let corners = facts.mesh.faces().corners();
    let area = facts.area[face] / range.len() as f64;
    let is_apart = facts.apart.has(face);
    let waiting = if is_apart { apart } else { waiting };
    for corner in range {
        let spot = Spot::corner(face, corner, 0.0);
        let unlit = || spot.of(Gauge::Steps, key_light_lost());
        let Some(&normal) = stored.get(corner, corners[corner]) else {
            // glTF asks for flat ones there.
            let filled_in = angle_between(facts.face_normal(face), facts.expected(corner));
            found.add(Kind::MissingNormals, spot.by(Degrees::from(filled_in).0), area);
            continue;
        };
        let length = normal.length();
        let off = (length - 1.0).abs();
        if !normal.is_finite() {
            found.add(Kind::NotFinite, unlit(), area);
        } else if length == 0.0 {
            // Nothing right could stand at a corner of a face without direction.
            if facts.worth[face] != Significance::Silent {
                found.add(Kind::ZeroNormals, unlit(), area);
            }
        } else if off > thresholds.length {
            found.add(Kind::NotUnit, spot.of(Gauge::Steps, key_light_scaled(length)), area);
        } else if off > thresholds.strict_length {
            found.add(Kind::LooseLength, spot.of(Gauge::Steps, key_light_scaled(length)), area);
        }
        if facts.worth[face] == Significance::Sound
            && facts.is_judged(corner)
            && let Some(unit) = facts.stored_unit(corner)
            && let Some(off) = deviation.exceeded(unit, facts.expected(corner))
            && let Some(kind) = direction((facts, runs), face, corner, (unit, off), thresholds)
        {
            let spot = spot.by(off);
            match (kind, Ground::of(facts, corner, unit)) {
                (Kind::Stray, Some(_)) if off <= LETTER => found.add(Kind::Custom, spot, area),
                (Kind::Stray, Some(ground)) => waiting.add(ground, spot, area),
                (Kind::Flipped, Some(_)) if !is_apart && is_alone(facts, face, corner) => {
                    found.add(kind, spot, area);
                }
                (Kind::Flipped, Some(_)) if off >= 180.0 - SAME && is_negated(facts, face, corner) => {
                    waiting.add_opposite(spot, area);
                }
                (_, Some(_)) => waiting.add_against(kind, spot, area),
                _ => found.add(kind, spot, area),
            }
        } else if facts.is_near_reoriented(corner)
            && let Some((kind, off)) = near_reoriented((facts, runs), face, corner, deviation, thresholds)
        {
            found.add(kind, spot.by(off), area);
        }
    }
}

/// What is wrong with a normal beside faces that run against their neighbours, or on such a face, and by how many degrees. What
/// they mean there is open, as they are or turned back, and so is which way a normal on them should point: nothing is if either
/// explains it.
fn near_reoriented(
    (facts, runs): (&Facts<'_>, Option<&Runs<'_>>),
    face: usize,
    corner: usize,
    deviation: Limit,
    thresholds: &Thresholds,
) -> Option<(Kind, f64)> {
    let stored = facts.stored_unit(corner)?;
    let expected = facts.expected(corner);
    let is_turned = facts.worth[face] == Significance::Turned;
    let unit = if is_turned && stored.dot(expected) < 0.0 { -stored } else { stored };
    let off = deviation.exceeded(unit, expected)?;
    let kind = direction((facts, runs), face, corner, (unit, off), thresholds)?;
    Ground::near_reoriented(facts, corner, stored, is_turned).is_none().then_some((kind, off))
}

/// Whether at least half of the other normals of a face are on its front.
fn is_alone(facts: &Facts<'_>, face: usize, corner: usize) -> bool {
    let others = || facts.mesh.faces().range(face).filter(|&other| other != corner);
    let is_in_front = |&other: &usize| {
        facts.stored_unit(other).is_some_and(|normal| normal.dot(facts.face_normal(face)) > 0.0)
    };
    2 * others().filter(is_in_front).count() >= others().count()
}

/// Whether at least half of the other normals of a face are on its front, or as good as opposite to the right ones as well. What is
/// the very opposite was negated then, and not reached by leaning further and further back, as at the lower pole of a ball
/// that is lit from above.
fn is_negated(facts: &Facts<'_>, face: usize, corner: usize) -> bool {
    let others = || facts.mesh.faces().range(face).filter(|&other| other != corner);
    let is_opposite = |&other: &usize| {
        facts.stored_unit(other).is_some_and(|normal| {
            normal.dot(facts.face_normal(face)) > 0.0
                || Degrees::from(angle_between(-normal, facts.expected(other))).0 <= REPRODUCED
        })
    };
    2 * others().filter(is_opposite).count() >= others().count()
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
        false if smoothing_findings::is_averaged(facts, corner, 0.0) => None,
        false if runs.is_some_and(|runs| runs.of(corner as u32) != Run::default()) => None,
        // The fan may be another one than that which the normal was made from.
        false if facts.has_two_fans(corner) => None,
        // Or go on beyond the border of the part.
        false if facts.goes_on(corner, normal) => None,
        false => Some(Kind::Stray),
    }
}

/// Whether an edge of a face is a fold with one normal on both sides.
fn is_folded_over(facts: &Facts<'_>, face: usize) -> bool {
    facts.mesh.faces().range(face).any(|corner| smoothing_findings::is_averaged(facts, corner, OPPOSITE))
}

/// Where the fan does not tell, strays are faults if they are most of what a rule leaves unexplained, be it followed closely or
/// to the letter; else the normals are of another making. That edges were marked by hand explains runs of faces, unless nearly
/// all of the mesh follows the rule.
fn grade_outliers(facts: &Facts<'_>, mut waiting: Waiting, found: &mut Tallies, sound: f64) {
    let is_rule = facts.estimate.is_some_and(|estimate| estimate.is_rule());
    let is_departed_from = facts.estimate.is_some_and(|estimate| estimate.is_departed_from());
    let unexplained = (1.0 - facts.estimate.map_or(0.0, |estimate| estimate.reproduced)) * sound;
    let of_rule = unexplained - facts.apart.corners as f64;
    let left = of_rule - count(found, FAULTS) - waiting.against() as f64;
    grade_against(waiting.take_against(), is_departed_from, found);
    let are_most = |grounds: &[Ground]| waiting.count(grounds) as f64 >= 0.5 * left;
    let are_both = is_rule && are_most(&Ground::ALL);
    let is_shared = are_both || (is_departed_from && are_most(&[Ground::Shared]));
    for (tally, is_fault) in waiting.into_tallies().zip([is_shared, are_both]) {
        found.absorb(if is_fault { Kind::Stray } else { Kind::Custom }, tally);
    }
    let faults = count(found, FAULTS);
    let outliers = found.tally(Kind::Stray);
    outliers.remedy = facts.estimate.map(|estimate| estimate.options());
    // To compute all again is no remedy where others were made in another way.
    outliers.may_be_meant = !is_departed_from || faults < 0.5 * unexplained;
}

/// What no rule says anything about may be meant, beside faults of others too.
fn grade_regions(mut apart: Waiting, found: &mut Tallies, most: usize) {
    let mut own = Tallies::new(most);
    grade_against(apart.take_against(), false, &mut own);
    if found.get(Kind::AgainstFace).count > 0 {
        own.rename(Kind::AgainstFace, Kind::Custom);
    }
    apart.into_tallies().for_each(|tally| own.absorb(Kind::Custom, tally));
    // What mends the others would not leave these as they are.
    for kind in AGAINST {
        found.tally(kind).may_be_meant |= own.get(Kind::AgainstFace).count + own.get(Kind::Custom).count > 0;
    }
    found.merge(own);
}

/// Normals that point behind their face and have a ground are faults where a rule made the rest. Else they may be meant, as on
/// leaves that are lit like a ball, and beside ones without a ground, which are faults whatever made the others, they are no
/// more than what no rule derives.
fn grade_against(
    (grounded, opposite): ([Tally; AGAINST.len()], Tally),
    is_departed_from: bool,
    found: &mut Tallies,
) {
    /// The share of turned normals that are the very opposite from which on they were negated: of a fine ball lit from above one
    /// in two thousand is, and one in ten where the rule is off by 3°.
    const NEGATED: f64 = 0.05;
    let are_alone = found.get(Kind::AgainstFace).count == 0;
    let is_much = opposite.count as f64 >= NEGATED * (opposite.count + grounded[0].count) as f64;
    let (negated, leaning) =
        if is_much { (opposite, Tally::default()) } else { (Tally::default(), opposite) };
    found.absorb(Kind::Flipped, negated);
    let all = AGAINST.into_iter().zip(grounded).chain([(Kind::Flipped, leaning)]);
    for (kind, tally) in all {
        // Beside more that are the very opposite, what is nearly so was negated with them.
        let is_negated = kind == Kind::Flipped && found.get(kind).count > tally.count;
        let reported = match (is_departed_from || is_negated, are_alone) {
            (true, _) => kind,
            (false, true) => Kind::AgainstFace,
            (false, false) => Kind::Custom,
        };
        found.absorb(reported, tally);
    }
    if !is_departed_from && are_alone {
        let against = found.tally(Kind::AgainstFace);
        against.severity = Some(Severity::Note);
        against.may_be_meant = true;
    }
}
