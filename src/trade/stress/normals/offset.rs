//! Far from the origin: what is lost when positions are stored, and what when they are computed with.

use crate::num::numbers::Numbers;
use crate::trade::exact;
use crate::trade::stress::case::{Bound, Measured, StressCase, Unit, Worst};
use crate::trade::stress::group::Group;
use crate::trade::stress::normals::naive;
use crate::trade::stress::normals::triangles::{self, Triangle};
use glam::{DQuat, DVec3};

const OFFSETS: [f64; 7] = [1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7];
const TRIANGLES: usize = 200;

pub(in crate::trade::stress) fn cases() -> Vec<StressCase> {
    OFFSETS.map(arithmetic).into_iter().chain(OFFSETS.map(storage)).collect()
}

/// The stored positions are taken as given.
fn arithmetic(offset: f64) -> StressCase {
    StressCase {
        group: Group::Offset,
        name: format!("{offset:.0e}, arithmetic"),
        what: "equilateral triangles of side 1 so far along each axis: the error against the stored positions",
        expectation: triangles::EXPECTATION,
        bound: triangles::ONE_ULP,
        fast_bound: Some(triangles::FAST),
        plain_unit: Unit::Degrees,
        plain_formula: triangles::FORMULA,
        measure: Box::new(move || {
            let stored: Vec<Triangle> = equilateral(offset).into_iter().map(stored).collect();
            triangles::measure(&stored)
        }),
    }
}

/// The error against the positions before they were rounded. No arithmetic on `f32` positions can help it; an origin
/// near by, kept in `f64`, does.
fn storage(offset: f64) -> StressCase {
    // A corner moves by half a spacing on each axis; n = e1×e2 of length sin 60° by up to 4δ + 4δ².
    let spacing = f64::from(f32::EPSILON) * libm::exp2(libm::floor(libm::log2(offset + 1.0)));
    let moved = 0.5 * 3.0_f64.sqrt() * spacing;
    let sine = (4.0 * moved + 4.0 * moved * moved) / (0.5 * 3.0_f64.sqrt());
    let turned = if sine < 1.0 { libm::asin(sine).to_degrees() } else { 180.0 };
    let most = (turned + 1e-5).min(180.0);
    StressCase {
        group: Group::Offset,
        name: format!("{offset:.0e}, storage"),
        what: "the same triangles: the error against the positions before they were rounded to f32",
        expectation: "as much as rounding can turn a face",
        bound: Bound::new(
            most,
            Unit::Degrees,
            "asin((4d + 4d^2)/sin 60) for corners moved by d = sqrt(3)/2 spacings, and the rounding of the result",
        ),
        fast_bound: Some(Bound::new(
            (most + triangles::FAST.most).min(180.0),
            Unit::Degrees,
            "that of storage and that of fast faces, 0.0172 degrees",
        )),
        plain_unit: Unit::Degrees,
        plain_formula: triangles::FORMULA,
        measure: Box::new(move || measure_storage(offset)),
    }
}

fn measure_storage(offset: f64) -> Measured {
    let originals = equilateral(offset);
    let triangles: Vec<Triangle> = originals.iter().map(|&triangle| stored(triangle)).collect();
    let normals = triangles::faithful(&triangles);
    let (mut faithful, mut fast, mut plain) = (Worst::default(), Worst::default(), Worst::default());
    let mut declined = 0;
    for ((original, triangle), (normal, is_degenerate)) in originals.iter().zip(&triangles).zip(normals) {
        let truth = exact::face_normal(original).expect("an equilateral triangle has an area");
        // One that storage has made degenerate has a normal that is made up, by as much as half a turn.
        let normal = if is_degenerate { 180.0 } else { degrees(DVec3::from(normal.map(f64::from)), &truth) };
        faithful.add(normal);
        let quick = triangles::fast(triangle);
        declined += usize::from(quick.declined);
        fast.add(if quick.fault.is_some() { 180.0 } else { degrees(quick.normal, &truth) });
        plain.add(degrees(naive::direction(naive::face_normal(*triangle)), &truth));
    }
    Measured { samples: triangles.len(), faithful, fast: Some(fast), declined, plain: Some(plain) }
}

fn degrees(normal: DVec3, truth: &exact::Vector) -> f64 {
    exact::angle_to(normal, truth).to_degrees()
}

/// Turned at random, in double precision.
fn equilateral(offset: f64) -> Vec<[DVec3; 3]> {
    let mut numbers = Numbers::new(3);
    let corner = [DVec3::ZERO, DVec3::X, DVec3::new(0.5, 0.5 * 3.0_f64.sqrt(), 0.0)];
    let triangle = |_| {
        let [x, y, z, w] = [0; 4].map(|_| 2.0 * numbers.unit() - 1.0);
        let turn = DQuat::from_xyzw(x, y, z, w).normalize();
        let place = DVec3::splat(offset) + DVec3::from_array([0; 3].map(|_| 0.5 * numbers.unit()));
        corner.map(|corner| turn * corner + place)
    };
    (0..TRIANGLES).map(triangle).collect()
}

fn stored(triangle: [DVec3; 3]) -> Triangle {
    triangle.map(|corner| corner.as_vec3())
}
