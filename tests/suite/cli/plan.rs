//! `crease plan`: its text, its JSON, and command lines that are refused.

use super::{code, crease, data, folder, path, text};
use std::fs;
use std::process::Output;

/// A matt cube under a sun, whose plan is flat and omits a lamp that lights nothing.
const SCENE: &str = "\
[settings]\nsize = [24, 18]\n[camera]\neye = [4, 3, 5]\ntarget = [0, 0, 0]\nheight = 4\n\
[[light.directional]]\ntowards = [1, 2, 3]\n[[light.directional]]\ntowards = [-1, -2, -3]\ncolour = 0.5\n\
[[object]]\nname = \"block\"\nmaterial = { specular = 0 }\n\
polygons = { vertices = [[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1], [-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]], \
faces = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [2, 3, 7, 6], [1, 2, 6, 5], [0, 4, 7, 3]] }\n";

fn plan(args: &[&str]) -> Output {
    crease().arg("plan").args(args).output().unwrap()
}

#[test]
fn the_report_has_a_line_for_each_decision() {
    let folder = folder(&[("scene.toml", SCENE)]);
    let (input, output) = (path(folder.path().join("scene.toml")), path(folder.path().join("planned.toml")));
    let done = plan(&[&input, "-o", &output]);
    assert_eq!(code(&done), 0, "{}", text(&done.stderr));
    let report = text(&done.stdout);
    let lines: Vec<&str> = report.lines().collect();
    assert_eq!(lines[0], format!("{input} -> {output}"));
    let decisions: Vec<&str> =
        lines.iter().filter_map(|line| line.strip_prefix("  plan ")).map(str::trim).collect();
    assert_eq!(decisions.len(), 2, "{report}");
    assert!(decisions[0].starts_with("block: shading Phong to flat; saves "), "{report}");
    assert!(decisions[1].starts_with("light 1: directional to omitted; saves "), "{report}");
    for label in ["work", "bytes", "vertices", "worst", "search", "time"] {
        assert_eq!(
            lines.iter().filter(|line| line.starts_with(&format!("  {label} "))).count(),
            1,
            "{label}:\n{report}"
        );
    }
    assert!(report.contains("the cheapest plan"), "{report}");
    // The planned scene can be drawn and planned.
    let picture = path(folder.path().join("picture.png"));
    assert_eq!(code(&crease().args(["render", &output, "-o", &picture, "-q"]).output().unwrap()), 0);
    let second = plan(&[&output, "--tolerance", "0.001"]);
    assert!(
        text(&second.stdout).contains("nothing can be omitted within the tolerance"),
        "{}",
        text(&second.stdout)
    );
}

/// The members that docs/json.md lists.
#[test]
fn the_json_has_the_documented_members() {
    let folder = folder(&[("scene.toml", SCENE)]);
    let input = path(folder.path().join("scene.toml"));
    let done = plan(&[&input, "--json", "-q"]);
    assert_eq!(code(&done), 0, "{}", text(&done.stderr));
    let report: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
    assert_eq!((&report["schema"], &report["status"]), (&"crease-plan/1".into(), &"ok".into()));
    let page = fs::read_to_string(path(data("../docs/json.md"))).unwrap();
    let section = page.split("## `crease-plan/1`").nth(1).unwrap().split("\n## ").next().unwrap();
    let check = |value: &serde_json::Value| {
        for member in value.as_object().unwrap().keys() {
            let shared = ["schema", "crease", "status", "seconds"].contains(&member.as_str());
            assert!(shared || section.contains(&format!("`{member}`")), "{member} is not in docs/json.md");
        }
    };
    check(&report);
    check(&report["decisions"][0]);
    check(&report["planned"]);
    check(&report["worst"]);
    check(&report["worst_place"]);
    check(&report["end"]);
    assert_eq!(report["end"]["reason"], "proven");
    assert_eq!(report["decisions"].as_array().unwrap().len(), 2);
    assert_eq!(report["decisions"][0]["axis"], "shading");
    assert_eq!(report["planned"]["vertices"], 8);
    assert_eq!(report["is_cheapest"], true);
    // Only times differ from run to run, and with the number of threads.
    let mut again: serde_json::Value =
        serde_json::from_slice(&plan(&[&input, "--json", "-q", "--threads", "2"]).stdout).unwrap();
    for time in ["seconds", "draw_seconds"] {
        again[time] = report[time].clone();
    }
    assert_eq!(again, report);
}

/// A scene of a mesh file, named in a line that is indented.
fn mesh_scene(name: &str) -> String {
    format!(
        "[settings]\nsize = [24, 18]\n[[light.directional]]\ntowards = [1, 2, 3]\n[[object]]\n  mesh = '{name}' # a tetrahedron\n\
         weight = \"angle\"\n"
    )
}

const TETRAHEDRON: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

/// A planned scene in a folder above names its meshes from there, and draws the same.
#[test]
fn scenes_planned_into_a_folder_above_can_be_drawn() {
    let folder = folder(&[("inner/scene.toml", &mesh_scene("part.obj")), ("inner/part.obj", TETRAHEDRON)]);
    let at = |name: &str| path(folder.path().join(name));
    let drawn = |scene: &str| {
        let picture = at("picture.png");
        let done = crease().args(["render", scene, "-o", &picture, "-q"]).output().unwrap();
        assert_eq!(code(&done), 0, "{}", text(&done.stderr));
        fs::read(picture).unwrap()
    };
    for options in [&["--tolerance", "0"][..], &[]] {
        let mut pictures = Vec::new();
        for output in ["inner/planned.toml", "planned.toml"] {
            let done = plan(&[&[&at("inner/scene.toml"), "-q", "-o", &at(output)], options].concat());
            assert_eq!(code(&done), 0, "{}", text(&done.stderr));
            pictures.push(drawn(&at(output)));
        }
        assert_eq!(pictures[0], pictures[1]);
        let planned = fs::read_to_string(at("planned.toml")).unwrap();
        assert!(planned.contains("mesh = \"inner/part.obj\" # a tetrahedron"), "{planned}");
    }
}

/// A scene names no files outside its folder, also if its objects are inline tables.
#[test]
fn a_folder_from_which_no_mesh_can_be_named_is_refused() {
    let inline = "settings = { size = [24, 18] }\nobject = [{ mesh = 'part.obj' }]\n";
    let folder = folder(&[
        ("scene.toml", &mesh_scene("part.obj")),
        ("inline.toml", inline),
        ("part.obj", TETRAHEDRON),
    ]);
    fs::create_dir(folder.path().join("out")).unwrap();
    for name in ["scene.toml", "inline.toml"] {
        let output = folder.path().join("out/planned.toml");
        let refused = plan(&[&path(folder.path().join(name)), "-o", &path(&output)]);
        assert_eq!(code(&refused), 2, "{}", text(&refused.stderr));
        let message = text(&refused.stderr);
        assert!(
            message.contains("part.obj from its folder") && message.contains("help: write it into"),
            "{message}"
        );
        assert!(!output.exists());
    }
    // A scene without meshes goes anywhere.
    fs::write(folder.path().join("plain.toml"), SCENE).unwrap();
    let done =
        plan(&[&path(folder.path().join("plain.toml")), "-q", "-o", &path(folder.path().join("out/a.toml"))]);
    assert_eq!(code(&done), 0, "{}", text(&done.stderr));
}

#[test]
fn the_report_states_why_the_search_ended() {
    let folder = folder(&[("scene.toml", SCENE)]);
    let input = path(folder.path().join("scene.toml"));
    let of = |args: &[&str]| text(&plan(&[&[input.as_str()], args].concat()).stdout).to_owned();
    let timed = of(&["--seconds", "0"]);
    assert!(
        timed.contains("0 s used up, so the plan depends on the machine; a cheaper plan saves at most"),
        "{timed}"
    );
    let spent = of(&["--budget", "0"]);
    assert!(
        spent.contains("budget used up; a cheaper plan saves at most") && spent.contains(" % more ("),
        "{spent}"
    );
    let tiny = of(&["--tolerance", "1e-300"]);
    assert!(tiny.contains("(tolerance 1e-300)") && !tiny.contains("00000000"), "{tiny}");
}

/// Enough to find each stated view again.
#[test]
fn the_report_states_the_worst_views() {
    let folder = folder(&[("scene.toml", &SCENE.replace("specular = 0", "specular = 0.002"))]);
    let input = path(folder.path().join("scene.toml"));
    let args = ["--views", "2", "--light-cone", "10"];
    let report = text(&plan(&[&[input.as_str()], &args[..]].concat()).stdout).to_owned();
    assert!(report.contains(" of view ") && report.matches("--camera 'eye=").count() == 2, "{report}");
    let json = plan(&[&[input.as_str(), "--json", "-q"], &args[..]].concat());
    let json: serde_json::Value = serde_json::from_slice(&json.stdout).unwrap();
    for member in ["worst_place", "held_out_place"] {
        let place = &json[member];
        let length = |key: &str| -> f64 {
            place[key]
                .as_array()
                .unwrap()
                .iter()
                .map(|x| x.as_f64().unwrap())
                .map(|x| x * x)
                .sum::<f64>()
                .sqrt()
        };
        // The distance of the scene's camera.
        assert!((length("eye") - 50.0_f64.sqrt()).abs() < 1e-9 && length("target") == 0.0, "{place}");
    }
    let degrees = json["held_out_place"]["turn"]["degrees"].as_f64().unwrap();
    assert!([5.0, 10.0].iter().any(|angle| (degrees - angle).abs() < 1e-9), "{degrees}");
}

#[test]
fn standard_output_carries_the_scene() {
    let folder = folder(&[("scene.toml", SCENE)]);
    let (input, output) = (path(folder.path().join("scene.toml")), path(folder.path().join("planned.toml")));
    let streamed = plan(&[&input, "-o", "-"]);
    assert_eq!(code(&streamed), 0);
    assert_eq!(code(&plan(&[&input, "-o", &output, "-q"])), 0);
    assert_eq!(text(&streamed.stdout), fs::read_to_string(&output).unwrap());
    assert!(text(&streamed.stderr).contains("the cheapest plan"), "{}", text(&streamed.stderr));
}

#[test]
fn wrong_command_lines_are_refused() {
    let folder = folder(&[("scene.toml", SCENE)]);
    let input = path(folder.path().join("scene.toml"));
    let wrong: &[&[&str]] = &[
        &["--tolerance", "nan"],
        &["--tolerance", "-1"],
        &["--tolerance", "inf"],
        &["--share", "2"],
        &["--outline", "-1"],
        &["--views", "0"],
        &["--keep", "colours"],
        &["--keep", "lights", "--only", "shading"],
        &["--minimise", "time"],
        &["--size", "0x0"],
        &["--metric", "ssim"],
        &["-o", "a.toml", "--html", "./a.toml"],
        &["-o", "-", "--html", "-"],
        &["--metric", "flip", "--share", "0.1"],
        &["--metric", "flip", "--outline", "1"],
        &["--allow", "shading"],
        &["--seconds", "-1"],
        &["-o", &input],
    ];
    for args in wrong {
        let refused = plan(&[&[input.as_str()], *args].concat());
        assert_eq!(code(&refused), 2, "{args:?}: {}", text(&refused.stderr));
        assert!(text(&refused.stderr).starts_with("error: "), "{args:?}: {}", text(&refused.stderr));
    }
    assert_eq!(fs::read_to_string(&input).unwrap(), SCENE);
    assert_eq!(code(&plan(&[])), 2);
}

#[test]
fn unreadable_scenes_are_bad_input() {
    let away = SCENE.replace("target = [0, 0, 0]", "target = [9, 9, 9]");
    let files = [
        ("syntax.toml", "[settings\n"),
        ("unknown.toml", "[[object]]\nshape = 1\n"),
        ("empty.toml", "[settings]\nsize = [8, 8]\n"),
        ("away.toml", away.as_str()),
    ];
    let folder = folder(&files);
    for name in ["syntax.toml", "unknown.toml", "empty.toml", "away.toml", "missing.toml"] {
        let (input, output) = (path(folder.path().join(name)), path(folder.path().join("out.toml")));
        let failed = plan(&[&input, "-o", &output]);
        assert_eq!(code(&failed), 3, "{name}: {}", text(&failed.stderr));
        assert!(text(&failed.stderr).contains(name), "{name}: {}", text(&failed.stderr));
        assert!(!folder.path().join("out.toml").exists());
    }
    let input = path(folder.path().join("away.toml"));
    let report: serde_json::Value = serde_json::from_slice(&plan(&[&input, "--json"]).stdout).unwrap();
    assert_eq!((&report["status"], &report["error"]["kind"]), (&"failed".into(), &"input".into()));
}

#[test]
fn axes_and_size_are_options() {
    let folder = folder(&[("scene.toml", SCENE)]);
    let input = path(folder.path().join("scene.toml"));
    let report = |args: &[&str]| -> serde_json::Value {
        let output = plan(&[&[input.as_str(), "--json", "-q"], args].concat());
        serde_json::from_slice(&output.stdout).unwrap()
    };
    let axes = |report: &serde_json::Value| -> Vec<String> {
        let decisions = report["decisions"].as_array().unwrap();
        decisions.iter().map(|decision| decision["axis"].as_str().unwrap().to_owned()).collect()
    };
    assert_eq!(axes(&report(&["--keep", "lights"])), ["shading"]);
    assert_eq!(axes(&report(&["--only", "lights"])), ["lights"]);
    let text_of =
        |args: &[&str]| text(&plan(&[&[input.as_str(), "-o", "-", "-q"], args].concat()).stdout).to_owned();
    assert!(text_of(&["--size", "12x9"]).contains("size = [12, 9]"));
    let explained = plan(&[&input, "--explain"]);
    assert!(text(&explained.stdout).contains("The reference is the scene as declared"));
}

/// A page in both languages: pictures of the plan and of each refused step, the reasons, and no text without a value.
#[test]
fn the_page_shows_the_plan_and_what_was_refused() {
    let folder = folder(&[("scene <1>.toml", SCENE)]);
    let (input, page) = (path(folder.path().join("scene <1>.toml")), path(folder.path().join("page.html")));
    for (language, title, reason) in [
        ("en", "needs", "block is lit by flat shading in place of Phong shading"),
        ("pt", "precisa de", "block recebe tonalização plana em vez de tonalização de Phong"),
    ] {
        let done = plan(&[&input, "--html", &page, "--lang", language]);
        assert_eq!(code(&done), 0, "{}", text(&done.stderr));
        assert!(text(&done.stdout).contains(&format!("  page     {page}")), "{}", text(&done.stdout));
        let html = fs::read_to_string(&page).unwrap();
        assert!(html.contains(&format!("<html lang=\"{language}\">")));
        assert!(html.contains(&format!("<h1>scene &lt;1&gt;.toml {title} ")), "{html}");
        assert!(html.contains(reason), "{language}");
        assert!(html.contains(" 4, 3, 5 "), "the eye of the worst view: {html}");
        let refused = html.matches("<h3").count();
        assert!(refused >= 2, "{refused} refused steps");
        assert_eq!(html.matches("<img ").count(), 3 + 3 * refused);
        assert_eq!(html.matches("<svg role=\"img\"").count(), 1);
        let words = html.split("<style>").nth(1).unwrap().split("</style>").nth(1).unwrap();
        assert!(!words.contains('{') && !words.contains("∞") && !words.contains("NaN"), "{language}");
    }
    // A plan without changes has a page as well.
    let done = plan(&[&input, "--tolerance", "0", "--only", "reflection", "--html", &page, "-q"]);
    assert_eq!(code(&done), 0, "{}", text(&done.stderr));
    assert!(fs::read_to_string(&page).unwrap().contains("needs everything that it declares"));
}
