//! Options that change nothing are reported, and no others: each claim is checked with the bytes of the picture.

use super::notes::notes;
use super::{bytes, picture, render, with};
use crate::cli::{folder, path, text};
use crease::num::{LinearRgb, Srgb8};

/// A folded strip of two different faces, a face seen from behind, and colours at all corners.
const STRIP: &str = "\
v -1 -1 0 1 0 0\nv 0 -1 0.4 0 1 0\nv 0 1 0.4 0 0 1\nv -1 1 0 1 1 0\nv 2 -1 0 0 1 1\nv 2 0.5 0 1 0 1\n
v -2 -1 0 1 1 1\nv -1.2 -1 0 0 0 0\nv -1.2 1 -0.5 1 0 0\nf 1 2 3 4\nf 2 5 6 3\nf 7 9 8\n";
const BALL: &str = "[[object]]\nsurface.sphere.radius = 1\n";

/// The strip and a ball, as files.
struct Stage {
    folder: tempfile::TempDir,
}

impl Stage {
    fn new() -> Self {
        let strip = "[[object]]\nmesh = \"strip.obj\"\n";
        let files = [
            ("strip.obj", STRIP.to_owned()),
            ("ball.toml", BALL.to_owned()),
            ("given.toml", format!("[settings]\nreflection = \"given\"\n{strip}")),
            ("net.toml", format!("{BALL}tessellation = {{ segments = [8, 6] }}\n")),
            (
                "exact.toml",
                format!("[settings]\nshading = \"exact\"\n{BALL}tessellation = {{ segments = [8, 6] }}\n"),
            ),
        ];
        Self { folder: folder(&files.each_ref().map(|(name, text)| (*name, &**text))) }
    }

    /// Words of a command line, whose first is the name of a file, at a low light.
    fn args(&self, words: &str) -> Vec<String> {
        let (name, words) = words.split_once(' ').unwrap_or((words, ""));
        let words: Vec<&str> = words.split(' ').filter(|word| !word.is_empty()).collect();
        let size = ["--size", "48x36", "--samples", "1"];
        with(&with(&[path(self.folder.path().join(name))], &size), &words.map_quoted())
    }
}

/// Words with `_` for the spaces within them.
trait Quoted {
    fn map_quoted(&self) -> Vec<String>;
}

impl Quoted for Vec<&str> {
    fn map_quoted(&self) -> Vec<String> {
        self.iter().map(|word| word.replace('_', " ")).collect()
    }
}

/// What was drawn, options that change nothing there, and why they do not.
const UNREAD: &[(&str, &[&str], &str)] = &[
    ("strip.obj --show depth", LIGHT, "change nothing: --show draws something else in place of light"),
    ("strip.obj --show normals", LIGHT, "change nothing: --show draws something else in place of light"),
    ("strip.obj --shading wireframe", LIGHT, "change nothing: a wireframe is not lit"),
    ("strip.obj --reflection given", LIGHT_ALONE, "change nothing: the colours of vertices are shown unlit"),
    ("given.toml", LIGHT_ALONE, "change nothing: the colours of vertices are shown unlit"),
    ("strip.obj --show face-id", &["--reflection", "given"], "changes nothing: --show draws"),
    ("strip.obj --shading gouraud", &["--terminator", "hard"], "--terminator changes nothing: only Phong"),
    ("strip.obj --shading flat", &["--terminator", "soft"], "--terminator changes nothing: only Phong"),
    ("exact.toml", &["--terminator", "hard"], "--terminator changes nothing: only Phong"),
    ("strip.obj --shading flat", NORMALS, "change nothing: only Gouraud and Phong shading use the normals"),
    ("strip.obj --shading wireframe", NORMALS, "change nothing: only Gouraud and Phong shading use"),
    ("strip.obj --shading flat --show normals", NORMALS, "change nothing: only Gouraud and Phong"),
    ("exact.toml", NORMALS, "change nothing: only Gouraud and Phong"),
    ("ball.toml", NORMALS, "change nothing: the scene has no meshes"),
    ("strip.obj --shading flat", AFFINE, "--interpolation changes nothing: only"),
    ("strip.obj --shading wireframe", AFFINE, "--interpolation changes nothing: only"),
    ("exact.toml", AFFINE, "--interpolation changes nothing: only"),
    ("ball.toml", &["--shading", "flat"], "drawn exactly"),
    ("ball.toml", &["--shading", "phong"], "drawn exactly"),
];

/// What was drawn, and options that change it.
const READ: &[(&str, &[&str])] = &[
    ("strip.obj", &["--light", "directional_towards=1,0,0.2"]),
    ("strip.obj", &["--reflection", "given"]),
    ("given.toml", &["--reflection", "blinn"]),
    ("net.toml --light directional_towards=1,0.4,-0.3", &["--terminator", "hard"]),
    ("strip.obj", &["--weight", "area"]),
    ("net.toml", &["--when", "always"]),
    ("strip.obj --shading flat --flat-sample vertex-mean", &["--weight", "area"]),
    ("strip.obj --shading wireframe --show normals", &["--weight", "area"]),
    ("given.toml --show normals", &["--crease", "5"]),
    ("strip.obj --show depth --overlay vertex-normals", &["--weight", "area"]),
    ("strip.obj --reflection given --overlay creases", &["--crease", "5"]),
    ("strip.obj", AFFINE),
    ("strip.obj --show normals", AFFINE),
    ("strip.obj --shading wireframe --show normals", AFFINE),
    ("given.toml --material ks=0", &["--reflection", "blinn"]),
    ("strip.obj", &["--shading", "gouraud"]),
];

const LIGHT: &[&str] = &[
    "--light",
    "directional_towards=1,0,0",
    "--ambient",
    "1",
    "--material",
    "kd=0.2",
    "--reflection",
    "phong",
    "--exponent",
    "3",
    "--guard",
    "highlight=off",
    "--literal",
    "--terminator",
    "hard",
];
/// Without the option that makes it light.
const LIGHT_ALONE: &[&str] = &[
    "--light",
    "directional_towards=1,0,0",
    "--ambient",
    "1",
    "--material",
    "kd=0.2",
    "--exponent",
    "3",
    "--guard",
    "highlight=off",
    "--literal",
    "--terminator",
    "hard",
];
const NORMALS: &[&str] = &["--weight", "area", "--crease", "5", "--when", "always"];
const AFFINE: &[&str] = &["--interpolation", "affine"];

fn is_reported(found: &str) -> bool {
    ["nothing", "drawn exactly", "more than once"].iter().any(|word| found.contains(word))
}

#[test]
fn options_that_change_nothing_are_reported() {
    let stage = Stage::new();
    for (words, options, reason) in UNREAD {
        let plain = stage.args(words);
        let typed = with(&plain, &options.to_vec().map_quoted());
        let found = notes(&typed);
        let reported: Vec<&str> = found.lines().filter(|line| line.contains(reason)).collect();
        assert!(!reported.is_empty(), "{words} {options:?}: no {reason:?} in {found:?}");
        let names = options.iter().filter(|word| word.starts_with("--"));
        if !reason.contains("drawn exactly") {
            names.for_each(|name| assert!(found.contains(name), "{words}: nothing of {name} in {found:?}"));
        }
        assert!(
            bytes(&plain) == bytes(&typed),
            "{words} {options:?} changes the picture, but is reported not to"
        );
    }
}

#[test]
fn options_that_change_something_are_not_reported() {
    let stage = Stage::new();
    for (words, options) in READ {
        let plain = stage.args(words);
        let typed = with(&plain, &options.to_vec().map_quoted());
        assert!(bytes(&plain) != bytes(&typed), "{words} {options:?} changes nothing");
        let found = notes(&typed);
        assert!(!is_reported(&found), "{words} {options:?}: {found}");
    }
}

/// One fact is reported once.
#[test]
fn analytic_surfaces_are_reported_once() {
    let stage = Stage::new();
    for words in ["ball.toml --show normals --shading gouraud", "ball.toml --show depth --compare flat,phong"]
    {
        let found = notes(&stage.args(words));
        assert!(found.lines().count() == 1 && found.contains("drawn exactly"), "{words}: {found}");
    }
}

/// Vertex colours of a file are reported if light hides them, whatever the format.
#[test]
fn colours_of_vertices_are_reported_where_they_are_lost() {
    let stage = Stage::new();
    let glb = path(stage.folder.path().join("strip.glb"));
    let strip = path(stage.folder.path().join("strip.obj"));
    assert!(
        crate::cli::crease().args(["normals", "-q", &strip, "-o", &glb]).output().unwrap().status.success()
    );
    for file in ["strip.obj", "strip.glb"] {
        for (more, is_reported) in [
            ("", true),
            (" --shading flat", true),
            (" --compare flat,wireframe", true),
            (" --reflection given", false),
            (" --shading wireframe", false),
            (" --show depth", false),
        ] {
            let found = notes(&stage.args(&format!("{file}{more}")));
            let said = found
                .contains("the vertex colours are not drawn: lit materials replace them; --reflection given");
            assert_eq!(said, is_reported, "{file}{more}: {found}");
        }
    }
    assert!(!notes(&stage.args("given.toml")).contains("have colours"));
}

/// Culled faces have no edges in a wireframe, and the report counts what is drawn.
#[test]
fn wireframes_leave_out_the_edges_of_faces_that_are_left_out() {
    let (_folder, square) = super::square();
    let wires = ["--shading", "wireframe", "--background", "black"];
    let args = with(&with(&[square.as_str()], &super::BEFORE), &wires);
    for lines in ["remove", "show"] {
        let args = with(&args, &["--hidden-lines", lines]);
        let (kept, left_out) = (with(&args, &["--cull", "back"]), with(&args, &["--cull", "front"]));
        assert!(bytes(&kept) == bytes(&args), "{lines}");
        assert_eq!(super::pixels_unlike(&picture(&left_out), [0; 3]), 0, "{lines}");
        let drawing = super::report(&left_out)["drawings"][0].clone();
        assert_eq!((&drawing["triangles_drawn"], &drawing["covered_pixels"]), (&0.into(), &0.into()));
        assert!(notes(&left_out).contains("the culled side"));
    }
}

/// A probe reports weights and normals of corners even if they do not affect the colour.
#[test]
fn options_that_change_what_a_probe_reports_are_not_reported() {
    let stage = Stage::new();
    let flat = stage.args("strip.obj --shading flat --probe 26,18");
    let said = |args: &[String]| text(&render(args).stdout).to_string();
    for options in [["--weight", "area"], ["--interpolation", "affine"]] {
        let typed = with(&flat, &options);
        assert_ne!(said(&flat), said(&typed), "{options:?}");
        assert!(!is_reported(&notes(&typed)), "{options:?}: {}", notes(&typed));
    }
}

#[test]
fn panels_without_a_difference_are_reported() {
    let stage = Stage::new();
    assert!(notes(&stage.args("ball.toml --compare flat,exact")).contains("drawn exactly"));
    for panels in ["affine,perspective", "gouraud,phong"] {
        let found = notes(&with(&stage.args("strip.obj"), &["--compare", panels]));
        assert!(!is_reported(&found), "{panels}: {found}");
    }
}

/// A material that reflects too much matters only where it is lit.
#[test]
fn materials_are_judged_where_they_are_lit() {
    let stage = Stage::new();
    let bright = ["--material", "kd=0.9 ks=0.9"];
    let found = |words: &str| notes(&with(&stage.args(words), &bright));
    assert!(found("strip.obj").contains("object 0: "), "{}", found("strip.obj"));
    for words in ["strip.obj --show depth", "strip.obj --shading wireframe", "strip.obj --reflection given"] {
        assert!(!found(words).contains("object 0: "), "{words}: {}", found(words));
    }
}

/// Default lines, which are black or white, differ from any background with any transfer: the better of the two has a contrast of
/// √(1.05 · 0.05)/0.05 or more, which is 4.58, on a screen.
#[test]
fn wireframes_of_bare_meshes_have_contrast() {
    let stage = Stage::new();
    let luminance = |code: [u8; 3]| LinearRgb::from(Srgb8(code)).luminance() + 0.05;
    for background in ["0", "0.1", "0.179", "0.18", "0.3", "0.45", "0.6", "1"] {
        for transfer in ["srgb", "direct"] {
            let args = stage.args(&format!("strip.obj --shading wireframe --transfer {transfer}"));
            let args = with(&args, &["--background", background]);
            let picture = picture(&args);
            let behind = picture.get_pixel(0, 0).0;
            let wire = picture.pixels().map(|pixel| pixel.0).find(|code| *code != behind).unwrap();
            let (wire, behind) = (luminance(wire), luminance(behind));
            // Codes are rounded.
            assert!(wire.max(behind) / wire.min(behind) > 4.5, "{background} {transfer}: {wire} on {behind}");
        }
    }
}
