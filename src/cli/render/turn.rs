//! Turning the objects of a scene.

use crease::num::{Degrees, UnitVec3};
use crease::raster::{Camera, SceneFile, rotation};
use glam::{DMat3, DMat4, DVec3};

/// The rotation by an angle about a vector, counter-clockwise as seen from its tip.
pub fn about(axis: DVec3, Degrees(degrees): Degrees) -> DMat4 {
    let turned = rotation(DVec3::Y * degrees);
    match UnitVec3::new(axis).map(UnitVec3::get) {
        None | Some(DVec3::Y) => turned,
        Some(axis) => {
            // Into a space where the axis is y, and back.
            let z = axis.any_orthonormal_vector();
            let from_upright = DMat3::from_cols(axis.cross(z), axis, z);
            DMat4::from_mat3(from_upright) * turned * DMat4::from_mat3(from_upright.transpose())
        }
    }
}

/// The point that objects are turned about: the middle of the box around them, and where there is none the point that
/// the camera looks at.
pub fn pivot(file: &SceneFile) -> DVec3 {
    let scene = file.scene();
    scene.bounds().map_or(scene.camera.target, |(low, high)| low * 0.5 + high * 0.5)
}

/// The file's camera, or one that holds the objects however they are turned about their upright axis.
pub fn camera(file: &SceneFile) -> Camera {
    let scene = file.scene();
    let [width, height] = file.settings.size.map(f64::from);
    let turned = if file.camera.is_none() { scene.framing_turned(width / height) } else { None };
    turned.unwrap_or(scene.camera)
}

pub fn turn(file: &mut SceneFile, rotation: DMat4, pivot: DVec3) {
    let map = DMat4::from_translation(pivot) * rotation * DMat4::from_translation(-pivot);
    for object in &mut file.objects {
        object.transform = map * object.transform;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_turn_is_a_rotation_about_its_axis() {
        assert_eq!(about(DVec3::Y * 3.0, Degrees(90.0)).transform_vector3(DVec3::Z), DVec3::X);
        for axis in [DVec3::X, DVec3::Z, DVec3::NEG_Y, DVec3::new(1.0, -2.0, 0.5)] {
            let unit = axis.normalize();
            let turned = DMat3::from_mat4(about(axis, Degrees(77.0)));
            // Sums of three products of numbers up to 1, three times over.
            assert!((turned * turned.transpose()).abs_diff_eq(DMat3::IDENTITY, 4e-15), "{axis}");
            assert!((turned.determinant() - 1.0).abs() < 4e-15 && (turned * unit).abs_diff_eq(unit, 4e-15));
            // Rodrigues: a vector square to the axis goes towards axis × vector.
            let across = unit.any_orthonormal_vector();
            // sin 77° = 0.97437
            assert!(((turned * across).dot(unit.cross(across)) - 0.974_37).abs() < 1e-6, "{axis}");
        }
    }
}
