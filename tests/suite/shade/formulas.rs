//! The formulas F1 to F17, F25 and F29 of the lectures, one test each; the table in the documentation of `shade` names
//! them.

use super::{ambient, direction, lit, sun, uniform};
use crate::random::Random;
use crease::num::{Degrees, LinearRgb, Radians};
use crease::shade::{
    AreaShape, Attenuation, Cone, DepthCue, Guards, Light, Material, Probe, Reflectance, Reflection,
    ShadeSettings, Shader, SurfacePoint, ToneRule, Viewer, blinn_exponent, fresnel, phong_exponent, reflect,
};
use glam::{DVec3, DVec4};

const WHITE: LinearRgb = LinearRgb::WHITE;

/// Only one kind of reflection, white.
fn only_diffuse() -> Material {
    Material {
        ambient: Reflectance::NONE,
        diffuse: Reflectance::Merged(WHITE),
        specular: Reflectance::NONE,
        ..Material::default()
    }
}

fn only_specular(exponent: f64, reflection: Reflection) -> Material {
    Material {
        ambient: Reflectance::NONE,
        diffuse: Reflectance::NONE,
        specular: Reflectance::Merged(WHITE),
        exponent,
        reflection,
    }
}

fn towards(view: DVec3) -> ShadeSettings {
    ShadeSettings { viewer: Viewer::Towards(view), ..ShadeSettings::default() }
}

fn point_light(position: DVec3, attenuation: Attenuation) -> Light {
    Light::Point { position, colour: WHITE, attenuation }
}

fn first(colour: [f64; 3]) -> f64 {
    colour[0]
}

/// A few roundings of numbers of this size.
#[track_caller]
fn close(got: f64, expected: f64) {
    assert!((got - expected).abs() <= 1e-14 * expected.abs().max(1.0), "{got}, not {expected}");
}

#[test]
fn f1_more_light_out_than_in_is_a_warning() {
    let of = |kd, ks| Material {
        diffuse: Reflectance::new(kd, WHITE),
        specular: Reflectance::new(ks, WHITE),
        ..Material::default()
    };
    // Sums of 1 with and without a rounding error.
    assert!([(0.7, 0.3), (0.1, 0.9), (0.35, 0.65)].iter().all(|&(kd, ks)| of(kd, ks).gain().is_none()));
    let material = of(0.5, 0.7);
    let text = material.gain().unwrap().to_string();
    assert!(text.contains("1.200 in red, 1.200 in green, 1.200 in blue"), "{text}");
    // The sum of each component counts: a red and a green coat have no component in common.
    let apart = Material {
        diffuse: Reflectance::new(0.9, LinearRgb::new(1.0, 0.0, 0.0)),
        specular: Reflectance::new(0.9, LinearRgb::new(0.0, 1.0, 0.0)),
        ..Material::default()
    };
    assert_eq!(apart.gain(), None);
}

#[test]
fn f2_the_mirrored_ray_has_the_same_angle_in_the_same_plane() {
    let mut random = Random(1);
    for _ in 0..500 {
        let (normal, light) = (direction(&mut random), direction(&mut random));
        let mirrored = reflect(normal, light);
        close(mirrored.dot(normal), light.dot(normal));
        close(mirrored.dot(normal.cross(light)), 0.0);
        close(mirrored.cross(normal).length(), light.cross(normal).length());
    }
}

#[test]
fn f3_lambert_is_the_cosine_and_nothing_from_behind() {
    for angle in [0.0, 30.0, 60.0, 89.0, 90.0, 91.0, 180.0_f64] {
        let cosine = libm::cos(angle.to_radians());
        let light = sun(libm::sin(angle.to_radians()), 0.0, cosine);
        let got = first(lit(&[light], &only_diffuse(), &towards(DVec3::Z), DVec3::ZERO, DVec3::Z));
        close(got, cosine.max(0.0));
    }
}

#[test]
fn f4_phong_is_the_cosine_to_the_mirrored_ray_to_the_nth() {
    let mut random = Random(2);
    for exponent in [1.0, 2.0, 7.5, 40.0] {
        for _ in 0..200 {
            let (normal, light, view) =
                (direction(&mut random), direction(&mut random), direction(&mut random));
            let got = first(lit(
                &[sun(light.x, light.y, light.z)],
                &only_specular(exponent, Reflection::Phong),
                &towards(view),
                DVec3::ZERO,
                normal,
            ));
            let cosine = reflect(normal, light).dot(view);
            let lit = cosine > 0.0 && normal.dot(light) > 0.0;
            // n roundings of the cosine's last digits.
            let expected = if lit { libm::pow(cosine, exponent) } else { 0.0 };
            assert!((got - expected).abs() < exponent * 2e-15, "{got}, not {expected}");
        }
    }
}

#[test]
fn f5_the_probe_reports_the_mirrored_ray() {
    let mut random = Random(3);
    for _ in 0..200 {
        let (normal, light, view) = (direction(&mut random), direction(&mut random), direction(&mut random));
        let point = SurfacePoint { position: [0.0; 3], normal: normal.to_array() };
        let probe =
            Probe::new(&[sun(light.x, light.y, light.z)], &Material::default(), &towards(view)).unwrap();
        let explanation = probe.explain(&point);
        let expected = normal * (2.0 * normal.dot(light)) - light;
        // Roundings of three components below 2.
        assert!(DVec3::from_array(explanation.lights[0].reflected).distance(expected) < 2e-15);
        close(explanation.lights[0].v_dot_r, expected.dot(view));
    }
}

#[test]
fn f6_in_the_plane_the_half_vector_halves_the_angle() {
    let at = |angle: f64| DVec3::new(libm::sin(angle.to_radians()), 0.0, libm::cos(angle.to_radians()));
    for (light, view) in [(-60.0, 30.0), (-20.0, 70.0), (10.0, 40.0), (-45.0, 45.0)] {
        let (l, v) = (at(light), at(view));
        for exponent in [1.0, 8.0] {
            let blinn = only_specular(exponent, Reflection::Blinn);
            let got = first(lit(&[sun(l.x, l.y, l.z)], &blinn, &towards(v), DVec3::ZERO, DVec3::Z));
            // φ between V and R = −light angle; α = φ/2.
            let alpha = (view + light) / 2.0;
            assert!((got - libm::pow(libm::cos(alpha.to_radians()), exponent)).abs() < 1e-14);
        }
    }
}

#[test]
fn f6_far_light_and_viewer_give_what_near_ones_give_in_the_limit() {
    let blinn = only_specular(16.0, Reflection::Blinn);
    let (l, v) = (DVec3::new(-1.0, 0.5, 2.0).normalize(), DVec3::new(0.8, 0.1, 1.0).normalize());
    let same_half = first(lit(&[sun(l.x, l.y, l.z)], &blinn, &towards(v), DVec3::ZERO, DVec3::Z));
    for distance in [1e3, 1e6] {
        let settings = ShadeSettings { viewer: Viewer::At(v * distance), ..ShadeSettings::default() };
        let light = point_light(l * distance, Attenuation::None);
        // Off the axis of both: the error of direction is 1/distance, of the highlight up to √(n/e) times that.
        let got = first(lit(&[light], &blinn, &settings, DVec3::X, DVec3::Z));
        assert!((got - same_half).abs() < 3.0 / distance, "{got}, not {same_half} at {distance}");
    }
}

#[test]
fn f6_blinn_with_four_times_the_exponent_is_close_to_phong() {
    assert_eq!((blinn_exponent(8.0), phong_exponent(32.0)), (32.0, 8.0));
    // reference §3.7: the largest difference of cosⁿ φ and cos⁴ⁿ(φ/2).
    for (n, published) in
        [(1.0, 0.25), (2.0, 0.0902), (5.0, 0.0301), (10.0, 0.01425), (50.0, 0.00273), (200.0, 0.00068)]
    {
        let difference = |exponent: f64| {
            (0..9000)
                .map(|i| f64::from(i) / 100.0 * std::f64::consts::PI / 180.0)
                .map(|phi| libm::pow(libm::cos(phi), n) - libm::pow(libm::cos(phi / 2.0), exponent))
                .fold(0.0, |worst: f64, d| worst.max(d.abs()))
        };
        // The last digit given.
        assert!((difference(blinn_exponent(n)) / published - 1.0).abs() < 0.01, "n = {n}");
        assert!(difference(n) > 0.4);
    }
}

#[test]
fn f7_ambient_light_is_everywhere_the_same() {
    let material =
        Material { ambient: Reflectance::new(0.25, LinearRgb::new(1.0, 0.5, 0.0)), ..Material::default() };
    let settings = ShadeSettings {
        viewer: Viewer::At(DVec3::Z * 9.0),
        depth_cue: Some(DepthCue { k: 0.0 }),
        ..ShadeSettings::default()
    };
    let mut random = Random(4);
    for _ in 0..20 {
        let (position, normal) = (direction(&mut random), direction(&mut random));
        assert_eq!(lit(&[ambient(0.5)], &material, &settings, position, normal), [0.125, 0.0625, 0.0]);
    }
}

#[test]
fn f8_the_terms_add_up() {
    let lights = [ambient(0.3), sun(1.0, 2.0, 3.0)];
    let (view, normal) = (DVec3::new(-1.0, 0.0, 2.0), DVec3::new(0.1, 0.2, 0.9));
    for reflection in [Reflection::Phong, Reflection::Blinn] {
        let material = Material { reflection, ..Material::default() };
        let sum = first(lit(&lights, &material, &towards(view), DVec3::ZERO, normal));
        let (n, l, v) = (normal.normalize(), DVec3::new(1.0, 2.0, 3.0).normalize(), view.normalize());
        let cosine = match reflection {
            Reflection::Phong => reflect(n, l).dot(v),
            Reflection::Blinn => n.dot((l + v).normalize()),
        };
        close(sum, 0.3 * 0.1 * 0.8 + 0.7 * 0.8 * n.dot(l) + 0.2 * libm::pow(cosine, 32.0));
    }
}

#[test]
fn f9_three_attenuations_with_the_distance_to_the_light() {
    let at = |attenuation: Attenuation, d: f64| {
        let light = point_light(DVec3::Z * d, attenuation);
        first(lit(&[light], &only_diffuse(), &towards(DVec3::X), DVec3::ZERO, DVec3::Z))
    };
    for d in [0.01, 1.0, 7.0, 1e4] {
        close(at(Attenuation::None, d), 1.0);
        close(at(Attenuation::InverseSquare, d), 1.0 / (d * d));
        close(at(Attenuation::Offset(2.0), d), 1.0 / (d + 2.0));
        let quadratic = Attenuation::Quadratic([3.0, 0.5, 0.25]);
        close(at(quadratic, d), 1.0 / (3.0 + 0.5 * d + 0.25 * d * d));
        let range = 10.0;
        let window = (1.0 - libm::pow(d / range, 4.0)).max(0.0);
        close(at(Attenuation::InverseSquareWithin(range), d), window / (d * d));
    }
    // 1/(d + k) stays under 1/k; 1/d² is unbounded near the light.
    assert!(at(Attenuation::Offset(2.0), 1e-12) < 0.5 + 1e-12);
    assert!(at(Attenuation::InverseSquare, 1e-9) > 1e17);
}

#[test]
fn f10_light_from_infinity_is_not_attenuated() {
    let attenuation = Attenuation::Quadratic([5.0, 6.0, 7.0]);
    let far = Light::at(DVec4::new(0.0, 0.0, 3.0, 0.0), WHITE, attenuation);
    let point = SurfacePoint { position: [0.0; 3], normal: [0.0, 0.0, 1.0] };
    let explanation = Probe::new(&[far], &only_diffuse(), &towards(DVec3::Z)).unwrap().explain(&point);
    assert_eq!((explanation.lights[0].attenuation, explanation.lights[0].distance), (1.0, None));
    assert_eq!(explanation.sum, [1.0; 3]);
}

#[test]
fn f11_a_point_light_shines_from_where_it_is() {
    let attenuation = Attenuation::Quadratic([1.0, 0.1, 0.01]);
    let light =
        Light::Point { position: DVec3::new(3.0, 4.0, 12.0), colour: LinearRgb::grey(5.0), attenuation };
    let got = first(lit(&[light], &only_diffuse(), &towards(DVec3::Z), DVec3::ZERO, DVec3::Z));
    close(got, 5.0 * (12.0 / 13.0) / (1.0 + 1.3 + 1.69));
}

fn spot(cone: Cone) -> Light {
    Light::Spot { position: DVec3::Z, colour: WHITE, attenuation: Attenuation::None, cone }
}

/// The light of a spot one above the floor on a surface at this angle from its axis that faces it.
fn under_spot(cone: Cone, angle: f64, guards: Guards) -> f64 {
    let ray = DVec3::new(libm::sin(angle.to_radians()), 0.0, -libm::cos(angle.to_radians()));
    let settings = ShadeSettings { guards, ..towards(DVec3::Z) };
    first(lit(&[spot(cone)], &only_diffuse(), &settings, DVec3::Z + ray * 2.0, -ray))
}

#[test]
fn f12_a_spot_has_a_direction_a_cut_off_and_an_exponent() {
    let lectures = Cone::of_lectures(DVec3::NEG_Z * 3.0);
    for angle in [0.0, 20.0, 60.0, 89.0, 100.0, 170.0_f64] {
        let cosine = libm::cos(angle.to_radians());
        close(under_spot(lectures, angle, Guards::default()), cosine.max(0.0));
        // The lectures' own formula takes light away behind the spot.
        close(under_spot(lectures, angle, Guards::literal()), cosine);
    }
    let narrow = Cone { cut_off: Degrees(30.0).into(), exponent: 4.0, ..lectures };
    for (angle, inside) in [(0.0, true), (29.99, true), (30.01, false), (80.0, false)] {
        let expected = if inside { libm::pow(libm::cos(f64::to_radians(angle)), 4.0) } else { 0.0 };
        close(under_spot(narrow, angle, Guards::default()), expected);
    }
    let even = Cone { exponent: 0.0, cut_off: Degrees(90.0).into(), ..lectures };
    assert_eq!(under_spot(even, 89.9, Guards::default()), 1.0);
}

#[test]
fn f12_the_soft_edge_is_the_falloff_of_gltf() {
    let cone = Cone {
        axis: DVec3::NEG_Z,
        cut_off: Degrees(40.0).into(),
        soft_edge: Degrees(15.0).into(),
        exponent: 0.0,
    };
    let cos = |angle: f64| libm::cos(angle.to_radians());
    for angle in [0.0, 24.9, 25.0, 30.0, 39.0, 40.0, 41.0, 120.0] {
        let ramp = ((cos(angle) - cos(40.0)) / (cos(25.0) - cos(40.0))).clamp(0.0, 1.0);
        let got = under_spot(cone, angle, Guards::default());
        assert!((got - ramp * ramp).abs() < 1e-13, "{angle}°: {got}, not {}", ramp * ramp);
    }
}

#[test]
fn f12_cones_too_narrow_for_single_precision_cosines_have_edges() {
    // Below 0.014° every cosine in single precision is 1 (reference §3.7).
    let half = Radians(1e-5);
    let cone = Cone { axis: DVec3::NEG_Z, cut_off: half, soft_edge: Radians(0.0), exponent: 0.0 };
    let shader = Shader::<f32>::new(&[spot(cone)], &only_diffuse(), &towards(DVec3::Z)).unwrap();
    for (x, expected) in [(0.5e-5, 1.0), (0.99e-5, 1.0), (1.01e-5, 0.0), (3e-5, 0.0)] {
        let colour =
            shader.shade(&SurfacePoint { position: [x, 0.0, 0.0], normal: [0.0, 0.0, 1.0] }).unwrap();
        assert_eq!(colour, [expected; 3], "{x}");
    }
}

#[test]
fn f13_a_directional_light_is_the_limit_of_points() {
    let material = Material::default();
    let normal = DVec3::new(0.3, -0.2, 1.0);
    let at = |w: f64| {
        let light = Light::at(DVec4::new(1.0, 2.0, 3.0, w), WHITE, Attenuation::None);
        first(lit(&[light], &material, &towards(DVec3::Z), DVec3::new(0.5, 0.5, 0.0), normal))
    };
    let far = at(0.0);
    // The direction is off by |p|/|P| = 0.19 w; the highlight's slope is at most √(32/e).
    for w in [1e-1, 1e-2, 1e-4, 1e-7] {
        let off = (at(w) - far).abs();
        assert!(off < 0.4 * w && off > 1e-4 * w, "w = {w}: {off}");
    }
    assert!(matches!(Light::at(DVec4::ONE, WHITE, Attenuation::None), Light::Point { .. }));
}

#[test]
fn f14_an_area_light_far_away_is_a_point_light_of_its_power() {
    let material = Material { exponent: 8.0, ..Material::default() };
    let normal = DVec3::new(0.2, 0.1, 1.0).normalize();
    let settings = towards(DVec3::new(-0.4, 0.1, 1.0));
    let shapes = [
        AreaShape::Rectangle { centre: DVec3::Z, u: DVec3::X * 0.5, v: DVec3::NEG_Y * 0.25 },
        AreaShape::Disc {
            centre: DVec3::Z,
            normal: DVec3::NEG_Z,
            radius: (0.5 / std::f64::consts::PI).sqrt(),
        },
    ];
    for shape in shapes {
        for h in [20.0, 200.0] {
            // Everything h times as far: the area of 0.5 seen from there, over π.
            let moved = match shape {
                AreaShape::Rectangle { u, v, .. } => AreaShape::Rectangle { centre: DVec3::Z * h, u, v },
                AreaShape::Disc { normal, radius, .. } => {
                    AreaShape::Disc { centre: DVec3::Z * h, normal, radius }
                }
            };
            let area = Light::Area { shape: moved, colour: LinearRgb::grey(1e4) };
            let power = 1e4 * 0.5 / std::f64::consts::PI;
            let point = Light::Point {
                position: DVec3::Z * h,
                colour: LinearRgb::grey(power),
                attenuation: Attenuation::InverseSquare,
            };
            let [area, point] =
                [area, point].map(|light| first(lit(&[light], &material, &settings, DVec3::ZERO, normal)));
            // The highlight's point moves by up to half the light: 0.5/h, times the slope of cos⁸ and then some.
            assert!((area / point - 1.0).abs() < 3.0 / h, "{shape:?} at {h}: {area}, not {point}");
        }
    }
}

#[test]
fn f14_the_point_lights_error_under_a_square() {
    let shape = |h: f64| AreaShape::Rectangle { centre: DVec3::Z * h, u: DVec3::X, v: DVec3::NEG_Y };
    for (h, factor, error) in
        [(1.0, 0.554_126_424_0, 1.298), (5.0, 0.048_357_023_5, 0.0532), (20.0, 0.003_172_525_5, 0.00333)]
    {
        let area = Light::Area { shape: shape(h), colour: WHITE };
        let got = first(lit(&[area], &only_diffuse(), &towards(DVec3::Z), DVec3::ZERO, DVec3::Z));
        assert!((got - factor).abs() < 0.5e-10, "{got}");
        let point = 4.0 / std::f64::consts::PI / (h * h);
        // Half of the last digit given.
        assert!((point / got - 1.0 - error).abs() < 0.002 * error, "h = {h}");
    }
}

#[test]
fn f15_coefficients_and_colours_separate_or_merged() {
    let (o_d, o_s) = (LinearRgb::new(0.5, 1.0, 0.7), LinearRgb::new(1.0, 0.9, 0.1));
    let split = Material {
        ambient: Reflectance::new(0.5, o_d),
        diffuse: Reflectance::new(0.25, o_d),
        specular: Reflectance::new(0.5, o_s),
        ..Material::default()
    };
    let merged = Material {
        ambient: Reflectance::Merged(o_d * 0.5),
        diffuse: Reflectance::Merged(o_d * 0.25),
        specular: Reflectance::Merged(o_s * 0.5),
        ..Material::default()
    };
    let lights = [ambient(0.5), sun(0.0, 1.0, 1.0)];
    let [a, b] = [split, merged].map(|m| lit(&lights, &m, &towards(DVec3::Z), DVec3::ZERO, DVec3::Z));
    assert_eq!(a, b);
    // O_s is a colour of its own.
    let metal = Material { specular: Reflectance::new(0.5, o_d), ..split };
    assert_ne!(lit(&lights, &metal, &towards(DVec3::Z), DVec3::ZERO, DVec3::Z), a);
}

#[test]
fn f16_lights_add_up_each_with_its_own_distance() {
    let lights = [
        sun(1.0, 0.0, 2.0),
        point_light(DVec3::new(0.0, 2.0, 3.0), Attenuation::Offset(1.0)),
        point_light(DVec3::new(-4.0, 2.0, 3.0), Attenuation::InverseSquare),
        ambient(0.2),
        spot(Cone::of_lectures(DVec3::NEG_Z)),
    ];
    let of = |lights: &[Light]| lit(lights, &Material::default(), &towards(DVec3::Z), DVec3::X, DVec3::Z);
    let one_by_one: f64 = lights.iter().map(|light| first(of(&[*light]))).sum();
    close(first(of(&lights)), one_by_one);
}

#[test]
fn f17_depth_cueing_divides_by_the_distance_to_the_viewer() {
    let lights = [ambient(1.0), point_light(DVec3::new(0.0, 0.0, 3.0), Attenuation::Offset(1.0))];
    let material = Material { ambient: Reflectance::new(0.1, WHITE), ..only_diffuse() };
    let eye = DVec3::new(8.0, 0.0, 6.0);
    let plain = ShadeSettings { viewer: Viewer::At(eye), ..ShadeSettings::default() };
    let cued = ShadeSettings { depth_cue: Some(DepthCue { k: 2.0 }), ..plain };
    let [plain, cued] =
        [plain, cued].map(|settings| first(lit(&lights, &material, &settings, DVec3::ZERO, DVec3::Z)));
    // The light is 3 away, the viewer 10: d means either (F9, F17).
    close(plain, 0.1 + 1.0 / (3.0 + 1.0));
    close(cued, 0.1 + 1.0 / (3.0 + 1.0) / (10.0 + 2.0));
}

#[test]
fn f25_colours_out_of_range_are_clamped_or_divided() {
    let mut random = Random(5);
    for _ in 0..500 {
        let colour = [(); 3].map(|()| uniform(&mut random) * 3.0 - 0.5);
        let clamped = ToneRule::Clamp.apply(colour);
        let divided = ToneRule::DivideByMax.apply(colour);
        assert_eq!(clamped, colour.map(|c| c.clamp(0.0, 1.0)));
        assert!(divided.iter().all(|c| (0.0..=1.0).contains(c)));
        let largest = colour.into_iter().fold(1.0, f64::max);
        assert_eq!(divided, colour.map(|c| (c / largest).max(0.0)), "the ratios stay");
        assert!(largest == 1.0 || divided.contains(&1.0));
    }
}

#[test]
fn f29_fresnel_and_snell() {
    // Unit tests check the figures. Here, light is conserved (F1): what is not reflected is transmitted.
    for degrees in [0.0, 20.0, 45.0, 70.0, 89.0] {
        let part = fresnel(1.0, 1.5, Degrees(degrees).into());
        close(part.reflected() + part.transmitted(), 1.0);
        assert!(part.s >= part.p || degrees > 89.9);
    }
}
