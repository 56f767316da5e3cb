//! The real meshes as scenes.

use crate::meshes::{Row, rows};
use crease::raster::{Image, LoadOptions, SceneFile, load, render};
use glam::{DMat4, DVec3};

const SIZE: [u32; 2] = [96, 72];

fn good_files() -> Vec<Row> {
    let mut rows = rows("", &["obj", "ply", "stl", "STL", "gltf", "glb"]);
    rows.retain(|row| {
        let is_good = !row.name().starts_with("bad/") && row.text("expect").starts_with("load");
        is_good && row.number("faces") > 0
    });
    rows
}

fn open(row: &Row) -> SceneFile {
    let file = load(&row.path, None, &LoadOptions::default());
    let mut file = file.unwrap_or_else(|error| panic!("{}: {error}", row.name()));
    file.settings.size = SIZE;
    file
}

fn draw(name: &str, file: &SceneFile) -> Image {
    render(&file.scene(), &file.settings).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// Without a camera of its own.
fn framed(mut file: SceneFile) -> SceneFile {
    (file.camera, file.lights) = (None, None);
    file
}

/// How many columns and rows have something in them, and how many pixels of the picture's rim.
fn extent(image: &Image) -> ([usize; 2], usize) {
    let [width, height] = SIZE.map(|side| side as usize);
    let covered = |x: usize, y: usize| image.coverage[y * width + x] > 0;
    let columns = (0..width).filter(|&x| (0..height).any(|y| covered(x, y))).count();
    let rows = (0..height).filter(|&y| (0..width).any(|x| covered(x, y))).count();
    let is_rim = |x: usize, y: usize| x == 0 || y == 0 || x == width - 1 || y == height - 1;
    let all = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    ([columns, rows], all.filter(|&(x, y)| is_rim(x, y) && covered(x, y)).count())
}

/// Each good file with faces draws; framed by itself, all of it is in the picture and fills a good part of it.
#[test]
fn every_good_file_is_framed_well() {
    let mut wrong = Vec::new();
    for row in good_files() {
        let file = open(&row);
        let own = draw(row.name(), &file).statistics.covered_pixels;
        let image = draw(row.name(), &framed(file));
        let ([columns, rows], rim) = extent(&image);
        if own == 0 || rim > 0 || columns.max(rows) < 15 {
            wrong.push(format!(
                "{}: {own} pixels; {columns} columns, {rows} rows, {rim} at the rim",
                row.name()
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A file a thousand million times larger or smaller, and far from the origin, gives the same picture.
#[test]
fn size_and_place_do_not_matter() {
    let mut wrong = Vec::new();
    for row in good_files().into_iter().filter(|row| row.number("bytes") < 200_000) {
        let file = framed(open(&row));
        let expected = draw(row.name(), &file).statistics.covered_pixels;
        for (scale, offset) in [(1e9, 0.0), (1e-9, 0.0), (1e-9, 1e-4), (1.0, 1e3)] {
            let mut moved = file.clone();
            let map = DMat4::from_translation(DVec3::splat(offset)) * DMat4::from_scale(DVec3::splat(scale));
            moved.objects.iter_mut().for_each(|object| object.transform = map * object.transform);
            let covered = draw(row.name(), &moved).statistics.covered_pixels;
            // Roundings of rims.
            if covered.abs_diff(expected) > 4 {
                wrong.push(format!("{}: {scale:e} {offset:e}: {covered}, not {expected}", row.name()));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Many glTF files specify only that the material is metal. Pictures show a shape in many tones, no white silhouette.
#[test]
fn gltf_files_show_their_shape() {
    let mut wrong = Vec::new();
    for row in good_files() {
        let name = row.name();
        if !name.ends_with(".gltf") && !name.ends_with(".glb") {
            continue;
        }
        let file = framed(open(&row));
        // Unlit materials, and flat plates, have one tone each.
        let is_solid = file.scene().bounds().is_some_and(|(low, high)| {
            let size = high - low;
            size.min_element() > 0.05 * size.max_element()
        });
        if file.objects.iter().any(|object| object.given) || !is_solid {
            continue;
        }
        let image = draw(name, &file);
        let at = |x: u32, y: u32| image.pixel(x, y).unwrap();
        let all = (0..SIZE[1]).flat_map(|y| (0..SIZE[0]).map(move |x| (x, y)));
        let seen: Vec<_> = all
            .filter(|&(x, y)| image.coverage[(y * SIZE[0] + x) as usize] > 0)
            .map(|(x, y)| at(x, y))
            .collect();
        let white = seen.iter().filter(|pixel| pixel.iter().all(|&code| code == 255)).count();
        let mut tones: Vec<_> = seen.iter().map(|pixel| pixel[1]).collect();
        tones.sort_unstable();
        tones.dedup();
        // A box has as few tones as sides.
        let is_curved = row.number("faces") >= 200;
        // White matte surfaces that face the light are white.
        if 8 * white > seen.len() || is_curved && tones.len() < 20 {
            wrong.push(format!("{name}: {white} of {} pixels white, {} tones", seen.len(), tones.len()));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
