//! Help, and command lines and scenes that are refused.

use super::{SQUARE, gear, render, report, with};
use crate::cli::{BAD, code, crease, folder, names, path, text};

/// Every option that the verb promises, with its values.
const OPTIONS: &[(&str, &[&str])] = &[
    ("-o, --output", &["FILE"]),
    ("--format", &["obj", "ply", "stl", "gltf", "glb"]),
    ("--root", &[]),
    ("--force", &[]),
    ("--size", &["WxH", "640x480"]),
    ("--samples", &["1", "4", "8", "16"]),
    ("--bits", &["8", "16"]),
    ("--compare", &["flat", "gouraud", "phong", "wireframe", "exact", "scanline", "affine", "perspective"]),
    ("--turntable", &["N"]),
    ("--probe", &["X,Y"]),
    ("--shading", &["flat", "gouraud", "phong", "wireframe", "exact", "traced"]),
    ("--interpolation", &["scanline", "affine", "perspective"]),
    ("--reflection", &["phong", "blinn", "given"]),
    ("--exponent", &["32"]),
    ("--flat-sample", &["centroid", "vertex-mean"]),
    ("--show", &["normals", "facing", "depth", "face-id", "deviation"]),
    ("--overlay", &["wire", "creases", "vertex-normals", "face-normals"]),
    ("--hidden-lines", &["remove", "show"]),
    ("--cull", &["none", "back", "front"]),
    ("--two-sided", &[]),
    ("--camera", &["CAMERA"]),
    ("--light", &["LIGHT"]),
    ("--ambient", &["COLOUR"]),
    ("--material", &["MATERIAL"]),
    ("--background", &["COLOUR"]),
    ("--rotate", &["X,Y,Z"]),
    ("--weight", &["uniform", "area", "angle", "angle-area", "max", "edge", "quadric", "jet", "best"]),
    ("--crease", &["DEG|off"]),
    ("--when", &["always", "missing", "broken"]),
    ("--guard", &["highlight", "diffuse", "spot", "renormalise", "underflow"]),
    ("--literal", &[]),
    ("--terminator", &["smooth", "hard", "soft"]),
    ("--tone", &["clamp", "max"]),
    ("--transfer", &["srgb", "direct"]),
    ("--threads", &[]),
    ("--json", &[]),
    ("-q, --quiet", &[]),
    ("-v, --verbose", &[]),
];

#[test]
fn help_has_every_option_with_its_values_and_examples() {
    let output = render(["--help"]);
    assert_eq!(code(&output), 0);
    let help = text(&output.stdout);
    for (option, values) in OPTIONS {
        let heading = |end: &str| {
            help.find(&format!("\n      {option}{end}")).or(help.find(&format!("\n  {option}{end}")))
        };
        let start = heading(" ").or(heading("\n"));
        let start = start.unwrap_or_else(|| panic!("no {option} in\n{help}"));
        let rest = &help[start + option.len()..];
        let end =
            ["\n      --", "\n  -"].iter().filter_map(|next| rest.find(next)).min().unwrap_or(rest.len());
        for value in *values {
            assert!(rest[..end].contains(value), "no {value} in\n{option}{}", &rest[..end]);
        }
    }
    assert!(help.contains("Examples:\n  crease render") && help.contains("Exit codes:"));
    assert!(help.contains("directional towards=V"));
}

#[test]
fn completions_and_manual_pages_know_the_verb() {
    for shell in ["bash", "zsh", "fish"] {
        let output = crease().args(["completions", shell]).output().unwrap();
        assert!(text(&output.stdout).contains("turntable"), "{shell}");
    }
    let page = crease().args(["man", "render"]).output().unwrap();
    assert!(text(&page.stdout).contains(".TH crease-render 1") && text(&page.stdout).contains("turntable"));
}

#[test]
fn wrong_command_lines_are_refused_with_a_reason() {
    let work = folder(&[("a.obj", SQUARE), ("sub/b.obj", SQUARE), ("mesh.png", SQUARE)]);
    let at = |name: &str| path(work.path().join(name));
    let [a, out] = [at("a.obj"), at("out.png")];
    let before = names(work.path());
    let table: &[(&[&str], &str)] = &[
        (&[], "<INPUT>"),
        (&[&a], "--output is required"),
        (&[&at("sub"), "-o", &out], "is a folder"),
        (&[&a, "-o", &at("sub")], "is a folder"),
        (&[&a, "-o", &at("out.bmp")], "use .png, .jpg, .webp or .gif"),
        (&[&a, "-o", &at("out.webp"), "--turntable", "4"], "--turntable makes a GIF"),
        (&[&a, "-o", &at("out.jpg"), "--bits", "16"], "--bits 16 needs a PNG output"),
        (&[&a, "-o", &at("out")], "use .png, .jpg, .webp or .gif"),
        (&[&a, "-o", &out, "--size", "20000x10"], "16384"),
        (&[&a, "-o", &out, "--size", "0x10"], "16384"),
        (&[&a, "-o", &out, "--size", "wide"], "WIDTHxHEIGHT"),
        (&[&a, "-o", &out, "--samples", "5"], "16"),
        (&[&a, "-o", &out, "--bits", "12"], "use one of: 8, 16"),
        (&[&a, "-o", &at("a.gif"), "--bits", "16"], "GIF has 8 bits"),
        (&[&a, "-o", &out, "--shading", "toon"], "gouraud"),
        (&[&a, "-o", &out, "--exponent", "-1"], "0 or more"),
        (&[&a, "-o", &out, "--exponent", "nan"], "finite"),
        (&[&a, "-o", &out, "--show", "age"], "face-id"),
        (&[&a, "-o", &out, "--overlay", "hair"], "vertex-normals"),
        (&[&a, "-o", &out, "--compare", "flat,toon"], "gouraud"),
        (&[&a, "-o", &out, "--compare", "flat", "--shading", "flat"], "cannot be used with"),
        (&[&a, "-o", &out, "--compare", "affine", "--interpolation", "affine"], "cannot be used with"),
        (&[&a, "-o", &out, "--turntable", "8"], ".gif"),
        (&[&a, "-o", &at("a.gif"), "--turntable", "1"], "from 2 to 720"),
        (&[&a, "--probe", "3,4", "--turntable", "8"], "cannot be used with"),
        (&[&a, "--probe", "3,4", "--show", "depth"], "cannot be used with"),
        (&[&a, "--probe", "3,4", "--compare", "flat,phong"], "cannot be used with"),
        (&[&at("mesh.png"), "--format", "obj", "-o", &at("mesh.png")], "overwrite the input"),
        (&[&a, "--probe", "3"], "column and row"),
        (&[&a, "-o", &out, "--rotate", "1,2"], "three numbers"),
        (&[&a, "-o", &out, "--rotate", "1,2,inf"], "finite"),
        (&[&a, "-o", &out, "--camera", ""], "such as eye=3,2,5"),
        (&[&a, "-o", &out, "--material", " "], "such as colour="),
        (&[&a, "-o", &out, "--camera", "eye=1,2"], "eye: "),
        (&[&a, "-o", &out, "--camera", "zoom=2"], "unknown key zoom"),
        (&[&a, "-o", &out, "--light", "sun"], "directional, point, spot"),
        (&[&a, "-o", &out, "--light", "point"], "position= is missing"),
        (&[&a, "-o", &out, "--material", "kd=-1"], "0 or more"),
        (&[&a, "-o", &out, "--ambient", "dim"], "#rrggbb"),
        (&[&a, "-o", &out, "--background", "#12345"], "#rrggbb"),
        (&[&a, "-o", &out, "--guard", "honour=on"], "renormalise"),
        (&[&a, "-o", &out, "--crease", "200"], "0 to 180"),
        (&[&a, "-o", &out, "--threads", "0"], "from 1 to 1024"),
        (&[&a, &a, "-o", &out], "unexpected argument"),
    ];
    for (args, expected) in table {
        let output = render(*args);
        let message = text(&output.stderr);
        assert_eq!(code(&output), 2, "{args:?}: {message}");
        assert!(message.contains(expected), "{args:?}: {message}");
        assert!(message.starts_with("error: ") && message.contains("\nhelp: "), "{args:?}: {message}");
        assert!(output.stdout.is_empty(), "{args:?}");
    }
    assert_eq!(names(work.path()), before, "nothing is written");
}

#[test]
fn each_kind_of_failure_has_its_code_and_names_its_cause() {
    let work = folder(&[
        ("good.obj", SQUARE),
        ("plain.obj", crate::cli::TRIANGLE),
        ("bad.obj", BAD),
        ("empty.obj", "v 0 0 0\n"),
        ("syntax.toml", "[[object]\n"),
        ("unknown.toml", "[settings]\n\nshades = \"phong\"\n"),
        ("type.toml", "[settings]\nsize = \"big\"\n"),
        ("range.toml", "[settings]\nsamples = 5\n"),
        ("missing.toml", "[[object]]\nmesh = \"nowhere.obj\"\n"),
        ("sub/away.toml", "[[object]]\nmesh = \"../good.obj\"\n"),
        ("eye.toml", "[camera]\neye = [1, 1, 1]\ntarget = [1, 1, 1]\n"),
        ("nan.toml", "[[light.point]]\nposition = [nan, 0, 0]\ncolour = 1\n"),
        (
            "exponent.toml",
            "[[object]]\nsurface = { sphere = { radius = 1 } }\nmaterial = { exponent = -2 }\n",
        ),
        ("nothing.toml", ""),
        ("wire.toml", "[settings]\nshading = \"wireframe\"\n[[object]]\nmesh = \"good.obj\"\n"),
    ]);
    let before = names(work.path());
    let at = |name: &str| path(work.path().join(name));
    let [good, out] = [at("good.obj"), at("out.png")];
    let table: &[(&[&str], i32, &str)] = &[
        (&[&at("nowhere.obj"), "-o", &out], 3, "nowhere.obj"),
        (&[&at("bad.obj"), "-o", &out], 3, "line 2"),
        (&[&at("empty.obj"), "-o", &out], 3, "no faces"),
        (&[&at("syntax.toml"), "-o", &out], 3, "line 1"),
        (&[&at("unknown.toml"), "-o", &out], 3, "line 3: `settings.shades`"),
        (&[&at("type.toml"), "-o", &out], 3, "line 2: `settings.size`"),
        (&[&at("range.toml"), "-o", &out], 3, "line 2: `settings.samples`"),
        (&[&at("missing.toml"), "-o", &out], 3, "nowhere.obj"),
        (&[&at("sub/away.toml"), "-o", &out], 3, "--root"),
        (&[&at("eye.toml"), "-o", &out], 3, "same point"),
        (&[&at("nan.toml"), "-o", &out], 3, "line 2: `light.point.position`"),
        (&[&at("exponent.toml"), "-o", &out], 3, "line 3: `object.material.exponent`"),
        (&[&at("nothing.toml"), "-o", &out], 3, "no objects"),
        (&[&good, "-o", &out, "--shading", "exact"], 3, "analytic surface"),
        (&[&at("plain.obj"), "-o", &out, "--reflection", "given"], 3, "no vertex colours"),
        (&[&good, "-o", &at("good.obj/out.png")], 4, "good.obj"),
    ];
    for (args, expected, cause) in table {
        let output = render(*args);
        let message = text(&output.stderr);
        assert_eq!(code(&output), *expected, "{args:?}: {message}");
        assert!(message.starts_with("error: ") && message.contains(cause), "{args:?}: {message}");
    }
    assert_eq!(names(work.path()), before, "nothing is written");
}

/// Values that are wrong only together with the scene are still errors of the command line: the message names the option, and not
/// the file.
#[test]
fn values_that_a_scene_rejects_are_errors_of_usage() {
    let wire = "[settings]\nshading = \"wireframe\"\n[[object]]\nmesh = \"good.obj\"\n";
    let work = folder(&[("good.obj", SQUARE), ("wire.toml", wire)]);
    let before = names(work.path());
    let at = |name: &str| path(work.path().join(name));
    let [good, out] = [at("good.obj"), at("out.png")];
    let table: &[(&[&str], &[&str])] = &[
        (&["--camera", "eye=0,0,0 target=0,0,0"], &["--camera", "eye=0,0,0 target=0,0,0", "same point"]),
        (&["--camera", "up=0,0,0"], &["--camera", "up"]),
        (&["--camera", "eye=0,0,3 target=0,0,0 up=0,0,1"], &["--camera", "parallel to its axis"]),
        (&["--camera", "near=0"], &["--camera", "near distance is 0"]),
        (&["--camera", "angle=180"], &["--camera", "180", "between 0 and 180"]),
        (&["--camera", "height=0"], &["--camera", "height", "above 0"]),
        (&["--camera", "near=-1"], &["--camera", "near", "-1"]),
        (&["--light", "directional towards=0,0,0"], &["--light", "direction", "not zero"]),
        (&["--light", "spot position=0,0,1 axis=0,0,-1 cut-off=200"], &["--light", "cut-off is 200"]),
        (&["--light", "spot position=0,0,1 axis=0,0,-1 exponent=-1"], &["--light", "exponent is -1"]),
        (&["--light", "disc centre=0,0,1 normal=0,0,-1 radius=0"], &["--light", "radius is 0"]),
        (&["--light", "point position=0,0,1 attenuation=0,0,0"], &["--light", "kc + kl + kq"]),
        (&["--light", "point position=0,0,1e300"], &["--light: position"]),
        (&["--background", "1e300"], &["--background: "]),
        (&["--material", "kd=1e300"], &["--material: diffuse reflection is [8e299, ", "single precision"]),
        (&["--material", "highlight=1e39 ks=1"], &["--material: specular reflection is [1e39, "]),
        (&["--light", "directional towards=0,0,1 colour=1e300"], &["--light: colour is [1e300, "]),
        (&["--ambient", "1e300"], &["--ambient: colour is [1e300, "]),
        (
            &["--material", "kd=1e30", "--light", "directional towards=0,0,1 colour=1e30"],
            &["--material and --light: no finite"],
        ),
        (
            &["--light", "point position=0,0,0.01 colour=1e38 attenuation=inverse-square"],
            &["--light: no finite"],
        ),
        (
            &["--material", "colour=1 ka=1e20 kd=0 ks=0", "--ambient", "1e20"],
            &["--material and --ambient: no finite"],
        ),
        (&["--probe", "641,0"], &["--probe 641,0", "640x480", "639,479"]),
        (
            &["--probe", "3,4", "--shading", "wireframe"],
            &["--probe", "does not work with --shading wireframe"],
        ),
        (&["--compare", "flat,phong", "--size", "16384x16384"], &["--compare", "1 to 16384"]),
        (&["--compare", "flat,gouraud,phong,wireframe", "--size", "16384x16"], &["--compare", "1 to 16384"]),
    ];
    for (more, expected) in table {
        let output = render(with(&[good.as_str(), "-o", &out], more));
        let message = text(&output.stderr);
        assert_eq!(code(&output), 2, "{more:?}: {message}");
        assert!(
            message.starts_with("error: ") && !message.lines().next().unwrap().contains("good.obj:"),
            "{more:?}: {message}"
        );
        assert!(!message.lines().next().unwrap().contains("object 0"), "{more:?}: {message}");
        for piece in *expected {
            assert!(message.contains(piece), "{more:?}: no {piece:?} in {message}");
        }
    }
    let output = render([at("wire.toml").as_str(), "--probe", "3,4"]);
    assert!(code(&output) == 2 && text(&output.stderr).contains("does not work with --shading wireframe"));
    let spin = at("spin.gif");
    let output = render([good.as_str(), "-o", &spin, "--turntable", "720", "--size", "16384x16384"]);
    assert!(code(&output) == 2 && text(&output.stderr).contains("fewer or smaller"));
    assert_eq!(names(work.path()), before, "nothing is written");
}

#[test]
fn errors_and_warnings_are_data_too() {
    let gear = gear();
    let failed = report(&with(&gear, &["--shading", "exact"]));
    assert_eq!((&failed["status"], &failed["error"]["kind"]), (&"failed".into(), &"input".into()));
    let bright = report(&with(&gear, &["--material", "colour=1,0.5,0.25 kd=0.9 ks=0.7 highlight=1,0,1"]));
    assert_eq!(bright["notes"][0]["severity"], "warning");
    let said = bright["notes"][0]["text"].as_str().unwrap();
    assert!(
        said.contains("diffuse + specular") && said.contains("1.600 in red, 0.450 in green, 0.925 in blue"),
        "{said}"
    );
    // What is compared are products: coefficients above 1 in dark colours reflect no more than there is.
    let dark = report(&with(&gear, &["--material", "colour=0.5 kd=1.2 ks=0.7 highlight=0.5"]));
    assert_eq!(dark["notes"].as_array().unwrap().len(), 0, "{}", dark["notes"]);
}

/// Every member that a report can have is in the table of the schema; those of probes are documented fields of the
/// library's `PixelReport`.
#[test]
fn the_schema_lists_every_member() {
    let source = std::fs::read_to_string("docs/json.md").unwrap();
    let section = |name: &str| source.split("\n## ").find(|section| section.starts_with(name)).unwrap();
    let table = section("Members that several schemas share").to_owned() + section("`crease-render/1`");
    let gear = gear();
    let spin = folder(&[]);
    let out = path(spin.path().join("spin.gif"));
    let reports = [
        report(&with(&gear, &["--probe", "48,36"])),
        report(&with(&gear, &["--camera", "height=3", "--turntable", "2", "-o", &out])),
        report(&with(&gear, &["--shading", "exact"])),
    ];
    let mut found = std::collections::BTreeSet::new();
    let mut left: Vec<&serde_json::Value> = reports.iter().collect();
    while let Some(value) = left.pop() {
        let of_object = value.as_object().into_iter().flatten();
        for (name, value) in of_object.filter(|(name, _)| !["error", "notes"].contains(&name.as_str())) {
            found.insert(name.as_str());
            left.extend((!["probe", "guards"].contains(&name.as_str())).then_some(value));
        }
        left.extend(value.as_array().into_iter().flatten());
    }
    assert!(found.len() > 40, "{found:?}");
    for name in found {
        assert!(table.contains(&format!("`{name}`")), "{name} is not in the table");
    }
}
