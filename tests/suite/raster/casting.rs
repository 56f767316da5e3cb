//! Analytic surfaces, drawn exactly, against textbook ray casters that share nothing with the library.

use super::shapes::{linear, scene};
use crease::num::LinearRgb;
use crease::raster::{Image, Object, RenderSettings, Scene, Shape, Show, render};
use crease::shade::{Attenuation, Light, Material, Reflectance, Reflection};
use crease::surface::{Cone, Cylinder, Ellipsoid, Plane, Primitive, Sphere, Torus};
use glam::{DMat4, DQuat, DVec2, DVec3, Vec3Swizzles};

const SIZE: [u32; 2] = [120, 90];

/// A form in its own space, as the library's documentation describes it.
#[derive(Clone, Copy, Debug)]
enum Form {
    Plane([f64; 2]),
    Ellipsoid(DVec3),
    Cylinder { radius: f64, height: f64 },
    Cone { radius: f64, height: f64 },
    Torus { ring: f64, tube: f64 },
}

const FORMS: [Form; 6] = [
    Form::Plane([1.8, 1.3]),
    Form::Ellipsoid(DVec3::splat(0.8)),
    Form::Ellipsoid(DVec3::new(1.0, 0.6, 0.4)),
    Form::Cylinder { radius: 0.6, height: 1.5 },
    Form::Cone { radius: 0.9, height: 1.6 },
    Form::Torus { ring: 0.8, tube: 0.3 },
];

/// What a ray meets first: its parameter and the gradient there, which points outward.
type Met = Option<(f64, DVec3)>;

impl Form {
    fn primitive(self) -> Primitive {
        match self {
            Form::Plane([width, height]) => Plane::new(width, height).unwrap().into(),
            Form::Ellipsoid(axes) if axes.x == axes.z => Sphere::new(axes.x).unwrap().into(),
            Form::Ellipsoid(axes) => Ellipsoid::new(axes).unwrap().into(),
            Form::Cylinder { radius, height } => Cylinder::new(radius, height).unwrap().into(),
            Form::Cone { radius, height } => Cone::new(radius, height).unwrap().into(),
            Form::Torus { ring, tube } => Torus::new(ring, tube).unwrap().into(),
        }
    }

    /// The first hit, and whether it is certain: at rims rounding decides.
    fn meet(self, from: DVec3, along: DVec3) -> (Met, bool) {
        let at = |t: f64| from + along * t;
        // Points of a quadric, a t² + 2 b t + c = 0, within so far of y = 0.
        let quadric = |[a, b, c]: [f64; 3], half: f64, gradient: &dyn Fn(DVec3) -> DVec3| {
            let part = b * b - a * c;
            let roots = if part > 0.0 { [(-b - part.sqrt()) / a, (-b + part.sqrt()) / a] } else { [-1.0; 2] };
            let (low, high) = (roots[0].min(roots[1]), roots[0].max(roots[1]));
            let mut sure = part.abs() > 1e-9;
            for t in [low, high] {
                sure &= t < 0.0 || (at(t).y.abs() - half).abs() > 1e-9;
                if t > 0.0 && at(t).y.abs() <= half {
                    return (Some((t, gradient(at(t)))), sure);
                }
            }
            (None, sure)
        };
        match self {
            Form::Plane([width, height]) => {
                let t = -from.z / along.z;
                let out = (at(t).truncate().abs() - DVec2::new(width, height) / 2.0).max_element();
                ((t > 0.0 && out <= 0.0).then_some((t, DVec3::Z)), out.abs() > 1e-9)
            }
            Form::Ellipsoid(axes) => {
                let (o, d) = (from / axes, along / axes);
                let gradient = |p: DVec3| p / (axes * axes);
                quadric([d.dot(d), o.dot(d), o.dot(o) - 1.0], f64::INFINITY, &gradient)
            }
            Form::Cylinder { radius, height } => {
                let (o, d) = (from.xz(), along.xz());
                let round = [d.dot(d), o.dot(d), o.dot(o) - radius * radius];
                quadric(round, height / 2.0, &|p| DVec3::new(p.x, 0.0, p.z))
            }
            Form::Cone { radius, height } => {
                // x² + z² = s² (h/2 − y)²
                let slope = radius / height;
                let (o, d, down) = (from.xz(), along.xz(), height / 2.0 - from.y);
                let s2 = slope * slope;
                let double = [
                    d.dot(d) - s2 * along.y * along.y,
                    o.dot(d) + s2 * down * along.y,
                    o.dot(o) - s2 * down * down,
                ];
                quadric(double, height / 2.0, &|p| DVec3::new(p.x, s2 * (height / 2.0 - p.y), p.z))
            }
            Form::Torus { ring, tube } => {
                let (met, sure) = first_root(from, along, ring + tube, |p| {
                    let sum = p.dot(p) + ring * ring - tube * tube;
                    sum * sum - 4.0 * ring * ring * p.xz().dot(p.xz())
                });
                let gradient = |p: DVec3| {
                    let middle = DVec3::new(p.x, 0.0, p.z).normalize() * ring;
                    p - middle
                };
                (met.map(|t| (t, gradient(at(t)))), sure)
            }
        }
    }
}

/// Where a function of the points of a ray first falls to 0 within a ball about the origin, outside of which it is
/// positive: by steps and bisection, and by the bottoms of valleys between them.
fn first_root(from: DVec3, along: DVec3, radius: f64, value: impl Fn(DVec3) -> f64) -> (Option<f64>, bool) {
    const STEPS: usize = 128;
    let value = |t: f64| value(from + along * t);
    let (middle, half) = (-from.dot(along) / along.dot(along), 1.01 * radius / along.length());
    let at = |step: usize| middle + half * (2.0 * step as f64 / STEPS as f64 - 1.0);
    let bisect = |mut out: f64, mut within: f64| {
        for _ in 0..60 {
            let between = 0.5 * (out + within);
            *(if value(between) > 0.0 { &mut out } else { &mut within }) = between;
        }
        within
    };
    let mut sure = true;
    for step in 1..=STEPS {
        if value(at(step)) <= 0.0 {
            return (Some(bisect(at(step - 1), at(step))), sure);
        }
        let [before, here, after] = [step - 1, step, step + 1].map(|step| value(at(step)));
        if here <= before && here <= after {
            let (mut low, mut high) = (at(step - 1), at(step + 1));
            for _ in 0..80 {
                let [a, b] = [low + (high - low) / 3.0, high - (high - low) / 3.0];
                if value(a) < value(b) { high = b } else { low = a }
            }
            sure &= value(low).abs() > 1e-9;
            if value(low) <= 0.0 {
                return (Some(bisect(at(step - 1), low)), sure);
            }
        }
    }
    (None, sure)
}

/// Transforms: rotated, stretched, mirrored.
fn places() -> [DMat4; 4] {
    let turn = DQuat::from_rotation_z(0.4) * DQuat::from_rotation_x(-0.9);
    let stretch = DVec3::new(1.3, 0.7, 0.9);
    let moved = DVec3::new(0.2, -0.1, 0.3);
    [
        DMat4::from_translation(DVec3::new(0.1, -0.2, 0.1)),
        DMat4::from_scale_rotation_translation(DVec3::splat(0.8), turn, moved),
        DMat4::from_scale_rotation_translation(stretch, turn, moved) * DMat4::from_rotation_y(0.7),
        DMat4::from_scale(DVec3::new(-1.0, 1.2, 0.8)) * DMat4::from_quat(turn),
    ]
}

/// Coverage, normals, sides, depths and colours of each form, at each place, at every sample that is sure.
#[test]
fn exact_agrees_with_textbook_ray_casters() {
    let colour = LinearRgb::new(0.9, 0.6, 0.3);
    let material = Material {
        ambient: Reflectance::new(0.1, colour),
        diffuse: Reflectance::new(0.6, colour),
        specular: Reflectance::new(0.3, LinearRgb::WHITE),
        exponent: 20.0,
        reflection: Reflection::Blinn,
    };
    let lamp = DVec3::new(1.5, 2.0, 3.0);
    for form in FORMS {
        for (place, world) in places().into_iter().enumerate() {
            let object =
                Object { transform: world, ..Object::new(Shape::Surface(form.primitive()), material) };
            let lights = vec![
                Light::Ambient { colour: LinearRgb::grey(0.5) },
                Light::Point { position: lamp, colour: LinearRgb::WHITE, attenuation: Attenuation::None },
            ];
            let scene = Scene { lights, ..scene(vec![object]) };
            let draw = |show| render(&scene, &RenderSettings { show, ..linear(SIZE) }).unwrap();
            let images = [Show::Shaded, Show::Normals, Show::Facing, Show::Depth].map(draw);
            let eye = scene.camera.eye;
            let (mut hits, mut backs, mut unsure) = (0, 0, 0);
            for y in 0..SIZE[1] {
                for x in 0..SIZE[0] {
                    let tan = libm::tan(20.0_f64.to_radians());
                    let [across, up] =
                        [f64::from(x) + 0.5 - 60.0, 45.0 - f64::from(y) - 0.5].map(|n| n / 45.0 * tan);
                    let ray = DVec3::new(across, up, -1.0);
                    let inverse = world.inverse();
                    let (met, sure) =
                        form.meet(inverse.transform_point3(eye), inverse.transform_vector3(ray));
                    let what = format!("{form:?}, place {place}, pixel {x} {y}");
                    let pixel = (y * SIZE[0] + x) as usize;
                    if !sure {
                        unsure += 1;
                        continue;
                    }
                    assert_eq!(images[0].coverage[pixel] > 0, met.is_some(), "{what}");
                    let Some((t, gradient)) = met else { continue };
                    let normal = inverse.transpose().transform_vector3(gradient).normalize();
                    let got =
                        |image: &Image| DVec3::from(image.linear.as_ref().unwrap()[pixel].map(f64::from));
                    let [shaded, normals, facing, depth] = images.each_ref().map(got);
                    // Roundings of single precision of numbers up to 1, doubled with the normal.
                    assert!(
                        (2.0 * normals - 1.0).distance(normal) < 5e-7,
                        "{what}: {normals} shows {normal}"
                    );
                    let is_front = ray.dot(normal) < 0.0;
                    assert_eq!(facing.y > facing.x, is_front, "{what}");
                    // From half to one and a half times the distance of the target, 4, from white to black: two roundings
                    // of numbers up to 6, over 4.
                    assert!((depth.x - (6.0 - t) / 4.0).abs() < 5e-7, "{what}: {depth} at {t}");
                    let point = eye + ray * t;
                    let (light, view) = ((lamp - point).normalize(), (eye - point).normalize());
                    let cosine = normal.dot(light).max(0.0);
                    let half = (light + view).normalize();
                    let shine = if cosine > 0.0 { libm::pow(normal.dot(half).max(0.0), 20.0) } else { 0.0 };
                    let expected = DVec3::from(colour.to_array()) * (0.05 + 0.6 * cosine) + 0.3 * shine;
                    // Cosines are rounded by some 1e-7, which the exponent makes 20 times as much.
                    assert!(
                        (shaded - expected).abs().max_element() < 2e-6,
                        "{what}: {shaded}, not {expected}"
                    );
                    hits += 1;
                    backs += i32::from(!is_front);
                }
            }
            assert!(hits > 300 && unsure < 10, "{form:?}, place {place}: {hits} hits, {unsure} not sure");
            let is_open = matches!(form, Form::Cylinder { .. } | Form::Cone { .. });
            assert!(backs == 0 || is_open || matches!(form, Form::Plane(_)), "{form:?}, place {place}");
            assert!(!is_open || place == 0 || backs > 0, "{form:?}, place {place}: no inside is seen");
        }
    }
}
