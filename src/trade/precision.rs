//! `fast` compared with `faithful` on meshes that are hard for single precision.

use super::angles::{AngleErrors, angle_between};
use super::cases::{NamedSurface, SampleMesh, Tiling};
use super::cost::rounded;
use super::vertex::recipe;
use crate::mesh::Topology;
use crate::normals::{NormalRecipe, Precision, Weight, compute_on};
use crate::num::Radians;
use crate::surface::{Cone, Tessellation};
use glam::DVec3;
use serde::Serialize;

/// Normals in single precision compared with faithful ones, of a torus or a cone stored in single precision.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PrecisionRow {
    /// The mesh.
    pub case: &'static str,
    /// The weight.
    pub weight: Weight,
    /// Between `fast` and `faithful`.
    pub fast: AngleErrors,
    /// Between `faithful` and the surface: the error of the tessellation and the storage.
    pub faithful: AngleErrors,
    /// Whether the mesh is out of the range of `fast`, which left it to `faithful`.
    pub declined: bool,
}

/// A mesh that is hard for single precision: its description, tiling, and where its positions are moved.
type HardCase = (&'static str, Tiling, fn(DVec3) -> DVec3);

const WEIGHTS: [Weight; 4] = [Weight::Uniform, Weight::Area, Weight::Angle, Weight::Max];

const CASES: [HardCase; 7] = [
    ("64 × 32, jittered", Tiling::Jittered, |p| p),
    ("stretched ten times", Tiling::Stretched, |p| p),
    ("slivers of 1 : 1000", Tiling::Slivers, |p| p),
    ("marching tetrahedra", Tiling::Marching, |p| p),
    ("10³ from the origin", Tiling::Jittered, |p| p + DVec3::new(1e3, 0.0, 0.0)),
    ("10⁵ from the origin", Tiling::Jittered, |p| p + DVec3::new(1e5, 0.0, 0.0)),
    ("scaled by 10⁻⁷", Tiling::Jittered, |p| p * 1e-7),
];

/// Faces of the largest aspect ratio for `fast`, and sums that shrink by the height of the cone.
const CONE: &str = "tip of a cone of height 50";

/// All rows: seven cases of a torus and one of a cone, with four weights each.
pub fn precision_rows() -> Vec<PrecisionRow> {
    let torus = NamedSurface::torus();
    let of_torus = CASES.into_iter().map(|(case, tiling, moved)| {
        let tessellation = tiling.tessellation(&torus.surface, 2);
        (case, SampleMesh::new(&torus, &tessellation).ok(), moved)
    });
    let of_cone: (_, _, fn(DVec3) -> DVec3) = (CONE, cone(), |p| p);
    let rows = |(case, sample, moved): (&'static str, Option<SampleMesh>, fn(DVec3) -> DVec3)| {
        let row = |weight| Some(row(case, sample.as_ref()?, moved, weight));
        WEIGHTS.into_iter().filter_map(row).collect::<Vec<_>>()
    };
    of_torus.chain([of_cone]).flat_map(rows).collect()
}

/// A cone fifty times as high as its base is wide, in two rows of faces.
fn cone() -> Option<SampleMesh> {
    let surface = NamedSurface { name: "cone", surface: Cone::new(1.0, 50.0).ok()?.into() };
    let tessellation = Tessellation { segments: [64, 2], jitter: 0.2, ..Tessellation::default() };
    SampleMesh::new(&surface, &tessellation).ok()
}

fn row(case: &'static str, sample: &SampleMesh, moved: fn(DVec3) -> DVec3, weight: Weight) -> PrecisionRow {
    let mesh = rounded(&sample.mesh, moved);
    let topology = Topology::by_index(mesh.faces(), mesh.vertex_count());
    let compute = |precision| compute_on(&mesh, &topology, &NormalRecipe { precision, ..recipe(weight) });
    let [faithful, fast] = [Precision::Faithful, Precision::Fast].map(compute);
    let pairs = faithful.normals.values.iter().zip(&fast.normals.values);
    let differences: Vec<Radians> = pairs.map(|(&a, &b)| angle_between(a, b)).collect();
    PrecisionRow {
        case,
        weight,
        fast: AngleErrors::of(&differences),
        faithful: AngleErrors::of(&sample.errors(&faithful)),
        declined: fast.summary.fast_declined,
    }
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
