//! Highlights: large exponents, light from behind, and half-vectors of nothing.

use crate::num::numbers::Numbers;
use crate::num::{Power, Underflow};
use crate::shade::Reflection;
use crate::trade::exact::{big, small};
use crate::trade::stress::case::{Bound, StressCase, Unit};
use crate::trade::stress::group::Group;
use crate::trade::stress::pictures::lit::{self, Scene};
use dashu::base::Abs;
use glam::{DVec3, Vec3};

const EXPONENTS: [u32; 7] = [1, 10, 100, 1000, 10_000, 100_000, 1_000_000];
const SAMPLES: usize = 500;
/// The exponent of the cases about directions.
const MODERATE: u32 = 10;

pub(in crate::trade::stress) fn cases() -> Vec<StressCase> {
    let powers = EXPONENTS.map(power);
    let whole = EXPONENTS.map(blinn);
    let opposite = [1e-1, 1e-3, 1e-5].map(nearly_opposite);
    powers
        .into_iter()
        .chain(whole)
        .chain([exactly_opposite()])
        .chain(opposite)
        .chain([behind(), grazing()])
        .collect()
}

/// A bound in roundings: 2⁻⁵³ each for `f64`, 2⁻²⁴ for `f32`.
fn both(roundings: f64, source: &'static str) -> (Bound, Option<Bound>) {
    let of = |bits: i32| Bound::new(libm::ldexp(roundings, -bits), Unit::Absolute, source);
    (of(53), Some(of(24)))
}

/// cosⁿ alone.
fn power(exponent: u32) -> StressCase {
    let (bound, fast_bound) = match exponent {
        ..=128 => both(f64::from(exponent), "Power: n roundings by repeated squaring, n up to 128"),
        _ => both(4.0, "Power: 4 roundings of 1 by exp2(n log2 x)"),
    };
    StressCase {
        group: Group::Highlight,
        name: format!("cos^n, n = {exponent}"),
        what: "powers of f32 cosines from where the highlight ends to 1",
        expectation: "right to a few roundings of 1",
        bound,
        fast_bound,
        plain_unit: Unit::Absolute,
        plain_formula: "powf(x, n)",
        measure: Box::new(move || {
            let mut numbers = Numbers::new(14);
            let n = f64::from(exponent);
            let (double, single) =
                (Power::<f64>::new(n, Underflow::Zero), Power::<f32>::new(n, Underflow::Zero));
            let errors = (0..SAMPLES).map(|_| {
                // Powers from 1 to 2⁻¹⁰ and some to 2⁻²⁰⁰.
                let depth = if numbers.below(4) == 0 { 200.0 } else { 10.0 };
                let x = libm::exp2(-depth * numbers.unit() / n) as f32;
                let truth = big(f64::from(x)).powi(exponent.into());
                let error = |got: f64| small(&(big(got) - &truth).abs());
                [double.of(f64::from(x)), f64::from(single.of(x)), f64::from(libm::powf(x, exponent as f32))]
                    .map(error)
            });
            lit::three(&errors.collect::<Vec<_>>())
        }),
    }
}

/// The whole of Blinn's highlight, from vectors.
fn blinn(exponent: u32) -> StressCase {
    let source = "8n roundings of the cosine (two directions, their sum, three roots, a dot product), and 4 of the power";
    let (bound, fast_bound) = both(8.0 * f64::from(exponent) + 4.0, source);
    StressCase {
        group: Group::Highlight,
        name: format!("(N·H)^n, n = {exponent}"),
        what: "Blinn's highlight where it is bright, light and viewer far away",
        expectation: "n roundings, a few times: single precision ends where they show",
        bound,
        fast_bound,
        plain_unit: Unit::Absolute,
        plain_formula: "powf(dot(N, unit(L + V)), n)",
        measure: Box::new(move || {
            let mut numbers = Numbers::new(15);
            let scene = || {
                // Within 45° of z, so that no normal of the highlight is turned away from the light.
                let [light, view] = [0; 2].map(|_| front(&mut numbers) + DVec3::Z);
                let half = (light.normalize() + view.normalize()).normalize();
                let blur = 0.5 / f64::from(exponent).sqrt();
                let normal = (half + blur * numbers.unit() * direction(&mut numbers)).normalize();
                Scene::far(light, view, normal, exponent, Reflection::Blinn)
            };
            lit::measure(std::iter::repeat_with(scene).take(SAMPLES))
        }),
    }
}

/// Light from exactly behind the point, as the viewer sees it: H = 0/0.
fn exactly_opposite() -> StressCase {
    let none = Bound::new(0.0, Unit::Absolute, "no half-vector, no highlight");
    StressCase {
        group: Group::Highlight,
        name: "H at L = -V".into(),
        what: "a light and a viewer on a line through the point, on either side of it",
        expectation: "no highlight at all",
        bound: none,
        fast_bound: Some(none),
        plain_unit: Unit::Absolute,
        plain_formula: "powf(dot(N, unit(L + V)), n)",
        measure: Box::new(|| {
            let mut numbers = Numbers::new(16);
            let scene = || {
                let light = front(&mut numbers).as_vec3().as_dvec3();
                let normal = front(&mut numbers).normalize();
                // Twice as far: the same direction to the last bit.
                Scene::near(light, light * -2.0, normal, MODERATE, Reflection::Blinn).without_highlight()
            };
            lit::measure(std::iter::repeat_with(scene).take(SAMPLES))
        }),
    }
}

/// Light from almost behind the point: what is left of L + V is small.
fn nearly_opposite(angle: f64) -> StressCase {
    let (bound, fast_bound) = both(
        16.0 * f64::from(MODERATE) / angle + 4.0,
        "16 roundings of L + V over its length, which is the angle; times n; 4 of the power",
    );
    StressCase {
        group: Group::Highlight,
        name: format!("H at L = -V but for {angle:.0e} rad"),
        what: "a light almost behind the point as the viewer sees it, n = 10",
        expectation: "roundings over the angle",
        bound,
        fast_bound,
        plain_unit: Unit::Absolute,
        plain_formula: "powf(dot(N, unit(L + V)), n)",
        measure: Box::new(move || {
            let mut numbers = Numbers::new(17);
            let scene = || {
                let light = front(&mut numbers).normalize();
                let aside = light.cross(direction(&mut numbers)).normalize();
                let view = -light * libm::cos(angle) + aside * libm::sin(angle);
                let normal = (aside + 0.3 * direction(&mut numbers) + 0.3 * light).normalize();
                Scene::near(light * 2.0, view * 3.0, normal, MODERATE, Reflection::Blinn)
            };
            lit::measure(std::iter::repeat_with(scene).take(SAMPLES))
        }),
    }
}

/// A light a little behind the surface, its mirrored ray almost towards the viewer: the lectures' formula, which asks for
/// V·R > 0 only, shines at full strength.
fn behind() -> StressCase {
    let none = Bound::new(0.0, Unit::Absolute, "Guards::highlight: none where N·L is at most 0");
    StressCase {
        group: Group::Highlight,
        name: "light from behind".into(),
        what: "Phong's highlight with N·L from -1e-1 to -1e-5 and V·R near 1",
        expectation: "no highlight at all",
        bound: none,
        fast_bound: Some(none),
        plain_unit: Unit::Absolute,
        plain_formula: "V·R > 0 ? powf(V·R, n) : 0",
        measure: Box::new(|| {
            let mut numbers = Numbers::new(18);
            let scene = || {
                let normal = front(&mut numbers).normalize();
                let along = normal.cross(direction(&mut numbers)).normalize();
                let depth = libm::exp10(-1.0 - 4.0 * numbers.unit());
                let (light, view) = (along - normal * depth, -along + normal * depth);
                Scene::far(light, view, normal, MODERATE, Reflection::Phong).without_highlight()
            };
            lit::measure(std::iter::repeat_with(scene).take(SAMPLES))
        }),
    }
}

/// Diffuse light along the surface: its sign is rounding.
fn grazing() -> StressCase {
    let (bound, fast_bound) = both(8.0, "two directions of 2 roundings each and a dot product of 3");
    StressCase {
        group: Group::Highlight,
        name: "grazing light".into(),
        what: "diffuse light with N·L within ±1e-5",
        expectation: "a few roundings of 1, never below 0",
        bound,
        fast_bound,
        plain_unit: Unit::Absolute,
        plain_formula: "dot(N, L)",
        measure: Box::new(|| {
            let mut numbers = Numbers::new(19);
            let errors = (0..SAMPLES).map(|_| {
                let normal = front(&mut numbers).normalize();
                let along = normal.cross(direction(&mut numbers)).normalize();
                let light = (along + normal * (2e-5 * numbers.unit() - 1e-5)).as_vec3().as_dvec3();
                let scene = Scene::far(light, DVec3::Z, normal, 1, Reflection::Blinn);
                let truth = scene.true_diffuse();
                let plain: Vec3 = crate::trade::stress::normals::naive::unit(light.as_vec3());
                let got = scene.diffuse();
                let error =
                    |got: f64| if got < 0.0 { f64::INFINITY } else { small(&(big(got) - &truth).abs()) };
                let plain = small(&(big(f64::from(scene.normal.dot(plain))) - &truth).abs());
                [error(got[0]), error(got[1]), plain]
            });
            lit::three(&errors.collect::<Vec<_>>())
        }),
    }
}

/// A direction in front of the xy-plane.
fn front(numbers: &mut Numbers) -> DVec3 {
    let v = direction(numbers);
    DVec3::new(v.x, v.y, v.z.abs() + 0.2)
}

fn direction(numbers: &mut Numbers) -> DVec3 {
    DVec3::from_array([0; 3].map(|_| 2.0 * numbers.unit() - 1.0)).normalize()
}
