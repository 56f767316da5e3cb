//! Values of corners spread over samples, many at once.

use crate::num::{Kernel, Lanes};
use crate::raster::coverage::records::{Record, parts};
use crate::raster::coverage::visible_triangle::place;
use crate::raster::view::fixed_point::BITS;
use crate::raster::view::screen_transform::Rays;

/// Samples that are computed side by side.
pub(crate) const BATCH: usize = 512;

/// One value of each sample.
pub(crate) type Row = [f32; BATCH];

/// A sample that is seen: the pixel's number in its tile, and the triangle there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct VisibleSample {
    pub(crate) pixel: u16,
    pub(crate) record: u32,
}

/// Interpolates what the corners of triangles carry, for at most [`BATCH`] samples.
pub(crate) struct Interpolate<'a> {
    pub(crate) records: &'a [Record],
    pub(crate) seen: &'a [VisibleSample],
    /// The sample of the tile's first pixel, in 256ths of a pixel of the picture.
    pub(crate) origin: [i32; 2],
    /// Weigh by nearness.
    pub(crate) perspective: bool,
    pub(crate) out: &'a mut [Row; 3],
}

/// Samples gathered before anything is computed.
const LANES: usize = 64;

impl Kernel for Interpolate<'_> {
    type Output = ();

    /// Edge functions in doubles are exact: coordinates have 25 bits. So weights are never negative, and values stay
    /// within the hull of those at the corners up to rounding.
    #[inline(always)]
    fn run<A: Lanes>(self, _: A) {
        let Self { records, seen, origin, perspective, out } = self;
        let mut x = [[0_i32; LANES]; 3];
        let mut y = [[0_i32; LANES]; 3];
        let mut nearness = [[0.0_f32; LANES]; 3];
        let mut values = [[[0.0_f32; LANES]; 3]; 3];
        for (block, seen) in seen.chunks(LANES).enumerate() {
            for (lane, seen) in seen.iter().enumerate().take(LANES) {
                let record = &records[seen.record as usize];
                let [column, row] = place(usize::from(seen.pixel)).map(|n| n as i32);
                let [px, py] = [origin[0] + (column << BITS), origin[1] + (row << BITS)];
                for k in 0..3 {
                    x[k][lane] = record.x[k] - px;
                    y[k][lane] = record.y[k] - py;
                    nearness[k][lane] = record.nearness[k];
                    let value = record.values[k];
                    (values[k][0][lane], values[k][1][lane], values[k][2][lane]) =
                        (value.x, value.y, value.z);
                }
            }
            let mut weights = [[0.0_f32; LANES]; 3];
            for lane in 0..LANES {
                let [mut w0, mut w1, mut w2] =
                    parts([x[0][lane], x[1][lane], x[2][lane]], [y[0][lane], y[1][lane], y[2][lane]]);
                if perspective {
                    w0 *= f64::from(nearness[0][lane]);
                    w1 *= f64::from(nearness[1][lane]);
                    w2 *= f64::from(nearness[2][lane]);
                }
                let per_sum = 1.0 / ((w0 + w1) + w2);
                weights[0][lane] = (w0 * per_sum) as f32;
                weights[1][lane] = (w1 * per_sum) as f32;
                weights[2][lane] = (w2 * per_sum) as f32;
            }
            let count = seen.len();
            for (component, out) in out.iter_mut().enumerate() {
                let mut row = [0.0; LANES];
                for lane in 0..LANES {
                    row[lane] = (weights[0][lane] * values[0][component][lane]
                        + weights[1][lane] * values[1][component][lane])
                        + weights[2][lane] * values[2][component][lane];
                }
                out[block * LANES..][..count].copy_from_slice(&row[..count]);
            }
        }
    }
}

/// Positions of samples relative to the view's origin, from their depths.
pub(crate) struct Positions<'a> {
    pub(crate) rays: &'a Rays,
    pub(crate) seen: &'a [VisibleSample],
    pub(crate) depth: &'a [f32],
    /// What is seen, where depth is not nearness.
    pub(crate) records: Option<&'a [Record]>,
    pub(crate) origin: [i32; 2],
    pub(crate) out: &'a mut [Row; 3],
}

impl Kernel for Positions<'_> {
    type Output = ();

    #[inline(always)]
    fn run<A: Lanes>(self, _: A) {
        let Self { rays, seen, depth, records, origin, out } = self;
        let mut rows = [[0.0_f32; BATCH]; 4];
        let [xs, ys, depths, nearness] = &mut rows;
        for (lane, seen) in seen.iter().enumerate().take(BATCH) {
            let [column, row] = place(usize::from(seen.pixel)).map(|n| n as i32);
            let at = [origin[0] + (column << BITS), origin[1] + (row << BITS)];
            [xs[lane], ys[lane]] = at.map(|n| n as f32);
            depths[lane] = depth[usize::from(seen.pixel)];
            nearness[lane] = match records {
                None => depths[lane],
                Some(records) => records[seen.record as usize].nearness_at(at),
            };
        }
        let (start, direction) = (rays.start.map(|v| v.to_array()), rays.direction.map(|v| v.to_array()));
        let per_pixel = 1.0 / (1 << BITS) as f32;
        let count = seen.len().min(BATCH);
        for (axis, out) in out.iter_mut().enumerate() {
            for lane in 0..count {
                let (x, y) = (xs[lane] * per_pixel, ys[lane] * per_pixel);
                let at = |v: &[[f32; 3]; 3]| v[0][axis] + (v[1][axis] * x + v[2][axis] * y);
                out[lane] = at(&start) + at(&direction) * rays.distance(depths[lane], nearness[lane]);
            }
        }
    }
}
