//! Stored precision: the grid that all normals lie on, and what that serves.

use crate::mesh::Column;
use crate::num::{Degrees, angle_between, largest_exponent, three_digits};
use crate::quality::catalogue::Kind;
use crate::quality::counts::{Remark, Spot, Tallies, scan};
use crate::quality::facts::{Facts, Significance};
use crate::quality::storage::grid::Grid;
use crate::quality::thresholds::Thresholds;
use glam::DVec3;

/// The share of corners up to which those that are farther off than rounding makes them are exceptions.
const FEW: f64 = 0.15;

/// Values looked at.
const SAMPLE: usize = 10_000;

/// Half a step of 8 bits: what rounding may show.
const VISIBLE: f64 = 0.5 / 255.0;

/// What mends rounded normals in a format that would round them in the same way again.
const FINER: &str = "--normal-format i16";

/// What stored normals were rounded to.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Precision {
    /// The grid, in words.
    pub grid: String,
    /// An angle that no normal is farther from what was stored of it, if it was rounded to the nearest: a bound, not measured.
    #[serde(rename = "degrees")]
    pub error: Degrees,
    /// The largest exponent of a highlight that it shows in by half a step of 8 bits at most; `None` if it may show by more
    /// on a matte surface.
    pub exponent: Option<u64>,
}

/// The precision of stored normals, as far as they tell. Reported as a finding if it is below the threshold, with the highest
/// exponent that it serves.
pub(in crate::quality) fn find(
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
    let exponent = facts.gloss.largest_exponent(facts.mesh);
    let serves_material = precision.exponent.is_some_and(|largest| largest as f64 >= exponent);
    if precision.error <= thresholds.quantisation && serves_material {
        return Some(precision);
    }
    let measured = Measured::new(facts, precision.error, thresholds.places);
    match &measured {
        Some(measured) => {
            found.add_mesh(Kind::Quantised, facts.total_area, measured.worst.clone());
        }
        None => found.add(Kind::Quantised, Spot::mesh(), facts.total_area),
    }
    if facts.has_normal_formats {
        found.tally(Kind::Quantised).remedy = Some(FINER.into());
    }
    let serves = match precision.exponent {
        Some(exponent) => format!("good for exponents up to {exponent}"),
        None => "which even a matte surface may show by more than half a step of 8 bits".into(),
    };
    let bits = needed_bits(exponent);
    let weight = measured.as_ref().map_or(precision.error, |measured| measured.largest).0;
    let off = match measured {
        Some(Measured { largest, rms, corners, .. }) => {
            let where_so = match corners {
                [explained, compared] if explained == compared => String::new(),
                [explained, compared] => {
                    format!(" at the {explained} of {compared} corners that rounding explains")
                }
            };
            let [largest, rms] = [largest, rms].map(|it| three_digits(it.0));
            format!(
                "off what their rule gives by up to {largest}°, {rms}° in the root mean square{where_so}; "
            )
        }
        None => String::new(),
    };
    let text = format!(
        "{}, {off}rounding to the nearest makes at most {}°, {serves}; the material's exponent of {} needs {bits} bits a component",
        precision.grid,
        three_digits(precision.error.0),
        three_digits(exponent)
    );
    found.tally(Kind::Quantised).remark = Some(Remark { weight, text });
    Some(precision)
}

/// What rounding did, where a rule tells what was rounded.
struct Measured {
    largest: Degrees,
    rms: Degrees,
    /// How many corners rounding explains, and how many were compared: the others are off by more.
    corners: [u64; 2],
    /// The corners that are farthest off.
    worst: Vec<Spot>,
}

impl Measured {
    /// Over the corners that rounding explains: those no farther from their rule than its bound. `None` if no rule is known, or
    /// more are farther than strays may be: then what the normals were before they were rounded is not known.
    fn new(facts: &Facts<'_>, bound: Degrees, places: usize) -> Option<Self> {
        // What was taken back to another space is not as it was rounded.
        if facts.written.is_some() || !facts.estimate.is_some_and(|estimate| estimate.is_rule()) {
            return None;
        }
        // A finding of each: corners that are compared, and those within the bound with their squares for areas.
        let (compared, explained) = (Kind::Custom, Kind::Quantised);
        let all = scan(facts.mesh.face_count(), places.max(1), |faces, found| {
            for face in faces.filter(|&face| facts.worth[face] == Significance::Sound) {
                for corner in facts.mesh.faces().range(face).filter(|&corner| facts.is_judged(corner)) {
                    let Some(unit) = facts.stored_unit(corner) else { continue };
                    let off = Degrees::from(angle_between(unit, facts.expected(corner))).0;
                    found.tally(compared).count += 1;
                    if off <= bound.0 {
                        found.add(explained, Spot::corner(face, corner, off), off * off);
                    }
                }
            }
        });
        let (compared, explained) = (all.get(compared).count, all.get(explained));
        let count = explained.count as f64;
        let worst = explained.worst.first().filter(|_| count >= (1.0 - FEW) * compared as f64)?;
        Some(Self {
            largest: Degrees(worst.weight),
            rms: Degrees((explained.area / count).sqrt()),
            corners: [explained.count, compared],
            worst: explained.worst.clone(),
        })
    }
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
