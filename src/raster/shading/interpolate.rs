//! Values of corners spread over samples: barycentric, many at once, or by the lectures' scanline algorithm (F19).
//!
//! The scanline algorithm is that of Gouraud 1971. It uses the whole polygon, not triangles, so for four corners or
//! more the result depends on the rotation of the polygon.

use crate::num::{Arithmetic, EightLanes, Kernel, Lanes};
use crate::raster::coverage::records::Record;
use crate::raster::coverage::setup::SIDE;
use crate::raster::coverage::shown::Block;
use crate::raster::coverage::visible_triangle::{LANES, PIXELS, place};
use crate::raster::view::clip::{ClipVertex, Mix, NEAR, clip};
use crate::raster::view::fixed_point::{BITS, GUARD, ONE, snap};
use crate::raster::view::screen_transform::{Rays, View, ViewPoint};
use glam::DVec3;

/// Samples that are computed side by side.
pub(crate) const BATCH: usize = 512;

pub(crate) type Row = [f32; BATCH];

/// How the values of a triangle's corners are spread over its samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Spread {
    /// The first corner's value is the triangle's.
    Constant,
    /// Linearly on the picture.
    Affine,
    /// Linearly in the scene, seen in perspective.
    Perspective,
}

/// Spreads what the corners of triangles carry over the samples of at most [`BATCH`] / 16 blocks. Rows have 16 numbers a block, of
/// which only those of lanes that show a triangle have a meaning.
pub(crate) struct Interpolate<'a> {
    pub(crate) records: &'a [Record],
    pub(crate) blocks: &'a [Block],
    /// The record that each pixel of the tile shows.
    pub(crate) shown: &'a [u32; PIXELS],
    /// The sample of the tile's first pixel, in 256ths of a pixel of the picture.
    pub(crate) origin: [i32; 2],
    pub(crate) spread: Spread,
    pub(crate) out: &'a mut [Row; 3],
}

impl Kernel for Interpolate<'_> {
    type Output = ();

    #[inline(always)]
    fn run<A: Lanes>(self, arch: A) {
        let Self { records, blocks, shown, origin, spread, out: [xs, ys, zs] } = self;
        let rows = [xs, ys, zs].map(|row| row.as_chunks_mut::<LANES>().0.iter_mut());
        let [xs, ys, zs] = rows;
        for (((&block, xs), ys), zs) in blocks.iter().zip(xs).zip(ys).zip(zs) {
            let shown: &[u32; LANES] = shown[block.start()..].first_chunk().expect("a block");
            let corner = sample_at(origin, block.start());
            [*xs, *ys, *zs] = match spread {
                Spread::Constant => constant(records, shown),
                Spread::Affine => mean(arch, records, block, shown, corner, false),
                Spread::Perspective => mean(arch, records, block, shown, corner, true),
            };
        }
    }
}

#[inline(always)]
fn constant(records: &[Record], shown: &[u32; LANES]) -> [[f32; LANES]; 3] {
    let mut values = [[0.0; LANES]; 3];
    for lane in 0..LANES {
        // Another object's, or any for background: these lanes have no meaning.
        let record = &records[(shown[lane] as usize).min(records.len() - 1)];
        (values[0][lane], values[1][lane], values[2][lane]) = record.values[0].into();
    }
    values
}

/// Means of the corners' values, triangle by triangle: most blocks show few.
#[inline(always)]
fn mean<A: Lanes>(
    arch: A,
    records: &[Record],
    block: Block,
    shown: &[u32; LANES],
    corner: [i32; 2],
    perspective: bool,
) -> [[f32; LANES]; 3] {
    let single = arch.singles();
    let [upper, lower]: [&[u32; HALF_BLOCK]; 2] =
        [shown.first_chunk().expect("rows"), shown.last_chunk().expect("rows")];
    // A tile has too few records for their numbers to be rounded.
    let numbers = [single.load(&upper.map(|n| n as f32)), single.load(&lower.map(|n| n as f32))];
    let zero = single.splat(0.0);
    let mut values = [[zero; 2]; 3];
    let mut pending = block.lanes;
    while pending != 0 {
        let number = shown[pending.trailing_zeros() as usize % LANES];
        let its = [arch.equal_bits(upper, number), arch.equal_bits(lower, number)];
        pending &= !u16::from_le_bytes(its);
        let record = &records[number as usize];
        let weights = weights(arch, record, corner, perspective);
        let [a, b, c] =
            [record.values[0].to_array(), record.values[1].to_array(), record.values[2].to_array()];
        let number = single.splat(f64::from(number));
        for half in 0..2 {
            let distance = single.abs(single.sub(numbers[half], number));
            let its = single.less(distance, single.splat(0.5));
            let [w0, w1, w2] = weights[half];
            for component in 0..3 {
                let a = single.mul(w0, single.splat(f64::from(a[component])));
                let b = single.mul(w1, single.splat(f64::from(b[component])));
                let c = single.mul(w2, single.splat(f64::from(c[component])));
                let value = single.add(single.add(a, b), c);
                values[component][half] = single.select(its, value, values[component][half]);
            }
        }
    }
    let mut rows = [[0.0; LANES]; 3];
    for component in 0..3 {
        let (upper, lower) = rows[component].split_at_mut(HALF_BLOCK);
        upper.copy_from_slice(&single.to_array(values[component][0]));
        lower.copy_from_slice(&single.to_array(values[component][1]));
    }
    rows
}

/// The sample of a pixel of a tile, in 256ths of a pixel of the picture.
#[inline(always)]
pub(crate) fn sample_at(origin: [i32; 2], pixel: usize) -> [i32; 2] {
    let [column, row] = place(pixel).map(|n| n as i32);
    [origin[0] + (column << BITS), origin[1] + (row << BITS)]
}

/// Corners nearer than this to a block's first pixel, in 256ths of a pixel, have edge functions that are exact in single precision
/// at all its pixels: differences of coordinates are below 2¹², and products of two below 2²⁴. Nearness is between 10⁻³⁸ and 10³⁰, so
/// that its products with them and their sums neither overflow nor lose digits.
const SMALL: i32 = (1 << 12) - ((SIDE as i32 - 1) << BITS);

/// Numbers in half of a block's pixels.
type Half<L> = <L as Arithmetic>::Number;

/// Pixels of half a block.
const HALF_BLOCK: usize = LANES / 2;

/// Where the pixels of half a block are relative to its first pixel, in 256ths of a pixel.
const COLUMNS: [i32; HALF_BLOCK] = [0, ONE, 2 * ONE, 3 * ONE, 0, ONE, 2 * ONE, 3 * ONE];
const ROWS: [[i32; HALF_BLOCK]; 2] = [
    [0, 0, 0, 0, ONE, ONE, ONE, ONE],
    [2 * ONE, 2 * ONE, 2 * ONE, 2 * ONE, 3 * ONE, 3 * ONE, 3 * ONE, 3 * ONE],
];

/// The shares of a triangle's corners at the pixels of both halves of a block. They are never negative within the triangle, so that
/// values stay within the hull of the corners' values up to rounding: edge functions are exact, for small triangles in single
/// precision, for others, which have 25 bits, in double precision.
#[inline(always)]
fn weights<A: Lanes>(
    arch: A,
    record: &Record,
    [px, py]: [i32; 2],
    perspective: bool,
) -> [[Half<A::Singles>; 3]; 2] {
    let Record { x: [x0, x1, x2], y: [y0, y1, y2], .. } = *record;
    let (x, y) = ([x0 - px, x1 - px, x2 - px], [y0 - py, y1 - py, y2 - py]);
    let is_small = x.iter().chain(&y).fold(0, |most, n| n.abs().max(most)) < SMALL;
    let nearness = if perspective { record.nearness } else { [1.0; 3] };
    let single = arch.singles();
    if is_small {
        let columns = single.load(&COLUMNS.map(|n| n as f32));
        let upper = single.load(&ROWS[0].map(|n| n as f32));
        let lower = single.load(&ROWS[1].map(|n| n as f32));
        return [
            shares(single, x, y, nearness, [columns, upper]),
            shares(single, x, y, nearness, [columns, lower]),
        ];
    }
    let columns = arch.load(&COLUMNS.map(f64::from));
    let upper = shares(arch, x, y, nearness, [columns, arch.load(&ROWS[0].map(f64::from))]);
    let lower = shares(arch, x, y, nearness, [columns, arch.load(&ROWS[1].map(f64::from))]);
    let mut halves = [[single.splat(0.0); 3]; 2];
    for k in 0..3 {
        halves[0][k] = single.load(&arch.to_array(upper[k]).map(|share| share as f32));
        halves[1][k] = single.load(&arch.to_array(lower[k]).map(|share| share as f32));
    }
    halves
}

/// Edge functions times nearness, divided by their sum, for a triangle's corners relative to a block and pixels of the block.
#[inline(always)]
fn shares<L: EightLanes>(
    arch: L,
    x: [i32; 3],
    y: [i32; 3],
    nearness: [f32; 3],
    [columns, rows]: [Half<L>; 2],
) -> [Half<L>; 3] {
    let (mut xs, mut ys) = ([columns; 3], [rows; 3]);
    for k in 0..3 {
        xs[k] = arch.sub(arch.splat(f64::from(x[k])), columns);
        ys[k] = arch.sub(arch.splat(f64::from(y[k])), rows);
    }
    let mut shares = xs;
    for k in 0..3 {
        let (a, b) = ((k + 1) % 3, (k + 2) % 3);
        let edge = arch.sub(arch.mul(xs[a], ys[b]), arch.mul(xs[b], ys[a]));
        shares[k] = arch.mul(edge, arch.splat(f64::from(nearness[k])));
    }
    let sum = arch.add(arch.add(shares[0], shares[1]), shares[2]);
    let per_sum = arch.div(arch.splat(1.0), sum);
    for share in &mut shares {
        *share = arch.mul(*share, per_sum);
    }
    shares
}

/// Positions of the samples of blocks relative to the view's origin, from their depths.
pub(crate) struct Positions<'a> {
    pub(crate) rays: &'a Rays,
    pub(crate) blocks: &'a [Block],
    pub(crate) depth: &'a [f32; PIXELS],
    /// The records and which of them each pixel shows, where depth is not nearness.
    pub(crate) records: Option<(&'a [Record], &'a [u32; PIXELS])>,
    pub(crate) origin: [i32; 2],
    pub(crate) out: &'a mut [Row; 3],
}

impl Kernel for Positions<'_> {
    type Output = ();

    #[inline(always)]
    fn run<A: Lanes>(self, _: A) {
        let Self { rays, blocks, depth, records, origin, out: [xs, ys, zs] } = self;
        let (start, direction) = (rays.start.map(|v| v.to_array()), rays.direction.map(|v| v.to_array()));
        let per_pixel = 1.0 / (1 << BITS) as f32;
        let rows = [xs, ys, zs].map(|row| row.as_chunks_mut::<LANES>().0.iter_mut());
        let [xs, ys, zs] = rows;
        for (((block, xs), ys), zs) in blocks.iter().zip(xs).zip(ys).zip(zs) {
            let depth: &[f32; LANES] = depth[block.start()..].first_chunk().expect("a block");
            let [px, py] = sample_at(origin, block.start());
            let mut nearness = *depth;
            if let Some((records, shown)) = records {
                for lane in block.shown() {
                    let record = &records[shown[block.start() + lane] as usize];
                    nearness[lane] = record.nearness_at(sample_at(origin, block.start() + lane));
                }
            }
            for lane in 0..LANES {
                let (dx, dy) = ((lane % SIDE) as i32 * ONE, (lane / SIDE) as i32 * ONE);
                let (x, y) = ((px + dx) as f32 * per_pixel, (py + dy) as f32 * per_pixel);
                let distance = rays.distance(depth[lane], nearness[lane]);
                let at = |v: &[[f32; 3]; 3], axis: usize| v[0][axis] + (v[1][axis] * x + v[2][axis] * y);
                xs[lane] = at(&start, 0) + at(&direction, 0) * distance;
                ys[lane] = at(&start, 1) + at(&direction, 1) * distance;
                zs[lane] = at(&start, 2) + at(&direction, 2) * distance;
            }
        }
    }
}

/// Gives lanes that do not show the object the numbers of the first that does, so that they cause no error.
pub(crate) fn fill_lanes(blocks: &[Block], rows: &mut [Row; 3]) {
    for (at, block) in blocks.iter().enumerate().filter(|(_, block)| !block.is_full()) {
        for row in rows.iter_mut() {
            for lane in 0..LANES {
                row[at * LANES + lane] = row[at * LANES + block.lane_or_first(lane)];
            }
        }
    }
}

impl Mix for DVec3 {
    fn mix(self, other: Self, [of_self, of_other]: [f64; 2], _: [f64; 2]) -> Self {
        self * of_self + other * of_other
    }
}

/// A polygon on the picture with a value at each corner.
#[derive(Clone, Debug, Default)]
pub(crate) struct ScanPolygon {
    corners: Vec<([f64; 2], DVec3)>,
}

#[derive(Clone, Copy)]
struct Crossing {
    x: f64,
    value: DVec3,
}

impl ScanPolygon {
    /// Clips a polygon to the near plane and places it on the picture, snapped like everything that covers pixels.
    pub(crate) fn new(view: &View, corners: impl Iterator<Item = (ViewPoint, DVec3)>) -> Self {
        // Out of the guard band there is no grid and no need of one.
        let reach = f64::from(2 * GUARD);
        let on_grid =
            |place: f64| if place.abs() < reach { f64::from(snap(place)) / f64::from(ONE) } else { place };
        let mut polygon = Self::unsnapped(view, corners);
        for (place, _) in &mut polygon.corners {
            *place = place.map(on_grid);
        }
        polygon
    }

    /// The same without snapping.
    pub(crate) fn unsnapped(view: &View, corners: impl Iterator<Item = (ViewPoint, DVec3)>) -> Self {
        let mut polygon: Vec<_> = corners.map(|(point, attribute)| ClipVertex { point, attribute }).collect();
        clip(view, 1 << NEAR, &mut polygon, &mut Vec::new());
        Self { corners: polygon.iter().map(|v| (view.on_picture(v.point), v.attribute)).collect() }
    }

    /// The value at a place of the picture.
    ///
    /// Edges are half-open in y, so that a scanline through a corner crosses an even number of edges; level edges are
    /// skipped. Of the spans between pairs of crossings the one that holds the place counts; if rounding excludes the
    /// place from all of them, the nearest one.
    pub(crate) fn value(&self, [x, y]: [f64; 2]) -> DVec3 {
        let next = self.corners.iter().cycle().skip(1);
        let mut crossings: Vec<Crossing> = self
            .corners
            .iter()
            .zip(next)
            .filter(|((a, _), (b, _))| (a[1] <= y) != (b[1] <= y))
            .map(|(&(a, value_a), &(b, value_b))| {
                let t = (y - a[1]) / (b[1] - a[1]);
                Crossing { x: a[0] + (b[0] - a[0]) * t, value: value_a + (value_b - value_a) * t }
            })
            .collect();
        crossings.sort_by(|a, b| a.x.total_cmp(&b.x));
        let outside = |span: &&[Crossing]| (span[0].x - x).max(x - span[1].x).max(0.0);
        let spans = crossings.chunks_exact(2);
        match spans.min_by(|a, b| outside(a).total_cmp(&outside(b))) {
            Some([left, right]) if right.x > left.x => {
                let t = ((x - left.x) / (right.x - left.x)).clamp(0.0, 1.0);
                left.value + (right.value - left.value) * t
            }
            Some(span) => span[0].value,
            // A polygon that covers the place only as its triangles do, not as a polygon: it crosses itself.
            None => self.nearest([x, y]),
        }
    }

    fn nearest(&self, [x, y]: [f64; 2]) -> DVec3 {
        let distance = |&&([a, b], _): &&([f64; 2], DVec3)| (a - x) * (a - x) + (b - y) * (b - y);
        let nearest = self.corners.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
        nearest.map_or(DVec3::ZERO, |&(_, value)| value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num;
    use crate::num::test_numbers::Numbers;

    fn polygon(corners: &[([f64; 2], [f64; 3])]) -> ScanPolygon {
        ScanPolygon { corners: corners.iter().map(|&(place, value)| (place, value.into())).collect() }
    }

    fn diamond(degrees: f64) -> ScanPolygon {
        // Exercise 1.6.25: v1 and v3 on the scanline through the centre, v2 and v4 on the vertical.
        let colours = [[0.0, 0.4, 0.4], [0.0, 0.2, 0.2], [0.2, 0.6, 0.6], [0.4, 0.4, 0.0]];
        let corner = |k: usize| {
            let turn = (degrees + 90.0 * k as f64).to_radians();
            ([10.0 * libm::cos(turn), 10.0 * libm::sin(turn)], colours[k])
        };
        polygon(&[0, 1, 2, 3].map(corner))
    }

    /// The shares at the pixels of a block, in both precisions.
    struct BothShares<'a>(&'a Record, [i32; 2]);

    impl Kernel for BothShares<'_> {
        type Output = [[f64; 3]; LANES];

        fn run<A: Lanes>(self, arch: A) -> [[f64; 3]; LANES] {
            let Self(record, corner) = self;
            let single = arch.singles();
            let halves =
                weights(arch, record, corner, true).map(|half| half.map(|share| single.to_array(share)));
            std::array::from_fn(|lane| {
                let share = |k: usize| f64::from(halves[lane / HALF_BLOCK][k][lane % HALF_BLOCK]);
                [share(0), share(1), share(2)]
            })
        }
    }

    /// Triangles from under a pixel to a thousand pixels, against edge functions in whole numbers of 128 bits. Of five roundings in
    /// single precision each is 6e-8 of a share at most.
    #[test]
    fn shares_are_right_in_single_and_double_precision() {
        let mut numbers = Numbers::new(17);
        let mut inside = [0; 2];
        for round in 0..3000 {
            let size = [100, 900, 3000, 200_000][round % 4];
            // From the least to the largest nearness that a view has.
            let unit = [1.0, 2e-37, 9e29][round % 3];
            let at = [0; 2].map(|_| numbers.below(1 << 20) as i32);
            let mut place = || [0; 2].map(|_| numbers.below(2 * size) as i32 - size as i32);
            let corners = [place(), place(), place()];
            let record = Record {
                x: corners.map(|[x, _]| at[0] + x),
                y: corners.map(|[_, y]| at[1] + y),
                nearness: [0; 3].map(|_| (0.1 + numbers.unit() as f32) * unit),
                ..Record::default()
            };
            let found = num::dispatch(BothShares(&record, at));
            for (lane, found) in found.into_iter().enumerate() {
                let [px, py] = [(lane % SIDE) as i32 * ONE, (lane / SIDE) as i32 * ONE];
                let edge = |a: usize, b: usize| {
                    let [x, y] =
                        [0, 1].map(|axis| [a, b].map(|k| i128::from(corners[k][axis] - [px, py][axis])));
                    x[0] * y[1] - x[1] * y[0]
                };
                let edges = [edge(1, 2), edge(2, 0), edge(0, 1)];
                if edges.iter().any(|&e| e < 0) && edges.iter().any(|&e| e > 0) || edges == [0; 3] {
                    continue;
                }
                inside[usize::from(size > 3000)] += 1;
                let parts = [0, 1, 2].map(|k| edges[k] as f64 * f64::from(record.nearness[k]));
                let sum: f64 = parts.iter().sum();
                for k in 0..3 {
                    let expected = parts[k] / sum;
                    assert!(found[k] >= 0.0 && (found[k] - expected).abs() <= 3e-7 * expected, "{record:?}");
                }
            }
        }
        assert!(inside.iter().all(|&inside| inside > 1000), "{inside:?}");
    }

    /// Rows of a full block, one of two lanes, and no block.
    #[test]
    fn lanes_of_other_objects_take_the_first_that_counts() {
        let blocks = [Block { number: 3, lanes: u16::MAX }, Block { number: 9, lanes: 0b1000_0010_0000 }];
        let mut rows = [0.0, 100.0, 200.0].map(|from| std::array::from_fn(|at| from + at as f32));
        fill_lanes(&blocks, &mut rows);
        for (row, from) in rows.iter().zip([0.0, 100.0, 200.0]) {
            for (at, &found) in row.iter().enumerate() {
                // The second block's lanes are 16 to 31 of the row, of which 21 and 27 show the object.
                let expected = if (16..32).contains(&at) && at != 27 { 21 } else { at };
                assert_eq!(found, from + expected as f32, "{at}");
            }
        }
    }

    /// The closed form of reference §4.1, and the two printed values.
    #[test]
    fn the_diamond_turns_its_centre() {
        for step in 0..=18 {
            let degrees = 5.0 * f64::from(step);
            let (sin, cos) = libm::sincos(degrees.to_radians());
            let (c13, c24) = (DVec3::new(0.2, 1.0, 1.0) * 0.5, DVec3::new(0.4, 0.6, 0.2) * 0.5);
            let expected = (c13 * cos + c24 * sin) / (cos + sin);
            let got = diamond(degrees).value([0.0, 0.0]);
            assert!(got.distance(expected) < 1e-14, "{degrees}: {got} is not {expected}");
        }
        assert!(diamond(0.0).value([0.0, 0.0]).distance(DVec3::new(0.1, 0.5, 0.5)) < 1e-15);
        assert!(diamond(90.0).value([0.0, 0.0]).distance(DVec3::new(0.2, 0.3, 0.1)) < 1e-15);
    }

    /// Exercise 1.6.24 with a triangle that fits its figure: in triangles it is barycentric.
    #[test]
    fn triangles_are_barycentric() {
        let triangle = polygon(&[
            ([2.0, 1.0], [1.0, 0.0, 0.8]),
            ([6.0, 5.0], [0.6, 0.4, 0.8]),
            ([10.0, 1.0], [0.2, 0.8, 0.0]),
        ]);
        assert!(triangle.value([6.0, 3.0]).distance(DVec3::new(0.6, 0.4, 0.6)) < 1e-15);
    }

    #[test]
    fn level_edges_corners_and_dents_are_handled() {
        let value = |place: [f64; 2]| [place[0], place[1], 0.0];
        // A U: linear in the corners' places, so linear everywhere.
        let places =
            [[0.0, 0.0], [6.0, 0.0], [6.0, 4.0], [4.0, 4.0], [4.0, 2.0], [2.0, 2.0], [2.0, 4.0], [0.0, 4.0]];
        let dented = polygon(&places.map(|place| (place, value(place))));
        for [x, y] in [[1.0, 3.0], [5.0, 3.0], [3.0, 1.0], [1.0, 2.0], [0.0, 0.0], [5.5, 3.999]] {
            assert!(dented.value([x, y]).distance(DVec3::new(x, y, 0.0)) < 1e-14, "{x} {y}");
        }
        // Below the last scanline nothing crosses.
        assert_eq!(dented.value([5.9, 4.0]), DVec3::new(6.0, 4.0, 0.0));
    }
}
