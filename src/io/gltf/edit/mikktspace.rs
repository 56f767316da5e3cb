//! Tangents by MikkTSpace (Mikkelsen, *Simulation of Wrinkled Surfaces Revisited*, 2008).

use bevy_mikktspace::{Geometry, Ops, TangentSpace, generate_tangents};
use glam::Vec3;

/// What tangents depend on, one entry a corner, three corners a triangle.
pub struct Surface {
    pub positions: Vec<[f32; 3]>,
    pub normals: Vec<Vec3>,
    /// As the texture shows them, v counted from the top of the image; not used if the surface has none.
    pub uvs: Vec<[f32; 2]>,
    /// With the handedness in `w`. The given ones stay where uv have no direction.
    pub tangents: Vec<[f32; 4]>,
}

impl Surface {
    pub fn generate(&mut self) {
        // The error type has no values.
        let _ = generate_tangents(self);
    }
}

/// The same bits on every platform.
struct Portable;

impl Ops for Portable {
    fn sqrt(x: f32) -> f32 {
        x.sqrt()
    }

    fn acos(x: f32) -> f32 {
        libm::acos(f64::from(x)) as f32
    }
}

impl Geometry<Portable> for Surface {
    fn num_faces(&self) -> usize {
        self.positions.len() / 3
    }

    fn num_vertices_of_face(&self, _face: usize) -> usize {
        3
    }

    fn position(&self, face: usize, vert: usize) -> [f32; 3] {
        self.positions[3 * face + vert]
    }

    fn normal(&self, face: usize, vert: usize) -> [f32; 3] {
        self.normals[3 * face + vert].to_array()
    }

    fn tex_coord(&self, face: usize, vert: usize) -> [f32; 2] {
        self.uvs[3 * face + vert]
    }

    fn set_tangent(&mut self, space: Option<TangentSpace>, face: usize, vert: usize) {
        let Some([x, y, z, w]) = space.map(|space| space.tangent_encoded()) else { return };
        let length = Vec3::new(x, y, z).length();
        if (length - 1.0).abs() < 1e-3 {
            // MikkTSpace counts v upwards.
            self.tangents[3 * face + vert] = [x / length, y / length, z / length, -w];
        }
    }
}

/// A unit vector perpendicular to a unit vector, with handedness 1.
pub fn perpendicular(normal: Vec3) -> [f32; 4] {
    let axis = if normal.x.abs() < 0.5 { Vec3::X } else { Vec3::Y };
    let [x, y, z] = axis.reject_from_normalized(normal).normalize_or(Vec3::X).to_array();
    [x, y, z, 1.0]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(uvs: [[f32; 2]; 4]) -> Vec<[f32; 4]> {
        let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        let order = [0, 1, 2, 0, 2, 3];
        let mut surface = Surface {
            positions: order.map(|v: usize| points[v]).to_vec(),
            normals: vec![Vec3::Z; 6],
            uvs: order.map(|v: usize| uvs[v]).to_vec(),
            tangents: vec![perpendicular(Vec3::Z); 6],
        };
        surface.generate();
        surface.tangents
    }

    #[test]
    fn a_plain_picture_on_a_square() {
        // glTF's v runs down the image: the picture is upright if v falls as y rises, and then the
        // bitangent w · n × t points up.
        let upright = square([[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]]);
        assert!(upright.iter().all(|&t| t == [1.0, 0.0, 0.0, 1.0]), "{upright:?}");
        let mirrored = square([[1.0, 1.0], [0.0, 1.0], [0.0, 0.0], [1.0, 0.0]]);
        assert!(mirrored.iter().all(|&t| t == [-1.0, 0.0, 0.0, -1.0]), "{mirrored:?}");
    }

    #[test]
    fn without_a_direction_in_uv_a_tangent_is_still_a_unit_vector() {
        for tangent in square([[0.5, 0.5]; 4]) {
            let length = Vec3::new(tangent[0], tangent[1], tangent[2]).length();
            assert!((length - 1.0).abs() < 1e-6 && tangent[3].abs() == 1.0 && tangent[2].abs() < 1e-6);
        }
    }
}
