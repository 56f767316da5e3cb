//! Weighted sums in single precision: the fast end of the trade.
//!
//! Positions, terms and sums are `f32`, eight triangles at a time. Within the range that is checked in the same pass a face
//! normal is off by at most 3e-7 rad times length over height, so 3e-4 rad (0.017°) for the thinnest face allowed; a mean
//! whose sum shrinks by k, by no more than k times that of its worst face, where k is near 1 on smooth surfaces and at most
//! 1000. Real meshes have a few faces and sums out of this range: double precision computes them, up to one in [`EXCEPTIONS`].
//! With more of them, or with lengths out of range, all is left to double precision.

use crate::mesh::{FacesRef, PositionsRef};
use crate::normals::faces::component::Component;
use crate::normals::faces::positions::Source;
use crate::normals::faces::shape::FaceState;
use crate::normals::recipe::Weight;
use crate::normals::sums::accumulate::{Fill, UnusualFace, Walk, add_triangles};
use crate::normals::sums::block::{ALL, Settled};
use crate::normals::sums::corner_terms::CornerTerms;
use crate::normals::sums::finish::UncertainSlots;
use crate::normals::sums::gather::{are_in_place, copied, rows, whole_groups};
use crate::normals::sums::partition::{BLOCK, Partition};
use crate::normals::sums::recheck::Recheck;
use crate::normals::sums::request::{SlotState, SumRequest, Sums};
use crate::normals::sums::scatter::BlockTerms;
use crate::normals::sums::single_finish::FinishSingles;
use crate::normals::sums::weight::TriangleMeasures;
use crate::normals::sums::weighted_sums::{SumScratch, accumulate, finish};
use crate::num::{self, EightLanes, Kernel, LANES, Lanes, Scalars, Vectors};
use rayon::prelude::*;

/// Squares of the shortest and the longest edge: 1e-6 and 1e6 in units of the caller, but for rounding.
const SQUARED_EDGES: (f64, f64) = (0.999_999e-12, 1.000_001e12);
/// Least height of a face, as a share of its longest edge.
const LEAST_HEIGHT: f64 = 1e-3;
/// Height under which the direction of a face is rounding, as a share of its largest coordinate: 4 ulp.
const LEAST_RELATIVE_HEIGHT: f64 = 4.0 * f32::EPSILON as f64;
/// Most faces in one sum, so that the rounding of the sum does not show.
const MOST_FACES: u32 = 1000;
/// One face and one sum in so many may be out of range. The scalar path takes about ten times as long for a face.
const EXCEPTIONS: usize = 32;

/// Weighted sums in single precision; `None` if something is out of range.
pub(crate) fn single_sums(request: &SumRequest, scratch: &mut SumScratch) -> Option<Sums> {
    let mut sums = Sums::new(request.slots);
    let unit: &mut [[f64; 3]] = bytemuck::cast_slice_mut(&mut sums.unit);
    single_sums_into(request, scratch, unit, &mut sums.state).then_some(sums)
}

/// The same into the caller's slices: a slot without faces has +Z and [`SlotState::Empty`]. Returns `false`, with unspecified
/// output, if anything is out of range, or if faces are not triangles.
pub(crate) fn single_sums_into<O: Component>(
    request: &SumRequest,
    scratch: &mut SumScratch,
    unit: &mut [[O; 3]],
    state: &mut [SlotState],
) -> bool {
    let SumRequest { faces, target, slots, .. } = *request;
    if !faces.is_triangles() {
        return false;
    }
    let mut copied = std::mem::take(&mut scratch.single_positions);
    let points: &[[f32; 3]] = match request.positions {
        PositionsRef::F32(points) => points,
        PositionsRef::F64(points) => {
            points.par_iter().map(|point| point.as_vec3().to_array()).collect_into_vec(&mut copied);
            &copied
        }
    };
    let least_weight = least_weight(request, points);
    let partition = Partition::new(faces, target);
    let mut memory = std::mem::take(&mut scratch.single_parts);
    memory.resize_with(partition.parts().max(memory.len()), Default::default);
    let parts = &mut memory[..partition.parts()];
    let most_thin = faces.len() / EXCEPTIONS;
    let owned = accumulate(request, partition, parts, &|walk, sums, thin| {
        // Faces that are added to the sums of another part are listed in theirs.
        let is_share = matches!(walk, Walk::Share(..));
        let mut terms = SingleTerms {
            faces,
            weight: request.weight,
            points,
            least_weight,
            positions: request.positions,
            source: None,
            thin,
            most_thin: if is_share { most_thin } else { usize::MAX },
            scalar: CornerTerms::default(),
        };
        add_triangles(request, walk, sums, &mut terms)
    });
    let thin: usize = parts.iter().map(|part| part.unusual.len()).sum();
    let mut is_in_range = false;
    if let Some(owned) = owned
        && thin <= most_thin
    {
        let most_weight = least_weight * MOST_FACES as f32;
        let are_light = finish(slots, parts, &owned, unit, state, &|part, owned, unit, state| {
            part.uncertain.clear();
            let (first, sums) = (owned.start as u32, &mut part.sums.get(slots)[owned]);
            let recount = &mut part.uncertain.recount;
            num::dispatch(FinishSingles { sums, first, most_weight, unit, state, recount })
        });
        let mut uncertain = UncertainSlots::default();
        parts.iter().for_each(|part| uncertain.join(&part.uncertain));
        is_in_range = (are_light || have_few_faces(target, slots))
            && uncertain.recount.len() <= slots / EXCEPTIONS
            && recheck(request, &uncertain, unit, state);
        // All sums are zero again.
        scratch.single_parts = memory;
    }
    scratch.single_positions = copied;
    is_in_range
}

/// The least weight of a term in the sums of weights, which then bound the number of faces: with k faces a sum of weights is
/// at least k times this. It is an eighth of the lower quartile of weights of some faces, so that a sum of some faces of usual
/// size is below [`MOST_FACES`] times it, and larger weights do not hide a sum that cancels.
fn least_weight(request: &SumRequest, points: &[[f32; 3]]) -> f32 {
    let (faces, weight) = (request.faces.corners().as_chunks::<3>().0, request.weight);
    let count = BLOCK.min(faces.len());
    let triangles: Vec<[u32; 3]> = (0..count).map(|at| faces[at * (faces.len() / count)]).collect();
    let mut terms = BlockTerms::zero();
    if single_block(points, &triangles, weight, 0.0, &mut terms).is_none() {
        // Weights that do not exist bound nothing.
        return 0.0;
    }
    let factor = |weights: &[f32; 4]| if weight.is_equal_at_corners() { 1.0 } else { weights[0] };
    let weights =
        terms.vectors.iter().zip(&terms.weights).map(|(vector, weights)| vector[3] * factor(weights));
    let mut weights: Vec<f32> = weights.take(count).filter(|weight| weight.is_normal()).collect();
    weights.sort_unstable_by(f32::total_cmp);
    weights.get(weights.len() / 4).map_or(0.0, |quartile| quartile / 8.0)
}

/// Computes what a block of triangles adds to sums, and one bit for each whose shape is in range; `None` if a length is out of
/// range or a vertex does not exist.
fn single_block(
    points: &[[f32; 3]],
    triangles: &[[u32; 3]],
    weight: Weight,
    least_weight: f32,
    terms: &mut BlockTerms<f32>,
) -> Option<Settled> {
    let block = SingleBlock { points, triangles, weight, least_weight, terms };
    match num::dispatch(block) {
        Ok(in_range) => Some(in_range),
        Err(Refusal::OutOfRange) => None,
        Err(Refusal::NotInPlace) => {
            let points = &copied(points, triangles)?;
            let triangles = whole_groups(triangles.len());
            num::dispatch(SingleBlock { points, triangles, weight, least_weight, terms }).ok()
        }
    }
}

/// Whether no slot has more than [`MOST_FACES`] corners.
fn have_few_faces(target: &[u32], slots: usize) -> bool {
    let mut counts = vec![0_u32; slots];
    for &slot in target {
        // Corners without a slot have a number beyond them.
        if let Some(count) = counts.get_mut(slot as usize) {
            *count += 1;
        }
    }
    counts.iter().all(|&count| count <= MOST_FACES)
}

/// Computes some sums again in double precision; false if one of them has no direction.
fn recheck<O: Component>(
    request: &SumRequest,
    uncertain: &UncertainSlots,
    unit: &mut [[O; 3]],
    state: &mut [SlotState],
) -> bool {
    if uncertain.recount.is_empty() {
        return true;
    }
    let source = &Source::new(request.positions);
    let found = Recheck { request, source, unusual: &[] }.run(uncertain);
    for &(slot, vector, found) in &found {
        (unit[slot as usize], state[slot as usize]) = (O::emit(vector), found);
    }
    found.iter().all(|(_, _, state)| state.has_normal())
}

/// What triangles add to sums in single precision.
struct SingleTerms<'a> {
    faces: FacesRef<'a>,
    weight: Weight,
    points: &'a [[f32; 3]],
    least_weight: f32,
    /// The positions in the type that they came in.
    positions: PositionsRef<'a>,
    /// Where double precision reads the positions of thin faces, once there is one.
    source: Option<Source<'a>>,
    /// Takes the thin faces, of which there are this many at most.
    thin: &'a mut Vec<UnusualFace>,
    most_thin: usize,
    scalar: CornerTerms,
}

impl Fill<f32> for SingleTerms<'_> {
    /// False if a triangle is out of range or has a vertex that does not exist.
    fn fill(
        &mut self,
        triangles: &[[u32; 3]],
        face: &dyn Fn(usize) -> usize,
        terms: &mut BlockTerms<f32>,
    ) -> bool {
        let Self { weight, points, least_weight, .. } = *self;
        let in_range = single_block(points, triangles, weight, least_weight, terms);
        in_range.is_some_and(|in_range| self.settle(in_range, triangles.len(), face, terms))
    }

    fn least_weight(&self) -> f32 {
        self.least_weight
    }
}

impl SingleTerms<'_> {
    /// Computes those of some triangles that are out of range in double precision. False if there are too many of them, or if
    /// one is degenerate or below the rounding of its coordinates: such faces do not simply count.
    fn settle(
        &mut self,
        in_range: Settled,
        triangles: usize,
        face: &dyn Fn(usize) -> usize,
        terms: &mut BlockTerms<f32>,
    ) -> bool {
        for at in in_range.rest(triangles) {
            // Rounded positions do not determine the direction of a thin face.
            if let PositionsRef::F64(_) = self.positions {
                return false;
            }
            let source = self.source.get_or_insert_with(|| Source::new(self.positions));
            let (face, scalar) = (face(at), &mut self.scalar);
            scalar.fill(self.faces, source, self.weight, face, |_| false);
            let [x, y, z, length] = scalar.vector.map(|x| x as f32);
            let vector = [x, y, z, length.max(self.least_weight)];
            let weights = &scalar.weights;
            let are_finite =
                vector.iter().all(|x| x.is_finite()) && weights.iter().all(|&x| (x as f32).is_finite());
            if self.thin.len() == self.most_thin
                || scalar.state != FaceState::Counted
                || !vector[3].is_normal()
                || !are_finite
            {
                return false;
            }
            self.thin.push((face as u32, FaceState::Counted));
            terms.vectors[at] = vector;
            terms.weights[at] = std::array::from_fn(|corner| weights[corner.min(2)] as f32);
        }
        true
    }
}

/// Computes what a block of triangles adds to sums, and one bit for each whose shape is in range.
struct SingleBlock<'a> {
    points: &'a [[f32; 3]],
    triangles: &'a [[u32; 3]],
    weight: Weight,
    least_weight: f32,
    terms: &'a mut BlockTerms<f32>,
}

/// Why a block is not computed.
enum Refusal {
    /// Triangles that have to be [`copied`] first.
    NotInPlace,
    /// A length is out of range.
    OutOfRange,
}

impl Kernel for SingleBlock<'_> {
    type Output = Result<Settled, Refusal>;

    #[inline(always)]
    fn run<A: Lanes>(self, arch: A) -> Result<Settled, Refusal> {
        let Self { points, triangles, weight, least_weight, terms } = self;
        if !are_in_place(points.len(), triangles) {
            return Err(Refusal::NotInPlace);
        }
        let (vectors, weights) = (terms.vectors.as_chunks_mut().0, terms.weights.as_chunks_mut().0);
        let mut in_range = Settled::default();
        let arch = arch.singles();
        let groups = triangles.as_chunks().0.iter().zip(vectors).zip(weights);
        for (group, ((triangles, vectors), weights)) in groups.enumerate() {
            let bits = group_terms(arch, points, triangles, weight, least_weight, vectors, weights);
            in_range.add(group, bits.ok_or(Refusal::OutOfRange)?);
        }
        Ok(in_range)
    }
}

/// What eight triangles add to sums, and one bit for each whose shape is in range; `None` if a length is not.
#[inline(always)]
fn group_terms<A: EightLanes<Element = f32>>(
    arch: A,
    points: &[[f32; 3]],
    triangles: &[[u32; 3]; LANES],
    weight: Weight,
    least_weight: f32,
    vectors: &mut [[f32; 4]; LANES],
    weights: &mut [[f32; 4]; LANES],
) -> Option<u8> {
    let points = points.as_flattened();
    let [x0, y0, z0, _] = arch.columns(rows(points, triangles, 0)?);
    let [x1, y1, z1, _] = arch.columns(rows(points, triangles, 1)?);
    let [x2, y2, z2, _] = arch.columns(rows(points, triangles, 2)?);
    let p0 = Vectors::new(arch, [x0, y0, z0]);
    let p1 = Vectors::new(arch, [x1, y1, z1]);
    let p2 = Vectors::new(arch, [x2, y2, z2]);
    let (e1, e2) = (p1 - p0, p2 - p0);
    let vector = e1.cross(e2);
    let squared = vector.squared_length();
    let bits = if are_surely_in_range(arch, p0, e1, e2, squared) {
        ALL
    } else {
        in_range(arch, [p0, p1, p2], [e1, e2, p2 - p1], squared)?
    };
    let one = Scalars::splat(arch, 1.0);
    let (face, length);
    match (weight.has_area_factor(), weight.is_equal_at_corners()) {
        // Only an upper bound, which saves the root.
        (true, true) => {
            let least_weight = Scalars::splat(arch, f64::from(least_weight));
            (face, length) = (vector, vector.sum_of_magnitudes().max(least_weight));
        }
        (true, false) => (face, length) = (vector, squared.sqrt()),
        (false, _) => (face, length) = (vector.scaled(one / squared.sqrt()), one),
    }
    *vectors = arch.rows([face.x.value, face.y.value, face.z.value, length.value]).0;
    if !weight.is_equal_at_corners() {
        let [a, b, c] = TriangleMeasures::new(squared.sqrt(), e1, e2, p2 - p1).corner_factors(weight);
        *weights = arch.rows([a.value, b.value, c.value, c.value]).0;
    }
    Some(bits)
}

/// Whether lengths and shapes of eight triangles are in range by bounds that take few operations; mostly they are. With the
/// squared edges a and b at a corner p, no squared edge is above 2(a + b), no squared coordinate above 2(|p|² + a + b), and
/// no squared height below |e₁ × e₂|² / 2(a + b). Where rounding could matter, these bounds are off by more.
#[inline(always)]
fn are_surely_in_range<A: EightLanes<Element = f32>>(
    arch: A,
    corner: Vectors<A>,
    e1: Vectors<A>,
    e2: Vectors<A>,
    squared: Scalars<A>,
) -> bool {
    let splat = |x| Scalars::splat(arch, x);
    let half = e1.squared_length() + e2.squared_length();
    let longest = half + half;
    let near = corner.squared_length() + half;
    let by_shape = splat(LEAST_HEIGHT * LEAST_HEIGHT) * longest;
    let by_rounding = splat(2.0 * LEAST_RELATIVE_HEIGHT * LEAST_RELATIVE_HEIGHT) * near;
    let least_squared_height = by_shape.max(by_rounding).max(splat(1e-12));
    let is_short = longest.less(splat(1e12));
    // No comparison holds for NaN.
    ((least_squared_height * longest).less(squared) & is_short).row_bits() == ALL
}

/// One bit for each of eight triangles whose shape is in range; `None` if a length is not.
#[inline(always)]
fn in_range<A: EightLanes<Element = f32>>(
    arch: A,
    points: [Vectors<A>; 3],
    edges: [Vectors<A>; 3],
    squared: Scalars<A>,
) -> Option<u8> {
    let (a, b, c) = (edges[0].squared_length(), edges[1].squared_length(), edges[2].squared_length());
    let (shortest, longest) = (a.min(b).min(c), a.max(b).max(c));
    let (a, b, c) = (largest(points[0]), largest(points[1]), largest(points[2]));
    let least = Scalars::splat(arch, LEAST_HEIGHT) * longest;
    let relative = Scalars::splat(arch, LEAST_RELATIVE_HEIGHT) * a.max(b).max(c);
    let is_long_enough = Scalars::splat(arch, SQUARED_EDGES.0).less(shortest);
    if (is_long_enough & longest.less(Scalars::splat(arch, SQUARED_EDGES.1))).row_bits() != ALL {
        return None;
    }
    Some(((least * least).less(squared) & (relative * relative * longest).less(squared)).row_bits())
}

/// The largest magnitude of three coordinates.
#[inline(always)]
fn largest<A: EightLanes>(point: Vectors<A>) -> Scalars<A> {
    point.x.abs().max(point.y.abs()).max(point.z.abs())
}

#[cfg(test)]
mod tests {
    use super::{are_surely_in_range, in_range};
    use crate::mesh::{Faces, Mesh, MeshBuilder, Positions};
    use crate::normals::compute::compute;
    use crate::normals::recipe::{Averaging, NormalRecipe, Precision, Weight};
    use crate::normals::scratch::Scratch;
    use crate::normals::slices::vertex_normals::vertex_normals;
    use crate::normals::sums::block::ALL;
    use crate::normals::test_meshes::{bumpy, with_threads};
    use crate::num::test_numbers::Numbers;
    use crate::num::{self, EightLanes, Kernel, LANES, Lanes, Vectors};
    use glam::DVec3;

    fn mesh(scale: f64, flatten: f64) -> Mesh {
        let (faces, positions) = bumpy(24, 7);
        let positions = positions.iter().map(|&p| p * DVec3::new(scale, scale, scale * flatten)).collect();
        let faces = Faces::triangles(faces.as_flattened().to_vec());
        MeshBuilder { positions, faces, ..MeshBuilder::default() }.build().unwrap()
    }

    fn fast(weight: Weight) -> NormalRecipe {
        NormalRecipe { weight, precision: Precision::Fast, ..NormalRecipe::default() }
    }

    /// In range, single precision stays within its stated error: on this mesh no face is thinner than a hundredth of its
    /// length, so 3e-5 rad. It must differ from double precision, or it would not be single.
    #[test]
    fn in_range_it_is_close_and_not_the_same() {
        for weight in Weight::SUMS {
            let faithful = compute(&mesh(1.0, 1.0), &NormalRecipe { weight, ..NormalRecipe::default() });
            let fast = compute(&mesh(1.0, 1.0), &fast(weight));
            assert!(!fast.summary.fast_declined, "{weight:?}");
            assert_eq!(fast.normals.index, faithful.normals.index);
            let off = faithful.normals.values.iter().zip(&fast.normals.values);
            let worst = off.map(|(a, b)| libm::atan2(a.cross(*b).length(), a.dot(*b))).fold(0.0, f64::max);
            assert!(worst > 0.0 && worst < 3e-5, "{weight:?}: {worst:e}");
        }
    }

    #[test]
    fn normals_are_unit_in_doubles() {
        let field = compute(&mesh(1.0, 1.0), &fast(Weight::Angle));
        for normal in field.face_normals.iter().chain(&field.normals.values) {
            // Three roundings of the squared length, one of the factor and one of each component.
            assert!((normal.length() - 1.0).abs() <= 4.0 * f64::EPSILON, "{normal}");
        }
    }

    #[test]
    fn out_of_range_double_precision_is_used_and_reported() {
        for (scale, flatten) in [(1e-9, 1.0), (1e9, 1.0), (1.0, 1e-7)] {
            let mut mesh = mesh(scale, flatten);
            if flatten < 1.0 {
                // Slivers: one direction shrunk so far that faces are thinner than a thousandth of their length.
                let thin = mesh.positions().iter().map(|p| p.with_y(p.y * 1e-6)).collect();
                let faces = mesh.faces().clone();
                mesh = MeshBuilder { positions: thin, faces, ..MeshBuilder::default() }.build().unwrap();
            }
            let faithful = compute(&mesh, &NormalRecipe::default());
            let fast = compute(&mesh, &fast(Weight::Angle));
            assert!(fast.summary.fast_declined, "{scale:e}");
            assert_eq!(fast.normals, faithful.normals);
        }
    }

    /// A grid in which one triangle in a thousand is thinner than single precision allows, and a spike whose sum cancels but
    /// for a thousandth part: both are computed in double precision, with any number of threads. The vertices of a thin triangle
    /// by itself are right but for the rounding of one term and its length.
    #[test]
    fn a_few_thin_faces_and_cancelling_sums_are_exceptions() {
        let (mut faces, points) = bumpy(100, 7);
        let mut points: Vec<[f32; 3]> = points.iter().map(|p| p.as_vec3().to_array()).collect();
        for face in (0..faces.len()).step_by(1000) {
            // A vertex next to the middle of the opposite edge, by a few hundred spacings of coordinates.
            let [a, b, c] = faces[face].map(|vertex| glam::Vec3::from(points[vertex as usize]));
            let middle = (a + b) / 2.0;
            points[faces[face][2] as usize] = (middle + (c - middle) * 3e-4).to_array();
        }
        let tip = points.len() as u32;
        points.extend([[0.0, 0.0, 2000.0], [1.0, 0.0, 0.0], [-0.5, 0.8, 0.0], [-0.5, -0.8, 0.0]]);
        faces.extend([[tip, tip + 1, tip + 2], [tip, tip + 2, tip + 3], [tip, tip + 3, tip + 1]]);
        points.extend([[0.1, 0.7, 0.3], [1.3, 1.1, 0.9], [0.7, 0.9001, 0.6]]);
        faces.push([tip + 4, tip + 5, tip + 6]);
        let mesh = MeshBuilder {
            positions: Positions::F32(points),
            faces: Faces::triangles(faces.as_flattened().to_vec()),
            ..MeshBuilder::default()
        };
        let mesh = mesh.build().unwrap();
        for weight in Weight::SUMS {
            let faithful = compute(&mesh, &NormalRecipe { weight, ..NormalRecipe::default() }).normals;
            let alone = with_threads(1, || compute(&mesh, &fast(weight)));
            assert!(!alone.summary.fast_declined, "{weight:?}");
            let pairs = faithful.values.iter().zip(&alone.normals.values);
            let off: Vec<f64> = pairs.map(|(a, b)| libm::atan2(a.cross(*b).length(), a.dot(*b))).collect();
            let worst = off.iter().copied().fold(0.0, f64::max);
            assert!(worst > 0.0 && worst < 3e-4, "{weight:?}: {worst:e}");
            let by_itself = &off[off.len() - 3..];
            assert!(
                by_itself.iter().all(|&off| off < 4.0 * f64::from(f32::EPSILON)),
                "{weight:?}: {by_itself:?}"
            );
            for threads in [2, 3, 8] {
                assert_eq!(with_threads(threads, || compute(&mesh, &fast(weight))).normals, alone.normals);
            }
        }
    }

    /// Far from the origin the height of faces comes near the spacing of coordinates, whatever their shape.
    #[test]
    fn the_distance_from_the_origin_has_a_limit() {
        for (distance, is_declined) in [(0.0, false), (1e3, false), (1e6, true)] {
            let near = mesh(1.0, 1.0);
            let positions = near.positions().iter().map(|p| p + DVec3::splat(distance)).collect();
            let far = MeshBuilder { positions, faces: near.faces().clone(), ..MeshBuilder::default() };
            let field = compute(&far.build().unwrap(), &fast(Weight::Area));
            assert_eq!(field.summary.fast_declined, is_declined, "{distance:e}");
        }
    }

    /// A fan of more faces than one sum may have, by itself and with its faces spread over those of a grid, so that several
    /// threads add to the sum. Its faces are smaller than those of the grid, of about the same size, or larger.
    #[test]
    fn the_valence_has_a_limit() {
        let (grid, points) = bumpy(150, 3);
        for (valence, scale, is_declined) in [
            (1000_u32, 1.0, false),
            (1000, 30.0, false),
            (1001, 1e-3, true),
            (1001, 1.0, true),
            (1001, 30.0, true),
        ] {
            let rim = (0..valence).map(|i| f64::from(i) * std::f64::consts::TAU / f64::from(valence));
            let rim = rim.map(|angle| scale * DVec3::new(libm::cos(angle), libm::sin(angle), -0.5));
            let fan: Vec<[u32; 3]> = (0..valence).map(|i| [0, 1 + i, 1 + (i + 1) % valence]).collect();
            let fan_points: Vec<DVec3> = std::iter::once(DVec3::ZERO).chain(rim).collect();
            let grid: Vec<[u32; 3]> =
                grid.iter().map(|face| face.map(|vertex| vertex + valence + 1)).collect();
            let spread: Vec<[u32; 3]> = grid
                .chunks(grid.len() / valence as usize)
                .zip(&fan)
                .flat_map(|(some, &face)| some.iter().copied().chain([face]))
                .collect();
            let all_points: Vec<DVec3> = fan_points.iter().chain(&points).copied().collect();
            for (positions, faces) in [(fan_points, fan), (all_points, spread)] {
                let faces = Faces::triangles(faces.as_flattened().to_vec());
                let positions = positions.into_iter().collect();
                let mesh = MeshBuilder { positions, faces, ..MeshBuilder::default() }.build().unwrap();
                for (weight, threads) in [Weight::Area, Weight::Angle, Weight::Uniform]
                    .into_iter()
                    .flat_map(|it| [1, 2, 3, 8].map(|n| (it, n)))
                {
                    let field = with_threads(threads, || compute(&mesh, &fast(weight)));
                    assert_eq!(
                        field.summary.fast_declined, is_declined,
                        "{weight:?} {valence} {scale} {threads}"
                    );
                }
            }
        }
    }

    /// Ranges of some triangles, eight at a time: by bounds and by comparison.
    struct Ranges<'a>(&'a [[[f32; 3]; 3]; LANES]);

    impl Kernel for Ranges<'_> {
        type Output = (bool, Option<u8>);

        fn run<A: Lanes>(self, arch: A) -> (bool, Option<u8>) {
            let arch = arch.singles();
            let corner = |corner: usize| {
                let axis = |axis: usize| arch.load(&self.0.map(|triangle| triangle[corner][axis]));
                Vectors::new(arch, [axis(0), axis(1), axis(2)])
            };
            let [p0, p1, p2] = [corner(0), corner(1), corner(2)];
            let (e1, e2) = (p1 - p0, p2 - p0);
            let squared = e1.cross(e2).squared_length();
            let surely = are_surely_in_range(arch, p0, e1, e2, squared);
            (surely, in_range(arch, [p0, p1, p2], [e1, e2, p2 - p1], squared))
        }
    }

    /// What bounds show to be in range is in range, also next to each limit: of the shape, of the length of edges, and of the
    /// distance from the origin.
    #[test]
    fn bounds_of_the_range_hold() {
        let mut numbers = Numbers::new(17);
        let (mut sure, mut unsure, mut outside) = (0, 0, 0);
        for _ in 0..200_000 {
            let mut number = |low: f64, high: f64| {
                low + (high - low) * f64::from(numbers.below(1 << 20) as u32) / f64::from(1 << 20)
            };
            let scale = [1.0, libm::pow(10.0, number(-6.1, -5.9)), libm::pow(10.0, number(5.8, 6.1))];
            let scale = scale[number(0.0, 3.0) as usize];
            let height = libm::pow(10.0, number(-3.2, 0.0));
            let distance = [0.0, scale * libm::pow(10.0, number(1.0, 4.0))][number(0.0, 2.0) as usize];
            let [along, turn] = [number(-1.0, 2.0), number(0.0, std::f64::consts::TAU)];
            let (sin, cos) = libm::sincos(turn);
            let flat = [[0.0, 0.0], [1.0, 0.0], [along, height]];
            let triangle = flat.map(|[x, y]| {
                [x * cos - y * sin, x * sin + y * cos, 0.3 * x].map(|x| (scale * x + distance) as f32)
            });
            let (surely, exactly) = num::dispatch(Ranges(&[triangle; LANES]));
            assert!(!surely || exactly == Some(ALL), "{triangle:?}");
            match exactly {
                Some(ALL) if surely => sure += 1,
                Some(ALL) => unsure += 1,
                _ => outside += 1,
            }
        }
        assert!(sure > 50_000 && unsure > 5000 && outside > 5000, "{sure} {unsure} {outside}");
    }

    /// In the callers' slices: the same bits with any number of threads, in order, mixed and shuffled, and again after a mesh
    /// out of range has left its traces in memory.
    #[test]
    fn any_number_of_threads_gives_the_same_bits() {
        let (faces, points) = bumpy(200, 11);
        let points: Vec<[f32; 3]> = points.iter().map(|p| p.as_vec3().to_array()).collect();
        let mut numbers = Numbers::new(9);
        let mut shuffled = faces.clone();
        numbers.shuffle(&mut shuffled);
        let mut mixed = faces.clone();
        mixed.swap(300, faces.len() - 1);
        let mut far = points.clone();
        far[points.len() / 2] = [1e9; 3];
        for faces in [&faces, &mixed, &shuffled] {
            for weight in Weight::SUMS {
                let averaging = Averaging { weight, precision: Precision::Fast, ..Averaging::default() };
                let mut scratch = Scratch::new();
                let mut run = |points: &[[f32; 3]], threads| {
                    let mut normals = vec![[0.0_f32; 3]; points.len()];
                    with_threads(threads, || {
                        vertex_normals(points, faces, averaging, &mut scratch, &mut normals).unwrap()
                    });
                    normals
                };
                let alone = run(&points, 1);
                for threads in [2, 3, 8] {
                    assert_eq!(run(&points, threads), alone, "{weight:?}");
                    run(&far, threads);
                }
            }
        }
    }
}
