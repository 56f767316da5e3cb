//! What triangles add to sums, eight at a time.
//!
//! The scalar path, [`CornerTerms`](crate::normals::sums::corner_terms::CornerTerms), gives the same bits.

use crate::mesh::Storage;
use crate::normals::faces::positions::{Extent, Source};
use crate::normals::faces::sliver;
use crate::normals::recipe::Weight;
use crate::normals::sums::weight::TriangleMeasures;
use crate::num::{LANES, Lanes, Real, Rows, Scalars, Truth, Vectors};

/// What eight triangles add to sums.
#[derive(Clone, Copy)]
pub(crate) struct GroupTerms<T> {
    /// Each face's vector and its length. Where every corner counts by area alone, the latter may be only an upper bound.
    pub(crate) vectors: Rows<T>,
    /// The weights of each face's corners. Where every corner counts the same, nothing.
    pub(crate) weights: Rows<T>,
}

impl<T: Real> GroupTerms<T> {
    pub(crate) const ZERO: Self = Self { vectors: Rows::ZERO, weights: Rows::ZERO };
}

/// All eight triangles.
pub(crate) const ALL: u8 = u8::MAX;

/// Differences of `f32` values are exact in `f64` while no value is this many times as large as another that is not
/// zero: 24 bits each, 28 between their exponents and one to carry make 53.
const EXACT_RATIO: f64 = (1 << 28) as f64;
/// 2^-300: sums of two squared edges above it keep clear of the subnormal range in everything computed from them.
const SMALLEST_SQUARES: f64 = 4.909_093_465_297_727e-91;

/// Whether vertices exist and none is the last. Others need the scalar path, as rows are read with the number after them.
#[inline(always)]
pub(crate) fn are_inner(source: &Source, triangles: &[[u32; 3]]) -> bool {
    let highest = triangles.as_flattened().iter().fold(0, |highest, &vertex| vertex.max(highest));
    (highest as usize) < source.count().saturating_sub(1)
}

/// Computes what eight triangles, which [`are_inner`], add to sums. Gives one bit for each that is settled; what is not needs
/// the scalar path.
#[inline(always)]
pub(crate) fn group_terms<A: Lanes>(
    arch: A,
    triangles: &[[u32; 3]; LANES],
    source: &Source,
    weight: Weight,
    terms: &mut GroupTerms<f64>,
) -> u8 {
    let mut corners = [[0; LANES]; 3];
    for (i, triangle) in triangles.iter().enumerate() {
        for corner in 0..3 {
            corners[corner][i] = triangle[corner];
        }
    }
    let p0 = Vectors::new(arch, source.columns(arch, corners[0]));
    let p1 = Vectors::new(arch, source.columns(arch, corners[1]));
    let p2 = Vectors::new(arch, source.columns(arch, corners[2]));
    if let Some(Extent { sliver_bound, grain }) = source.extent() {
        let (e1, e2) = (p1 - p0, p2 - p0);
        let settled = Group { e1, e2, e3: p2 - p1, vector: e1.cross(e2) }.write(weight, sliver_bound, terms);
        if settled & multiples(grain, [p0, p1, p2]).row_bits() == ALL {
            return ALL;
        }
    }
    // A bound for these triangles' own coordinates may be lower.
    let (largest, smallest) = range(arch, [p0, p1, p2]);
    let bound = sliver::triangle_bound(source.storage(), largest);
    let single = source.storage() == Storage::F32;
    if single && largest < EXACT_RATIO * smallest {
        let (e1, e2) = (p1 - p0, p2 - p0);
        return Group { e1, e2, e3: p2 - p1, vector: e1.cross(e2) }.write(weight, bound, terms);
    }
    let ((e1, low1), (e2, low2)) = (p1.two_difference(p0), p2.two_difference(p0));
    let vector = e1.cross_with_low_parts(low1, e2, low2);
    let settled = Group { e1, e2, e3: p2 - p1, vector }.write(weight, bound, terms);
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
    fn write(self, weight: Weight, bound: f64, terms: &mut GroupTerms<f64>) -> u8 {
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
                let weights = TriangleMeasures::new(length, e1, e2, e3).corner_factors(weight);
                let [a, b, c] = if weight.has_area_factor() {
                    weights
                } else {
                    let reciprocal = one / length;
                    [weights[0] * reciprocal, weights[1] * reciprocal, weights[2] * reciprocal]
                };
                terms.weights = arch.rows([a.value, b.value, c.value, c.value]);
            }
        }
        terms.vectors = arch.rows([face.x.value, face.y.value, face.z.value, length.value]);
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
