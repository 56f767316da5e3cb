//! Pictures of all scenes of `data/scenes`.

use super::{folder, names, scene};
use crease::num::LinearRgb;
use crease::raster::{Interpolation, RenderSettings, Shading, render};
use crease::report::{encode_png, probe_pixel};
use crease::shade::Guards;
use std::fs;

/// Distance of the pixels that are probed.
const STEP: usize = 23;

/// Every scene draws something, leaves some background, and at a grid of pixels what is computed again in double
/// precision is what the picture shows, to one step of 8 bits. `CREASE_PICTURES` names a folder for the pictures.
#[test]
fn every_scene_draws_and_its_probes_agree_with_its_picture() {
    let names = names();
    assert!(names.len() >= 20, "{names:?}");
    for name in names {
        let file = scene(&name);
        let (scene, settings) = (file.scene(), &file.settings);
        let image = render(&scene, settings).unwrap_or_else(|error| panic!("{name}: {error}"));
        let [width, height] = settings.size;
        let pixels = u64::from(width) * u64::from(height);
        assert!((pixels / 50..pixels).contains(&image.statistics.covered_pixels), "{name}");
        let mut probed = 0;
        for y in (STEP as u32 / 2..height).step_by(STEP) {
            for x in (STEP as u32 / 2..width).step_by(STEP) {
                let picture = image.pixel(x, y).unwrap();
                let report = probe_pixel(&scene, settings, [x, y], picture).unwrap();
                let near = report.computed.iter().zip(picture).all(|(a, b)| a.abs_diff(b) <= 1);
                assert!(near, "{name}: {report}");
                probed += usize::from(report.samples.iter().any(|sample| sample.seen.is_some()));
            }
        }
        assert!(probed > 10, "{name}: {probed}");
        if let Some(folder) = std::env::var_os("CREASE_PICTURES") {
            let file = encode_png(&image.into(), None, settings.transfer).unwrap();
            let name = format!("{}.png", name.replace('/', "-"));
            fs::write(std::path::Path::new(&folder).join(name), file).unwrap();
        }
    }
}

/// The examples have no notes.
#[test]
fn examples_have_nothing_to_note() {
    for name in names() {
        let notes = scene(&name).notes;
        // It uses the objects of a file without its camera and lights, as its first lines say.
        let expected = if name == "stage.toml" { 1 } else { 0 };
        assert_eq!(notes.len(), expected, "{name}: {notes:?}");
    }
}

/// Lecture scenes show the computed numbers themselves, and say so.
#[test]
fn scenes_of_lectures_have_no_transfer_curve() {
    for name in names().iter().filter(|name| name.starts_with("lectures/")) {
        assert_eq!(scene(name).settings.transfer, crease::num::Transfer::Direct, "{name}");
    }
}

/// The pixels and numbers that the comments of the lectures' scenes name are those of the tests.
#[test]
fn every_scene_of_the_lectures_says_which_pixel_to_probe() {
    for name in names().iter().filter(|name| name.starts_with("lectures/")) {
        let text = fs::read_to_string(folder().join(name)).unwrap();
        assert!(text.contains(&format!("crease render data/scenes/{name} --probe ")), "{name}");
    }
}

#[test]
fn settings_are_those_of_the_file() {
    let diamond = scene("diamond.toml");
    let expected = RenderSettings {
        size: [641, 241],
        shading: Shading::Gouraud,
        interpolation: Interpolation::Scanline,
        transfer: crease::num::Transfer::Direct,
        ..RenderSettings::default()
    };
    assert_eq!(diamond.settings, expected);
    assert_eq!(diamond.background, LinearRgb::grey(0.5));
    assert!(diamond.objects.iter().all(|object| object.given) && diamond.lights.is_none());
    let guards = scene("guards.toml").settings.guards;
    assert_eq!(guards, Guards { diffuse: true, ..Guards::literal() });
}

/// The centres that the scene's own comment names.
#[test]
fn the_diamond_turns_its_centre() {
    let file = scene("diamond.toml");
    let image = render(&file.scene(), &file.settings).unwrap();
    for (pixel, expected) in
        [([110, 120], [0.1, 0.5, 0.5]), ([320, 120], [0.15, 0.4, 0.3]), ([530, 120], [0.2, 0.3, 0.1])]
    {
        let picture = image.pixel(pixel[0], pixel[1]).unwrap();
        let report = probe_pixel(&file.scene(), &file.settings, pixel, picture).unwrap();
        for (got, expected) in report.linear.iter().zip(expected) {
            // A rotation by 45° and back, in double precision.
            assert!((got - expected).abs() < 1e-12, "{report}");
        }
    }
}
