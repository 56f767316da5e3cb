//! Unit vectors of vectors whose squares are out of range.

use crate::num::UnitVec3;
use crate::num::numbers::Numbers;
use crate::trade::exact;
use crate::trade::stress::case::{Bound, Measured, StressCase, Unit, Worst};
use crate::trade::stress::group::Group;
use crate::trade::stress::normals::naive;
use glam::DVec3;

const VECTORS: usize = 500;

/// Powers of ten between which lengths lie, and what they are.
const RANGES: [(&str, f64, f64); 6] = [
    ("subnormal f32", -44.9, -38.0),
    ("squares subnormal in f32", -23.0, -19.0),
    ("of ordinary length", -3.0, 3.0),
    ("squares beyond f32", 19.0, 38.4),
    ("subnormal f64", -323.0, -308.0),
    ("largest f64", 150.0, 308.0),
];

pub(in crate::trade::stress) fn cases() -> Vec<StressCase> {
    RANGES.into_iter().map(|(name, low, high)| case(name, low, high)).collect()
}

fn case(name: &str, low: f64, high: f64) -> StressCase {
    StressCase {
        group: Group::Unit,
        name: name.into(),
        what: "UnitVec3 of random vectors of these lengths",
        expectation: "right to the last bits of f64",
        bound: Bound::new(
            libm::ldexp(1.0, -51),
            Unit::Absolute,
            "UnitVec3: within 2^-51; three squares, two sums, a root, a division and a product of 2^-53 each",
        ),
        fast_bound: None,
        plain_unit: Unit::Absolute,
        plain_formula: "v / sqrt(v·v)",
        measure: Box::new(move || measure(low, high)),
    }
}

fn measure(low: f64, high: f64) -> Measured {
    let mut numbers = Numbers::new(12);
    let (mut faithful, mut plain) = (Worst::default(), Worst::default());
    let is_single = low > -46.0 && high < 39.0;
    for _ in 0..VECTORS {
        let length = libm::exp10(low + (high - low) * numbers.unit());
        let mut v = DVec3::from_array([0; 3].map(|_| (2.0 * numbers.unit() - 1.0) * length));
        if is_single {
            v = v.as_vec3().as_dvec3();
        }
        let Some(truth) = exact::unit(&v.to_array().map(exact::big)) else { continue };
        faithful.add(exact::distance(UnitVec3::new(v).map_or(DVec3::NAN, UnitVec3::get), &truth));
        plain.add(exact::distance(naive::direction(naive::unit(v.as_vec3())), &truth));
    }
    Measured { samples: VECTORS, faithful, plain: Some(plain), ..Measured::default() }
}
