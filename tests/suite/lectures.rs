//! The worked numbers of the lecture notes (Medeiros Filho, *Iluminação e Sombreamento*, 2017), one test each: the
//! printed result where it is right, the exact one to every digit known, and each misprint by name.

use crate::shade::lit;
use crease::num::{LinearRgb, Transfer};
use crease::shade::{
    Attenuation, Explanation, Light, Material, Probe, Reflectance, Reflection, ShadeSettings, SurfacePoint,
    ToneRule, Viewer,
};
use glam::DVec3;

const WHITE: LinearRgb = LinearRgb::WHITE;
const YELLOW: LinearRgb = LinearRgb::new(1.0, 1.0, 0.0);

/// Holds a number to all digits of its text: within half a unit of the last.
#[track_caller]
pub fn digits(got: f64, expected: &str) {
    let decimals = expected.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let half = 0.5 * libm::pow(10.0, -(decimals as f64));
    let expected: f64 = expected.parse().unwrap();
    assert!((got - expected).abs() <= half * (1.0 + 1e-9), "{got}, not {expected}");
}

/// The same for each component.
#[track_caller]
pub fn all_digits(got: [f64; 3], expected: [&str; 3]) {
    got.into_iter().zip(expected).for_each(|(got, expected)| digits(got, expected));
}

fn viewer(x: f64, y: f64) -> ShadeSettings {
    ShadeSettings { viewer: Viewer::Towards(DVec3::new(x, y, 0.0)), ..ShadeSettings::default() }
}

fn grey_material(ka: f64, kd: f64, ks: f64, exponent: f64, reflection: Reflection) -> Material {
    Material {
        ambient: Reflectance::new(ka, WHITE),
        diffuse: Reflectance::new(kd, WHITE),
        specular: Reflectance::new(ks, WHITE),
        exponent,
        reflection,
    }
}

/// The object of examples 1 to 3.
fn example(reflection: Reflection) -> Material {
    grey_material(0.15, 0.7, 0.2, 2.0, reflection)
}

/// What happens at the origin of the floor y = 0.
fn explain(lights: &[Light], material: &Material, settings: &ShadeSettings) -> Explanation {
    let floor = SurfacePoint { position: [0.0; 3], normal: [0.0, 1.0, 0.0] };
    let explanation = Probe::new(lights, material, settings).unwrap().explain(&floor);
    assert_eq!(lit(lights, material, settings, DVec3::ZERO, DVec3::Y), explanation.sum);
    explanation
}

fn example_1() -> [Light; 2] {
    [
        Light::Ambient { colour: WHITE },
        Light::Directional { towards: DVec3::new(-4.0, 3.0, 0.0), colour: LinearRgb::grey(8.0) },
    ]
}

#[test]
fn example_1_phong() {
    let result = explain(&example_1(), &example(Reflection::Phong), &viewer(4.0, 2.0));
    digits(result.lights[0].n_dot_l, "0.600000000");
    all_digits(result.lights[0].reflected, ["0.800000000", "0.600000000", "0.000000000"]);
    digits(result.lights[0].v_dot_r, "0.983869910");
    all_digits(result.sum, ["5.058800000"; 3]);
}

#[test]
fn example_1_states_another_viewer_than_its_solution_uses() {
    // V = 4i + 2.5j in the statement, 4i + 2j in the solution.
    let phong = explain(&example_1(), &example(Reflection::Phong), &viewer(4.0, 2.5));
    all_digits(phong.sum, ["5.098494"; 3]);
    let blinn = explain(&example_1(), &example(Reflection::Blinn), &viewer(4.0, 2.5));
    all_digits(blinn.sum, ["5.107118"; 3]);
}

#[test]
fn example_1_blinn_whose_printed_length_of_l_plus_v_is_wrong() {
    let result = explain(&example_1(), &example(Reflection::Blinn), &viewer(4.0, 2.0));
    let light = &result.lights[0];
    all_digits(light.half.unwrap(), ["0.089805595", "0.995959314", "0.000000000"]);
    digits(light.n_dot_h.unwrap(), "0.995959314");
    all_digits(result.sum, ["5.097096"; 3]);
    // Printed: ‖5 + 4.472‖.
    let sum = DVec3::from_array(light.towards) + DVec3::from_array(result.view);
    digits(sum.length(), "1.051462224");
    // φ = 10.3048° and α = 5.1524°, exactly half (F6).
    let angle = |a: [f64; 3], b: [f64; 3]| {
        let (a, b) = (DVec3::from_array(a), DVec3::from_array(b));
        libm::atan2(a.cross(b).length(), a.dot(b)).to_degrees()
    };
    digits(angle(result.view, light.reflected), "10.3048");
    digits(angle(result.normal, light.half.unwrap()), "5.1524");
}

fn example_2(colour: LinearRgb) -> [Light; 2] {
    let position = DVec3::new(-40.0, 30.0, 0.0);
    [
        Light::Ambient { colour: WHITE },
        Light::Point { position, colour, attenuation: Attenuation::Offset(1.0) },
    ]
}

#[test]
fn example_2_whose_phong_result_is_cut_off_not_rounded() {
    let lights = example_2(LinearRgb::grey(8.0));
    let phong = explain(&lights, &example(Reflection::Phong), &viewer(4.0, 2.0));
    assert_eq!(phong.lights[0].distance, Some(50.0));
    assert_eq!(phong.lights[0].attenuation, 1.0 / 51.0);
    // Printed: 0.2462.
    all_digits(phong.sum, ["0.246250980"; 3]);
    let blinn = explain(&lights, &example(Reflection::Blinn), &viewer(4.0, 2.0));
    all_digits(blinn.sum, ["0.247001881"; 3]);
    // With the statement's viewer.
    all_digits(explain(&lights, &example(Reflection::Phong), &viewer(4.0, 2.5)).sum, ["0.247029"; 3]);
    all_digits(explain(&lights, &example(Reflection::Blinn), &viewer(4.0, 2.5)).sum, ["0.247198"; 3]);
}

#[test]
fn example_3_phong_which_drops_the_intensity_of_example_2() {
    let colour = LinearRgb::new(0.2, 0.7, 0.45);
    let result = explain(&example_2(colour), &example(Reflection::Phong), &viewer(4.0, 2.0));
    all_digits(result.sum, ["0.152406275", "0.158421961", "0.155414118"]);
    let kept = explain(&example_2(colour * 8.0), &example(Reflection::Phong), &viewer(4.0, 2.0));
    all_digits(kept.sum, ["0.169250", "0.217376", "0.193313"]);
}

#[test]
fn example_3_blinn_whose_green_and_blue_formulas_are_swapped() {
    let result =
        explain(&example_2(LinearRgb::new(0.2, 0.7, 0.45)), &example(Reflection::Blinn), &viewer(4.0, 2.0));
    // The values are right; only their formulas show each other's intensity.
    all_digits(result.sum, ["0.152425047", "0.158487665", "0.155456356"]);
    let swapped =
        explain(&example_2(LinearRgb::new(0.2, 0.45, 0.7)), &example(Reflection::Blinn), &viewer(4.0, 2.0));
    assert!(swapped.sum[1] < swapped.sum[2]);
}

/// Exercises 1.6.16 and 1.6.17: a yellow surface in white light from above, green ambient light of one half.
fn yellow(ka: f64, ks: f64) -> ([Light; 2], Material) {
    let lights = [
        Light::Ambient { colour: LinearRgb::new(0.0, 0.5, 0.0) },
        Light::Point { position: DVec3::Y, colour: WHITE, attenuation: Attenuation::None },
    ];
    let material = Material {
        ambient: Reflectance::new(ka, YELLOW),
        diffuse: Reflectance::new(0.6, YELLOW),
        ..grey_material(0.0, 0.0, ks, 1.0, Reflection::Phong)
    };
    (lights, material)
}

#[test]
fn exercise_1_6_16_whose_table_2_prints_a_blue_of_a_tenth() {
    // N·L = R·V = 1 is implied: light and viewer above.
    let (lights, matte) = yellow(0.2, 0.0);
    let without = explain(&lights, &matte, &viewer(0.0, 1.0)).sum;
    all_digits(without, ["0.600000000", "0.700000000", "0.000000000"]);
    let (lights, shiny) = yellow(0.2, 0.1);
    all_digits(
        explain(&lights, &shiny, &viewer(0.0, 1.0)).sum,
        ["0.700000000", "0.800000000", "0.100000000"],
    );
}

#[test]
fn exercise_1_6_17_whose_division_by_the_largest_is_cut_off() {
    let (lights, matte) = yellow(0.4, 0.0);
    let without = explain(&lights, &matte, &viewer(0.0, 1.0)).sum;
    all_digits(without, ["0.600000000", "0.800000000", "0.000000000"]);
    let (lights, shiny) = yellow(0.4, 0.3);
    let with = explain(&lights, &shiny, &viewer(0.0, 1.0));
    all_digits(with.sum, ["0.900000000", "1.100000000", "0.300000000"]);
    all_digits(with.colour, ["0.900000000", "1.000000000", "0.300000000"]);
    let by_largest = ShadeSettings { tone: ToneRule::DivideByMax, ..viewer(0.0, 1.0) };
    // Printed: 0.272 for the blue.
    all_digits(explain(&lights, &shiny, &by_largest).colour, ["0.818182", "1.000000", "0.272727"]);
}

#[test]
fn exercise_1_6_18_which_prints_n_dot_v_for_n_dot_l_and_a_tenth_for_one() {
    let lights = [
        Light::Ambient { colour: LinearRgb::new(0.0, 1.0, 0.0) },
        // At 60° from the normal: cos 60° = 0.5.
        Light::Point {
            position: DVec3::new(3_f64.sqrt(), 1.0, 0.0),
            colour: WHITE,
            attenuation: Attenuation::None,
        },
    ];
    let merged = |diffuse: LinearRgb| Material {
        ambient: Reflectance::Merged(LinearRgb::new(0.0, 0.5, 0.0)),
        diffuse: Reflectance::Merged(diffuse),
        specular: Reflectance::NONE,
        ..Material::default()
    };
    let k_d = LinearRgb::new(0.8, 0.6, 0.4);
    let target = ["0.400000000", "0.800000000", "0.200000000"];
    all_digits(explain(&lights, &merged(k_d), &viewer(0.0, 1.0)).sum, target);
    let colour = LinearRgb::new(0.8, 0.8, 0.4);
    let split = Material {
        ambient: Reflectance::new(0.5, colour),
        diffuse: Reflectance::new(1.0, colour),
        specular: Reflectance::NONE,
        ..Material::default()
    };
    all_digits(explain(&lights, &split, &viewer(0.0, 1.0)).sum, target);
    // k_d · 0.5 · 0.1, as printed, is far from it.
    let tenth = Material { diffuse: Reflectance::new(0.1, colour), ..split };
    all_digits(explain(&lights, &tenth, &viewer(0.0, 1.0)).sum, ["0.04", "0.44", "0.02"]);
}

#[test]
fn exercise_1_6_19_which_is_cut_off_and_reflects_more_than_it_gets() {
    let eye = DVec3::new(1.0, 1.0, 0.0);
    let lights = [
        Light::Ambient { colour: LinearRgb::new(0.0, 1.0, 0.0) },
        Light::Point { position: eye, colour: YELLOW, attenuation: Attenuation::None },
    ];
    let settings = ShadeSettings { viewer: Viewer::At(eye), ..ShadeSettings::default() };
    let phong = grey_material(0.2, 0.5, 0.7, 2.0, Reflection::Phong);
    // Printed: 0.3535, 0.5535.
    all_digits(explain(&lights, &phong, &settings).sum, ["0.353553391", "0.553553391", "0.000000000"]);
    let blinn = Material { reflection: Reflection::Blinn, ..phong };
    all_digits(explain(&lights, &blinn, &settings).sum, ["0.703553", "0.903553", "0.000000"]);
    // F1: k_d + k_s = 1.2.
    all_digits(phong.gain().unwrap().sum.to_array(), ["1.2"; 3]);
}

#[test]
fn exercise_1_6_23() {
    let degrees = |angle: f64| DVec3::new(libm::sin(angle.to_radians()), libm::cos(angle.to_radians()), 0.0);
    let light = Light::Directional { towards: degrees(-60.0), colour: WHITE };
    let settings = ShadeSettings { viewer: Viewer::Towards(degrees(30.0)), ..ShadeSettings::default() };
    let phong = Material {
        ambient: Reflectance::NONE,
        diffuse: Reflectance::NONE,
        specular: Reflectance::Merged(LinearRgb::new(1.0, 0.0, 0.0)),
        exponent: 2.0,
        reflection: Reflection::Phong,
    };
    all_digits(explain(&[light], &phong, &settings).sum, ["0.750000000", "0.000000000", "0.000000000"]);
    let blinn = Material { reflection: Reflection::Blinn, ..phong };
    digits(explain(&[light], &blinn, &settings).sum[0], "0.933013");
}

/// What a corner of a given colour sends to the viewer: the exercises give colours, and a surface that answers white ambient
/// light with one has it (F7).
fn given(colour: [f64; 3]) -> LinearRgb {
    let own = Material {
        ambient: Reflectance::Merged(colour.into()),
        diffuse: Reflectance::NONE,
        specular: Reflectance::NONE,
        ..Material::default()
    };
    explain(&[Light::Ambient { colour: WHITE }], &own, &viewer(0.0, 1.0)).sum.into()
}

/// I_a − (I_a − I_b) t (F19): along an edge, and along the scanline between two edges.
fn along(a: LinearRgb, b: LinearRgb, t: f64) -> LinearRgb {
    a * (1.0 - t) + b * t
}

#[test]
fn exercise_1_6_24() {
    let [p1, p2, p3] = [[1.0, 0.0, 0.8], [0.6, 0.4, 0.8], [0.2, 0.8, 0.0]].map(given);
    // The figure is lost; a triangle that fits is (2, 1), (6, 5), (10, 1). Its scanline y = 3 cuts two edges in their middles,
    // x = 4 and x = 8, and (6, 3) is the middle of the span.
    let t = |from: f64, to: f64, at: f64| (at - from) / (to - from);
    let (q, r) = (along(p1, p2, t(1.0, 5.0, 3.0)), along(p3, p2, t(1.0, 5.0, 3.0)));
    all_digits(along(q, r, t(4.0, 8.0, 6.0)).to_array(), ["0.600000000", "0.400000000", "0.600000000"]);
}

/// The corners v1 to v4 of the diamond of exercise 1.6.25.
const DIAMOND: [[f64; 3]; 4] = [[0.0, 0.4, 0.4], [0.0, 0.2, 0.2], [0.2, 0.6, 0.6], [0.4, 0.4, 0.0]];

#[test]
fn exercise_1_6_25_a_and_b() {
    let [v1, v2, v3, v4] = DIAMOND.map(given);
    // a, answer E: "flat" is the mean of the corners, in both positions.
    all_digits(((v1 + v2 + v3 + v4) * 0.25).to_array(), ["0.150000000", "0.400000000", "0.300000000"]);
    // b, answer C: the scanline through the centre meets v1 and v3, then v4 and v2.
    all_digits(along(v1, v3, 0.5).to_array(), ["0.100000000", "0.500000000", "0.500000000"]);
    all_digits(along(v4, v2, 0.5).to_array(), ["0.200000000", "0.300000000", "0.100000000"]);
}

/// Can the centre be (0.6, 0.8, 0.8)? Not from colours of corners, none of which is so bright; under Phong's shading it can
/// (answer C), here by a highlight that all corners miss: they lean by 45°, where V·R = cos 90°.
#[test]
fn exercise_1_6_25_c() {
    let lights = [Light::Ambient { colour: WHITE }, Light::Directional { towards: DVec3::Z, colour: WHITE }];
    let settings = ShadeSettings { viewer: Viewer::Towards(DVec3::Z), ..ShadeSettings::default() };
    let shade = |own: LinearRgb, normal: DVec3| {
        let material = Material {
            ambient: Reflectance::Merged(own),
            diffuse: Reflectance::NONE,
            specular: Reflectance::Merged(LinearRgb::new(0.5, 0.3, 0.3)),
            exponent: 8.0,
            reflection: Reflection::Phong,
        };
        lit(&lights, &material, &settings, DVec3::ZERO, normal.normalize())
    };
    let leaning = [DVec3::NEG_X, DVec3::NEG_Y, DVec3::X, DVec3::Y].map(|side| DVec3::Z + side);
    for (colour, normal) in DIAMOND.into_iter().zip(leaning) {
        all_digits(shade(colour.into(), normal), colour.map(|c| format!("{c:.9}")).each_ref().map(|c| &**c));
    }
    let middle = along(DIAMOND[0].into(), DIAMOND[2].into(), 0.5);
    let normal = (leaning[0] + leaning[2]) * 0.5;
    all_digits(shade(middle, normal), ["0.600000000", "0.800000000", "0.800000000"]);
}

#[test]
fn exercise_1_6_29() {
    // A blue object in red light is black, exactly.
    let red = Light::Directional { towards: DVec3::Y, colour: LinearRgb::new(1.0, 0.0, 0.0) };
    let blue = Material::matte(LinearRgb::new(0.0, 0.0, 1.0));
    assert_eq!(lit(&[red], &blue, &viewer(0.0, 1.0), DVec3::ZERO, DVec3::Y), [0.0; 3]);
}

#[test]
fn exercise_1_6_31_whose_distance_is_misprinted() {
    let lights = [
        Light::Ambient { colour: LinearRgb::new(0.8, 0.5, 0.2) },
        Light::Point {
            position: DVec3::new(-50.0, 30.0, 0.0),
            colour: YELLOW,
            // k = 1 is not stated, only used.
            attenuation: Attenuation::Offset(1.0),
        },
    ];
    let colour = LinearRgb::new(0.5, 1.0, 0.7);
    let phong = Material {
        ambient: Reflectance::new(0.4, colour),
        diffuse: Reflectance::new(0.5, colour),
        // O_s = O_d is not stated either.
        specular: Reflectance::new(0.3, colour),
        exponent: 3.0,
        reflection: Reflection::Phong,
    };
    let result = explain(&lights, &phong, &viewer(3.0, 2.0));
    let light = &result.lights[0];
    // Printed: 58.30851.
    digits(light.distance.unwrap(), "58.309518948");
    digits(light.n_dot_l, "0.514495755");
    digits(light.v_dot_r, "0.998868138");
    all_digits(result.sum, ["0.164689217", "0.209378433", "0.056000000"]);
    assert_eq!(result.colour.map(|component| Transfer::Direct.to_u8(component)), [42, 53, 14]);
    let white = Material { specular: Reflectance::new(0.3, WHITE), ..phong };
    digits(explain(&lights, &white, &viewer(3.0, 2.0)).sum[0], "0.167209743");
    let blinn = Material { reflection: Reflection::Blinn, ..phong };
    let sum = explain(&lights, &blinn, &viewer(3.0, 2.0)).sum;
    all_digits(sum, ["0.164695648", "0.209391296", "0.056000000"]);
}
