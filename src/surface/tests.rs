//! Exactness: normals against differences of points, and the descriptions of one surface against each other.

use crate::num::test_numbers::Numbers;
use crate::surface::*;
use glam::DVec3;

pub(super) fn all() -> Vec<(&'static str, Surface)> {
    vec![
        ("plane", Plane::default().into()),
        ("sphere", Sphere::new(2.0).unwrap().into()),
        ("ellipsoid", Ellipsoid::default().into()),
        ("cylinder", Cylinder::new(0.5, 3.0).unwrap().into()),
        ("cone", Cone::default().into()),
        ("torus", Torus::default().into()),
        ("catenoid", Surface::Catenoid(Catenoid::default())),
        ("wave", Surface::Wave(Wave::default())),
        ("saddle", Surface::MonkeySaddle(MonkeySaddle::default())),
        ("box", Surface::Superquadric(Superquadric::default())),
        (
            "octahedron",
            Surface::Superquadric(Superquadric::new(DVec3::new(1.0, 2.0, 0.5), 1.6, 1.3).unwrap()),
        ),
        ("patch", Surface::Patch(Box::default())),
        ("teapot", Surface::Teapot),
    ]
}

/// Parameters well inside, for a superquadric also well off the planes of symmetry, where higher derivatives have no
/// bound.
fn inside(numbers: &mut Numbers) -> (f64, f64) {
    let part = |k: f64| (k.floor() + 0.25 + 0.5 * k.fract()) / 4.0;
    (part(4.0 * numbers.unit()), part(4.0 * numbers.unit()))
}

/// Central differences of points have an error of h²/6 times third derivatives: halving h divides it by four.
#[test]
fn normals_are_cross_products_of_tangents_to_second_order() {
    let mut numbers = Numbers::new(51);
    for (name, surface) in all() {
        let charts = surface.charts();
        let mut errors = [0.0_f64; 3];
        for round in 0..400 {
            let chart = charts[round % charts.len()];
            let (u, v) = inside(&mut numbers);
            let point = |u, v| chart.at(u, v).unwrap().position;
            for (error, h) in errors.iter_mut().zip([4e-3, 2e-3, 1e-3]) {
                let du = point(u + h, v) - point(u - h, v);
                let dv = point(u, v + h) - point(u, v - h);
                let normal = chart.at(u, v).unwrap().normal.get();
                *error = error.max((du.cross(dv).normalize() - normal).length());
            }
        }
        if errors[0] < 1e-11 {
            // Central differences of sine and cosine are parallel to their derivatives: the rest is rounding.
            assert!(
                matches!(name, "plane" | "cone" | "cylinder" | "sphere" | "ellipsoid" | "torus"),
                "{name}"
            );
            continue;
        }
        for pair in errors.windows(2) {
            let order = libm::log2(pair[0] / pair[1]);
            assert!((order - 2.0).abs() < 0.1, "{name}: order {order} from {errors:?}");
        }
        assert!(errors[2] < 2e-3, "{name}: {errors:?}");
    }
}

#[test]
fn zero_sets_hold_the_points_and_their_normals() {
    let mut numbers = Numbers::new(52);
    for (name, surface) in all() {
        let Some(zero_set) = surface.zero_set() else { continue };
        for chart in surface.charts() {
            for _ in 0..300 {
                let sample = chart.at(numbers.unit(), numbers.unit()).unwrap();
                // Some roundings of coordinates up to 2.
                assert!(zero_set.value(sample.position).abs() < 4e-15, "{name}");
                let normal = zero_set.normal_at(sample.position).unwrap().get();
                let error = (normal - sample.normal.get()).length();
                // Near the catenoid's and the superquadrics' sharpest bends a rounding of the point turns the normal
                // several times as far; close to the tip of the cone, over its distance from the axis.
                assert!(
                    error < 1e-13 || name == "cone" && error < 1e-13 / (1.0 - sample.position.y),
                    "{name} {error:e}"
                );
            }
        }
    }
}

/// The same check as for the surfaces that rays can hit, for the others.
#[test]
fn normals_are_gradients_of_zero_sets_to_second_order() {
    let mut numbers = Numbers::new(53);
    for (name, surface) in all() {
        let Some(zero_set) = surface.zero_set().filter(|_| !matches!(surface, Surface::Primitive(_))) else {
            continue;
        };
        let mut errors = [0.0_f64; 3];
        for _ in 0..300 {
            let (u, v) = inside(&mut numbers);
            let sample = surface.charts()[0].at(u, v).unwrap();
            for (error, h) in errors.iter_mut().zip([4e-3, 2e-3, 1e-3]) {
                let slope = |axis: DVec3| {
                    zero_set.value(sample.position + axis * h) - zero_set.value(sample.position - axis * h)
                };
                let gradient = DVec3::from_array(DVec3::AXES.map(slope)).normalize();
                *error = error.max((gradient - sample.normal.get()).length());
            }
        }
        for pair in errors.windows(2) {
            let order = libm::log2(pair[0] / pair[1]);
            assert!((order - 2.0).abs() < 0.15, "{name}: order {order} from {errors:?}");
        }
    }
}

#[test]
fn charts_close_where_they_say_so() {
    let parts = || (1..8).map(|k| f64::from(k) / 8.0);
    for (name, surface) in all() {
        for chart in surface.charts() {
            let same = |a: (f64, f64), b: (f64, f64)| chart.at(a.0, a.1) == chart.at(b.0, b.1);
            let is_point = |v: f64| {
                let position = |u| chart.at(u, v).unwrap().position;
                parts().all(|u| (position(u) - position(0.0)).length() < 1e-15)
            };
            let Chart { wraps_u, wraps_v, pole_low, pole_high } = chart.chart();
            assert_eq!(wraps_u, parts().all(|v| same((0.0, v), (1.0, v))), "{name}");
            assert_eq!(wraps_u, parts().all(|v| same((0.25, v), (2.25, v))), "{name}");
            assert_eq!(wraps_v, parts().all(|u| same((u, 0.0), (u, 1.0))), "{name}");
            assert_eq!((pole_low, pole_high), (is_point(0.0), is_point(1.0)), "{name}");
        }
    }
}

/// Every quarter of the pot, the lid and the bottom is the one before it turned by 90°, and everything is its own mirror
/// image: a mistyped figure would show.
#[test]
fn the_teapot_has_its_symmetries() {
    let patches = teapot();
    assert_eq!(patches.len(), 32);
    let mut distinct: Vec<[i64; 3]> = Vec::new();
    let key = |p: DVec3| (p * 1e6).round().to_array().map(|x| x as i64);
    distinct.extend(patches.iter().flat_map(|patch| patch.points().as_flattened()).map(|&p| key(p)));
    let mirrored: Vec<[i64; 3]> = distinct.iter().map(|&[x, y, z]| [x, y, -z]).collect();
    distinct.sort_unstable();
    distinct.dedup();
    assert_eq!(distinct.len(), 290);
    assert!(mirrored.iter().all(|p| distinct.binary_search(p).is_ok()));
    for first in [0, 4, 8, 20, 24, 28] {
        // The pot's quarters run clockwise seen from above, the bottom's the other way.
        let sense = if first == 28 { -1.0 } else { 1.0 };
        for quarter in first + 1..first + 4 {
            let (one, next) = (patches[quarter - 1].points(), patches[quarter].points());
            for (p, q) in one.as_flattened().iter().zip(next.as_flattened()) {
                assert!(
                    (DVec3::new(-p.z * sense, p.y, p.x * sense) - *q).length() < 1e-15,
                    "{quarter}: {p} {q}"
                );
            }
        }
    }
}

#[test]
fn normals_on_collapsed_sides_are_the_limits() {
    for (number, patch) in teapot().iter().enumerate() {
        let Chart { pole_low, pole_high, .. } = patch.chart();
        assert_eq!((pole_low, pole_high), ((20..24).contains(&number) || number >= 28, false));
        if !pole_low {
            continue;
        }
        let up = if number < 28 { DVec3::Y } else { DVec3::NEG_Y };
        for u in [0.0, 0.2, 0.5, 1.0] {
            // The limit is reached to first order at most; 1e-9 away it has to be within 1e-8.
            let at = |v| patch.at(u, v).unwrap().normal.get();
            assert!((at(0.0) - up).length() < 1e-15, "{number}: {}", at(0.0));
            assert!((at(1e-9) - at(0.0)).length() < 1e-8, "{number}: {}", at(1e-9));
        }
    }
    // A side at v = 1 and one at u = 0 or 1: a rotated patch keeps its surface.
    let lid = teapot()[20].points();
    let turned = BezierPatch::new(std::array::from_fn(|row| lid[3 - row])).unwrap();
    assert_eq!(turned.at(0.3, 1.0).unwrap().normal.get(), DVec3::NEG_Y);
    let across = BezierPatch::new(std::array::from_fn(|row| std::array::from_fn(|k| lid[k][row]))).unwrap();
    assert_eq!(across.at(0.0, 0.3).unwrap().normal.get(), DVec3::NEG_Y);
    let across =
        BezierPatch::new(std::array::from_fn(|row| std::array::from_fn(|k| lid[3 - k][row]))).unwrap();
    assert_eq!(across.at(1.0, 0.3).unwrap().normal.get(), DVec3::Y);
}

#[test]
fn settings_out_of_range_are_refused() {
    for bad in [0.0, -1.0, f64::NAN, 2.0] {
        assert!(matches!(Superquadric::new(DVec3::ONE, bad, 1.0), Err(SurfaceError::OutOfRange(_))));
    }
    assert!(matches!(Catenoid::new(0.01, 3.0), Err(SurfaceError::OutOfRange(_))));
    assert!(Wave::new(f64::INFINITY).is_err() && MonkeySaddle::new(0.0).is_err());
    let mut points = *BezierPatch::default().points();
    points[2][1].y = f64::NAN;
    let fact = "the control point in row 2, column 1 is not finite or beyond 1e60";
    assert_eq!(BezierPatch::new(points), Err(SurfaceError::Invalid(fact.into())));
}
