//! Points that lie exactly on a line, or on each other.

use crate::normals::FaultReason;
use crate::num::numbers::Numbers;
use crate::trade::exact;
use crate::trade::stress::case::{Bound, Measured, StressCase, Unit, Worst};
use crate::trade::stress::group::Group;
use crate::trade::stress::normals::fans::{self, Fan};
use crate::trade::stress::normals::naive;
use crate::trade::stress::normals::triangles::{self, Triangle};
use glam::Vec3;

const TRIANGLES: usize = 300;
const ALL_FOUND: Bound = Bound::none_wrong("the area is exactly zero");

pub(in crate::trade::stress) fn cases() -> Vec<StressCase> {
    let collinear = "three points of small whole numbers, times a power of two, exactly on a line";
    let duplicate = "two or three corners at the same place";
    vec![
        reported("exactly collinear", collinear, collinear_points),
        reported("duplicate points", duplicate, duplicate_points),
        reported("collinear far away", "three points on a line through 1e6, exactly", far_collinear_points),
        one_off(),
        next_to(),
    ]
}

/// Every triangle has zero area, which exact arithmetic confirms, and has to be found.
fn reported(name: &str, what: &'static str, triangles: fn(&mut Numbers) -> Triangle) -> StressCase {
    StressCase {
        group: Group::Degenerate,
        name: name.into(),
        what,
        expectation: "all reported, each with a finite unit normal",
        bound: ALL_FOUND,
        fast_bound: Some(ALL_FOUND),
        plain_unit: Unit::Wrong,
        plain_formula: triangles::FORMULA,
        measure: Box::new(move || {
            let triangles = sample(triangles);
            let is_unit = |normal: [f32; 3]| (Vec3::from(normal).length() - 1.0).abs() < 1e-6;
            let results = triangles::faithful(&triangles);
            let wrong = triangles.iter().zip(results).filter(|(corners, (normal, is_degenerate))| {
                let truth = exact::degenerate(&corners.map(|corner| corner.as_dvec3()));
                *is_degenerate != truth || !truth || !is_unit(*normal)
            });
            let quick: Vec<triangles::Quick> = triangles.iter().map(triangles::fast).collect();
            let missed = quick.iter().filter(|quick| {
                quick.fault != Some(FaultReason::ZeroArea) || !is_unit(quick.normal.as_vec3().to_array())
            });
            let directions = triangles.iter().map(|&t| naive::direction(naive::face_normal(t)));
            let undefined = directions.clone().filter(|n| n.is_nan()).count();
            let plain = Worst { error: (triangles.len() - undefined) as f64, undefined };
            Measured {
                samples: triangles.len(),
                faithful: Worst::wrong(wrong.count()),
                fast: Some(Worst::wrong(missed.count())),
                declined: quick.iter().filter(|quick| quick.declined).count(),
                plain: Some(plain),
            }
        }),
    }
}

fn sample(triangle: impl Fn(&mut Numbers) -> Triangle) -> Vec<Triangle> {
    let mut numbers = Numbers::new(6);
    (0..TRIANGLES).map(|_| triangle(&mut numbers)).collect()
}

/// A vector of whole numbers up to a limit, not zero.
fn whole(numbers: &mut Numbers, limit: usize) -> Vec3 {
    let mut one = || numbers.below(2 * limit + 1) as f32 - limit as f32;
    let v = Vec3::new(one(), one(), one());
    if v == Vec3::ZERO { Vec3::X } else { v }
}

fn collinear_points(numbers: &mut Numbers) -> Triangle {
    let (start, along) = (whole(numbers, 1000), whole(numbers, 1000));
    let size = libm::ldexpf(1.0, numbers.below(40) as i32 - 20);
    [0.0, 1.0, 2.0 + numbers.below(9) as f32].map(|times| (start + along * times) * size)
}

fn far_collinear_points(numbers: &mut Numbers) -> Triangle {
    let (start, along) = (whole(numbers, 1_000_000), whole(numbers, 100));
    [0.0, 1.0, 2.0 + numbers.below(90) as f32].map(|times| start + along * times)
}

fn duplicate_points(numbers: &mut Numbers) -> Triangle {
    let [a, b] = [0; 2].map(|_| Vec3::from_array([0; 3].map(|_| numbers.spread(30) as f32)));
    [[a, a, b], [a, b, a], [b, a, a], [a, a, a]][numbers.below(4)]
}

/// A corner that one spacing takes off the line.
fn one_off() -> StressCase {
    let triangle = |numbers: &mut Numbers| {
        let mut corners = collinear_points(numbers);
        let axis = numbers.below(3);
        corners[2][axis] =
            if numbers.below(2) == 0 { corners[2][axis].next_up() } else { corners[2][axis].next_down() };
        corners
    };
    StressCase {
        group: Group::Degenerate,
        name: "one spacing off a line".into(),
        what: "the collinear points with one coordinate moved to the next f32",
        expectation: triangles::EXPECTATION,
        bound: triangles::ONE_ULP,
        fast_bound: Some(triangles::FAST),
        plain_unit: Unit::Degrees,
        plain_formula: triangles::FORMULA,
        measure: Box::new(move || triangles::measure(&sample(triangle))),
    }
}

/// Faces without area must not turn the normal of a vertex.
fn next_to() -> StressCase {
    StressCase {
        group: Group::Degenerate,
        name: "vertex beside faces of no area".into(),
        what: "the tip of a cone with three faces of no area added, by six weights",
        expectation: "they add nothing",
        bound: Bound::new(3e-6, Unit::Degrees, "rounding to f32, sqrt(3)/2^25 rad"),
        fast_bound: Some(triangles::FAST),
        plain_unit: Unit::Degrees,
        plain_formula: fans::FORMULA,
        measure: Box::new(|| {
            let mut fan = Fan::cone(6, 0.3);
            let (centre, [a, b]) = (fan.centre, fan.triangles[0]);
            fan.triangles.extend([[a, a], [centre, b], [centre, centre]]);
            fans::measure(&[fan], &fans::WEIGHTS)
        }),
    }
}
