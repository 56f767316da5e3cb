//! Stored precision: the grid that all normals lie on, and what that serves.

use super::Thresholds;
use super::catalogue::Kind;
use super::facts::Facts;
use super::grid::Grid;
use super::tally::{Spot, Tallies};
use crate::mesh::Column;
use crate::num::{Degrees, largest_exponent, three_digits};
use glam::DVec3;

/// Values looked at.
const SAMPLE: usize = 10_000;

/// Half a step of 8 bits: what rounding may show.
const VISIBLE: f64 = 0.5 / 255.0;

/// What mends rounded normals in a format that would round them in the same way again.
const FINER: &str = "--normal-format i16";

/// What stored normals were rounded to.
#[derive(Clone, Debug, PartialEq)]
pub struct Precision {
    /// The grid, in words.
    pub grid: String,
    /// An angle that no normal is farther from what was stored of it.
    pub error: Degrees,
    /// The largest exponent of a highlight that it shows in by half a step of 8 bits at most; `None` if it may show by more
    /// on a matte surface.
    pub exponent: Option<u64>,
}

/// The precision of stored normals, as far as they tell. Told as a finding if it is below the threshold, with the highest
/// exponent that it serves.
pub(super) fn find(
    facts: &Facts<'_>,
    stored: &Column<DVec3>,
    thresholds: &Thresholds,
    found: &mut Tallies,
) -> Option<Precision> {
    let stride = stored.values.len().div_ceil(SAMPLE).max(1);
    let sample: Vec<DVec3> = stored.values.iter().step_by(stride).copied().collect();
    let grid = Grid::find(&sample)?;
    let precision = Precision {
        grid: grid.name(),
        error: grid.error(),
        exponent: largest_exponent(grid.error().into(), VISIBLE),
    };
    if facts.has_normal_formats && grid.spoils_lengths() && found.get(Kind::LooseLength).count > 0 {
        found.tally(Kind::LooseLength).remedy = Some(FINER.into());
    }
    if precision.error <= thresholds.quantisation {
        return Some(precision);
    }
    found.add(Kind::Quantised, Spot::mesh().by(precision.error.0), facts.total_area);
    if facts.has_normal_formats {
        found.tally(Kind::Quantised).remedy = Some(FINER.into());
    }
    let serves = match precision.exponent {
        Some(exponent) => format!("good for exponents up to {exponent}"),
        None => "which a matte surface may show in half a step of 8 bits".into(),
    };
    let exponent = facts.gloss.largest_exponent(facts.mesh);
    let bits = needed_bits(exponent);
    found.tally(Kind::Quantised).remark = Some(format!(
        "{}, off by up to {}°, {serves}; the material's exponent of {} needs {bits} bits a component",
        precision.grid,
        three_digits(precision.error.0),
        three_digits(exponent)
    ));
    Some(precision)
}

/// Bits of a signed component with which a highlight of this exponent is off by half a step of 8 bits at most.
fn needed_bits(exponent: f64) -> u32 {
    let error = VISIBLE / crate::num::steepest_slope(exponent.max(1.0));
    // Half a step in each component, at right angles to the normal at worst.
    let steps = 0.5 * 3.0_f64.sqrt() / error;
    libm::ceil(libm::log2(steps + 1.0)) as u32 + 1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn glossier_needs_more_bits() {
        // ½ √3 / (1/510) = 442 steps of a component and its sign: 10 bits for a diffuse term.
        assert_eq!(needed_bits(1.0), 10);
        assert!(needed_bits(32.0) > 10 && needed_bits(1000.0) > needed_bits(32.0));
    }
}
