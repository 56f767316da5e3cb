//! Affine maps of meshes: their effect on normals and on the winding of faces.

use super::face_edit::FaceEdit;
use super::polygon_mesh::Mesh;
use crate::num::unit_scale;
use glam::{DMat3, DMat4, DVec3};
use std::sync::Arc;

/// How normals follow a linear map of positions: by its inverse transpose.
///
/// A map that mirrors ([`mirrored`](Self::mirrored)) turns counter-clockwise faces into clockwise ones: reverse them. The
/// normals returned here agree with the reversed faces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NormalMatrix {
    /// Cofactors of the map with its columns scaled to about one.
    cofactors: DMat3,
    /// What the columns were scaled by, up to a common factor.
    scale: DVec3,
    mirrored: bool,
}

/// The normal matrix of a linear map, or `None` if the map is singular (it flattens space).
///
/// The inverse transpose is cofactors over determinant. The determinant only contributes its sign, as normals are
/// renormalised, so nothing is divided by a small number; and columns are scaled by powers of two first, so that
/// neither small nor large scales under- or overflow. A map counts as singular if its determinant may differ from 0 by
/// rounding alone.
///
/// ```
/// use crease::mesh::normal_matrix;
/// use glam::{DMat3, DVec3};
///
/// let squeeze = normal_matrix(DMat3::from_diagonal(DVec3::new(1e-200, 1.0, -1.0))).unwrap();
/// assert!(squeeze.mirrored());
/// assert_eq!(squeeze.apply(DVec3::Z), Some(DVec3::NEG_Z));
/// assert_eq!(normal_matrix(DMat3::from_diagonal(DVec3::new(1.0, 0.0, 1.0))), None);
/// ```
pub fn normal_matrix(map: DMat3) -> Option<NormalMatrix> {
    if !map.is_finite() {
        return None;
    }
    let columns = [map.x_axis, map.y_axis, map.z_axis];
    let scale = columns.map(|column| unit_scale(column.abs().max_element()));
    let [x, y, z] = [0, 1, 2].map(|k| columns[k] * scale[k]);
    let cofactors = DMat3::from_cols(y.cross(z), z.cross(x), x.cross(y));
    let determinant = x.dot(cofactors.x_axis);
    // Each of the six products is rounded five times.
    if determinant.abs() <= 5.0 * f64::EPSILON * permanent(x, y, z) {
        return None;
    }
    let largest = scale.into_iter().fold(0.0, f64::max);
    let sign = determinant.signum();
    let scale = DVec3::from_array(scale) / largest;
    Some(NormalMatrix { cofactors: cofactors * sign, scale, mirrored: sign < 0.0 })
}

/// The determinant of three rows with every product counted as positive.
pub(crate) fn permanent(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    let (a, b, c) = (a.abs(), b.abs(), c.abs());
    a.x * (b.y * c.z + b.z * c.y) + a.y * (b.z * c.x + b.x * c.z) + a.z * (b.x * c.y + b.y * c.x)
}

impl NormalMatrix {
    /// Whether the map mirrors.
    pub fn mirrored(&self) -> bool {
        self.mirrored
    }

    /// The unit normal that a normal becomes; `None` for one that is zero or not finite.
    pub fn apply(&self, normal: DVec3) -> Option<DVec3> {
        let scaled = normal * self.scale;
        let scaled = scaled * unit_scale(scaled.abs().max_element());
        let moved = self.cofactors * scaled;
        (moved * unit_scale(moved.abs().max_element())).try_normalize()
    }
}

/// Why [`Mesh::transformed`] fails.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TransformFault {
    /// A position is no longer finite.
    Overflow,
}

impl Mesh {
    /// The mesh moved by an affine map: positions, normals, displacements of morph targets. A map that mirrors reverses
    /// all faces. Normals are lost if the map is singular. Anything but the identity makes doubles of the positions.
    ///
    /// # Errors
    /// If a position overflows.
    pub fn transformed(&self, map: DMat4) -> Result<Mesh, TransformFault> {
        if map == DMat4::IDENTITY {
            return Ok(self.clone());
        }
        let linear = DMat3::from_mat4(map);
        let normals = normal_matrix(linear);
        let is_mirrored = normals.is_some_and(|normals| normals.mirrored());
        let count = if is_mirrored { self.face_count() as u32 } else { 0 };
        let mut moved = self.with_faces(&FaceEdit { reversed: (0..count).collect(), ..FaceEdit::default() });
        let mut positions = self.positions().to_vec();
        for position in &mut positions {
            *position = map.transform_point3(*position);
            if !position.is_finite() {
                return Err(TransformFault::Overflow);
            }
        }
        moved.positions = Arc::new(positions.into());
        for displacement in moved.columns.morph_targets.iter_mut().flatten() {
            *displacement = linear * *displacement;
        }
        match normals {
            Some(matrix) => {
                for normal in moved.columns.normals.iter_mut().flat_map(|normals| &mut normals.values) {
                    // A stored normal without direction stays unchanged.
                    *normal = matrix.apply(*normal).unwrap_or(*normal);
                }
            }
            None => moved.columns.normals = None,
        }
        Ok(moved)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Column, Faces, MeshBuilder, Storage};

    /// The vector area of a triangle's image, which is what its normal must be parallel to.
    fn image_normal(map: DMat3, a: DVec3, b: DVec3) -> DVec3 {
        (map * a).cross(map * b).normalize()
    }

    fn maps() -> Vec<DMat3> {
        let shear = DMat3::from_cols(
            DVec3::new(1.0, 0.2, 0.0),
            DVec3::new(0.7, 2.0, 0.1),
            DVec3::new(0.0, -0.4, 0.5),
        );
        vec![
            DMat3::IDENTITY,
            shear,
            shear * DMat3::from_diagonal(DVec3::new(1.0, -1.0, 1.0)),
            DMat3::from_diagonal(DVec3::new(-3.0, -0.25, -1.0)),
            DMat3::from_rotation_y(0.3) * DMat3::from_diagonal(DVec3::new(5.0, 0.1, 1.0)),
        ]
    }

    #[test]
    fn normals_stay_perpendicular_and_agree_with_the_way_round() {
        for map in maps() {
            let matrix = normal_matrix(map).unwrap();
            assert_eq!(matrix.mirrored(), map.determinant() < 0.0);
            for (a, b) in [(DVec3::X, DVec3::Y), (DVec3::new(1.0, 2.0, 3.0), DVec3::new(-1.0, 0.5, 2.0))] {
                let moved = matrix.apply(a.cross(b).normalize()).unwrap();
                let truth = image_normal(map, a, b) * if matrix.mirrored() { -1.0 } else { 1.0 };
                // Two normalisations and a product of condition below 50.
                assert!((moved - truth).length() < 1e-14, "{map}: {moved} is not {truth}");
            }
        }
    }

    #[test]
    fn scale_does_not_matter() {
        let normal = DVec3::new(0.6, 0.0, 0.8);
        for map in maps() {
            let expected = normal_matrix(map).unwrap().apply(normal);
            for exponent in [-1000, -500, -100, 100, 500, 1000] {
                let scaled = normal_matrix(map * libm::ldexp(1.0, exponent)).unwrap();
                assert_eq!(scaled.apply(normal), expected, "2^{exponent}");
            }
        }
        let uneven = normal_matrix(DMat3::from_diagonal(DVec3::new(1e-200, 1e-200, 1e200))).unwrap();
        assert_eq!(uneven.apply(DVec3::new(0.6, 0.8, 0.0)), Some(DVec3::new(0.6, 0.8, 0.0)));
    }

    #[test]
    fn flat_maps_are_singular() {
        for map in [
            DMat3::ZERO,
            DMat3::from_diagonal(DVec3::new(1.0, 1.0, 0.0)),
            DMat3::from_cols(DVec3::new(1.0, 2.0, 3.0), DVec3::new(4.0, 5.0, 6.0), DVec3::new(7.0, 8.0, 9.0)),
            DMat3::from_cols(DVec3::splat(0.1), DVec3::splat(0.3), DVec3::X),
            DMat3::from_diagonal(DVec3::new(1.0, f64::NAN, 1.0)),
        ] {
            assert_eq!(normal_matrix(map), None, "{map}");
        }
        assert!(normal_matrix(DMat3::from_diagonal(DVec3::new(1.0, 1.0, 1e-300))).is_some());
    }

    #[test]
    fn a_mirrored_mesh_turns_its_faces() {
        let mesh = MeshBuilder {
            positions: vec![[0.0_f32; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].into(),
            faces: Faces::triangles(vec![0, 1, 2]),
            ..MeshBuilder::default()
        };
        let mesh =
            mesh.build().unwrap().with_normals(Some(Column::per_corner(vec![DVec3::Z], vec![0, 0, 0])));
        let moved = mesh.transformed(DMat4::from_scale(DVec3::new(1.0, 1.0, -1.0))).unwrap();
        assert_eq!(moved.faces().corners(), [0, 2, 1]);
        assert_eq!(moved.columns().normals.as_ref().unwrap().values, [DVec3::NEG_Z]);
        assert_eq!(moved.storage(), Storage::F64);
        assert_eq!(mesh.transformed(DMat4::IDENTITY), Ok(mesh.clone()));
        assert!(
            mesh.transformed(DMat4::from_scale(DVec3::new(1.0, 1.0, 0.0)))
                .unwrap()
                .columns()
                .normals
                .is_none()
        );
        let far = DMat4::from_scale(DVec3::splat(1e308)) * DMat4::from_scale(DVec3::splat(1e308));
        assert_eq!(mesh.transformed(far), Err(TransformFault::Overflow));
    }
}
