//! Materials, cameras and lights.

use super::document::GltfDocument;
use super::fields::{Fields, numbered, out_of_range};
use super::json::{Json, Value};
use super::nodes::{NodeTree, Placed};
use crate::io::appearance::as_written;
use crate::io::{
    Appearance, FileCamera, FileImages, FileLight, FileLightKind, FileMaterial, FileOptics, FileProjection,
    FileReflection, Note, Place, Problem, ReadError,
};
use glam::DMat4;
use gltf::json::extensions::scene::khr_lights_punctual::{Light, Type as LightType};
use gltf::json::material::Material;
use gltf::json::validation::Checked;
use serde::de::DeserializeOwned;
use std::f64::consts::PI;
use std::fmt::Write as _;

const LIGHTS: &str = "KHR_lights_punctual";

/// The materials, cameras and lights of a document. Invalid materials and lights are omitted with a note.
pub(in crate::io) fn appearance(document: &GltfDocument) -> Appearance {
    let records = &document.records;
    let json = &records.json;
    let mut found = Appearance::default();
    for (name, &number) in &document.materials {
        match material(&records.fields(records.materials[number]), number, name) {
            Ok(material) => found.materials.push(material),
            Err(error) => found.notes.push(not_understood(error)),
        }
    }
    let extension = Fields::root(json).extension(LIGHTS);
    let lights: Vec<Value> = extension.into_iter().flat_map(|object| json.items(object, "lights")).collect();
    let visited = NodeTree::new(json).and_then(|tree| {
        tree.each(|node| {
            if !node.shown {
                return Ok(());
            }
            found.cameras.extend(camera_at(&node).transpose());
            if let Some(extension) = node.fields.extension(LIGHTS) {
                match light(&node, extension, &lights) {
                    Ok(light) => found.lights.push(light),
                    Err(error) => found.notes.push(not_understood(error)),
                }
            }
            Ok(())
        })
    });
    if let Err(error) = visited {
        found.notes.push(Note::warning(error.place, error.found));
    }
    found
}

fn not_understood(error: ReadError) -> Note {
    Note::warning(error.place, format!("ignored: {}", error.found))
}

fn typed<T: DeserializeOwned>(json: &Json, value: Value, place: Place) -> Result<T, ReadError> {
    serde_json::from_str(json.raw(value)).map_err(|error| out_of_range(place, error.to_string()))
}

fn material(fields: &Fields<'_>, number: usize, name: &str) -> Result<FileMaterial, ReadError> {
    let place = || numbered("materials", number);
    let material: Material = typed(fields.json, fields.object, place())?;
    let surface = &material.pbr_metallic_roughness;
    let [r, g, b, opacity] = surface.base_color_factor.0.map(as_written);
    let [metallic, roughness] = [surface.metallic_factor.0, surface.roughness_factor.0].map(as_written);
    if [r, g, b, opacity, metallic, roughness].iter().any(|factor| !(0.0..=1.0).contains(factor)) {
        return Err(out_of_range(place(), "a factor of the material is not between 0 and 1"));
    }
    let unlit = fields.extension("KHR_materials_unlit").is_some();
    let textures = [
        surface.base_color_texture.is_some(),
        surface.metallic_roughness_texture.is_some(),
        material.normal_texture.is_some(),
        material.occlusion_texture.is_some(),
        material.emissive_texture.is_some(),
    ];
    let base_colour = [r, g, b];
    Ok(FileMaterial {
        name: name.to_owned(),
        reflection: FileReflection::MetallicRoughness { base_colour, metallic, roughness, unlit },
        opacity: Some(opacity),
        optics: optics(fields, base_colour, metallic, &place)?,
        textures: textures.into_iter().filter(|&is_there| is_there).count(),
        images: FileImages::default(),
    })
}

/// Transmission with the index and the absorption of the volume. Without a thickness a surface is a thin wall: light passes
/// straight on.
fn optics(
    fields: &Fields<'_>,
    base_colour: [f64; 3],
    metallic: f64,
    place: &impl Fn() -> Place,
) -> Result<FileOptics, ReadError> {
    let json = fields.json;
    let number = |extension: Option<Value>, name: &str, default: f64| {
        let value = extension.and_then(|object| json.member(object, name));
        value.map_or(Ok(default), |value| typed::<f32>(json, value, place()).map(as_written))
    };
    let transmission = fields.extension("KHR_materials_transmission");
    let volume = fields.extension("KHR_materials_volume");
    let factor = number(transmission, "transmissionFactor", 0.0)?;
    let ior = number(fields.extension("KHR_materials_ior"), "ior", 1.5)?;
    let thickness = number(volume, "thicknessFactor", 0.0)?;
    let distance = number(volume, "attenuationDistance", f64::INFINITY)?;
    let colour = volume.and_then(|object| json.member(object, "attenuationColor"));
    let colour =
        colour.map_or(Ok([1.0_f32; 3]), |value| typed::<[f32; 3]>(json, value, place()))?.map(as_written);
    if !(0.0..=1.0).contains(&factor) {
        return Err(out_of_range(
            place(),
            format!("the transmission factor {factor} is not between 0 and 1"),
        ));
    }
    if thickness < 0.0 || distance <= 0.0 || !colour.iter().all(|share| (0.0..=1.0).contains(share)) {
        let found =
            "the volume has a negative thickness, a distance of 0 or less, or a colour outside 0 to 1";
        return Err(out_of_range(place(), found));
    }
    let lost = factor * (1.0 - metallic);
    // An index below 1 is reported where it matters, also that of a thin wall.
    let ior = if thickness > 0.0 || lost > 0.0 && ior < 1.0 { ior } else { 1.0 };
    let absorb = match thickness > 0.0 && distance.is_finite() {
        true => colour.map(|share| -libm::log(share.max(LEAST_SHARE)) / distance),
        false => [0.0; 3],
    };
    Ok(FileOptics { transmit: base_colour.map(|c| c * lost), lost, ior, absorb, ..FileOptics::default() })
}

/// The smallest share of light that a volume leaves: 0 has no logarithm.
const LEAST_SHARE: f64 = 1e-6;

fn light(node: &Placed<'_>, extension: Value, lights: &[Value]) -> Result<FileLight, ReadError> {
    let json = node.fields.json;
    let number = json.member(extension, "light").and_then(|light| json.integer(light));
    let Some(number) = number else {
        let place = Place::Json(format!("/nodes/{}/extensions", node.number));
        return Err(out_of_range(place, "the node names no light: `light` is missing"));
    };
    let place = Place::Json(format!("/extensions/{LIGHTS}/lights/{number}"));
    let value = usize::try_from(number).ok().and_then(|number| lights.get(number));
    let value = value.ok_or_else(|| out_of_range(place.clone(), "no light has this index"))?;
    let light: Light = typed(json, *value, place.clone())?;
    let kind = match (&light.type_, &light.spot) {
        (Checked::Valid(LightType::Directional), _) => FileLightKind::Directional,
        (Checked::Valid(LightType::Point), _) => FileLightKind::Point,
        (Checked::Valid(LightType::Spot), Some(spot)) => FileLightKind::Spot {
            inner: as_written(spot.inner_cone_angle),
            outer: as_written(spot.outer_cone_angle),
        },
        _ => {
            let found = "the type of the light is not directional, point, or spot with a `spot` object";
            return Err(out_of_range(place, found));
        }
    };
    Ok(FileLight {
        name: light.name.unwrap_or_default(),
        world_from_light: node.frame.world,
        kind,
        colour: light.color.map(as_written),
        intensity: as_written(light.intensity),
        range: light.range.map(as_written),
    })
}

/// The camera of a node, or what is wrong with it; `None` if it has none. It looks along its node's −z with +y up. It has the
/// position of its node, and the product of the rotations from the root on: scaling does not affect it (glTF 2.0, §3.10.2).
fn camera_at(node: &Placed<'_>) -> Result<Option<FileCamera>, ReadError> {
    let json = node.fields.json;
    let Some(value) = json.member(node.fields.object, "camera") else { return Ok(None) };
    let number = json.integer(value).and_then(|number| usize::try_from(number).ok());
    let Some(camera) = number.and_then(|number| json.items(json.root(), "cameras").nth(number)) else {
        let place = Place::Json(format!("/nodes/{}/camera", node.number));
        return Err(out_of_range(place, format!("the file has no camera {}", json.raw(value))));
    };
    let camera = Fields::new(json, camera)?;
    let name = camera.name()?;
    let read = projection(&camera).and_then(|(projection, [near, far])| {
        if let Some((at, member)) = node.frame.without_rotation {
            let (what, advice) = match member {
                "matrix" => {
                    ("a matrix without an inverse", "use `rotation`, `translation` and `scale` instead")
                }
                _ => ("a rotation of zeros", "use a quaternion of length 1, such as 0, 0, 0, 1"),
            };
            let found = format!("{what} gives a camera at or below this node no orientation");
            let place = Place::Json(format!("/nodes/{at}/{member}"));
            return Err(ReadError::new(Problem::Range, place, found, advice));
        }
        let position = node.frame.world.w_axis.truncate();
        Ok(FileCamera {
            name: name.clone(),
            place: camera.place(),
            world_from_camera: DMat4::from_rotation_translation(node.frame.rotation, position),
            projection,
            near,
            far: far.is_finite().then_some(far),
        })
    });
    match read {
        Err(error) if !name.is_empty() => {
            Err(ReadError { found: format!("camera `{name}`: {}", error.found), ..error })
        }
        read => read.map(Some),
    }
}

/// The projection of a camera, and its near and far distances, the latter infinite if there is none.
fn projection(camera: &Fields<'_>) -> Result<(FileProjection, [f64; 2]), ReadError> {
    let kind = camera.required_string("type")?;
    let (lens, projection, is_near, near_range): (_, _, fn(f64) -> bool, _) = match &*kind {
        "perspective" => {
            let lens = camera.required_child("perspective")?;
            let is_angle = |angle| angle > 0.0 && angle < PI;
            let angle = needed(&lens, "yfov", is_angle, "an angle above 0 and below π, in radians")?;
            optional(&lens, "aspectRatio", |aspect| aspect > 0.0, "a number above 0, or none")?;
            (lens, FileProjection::Perspective(angle), |near| near > 0.0, "a distance above 0")
        }
        "orthographic" => {
            let lens = camera.required_child("orthographic")?;
            let wanted = "half of the visible size, a length above 0";
            let whole = |name| Ok(2.0 * needed(&lens, name, |half| half > 0.0, wanted)?);
            let projection = FileProjection::Orthographic { width: whole("xmag")?, height: whole("ymag")? };
            (lens, projection, |near| near >= 0.0, "a distance of 0 or more")
        }
        kind => {
            let found = format!("unknown camera type `{kind}`");
            let advice = "use `perspective` or `orthographic`";
            return Err(ReadError::new(Problem::Range, camera.member("type"), found, advice));
        }
    };
    let near = needed(&lens, "znear", is_near, near_range)?;
    let far_range = format!("a distance above `znear`, which is {near}");
    let far = optional(&lens, "zfar", |far| far > near, &far_range)?;
    if far.is_none() && matches!(projection, FileProjection::Orthographic { .. }) {
        return Err(lens.missing("zfar"));
    }
    Ok((projection, [near, far.unwrap_or(f64::INFINITY)]))
}

fn needed(
    lens: &Fields<'_>,
    name: &str,
    is_allowed: impl Fn(f64) -> bool,
    wanted: &str,
) -> Result<f64, ReadError> {
    optional(lens, name, is_allowed, wanted)?.ok_or_else(|| lens.missing(name))
}

fn optional(
    lens: &Fields<'_>,
    name: &str,
    is_allowed: impl Fn(f64) -> bool,
    wanted: &str,
) -> Result<Option<f64>, ReadError> {
    match lens.number(name)? {
        Some(number) if !is_allowed(number) => {
            let found = format!("`{name}` is {number}");
            Err(ReadError::new(Problem::Range, lens.member(name), found, format!("give {wanted}")))
        }
        number => Ok(number),
    }
}

/// The textures of a new material, and the factor of the normal texture.
#[derive(Clone, Copy, Debug, Default)]
pub struct MaterialTextures {
    pub base_colour: Option<usize>,
    pub normal: Option<(usize, f64)>,
}

/// The members of a glTF material behind its name, each with a comma in front.
///
/// The diffuse colour is the base colour of a dielectric, number for number. A highlight of exponent n belongs to
/// a surface of α = √(2/(n + 2)) (Walter et al., "Microfacet models for refraction", 2007, eq. 30 with
/// n ≈ 2/α² − 2), and glTF's roughness is √α.
pub fn material_members(material: &FileMaterial, textures: MaterialTextures) -> String {
    let unit = |value: f64| value.clamp(0.0, 1.0);
    let (base, metallic, roughness) = match material.reflection {
        FileReflection::Phong { diffuse, exponent, .. } => {
            (diffuse, 0.0, exponent.map(|n| (2.0 / (n.max(0.0) + 2.0)).sqrt().sqrt()))
        }
        FileReflection::MetallicRoughness { base_colour, metallic, roughness, .. } => {
            (Some(base_colour), metallic, Some(roughness))
        }
    };
    let mut json = String::new();
    if base.is_some() || roughness.is_some() || material.opacity.is_some() || textures.base_colour.is_some() {
        json.push_str(",\"pbrMetallicRoughness\":{");
        if base.is_some() || material.opacity.is_some() {
            let [r, g, b] = base.unwrap_or([1.0; 3]).map(unit);
            let opacity = unit(material.opacity.unwrap_or(1.0));
            let _ = write!(json, "\"baseColorFactor\":[{r},{g},{b},{opacity}],");
        }
        if let Some(texture) = textures.base_colour {
            let _ = write!(json, "\"baseColorTexture\":{{\"index\":{texture}}},");
        }
        let _ = write!(json, "\"metallicFactor\":{metallic}");
        if let Some(roughness) = roughness {
            let _ = write!(json, ",\"roughnessFactor\":{}", roughness as f32);
        }
        json.push('}');
    }
    if let Some((texture, scale)) = textures.normal {
        let scale = if scale == 1.0 { String::new() } else { format!(",\"scale\":{scale}") };
        let _ = write!(json, ",\"normalTexture\":{{\"index\":{texture}{scale}}}");
    }
    if material.opacity.is_some_and(|opacity| opacity < 1.0) {
        json.push_str(",\"alphaMode\":\"BLEND\"");
    }
    json
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
    fn transmission_has_the_index_and_absorption_of_its_volume() {
        let text = |extensions: &str| {
            format!(
                r#"{{"asset": {{"version": "2.0"}}, "materials": [{{"name": "glass", "pbrMetallicRoughness":
                {{"baseColorFactor": [1, 0.5, 0, 1], "metallicFactor": 0}}, "extensions": {{{extensions}}}}}],
                "buffers": [{{"byteLength": 36, "uri":
                "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}}],
                "bufferViews": [{{"buffer": 0, "byteLength": 36}}],
                "accessors": [{{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                "min": [0, 0, 0], "max": [1, 1, 0]}}],
                "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}, "material": 0}}]}}]}}"#
            )
        };
        let transmission = r#""KHR_materials_transmission": {"transmissionFactor": 0.5}"#;
        let volume = r#""KHR_materials_ior": {"ior": 1.25}, "KHR_materials_volume":
            {"thicknessFactor": 1, "attenuationDistance": 2, "attenuationColor": [1, 0.5, 0.25]}"#;
        let optics = |extensions: &str| looks(&text(extensions)).materials[0].optics;
        let thin = FileOptics { transmit: [0.5, 0.25, 0.0], lost: 0.5, ..FileOptics::default() };
        assert_eq!(optics(transmission), thin);
        let body = optics(&format!("{transmission}, {volume}"));
        assert_eq!(FileOptics { absorb: [0.0; 3], ..body }, FileOptics { ior: 1.25, ..thin });
        // Half after a distance of 2, a quarter of it in blue.
        let half = std::f64::consts::LN_2 / 2.0;
        assert!(body.absorb.into_iter().zip([0.0, half, 2.0 * half]).all(|(a, b)| (a - b).abs() < 1e-7));
        let wrong = looks(&text(r#""KHR_materials_transmission": {"transmissionFactor": 2}"#));
        assert!(wrong.materials.is_empty() && wrong.notes[0].to_string().contains("factor 2 is not between"));
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
            (r#""type": "perspective", "#, "", ["/cameras/0", "`type` is missing", "export"]),
            (r#""perspective":"#, r#""lens":"#, ["/cameras/0", "`perspective` is missing", "export"]),
            (
                r#""perspective": {"yfov": 0.6, "znear": 0.1}"#,
                r#""perspective": 7"#,
                [lens, "7 is not an object", "export"],
            ),
            (r#""yfov": 0.6, "#, "", [lens, "`yfov` is missing", "export"]),
            ("0.6", r#""x""#, ["/perspective/yfov", r#""x" is not a finite number"#, "export"]),
            ("0.6", "0", ["/perspective/yfov", "`yfov` is 0", "above 0 and below π, in radians"]),
            ("0.6", "-0.5", ["/perspective/yfov", "`yfov` is -0.5", "above 0 and below π, in radians"]),
            ("0.6", "3.2", ["/perspective/yfov", "`yfov` is 3.2", "above 0 and below π, in radians"]),
            ("0.6", "1e999", ["/perspective/yfov", "1e999 is not a finite number", "export"]),
            (r#", "znear": 0.1"#, "", [lens, "`znear` is missing", "export"]),
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
            ("0.1}", r#"0.1}, "name": "eye", "type": "none""#, ["/cameras/0", "camera `eye`", "none"]),
            (perspective, "7", ["/cameras/0", "7 is not an object", "export"]),
            (perspective, "", ["/nodes/0/camera", "no camera 0", "export"]),
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
            (r#", "zfar": 9"#, "", ["/cameras/0/orthographic", "`zfar` is missing", "export"]),
        ] {
            assert!(orthographic.contains(from));
            let error = at_camera(&orthographic.replace(from, to), "").unwrap_err();
            assert!(pieces.iter().all(|piece| error.contains(piece)), "{to}: {error}");
        }
        let error = at_camera(perspective, r#", "rotation": [0, 0, 0, 0]"#).unwrap_err();
        assert!(error.starts_with("/nodes/0/rotation: ") && error.contains("0, 0, 0, 1"), "{error}");
        let error = at_camera(perspective, r#", "x": 0, "camera": "x""#).unwrap_err();
        assert!(error.starts_with("/nodes/0/camera: the file has no camera \"x\""), "{error}");
    }

    fn members_of(diffuse: Option<[f64; 3]>, exponent: Option<f64>, opacity: Option<f64>) -> String {
        let reflection = FileReflection::Phong { ambient: None, diffuse, specular: None, exponent };
        material_members(
            &FileMaterial {
                name: "x".into(),
                reflection,
                opacity,
                optics: FileOptics::default(),
                textures: 1,
                images: FileImages::default(),
            },
            MaterialTextures::default(),
        )
    }

    #[test]
    fn a_material_is_reported_in_the_terms_of_gltf() {
        assert_eq!(members_of(None, None, None), "");
        // An exponent of 30 means α = 1/4 and a roughness of 1/2.
        assert_eq!(
            members_of(Some([0.5, 0.0, 2.0]), Some(30.0), None),
            ",\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.5,0,1,1],\"metallicFactor\":0,\"roughnessFactor\":0.5}"
        );
        assert_eq!(
            members_of(None, None, Some(0.25)),
            ",\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,1,1,0.25],\"metallicFactor\":0},\"alphaMode\":\"BLEND\""
        );
        assert!(members_of(None, Some(0.0), None).contains("\"roughnessFactor\":1}"));
        let reflection = FileReflection::MetallicRoughness {
            base_colour: [0.1, 0.2, 0.3],
            metallic: 1.0,
            roughness: 0.5,
            unlit: false,
        };
        let gold = FileMaterial {
            name: "gold".into(),
            reflection,
            opacity: None,
            optics: FileOptics::default(),
            textures: 0,
            images: FileImages::default(),
        };
        assert_eq!(
            material_members(&gold, MaterialTextures::default()),
            ",\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.1,0.2,0.3,1],\"metallicFactor\":1,\"roughnessFactor\":0.5}"
        );
    }
}
