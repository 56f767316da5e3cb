//! Faces that meet as they do in no smooth surface.

use crate::normals::{Crease, FaultReason, Faults, NormalRecipe, Precision, Scope, compute};
use crate::num::numbers::Numbers;
use crate::trade::stress::case::{Bound, Measured, StressCase, Unit, Worst};
use crate::trade::stress::group::Group;
use crate::trade::stress::normals::fans::{self, Fan};
use crate::trade::stress::normals::naive;
use crate::trade::stress::normals::triangles::indexed;
use glam::{DVec3, Vec3};

/// Heights of cones over a base of radius 1, from nearly flat to needle-like.
const HEIGHTS: [f64; 5] = [1e-4, 1e-2, 1.0, 1e2, 1e4];

pub(in crate::trade::stress) fn cases() -> Vec<StressCase> {
    let folds = [10.0, 1.0, 0.1].map(|degrees| {
        let what = "fans that go forth and back over themselves, opened by this angle, by six weights";
        sum_case(format!("folded to {degrees} degrees"), what, folded(degrees))
    });
    let fins = sum_case(
        "edges of three faces".into(),
        "a vertex on an edge of three faces and one of two, by six weights",
        fins(),
    );
    let tips = HEIGHTS.map(|height| {
        let what = "cones of 3, 8 and 64 faces and this height over a base of radius 1, by six weights";
        sum_case(
            format!("cone tips of height {height}"),
            what,
            [3, 8, 64].map(|n| Fan::cone(n, height)).to_vec(),
        )
    });
    [opposite()].into_iter().chain(folds).chain([fins]).chain(tips).collect()
}

fn sum_case(name: String, what: &'static str, fans: Vec<Fan>) -> StressCase {
    let widest = |bound: fn(&Fan, usize) -> Bound| {
        let bounds = fans.iter().map(|fan| bound(fan, fan.triangles.len()));
        bounds.max_by(|a, b| a.most.total_cmp(&b.most)).expect("at least one fan")
    };
    StressCase {
        group: Group::Fan,
        name,
        what,
        expectation: "right to the rounding to f32 and of the sum",
        bound: widest(fans::bound),
        fast_bound: Some(widest(fans::fast_bound)),
        plain_unit: Unit::Degrees,
        plain_formula: fans::FORMULA,
        measure: Box::new(move || fans::measure(&fans, &fans::WEIGHTS)),
    }
}

/// Spokes forth and back, the way back lifted by an angle.
fn folded(degrees: f64) -> Vec<Fan> {
    let mut numbers = Numbers::new(7);
    let fan = |_| {
        let lift = libm::tan(degrees.to_radians());
        let rim = |k: usize| {
            let turn = 0.6 * k as f64;
            DVec3::new(libm::cos(turn), libm::sin(turn), 0.0)
        };
        let back = |k: usize, numbers: &mut Numbers| rim(k) + DVec3::Z * lift * (0.5 + numbers.unit());
        let mut ring: Vec<DVec3> = (0..5).map(rim).collect();
        ring.extend((1..4).rev().map(|k| back(k, &mut numbers)));
        let ring: Vec<Vec3> = ring.into_iter().map(|p| p.as_vec3()).collect();
        Fan::closed(Vec3::ZERO, &ring)
    };
    (0..10).map(fan).collect()
}

/// Three blades on one edge, and a fourth beside.
fn fins() -> Vec<Fan> {
    let mut numbers = Numbers::new(8);
    let fan = |_| {
        let mut blade = || Vec3::from_array([0; 3].map(|_| (2.0 * numbers.unit() - 1.0) as f32));
        let (edge, [a, b, c, d]) = (blade(), [blade(), blade(), blade(), blade()]);
        Fan { centre: Vec3::splat(0.1), triangles: vec![[edge, a], [edge, b], [edge, c], [a, d]] }
    };
    (0..20).map(fan).collect()
}

/// The same triangle from both sides: nothing is left, which has to be said.
fn opposite() -> StressCase {
    let no_direction =
        Bound::none_wrong("FaultReason::CancellingFan, with a finite unit normal in its place");
    StressCase {
        group: Group::Fan,
        name: "opposite faces".into(),
        what: "20 triangles, each with the same one turned round, by six weights",
        expectation: "each corner is reported, with a unit normal in its place",
        bound: no_direction,
        fast_bound: Some(no_direction),
        plain_unit: Unit::Wrong,
        plain_formula: fans::FORMULA,
        measure: Box::new(measure_opposite),
    }
}

fn measure_opposite() -> Measured {
    let mut numbers = Numbers::new(9);
    let positions: Vec<Vec3> =
        (0..60).map(|_| Vec3::from_array([0; 3].map(|_| numbers.unit() as f32))).collect();
    let triangles: Vec<[u32; 3]> =
        (0..20).flat_map(|i| [[3 * i, 3 * i + 1, 3 * i + 2], [3 * i, 3 * i + 2, 3 * i + 1]]).collect();
    let (mesh, corners) = (indexed(&positions, &triangles), 3 * triangles.len());
    let mut measured = Measured::default();
    let (mut wrong, mut fast_wrong, mut plain) = (0, 0, Worst::default());
    for weight in fans::WEIGHTS {
        let wrong_of = |precision| {
            let recipe = NormalRecipe {
                weight,
                crease: Crease::OFF,
                scope: Scope::Vertex,
                precision,
                ..NormalRecipe::default()
            };
            let field = compute(&mesh, &recipe);
            let named = Faults::count(&field.faults.corners, FaultReason::CancellingFan);
            let is_unit = |normal: &&DVec3| (normal.length() - 1.0).abs() < 1e-6;
            let normals = &field.normals.values;
            let bad = normals.len() - normals.iter().filter(is_unit).count();
            (corners - named + bad, field.summary.fast_declined)
        };
        wrong += wrong_of(Precision::Faithful).0;
        let (count, declined) = wrong_of(Precision::Fast);
        fast_wrong += count;
        measured.samples += corners;
        measured.declined += if declined { corners } else { 0 };
        for [a, b, c] in positions.as_chunks::<3>().0 {
            for [centre, e1, e2] in [[a, b, c], [b, c, a], [c, a, b]] {
                let normal = naive::vertex_normal(*centre, &[[*e1, *e2], [*e2, *e1]], weight);
                plain.add(if naive::direction(normal).is_nan() { f64::NAN } else { 1.0 });
            }
        }
    }
    Measured {
        faithful: Worst::wrong(wrong),
        fast: Some(Worst::wrong(fast_wrong)),
        plain: Some(plain),
        ..measured
    }
}
