//! Many faces at one vertex, and face normals that nearly cancel.

use crate::normals::Weight;
use crate::trade::stress::case::{StressCase, Unit};
use crate::trade::stress::group::Group;
use crate::trade::stress::normals::fans::{self, Fan};

/// Height of the cones whose valence varies: their faces are tilted by 1/10.
const HEIGHT: f64 = 10.0;
/// Faces that are counted one by one by every weight; beyond, the uniform weight tells what there is to tell.
const FEW: usize = 1000;
/// Tilts of faces from the vertical: sums shrink by one over this.
const TILTS: [f64; 5] = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5];
/// Valence of the fans that nearly cancel.
const FACES: usize = 10_000;

pub(in crate::trade::stress) fn cases() -> Vec<StressCase> {
    let valences = [3, 10, 100, FEW, 100_000, 1_000_000].map(|valence| {
        let weights = if valence <= FEW { &fans::WEIGHTS[..] } else { &[Weight::Uniform] };
        case(
            format!("{valence} faces"),
            "the tip of a cone ten times higher than wide",
            valence,
            HEIGHT,
            weights,
        )
    });
    let tilts = TILTS.map(|tilt| {
        let what =
            "10000 faces, uniform weights, each this far from the vertical: their sum shrinks by as much";
        case(format!("tilt {tilt:.0e}"), what, FACES, 1.0 / tilt, &[Weight::Uniform])
    });
    // Few enough for `fast`, and steep enough that a sum loses all but three digits: where it still runs, and beyond.
    let steep = [1e-1, 1e-2, 2e-3, 5e-4].map(|tilt: f64| {
        let what = "8 faces, each this far from the vertical: their sum shrinks by as much";
        case(format!("tilt {tilt:.0e}, 8 faces"), what, 8, 1.0 / tilt, &fans::WEIGHTS)
    });
    valences.into_iter().chain(tilts).chain(steep).collect()
}

fn case(
    name: String,
    what: &'static str,
    valence: usize,
    height: f64,
    weights: &'static [Weight],
) -> StressCase {
    // The bounds depend on the fan's shape only through what its sum shrinks by, which a smaller one tells as well.
    let shape = Fan::cone(valence.min(FACES), height);
    StressCase {
        group: Group::Valence,
        name,
        what,
        expectation: "right to the rounding to f32 and of the sum",
        bound: fans::bound(&shape, valence),
        fast_bound: Some(fans::fast_bound(&shape, valence)),
        plain_unit: Unit::Degrees,
        plain_formula: fans::FORMULA,
        measure: Box::new(move || fans::measure(&[Fan::cone(valence, height)], weights)),
    }
}
