//! The numbers behind a pixel.

use super::{BEFORE, gear, picture, render, report, square, with};
use crate::cli::{code, text};

/// The lamp of the tests at an angle of 60° to the square's normal.
const LAMP: [&str; 6] =
    ["--light", "directional towards=1.7320508075688772,0,1", "--ambient", "0.5", "--transfer", "direct"];

#[test]
fn a_student_can_follow_the_formula() {
    let (_folder, square) = square();
    let args = with(&with(&[square.as_str()], &BEFORE), &LAMP);
    let args =
        with(&args, &["--samples", "1", "--material", "colour=1 ka=0.2 kd=0.6 ks=0", "--probe", "20,20"]);
    let output = render(&args);
    assert_eq!(code(&output), 0, "{}", text(&output.stderr));
    let reported = text(&output.stdout);
    for part in [
        "pixel        (20, 20)",
        "object 0, face 0",
        "weight 0.",
        "N            (0.000000000, 0.000000000, 1.000000000)",
    ] {
        assert!(reported.contains(part), "no {part:?} in\n{reported}");
    }
    for part in ["N·L        0.500000000", "L          (0.866025404, 0.000000000, 0.500000000), at infinity"]
    {
        assert!(reported.contains(part), "no {part:?} in\n{reported}");
    }
    // 0.5 · 0.2 of ambient light and 0.6 · 0.5 of the lamp.
    for part in [
        "ambient      (0.100000000",
        "sum          (0.400000000",
        "8-bit        [102, 102, 102], in the picture [102, 102, 102]",
    ] {
        assert!(reported.contains(part), "no {part:?} in\n{reported}");
    }
    let report = report(&args);
    let sample = &report["probe"]["samples"][0];
    // Two roundings: of the lamp's direction and of the product.
    let n_dot_l = sample["lit"][0]["light"]["lights"][0]["n_dot_l"].as_f64().unwrap();
    assert!((n_dot_l - 0.5).abs() <= 2.0 * f64::EPSILON, "{n_dot_l}");
    assert_eq!(sample["face"], 0);
    let weights: f64 = sample["weights"].as_array().unwrap().iter().map(|w| w.as_f64().unwrap()).sum();
    assert!((weights - 1.0).abs() < 1e-12);
}

/// The second computation agrees with the picture within one step, in every mode.
#[test]
fn recomputed_pixels_are_those_of_the_picture() {
    let gear = gear();
    for more in [
        &["--shading", "flat"][..],
        &["--shading", "flat", "--flat-sample", "vertex-mean"],
        &["--shading", "gouraud", "--interpolation", "scanline"],
        &["--shading", "gouraud", "--interpolation", "affine"],
        &["--shading", "phong", "--light", "point position=1,3,2 attenuation=offset:1"],
        &["--shading", "phong", "--samples", "16"],
        &["--literal", "--samples", "1"],
        &["--terminator", "soft", "--light", "directional towards=1,0.2,0.1"],
        &["--terminator", "hard", "--light", "directional towards=1,0.2,0.1"],
    ] {
        let args = with(&gear, more);
        let shown = picture(&args);
        for at in [[48, 36], [30, 20], [60, 50], [20, 40], [70, 30], [2, 2]] {
            let place = format!("{},{}", at[0], at[1]);
            let report = report(&with(&args, &["--probe", &place]));
            let codes = |name: &str| -> Vec<u8> {
                let list = report["probe"][name].as_array().unwrap_or_else(|| panic!("{report}"));
                list.iter().map(|code| code.as_u64().unwrap() as u8).collect()
            };
            let (computed, own) = (codes("computed"), codes("picture"));
            assert_eq!(own, shown.get_pixel(at[0], at[1]).0);
            // One step of the code.
            assert!(
                computed.iter().zip(&own).all(|(a, b)| a.abs_diff(*b) <= 1),
                "{more:?} {at:?}: {computed:?} {own:?}"
            );
        }
    }
}

#[test]
fn outside_and_next_to_the_mesh() {
    let gear = gear();
    let next_to = render(with(&gear, &["--probe", "0,0"]));
    assert!(text(&next_to.stdout).contains("background only"), "{}", text(&next_to.stdout));
    let outside = render(with(&gear, &["--probe", "96,0"]));
    assert_eq!(code(&outside), 2);
    assert!(text(&outside.stderr).contains("outside the picture of 96x72"), "{}", text(&outside.stderr));
}

/// A lamp in the plate that it lights, which single precision misses by a little: a value that is not finite is an error, in
/// probes as in pictures.
#[test]
fn a_pixel_without_a_number_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("lamp.toml");
    let scene = r#"
        [settings]
        size = [3, 3]
        [camera]
        eye = [0, 1, 0]
        target = [0, 0, 0]
        up = [0, 0, 1]
        height = 0.001
        [[light.point]]
        position = [0, 0, 0]
        attenuation = { quadratic = [1, 1, 1] }
        [[object]]
        polygons = { vertices = [[-2, 0, -2], [-2, 0, 2], [2, 0, 2], [2, 0, -2]], faces = [[0, 1, 2, 3]] }
    "#;
    std::fs::write(&path, scene).unwrap();
    let output = render([path.to_str().unwrap(), "--probe", "1,1"]);
    assert_eq!(code(&output), 3, "{}", text(&output.stdout));
    let said = text(&output.stderr);
    assert!(said.contains("object 0: no finite colour at (0, 0, 0)") && said.contains("light 0"), "{said}");
}
