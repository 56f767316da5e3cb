//! Light on one point in three precisions, against the lectures' formulas in 256 bits: highlights with large exponents, light from
//! behind, half-vectors of nearly no length, and light that is very close.

use super::prelude::*;
use crate::num::{Power, Underflow};

/// A point at the origin, its normal, and the positions of light and viewer. All coordinates are `f32` numbers.
#[derive(Clone, Copy, Debug)]
struct Scene {
    light: Vec3,
    view: Vec3,
    normal: Vec3,
    exponent: u32,
    reflection: Reflection,
    /// How the light fades; `None` if light and viewer are infinitely far away, in these directions.
    attenuation: Option<Attenuation>,
    /// Whether the true highlight is 0, whatever the formula says.
    dark: bool,
}

impl Scene {
    /// Light and viewer in these directions, infinitely far away; then the normal.
    fn far(vectors: [DVec3; 3], exponent: u32, reflection: Reflection) -> Self {
        let [light, view, normal] = vectors.map(|v| v.as_vec3());
        Self { light, view, normal, exponent, reflection, attenuation: None, dark: false }
    }

    /// Light and viewer at these points; then the normal.
    fn near(vectors: [DVec3; 3], exponent: u32, reflection: Reflection) -> Self {
        Self { attenuation: Some(Attenuation::None), ..Self::far(vectors, exponent, reflection) }
    }

    fn without_highlight(self) -> Self {
        Self { dark: true, ..self }
    }

    /// The red light that the point reflects; `None` if it is refused.
    fn shade<R: Real>(&self, material: &Material) -> Option<f64> {
        let ([light, view], colour) = ([self.light, self.view].map(|v| v.as_dvec3()), LinearRgb::WHITE);
        let (light, viewer) = match self.attenuation {
            None => (Light::Directional { towards: light, colour }, Viewer::Towards(view)),
            Some(attenuation) => (Light::Point { position: light, colour, attenuation }, Viewer::At(view)),
        };
        let settings = ShadeSettings { viewer, ..ShadeSettings::default() };
        let shader = Shader::<R>::new(&[light], material, &settings).expect("numbers that make sense");
        let normal = self.normal.to_array().map(|x| R::of(f64::from(x)));
        let point = SurfacePoint { position: [R::ZERO; 3], normal };
        shader.shade(&point).ok().map(|[red, ..]| red.to_f64())
    }

    fn highlights(&self) -> [f64; 2] {
        let material = Material {
            specular: Reflectance::Merged(LinearRgb::WHITE),
            diffuse: Reflectance::NONE,
            exponent: f64::from(self.exponent),
            reflection: self.reflection,
            ..Material::default()
        };
        [self.shade::<f64>(&material), self.shade::<f32>(&material)].map(|red| red.unwrap_or(f64::NAN))
    }

    /// Diffuse light, in double and in single precision; `None` if it is refused.
    fn diffuse(&self) -> [Option<f64>; 2] {
        let white = Reflectance::Merged(LinearRgb::WHITE);
        let material = Material { diffuse: white, specular: Reflectance::NONE, ..Material::default() };
        [self.shade::<f64>(&material), self.shade::<f32>(&material)]
    }

    /// N, L, V.
    fn true_directions(&self) -> [exact::Vector; 3] {
        [self.normal, self.light, self.view]
            .map(|v| exact::unit(&v.as_dvec3().to_array().map(big)).expect("a vector with a direction"))
    }

    /// max(N·L, 0).
    fn true_diffuse(&self) -> Big {
        let [normal, light, _] = self.true_directions();
        exact::dot(&normal, &light).max(big(0.0))
    }

    /// max(cos, 0)ⁿ, whatever N·L is; `None` without a half-vector.
    fn highlight_formula(&self) -> Option<Big> {
        let [normal, light, view] = self.true_directions();
        let cosine = match self.reflection {
            Reflection::Blinn => {
                let sum: exact::Vector = std::array::from_fn(|axis| &light[axis] + &view[axis]);
                exact::dot(&normal, &exact::unit(&sum)?)
            }
            Reflection::Phong => {
                big(2.0) * exact::dot(&normal, &light) * exact::dot(&normal, &view)
                    - exact::dot(&light, &view)
            }
        };
        Some(cosine.max(big(0.0)).powi(self.exponent.into()))
    }

    /// The formulas as usually written.
    fn plain_highlight(&self) -> f32 {
        let [normal, light, view] = [self.normal, self.light, self.view].map(plain::unit);
        let cosine = match self.reflection {
            Reflection::Blinn => normal.dot(plain::unit(light + view)),
            Reflection::Phong => (2.0 * normal.dot(light) * normal - light).dot(view),
        };
        if cosine <= 0.0 { 0.0 } else { libm::powf(cosine, self.exponent as f32) }
    }
}

fn measure_scenes(scenes: impl Iterator<Item = Scene>) -> Measured {
    let mut definition = Worst::default();
    let measured = Measured::triples(scenes.map(|scene| {
        let formula = scene.highlight_formula();
        // No highlight where N·L is not above 0.
        let is_dark = scene.dark || scene.true_diffuse() == Big::ZERO;
        let truth = if is_dark { Big::ZERO } else { formula.clone().expect("a half-vector") };
        definition
            .add(formula.map_or(Outcome::NotANumber, |formula| small(&(formula - &truth).abs()).into()));
        let [double, single] = scene.highlights();
        [double, single, f64::from(scene.plain_highlight())]
            .map(|found| Outcome::number(found, |found| small(&(big(found) - &truth).abs())))
    }));
    Measured { definition, ..measured }
}

const EXPONENTS: [u32; 7] = [1, 10, 100, 1000, 10_000, 100_000, 1_000_000];
const SAMPLES: usize = 500;
/// The exponent of the cases about directions.
const MODERATE: u32 = 10;

pub(super) fn highlight_cases() -> Vec<StressCase> {
    let opposite = [1e-1, 1e-3, 1e-5].map(nearly_opposite);
    let powers = EXPONENTS.into_iter().map(power).chain(EXPONENTS.map(blinn));
    powers.chain([exactly_opposite()]).chain(opposite).chain([behind(), grazing()]).collect()
}

/// A bound in roundings: 2⁻⁵³ each for `f64`, 2⁻²⁴ for `f32`.
fn roundings(number: f64, source: &'static str) -> (Bound, Option<Bound>) {
    let bound = |bits: i32| Bound::new(libm::ldexp(number, -bits), Unit::Absolute, source);
    (bound(53), Some(bound(24)))
}

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
        measure_scenes((0..SAMPLES).map(|_| scene(&mut numbers)))
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
            let diffuse = scene.diffuse().map(|found| found.unwrap_or(f64::NAN));
            let [double, single] =
                diffuse.map(|found| if found < 0.0 { f64::INFINITY } else { error(found) });
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

const NEAR: [f64; 8] = [1e-1, 1e-3, 1e-6, 1e-10, 1e-18, 1e-20, 1e-30, 1e-38];
const POINTS: usize = 200;

pub(super) fn attenuation_cases() -> Vec<StressCase> {
    let near = NEAR.map(|distance| {
        let bound = |bits: i32| Bound::new(libm::ldexp(12.0, -bits), Unit::Relative, "near-light-bound");
        let (name, bounds) = (format!("1/d^2 at d = {distance:.0e}"), (bound(53), Some(bound(24))));
        StressCase::new(Group::Attenuation, "near-light", name, bounds, move || measure_near(distance))
    });
    let refused = Bound::none_wrong("at-light-bound");
    let bounds = (refused, Some(refused));
    let at_light =
        StressCase::new(Group::Attenuation, "at-light", "1/d^2 at d = 0", bounds, measure_at_light);
    near.into_iter().chain([at_light]).collect()
}

fn measure_near(distance: f64) -> Measured {
    let mut numbers = Numbers::new(20);
    let mut measured = Measured { samples: POINTS, ..Measured::default() };
    let (mut fast, mut plain) = (Worst::default(), Worst::default());
    for _ in 0..POINTS {
        let [x, y] = [0; 2].map(|_| signed(&mut numbers));
        let lamp = (DVec3::new(x, y, 1.0).normalize() * distance).as_vec3();
        let truth = truth(lamp);
        let relative = |found: f64| small(&((big(found) - &truth).abs() / &truth));
        let [double, single] = at_lamp(lamp).diffuse();
        measured.faithful.add(Outcome::number(double.unwrap_or(f64::NAN), relative));
        match single {
            Some(found) => fast.add(relative(found)),
            None => measured.declined += 1,
        }
        let d = lamp.length();
        plain.add(Outcome::number(f64::from(plain::unit(lamp).z / (d * d)), relative));
    }
    Measured { fast: Some(fast), plain: Some(plain), ..measured }
}

/// A lamp whose light fades with the square of the distance, before a point with the normal +z.
fn at_lamp(lamp: Vec3) -> Scene {
    let scene = Scene::near([lamp.as_dvec3(), DVec3::Z, DVec3::Z], 1, Reflection::Blinn);
    Scene { attenuation: Some(Attenuation::InverseSquare), ..scene }
}

/// cos/d² = z/d³.
fn truth(lamp: Vec3) -> Big {
    let lamp = lamp.as_dvec3().to_array().map(big);
    let squared = exact::dot(&lamp, &lamp);
    &lamp[2] / (squared * exact::length(&lamp))
}

fn measure_at_light() -> Measured {
    let [faithful, fast] = at_lamp(Vec3::ZERO).diffuse().map(|red| Worst::wrong(usize::from(red.is_some())));
    Measured {
        samples: 1,
        faithful,
        fast: Some(fast),
        declined: 0,
        plain: Some([f64::from(plain::unit(Vec3::ZERO).z / 0.0)].into_iter().collect()),
        definition: Worst::not_a_number(1),
    }
}
