//! Light that is very close.

use crate::num::numbers::Numbers;
use crate::num::{LinearRgb, Real};
use crate::shade::{Attenuation, Light, Material, Reflectance, ShadeSettings, Shader, SurfacePoint};
use crate::trade::exact::{self, Big, big, small};
use crate::trade::stress::case::{Bound, Measured, StressCase, Unit, Worst};
use crate::trade::stress::group::Group;
use crate::trade::stress::normals::naive;
use dashu::base::Abs;
use glam::{DVec3, Vec3};

const DISTANCES: [f64; 8] = [1e-1, 1e-3, 1e-6, 1e-10, 1e-18, 1e-20, 1e-30, 1e-38];
const POINTS: usize = 200;

pub(in crate::trade::stress) fn cases() -> Vec<StressCase> {
    DISTANCES.map(near).into_iter().chain([at_the_light()]).collect()
}

fn near(distance: f64) -> StressCase {
    let of = |bits: i32| {
        let source = "12 roundings: distance 3, direction 3, N·L 3, 1/d^2 3; f32 refuses where d^2 is no normal number";
        Bound::new(libm::ldexp(12.0, -bits), Unit::Relative, source)
    };
    StressCase {
        group: Group::Attenuation,
        name: format!("1/d^2 at d = {distance:.0e}"),
        what: "diffuse light of a lamp so close to the point, off to any side",
        expectation: "right to a few roundings, or refused with an error",
        bound: of(53),
        fast_bound: Some(of(24)),
        plain_unit: Unit::Relative,
        plain_formula: "dot(N, unit(P - x)) / (d·d)",
        measure: Box::new(move || measure(distance)),
    }
}

fn measure(distance: f64) -> Measured {
    let mut numbers = Numbers::new(20);
    let mut measured = Measured { samples: POINTS, ..Measured::default() };
    let (mut fast, mut plain) = (Worst::default(), Worst::default());
    for _ in 0..POINTS {
        let mut one = || 2.0 * numbers.unit() - 1.0;
        let lamp = (DVec3::new(one(), one(), 1.0).normalize() * distance).as_vec3();
        let truth = truth(lamp);
        let relative =
            |got: f64| if got.is_nan() { got } else { small(&((big(got) - &truth).abs() / &truth)) };
        measured.faithful.add(relative(shade::<f64>(lamp).unwrap_or(f64::NAN)));
        match shade::<f32>(lamp) {
            Some(got) => fast.add(relative(got)),
            None => measured.declined += 1,
        }
        let d = lamp.length();
        let portable = f64::from(naive::unit(lamp).z / (d * d));
        plain.add(if portable.is_finite() { relative(portable) } else { f64::NAN });
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

/// The point itself: 0/0 and 1/0.
fn at_the_light() -> StressCase {
    let refused = Bound::none_wrong("NotFinite: a colour that is not finite is an error, never a colour");
    StressCase {
        group: Group::Attenuation,
        name: "1/d^2 at d = 0".into(),
        what: "a lamp at the point itself",
        expectation: "refused with an error",
        bound: refused,
        fast_bound: Some(refused),
        plain_unit: Unit::Wrong,
        plain_formula: "dot(N, unit(P - x)) / (d·d)",
        measure: Box::new(|| {
            let wrong = |colour: Option<f64>| Worst::wrong(usize::from(colour.is_some()));
            Measured {
                samples: 1,
                faithful: wrong(shade::<f64>(Vec3::ZERO)),
                fast: Some(wrong(shade::<f32>(Vec3::ZERO))),
                declined: 0,
                plain: Some([f64::from(naive::unit(Vec3::ZERO).z / 0.0)].into_iter().collect()),
            }
        }),
    }
}
