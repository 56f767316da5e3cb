//! Curved triangles over those of a mesh, from its normals alone.

use super::super::prelude::*;
use crate::mesh::{Topology, Weld, triangulate};
use crate::num::UnitVec3;

/// The mesh with every triangle as a Bézier triangle of third order, cut into parts² flat ones (A. Vlachos et al., *Curved PN
/// triangles*, I3D 2001). At the corners it has the positions of the mesh, and its edges leave at right angles to the
/// normals there. Faces of more than three corners are cut into triangles first.
///
/// One rule is not from the paper, which leaves a crack where the two sides of an edge have different normals. Here the
/// edge leaves each end at right angles to both normals, along the crease: both sides compute the same edge. So the
/// edges of a box stay straight, and the rim of a cylinder becomes round.
///
/// Normals are interpolated linearly, not quadratically as in the paper, so that only the shape differs from flat
/// triangles.
pub(super) fn curved(mesh: &Mesh, field: &NormalField, parts: u32) -> TriangleMesh {
    let edges = Edges { mesh, field, topology: Topology::build(mesh, Weld::default()) };
    let (mut positions, mut normals, mut triangles) = (Vec::new(), Vec::new(), Vec::new());
    for corners in triangulate(mesh).triangles {
        let patch = Patch::new(&edges, corners);
        let corner_normals = corners.map(|corner| edges.normal(corner));
        let first = positions.len() as u32;
        for (row, column) in (0..=parts).flat_map(|row| (0..=parts - row).map(move |column| (row, column))) {
            let share = [parts - row - column, column, row].map(|k| f64::from(k) / f64::from(parts));
            positions.push(patch.at(share));
            let normal: DVec3 = corner_normals.iter().zip(share).map(|(&normal, share)| normal * share).sum();
            normals.push(UnitVec3::new(normal).map_or(corner_normals[0], UnitVec3::get));
        }
        triangles.extend(small_triangles(parts).map(|triangle| triangle.map(|vertex| first + vertex)));
    }
    TriangleMesh::new(&positions, triangles, &normals)
}

/// The triangles of a triangle in rows of vertices, the longest of them first.
fn small_triangles(parts: u32) -> impl Iterator<Item = [u32; 3]> {
    // The rows before hold parts + 1, parts, … vertices.
    let start = move |row: u32| row * (parts + 1) - row * row.saturating_sub(1) / 2;
    (0..parts).flat_map(move |row| {
        let (low, high) = (start(row), start(row + 1));
        let upright = (0..parts - row).map(move |k| [low + k, low + k + 1, high + k]);
        let hanging = (1..parts - row).map(move |k| [low + k, high + k, high + k - 1]);
        upright.chain(hanging)
    })
}

/// What an edge needs to know of the faces on both of its sides.
struct Edges<'a> {
    mesh: &'a Mesh,
    field: &'a NormalField,
    topology: Topology,
}

impl Edges<'_> {
    fn vertex(&self, corner: u32) -> u32 {
        self.mesh.faces().corners()[corner as usize]
    }

    fn position(&self, corner: u32) -> DVec3 {
        self.mesh.positions().at(self.vertex(corner))
    }

    fn normal(&self, corner: u32) -> DVec3 {
        let normal = self.field.normals.get(corner as usize, self.vertex(corner));
        *normal.expect("a field has a normal for every corner")
    }

    /// The normal at a corner on the other side of the edge to another corner of its face, if the edge has one.
    fn beyond(&self, corner: u32, to: u32) -> Option<DVec3> {
        let topology = &self.topology;
        let other = if topology.next(corner) == to {
            topology.next(topology.across(corner)?)
        } else if topology.next(to) == corner {
            topology.across(to)?
        } else {
            // A diagonal: both sides are of one face.
            return None;
        };
        Some(self.normal(other))
    }

    /// The control point of the edge between two corners that is next to the first.
    fn control(&self, corner: u32, to: u32) -> DVec3 {
        /// Sine of the least angle between normals that determines the direction of a crease.
        const LEAST: f64 = 0.01;
        let (place, normal) = (self.position(corner), self.normal(corner));
        let third = (self.position(to) - place) / 3.0;
        let crease = self.beyond(corner, to).map(|beyond| normal.cross(beyond));
        place
            + match crease.filter(|crease| crease.length() > LEAST) {
                Some(crease) => third.project_onto(crease),
                None => third - normal * third.dot(normal),
            }
    }
}

struct Patch {
    corners: [DVec3; 3],
    /// Next to corner i on the edges to the following corner and to the one before.
    edges: [[DVec3; 2]; 3],
    middle: DVec3,
}

impl Patch {
    fn new(edges: &Edges, corners: [u32; 3]) -> Self {
        let control = |i: usize| [1, 2].map(|step| edges.control(corners[i], corners[(i + step) % 3]));
        let points = corners.map(|corner| edges.position(corner));
        let controls = [0, 1, 2].map(control);
        let of_edges = controls.as_flattened().iter().sum::<DVec3>() / 6.0;
        let of_corners = points.iter().sum::<DVec3>() / 3.0;
        // Second order is reproduced with this middle.
        Self { corners: points, edges: controls, middle: of_edges + (of_edges - of_corners) * 0.5 }
    }

    /// The point at shares of the three corners. The order of terms gives a point of an edge the same bits from both sides.
    fn at(&self, share: [f64; 3]) -> DVec3 {
        let corner = |i: usize| self.corners[i] * (share[i] * share[i] * share[i]);
        let edge = |i: usize, step: usize| {
            self.edges[i][step - 1] * (3.0 * share[i] * share[i] * share[(i + step) % 3])
        };
        let corners = corner(0) + corner(1) + corner(2);
        // Two terms of each edge.
        let edges = (edge(0, 1) + edge(1, 2)) + (edge(1, 1) + edge(2, 2)) + (edge(2, 1) + edge(0, 2));
        corners + edges + self.middle * (6.0 * share[0] * share[1] * share[2])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Faces, MeshBuilder};
    use crate::normals::{NormalRecipe, compute};
    use crate::surface::{Pattern, Sphere, Surface, Tessellation};
    use std::collections::BTreeMap;
    use std::f64::consts::TAU;

    fn places(body: &TriangleMesh) -> impl Iterator<Item = DVec3> {
        body.positions.iter().map(|point| DVec3::from(point.map(f64::from)))
    }

    /// Prism of a circle's corners with caps of one face each.
    fn cylinder(segments: u32) -> Mesh {
        let ring = |y: f64| {
            (0..segments).map(move |k| {
                let (sine, cosine) = libm::sincos(TAU * f64::from(k) / f64::from(segments));
                DVec3::new(sine, y, cosine)
            })
        };
        let mut faces = Faces::new();
        for k in 0..segments {
            let next = (k + 1) % segments;
            faces.push(&[k, next, next + segments, k + segments]);
        }
        faces.push(&(0..segments).rev().collect::<Vec<_>>());
        faces.push(&(segments..2 * segments).collect::<Vec<_>>());
        MeshBuilder { positions: ring(-0.5).chain(ring(0.5)).collect(), faces, ..MeshBuilder::default() }
            .build()
            .unwrap()
    }

    #[test]
    fn a_ball_becomes_rounder_in_fourth_order() {
        let error = |level| {
            let tessellation = Tessellation { pattern: Pattern::Icosphere(level), ..Tessellation::default() };
            let mesh = Surface::from(Sphere::default()).tessellate(&tessellation).unwrap();
            let mut field = compute(&mesh, &NormalRecipe::default());
            // Max' weights or these: the ball's own.
            for (entry, normal) in field.normals.values.iter_mut().enumerate() {
                *normal = mesh.positions().at(field.entry_vertex[entry]).normalize();
            }
            places(&curved(&mesh, &field, 4)).map(|point| (point.length() - 1.0).abs()).fold(0.0, f64::max)
        };
        let [coarse, fine] = [1, 2].map(error);
        // Flat triangles of level 1 lie 0.074 within, of level 2 0.019.
        assert!(coarse < 0.006, "{coarse}");
        assert!(coarse / fine > 10.0, "{coarse} {fine}");
    }

    #[test]
    fn rims_become_round_and_caps_stay_flat() {
        let mesh = cylinder(12);
        let body = curved(&mesh, &compute(&mesh, &NormalRecipe::default()), 4);
        // Flat sides reach in to cos 15° = 0.966. The cubic has the circle's tangents, but those of a third of a chord are a
        // little too short.
        let sides = places(&body).zip(&body.normals).filter(|(_, normal)| normal[1].abs() < 0.5);
        let radius = sides.map(|(point, _)| libm::hypot(point.x, point.z));
        let (low, high) = radius.fold((2.0, 0.0), |(low, high): (f64, f64), r| (low.min(r), high.max(r)));
        assert!(low > 0.995 && high < 1.0 + 1e-6, "{low} {high}");
        assert!(places(&body).all(|point| point.y.abs() < 0.5 + 1e-6));
    }

    /// Every small edge of a closed mesh is met by one the other way, to the bit.
    #[test]
    fn there_are_no_cracks() {
        for segments in [3, 5, 8] {
            let mesh = cylinder(segments);
            let body = curved(&mesh, &compute(&mesh, &NormalRecipe::default()), 3);
            let mut edges: BTreeMap<[[u32; 3]; 2], i32> = BTreeMap::new();
            for triangle in &body.triangles {
                let places =
                    triangle.map(|vertex| body.positions[vertex as usize].map(|x| (x + 0.0).to_bits()));
                for (a, b) in [(0, 1), (1, 2), (2, 0)] {
                    *edges.entry([places[a], places[b]]).or_default() += 1;
                    *edges.entry([places[b], places[a]]).or_default() -= 1;
                }
            }
            assert!(edges.values().all(|&balance| balance == 0), "{segments}");
        }
    }

    #[test]
    fn boxes_stay_boxes() {
        let mesh = cylinder(4);
        let body = curved(&mesh, &compute(&mesh, &NormalRecipe::default()), 5);
        // Single precision of numbers up to 1.
        for point in places(&body) {
            let beyond = (point.x.abs() + point.z.abs() - 1.0).max(point.y.abs() - 0.5);
            assert!(beyond < 2e-7, "{point}");
        }
        assert_eq!(body.triangles.len(), 12 * 25);
    }
}
