//! Values of corners spread over samples by barycentric coordinates, many at once.

use crate::num::{Arithmetic, EightLanes, Kernel, Lanes, Scalars};
use crate::raster::coverage::records::{Record, RecordCorners};
use crate::raster::coverage::setup::SIDE;
use crate::raster::coverage::shown::Block;
use crate::raster::coverage::visible_triangle::{LANES, PIXELS, place};
use crate::raster::view::fixed_point::{BITS, ONE};
use crate::raster::view::screen_transform::Rays;

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
        (values[0][lane], values[1][lane], values[2][lane]) = record.corners.values[0].into();
    }
    values
}

/// Means of the corners' values: pixel by pixel in blocks that show many triangles, which all are small; else triangle by triangle.
#[inline(always)]
fn mean<A: Lanes>(
    arch: A,
    records: &[Record],
    block: Block,
    shown: &[u32; LANES],
    corner: [i32; 2],
    perspective: bool,
) -> [[f32; LANES]; 3] {
    let on_diagonal = [shown[0], shown[5], shown[10], shown[15]];
    let are_many = (1..4).all(|at| !on_diagonal[..at].contains(&on_diagonal[at]));
    let by_pixel = match are_many {
        true => mean_by_pixel(arch, records, block, shown, corner, perspective),
        false => None,
    };
    match by_pixel {
        Some(values) => values,
        None => mean_by_triangle(arch, records, block, shown, corner, perspective),
    }
}

#[inline(always)]
fn mean_by_triangle<A: Lanes>(
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
        let [a, b, c] = record.corners.values;
        let [a, b, c] = [a.to_array(), b.to_array(), c.to_array()];
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

/// The bits of [`mean_by_triangle`], eight pixels at a time: faster for four triangles or more. `None` unless all are small.
#[inline(always)]
fn mean_by_pixel<A: Lanes>(
    arch: A,
    records: &[Record],
    block: Block,
    shown: &[u32; LANES],
    [px, py]: [i32; 2],
    perspective: bool,
) -> Option<[[f32; LANES]; 3]> {
    let single = arch.singles();
    let scalars = |value| Scalars::new(single, value);
    let (px, py) = (single.splat(f64::from(px)), single.splat(f64::from(py)));
    let columns = single.load(&COLUMNS.map(|n| n as f32));
    let mut values = [[0.0; LANES]; 3];
    for (half, rows) in ROWS.iter().enumerate() {
        let mut corners = [&records[0].corners; HALF_BLOCK];
        for (lane, corners) in corners.iter_mut().enumerate() {
            let lane = block.lane_or_first(half * HALF_BLOCK + lane);
            *corners = &records[shown[lane] as usize].corners;
        }
        let [mut xs, mut ys, mut nearness, a, b, c] = corner_lanes(single, &corners);
        let mut farthest = scalars(single.splat(0.0));
        for k in 0..3 {
            (xs[k], ys[k]) = (single.sub(xs[k], px), single.sub(ys[k], py));
            farthest = farthest.max(scalars(xs[k]).abs()).max(scalars(ys[k]).abs());
        }
        if farthest.less(Scalars::splat(single, f64::from(SMALL))).row_bits() != u8::MAX {
            return None;
        }
        if !perspective {
            nearness = [single.splat(1.0); 3];
        }
        let rows = single.load(&rows.map(|n| n as f32));
        let [w0, w1, w2] = shares(single, [xs, ys, nearness], [columns, rows]);
        for component in 0..3 {
            let (a, b, c) = (a[component], b[component], c[component]);
            let sum = single.add(single.mul(w0, a), single.mul(w1, b));
            let sum = single.add(sum, single.mul(w2, c));
            values[component][half * HALF_BLOCK..][..HALF_BLOCK].copy_from_slice(&single.to_array(sum));
        }
    }
    Some(values)
}

/// The x, y and nearness of the corners of eight triangles, and the values at each corner, a lane for each triangle.
#[inline(always)]
fn corner_lanes<L: EightLanes<Element = f32>>(
    arch: L,
    corners: &[&RecordCorners; HALF_BLOCK],
) -> [[Half<L>; 3]; 6] {
    let [x0, x1, x2, y0] = four_columns(arch, corners, 0);
    let [y1, y2, n0, n1] = four_columns(arch, corners, 4);
    let [n2, a0, a1, a2] = four_columns(arch, corners, 8);
    let [b0, b1, b2, c0] = four_columns(arch, corners, 12);
    let [_, _, c1, c2] = four_columns(arch, corners, 14);
    [[x0, x1, x2], [y0, y1, y2], [n0, n1, n2], [a0, a1, a2], [b0, b1, b2], [c0, c1, c2]]
}

/// Four of the 18 numbers of eight triangles, from one on.
#[inline(always)]
fn four_columns<L: EightLanes<Element = f32>>(
    arch: L,
    [a, b, c, d, e, f, g, h]: &[&RecordCorners; HALF_BLOCK],
    from: usize,
) -> [Half<L>; 4] {
    let row = |corners| -> &[f32; 4] {
        let numbers: &[f32; 18] = bytemuck::cast_ref(corners);
        numbers[from..].first_chunk().expect("four numbers")
    };
    arch.columns([row(*a), row(*b), row(*c), row(*d), row(*e), row(*f), row(*g), row(*h)])
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
const SMALL: f32 = ((1 << 12) - ((SIDE as i32 - 1) << BITS)) as f32;

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
    let RecordCorners { x: [x0, x1, x2], y: [y0, y1, y2], nearness, .. } = record.corners;
    // Whole numbers of 24 bits: exact.
    let (px, py) = (px as f32, py as f32);
    let (x, y) = ([x0 - px, x1 - px, x2 - px], [y0 - py, y1 - py, y2 - py]);
    let is_small = x.iter().chain(&y).fold(0.0, |most, n| n.abs().max(most)) < SMALL;
    let corners = [x, y, if perspective { nearness } else { [1.0; 3] }];
    let single = arch.singles();
    if is_small {
        let columns = single.load(&COLUMNS.map(|n| n as f32));
        let upper = single.load(&ROWS[0].map(|n| n as f32));
        let lower = single.load(&ROWS[1].map(|n| n as f32));
        return [
            shares(single, splat(single, corners), [columns, upper]),
            shares(single, splat(single, corners), [columns, lower]),
        ];
    }
    let columns = arch.load(&COLUMNS.map(f64::from));
    let upper = shares(arch, splat(arch, corners), [columns, arch.load(&ROWS[0].map(f64::from))]);
    let lower = shares(arch, splat(arch, corners), [columns, arch.load(&ROWS[1].map(f64::from))]);
    let mut halves = [[single.splat(0.0); 3]; 2];
    for k in 0..3 {
        halves[0][k] = single.load(&arch.to_array(upper[k]).map(|share| share as f32));
        halves[1][k] = single.load(&arch.to_array(lower[k]).map(|share| share as f32));
    }
    halves
}

/// The same numbers in all lanes: x, y and nearness of a triangle's corners.
#[inline(always)]
fn splat<L: EightLanes>(arch: L, corners: [[f32; 3]; 3]) -> [[Half<L>; 3]; 3] {
    let mut lanes = [[arch.splat(0.0); 3]; 3];
    for (lanes, numbers) in lanes.iter_mut().zip(corners) {
        for (lanes, number) in lanes.iter_mut().zip(numbers) {
            *lanes = arch.splat(f64::from(number));
        }
    }
    lanes
}

/// Edge functions times nearness, divided by their sum, at pixels of a block. The x and y of the corners are relative to the block.
#[inline(always)]
fn shares<L: EightLanes>(
    arch: L,
    [mut xs, mut ys, nearness]: [[Half<L>; 3]; 3],
    [columns, rows]: [Half<L>; 2],
) -> [Half<L>; 3] {
    for k in 0..3 {
        xs[k] = arch.sub(xs[k], columns);
        ys[k] = arch.sub(ys[k], rows);
    }
    let mut shares = xs;
    for k in 0..3 {
        let (a, b) = ((k + 1) % 3, (k + 2) % 3);
        let edge = arch.sub(arch.mul(xs[a], ys[b]), arch.mul(xs[b], ys[a]));
        shares[k] = arch.mul(edge, nearness[k]);
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num;
    use crate::num::test_numbers::Numbers;
    use crate::raster::coverage::visible_triangle::NOTHING;

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
            let corners_on_picture = RecordCorners {
                x: corners.map(|[x, _]| (at[0] + x) as f32),
                y: corners.map(|[_, y]| (at[1] + y) as f32),
                nearness: [0; 3].map(|_| (0.1 + numbers.unit() as f32) * unit),
                values: Default::default(),
            };
            let record = Record { corners: corners_on_picture, ..Record::default() };
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
                let parts = [0, 1, 2].map(|k| edges[k] as f64 * f64::from(record.corners.nearness[k]));
                let sum: f64 = parts.iter().sum();
                for k in 0..3 {
                    let expected = parts[k] / sum;
                    assert!(found[k] >= 0.0 && (found[k] - expected).abs() <= 3e-7 * expected, "{record:?}");
                }
            }
        }
        assert!(inside.iter().all(|&inside| inside > 1000), "{inside:?}");
    }

    /// Means of values by triangle and by pixel.
    struct BothMeans<'a>(&'a [Record], Block, &'a [u32; LANES], [i32; 2], bool);

    impl Kernel for BothMeans<'_> {
        type Output = [Option<[[f32; LANES]; 3]>; 2];

        fn run<A: Lanes>(self, arch: A) -> [Option<[[f32; LANES]; 3]>; 2] {
            let Self(records, block, shown, corner, perspective) = self;
            let by_triangle = mean_by_triangle(arch, records, block, shown, corner, perspective);
            [Some(by_triangle), mean_by_pixel(arch, records, block, shown, corner, perspective)]
        }
    }

    #[test]
    fn means_by_pixel_have_the_bits_of_means_by_triangle() {
        let mut numbers = Numbers::new(18);
        let (mut compared, mut declined) = (0, 0);
        for round in 0..3000 {
            let at = [0; 2].map(|_| numbers.below(1 << 22) as i32 & !0xff);
            let size = [600, 3000, 5000][round % 3];
            let mut place =
                |at: i32| [0; 3].map(|_| (at + numbers.below(2 * size) as i32 - size as i32) as f32);
            let mut records: Vec<Record> = (0..9)
                .map(|_| RecordCorners { x: place(at[0]), y: place(at[1]), ..RecordCorners::default() })
                .map(|corners| Record { corners, ..Record::default() })
                .collect();
            for RecordCorners { nearness, values, .. } in records.iter_mut().map(|it| &mut it.corners) {
                *nearness = [0; 3].map(|_| 0.1 + numbers.unit() as f32);
                *values = [0; 3].map(|_| [0; 3].map(|_| numbers.unit() as f32 - 0.5).into());
            }
            let lanes = [u16::MAX, numbers.below(65_535) as u16 + 1][round % 2];
            let shown = std::array::from_fn(|lane| match lanes >> lane & 1 {
                0 => NOTHING,
                _ => numbers.below(records.len()) as u32,
            });
            let block = Block { number: 0, lanes };
            let found = num::dispatch(BothMeans(&records, block, &shown, at, round % 4 < 2));
            let [Some(by_triangle), Some(by_pixel)] = found else {
                declined += 1;
                continue;
            };
            for lane in block.shown() {
                let bits = |rows: [[f32; LANES]; 3]| rows.map(|row| row[lane].to_bits());
                assert_eq!(bits(by_pixel), bits(by_triangle), "{round} {lane}");
                compared += 1;
            }
        }
        assert!(compared > 10_000 && declined > 500, "{compared} {declined}");
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
}
