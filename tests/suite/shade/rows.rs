//! Rows against points: the same bits, whatever the scene.

use super::{direction, uniform};
use crate::random::Random;
use crease::num::{LinearRgb, Radians};
use crease::shade::{
    AreaShape, Attenuation, Cone, DepthCue, Guards, Light, Material, Reflectance, Reflection, ShadeSettings,
    Shader, SurfacePoint, SurfaceRows, Viewer,
};
use glam::DVec3;

fn any_colour(random: &mut Random) -> LinearRgb {
    if random.one_in(5) { LinearRgb::BLACK } else { [(); 3].map(|()| uniform(random)).into() }
}

fn any_light(random: &mut Random) -> Light {
    let colour = any_colour(random);
    let position = direction(random) * (2.0 + 5.0 * uniform(random));
    let attenuation = match random.below(5) {
        0 => Attenuation::None,
        1 => Attenuation::InverseSquare,
        2 => Attenuation::InverseSquareWithin(4.0),
        3 => Attenuation::Offset(uniform(random)),
        _ => Attenuation::Quadratic([1.0, uniform(random), uniform(random)]),
    };
    match random.below(6) {
        0 => Light::Ambient { colour },
        1 => Light::Directional { towards: position, colour },
        2 => Light::Point { position, colour, attenuation },
        3 => {
            let cone = Cone {
                axis: -position,
                cut_off: Radians(if random.one_in(3) { std::f64::consts::PI } else { 0.1 + uniform(random) }),
                soft_edge: Radians(if random.one_in(2) { 0.0 } else { 0.1 }),
                exponent: [0.0, 1.0, 2.0, 3.7][random.below(4)],
            };
            Light::Spot { position, colour, attenuation, cone }
        }
        4 => {
            let (u, v) = position.normalize().any_orthonormal_pair();
            Light::Area { shape: AreaShape::Rectangle { centre: position, u, v: v * 0.5 }, colour }
        }
        _ => Light::Area {
            shape: AreaShape::Disc { centre: position, normal: -position, radius: 0.7 },
            colour,
        },
    }
}

fn any_material(random: &mut Random) -> Material {
    Material {
        ambient: Reflectance::Merged(any_colour(random)),
        diffuse: Reflectance::Merged(any_colour(random)),
        specular: Reflectance::Merged(any_colour(random)),
        exponent: [0.0, 1.0, 5.0, 32.0, 12.3, 700.0][random.below(6)],
        reflection: if random.one_in(2) { Reflection::Phong } else { Reflection::Blinn },
    }
}

fn any_settings(random: &mut Random) -> ShadeSettings {
    let near = random.one_in(2);
    let view = direction(random) * 9.0;
    let mut guards = Guards::default();
    for name in Guards::NAMES {
        guards.set(name, !random.one_in(4));
    }
    ShadeSettings {
        viewer: if near { Viewer::At(view) } else { Viewer::Towards(view) },
        guards,
        depth_cue: (near && random.one_in(2)).then_some(DepthCue { k: 1.0 }),
        two_sided: random.one_in(3),
        ..ShadeSettings::default()
    }
}

#[test]
fn rows_have_the_bits_of_their_points() {
    let mut random = Random(7);
    let mut lit = 0;
    for round in 0..400 {
        let lights: Vec<Light> = (0..random.below(4)).map(|_| any_light(&mut random)).collect();
        let (material, settings) = (any_material(&mut random), any_settings(&mut random));
        let shader = Shader::<f32>::new(&lights, &material, &settings).unwrap();
        // Blocks of 128, whole vectors, and remainders.
        let count = [0, 1, 7, 64, 128, 129, 300][round % 7];
        let mut positions = [(); 3].map(|()| vec![0.0_f32; count]);
        let mut normals = positions.clone();
        for i in 0..count {
            let (position, normal) =
                (direction(&mut random), direction(&mut random) * (0.5 + 0.5 * uniform(&mut random)));
            for axis in 0..3 {
                positions[axis][i] = position[axis] as f32;
                normals[axis][i] = normal[axis] as f32;
            }
        }
        let mut out = positions.clone();
        let rows =
            SurfaceRows { positions: row_slices(&positions), normals: row_slices(&normals), faces: None };
        let [red, green, blue] = &mut out;
        shader.shade_rows(&rows, [red, green, blue]).unwrap();
        for i in 0..count {
            let at = |rows: &[Vec<f32>; 3]| [rows[0][i], rows[1][i], rows[2][i]];
            let point = SurfacePoint { position: at(&positions), normal: at(&normals) };
            let single = shader.shade(&point).unwrap();
            assert_eq!(
                at(&out).map(f32::to_bits),
                single.map(f32::to_bits),
                "{lights:?} {material:?} {settings:?}"
            );
            lit += usize::from(single.iter().any(|&c| c > 0.0));
        }
    }
    assert!(lit > 10_000, "only {lit} points are lit");
}

fn row_slices(rows: &[Vec<f32>; 3]) -> [&[f32]; 3] {
    [&rows[0], &rows[1], &rows[2]]
}

#[test]
fn positions_may_be_missing_where_nothing_needs_them() {
    let sun = Light::Directional { towards: DVec3::Z, colour: LinearRgb::WHITE };
    let shader = Shader::<f32>::new(&[sun], &Material::default(), &ShadeSettings::default()).unwrap();
    assert!(!shader.needs_positions() && shader.needs_normals());
    let (zeros, ones) = ([0.0; 5], [1.0; 5]);
    let rows = SurfaceRows { positions: [&[]; 3], normals: [&zeros, &zeros, &ones], faces: None };
    let mut out = [[0.0; 5]; 3];
    let [red, green, blue] = &mut out;
    shader.shade_rows(&rows, [red, green, blue]).unwrap();
    // 0.7 · 0.8 + 0.2: straight from above.
    assert!(out[0].iter().all(|&c| (c - 0.76).abs() < 1e-6), "{out:?}");
    let near = ShadeSettings { viewer: Viewer::At(DVec3::Z), ..ShadeSettings::default() };
    assert!(Shader::<f32>::new(&[sun], &Material::default(), &near).unwrap().needs_positions());
    // Without a highlight the position of the viewer is not used.
    let matte = Material::matte(LinearRgb::WHITE);
    assert!(!Shader::<f32>::new(&[sun], &matte, &near).unwrap().needs_positions());
    let night = Light::Ambient { colour: LinearRgb::WHITE };
    assert!(!Shader::<f32>::new(&[night], &matte, &near).unwrap().needs_normals());
}

#[test]
fn what_is_not_there_changes_no_bit() {
    let mut random = Random(8);
    for _ in 0..100 {
        let lights = [any_light(&mut random), any_light(&mut random)];
        let (material, settings) = (any_material(&mut random), any_settings(&mut random));
        let dark = Light::Point {
            position: DVec3::X * 5.0,
            colour: LinearRgb::BLACK,
            attenuation: Attenuation::None,
        };
        let more = [lights[0], dark, lights[1]];
        let normal = direction(&mut random).to_array();
        let point = SurfacePoint { position: direction(&mut random).to_array(), normal };
        let [plain, with_dark] = [&lights[..], &more[..]]
            .map(|lights| Shader::<f64>::new(lights, &material, &settings).unwrap().shade(&point).unwrap());
        assert_eq!(plain, with_dark);
    }
}
