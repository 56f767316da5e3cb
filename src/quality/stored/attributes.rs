//! Findings about what goes with normals: tangents, and the normals of morphed shapes.

use crate::io::Loaded;
use crate::num::{Degrees, UnitVec3, angle_between};
use crate::quality::catalogue::Kind;
use crate::quality::counts::{Gauge, Spot, Tallies, scan};
use crate::quality::facts::{Facts, Significance};
use crate::quality::thresholds::Thresholds;
use glam::DVec4;

/// Everything about the attributes of a part beside its normals.
pub(in crate::quality) fn find(
    facts: &Facts<'_>,
    loaded: &Loaded,
    part: usize,
    thresholds: &Thresholds,
    found: &mut Tallies,
) {
    if facts.stored.is_none() {
        return;
    }
    tangents(facts, &loaded.tangents(part), thresholds, found);
    for target in 0..facts.mesh.columns().morph_targets.len() {
        morphed(facts, loaded, part, target, thresholds, found);
    }
}

/// Tangents that do not lie across their normal, or whose length or handedness is not 1.
fn tangents(facts: &Facts<'_>, tangents: &[Option<DVec4>], thresholds: &Thresholds, found: &mut Tallies) {
    if tangents.is_empty() {
        return;
    }
    let corners = facts.mesh.faces().corners();
    let off = scan(facts.mesh.face_count(), thresholds.places, |faces, found| {
        for face in faces.filter(|&face| facts.worth[face] != Significance::Silent) {
            let range = facts.mesh.faces().range(face);
            let area = facts.area[face] / range.len() as f64;
            for corner in range {
                let (Some(tangent), Some(normal)) =
                    (tangents[corners[corner] as usize], facts.stored_unit(corner))
                else {
                    continue;
                };
                let direction = tangent.truncate();
                let is_unit = (direction.length() - 1.0).abs() <= thresholds.length && tangent.w.abs() == 1.0;
                let lean = (90.0 - Degrees::from(angle_between(direction, normal)).0).abs();
                if !is_unit {
                    found.add(Kind::Tangents, Spot::corner(face, corner, 0.0).of(Gauge::Order, 180.0), area);
                } else if lean > thresholds.tangent.0 {
                    found.add(Kind::Tangents, Spot::corner(face, corner, lean), area);
                }
            }
        }
    });
    found.merge(off);
}

/// Normals of a morphed shape that are further from those that the shape should have than those of the mesh itself are.
fn morphed(
    facts: &Facts<'_>,
    loaded: &Loaded,
    part: usize,
    target: usize,
    thresholds: &Thresholds,
    found: &mut Tallies,
) {
    let added = loaded.morph_normals(part, target);
    let Some(expected) = facts.field.morph_normals.get(target).filter(|_| !added.is_empty()) else { return };
    let corners = facts.mesh.faces().corners();
    let off = scan(facts.mesh.face_count(), thresholds.places, |faces, found| {
        for face in faces.filter(|&face| facts.worth[face] == Significance::Sound) {
            let range = facts.mesh.faces().range(face);
            let area = facts.area[face] / range.len() as f64;
            for corner in range {
                let vertex = corners[corner];
                let (Some(added), Some(own)) = (added[vertex as usize], facts.stored_unit(corner)) else {
                    continue;
                };
                let slot =
                    facts.field.normals.slot(corner, vertex).expect("a field has a normal for every corner");
                let degrees = |a, b| Degrees::from(angle_between(a, b)).0;
                let own_off = degrees(own, facts.expected(corner));
                let off = match UnitVec3::new(own + added) {
                    Some(normal) => degrees(normal.get(), expected[slot as usize]),
                    // No direction is as wrong as can be.
                    None => 180.0,
                };
                if off - own_off > thresholds.deviation.0 {
                    found.add(Kind::MorphNormals, Spot::corner(face, corner, off), area);
                }
            }
        }
    });
    found.merge(off);
}
