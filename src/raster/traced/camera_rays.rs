//! Rays of the camera: the first hits of a tile, and the light from there.

use super::bundle::{BUNDLE, first_node};
use super::hit::SurfaceHit;
use super::lamp::move_of_pixel;
use super::ray_tree::RayNode;
use super::traverse::{Stack, TriangleHit, WIDENED, nearest};
use super::whitted::Tracer;
use super::world::{FrameRay, Met, TracedScene, World};
use crate::num::{self, Kernel, Lanes, Scalars};
use crate::raster::coverage::visible_triangle::{PIXELS, place};
use crate::raster::error::Result;
use crate::raster::frame::job::Job;
use crate::raster::settings::Cull;
use crate::raster::view::fixed_point::ONE;
use glam::Vec3;

/// Traces tiles, and keeps its memory in between.
#[derive(Default)]
pub(crate) struct TileTracer {
    stack: Stack,
    pixels: Vec<(usize, [i32; 2])>,
    rays: Vec<FrameRay>,
    hits: Vec<Option<(f64, TriangleHit)>>,
    /// Rays of all kinds so far.
    pub(crate) count: u64,
    /// The sum of the shares of light that limits cut off, by sample.
    pub(crate) cut: f64,
}

/// Rays that are followed to their first triangle before any is shaded.
const BATCH: usize = 256;

/// The ray of a place on the picture from the near plane on.
fn camera_ray(job: &Job, at: [f64; 2]) -> FrameRay {
    let (start, direction) = job.view.ray(at);
    let origin = (job.view.eye - job.view.origin) + (start + direction * job.view.near);
    FrameRay { origin: origin / job.frame.unit, direction: direction.normalize(), reach: f64::INFINITY }
}

/// What the camera sees at a place on the picture, and the distance along its axis.
pub(crate) fn first_hit(job: &Job, scene: &TracedScene, at: [f64; 2]) -> Option<(FrameRay, SurfaceHit, f64)> {
    let ray = camera_ray(job, at);
    let cull = job.settings.cull;
    let triangles = |hit: &TriangleHit| is_kept(job, cull, &ray, hit);
    let solids = |_, front| cull.keeps(front);
    let (distance, met) = scene.world.nearest(&ray, &mut Stack::new(), triangles, &solids)?;
    let hit = SurfaceHit::new(job, ray.direction, distance, &met);
    let along = job.view.near + distance * job.frame.unit * ray.direction.dot(job.view.axes[2]);
    Some((ray, hit, along))
}

/// The tree of rays of what the camera sees at a sample, given in 256ths of a pixel.
pub(crate) fn ray_tree(
    job: &Job,
    scene: &TracedScene,
    (ray, hit): (FrameRay, &SurfaceHit),
    sample: [i32; 2],
) -> Result<RayNode> {
    let mut node = RayNode { kind: "camera", share: [1.0; 3], ..RayNode::default() };
    let mut tracer = Tracer::new(job, scene, Stack::new());
    tracer.sample(ray, hit, move_of_pixel(sample.map(|n| n as u32)), Some(&mut node))?;
    Ok(node)
}

/// Whether the camera sees a triangle from a side that is drawn.
fn is_kept(job: &Job, cull: Cull, ray: &FrameRay, hit: &TriangleHit) -> bool {
    cull == Cull::None || {
        let met = Met::Triangle(*hit);
        cull.keeps(SurfaceHit::new(job, ray.direction, f64::from(hit.distance), &met).front)
    }
}

impl TileTracer {
    /// Traces the samples of a tile, the first one at `origin` in 256ths of a pixel; hands over the covered pixels with their
    /// objects and colours.
    pub(crate) fn trace(
        &mut self,
        job: &Job,
        scene: &TracedScene,
        origin: [i32; 2],
        mut take: impl FnMut(usize, usize, Vec3),
    ) -> Result<()> {
        let [width, height] = job.view.size.map(|n| n as i32 * ONE);
        let cull = job.settings.cull;
        let mut tracer = Tracer::new(job, scene, std::mem::take(&mut self.stack));
        for first in (0..PIXELS).step_by(BATCH) {
            self.pixels.clear();
            self.rays.clear();
            for pixel in first..(first + BATCH).min(PIXELS) {
                let [column, row] = place(pixel).map(|n| n as i32 * ONE);
                let sample = [origin[0] + column, origin[1] + row];
                if sample[0] < width && sample[1] < height {
                    self.pixels.push((pixel, sample));
                    self.rays.push(camera_ray(job, sample.map(|n| f64::from(n) / f64::from(ONE))));
                }
            }
            self.hits.clear();
            num::dispatch(FirstHits {
                world: &scene.world,
                rays: &self.rays,
                hits: &mut self.hits,
                stack: &mut tracer.stack,
                counts: |ray: &FrameRay, hit: &TriangleHit| is_kept(job, cull, ray, hit),
            });
            for ((&(pixel, sample), ray), &triangle) in self.pixels.iter().zip(&self.rays).zip(&self.hits) {
                let met = scene.world.with_solids(ray, triangle, &|_, front| cull.keeps(front));
                let Some((distance, met)) = met else { continue };
                let hit = SurfaceHit::new(job, ray.direction, distance, &met);
                let moved = move_of_pixel(sample.map(|n| n as u32));
                take(pixel, hit.object, tracer.sample(*ray, &hit, moved, None)?);
            }
        }
        self.count += tracer.rays;
        self.cut += tracer.cut;
        self.stack = tracer.stack;
        Ok(())
    }
}

/// The first triangle of each of some rays.
struct FirstHits<'a, F> {
    world: &'a World,
    rays: &'a [FrameRay],
    hits: &'a mut Vec<Option<(f64, TriangleHit)>>,
    stack: &'a mut Stack,
    counts: F,
}

impl<F: Fn(&FrameRay, &TriangleHit) -> bool> Kernel for FirstHits<'_, F> {
    type Output = ();

    #[inline(always)]
    fn run<A: Lanes>(self, arch: A) {
        let Self { world, rays, hits, stack, counts } = self;
        let arch = arch.singles();
        let widened = Scalars::splat(arch, WIDENED);
        for rays in rays.chunks(BUNDLE) {
            let mut entered = [None; BUNDLE];
            entered.iter_mut().zip(rays).for_each(|(entered, ray)| *entered = world.enter(ray));
            let in_tree = entered.iter().flatten().map(|(_, in_tree)| in_tree);
            let first = first_node(arch, &world.tree, in_tree, widened);
            for (ray, entered) in rays.iter().zip(entered) {
                hits.push(first.as_ref().zip(entered).and_then(|(first, (before, in_tree))| {
                    let counts = |hit: &TriangleHit| counts(ray, hit);
                    let hit = nearest(arch, (&world.tree, first), &in_tree, stack, false, &counts)?;
                    Some((before + f64::from(hit.distance), hit))
                }));
            }
        }
    }
}
