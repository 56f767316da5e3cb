//! The worked numbers of the lecture notes, each in a probe of a pixel of its scene.

use super::scene;
use crate::lectures::{all_digits, digits};
use crease::num::LinearRgb;
use crease::raster::ProbePoint;
use crease::raster::{FlatSample, SceneFile, Shading, render};
use crease::report::{PixelReport, probe_pixel};
use crease::shade::{Explanation, Light, Reflectance, Reflection, ToneRule};
use glam::DVec3;

/// The middle of the picture.
const MIDDLE: [u32; 2] = [320, 240];

/// The probe of a pixel. Asserts that the picture shows the same colour.
fn probe(file: &SceneFile, pixel: [u32; 2]) -> PixelReport {
    let scene = file.scene();
    let image = render(&scene, &file.settings).unwrap();
    let report =
        probe_pixel(&scene, &file.settings, pixel, image.pixel(pixel[0], pixel[1]).unwrap()).unwrap();
    for (computed, picture) in report.computed.iter().zip(report.picture) {
        assert!(computed.abs_diff(picture) <= 1, "{report}");
    }
    report
}

fn seen(report: &PixelReport) -> &ProbePoint {
    let [sample] = &report.samples[..] else { panic!("one sample a pixel") };
    sample.seen.as_ref().unwrap()
}

/// The explanation of the light at the only point that is lit.
fn explanation(report: &PixelReport) -> &Explanation {
    let [lit] = &seen(report).lit[..] else { panic!("one point is lit") };
    lit.light.as_ref().unwrap()
}

fn by(reflection: Reflection, mut file: SceneFile) -> SceneFile {
    file.objects.iter_mut().for_each(|object| object.material.reflection = reflection);
    file
}

/// The statements of examples 1 and 2 have another viewer than their solutions: V = 4i + 2.5j.
fn as_stated(mut file: SceneFile) -> SceneFile {
    file.camera.as_mut().unwrap().eye = DVec3::new(4.0, 2.5, 0.0);
    file
}

#[test]
fn example_1() {
    let name = "lectures/example-01.toml";
    let phong = probe(&scene(name), MIDDLE);
    let light = &explanation(&phong).lights[0];
    digits(light.n_dot_l, "0.600000000");
    all_digits(light.reflected, ["0.800000000", "0.600000000", "0.000000000"]);
    digits(light.v_dot_r, "0.983869910");
    all_digits(phong.linear, ["5.058800000"; 3]);
    let blinn = probe(&by(Reflection::Blinn, scene(name)), MIDDLE);
    let light = &explanation(&blinn).lights[0];
    all_digits(light.half.unwrap(), ["0.089805595", "0.995959314", "0.000000000"]);
    digits(light.n_dot_h.unwrap(), "0.995959314");
    all_digits(blinn.linear, ["5.097096"; 3]);
    // Misprinted: the length of L + V, as ‖5 + 4.472‖.
    let sum = DVec3::from(light.towards) + DVec3::from(explanation(&blinn).view);
    digits(sum.length(), "1.051462224");
    all_digits(probe(&as_stated(scene(name)), MIDDLE).linear, ["5.098494"; 3]);
    all_digits(probe(&as_stated(by(Reflection::Blinn, scene(name))), MIDDLE).linear, ["5.107118"; 3]);
}

#[test]
fn example_2_whose_phong_result_is_cut_off_not_rounded() {
    let name = "lectures/example-02.toml";
    let phong = probe(&scene(name), MIDDLE);
    digits(explanation(&phong).lights[0].distance.unwrap(), "50.000000000");
    digits(explanation(&phong).lights[0].attenuation, "0.019607843");
    // Printed: 0.2462.
    all_digits(phong.linear, ["0.246250980"; 3]);
    let blinn = by(Reflection::Blinn, scene(name));
    all_digits(probe(&blinn, MIDDLE).linear, ["0.247001881"; 3]);
    all_digits(probe(&as_stated(scene(name)), MIDDLE).linear, ["0.247029"; 3]);
    all_digits(probe(&as_stated(blinn), MIDDLE).linear, ["0.247198"; 3]);
}

#[test]
fn example_3_which_drops_an_intensity_and_swaps_two_formulas() {
    let name = "lectures/example-03.toml";
    let phong = scene(name);
    all_digits(probe(&phong, MIDDLE).linear, ["0.152406275", "0.158421961", "0.155414118"]);
    // With the intensity 8 of example 2.
    let mut kept = phong.clone();
    let Some([_, Light::Point { colour, .. }]) = kept.lights.as_deref_mut() else { panic!("two lights") };
    *colour = *colour * 8.0;
    all_digits(probe(&kept, MIDDLE).linear, ["0.169250", "0.217376", "0.193313"]);
    // Misprinted: the formulas of green and blue show each other's intensity; the values are right.
    let blinn = by(Reflection::Blinn, phong);
    all_digits(probe(&blinn, MIDDLE).linear, ["0.152425047", "0.158487665", "0.155456356"]);
}

#[test]
fn exercise_1_6_16_whose_table_2_prints_a_blue_of_a_tenth() {
    let file = scene("lectures/exercise-1-6-16.toml");
    let matte = probe(&file, [200, 240]);
    digits(explanation(&matte).lights[0].n_dot_l, "1.000000000");
    all_digits(matte.linear, ["0.600000000", "0.700000000", "0.000000000"]);
    let shiny = probe(&file, [440, 240]);
    digits(explanation(&shiny).lights[0].v_dot_r, "1.000000000");
    all_digits(shiny.linear, ["0.700000000", "0.800000000", "0.100000000"]);
}

#[test]
fn exercise_1_6_17_whose_division_by_the_largest_is_cut_off() {
    let mut file = scene("lectures/exercise-1-6-17.toml");
    all_digits(probe(&file, [200, 240]).linear, ["0.600000000", "0.800000000", "0.000000000"]);
    let shiny = probe(&file, [440, 240]);
    all_digits(shiny.linear, ["0.900000000", "1.100000000", "0.300000000"]);
    all_digits(explanation(&shiny).colour, ["0.900000000", "1.000000000", "0.300000000"]);
    file.settings.tone = ToneRule::DivideByMax;
    let by_largest = probe(&file, [440, 240]);
    // Printed: 0.272 for the blue.
    all_digits(explanation(&by_largest).colour, ["0.818182", "1.000000", "0.272727"]);
    assert_eq!(by_largest.picture, [209, 255, 70]);
}

#[test]
fn exercise_1_6_18_which_prints_n_dot_v_for_n_dot_l_and_a_tenth_for_one() {
    let mut file = scene("lectures/exercise-1-6-18.toml");
    for pixel in [[200, 240], [440, 240]] {
        let report = probe(&file, pixel);
        digits(explanation(&report).lights[0].n_dot_l, "0.500000000");
        all_digits(report.linear, ["0.400000000", "0.800000000", "0.200000000"]);
    }
    // k_d · 0.5 · 0.1, as printed, is far from it.
    file.objects[1].material.diffuse = Reflectance::new(0.1, LinearRgb::new(0.8, 0.8, 0.4));
    all_digits(probe(&file, [440, 240]).linear, ["0.04", "0.44", "0.02"]);
}

#[test]
fn exercise_1_6_19_which_is_cut_off_and_reflects_more_than_it_gets() {
    let file = scene("lectures/exercise-1-6-19.toml");
    let phong = probe(&file, MIDDLE);
    let light = &explanation(&phong).lights[0];
    // cos 45° and cos 90°.
    digits(light.n_dot_l, "0.707106781");
    digits(light.v_dot_r, "0.000000000");
    // Printed: 0.3535, 0.5535.
    all_digits(phong.linear, ["0.353553391", "0.553553391", "0.000000000"]);
    // F1: k_d + k_s = 1.2.
    all_digits(file.objects[0].material.gain().unwrap().sum.to_array(), ["1.2"; 3]);
    all_digits(probe(&by(Reflection::Blinn, file), MIDDLE).linear, ["0.703553", "0.903553", "0.000000"]);
}

#[test]
fn exercise_1_6_23() {
    let file = scene("lectures/exercise-1-6-23.toml");
    let phong = probe(&file, MIDDLE);
    digits(explanation(&phong).lights[0].n_dot_l, "0.500000000");
    all_digits(phong.linear, ["0.750000000", "0.000000000", "0.000000000"]);
    digits(probe(&by(Reflection::Blinn, file), MIDDLE).linear[0], "0.933013");
}

#[test]
fn exercise_1_6_24() {
    let report = probe(&scene("lectures/exercise-1-6-24.toml"), MIDDLE);
    all_digits(report.linear, ["0.600000000", "0.400000000", "0.600000000"]);
    all_digits(seen(&report).position, ["6.000000000", "3.000000000", "0.000000000"]);
    // P1 and P3 by a quarter each, P2 by half.
    for (vertex, weight) in seen(&report).vertices.iter().zip(&seen(&report).weights) {
        digits(*weight, if *vertex == 1 { "0.500000000" } else { "0.250000000" });
    }
}

const POSITIONS: [[u32; 2]; 2] = [[170, 240], [470, 240]];

#[test]
fn exercise_1_6_25() {
    let mut file = scene("lectures/exercise-1-6-25.toml");
    // b, answer C.
    let expected =
        [["0.100000000", "0.500000000", "0.500000000"], ["0.200000000", "0.300000000", "0.100000000"]];
    for (pixel, expected) in POSITIONS.into_iter().zip(expected) {
        all_digits(probe(&file, pixel).linear, expected);
    }
    // c: no colour of the picture is above those of the corners, so none is (0.6, 0.8, 0.8).
    file.settings.keep_linear = true;
    let image = render(&file.scene(), &file.settings).unwrap();
    let covered = image.linear.unwrap().into_iter().zip(&image.coverage).filter(|(_, n)| **n > 0);
    let largest = covered.fold([0.0_f32; 3], |most, (colour, _)| [0, 1, 2].map(|k| most[k].max(colour[k])));
    assert_eq!(largest.map(|component| component <= 0.6), [true; 3], "{largest:?}");
    assert!(largest[0] > 0.35 && largest[1] > 0.55, "{largest:?}");
    // a, answer E; the mean of the corners' colours, "flat" as the exercise has it.
    file.settings.shading = Shading::Flat;
    for flat_sample in [FlatSample::VertexMean, FlatSample::Centroid] {
        file.settings.flat_sample = flat_sample;
        for pixel in POSITIONS {
            all_digits(probe(&file, pixel).linear, ["0.150000000", "0.400000000", "0.300000000"]);
        }
    }
}

#[test]
fn exercise_1_6_29() {
    let report = probe(&scene("lectures/exercise-1-6-29.toml"), MIDDLE);
    assert_eq!((report.linear, report.picture), ([0.0; 3], [0; 3]));
    // The light falls on the ball, which returns nothing of its colour.
    let light = &explanation(&report).lights[0];
    assert!(light.n_dot_l > 0.0 && light.half.is_some() && light.v_dot_r.is_finite(), "{light:?}");
    assert_eq!((light.diffuse.guarded, light.specular.guarded), ([0.0; 3], [0.0; 3]));
    let text = report.to_string();
    for word in ["light 0, ", "N·L ", "R  ", "H  ", "diffuse    (0.000000000, 0.000000000, 0.000000000)"] {
        assert!(text.contains(word), "no {word:?} in\n{text}");
    }
}

#[test]
fn exercise_1_6_31_whose_distance_is_misprinted() {
    let file = scene("lectures/exercise-1-6-31.toml");
    let phong = probe(&file, MIDDLE);
    let light = &explanation(&phong).lights[0];
    // Printed: 58.30851.
    digits(light.distance.unwrap(), "58.309518948");
    digits(light.n_dot_l, "0.514495755");
    digits(light.v_dot_r, "0.998868138");
    all_digits(phong.linear, ["0.164689217", "0.209378433", "0.056000000"]);
    assert_eq!((phong.computed, phong.picture), ([42, 53, 14], [42, 53, 14]));
    let mut white = file.clone();
    white.objects[0].material.specular = Reflectance::new(0.3, LinearRgb::WHITE);
    digits(probe(&white, MIDDLE).linear[0], "0.167209743");
    let blinn = probe(&by(Reflection::Blinn, file), MIDDLE);
    all_digits(blinn.linear, ["0.164695648", "0.209391296", "0.056000000"]);
}
