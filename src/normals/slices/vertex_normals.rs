//! Normals of triangles in the caller's own slices: the same kernels, without building a mesh.

use crate::mesh::{FacesRef, NONE};
use crate::normals::faces::component::Component;
use crate::normals::faces::face_normals::face_normals_into;
use crate::normals::faces::shape::FaceState;
use crate::normals::fallback::neighbours::{neighbour_normals, vertex_fallbacks};
use crate::normals::fault::{Fault, FaultReason, Faults};
use crate::normals::recipe::{Averaging, Precision, Slivers};
use crate::normals::scratch::Scratch;
use crate::normals::sums::partition::Bounds;
use crate::normals::sums::request::{SlotState, SumRequest};
use crate::normals::sums::single_precision::single_sums_into;
use crate::normals::sums::weighted_sums::weighted_sums_into;
use crate::num;

/// The type of coordinates: `f32` or `f64`.
#[expect(private_bounds, reason = "sealed: the kernels know these two types")]
pub trait Coordinate: Component {}

impl Coordinate for f32 {}
impl Coordinate for f64 {}

/// The reason why slices do not fit each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SliceError {
    /// A triangle names a vertex that is not there.
    #[error("triangle {triangle} refers to vertex {vertex}, but there are only {count}")]
    VertexOutOfRange {
        /// The triangle, counted from 0.
        triangle: usize,
        /// The vertex that it asks for, counted from 0.
        vertex: u32,
        /// How many positions there are.
        count: usize,
    },
    /// The slice for normals does not have one entry for each element.
    #[error("there is room for {found} normals; {expected} were expected")]
    OutputLength {
        /// Entries of the slice.
        found: usize,
        /// Entries needed.
        expected: usize,
    },
    /// More vertices than 32-bit indices can count, or more corners: 2^32 without edges, 2^30 with them.
    #[error("{count} {what} are more than can be numbered; divide the mesh")]
    TooLarge {
        /// What there is too much of.
        what: &'static str,
        /// How much.
        count: usize,
    },
    /// The weights `quadric`, `jet` and `best` fit surfaces past the faces of a vertex, which takes a mesh with its topology.
    #[error("the {0} weight needs a mesh with topology; compute it from a NormalRecipe")]
    FitNeedsMesh(&'static str),
}

/// Computes the unit normal of every triangle, (P1−P0)×(P2−P0) made unit.
///
/// With `f32` each component is within 1 ulp of the true one, at any magnitude, offset or thinness; with `f64` the normal
/// is within 1e-12 rad. A triangle without direction has the unit sum of those that share an edge (two vertices) with it,
/// else +Z. Every normal is finite and unit.
///
/// Uses the threads of rayon's current pool; the result does not depend on their number. Time is linear in triangles.
///
/// `Faults::faces` of the result lists the triangles that have a fallback normal, and with
/// [`BelowStorage`](FaultReason::BelowStorage) those whose own normal is noise of the rounding of their coordinates.
///
/// ```
/// use crease::normals::{Scratch, face_normals};
///
/// let positions = [[0.0_f32, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0]];
/// let mut normals = [[0.0; 3]];
/// let faults = face_normals(&positions, &[[0, 1, 2]], &mut Scratch::new(), &mut normals)?;
/// assert_eq!(normals, [[0.0, 0.0, 1.0]]);
/// assert!(faults.is_empty());
/// # Ok::<(), crease::normals::SliceError>(())
/// ```
///
/// # Errors
/// If slices do not go together; see [`SliceError`]. Nothing is written then.
pub fn face_normals<T: Coordinate>(
    positions: &[[T; 3]],
    triangles: &[[u32; 3]],
    scratch: &mut Scratch,
    normals: &mut [[T; 3]],
) -> Result<Faults, SliceError> {
    check(positions.len(), triangles, triangles.len(), normals.len())?;
    let faces = FacesRef::triangles(triangles);
    let states = &mut scratch.faces.state;
    states.resize(triangles.len(), FaceState::Counted);
    face_normals_into(faces, T::positions(positions), normals, states);

    let unusual = |(face, &state): (usize, &FaceState)| fault(face as u32, state);
    let faults =
        Faults { faces: states.iter().enumerate().filter_map(unusual).collect(), ..Faults::default() };
    let without: Vec<u32> = faults
        .faces
        .iter()
        .map(|fault| fault.index)
        .filter(|&face| !states[face as usize].has_direction())
        .collect();
    if !without.is_empty() {
        let defined = |face: usize| states[face].has_direction().then(|| T::widen(normals[face]));
        let fallbacks = neighbour_normals(faces, &without, defined);
        for (&face, normal) in without.iter().zip(fallbacks) {
            normals[face as usize] = T::emit(normal);
        }
    }
    Ok(faults)
}

/// Computes a unit normal for every vertex: the mean of the normals of its triangles by a weight. No edge is hard, and
/// vertices that have the same position stay separate.
///
/// With `f32` positions everything is computed in double precision and rounded once; with [`Precision::Fast`] in `f32`, with
/// the range and the error that it names, and everything else falls back to double precision. Triangles of zero area add
/// nothing; nor do slivers with [`Slivers::Exclude`], unless a vertex has no other triangle. A vertex with one triangle has
/// its normal to the bit. Where a sum cancels (see [`FaultReason::CancellingFan`]) or nothing adds to it, the normal is the
/// unit sum of the defined normals at the vertex, else the first of them by lexicographic value, else +Z. Sums that nearly
/// cancel are kept, right to 10⁻³ rad or better, and are not listed. Every normal is finite and unit.
///
/// Each sum runs in ascending triangle index on the threads of rayon's current pool: their number does not change a bit.
/// Multiplying positions by a power of two does not either, as long as they stay normal numbers. Time is linear in
/// triangles.
///
/// `Faults::vertices` of the result lists the vertices that have a fallback normal, `Faults::faces` the triangles that
/// added nothing.
///
/// ```
/// use crease::normals::{Averaging, FaultReason, Scratch, vertex_normals};
///
/// // A roof of two slopes, and a vertex that nothing uses.
/// let positions = [[0.0_f32, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, -1.0], [-1.0, 0.0, -1.0], [9.0, 9.0, 9.0]];
/// let triangles = [[0, 2, 1], [0, 1, 3]];
/// let mut normals = [[0.0; 3]; 5];
/// let mut scratch = Scratch::new();
/// let faults = vertex_normals(&positions, &triangles, Averaging::default(), &mut scratch, &mut normals)?;
/// assert_eq!(normals[0], [0.0, 0.0, 1.0]);
/// assert_eq!(faults.vertices.len(), 1);
/// assert_eq!(faults.vertices[0].reason, FaultReason::Unreferenced);
/// # Ok::<(), crease::normals::SliceError>(())
/// ```
///
/// # Errors
/// If slices do not go together; see [`SliceError`]. Nothing is written then.
pub fn vertex_normals<T: Coordinate>(
    positions: &[[T; 3]],
    triangles: &[[u32; 3]],
    averaging: Averaging,
    scratch: &mut Scratch,
    normals: &mut [[T; 3]],
) -> Result<Faults, SliceError> {
    let Averaging { weight, slivers, precision } = averaging;
    if weight.is_fit() {
        return Err(SliceError::FitNeedsMesh(weight.name()));
    }
    check_lengths(positions.len(), triangles, positions.len(), normals.len())?;
    let (faces, points) = (FacesRef::triangles(triangles), T::positions(positions));
    let request = SumRequest {
        faces,
        positions: points,
        target: faces.corners(),
        slots: positions.len(),
        weight,
        slivers,
    };
    let states = &mut scratch.slots;
    states.resize(positions.len(), SlotState::Empty);
    if precision == Precision::Fast && single_sums_into(&request, &mut scratch.sums, normals, states) {
        return Ok(Faults { vertices: unreferenced(states), ..Faults::default() });
    }
    let outcome = weighted_sums_into(&request, &mut scratch.sums, normals, states);
    if outcome.vertex_missing {
        return Err(no_such_vertex(positions.len(), triangles));
    }

    let added = |state: FaceState| state == FaceState::Sliver && slivers == Slivers::Keep;
    let unusual = outcome.unusual.into_iter().filter(|&(_, state)| !added(state));
    let mut faults = Faults {
        faces: unusual.filter_map(|(face, state)| fault(face, state)).collect(),
        ..Faults::default()
    };
    if outcome.all_good {
        return Ok(faults);
    }
    let undefined = |(vertex, &state): (usize, &SlotState)| (!state.has_normal()).then_some(vertex as u32);
    let undefined: Vec<u32> = states.iter().enumerate().filter_map(undefined).collect();
    for fallback in vertex_fallbacks(faces, points, &undefined) {
        normals[fallback.vertex as usize] = T::emit(fallback.normal);
        let reason = match states[fallback.vertex as usize] {
            SlotState::Cancelling => FaultReason::CancellingFan,
            _ if !fallback.referenced => FaultReason::Unreferenced,
            _ => fault_reason(fallback.cause).unwrap_or(FaultReason::CancellingFan),
        };
        faults.vertices.push(Fault { index: fallback.vertex, reason });
    }
    Ok(faults)
}

/// The vertices that no triangle uses.
fn unreferenced(states: &[SlotState]) -> Vec<Fault> {
    let empty = (0..).zip(states).filter(|&(_, &state)| state == SlotState::Empty);
    empty.map(|(index, _)| Fault { index, reason: FaultReason::Unreferenced }).collect()
}

/// What a face's state is called in reports.
pub(crate) fn fault_reason(state: FaceState) -> Option<FaultReason> {
    match state {
        FaceState::Counted => None,
        FaceState::Sliver => Some(FaultReason::BelowStorage),
        FaceState::ZeroArea => Some(FaultReason::ZeroArea),
        FaceState::OutOfRange => Some(FaultReason::OutOfRange),
        FaceState::NonFinite => Some(FaultReason::NonFinite),
    }
}

fn fault(index: u32, state: FaceState) -> Option<Fault> {
    fault_reason(state).map(|reason| Fault { index, reason })
}

/// That every vertex exists and the output has the right length.
pub(in crate::normals) fn check(
    vertices: usize,
    triangles: &[[u32; 3]],
    expected: usize,
    found: usize,
) -> Result<(), SliceError> {
    check_lengths(vertices, triangles, expected, found)?;
    let (_, highest) = num::dispatch(Bounds(triangles.as_flattened()));
    let is_missing = highest as usize >= vertices && !triangles.is_empty();
    if is_missing { Err(no_such_vertex(vertices, triangles)) } else { Ok(()) }
}

/// That the output has the right length.
fn check_lengths(
    vertices: usize,
    triangles: &[[u32; 3]],
    expected: usize,
    found: usize,
) -> Result<(), SliceError> {
    for (what, count) in [("vertices", vertices), ("corners", 3 * triangles.len())] {
        if count >= NONE as usize {
            return Err(SliceError::TooLarge { what, count });
        }
    }
    if found != expected {
        return Err(SliceError::OutputLength { found, expected });
    }
    Ok(())
}

/// The first vertex that does not exist.
fn no_such_vertex(count: usize, triangles: &[[u32; 3]]) -> SliceError {
    let mut all = triangles.iter().enumerate().flat_map(|(triangle, corners)| corners.map(|v| (triangle, v)));
    let (triangle, vertex) = all.find(|&(_, vertex)| vertex as usize >= count).unwrap_or_default();
    SliceError::VertexOutOfRange { triangle, vertex, count }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::normals::recipe::Weight;
    use glam::DVec3;

    /// Found by fuzzing: faces of coordinates from 1e-320 to 1 had infinite weights or vectors of zeros, and made normals that are
    /// not numbers.
    #[test]
    fn extreme_ranges_give_unit_normals() {
        let small = 5.634155089066723e-241;
        let infinite_weights = [
            [0.0, 5.6341436472880435e-241, 1.7776e-320],
            [-1.7754849808387917e-64, -1.775484980854224e-64, -1.775484980854224e-64],
            [4.884306681505455e-241, small, small],
            [small, 3.523722732774444e-294, 1.0000000000000142],
        ];
        let vectors_of_zeros = [
            [0.0, 1.946939626193801e-308, -1.0584651559856481e-275],
            [5.6341550890725615e-241, -3.4502345330247923e-190, -3.450234537908882e-190],
            [8.867378411577562e-246, 5.634155089983309e-241, 5.634155089066734e-241],
            [1.954574683551424e-308, 0.0, 1.0],
        ];
        let triangles = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
        for positions in [infinite_weights, vectors_of_zeros] {
            for weight in Weight::SUMS {
                for slivers in [Slivers::Exclude, Slivers::Keep] {
                    let averaging = Averaging { weight, slivers, ..Averaging::default() };
                    let mut normals = [[0.0; 3]; 4];
                    vertex_normals(&positions, &triangles, averaging, &mut Scratch::new(), &mut normals)
                        .unwrap();
                    let is_unit = |n: &[f64; 3]| (DVec3::from_array(*n).length() - 1.0).abs() < 1e-12;
                    assert!(normals.iter().all(is_unit), "{averaging:?}: {normals:?}");
                }
            }
        }
    }
}
