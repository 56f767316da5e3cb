//! Rays through a mesh: whether they escape from a point, and how far the nearest face is.

use super::box_tree::{Bounds, BoxTree};
use super::polygon_mesh::Mesh;
use crate::num::unit_scale;
use glam::DVec3;

/// Hits closer than this, in units of the mesh's half size, are on the surface that the ray starts on.
const NEAR: f64 = 1e-9;

/// The faces of a mesh, in a tree of boxes, in units of the mesh's half size about its middle.
pub(crate) struct Obstacles<'a> {
    mesh: &'a Mesh,
    tree: BoxTree,
    middle: DVec3,
    scale: f64,
}

impl<'a> Obstacles<'a> {
    /// n log n in faces.
    pub(crate) fn new(mesh: &'a Mesh) -> Self {
        let (low, high) = mesh.bounds().unwrap_or_default();
        let middle = Bounds { low, high }.middle();
        let scale = unit_scale((high - middle).max(middle - low).max_element());
        let place = |vertex: u32| (mesh.position(vertex) - middle) * scale;
        let tree = BoxTree::build(mesh.face_count(), &|face| {
            Bounds::of(mesh.faces().face(face as usize).iter().map(|&vertex| place(vertex)))
        });
        Self { mesh, tree, middle, scale }
    }

    /// A point of the mesh's space in the units of this.
    pub(crate) fn local(&self, point: DVec3) -> DVec3 {
        (point - self.middle) * self.scale
    }

    /// The position of a vertex, in the units of this.
    pub(crate) fn place(&self, vertex: u32) -> DVec3 {
        self.local(self.mesh.position(vertex))
    }

    /// The fan of triangles of a face.
    pub(crate) fn triangles(&self, face: u32) -> impl Iterator<Item = [DVec3; 3]> {
        self.mesh.faces().fan(face).map(|triangle| triangle.map(|vertex| self.place(vertex)))
    }

    /// Whether a ray escapes from a point without meeting a face other than its `own`; `None` if that is undetermined after
    /// `budget` boxes and faces.
    pub(crate) fn is_free(&self, from: DVec3, direction: DVec3, own: u32, budget: usize) -> Option<bool> {
        let inverse = inverse(direction);
        let mut free = true;
        let enough = self.tree.visit(
            &mut { budget },
            |bounds| enters(bounds, from, inverse).is_some(),
            |face| {
                free = face == own || self.hits(face, from, direction).next().is_none();
                free
            },
        );
        (enough || !free).then_some(free)
    }

    /// The parameters, in lengths of the direction, at which a ray meets the fan of triangles of a face, on either side
    /// (T. Möller, B. Trumbore, *Fast, minimum storage ray/triangle intersection*, Journal of Graphics Tools 2(1), 1997).
    fn hits(&self, face: u32, from: DVec3, direction: DVec3) -> impl Iterator<Item = f64> {
        self.triangles(face).filter_map(move |[first, second, third]| {
            let [u, v] = [second - first, third - first];
            let p = direction.cross(v);
            let determinant = u.dot(p);
            if determinant == 0.0 {
                return None;
            }
            let t = from - first;
            let a = t.dot(p) / determinant;
            let q = t.cross(u);
            let b = direction.dot(q) / determinant;
            let far = v.dot(q) / determinant;
            (a >= 0.0 && b >= 0.0 && a + b <= 1.0 && far > NEAR).then_some(far)
        })
    }
}

/// For pictures: how far the nearest face is.
#[cfg(any(feature = "report", test))]
impl Obstacles<'_> {
    /// A direction of the mesh's space in the units of this.
    pub(crate) fn local_way(&self, way: DVec3) -> DVec3 {
        way * self.scale
    }

    /// The distance from a point to the nearest face other than its `own`, in lengths of the direction, if it is less than
    /// `most`; else `most`, also if it is undetermined after `budget` boxes and faces.
    pub(crate) fn clearance(
        &self,
        (from, direction): (DVec3, DVec3),
        own: u32,
        most: f64,
        budget: usize,
    ) -> f64 {
        let inverse = inverse(direction);
        let nearest = std::cell::Cell::new(most);
        let is_closer = |bounds| enters(bounds, from, inverse).is_some_and(|near| near < nearest.get());
        let enough = self.tree.visit(&mut { budget }, is_closer, |face| {
            if face != own {
                nearest.set(self.hits(face, from, direction).fold(nearest.get(), f64::min));
            }
            true
        });
        if enough { nearest.get() } else { most }
    }
}

/// One over each component, but finite for zero, so that no product is NaN.
fn inverse(direction: DVec3) -> [f64; 3] {
    direction.to_array().map(|x| 1.0 / if x.abs() < 1e-30 { 1e-30 } else { x })
}

/// The parameter, in lengths of the direction, at which a ray enters a box, if it does.
fn enters(bounds: Bounds, from: DVec3, inverse: [f64; 3]) -> Option<f64> {
    let (mut near, mut far) = (0.0_f64, f64::INFINITY);
    for axis in 0..3 {
        let [a, b] = [bounds.low, bounds.high].map(|p| (p[axis] - from[axis]) * inverse[axis]);
        near = near.max(a.min(b));
        far = far.min(a.max(b));
    }
    // Three roundings on either side.
    (near <= far * (1.0 + 6.0 * f64::EPSILON)).then_some(near)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Faces, MeshBuilder};

    #[test]
    fn rays_meet_what_is_in_their_way() {
        let square = |z: f64| [[-1., -1.], [1., -1.], [1., 1.], [-1., 1.]].map(|[x, y]| DVec3::new(x, y, z));
        let mut faces = Faces::new();
        (0..3).for_each(|i| faces.push(&[4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3]));
        let positions = [square(0.0), square(1.0), square(-3.0)].concat();
        for offset in [DVec3::ZERO, DVec3::splat(1e6)] {
            let positions = positions.iter().map(|&p| p + offset).collect();
            let mesh =
                MeshBuilder { positions, faces: faces.clone(), ..MeshBuilder::default() }.build().unwrap();
            let obstacles = Obstacles::new(&mesh);
            let from = obstacles.local(offset);
            let free = |direction: DVec3| obstacles.is_free(from, direction, 0, 1000);
            assert_eq!(free(DVec3::Z), Some(false));
            assert_eq!(free(DVec3::NEG_Z), Some(false));
            assert_eq!(free(DVec3::X), Some(true));
            // Past the rim of the upper one, which is met up to 45°.
            assert_eq!(free(DVec3::new(0.99, 0.0, 1.0)), Some(false));
            assert_eq!(free(DVec3::new(1.01, 0.0, 1.0)), Some(true));
            assert_eq!(obstacles.is_free(from, DVec3::X, 0, 0), None, "no budget");
            let clearance =
                |way: DVec3, budget| obstacles.clearance((from, obstacles.local_way(way)), 0, 9.0, budget);
            let ways = [DVec3::Z, DVec3::NEG_Z, 0.5 * DVec3::Z, DVec3::X, DVec3::new(0.5, 0.0, 1.0)];
            assert_eq!(ways.map(|way| clearance(way, 1000)), [1.0, 3.0, 2.0, 9.0, 1.0]);
            assert_eq!(clearance(DVec3::Z, 0), 9.0, "no budget");
        }
    }
}
