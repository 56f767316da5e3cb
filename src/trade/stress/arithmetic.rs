//! Differences of nearly equal products, unit vectors of extreme length, and corners near 0 and π.

use super::prelude::*;
use crate::num::{Split, UnitVec3, corner_angle, cross, difference_of_products};

const PRODUCTS: usize = 2000;
const VECTORS: usize = 500;
const CORNERS: usize = 300;

/// a, b, c, d of M. Pharr, *Accurate differences of products with Kahan's algorithm* (2019): −75.1656.
const PHARR: [f32; 4] = [33_962.035, -30_438.8, 41_563.4, -24_871.969];

pub(super) fn product_cases() -> Vec<StressCase> {
    let case = |texts, name, factors: fn() -> Vec<[f64; 4]>| {
        let bound = Bound::new(2.3e-16, Unit::Relative, "product-bound");
        StressCase::new(Group::Product, texts, name, (bound, None), move || {
            Measured::pairs(factors().into_iter().map(product_errors))
        })
    };
    vec![
        case("pharr", "Pharr's", || vec![PHARR.map(f64::from)]),
        case("products", "nearly equal products", || {
            let mut numbers = Numbers::new(13);
            let four = |_| {
                let [a, b, c] = [0; 3].map(|_| numbers.spread(20) as f32);
                [a, b, c, (f64::from(a) * f64::from(b) / f64::from(c)) as f32]
            };
            (0..PRODUCTS).map(four).map(|four: [f32; 4]| four.map(f64::from)).collect()
        }),
        case("double-products", "nearly equal products of doubles", || {
            let mut numbers = Numbers::new(14);
            let four = |_| {
                let [a, b, c] = [0; 3].map(|_| numbers.spread(20));
                [a, b, c, a * b / c]
            };
            (0..PRODUCTS).map(four).collect()
        }),
    ]
}

fn product_errors([a, b, c, d]: [f64; 4]) -> [f64; 2] {
    let truth = |[a, b, c, d]: [f64; 4]| big(a) * big(b) - big(c) * big(d);
    let found = difference_of_products::<Split>(a, b, c, d);
    // Plain code rounds the factors itself; its truth is that of the rounded ones.
    let single = [a, b, c, d].map(|x| x as f32);
    let plain = f64::from(single[0] * single[1] - single[2] * single[3]);
    [relative(found, &truth([a, b, c, d])), relative(plain, &truth(single.map(f64::from)))]
}

/// |found − truth| / |truth|; for a truth of zero, 0 or infinity.
fn relative(found: f64, truth: &Big) -> f64 {
    if *truth == Big::ZERO {
        return if found == 0.0 { 0.0 } else { f64::INFINITY };
    }
    small(&((big(found) - truth).abs() / truth.clone().abs()))
}

pub(super) fn unit_vector_cases() -> Vec<StressCase> {
    // Powers of ten between which lengths lie.
    let ranges = [
        ("subnormal f32", -44.9, -38.0),
        ("squares subnormal in f32", -23.0, -19.0),
        ("of ordinary length", -3.0, 3.0),
        ("squares beyond f32", 19.0, 38.4),
        ("subnormal f64", -323.0, -308.0),
        ("largest f64", 150.0, 308.0),
    ];
    let case = |(name, low, high)| {
        let bound = Bound::new(libm::ldexp(1.0, -51), Unit::Absolute, "unit-vector-bound");
        StressCase::new(Group::Unit, "unit-vector", name, (bound, None), move || {
            measure_unit_vectors(low, high)
        })
    };
    ranges.map(case).into()
}

fn measure_unit_vectors(low: f64, high: f64) -> Measured {
    let mut numbers = Numbers::new(12);
    let is_single = low > -46.0 && high < 39.0;
    let errors = (0..VECTORS).filter_map(|_| {
        let length = libm::exp10(low + (high - low) * numbers.unit());
        let mut v = vector(&mut numbers) * length;
        if is_single {
            v = v.as_vec3().as_dvec3();
        }
        let truth = exact::unit(&v.to_array().map(big))?;
        let faithful = UnitVec3::new(v).map_or(DVec3::NAN, UnitVec3::get);
        let plain = plain::unit(v.as_vec3()).as_dvec3();
        Some([faithful, plain].map(|unit| Outcome::vector(unit, |unit| exact::distance(unit, &truth))))
    });
    Measured { samples: VECTORS, ..Measured::pairs(errors) }
}

pub(super) fn angle_cases() -> Vec<StressCase> {
    let case = |name: String, angle: f64| {
        // |e1×e2|, e1·e2 and the arc tangent: the cross product is within 2u of each component, u = 2⁻⁵³, the arc tangent 2 ulp.
        let bound = Bound::new(2e-15, Unit::Relative, "corner-angle-bound");
        StressCase::new(Group::Angle, "corner-angle", name, (bound, None), move || measure_angles(angle))
    };
    let near_0 = [1e-6, 1e-3, 0.1, 1.0].map(|angle: f64| case(format!("{angle} rad"), angle));
    let near_pi = [0.1, 1e-3, 1e-6].map(|rest: f64| case(format!("pi - {rest} rad"), PI - rest));
    let bound = Bound::none_wrong("straight-bound");
    let straight =
        StressCase::new(Group::Angle, "straight", "exactly 0 and pi", (bound, None), measure_straight);
    near_0.into_iter().chain(near_pi).chain([straight]).collect()
}

fn measure_angles(angle: f64) -> Measured {
    let mut numbers = Numbers::new(10);
    Measured::pairs((0..CORNERS).map(|_| {
        let [along, other] = [0; 2].map(|_| vector(&mut numbers).normalize());
        let across = along.cross(other).normalize();
        let turned = along * libm::cos(angle) + across * libm::sin(angle);
        // In f64, whose products have to be rounded; plain code has f32 edges, and the truth of those.
        let [e1, e2] = [along, turned].map(|e| e * (0.5 + 1.5 * numbers.unit()));
        let truth = true_angle(e1, e2);
        let faithful = ((computed_angle(e1, e2) - truth) / truth).abs();
        let [e1, e2] = [e1, e2].map(|e| e.as_vec3());
        let truth = true_angle(e1.as_dvec3(), e2.as_dvec3());
        let plain = plain::angle(plain::unit(e1), plain::unit(e2));
        [faithful, ((f64::from(plain) - truth) / truth).abs()]
    }))
}

/// The angle as angle weights compute it.
fn computed_angle(e1: DVec3, e2: DVec3) -> f64 {
    corner_angle(cross::<Split>(e1, e2).length(), e1.dot(e2))
}

fn true_angle(e1: DVec3, e2: DVec3) -> f64 {
    let [e1, e2] = [e1, e2].map(|e| e.to_array().map(big));
    small(&exact::angle(&e1, &e2))
}

fn measure_straight() -> Measured {
    let mut numbers = Numbers::new(11);
    let (mut wrong, mut plain_wrong, mut nan) = (0, 0, 0);
    for _ in 0..CORNERS {
        let e1 = Vec3::from_array([0; 3].map(|_| numbers.below(1000) as f32 + 1.0));
        let times = numbers.below(100) as f32 + 1.0;
        for (e2, angle) in [(e1 * times, 0.0), (e1 * -times, PI)] {
            wrong += usize::from(computed_angle(e1.as_dvec3(), e2.as_dvec3()) != angle);
            let plain = plain::angle(plain::unit(e1), plain::unit(e2));
            nan += usize::from(plain.is_nan());
            plain_wrong += usize::from(!plain.is_nan() && plain != angle as f32);
        }
    }
    let plain = Some(Worst { nan, ..Worst::wrong(plain_wrong) });
    Measured { plain, ..Measured::wrong(2 * CORNERS, [wrong, 0, 0]) }
}
