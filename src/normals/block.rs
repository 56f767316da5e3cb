//! Blocks of triangles, laid out so that the compiler computes several at once.

use super::face_shape::Minor;
use super::positions::Source;
use super::sliver;
use super::weight::{CornerWeight, TriangleMeasures};
use crate::mesh::Storage;
use crate::num::{self, Product, difference_of_products};
use glam::DVec3;

/// Triangles in a block: enough to fill vectors, few enough that all its arrays stay in the nearest cache.
pub(crate) const LANES: usize = 64;

type Lanes = [f64; LANES];

/// Coordinates of the corners of up to [`LANES`] triangles, transposed: nine rows, x y z of the first corner, of the
/// second, of the third.
pub(crate) struct Corners<T> {
    rows: [[T; LANES]; 9],
}

/// What triangles of a block add to sums; see [`CornerTerms`](super::corner_terms::CornerTerms).
pub(crate) struct BlockTerms {
    /// Each face's vector and its length.
    pub(crate) vectors: [[f64; 4]; LANES],
    /// The weights of each face's corners.
    pub(crate) weights: [[f64; 4]; LANES],
    /// Whether the above is right. Where it is not, the face needs the scalar path.
    pub(crate) settled: [u64; LANES],
}

impl BlockTerms {
    pub(crate) fn new() -> Self {
        Self { vectors: [[0.0; 4]; LANES], weights: [[0.0; 4]; LANES], settled: [0; LANES] }
    }
}

impl<T: Copy + Default + Into<f64>> Corners<T> {
    pub(crate) fn new() -> Self {
        Self { rows: [[T::default(); LANES]; 9] }
    }

    /// Reads the corners of the given triangles; rows beyond them keep what they had.
    #[inline(always)]
    pub(crate) fn gather<S: Source<Scalar = T>>(&mut self, triangles: &[[u32; 3]], source: S) {
        for (lane, triangle) in triangles.iter().enumerate().take(LANES) {
            let [a, b, c] = triangle.map(|vertex| source.stored(vertex));
            for axis in 0..3 {
                self.rows[axis][lane] = a[axis];
                self.rows[3 + axis][lane] = b[axis];
                self.rows[6 + axis][lane] = c[axis];
            }
        }
    }

    #[inline(always)]
    fn point(&self, corner: usize, lane: usize) -> DVec3 {
        let row = |axis: usize| self.rows[3 * corner + axis][lane].into();
        DVec3::new(row(0), row(1), row(2))
    }

    /// The largest magnitude in the block, and the smallest but zero.
    #[inline(always)]
    fn range(&self) -> (f64, f64) {
        let (mut largest, mut smallest) = ([0.0_f64; LANES], [f64::INFINITY; LANES]);
        for row in &self.rows {
            for lane in 0..LANES {
                let x: f64 = row[lane].into();
                let x = x.abs();
                // Comparisons so arranged that NaN becomes the largest.
                largest[lane] = if x <= largest[lane] { largest[lane] } else { x };
                let x = if x == 0.0 { f64::INFINITY } else { x };
                smallest[lane] = if x < smallest[lane] { x } else { smallest[lane] };
            }
        }
        let (mut high, mut low) = (0.0, f64::INFINITY);
        for lane in 0..LANES {
            high = if largest[lane] <= high { high } else { largest[lane] };
            low = if smallest[lane] < low { smallest[lane] } else { low };
        }
        (high, low)
    }
}

/// Differences of `f32` values are exact in `f64` while no value is this many times as large as another that is not
/// zero: 24 bits each, 28 between their exponents and one to carry make 53.
const EXACT_RATIO: f64 = (1 << 28) as f64;
/// Sums of two squared edges above this keep clear of the subnormal range in everything computed from them.
const SMALLEST_SQUARES: f64 = 4.909_093_465_297_727e-91; // 2^-300

/// Computes what triangles add to sums, for a whole block.
#[inline(always)]
pub(crate) fn block_terms<P: Product, S: Source, W: CornerWeight>(
    corners: &Corners<S::Scalar>,
    source: S,
    terms: &mut BlockTerms,
) {
    let (largest, smallest) = corners.range();
    let threshold = sliver::threshold(source.storage(), largest);
    // The longest edge is at most |e1| + |e2|, its square at most twice the sum of theirs; and something for the
    // rounding of the test itself.
    let bar = 2.001 * threshold * threshold;
    if source.storage() == Storage::F32 && largest < EXACT_RATIO * smallest {
        lanes::<P, S, W, false>(corners, bar, terms);
    } else {
        lanes::<P, S, W, true>(corners, bar, terms);
        if source.storage() == Storage::F32 {
            settle_exact_differences_only(corners, terms);
        }
    }
}

/// With `f32` values a component far smaller than the others must be right to an ulp as well: where differences are
/// not exact, the scalar path watches over that.
#[inline(always)]
fn settle_exact_differences_only<T: Copy + Default + Into<f64>>(
    corners: &Corners<T>,
    terms: &mut BlockTerms,
) {
    for lane in 0..LANES {
        let [p0, p1, p2] = [0, 1, 2].map(|corner| corners.point(corner, lane));
        let (low1, low2) = (difference(p1, p0).1, difference(p2, p0).1);
        let exact = low1.abs() + low2.abs() == DVec3::ZERO;
        terms.settled[lane] &= u64::from(exact);
    }
}

#[inline(always)]
fn difference(to: DVec3, from: DVec3) -> (DVec3, DVec3) {
    let (x, y, z) = (
        num::two_difference(to.x, from.x),
        num::two_difference(to.y, from.y),
        num::two_difference(to.z, from.z),
    );
    (DVec3::new(x.0, y.0, z.0), DVec3::new(x.1, y.1, z.1))
}

/// u × v by differences of products; with `LOW`, of vectors that have low parts.
#[inline(always)]
fn cross<P: Product, const LOW: bool>(u: (DVec3, DVec3), v: (DVec3, DVec3)) -> DVec3 {
    let minor = |i: usize, j: usize| {
        if LOW {
            let part = |w: (DVec3, DVec3), axis: usize| (w.0[axis], w.1[axis]);
            Minor { a: part(u, i), b: part(v, j), c: part(u, j), d: part(v, i) }.value::<P>()
        } else {
            difference_of_products::<P>(u.0[i], v.0[j], u.0[j], v.0[i])
        }
    };
    DVec3::new(minor(1, 2), minor(2, 0), minor(0, 1))
}

#[inline(always)]
fn lanes<P: Product, S: Source, W: CornerWeight, const LOW: bool>(
    corners: &Corners<S::Scalar>,
    bar: f64,
    terms: &mut BlockTerms,
) {
    let mut columns: [Lanes; 7] = [[0.0; LANES]; 7];
    for lane in 0..LANES {
        let [p0, p1, p2] = [0, 1, 2].map(|corner| corners.point(corner, lane));
        let (u, v) = if LOW {
            (difference(p1, p0), difference(p2, p0))
        } else {
            ((p1 - p0, DVec3::ZERO), (p2 - p0, DVec3::ZERO))
        };
        let vector = cross::<P, LOW>(u, v);
        let squared = num::squared_length(vector);
        let length = squared.sqrt();
        let squares = num::squared_length(u.0) + num::squared_length(v.0);
        // False for zero areas, slivers and NaN alike.
        terms.settled[lane] = u64::from((squared > bar * squares) & (squares > SMALLEST_SQUARES));
        let face = if W::BY_AREA { vector } else { vector * (1.0 / length) };
        columns[0][lane] = face.x;
        columns[1][lane] = face.y;
        columns[2][lane] = face.z;
        columns[3][lane] = if W::BY_AREA { length } else { 1.0 };
        if !W::EVEN {
            let weights = W::of_triangle(TriangleMeasures::new(length, u.0, v.0, p2 - p1));
            columns[4][lane] = weights[0];
            columns[5][lane] = weights[1];
            columns[6][lane] = weights[2];
        }
    }
    for lane in 0..LANES {
        terms.vectors[lane] = [columns[0][lane], columns[1][lane], columns[2][lane], columns[3][lane]];
        if !W::EVEN {
            terms.weights[lane] = [columns[4][lane], columns[5][lane], columns[6][lane], 0.0];
        }
    }
}
