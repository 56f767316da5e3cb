//! A camera that shows all of a scene as large as it goes.

use super::camera::{Camera, MARGIN, NEAR_SHARE, Projection};
use super::scene::Scene;
use glam::DVec2;

/// The eye stays at least this share of the distance of [`Camera::framing`] away from the nearest point: a rod that
/// points at the viewer would otherwise be looked at from its tip.
const NEAREST: f64 = 0.25;

impl Scene<'_> {
    /// A camera that looks the way of [`Camera::framing`] and has its angle, but stands so that the picture, of this
    /// ratio of width to height, just holds what is there to be drawn and a margin of a tenth. `None` if there is
    /// nothing to draw.
    ///
    /// Four planes through the eye bound what is seen. For each the point that lies farthest out is found; the eye is
    /// then put where opposite planes touch theirs at once, or, in the direction that has room to spare, in the middle
    /// between them. Vertices that no face uses do not count.
    pub fn framing(&self, aspect: f64) -> Option<Camera> {
        let (low, high) = self.bounds()?;
        let loose = Camera::framing((low, high), aspect);
        let (Ok([right, up, forward]), Projection::Perspective(angle)) = (loose.axes(), loose.projection)
        else {
            return Some(loose);
        };
        let vertical = libm::tan(0.5 * angle.0) / MARGIN;
        let slope = DVec2::new(vertical * aspect, vertical);
        // How far out points lie of planes through the middle: `above` of those at the right and the top, `below` of
        // those at the left and the bottom.
        let [mut above, mut below] = [DVec2::NEG_INFINITY; 2];
        let mut nearest = f64::INFINITY;
        self.each_point(|point| {
            let point = point - loose.target;
            let (across, depth) = (DVec2::new(point.dot(right), point.dot(up)), point.dot(forward));
            above = above.max(across - slope * depth);
            below = below.max(-across - slope * depth);
            nearest = nearest.min(depth);
        });
        let [aside, depth] = [(above - below) * 0.5, (above + below) * 0.5 / slope];
        let least = NEAREST * loose.eye.distance(loose.target) - nearest;
        let back = depth.max_element().max(least);
        let eye = loose.target + right * aside.x + up * aside.y - forward * back;
        let tight =
            Camera { eye, target: eye + forward * back, near: (back + nearest) * NEAR_SHARE, ..loose };
        // Numbers at the end of their range may fail where the box alone does not.
        Some(if tight.check().is_ok() { tight } else { loose })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::LinearRgb;
    use crate::raster::{Object, Shape, Triangles};
    use crate::shade::Material;
    use glam::DVec3;

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
}
