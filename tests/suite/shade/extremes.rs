//! Where numbers end: scenes of any size, and what is not finite.

use super::{direction, uniform};
use crate::random::Random;
use crease::num::LinearRgb;
use crease::shade::{
    Attenuation, Cone, Frame, Light, Material, ShadeSettings, Shader, SurfacePoint, SurfaceRows, Viewer,
};
use glam::DVec3;

fn scene(scale: f64, offset: DVec3) -> (Vec<Light>, ShadeSettings) {
    let place = |x: f64, y: f64, z: f64| DVec3::new(x, y, z) * scale + offset;
    let attenuation = Attenuation::Quadratic([1.0, 0.25 / scale, 0.125 / scale / scale]);
    let cone = Cone::of_lectures(DVec3::new(-1.0, 0.0, -1.0));
    let lights = vec![
        Light::Directional { towards: DVec3::ONE, colour: LinearRgb::WHITE },
        Light::Point { position: place(1.0, 2.0, 4.0), colour: LinearRgb::WHITE, attenuation },
        Light::Spot { position: place(2.0, 0.0, 2.0), colour: LinearRgb::WHITE, attenuation, cone },
    ];
    let settings = ShadeSettings {
        viewer: Viewer::At(place(0.0, -4.0, 8.0)),
        frame: Frame { origin: offset, unit: scale },
        ..ShadeSettings::default()
    };
    (lights, settings)
}

#[test]
fn a_scene_of_any_size_has_the_same_bits_in_its_own_frame() {
    let mut random = Random(9);
    let shaders = [-300, -60, 0, 10, 90, 300].map(|exponent| {
        let (lights, settings) = scene(libm::ldexp(1.0, exponent), DVec3::ZERO);
        Shader::<f32>::new(&lights, &Material::default(), &settings).unwrap()
    });
    for _ in 0..100 {
        let (position, normal) = (direction(&mut random), direction(&mut random));
        let point = SurfacePoint {
            position: position.to_array().map(|x| x as f32),
            normal: normal.to_array().map(|x| x as f32),
        };
        let [first, others @ ..] = shaders.each_ref().map(|shader| shader.shade(&point).unwrap());
        assert!(others.iter().all(|colour| *colour == first));
    }
}

#[test]
fn a_scene_far_from_the_origin_loses_nothing_in_its_own_frame() {
    let offset = DVec3::new(1e6, -2e6, 3e6);
    let shade = |offset: DVec3| {
        let (lights, settings) = scene(1.0, offset);
        let shader = Shader::<f32>::new(&lights, &Material::default(), &settings).unwrap();
        shader.shade(&SurfacePoint { position: [0.1, 0.2, 0.3], normal: [0.0, 0.6, 0.8] }).unwrap()
    };
    assert_eq!(shade(offset), shade(DVec3::ZERO));
}

#[test]
fn single_precision_is_close_to_double() {
    let mut random = Random(10);
    let (lights, settings) = scene(1.0, DVec3::ZERO);
    for exponent in [1.0, 32.0, 100.0, 1000.0] {
        let material = Material { exponent, ..Material::default() };
        let single = Shader::<f32>::new(&lights, &material, &settings).unwrap();
        let double = Shader::<f64>::new(&lights, &material, &settings).unwrap();
        let mut worst = 0.0;
        for _ in 0..2000 {
            let position = direction(&mut random).to_array().map(|x| x as f32);
            let normal = direction(&mut random).to_array().map(|x| x as f32);
            let (a, b) = (
                single.shade(&SurfacePoint { position, normal }).unwrap(),
                double
                    .shade(&SurfacePoint { position: position.map(f64::from), normal: normal.map(f64::from) })
                    .unwrap(),
            );
            worst = a.into_iter().zip(b).map(|(a, b)| (f64::from(a) - b).abs()).fold(worst, f64::max);
        }
        // A cosine is a few roundings off, u = 6e-8, and its power n times that near 1: 3 lights, k_s = 0.2.
        let bound = 3.0 * (0.2 * exponent + 0.8) * 4.0 * 6e-8 + 3e-7;
        assert!(worst < bound && worst > 1e-9, "n = {exponent}: {worst:e}, bound {bound:e}");
    }
}

#[test]
fn a_light_at_the_point_itself_is_an_error_that_names_it() {
    let lights = [
        Light::Ambient { colour: LinearRgb::WHITE },
        Light::Point {
            position: DVec3::ONE,
            colour: LinearRgb::WHITE,
            attenuation: Attenuation::Offset(1.0),
        },
    ];
    let shader = Shader::<f32>::new(&lights, &Material::default(), &ShadeSettings::default()).unwrap();
    let error = shader.shade(&SurfacePoint { position: [1.0; 3], normal: [0.0, 0.0, 1.0] }).unwrap_err();
    assert_eq!((error.light, error.position), (Some(1), [1.0; 3]));
    let text = error.to_string();
    assert!(text.contains("(1, 1, 1)") && text.contains("light 1"), "{text}");

    let mut positions = [[0.0_f32; 200]; 3];
    positions.iter_mut().for_each(|row| row[150] = 1.0);
    let (zeros, ones) = ([0.0; 200], [1.0; 200]);
    let rows = SurfaceRows {
        positions: positions.each_ref().map(|row| &row[..]),
        normals: [&zeros, &zeros, &ones],
        faces: None,
    };
    let mut out = [[0.0; 200]; 3];
    let [red, green, blue] = &mut out;
    assert_eq!(shader.shade_rows(&rows, [red, green, blue]).unwrap_err().index, 150);
}

#[test]
fn what_is_not_a_number_is_never_a_colour() {
    let (lights, settings) = scene(1.0, DVec3::ZERO);
    let shiny_only = Material { diffuse: crease::shade::Reflectance::NONE, ..Material::default() };
    for material in [Material::default(), shiny_only, Material::matte(LinearRgb::WHITE)] {
        let shader = Shader::<f32>::new(&lights, &material, &settings).unwrap();
        for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 1e38] {
            let good = [0.1, 0.2, 0.3];
            let error = shader.shade(&SurfacePoint { position: good, normal: [0.0, bad, 1.0] }).unwrap_err();
            assert!(bad.is_finite() || error.to_string().contains("the normal is not finite"), "{error}");
            assert!(
                shader.shade(&SurfacePoint { position: [0.0, bad, 1.0], normal: good }).is_err(),
                "at {bad}"
            );
        }
    }
}

#[test]
fn a_normal_of_no_length_has_ambient_light_only() {
    let (mut lights, settings) = scene(1.0, DVec3::ZERO);
    lights.push(Light::Ambient { colour: LinearRgb::WHITE });
    let shader = Shader::<f32>::new(&lights, &Material::default(), &settings).unwrap();
    for normal in [[0.0; 3], [0.0, 1e-30, 0.0], [0.0, -0.0, 0.0]] {
        let colour = shader.shade(&SurfacePoint { position: [0.0; 3], normal }).unwrap();
        assert!(colour.iter().all(|c| (c - 0.08).abs() < 1e-8), "{colour:?}");
    }
}

#[test]
fn longer_and_shorter_normals_count_the_same() {
    let mut random = Random(11);
    let (lights, settings) = scene(1.0, DVec3::ZERO);
    let shader = Shader::<f32>::new(&lights, &Material::default(), &settings).unwrap();
    for _ in 0..100 {
        let normal = direction(&mut random).to_array().map(|x| x as f32);
        let shade = |length: f32| {
            shader.shade(&SurfacePoint { position: [0.0; 3], normal: normal.map(|x| x * length) }).unwrap()
        };
        let length = libm::ldexpf(1.0, (uniform(&mut random) * 100.0) as i32 - 50);
        assert_eq!(shade(length), shade(1.0));
    }
}
