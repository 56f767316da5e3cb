//! Scenes that make no sense: the line, the key, what was found and what to do.

use super::from_text;
use crease::raster::{LoadOptions, SceneFile, load};
use std::fs;
use std::path::Path;

fn refused(text: &str) -> String {
    match SceneFile::from_toml(text, Path::new(""), &LoadOptions::default()) {
        Ok(_) => panic!("taken: {text}"),
        Err(error) => error.to_string(),
    }
}

/// A scene that is right, to which faults are added.
const BALL: &str = "[[object]]\nsurface.sphere.radius = 1\n";

#[test]
fn every_fault_is_reported_with_its_line_and_key() {
    assert_eq!(from_text(BALL).objects.len(), 1);
    let faults: &[(&str, &[&str])] = &[
        ("[settings", &["line 3"]),
        ("[settings]\nsize = [640, 480\n", &["line "]),
        ("[settings]\nsize = [1, 2]\nsize = [3, 4]\n", &["line 5"]),
        ("[setting]\n", &["line 3: `setting`"]),
        ("[settings]\n\ncolor = 1\n", &["line 5: `settings.color`"]),
        ("[camera]\neye = [0, 0, 1]\ntarget = [0, 0, 0]\nroll = 3\n", &["line 6: `camera.roll`"]),
        ("[[light.laser]]\n", &["`light.laser`", "line 3"]),
        (
            "[[object]]\nsurface.sphere.radius = 1\nmaterial = { shine = 3 }\n",
            &["line 5: `object.material.shine`"],
        ),
        ("[[object]]\nsurface.cube.size = 1\n", &["line 4: `object.surface.cube`"]),
        ("[settings]\nsize = 7\n", &["line 4: `settings.size`"]),
        ("[settings]\nsize = [640, \"480\"]\n", &["line 4: `settings.size`"]),
        ("[settings]\nsamples = 4.5\n", &["line 4: `settings.samples`"]),
        ("[settings]\ntwo-sided = \"yes\"\n", &["line 4: `settings.two-sided`"]),
        (
            "[camera]\neye = [0, 0]\ntarget = [0, 0, 0]\n",
            &["line 4: `camera.eye`: found a list of length 2, expected a list of length 3"],
        ),
        ("[camera]\neye = [0, 0, 1, 1]\ntarget = [0, 0, 0]\n", &["found a list of length 4"]),
        ("[settings]\nsize = [640, 480, 1]\n", &["line 4: `settings.size`: found a list of length 3"]),
        (
            "[[light.point]]\nposition = [0, 0, 3]\nattenuation = { quadratic = [1, 0, 0, 0] }\n",
            &["line 5: `light.point.attenuation", "found a list of length 4"],
        ),
        (
            "[[object]]\nsurface.sphere.radius = 1\ntessellation = { segments = [3, 4, 5] }\n",
            &["line 5: `object.tessellation.segments`: found a list of length 3"],
        ),
        ("[settings]\nwire = 2\n", &["line 4: `settings.wire`: found integer `2`, expected a table"]),
        ("[settings]\n\"a sequence\" = 2\n", &["unknown key `a sequence`"]),
        ("[camera]\neye = \"a\"\n", &["found string \"a\", expected a list"]),
        ("[settings]\ndepth-cue = -1\n", &["found -1;"]),
        ("[camera]\neye = [0, 0, 1]\n", &["`camera`", "target"]),
        ("[light.ambient]\ncolour = 1\n", &["`light.ambient`: found a table", "write `[[light.ambient]]`"]),
        ("[[light.ambient]]\ncolour = [1, 2]\n", &["line 4: `light.ambient.colour`", "3 linear"]),
        ("[[light.ambient]]\ncolour = \"blue\"\n", &["line 4: `light.ambient.colour`"]),
        ("[settings]\nsize = [0, 480]\n", &["line 4: `settings.size`", "1 to 16384"]),
        ("[settings]\nsize = [640, 99999]\n", &["line 4: `settings.size`", "1 to 16384"]),
        ("[settings]\nsize = [-1, 5]\n", &["line 4: `settings.size`"]),
        ("[[light.ambient]]\ncolour = 1e39\n", &["line 4: `light.ambient.colour`", "3.4e38"]),
        ("[settings]\nsize = [1e3, 3]\n", &["line 4: `settings.size`", "a whole number"]),
        ("[settings]\nsamples = 5\n", &["line 4: `settings.samples`", "1, 4, 8 or 16"]),
        ("[settings]\nbits = 12\n", &["line 4: `settings.bits`", "8 or 16"]),
        (
            "[settings]\nshading = \"toon\"\n",
            &["line 4: `settings.shading`", "toon", "`flat`, `gouraud`, `phong`"],
        ),
        (
            "[settings]\nshading = \"exact\"\n[[object]]\nname = \"leaf\"\npolygons = { vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]], faces = [[0, 1, 2]] }\n",
            &[
                "line 4: `settings.shading`",
                "object 1 (`leaf`)",
                "not an analytic surface",
                "another shading",
            ],
        ),
        ("[settings]\ninterpolation = \"cubic\"\n", &["line 4: `settings.interpolation`"]),
        (
            "[settings]\nterminator = \"kind\"\n",
            &["line 4: `settings.terminator`", "kind", "`smooth`, `hard`, `soft`"],
        ),
        ("[settings]\ntone = \"filmic\"\n", &["line 4: `settings.tone`", "filmic", "`clamp` or `max`"]),
        ("[settings]\ntransfer = \"gamma\"\n", &["line 4: `settings.transfer`"]),
        ("[settings]\nguards = { lowlight = true }\n", &["line 4: `settings.guards.lowlight`", "highlight"]),
        ("[settings]\ndepth-cue = -1\n", &["line 4: `settings.depth-cue`"]),
        ("[settings]\nbackground = nan\n", &["line 4: `settings.background`"]),
        ("[settings]\nbackground = [0.5, -0.1, 0.5]\n", &["line 4: `settings.background`", "negative"]),
        ("[settings]\nbackground = -1\n", &["line 4: `settings.background`", "negative"]),
        ("[settings]\nwire = { colour = [-1, 0, 0] }\n", &["line 4: `settings.wire.colour`", "negative"]),
        ("[settings]\nwire = { width = 0 }\n", &["line 4: `settings.wire.width`"]),
        ("[settings]\nreflection = \"given\"\n", &["colours", "line 1"]),
        ("[camera]\neye = [1, 2, 3]\ntarget = [1, 2, 3]\n", &["line 5: `camera.target`", "eye and target"]),
        ("[camera]\neye = [0, 0, nan]\ntarget = [0, 0, 0]\n", &["line 4: `camera.eye`", "not finite"]),
        ("[camera]\neye = [0, 0, inf]\ntarget = [0, 0, 0]\n", &["line 4: `camera.eye`", "not finite"]),
        ("[camera]\neye = [0, 1, 0]\ntarget = [0, 0, 0]\n", &["`camera`", "up"]),
        ("[camera]\neye = [0, 0, 1]\ntarget = [0, 0, 0]\nangle = 0\n", &["`camera.angle`", "line 6"]),
        ("[camera]\neye = [0, 0, 1]\ntarget = [0, 0, 0]\nangle = 180\n", &["`camera.angle`", "line 6"]),
        ("[camera]\neye = [0, 0, 1]\ntarget = [0, 0, 0]\nheight = 0\n", &["`camera.height`", "line 6"]),
        (
            "[camera]\neye = [0, 0, 1]\ntarget = [0, 0, 0]\nheight = 1\nangle = 3\n",
            &["`camera", "angle and height are both given"],
        ),
        ("[camera]\neye = [0, 0, 1]\ntarget = [0, 0, 0]\nnear = -1\n", &["`camera.near`", "line 6"]),
        ("[[light.directional]]\ntowards = [0, 0, 0]\n", &["line 4: `light.directional.towards`"]),
        ("[[light.directional]]\ntowards = [0, 0, nan]\n", &["line 4: `light.directional.towards`"]),
        ("[[light.directional]]\ncolour = 1\n", &["`light.directional`", "towards"]),
        ("[[light.ambient]]\ncolour = -1\n", &["line 4: `light.ambient.colour`"]),
        ("[[light.point]]\nposition = [0, 0, 5, -1]\n", &["line 4: `light.point.position`", "w is -1"]),
        ("[[light.point]]\nposition = [0, 0]\n", &["line 4: `light.point.position`", "3, or 4"]),
        ("[[light.point]]\nposition = [0, 0, 0, 0]\n", &["line 4: `light.point.position`"]),
        (
            "[[light.point]]\nposition = [0, 0, 3]\nattenuation = \"cubic\"\n",
            &["line 5: `light.point.attenuation`"],
        ),
        (
            "[[light.point]]\nposition = [0, 0, 3]\nattenuation = { offset = -1 }\n",
            &["line 5: `light.point.attenuation"],
        ),
        (
            "[[light.point]]\nposition = [0, 0, 3]\nattenuation = { quadratic = [0, 0, 0] }\n",
            &["line 5: `light.point.attenuation"],
        ),
        ("[[light.spot]]\nposition = [0, 0, 3]\naxis = [0, 0, 0]\n", &["line 5: `light.spot.axis`"]),
        (
            "[[light.spot]]\nposition = [0, 0, 3]\naxis = [0, 0, -1]\ncut-off = 200\n",
            &["line 6: `light.spot.cut-off`"],
        ),
        (
            "[[light.spot]]\nposition = [0, 0, 3]\naxis = [0, 0, -1]\ncut-off = 20\nsoft-edge = 30\n",
            &["line 7: `light.spot.soft-edge`"],
        ),
        (
            "[[light.spot]]\nposition = [0, 0, 3]\naxis = [0, 0, -1]\nexponent = -2\n",
            &["line 6: `light.spot.exponent`"],
        ),
        (
            "[[light.rectangle]]\ncentre = [0, 3, 0]\nu = [1, 0, 0]\nv = [2, 0, 0]\n",
            &["line 6: `light.rectangle.v`"],
        ),
        (
            "[[light.disc]]\ncentre = [0, 3, 0]\nnormal = [0, -1, 0]\nradius = 0\n",
            &["line 6: `light.disc.radius`"],
        ),
        (
            "[[object]]\nsurface.sphere.radius = 1\nmaterial = { exponent = -3 }\n",
            &["line 5: `object.material.exponent`"],
        ),
        (
            "[[object]]\nsurface.sphere.radius = 1\nmaterial = { diffuse = -0.5 }\n",
            &["line 5: `object.material.diffuse`"],
        ),
        (
            "[[object]]\nsurface.sphere.radius = 1\n[object.material]\nspecular = { k = 1 }\n",
            &["line 6: `object.material.specular", "colour"],
        ),
        ("[[object]]\nsurface.sphere.radius = 1\nmaterial.reflection = \"given\"\n", &["colours", "`object"]),
        (
            "[[object]]\nsurface.sphere.radius = 1\nmaterial.colour = \"#12345\"\n",
            &["line 5: `object.material.colour`"],
        ),
        ("[[object]]\nsurface = { sphere = 1 }\n", &["line 4: `object.surface.sphere`", "expected members"]),
        ("[[object]]\nsurface = \"sphere\"\n", &["line 4: `object.surface`", "expected members"]),
        (
            "[[light.point]]\nposition = [0, 0, 1]\nattenuation = \"offset\"\n",
            &["line 5: `light.point.attenuation`", "expected a value"],
        ),
        (
            "[settings]\ndepth-cue = 1\n[camera]\neye = [0, 0, 1]\ntarget = [0, 0, 0]\nheight = 2\n",
            &["line 4: `settings.depth-cue`", "parallel"],
        ),
        ("[[object]]\nname = \"nothing\"\n", &["line 3: `object`", "exactly one of"]),
        ("[[object]]\nmesh = \"a.obj\"\nsurface.sphere.radius = 1\n", &["`object`", "exactly one of"]),
        ("[[object]]\nmesh = \"nowhere.obj\"\n", &["line 4: `object.mesh`", "nowhere.obj", "not found"]),
        ("[[object]]\nmesh = \"https://example.org/a.obj\"\n", &["line 4: `object.mesh`", "URL"]),
        ("[[object]]\nmesh = \"../Cargo.toml\"\n", &["line 4: `object.mesh`"]),
        ("[[object]]\nmesh = \"Cargo.toml\"\n", &["line 4: `object.mesh`"]),
        ("[[object]]\nmesh = \"src\"\n", &["line 4: `object.mesh`"]),
        ("[[object]]\nsurface.sphere.radius = 0\n", &["line 4: `object.surface"]),
        ("[[object]]\nsurface.sphere.radius = nan\n", &["line 4: `object.surface`", "radius is NaN"]),
        ("[[object]]\nsurface.torus = { major = 1, minor = 2 }\n", &["line 4: `object.surface"]),
        ("[[object]]\nsurface.teapot = {}\n", &["line 4: `object.surface", "tessellation"]),
        (
            "[[object]]\nsurface.sphere.radius = 1\ntessellation.segments = [1, 1]\n",
            &["line 5: `object.tessellation"],
        ),
        (
            "[[object]]\nsurface.sphere.radius = 1\ntessellation.segments = [100000, 100000]\n",
            &["line 5: `object.tessellation"],
        ),
        (
            "[[object]]\nsurface.sphere.radius = 1\ntessellation.pattern = \"hexagons\"\n",
            &["line 5: `object.tessellation.pattern`"],
        ),
        (
            "[[object]]\nsurface.sphere.radius = 1\ntransform = [{ scale = 0 }]\n",
            &["line 5: `object.transform`", "flattens"],
        ),
        (
            "[[object]]\nsurface.sphere.radius = 1\ntransform = [{ scale = 1e200 }, { scale = 1e200 }]\n",
            &["line 5: `object.transform`"],
        ),
        (
            "[[object]]\nsurface.sphere.radius = 1\ntransform = [{ shear = 3 }]\n",
            &["line 5: `object.transform"],
        ),
        (
            "[[object]]\nsurface.sphere.radius = 1\nnormals = \"smooth\"\n",
            &["line 5: `object.normals`", "smooth", "`given` or `computed`"],
        ),
        (
            "[[object]]\npolygons = { vertices = [[0, 0, 0]], faces = [] }\n",
            &["line 4: `object.polygons.faces`"],
        ),
        (
            "[[object]]\npolygons = { vertices = [[0, 0, 0]], faces = [[0, 1, 2]] }\n",
            &["line 4: `object.polygons.faces`"],
        ),
        (
            "[[object]]\npolygons = { vertices = [[0, 0, 0], [1, 0, 0]], faces = [[0, 1]] }\n",
            &["line 4: `object.polygons.faces`"],
        ),
        (
            "[[object]]\n[object.polygons]\nvertices = [[0, 0, 0], [1, 0, 0], [0, 1, inf]]\nfaces = [[0, 1, 2]]\n",
            &["line 5: `object.polygons.vertices`"],
        ),
        (
            "[[object]]\n[object.polygons]\nvertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\nfaces = [[0, 1, 2]]\ncolours = [[1, 1, 1], [1, 1, -1], [1, 1, 1]]\n",
            &["line 7: `object.polygons.colours", "negative"],
        ),
        (
            "[[object]]\n[object.polygons]\nvertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\nfaces = [[0, 1, 2]]\ncolours = [[1, 1, 1]]\n",
            &["line 7: `object.polygons.colours`", "1 colours for 3"],
        ),
        (
            "[[object]]\n[object.polygons]\nvertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\nfaces = [[0, 1, 2]]\nnormals = [[1, 1, 1]]\n",
            &["line 7: `object.polygons.normals`"],
        ),
        (
            "[[object]]\n[object.polygons]\nvertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\nfaces = [[0, 1, 2]]\nnormals = [[0, 0, 1], [0, 0, 1], [0, 0, 0]]\n",
            &["line 7: `object.polygons.normals`"],
        ),
    ];
    let mut wrong = Vec::new();
    for (text, pieces) in faults {
        let error = refused(&format!("{BALL}{text}"));
        println!("{text:?}\n    {error}");
        if !pieces.iter().all(|piece| error.contains(piece)) {
            wrong.push(format!("{text}\n    gave {error}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn an_empty_scene_has_nothing_to_draw() {
    for text in ["", "# nothing\n", "[settings]\nsize = [4, 4]\n"] {
        assert!(refused(text).contains("add an [[object]]"), "{}", refused(text));
    }
}

/// Faults of a mesh that a scene names are reported at the scene's key, with the place in the mesh.
#[test]
fn faults_of_meshes_are_reported_where_the_scene_names_them() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("broken.obj"), "v 0 0 0\nf 1 2 3\n").unwrap();
    fs::write(folder.path().join("points.obj"), "v 0 0 0\n").unwrap();
    fs::write(
        folder.path().join("circle.gltf"),
        r#"{"asset": {"version": "2.0"}, "nodes": [{"children": [1]}, {"children": [0]}]}"#,
    )
    .unwrap();
    for (name, pieces) in
        [("broken.obj", &["line 2"][..]), ("points.obj", &["no faces"]), ("circle.gltf", &["/nodes/"])]
    {
        let path = folder.path().join("scene.toml");
        fs::write(&path, format!("{BALL}[[object]]\nmesh = \"{name}\"\n")).unwrap();
        let error = load(&path, None, &LoadOptions::default()).unwrap_err().to_string();
        assert!(error.starts_with(&format!("line 4: `object.mesh`: {name}: ")), "{error}");
        assert!(pieces.iter().all(|piece| error.contains(piece)), "{error}");
    }
}

/// Files that are no scenes at all.
#[test]
fn files_that_are_no_text_are_reported() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    let error = load(&path, None, &LoadOptions::default()).unwrap_err().to_string();
    assert!(error.contains("no such file"), "{error}");
    fs::write(&path, b"[settings]\nsize = [1, 1] # \xff\n").unwrap();
    let error = load(&path, None, &LoadOptions::default()).unwrap_err().to_string();
    assert!(error.starts_with("line 2: ") && error.contains("UTF-8"), "{error}");
    assert!(load(folder.path(), None, &LoadOptions::default()).unwrap_err().to_string().contains("folder"));
}

/// The nesting of tables is bounded, so that no text overflows the stack.
#[test]
fn deep_nesting_is_an_error() {
    let deep = format!("a = {}{}", "[".repeat(100_000), "]".repeat(100_000));
    assert!(refused(&deep).starts_with("line 1: "));
    let dotted = format!("{}a = 1", "a.".repeat(20_000));
    assert!(refused(&dotted).starts_with("line 1: "));
}

/// The time of reading is linear in the length of the text, also with an error in the middle.
#[test]
fn large_scenes_are_read_in_good_time() {
    let text = BALL.repeat(20_000);
    assert_eq!(from_text(&text).objects.len(), 20_000);
    assert!(refused(&format!("{text}[settings]\nbits = 9\n")).starts_with("line 40002: `settings.bits`"));
}
