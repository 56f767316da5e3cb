//! Points of a surface, and the triangles that the rays from them cross.

use crate::mesh::polygon_mesh::Mesh;
use crate::mesh::transform::permanent;
use crate::num::unit_scale;
use glam::DVec3;

/// A point that may lie in a shell.
pub(super) struct Probe {
    pub(super) at: DVec3,
    /// Bound on the error of each coordinate.
    pub(super) blur: f64,
}

/// Points spread over a surface, coordinates times `scale`: one corner and one inner point of each face that reaches
/// furthest along an axis and of six more, evenly spread over the list.
///
/// Corners are exact and reach furthest, but in models on a grid they tend to lie exactly below edges of others;
/// inner points hardly ever do.
pub(super) fn probes(mesh: &Mesh, faces: &[u32], scale: f64) -> Vec<Probe> {
    const SPREAD: usize = 6;
    let mut chosen: Vec<(u32, u32)> = Vec::with_capacity(12);
    for (axis, sign) in (0..3).flat_map(|axis| [(axis, -1.0), (axis, 1.0)]) {
        let corners = faces.iter().flat_map(|&f| mesh.faces().face(f as usize).iter().map(move |&v| (f, v)));
        chosen.extend(corners.reduce(|best, corner| {
            let is_further = sign * mesh.position(corner.1)[axis] > sign * mesh.position(best.1)[axis];
            if is_further { corner } else { best }
        }));
    }
    chosen.extend((0..SPREAD).map(|i| {
        let face = faces[i * (faces.len() - 1) / (SPREAD - 1)];
        (face, mesh.faces().face(face as usize)[0])
    }));
    chosen.sort_unstable();
    chosen.dedup_by_key(|(face, _)| *face);
    let mut probes = Vec::with_capacity(2 * chosen.len());
    for (face, vertex) in chosen {
        probes.push(Probe { at: scale * mesh.position(vertex), blur: 0.0 });
        let corners = mesh.faces().face(face as usize);
        let [a, b, c] = [0, 1, 2].map(|corner| scale * mesh.position(corners[corner]));
        // Uneven shares, so that no symmetry of the model puts the point below an edge. Three products and two
        // sums of what is no larger than the largest coordinate.
        let at = 0.6171875 * a + 0.0859375 * b + 0.296875 * c;
        let largest = a.abs().max(b.abs()).max(c.abs()).max_element();
        probes.push(Probe { at, blur: 4.0 * f64::EPSILON * largest });
    }
    probes
}

impl Probe {
    /// How the ray upwards crosses a triangle: 1 if it comes out through its front, −1 if through its back, 0 if
    /// it misses it; `None` if the point is too close to the triangle, or the ray to one of its edges.
    pub(super) fn crossing(&self, a: DVec3, b: DVec3, c: DVec3) -> Option<i32> {
        let (a, b, c) = (a - self.at, b - self.at, c - self.at);
        // Triangles far smaller than the mesh must not lose their products below the range of a double.
        let unit = unit_scale(a.abs().max(b.abs()).max(c.abs()).max_element());
        let (a, b, c, blur) = (unit * a, unit * b, unit * c, unit * self.blur);
        let winding = winding(a, b, blur)? + winding(b, c, blur)? + winding(c, a, blur)?;
        if winding == 0 {
            return Some(0);
        }
        // Six times the volume of the tetrahedron below the triangle. The constant covers Shewchuk's 7 + 56ε
        // half-ulps of the permanent (1997, orient3d, first bound).
        let height = a.dot(b.cross(c));
        let reach = (b - a).abs().element_sum() * (c - a).abs().element_sum();
        let error = 4.0 * f64::EPSILON * permanent(a, b, c) + 4.0 * blur * reach;
        if height.abs() <= error + f64::MIN_POSITIVE {
            return None;
        }
        Some(if (height > 0.0) == (winding > 0) { winding } else { 0 })
    }
}

/// How an edge, given relative to a point and seen from above, winds around the point: 1 if it crosses the half-line
/// to +x upwards, −1 if downwards. An end on the line of that half-line counts as below it, so that two edges which
/// meet there cross once or not at all.
fn winding(from: DVec3, to: DVec3, blur: f64) -> Option<i32> {
    let up = from.y <= 0.0 && to.y > 0.0;
    let down = to.y <= 0.0 && from.y > 0.0;
    let (low, high) = (from.min(to), from.max(to));
    let close = low.x <= blur && -blur <= high.x && low.y <= blur && -blur <= high.y;
    if !(up || down || close) {
        return Some(0);
    }
    let (left, right) = (from.x * to.y, from.y * to.x);
    let side = left - right;
    // Shewchuk's 3 + 16ε half-ulps (1997, orient2d, first bound) of the two products.
    let error =
        2.0 * f64::EPSILON * (left.abs() + right.abs()) + 2.0 * blur * (to - from).abs().element_sum();
    if close && side.abs() <= error + f64::MIN_POSITIVE {
        return None;
    }
    Some(i32::from(up && side > 0.0) - i32::from(down && side < 0.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    const A: DVec3 = DVec3::new(0.0, 0.0, 1.0);
    const B: DVec3 = DVec3::new(1.0, 0.0, 1.0);
    const C: DVec3 = DVec3::new(0.0, 1.0, 1.0);

    fn probe(x: f64, y: f64, z: f64) -> Probe {
        Probe { at: DVec3::new(x, y, z), blur: 0.0 }
    }

    #[test]
    fn rays_leave_by_fronts_and_enter_by_backs() {
        assert_eq!(probe(0.2, 0.3, 0.0).crossing(A, B, C), Some(1));
        assert_eq!(probe(0.2, 0.3, 0.0).crossing(B, A, C), Some(-1));
        assert_eq!(probe(0.2, 0.3, 2.0).crossing(A, B, C), Some(0), "the triangle is below");
        assert_eq!(probe(0.8, 0.3, 0.0).crossing(A, B, C), Some(0), "next to it");
        assert_eq!(probe(0.2, 0.3, 0.0).crossing(A, B, B), Some(0), "no area");
    }

    #[test]
    fn what_lies_on_the_surface_or_below_an_edge_is_not_decided() {
        assert_eq!(probe(0.2, 0.3, 1.0).crossing(A, B, C), None);
        assert_eq!(probe(0.5, 0.5, 0.0).crossing(A, B, C), None, "the slanted edge");
        assert_eq!(probe(0.5, 0.0, 0.0).crossing(A, B, C), None, "the edge along x");
        assert_eq!(probe(0.0, 0.5, 0.0).crossing(A, B, C), None, "the edge along y");
        assert_eq!(probe(2.0, 0.0, 0.0).crossing(A, B, C), Some(0), "only in line with it");
        let blurred = Probe { at: DVec3::new(0.2, 0.3, 1.0 - 1e-12), blur: 1e-11 };
        assert_eq!(blurred.crossing(A, B, C), None);
        let next_to = Probe { at: DVec3::new(0.2, -1e-12, 0.0), blur: 1e-11 };
        assert_eq!(next_to.crossing(A, B, C), None);
    }
}
