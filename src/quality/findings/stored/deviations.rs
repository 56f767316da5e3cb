//! Normals that deviate from the recipe of the mesh: negated, against their face, outliers, or authored.

use crate::quality::estimate::recipe::{EXACT, REPRODUCED};
use crate::quality::findings::prelude::*;
use crate::quality::findings::smoothing::edge::is_at_averaged;
use crate::quality::findings::smoothing::edge::{Run, Runs};
use crate::quality::findings::stored::origin::Origin;
use crate::quality::findings::stored::regions::Regions;
use crate::quality::findings::stored::rotated;
use crate::quality::input::part::Direction;
use glam::DVec3;

/// From this angle, in degrees, a normal counts as the opposite of the expected one, and an edge as a fold.
const OPPOSITE: f64 = 135.0;

/// The share of corners against their faces from which all are inverted.
const ALL: f64 = 0.9;

/// The share of exact opposites among flipped normals from which they were negated: of a fine ball lit from above one in two
/// thousand is, and one in ten where the recipe is off by 3°.
const NEGATED: f64 = 0.05;

#[derive(Clone, Copy, PartialEq)]
enum Verdict {
    /// A finding, whatever the rest of the mesh is like.
    Certain(Kind),
    /// The rest of the mesh decides.
    Open(Area, Class),
}

/// Where an open verdict is from.
#[derive(Clone, Copy, PartialEq)]
enum Area {
    /// From faces that the recipe applies to.
    Recipe,
    /// From a region that the recipe says nothing about.
    Region,
}

#[derive(Clone, Copy, PartialEq)]
enum Class {
    /// Deviates, and other corners of the vertex share it.
    Shared,
    /// Deviates, and is the mean of a run of faces.
    Run,
    /// Nearly the opposite of the expected normal.
    Flipped,
    /// Behind its face.
    Against,
    /// Exactly the opposite of the expected normal.
    Opposite,
}

use Class::{Against, Flipped, Opposite, Run as OfRun, Shared};

pub(crate) fn search(facts: &Facts<'_>, found: &mut Found) {
    let (runs, regions) = (Runs::new(facts), Regions::new(facts));
    let corner =
        Corner { facts, runs, regions: &regions, deviation: Limit::new(facts.thresholds.deviation.0) };
    let mut verdicts = facts.scan_corners(|face, index, found| {
        if let Some((verdict, degrees)) = corner.check(face, index) {
            found.add(verdict, Spot::corner(face, index, degrees), facts.corner_area(face));
        }
    });
    if rotated::search(facts, found) {
        // One cause explains all of them.
        return;
    }
    let certain = [Kind::Flipped, Kind::AgainstFace, Kind::Outlier, Kind::Custom];
    let sound = (0..facts.mesh.face_count()).filter(|&face| facts.is_sound(face));
    let sound = sound.map(|face| facts.corners_of(face).len()).sum::<usize>() as f64;
    let against: u64 = certain[..2].iter().map(|finding| verdicts.count(Verdict::Certain(*finding))).sum();
    let against = against + open_against(&verdicts, Area::Recipe) + open_against(&verdicts, Area::Region);
    let is_inverted = against as f64 >= ALL * sound;
    for finding in certain {
        let tally = verdicts.take(Verdict::Certain(finding));
        found.absorb(if is_inverted { Kind::Inverted } else { finding }, tally);
    }
    if is_inverted {
        for area in [Area::Recipe, Area::Region] {
            for class in [Shared, OfRun, Flipped, Against, Opposite] {
                found.absorb(Kind::Inverted, verdicts.take(Verdict::Open(area, class)));
            }
        }
    } else {
        grade_by_recipe(facts, &mut verdicts, regions.corners, sound, found);
        grade_regions(facts, &mut verdicts, found);
    }
}

fn open_against(verdicts: &Tallies<Verdict>, area: Area) -> u64 {
    [Flipped, Against, Opposite].map(|class| verdicts.count(Verdict::Open(area, class))).iter().sum()
}

struct Corner<'a> {
    facts: &'a Facts<'a>,
    runs: Option<Runs<'a>>,
    regions: &'a Regions,
    deviation: Limit,
}

impl Corner<'_> {
    /// The verdict on the normal of a corner and its deviation in degrees; `None` if it is right, or nothing can be said.
    fn check(&self, face: usize, corner: usize) -> Option<(Verdict, f64)> {
        let facts = self.facts;
        if facts.is_disputed(corner) {
            return self.check_disputed(face, corner);
        }
        if !facts.is_sound(face) || !facts.is_judged(corner) {
            return None;
        }
        let normal = facts.stored_unit(corner)?;
        let off = self.deviation.exceeded(normal, facts.expected(corner))?;
        let finding = self.finding(face, corner, normal, off)?;
        let area = if self.regions.has(face) { Area::Region } else { Area::Recipe };
        let origin = Origin::of(facts, corner, normal);
        let (is_outlier, is_flipped) = (finding == Kind::Outlier, finding == Kind::Flipped);
        let verdict = match origin {
            None => Verdict::Certain(finding),
            Some(_) if is_outlier && off <= EXACT => Verdict::Certain(Kind::Custom),
            Some(Origin::Shared) if is_outlier => Verdict::Open(area, Shared),
            Some(Origin::Run) if is_outlier => Verdict::Open(area, OfRun),
            _ if is_flipped && area == Area::Recipe && is_alone(facts, face, corner) => {
                Verdict::Certain(finding)
            }
            _ if is_flipped && off >= 180.0 - SAME && is_negated(facts, face, corner) => {
                Verdict::Open(area, Opposite)
            }
            _ => Verdict::Open(area, if is_flipped { Flipped } else { Against }),
        };
        Some((verdict, off))
    }

    /// The same next to faces with opposite winding to their neighbours, or on such a face. Their means are uncertain, as is which way a
    /// normal on them should point: nothing is wrong if any reading explains it.
    fn check_disputed(&self, face: usize, corner: usize) -> Option<(Verdict, f64)> {
        let facts = self.facts;
        let stored = facts.stored_unit(corner)?;
        let expected = facts.expected(corner);
        let is_reversed = facts.direction(face) == Direction::Reversed;
        let normal = if is_reversed && stored.dot(expected) < 0.0 { -stored } else { stored };
        let off = self.deviation.exceeded(normal, expected)?;
        let finding = self.finding(face, corner, normal, off)?;
        let origin = Origin::of_disputed(facts, corner, stored, is_reversed);
        origin.is_none().then_some((Verdict::Certain(finding), off))
    }

    /// What is wrong with a normal that is off by so many degrees; `None` if an edge explains it.
    fn finding(&self, face: usize, corner: usize, normal: DVec3, off: f64) -> Option<Kind> {
        let facts = self.facts;
        let from_face = degrees_between(normal, facts.face_normal(face));
        if from_face > 90.0 + facts.thresholds.against.0 {
            // Smoothed over a fold, as when a polygon that crosses itself was cut into triangles, it is right for one side.
            let is_folded = facts.corners_of(face).any(|corner| is_at_averaged(facts, corner, OPPOSITE));
            let finding = if off > OPPOSITE { Kind::Flipped } else { Kind::AgainstFace };
            return (!is_folded).then_some(finding);
        }
        // An edge that should be sharp explains its corners, and so does one that should not be. With two fans, the normal may be
        // of the other one. It may also continue across the border of the part.
        let is_explained = is_at_averaged(facts, corner, 0.0)
            || self.runs.as_ref().is_some_and(|runs| runs.of(corner as u32) != Run::default())
            || facts.has_two_fans(corner)
            || facts.is_shared_with_other_part(corner, normal);
        (!is_explained).then_some(Kind::Outlier)
    }
}

/// Whether at least half of the other corners of a face are like this.
fn are_most_others(facts: &Facts<'_>, face: usize, corner: usize, is: impl Fn(usize) -> bool) -> bool {
    let others = || facts.corners_of(face).filter(|&other| other != corner);
    2 * others().filter(|&other| is(other)).count() >= others().count()
}

/// Whether a normal of a face is on its front.
fn is_in_front(facts: &Facts<'_>, face: usize, corner: usize) -> bool {
    facts.stored_unit(corner).is_some_and(|normal| normal.dot(facts.face_normal(face)) > 0.0)
}

fn is_alone(facts: &Facts<'_>, face: usize, corner: usize) -> bool {
    are_most_others(facts, face, corner, |other| is_in_front(facts, face, other))
}

/// Whether most other normals of a face are on its front, or nearly opposite to the expected ones too. An exact opposite was then
/// negated, and not reached by leaning farther and farther back, as at the lower pole of a ball lit from above.
fn is_negated(facts: &Facts<'_>, face: usize, corner: usize) -> bool {
    let is_opposite = |other: usize| {
        let normal = facts.stored_unit(other);
        normal.is_some_and(|normal| degrees_between(-normal, facts.expected(other)) <= REPRODUCED)
    };
    are_most_others(facts, face, corner, |other| is_in_front(facts, face, other) || is_opposite(other))
}

/// Grades open verdicts on faces that the recipe applies to. They are outliers if they are most of what the recipe does not
/// explain, be it followed closely or exactly; otherwise the normals are authored. Marked edges may explain the means of runs,
/// unless nearly all of the mesh follows the recipe.
fn grade_by_recipe(
    facts: &Facts<'_>,
    verdicts: &mut Tallies<Verdict>,
    corners_in_regions: usize,
    sound: f64,
    found: &mut Found,
) {
    let estimate = facts.estimate;
    let is_rule = estimate.is_some_and(|estimate| estimate.is_rule());
    let is_departed_from = estimate.is_some_and(|estimate| estimate.is_departed_from());
    let faults = |found: &Found| {
        [Kind::Flipped, Kind::AgainstFace, Kind::Outlier]
            .map(|finding| found.count(finding))
            .iter()
            .sum::<u64>() as f64
    };
    let unexplained = (1.0 - estimate.map_or(0.0, |estimate| estimate.reproduced)) * sound;
    let left =
        unexplained - corners_in_regions as f64 - faults(found) - open_against(verdicts, Area::Recipe) as f64;
    grade_against(verdicts, Area::Recipe, is_departed_from, found);
    let [shared, of_run] = [Shared, OfRun].map(|class| verdicts.take(Verdict::Open(Area::Recipe, class)));
    let are_most = |count: u64| count as f64 >= 0.5 * left;
    let are_both = is_rule && are_most(shared.count + of_run.count);
    let are_shared = are_both || (is_departed_from && are_most(shared.count));
    for (tally, is_fault) in [(shared, are_shared), (of_run, are_both)] {
        found.absorb(if is_fault { Kind::Outlier } else { Kind::Custom }, tally);
    }
    let faults = faults(found);
    let outliers = found.tally(Kind::Outlier);
    let has_groups = facts.mesh.columns().smoothing.is_some();
    outliers.remedy = estimate.map(|estimate| estimate.options(has_groups));
    // Computing all normals is no remedy if others were made in another way.
    outliers.may_be_meant = !is_departed_from || faults < 0.5 * unexplained;
}

/// Grades open verdicts on regions that the recipe says nothing about. They may be intended, also next to faults of others.
fn grade_regions(facts: &Facts<'_>, verdicts: &mut Tallies<Verdict>, found: &mut Found) {
    let mut own = Tallies::new(facts.thresholds.places);
    grade_against(verdicts, Area::Region, false, &mut own);
    if found.count(Kind::AgainstFace) > 0 {
        let tally = own.take(Kind::AgainstFace);
        own.absorb(Kind::Custom, tally);
    }
    for class in [Shared, OfRun] {
        own.absorb(Kind::Custom, verdicts.take(Verdict::Open(Area::Region, class)));
    }
    // The remedy of the others would change these.
    let are_meant = own.count(Kind::AgainstFace) + own.count(Kind::Custom) > 0;
    [Kind::Flipped, Kind::AgainstFace]
        .into_iter()
        .for_each(|finding| found.tally(finding).may_be_meant |= are_meant);
    found.merge(own);
}

/// Grades normals that point behind their face and have an origin. They are faults if a recipe made the rest. Otherwise they may be
/// intended, as on leaves that are lit like a ball; next to normals without an origin, which are faults in any case, they are
/// only custom.
fn grade_against(verdicts: &mut Tallies<Verdict>, area: Area, is_departed_from: bool, found: &mut Found) {
    let [flipped, against, opposite] =
        [Flipped, Against, Opposite].map(|class| verdicts.take(Verdict::Open(area, class)));
    let are_alone = found.count(Kind::AgainstFace) == 0;
    let are_negated = opposite.count as f64 >= NEGATED * (opposite.count + flipped.count) as f64;
    let (negated, leaning) =
        if are_negated { (opposite, Tally::default()) } else { (Tally::default(), opposite) };
    found.absorb(Kind::Flipped, negated);
    for (finding, tally) in [(Kind::Flipped, flipped), (Kind::AgainstFace, against), (Kind::Flipped, leaning)]
    {
        // Next to more exact opposites, what is nearly opposite was negated with them.
        let is_negated = finding == Kind::Flipped && found.count(finding) > tally.count;
        let graded = match (is_departed_from || is_negated, are_alone) {
            (true, _) => finding,
            (false, true) => Kind::AgainstFace,
            (false, false) => Kind::Custom,
        };
        found.absorb(graded, tally);
    }
    if !is_departed_from && are_alone {
        let against = found.tally(Kind::AgainstFace);
        against.severity = Some(Severity::Note);
        against.may_be_meant = true;
    }
}
