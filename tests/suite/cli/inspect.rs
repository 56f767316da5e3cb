//! The verb `inspect`: exit codes, choices of findings, and a JSON report with the members that are documented.

use super::{TRIANGLE, code, crease, data, folder, path, text};
use crease::text::Language;
use serde::Deserialize;
use std::process::Output;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "the members are checked by being read")]
struct Report {
    schema: String,
    crease: String,
    status: String,
    error: Option<serde_json::Value>,
    input: serde_json::Value,
    verdict: Option<String>,
    counts: Counts,
    hidden: Counts,
    parts: Vec<Part>,
    findings: Vec<Finding>,
    fix: Option<Fix>,
    against: Option<Against>,
    seconds: Seconds,
}

#[derive(Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
struct Counts {
    error: usize,
    warning: usize,
    note: usize,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "the members are checked by being read")]
struct Part {
    name: String,
    vertices: usize,
    faces: usize,
    corners: usize,
    estimate: Option<Estimate>,
    precision: Option<Precision>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "the members are checked by being read")]
struct Estimate {
    weight: String,
    crease: f64,
    groups: bool,
    turned: bool,
    sample: usize,
    reproduced: f64,
    separated: f64,
    median: f64,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "the members are checked by being read")]
struct Precision {
    grid: String,
    degrees: f64,
    exponent: Option<u64>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "the members are checked by being read")]
struct Finding {
    id: String,
    severity: String,
    family: String,
    cause: String,
    element: String,
    count: u64,
    of: u64,
    share: f64,
    area_share: Option<f64>,
    degrees: Option<f64>,
    steps: Option<f64>,
    measure: Option<Measure>,
    confidence: Option<f64>,
    command: Option<String>,
    places: Vec<Place>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "the members are checked by being read")]
struct Measure {
    value: f64,
    unit: String,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "the members are checked by being read")]
struct Place {
    part: usize,
    face: Option<u32>,
    corner: Option<u32>,
    vertex: Option<u32>,
    position: Option<[f64; 3]>,
    degrees: Option<f64>,
    node: Option<String>,
    line: Option<u64>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "the members are checked by being read")]
struct Seconds {
    read: f64,
    inspect: f64,
    total: f64,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "the members are checked by being read")]
struct Against {
    path: String,
    faces: [usize; 2],
    unmatched: [usize; 2],
    turned: usize,
    corners: usize,
    gained: usize,
    lost: usize,
    changed: usize,
    visible: usize,
    mean: Change,
    rms: Change,
    p50: Change,
    p95: Change,
    p99: Change,
    largest: Change,
    places: Vec<Place>,
    findings: Vec<FindingChange>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "the members are checked by being read")]
struct Change {
    degrees: f64,
    steps: f64,
}

#[derive(Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
struct Fix {
    command: String,
    findings: Vec<String>,
}

#[derive(Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
struct FindingChange {
    id: String,
    before: u64,
    after: u64,
}

/// Two triangles of a square, the second with a normal that points down.
const FLIPPED: &str =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nvn 0 0 -1\nf 1//1 2//1 3//1\nf 1//1 3//2 4//1\n";

fn inspect(args: &[&str]) -> Output {
    crease().arg("inspect").args(args).output().unwrap()
}

#[test]
fn the_report_has_the_documented_members() {
    let files = folder(&[("flipped.obj", FLIPPED)]);
    let output = inspect(&["--json", &path(files.path().join("flipped.obj"))]);
    assert_eq!(code(&output), 0, "{}", text(&output.stderr));
    let report: Report = serde_json::from_str(text(&output.stdout)).unwrap();
    assert_eq!((report.schema.as_str(), report.status.as_str()), ("crease-inspect/2", "ok"));
    let finding = &report.findings[0];
    assert_eq!(
        (finding.id.as_str(), finding.severity.as_str(), finding.count),
        ("flipped-normals", "error", 1)
    );
    let place = &finding.places[0];
    assert_eq!(
        (place.face, place.corner, place.vertex, place.position),
        (Some(1), Some(1), Some(2), Some([1.0, 1.0, 0.0]))
    );
    assert_eq!(place.line, Some(8), "the line of the face");
    assert_eq!(report.verdict.as_deref(), Some("error"));
    assert_eq!(report.counts, Counts { error: 1, warning: 0, note: report.findings.len() - 1 });
}

#[test]
fn gates_end_with_1_where_something_is_found() {
    let files = folder(&[("flipped.obj", FLIPPED), ("good.obj", TRIANGLE)]);
    let (flipped, good) = (path(files.path().join("flipped.obj")), path(files.path().join("good.obj")));
    assert_eq!(code(&inspect(&[&flipped])), 0);
    assert_eq!(code(&inspect(&["--fail-on", "error", &flipped])), 1);
    assert_eq!(code(&inspect(&["--fail-on", "error", &good])), 0);
    assert_eq!(code(&inspect(&["--fail-on", "note", &good])), 1);
    assert_eq!(code(&inspect(&["--fail-on", "error", "--ignore", "flipped-normals", &flipped])), 0);
    assert_eq!(code(&inspect(&["--fail-on", "note", "--only", "needle-faces", &flipped])), 0);
    let both = inspect(&["--json", "--recursive", "--fail-on", "error", &path(files.path())]);
    assert_eq!((code(&both), text(&both.stdout).lines().count()), (1, 2));
    let statuses =
        text(&both.stdout).lines().map(|line| serde_json::from_str::<Report>(line).unwrap().status);
    assert_eq!(statuses.collect::<Vec<_>>(), ["findings", "ok"]);
    assert_eq!(code(&inspect(&["nowhere.obj"])), 3);
    assert_eq!(code(&inspect(&["nowhere.obj", &good])), 5);
    // A file that cannot be read comes first, whatever is found in the others.
    assert_eq!(code(&inspect(&["--fail-on", "error", "nowhere.obj", &flipped])), 5);
    assert_eq!(code(&inspect(&[])), 2);
    assert_eq!(code(&inspect(&["--only", "nothing", &good])), 2);
    assert_eq!(code(&inspect(&["--deviation", "200", &good])), 2);
}

/// Hidden findings do not count, and the help says so.
#[test]
fn severity_hides_findings_from_the_gate() {
    let files = folder(&[("good.obj", TRIANGLE)]);
    let good = path(files.path().join("good.obj"));
    assert_eq!(code(&inspect(&["--fail-on", "note", &good])), 1);
    assert_eq!(code(&inspect(&["--fail-on", "note", "--severity", "error", &good])), 0);
    let said = |options: &[&str]| text(&inspect(&[options, &[&good]].concat()).stdout).to_owned();
    let hidden = "good.obj: no errors or warnings; 1 note hidden (--severity note shows it)\n";
    for options in [&["--severity", "error"][..], &[]] {
        assert!(said(options).contains(hidden) && !said(options).contains("no-normals"), "{}", said(options));
    }
    for options in [&["--severity", "note"][..], &["-v"]] {
        assert!(said(options).contains("good.obj: 1 note\n  note no-normals"), "{}", said(options));
    }
    assert!(said(&["--ignore", "no-normals"]).contains("good.obj: no selected findings; 1 note hidden\n"));
    let report: Report = serde_json::from_str(&said(&["--json", "--severity", "error"])).unwrap();
    assert_eq!((report.counts.note, report.hidden), (0, Counts { error: 0, warning: 0, note: 1 }));
    let help = inspect(&["--help"]);
    let said = text(&help.stdout).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(said.contains("and count the others; --fail-on ignores the others"), "{said}");
}

#[test]
fn negative_thresholds_are_answered_with_what_is_allowed() {
    for (option, allowed) in [
        ("--deviation", "an angle from 0 to 180 degrees"),
        ("--length", "a number of 0 or more"),
        ("--size", "a number of 1 or more"),
        ("--valence", "a whole number from 0 to 4294967295"),
        ("--confidence", "0.5 to 1"),
    ] {
        let output = inspect(&[option, "-1", "part.obj"]);
        let said = text(&output.stderr);
        assert!(code(&output) == 2 && said.contains(allowed) && said.contains(option), "{option}: {said}");
    }
}

#[test]
fn every_finding_is_explained() {
    for language in Language::ALL {
        let all = inspect(&["--lang", language.tag(), "--explain", "all"]);
        let all = text(&all.stdout);
        assert!(!all.contains('{'), "a text or a placeholder is missing: {all}");
        for entry in crease::quality::catalogue::entries() {
            let texts = [entry.meaning(), entry.advice()];
            assert!(texts.iter().all(|text| all.contains(text.get(language))), "{}", entry.id);
            let one = inspect(&["--lang", language.tag(), "--explain", entry.id]);
            let one = text(&one.stdout);
            assert!(one.starts_with(entry.id) && all.contains(one), "{one}");
        }
    }
    let fitting = inspect(&["--explain", "faceted", "--lang", "pt"]);
    assert!(text(&fitting.stdout).contains("faceted-normals: normais de face em uma forma suave"));
    assert_eq!(code(&inspect(&["--lang", "pt", "part.obj"])), 2, "reports are in English");
    for other in ["--json", "--seam=3", "--view=1,0,0", "--root=.", "--manifest=list"] {
        assert_eq!(code(&inspect(&["--explain", "all", other])), 2, "{other}");
    }
}

#[test]
fn text_begins_with_a_verdict() {
    let output = inspect(&["--severity", "note", &path(data("gear.obj"))]);
    let said = text(&output.stdout);
    assert!(said.lines().next().unwrap().contains("gear.obj: ") && said.contains("no-normals"), "{said}");
    let clean = inspect(&[&path(data("part.stl"))]);
    assert!(text(&clean.stdout).contains("part.stl: No problems found.\n"), "{}", text(&clean.stdout));
    let quiet = inspect(&["-q", &path(data("gear.obj"))]);
    assert!(quiet.stdout.is_empty());
}

#[test]
fn before_and_after_are_distinguished() {
    let files = folder(&[("flipped.obj", FLIPPED)]);
    let (flipped, mended) = (path(files.path().join("flipped.obj")), path(files.path().join("mended.glb")));
    let page = path(files.path().join("page.html"));
    let mend = crease().args(["normals", &flipped, "-o", &mended, "--when", "broken"]).output().unwrap();
    assert!(mend.status.success(), "{}", text(&mend.stderr));

    let output = inspect(&["--json", "--html", &page, &flipped, "--against", &mended]);
    let report: Report = serde_json::from_str(text(&output.stdout)).unwrap();
    let against = report.against.expect("it was asked for");
    assert_eq!((against.faces, against.unmatched, against.turned), ([2, 2], [0, 0], 0));
    assert_eq!((against.corners, against.changed, against.visible), (6, 1, 1));
    assert_eq!((against.largest.degrees, against.mean.degrees), (180.0, 30.0));
    // One of six angles is 180°.
    assert!((against.rms.degrees - 180.0 / 6.0_f64.sqrt()).abs() < 1e-9, "{:?}", against.rms);
    assert_eq!([&against.p50, &against.p95, &against.p99].map(|it| it.degrees), [0.0, 180.0, 180.0]);
    let place = &against.places[0];
    assert_eq!(
        (place.face, place.corner, place.line, place.degrees),
        (Some(1), Some(1), Some(8), Some(180.0))
    );
    let gone = FindingChange { id: "flipped-normals".into(), before: 1, after: 0 };
    assert!(against.findings.contains(&gone), "{:?}", against.findings);
    let page = std::fs::read_to_string(page).unwrap();
    assert!(page.contains("id=\"before-and-after\"") && page.contains("has after"), "the panels");

    let said = inspect(&[&flipped, "--against", &mended]);
    let said = text(&said.stdout);
    assert!(
        said.contains("1 of 6 corners changed") && said.contains("gone: flipped-normals 1 → 0"),
        "{said}"
    );
    let same = inspect(&[&mended, "--against", &mended]);
    assert!(text(&same.stdout).contains("no normals changed (6 corners)"), "{}", text(&same.stdout));
}

#[test]
fn what_came_after_may_come_from_standard_input() {
    let files = folder(&[("flipped.obj", FLIPPED)]);
    let flipped = path(files.path().join("flipped.obj"));
    let output = crease()
        .args(["inspect", "--json", &flipped, "--against", "-"])
        .write_stdin(FLIPPED)
        .output()
        .unwrap();
    let report: Report = serde_json::from_str(text(&output.stdout)).unwrap();
    let against = report.against.expect("it was asked for");
    assert_eq!((against.path.as_str(), against.corners, against.changed), ("-", 6, 0));
    let twice = crease().args(["inspect", "-", "--against", "-"]).write_stdin(FLIPPED).output().unwrap();
    assert_eq!(code(&twice), 2, "{}", text(&twice.stderr));
}

#[test]
fn a_file_without_faces_does_not_pass() {
    let files = folder(&[("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n")]);
    let points = path(files.path().join("points.obj"));
    let output = inspect(&["--json", "--fail-on", "warning", &points]);
    assert_eq!(code(&output), 1);
    let report: Report = serde_json::from_str(text(&output.stdout)).unwrap();
    assert_eq!(report.findings.iter().map(|it| it.id.as_str()).collect::<Vec<_>>(), ["no-faces"]);
    // Nothing would compute normals for it, so nothing is said of that.
    let drawn = inspect(&["--html", &path(files.path().join("points.html")), &points]);
    assert_eq!((code(&drawn), text(&drawn.stderr)), (0, ""));
}

#[test]
fn different_shapes_are_not_compared() {
    let elsewhere = FLIPPED.replace("v 0", "v 7");
    let files = folder(&[("a.obj", FLIPPED), ("b.obj", &elsewhere)]);
    let [a, b] = ["a.obj", "b.obj"].map(|name| path(files.path().join(name)));
    let output = inspect(&[&a, "--against", &b]);
    assert_eq!(code(&output), 3, "{}", text(&output.stderr));
    assert!(text(&output.stderr).contains("no face in common"), "{}", text(&output.stderr));
    assert_eq!(code(&inspect(&[&a, "--against", "nowhere.obj"])), 3);
    assert!(text(&output.stderr).contains("\nhelp: "), "{}", text(&output.stderr));
    let two = inspect(&[&a, &b, "--against", &a]);
    assert!(code(&two) == 2 && text(&two.stderr).contains("\nhelp: "), "{}", text(&two.stderr));
}

#[test]
fn batches_name_their_findings_and_fixes_are_written_to_the_working_folder() {
    let zero = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nf 1//1 2//1 3//1\n";
    let files = folder(&[("a.obj", zero), ("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")]);
    let [a, b] = ["a.obj", "b.obj"].map(|name| path(files.path().join(name)));
    let output = inspect(&[&a, &b]);
    let listed = text(&output.stdout);
    let of_a = listed.lines().find(|line| line.starts_with(&a)).unwrap();
    assert!(of_a.ends_with(" · zero-normals"), "{listed}");
    let output = inspect(&[&a, "--json"]);
    let json = text(&output.stdout);
    assert!(json.contains(" -o a-fixed.obj"), "{json}");

    let twin = files.path().join("twin/a.obj");
    std::fs::create_dir(twin.parent().unwrap()).unwrap();
    std::fs::write(&twin, zero).unwrap();
    let output = inspect(&["-v", &a, &path(twin)]);
    let listed = text(&output.stdout);
    assert!(listed.contains(" -o a-fixed.obj ") && listed.contains(" -o a-fixed-2.obj "), "{listed}");
    let output = crease().args(["inspect", "-"]).write_stdin(zero).output().unwrap();
    assert!(text(&output.stdout).contains("crease normals - -o stdin-fixed.obj --when broken < FILE"));
}

#[test]
fn pictures_may_go_to_standard_output() {
    let files = folder(&[("flipped.obj", FLIPPED)]);
    let (flipped, page) = (path(files.path().join("flipped.obj")), path(files.path().join("page.html")));
    let page_to = |to: &str| inspect(&["--json", "--fail-on", "error", "--html", to, &flipped]);
    let (streamed, stored) = (page_to("-"), page_to(&page));
    assert_eq!((code(&streamed), code(&stored)), (1, 1), "{}", text(&streamed.stderr));
    assert_eq!(text(&streamed.stdout), std::fs::read_to_string(&page).unwrap());
    let report: Report = serde_json::from_str(text(&streamed.stderr)).expect("the report alone");
    assert_eq!(report.status, "findings");
    let picture = inspect(&["--heatmap", "-", &flipped]);
    assert!(picture.stdout.starts_with(b"\x89PNG"), "{}", text(&picture.stderr));
    assert!(text(&picture.stderr).contains("flipped-normals"));
    let both = inspect(&["--html", "-", "--heatmap", "-", &flipped]);
    assert_eq!(code(&both), 2, "{}", text(&both.stderr));
    assert!(both.stdout.is_empty() && !std::path::Path::new("-").exists());
}

/// What no camera can see where it stands is drawn as a bare mesh is: brought nearer.
#[test]
fn meshes_of_any_size_and_place_have_pictures() {
    let triangle = |scale: f64, away: f64| {
        let at = |x: f64, y: f64| format!("v {:e} {:e} {:e}\n", away + x * scale, y * scale, x * y * scale);
        let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| at(x, y)).concat();
        format!("{corners}vn 0 0 1\nvn 0 0 -1\nf 1//1 2//1 3//1\nf 1//1 3//2 4//1\n")
    };
    let files = [
        ("small.obj", 1e-300, 0.0),
        ("large.obj", 1e300, 0.0),
        ("far.obj", 1.0, 1e12),
        ("usual.obj", 1.0, 0.0),
    ];
    let files = files.map(|(name, scale, away)| (name, triangle(scale, away)));
    let files = folder(&files.each_ref().map(|(name, content)| (*name, content.as_str())));
    for name in ["small.obj", "large.obj", "far.obj", "usual.obj"] {
        let file = path(files.path().join(name));
        for pictures in ["--heatmap", "--html"] {
            let output = inspect(&[pictures, "-", &file]);
            assert_eq!(code(&output), 0, "{name}: {}", text(&output.stderr));
            // A page has an overview and a close-up at least.
            let is_page = pictures == "--html";
            assert!(!is_page || text(&output.stdout).matches("<img").count() > 3, "{name}");
        }
    }
}

#[test]
fn no_picture_is_written_over_what_is_read() {
    let files = folder(&[("own.obj", TRIANGLE), ("other.obj", TRIANGLE)]);
    let [own, other, page] = ["own.obj", "other.obj", "page.html"].map(|name| path(files.path().join(name)));
    let around = path(files.path().join("../").join(files.path().file_name().unwrap()).join("own.obj"));
    for pictures in [
        &["--html", &own][..],
        &["--heatmap", &around],
        &["--against", &other, "--html", &other],
        &["--html", &page, "--heatmap", &page],
    ] {
        let output = inspect(&[&[own.as_str()], pictures].concat());
        assert_eq!(code(&output), 2, "{pictures:?}: {}", text(&output.stderr));
    }
    assert!(!files.path().join("page.html").exists());
    for input in [own, other] {
        assert_eq!(std::fs::read_to_string(input).unwrap(), TRIANGLE);
    }
}

/// What is written is what the name says.
#[test]
fn a_heat_map_is_a_png() {
    let files = folder(&[("own.obj", TRIANGLE)]);
    let [own, map] = ["own.obj", "map.jpg"].map(|name| path(files.path().join(name)));
    let output = inspect(&["--heatmap", &map, &own]);
    assert_eq!(code(&output), 2, "{}", text(&output.stderr));
    assert!(text(&output.stderr).contains("help: use a name that ends in .png"), "{}", text(&output.stderr));
    assert!(!files.path().join("map.jpg").exists());
}

/// A map of angles of a file without normals has nothing to show: that is said, and the map is made. A map of findings is not
/// affected.
#[test]
fn heat_maps_without_normals_are_explained() {
    let files = folder(&[("flipped.obj", FLIPPED), ("good.obj", TRIANGLE)]);
    let map = path(files.path().join("map.png"));
    let of = |name: &str, what: &[&str]| {
        inspect(&[&["--heatmap", &map, &path(files.path().join(name))], what].concat())
    };
    let said = of("good.obj", &["--heatmap-of", "deviation"]);
    assert!(
        code(&said) == 0 && text(&said.stderr).contains("no normals are stored"),
        "{}",
        text(&said.stderr)
    );
    assert!(files.path().join("map.png").is_file());
    assert_eq!(text(&of("flipped.obj", &["--heatmap-of", "area"]).stderr), "");
    assert_eq!(text(&of("good.obj", &[]).stderr), "");
    let wrong = of("good.obj", &["--heatmap-of", "flipped-normal"]);
    assert!(code(&wrong) == 2 && text(&wrong.stderr).contains("flipped-normals"), "{}", text(&wrong.stderr));
}
