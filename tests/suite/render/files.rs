//! Output files of `crease render`, and the files that it reads.

use super::{BEFORE, bytes, exists, gear, picture, render, report, square, with};
use crate::cli::{code, crease, path, text};
use image::AnimationDecoder;
use image::codecs::gif::GifDecoder;
use std::fs;
use std::io::Cursor;

fn frames(gif: &[u8]) -> Vec<image::Frame> {
    GifDecoder::new(Cursor::new(gif)).unwrap().into_frames().collect_frames().unwrap()
}

#[test]
fn a_picture_goes_to_a_file_and_the_report_to_standard_output() {
    let (folder, square) = square();
    let out = path(folder.path().join("new/square.png"));
    let output = render([square.as_str(), "-o", out.as_str(), "--size", "64x48"]);
    assert_eq!(code(&output), 0, "{}", text(&output.stderr));
    let reported = text(&output.stdout);
    for part in
        ["square.png", "1 object, 4 vertices, 1 face", "2 triangles", "png, 64x48, 8 bits, srgb", "time"]
    {
        assert!(reported.contains(part), "no {part:?} in\n{reported}");
    }
    // Its vertices have colours, which light does not show.
    let said = text(&output.stderr);
    assert!(said.lines().count() == 1 && said.contains("the vertex colours are not drawn"), "{said}");
    let decoded = image::open(&out).unwrap();
    assert_eq!((decoded.width(), decoded.height()), (64, 48));
    assert_eq!(fs::read(&out).unwrap(), bytes(&[square.as_str(), "--size", "64x48"]));
    let quiet = render([square.as_str(), "-o", out.as_str(), "-q"]);
    assert!(quiet.stdout.is_empty() && code(&quiet) == 0);
}

#[test]
fn the_report_moves_to_standard_error_when_the_picture_needs_standard_output() {
    let (_folder, square) = square();
    let output = render([square.as_str(), "-o", "-", "--json"]);
    assert!(output.stdout.starts_with(b"\x89PNG"));
    let report: serde_json::Value = serde_json::from_slice(&output.stderr).unwrap();
    assert_eq!(report["output"]["bytes"], output.stdout.len());
}

#[test]
fn a_mesh_may_come_from_standard_input() {
    let (_folder, square) = square();
    let mut command = crease();
    command.args(["render", "-", "--format", "obj", "-o", "-", "-q"]).args(BEFORE);
    let output = command.write_stdin(super::SQUARE).output().unwrap();
    assert_eq!(output.stdout, bytes(&with(&[square.as_str()], &BEFORE)));
}

/// Standard input has no folder for its materials. `--root` gives it one, and without it a note reports the missing file.
#[test]
fn materials_of_standard_input_come_from_the_root() {
    let [file, size, pixels] = gear();
    let text = std::fs::read(&file).unwrap();
    let root = path(crate::cli::data(""));
    let streamed = |more: &[&str]| {
        let mut command = crease();
        command.args(["render", "-", "--format", "obj", "-o", "-", &size, &pixels]).args(more);
        command.write_stdin(text.clone()).output().unwrap()
    };
    let reported = streamed(&[]);
    let said = crate::cli::text(&reported.stderr);
    assert!(
        said.contains("`gear.mtl` was not read, because a stream has no folder (--root names one)"),
        "{said}"
    );
    let rooted = streamed(&["--root", &root]);
    assert!(!crate::cli::text(&rooted.stderr).contains("gear.mtl"));
    assert!(rooted.stdout == bytes(&[file, size, pixels]) && rooted.stdout != reported.stdout);
}

#[test]
fn sixteen_bits_hold_the_eight() {
    let gear = gear();
    let eight = picture(&with(&gear, &["--transfer", "direct"]));
    let wide = bytes(&with(&gear, &["--transfer", "direct", "--bits", "16"]));
    let wide = image::load_from_memory(&wide).unwrap();
    assert_eq!(wide.color(), image::ColorType::Rgb16);
    for (eight, wide) in eight.pixels().zip(wide.into_rgb16().pixels()) {
        for (eight, wide) in eight.0.iter().zip(wide.0) {
            // Both are the nearest codes of the same number.
            assert!((f64::from(*eight) - f64::from(wide) / 257.0).abs() <= 0.51, "{eight} {wide}");
        }
    }
}

#[test]
fn a_turntable_turns_once() {
    let (folder, square) = square();
    let args = with(&with(&[square.as_str()], &BEFORE), &["--shading", "flat"]);
    let out = path(folder.path().join("spin.gif"));
    let turned = report(&with(&args, &["--turntable", "8", "-o", &out]));
    assert_eq!(turned["drawings"].as_array().unwrap().len(), 8);
    assert_eq!(turned["drawings"][2]["name"], "90°");
    let frames = frames(&fs::read(&out).unwrap());
    assert_eq!(frames.len(), 8);
    // 4 s a turn.
    assert!(frames.iter().all(|frame| frame.delay().numer_denom_ms() == (500, 1)));
    let still = picture(&args);
    let rgb = |frame: &image::Frame| -> Vec<[u8; 3]> {
        frame.buffer().pixels().map(|pixel| [pixel.0[0], pixel.0[1], pixel.0[2]]).collect()
    };
    let still: Vec<[u8; 3]> = still.pixels().map(|pixel| pixel.0).collect();
    // Eight flat frames with anti-aliased rims have few colours: the palette holds them within a cell or two.
    let far = |frame: &image::Frame| {
        let pairs = rgb(frame).into_iter().zip(still.iter().copied());
        pairs.flat_map(|(a, b)| (0..3).map(move |k| a[k].abs_diff(b[k]))).max().unwrap()
    };
    assert!(far(&frames[0]) <= 8, "{}", far(&frames[0]));
    assert!(far(&frames[1]) > 30);
    let quarter: Vec<[u8; 3]> =
        picture(&with(&args, &["--rotate", "0,90,0"])).pixels().map(|pixel| pixel.0).collect();
    let difference =
        rgb(&frames[2]).iter().zip(&quarter).flat_map(|(a, b)| (0..3).map(|k| a[k].abs_diff(b[k]))).max();
    assert!(difference <= Some(8), "{difference:?}");
}

/// WebP has the pixels of the PNG, JPEG is close to them; both by the name of the file, or by `--to` for a stream.
#[test]
fn pictures_may_be_jpeg_or_webp() {
    let folder = tempfile::tempdir().unwrap();
    let scene = path(std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("data/scenes/sphere.toml"));
    let draw = |name: &str| {
        let out = path(folder.path().join(name));
        let done = render([&scene, "--size", "64x48", "-o", &out, "-q"]);
        assert_eq!(code(&done), 0, "{}", text(&done.stderr));
        fs::read(out).unwrap()
    };
    let pixels = |bytes: &[u8]| image::load_from_memory(bytes).unwrap().into_rgb8();
    let png = pixels(&draw("a.png"));
    assert_eq!(pixels(&draw("a.webp")), png);
    let jpeg = draw("a.JPG");
    let off = pixels(&jpeg).iter().zip(png.iter()).map(|(a, b)| u64::from(a.abs_diff(*b))).sum::<u64>();
    let mean = off as f64 / png.len() as f64;
    assert!(mean > 0.0 && mean < 2.0, "{mean}");
    let streamed = render([&scene, "--size", "64x48", "--to", "jpeg", "-o", "-"]);
    assert_eq!(streamed.stdout, jpeg);
}

#[test]
fn a_still_picture_may_be_a_gif() {
    let (folder, square) = square();
    let out = path(folder.path().join("still.gif"));
    let output = render(with(&[square.as_str()], &["-o", &out, "--size", "32x32"]));
    assert_eq!(code(&output), 0);
    assert_eq!(frames(&fs::read(&out).unwrap()).len(), 1);
}

#[test]
fn panels_are_the_pictures_themselves() {
    let (_folder, square) = square();
    let args = with(&[square.as_str()], &["--size", "64x64", "--light", "point position=0.5,0.5,0.7"]);
    let sheet = picture(&with(&args, &["--compare", "flat,gouraud,phong"]));
    let found = |single: &image::RgbImage| {
        let fits = |x: u32, y: u32| {
            single.enumerate_pixels().all(|(i, j, pixel)| sheet.get_pixel(x + i, y + j) == pixel)
        };
        (0..=sheet.width() - 64).find(|&x| (0..=sheet.height() - 64).any(|y| fits(x, y)))
    };
    let places: Vec<u32> = ["flat", "gouraud", "phong"]
        .iter()
        .map(|shading| found(&picture(&with(&args, &["--shading", shading]))).expect(shading))
        .collect();
    assert!(places[0] + 64 < places[1] && places[1] + 64 < places[2], "{places:?}");
    let report = report(&with(&args, &["--compare", "flat,gouraud,phong"]));
    let names: Vec<&str> =
        report["drawings"].as_array().unwrap().iter().map(|d| d["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["flat", "gouraud", "phong"]);
}

/// The colours of the direct transfer have no standard that a viewer could apply.
#[test]
fn png_files_say_what_their_numbers_mean() {
    let (_folder, square) = square();
    let has = |args: &[&str], name: &[u8]| {
        bytes(&with(&[square.as_str()], args)).windows(4).any(|window| window == name)
    };
    assert!(has(&[], b"sRGB") && !has(&[], b"tEXt"));
    assert!(!has(&["--transfer", "direct"], b"sRGB") && has(&["--transfer", "direct"], b"tEXt"));
}

#[test]
fn a_failure_leaves_an_older_picture_alone() {
    let (folder, square) = square();
    let out = folder.path().join("old.png");
    fs::write(&out, "old").unwrap();
    let output = render([square.as_str(), "-o", &path(&out), "--shading", "exact"]);
    assert_eq!(code(&output), 3, "{}", text(&output.stderr));
    assert_eq!(fs::read(&out).unwrap(), b"old");
    assert!(exists(folder.path(), "square.obj"));
    assert_eq!(crate::cli::names(folder.path()), ["old.png", "square.obj"]);
}
