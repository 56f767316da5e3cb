//! Many faces at one vertex, and faces that meet as in no smooth surface.

use super::case::{Bound, Measured, StressCase, Worst};
use super::face_normals::indexed;
use super::fans::{self, Fan};
use super::group::Group;
use super::plain;
use super::random::vector;
use crate::normals::{FaultReason, Faults, NormalField, Precision, Weight, compute};
use crate::num::numbers::Numbers;
use glam::{DVec3, Vec3};

/// The height of the cones whose valence varies: their faces are tilted by 1/10.
const HEIGHT: f64 = 10.0;
/// The largest valence that all weights are computed with; beyond it, only the uniform one.
const FEW: usize = 1000;
/// The valence of the fans that nearly cancel.
const FACES: usize = 10_000;

pub(super) fn valence_cases() -> Vec<StressCase> {
    let valences = [3, 10, 100, FEW, 100_000, 1_000_000].map(|valence| {
        let weights = if valence <= FEW { &fans::WEIGHTS[..] } else { &[Weight::Uniform] };
        cone_case("valence", format!("{valence} faces"), valence, HEIGHT, weights)
    });
    // Sums shrink by one over the tilt of faces from the vertical.
    let tilts = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5].map(|tilt: f64| {
        cone_case("tilt", format!("tilt {tilt:.0e}"), FACES, 1.0 / tilt, &[Weight::Uniform])
    });
    // In the range of `fast`, up to where a sum loses all but three digits, and beyond.
    let steep = [1e-1, 1e-2, 2e-3, 5e-4].map(|tilt: f64| {
        cone_case("steep-tilt", format!("tilt {tilt:.0e}, 8 faces"), 8, 1.0 / tilt, &fans::WEIGHTS)
    });
    valences.into_iter().chain(tilts).chain(steep).collect()
}

fn cone_case(
    texts: &'static str,
    name: String,
    valence: usize,
    height: f64,
    weights: &'static [Weight],
) -> StressCase {
    // The bounds depend on the shape only through its condition number, which is that of a smaller fan.
    let bounds = Fan::cone(valence.min(FACES), height).bounds(valence);
    StressCase::new(Group::Valence, texts, name, bounds, move || {
        fans::measure(&[Fan::cone(valence, height)], weights)
    })
}

pub(super) fn fan_cases() -> Vec<StressCase> {
    let bound = Bound::none_wrong("opposite-bound");
    let bounds = (bound, Some(bound));
    let opposite = StressCase::new(Group::Fan, "opposite", "opposite faces", bounds, measure_opposite);
    let folds = [10.0, 1.0, 0.1].map(|degrees| {
        fans::case(Group::Fan, "folded", format!("folded to {degrees} degrees"), folded_fans(degrees))
    });
    let fins = fans::case(Group::Fan, "fins", "edges of three faces", fins());
    let tips = [1e-4, 1e-2, 1.0, 1e2, 1e4].map(|height| {
        let fans = [3, 8, 64].map(|n| Fan::cone(n, height)).to_vec();
        fans::case(Group::Fan, "cone-tips", format!("cone tips of height {height}"), fans)
    });
    [opposite].into_iter().chain(folds).chain([fins]).chain(tips).collect()
}

/// Spokes forth and back, the way back lifted by an angle.
fn folded_fans(degrees: f64) -> Vec<Fan> {
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

/// Three blades on one edge, and a fourth next to it.
fn fins() -> Vec<Fan> {
    let mut numbers = Numbers::new(8);
    let fan = |_| {
        let [edge, a, b, c, d] = [0; 5].map(|_| vector(&mut numbers).as_vec3());
        Fan { centre: Vec3::splat(0.1), triangles: vec![[edge, a], [edge, b], [edge, c], [a, d]] }
    };
    (0..20).map(fan).collect()
}

/// The same triangle from both sides: the sum cancels, which has to be reported.
fn measure_opposite() -> Measured {
    let mut numbers = Numbers::new(9);
    let positions: Vec<Vec3> =
        (0..60).map(|_| Vec3::from_array([0; 3].map(|_| numbers.unit() as f32))).collect();
    let triangles: Vec<[u32; 3]> =
        (0..20).flat_map(|i| [[3 * i, 3 * i + 1, 3 * i + 2], [3 * i, 3 * i + 2, 3 * i + 1]]).collect();
    let (mesh, corners) = (indexed(&positions, &triangles), 3 * triangles.len());
    // Corners that are not reported, and normals that are not unit.
    let wrong = |field: &NormalField| {
        let is_unit = |normal: &DVec3| (normal.length() - 1.0).abs() < 1e-6;
        let reported = Faults::count(&field.faults.corners, FaultReason::CancellingFan);
        corners - reported + field.normals.values.iter().filter(|normal| !is_unit(normal)).count()
    };
    let mut measured = Measured::default();
    let (mut faithful_wrong, mut fast_wrong, mut plain) = (0, 0, Worst::default());
    for weight in fans::WEIGHTS {
        let [faithful, fast] = [Precision::Faithful, Precision::Fast]
            .map(|precision| compute(&mesh, &fans::recipe(weight, precision)));
        faithful_wrong += wrong(&faithful);
        fast_wrong += wrong(&fast);
        measured.samples += corners;
        measured.declined += if fast.summary.fast_declined { corners } else { 0 };
        for [a, b, c] in positions.as_chunks::<3>().0 {
            for [centre, e1, e2] in [[a, b, c], [b, c, a], [c, a, b]] {
                let normal = plain::vertex_normal(*centre, &[[*e1, *e2], [*e2, *e1]], weight);
                plain.add(if plain::direction(normal).is_nan() { f64::NAN } else { 1.0 });
            }
        }
    }
    Measured {
        faithful: Worst::wrong(faithful_wrong),
        fast: Some(Worst::wrong(fast_wrong)),
        plain: Some(plain),
        ..measured
    }
}
