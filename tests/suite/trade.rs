//! The verb `trade` and its page.

use crate::cli;
use assert_cmd::Command;
use std::collections::BTreeSet;
use std::path::Path;
use std::sync::LazyLock;

fn crease(arguments: &[&str]) -> Command {
    let mut command = cli::crease();
    command.args(arguments).current_dir(env!("CARGO_MANIFEST_DIR"));
    command
}

/// What one quick measurement printed, and its page.
static QUICK: LazyLock<(serde_json::Value, String)> = LazyLock::new(|| {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path().join("new/folder");
    let output = crease(&["trade", "--quick", "--json", "-o", place.to_str().unwrap()]).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let page = std::fs::read_to_string(place.join("index.html")).unwrap();
    (serde_json::from_slice(&output.stdout).unwrap(), page)
});

/// Every value of an attribute in a page.
fn values<'a>(page: &'a str, attribute: &str) -> Vec<&'a str> {
    let start = format!(" {attribute}=\"");
    page.split(start.as_str()).skip(1).map(|rest| rest.split('"').next().unwrap()).collect()
}

/// Start tags of one kind.
fn tags<'a>(page: &'a str, name: &str) -> Vec<&'a str> {
    let start = format!("<{name}");
    let tags = page.split(start.as_str()).skip(1).filter(|rest| rest.starts_with([' ', '>']));
    tags.map(|rest| rest.split('>').next().unwrap()).collect()
}

fn check_page(page: &str) {
    // Nothing from elsewhere, by whatever spelling.
    for elsewhere in ["http:", "https:", "//", "url(", "@import", "<script", "<link", "<iframe", "<base"] {
        let text = strip_data(page);
        let inside = elsewhere == "url(";
        let found =
            text.match_indices(elsewhere).filter(|(at, _)| !inside || !text[at + 4..].starts_with('#'));
        assert_eq!(found.count(), 0, "{elsewhere}");
    }
    // Every id once, and every reference to one that is there.
    let ids = values(page, "id");
    let known: BTreeSet<&str> = ids.iter().copied().collect();
    assert_eq!(ids.len(), known.len());
    let links =
        values(page, "href").into_iter().map(|href| href.strip_prefix('#').expect("a link within the page"));
    let labels = values(page, "aria-labelledby").into_iter().flat_map(str::split_whitespace);
    let clips = values(page, "clip-path").into_iter().map(|url| {
        url.strip_prefix("url(#").and_then(|url| url.strip_suffix(')')).expect("a reference within the page")
    });
    let references: Vec<&str> = links.chain(labels).chain(clips).collect();
    assert!(!references.is_empty());
    for reference in references {
        assert!(known.contains(reference), "{reference}");
    }
    // Every picture and every drawing says what it shows.
    let alternatives = tags(page, "img").into_iter().map(|tag| values(tag, "alt").concat());
    assert!(alternatives.into_iter().all(|alternative| alternative.len() > 10));
    let drawings = tags(page, "svg");
    assert!(drawings.iter().all(|tag| tag.contains("role=\"img\"") && tag.contains("aria-labelledby")));
    assert_eq!(tags(page, "desc").len(), drawings.len());
    let described = page.split("<desc").skip(1).map(|rest| rest.split_once('>').unwrap().1);
    assert!(described.into_iter().all(|text| text.find('<').unwrap() > 10));
    // Every element that is opened is closed.
    for name in [
        "html", "head", "body", "main", "div", "figure", "table", "tr", "td", "th", "svg", "g", "text", "ul",
        "li",
    ] {
        let closed = page.matches(&format!("</{name}>")).count();
        assert_eq!(tags(page, name).len(), closed, "{name}");
    }
    for bad in ["NaN", "inf\"", "Infinity"] {
        assert!(!strip_data(page).contains(bad), "{bad}");
    }
    assert!(
        page.contains("@media print")
            && page.contains("lang=\"en\"")
            && page.contains("<meta charset=\"utf-8\">")
    );
}

/// Without the bytes of pictures, which may spell anything.
fn strip_data(page: &str) -> String {
    let mut parts = page.split("data:image/png;base64,");
    let mut text = parts.next().unwrap().to_owned();
    parts.for_each(|part| text.push_str(part.split_once('"').unwrap().1));
    text
}

#[test]
fn the_page_stands_alone() {
    let (_, page) = &*QUICK;
    check_page(page);
    assert!(tags(page, "svg").len() > 10 && tags(page, "img").len() >= 3);
    // Three weights on a sheet, each named below its picture.
    assert!(page.contains("angle: rms") && page.contains("; max: rms") && page.contains("; quadric: rms"));
    assert!(page.rfind("Advice").unwrap() > page.len() - 10_000, "advice is the last part");
}

#[test]
fn the_report_has_every_part() {
    let (report, _) = &*QUICK;
    assert_eq!((report["schema"].as_str(), report["status"].as_str()), (Some("crease-trade/1"), Some("ok")));
    let surfaces = &report["surfaces"];
    for part in ["vertex", "boxes", "precision", "encodings", "shading", "approximations"] {
        assert!(surfaces[part].as_array().is_some_and(|rows| !rows.is_empty()), "{part}");
    }
    // Six sums four ways, three fits one way.
    assert_eq!(surfaces["costs"]["rows"].as_array().unwrap().len(), 27);
    let classes = surfaces["classes"].as_array().unwrap();
    assert_eq!(classes.len(), 10);
    for class in classes {
        let points = class["points"].as_array().unwrap();
        // `--quick` has scattered points of one surface only.
        assert_eq!((points.len(), class["surfaces"].as_u64() >= Some(1)), (9, true), "{class}");
        assert!(points.iter().any(|point| point["dominated_by"].is_null()));
        let is_random = ["jittered", "quads", "polygons", "marching", "scattered", "noisy"];
        let has_spread = points.iter().any(|point| point["spread"][0] != point["spread"][1]);
        assert_eq!(has_spread, is_random.iter().any(|name| class["tiling"] == *name), "{class}");
    }
    assert!(report["advice"].as_array().unwrap().len() > 5);
    // The figures that are quoted, in the report as in the library's own tests: jittered torus at 64 × 32.
    let cases = surfaces["vertex"].as_array().unwrap();
    let torus = cases.iter().find(|case| case["surface"] == "torus" && case["tiling"] == "jittered").unwrap();
    let level =
        torus["meshes"].as_array().unwrap().iter().position(|mesh| mesh["segments"][0] == 64).unwrap();
    for (weight, rms) in [("uniform", 1.644), ("max", 0.498)] {
        let methods = torus["methods"].as_array().unwrap();
        let method = methods.iter().find(|method| method["weight"] == weight).unwrap();
        let found = method["errors"][level]["rms"].as_f64().unwrap();
        assert!((found - rms).abs() <= 0.0005, "{weight}: {found}");
    }
}

/// A report without its times: only errors remain.
fn without_times(value: &mut serde_json::Value) {
    match value {
        serde_json::Value::Object(members) => {
            let is_time = |key: &str| {
                key.ends_with("ns")
                    || key.starts_with("ns_")
                    || ["ratio", "dominated_by", "milliseconds", "seconds", "advice", "output"].contains(&key)
            };
            members.retain(|key, _| !is_time(key));
            members.values_mut().for_each(without_times);
        }
        serde_json::Value::Array(list) => list.iter_mut().for_each(without_times),
        _ => {}
    }
}

#[test]
fn errors_are_the_same_in_every_run_with_any_number_of_threads() {
    let again = crease(&["trade", "--quick", "--json", "--threads", "3"]).output().unwrap();
    let mut again: serde_json::Value = serde_json::from_slice(&again.stdout).unwrap();
    let mut first = QUICK.0.clone();
    without_times(&mut again);
    without_times(&mut first);
    assert_eq!(again.to_string(), first.to_string());
    assert!(first["surfaces"]["encodings"][0]["max"].is_number());
}

#[test]
fn a_mesh_of_ones_own_gets_a_recommendation() {
    let folder = tempfile::tempdir().unwrap();
    let output = crease(&["trade", "data/gear.obj", "-o", folder.path().to_str().unwrap()]).output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    // Its normals are too close to sharp edges for any fit, and the advice must say so.
    let advice = "No weighting can be recommended on this mesh.";
    assert!(output.status.success() && text.contains(advice), "{text}");
    let page = std::fs::read_to_string(folder.path().join("index.html")).unwrap();
    check_page(&page);
    assert!(page.contains("data/gear.obj") && page.contains(advice));
    // Error against cost with its frontier, how errors are spread, and where they are.
    assert!(page.contains("Pareto frontier") && page.contains("Errors of normals"));
    assert!(page.contains("grey where there is none"));
    assert!(page.contains("Hollow markers are dominated"));
    assert!(
        text.contains("Costs were measured on"),
        "a gear is too small for its costs to mean much: {text}"
    );
}

/// Max's weights are exact on a sphere, which fits are not.
#[test]
fn stored_normals_are_taken_for_the_truth() {
    let folder = tempfile::tempdir().unwrap();
    let sphere = folder.path().join("sphere.ply");
    let sphere = sphere.to_str().unwrap();
    let made = crease(&["surface", "sphere", "--segments", "16x16", "-q", "-o", sphere]).output().unwrap();
    assert!(made.status.success());
    let report = |arguments: &[&str]| -> serde_json::Value {
        let output = crease(&[&["trade", sphere, "--json"], arguments].concat()).output().unwrap();
        serde_json::from_slice(&output.stdout).unwrap()
    };
    let max = |report: &serde_json::Value| report["mesh"]["methods"][4]["estimate"]["max"].as_f64().unwrap();
    let stored = report(&["--truth", "stored"]);
    assert_eq!(
        (&stored["mesh"]["reference"], &stored["mesh"]["recommended"]),
        (&"stored".into(), &"max".into())
    );
    assert!(max(&stored) < 1e-12, "{}", max(&stored));
    assert!(max(&report(&["--truth", "estimated"])) > 1e-3);
    let page = folder.path().join("page");
    let text =
        crease(&["trade", sphere, "--truth", "stored", "-o", page.to_str().unwrap()]).output().unwrap();
    assert!(String::from_utf8(text.stdout).unwrap().contains("Use --weight max"));
    let page = std::fs::read_to_string(page.join("index.html")).unwrap();
    check_page(&page);
    assert!(page.contains("max, exact"), "an error of 0 is not on a logarithmic axis");
    let without = crease(&["trade", "data/gear.obj", "--truth", "stored"]).output().unwrap();
    assert_eq!(without.status.code(), Some(3));
    assert!(String::from_utf8_lossy(&without.stderr).contains("omit --truth stored"));
    // Facet normals are not those of the surface.
    let work = tempfile::tempdir().unwrap();
    let folder = work.path().join("pages");
    let stl = ["trade", "data/part.stl", "--truth", "stored", "-o", folder.to_str().unwrap()];
    let facets = crease(&stl).output().unwrap();
    assert_eq!(facets.status.code(), Some(3));
    assert!(String::from_utf8_lossy(&facets.stderr).contains("normals of its facets"));
    assert!(!folder.exists(), "an input that is refused leaves no folder");
}

#[test]
fn a_mesh_without_faces_is_nothing_to_measure() {
    for positions in ["", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"] {
        let output = crease(&["trade", "-", "--format", "obj"]).write_stdin(positions).output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(3), "{positions:?}: {said}");
        assert!(output.stdout.is_empty() && said.contains("no faces to measure"), "{said}");
    }
}

#[test]
fn what_cannot_be_read_or_written_is_reported() {
    let missing = crease(&["trade", "data/no-such.obj"]).output().unwrap();
    assert_eq!(missing.status.code(), Some(3));
    assert!(String::from_utf8_lossy(&missing.stderr).contains("data/no-such.obj"));
    let in_the_way = Path::new("Cargo.toml");
    let refused = crease(&["trade", "data/gear.obj", "-o", in_the_way.to_str().unwrap()]).output().unwrap();
    assert_eq!(refused.status.code(), Some(4));
    for wrong in [
        ["--quick", "data/gear.obj"],
        ["--quick", "--crease=30"],
        ["--full", "--format=stl"],
        ["--quick", "--truth=stored"],
    ] {
        let usage = crease(&["trade", wrong[0], wrong[1]]).output().unwrap();
        assert_eq!(usage.status.code(), Some(2), "{wrong:?}");
    }
}
