//! ab − cd where the products are nearly equal.

use crate::num::numbers::Numbers;
use crate::num::{Split, difference_of_products};
use crate::trade::exact::{Big, big, small};
use crate::trade::stress::case::{Bound, Measured, StressCase, Unit, Worst};
use crate::trade::stress::group::Group;
use dashu::base::Abs;

const PRODUCTS: usize = 2000;

/// a, b, c, d of M. Pharr, *Accurate differences of products with Kahan's algorithm* (2019): −75.1656.
const PHARR: [f32; 4] = [33_962.035, -30_438.8, 41_563.4, -24_871.969];

const TWO_UNITS: Bound = Bound::new(
    2.3e-16,
    Unit::Relative,
    "2u, u = 2^-53: Jeannerod, Louvet & Muller, Math. Comp. 82, 2013, and the reading of the result",
);

pub(in crate::trade::stress) fn cases() -> Vec<StressCase> {
    let pharr = "33962.035·(-30438.8) - 41563.4·(-24871.969), which is -75.1656: plain f32 says -128";
    let doubles = "random f64 factors, whose products f64 has to round, d the f64 next to ab/c";
    let random = "random f32 factors of 1e-6 to 1e6, d the f32 next to ab/c";
    vec![
        case("Pharr's", pharr, || vec![PHARR.map(f64::from)]),
        case("nearly equal products", random, || {
            let mut numbers = Numbers::new(13);
            let four = |_| {
                let [a, b, c] = [0; 3].map(|_| numbers.spread(20) as f32);
                [a, b, c, (f64::from(a) * f64::from(b) / f64::from(c)) as f32]
            };
            (0..PRODUCTS).map(four).map(|four: [f32; 4]| four.map(f64::from)).collect()
        }),
        case("nearly equal products of doubles", doubles, || {
            let mut numbers = Numbers::new(14);
            let four = |_| {
                let [a, b, c] = [0; 3].map(|_| numbers.spread(20));
                [a, b, c, a * b / c]
            };
            (0..PRODUCTS).map(four).collect()
        }),
    ]
}

fn case(name: &str, what: &'static str, factors: fn() -> Vec<[f64; 4]>) -> StressCase {
    StressCase {
        group: Group::Product,
        name: name.into(),
        what,
        expectation: "within 2 roundings of the difference, or exactly 0",
        bound: TWO_UNITS,
        fast_bound: None,
        plain_unit: Unit::Relative,
        plain_formula: "a·b - c·d",
        measure: Box::new(move || {
            let factors = factors();
            let errors = factors.iter().map(|&[a, b, c, d]| {
                let truth = difference([a, b, c, d]);
                let got = difference_of_products::<Split>(a, b, c, d);
                // Of the factors that it is given, which it rounds itself.
                let single = [a, b, c, d].map(|x| x as f32);
                let portable = f64::from(single[0] * single[1] - single[2] * single[3]);
                [relative(got, &truth), relative(portable, &difference(single.map(f64::from)))]
            });
            let errors: Vec<[f64; 2]> = errors.collect();
            Measured {
                samples: factors.len(),
                faithful: errors.iter().map(|e| e[0]).collect(),
                plain: Some(errors.iter().map(|e| e[1]).collect::<Worst>()),
                ..Measured::default()
            }
        }),
    }
}

fn difference([a, b, c, d]: [f64; 4]) -> Big {
    big(a) * big(b) - big(c) * big(d)
}

/// |got − truth| / |truth|; of a truth of zero, whether it was met.
fn relative(got: f64, truth: &Big) -> f64 {
    if *truth == Big::ZERO {
        return if got == 0.0 { 0.0 } else { f64::INFINITY };
    }
    small(&((big(got) - truth).abs() / truth.clone().abs()))
}
