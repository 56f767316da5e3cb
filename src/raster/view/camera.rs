//! Where a picture is seen from.

use crate::num::{Degrees, Radians, UnitVec3};
use glam::DVec3;

/// How points in front of the camera reach the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Projection {
    /// Central projection; the angle is that between the top and the bottom of the picture, in (0, π).
    Perspective(Radians),
    /// Parallel projection; the height of the picture in units of the scene, above 0.
    Orthographic(f64),
}

/// A camera: right-handed, looking from `eye` at `target`, with square pixels.
///
/// Everything is in units of the scene, in `f64`. Positions are computed relative to the eye before they are rounded to
/// single precision, so that a mesh 10⁷ units from the origin is drawn as accurately as one at the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The centre of projection, or any point of the picture's axis in front of which everything is seen.
    pub eye: DVec3,
    /// The point in the middle of the picture.
    pub target: DVec3,
    /// Which way is up in the picture: any vector not parallel to the axis.
    pub up: DVec3,
    /// Perspective or orthographic.
    pub projection: Projection,
    /// Distance along the axis before which nothing is drawn: above 0 in perspective, at least 0 else.
    pub near: f64,
}

/// What is wrong with a camera.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum CameraError {
    /// A coordinate, angle, height or distance that is infinite or not a number.
    #[error("the camera's {0} is not finite")]
    NonFinite(&'static str),
    /// There is no direction to look in.
    #[error("the camera's eye and target are the same point {0}")]
    NoDirection(DVec3),
    /// The picture could be turned any way round its axis.
    #[error("the camera's up vector {0} is zero or parallel to its axis")]
    NoUp(DVec3),
    /// The opening angle is not between 0 and 180 degrees.
    #[error("the camera's vertical angle is {0} degrees; it must lie between 0 and 180")]
    Angle(f64),
    /// The height of an orthographic picture is not positive.
    #[error("the camera's orthographic height is {0}; it must be above 0")]
    Height(f64),
    /// The near distance is not positive (perspective) or negative (orthographic).
    #[error("the camera's near distance is {0}; it must be above 0 (orthographic: at least 0)")]
    Near(f64),
}

const FRAMING_ANGLE: Degrees = Degrees(30.0);
/// How much wider than the mesh the picture of [`Camera::framing`] is.
pub(crate) const MARGIN: f64 = 1.1;
/// Near distance of [`Camera::framing`] as a share of that to the mesh's nearest point. Depth is near over distance in
/// floating point, so that a close near plane costs no precision.
pub(crate) const NEAR_SHARE: f64 = 1.0 / 64.0;

impl Camera {
    /// A perspective camera (30° from top to bottom) that shows everything within the given bounds, seen from the
    /// front, a little from above and from the right; `aspect` is width over height of the picture.
    ///
    /// Bounds of any size and at any place are framed alike, unless they are smaller than 10⁻¹² of their distance from
    /// the origin. A single point is framed as if it had a size of a millionth of that distance (or of 1 at the origin).
    ///
    /// ```
    /// use crease::raster::Camera;
    /// use glam::DVec3;
    ///
    /// let camera = Camera::framing((DVec3::splat(1e7), DVec3::splat(1e7 + 1.0)), 16.0 / 9.0);
    /// assert!(camera.check().is_ok());
    /// ```
    pub fn framing((low, high): (DVec3, DVec3), aspect: f64) -> Self {
        // Halved before they are added: the bounds may reach the largest numbers there are.
        let centre = low * 0.5 + high * 0.5;
        let half = high * 0.5 - low * 0.5;
        let largest = half.abs().max_element();
        let radius = largest * (half / largest.max(f64::MIN_POSITIVE)).length();
        let place = centre.abs().max_element();
        let radius = match (largest > 0.0, place > 0.0) {
            (true, _) => radius.max(place * 1e-12),
            (false, true) => place * 1e-6,
            (false, false) => 1.0,
        };
        let vertical = 0.5 * Radians::from(FRAMING_ANGLE).0;
        let horizontal = libm::atan(libm::tan(vertical) * aspect);
        let distance = MARGIN * radius / libm::sin(vertical.min(horizontal));
        let away = DVec3::new(0.5, 0.4, 1.0).normalize();
        Self {
            eye: centre + away * distance,
            target: centre,
            up: DVec3::Y,
            projection: Projection::Perspective(FRAMING_ANGLE.into()),
            near: (distance - radius) * NEAR_SHARE,
        }
    }

    /// Whether the camera can be used.
    ///
    /// # Errors
    /// The first fault found.
    pub fn check(&self) -> Result<(), CameraError> {
        self.axes().map(|_| ())
    }

    /// The picture's right, its up and the direction of view: orthogonal unit vectors.
    ///
    /// # Errors
    /// As [`check`](Self::check).
    pub fn axes(&self) -> Result<[DVec3; 3], CameraError> {
        for (what, vector) in [("eye", self.eye), ("target", self.target), ("up vector", self.up)] {
            if !vector.is_finite() {
                return Err(CameraError::NonFinite(what));
            }
        }
        match self.projection {
            Projection::Perspective(Radians(angle)) if !angle.is_finite() => {
                return Err(CameraError::NonFinite("vertical angle"));
            }
            Projection::Perspective(Radians(angle)) if !(angle > 0.0 && angle < std::f64::consts::PI) => {
                return Err(CameraError::Angle(Degrees::shortest(Radians(angle)).0));
            }
            Projection::Orthographic(height) if !height.is_finite() => {
                return Err(CameraError::NonFinite("orthographic height"));
            }
            Projection::Orthographic(height) if height <= 0.0 => return Err(CameraError::Height(height)),
            _ => {}
        }
        let forward = UnitVec3::new(self.target * 0.5 - self.eye * 0.5)
            .ok_or(CameraError::NoDirection(self.eye))?
            .get();
        // After the direction: a near distance may be a share of that to the target.
        let perspective = matches!(self.projection, Projection::Perspective(_));
        if !self.near.is_finite() {
            return Err(CameraError::NonFinite("near distance"));
        }
        if self.near < 0.0 || perspective && self.near == 0.0 {
            return Err(CameraError::Near(self.near));
        }
        let up = UnitVec3::new(self.up).ok_or(CameraError::NoUp(self.up))?.get();
        let across = forward.cross(up);
        // Within a few roundings of parallel there is no direction left in the cross product.
        let right = UnitVec3::new(across).filter(|_| across.length() > 8.0 * f64::EPSILON);
        let right = right.ok_or(CameraError::NoUp(self.up))?.get();
        Ok([right, right.cross(forward), forward])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera() -> Camera {
        Camera {
            eye: DVec3::new(0.0, 0.0, 5.0),
            target: DVec3::ZERO,
            up: DVec3::Y,
            projection: Projection::Perspective(Radians(0.5)),
            near: 0.1,
        }
    }

    #[test]
    fn axes_are_right_handed() {
        assert_eq!(camera().axes(), Ok([DVec3::X, DVec3::Y, DVec3::NEG_Z]));
        let oblique = Camera { eye: DVec3::new(1.0, 2.0, 3.0), ..camera() };
        let [right, up, forward] = oblique.axes().unwrap();
        // Products of unit vectors: a few units in the last place.
        assert!(right.cross(up).distance(-forward) < 1e-15 && up.y > 0.0 && right.y == 0.0);
        // Scale changes nothing.
        let far = Camera { eye: oblique.eye * 1e300, ..oblique };
        assert!(far.axes().unwrap()[2].distance(forward) < 1e-15);
    }

    #[test]
    fn faults_are_named() {
        let nan = f64::NAN;
        let cases = [
            (Camera { eye: DVec3::new(nan, 0.0, 0.0), ..camera() }, "eye is not finite"),
            (Camera { target: camera().eye, ..camera() }, "same point"),
            (Camera { up: DVec3::ZERO, ..camera() }, "up vector"),
            (Camera { up: DVec3::Z * -3.0, ..camera() }, "parallel"),
            (Camera { projection: Projection::Perspective(Radians(0.0)), ..camera() }, "between 0 and 180"),
            (Camera { projection: Projection::Perspective(Radians(3.2)), ..camera() }, "between 0 and 180"),
            (Camera { projection: Projection::Perspective(Radians(nan)), ..camera() }, "angle is not finite"),
            (Camera { projection: Projection::Orthographic(0.0), ..camera() }, "height is 0"),
            (Camera { projection: Projection::Orthographic(nan), ..camera() }, "height is not finite"),
            (Camera { near: 0.0, ..camera() }, "near distance is 0"),
            (Camera { near: nan, ..camera() }, "near distance is not finite"),
        ];
        for (camera, expected) in cases {
            let message = camera.check().unwrap_err().to_string();
            assert!(message.contains(expected), "{message:?} does not say {expected:?}");
        }
    }

    #[test]
    fn framing_takes_any_size_and_place() {
        for scale in [1e-30, 1e-3, 1.0, 1e30] {
            for offset in [0.0, 1.0, 1e7] {
                let low = DVec3::new(offset - 1.0, offset, offset) * scale;
                let high = DVec3::new(offset + 1.0, offset + 0.5, offset + 0.25) * scale;
                let camera = Camera::framing((low, high), 1.5);
                camera.check().unwrap();
                let away = camera.eye.distance(camera.target) / scale;
                // Half the diagonal is 1.0383, half the angle 15°: 1.1 · 1.0383 / sin 15°.
                assert!((away - 4.4128).abs() < 1e-3, "{scale} {offset}: {away}");
            }
        }
        for point in [DVec3::ZERO, DVec3::splat(3e9)] {
            Camera::framing((point, point), 1.0).check().unwrap();
        }
    }
}
