//! glTF files as scenes: what their nodes, cameras, lights and materials become.

use super::scene;
use crease::io::{Format, ReadError, ReadOptions, read_bytes};
use crease::num::Radians;
use crease::raster::{LoadOptions, Projection, SceneFile, probe, render};
use crease::shade::{Attenuation, Light, Material, Reflectance, Reflection};
use glam::{DMat4, DVec3};

/// A square of two units in the plane z = 0, seen by an orthographic camera from z = 3; the middle pixel of a picture is the
/// origin. `nodes` follow the square's and the camera's, `material` and `lights` fill in.
fn square(nodes: &str, material: &str, lights: &str) -> Result<SceneFile, ReadError> {
    from_text(square_text(nodes, material, lights))
}

fn from_text(text: String) -> Result<SceneFile, ReadError> {
    let loaded = read_bytes(text.into_bytes(), Some(Format::Gltf), None, &ReadOptions::default())?;
    SceneFile::from_loaded(loaded, &LoadOptions::default())
}

fn square_text(nodes: &str, material: &str, lights: &str) -> String {
    use base64::Engine;
    let positions: [f32; 12] = [-1.0, -1.0, 0.0, 1.0, -1.0, 0.0, 1.0, 1.0, 0.0, -1.0, 1.0, 0.0];
    let mut bytes: Vec<u8> = positions.iter().flat_map(|x| x.to_le_bytes()).collect();
    bytes.extend([0, 1, 2, 0, 2, 3_u8]);
    let data = base64::engine::general_purpose::STANDARD.encode(bytes);
    let count = nodes.matches("\"node\"").count() + 2;
    let all: Vec<String> = (0..count).map(|node| node.to_string()).collect();
    format!(
        r#"{{"asset": {{"version": "2.0"}}, "scene": 0, "scenes": [{{"nodes": [{all}]}}],
        "nodes": [{{"mesh": 0}}, {{"camera": 0, "translation": [0, 0, 3]}}{nodes}],
        "cameras": [{{"type": "orthographic", "orthographic": {{"xmag": 1, "ymag": 1.5, "znear": 0, "zfar": 9}}}}],
        "extensionsUsed": ["KHR_lights_punctual", "KHR_materials_unlit"],
        "extensions": {{"KHR_lights_punctual": {{"lights": [{lights}]}}}},
        "materials": [{{"name": "m", {material}}}],
        "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}, "indices": 1, "material": 0}}]}}],
        "accessors": [{{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [-1, -1, 0], "max": [1, 1, 0]}},
            {{"bufferView": 1, "componentType": 5121, "count": 6, "type": "SCALAR"}}],
        "bufferViews": [{{"buffer": 0, "byteLength": 48}}, {{"buffer": 0, "byteOffset": 48, "byteLength": 6}}],
        "buffers": [{{"byteLength": 54, "uri": "data:application/octet-stream;base64,{data}"}}]}}"#,
        all = all.join(",")
    )
}

const MATTE: &str =
    r#""pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 0.1, 1], "metallicFactor": 0}"#;

/// The colour in the middle of the picture.
fn middle(mut file: SceneFile) -> [f64; 3] {
    file.settings.size = [31, 31];
    let scene = file.scene();
    let point = probe(&scene, &file.settings, [15, 15], 0).unwrap().unwrap();
    assert!(DVec3::from(point.position).length() < 1e-12, "{point:?}");
    point.colour().to_array()
}

#[test]
fn the_example_has_its_camera_lights_and_materials() {
    let file = scene("stage.gltf");
    let camera = file.camera.unwrap();
    assert_eq!(camera.eye, DVec3::new(0.0, 2.4, 7.0));
    assert_eq!(camera.projection, Projection::Perspective(Radians(0.55)));
    assert_eq!(camera.near, 0.1);
    // It looks down by 17°: a quaternion of ten digits.
    let forward = camera.axes().unwrap()[2];
    assert!((libm::asin(-forward.y).to_degrees() - 17.0).abs() < 1e-6, "{forward}");
    let names: Vec<&str> = file.objects.iter().map(|object| &*object.name).collect();
    assert_eq!(names, ["floor", "red", "gold", "mirrored", "on top"]);
    // The child of the mirrored node stands on top of it: 0.4 + 0.4·1.5.
    let at = file.objects[4].transform.w_axis.truncate();
    assert!(at.distance(DVec3::new(1.4, 1.0, 0.2)) < 1e-12, "{at}");
    let lights = file.lights.clone().unwrap();
    let [
        Light::Directional { towards, colour },
        Light::Point { position, attenuation, .. },
        Light::Spot { cone, .. },
    ] = lights[..]
    else {
        panic!("{lights:?}")
    };
    assert_eq!(colour.to_array(), [1.0, 0.96, 0.9].map(|c| c * (2.0 * std::f64::consts::FRAC_1_PI)));
    assert!(towards.y > 0.7 && towards.z > 0.6, "{towards}");
    assert_eq!((position, attenuation), (DVec3::new(-3.0, 2.0, 1.0), Attenuation::InverseSquare));
    assert!(cone.axis.distance(DVec3::NEG_Y) < 1e-9 && cone.cut_off == Radians(0.35));
    // Red plastic, whose diffuse reflection is what its highlight leaves: 1 − 0.04 · 0.84 · (2/0.4⁴ + 6)/8.
    let red = file.objects[1].material.diffuse.merged();
    assert!((red.r - 0.646_675).abs() < 1e-9 && (red.g / red.r - 0.12 / 0.7).abs() < 1e-9, "{red:?}");
    // Mirrored or not, every box is seen from outside.
    let image = render(&file.scene(), &file.settings).unwrap();
    assert!(image.statistics.covered_pixels > 50_000);
}

/// As the standard has it, a white surface under a light of 1 lux at N·L shows N·L/π.
#[test]
fn a_directional_light_is_in_lux() {
    let sun = r#"{"type": "directional", "intensity": 3.141592653589793}"#;
    // Turned by 60° about y, so that N·L is a half.
    let node = r#", {"name": "node", "rotation": [0, 0.5, 0, 0.8660254037844386],
        "extensions": {"KHR_lights_punctual": {"light": 0}}}"#;
    let mut file = square(node, MATTE, sun).unwrap();
    file.objects[0].material.specular = Reflectance::NONE;
    let expected = [0.25, 0.125, 0.05];
    for (got, expected) in middle(file).into_iter().zip(expected) {
        // The intensity passes through single precision.
        assert!((got - expected).abs() < 1e-6 * expected, "{got} is not {expected}");
    }
}

#[test]
fn a_point_light_is_in_candela_and_fades_by_the_square() {
    let lamp = |range: &str| format!(r#"{{"type": "point", "intensity": 3.141592653589793{range}}}"#);
    let node = r#", {"name": "node", "translation": [0, 0, 2], "extensions": {"KHR_lights_punctual": {"light": 0}}}"#;
    let shown = |range: &str| {
        let mut file = square(node, MATTE, &lamp(range)).unwrap();
        file.objects[0].material.specular = Reflectance::NONE;
        middle(file)[0]
    };
    assert!((shown("") - 0.5 / 4.0).abs() < 1e-7);
    // (1 − (d/r)⁴)/d²
    assert!((shown(r#", "range": 4"#) - 0.5 / 4.0 * (15.0 / 16.0)).abs() < 1e-7);
    assert_eq!(shown(r#", "range": 1.5"#), 0.0);
}

#[test]
fn metal_and_roughness_become_a_highlight() {
    let material = |base: &str, metallic: f64, roughness: f64| -> Material {
        let text = format!(
            r#""pbrMetallicRoughness": {{"baseColorFactor": {base}, "metallicFactor": {metallic}, "roughnessFactor": {roughness}}}"#
        );
        square("", &text, "").unwrap().objects[0].material
    };
    let merged = |reflectance: Reflectance| reflectance.merged().to_array();
    let near = |got: Reflectance, expected: [f64; 3]| {
        let is_near = |(got, expected): (f64, f64)| (got - expected).abs() < 1e-15;
        assert!(merged(got).into_iter().zip(expected).all(is_near), "{got:?}, not {expected:?}");
    };
    // α = 1/4 gives n = 30 and K_s = 0.04 · 3/4 · 38/8 = 0.1425.
    let plastic = material("[0.5, 0.25, 0.125, 1]", 0.0, 0.5);
    assert_eq!((plastic.exponent, plastic.reflection), (30.0, Reflection::Blinn));
    near(plastic.specular, [0.1425; 3]);
    near(plastic.diffuse, [0.5, 0.25, 0.125]);
    // Metal: a highlight of its own hue, half as bright as white, and for its surroundings what that leaves of 9/16.
    let gold = material("[1, 0.75, 0.25, 1]", 1.0, 0.5);
    near(gold.specular, [0.5, 0.375, 0.125]);
    near(gold.diffuse, [0.5, 0.375, 0.125]);
    // The roughest scatters nearly as if it were matte, the smoothest has a highlight that can still be drawn.
    let rough = material("[0.5, 0.5, 0.5, 1]", 1.0, 1.0);
    near(rough.diffuse, [0.375; 3]);
    near(rough.specular, [0.0; 3]);
    assert_eq!(rough.exponent, 1.0);
    assert_eq!(material("[1, 1, 1, 1]", 0.0, 0.0).exponent, 1e4);
    assert_eq!(merged(material("[0, 0, 0, 1]", 1.0, 0.5).specular), [0.0; 3]);
    // Never more light than there is.
    for metallic in [0.0, 0.3, 1.0] {
        for roughness in [0.0, 0.1, 0.4, 0.7, 1.0] {
            let white = material("[1, 1, 1, 1]", metallic, roughness);
            assert!(white.gain().is_none(), "{metallic} {roughness}: {white:?}");
            assert!(merged(white.diffuse)[0] >= 0.25 && white.exponent >= 1.0);
        }
    }
}

/// The default material of the standard, metal of full roughness, shows the shape.
#[test]
fn the_standards_own_material_shows_shape() {
    for material in ["", r#""pbrMetallicRoughness": {"roughnessFactor": 0.5}"#] {
        let mut file = square("", if material.is_empty() { r#""extras": 1"# } else { material }, "").unwrap();
        (file.camera, file.lights) = (None, None);
        file.settings.size = [64, 48];
        let mut seen = std::collections::BTreeSet::new();
        for degrees in 0..18 {
            let turned = DMat4::from_rotation_y(f64::from(5 * degrees - 45).to_radians());
            file.objects[0].transform = turned;
            let picture = render(&file.scene(), &file.settings).unwrap();
            let pixel = picture.pixel(32, 24).unwrap();
            assert!(pixel[0] < 255, "{material}: white at {degrees}");
            seen.insert(pixel[0]);
        }
        assert!(seen.len() >= 10, "{material}: {seen:?}");
    }
}

#[test]
fn unlit_materials_show_their_colour() {
    let file =
        square("", &format!("{MATTE}, \"extensions\": {{\"KHR_materials_unlit\": {{}}}}"), "").unwrap();
    assert!(file.objects[0].given);
    for (got, expected) in middle(file).into_iter().zip([0.5, 0.25, 0.1]) {
        assert!((got - expected).abs() < 1e-12);
    }
}

#[test]
fn without_lights_and_camera_it_is_framed_and_lit_by_itself() {
    let mut file = square("", MATTE, "").unwrap();
    assert!(file.lights.is_none() && file.camera.is_some());
    assert_eq!(file.scene().lights.len(), 2);
    file.camera = None;
    file.settings.size = [40, 30];
    let covered = render(&file.scene(), &file.settings).unwrap().statistics.covered_pixels;
    assert!(covered > 100, "{covered}");
}

/// The first camera is taken, and what cannot be used is omitted, with a note on each.
#[test]
fn what_is_not_taken_is_reported() {
    let nodes = r#", {"name": "node", "camera": 0}, {"name": "node", "mesh": 0, "scale": [1, 0, 1]},
        {"name": "node", "extensions": {"KHR_lights_punctual": {"light": 0}}}"#;
    let file =
        square(nodes, MATTE, r#"{"type": "spot", "spot": {"innerConeAngle": 0.5, "outerConeAngle": 0.25}}"#);
    let file = file.unwrap();
    assert!(file.lights.is_none() && file.objects.len() == 1);
    let said = file.notes.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n");
    for piece in ["the first of 2 cameras", "flattens its mesh", "a light is omitted: light 0"] {
        assert!(said.contains(piece), "{said}");
    }
}

/// An invalid camera is an error if it would be used, and a note otherwise. No other camera replaces it.
#[test]
fn cameras_that_are_none_are_refused_with_their_place() {
    let lens = r#""orthographic", "orthographic": {"xmag": 1, "ymag": 1.5, "znear": 0, "zfar": 9}"#;
    for (faulty, field) in [
        (lens.replace(r#""xmag": 1"#, r#""xmag": 0"#), "`xmag` is 0"),
        (r#""perspective", "perspective": {"yfov": 3.2, "znear": 0.1}"#.to_owned(), "`yfov` is 3.2"),
        (r#""perspective", "perspective": {"znear": 0.1}"#.to_owned(), "`yfov` is missing"),
        (r#""perspective""#.to_owned(), "`perspective` is missing"),
    ] {
        let text = square_text("", MATTE, "");
        assert!(text.contains(lens));
        let wrong = text.replace(lens, &faulty);
        let error = from_text(wrong.clone()).unwrap_err().to_string();
        assert!(
            error.contains("/cameras/0")
                && error.contains(field)
                && error.contains("remove the camera from the file"),
            "{error}"
        );
        let is_reported = |file: &SceneFile| {
            file.notes.iter().any(|note| note.text.contains(field) && note.text.contains("omitted"))
        };
        let loaded = read_bytes(wrong.into_bytes(), Some(Format::Gltf), None, &ReadOptions::default());
        let elsewhere = LoadOptions { from_elsewhere: true, ..LoadOptions::default() };
        let file = SceneFile::from_loaded(loaded.unwrap(), &elsewhere).unwrap();
        assert!(file.camera.is_none() && is_reported(&file), "{:?}", file.notes);
        // A camera that is not used does no harm.
        let two = text.replace(lens, &format!(r#"{lens}}}, {{"type": {faulty}"#));
        let two = two.replace(r#""translation": [0, 0, 3]}"#, r#""translation": [0, 0, 3]}, {"camera": 1}"#);
        let two = two.replace(r#""nodes": [0,1]"#, r#""nodes": [0,1,2]"#);
        let file = from_text(two).unwrap();
        assert!(file.camera.is_some() && is_reported(&file), "{:?}", file.notes);
    }
    // A finite position that is too far away to see anything.
    let far = square_text("", MATTE, "").replace("[0, 0, 3]", "[0, 0, 1e200]");
    let error = from_text(far).unwrap_err().to_string();
    assert!(error.contains("/cameras/0") && error.contains("invalid camera"), "{error}");
}

/// The scale of a camera's node does not affect the view (glTF 2.0, §3.10.2): neither mirroring nor a scale of zero rotates it.
#[test]
fn a_cameras_scale_is_ignored() {
    let text = square_text("", MATTE, "");
    let seen = |nodes: &str| {
        let text = text.replace(r#"{"camera": 0, "translation": [0, 0, 3]}"#, nodes);
        from_text(text).map(|file| file.camera.unwrap())
    };
    let (place, turn) = (r#""translation": [0, 0, 3]"#, r#""rotation": [0, 0.6, 0, 0.8]"#);
    let of_node = |members: &str| seen(&format!(r#"{{"camera": 0, {place}{members}}}"#)).unwrap();
    let (plain, turned) = (of_node(""), of_node(&format!(", {turn}")));
    let forward = DVec3::new(-0.96, 0.0, -0.28);
    assert!(turned.axes().unwrap()[2].distance(forward) < 1e-15, "{turned:?}");
    for scale in
        [[2.0, 2.0, 2.0], [1.0, 1.0, -1.0], [-1.0, 1.0, 1.0], [1.0, -1.0, 1.0], [0.0; 3], [1.0, 1.0, 0.0]]
    {
        assert_eq!(of_node(&format!(r#", "scale": {scale:?}"#)), plain, "{scale:?}");
        assert_eq!(of_node(&format!(r#", "scale": {scale:?}, {turn}"#)), turned, "{scale:?}");
        // The scale of a parent node moves the camera, like everything below it, and does not rotate it.
        let below = format!(
            r#"{{{place}, "scale": {scale:?}, "children": [2]}}, {{"camera": 0, "translation": [1, 0, 0], {turn}}}"#
        );
        let below = seen(&below).unwrap();
        assert_eq!(below.eye, DVec3::new(scale[0], 0.0, 3.0));
        assert!(below.axes().unwrap()[2].distance(forward) < 1e-15, "{scale:?}: {below:?}");
        assert_eq!(below.projection, plain.projection);
    }
}

/// A matrix determines the rotation, unless it has no inverse.
#[test]
fn a_cameras_matrix_is_decomposed() {
    let text = square_text("", MATTE, "");
    let seen = |columns: [[f64; 3]; 3]| {
        let [[a, b, c], [d, e, f], [g, h, i]] = columns;
        let matrix = format!("{:?}", [a, b, c, 0.0, d, e, f, 0.0, g, h, i, 0.0, 0.0, 0.0, 3.0, 1.0]);
        let text = text.replace(r#""translation": [0, 0, 3]"#, &format!(r#""matrix": {matrix}"#));
        from_text(text).map(|file| file.camera.unwrap().axes().unwrap())
    };
    let turn = [[-0.28, 0.0, -0.96], [0.0, 1.0, 0.0], [0.96, 0.0, -0.28]];
    for scale in [[1.0, 1.0, 1.0], [2.0, 3.0, 0.5], [1e-200, 1.0, 1.0], [-1.0, 1.0, 1.0]] {
        let scaled = [0, 1, 2].map(|k| turn[k].map(|component| component * scale[k]));
        let [right, up, forward] = seen(scaled).unwrap();
        assert!(right.distance(DVec3::from(turn[0])) < 1e-15, "{scale:?}: {right}");
        assert!(up.distance(DVec3::Y) < 1e-15 && forward.distance(-DVec3::from(turn[2])) < 1e-15);
    }
    for flat in
        [[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0; 3]], [[1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 0.0, 1.0]]]
    {
        let error = seen(flat).unwrap_err().to_string();
        assert!(error.contains("/nodes/1/matrix") && error.contains("without an inverse"), "{error}");
    }
}

/// Nothing is cut off far away; a note reports if the file asks for that.
#[test]
fn a_far_distance_that_would_cut_is_reported() {
    let notes = |far: &str, options: &LoadOptions| {
        let text = square_text("", MATTE, "").replace("\"zfar\": 9", &format!("\"zfar\": {far}"));
        let loaded = read_bytes(text.into_bytes(), Some(Format::Gltf), None, &ReadOptions::default());
        let file = SceneFile::from_loaded(loaded.unwrap(), options).unwrap();
        file.notes.iter().map(ToString::to_string).filter(|note| note.contains("zfar")).collect::<Vec<_>>()
    };
    let own = LoadOptions::default();
    let found = notes("2.5", &own);
    let [note] = &found[..] else { panic!("{found:?}") };
    assert!(
        note.contains("/cameras/0") && note.contains("`zfar` of 2.5") && note.contains("distance of 3"),
        "{note}"
    );
    assert!(notes("3", &own).is_empty() && notes("9", &own).is_empty());
    assert!(notes("2.5", &LoadOptions { from_elsewhere: true, ..own }).is_empty());
}

/// Meshes that no node shows are drawn at their own positions, and a note gives the reason.
#[test]
fn meshes_without_nodes_are_drawn_as_they_stand() {
    let text = square_text("", MATTE, "").replace(r#"[{"mesh": 0}, "#, r#"[{"name": "empty"}, "#);
    let file = from_text(text).unwrap();
    assert_eq!((file.objects.len(), file.objects[0].transform), (1, DMat4::IDENTITY));
    assert!(file.notes.iter().any(|note| note.text.contains("no node of the scene")), "{:?}", file.notes);
}

#[test]
fn nodes_in_a_circle_are_refused_with_their_place() {
    let nodes = r#", {"name": "node", "children": [3]}, {"name": "node", "children": [2]}"#;
    let error = square(nodes, MATTE, "").unwrap_err().to_string();
    assert!(error.contains("/nodes/") && error.contains("own"), "{error}");
}

/// A scene file that refers to a glTF file takes its objects at their places, under its own transform.
#[test]
fn scenes_may_refer_to_gltf_files() {
    let (whole, own) = (scene("stage.toml"), scene("stage.gltf"));
    assert_eq!(whole.meshes.len(), own.meshes.len(), "read once");
    assert_eq!(whole.objects.len(), 2 * own.objects.len());
    let (first, again) = whole.objects.split_at(own.objects.len());
    assert_eq!(first, own.objects);
    let moved = DMat4::from_translation(DVec3::new(-0.9, 0.05, 1.4))
        * DMat4::from_scale(DVec3::new(-0.25, 0.25, 0.25));
    for (object, own) in again.iter().zip(&own.objects) {
        assert_eq!((&*object.name, object.shape), ("model", own.shape));
        assert!(object.transform.abs_diff_eq(moved * own.transform, 1e-15));
        assert_eq!(object.material.exponent, 40.0);
    }
    assert_eq!(whole.lights.unwrap().len(), 2);
}
