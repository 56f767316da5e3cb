//! Tangents of a new file, for faces whose material has a normal texture.

use super::pieces::Group;
use crate::io::gltf::edit::mikktspace::{Surface, perpendicular};
use crate::mesh::{Mesh, NONE};
use glam::Vec3;
use rustc_hash::FxHashMap;

/// Tangents, of which corners share those that agree to the bit.
pub struct NewTangents {
    /// With the handedness in `w`.
    values: Vec<[f32; 4]>,
    /// The number of each corner's tangent; [`NONE`] where there is none.
    pub of_corner: Vec<u32>,
}

impl NewTangents {
    /// The tangent of every written vertex; +x where there is none, as accessors have a value for each vertex.
    pub fn of_vertices(&self, vertex_of: &[u32], count: usize) -> Vec<[f32; 4]> {
        let mut values = vec![[1.0, 0.0, 0.0, 1.0]; count];
        for (&vertex, &number) in vertex_of.iter().zip(&self.of_corner) {
            if let Some(tangent) = self.values.get(number as usize) {
                values[vertex as usize] = *tangent;
            }
        }
        values
    }
}

/// Tangents by MikkTSpace for the groups of triangles that need them; `None` if no group with normals does. A corner of a polygon
/// has the tangent of its first triangle. Corners without texture coordinates have those of the origin.
pub fn new_tangents(
    mesh: &Mesh,
    groups: &[(Group, Option<Vec<u32>>)],
    is_needed: impl Fn(&Group) -> bool,
) -> Option<NewTangents> {
    let columns = mesh.columns();
    let (normals, uvs) = (columns.normals.as_ref()?, columns.uvs.as_ref()?);
    let mut tangents = NewTangents { values: Vec::new(), of_corner: Vec::new() };
    let mut numbers = FxHashMap::default();
    for (_, corners) in groups.iter().filter(|(group, _)| !group.flat && is_needed(group)) {
        let all = || (0..mesh.faces().corners().len() as u32).collect();
        let corners = corners.clone().unwrap_or_else(all);
        let vertex = |&corner: &u32| mesh.faces().corners()[corner as usize];
        let normal =
            |corner: &u32| normals.get(*corner as usize, vertex(corner)).map(|normal| normal.as_vec3());
        // glTF counts v from the top of the image.
        let finite = |x: f64| if (x as f32).is_finite() { x as f32 } else { 0.0 };
        let uv = |corner: &u32| match uvs.get(*corner as usize, vertex(corner)) {
            Some(uv) => [finite(uv.x), finite(1.0 - uv.y)],
            None => [0.0; 2],
        };
        let normals: Vec<Vec3> = corners.iter().map(|corner| normal(corner).unwrap_or(Vec3::Z)).collect();
        let mut surface = Surface {
            positions: corners.iter().map(|c| mesh.position(vertex(c)).as_vec3().to_array()).collect(),
            uvs: corners.iter().map(uv).collect(),
            tangents: normals.iter().map(|&normal| perpendicular(normal)).collect(),
            normals,
        };
        surface.generate();
        tangents.of_corner.resize(mesh.faces().corners().len(), NONE);
        for (&corner, tangent) in corners.iter().zip(surface.tangents) {
            let number = &mut tangents.of_corner[corner as usize];
            if *number == NONE {
                let next = tangents.values.len() as u32;
                *number = *numbers.entry(tangent.map(f32::to_bits)).or_insert(next);
                if *number == next {
                    tangents.values.push(tangent);
                }
            }
        }
    }
    (!tangents.of_corner.is_empty()).then_some(tangents)
}
