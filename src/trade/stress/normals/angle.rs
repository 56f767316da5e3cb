//! Corners that are nearly closed or nearly straight.

use crate::num::numbers::Numbers;
use crate::num::{Split, corner_angle, cross};
use crate::trade::exact::{self, big, small};
use crate::trade::stress::case::{Bound, Measured, StressCase, Unit, Worst};
use crate::trade::stress::group::Group;
use crate::trade::stress::normals::naive;
use glam::{DVec3, Vec3};

const CORNERS: usize = 300;

/// |e1×e2|, e1·e2 and the arc tangent: the cross product is within 2u of each component, u = 2⁻⁵³, the arc tangent 2 ulp.
const NEAR_0: Bound = Bound::new(
    2e-15,
    Unit::Relative,
    "16/2^53: cross product 2, length 3, dot product 4, corner_angle 2 ulp, and slack",
);

pub(in crate::trade::stress) fn cases() -> Vec<StressCase> {
    let near_0 = [1e-6, 1e-3, 0.1, 1.0].map(|angle: f64| case(format!("{angle} rad"), angle));
    let near_pi =
        [0.1, 1e-3, 1e-6].map(|rest: f64| case(format!("pi - {rest} rad"), std::f64::consts::PI - rest));
    near_0.into_iter().chain(near_pi).chain([straight()]).collect()
}

fn case(name: String, angle: f64) -> StressCase {
    StressCase {
        group: Group::Angle,
        name,
        what: "corners of this angle between edges of 1/2 to 2, in f64; plain code has them in f32",
        expectation: "right to the last bits of f64, relative to the angle",
        bound: NEAR_0,
        fast_bound: None,
        plain_unit: Unit::Relative,
        plain_formula: "acos(dot(unit(a), unit(b)))",
        measure: Box::new(move || measure(angle)),
    }
}

fn measure(angle: f64) -> Measured {
    let mut numbers = Numbers::new(10);
    let (mut faithful, mut plain) = (Worst::default(), Worst::default());
    for _ in 0..CORNERS {
        let mut vector = || DVec3::from_array([0; 3].map(|_| 2.0 * numbers.unit() - 1.0)).normalize();
        let (along, other) = (vector(), vector());
        let across = along.cross(other).normalize();
        let turned = along * libm::cos(angle) + across * libm::sin(angle);
        // In f64, whose products have to be rounded; plain code gets them in f32, and is held to those.
        let [e1, e2] = [along, turned].map(|e| e * (0.5 + 1.5 * numbers.unit()));
        let truth = true_angle(e1, e2);
        faithful.add(((computed(e1, e2) - truth) / truth).abs());
        let [e1, e2] = [e1, e2].map(|e| e.as_vec3());
        let truth = true_angle(e1.as_dvec3(), e2.as_dvec3());
        let portable = naive::angle(naive::unit(e1), naive::unit(e2));
        plain.add(((f64::from(portable) - truth) / truth).abs());
    }
    Measured { samples: CORNERS, faithful, plain: Some(plain), ..Measured::default() }
}

/// As angle weights have it.
fn computed(e1: DVec3, e2: DVec3) -> f64 {
    corner_angle(cross::<Split>(e1, e2).length(), e1.dot(e2))
}

fn true_angle(e1: DVec3, e2: DVec3) -> f64 {
    let [e1, e2] = [e1, e2].map(|e| e.to_array().map(big));
    small(&exact::angle(&e1, &e2))
}

/// Exactly 0 and exactly π.
fn straight() -> StressCase {
    StressCase {
        group: Group::Angle,
        name: "exactly 0 and pi".into(),
        what: "edges of small whole numbers with a multiple of themselves, forth and back",
        expectation: "exactly 0, and the double next to pi",
        bound: Bound::none_wrong("cross products of such numbers are exact, and exactly zero"),
        fast_bound: None,
        plain_unit: Unit::Wrong,
        plain_formula: "acos(dot(unit(a), unit(b)))",
        measure: Box::new(|| {
            let mut numbers = Numbers::new(11);
            let (mut wrong, mut plainly_wrong, mut undefined) = (0, 0, 0);
            for _ in 0..CORNERS {
                let e1 = Vec3::from_array([0; 3].map(|_| numbers.below(1000) as f32 + 1.0));
                let times = numbers.below(100) as f32 + 1.0;
                for (e2, angle) in [(e1 * times, 0.0), (e1 * -times, std::f64::consts::PI)] {
                    wrong += usize::from(computed(e1.as_dvec3(), e2.as_dvec3()) != angle);
                    let portable = naive::angle(naive::unit(e1), naive::unit(e2));
                    undefined += usize::from(portable.is_nan());
                    plainly_wrong += usize::from(!portable.is_nan() && portable != angle as f32);
                }
            }
            let plain = Some(Worst { error: plainly_wrong as f64, undefined });
            Measured { samples: 2 * CORNERS, faithful: Worst::wrong(wrong), plain, ..Measured::default() }
        }),
    }
}
