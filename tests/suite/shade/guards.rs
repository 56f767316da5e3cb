//! Each guard on and off.

use super::{direction, lit, sun};
use crate::random::Random;
use crease::num::LinearRgb;
use crease::shade::{Guards, Material, Probe, Reflectance, Reflection, ShadeSettings, SurfacePoint, Viewer};
use glam::DVec3;

fn with(guards: Guards, view: DVec3) -> ShadeSettings {
    ShadeSettings { guards, viewer: Viewer::Towards(view), ..ShadeSettings::default() }
}

fn all_but(name: &str) -> Guards {
    let mut guards = Guards::default();
    assert!(guards.set(name, false), "no guard {name}");
    guards
}

#[test]
fn names_switch_each_one_and_literal_all() {
    let mut guards = Guards::default();
    for name in Guards::NAMES {
        assert_ne!(all_but(name), Guards::default());
        guards.set(name, false);
    }
    assert_eq!(guards, Guards::literal());
}

#[test]
fn a_light_behind_the_face_has_no_highlight_unless_asked() {
    // Light and viewer low on opposite sides, the light just under the horizon: R goes to the viewer.
    let (light, view) = (DVec3::new(-1.0, 0.0, -0.1), DVec3::new(1.0, 0.0, -0.1));
    for reflection in [Reflection::Phong, Reflection::Blinn] {
        let shiny = Material {
            specular: Reflectance::Merged(LinearRgb::WHITE),
            exponent: 1.0,
            reflection,
            ..Material::matte(LinearRgb::BLACK)
        };
        let at = |guards| {
            lit(&[sun(light.x, light.y, light.z)], &shiny, &with(guards, view), DVec3::ZERO, DVec3::Z)[0]
        };
        assert_eq!(at(Guards::default()), 0.0);
        match reflection {
            Reflection::Phong => assert!(at(all_but("highlight")) > 0.9),
            // H points down here.
            Reflection::Blinn => assert_eq!(at(all_but("highlight")), 0.0),
        }
    }
}

#[test]
fn diffuse_light_is_not_negative_unless_asked() {
    let matte = Material::matte(LinearRgb::WHITE);
    let at = |guards| lit(&[sun(0.0, 0.6, -0.8)], &matte, &with(guards, DVec3::Z), DVec3::ZERO, DVec3::Z)[0];
    assert_eq!(at(Guards::default()), 0.0);
    assert_eq!(at(all_but("diffuse")), 0.9 * -0.8);
}

#[test]
fn normals_are_made_unit_vectors_unless_asked() {
    // Half way between two normals 60° apart, as interpolation gives it: cos 30° long.
    let normal = DVec3::new(0.0, 0.0, libm::cos(30_f64.to_radians()));
    let matte = Material::matte(LinearRgb::WHITE);
    let at = |guards| lit(&[sun(0.0, 0.0, 1.0)], &matte, &with(guards, DVec3::Z), DVec3::ZERO, normal)[0];
    assert_eq!(at(Guards::default()), 0.9);
    assert_eq!(at(all_but("renormalise")), 0.9 * normal.z);
}

#[test]
fn small_powers_are_zero_unless_asked() {
    let shiny = Material {
        specular: Reflectance::Merged(LinearRgb::WHITE),
        exponent: 1000.0,
        reflection: Reflection::Phong,
        ..Material::matte(LinearRgb::BLACK)
    };
    // reference §3.7: cos^1000 in single precision is subnormal from 23.60° and 0 from 25.68°.
    let angle = 24.5_f64.to_radians();
    let view = DVec3::new(libm::sin(angle), 0.0, libm::cos(angle));
    let point = SurfacePoint { position: [0.0; 3], normal: [0.0, 0.0, 1.0_f32] };
    let at = |guards| {
        let shader = crease::shade::Shader::new(&[sun(0.0, 0.0, 1.0)], &shiny, &with(guards, view)).unwrap();
        shader.shade(&point).unwrap()[0]
    };
    assert_eq!(at(Guards::default()), 0.0);
    let left = at(all_but("underflow"));
    assert!(left > 0.0 && left < f32::MIN_POSITIVE, "{left:e}");
}

#[test]
fn opposite_light_and_viewer_give_no_highlight_in_any_mode() {
    let mut random = Random(6);
    let shiny = Material {
        specular: Reflectance::Merged(LinearRgb::WHITE),
        exponent: 1.0,
        ..Material::matte(LinearRgb::BLACK)
    };
    for guards in [Guards::default(), Guards::literal()] {
        for _ in 0..500 {
            let (light, normal) = (direction(&mut random), direction(&mut random));
            // Of another length, so that both are rounded in their own way.
            let settings = with(guards, light * -3.7);
            assert_eq!(
                lit(&[sun(light.x, light.y, light.z)], &shiny, &settings, DVec3::ZERO, normal),
                [0.0; 3]
            );
            let near = ShadeSettings { viewer: Viewer::At(light * -3.7), ..settings };
            assert_eq!(lit(&[sun(light.x, light.y, light.z)], &shiny, &near, DVec3::ZERO, normal), [0.0; 3]);
        }
    }
    let probe =
        Probe::new(&[sun(1.0, 2.0, 3.0)], &shiny, &with(Guards::literal(), -DVec3::new(1.0, 2.0, 3.0)));
    let explanation = probe.unwrap().explain(&SurfacePoint { position: [0.0; 3], normal: [0.0, 0.0, 1.0] });
    assert!(explanation.lights.iter().all(|light| light.half.is_none()));
}

#[test]
fn both_sides_are_lit_if_asked() {
    let matte = Material::matte(LinearRgb::WHITE);
    let one = with(Guards::default(), DVec3::Z);
    let both = ShadeSettings { two_sided: true, ..one };
    let at = |settings| lit(&[sun(0.0, 0.6, 0.8)], &matte, settings, DVec3::ZERO, DVec3::NEG_Z)[0];
    assert_eq!((at(&one), at(&both)), (0.0, 0.9 * 0.8));
}
