//! Scenes that make no sense are refused, with the place and what to do.

use super::sun;
use crease::num::{Degrees, LinearRgb, Radians};
use crease::shade::{
    AreaShape, Attenuation, Cone, DepthCue, Frame, Light, Material, Place, Reflectance, ShadeSettings,
    Shader, Viewer,
};
use glam::DVec3;

const WHITE: LinearRgb = LinearRgb::WHITE;

/// The error of a scene, by its text.
fn refused(lights: &[Light], material: Material, settings: ShadeSettings) -> String {
    let [single, double] = [
        Shader::<f32>::new(lights, &material, &settings).map(|_| ()),
        Shader::<f64>::new(lights, &material, &settings).map(|_| ()),
    ];
    assert_eq!(single, double);
    single.expect_err("it should be refused").to_string()
}

#[track_caller]
fn light(light: Light, expected: &str) {
    let text = refused(&[sun(0.0, 0.0, 1.0), light], Material::default(), ShadeSettings::default());
    assert_eq!(text, format!("light 1: {expected}"));
}

fn point(attenuation: Attenuation) -> Light {
    Light::Point { position: DVec3::Z, colour: WHITE, attenuation }
}

fn spot(cone: Cone) -> Light {
    Light::Spot { position: DVec3::Z, colour: WHITE, attenuation: Attenuation::None, cone }
}

#[test]
fn lights() {
    let not_negative = "it must be finite and not negative";
    light(
        Light::Ambient { colour: LinearRgb::new(0.0, f64::NAN, 1.0) },
        "colour is (0, NaN, 1); it must be of finite components, none of them negative",
    );
    light(
        Light::Directional { towards: DVec3::ZERO, colour: WHITE },
        "direction is [0, 0, 0]; it must be of finite coordinates, and not zero",
    );
    light(
        Light::Point {
            position: DVec3::new(f64::INFINITY, 0.0, 0.0),
            colour: WHITE,
            attenuation: Attenuation::None,
        },
        "position is [inf, 0, 0]; it must be of finite coordinates",
    );
    light(point(Attenuation::Offset(-1.0)), &format!("k is -1; {not_negative}"));
    light(point(Attenuation::InverseSquareWithin(0.0)), "range is 0; it must be finite and above 0");
    let quadratic =
        |constant, linear, quadratic| point(Attenuation::Quadratic([constant, linear, quadratic]));
    light(quadratic(0.0, -0.5, 1.0), &format!("kl is -0.5; {not_negative}"));
    light(quadratic(0.0, 0.0, 0.0), "kc + kl + kq is 0; it must be finite and above 0");
}

#[test]
fn cones() {
    let cone = Cone::of_lectures(DVec3::NEG_Z);
    for (degrees, fine) in
        [(0.0, false), (-5.0, false), (0.1, true), (90.0, true), (91.0, false), (180.0, true), (200.0, false)]
    {
        let lights = [spot(Cone { cut_off: Degrees(degrees).into(), ..cone })];
        let got = Shader::<f32>::new(&lights, &Material::default(), &ShadeSettings::default());
        assert_eq!(got.is_ok(), fine, "{degrees}°");
    }
    light(
        spot(Cone { cut_off: Degrees(120.0).into(), ..cone }),
        "cut-off is 120°; it must be above 0° and up to 90°, or 180° for no cut-off",
    );
    let narrow = Cone { cut_off: Degrees(45.0).into(), ..cone };
    light(
        spot(Cone { soft_edge: Radians(std::f64::consts::FRAC_PI_2), ..narrow }),
        "soft edge is 90°; it must be 0° or more and no wider than the cut-off",
    );
    light(
        spot(Cone { exponent: f64::NAN, ..cone }),
        "spot exponent is NaN; it must be finite and not negative",
    );
    light(
        spot(Cone { axis: DVec3::ZERO, ..cone }),
        "axis is [0, 0, 0]; it must be of finite coordinates, and not zero",
    );
}

#[test]
fn area_lights() {
    let area = |shape| Light::Area { shape, colour: WHITE };
    light(
        area(AreaShape::Rectangle { centre: DVec3::Z, u: DVec3::X, v: DVec3::new(1.0, 1.0, 0.0) }),
        "pair of sides is [1, 0, 0] and [1, 1, 0]; it must be at a right angle",
    );
    light(
        area(AreaShape::Disc { centre: DVec3::Z, normal: DVec3::Z, radius: -2.0 }),
        "radius is -2; it must be finite and above 0",
    );
}

#[test]
fn materials() {
    let with = |material| refused(&[sun(0.0, 0.0, 1.0)], material, ShadeSettings::default());
    assert_eq!(
        with(Material { exponent: -1.0, ..Material::default() }),
        "material: exponent is -1; it must be finite and not negative"
    );
    assert_eq!(
        with(Material { diffuse: Reflectance::new(-0.5, WHITE), ..Material::default() }),
        "material: diffuse reflection is -0.5; it must be finite and not negative"
    );
    let dark = Reflectance::Merged(LinearRgb::new(0.0, 0.0, -1.0));
    assert!(
        with(Material { specular: dark, ..Material::default() })
            .contains("specular reflection is (0, 0, -1)")
    );
}

#[test]
fn settings() {
    let with = |settings| refused(&[sun(0.0, 0.0, 1.0)], Material::default(), settings);
    let settings = ShadeSettings::default();
    assert_eq!(
        with(ShadeSettings { depth_cue: Some(DepthCue { k: 1.0 }), ..settings }),
        "shading: viewer is infinitely far away; it must be at a point, for depth cueing"
    );
    let at = Viewer::At(DVec3::Z);
    assert!(
        with(ShadeSettings { viewer: at, depth_cue: Some(DepthCue { k: -1.0 }), ..settings })
            .contains("depth cue k is -1")
    );
    assert!(
        with(ShadeSettings { viewer: Viewer::Towards(DVec3::ZERO), ..settings })
            .contains("direction to the viewer")
    );
    assert!(
        with(ShadeSettings { frame: Frame { unit: 0.0, ..Frame::default() }, ..settings })
            .contains("unit is 0")
    );
}

#[test]
fn a_light_too_far_for_single_precision_is_reported_as_a_direction() {
    let far = Light::Point { position: DVec3::X * 1e15, colour: WHITE, attenuation: Attenuation::None };
    let error = Shader::<f32>::new(&[far], &Material::default(), &ShadeSettings::default()).unwrap_err();
    assert_eq!((error.place, error.field), (Place::Light(0), "position"));
    assert!(error.to_string().contains("give a direction"), "{error}");
    assert!(Shader::<f64>::new(&[far], &Material::default(), &ShadeSettings::default()).is_ok());
}
