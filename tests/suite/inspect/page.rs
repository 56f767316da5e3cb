//! The page of a diagnosis: it is self-contained, its links have targets, and its pictures have alternative text.

use super::{loaded, rebuilt, surface, with_normals};
use crease::io::{Format, Loaded, ReadOptions, read_bytes};
use crease::mesh::{Faces, Mesh};
use crease::normals::NormalRecipe;
use crease::quality::catalogue::Kind;
use crease::quality::{Diagnosis, Thresholds, diagnose};
use crease::report::{DiagnosisPage, HeatMap, Picture, Sight};
use crease::surface::{Sphere, Surface, Torus};
use crease::text::Language;
use glam::DVec3;
use std::collections::BTreeSet;

/// The map of the deviations of a file.
fn deviations(file: &Loaded, diagnosis: &Diagnosis, sight: Sight, side: u32) -> Picture {
    let of = HeatMap::Deviation;
    crease::report::heat_map(file, (diagnosis, &Thresholds::default()), of, sight, side, Language::English)
        .unwrap()
}

/// All texts between two marks.
fn between<'a>(text: &'a str, from: &str, to: &str) -> Vec<&'a str> {
    text.split(from).skip(1).filter_map(|rest| rest.split(to).next()).collect()
}

#[test]
fn the_page_of_a_fault_is_whole() {
    let mesh = with_normals(
        surface(&Surface::from(Torus::default()), [24, 12]).with_normals(None),
        &NormalRecipe::default(),
    );
    let mut normals = mesh.columns().normals.clone().unwrap();
    normals.values[7] = -normals.values[7];
    let file = loaded(mesh.with_normals(Some(normals)));
    let diagnosis = diagnose(&file, &Thresholds::default(), &|_| {});
    let fix = diagnosis.fix(|_| true, false, ["a <torus>.obj", "b.obj"]);
    for language in Language::ALL {
        let page = DiagnosisPage {
            name: "a <torus>.obj",
            fix: fix.as_ref(),
            omitted: 0,
            after: None,
            sight: Sight::Auto,
            language,
            thresholds: &Thresholds::default(),
        };
        check(&page.html(&file, &diagnosis).unwrap(), &diagnosis, language);
    }
}

/// Without stored normals there are no deviations to show, although a face is reversed.
#[test]
fn a_mesh_without_normals_has_no_picture_of_deviations() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 3 4\n";
    let read =
        |text: &str| read_bytes(text.into(), Some(Format::Obj), None, &ReadOptions::default()).unwrap();
    let with_normals = format!("vn 0 0 1\n{}", text.replace("f 1 3 2", "f 1//1 3//1 2//1"));
    for (text, has_picture) in [(text, false), (&*with_normals, true)] {
        let file = read(text);
        let diagnosis = diagnose(&file, &Thresholds::default(), &|_| {});
        assert!(diagnosis.get(Kind::InconsistentWinding).is_some(), "{:?}", diagnosis.findings);
        let page = page_of(&file, &diagnosis);
        assert_eq!(page.contains("computed with the estimated recipe"), has_picture, "{text}");
    }
}

/// The page of a diagnosis in English.
fn page_of(file: &Loaded, diagnosis: &Diagnosis) -> String {
    let page = DiagnosisPage {
        name: "a.obj",
        fix: None,
        omitted: 0,
        after: None,
        sight: Sight::Auto,
        language: Language::English,
        thresholds: &Thresholds::default(),
    };
    page.html(file, diagnosis).unwrap()
}

/// Asserts that a page in a language is whole.
fn check(page: &str, diagnosis: &Diagnosis, language: Language) {
    // A key or a placeholder without its text shows in braces.
    let text = page.split("</style>").last().unwrap();
    assert!(!text.contains('{'), "{language:?}: a text is missing");
    assert!(page.contains(&format!("<html lang=\"{}\"", language.tag())));
    assert!(
        !page.contains("http://") && !page.contains("https://") && !page.contains("<script"),
        "an address"
    );
    assert!(!page.contains("<torus>"), "text became markup");
    let ids = between(page, " id=\"", "\"");
    let distinct: BTreeSet<&str> = ids.iter().copied().collect();
    assert_eq!(distinct.len(), ids.len(), "ids are all different");
    for link in between(page, "href=\"#", "\"") {
        assert!(distinct.contains(link), "{link} leads nowhere");
    }
    for source in between(page, "<img src=\"", "\"") {
        assert!(source.starts_with("data:image/png;base64,"));
    }
    let pictures = between(page, "<img ", ">");
    assert!(pictures.len() > 4 && pictures.iter().all(|image| between(image, "alt=\"", "\"")[0].len() > 20));
    assert_eq!(page.matches("<svg role=\"img\"").count(), 5, "five histograms");
    for finding in &diagnosis.findings {
        assert!(distinct.contains(finding.kind.id()), "{}", finding.kind.id());
    }
    assert!(page.contains(Kind::Flipped.entry().meaning().get(language)));
    assert!(page.contains("crease normals 'a &lt;torus&gt;.obj'"));
}

/// The number of pixels of a picture, above the legend, with a certain colour.
fn pixels(picture: Picture, is_such: fn([u8; 3]) -> bool) -> usize {
    let side = picture.size[0] as usize;
    let crease::raster::Pixels::Eight(pixels) = picture.pixels else { panic!("8 bits") };
    pixels[..side * side].iter().filter(|pixel| is_such(**pixel)).count()
}

/// A ring marks a visible place, with some thirty pixels here; from behind there is none.
#[test]
fn rings_mark_only_what_is_seen() {
    let mesh = with_normals(
        surface(&Surface::from(Sphere::default()), [48, 24]).with_normals(None),
        &NormalRecipe::default(),
    );
    let mut normals = mesh.columns().normals.clone().unwrap();
    let front =
        (0..normals.values.len()).max_by(|&a, &b| normals.values[a].z.total_cmp(&normals.values[b].z));
    let front = front.unwrap();
    normals.values[front] = -normals.values[front];
    let file = loaded(mesh.with_normals(Some(normals)));
    let diagnosis = diagnose(&file, &Thresholds::default(), &|_| {});
    let red = |from| {
        let picture = deviations(&file, &diagnosis, Sight::From(from), 200);
        pixels(picture, |[r, g, b]| r > 200 && g < 60 && b < 60)
    };
    assert!(red(DVec3::Z) > 20 && red(DVec3::NEG_Z) == 0, "{} {}", red(DVec3::Z), red(DVec3::NEG_Z));
}

/// The number of yellow pixels.
fn yellow(picture: Picture) -> usize {
    pixels(picture, |[r, g, b]| r > 200 && g > 180 && b < 120)
}

/// The number of pixels in the pink of corners without a normal.
fn pink(picture: Picture) -> usize {
    pixels(picture, |[r, g, b]| r > 220 && g < 120 && b > 170)
}

/// Asserts that the faults of a mesh are hidden from one side, and that the automatic view shows some of them.
fn is_seen_but_not_from(side: DVec3, mesh: Mesh) {
    let file = loaded(mesh);
    let diagnosis = diagnose(&file, &Thresholds::default(), &|_| {});
    let seen = |sight: Sight| yellow(deviations(&file, &diagnosis, sight, 128));
    assert_eq!(seen(Sight::From(side)), 0, "the wall hides it");
    assert!(seen(Sight::Auto) > 10, "{}", seen(Sight::Auto));
}

/// A ball in an open box with inverted normals where it faces a wall. They are hidden from beyond that wall, and the automatic
/// view shows them.
#[test]
fn the_view_sees_what_is_wrong() {
    let ball = surface(&Surface::from(Sphere::default()), [48, 24]);
    let mut positions: Vec<DVec3> = ball.positions().iter().map(|p| p * 0.3).collect();
    let mut faces = ball.faces().clone();
    let first = positions.len() as u32;
    for height in [-1.0, 0.5] {
        positions.extend([[-1., -1.], [1., -1.], [1., 1.], [-1., 1.]].map(|[x, z]| DVec3::new(x, height, z)));
    }
    for [a, b, c, d] in [[0, 1, 2, 3], [0, 4, 5, 1], [1, 5, 6, 2], [2, 6, 7, 3], [3, 7, 4, 0]] {
        faces.push(&[a, b, c, d].map(|v: u32| first + v));
    }
    let mesh = with_normals(rebuilt(positions, faces), &NormalRecipe::default());
    let mut normals = mesh.columns().normals.clone().unwrap();
    let turned =
        normals.values.iter_mut().filter(|normal| normal.x > 0.95 && normal.y > 0.0 && normal.y < 0.3);
    assert!(turned.map(|normal| *normal = -*normal).count() > 3);
    is_seen_but_not_from(DVec3::X, mesh.with_normals(Some(normals)));
}

/// The bottom of a deep well that leans is seen from straight above only.
#[test]
fn the_automatic_view_looks_into_a_well() {
    let axis = DVec3::new(0.3, 0.5, 0.8).normalize();
    let [u, v] = [axis.any_orthonormal_vector(), axis.cross(axis.any_orthonormal_vector())];
    let ring = |height: f64| {
        (0..6).map(move |k| {
            let (sine, cosine) = libm::sincos(f64::from(k) * std::f64::consts::FRAC_PI_3);
            u * cosine + v * sine + axis * height
        })
    };
    let mut faces = Faces::new();
    faces.push(&[0, 1, 2, 3, 4, 5]);
    (0..6).for_each(|k| faces.push(&[k, k + 6, (k + 1) % 6 + 6, (k + 1) % 6]));
    let mesh = with_normals(rebuilt(ring(0.0).chain(ring(15.0)).collect(), faces), &NormalRecipe::default());
    let mut normals = mesh.columns().normals.clone().unwrap();
    let turned = normals.values.iter_mut().filter(|normal| normal.dot(axis) > 0.9);
    assert!(turned.map(|normal| *normal = -*normal).count() > 0);
    is_seen_but_not_from(DVec3::Z, mesh.with_normals(Some(normals)));
}

/// A mesh with right normals is violet all over; one with wrong normals is yellow.
#[test]
fn colours_tell_deviation() {
    let mesh = with_normals(
        surface(&Surface::from(Torus::default()), [24, 12]).with_normals(None),
        &NormalRecipe::default(),
    );
    let mut wrong = mesh.columns().normals.clone().unwrap();
    // Those that are visible.
    wrong.values.iter_mut().filter(|normal| normal.y > 0.0).for_each(|normal| *normal = -*normal);
    let yellow_of = |mesh: Mesh| {
        let file = loaded(mesh);
        let diagnosis = diagnose(&file, &Thresholds::default(), &|_| {});
        yellow(deviations(&file, &diagnosis, Sight::From(DVec3::new(1.0, 2.0, 1.0)), 96))
    };
    assert_eq!(yellow_of(mesh.clone()), 0);
    assert!(yellow_of(mesh.with_normals(Some(wrong))) > 500);
}

fn heat_map(mesh: Mesh, side: u32) -> Picture {
    let file = loaded(mesh);
    let diagnosis = diagnose(&file, &Thresholds::default(), &|_| {});
    deviations(&file, &diagnosis, Sight::From(DVec3::new(1.0, 2.0, 1.0)), side)
}

/// A single fault is visible however small its faces are, although its pixel also shows right corners.
#[test]
fn single_faults_are_seen_at_any_density() {
    const SIDE: u32 = 240;
    for segments in [[24, 12], [240, 120], [480, 240]] {
        let torus = surface(&Surface::from(Torus::default()), segments).with_normals(None);
        let mesh = with_normals(torus, &NormalRecipe::default());
        assert_eq!(yellow(heat_map(mesh.clone(), SIDE)), 0, "{segments:?}");
        let mut normals = mesh.columns().normals.clone().unwrap();
        // One visible vertex.
        let seen = normals.values.iter().position(|normal| normal.y > 0.8 && normal.x > 0.1).unwrap();
        normals.values[seen] = -normals.values[seen];
        let found = yellow(heat_map(mesh.with_normals(Some(normals)), SIDE));
        assert!(found >= 3, "{segments:?}: {found} pixels");
    }
}

/// Corners without a usable normal are not drawn as right: those without a normal, those with one that is zero or NaN, and those
/// of a file without normals.
#[test]
fn what_has_no_direction_is_pink() {
    let bare = surface(&Surface::from(Torus::default()), [24, 12]).with_normals(None);
    let mesh = with_normals(bare.clone(), &NormalRecipe::default());
    assert_eq!(pink(heat_map(mesh.clone(), 160)), 0);
    for nothing in [DVec3::ZERO, DVec3::NAN] {
        let mut normals = mesh.columns().normals.clone().unwrap();
        normals.values.iter_mut().filter(|normal| normal.y > 0.7).for_each(|normal| *normal = nothing);
        let found = pink(heat_map(mesh.clone().with_normals(Some(normals)), 160));
        assert!((1000..10_000).contains(&found), "{nothing}: {found}");
    }
    let found = pink(heat_map(bare, 160));
    assert!(found > 8_000, "{found}: all of it");
}

/// Names between backticks are set as code, and no backtick is left.
#[test]
fn names_in_pages_are_code() {
    let bare = surface(&Surface::from(Torus::default()), [24, 12]).with_normals(None);
    let mut normals = with_normals(bare.clone(), &NormalRecipe::default()).columns().normals.clone().unwrap();
    normals.values.iter_mut().for_each(|normal| *normal = normal.any_orthonormal_vector());
    let file = loaded(bare.with_normals(Some(normals)));
    let diagnosis = diagnose(&file, &Thresholds::default(), &|_| {});
    let page = page_of(&file, &diagnosis);
    assert!(diagnosis.get(Kind::Custom).is_some());
    assert!(page.contains("<code>--when missing</code>") && !page.contains('`'));
}

/// Ten reversed faces of a mesh without normals are a colour of their own in the map of findings; a clean mesh is grey.
#[test]
fn the_map_of_findings_shows_reversed_faces() {
    let bare = surface(&Surface::from(Torus::default()), [24, 12]).with_normals(None);
    let map = |mesh: Mesh| {
        let file = loaded(mesh);
        let thresholds = Thresholds::default();
        let diagnosis = diagnose(&file, &thresholds, &|_| {});
        crease::report::heat_map(
            &file,
            (&diagnosis, &thresholds),
            HeatMap::Findings,
            Sight::Auto,
            160,
            Language::English,
        )
        .unwrap()
    };
    let orange = |picture: Picture| pixels(picture, |[r, g, b]| r > 80 && r / 2 > g && b < 20);
    assert_eq!(orange(map(bare.clone())), 0);
    let mut faces = Faces::new();
    let upper = |face: &[u32]| face.iter().all(|&vertex| bare.positions().at(vertex).y > 0.1);
    let mut reversed = 0;
    for face in bare.faces().iter() {
        let mut corners = face.to_vec();
        if upper(face) && reversed < 10 {
            corners.reverse();
            reversed += 1;
        }
        faces.push(&corners);
    }
    let found = orange(map(rebuilt(bare.positions().iter().collect(), faces)));
    assert!(reversed == 10 && found > 150, "{found} pixels");
}
