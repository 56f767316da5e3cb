//! A camera that shows all of a scene as large as it goes.

use crate::raster::scene::{Object, Scene, Shape, corners};
use crate::raster::view::camera::{Camera, MARGIN, NEAR_SHARE, Projection};
use crate::surface::{Primitive, Surface, Tessellation};
use glam::{DVec2, DVec3};

/// The least distance from the eye to the nearest point, as a share of that of [`Camera::framing`]. Without it, a rod
/// that points at the viewer would be seen from its tip.
const NEAREST: f64 = 0.25;

/// Parts along each side of the net of points that approximates an analytic surface: it is at most 0.3 % smaller.
const NET: [u32; 2] = [40, 40];

/// The four planes through a point that bound what a camera there sees.
struct Planes {
    right: DVec3,
    up: DVec3,
    forward: DVec3,
    /// How far they lean aside and upwards per unit of length.
    slope: DVec2,
}

/// How far out of the planes something lies.
#[derive(Clone, Copy)]
struct Extent {
    /// Of the right and the upper one.
    above: DVec2,
    /// Of the left and the lower one.
    below: DVec2,
    nearest: f64,
}

impl Planes {
    fn of_point(&self, point: DVec3) -> Extent {
        let across = DVec2::new(point.dot(self.right), point.dot(self.up));
        let depth = point.dot(self.forward);
        Extent { above: across - self.slope * depth, below: -across - self.slope * depth, nearest: depth }
    }

    /// Of the circle that a point describes about the upright axis through the planes' own point.
    fn of_circle(&self, point: DVec3) -> Extent {
        let flat = |v: DVec3| libm::hypot(v.x, v.z);
        let farthest = |way: DVec3| point.y * way.y + flat(point) * flat(way);
        let Self { right, up, forward, slope } = *self;
        let out =
            |x: DVec3, y: DVec3| DVec2::new(farthest(x - forward * slope.x), farthest(y - forward * slope.y));
        Extent { above: out(right, up), below: out(-right, -up), nearest: -farthest(-forward) }
    }
}

impl Scene<'_> {
    /// A camera with the direction and angle of [`Camera::framing`], so near that the picture, of this ratio of width to height, just
    /// holds all that is drawn and a margin of a tenth. `None` if there is nothing to draw. The eye is where four planes through it
    /// touch the points that lie farthest out.
    pub fn framing(&self, aspect: f64) -> Option<Camera> {
        Some(self.tight(self.bounds()?, aspect, Planes::of_point))
    }

    /// The same for a turntable: the scene stays in the picture when it rotates about the upright axis through the middle of its box.
    pub fn framing_turned(&self, aspect: f64) -> Option<Camera> {
        let (low, high) = self.bounds()?;
        let (centre, half) = (low * 0.5 + high * 0.5, high * 0.5 - low * 0.5);
        let radius = libm::hypot(half.x, half.z);
        let half = DVec3::new(radius, half.y, radius);
        Some(self.tight((centre - half, centre + half), aspect, Planes::of_circle))
    }

    fn tight(&self, bounds: (DVec3, DVec3), aspect: f64, reach: fn(&Planes, DVec3) -> Extent) -> Camera {
        let loose = Camera::framing(bounds, aspect);
        let (Ok([right, up, forward]), Projection::Perspective(angle)) = (loose.axes(), loose.projection)
        else {
            return loose;
        };
        let vertical = libm::tan(0.5 * angle.0) / MARGIN;
        let slope = DVec2::new(vertical * aspect, vertical);
        let planes = Planes { right, up, forward, slope };
        let [mut above, mut below] = [DVec2::NEG_INFINITY; 2];
        let mut nearest = f64::INFINITY;
        self.each_rim_point(|point| {
            let out = reach(&planes, point - loose.target);
            above = above.max(out.above);
            below = below.max(out.below);
            nearest = nearest.min(out.nearest);
        });
        let [aside, depth] = [(above - below) * 0.5, (above + below) * 0.5 / slope];
        let least = NEAREST * loose.eye.distance(loose.target) - nearest;
        let back = depth.max_element().max(least);
        let eye = loose.target + right * aside.x + up * aside.y - forward * back;
        let tight =
            Camera { eye, target: eye + forward * back, near: (back + nearest) * NEAR_SHARE, ..loose };
        // Numbers at the end of their range may fail where the box alone does not.
        if tight.check().is_ok() { tight } else { loose }
    }

    /// Visits the points of [`each_point`](Self::each_point), but of analytic surfaces points on them.
    fn each_rim_point(&self, mut visit: impl FnMut(DVec3)) {
        let is_surface = |object: &Object| matches!(object.shape, Shape::Surface(_));
        let mut nets: Vec<(Primitive, Vec<DVec3>)> = Vec::new();
        self.each_point_of(|object| !is_surface(object), &mut visit);
        for object in &self.objects {
            let Shape::Surface(primitive) = object.shape else { continue };
            let known = nets.iter().position(|(known, _)| *known == primitive);
            let net = known.unwrap_or_else(|| {
                // Few scenes have many different ones.
                nets.truncate(64);
                nets.push((primitive, net(primitive)));
                nets.len() - 1
            });
            nets[net].1.iter().for_each(|&point| visit(object.transform.transform_point3(point)));
        }
    }
}

fn net(primitive: Primitive) -> Vec<DVec3> {
    let cut = Tessellation { segments: NET, ..Tessellation::default() };
    match Surface::Primitive(primitive).tessellate(&cut) {
        Ok(mesh) => mesh.positions().to_vec(),
        Err(_) => corners(primitive.half_extents()).to_vec(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::LinearRgb;
    use crate::raster::scene::Triangles;
    use crate::shade::Material;

    fn scene<'a>(positions: &'a [[f32; 3]], triangles: &'a [[u32; 3]]) -> Scene<'a> {
        let triangles = Triangles { positions, triangles, normals: &[], face_normals: &[] };
        Scene {
            objects: vec![Object::new(Shape::Triangles(triangles), Material::default())],
            lines: Vec::new(),
            lights: Vec::new(),
            camera: Camera::framing((DVec3::ZERO, DVec3::ONE), 1.0),
            background: LinearRgb::BLACK,
        }
    }

    /// Where a camera sees a point: 1 is the rim of the picture.
    fn seen(camera: &Camera, aspect: f64, point: DVec3) -> DVec2 {
        let [right, up, forward] = camera.axes().unwrap();
        let Projection::Perspective(angle) = camera.projection else { panic!("a perspective") };
        let point = point - camera.eye;
        let slope = libm::tan(0.5 * angle.0) * point.dot(forward);
        DVec2::new(point.dot(right) / (slope * aspect), point.dot(up) / slope)
    }

    #[test]
    fn opposite_sides_are_touched_within_the_margin() {
        let flat = [[-3.0, 0.0, -1.0], [4.0, 0.5, 0.0], [0.0, 0.25, 2.5], [50.0, 50.0, 50.0]];
        let tall = flat.map(|[x, y, z]: [f32; 3]| [y, 3.0 * x, z]);
        for (positions, wide) in [(flat, true), (tall, false)] {
            for aspect in [1.0, 1.5] {
                let scene = scene(&positions, &[[0, 1, 2]]);
                let camera = scene.framing(aspect).unwrap();
                let points =
                    positions[..3].iter().map(|p| seen(&camera, aspect, DVec3::from(p.map(f64::from))));
                let (low, high) = points
                    .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), p| (low.min(p), high.max(p)));
                let touching = if wide { [low.x, high.x] } else { [low.y, high.y] };
                // A few roundings of coordinates of some units.
                assert!(
                    (touching[0] + 1.0 / MARGIN).abs() < 1e-12 && (touching[1] - 1.0 / MARGIN).abs() < 1e-12
                );
                assert!(low.min_element() > -0.92 && high.max_element() < 0.92, "{low} {high}");
            }
        }
    }

    #[test]
    fn points_and_lines_have_a_camera_too() {
        let camera = |positions: &[[f32; 3]]| scene(positions, &[[0, 1, 2]]).framing(1.0).unwrap();
        camera(&[[2.0; 3]; 3]).check().unwrap();
        let rod = [[0.0; 3], [0.5, 0.4, 1.0], [5.0, 4.0, 10.0]];
        let eye = camera(&rod).eye;
        assert!(eye.distance(DVec3::new(5.0, 4.0, 10.0)) > 5.0, "{eye}");
        assert!(scene(&rod, &[]).framing(1.0).is_none());
        for size in [1e-30, 1e30] {
            camera(&rod.map(|point| point.map(|x| x * size))).check().unwrap();
        }
    }

    /// At every turn within the margin, and touching it at some.
    #[test]
    fn a_turntable_is_framed_tightly() {
        let positions = [[-3.0, 0.0, -1.0], [4.0, 0.5, 0.0], [0.0, 0.25, 2.5]];
        for aspect in [1.0, 1.5] {
            let scene = scene(&positions, &[[0, 1, 2]]);
            let camera = scene.framing_turned(aspect).unwrap();
            let (low, high) = scene.bounds().unwrap();
            let middle = (low + high) * 0.5;
            let mut farthest: f64 = 0.0;
            for degrees in 0..360 {
                let turn = glam::DMat3::from_rotation_y(f64::from(degrees).to_radians());
                for point in positions {
                    let point = middle + turn * (DVec3::from(point.map(f64::from)) - middle);
                    farthest = farthest.max(seen(&camera, aspect, point).abs().max_element());
                }
            }
            // A turn between two degrees may reach a little farther.
            assert!(farthest < 1.0 / MARGIN + 1e-12 && farthest > 0.999 / MARGIN, "{aspect}: {farthest}");
        }
    }

    /// A surface that rays are cast at is framed as its net is.
    #[test]
    fn solids_are_framed_as_large_as_their_nets() {
        use crate::surface::{Sphere, Torus};
        let solids = [Sphere::new(1.0).unwrap().into(), Torus::new(2.0, 0.5).unwrap().into()];
        for primitive in solids {
            let fine = Tessellation { segments: [256, 256], ..Tessellation::default() };
            let mesh = Surface::Primitive(primitive).tessellate(&fine).unwrap();
            let solid = Scene {
                objects: vec![Object::new(Shape::Surface(primitive), Material::default())],
                ..scene(&[], &[])
            };
            let camera = solid.framing(1.0).unwrap();
            let seen = mesh.positions().iter().map(|point| seen(&camera, 1.0, point).abs().max_element());
            let farthest = seen.fold(0.0, f64::max);
            assert!((farthest * MARGIN - 1.0).abs() < 0.005, "{primitive:?}: {farthest}");
        }
    }
}
