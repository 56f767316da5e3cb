//! Stored precision: the step that all components are multiples of.

use super::Thresholds;
use super::catalogue::Kind;
use super::facts::Facts;
use super::tally::{Spot, Tallies};
use crate::mesh::Column;
use crate::num::{Degrees, Radians, largest_exponent, three_digits};
use glam::DVec3;

/// Steps that formats leave: what a unit component is divided into, and how to say so.
const STEPS: [(f64, &str); 4] =
    [(10.0, "one decimal"), (100.0, "two decimals"), (127.0, "8-bit integers"), (1000.0, "three decimals")];

/// Values looked at.
const SAMPLE: usize = 10_000;

/// Components that have to be fractions of a step's number before it is believed.
const FEWEST: usize = 24;

/// Tells the precision of stored normals if it is below the threshold, with the highest exponent that it serves.
pub(super) fn find(facts: &Facts<'_>, stored: &Column<DVec3>, thresholds: &Thresholds, found: &mut Tallies) {
    let stride = stored.values.len().div_ceil(SAMPLE).max(1);
    let components: Vec<f64> = (stored.values.iter().step_by(stride).flat_map(|normal| normal.to_array()))
        .filter(|x| x.is_finite() && *x != 0.0 && x.abs() != 1.0)
        .collect();
    if components.len() < FEWEST {
        return;
    }
    // A value in 32 bits is off by up to 2⁻²⁴, relative.
    let fits =
        |steps: f64| components.iter().all(|x| (x * steps - libm::round(x * steps)).abs() <= 1e-6 * steps);
    let Some(&(steps, name)) = STEPS.iter().find(|(steps, _)| fits(*steps)) else { return };
    // Half a step in each component, across the normal: at most √3/2 of a step, √2/2 of it sideways.
    let error = Degrees::from(Radians(std::f64::consts::FRAC_1_SQRT_2 / steps)).0;
    if error <= thresholds.quantisation.0 {
        return;
    }
    found.add(Kind::Quantised, Spot::mesh().by(error), facts.total_area);
    let serves = match largest_exponent(Degrees(error).into(), 0.5 / 255.0) {
        Some(exponent) => format!("good for exponents up to {exponent}"),
        None => "which a matte surface may show in half a step of 8 bits".into(),
    };
    let exponent = facts.gloss.largest_exponent(facts.mesh);
    let bits = needed_bits(exponent);
    let tally = found.tally(Kind::Quantised);
    tally.remark = Some(format!(
        "{name}, off by up to {error:.2}°, {serves}; the material's exponent of {} needs {bits} bits a component",
        three_digits(exponent)
    ));
}

/// Bits of a signed component with which a highlight of this exponent is off by half a step of 8 bits at most.
fn needed_bits(exponent: f64) -> u32 {
    let error = 0.5 / 255.0 / crate::num::steepest_slope(exponent.max(1.0));
    let steps = std::f64::consts::FRAC_1_SQRT_2 / error;
    libm::ceil(libm::log2(steps + 1.0)) as u32 + 1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn glossier_needs_more_bits() {
        // √½ / (1/510) = 360 steps of a component and its sign: 10 bits for a diffuse term.
        assert_eq!(needed_bits(1.0), 10);
        assert!(needed_bits(32.0) > 10 && needed_bits(1000.0) > needed_bits(32.0));
    }
}
