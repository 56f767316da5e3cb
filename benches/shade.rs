//! What light on points costs: nanoseconds a point, and each scene as a ratio to the cheapest that has
//! a light. What a scene does not have must cost nothing: the pairs at the end hold that.
//!
//!     cargo bench --bench shade -- [ROUNDS]

#![allow(clippy::print_stdout, reason = "it prints a table")]

use crease::num::{Degrees, LinearRgb};
use crease::shade::{
    AreaShape, Attenuation, Cone, Light, Material, Reflectance, Reflection, ShadeSettings, Shader,
    SurfacePoint, SurfaceRows, Viewer,
};
use glam::DVec3;
use std::hint::black_box;
use std::time::Instant;

/// Points of a tile of 64 × 64 pixels.
const POINTS: usize = 4096;
/// Tiles that one measurement shades.
const REPEATS: usize = 64;

/// A name and what shades a tile once.
type Candidate<'a> = (&'static str, Box<dyn FnMut() + 'a>);

fn main() {
    let rounds = std::env::args().skip(1).find_map(|argument| argument.parse().ok()).unwrap_or(9).max(5);
    let (positions, normals) = bumps();
    let rows = SurfaceRows {
        positions: positions.each_ref().map(|row| &row[..]),
        normals: normals.each_ref().map(|row| &row[..]),
        faces: None,
    };
    let mut candidates: Vec<Candidate> = scenes()
        .into_iter()
        .map(|(name, lights, material, viewer)| {
            let settings = ShadeSettings { viewer, ..ShadeSettings::default() };
            let shader = Shader::<f32>::new(&lights, &material, &settings).expect("the scene is sound");
            let mut out = [(); 3].map(|()| vec![0.0_f32; POINTS]);
            let work: Box<dyn FnMut()> = Box::new(move || {
                let [red, green, blue] = black_box(&mut out);
                shader.shade_rows(black_box(&rows), [red, green, blue]).expect("every colour is finite");
            });
            (name, work)
        })
        .collect();
    candidates.push(("baseline: point by point, powf", Box::new(baseline(&rows))));
    candidates.push(("ours, point by point", Box::new(point_by_point(&rows))));
    let seconds = measure(&mut candidates, rounds);
    let of =
        |name: &str| candidates.iter().position(|(other, _)| *other == name).map_or(f64::NAN, |i| seconds[i]);
    let reference = of("sun, matte");
    println!("| scene | ns a point | of `sun, matte` |\n|---|---:|---:|");
    for ((name, _), seconds) in candidates.iter().zip(&seconds) {
        println!("| {name} | {:.2} | {:.2} |", seconds * 1e9, seconds / reference);
    }
    println!("\n| what is not there | costs |\n|---|---:|");
    for (name, with, without) in [
        ("a highlight of coefficient 0", "sun, k_s = 0", "sun, matte"),
        ("a black point light", "sun, matte, and a black point light", "sun, matte"),
        ("a near viewer that nothing uses", "sun, matte, viewer near", "sun, matte"),
    ] {
        println!("| {name} | {:.2}× |", of(with) / of(without));
    }
}

/// Points and normals of a bumpy floor that faces z.
fn bumps() -> ([Vec<f32>; 3], [Vec<f32>; 3]) {
    let mut positions = [(); 3].map(|()| Vec::with_capacity(POINTS));
    let mut normals = positions.clone();
    for i in 0..POINTS {
        let (x, y) = ((i % 64) as f64 / 32.0 - 1.0, (i / 64) as f64 / 32.0 - 1.0);
        let normal = [0.4 * libm::sin(9.0 * x), 0.4 * libm::cos(7.0 * y), 1.0];
        for (axis, (p, n)) in [x, y, 0.1 * libm::sin(9.0 * y)].into_iter().zip(normal).enumerate() {
            positions[axis].push(p as f32);
            normals[axis].push(n as f32);
        }
    }
    (positions, normals)
}

type Scene = (&'static str, Vec<Light>, Material, Viewer);

fn scenes() -> Vec<Scene> {
    let colour = LinearRgb::new(0.9, 0.8, 0.7);
    let ambient = Light::Ambient { colour };
    let sun = Light::Directional { towards: DVec3::new(1.0, 2.0, 3.0), colour };
    let position = DVec3::new(1.0, 2.0, 3.0);
    let attenuation = Attenuation::Quadratic([1.0, 0.1, 0.01]);
    let point = Light::Point { position, colour, attenuation };
    let black = Light::Point { position, colour: LinearRgb::BLACK, attenuation };
    let cone = Cone {
        axis: -position,
        cut_off: Degrees(30.0).into(),
        soft_edge: Degrees(5.0).into(),
        exponent: 1.0,
    };
    let spot = Light::Spot { position, colour, attenuation, cone };
    let square = Light::Area {
        shape: AreaShape::Rectangle { centre: position, u: DVec3::X, v: DVec3::NEG_Y },
        colour,
    };
    let disc =
        Light::Area { shape: AreaShape::Disc { centre: position, normal: -position, radius: 1.0 }, colour };
    let (far, near) = (Viewer::Towards(DVec3::Z), Viewer::At(DVec3::Z * 5.0));
    let matte = Material::matte(colour);
    let blinn = Material::plastic(colour);
    let phong = Material { reflection: Reflection::Phong, ..blinn };
    let dull = Material { specular: Reflectance::new(0.0, colour), ..blinn };
    let real = Material { exponent: 32.5, ..blinn };
    let all = vec![ambient, sun, point, spot];
    vec![
        ("ambient only", vec![ambient], matte, far),
        ("sun, matte", vec![sun], matte, far),
        ("sun, k_s = 0", vec![sun], dull, far),
        ("sun, matte, and a black point light", vec![sun, black], matte, far),
        ("sun, matte, viewer near", vec![sun], matte, near),
        ("sun, Blinn n = 32", vec![sun], blinn, far),
        ("sun, Blinn n = 32.5", vec![sun], real, far),
        ("sun, Phong n = 32", vec![sun], phong, far),
        ("sun, Blinn n = 32, viewer near", vec![sun], blinn, near),
        ("point light, Blinn n = 32, viewer near", vec![point], blinn, near),
        ("spot, Blinn n = 32, viewer near", vec![spot], blinn, near),
        ("ambient, sun, point and spot, Blinn, viewer near", all, blinn, near),
        ("square light, matte", vec![square], matte, far),
        ("disc light, matte", vec![disc], matte, far),
    ]
}

/// `sun, Blinn n = 32` as one writes it down: a loop over points with the platform's power.
fn baseline<'a>(rows: &SurfaceRows<'a>) -> impl FnMut() + use<'a> {
    let [xs, ys, zs] = rows.normals;
    let mut out = vec![[0.0_f32; 3]; POINTS];
    let light = DVec3::new(1.0, 2.0, 3.0).normalize().as_vec3();
    let half = (light + glam::Vec3::Z).normalize();
    let (diffuse, specular) = (glam::Vec3::new(0.57, 0.45, 0.34), glam::Vec3::new(0.18, 0.16, 0.14));
    move || {
        for (i, out) in black_box(&mut out).iter_mut().enumerate() {
            let normal = glam::Vec3::new(xs[i], ys[i], zs[i]).normalize();
            let cosine = normal.dot(light).max(0.0);
            #[allow(clippy::disallowed_methods, reason = "what everybody calls")]
            let highlight = if cosine > 0.0 { normal.dot(half).max(0.0).powf(32.0) } else { 0.0 };
            *out = (diffuse * cosine + specular * highlight).to_array();
        }
    }
}

/// The same through [`Shader::shade`].
fn point_by_point<'a>(rows: &SurfaceRows<'a>) -> impl FnMut() + use<'a> {
    let rows = *rows;
    let (_, lights, material, viewer) =
        scenes().into_iter().find(|scene| scene.0 == "sun, Blinn n = 32").expect("it is in the list");
    let settings = ShadeSettings { viewer, ..ShadeSettings::default() };
    let shader = Shader::<f32>::new(&lights, &material, &settings).expect("the scene is sound");
    let mut out = vec![[0.0_f32; 3]; POINTS];
    move || {
        for (i, out) in black_box(&mut out).iter_mut().enumerate() {
            let point = SurfacePoint {
                position: rows.positions.map(|row| row[i]),
                normal: rows.normals.map(|row| row[i]),
            };
            *out = shader.shade(&point).expect("every colour is finite");
        }
    }
}

/// Median seconds a point of each candidate, in turn.
fn measure(candidates: &mut [Candidate], rounds: usize) -> Vec<f64> {
    let mut seconds = vec![Vec::new(); candidates.len()];
    for round in 0..=rounds {
        for ((_, work), seconds) in candidates.iter_mut().zip(&mut seconds) {
            let start = Instant::now();
            (0..REPEATS).for_each(|_| work());
            // The first round is for warming up.
            if round > 0 {
                seconds.push(start.elapsed().as_secs_f64() / (REPEATS * POINTS) as f64);
            }
        }
    }
    seconds
        .into_iter()
        .map(|mut seconds: Vec<f64>| {
            seconds.sort_by(f64::total_cmp);
            seconds[seconds.len() / 2]
        })
        .collect()
}
