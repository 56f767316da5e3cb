//! Light that is very close.

use super::prelude::*;

const DISTANCES: [f64; 8] = [1e-1, 1e-3, 1e-6, 1e-10, 1e-18, 1e-20, 1e-30, 1e-38];
const POINTS: usize = 200;

pub(super) fn cases() -> Vec<StressCase> {
    let near = DISTANCES.map(|distance| {
        let bound = |bits: i32| Bound::new(libm::ldexp(12.0, -bits), Unit::Relative, "near-light-bound");
        let (name, bounds) = (format!("1/d^2 at d = {distance:.0e}"), (bound(53), Some(bound(24))));
        StressCase::new(Group::Attenuation, "near-light", name, bounds, move || measure(distance))
    });
    let refused = Bound::none_wrong("at-light-bound");
    let bounds = (refused, Some(refused));
    let at_light =
        StressCase::new(Group::Attenuation, "at-light", "1/d^2 at d = 0", bounds, measure_at_light);
    near.into_iter().chain([at_light]).collect()
}

fn measure(distance: f64) -> Measured {
    let mut numbers = Numbers::new(20);
    let mut measured = Measured { samples: POINTS, ..Measured::default() };
    let (mut fast, mut plain) = (Worst::default(), Worst::default());
    for _ in 0..POINTS {
        let [x, y] = [0; 2].map(|_| signed(&mut numbers));
        let lamp = (DVec3::new(x, y, 1.0).normalize() * distance).as_vec3();
        let truth = truth(lamp);
        let relative = |found: f64| {
            if found.is_nan() { found } else { small(&((big(found) - &truth).abs() / &truth)) }
        };
        measured.faithful.add(relative(shade::<f64>(lamp).unwrap_or(f64::NAN)));
        match shade::<f32>(lamp) {
            Some(found) => fast.add(relative(found)),
            None => measured.declined += 1,
        }
        let d = lamp.length();
        let plain_light = f64::from(plain::unit(lamp).z / (d * d));
        plain.add(if plain_light.is_finite() { relative(plain_light) } else { f64::NAN });
    }
    Measured { fast: Some(fast), plain: Some(plain), ..measured }
}

/// The light on the point at the origin with the normal +z; `None` if it is refused.
fn shade<R: Real>(lamp: Vec3) -> Option<f64> {
    let light = Light::Point {
        position: lamp.as_dvec3(),
        colour: LinearRgb::WHITE,
        attenuation: Attenuation::InverseSquare,
    };
    let white = Reflectance::Merged(LinearRgb::WHITE);
    let material = Material { diffuse: white, specular: Reflectance::NONE, ..Material::default() };
    let shader = Shader::<R>::new(&[light], &material, &ShadeSettings::default());
    let point = SurfacePoint { position: [R::ZERO; 3], normal: [R::ZERO, R::ZERO, R::ONE] };
    let [red, ..] = shader.expect("numbers that make sense").shade(&point).ok()?;
    Some(red.to_f64())
}

/// cos/d² = z/d³.
fn truth(lamp: Vec3) -> Big {
    let lamp = lamp.as_dvec3().to_array().map(big);
    let squared = exact::dot(&lamp, &lamp);
    &lamp[2] / (squared * exact::length(&lamp))
}

fn measure_at_light() -> Measured {
    let wrong = |colour: Option<f64>| Worst::wrong(usize::from(colour.is_some()));
    Measured {
        samples: 1,
        faithful: wrong(shade::<f64>(Vec3::ZERO)),
        fast: Some(wrong(shade::<f32>(Vec3::ZERO))),
        declined: 0,
        plain: Some([f64::from(plain::unit(Vec3::ZERO).z / 0.0)].into_iter().collect()),
    }
}
