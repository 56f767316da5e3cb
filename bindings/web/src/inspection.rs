//! The findings of a mesh, each with the place of its worst occurrences and the side that they face.

use crate::laboratory::Result;
use crate::subject::Subject;
use crease::num::{Degrees, Radians};
use crease::quality::{Finding, Site, Thresholds, diagnose};
use glam::{DMat3, DMat4, DVec3};
use serde_json::{Value, json};

pub(crate) fn inspect(subject: &Subject) -> Result<Value> {
    let loaded = subject.loaded.clone().without_source();
    let diagnosis = diagnose(&loaded, &Thresholds::default(), &|_| {});
    let stem = subject.name.rsplit_once('.').map_or(&*subject.name, |(stem, _)| stem);
    let fixed = format!("{stem}-fixed.{}", loaded.format.extension());
    let findings: Vec<Value> = diagnosis
        .findings
        .iter()
        .map(|finding| {
            let entry = finding.kind.entry();
            json!({
                "id": finding.kind.id(),
                "title": entry.title(),
                "meaning": entry.meaning(),
                "advice": entry.advice(),
                "cause": finding.cause,
                "severity": finding.severity,
                "count": finding.count,
                "of": finding.of,
                "element": entry.element.name(),
                "degrees": finding.degrees,
                "command": finding.command(&subject.name, &fixed),
                "places": places(subject, finding),
            })
        })
        .collect();
    Ok(json!({ "name": subject.name, "findings": findings }))
}

/// The places of a finding that have a position, in the world, with the turn and tilt of a viewer in front of each.
fn places(subject: &Subject, finding: &Finding) -> Vec<Value> {
    finding.places.iter().filter_map(|site| place(subject, site)).collect()
}

fn place(subject: &Subject, site: &Site) -> Option<Value> {
    let placed = subject.places().into_iter().find(|&(part, _)| part == site.part);
    let world = placed.map_or(DMat4::IDENTITY, |(_, world)| world);
    let position = world.transform_point3(site.position?);
    let face = site.face.and_then(|face| subject.fields[site.part].face_normals.get(face as usize));
    let outwards = face.map(|&normal| DMat3::from_mat4(world) * normal);
    let towards = outwards.unwrap_or(position - subject.centre).try_normalize().unwrap_or(DVec3::Z);
    let degrees = |radians: f64| Degrees::from(Radians(radians)).0;
    Some(json!({
        "position": position.to_array(),
        "turn": degrees(libm::atan2(towards.x, towards.z)),
        "tilt": degrees(libm::asin(towards.y.clamp(-1.0, 1.0))),
        "face": site.face,
        "vertex": site.vertex,
        "line": site.line,
        "degrees": site.degrees,
    }))
}
