//! What triangles add to sums, eight at a time.
//!
//! The scalar path, [`CornerTerms`](crate::normals::sums::corner_terms::CornerTerms), gives the same bits.

use crate::mesh::{PositionsRef, Storage};
use crate::normals::faces::positions::{EXACT_RATIO, Extent, Source};
use crate::normals::faces::sliver;
use crate::normals::recipe::Weight;
use crate::normals::sums::gather::{are_in_place, columns, copied, whole_groups};
use crate::normals::sums::scatter::BlockTerms;
use crate::normals::sums::weight::TriangleMeasures;
use crate::num::{self, Kernel, LANES, Lanes, Scalars, Truth, Vectors};

/// All eight triangles.
pub(crate) const ALL: u8 = u8::MAX;

/// 2^-300: sums of two squared edges above it keep clear of the subnormal range in everything computed from them.
const SMALLEST_SQUARES: f64 = 4.909_093_465_297_727e-91;

/// Computes what a block of triangles adds to sums; `None` if a vertex does not exist.
pub(crate) fn block_terms(
    source: &Source,
    triangles: &[[u32; 3]],
    weight: Weight,
    terms: &mut BlockTerms<f64>,
) -> Option<Settled> {
    let positions = source.positions();
    let settled = num::dispatch(BlockKernel { source, positions, triangles, weight, terms });
    if settled.is_some() {
        return settled;
    }
    let (singles, doubles);
    let positions = match positions {
        PositionsRef::F32(points) => {
            singles = copied(points, triangles)?;
            PositionsRef::F32(&singles)
        }
        PositionsRef::F64(points) => {
            doubles = copied(points, triangles)?;
            PositionsRef::F64(&doubles)
        }
    };
    let triangles = whole_groups(triangles.len());
    num::dispatch(BlockKernel { source, positions, triangles, weight, terms })
}

/// Computes what the triangles of a block add to sums, if they [`are_in_place`].
struct BlockKernel<'a> {
    source: &'a Source<'a>,
    /// Those of the source or copies of some of them.
    positions: PositionsRef<'a>,
    triangles: &'a [[u32; 3]],
    weight: Weight,
    terms: &'a mut BlockTerms<f64>,
}

/// One bit for each triangle of a block that is settled; what is not needs the scalar path.
#[derive(Clone, Copy, Default)]
pub(crate) struct Settled(u64);

impl Settled {
    /// Adds the bits of a group of eight triangles.
    #[inline(always)]
    pub(crate) fn add(&mut self, group: usize, bits: u8) {
        self.0 |= u64::from(bits) << (LANES * group);
    }

    /// Those of the first so many that are not settled.
    pub(crate) fn rest(self, triangles: usize) -> impl Iterator<Item = usize> {
        let some = if self.0 == u64::MAX { 0..0 } else { 0..triangles };
        some.filter(move |&at| self.0 >> at & 1 == 0)
    }
}

impl Kernel for BlockKernel<'_> {
    type Output = Option<Settled>;

    #[inline(always)]
    fn run<A: Lanes>(self, arch: A) -> Option<Settled> {
        let Self { source, positions, triangles, weight, terms } = self;
        if !are_in_place(positions.len(), triangles) {
            return None;
        }
        // A copy stays in registers.
        let source = *source;
        let (vectors, weights) = (terms.vectors.as_chunks_mut().0, terms.weights.as_chunks_mut().0);
        let mut settled = Settled::default();
        let groups = triangles.as_chunks().0.iter().zip(vectors).zip(weights);
        for (group, ((triangles, vectors), weights)) in groups.enumerate() {
            let corners = columns(arch, positions, triangles, source.factor())?;
            settled.add(group, group_terms(arch, corners, &source, weight, vectors, weights));
        }
        Some(settled)
    }
}

/// Computes what a group of eight triangles adds to sums.
#[inline(always)]
fn group_terms<A: Lanes>(
    arch: A,
    corners: [[A::Number; 3]; 3],
    source: &Source,
    weight: Weight,
    vectors: &mut [[f64; 4]; LANES],
    weights: &mut [[f64; 4]; LANES],
) -> u8 {
    let [p0, p1, p2] = corners;
    let (p0, p1, p2) = (Vectors::new(arch, p0), Vectors::new(arch, p1), Vectors::new(arch, p2));
    if let Some(Extent { sliver_bound, grain, is_exact }) = source.extent() {
        let (e1, e2) = (p1 - p0, p2 - p0);
        let settled =
            Group { e1, e2, e3: p2 - p1, vector: e1.cross(e2) }.write(weight, sliver_bound, vectors, weights);
        if settled == ALL && (is_exact || multiples(grain, [p0, p1, p2]).row_bits() == ALL) {
            return ALL;
        }
    }
    // A bound for these triangles' own coordinates may be lower.
    let (largest, smallest) = range(arch, [p0, p1, p2]);
    let bound = sliver::triangle_bound(source.storage(), largest);
    let single = source.storage() == Storage::F32;
    if single && largest < EXACT_RATIO * smallest {
        let (e1, e2) = (p1 - p0, p2 - p0);
        return Group { e1, e2, e3: p2 - p1, vector: e1.cross(e2) }.write(weight, bound, vectors, weights);
    }
    let ((e1, low1), (e2, low2)) = (p1.two_difference(p0), p2.two_difference(p0));
    let vector = e1.cross_with_low_parts(low1, e2, low2);
    let settled = Group { e1, e2, e3: p2 - p1, vector }.write(weight, bound, vectors, weights);
    if !single {
        return settled;
    }
    // With `f32` values a component far smaller than the others must be right to an ulp as well: where differences are
    // not exact, the scalar path watches over that.
    let lost = low1.sum_of_magnitudes() + low2.sum_of_magnitudes();
    settled & lost.less(Scalars::splat(arch, f64::MIN_POSITIVE)).row_bits()
}

/// Which triangles have only coordinates that are multiples of a power of two, which is above 2^-51 of the largest.
#[inline(always)]
fn multiples<A: Lanes>(grain: f64, [p0, p1, p2]: [Vectors<A>; 3]) -> Truth<A> {
    let arch = p0.x.arch;
    // What is added leaves no place for smaller bits.
    let rounder = Scalars::splat(arch, 1.5 * (1_u64 << 52) as f64 * grain);
    let mut lost = Scalars::splat(arch, 0.0);
    for x in [p0.x, p0.y, p0.z, p1.x, p1.y, p1.z, p2.x, p2.y, p2.z] {
        lost = lost.differences((x + rounder) - rounder, x);
    }
    // Without the sign, which zero may lose.
    lost.abs().less(Scalars::splat(arch, f64::from_bits(1)))
}

/// Eight triangles.
struct Group<A: Lanes> {
    /// P0→P1, P0→P2 and P1→P2.
    e1: Vectors<A>,
    e2: Vectors<A>,
    e3: Vectors<A>,
    /// Twice the area vector.
    vector: Vectors<A>,
}

impl<A: Lanes> Group<A> {
    /// Writes terms; gives one bit for each triangle that is neither a sliver nor too small nor undefined.
    #[inline(always)]
    fn write(
        self,
        weight: Weight,
        bound: f64,
        vectors: &mut [[f64; 4]; LANES],
        weights: &mut [[f64; 4]; LANES],
    ) -> u8 {
        let Self { e1, e2, e3, vector } = self;
        let arch = vector.x.arch;
        let one = Scalars::splat(arch, 1.0);
        let squared = vector.squared_length();
        let squares = e1.squared_length() + e2.squared_length();
        let settled = (Scalars::splat(arch, bound) * squares).less(squared)
            & Scalars::splat(arch, SMALLEST_SQUARES).less(squares);
        let (face, length);
        match (weight.has_area_factor(), weight.is_equal_at_corners()) {
            // Only an upper bound, which saves the root; see `Finish`.
            (true, true) => (face, length) = (vector, vector.sum_of_magnitudes()),
            (false, true) => {
                (face, length) = (vector.scaled(one / squared.sqrt()), one);
            }
            (_, false) => {
                (face, length) = (vector, squared.sqrt());
                let [mut a, mut b, mut c] = TriangleMeasures::new(length, e1, e2, e3).corner_factors(weight);
                if !weight.has_area_factor() {
                    let reciprocal = one / length;
                    (a, b, c) = (a * reciprocal, b * reciprocal, c * reciprocal);
                }
                *weights = arch.rows([a.value, b.value, c.value, c.value]).0;
            }
        }
        *vectors = arch.rows([face.x.value, face.y.value, face.z.value, length.value]).0;
        settled.row_bits()
    }
}

/// The largest magnitude, and the smallest but zero.
#[inline(always)]
fn range<A: Lanes>(arch: A, points: [Vectors<A>; 3]) -> (f64, f64) {
    let (zero, infinity) = (Scalars::splat(arch, 0.0), Scalars::splat(arch, f64::INFINITY));
    let (mut largest, mut smallest) = (zero, infinity);
    for Vectors { x, y, z } in points {
        for x in [x, y, z] {
            let magnitude = x.abs();
            largest = largest.max(magnitude);
            smallest = smallest.min(zero.less(magnitude).select(magnitude, infinity));
        }
    }
    let (largest, smallest) = (arch.to_array(largest.value), arch.to_array(smallest.value));
    (largest.into_iter().fold(0.0, f64::max), smallest.into_iter().fold(f64::INFINITY, f64::min))
}
