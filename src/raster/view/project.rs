//! Vertices on the picture.

use crate::mesh::PositionsRef;
use crate::num::parallel;
use crate::num::{self, Kernel, Lanes};
use crate::raster::view::fixed_point::{GUARD, snap};
use crate::raster::view::screen_transform::{ObjectMap, View};
use glam::DVec3;

/// A vertex as the rasterizer sees it: 16 bytes, a row of four numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub(crate) struct ScreenVertex {
    /// In 256ths of a pixel from the upper left corner; see [`fixed`](crate::raster::view::fixed_point).
    pub(crate) x: i32,
    pub(crate) y: i32,
    /// Larger is nearer; see [`View::depth`].
    pub(crate) depth: f32,
    /// Which clipping planes the vertex is outside of, one bit each; the rest is only valid if none is set.
    pub(crate) outside: u32,
}

/// The bit of a vertex whose place on the picture overflows.
pub(crate) const NOT_FINITE: u32 = 1 << 5;

/// Positions or normals to read, in either precision.
pub(crate) type Points<'a> = PositionsRef<'a>;

/// Vertices that one task projects.
const TASK: usize = 8192;

/// Projects and snaps all vertices, in place of those in the list; returns the planes that any of them is outside of.
pub(crate) fn project(points: Points, map: &ObjectMap, view: &View, vertices: &mut Vec<ScreenVertex>) -> u32 {
    vertices.resize(points.len(), ScreenVertex::default());
    match points {
        Points::F64(points) => project_all(points, map, view, vertices),
        Points::F32(points) => project_all(points, map, view, vertices),
    }
}

fn project_all<T: Point>(points: &[T], map: &ObjectMap, view: &View, vertices: &mut [ScreenVertex]) -> u32 {
    let outside = parallel::map_chunks(vertices, TASK, |task, out| {
        let points = &points[task * TASK..][..out.len()];
        num::dispatch(Project { points, map, view, out })
    });
    outside.into_iter().fold(0, |a, b| a | b)
}

const LANES: usize = 32;

trait Point: Copy + Sync {
    fn wide(self) -> [f64; 3];
}

impl Point for DVec3 {
    #[inline(always)]
    fn wide(self) -> [f64; 3] {
        self.to_array()
    }
}

impl Point for [f32; 3] {
    #[inline(always)]
    fn wide(self) -> [f64; 3] {
        self.map(f64::from)
    }
}

struct Project<'a, T> {
    points: &'a [T],
    map: &'a ObjectMap,
    view: &'a View,
    out: &'a mut [ScreenVertex],
}

impl<T: Point> Kernel for Project<'_, T> {
    type Output = u32;

    #[inline(always)]
    fn run<A: Lanes>(self, _: A) -> u32 {
        let Self { points, map, view, out } = self;
        let mut outside = 0;
        let mut rows = [[0.0; LANES]; 3];
        for (points, out) in points.chunks(LANES).zip(out.chunks_mut(LANES)) {
            for (lane, point) in points.iter().enumerate().take(LANES) {
                let [x, y, z] = point.wide();
                (rows[0][lane], rows[1][lane], rows[2][lane]) = (x, y, z);
            }
            let mut block = [ScreenVertex::default(); LANES];
            for lane in 0..LANES {
                let point = DVec3::new(rows[0][lane], rows[1][lane], rows[2][lane]);
                block[lane] = screen_vertex(map, view, point);
            }
            out.copy_from_slice(&block[..out.len()]);
            outside = out.iter().fold(outside, |outside, vertex| outside | vertex.outside);
        }
        outside
    }
}

#[inline(always)]
fn screen_vertex(map: &ObjectMap, view: &View, point: DVec3) -> ScreenVertex {
    let seen = map.view(point);
    let guard = f64::from(GUARD) * seen.h;
    let bit = |outside: bool, bit: u32| u32::from(outside) << bit;
    let size = (seen.x.abs() + seen.y.abs()) + (seen.z.abs() + guard.abs());
    let outside = bit(seen.z < view.near, 0)
        | bit(seen.x < -guard, 1)
        | bit(seen.x > guard, 2)
        | bit(seen.y < -guard, 3)
        | bit(seen.y > guard, 4)
        | if size < f64::INFINITY { 0 } else { NOT_FINITE };
    let [x, y] = view.on_picture(seen);
    ScreenVertex { x: snap(x), y: snap(y), depth: view.depth(seen.z) as f32, outside }
}
