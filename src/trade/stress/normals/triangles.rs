//! Face normals of many triangles, three ways, against exact arithmetic.

use crate::mesh::{Faces, Mesh, MeshBuilder, Storage};
use crate::normals::{FaultReason, NormalRecipe, Precision, Scratch, compute, face_normals};
use crate::trade::exact;
use crate::trade::stress::case::{Bound, Measured, Unit, Worst};
use crate::trade::stress::normals::naive;
use glam::{DVec3, Vec3};

/// Three corners of `f32` coordinates.
pub(in crate::trade::stress) type Triangle = [Vec3; 3];

/// What `faithful` promises.
pub(in crate::trade::stress) const ONE_ULP: Bound = Bound::new(
    1.0,
    Unit::Ulps,
    "face_normals: each f32 component within 1 ulp, or the face is reported as exactly degenerate",
);
/// What `fast` promises, at its thinnest face.
pub(in crate::trade::stress) const FAST: Bound = Bound::new(
    0.0172,
    Unit::Degrees,
    "3e-7 rad times length over height, which is 1000 at most where fast does not decline",
);
/// What it says in words.
pub(in crate::trade::stress) const EXPECTATION: &str = "within 1 ulp, or reported as degenerate";
/// The plain formula.
pub(in crate::trade::stress) const FORMULA: &str = "n = (b-a)×(c-a); n / sqrt(n·n)";

/// The normal of each triangle, each on its own.
pub(in crate::trade::stress) fn measure(triangles: &[Triangle]) -> Measured {
    let mut measured = Measured { samples: triangles.len(), ..Measured::default() };
    let (mut quickly, mut plain) = (Worst::default(), Worst::default());
    for (triangle, (normal, is_degenerate)) in triangles.iter().zip(faithful(triangles)) {
        let quick = fast(triangle);
        measured.declined += usize::from(quick.declined);
        let truth = exact::face_normal(&triangle.map(|corner| corner.as_dvec3()));
        let (Some(truth), false) = (&truth, is_degenerate) else {
            measured.faithful.add(if truth.is_none() && is_degenerate { 0.0 } else { f64::INFINITY });
            continue;
        };
        measured.faithful.add(exact::error_in_ulps(normal, truth));
        quickly.add(exact::angle_to(quick.normal, truth).to_degrees());
        let normal = naive::direction(naive::face_normal(*triangle));
        plain.add(exact::angle_to(normal, truth).to_degrees());
    }
    Measured { fast: Some(quickly), plain: Some(plain), ..measured }
}

/// What `fast` makes of a triangle.
pub(in crate::trade::stress) struct Quick {
    pub(in crate::trade::stress) normal: DVec3,
    /// What is said to be wrong with it.
    pub(in crate::trade::stress) fault: Option<FaultReason>,
    /// Whether it was left to `faithful`.
    pub(in crate::trade::stress) declined: bool,
}

/// One triangle by [`Precision::Fast`].
pub(in crate::trade::stress) fn fast(triangle: &Triangle) -> Quick {
    let recipe = NormalRecipe { precision: Precision::Fast, ..NormalRecipe::default() };
    let field = compute(&indexed(triangle, &[[0, 1, 2]]), &recipe);
    Quick {
        normal: field.face_normals[0],
        fault: field.faults.faces.first().map(|fault| fault.reason),
        declined: field.summary.fast_declined,
    }
}

/// Face normals by the interface for slices, and whether each triangle was reported as of zero area.
pub(in crate::trade::stress) fn faithful(triangles: &[Triangle]) -> Vec<([f32; 3], bool)> {
    let positions: Vec<[f32; 3]> = triangles.as_flattened().iter().map(Vec3::to_array).collect();
    let indices: Vec<[u32; 3]> = (0..triangles.len() as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let mut normals = vec![[0.0; 3]; triangles.len()];
    let faults = face_normals(&positions, &indices, &mut Scratch::new(), &mut normals);
    let mut degenerate = vec![false; triangles.len()];
    for fault in faults.expect("slices that go together").faces {
        degenerate[fault.index as usize] = fault.reason == FaultReason::ZeroArea;
    }
    normals.into_iter().zip(degenerate).collect()
}

/// Triangles of `f32` positions as a mesh.
pub(in crate::trade::stress) fn indexed(positions: &[Vec3], triangles: &[[u32; 3]]) -> Mesh {
    let builder = MeshBuilder {
        positions: positions.iter().map(|p| p.as_dvec3()).collect(),
        storage: Storage::F32,
        faces: Faces::triangles(triangles.as_flattened().to_vec()),
        ..MeshBuilder::default()
    };
    builder.build().expect("positions that are finite")
}
