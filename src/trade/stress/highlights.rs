//! Highlights: large exponents, light from behind, and half-vectors of nearly no length.

use super::case::{Bound, Measured, StressCase, Unit};
use super::group::Group;
use super::lit_point::{self, Scene};
use super::plain;
use super::random::vector;
use crate::num::numbers::Numbers;
use crate::num::{Power, Underflow};
use crate::shade::Reflection;
use crate::trade::exact::{big, small};
use dashu::base::Abs;
use glam::DVec3;

const EXPONENTS: [u32; 7] = [1, 10, 100, 1000, 10_000, 100_000, 1_000_000];
const SAMPLES: usize = 500;
/// The exponent of the cases about directions.
const MODERATE: u32 = 10;

pub(super) fn cases() -> Vec<StressCase> {
    let opposite = [1e-1, 1e-3, 1e-5].map(nearly_opposite);
    let powers = EXPONENTS.into_iter().map(power).chain(EXPONENTS.map(blinn));
    powers.chain([exactly_opposite()]).chain(opposite).chain([behind(), grazing()]).collect()
}

/// A bound in roundings: 2⁻⁵³ each for `f64`, 2⁻²⁴ for `f32`.
fn roundings(number: f64, source: &'static str) -> (Bound, Option<Bound>) {
    let bound = |bits: i32| Bound::new(libm::ldexp(number, -bits), Unit::Absolute, source);
    (bound(53), Some(bound(24)))
}

/// No highlight at all.
fn none(source: &'static str) -> (Bound, Option<Bound>) {
    roundings(0.0, source)
}

/// A case about the highlights of scenes that are made from random numbers.
fn case(
    texts: &'static str,
    name: impl Into<String>,
    bounds: (Bound, Option<Bound>),
    seed: u64,
    scene: impl Fn(&mut Numbers) -> Scene + Send + Sync + 'static,
) -> StressCase {
    StressCase::new(Group::Highlight, texts, name, bounds, move || {
        let mut numbers = Numbers::new(seed);
        lit_point::measure((0..SAMPLES).map(|_| scene(&mut numbers)))
    })
}

/// cosⁿ alone.
fn power(exponent: u32) -> StressCase {
    let bounds = match exponent {
        ..=128 => roundings(f64::from(exponent), "power-bound-squaring"),
        _ => roundings(4.0, "power-bound-logarithm"),
    };
    let name = format!("cos^n, n = {exponent}");
    StressCase::new(Group::Highlight, "power", name, bounds, move || {
        let mut numbers = Numbers::new(14);
        let n = f64::from(exponent);
        let (double, single) = (Power::<f64>::new(n, Underflow::Zero), Power::<f32>::new(n, Underflow::Zero));
        Measured::triples((0..SAMPLES).map(|_| {
            // Powers from 1 to 2⁻¹⁰ and some to 2⁻²⁰⁰.
            let depth = if numbers.below(4) == 0 { 200.0 } else { 10.0 };
            let x = libm::exp2(-depth * numbers.unit() / n) as f32;
            let truth = big(f64::from(x)).powi(exponent.into());
            let error = |found: f64| small(&(big(found) - &truth).abs());
            [double.of(f64::from(x)), f64::from(single.of(x)), f64::from(libm::powf(x, exponent as f32))]
                .map(error)
        }))
    })
}

/// The whole of Blinn's highlight, from vectors.
fn blinn(exponent: u32) -> StressCase {
    let bounds = roundings(8.0 * f64::from(exponent) + 4.0, "blinn-bound");
    case("blinn", format!("(N·H)^n, n = {exponent}"), bounds, 15, move |numbers| {
        // Within 45° of z, so that no normal of the highlight faces away from the light.
        let [light, view] = [0; 2].map(|_| front(numbers) + DVec3::Z);
        let half = (light.normalize() + view.normalize()).normalize();
        let blur = 0.5 / f64::from(exponent).sqrt();
        let normal = (half + blur * numbers.unit() * direction(numbers)).normalize();
        Scene::far([light, view, normal], exponent, Reflection::Blinn)
    })
}

/// Light from exactly behind the point, as the viewer sees it: H = 0/0.
fn exactly_opposite() -> StressCase {
    case("opposite-light", "H at L = -V", none("opposite-light-bound"), 16, |numbers| {
        let light = front(numbers).as_vec3().as_dvec3();
        let normal = front(numbers).normalize();
        // Twice as far: the same direction to the last bit.
        Scene::near([light, light * -2.0, normal], MODERATE, Reflection::Blinn).without_highlight()
    })
}

/// Light from almost behind the point: L + V is short.
fn nearly_opposite(angle: f64) -> StressCase {
    let bounds = roundings(16.0 * f64::from(MODERATE) / angle + 4.0, "nearly-opposite-bound");
    let name = format!("H at L = -V but for {angle:.0e} rad");
    case("nearly-opposite", name, bounds, 17, move |numbers| {
        let light = front(numbers).normalize();
        let aside = light.cross(direction(numbers)).normalize();
        let view = -light * libm::cos(angle) + aside * libm::sin(angle);
        let normal = (aside + 0.3 * direction(numbers) + 0.3 * light).normalize();
        Scene::near([light * 2.0, view * 3.0, normal], MODERATE, Reflection::Blinn)
    })
}

/// A light a little behind the surface, its mirrored ray almost towards the viewer: the lectures' formula, which asks for
/// V·R > 0 only, shines at full strength.
fn behind() -> StressCase {
    case("light-behind", "light from behind", none("light-behind-bound"), 18, |numbers| {
        let normal = front(numbers).normalize();
        let along = normal.cross(direction(numbers)).normalize();
        let depth = libm::exp10(-1.0 - 4.0 * numbers.unit());
        let (light, view) = (along - normal * depth, -along + normal * depth);
        Scene::far([light, view, normal], MODERATE, Reflection::Phong).without_highlight()
    })
}

/// Diffuse light along the surface: its sign is rounding.
fn grazing() -> StressCase {
    let bounds = roundings(8.0, "grazing-bound");
    StressCase::new(Group::Highlight, "grazing", "grazing light", bounds, || {
        let mut numbers = Numbers::new(19);
        Measured::triples((0..SAMPLES).map(|_| {
            let normal = front(&mut numbers).normalize();
            let along = normal.cross(direction(&mut numbers)).normalize();
            let light = (along + normal * (2e-5 * numbers.unit() - 1e-5)).as_vec3().as_dvec3();
            let scene = Scene::far([light, DVec3::Z, normal], 1, Reflection::Blinn);
            let truth = scene.true_diffuse();
            let error = |found: f64| small(&(big(found) - &truth).abs());
            let [double, single] =
                scene.diffuse().map(|found| if found < 0.0 { f64::INFINITY } else { error(found) });
            [double, single, error(f64::from(scene.normal.dot(plain::unit(light.as_vec3()))))]
        }))
    })
}

/// A direction in front of the xy-plane.
fn front(numbers: &mut Numbers) -> DVec3 {
    let v = direction(numbers);
    DVec3::new(v.x, v.y, v.z.abs() + 0.2)
}

fn direction(numbers: &mut Numbers) -> DVec3 {
    vector(numbers).normalize()
}
