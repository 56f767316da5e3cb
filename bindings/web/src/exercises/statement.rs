//! The givens of an exercise, from its scene: normal, viewer, lights, material, or the colours of corners.

use crease::num::LinearRgb;
use crease::raster::{Projection, SceneFile};
use crease::shade::{Attenuation, Light};
use serde_json::{Value, json};

/// Rows of a table: the key of a name, and a value in numbers.
pub(super) fn givens(file: &SceneFile, probe: &Value) -> Vec<Value> {
    let mut rows = Vec::new();
    let seen = &probe["report"]["samples"][0];
    let object = seen["object"].as_u64().unwrap_or(0) as usize;
    let vector = |value: &Value| [0, 1, 2].map(|k| value[k].as_f64().unwrap_or(f64::NAN));
    rows.push(json!({ "key": "point", "value": numbers(vector(&seen["position"])) }));
    if file.objects.get(object).is_some_and(|object| object.given) {
        corners(file, object, &mut rows);
        return rows;
    }
    let light = &seen["lit"][0]["light"];
    rows.push(json!({ "key": "normal", "value": numbers(vector(&light["normal"])) }));
    if let Some(camera) = file.camera {
        let (key, place) = match camera.projection {
            Projection::Orthographic(_) => ("viewer-towards", camera.eye - camera.target),
            Projection::Perspective(_) => ("viewer-at", camera.eye),
        };
        rows.push(json!({ "key": key, "value": numbers(place.to_array()) }));
    }
    for light in file.lights.iter().flatten() {
        let colour = colour(light.colour());
        let value = match light {
            Light::Ambient { .. } => json!({ "key": "ambient-light", "value": colour }),
            Light::Directional { towards, .. } => {
                json!({ "key": "light-towards", "value": numbers(towards.to_array()), "colour": colour })
            }
            Light::Point { position, attenuation, .. } => {
                let fades = if let Attenuation::Offset(k) = attenuation { Some(*k) } else { None };
                let at = numbers(position.to_array());
                json!({ "key": "light-at", "value": at, "colour": colour, "offset": fades })
            }
            _ => continue,
        };
        rows.push(value);
    }
    let material = &file.objects[object].material;
    for (key, reflectance) in
        [("k-ambient", material.ambient), ("k-diffuse", material.diffuse), ("k-specular", material.specular)]
    {
        rows.push(json!({ "key": key, "value": colour(reflectance.merged()) }));
    }
    rows.push(json!({ "key": "exponent", "value": short(material.exponent) }));
    let key = if material.reflection == crease::shade::Reflection::Phong { "phong" } else { "blinn" };
    rows.push(json!({ "key": key, "value": "" }));
    rows
}

fn corners(file: &SceneFile, object: usize, rows: &mut Vec<Value>) {
    let transform = file.objects[object].transform;
    let Some(mesh) = file.mesh_of(object) else { return };
    let colours = mesh.colours.iter().flatten();
    for (vertex, (point, &own)) in mesh.mesh.positions().iter().zip(colours).enumerate() {
        let point = numbers(transform.transform_point3(point).to_array());
        rows.push(json!({ "key": "corner", "number": vertex + 1, "value": point, "colour": colour(own) }));
    }
    let key = if file.settings.shading == crease::raster::Shading::Flat { "by-mean" } else { "by-scanline" };
    rows.push(json!({ "key": key, "value": "" }));
}

fn colour(colour: LinearRgb) -> String {
    numbers(colour.to_array())
}

fn numbers(list: [f64; 3]) -> String {
    format!("({})", list.map(short).join(", "))
}

/// A number with at most six decimals: roundings of a rotation do not show.
fn short(x: f64) -> String {
    let text = format!("{x:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}
