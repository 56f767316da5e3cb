//! The page of a diagnosis: it holds everything itself, its links lead somewhere, its pictures can be read out.

use super::{loaded, surface, with_normals};
use crease::normals::NormalRecipe;
use crease::quality::catalogue::Kind;
use crease::quality::{Thresholds, diagnose};
use crease::report::{Sight, deviation_picture, diagnosis_page};
use crease::surface::{Surface, Torus};
use glam::DVec3;
use std::collections::BTreeSet;

/// What stands between two marks, wherever they occur.
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
    let page = diagnosis_page(&file, &diagnosis, None, ["a <torus>.obj", "mended.obj"], Sight::Auto).unwrap();

    assert!(
        !page.contains("http://") && !page.contains("https://") && !page.contains("<script"),
        "an address"
    );
    assert!(!page.contains("<torus>"), "text became markup");
    let ids = between(&page, " id=\"", "\"");
    let distinct: BTreeSet<&str> = ids.iter().copied().collect();
    assert_eq!(distinct.len(), ids.len(), "ids are all different");
    for link in between(&page, "href=\"#", "\"") {
        assert!(distinct.contains(link), "{link} leads nowhere");
    }
    for source in between(&page, "<img src=\"", "\"") {
        assert!(source.starts_with("data:image/png;base64,"));
    }
    let pictures = between(&page, "<img ", ">");
    assert!(pictures.len() > 3 && pictures.iter().all(|image| between(image, "alt=\"", "\"")[0].len() > 20));
    assert_eq!(page.matches("<svg role=\"img\"").count(), 5, "five histograms");
    for finding in &diagnosis.findings {
        assert!(distinct.contains(finding.kind.id()), "{}", finding.kind.id());
    }
    assert!(page.contains(Kind::Flipped.entry().meaning));
    assert!(page.contains("crease normals a &lt;torus&gt;.obj -o mended.obj --when broken"));
}

/// A mesh with right normals is violet all over; one with wrong normals is yellow.
#[test]
fn colours_tell_deviation() {
    let mesh = with_normals(
        surface(&Surface::from(Torus::default()), [24, 12]).with_normals(None),
        &NormalRecipe::default(),
    );
    let mut wrong = mesh.columns().normals.clone().unwrap();
    wrong.values.iter_mut().for_each(|normal| *normal = DVec3::new(normal.y, normal.z, normal.x));
    let yellow = |mesh: crease::mesh::Mesh| {
        let file = loaded(mesh);
        let diagnosis = diagnose(&file, &Thresholds::default(), &|_| {});
        let picture =
            deviation_picture(&file, &diagnosis, Sight::From(DVec3::new(1.0, 2.0, 1.0)), 96).unwrap();
        let crease::raster::Pixels::Eight(pixels) = picture.pixels else { panic!("8 bits") };
        // Above the legend.
        let upper = &pixels[..96 * 80];
        upper.iter().filter(|[r, g, b]| *r > 200 && *g > 180 && *b < 120).count()
    };
    assert_eq!(yellow(mesh.clone()), 0);
    assert!(yellow(mesh.with_normals(Some(wrong))) > 500);
}
