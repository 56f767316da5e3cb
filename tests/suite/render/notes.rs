//! Notes on pictures, and options that change values of a scene.

use super::{BEFORE, SQUARE, gear, picture, pixels_unlike, report, square, with};
use crate::cli::{code, folder, path, text};

/// The texts of all notes.
pub(super) fn notes(args: &[impl AsRef<str>]) -> String {
    let report = report(args);
    report["notes"].as_array().unwrap().iter().map(|note| format!("{}\n", note["text"])).collect()
}

/// An empty picture is no error, but its likely cause is reported.
#[test]
fn an_empty_picture_has_a_reason() {
    let ball = "[[object]]\nsurface.sphere.radius = 1\n";
    let work = folder(&[
        ("flat.obj", "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n"),
        ("one.obj", "v 3 3 3\nv 3 3 3\nv 3 3 3\nf 1 2 3\n"),
        ("ball.toml", ball),
        (
            "away.toml",
            &format!(
                "{ball}transform = [{{ translate = [0, 0, 1e9] }}]\n[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\n"
            ),
        ),
    ]);
    let at = |name: &str| path(work.path().join(name));
    let (_folder, square) = square();
    let table: &[(&[&str], &str)] = &[
        (&[&at("flat.obj")], "no face has a visible area; `crease inspect` reports"),
        (&[&at("one.obj")], "nothing is visible: "),
        (&[&square, "--camera", "eye=0,0,5 target=0,0,9"], "its near distance; --camera 'eye="),
        (&[&square, "--camera", "eye=0,0,5 target=9,0,5"], "everything is outside the picture"),
        (
            &[&square, "--camera", "eye=0,0,-5 target=0,0,0", "--cull", "back"],
            "the culled side; --cull none draws all faces",
        ),
        (&[&square, "--camera", "eye=0,0,50000 target=0,0,0 angle=2"], "smaller than the distance"),
        (&[&at("away.toml")], "behind the camera"),
        (&[&at("ball.toml"), "--shading", "wireframe"], "no edges to draw"),
        (&[&at("ball.toml"), "--overlay", "wire"], "no edges to draw"),
    ];
    for (args, expected) in table {
        let found = notes(&with(args, &["--size", "40x30"]));
        assert!(found.contains(expected), "{args:?}: no {expected:?} in {found:?}");
    }
    for args in
        [with(&[square.as_str()], &BEFORE), gear().to_vec(), with(&[at("ball.toml")], &["--size", "40x30"])]
    {
        assert!(!notes(&args).contains("seen") && !notes(&args).contains("missing"), "{args:?}");
    }
}

/// Of similar notes only the first names its place; with `-v` all of them do.
#[test]
fn all_places_of_a_note_are_named_if_asked_for() {
    let work = folder(&[("odd.obj", &format!("{SQUARE}{}", "odd\n".repeat(3)))]);
    let first = SQUARE.lines().count() + 1;
    let said = |more: &[&str]| {
        let args = with(&with(&[path(work.path().join("odd.obj"))], &BEFORE), more);
        let output = super::render(with(&args, &["-o", "-"]));
        assert_eq!(code(&output), 0, "{}", text(&output.stderr));
        text(&output.stderr).to_owned()
    };
    let alike = format!("line {first}: the unknown statement `odd` was ignored (and 2 more like it");
    let (brief, all) = (said(&[]), said(&["-v"]));
    assert!(brief.contains(&format!("{alike})")), "{brief}");
    assert!(all.contains(&format!("{alike}: line {}, line {})", first + 1, first + 2)), "{all}");
}

/// `--force` omits what makes a file unreadable, as it does in `normals`, and the message that names it is right.
#[test]
fn faces_without_a_place_are_left_out_by_force() {
    let work = folder(&[("nan.obj", &format!("{SQUARE}v nan 0 0\nf 1 2 5\n"))]);
    let args = with(&[path(work.path().join("nan.obj"))], &BEFORE);
    let refused = super::render(with(&args, &["-o", "-"]));
    assert!(code(&refused) == 3 && text(&refused.stderr).contains("--force"), "{}", text(&refused.stderr));
    assert_eq!(report(&with(&args, &["--force"]))["drawings"][0]["covered_pixels"], 1600);
}

/// A scene has no `--format` for its meshes, so the help does not suggest it.
#[test]
fn advice_within_a_scene_can_be_followed() {
    let work = folder(&[("a.toml", "[[object]]\nmesh = \"a.dat\"\n"), ("a.dat", "what is this\n")]);
    let output = super::render([path(work.path().join("a.toml")).as_str(), "-o", "-"]);
    let message = text(&output.stderr);
    assert!(code(&output) == 3 && message.contains(".obj") && !message.contains("--format"), "{message}");
    // A folder is reported as a folder, not as a missing file.
    let work = folder(&[("a.toml", "[[object]]\nmesh = \"sub\"\n"), ("sub/b.obj", SQUARE)]);
    let output = super::render([path(work.path().join("a.toml")).as_str(), "-o", "-"]);
    let message = text(&output.stderr);
    assert!(code(&output) == 3 && message.contains("line 2") && message.contains("is a folder"), "{message}");
}

/// A command with a camera of its own does not need that of the file.
#[test]
fn a_files_camera_that_is_none_is_an_error_unless_it_is_replaced() {
    let stage = std::fs::read_to_string(crate::cli::data("scenes/stage.gltf")).unwrap();
    let work = folder(&[("a.gltf", &stage.replace("\"yfov\": 0.55,", "\"yfov\": 3.2,"))]);
    let args = with(&[path(work.path().join("a.gltf"))], &["--size", "40x30"]);
    let refused = super::render(with(&args, &["-o", "-"]));
    let message = text(&refused.stderr);
    for piece in ["/cameras/0/perspective/yfov", "`yfov` is 3.2", "above 0 and below π"] {
        assert!(code(&refused) == 3 && message.contains(piece), "{message}");
    }
    let args = with(&args, &["--camera", "angle=20"]);
    assert!(notes(&args).contains("`yfov` is 3.2; this camera is omitted"), "{}", notes(&args));
    assert!(pixels_unlike(&picture(&args), [0, 0, 0]) > 200);
}

/// Options override the normals of a scene, and a note reports if there are none to change.
#[test]
fn options_override_normals_that_a_scene_calls_given() {
    let tilted = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0.6 0 0.8\nf 1//1 2//1 3//1\n";
    let given = "[[object]]\nmesh = \"a.obj\"\nnormals = \"given\"\n";
    let ball = "[[object]]\nsurface.sphere.radius = 1\n";
    let work = folder(&[("a.obj", tilted), ("given.toml", given), ("ball.toml", ball)]);
    let at = |name: &str| path(work.path().join(name));
    let args = with(&[at("given.toml")], &["--size", "40x30", "--show", "normals"]);
    // (n + 1)/2 of (0.6, 0, 0.8), whose z is 229.5 but for a rounding of single precision, and of (0, 0, 1).
    let middle = |more: &[&str]| {
        let picture = picture(&with(&args, more));
        picture.pixels().map(|pixel| pixel.0).find(|pixel| pixel[2] > 200).unwrap()
    };
    assert_eq!(middle(&[]), [204, 128, 229]);
    for more in [&["--when", "always"][..], &["--weight", "area"], &["--crease", "off"]] {
        assert_eq!(middle(more), [128, 128, 255], "{more:?}");
    }
    assert_eq!(middle(&["--when", "missing", "--weight", "area"]), [204, 128, 229]);
    let ball = with(&[at("ball.toml")], &["--size", "20x20"]);
    assert!(notes(&with(&ball, &["--weight", "area"])).contains("no meshes"));
    assert!(!notes(&ball).contains("no meshes"));
}

/// A wireframe shows on a background of any brightness.
#[test]
fn wireframes_show_on_white() {
    let (_folder, square) = square();
    let drawn = |background: &str| {
        let args = with(&[square.as_str()], &["--shading", "wireframe", "--size", "40x30"]);
        picture(&with(&args, &["--background", background]))
    };
    let darkest = |picture: &image::RgbImage| picture.pixels().map(|pixel| pixel.0[0]).min().unwrap();
    assert!(darkest(&drawn("1")) < 64 && pixels_unlike(&drawn("0"), [0, 0, 0]) > 20);
    assert!(pixels_unlike(&drawn("0.1"), [89, 89, 89]) > 20);
}

/// Values omitted from `--camera` are kept: also the near distance of a scene, however the eye is moved.
#[test]
fn a_scenes_camera_keeps_what_is_left_out() {
    let scene = "[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\nnear = 0.25\n[[object]]\nmesh = \"a.obj\"\n";
    let work = folder(&[("a.obj", SQUARE), ("a.toml", scene)]);
    let at = |name: &str| path(work.path().join(name));
    let camera = |args: &[String]| report(&with(args, &["--size", "40x30"]))["scene"]["camera"].clone();
    let moved = camera(&with(&[at("a.toml")], &["--camera", "eye=0,1,9"]));
    assert_eq!(moved["near"], 0.25, "{moved}");
    assert_eq!(moved["angle"], 30.0, "{moved}");
    // A far target cuts nothing off.
    let far = with(&[at("a.obj")], &["--camera", "eye=0,0,5 target=0,0,-30000", "--size", "40x30"]);
    assert!(pixels_unlike(&picture(&far), [0, 0, 0]) > 200);
}

/// A background given as a colour code has this code, whatever is shown in front of it.
#[test]
fn backgrounds_do_not_change_with_what_is_shown() {
    let (_folder, square) = square();
    let args = with(&[square.as_str()], &["--size", "40x30", "--background", "#80ff10"]);
    for show in ["normals", "depth", "facing", "face-id"] {
        let picture = picture(&with(&args, &["--show", show]));
        assert_eq!(picture.get_pixel(0, 0).0, [0x80, 0xff, 0x10], "{show}");
    }
    assert_eq!(picture(&args).get_pixel(0, 0).0, [0x80, 0xff, 0x10]);
}

/// The object fills the frames of a turntable.
#[test]
fn a_turntable_fills_its_frames() {
    let gear = gear();
    let still = report(&gear)["drawings"][0]["covered_pixels"].as_f64().unwrap();
    let folder = tempfile::tempdir().unwrap();
    let out = path(folder.path().join("spin.gif"));
    let turned = report(&with(&gear, &["--turntable", "6", "-o", &out]));
    let frames = turned["drawings"].as_array().unwrap();
    let covered = frames.iter().map(|frame| frame["covered_pixels"].as_f64().unwrap());
    let largest = covered.fold(0.0, f64::max);
    assert!(largest > 0.75 * still, "{largest} pixels, {still} in a still picture");
}

/// An analytic surface is framed as large as a mesh of it.
#[test]
fn a_solid_is_framed_as_its_tessellation_is() {
    let ball = "[[object]]\nsurface.sphere.radius = 1\n";
    let work = folder(&[("ball.toml", ball), ("net.toml", &format!("{ball}tessellation = {{ }}\n"))]);
    let covered = |name: &str| {
        let args = with(&[path(work.path().join(name))], &["--size", "80x60"]);
        report(&args)["drawings"][0]["covered_pixels"].as_f64().unwrap()
    };
    let (ball, net) = (covered("ball.toml"), covered("net.toml"));
    assert!((ball / net - 1.0).abs() < 0.02, "{ball} pixels, {net} of the tessellation");
}
