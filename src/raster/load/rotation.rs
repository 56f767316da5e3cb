//! Rotation by degrees.

use crate::num::{Degrees, Radians};
use glam::{DMat3, DMat4, DVec3};

/// The rotation by these degrees about the x axis, then about y, then about z; counter-clockwise seen from where an axis points
/// to. Quarter turns are exact.
///
/// ```
/// use crease::raster::rotation;
/// use glam::DVec3;
///
/// let turned = rotation(DVec3::new(0.0, 0.0, 90.0)).transform_vector3(DVec3::X);
/// assert_eq!(turned, DVec3::Y);
/// ```
pub fn rotation(degrees: DVec3) -> DMat4 {
    let [(sx, cx), (sy, cy), (sz, cz)] = degrees.to_array().map(sin_cos);
    let x = DMat3::from_cols(DVec3::X, DVec3::new(0.0, cx, sx), DVec3::new(0.0, -sx, cx));
    let y = DMat3::from_cols(DVec3::new(cy, 0.0, -sy), DVec3::Y, DVec3::new(sy, 0.0, cy));
    let z = DMat3::from_cols(DVec3::new(cz, sz, 0.0), DVec3::new(-sz, cz, 0.0), DVec3::Z);
    DMat4::from_mat3(z * y * x)
}

fn sin_cos(degrees: f64) -> (f64, f64) {
    let turn = degrees % 360.0;
    let quarters = (turn / 90.0).round();
    // Exact: both are multiples of the last place of the turn.
    let Radians(rest) = Degrees(turn - 90.0 * quarters).into();
    let (sin, cos) = libm::sincos(rest);
    match quarters.rem_euclid(4.0) {
        0.0 => (sin, cos),
        1.0 => (cos, -sin),
        2.0 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarter_turns_are_exact_and_others_turn_that_far() {
        for (degrees, image) in
            [(90.0, DVec3::Y), (-180.0, DVec3::NEG_X), (270.0, DVec3::NEG_Y), (720.0, DVec3::X)]
        {
            assert_eq!(rotation(DVec3::Z * degrees).transform_vector3(DVec3::X), image, "{degrees}");
        }
        // About x first: z goes to -y, which a turn about z by 90° takes to x.
        let both = rotation(DVec3::new(90.0, 0.0, 90.0));
        assert_eq!(both.transform_vector3(DVec3::Z), DVec3::X);
        for degrees in [1.0, 44.9, 45.1, 135.0, -200.0, 1e6] {
            let (sin, cos) = sin_cos(degrees);
            let radians = f64::to_radians(degrees % 360.0);
            // The reference rounds an angle of up to 2π.
            assert!((sin - libm::sin(radians)).abs() < 1e-15 && (cos - libm::cos(radians)).abs() < 1e-15);
        }
    }
}
