//! Coordinates at the limits of `f32`, and far from the origin.

use super::face_normals::{self, FAST, Triangle};
use super::fans::{self, Fan};
use super::prelude::*;
use crate::trade::exact;

/// From the smallest `f32` to the largest. Areas of `f32` code vanish below 2.6e-23 and overflow above 4.3e9.
const SCALES: [f64; 11] = [1e-45, 1e-38, 1e-30, 1e-19, 1e-12, 1.0, 1e6, 1e12, 1e19, 1e30, 3e38];
const OFFSETS: [f64; 7] = [1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7];
const TRIANGLES: usize = 200;
const FANS: usize = 5;

pub(super) fn magnitude_cases() -> Vec<StressCase> {
    let faces = SCALES.map(|scale| {
        face_normals::case(
            Group::Magnitude,
            "scaled-faces",
            format!("faces at {}", short(scale)),
            move || random_triangles(|numbers| (vector(numbers) * scale).as_vec3()),
        )
    });
    let mixed = face_normals::case(Group::Magnitude, "mixed-faces", "faces of 1e-38 to 1e38", || {
        let any = |numbers: &mut Numbers| {
            libm::copysign(libm::exp10(76.0 * numbers.unit() - 38.0), signed(numbers))
        };
        random_triangles(|numbers| Vec3::from_array([0; 3].map(|_| any(numbers) as f32)))
    });
    let vertices = SCALES.map(|scale| {
        // At the smallest number itself a fan vanishes.
        let scale = scale.max(1e-44);
        let fans = bumpy_fans().map(|fan| fan.scaled(scale)).to_vec();
        fans::case(Group::Magnitude, "scaled-fans", format!("vertices at {}", short(scale)), fans)
    });
    let long_spokes = [1e19, 1e30].map(|factor| {
        let mut fan = bumpy_fans()[0].clone();
        fan.triangles[2][1] *= factor as f32;
        fan.triangles[3][0] *= factor as f32;
        fans::case(Group::Magnitude, "long-spoke", format!("one spoke {factor:e} times longer"), vec![fan])
    });
    faces.into_iter().chain([mixed]).chain(vertices).chain(long_spokes).collect()
}

/// Triangles of random corners, some of them degenerate where representable numbers are few.
fn random_triangles(corner: impl Fn(&mut Numbers) -> Vec3) -> Vec<Triangle> {
    let mut numbers = Numbers::new(1);
    (0..TRIANGLES).map(|_| [0; 3].map(|_| corner(&mut numbers))).collect()
}

/// Fans of radius 0.6 to 1 around a raised vertex.
fn bumpy_fans() -> [Fan; FANS] {
    let mut numbers = Numbers::new(2);
    [0; FANS].map(|_| {
        let rim = |k: usize, numbers: &mut Numbers| {
            let turn = TAU * (k as f64 + 0.4 * numbers.unit()) / 7.0;
            let radius = 0.6 + 0.4 * numbers.unit();
            DVec3::new(radius * libm::cos(turn), radius * libm::sin(turn), 0.4 * numbers.unit()).as_vec3()
        };
        let ring: Vec<Vec3> = (0..7).map(|k| rim(k, &mut numbers)).collect();
        Fan::closed(DVec3::new(0.1, -0.1, 0.7).as_vec3(), &ring)
    })
}

/// A power of ten as it is written.
fn short(scale: f64) -> String {
    if scale == 1.0 { "1".into() } else { format!("{scale:e}") }
}

pub(super) fn offset_cases() -> Vec<StressCase> {
    let arithmetic = OFFSETS.map(|offset| {
        face_normals::case(
            Group::Offset,
            "offset-arithmetic",
            format!("{offset:.0e}, arithmetic"),
            move || equilateral_triangles(offset).into_iter().map(stored).collect(),
        )
    });
    arithmetic.into_iter().chain(OFFSETS.map(storage_case)).collect()
}

/// The error against the positions before they were rounded. No arithmetic on `f32` positions can avoid it; an origin
/// near the mesh, kept in `f64`, does.
fn storage_case(offset: f64) -> StressCase {
    // A corner moves by half a spacing on each axis; n = e1×e2 of length sin 60° by up to 4δ + 4δ².
    let spacing = f64::from(f32::EPSILON) * libm::exp2(libm::floor(libm::log2(offset + 1.0)));
    let moved = 0.5 * 3.0_f64.sqrt() * spacing;
    let sine = (4.0 * moved + 4.0 * moved * moved) / (0.5 * 3.0_f64.sqrt());
    let turned = if sine < 1.0 { libm::asin(sine).to_degrees() } else { 180.0 };
    let most = (turned + 1e-5).min(180.0);
    let faithful = Bound::new(most, Unit::Degrees, "offset-storage-bound");
    let fast = Bound::new((most + FAST.most).min(180.0), Unit::Degrees, "offset-storage-fast");
    let name = format!("{offset:.0e}, storage");
    StressCase::new(Group::Offset, "offset-storage", name, (faithful, Some(fast)), move || {
        measure_storage(offset)
    })
}

fn measure_storage(offset: f64) -> Measured {
    let originals = equilateral_triangles(offset);
    let triangles: Vec<Triangle> = originals.iter().map(|&triangle| stored(triangle)).collect();
    let mut declined = 0;
    let normals = face_normals::faithful(&triangles);
    let errors = originals.iter().zip(&triangles).zip(normals).map(|((original, triangle), faithful)| {
        let truth = exact::face_normal(original).expect("an equilateral triangle has an area");
        let degrees = |normal: DVec3| Outcome::degrees(normal, &truth);
        let (normal, is_degenerate) = faithful;
        let fast = face_normals::fast(triangle);
        declined += usize::from(fast.declined);
        // Rounding made the triangle degenerate: a fallback normal, by up to half a turn off.
        [
            if is_degenerate { 180.0.into() } else { degrees(DVec3::from(normal.map(f64::from))) },
            if fast.fault.is_some() { 180.0.into() } else { degrees(fast.normal) },
            degrees(face_normals::plain(triangle)),
        ]
    });
    let measured = Measured::triples(errors);
    Measured { declined, ..measured }
}

/// Triangles of side 1, rotated at random, in double precision.
fn equilateral_triangles(offset: f64) -> Vec<[DVec3; 3]> {
    let mut numbers = Numbers::new(3);
    let corner = [DVec3::ZERO, DVec3::X, DVec3::new(0.5, 0.5 * 3.0_f64.sqrt(), 0.0)];
    let triangle = |_| {
        let turn = rotation(&mut numbers);
        let place = DVec3::splat(offset) + DVec3::from_array([0; 3].map(|_| 0.5 * numbers.unit()));
        corner.map(|corner| turn * corner + place)
    };
    (0..TRIANGLES).map(triangle).collect()
}

fn stored(triangle: [DVec3; 3]) -> Triangle {
    triangle.map(|corner| corner.as_vec3())
}
