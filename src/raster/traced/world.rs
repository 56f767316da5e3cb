//! The triangles and the analytic surfaces of a scene, in the frame of its shaders.

use super::build::BoxedTriangle;
use super::lamp::Lamp;
use super::traverse::{Nearest, Stack, TreeRay, TriangleHit};
use super::tree::Tree;
use crate::num;
use crate::num::parallel;
use crate::raster::coverage::triangles::DrawnObject;
use crate::raster::view::screen_transform::REACH;
use crate::shade::Frame;
use crate::surface::{Hit, Placed, Ray};
use glam::{DVec3, Vec3};

/// What rays need of a scene.
pub(crate) struct TracedScene {
    pub(crate) world: World,
    /// Of all lights.
    pub(crate) lamps: Vec<Lamp>,
    /// Whether any object transmits light.
    pub(crate) transmits: bool,
}

/// What rays can meet.
pub(crate) struct World {
    pub(crate) tree: Tree,
    /// The smallest and the largest corner of all triangles.
    bounds: [DVec3; 2],
    solids: Vec<Solid>,
    frame: Frame,
}

/// An analytic surface.
struct Solid {
    object: usize,
    surface: Placed,
    /// A sphere around it.
    centre: DVec3,
    radius: f64,
}

/// What a ray meets first.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Met {
    Triangle(TriangleHit),
    /// An analytic surface of an object; the position is in the scene.
    Solid {
        object: usize,
        hit: Hit,
    },
}

/// A ray in the frame, with a unit vector as its direction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FrameRay {
    pub(crate) origin: DVec3,
    pub(crate) direction: DVec3,
    /// Hits beyond this distance do not count.
    pub(crate) reach: f64,
}

/// Surfaces that a ray passes before it is given up: no primitive is met more often.
const PASSES: usize = 4;

/// The smallest component of a direction that is divided by.
const THIN: f64 = 1e-300;

impl World {
    /// Meshes and surfaces, each with the number of its object.
    pub(crate) fn new(drawn: &[DrawnObject], surfaces: Vec<(usize, Placed)>, frame: Frame) -> Self {
        let vertices: Vec<Vec<Vec3>> = drawn.iter().map(|object| in_frame(object, frame)).collect();
        let corners = |id: u32| {
            let at = drawn.partition_point(|object| object.first <= id) - 1;
            let object = &drawn[at];
            object.list.vertices(id - object.first).map(|vertex| vertices[at][vertex as usize])
        };
        let count = drawn.last().map_or(0, |object| object.first + object.list.len() as u32);
        let triangle = |id: usize| BoxedTriangle::new(id as u32, corners(id as u32));
        let mut boxes = parallel::map(count as usize, triangle);
        let tree = Tree::new(&mut boxes, &corners);
        let solids = surfaces.into_iter().map(|(object, surface)| {
            let (centre, radius) = surface.sphere();
            Solid { object, surface, centre: frame.to_local(centre), radius: radius / frame.unit }
        });
        Self { bounds: tree.bounds(), tree, solids: solids.collect(), frame }
    }

    /// The start of a ray in the tree, advanced to the box of all triangles: a far ray would lose digits in single
    /// precision. `None` if the ray misses the box.
    #[inline(always)]
    pub(crate) fn enter(&self, ray: &FrameRay) -> Option<(f64, TreeRay)> {
        let [low, high] = self.bounds;
        let (mut near, mut far) = (0.0_f64, ray.reach);
        for axis in 0..3 {
            // Finite, so that no product is NaN.
            let along = ray.direction[axis];
            let inverse = 1.0 / if along.abs() < THIN { THIN } else { along };
            let [a, b] = [low, high].map(|side| (side[axis] - ray.origin[axis]) * inverse);
            near = near.max(a.min(b));
            far = far.min(a.max(b));
        }
        // A little before the box: single precision rounds its sides.
        let near = (near - near.abs() * 1e-6 - 1e-6).max(0.0);
        let is_met = near <= far * (1.0 + 1e-6) + 1e-6;
        let start = ray.origin + ray.direction * near;
        is_met.then(|| (near, TreeRay::new(start, ray.direction, (ray.reach - near) as f32)))
    }

    /// The nearest triangle that counts; its distance is that from the origin of the ray.
    fn nearest_triangle(
        &self,
        ray: &FrameRay,
        stack: &mut Stack,
        any: bool,
        counts: impl Fn(&TriangleHit) -> bool,
    ) -> Option<(f64, TriangleHit)> {
        let (before, in_tree) = self.enter(ray)?;
        let hit = num::dispatch(Nearest { tree: &self.tree, ray: in_tree, stack, any, counts })?;
        Some((before + f64::from(hit.distance), hit))
    }

    /// The nearest analytic surface that counts, by object and visible side.
    pub(crate) fn nearest_solid(
        &self,
        ray: &FrameRay,
        counts: &impl Fn(usize, bool) -> bool,
    ) -> Option<(f64, usize, Hit)> {
        let mut best: Option<(f64, usize, Hit)> = None;
        for solid in &self.solids {
            let reach = best.as_ref().map_or(ray.reach, |best| best.0);
            if let Some((distance, hit)) = solid.first(ray, self.frame, reach, counts)
                && best.as_ref().is_none_or(|best| distance < best.0)
            {
                best = Some((distance, solid.object, hit));
            }
        }
        best
    }

    /// What a ray meets first, among what counts, and the distance. Of two at the same distance a triangle is first.
    pub(crate) fn nearest(
        &self,
        ray: &FrameRay,
        stack: &mut Stack,
        triangle_counts: impl Fn(&TriangleHit) -> bool,
        solid_counts: &impl Fn(usize, bool) -> bool,
    ) -> Option<(f64, Met)> {
        let triangle = self.nearest_triangle(ray, stack, false, triangle_counts);
        self.with_solids(ray, triangle, solid_counts)
    }

    /// The nearer one of a triangle and the analytic surfaces.
    pub(crate) fn with_solids(
        &self,
        ray: &FrameRay,
        triangle: Option<(f64, TriangleHit)>,
        solid_counts: &impl Fn(usize, bool) -> bool,
    ) -> Option<(f64, Met)> {
        let reach = triangle.as_ref().map_or(ray.reach, |(distance, _)| *distance);
        match self.nearest_solid(&FrameRay { reach, ..*ray }, solid_counts) {
            Some((distance, object, hit)) => Some((distance, Met::Solid { object, hit })),
            None => triangle.map(|(distance, hit)| (distance, Met::Triangle(hit))),
        }
    }

    /// Whether a ray meets anything that counts.
    pub(crate) fn is_blocked(
        &self,
        ray: &FrameRay,
        stack: &mut Stack,
        triangle_counts: impl Fn(&TriangleHit) -> bool,
        solid_counts: &impl Fn(usize, bool) -> bool,
    ) -> bool {
        self.nearest_solid(ray, solid_counts).is_some()
            || self.nearest_triangle(ray, stack, true, triangle_counts).is_some()
    }
}

impl Solid {
    /// The first hit before `reach` that counts, and its distance.
    fn first(
        &self,
        ray: &FrameRay,
        frame: Frame,
        reach: f64,
        counts: &impl Fn(usize, bool) -> bool,
    ) -> Option<(f64, Hit)> {
        let away = self.centre - ray.origin;
        let along = away.dot(ray.direction);
        // With some room for rounding.
        let radius = self.radius * (1.0 + 1e-9) + away.length() * 1e-12;
        if (away - ray.direction * along).length() > radius || along < -radius || along - radius > reach {
            return None;
        }
        let mut from = 0.0;
        for _ in 0..PASSES {
            let origin = frame.to_world(ray.origin + ray.direction * from);
            let hit = self.surface.intersect(&Ray::new(origin, ray.direction * frame.unit)?)?;
            let distance = from + hit.t;
            if distance >= reach {
                return None;
            }
            if counts(self.object, hit.front) {
                return Some((distance, hit));
            }
            // A little behind the hit, as far as rounding could have put it in front.
            from = distance + distance.abs() * 1e-12;
        }
        None
    }
}

/// The vertices of an object, no farther from the origin of the frame than shaders take points.
fn in_frame(object: &DrawnObject, frame: Frame) -> Vec<Vec3> {
    let per_unit = 1.0 / frame.unit;
    parallel::map(object.points.len(), |vertex| {
        let point = object.map.scene_point(object.points.at(vertex as u32)) * per_unit;
        let largest = point.abs().max_element();
        let reach = f64::from(REACH);
        (if largest > reach { point * (reach / largest) } else { point }).as_vec3()
    })
}
