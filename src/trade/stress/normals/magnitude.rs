//! Coordinates at the ends of `f32`.

use crate::num::numbers::Numbers;
use crate::trade::stress::case::{StressCase, Unit};
use crate::trade::stress::group::Group;
use crate::trade::stress::normals::fans::{self, Fan};
use crate::trade::stress::normals::triangles::{self, Triangle};
use glam::{DVec3, Vec3};

/// From the smallest `f32` to the largest. Areas of `f32` code vanish below 2.6e-23 and overflow above 4.3e9.
const SCALES: [f64; 11] = [1e-45, 1e-38, 1e-30, 1e-19, 1e-12, 1.0, 1e6, 1e12, 1e19, 1e30, 3e38];
const TRIANGLES: usize = 200;
const FANS: usize = 5;

pub(in crate::trade::stress) fn cases() -> Vec<StressCase> {
    let faces = SCALES.map(|scale| {
        face_case(
            format!("faces at {}", short(scale)),
            "random triangles, coordinates up to this",
            move || random(|numbers| Vec3::from_array([0; 3].map(|_| (signed(numbers) * scale) as f32))),
        )
    });
    let mixed = face_case("faces of 1e-38 to 1e38".into(), "every coordinate of any magnitude", || {
        random(|numbers| {
            let any = |numbers: &mut Numbers| {
                libm::copysign(libm::exp10(76.0 * numbers.unit() - 38.0), signed(numbers))
            };
            Vec3::from_array([0; 3].map(|_| any(numbers) as f32))
        })
    });
    // Of a fan, nothing would be left at the smallest number itself.
    let vertices = SCALES.map(|scale| vertex_case(scale.max(1e-44)));
    let lopsided = [1e19, 1e30].map(lopsided_case);
    faces.into_iter().chain([mixed]).chain(vertices).chain(lopsided).collect()
}

fn face_case(
    name: String,
    what: &'static str,
    triangles: impl Fn() -> Vec<Triangle> + Send + Sync + 'static,
) -> StressCase {
    StressCase {
        group: Group::Magnitude,
        name,
        what,
        expectation: triangles::EXPECTATION,
        bound: triangles::ONE_ULP,
        fast_bound: Some(triangles::FAST),
        plain_unit: Unit::Degrees,
        plain_formula: triangles::FORMULA,
        measure: Box::new(move || triangles::measure(&triangles())),
    }
}

fn vertex_case(scale: f64) -> StressCase {
    let what = "bumpy fans of seven triangles by six weights, coordinates up to this";
    fan_case(format!("vertices at {}", short(scale)), what, bumpy().map(|fan| fan.scaled(scale)).to_vec())
}

/// One spoke far longer than the others, so that the triangles of one vertex differ by this factor.
fn lopsided_case(factor: f64) -> StressCase {
    let mut fan = bumpy()[0].clone();
    fan.triangles[2][1] *= factor as f32;
    fan.triangles[3][0] *= factor as f32;
    let name = format!("one spoke {factor:e} times longer");
    fan_case(name, "a bumpy fan by six weights, one of whose seven spokes is so long", vec![fan])
}

fn fan_case(name: String, what: &'static str, fans: Vec<Fan>) -> StressCase {
    let widest = fans.iter().map(|fan| fans::bound(fan, 7)).max_by(|a, b| a.most.total_cmp(&b.most));
    let fast = fans.iter().map(|fan| fans::fast_bound(fan, 7)).max_by(|a, b| a.most.total_cmp(&b.most));
    StressCase {
        group: Group::Magnitude,
        name,
        what,
        expectation: "right to the rounding to f32",
        bound: widest.expect("at least one fan"),
        fast_bound: fast,
        plain_unit: Unit::Degrees,
        plain_formula: fans::FORMULA,
        measure: Box::new(move || fans::measure(&fans, &fans::WEIGHTS)),
    }
}

/// Triangles of random corners, some of them degenerate where there are few numbers.
fn random(corner: impl Fn(&mut Numbers) -> Vec3) -> Vec<Triangle> {
    let mut numbers = Numbers::new(1);
    (0..TRIANGLES).map(|_| [0; 3].map(|_| corner(&mut numbers))).collect()
}

/// Fans of radius 0.6 to 1 round a vertex that stands out.
fn bumpy() -> [Fan; FANS] {
    let mut numbers = Numbers::new(2);
    [0; FANS].map(|_| {
        let rim = |k: usize, numbers: &mut Numbers| {
            let turn = std::f64::consts::TAU * (k as f64 + 0.4 * numbers.unit()) / 7.0;
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

/// Uniform in ±1.
fn signed(numbers: &mut Numbers) -> f64 {
    2.0 * numbers.unit() - 1.0
}
