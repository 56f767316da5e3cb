//! Each option has its effect. Other tests check the results of the library.

use super::{BEFORE, bytes, gear, picture, pixels_unlike, render, report, square, with};
use crate::cli::{data, path};
use std::collections::BTreeSet;

/// Options whose values all give different pictures; all but one value also differ from the picture without the option.
const VALUES: &[(&str, &[&str])] = &[
    ("--size", &["48x72", "96x48"]),
    ("--samples", &["1", "4", "8", "16"]),
    ("--bits", &["8", "16"]),
    ("--shading", &["flat", "gouraud", "phong", "wireframe"]),
    ("--reflection", &["phong", "blinn"]),
    ("--exponent", &["1", "32", "200"]),
    ("--show", &["normals", "facing", "depth", "face-id", "deviation", "deviation=3"]),
    ("--overlay", &["wire", "creases", "vertex-normals", "face-normals", "wire,creases"]),
    ("--cull", &["none", "front"]),
    ("--camera", &["eye=5,1,2", "target=0.2,0,0", "up=1,1,0", "angle=50", "height=2"]),
    (
        "--light",
        &[
            "directional towards=1,0,1",
            "point position=0,3,3",
            "point position=0,3,3 attenuation=inverse-square",
            "spot position=0,0,4 axis=0,0,-1 cut-off=15",
            "rectangle centre=0,0,4 u=1,0,0 v=0,-1,0",
            "disc centre=0,2,4 normal=0,-1,-2 radius=1 colour=#ffddaa",
        ],
    ),
    ("--ambient", &["0", "0.5", "0.1,0,0"]),
    ("--material", &["colour=1,0,0", "colour=#0000ff", "kd=0.2", "ks=0.9", "highlight=1,1,0", "exponent=3"]),
    ("--background", &["#ffffff", "0.2", "0,0,1", "black", "gradient", "transparent"]),
    ("--rotate", &["0,0,45", "90,0,0", "-10,20,0"]),
    ("--weight", &["uniform", "area", "angle"]),
    ("--crease", &["off", "0"]),
    ("--guard", &["renormalise=off"]),
    ("--terminator", &["smooth", "hard", "soft"]),
    ("--transfer", &["srgb", "direct"]),
    ("--compare", &["flat,gouraud,phong", "scanline,affine,perspective", "flat,wireframe"]),
];

#[test]
fn every_value_of_every_option_makes_its_own_picture() {
    let gear = gear();
    let plain = bytes(&gear);
    for (option, values) in VALUES {
        let others = if *option == "--size" { &gear[..1] } else { &gear[..] };
        let pictures: BTreeSet<Vec<u8>> =
            values.iter().map(|value| bytes(&with(others, &[option, value]))).collect();
        assert_eq!(pictures.len(), values.len(), "{option}: two values make the same picture");
        let like_plain = usize::from(pictures.contains(&plain));
        assert!(pictures.len() > like_plain, "{option} changes nothing");
    }
}

/// Hidden lines show as more lines, of wireframes and of overlays; removing them is the default.
#[test]
fn hidden_lines_are_removed_or_shown() {
    let gear = gear();
    for lines in [&["--shading", "wireframe"][..], &["--overlay", "wire"], &["--overlay", "vertex-normals"]] {
        let drawn = |how: &[&str]| bytes(&with(&with(&gear, lines), how));
        let (removed, shown) = (drawn(&["--hidden-lines", "remove"]), drawn(&["--hidden-lines", "show"]));
        assert!(removed != shown && removed == drawn(&[]), "{lines:?}");
    }
    let wires = |how: &str| {
        let args = with(&gear, &["--shading", "wireframe", "--hidden-lines", how, "--background", "black"]);
        pixels_unlike(&picture(&args), [0, 0, 0])
    };
    assert!(wires("show") > wires("remove"));
    // The option overrides a scene that shows them.
    let scene = "[settings]\nshading = \"wireframe\"\nwire.hide = false\n[[object]]\nsurface.torus = { major = 1, minor = 0.4 }\n\
                 tessellation = {}\n";
    let work = crate::cli::folder(&[("a.toml", scene)]);
    let args = with(&[path(work.path().join("a.toml"))], &["--size", "96x72"]);
    let plain = bytes(&args);
    assert!(plain == bytes(&with(&args, &["--hidden-lines", "show"])));
    assert!(plain != bytes(&with(&args, &["--hidden-lines", "remove"])));
}

/// The values that help names as defaults change nothing.
#[test]
fn defaults_are_what_help_says() {
    // A mesh without materials of its own.
    let [_, size, pixels] = gear();
    let bracket = [path(data("bracket.obj")), size, pixels];
    let plain = bytes(&bracket);
    for (option, value) in [
        ("--samples", "4"),
        ("--bits", "8"),
        ("--shading", "phong"),
        ("--interpolation", "perspective"),
        ("--reflection", "blinn"),
        ("--exponent", "32"),
        ("--flat-sample", "centroid"),
        ("--cull", "none"),
        ("--background", "0.7"),
        ("--rotate", "0,0,0"),
        ("--weight", "angle"),
        ("--when", "always"),
        ("--terminator", "smooth"),
        ("--tone", "clamp"),
        ("--transfer", "srgb"),
        ("--guard", "highlight=on"),
        ("--threads", "2"),
    ] {
        assert!(bytes(&with(&bracket, &[option, value])) == plain, "{option} {value}");
    }
}

/// Under strong perspective the three ways of interpolation differ, and flat faces can be lit in two ways.
#[test]
fn interpolation_and_flat_samples_differ_under_perspective() {
    let (_folder, square) = square();
    let tilted = [
        square.as_str(),
        "--size",
        "60x60",
        "--camera",
        "eye=0,-2,1 target=0,0.4,0 angle=60",
        "--light",
        "point position=0.5,0.5,0.7",
        "--shading",
    ];
    let pictures: BTreeSet<Vec<u8>> = ["scanline", "affine", "perspective"]
        .iter()
        .map(|how| bytes(&with(&tilted, &["gouraud", "--interpolation", how])))
        .collect();
    assert_eq!(pictures.len(), 3);
    let flat: BTreeSet<Vec<u8>> = ["centroid", "vertex-mean"]
        .iter()
        .map(|place| bytes(&with(&tilted, &["flat", "--flat-sample", place])))
        .collect();
    assert_eq!(flat.len(), 2);
}

#[test]
fn given_colours_are_interpolated_unlit() {
    let (_folder, square) = square();
    let args = with(&[square.as_str()], &BEFORE);
    let given = picture(&with(&args, &["--reflection", "given", "--transfer", "direct"]));
    // Corners of the picture are corners of the square: blue, green, white, red.
    for (at, expected) in
        [([0, 0], [0, 0, 255]), ([39, 0], [0, 255, 0]), ([0, 39], [255; 3]), ([39, 39], [255, 0, 0])]
    {
        let found = given.get_pixel(at[0], at[1]).0;
        // Half a pixel off the corner along both sides: 1/80 of each of two other corners, 6.4 steps together.
        let far = (0..3).map(|k| found[k].abs_diff(expected[k])).max().unwrap();
        assert!(far <= 7, "{at:?}: {found:?}");
    }
    let flat = picture(&with(&args, &["--reflection", "given", "--shading", "flat", "--transfer", "direct"]));
    // The mean of the four colours: (1/2, 1/2, 1/2).
    assert!(flat.pixels().all(|pixel| pixel.0 == [128; 3]), "{:?}", flat.get_pixel(0, 0));
}

/// A square that faces the viewer has the normal (0, 0, 1), which is shown as (0.5, 0.5, 1).
#[test]
fn normals_are_shown_as_numbers() {
    let (_folder, square) = square();
    let args = with(&with(&[square.as_str()], &BEFORE), &["--no-legend"]);
    let normals = picture(&with(&args, &["--show", "normals"]));
    assert!(normals.pixels().all(|pixel| pixel.0 == [128, 128, 255]));
    let facing =
        |rotate| picture(&with(&args, &["--show", "facing", "--rotate", rotate])).get_pixel(20, 20).0;
    let (front, back) = (facing("0,0,0"), facing("0,180,0"));
    assert!(front[1] > front[0] && back[0] > back[1], "{front:?} {back:?}");
    let turned = picture(&with(&args, &["--show", "normals", "--rotate", "0,30,0"]));
    // (sin 30° + 1)/2 and (cos 30° + 1)/2 of 255: 191.25 and 237.9.
    assert_eq!(turned.get_pixel(20, 20).0, [191, 128, 238]);
    let deviation = picture(&with(&args, &["--show", "deviation"]));
    assert!(deviation.pixels().all(|pixel| pixel.0 == [0; 3]), "the normals of a plane are right");
}

/// A square lit from behind is dark, unless it is lit on the side that is seen.
#[test]
fn two_sided_and_culled_faces() {
    let (_folder, square) = square();
    let lamp = ["--light", "directional towards=0,0,1", "--ambient", "0", "--rotate", "0,180,0"];
    let args = with(&with(&[square.as_str()], &BEFORE), &lamp);
    assert_eq!(pixels_unlike(&picture(&args), [0; 3]), 0);
    assert_eq!(pixels_unlike(&picture(&with(&args, &["--two-sided"])), [0; 3]), 1600);
    let culled = |which| picture(&with(&args, &["--background", "#ff0000", "--cull", which]));
    assert_eq!(pixels_unlike(&culled("back"), [255, 0, 0]), 0);
    assert_eq!(pixels_unlike(&culled("front"), [255, 0, 0]), 1600);
}

/// Light from behind: the printed formulas give a highlight and negative diffuse light, the guards do not.
#[test]
fn guards_can_be_switched() {
    let (_folder, square) = square();
    let lamp = [
        "--light",
        "directional towards=0.9,0,-0.1",
        "--camera",
        "eye=-5,0,0.6 target=0,0,0 height=2",
        "--ambient",
        "0",
        "--material",
        "kd=0 ks=1 exponent=2",
        "--reflection",
        "phong",
        "--size",
        "40x40",
        "--background",
        "black",
    ];
    let args = with(&[square.as_str()], &lamp);
    let guarded = picture(&args);
    assert_eq!(pixels_unlike(&guarded, [0; 3]), 0);
    let literal = picture(&with(&args, &["--literal"]));
    assert!(pixels_unlike(&literal, [0; 3]) > 100);
    assert_eq!(picture(&with(&args, &["--guard", "highlight=off"])), literal);
    assert_eq!(picture(&with(&args, &["--literal", "--guard", "highlight=on"])), guarded);
}

/// A colour of (1.8, 0.72, 0) is clamped to (1, 0.72, 0) or divided to (1, 0.4, 0): 183.6 and 102 steps of green.
#[test]
fn tone_rules_bring_colours_into_range() {
    let (_folder, square) = square();
    let bright = ["--material", "colour=1,0.4,0 ka=1 kd=0 ks=0", "--ambient", "1.8", "--transfer", "direct"];
    let args = with(&with(&[square.as_str()], &BEFORE), &bright);
    let colour = |rule| picture(&with(&args, &["--tone", rule])).get_pixel(20, 20).0;
    assert_eq!(colour("clamp"), [255, 184, 0]);
    assert_eq!(colour("max"), [255, 102, 0]);
}

/// What is drawn is what `normals` would write.
#[test]
fn when_and_crease_choose_the_normals() {
    let work = crate::cli::folder(&[(
        "tilted.obj",
        "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvn 0.6 0 0.8\nf 1//1 2//1 3//1 4//1\n",
    )]);
    let file = crate::cli::path(work.path().join("tilted.obj"));
    let colour = |when| {
        let args = with(&[file.as_str()], &BEFORE);
        picture(&with(&args, &["--show", "normals", "--when", when])).get_pixel(20, 20).0
    };
    assert_eq!(colour("always"), [128, 128, 255]);
    // (0.6 + 1)/2 and (0.8 + 1)/2 of 255: 204 and 229.5, where rounding decides.
    assert_eq!(colour("missing")[..2], [204, 128]);
    assert_eq!(colour("broken")[..2], [204, 128]);
    let gear = gear();
    let creases = |angle| {
        let shown = with(
            &gear,
            &["--overlay", "creases", "--ambient", "0", "--light", "point position=0,0,0 colour=0"],
        );
        pixels_unlike(&picture(&with(&shown, &["--crease", angle])), [0; 3])
    };
    assert!(creases("20") > creases("off"));
}

#[test]
fn threads_change_no_byte() {
    let gear = gear();
    for more in [
        &["--shading", "gouraud", "--overlay", "wire,vertex-normals"][..],
        &["--samples", "16", "--bits", "16"],
        &["--compare", "flat,phong,wireframe"],
        &["--shading", "gouraud", "--compare", "scanline,affine,perspective"],
        &["--turntable", "3"],
        &["--light", "disc centre=0,0,4 normal=0,0,-1 radius=1"],
    ] {
        let drawn = |threads| bytes(&with(&with(&gear, more), &["--threads", threads]));
        let one = drawn("1");
        for threads in ["2", "3", "8"] {
            assert!(drawn(threads) == one, "{more:?} with {threads} threads");
        }
    }
}

/// The report counts what the picture shows.
#[test]
fn the_report_counts_pixels_and_triangles() {
    let gear = gear();
    let args = with(&gear, &["--samples", "1", "--background", "#ff00ff", "--cull", "back"]);
    let shown = pixels_unlike(&picture(&args), [255, 0, 255]);
    let report = report(&args);
    assert_eq!((&report["schema"], &report["status"]), (&"crease-render/1".into(), &"ok".into()));
    let drawing = &report["drawings"][0];
    assert_eq!(drawing["covered_pixels"], shown);
    let edges = with(&args, &["--shading", "wireframe"]);
    let shown = pixels_unlike(&picture(&edges), [255, 0, 255]);
    assert_eq!(self::report(&edges)["drawings"][0]["covered_pixels"], shown);
    let count = |name: &str| drawing[name].as_u64().unwrap();
    // 1260 quads are 2520 triangles.
    assert_eq!(count("triangles_drawn") + count("triangles_culled"), 2520);
    assert!(count("triangles_culled") > 900 && count("triangles_clipped") == 0, "{drawing}");
    assert!(drawing["seconds"]["tiles"].as_f64().unwrap() > 0.0);
    assert_eq!(report["scene"]["faces"], 1260);
    assert_eq!(report["scene"]["lights"], serde_json::json!(["ambient", "directional"]));
    assert_eq!(report["scene"]["camera"]["angle"].as_f64().unwrap().round(), 30.0);
    assert_eq!(report["settings"]["guards"]["spot"], true);
    assert_eq!(report["settings"]["terminator"], "smooth");
    assert!(report.get("output").is_none(), "nothing was written");
}

/// Colour without a terminal needs an option.
#[test]
fn colour_of_the_report_is_chosen() {
    let gear = gear();
    let gear = gear.each_ref().map(String::as_str);
    let has_colour = |when: &[&str]| {
        let output = render(with(&with(&gear, &["--probe", "20,20", "--material", "kd=1 ks=1"]), when));
        [output.stdout, output.stderr].map(|stream| stream.contains(&0x1b))
    };
    assert!(has_colour(&["--color", "always"])[1]);
    for when in [&["--color", "never"][..], &["--color", "auto"], &[]] {
        assert_eq!(has_colour(when), [false; 2], "{when:?}");
    }
}
