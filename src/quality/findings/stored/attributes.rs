//! Attributes that go with normals: tangents, and the normals of morph targets.

use crate::num::UnitVec3;
use crate::quality::findings::prelude::*;

/// Checks the tangents and morph targets of a part with stored normals.
pub(crate) fn search(facts: &Facts<'_>, found: &mut Found) {
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
