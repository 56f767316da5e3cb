//! Normals that are missing, without a direction or not of unit length, tangents, and the normals of morph targets.

use crate::num::UnitVec3;
use crate::quality::effect::{key_light_lost, key_light_scaled};
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

/// Checks the tangents and morph targets of a part with stored normals.
pub(crate) fn search_attributes(facts: &Facts<'_>, found: &mut Found) {
    if facts.stored.is_some() {
        search_tangents(facts, found);
        (0..facts.mesh.columns().morph_targets.len()).for_each(|target| search_morphs(facts, target, found));
    }
}

/// Finds tangents that are not at right angles to their normal, or whose length or handedness is not 1.
fn search_tangents(facts: &Facts<'_>, found: &mut Found) {
    let tangents = facts.file.loaded.tangents(facts.number);
    if tangents.is_empty() {
        return;
    }
    let thresholds = facts.thresholds;
    found.merge(facts.scan_corners(|face, corner, found| {
        if !facts.has_direction(face) {
            return;
        }
        let tangent = tangents[facts.vertex(corner) as usize];
        let Some((tangent, normal)) = tangent.zip(facts.stored_unit(corner)) else { return };
        let (direction, area) = (tangent.truncate(), facts.corner_area(face));
        let is_unit = (direction.length() - 1.0).abs() <= thresholds.length && tangent.w.abs() == 1.0;
        let lean = (90.0 - degrees_between(direction, normal)).abs();
        if !is_unit {
            found.add(Kind::Tangents, Spot::corner(face, corner, 0.0).of(Measure::Order, 180.0), area);
        } else if lean > thresholds.tangent.0 {
            found.add(Kind::Tangents, Spot::corner(face, corner, lean), area);
        }
    }));
}

/// Finds normals of a morphed shape that deviate more than those of the mesh itself.
fn search_morphs(facts: &Facts<'_>, target: usize, found: &mut Found) {
    let offsets = facts.file.loaded.morph_normals(facts.number, target);
    let Some(expected) = facts.field.morph_normals.get(target).filter(|_| !offsets.is_empty()) else {
        return;
    };
    found.merge(facts.scan_corners(|face, corner, found| {
        if !facts.is_sound(face) {
            return;
        }
        let vertex = facts.vertex(corner);
        let offset = offsets[vertex as usize];
        let Some((offset, stored)) = offset.zip(facts.stored_unit(corner)) else { return };
        let slot = facts.field.normals.slot(corner, vertex).expect("a field has a normal for every corner");
        let own = degrees_between(stored, facts.expected(corner));
        // No direction is as wrong as can be.
        let morphed = UnitVec3::new(stored + offset)
            .map_or(180.0, |normal| degrees_between(normal.get(), expected[slot as usize]));
        if morphed - own > facts.thresholds.deviation.0 {
            found.add(Kind::MorphNormals, Spot::corner(face, corner, morphed), facts.corner_area(face));
        }
    }));
}
