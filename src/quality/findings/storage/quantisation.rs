//! The precision of stored normals: the grid that all of them are on, and the highlights that it is good for.

use crate::num::{Degrees, largest_exponent, three_digits};
use crate::quality::effect::Highlights;
use crate::quality::findings::prelude::*;
use crate::quality::findings::storage::grid::Grid;
use glam::DVec3;

/// The largest share of corners that may deviate by more than rounding explains.
const FEW: f64 = 0.15;

/// The most values that are sampled.
const SAMPLE: usize = 10_000;

/// Half a step of 8 bits: what rounding may show.
const VISIBLE: f64 = 0.5 / 255.0;

/// Fixes rounded normals in a format that would round them in the same way.
const FINER: &str = "--normal-format i16";

/// What stored normals were rounded to.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Precision {
    /// The grid, in words.
    #[serde(serialize_with = "in_english")]
    pub grid: Text,
    /// A bound on the angle between a normal and the same rounded to the nearest; not measured.
    #[serde(rename = "degrees")]
    pub error: Degrees,
    /// The largest exponent of a highlight that shows the error by half a step of 8 bits at most; `None` if a matte surface may
    /// show it by more.
    pub exponent: Option<u64>,
}

/// Finds the precision of the stored normals, and reports it if it is below the threshold.
pub(crate) fn search(facts: &Facts<'_>, found: &mut Found) -> Option<Precision> {
    let stored = facts.written.or(facts.stored)?;
    let stride = stored.values.len().div_ceil(SAMPLE).max(1);
    let sample: Vec<DVec3> = stored.values.iter().step_by(stride).copied().collect();
    let grid = Grid::find(&sample)?;
    let precision = Precision {
        error: grid.error(),
        exponent: largest_exponent(grid.error().into(), VISIBLE),
        grid: grid.name(),
    };
    let remedy = facts.file.has_normal_formats().then(|| FINER.to_owned());
    if remedy.is_some() && grid.spoils_lengths() && found.count(Kind::LooseLength) > 0 {
        found.tally(Kind::LooseLength).remedy = remedy.clone();
    }
    let exponent = Highlights::new(facts).largest_exponent(facts.mesh);
    let serves_material = precision.exponent.is_some_and(|largest| largest as f64 >= exponent);
    if precision.error > facts.thresholds.quantisation || !serves_material {
        report(facts, &precision, exponent, found);
        found.tally(Kind::Quantised).remedy = remedy;
    }
    Some(precision)
}

fn report(facts: &Facts<'_>, precision: &Precision, exponent: f64, found: &mut Found) {
    let measured = Measured::new(facts, precision.error.0);
    let (weight, worst) = match &measured {
        Some(measured) => (measured.largest, measured.worst.clone()),
        None => (precision.error.0, vec![Spot::mesh()]),
    };
    found.add_mesh(Kind::Quantised, facts.total_area, worst);
    let visibility = match precision.exponent {
        Some(exponent) => REMARKS.with("visible-from", &[("exponent", exponent.into())]),
        None => REMARKS.get("always-visible"),
    };
    let error = REMARKS.with(
        "rounding-error",
        &[
            ("degrees", digits(precision.error.0)),
            ("visibility", visibility.into()),
            ("exponent", digits(exponent)),
            ("bits", needed_bits(exponent).into()),
        ],
    );
    let (grid, error) = (("grid", (&precision.grid).into()), ("error", error.into()));
    let text = match measured {
        Some(measured) => {
            REMARKS.with("quantised-measured", &[grid, ("measured", measured.describe().into()), error])
        }
        None => REMARKS.with("quantised", &[grid, error]),
    };
    found.tally(Kind::Quantised).remark = Some(Remark { weight, text });
}

/// The error of rounding, where the recipe of the normals is known. Angles are in degrees.
struct Measured {
    largest: f64,
    rms: f64,
    /// How many corners rounding explains, and how many were compared.
    corners: [u64; 2],
    /// The explained corners with the largest errors.
    worst: Vec<Spot>,
}

impl Measured {
    /// Over the corners that rounding explains: those no farther from their recipe than the bound. `None` if no recipe is known, or
    /// too many are farther: then the normals before rounding are unknown.
    fn new(facts: &Facts<'_>, bound: f64) -> Option<Self> {
        // Normals taken back to another space are not as they were rounded.
        if facts.written.is_some() || !facts.estimate.is_some_and(|estimate| estimate.is_rule()) {
            return None;
        }
        // By whether rounding explains them, with squares for areas.
        let mut all = scan(facts.mesh.face_count(), facts.thresholds.places.max(1), |faces, found| {
            let sound = faces.filter(|&face| facts.is_sound(face));
            let corners = sound.flat_map(|face| facts.corners_of(face).map(move |corner| (face, corner)));
            for (face, corner) in corners.filter(|&(_, corner)| facts.is_judged(corner)) {
                if let Some(off) = facts.deviation(corner) {
                    found.add(off <= bound, Spot::corner(face, corner, off), off * off);
                }
            }
        });
        let (explained, others) = (all.take(true), all.count(false));
        let (count, compared) = (explained.count as f64, explained.count + others);
        let largest = explained.worst.first().filter(|_| count >= (1.0 - FEW) * compared as f64)?.weight;
        let rms = (explained.area / count).sqrt();
        Some(Self { largest, rms, corners: [explained.count, compared], worst: explained.worst })
    }

    fn describe(&self) -> Text {
        let [explained, compared] = self.corners;
        let (largest, rms) = (("largest", digits(self.largest)), ("rms", digits(self.rms)));
        match explained == compared {
            true => REMARKS.with("measured-error", &[largest, rms]),
            false => REMARKS.with(
                "measured-error-of-some",
                &[largest, rms, ("explained", explained.into()), ("compared", compared.into())],
            ),
        }
    }
}

fn digits(x: f64) -> Value {
    Value::digits(&three_digits(x))
}

fn in_english<S: serde::Serializer>(text: &Text, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(text.english())
}

/// The bits of a signed component with which a highlight of this exponent has an error of at most half a step of 8 bits.
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
