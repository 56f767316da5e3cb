//! Corner normals of triangles in the caller's own slices, split at creases.

use crate::mesh::{FacesRef, MAX_CORNERS, Topology};
use crate::normals::creases::dihedral_test::CreaseTest;
use crate::normals::creases::triangle_groups::TriangleCreases;
use crate::normals::faces::shape::FaceState;
use crate::normals::fallback::fallback_normals::{FallbackNormals, corner_faults, face_faults};
use crate::normals::fault::Faults;
use crate::normals::recipe::{Averaging, Precision};
use crate::normals::scratch::Scratch;
use crate::normals::slices::vertex_normals::{Coordinate, SliceError, check};
use crate::normals::sums::request::{SlotState, SumRequest};
use crate::normals::sums::single_precision::single_sums_into;
use crate::normals::sums::weighted_sums::weighted_sums_into;
use crate::num::Degrees;
use crate::num::parallel;

/// Computes indexed corner normals: one normal per vertex and smooth group, and one index a corner.
///
/// Edges of one triangle, of more than two, between triangles that are wound against each other, and those with
/// a dihedral angle over `crease` (+0.01°) are hard; they cut the fan of triangles around a vertex into groups. 0°
/// gives each corner its own triangle's normal, 180° splits at no angle. Edges are found by vertex index: vertices
/// that have the same position stay separate.
///
/// `normals` is cleared and filled, ordered by vertex; `index[c]` is the normal of corner `c`, three corners a
/// triangle. Weights, slivers, precision, faults and threads are as in [`vertex_normals`](crate::normals::vertex_normals);
/// `Faults::corners` lists the corners that have a fallback normal. Edges are matched in the call, vertex by
/// vertex: time is linear in triangles, memory some 70 bytes a triangle, which `scratch` keeps for the next call.
///
/// ```
/// use crease::normals::{Averaging, Scratch, corner_normals};
/// use crease::num::Degrees;
///
/// // A ridge of 90°: each slope keeps its own normal.
/// let positions = [[0.0_f32, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]];
/// let triangles = [[0, 2, 1], [0, 1, 3]];
/// let (mut normals, mut index) = (Vec::new(), [0; 6]);
/// corner_normals(
///     &positions,
///     &triangles,
///     Averaging::default(),
///     Degrees(40.0),
///     &mut Scratch::new(),
///     &mut normals,
///     &mut index,
/// )?;
/// assert_eq!(normals.len(), 6);
/// assert_eq!(normals[index[0] as usize], [0.0, 0.0, 1.0]);
/// # Ok::<(), crease::normals::SliceError>(())
/// ```
///
/// # Errors
/// If slices do not go together; see [`SliceError`]. Nothing is written then.
pub fn corner_normals<T: Coordinate>(
    positions: &[[T; 3]],
    triangles: &[[u32; 3]],
    averaging: Averaging,
    crease: Degrees,
    scratch: &mut Scratch,
    normals: &mut Vec<[T; 3]>,
    index: &mut [u32],
) -> Result<Faults, SliceError> {
    let Averaging { weight, slivers, precision } = averaging;
    if weight.is_fit() {
        return Err(SliceError::FitNeedsMesh(weight.name()));
    }
    let corners = 3 * triangles.len();
    if corners > MAX_CORNERS {
        return Err(SliceError::TooLarge { what: "corners", count: corners });
    }
    check(positions.len(), triangles, corners, index.len())?;
    let (faces, points) = (FacesRef::triangles(triangles), T::positions(positions));
    let Scratch { sums, slots: states, faces: face_normals, groups, .. } = scratch;
    face_normals.fill(faces, points);
    let crease = CreaseTest::new(Some(crease));
    let creases = TriangleCreases { faces, normals: face_normals, crease, slivers, counts: None };
    let (slots, _) = creases.entries(positions.len(), groups, index);
    let request = SumRequest { faces, positions: points, target: index, slots, weight, slivers };
    states.resize(slots, SlotState::Empty);
    normals.resize(slots, [T::ZERO; 3]);
    if precision == Precision::Fast
        && parallel::all(&face_normals.state, |&state| state == FaceState::Counted)
        && single_sums_into(&request, sums, normals, states)
    {
        return Ok(Faults::default());
    }
    let outcome = weighted_sums_into(&request, sums, normals, states);

    let set = |slot: usize, normal| normals[slot] = T::emit(normal);
    let fallbacks = if outcome.all_good {
        Vec::new()
    } else {
        let topology = Topology::of_view(faces, positions.len());
        FallbackNormals::new(faces, &topology, face_normals).for_slots(index, states, set)
    };
    let corners = corner_faults(index, &fallbacks);
    Ok(Faults { faces: face_faults(face_normals, slivers), corners, vertices: Vec::new() })
}
