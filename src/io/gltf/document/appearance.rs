//! Materials, cameras and lights; materials and lights by the typed view of the `gltf` crate.

use crate::io::appearance::as_written;
use crate::io::gltf::GltfDocument;
use crate::io::gltf::document::camera;
use crate::io::gltf::document::nodes;
use crate::io::gltf::json::fields::{At, Fields};
use crate::io::gltf::json::tree::{Json, Kind, Value};
use crate::io::{Appearance, FileLight, FileLightKind, FileMaterial, FileReflection, Note, Place};
use glam::DMat4;
use gltf::json::extensions::scene::khr_lights_punctual::{Light, Type as LightType};
use gltf::json::material::Material;
use gltf::json::validation::Checked;
use serde::de::DeserializeOwned;

const LIGHTS: &str = "KHR_lights_punctual";

/// What the document says about looks. Materials and lights that the standard does not allow are left out with a note.
pub(in crate::io) fn appearance(document: &GltfDocument) -> Appearance {
    let mut found = Appearance::default();
    let json = &document.records.json;
    for (name, &number) in &document.materials {
        found.material(json, name, document.records.materials[number], number);
    }
    let lights = punctual_lights(json);
    let visited = nodes::each(json, |node| {
        if !node.shown {
            return Ok(());
        }
        found.cameras.extend(camera::at_node(&node).transpose());
        if let Some(extension) = node.fields.extension(LIGHTS) {
            let light = json.member(extension, "light").and_then(|light| json.integer(light));
            found.light(json, &lights, light, node.fields.at, node.world);
        }
        Ok(())
    });
    if let Err(error) = visited {
        found.notes.push(Note::warning(error.place.clone(), error.found.clone()));
    }
    found
}

fn elements(json: &Json, list: Option<Value>) -> Vec<Value> {
    let list = list.filter(|&list| json.kind(list) == Kind::Array);
    list.map_or_else(Vec::new, |list| json.elements(list).collect())
}

fn punctual_lights(json: &Json) -> Vec<Value> {
    let extension = json.member(json.root(), "extensions").and_then(|all| json.member(all, LIGHTS));
    elements(json, extension.and_then(|extension| json.member(extension, "lights")))
}

impl Appearance {
    /// A value as a record of the `gltf` crate.
    fn typed<T: DeserializeOwned>(&mut self, json: &Json, value: Option<Value>, place: Place) -> Option<T> {
        let typed = match value {
            Some(value) => serde_json::from_str(json.raw(value)).map_err(|error| error.to_string()),
            None => Err("it is not there".to_owned()),
        };
        typed.map_err(|error| self.warn(place, &error)).ok()
    }

    fn warn(&mut self, place: Place, reason: &str) {
        self.notes.push(Note::warning(place, format!("not understood and left out: {reason}")));
    }

    fn material(&mut self, json: &Json, name: &str, object: Value, number: usize) {
        let at = At::new("materials", number);
        let Some(material) = self.typed::<Material>(json, Some(object), at.place()) else { return };
        let surface = &material.pbr_metallic_roughness;
        let [r, g, b, opacity] = surface.base_color_factor.0.map(as_written);
        let [metallic, roughness] = [surface.metallic_factor.0, surface.roughness_factor.0].map(as_written);
        if [r, g, b, opacity, metallic, roughness].iter().any(|factor| !(0.0..=1.0).contains(factor)) {
            return self.warn(at.place(), "factors of a material are numbers from 0 to 1");
        }
        let unlit = Fields { json, object, at }.extension("KHR_materials_unlit").is_some();
        let textures = [
            surface.base_color_texture.is_some(),
            surface.metallic_roughness_texture.is_some(),
            material.normal_texture.is_some(),
            material.occlusion_texture.is_some(),
            material.emissive_texture.is_some(),
        ];
        self.materials.push(FileMaterial {
            name: name.to_owned(),
            reflection: FileReflection::MetallicRoughness {
                base_colour: [r, g, b],
                metallic,
                roughness,
                unlit,
            },
            opacity: Some(opacity),
            textures: textures.into_iter().filter(|&there| there).count(),
        });
    }

    fn light(&mut self, json: &Json, lights: &[Value], number: Option<u64>, at: At, world: DMat4) {
        let number = number.and_then(|number| usize::try_from(number).ok());
        let Some(number) = number else {
            return self.warn(at.member("extensions"), "a light is named by its number");
        };
        let place = Place::Json(format!("/extensions/{LIGHTS}/lights/{number}"));
        let Some(light) = self.typed::<Light>(json, lights.get(number).copied(), place.clone()) else {
            return;
        };
        let kind = match (&light.type_, &light.spot) {
            (Checked::Valid(LightType::Directional), _) => FileLightKind::Directional,
            (Checked::Valid(LightType::Point), _) => FileLightKind::Point,
            (Checked::Valid(LightType::Spot), Some(spot)) => FileLightKind::Spot {
                inner: as_written(spot.inner_cone_angle),
                outer: as_written(spot.outer_cone_angle),
            },
            _ => return self.warn(place, "a light is directional, point or spot, and a spot says how wide"),
        };
        self.lights.push(FileLight {
            name: light.name.unwrap_or_default(),
            world_from_light: world,
            kind,
            colour: light.color.map(as_written),
            intensity: as_written(light.intensity),
            range: light.range.map(as_written),
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::{FileProjection, Format, ReadOptions, read_bytes};
    use glam::DVec3;

    fn looks(text: &str) -> Appearance {
        let options = ReadOptions::default();
        read_bytes(text.as_bytes().to_vec(), Some(Format::Gltf), None, &options).unwrap().appearance()
    }

    #[test]
    fn cameras_and_lights_stand_where_their_nodes_do() {
        let found = looks(
            r#"{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
            "cameras": [{"type": "orthographic", "orthographic":
                {"xmag": 9, "ymag": 1.1, "znear": 0.1, "zfar": 9}},
                {"type": "perspective", "name": "eye", "perspective": {"yfov": 0.6, "znear": 0.01}}],
            "extensions": {"KHR_lights_punctual": {"lights": [{"type": "spot", "color": [1, 0.5, 0],
                "intensity": 20, "range": 7, "spot": {"outerConeAngle": 0.3}}, {"type": "point"}]}},
            "nodes": [{"translation": [1, 2, 3], "children": [1, 2]}, {"camera": 1, "translation": [0, 0, 4]},
                {"extensions": {"KHR_lights_punctual": {"light": 0}}}, {"camera": 0}]}"#,
        );
        assert_eq!(found.notes, []);
        let [Ok(camera)] = &found.cameras[..] else { panic!("the other one is not in the scene") };
        assert_eq!((&*camera.name, camera.near), ("eye", 0.01));
        assert_eq!(camera.projection, FileProjection::Perspective(0.6));
        assert_eq!(camera.world_from_camera.transform_point3(DVec3::ZERO), DVec3::new(1.0, 2.0, 7.0));
        let [light] = &found.lights[..] else { panic!("one light") };
        assert_eq!(light.kind, FileLightKind::Spot { inner: 0.0, outer: 0.3 });
        assert_eq!((light.colour, light.intensity, light.range), ([1.0, 0.5, 0.0], 20.0, Some(7.0)));
    }

    #[test]
    fn what_the_standard_does_not_allow_is_left_out_and_reported() {
        let found = looks(
            r#"{"asset": {"version": "2.0"},
            "extensions": {"KHR_lights_punctual": {"lights": [{"type": "spot"}, {"type": "area"}, {}]}},
            "nodes": [{"extensions": {"KHR_lights_punctual": {"light": 0}}},
                {"extensions": {"KHR_lights_punctual": {"light": 1}}},
                {"extensions": {"KHR_lights_punctual": {"light": 2}}},
                {"extensions": {"KHR_lights_punctual": {"light": 3}}},
                {"extensions": {"KHR_lights_punctual": {}}}]}"#,
        );
        assert_eq!(found.lights.len(), 0);
        assert_eq!(found.notes.len(), 5, "{:?}", found.notes);
        let lights = "/extensions/KHR_lights_punctual/lights/0";
        assert_eq!(found.notes[0].place, Place::Json(lights.into()));
        assert_eq!(found.notes[4].place, Place::Json("/nodes/4/extensions".into()));
    }

    /// Each fault with its place, the number that is wrong and what to do.
    #[test]
    fn what_is_no_camera_is_an_error_of_its_own() {
        let (perspective, orthographic) = (
            r#"{"type": "perspective", "perspective": {"yfov": 0.6, "znear": 0.1}}"#,
            r#"{"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1.1, "znear": 0, "zfar": 9}}"#,
        );
        let at_camera = |camera: &str, node: &str| {
            let text = format!(
                r#"{{"asset": {{"version": "2.0"}}, "cameras": [{camera}], "nodes": [{{"camera": 0{node}}}]}}"#
            );
            looks(&text).cameras.remove(0).map_err(|error| error.to_string())
        };
        assert!(at_camera(perspective, "").is_ok() && at_camera(orthographic, "").is_ok());
        let lens = "/cameras/0/perspective";
        for (from, to, pieces) in [
            (
                r#""type": "perspective""#,
                r#""type": "fisheye""#,
                ["/cameras/0/type", "fisheye", "orthographic"],
            ),
            (r#""type": "perspective", "#, "", ["/cameras/0", "no `type`", "export"]),
            (r#""perspective":"#, r#""lens":"#, ["/cameras/0", "no `perspective`", "export"]),
            (
                r#""perspective": {"yfov": 0.6, "znear": 0.1}"#,
                r#""perspective": 7"#,
                [lens, "7 where an object", "export"],
            ),
            (r#""yfov": 0.6, "#, "", [lens, "no `yfov`", "export"]),
            ("0.6", r#""x""#, ["/perspective/yfov", r#""x" where a finite number"#, "export"]),
            ("0.6", "0", ["/perspective/yfov", "`yfov` is 0", "above 0 and below π, in radians"]),
            ("0.6", "-0.5", ["/perspective/yfov", "`yfov` is -0.5", "above 0 and below π, in radians"]),
            ("0.6", "3.2", ["/perspective/yfov", "`yfov` is 3.2", "above 0 and below π, in radians"]),
            ("0.6", "1e999", ["/perspective/yfov", "1e999 where a finite number", "export"]),
            (r#", "znear": 0.1"#, "", [lens, "no `znear`", "export"]),
            ("0.1", "0", ["/perspective/znear", "`znear` is 0", "above 0"]),
            (
                "0.1",
                r#"0.1, "zfar": 0.1"#,
                ["/perspective/zfar", "`zfar` is 0.1", "above `znear`, which is 0.1"],
            ),
            (
                "0.1",
                r#"0.1, "aspectRatio": 0"#,
                ["/perspective/aspectRatio", "`aspectRatio` is 0", "or none"],
            ),
            (
                "0.1",
                r#"0.1, "aspectRatio": -2"#,
                ["/perspective/aspectRatio", "`aspectRatio` is -2", "or none"],
            ),
            ("0.1}", r#"0.1}, "name": "eye", "type": "none""#, ["/cameras/0", "the camera `eye`", "none"]),
            (perspective, "7", ["/cameras/0", "7 where an object", "export"]),
            (perspective, "", ["/nodes/0/camera", "camera 0 is asked for", "where the file has 0"]),
        ] {
            assert!(perspective.contains(from));
            let error = at_camera(&perspective.replace(from, to), "").unwrap_err();
            assert!(pieces.iter().all(|piece| error.contains(piece)), "{to}: {error}");
        }
        for (from, to, pieces) in [
            ("1.1", "0", ["/orthographic/ymag", "`ymag` is 0", "above 0"]),
            (r#""xmag": 1"#, r#""xmag": -1"#, ["/orthographic/xmag", "`xmag` is -1", "above 0"]),
            (r#""znear": 0"#, r#""znear": -1"#, ["/orthographic/znear", "`znear` is -1", "0 or more"]),
            (r#""zfar": 9"#, r#""zfar": 0"#, ["/orthographic/zfar", "`zfar` is 0", "above `znear`"]),
            (r#", "zfar": 9"#, "", ["/cameras/0/orthographic", "no `zfar`", "export"]),
        ] {
            assert!(orthographic.contains(from));
            let error = at_camera(&orthographic.replace(from, to), "").unwrap_err();
            assert!(pieces.iter().all(|piece| error.contains(piece)), "{to}: {error}");
        }
        let error = at_camera(perspective, r#", "rotation": [0, 0, 0, 0]"#).unwrap_err();
        assert!(error.starts_with("/nodes/0/rotation: ") && error.contains("0, 0, 0, 1"), "{error}");
        let error = at_camera(perspective, r#", "x": 0, "camera": "x""#).unwrap_err();
        assert!(error.starts_with("/nodes/0/camera: \"x\" where"), "{error}");
    }
}
