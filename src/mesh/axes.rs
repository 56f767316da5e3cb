//! Conversion between coordinate systems with other axes and units.

use super::polygon_mesh::Mesh;
use super::positions::Positions;
use super::transform::TransformFault;
use glam::{DMat4, DVec3};
use std::sync::Arc;

/// The axis that points up in a coordinate system.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum UpAxis {
    /// +x.
    X,
    /// +y, as in glTF.
    #[default]
    Y,
    /// +z, as in most CAD files.
    Z,
}

/// A rotation by a quarter turn, or none, with a change of units. It permutes the components of normals and changes signs,
/// so their bits stay the same.
///
/// ```
/// use crease::mesh::{AxisConversion, UpAxis};
/// use glam::DVec3;
///
/// let from_millimetres = AxisConversion::to_y_up(UpAxis::Z).scaled(0.001);
/// assert_eq!(from_millimetres.rotate(DVec3::new(0.1, 0.2, 0.3)), DVec3::new(0.1, 0.3, -0.2));
/// assert_eq!(from_millimetres.point(DVec3::Z * 1000.0), DVec3::Y);
/// assert_eq!(from_millimetres.inverse().point(DVec3::Y), DVec3::Z * 1000.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisConversion {
    /// For each component of the result: the component that it is, and its sign.
    sources: [(usize, f64); 3],
    scale: f64,
}

impl AxisConversion {
    /// Rotates an up axis to +y. From z up, z becomes y and y becomes −z; from x up, x becomes y and y becomes −x.
    pub fn to_y_up(up: UpAxis) -> Self {
        let sources = match up {
            UpAxis::X => [(1, -1.0), (0, 1.0), (2, 1.0)],
            UpAxis::Y => [(0, 1.0), (1, 1.0), (2, 1.0)],
            UpAxis::Z => [(0, 1.0), (2, 1.0), (1, -1.0)],
        };
        Self { sources, scale: 1.0 }
    }

    /// The same, then multiplied by a factor above 0.
    pub fn scaled(self, factor: f64) -> Self {
        Self { scale: self.scale * factor, ..self }
    }

    /// The conversion back.
    pub fn inverse(self) -> Self {
        let mut sources = self.sources;
        for (component, (source, sign)) in self.sources.into_iter().enumerate() {
            sources[source] = (component, sign);
        }
        Self { sources, scale: 1.0 / self.scale }
    }

    /// Whether positions stay unchanged.
    pub fn is_identity(self) -> bool {
        self == Self::to_y_up(UpAxis::Y)
    }

    /// The direction or normal that a direction or normal becomes.
    pub fn rotate(self, v: DVec3) -> DVec3 {
        // A difference from +0 keeps zeros positive.
        let component = |(source, sign): (usize, f64)| if sign < 0.0 { 0.0 - v[source] } else { v[source] };
        DVec3::from_array(self.sources.map(component))
    }

    /// The position that a position becomes.
    pub fn point(self, p: DVec3) -> DVec3 {
        self.rotate(p) * self.scale
    }

    /// The same as a matrix.
    pub fn matrix(self) -> DMat4 {
        let [x, y, z] = DVec3::AXES.map(|axis| self.point(axis).extend(0.0));
        DMat4::from_cols(x, y, z, glam::DVec4::W)
    }
}

impl Mesh {
    /// The mesh in another coordinate system: positions, normals and displacements of morph targets. Positions are rounded to the
    /// precision in which they are stored.
    ///
    /// # Errors
    /// If a position overflows.
    pub fn converted(&self, conversion: AxisConversion) -> Result<Mesh, TransformFault> {
        let storage = self.storage();
        let points = self.positions().iter().map(|p| conversion.point(p)).collect();
        let positions = Positions::rounded(points, storage);
        if positions.view().first_non_finite().is_some() {
            return Err(TransformFault::Overflow);
        }
        let mut converted = self.clone();
        converted.positions = Arc::new(positions);
        let columns = &mut converted.columns;
        for displacement in columns.morph_targets.iter_mut().flatten() {
            *displacement = conversion.point(*displacement);
        }
        for normal in columns.normals.iter_mut().flat_map(|normals| &mut normals.values) {
            *normal = conversion.rotate(*normal);
        }
        Ok(converted)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Faces, MeshBuilder};
    use glam::DMat3;

    const ALL: [UpAxis; 3] = [UpAxis::X, UpAxis::Y, UpAxis::Z];

    #[test]
    fn conversions_rotate_and_their_inverses_undo_them() {
        for (up, axis) in ALL.into_iter().zip(DVec3::AXES) {
            let there = AxisConversion::to_y_up(up).scaled(0.25);
            assert_eq!(there.rotate(axis), DVec3::Y);
            assert_eq!(DMat3::from_mat4(there.matrix()).determinant(), 0.25 * 0.25 * 0.25, "no mirror");
            let point = DVec3::new(1.0, -2.0, 3.5);
            assert_eq!(there.matrix().transform_point3(point), there.point(point));
            assert_eq!(there.inverse().point(there.point(point)), point);
            assert_eq!(there.inverse().rotate(DVec3::Y), axis);
            assert_eq!(AxisConversion::to_y_up(up).is_identity(), up == UpAxis::Y);
        }
    }

    #[test]
    fn millimetres_become_metres_in_the_stored_precision() {
        let positions = vec![[1.0_f32, 2.0, 3.0], [0.1, 0.0, 0.0], [0.0, 7.0, -0.0]];
        let faces = Faces::triangles(vec![0, 1, 2]);
        let mesh = MeshBuilder { positions: positions.into(), faces, ..MeshBuilder::default() };
        let mesh = mesh.build().unwrap();
        let converted = mesh.converted(AxisConversion::to_y_up(UpAxis::Z).scaled(0.001)).unwrap();
        // The f32 nearest to 0.1 is a little larger than 0.1.
        let tenth = (f64::from(0.1_f32) * 0.001) as f32;
        let expected = vec![[0.001_f32, 0.003, -0.002], [tenth, 0.0, 0.0], [0.0, 0.0, -0.007]];
        assert_eq!(converted.positions(), Positions::from(expected).view());
        let huge = mesh.converted(AxisConversion::to_y_up(UpAxis::Y).scaled(1e38));
        assert_eq!(huge.err(), Some(TransformFault::Overflow), "7e38 is beyond f32");
    }
}
