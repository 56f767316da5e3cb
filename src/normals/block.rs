//! Blocks of triangles, laid out so that the compiler computes several at once.
//!
//! Everything here is loops over rows of fixed length without branches or calls: what a compiler turns into vector
//! instructions. The scalar path gives the same bits.

use super::face_shape::Minor;
use super::positions::{Scalar, Source};
use super::sliver;
use super::weight::{CornerWeight, TriangleMeasures};
use crate::mesh::Storage;
use crate::num::{self, Product};
use glam::DVec3;

/// Triangles in a block: enough to fill vectors, few enough that reading one block overlaps with computing the last.
pub(crate) const LANES: usize = 32;

type Row<T> = [T; LANES];

/// Coordinates of the corners of a block's triangles, for the first corners, the second and the third. x and y stay
/// together: they are read and written as one.
pub(crate) struct Corners<T> {
    xy: [Row<[T; 2]>; 3],
    z: [Row<T>; 3],
}

/// What triangles of a block add to sums; see [`CornerTerms`](super::corner_terms::CornerTerms).
pub(crate) struct BlockTerms {
    /// Each face's vector and its length. Where every corner counts by area alone, the latter is only an upper bound.
    pub(crate) vectors: Row<[f64; 4]>,
    /// The same by components.
    columns: [Row<f64>; 4],
    /// Weights of the first corners, of the second and of the third. Where every corner counts the same, nothing.
    pub(crate) weights: [Row<f64>; 3],
    /// Whether the above is right. Where it is not, the face needs the scalar path.
    pub(crate) settled: Row<u64>,
}

impl BlockTerms {
    pub(crate) fn new() -> Self {
        Self {
            vectors: [[0.0; 4]; LANES],
            columns: [[0.0; LANES]; 4],
            weights: [[0.0; LANES]; 3],
            settled: [0; LANES],
        }
    }

    /// Writes the terms of one triangle.
    pub(crate) fn set(&mut self, lane: usize, vector: [f64; 4], weights: &[f64]) {
        self.vectors[lane] = vector;
        self.weights.iter_mut().zip(weights).for_each(|(row, &x)| row[lane] = x);
    }
}

impl<T: Scalar> Corners<T> {
    pub(crate) fn new() -> Self {
        Self { xy: [[[T::default(); 2]; LANES]; 3], z: [[T::default(); LANES]; 3] }
    }

    /// Reads the corners of the given triangles; lanes beyond them keep what they had.
    #[inline(always)]
    pub(crate) fn gather<S: Source<Scalar = T>>(&mut self, triangles: &[[u32; 3]], source: S) {
        let Self { xy: [xy0, xy1, xy2], z: [z0, z1, z2] } = self;
        for (lane, &[a, b, c]) in triangles.iter().enumerate().take(LANES) {
            (xy0[lane], z0[lane]) = source.stored(a);
            (xy1[lane], z1[lane]) = source.stored(b);
            (xy2[lane], z2[lane]) = source.stored(c);
        }
    }

    /// The positions of a triangle's corners.
    #[inline(always)]
    fn points(&self, lane: usize) -> (DVec3, DVec3, DVec3) {
        let Self { xy, z } = self;
        let point = |[x, y]: [T; 2], z: T| DVec3::new(x.into(), y.into(), z.into());
        (point(xy[0][lane], z[0][lane]), point(xy[1][lane], z[1][lane]), point(xy[2][lane], z[2][lane]))
    }

    /// The largest magnitude in the block, and the smallest but zero.
    #[inline(always)]
    fn range(&self) -> (f64, f64) {
        // Lane by lane first: only the last step goes across lanes.
        let (mut largest, mut smallest) = ([T::LOWEST; LANES], [T::HIGHEST; LANES]);
        let mut take = |lane: usize, x: T| {
            let (high, low) = (x.magnitude(), x.magnitude_but_zero());
            largest[lane] = if high > largest[lane] { high } else { largest[lane] };
            smallest[lane] = if low < smallest[lane] { low } else { smallest[lane] };
        };
        for corner in 0..3 {
            let (x, y) = self.xy[corner].as_flattened().split_at(LANES);
            for (lane, &x) in x.iter().enumerate() {
                take(lane, x);
            }
            for (lane, &y) in y.iter().enumerate() {
                take(lane, y);
            }
            for lane in 0..LANES {
                take(lane, self.z[corner][lane]);
            }
        }
        let (mut high, mut low) = (T::LOWEST, T::HIGHEST);
        for lane in 0..LANES {
            high = if largest[lane] > high { largest[lane] } else { high };
            low = if smallest[lane] < low { smallest[lane] } else { low };
        }
        (T::largest(high), T::smallest(low))
    }
}

/// Differences of `f32` values are exact in `f64` while no value is this many times as large as another that is not
/// zero: 24 bits each, 28 between their exponents and one to carry make 53.
const EXACT_RATIO: f64 = (1 << 28) as f64;
/// 2^-300: sums of two squared edges above it keep clear of the subnormal range in everything computed from them.
const SMALLEST_SQUARES: f64 = 4.909_093_465_297_727e-91;

/// Computes what the first `count` triangles of a block add to sums, and tells whether all are settled.
#[inline(always)]
pub(crate) fn block_terms<P: Product, S: Source, W: CornerWeight>(
    corners: &Corners<S::Scalar>,
    count: usize,
    source: S,
    terms: &mut BlockTerms,
) -> bool {
    let (largest, smallest) = corners.range();
    let threshold = sliver::threshold(source.storage(), largest);
    // The longest edge is at most |e1| + |e2|, its square at most twice the sum of theirs; and something for the
    // rounding of the test itself.
    let bar = 2.001 * threshold * threshold;
    let single = source.storage() == Storage::F32;
    if single && largest < EXACT_RATIO * smallest {
        lanes::<P, S, W, false>(corners, bar, terms);
    } else {
        lanes::<P, S, W, true>(corners, bar, terms);
        if single {
            unsettle_inexact_differences(corners, terms);
        }
    }
    terms.settled.iter().take(count).fold(1, |all, &one| all & one) == 1
}

/// With `f32` values a component far smaller than the others must be right to an ulp as well: where differences are
/// not exact, the scalar path watches over that.
#[inline(always)]
fn unsettle_inexact_differences<T: Scalar>(corners: &Corners<T>, terms: &mut BlockTerms) {
    for lane in 0..LANES {
        let (p0, p1, p2) = corners.points(lane);
        let (u, v) = (difference(p1, p0).1, difference(p2, p0).1);
        let lost = ((u.x.abs() + u.y.abs()) + u.z.abs()) + ((v.x.abs() + v.y.abs()) + v.z.abs());
        terms.settled[lane] &= u64::from(lost == 0.0);
    }
}

/// The difference of two positions without error, as a high and a low part.
#[inline(always)]
fn difference(to: DVec3, from: DVec3) -> (DVec3, DVec3) {
    let (x, y, z) = (
        num::two_difference(to.x, from.x),
        num::two_difference(to.y, from.y),
        num::two_difference(to.z, from.z),
    );
    (DVec3::new(x.0, y.0, z.0), DVec3::new(x.1, y.1, z.1))
}

/// u × v by differences of products, for vectors that have low parts.
#[inline(always)]
fn cross_with_low_parts<P: Product>(u: (DVec3, DVec3), v: (DVec3, DVec3)) -> DVec3 {
    let ((ux, uy, uz), (vx, vy, vz)) =
        (((u.0.x, u.1.x), (u.0.y, u.1.y), (u.0.z, u.1.z)), ((v.0.x, v.1.x), (v.0.y, v.1.y), (v.0.z, v.1.z)));
    DVec3::new(
        Minor { a: uy, b: vz, c: uz, d: vy }.value::<P>(),
        Minor { a: uz, b: vx, c: ux, d: vz }.value::<P>(),
        Minor { a: ux, b: vy, c: uy, d: vx }.value::<P>(),
    )
}

#[inline(always)]
fn lanes<P: Product, S: Source, W: CornerWeight, const LOW: bool>(
    corners: &Corners<S::Scalar>,
    bar: f64,
    terms: &mut BlockTerms,
) {
    let BlockTerms { vectors, columns: [x, y, z, w], weights: [weight0, weight1, weight2], settled } = terms;
    for lane in 0..LANES {
        let (p0, p1, p2) = corners.points(lane);
        let (e1, e2, vector);
        if LOW {
            let (u, v) = (difference(p1, p0), difference(p2, p0));
            (e1, e2, vector) = (u.0, v.0, cross_with_low_parts::<P>(u, v));
        } else {
            (e1, e2) = (p1 - p0, p2 - p0);
            vector = num::cross::<P>(e1, e2);
        }
        let squared = num::squared_length(vector);
        let length = squared.sqrt();
        let squares = num::squared_length(e1) + num::squared_length(e2);
        // False for zero areas, slivers and NaN alike.
        settled[lane] = u64::from((squared > bar * squares) & (squares > SMALLEST_SQUARES));
        let face = if W::BY_AREA { vector } else { vector * (1.0 / length) };
        (x[lane], y[lane], z[lane]) = (face.x, face.y, face.z);
        w[lane] = match (W::BY_AREA, W::EVEN) {
            // Only an upper bound, which saves the root; see `Finish`.
            (true, true) => (vector.x.abs() + vector.y.abs()) + vector.z.abs(),
            (true, false) => length,
            (false, _) => 1.0,
        };
        if !W::EVEN {
            let [a, b, c] = W::of_triangle(TriangleMeasures::new(length, e1, e2, p2 - p1));
            (weight0[lane], weight1[lane], weight2[lane]) = (a, b, c);
        }
    }
    for lane in 0..LANES {
        vectors[lane] = [x[lane], y[lane], z[lane], w[lane]];
    }
}
