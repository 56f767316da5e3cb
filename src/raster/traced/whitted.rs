//! The light along a ray, by T. Whitted, *An improved illumination model for shaded display* (CACM 23(6), 1980): local light
//! with shadows, and the light from the mirrored and the refracted direction.

use super::hit::SurfaceHit;
use super::media::Media;
use super::ray_tree::{RayHit, RayNode, ShadowTest};
use super::traverse::Stack;
use super::world::{FrameRay, TracedScene};
use crate::num::{LinearRgb, Radians};
use crate::raster::coverage::records::single;
use crate::raster::error::{RenderError, Result};
use crate::raster::frame::job::Job;
use crate::raster::settings::Shading;
use crate::raster::shading::surface_colour::{ObjectColour, Shaders};
use crate::shade::{Optics, SeenFrom, fresnel, reflect, refract};
use glam::{DVec3, Vec3};

/// Most rays of one sample, reflected and refracted: a bound for materials that add more light than they receive.
const MOST_RAYS: u32 = 4096;

/// Follows rays; counts them.
pub(crate) struct Tracer<'a> {
    pub(super) job: &'a Job<'a>,
    pub(super) scene: &'a TracedScene,
    pub(crate) stack: Stack,
    /// How the sets of shadow rays of the pixel are moved.
    pub(super) moved: [f64; 2],
    /// Rays of all kinds so far.
    pub(crate) rays: u64,
    /// The sum of the shares of light that limits cut off, by sample.
    pub(crate) cut: f64,
    /// The rays that the sample may still send.
    left: u32,
}

/// A ray with its history.
#[derive(Clone, Copy, Debug)]
struct Path {
    ray: FrameRay,
    media: Media,
    /// Reflections and refractions so far.
    depth: u32,
    /// The share of its light in the colour of the sample.
    weight: LinearRgb,
    /// The length of the path from the camera to its start.
    length: f64,
}

/// A direction in which light comes to a surface, with its share.
struct Onward {
    kind: &'static str,
    direction: DVec3,
    share: LinearRgb,
    media: Media,
}

impl<'a> Tracer<'a> {
    pub(crate) fn new(job: &'a Job<'a>, scene: &'a TracedScene, stack: Stack) -> Self {
        Self { job, scene, stack, moved: [0.0; 2], rays: 0, cut: 0.0, left: 0 }
    }

    /// The light from a point that the camera sees along a ray; `moved` belongs to the pixel.
    pub(crate) fn sample(
        &mut self,
        ray: FrameRay,
        hit: &SurfaceHit,
        moved: [f64; 2],
        record: Option<&mut RayNode>,
    ) -> Result<Vec3> {
        (self.moved, self.left) = (moved, MOST_RAYS);
        self.rays += 1;
        let path = Path { ray, media: Media::default(), depth: 0, weight: LinearRgb::WHITE, length: 0.0 };
        self.light(&path, hit, record)
    }

    /// The light that arrives along a ray.
    fn follow(&mut self, path: &Path, record: Option<&mut RayNode>) -> Result<Vec3> {
        self.rays += 1;
        let found = self.scene.world.nearest(&path.ray, &mut self.stack, |_| true, &|_, _| true);
        if let Some((distance, met)) = found {
            let hit = SurfaceHit::new(self.job, path.ray.direction, distance, &met);
            return self.light(path, &hit, record);
        }
        // Out of an open body: all of its light is absorbed on an endless way.
        let inside = path.media.inmost().map(|object| self.optics(object));
        let left = inside.map_or(LinearRgb::WHITE, |optics| optics.transmittance(f64::INFINITY));
        let colour = Vec3::from(self.job.background) * single(left);
        if let Some(node) = record {
            self.describe(node, path, left, colour);
        }
        Ok(colour)
    }

    fn optics(&self, object: usize) -> &'a Optics {
        &self.job.objects[object].optics
    }

    /// The light that arrives along a ray from the point that it meets.
    fn light(&mut self, path: &Path, hit: &SurfaceHit, mut record: Option<&mut RayNode>) -> Result<Vec3> {
        let optics = self.optics(hit.object);
        let is_inside = optics.transmits() && !hit.front;
        let body = match path.media.inmost() {
            _ if is_inside && !path.media.holds(hit.object) => Some(hit.object),
            inmost => inmost,
        };
        let distance = hit.distance * self.job.frame.unit;
        let left = body.map_or(LinearRgb::WHITE, |object| self.optics(object).transmittance(distance));
        let mut shadows = Vec::new();
        let mut colour = match is_inside {
            true => Vec3::ZERO,
            false => self.local(path, hit, record.is_some().then_some(&mut shadows))?,
        };
        if let Some(node) = record.as_deref_mut() {
            node.hit = Some(self.described(hit, colour, shadows));
        }
        if optics.continues() {
            let path = Path { weight: path.weight * left, length: path.length + hit.distance, ..*path };
            for onward in self.onward(&path, hit, optics, record.as_deref_mut()) {
                colour += self.go_on(&path, hit, &onward, record.as_deref_mut())?;
            }
        }
        if left != LinearRgb::WHITE {
            colour *= single(left);
        }
        if let Some(node) = record {
            self.describe(node, path, left, colour);
        }
        Ok(colour)
    }

    /// The light that the local model gives, with shadows.
    fn local(
        &mut self,
        path: &Path,
        hit: &SurfaceHit,
        mut shadows: Option<&mut Vec<ShadowTest>>,
    ) -> Result<Vec3> {
        let job = self.job;
        let object = &job.objects[hit.object];
        let shaders: &Shaders = match &object.colour {
            ObjectColour::Given(colours) => return Ok(given(job, hit, colours)),
            ObjectColour::Lit(shaders) => shaders,
        };
        let face = match hit.triangle {
            Some((drawn, triangle)) if object.settings.asks_faces() => {
                let face = job.drawn[drawn].list.face(triangle);
                Some(object.face_normal(face, hit.turned).to_array())
            }
            _ => None,
        };
        // The camera's own rays have the viewer's direction, to the bit.
        let seen_from = (path.depth > 0).then(|| SeenFrom {
            view: (-path.ray.direction).as_vec3().to_array(),
            distance: (path.length + hit.distance) as f32,
        });
        let mut visible = |light: usize| {
            let share = self.visible(light, hit).to_array();
            if let Some(shadows) = shadows.as_deref_mut() {
                shadows.push(ShadowTest { light, visible: share });
            }
            share
        };
        let colour = shaders.shade_ray(hit.position, hit.normal.to_array(), face, seen_from, &mut visible);
        match colour {
            Ok(colour) => Ok(Vec3::from(colour)),
            Err(error) => Err(RenderError::NotFinite { object: hit.object, error }),
        }
    }

    /// The mirrored and the refracted direction of a point, with their shares.
    fn onward(
        &self,
        path: &Path,
        hit: &SurfaceHit,
        optics: &Optics,
        record: Option<&mut RayNode>,
    ) -> Vec<Onward> {
        let view = -path.ray.direction;
        let normals = shading_normals(hit, view);
        let mirrored = normals.map(|normal| reflect(normal, view));
        let mirrored = if mirrored[0].dot(hit.facing) > 0.0 { mirrored[0] } else { mirrored[1] };
        let mut onward = Vec::with_capacity(2);
        let mut share = if hit.front || !optics.transmits() { optics.reflect } else { LinearRgb::BLACK };
        if optics.transmits() {
            let after = if hit.front { path.media.entered(hit.object) } else { path.media.left(hit.object) };
            let index = |object: Option<usize>| object.map_or(1.0, |object| self.optics(object).ior);
            let before = match path.media.inmost() {
                None if !hit.front => Some(hit.object),
                inmost => inmost,
            };
            let indices = [index(before), index(after.inmost())];
            let bent = normals.map(|normal| refract(normal, view, indices[0], indices[1]));
            let which = match bent[0] {
                Some(direction) if direction.dot(hit.facing) >= 0.0 => 1,
                _ => 0,
            };
            let cosine = normals[which].dot(view);
            let angle = libm::atan2(normals[which].cross(view).length(), cosine);
            // Half a turn of rounding past the horizon.
            let angle = Radians(angle.min(std::f64::consts::FRAC_PI_2));
            let reflected = match bent[which] {
                Some(_) => fresnel(indices[0], indices[1], angle).reflected(),
                None => 1.0,
            };
            let passed = if hit.front { optics.transmit } else { LinearRgb::WHITE };
            share += passed * reflected;
            if let Some(direction) = bent[which].filter(|_| reflected < 1.0) {
                let share = passed * (1.0 - reflected);
                onward.push(Onward { kind: "refracted", direction, share, media: after });
            }
            if let Some(found) = record.and_then(|node| node.hit.as_mut()) {
                (found.indices, found.fresnel) = (Some(indices), Some(reflected));
            }
        }
        if share != LinearRgb::BLACK {
            onward.insert(0, Onward { kind: "reflected", direction: mirrored, share, media: path.media });
        }
        onward
    }

    /// The light of a direction times its share, unless a limit cuts it off.
    fn go_on(
        &mut self,
        path: &Path,
        hit: &SurfaceHit,
        onward: &Onward,
        record: Option<&mut RayNode>,
    ) -> Result<Vec3> {
        let limits = &self.job.settings.tracing;
        let weight = path.weight * onward.share;
        let found = record.and_then(|node| node.hit.as_mut());
        if path.depth >= limits.depth || weight.largest() < limits.weight || self.left == 0 {
            self.cut += weight.largest();
            if let Some(found) = found {
                found.cut += weight.largest();
            }
            return Ok(Vec3::ZERO);
        }
        self.left -= 1;
        let direction = onward.direction.normalize_or_zero();
        let origin = hit.leave(hit.position, direction);
        let ray = FrameRay { origin, direction, reach: f64::INFINITY };
        let next = Path { ray, media: onward.media, depth: path.depth + 1, weight, length: path.length };
        let Some(found) = found else {
            return Ok(self.follow(&next, None)? * single(onward.share));
        };
        let mut node = RayNode { kind: onward.kind, share: onward.share.to_array(), ..RayNode::default() };
        let colour = self.follow(&next, Some(&mut node))? * single(onward.share);
        found.rays.push(node);
        Ok(colour)
    }

    fn describe(&self, node: &mut RayNode, path: &Path, left: LinearRgb, colour: Vec3) {
        node.origin = self.job.frame.to_world(path.ray.origin).to_array();
        node.direction = path.ray.direction.to_array();
        node.transmittance = left.to_array();
        node.colour = colour.as_dvec3().to_array();
    }

    fn described(&self, hit: &SurfaceHit, local: Vec3, shadows: Vec<ShadowTest>) -> RayHit {
        let face = hit.triangle.map(|(drawn, triangle)| self.job.drawn[drawn].list.face(triangle));
        RayHit {
            object: hit.object,
            face,
            front: hit.front,
            position: self.job.frame.to_world(hit.position).to_array(),
            distance: hit.distance * self.job.frame.unit,
            normal: on_side(hit.normal.as_dvec3().normalize_or_zero(), hit.facing).to_array(),
            local: local.as_dvec3().to_array(),
            shadows,
            ..RayHit::default()
        }
    }
}

/// A normal on the side of another.
fn on_side(normal: DVec3, side: DVec3) -> DVec3 {
    if normal.dot(side) < 0.0 { -normal } else { normal }
}

/// The normal for reflection and refraction, and the one to take if a direction is on the wrong side of the face: that of
/// the face itself.
fn shading_normals(hit: &SurfaceHit, view: DVec3) -> [DVec3; 2] {
    let normal = on_side(hit.normal.as_dvec3().normalize_or_zero(), hit.facing);
    [if normal.dot(view) > 0.0 { normal } else { hit.facing }, hit.facing]
}

/// The colour of vertices at a point: interpolated, or the mean of a flat face.
fn given(job: &Job, hit: &SurfaceHit, colours: &[LinearRgb]) -> Vec3 {
    let Some((drawn, triangle)) = hit.triangle else { return Vec3::ZERO };
    let (drawn, object) = (&job.drawn[drawn], &job.objects[hit.object]);
    let colour = |vertex: u32| colours[vertex as usize];
    if object.settings.shading == Shading::Flat {
        let vertices = object.shape.face(drawn.list.face(triangle));
        let sum = vertices.iter().fold(LinearRgb::BLACK, |sum, &vertex| sum + colour(vertex));
        return single(sum * (1.0 / vertices.len() as f64));
    }
    let mixed = drawn.list.vertices(triangle).into_iter().zip(hit.weights);
    single(mixed.fold(LinearRgb::BLACK, |sum, (vertex, weight)| sum + colour(vertex) * weight))
}
