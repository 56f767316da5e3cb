//! Face normals of single triangles, by three methods, against exact arithmetic.

use super::prelude::*;
use crate::trade::exact;

pub(super) type Triangle = [Vec3; 3];

const FAITHFUL: Bound = Bound::new(1.0, Unit::Ulps, "face-bound");
/// The bound of `fast`, at its thinnest face.
pub(super) const FAST: Bound = Bound::new(0.0172, Unit::Degrees, "face-fast");

pub(super) fn case(
    group: Group,
    texts: &'static str,
    name: impl Into<String>,
    triangles: impl Fn() -> Vec<Triangle> + Send + Sync + 'static,
) -> StressCase {
    StressCase::new(group, texts, name, (FAITHFUL, Some(FAST)), move || measure(&triangles()))
}

fn measure(triangles: &[Triangle]) -> Measured {
    let mut measured = Measured { samples: triangles.len(), ..Measured::default() };
    let (mut fast_worst, mut plain_worst) = (Worst::default(), Worst::default());
    for (triangle, (normal, is_degenerate)) in triangles.iter().zip(faithful(triangles)) {
        let fast = fast(triangle);
        measured.declined += usize::from(fast.declined);
        let truth = exact::face_normal(&triangle.map(|corner| corner.as_dvec3()));
        let (Some(truth), false) = (&truth, is_degenerate) else {
            measured.faithful.add(if truth.is_none() && is_degenerate { 0.0 } else { f64::INFINITY });
            continue;
        };
        measured.faithful.add(exact::error_in_ulps(normal, truth));
        fast_worst.add(Outcome::degrees(fast.normal, truth));
        plain_worst.add(Outcome::degrees(plain(triangle), truth));
    }
    Measured { fast: Some(fast_worst), plain: Some(plain_worst), ..measured }
}

/// The plain face normal.
pub(super) fn plain(triangle: &Triangle) -> DVec3 {
    plain::face_normal(*triangle).as_dvec3()
}

/// The result of [`Precision::Fast`] for a triangle.
pub(super) struct FastNormal {
    pub(super) normal: DVec3,
    pub(super) fault: Option<FaultReason>,
    pub(super) declined: bool,
}

pub(super) fn fast(triangle: &Triangle) -> FastNormal {
    let recipe = NormalRecipe { precision: Precision::Fast, ..NormalRecipe::default() };
    let field = compute(&indexed(triangle, &[[0, 1, 2]]), &recipe);
    FastNormal {
        normal: field.face_normals[0],
        fault: field.faults.faces.first().map(|fault| fault.reason),
        declined: field.summary.fast_declined,
    }
}

/// Face normals through the slice interface, and whether each triangle was reported to have zero area.
pub(super) fn faithful(triangles: &[Triangle]) -> Vec<([f32; 3], bool)> {
    let positions: Vec<[f32; 3]> = triangles.as_flattened().iter().map(Vec3::to_array).collect();
    let indices: Vec<[u32; 3]> = (0..triangles.len() as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let mut normals = vec![[0.0; 3]; triangles.len()];
    let faults = face_normals(&positions, &indices, &mut Scratch::new(), &mut normals);
    let mut degenerate = vec![false; triangles.len()];
    for fault in faults.expect("slices of matching lengths").faces {
        degenerate[fault.index as usize] = fault.reason == FaultReason::ZeroArea;
    }
    normals.into_iter().zip(degenerate).collect()
}

/// Triangles of `f32` positions as a mesh.
pub(super) fn indexed(positions: &[Vec3], triangles: &[[u32; 3]]) -> Mesh {
    let positions: Vec<[f32; 3]> = positions.iter().map(Vec3::to_array).collect();
    let faces = Faces::triangles(triangles.as_flattened().to_vec());
    Mesh::new(positions, faces).expect("positions that are finite")
}
