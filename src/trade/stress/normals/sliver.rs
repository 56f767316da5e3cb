//! Faces much longer than high, and the height below which a face is a sliver.

use crate::normals::{FaultReason, Scratch, Slivers, Weight, face_normals};
use crate::num::numbers::Numbers;
use crate::trade::exact;
use crate::trade::stress::case::{Bound, Measured, StressCase, Unit, Worst};
use crate::trade::stress::group::Group;
use crate::trade::stress::normals::fans;
use crate::trade::stress::normals::naive;
use crate::trade::stress::normals::triangles::{self, Triangle};
use glam::{DVec3, Vec3};

/// Height over length.
const THINNESS: [f64; 8] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-12];
const TRIANGLES: usize = 300;
const ALL_REPORTED: Bound =
    Bound::none_wrong("Slivers: lower than four times the spacing at the largest coordinate");
/// What rounding leaves of a number near 1.
const SPACING: f32 = f32::EPSILON;

pub(in crate::trade::stress) fn cases() -> Vec<StressCase> {
    THINNESS.map(needles).into_iter().chain([threshold(), next_to()]).collect()
}

fn needles(thinness: f64) -> StressCase {
    StressCase {
        group: Group::Needle,
        name: format!("height/length {thinness:.0e}"),
        what: "triangles of length 1 and this height before rounding, one half through the origin",
        expectation: triangles::EXPECTATION,
        bound: triangles::ONE_ULP,
        fast_bound: Some(triangles::FAST),
        plain_unit: Unit::Degrees,
        plain_formula: triangles::FORMULA,
        measure: Box::new(move || triangles::measure(&thin(thinness))),
    }
}

/// Long sides in any direction; one half with a corner at the origin, where numbers are finest.
fn thin(thinness: f64) -> Vec<Triangle> {
    let mut numbers = Numbers::new(4);
    let vector = |numbers: &mut Numbers| DVec3::from_array([0; 3].map(|_| 2.0 * numbers.unit() - 1.0));
    let triangle = |i: usize| {
        let along = vector(&mut numbers).normalize();
        let across = along.cross(vector(&mut numbers)).normalize();
        let start = if i.is_multiple_of(2) { DVec3::ZERO } else { vector(&mut numbers) };
        let apex = along * numbers.unit() + across * thinness;
        [start, start + along, start + apex].map(|corner| corner.as_vec3())
    };
    (0..TRIANGLES).map(triangle).collect()
}

/// Heights of 1 to 8 spacings over a base from 1 to 1.75, along each pair of axes.
fn threshold() -> StressCase {
    StressCase {
        group: Group::Needle,
        name: "sliver threshold".into(),
        what: "heights of 1 to 8 spacings of f32, along each pair of axes: which are called slivers",
        expectation: "slivers below 4 spacings, and no others",
        bound: ALL_REPORTED,
        fast_bound: Some(ALL_REPORTED),
        plain_unit: Unit::Wrong,
        plain_formula: "sqrt(n·n) < 1e-6",
        measure: Box::new(measure_threshold),
    }
}

fn measure_threshold() -> Measured {
    let (mut samples, mut wrong, mut plainly_wrong) = (0, 0, 0);
    let (mut fast_wrong, mut declined) = (0, 0);
    for spacings in 1..=8_u8 {
        for axis in 0..3 {
            let point = |along: f32, up: f32| {
                let mut point = [0.0; 3];
                (point[axis], point[(axis + 1) % 3]) = (along, up);
                point
            };
            for size in [1_048_576.0, 1.0, 1.0 / 1_048_576.0] {
                let height = f32::from(spacings) * SPACING;
                let corners = [point(1.0, 0.0), point(1.75, 0.0), point(1.25, height)];
                let corners = corners.map(|corner| corner.map(|x| x * size));
                let mut normal = [[0.0; 3]];
                let faults = face_normals(&corners, &[[0, 1, 2]], &mut Scratch::new(), &mut normal);
                let faults = faults.expect("slices that go together").faces;
                let is_sliver = faults.iter().any(|fault| fault.reason == FaultReason::BelowStorage);
                let [a, b, c] = corners.map(Vec3::from);
                let quick = triangles::fast(&[a, b, c]);
                declined += usize::from(quick.declined);
                let is_called_sliver = quick.fault == Some(FaultReason::BelowStorage);
                fast_wrong += usize::from(is_called_sliver != (spacings < 4));
                samples += 1;
                wrong += usize::from(is_sliver != (spacings < 4));
                plainly_wrong += usize::from(((b - a).cross(c - a).length() < 1e-6) != (spacings < 4));
            }
        }
    }
    Measured {
        samples,
        faithful: Worst::wrong(wrong),
        fast: Some(Worst::wrong(fast_wrong)),
        declined,
        plain: Some(Worst::wrong(plainly_wrong)),
    }
}

/// A sliver, whose direction is rounding, must not turn the normal of a vertex.
fn next_to() -> StressCase {
    StressCase {
        group: Group::Needle,
        name: "vertex beside a sliver".into(),
        what: "fans of six triangles and one sliver, uniform weights: the error against the fan without it",
        expectation: "the sliver adds nothing",
        bound: Bound::new(3e-6, Unit::Degrees, "rounding to f32, sqrt(3)/2^25 rad"),
        fast_bound: Some(triangles::FAST),
        plain_unit: Unit::Degrees,
        plain_formula: fans::FORMULA,
        measure: Box::new(measure_near),
    }
}

fn measure_near() -> Measured {
    let (mut faithful, mut fast, mut plain) = (Worst::default(), Worst::default(), Worst::default());
    let mut declined = 0;
    let mut numbers = Numbers::new(5);
    let samples = 50;
    for _ in 0..samples {
        let mut fan = fans::Fan::cone(6, 0.3);
        let good: Vec<[DVec3; 2]> = fan.triangles.iter().map(|pair| pair.map(|p| p.as_dvec3())).collect();
        let truth = exact::vertex_normal(fan.centre.as_dvec3(), &good, Weight::Uniform);
        let truth = truth.expect("the tip of a cone has a normal");
        // On the way to the rim, but for a spacing.
        let [a, _] = fan.triangles[numbers.below(6)];
        let off = Vec3::from_array([0; 3].map(|_| SPACING * (2.0 * numbers.unit() - 1.0) as f32));
        fan.triangles.push([a, fan.centre + (a - fan.centre) * 0.5 + off]);
        let positions: Vec<Vec3> =
            std::iter::once(fan.centre).chain(fan.triangles.iter().flatten().copied()).collect();
        let indices: Vec<[u32; 3]> = (0..7).map(|i| [0, 2 * i + 1, 2 * i + 2]).collect();
        let normal = fans::faithful(&positions, &indices, Weight::Uniform, Slivers::Exclude)[0];
        let quick = fans::fast(&triangles::indexed(&positions, &indices), Weight::Uniform, Slivers::Exclude);
        declined += usize::from(quick.summary.fast_declined);
        fast.add(exact::angle_to(quick.normals.values[0], &truth).to_degrees());
        let portable = naive::vertex_normal(fan.centre, &fan.triangles, Weight::Uniform);
        faithful.add(exact::angle_to(normal, &truth).to_degrees());
        plain.add(exact::angle_to(naive::direction(portable), &truth).to_degrees());
    }
    Measured { samples, faithful, fast: Some(fast), declined, plain: Some(plain) }
}
