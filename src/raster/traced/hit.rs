//! What a ray meets: position, normals and sides, as Phong's shading takes them.
//!
//! Rays that leave a triangle start a little off it, by C. Wächter, N. Binder, *A fast and robust method for avoiding
//! self-intersection* (Ray Tracing Gems, 2019, ch. 6). Its constants are for a scene about the origin with a size near 1. The
//! frame of the shaders is that: its unit is near the distance of the camera from its target.

use super::world::Met;
use crate::raster::coverage::triangles::Corner;
use crate::raster::frame::job::Job;
use crate::raster::settings::Shading;
use glam::{DVec3, Vec3};

/// A point that a ray meets, in the frame of the shaders.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SurfaceHit {
    pub(crate) object: usize,
    /// The number among [`Job::drawn`] and the triangle in it; `None` on an analytic surface.
    pub(crate) triangle: Option<(usize, u32)>,
    /// The distance from the start of the ray.
    pub(crate) distance: f64,
    pub(crate) position: DVec3,
    /// Where shadow rays start, before they are moved off the surface.
    pub(crate) shadow_position: DVec3,
    /// The normal that Phong's shading uses: interpolated, or that of the face or of the analytic surface.
    pub(crate) normal: Vec3,
    /// The unit normal of the plane, towards the start of the ray.
    pub(crate) facing: DVec3,
    /// Whether the front is met.
    pub(crate) front: bool,
    /// Whether normals are those of the other side.
    pub(crate) turned: bool,
    /// Of the triangle's corners; their sum is 1.
    pub(crate) weights: [f64; 3],
}

impl SurfaceHit {
    pub(crate) fn new(job: &Job, direction: DVec3, distance: f64, met: &Met) -> Self {
        match met {
            Met::Triangle(hit) => {
                Self::on_triangle(job, direction, distance, hit.id, hit.weights, hit.corners)
            }
            &Met::Solid { object, ref hit } => {
                let normal = hit.normal.get();
                let turned = job.objects[object].settings.two_sided && !hit.front;
                let position = job.frame.to_local(hit.position);
                Self {
                    object,
                    triangle: None,
                    distance,
                    position,
                    shadow_position: position,
                    normal: if turned { -normal } else { normal }.as_vec3(),
                    facing: if normal.dot(direction) > 0.0 { -normal } else { normal },
                    front: hit.front,
                    turned,
                    weights: [0.0; 3],
                }
            }
        }
    }

    fn on_triangle(
        job: &Job,
        direction: DVec3,
        distance: f64,
        id: u32,
        parts: [f64; 3],
        corners: [Vec3; 3],
    ) -> Self {
        let owner = job.owner(id);
        let drawn = &job.drawn[owner];
        let triangle = id - drawn.first;
        let object = &job.objects[drawn.object];
        let corners = corners.map(Vec3::as_dvec3);
        let plane = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize_or_zero();
        let is_towards = plane.dot(direction) < 0.0;
        let front = is_towards != drawn.mirrored;
        let turned = object.settings.two_sided && !front;
        let per_sum = 1.0 / ((parts[0] + parts[1]) + parts[2]);
        let weights = parts.map(|part| part * per_sum);
        let mix = |of: [DVec3; 3]| of[0] * weights[0] + of[1] * weights[1] + of[2] * weights[2];
        let position = mix(corners);
        let (numbers, vertices) = (drawn.list.corners(triangle), drawn.list.vertices(triangle));
        let corner = |k: usize| Corner { number: numbers[k], vertex: vertices[k], turned };
        let (normal, shadow_position) = if object.settings.shading == Shading::Flat {
            (object.face_normal(drawn.list.face(triangle), turned), position)
        } else {
            let normals = [0, 1, 2].map(|k| object.corner_normal(corner(k)));
            let of = |k: usize| normals[k] * weights[k] as f32;
            let facing = normals.map(|normal| if is_towards == (front != turned) { normal } else { -normal });
            let lift = lifted(position, &corners, &facing.map(Vec3::as_dvec3), plane, is_towards);
            ((of(0) + of(1)) + of(2), position + mix(lift))
        };
        Self {
            object: drawn.object,
            triangle: Some((owner, triangle)),
            distance,
            position,
            shadow_position,
            normal,
            facing: match plane {
                DVec3::ZERO => -direction,
                plane if is_towards => plane,
                plane => -plane,
            },
            front,
            turned,
            weights,
        }
    }

    /// The start of a ray that leaves the surface in a direction.
    pub(crate) fn leave(&self, from: DVec3, direction: DVec3) -> DVec3 {
        let side = if direction.dot(self.facing) < 0.0 { -self.facing } else { self.facing };
        self.off(from, side)
    }

    /// A point moved off the surface, to the side of a unit normal.
    pub(crate) fn off(&self, from: DVec3, side: DVec3) -> DVec3 {
        match self.triangle {
            Some(_) => off_triangle(from.as_vec3(), side.as_vec3()).as_dvec3(),
            // Analytic surfaces are met in double precision.
            None => from + side * (EXACT * from.abs().max_element().max(1.0)),
        }
    }
}

/// How far rays start off an analytic surface, as a share of the coordinates: hits are exact to 1e-15 of its size.
const EXACT: f64 = 1e-11;

/// The vectors whose weighted mean moves a point of a triangle onto the smooth surface that its normals describe, where that
/// is above the triangle (J. Hanika, *Hacking the shadow terminator*, Ray Tracing Gems II, 2021, ch. 4). A shadow ray from
/// there does not meet the triangles next to a convex one, which its normals do not show.
fn lifted(
    position: DVec3,
    corners: &[DVec3; 3],
    normals: &[DVec3; 3],
    plane: DVec3,
    is_towards: bool,
) -> [DVec3; 3] {
    let side = if is_towards { plane } else { -plane };
    [0, 1, 2].map(|k| {
        let normal = normals[k].normalize_or_zero();
        // A normal of the other side describes no surface.
        let below = (position - corners[k]).dot(normal);
        if normal.dot(side) > 0.0 && below < 0.0 { normal * -below } else { DVec3::ZERO }
    })
}

/// Wächter and Binder's `offset_ray`: by 1/65 536 near the origin, else by up to 256 units in the last place.
fn off_triangle(from: Vec3, side: Vec3) -> Vec3 {
    const NEAR: f32 = 1.0 / 32.0;
    const LENGTH: f32 = 1.0 / 65_536.0;
    const STEPS: f32 = 256.0;
    let each = |x: f32, n: f32| {
        if x.abs() < NEAR {
            return x + LENGTH * n;
        }
        let steps = (STEPS * n) as i32;
        f32::from_bits((x.to_bits() as i32 + if x < 0.0 { -steps } else { steps }) as u32)
    };
    Vec3::new(each(from.x, side.x), each(from.y, side.y), each(from.z, side.z))
}
