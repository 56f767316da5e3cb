//! `fast` beside `faithful`, where it matters.

use super::angles::{AngleErrors, angle_between};
use super::cases::{Specimen, Subject, Tiling};
use super::cost::rounded;
use super::vertex::{recipe, weight_name};
use crate::mesh::Topology;
use crate::normals::{NormalField, NormalRecipe, Precision, Weight, compute_on};
use crate::num::Radians;
use crate::surface::{Cone, Tessellation};
use glam::DVec3;
use serde::Serialize;

/// Normals in single precision beside faithful ones, of a torus or a cone stored in single precision.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PrecisionRow {
    /// What is special about the mesh.
    pub case: &'static str,
    /// The weight.
    #[serde(serialize_with = "weight_name")]
    pub weight: Weight,
    /// Between `fast` and `faithful`.
    pub fast: AngleErrors,
    /// Between `faithful` and the surface: what the tessellation and the storage cost.
    pub faithful: AngleErrors,
    /// Whether `fast` saw that the mesh is out of its range, and left it to `faithful`.
    pub declined: bool,
}

/// How a mesh is made hard for single precision.
type Hardship = (&'static str, Tiling, fn(DVec3) -> DVec3);

const WEIGHTS: [Weight; 4] = [Weight::Uniform, Weight::Area, Weight::Angle, Weight::Max];

const CASES: [Hardship; 7] = [
    ("64 × 32, jittered", Tiling::Jittered, |p| p),
    ("stretched ten times", Tiling::Stretched, |p| p),
    ("slivers of 1 : 1000", Tiling::Slivers, |p| p),
    ("marching tetrahedra", Tiling::Marching, |p| p),
    ("10³ from the origin", Tiling::Jittered, |p| p + DVec3::new(1e3, 0.0, 0.0)),
    ("10⁵ from the origin", Tiling::Jittered, |p| p + DVec3::new(1e5, 0.0, 0.0)),
    ("scaled by 10⁻⁷", Tiling::Jittered, |p| p * 1e-7),
];

/// As high as faces may be long for `fast`, and sums that shrink by as much as the cone is high.
const CONE: &str = "tip of a cone of height 50";

/// A cone fifty times as high as its base is wide, in two rows of faces.
fn cone() -> Option<Specimen> {
    let subject = Subject { name: "cone", surface: Cone::new(1.0, 50.0).ok()?.into() };
    let tessellation = Tessellation { segments: [64, 2], jitter: 0.2, ..Tessellation::default() };
    Specimen::new(&subject, &tessellation).ok()
}

/// All rows: seven cases of a torus and one of a cone, with four weights each.
pub fn precision_rows() -> Vec<PrecisionRow> {
    let subjects = Subject::all(super::Effort::Quick);
    let Some(torus) = subjects.iter().find(|subject| subject.name == "torus") else { return Vec::new() };
    let rows = |(case, tiling, place): Hardship| {
        let tessellation = tiling.tessellation(&torus.surface, 2);
        let specimen = Specimen::new(torus, &tessellation);
        WEIGHTS.into_iter().filter_map(move |weight| row(case, specimen.as_ref().ok()?, place, weight))
    };
    let cone = cone();
    let of_cone = |weight| row(CONE, cone.as_ref()?, |p| p, weight);
    let of_torus = CASES.into_iter().flat_map(|case| rows(case).collect::<Vec<_>>());
    of_torus.chain(WEIGHTS.into_iter().filter_map(of_cone)).collect()
}

fn row(
    case: &'static str,
    specimen: &Specimen,
    place: fn(DVec3) -> DVec3,
    weight: Weight,
) -> Option<PrecisionRow> {
    let mesh = rounded(&specimen.mesh, place);
    let topology = Topology::by_index(mesh.faces(), mesh.vertex_count());
    let compute = |precision| compute_on(&mesh, &topology, &NormalRecipe { precision, ..recipe(weight) });
    let [faithful, fast] = [Precision::Faithful, Precision::Fast].map(compute);
    let pairs = faithful.normals.values.iter().zip(&fast.normals.values);
    let differences: Vec<Radians> = pairs.map(|(&a, &b)| angle_between(a, b)).collect();
    let truth = |field: &NormalField| {
        let known = field.normals.values.iter().zip(&field.entry_vertex);
        let error = |(&normal, &vertex): (&DVec3, &u32)| {
            Some(angle_between(normal, specimen.truth[vertex as usize]?))
        };
        known.filter_map(error).collect::<Vec<_>>()
    };
    Some(PrecisionRow {
        case,
        weight,
        fast: AngleErrors::of(&differences),
        faithful: AngleErrors::of(&truth(&faithful)),
        declined: fast.summary.fast_declined,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fast_is_close_or_declines() {
        let rows = precision_rows();
        assert_eq!(rows.len(), 32);
        for row in &rows {
            let (fast, case) = (row.fast, row.case);
            match row.declined {
                true => assert_eq!(fast.max, 0.0, "{case}: what is left to faithful is the same"),
                // Single precision's 6e-8 in each of some dozens of operations, over thinness of a tenth at the least.
                false => assert!(fast.max < 0.01, "{case} {}: {}", row.weight.name(), fast.max),
            }
            if case == CONE {
                // A face 3e-7 rad times length over height; the sum of the tip shrinks by 50.
                assert!(!row.declined && fast.max > 2e-5 && fast.max < 50.0 * 0.0172, "{row:?}");
                continue;
            }
            // Max's weights are exact on grids of the torus's own parameters: there nothing is lost but to storage.
            let is_exact =
                row.weight == Weight::Max && (case.contains("stretched") || case.contains("slivers"));
            let next_to = if is_exact { 0.01 } else { 0.1 * row.faithful.rms };
            assert!(fast.rms <= next_to, "{case} {}: {fast:?}", row.weight.name());
        }
        assert!(rows.iter().any(|row| row.declined) && rows.iter().any(|row| row.fast.max > 0.0));
        // Far away the stored positions themselves are coarse: what no arithmetic gets back.
        let at = |case: &str| {
            let found = rows.iter().find(|row| row.case.starts_with(case) && row.weight == Weight::Max);
            found.unwrap().faithful.rms
        };
        assert!(at("10⁵") > 1.2 * at("64"), "{} {}", at("10⁵"), at("64"));
    }
}
