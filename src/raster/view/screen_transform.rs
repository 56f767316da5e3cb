//! From the scene to the picture: points as a camera maps them to a picture of a given size.

use crate::num::Radians;
use crate::raster::view::camera::{Camera, CameraError, Projection};
use crate::raster::view::fixed_point::GUARD;
use glam::{DMat3, DMat4, DVec3, Vec3};

/// The smallest depth in perspective, which single precision still divides by: all points farther away than 10³⁷ near
/// distances have this depth.
const FARTHEST: f64 = f32::MIN_POSITIVE as f64;

/// The largest depth in a parallel projection: single precision has room for differences of two.
const DEEPEST: f64 = 1e38;

/// Depths are counted from the target, not the eye, if it is farther away than this many heights of the window: the
/// angle of view is then so narrow that depths from the eye are nearly equal.
const FAR: f64 = 64.0;

/// The largest ratio of the target's distance to the distance at which depth is 1, and the largest depth. The depths of
/// the target, at least 10⁻³⁰, and of points 10⁷ times as far away then stay in the range of single precision, 10⁻³⁸ to
/// 10³⁸.
const MOST_RATIO: f64 = 1e30;

/// The largest coordinate of shaded points: beyond it V and L are the same, but squares overflow.
pub(crate) const REACH: f32 = (1_u64 << 50) as f32;

/// A camera with a picture of a certain size.
///
/// *View space* has its origin in the eye. Its first two coordinates are in pixels from the middle of the picture, to the right and
/// down, times the third of [`ViewPoint`].
#[derive(Clone, Copy, Debug)]
pub(crate) struct View {
    pub(crate) eye: DVec3,
    /// The origin of lit positions: the eye, or the target if the camera is [`FAR`] from it. Then a step of single
    /// precision from the eye is not small compared with the window.
    pub(crate) origin: DVec3,
    /// How far along the axis the origin is.
    pub(crate) away: f64,
    /// Right, up, forward: unit vectors.
    pub(crate) axes: [DVec3; 3],
    /// Pixels per unit of length: at distance 1 in perspective, anywhere in a parallel projection.
    pub(crate) scale: f64,
    pub(crate) near: f64,
    /// The distance at which depth is 1 in perspective and 0 in a parallel projection, without the level: near, or the target if the
    /// camera is [`FAR`] from it.
    depth_from: f64,
    /// Subtracted from depth so that it keeps its digits: 0, or in a narrow perspective the depth of the target, 1.
    /// Points more than 10⁷ times as far away as the target then have equal depths.
    level: f64,
    distance: f64,
    /// How far behind a surface is little, at the most: a distance that a camera which is not far from its target has.
    pub(crate) reach: f64,
    pub(crate) perspective: bool,
    pub(crate) size: [u32; 2],
}

/// A point in view space, homogeneous.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct ViewPoint {
    /// Pixels right of the middle, times `h`.
    pub(crate) x: f64,
    /// Pixels below the middle, times `h`.
    pub(crate) y: f64,
    pub(crate) z: f64,
    /// The homogeneous coordinate: `z` in perspective, 1 else.
    pub(crate) h: f64,
}

impl View {
    pub(crate) fn new(camera: &Camera, size: [u32; 2]) -> Result<Self, CameraError> {
        let axes = camera.axes()?;
        let half = 0.5 * f64::from(size[1]);
        let (scale, perspective) = match camera.projection {
            Projection::Perspective(Radians(angle)) => (half / libm::tan(0.5 * angle), true),
            Projection::Orthographic(height) => (2.0 * half / height, false),
        };
        let (near, distance) = (camera.near, (camera.target - camera.eye).length());
        let shown = f64::from(size[1]) / scale * if perspective { distance } else { 1.0 };
        let is_far = distance > FAR * shown;
        let depth_from = match perspective {
            _ if is_far => distance,
            true => near.max(distance / MOST_RATIO),
            false => near,
        };
        let level = if is_far && perspective { 1.0 } else { 0.0 };
        let (origin, away) = if is_far { (camera.target, distance) } else { (camera.eye, 0.0) };
        Ok(Self {
            eye: camera.eye,
            origin,
            away,
            axes,
            scale,
            near,
            depth_from,
            level,
            distance,
            reach: FAR * shown,
            perspective,
            size,
        })
    }

    /// How high what is shown is at the target.
    pub(crate) fn shown(&self) -> f64 {
        self.reach / FAR
    }

    pub(crate) fn middle(&self) -> [f64; 2] {
        self.size.map(|n| 0.5 * f64::from(n))
    }

    /// Depth to compare: larger is nearer. In perspective [`nearness`](Self::nearness) less the level, else linear in z.
    #[inline(always)]
    pub(crate) fn depth(&self, z: f64) -> f64 {
        match self.perspective {
            true => self.nearness(z) - self.level,
            false => ((self.depth_from - z) * self.scale).clamp(-DEEPEST, DEEPEST),
        }
    }

    /// A share of 1/z, never 0: what perspective-correct interpolation weighs by.
    #[inline(always)]
    pub(crate) fn nearness(&self, z: f64) -> f64 {
        (self.depth_from / z).clamp(FARTHEST, MOST_RATIO)
    }

    /// Whether depth in perspective is not nearness, but has lost the digits of what is far behind the target.
    #[inline(always)]
    pub(crate) fn has_level(&self) -> bool {
        self.level != 0.0
    }

    /// A point of view space on the picture, in pixels from the upper left corner.
    #[inline(always)]
    pub(crate) fn on_picture(&self, point: ViewPoint) -> [f64; 2] {
        let [x, y] = self.middle();
        [x + point.x / point.h, y + point.y / point.h]
    }

    /// The distance inside each clipping plane: near, then the guard band's left, right, upper and lower side.
    pub(crate) fn inside(&self, point: ViewPoint) -> [f64; 5] {
        let guard = f64::from(GUARD) * point.h;
        [point.z - self.near, guard + point.x, guard - point.x, guard + point.y, guard - point.y]
    }

    /// The ray of a place on the picture: its start relative to the eye, and its direction with a component of 1 along the axis.
    pub(crate) fn ray(&self, [x, y]: [f64; 2]) -> (DVec3, DVec3) {
        let [right, up, forward] = self.axes;
        let [middle_x, middle_y] = self.middle();
        let across = right * ((x - middle_x) / self.scale) - up * ((y - middle_y) / self.scale);
        if self.perspective { (DVec3::ZERO, forward + across) } else { (across, forward) }
    }
}

impl Camera {
    /// Where on a picture of this size a point of the scene is seen, in pixels from its upper left corner; it may be outside, or
    /// hidden. `None` for points nearer than the near plane.
    ///
    /// ```
    /// use crease::raster::Camera;
    /// use glam::DVec3;
    ///
    /// let camera = Camera::framing((DVec3::ZERO, DVec3::ONE), 1.0);
    /// let [x, y] = camera.on_picture([200, 100], DVec3::splat(0.5))?.unwrap();
    /// assert!((x - 100.0).abs() < 1e-9 && (y - 50.0).abs() < 1e-9);
    /// # Ok::<(), crease::raster::CameraError>(())
    /// ```
    ///
    /// # Errors
    /// As [`check`](Self::check).
    pub fn on_picture(&self, size: [u32; 2], point: DVec3) -> Result<Option<[f64; 2]>, CameraError> {
        let view = View::new(self, size)?;
        let seen = ObjectMap::new(&view, DMat4::IDENTITY, point).view(point);
        Ok((seen.z >= view.near).then(|| view.on_picture(seen)))
    }
}

/// How many times farther away than the target a pivot may be: it takes 10 of the 53 bits of what is there.
const FAR_PIVOT: f64 = 1024.0;

/// The way from an object's own space to view space and to the scene's axes about the view's origin.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ObjectMap {
    /// A point of the object that is subtracted first, so that an object far from its origin keeps its digits.
    pivot: DVec3,
    to_view: DMat3,
    view_offset: DVec3,
    to_scene: DMat3,
    scene_offset: DVec3,
    perspective: bool,
}

impl ObjectMap {
    pub(crate) fn new(view: &View, transform: DMat4, pivot: DVec3) -> Self {
        let [right, up, forward] = view.axes;
        let rows = DMat3::from_cols(right * view.scale, -up * view.scale, forward).transpose();
        let to_scene = DMat3::from_mat4(transform);
        // Two of the three may cancel, and which does not matter: what their sum loses is added at the end.
        let (turned, place) = (to_scene * pivot, transform.w_axis.truncate());
        let sum = turned + place;
        let part = sum - turned;
        let lost = (turned - (sum - part)) + (place - part);
        let lost = if lost.is_finite() { lost } else { DVec3::ZERO };
        Self {
            pivot,
            to_view: rows * to_scene,
            view_offset: rows * ((sum - view.eye) + lost),
            to_scene,
            scene_offset: (sum - view.origin) + lost,
            perspective: view.perspective,
        }
    }

    /// The map with this point as the pivot, or the eye if the point is too far away.
    pub(crate) fn about(view: &View, transform: DMat4, point: DVec3) -> Self {
        let away = transform.transform_point3(point) - view.eye;
        if away.abs().max_element() <= FAR_PIVOT * view.distance {
            return Self::new(view, transform, point);
        }
        let eye = transform.inverse().transform_point3(view.eye);
        Self::new(view, transform, if eye.is_finite() { eye } else { DVec3::ZERO })
    }

    #[inline(always)]
    pub(crate) fn view(&self, point: DVec3) -> ViewPoint {
        let p = point - self.pivot;
        let m = &self.to_view;
        let row = |x: f64, y: f64, z: f64, offset: f64| ((x * p.x + y * p.y) + z * p.z) + offset;
        let z = row(m.x_axis.z, m.y_axis.z, m.z_axis.z, self.view_offset.z);
        ViewPoint {
            x: row(m.x_axis.x, m.y_axis.x, m.z_axis.x, self.view_offset.x),
            y: row(m.x_axis.y, m.y_axis.y, m.z_axis.y, self.view_offset.y),
            z,
            h: if self.perspective { z } else { 1.0 },
        }
    }

    /// A point of the object relative to the view's origin, in the scene's axes.
    #[inline(always)]
    pub(crate) fn scene_point(&self, point: DVec3) -> DVec3 {
        self.to_scene * (point - self.pivot) + self.scene_offset
    }
}

/// The rays of [`View::ray`] in single precision and a unit of their own: a point at a distance is `start + distance · direction`,
/// both linear on the picture, relative to the view's origin.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rays {
    /// At the picture's upper left corner, and per pixel to the right and down.
    pub(crate) start: [Vec3; 3],
    pub(crate) direction: [Vec3; 3],
    depth_from: f32,
    has_level: bool,
    /// Units of length per unit of depth, in a parallel projection.
    per_depth: f32,
    perspective: bool,
}

impl Rays {
    pub(crate) fn new(view: &View, unit: f64) -> Self {
        let from_origin = |place| {
            let (start, direction) = view.ray(place);
            // In perspective rays are as far apart there as what is across in their directions has become.
            let across = direction - view.axes[2];
            (if view.away == 0.0 { start } else { start + across * view.away }, direction)
        };
        let [corner, right, below] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(from_origin);
        let depth_from = if view.perspective { view.depth_from } else { view.depth_from - view.away };
        let rows = |a: DVec3, b: DVec3, c: DVec3| [a, b - a, c - a].map(|v| v.as_vec3());
        Self {
            start: rows(corner.0 / unit, right.0 / unit, below.0 / unit),
            direction: rows(corner.1, right.1, below.1),
            depth_from: (depth_from / unit) as f32,
            has_level: view.has_level(),
            per_depth: (1.0 / (view.scale * unit)) as f32,
            perspective: view.perspective,
        }
    }

    /// Distance along the axis, from the view's origin, of a point of this [depth](View::depth) and, in perspective, this
    /// [nearness](View::nearness). With z₀ the distance of depth 1, nearness is n = z₀/z, so that z = z₀/n, and from the
    /// target, where depth d is n − 1, z − z₀ = −z₀ d/n.
    #[inline(always)]
    pub(crate) fn distance(&self, depth: f32, nearness: f32) -> f32 {
        let share = if self.has_level { -depth } else { 1.0 };
        // Beyond its reach single precision has no squares of distances.
        match self.perspective {
            true => (self.depth_from * share / nearness).min(REACH),
            false => self.depth_from - depth * self.per_depth,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn views() -> [View; 2] {
        let camera = Camera {
            eye: DVec3::new(1.0, -2.0, 7.0),
            target: DVec3::new(0.5, 0.0, 0.0),
            up: DVec3::new(0.1, 1.0, 0.0),
            projection: Projection::Perspective(Radians(0.7)),
            near: 0.5,
        };
        let parallel = Camera { projection: Projection::Orthographic(3.0), ..camera };
        [camera, parallel].map(|camera| View::new(&camera, [640, 480]).unwrap())
    }

    #[test]
    fn the_target_is_in_the_middle_and_rays_come_back() {
        for view in views() {
            let map = ObjectMap::new(&view, DMat4::IDENTITY, DVec3::ZERO);
            let target = view.on_picture(map.view(DVec3::new(0.5, 0.0, 0.0)));
            assert!((target[0] - 320.0).abs() < 1e-10 && (target[1] - 240.0).abs() < 1e-10, "{target:?}");
            for point in [DVec3::new(0.3, 0.7, -1.0), DVec3::new(-0.4, -0.2, 0.5)] {
                let seen = map.view(point);
                let (start, direction) = view.ray(view.on_picture(seen));
                let back = start + direction * seen.z;
                assert!(back.distance(map.scene_point(point)) < 1e-13, "{back} {point}");
                assert!((map.scene_point(point) + view.eye).distance(point) < 1e-14);
                let rays = Rays::new(&view, 4.0);
                let distance = 4.0 * rays.distance(view.depth(seen.z) as f32, view.nearness(seen.z) as f32);
                assert!((f64::from(distance) / seen.z - 1.0).abs() < 3e-7);
            }
        }
    }

    #[test]
    fn up_is_up_and_right_is_right() {
        for view in views() {
            let map = ObjectMap::new(&view, DMat4::IDENTITY, DVec3::ZERO);
            let [x, y] = view.on_picture(map.view(DVec3::new(1.0, 1.0, 0.0)));
            assert!(x > 320.0 && y < 240.0);
            let point = map.view(DVec3::new(0.5, 0.5, 0.0));
            assert!(view.inside(point).iter().all(|&inside| inside > 0.0));
        }
    }

    /// Far from the origin only the position itself is rounded: the difference of two points keeps its digits.
    #[test]
    fn far_objects_keep_their_digits() {
        let [view, _] = views();
        let offset = DVec3::splat(1e7);
        let far = View { eye: view.eye + offset, ..view };
        let near_map = ObjectMap::new(&view, DMat4::IDENTITY, DVec3::ZERO);
        let far_map = ObjectMap::new(&far, DMat4::IDENTITY, offset);
        for point in [DVec3::new(0.25, 0.75, -1.0), DVec3::new(-0.5, -0.125, 0.5)] {
            let (a, b) = (near_map.view(point), far_map.view(point + offset));
            let (a, b) = (view.on_picture(a), far.on_picture(b));
            // The eye is rounded to 2e-9; a pixel is a hundredth of a unit.
            assert!((a[0] - b[0]).abs() < 1e-6 && (a[1] - b[1]).abs() < 1e-6, "{a:?} {b:?}");
        }
    }
}
