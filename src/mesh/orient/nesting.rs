//! How deep closed surfaces lie inside each other.
//!
//! A shell lies in another if its box does and all of a few points spread over it do. A point lies in a shell if
//! the ray from it upwards (+z) leaves the shell once more than it enters, or once less. The faces that a ray may
//! meet are found in a [`BoxTree`]; every decision is taken with a bound on its rounding error, and points too close
//! to a surface for that are ignored.
//!
//! Work is n log n in faces, plus the triangles that rays meet. Surfaces made so that every ray meets most
//! triangles would be quadratic: each ray has a budget, and a shell with a ray that used it up is undecided.

use crate::mesh::box_tree::{Bounds, BoxTree};
use crate::mesh::polygon_mesh::Mesh;
use crate::mesh::transform::permanent;
use crate::num::parallel;
use crate::num::unit_scale;
use glam::DVec3;

/// Cost limit of a search for boxes around or in a box; a longer search counts as successful.
const BOX_BUDGET: usize = 512;

/// Cost limit of all rays together, shared evenly: a constant, and so much for each triangle. A ray through a million
/// triangles of well-shaped shells costs some hundreds.
const RAY_BUDGET: (usize, usize) = (1 << 26, 256);

#[derive(Clone, Default)]
pub(super) struct Nest {
    /// How many there are in its mesh.
    pub(super) depth: u32,
    /// Those among them that are marked, ascending.
    pub(super) marked: Vec<u32>,
}

/// The nest of each shell; `None` if it is undetermined. Shells are closed components, as lists of faces, some of them
/// marked; `against` says which faces run against the others of their shell.
pub(super) fn nests(
    mesh: &Mesh,
    against: &[bool],
    shells: &[&[u32]],
    is_marked: &[bool],
) -> Vec<Option<Nest>> {
    let bounds = parallel::map_each(shells, |faces| face_bounds(mesh, faces));
    let boxes = BoxTree::build(shells.len(), &|shell| bounds[shell as usize]);
    // Whether another shell's box is a hit, or the search became too long.
    type Test = fn(Bounds, Bounds) -> bool;
    let finds = |shell: u32, enter: Test, is_hit: Test| {
        let (own, mut hit) = (bounds[shell as usize], false);
        let enough = boxes.visit(
            &mut { BOX_BUDGET },
            |node| enter(node, own),
            |other| {
                hit = other != shell && is_hit(bounds[other as usize], own);
                !hit
            },
        );
        hit || !enough
    };
    let is_inner = |shell: usize| finds(shell as u32, Bounds::contains, Bounds::contains);
    let inner = parallel::map(shells.len(), is_inner);
    let rays: usize = (0..shells.len()).filter(|&s| inner[s]).map(|s| 2 * shells[s].len().min(12)).sum();
    if rays == 0 {
        return vec![Some(Nest::default()); shells.len()];
    }
    // Only shells that have a box in their own need to be searched for crossings.
    let is_outer = |shell: u32| finds(shell, Bounds::overlaps, |other, own| own.contains(other));
    let outer = parallel::filter(shells.len(), is_outer);
    let walls = Walls::new(mesh, against, outer.iter().map(|&shell| (shell, shells[shell as usize])));
    let budget = Walls::budget([&walls], rays);
    let nest = |shell: usize| {
        if !inner[shell] {
            return Some(Nest::default());
        }
        let contains = |other: u32| bounds[other as usize].contains(bounds[shell]);
        let probes = probes(mesh, shells[shell], walls.scale);
        let around = walls.shells_around(Some(shell as u32), &probes, budget, contains)?;
        if around.iter().any(|&(_, place)| place == Place::TooClose) {
            return None;
        }
        let marked = around.iter().map(|it| it.0).filter(|&other| is_marked[other as usize]).collect();
        Some(Nest { depth: around.len() as u32, marked })
    };
    parallel::map(shells.len(), nest)
}

pub(super) fn face_bounds(mesh: &Mesh, faces: &[u32]) -> Bounds {
    let corners = faces.iter().flat_map(|&face| mesh.faces().face(face as usize));
    Bounds::of(corners.map(|&vertex| mesh.position(vertex)))
}

pub(super) struct Walls<'a> {
    mesh: &'a Mesh,
    /// The shell and the vertices of each; all of a shell agree.
    triangles: Vec<(u32, [u32; 3])>,
    tree: BoxTree,
    /// Brings all coordinates below 1, so that differences stay in range.
    pub(super) scale: f64,
}

/// The position of a point, or of a shell, relative to another shell, if it is not outside.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Place {
    Inside,
    TooClose,
}

impl<'a> Walls<'a> {
    /// The walls of shells, given by number and faces.
    pub(super) fn new<'s>(
        mesh: &'a Mesh,
        against: &[bool],
        shells: impl Iterator<Item = (u32, &'s [u32])>,
    ) -> Self {
        let mut triangles: Vec<(u32, [u32; 3])> = Vec::new();
        for (shell, faces) in shells {
            for &face in faces {
                let against = against[face as usize];
                let agreeing = |[a, b, c]: [u32; 3]| (shell, if against { [a, c, b] } else { [a, b, c] });
                triangles.extend(mesh.faces().fan(face).map(agreeing));
            }
        }
        let largest = mesh.bounds().map_or(0.0, |(low, high)| low.abs().max(high.abs()).max_element());
        let scale = unit_scale(largest);
        let tree = BoxTree::build(triangles.len(), &|item| {
            let (_, triangle) = triangles[item as usize];
            Bounds::of(triangle.into_iter().map(|vertex| scale * mesh.position(vertex)))
        });
        Self { mesh, triangles, tree, scale }
    }

    /// The cost limit of each of so many rays.
    pub(super) fn budget<'w>(walls: impl IntoIterator<Item = &'w Self>, rays: usize) -> usize
    where
        'a: 'w,
    {
        let triangles: usize = walls.into_iter().map(|walls| walls.triangles.len()).sum();
        (RAY_BUDGET.0 + RAY_BUDGET.1 * triangles) / rays.max(1)
    }

    /// The wanted shells that all points of a surface lie in, or that all of them lie too close to, except the `own`
    /// shell of the points, ascending. Points are scaled as the walls are. `None` if the budget of a ray is used up.
    pub(super) fn shells_around(
        &self,
        own: Option<u32>,
        probes: &[Probe],
        budget: usize,
        is_wanted: impl Fn(u32) -> bool,
    ) -> Option<Vec<(u32, Place)>> {
        let mut places: Vec<(u32, Place)> = Vec::new();
        for probe in probes {
            let before = places.len();
            let around = self.around(own, probe, budget)?;
            places.extend(around.into_iter().filter(|&(other, _)| is_wanted(other)));
            if places.len() == before {
                return Some(Vec::new());
            }
        }
        places.sort_unstable_by_key(|&(other, _)| other);
        let all = places.chunk_by(|a, b| a.0 == b.0).filter_map(|of_shell| {
            // A shell that a probe lies outside of is missing from the list of that probe.
            let is_close = of_shell.iter().all(|(_, place)| *place == Place::TooClose);
            let place = if is_close { Place::TooClose } else { Place::Inside };
            (of_shell.len() == probes.len()).then_some((of_shell[0].0, place))
        });
        Some(all.collect())
    }

    /// The other shells that a point lies in or too close to; `None` if the budget is used up.
    fn around(&self, own: Option<u32>, probe: &Probe, mut budget: usize) -> Option<Vec<(u32, Place)>> {
        let at = probe.at;
        let reach = |node: Bounds| {
            let (low, high) = (node.low - probe.blur, node.high + probe.blur);
            low.x <= at.x && at.x <= high.x && low.y <= at.y && at.y <= high.y && at.z <= high.z
        };
        let mut crossings: Vec<(u32, Option<i32>)> = Vec::new();
        let enough = self.tree.visit(&mut budget, reach, |item| {
            let (shell, triangle) = self.triangles[item as usize];
            if Some(shell) != own {
                let [a, b, c] = triangle.map(|vertex| self.scale * self.mesh.position(vertex));
                let crossing = probe.crossing(a, b, c);
                crossings.extend((crossing != Some(0)).then_some((shell, crossing)));
            }
            true
        });
        crossings.sort_unstable();
        let places = crossings.chunk_by(|a, b| a.0 == b.0).filter_map(|of_shell| {
            let winding: Option<i32> = of_shell.iter().map(|&(_, crossing)| crossing).sum();
            let place = if winding.is_none() { Place::TooClose } else { Place::Inside };
            (winding != Some(0)).then_some((of_shell[0].0, place))
        });
        enough.then(|| places.collect())
    }
}

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
