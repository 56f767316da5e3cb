//! Normals that are missing, without a direction or not of unit length.

use crate::quality::effect::lost_light::{key_light_lost, key_light_scaled};
use crate::quality::findings::prelude::*;

/// Reports a part without normals, with the corners at which flat normals, as glTF asks for, are farthest from smooth ones.
pub(crate) fn report_none(facts: &Facts<'_>, found: &mut Found) {
    // The square of the chord grows with the angle and costs less.
    let chord = |face, corner| (facts.face_normal(face) - facts.expected(corner)).length_squared();
    let mut flattest = facts.scan_corners(|face, corner, found| {
        if facts.has_direction(face) {
            found.add((), Spot::corner(face, corner, chord(face, corner)), 0.0);
        }
    });
    let by_angle = |spot: Spot| {
        spot.by(degrees_between(facts.face_normal(spot.face as usize), facts.expected(spot.corner as usize)))
    };
    let mut worst: Vec<Spot> = flattest.take(()).worst.into_iter().map(by_angle).collect();
    if worst.is_empty() {
        // A mesh without any direction: everywhere.
        worst.push(Spot::mesh().by(0.0));
    }
    found.add_mesh(Kind::NoNormals, facts.total_area, worst);
}

pub(crate) fn search(facts: &Facts<'_>, found: &mut Found) {
    let Some(stored) = facts.stored else { return };
    found.merge(facts.scan_corners(|face, corner, found| {
        let (spot, area) = (Spot::corner(face, corner, 0.0), facts.corner_area(face));
        let Some(normal) = stored.get(corner, facts.vertex(corner)) else {
            // glTF asks for flat normals there.
            let flat = degrees_between(facts.face_normal(face), facts.expected(corner));
            return found.add(Kind::MissingNormals, spot.by(flat), area);
        };
        let length = normal.length();
        let error = (length - 1.0).abs();
        if !normal.is_finite() {
            found.add(Kind::NotFinite, spot.of(Measure::Steps, key_light_lost()), area);
        } else if length == 0.0 {
            // No normal is right at a corner of a face without direction.
            if facts.has_direction(face) {
                found.add(Kind::ZeroNormals, spot.of(Measure::Steps, key_light_lost()), area);
            }
        } else if error > facts.thresholds.length {
            found.add(Kind::NotUnit, spot.of(Measure::Steps, key_light_scaled(length)), area);
        } else if error > facts.thresholds.strict_length {
            found.add(Kind::LooseLength, spot.of(Measure::Steps, key_light_scaled(length)), area);
        }
    }));
}
