//! Analytic surfaces, exactly: a ray for each sample. The lectures' brute force.

use crate::raster::coverage::visible_triangle::{PIXELS, Visible, place};
use crate::raster::frame::job::Job;
use crate::raster::view::fixed_point::ONE;
use crate::surface::{Hit, Ray};
use glam::{DVec3, Vec3};

/// What the rays of a tile's samples hit.
pub(crate) struct Hits {
    at: Vec<CastHit>,
}

#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct CastHit {
    /// Relative to the view's origin, in units of the frame.
    pub(crate) position: Vec3,
    /// Of the side that is seen, if both are lit.
    pub(crate) normal: Vec3,
    pub(crate) front: bool,
}

/// Surfaces that a ray passes before it is given up: no primitive is met more often.
const PASSES: usize = 4;

/// The first hit of an object in front of the near plane that is not culled, and its distance along the axis.
pub(crate) fn cast(job: &Job, object: usize, on_picture: [f64; 2]) -> Option<(Hit, f64)> {
    let surface = job.objects[object].truth.as_ref()?;
    let (start, direction) = job.view.ray(on_picture);
    let start = job.view.eye + start;
    let mut from = job.view.near;
    for _ in 0..PASSES {
        let hit = surface.intersect(&Ray::new(start + direction * from, direction)?)?;
        let distance = from + hit.t;
        if job.settings.cull.keeps(hit.front) {
            return Some((hit, distance));
        }
        // A little behind the hit, as far as rounding could have put it in front.
        from = distance + distance.abs() * 1e-12;
    }
    None
}

impl Hits {
    pub(crate) fn new() -> Self {
        Self { at: vec![CastHit::default(); PIXELS] }
    }

    pub(crate) fn at(&self, pixel: usize) -> &CastHit {
        &self.at[pixel]
    }

    /// Casts the rays of a tile at an object. Where the object is as near as what is there, what is there stays.
    pub(crate) fn cast(
        &mut self,
        job: &Job,
        object: usize,
        owner: u32,
        origin: [i32; 2],
        visible: &mut Visible,
    ) {
        let [width, height] = job.view.size.map(|n| n as i32 * ONE);
        for pixel in 0..PIXELS {
            let [column, row] = place(pixel).map(|n| n as i32 * ONE);
            let [x, y] = [origin[0] + column, origin[1] + row];
            if x >= width || y >= height {
                continue;
            }
            let on_picture = [x, y].map(|n| f64::from(n) / f64::from(ONE));
            let Some((hit, distance)) = cast(job, object, on_picture) else { continue };
            let depth = job.view.depth(distance) as f32;
            if depth > visible.depth[pixel] {
                visible.depth[pixel] = depth;
                visible.owner[pixel] = owner;
                let turned = job.objects[object].settings.two_sided && !hit.front;
                let position: DVec3 = (hit.position - job.view.origin) / job.frame.unit;
                self.at[pixel] = CastHit {
                    position: position.as_vec3(),
                    normal: hit.normal.get().as_vec3() * if turned { -1.0 } else { 1.0 },
                    front: hit.front,
                };
            }
        }
    }
}
