//! Whether a closed surface faces outwards: the sign of its volume.

use crate::mesh::box_tree::Bounds;
use crate::mesh::polygon_mesh::Mesh;
use crate::mesh::transform::permanent;
use crate::num::{CompensatedSum, unit_scale};
use glam::DVec3;
use rayon::prelude::*;

/// Whether a closed component faces outwards, once its faces agree with its lowest one. `None` if the volume is not above
/// its rounding error (a flat component), or not above the part that depends on how non-planar polygons are triangulated
/// (a sheet with two sides).
///
/// The volume is the sum of the tetrahedra between the faces and the middle of the component's box, in units of the box's
/// size, so that neither size nor distance from the origin matters.
pub(super) fn faces_outward(mesh: &Mesh, faces: &[u32], against: &[bool], bounds: Bounds) -> Option<bool> {
    /// Faces of a task; fixed, so that partial sums do not depend on the number of threads.
    const BLOCK: usize = 1 << 13;
    let middle = bounds.middle();
    let scale = unit_scale((bounds.high - middle).max(middle - bounds.low).max_element());
    let place = |vertex: u32| (mesh.position(vertex) - middle) * scale;
    let sums: Vec<Sums> = faces
        .par_chunks(BLOCK)
        .map(|block| {
            let mut sums = Sums::default();
            for &face in block {
                let sign = if against[face as usize] { -1.0 } else { 1.0 };
                for triangle in mesh.faces().fan(face) {
                    sums.add_triangle(triangle.map(place), sign);
                }
                let corners = mesh.faces().face(face as usize);
                for quad in corners[1..].windows(3) {
                    sums.add_quad([corners[0], quad[0], quad[1], quad[2]].map(place));
                }
            }
            sums
        })
        .collect();
    let mut total = Sums::default();
    sums.into_iter().for_each(|sums| total.merge(sums));
    total.sign()
}

/// Sums over the triangles of a surface, relative to a point inside its box and in units of that box.
#[derive(Default)]
struct Sums {
    /// Six times the volume.
    volume: CompensatedSum,
    /// Twice the vector area: zero for a surface without gaps.
    area: [CompensatedSum; 3],
    /// Six times the volume with all products counted as positive; rounding errors are proportional to it.
    magnitude: f64,
    /// Six times the volume between both ways to cut polygons along a diagonal.
    between_cuts: f64,
}

impl Sums {
    fn add_triangle(&mut self, [a, b, c]: [DVec3; 3], sign: f64) {
        self.volume += sign * a.dot(b.cross(c));
        let area = sign * (b - a).cross(c - a);
        self.area.iter_mut().zip(area.to_array()).for_each(|(sum, term)| *sum += term);
        self.magnitude += permanent(a, b, c);
    }

    fn add_quad(&mut self, [a, b, c, d]: [DVec3; 4]) {
        self.between_cuts += (b - a).dot((c - a).cross(d - a)).abs();
    }

    fn merge(&mut self, other: Sums) {
        self.volume += other.volume;
        self.area.iter_mut().zip(other.area).for_each(|(sum, term)| *sum += term);
        self.magnitude += other.magnitude;
        self.between_cuts += other.between_cuts;
    }

    fn sign(&self) -> Option<bool> {
        // Three rounded differences, two products and three sums: 8 roundings of ε/2 to first order; twice that.
        let rounding = 8.0 * f64::EPSILON * self.magnitude;
        // If edges meet only within the welding distance, the volume depends on the reference point, which could be
        // any other of the box, which is less than 2 wide.
        let gaps = 2.0 * 3f64.sqrt() * DVec3::from(self.area.map(CompensatedSum::value)).length();
        let volume = self.volume.value();
        (volume.abs() > rounding + gaps + self.between_cuts).then_some(volume > 0.0)
    }
}
