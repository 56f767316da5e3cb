//! Normals of least-squares quadrics: second order in the edge length, where weighted means are first order.

use crate::mesh::{PositionsRef, Topology};
use crate::normals::creases::smooth_groups::SlotCorners;
use crate::normals::fits::nearest::{NearTree, Neighbour, by_coordinates};
use crate::num::{UnitVec3, least_squares, unit_scale};
use glam::DVec3;
use rayon::prelude::*;
use rustc_hash::FxHashMap;

/// Most neighbours that one fit takes.
const MOST: usize = 64;

/// Fewest neighbours for a fit: one more than a quadric through the vertex has coefficients.
const FEWEST: usize = 6;

/// A group of more corners than this has its ring searched by a tree: each of its neighbours asks for it.
const CROWDED: usize = 128;

/// How much farther a fit may turn the mean than the means of its neighbours turn, in tangents. Where means are
/// one-sided, at the rim of a surface, the truth lies as far outside the mean as the next one lies inside: once. As much
/// again is for jitter.
const FARTHER: f64 = 2.0;

/// What rounding to f64 turns fits to a plane by, with room: 1.3e-15 was the most. In tangents.
const ROUNDING: f64 = 1.0 / (1_u64 << 40) as f64;

/// The surface that quadrics are fitted to.
#[derive(Clone, Copy)]
pub(crate) struct QuadricRequest<'a> {
    pub(crate) corner_vertices: &'a [u32],
    pub(crate) topology: &'a Topology,
    pub(crate) positions: PositionsRef<'a>,
    /// The smooth group of each corner.
    pub(crate) corner_group: &'a [u32],
    /// The corners of each smooth group.
    pub(crate) group_corners: &'a SlotCorners,
}

/// Replaces the unit normal of each smooth group by that of the quadric z = ax + by + cx² + dxy + ey² that fits
/// its two-ring best; z is along the given normal, which should be the angle-weighted mean. Groups without a
/// normal (zero) stay without. Returns for how many groups there was no fit, so that the given normal stands.
///
/// The two-ring is the edge neighbours of the group's corners and those of *their* groups in the same faces, so
/// no hard edge is crossed. Each position counts once; at most 64 are taken, the first ring before the second,
/// near before far, then by coordinates. That is also the order of the rows, and the tangent axes depend on the
/// given normal alone (Duff et al. 2017), so numbering shows only in the last bits of that normal: on a jittered
/// torus of 4096 triangles it turned no result by more than 2.8e-16 rad. There is no fit with fewer than 6
/// neighbours, and none where they lie on a conic through the vertex, as all of a line do.
///
/// Nor is there one that turns the mean in a direction in which the surface does not turn: by more than twice as much as
/// the means of the neighbours do, each measured in the plane of the mean and the fit. Points on two lines, as on a
/// cylinder of two rings, lie on a conic but for the rounding of their positions; what is fitted to that rounding may
/// lie anywhere, and no threshold on the dependence of columns can tell it from a stretched mesh without knowing how
/// the positions were rounded on their way here. The neighbours tell.
///
/// The neighbourhood is brought to unit size by a power of two, so scaling by one leaves the bits alone. Cost:
/// sorting some dozens of points and at most 64·50 multiplications a group. Rings of more than 128 corners are
/// searched by a tree, so that a tip where a million faces meet costs n log n, not n².
pub(crate) fn quadric_normals(request: QuadricRequest, normals: &mut [DVec3]) -> usize {
    let rings = Rings::new(request, normals.len() as u32);
    let means = normals.to_vec();
    normals
        .par_iter_mut()
        .enumerate()
        .map_init(Scratch::default, |scratch, (group, normal)| {
            if *normal == DVec3::ZERO || request.group_corners.row(group as u32).is_empty() {
                return 0;
            }
            let centre = rings.neighbours(group as u32, scratch);
            let around = || scratch.groups.iter().map(|&group| means[group as usize]);
            let fitted =
                fit(centre, &scratch.chosen, *normal).filter(|&fit| is_borne_out(fit, *normal, around()));
            *normal = fitted.unwrap_or(*normal);
            usize::from(fitted.is_none())
        })
        .sum()
}

/// The normal at a point of the quadric through it and near its neighbours.
fn fit(centre: DVec3, neighbours: &[Neighbour], normal: DVec3) -> Option<DVec3> {
    let count = neighbours.len();
    if count < FEWEST {
        return None;
    }
    let offsets = || neighbours.iter().map(|neighbour| neighbour.at - centre);
    let scale = unit_scale(offsets().fold(0.0, |largest, d| d.abs().max_element().max(largest)));
    let (tangent, bitangent) = normal.any_orthonormal_pair();
    let (mut columns, mut heights) = ([[0.0; MOST]; 5], [0.0; MOST]);
    for (i, offset) in offsets().enumerate() {
        let offset = offset * scale;
        let (x, y) = (offset.dot(tangent), offset.dot(bitangent));
        for (column, term) in columns.iter_mut().zip([x, y, x * x, x * y, y * y]) {
            column[i] = term;
        }
        heights[i] = offset.dot(normal);
    }
    let mut columns = columns.each_mut().map(|column| &mut column[..count]);
    let [a, b, ..] = least_squares(&mut columns, &mut heights[..count])?;
    UnitVec3::new(normal - a * tangent - b * bitangent).map(UnitVec3::get)
}

/// Whether the means around a vertex turn in the direction in which a fit turns its own mean.
fn is_borne_out(fit: DVec3, mean: DVec3, around: impl Iterator<Item = DVec3>) -> bool {
    let turn = fit / fit.dot(mean) - mean;
    let along = turn.normalize_or_zero();
    let lean = |other: DVec3| {
        let upright = other.dot(mean);
        if upright > 0.0 { other.dot(along).abs() / upright } else { f64::INFINITY }
    };
    let most = around.filter(|&other| other != DVec3::ZERO).map(lean).fold(0.0, f64::max);
    turn.length() <= FARTHER * most + ROUNDING
}

/// Finds neighbours.
struct Rings<'a> {
    request: QuadricRequest<'a>,
    /// The rings of crowded groups, each position once.
    crowds: FxHashMap<u32, NearTree>,
}

/// Memory reused from group to group.
#[derive(Default)]
struct Scratch {
    first: Vec<DVec3>,
    second: Vec<DVec3>,
    groups: Vec<u32>,
    candidates: Vec<Neighbour>,
    chosen: Vec<Neighbour>,
}

impl<'a> Rings<'a> {
    fn new(request: QuadricRequest<'a>, groups: u32) -> Self {
        let mut rings = Self { request, crowds: FxHashMap::default() };
        let crowded: Vec<u32> =
            (0..groups).filter(|&group| request.group_corners.row(group).len() > CROWDED).collect();
        let tree = |group: u32| {
            let mut points = Vec::new();
            rings.append_ring(group, &mut points);
            sort_positions(&mut points);
            (group, NearTree::build(points))
        };
        let crowds: Vec<_> = crowded.into_par_iter().map(tree).collect();
        rings.crowds.extend(crowds);
        rings
    }

    /// The position at a corner, without negative zeros.
    fn place(&self, corner: u32) -> DVec3 {
        self.request.positions.at(self.request.corner_vertices[corner as usize]) + DVec3::ZERO
    }

    /// The two neighbours of a corner in its face.
    fn next_to(&self, corner: u32) -> [u32; 2] {
        [self.request.topology.next(corner), self.request.topology.previous(corner)]
    }

    fn append_ring(&self, group: u32, into: &mut Vec<DVec3>) {
        for &corner in self.request.group_corners.row(group) {
            into.extend(self.next_to(corner).map(|next_to| self.place(next_to)));
        }
    }

    /// Puts the neighbours of a group into `scratch.chosen`, in order, and the groups of the first ring into
    /// `scratch.groups`. Returns where the group itself stands:
    /// the first by coordinates, should welding have joined vertices that are not quite in one place.
    fn neighbours(&self, group: u32, scratch: &mut Scratch) -> DVec3 {
        let Scratch { first, second, groups, candidates, chosen } = scratch;
        let corners = self.request.group_corners.row(group);
        let places = corners.iter().map(|&corner| self.place(corner));
        let centre = places.min_by(by_coordinates).expect("a group has corners");
        first.clear();
        self.append_ring(group, first);
        sort_positions(first);
        first.retain(|&p| p != centre);
        let scale = unit_scale(first.iter().fold(0.0, |size, &p| (p - centre).abs().max_element().max(size)));
        chosen.clear();
        let mut take_nearest = |positions: &[DVec3]| {
            let room = MOST - chosen.len();
            candidates.clear();
            candidates.extend(positions.iter().map(|&p| Neighbour::new(p, centre, scale)));
            if candidates.len() > room {
                candidates.select_nth_unstable(room);
                candidates.truncate(room);
            }
            candidates.sort_unstable();
            chosen.extend_from_slice(candidates);
        };
        groups.clear();
        let next_to = corners.iter().flat_map(|&corner| self.next_to(corner));
        groups.extend(next_to.map(|corner| self.request.corner_group[corner as usize]));
        groups.sort_unstable();
        groups.dedup();
        take_nearest(first);
        if first.len() >= MOST {
            return centre;
        }
        second.clear();
        for group in groups.iter() {
            match self.crowds.get(group) {
                // More than can be taken, should some be in the first ring or be the centre.
                Some(tree) => tree.nearest(centre, scale, MOST + first.len() + 1, second),
                None => self.append_ring(*group, second),
            }
        }
        sort_positions(second);
        second.retain(|p| *p != centre && first.binary_search_by(|q| by_coordinates(q, p)).is_err());
        take_nearest(second);
        centre
    }
}

/// Sorts positions and leaves each once.
fn sort_positions(positions: &mut Vec<DVec3>) {
    positions.sort_unstable_by(by_coordinates);
    positions.dedup();
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Faces, Mesh, MeshBuilder, Weld};
    use crate::normals::compute::compute;
    use crate::normals::recipe::{Crease, NormalRecipe, Slivers, Weight};
    use crate::normals::sums::request::SumRequest;
    use crate::normals::sums::weighted_sums::weighted_sums;
    use crate::normals::test_meshes::with_threads;
    use crate::num::test_numbers::Numbers;
    use std::f64::consts::TAU;

    fn build(positions: Vec<DVec3>, triangles: Vec<u32>) -> Mesh {
        MeshBuilder {
            positions: positions.into(),
            faces: Faces::triangles(triangles),
            ..MeshBuilder::default()
        }
        .build()
        .unwrap()
    }

    /// Groups of corners: all at a vertex, or by the given numbers.
    fn normals_of(mesh: &Mesh, corner_group: &[u32]) -> (Vec<DVec3>, usize) {
        let topology = Topology::build(mesh, Weld::Exact);
        let groups = corner_group.iter().max().map_or(0, |&group| group as usize + 1);
        let mut normals = weighted_sums(&SumRequest {
            faces: mesh.faces().view(),
            positions: mesh.positions(),
            target: corner_group,
            slots: groups,
            weight: Weight::Angle,
            slivers: Slivers::Keep,
        })
        .0
        .unit;
        let request = QuadricRequest {
            corner_vertices: mesh.faces().corners(),
            topology: &topology,
            positions: mesh.positions(),
            corner_group,
            group_corners: &SlotCorners::by_slot(corner_group, groups),
        };
        let fallbacks = quadric_normals(request, &mut normals);
        (normals, fallbacks)
    }

    fn smooth(mesh: &Mesh) -> (Vec<DVec3>, usize) {
        normals_of(mesh, mesh.faces().corners())
    }

    fn angle(a: DVec3, b: DVec3) -> f64 {
        libm::atan2(a.cross(b).length(), a.dot(b))
    }

    /// The hash of cell coordinates that jitters the reference meshes.
    fn hash(i: u32, j: u32, c: u32) -> f64 {
        let mut h = i.wrapping_mul(73_856_093) ^ j.wrapping_mul(19_349_663) ^ c.wrapping_mul(83_492_791);
        h = h.wrapping_mul(2_654_435_761);
        h = (h ^ h >> 16).wrapping_mul(2_246_822_519);
        f64::from(h ^ h >> 13) / 4_294_967_296.0
    }

    #[test]
    fn the_hash_is_the_published_one() {
        assert_eq!(hash(0, 0, 1), 0.371_767_405_187_711_1);
        assert_eq!(hash(10, 20, 3), 0.953_712_598_420_679_6);
    }

    /// A surface over a torus of m × n cells, jittered by half a cell, with random diagonals; with exact normals.
    fn wrapped(m: u32, n: u32, surface: impl Fn(f64, f64) -> (DVec3, DVec3)) -> (Mesh, Vec<DVec3>) {
        let vertex = |i: u32, j: u32| i % m * n + j % n;
        let (positions, exact) = (0..m * n)
            .map(|v| {
                let (i, j) = (v / n, v % n);
                let at = |x: u32, c: u32, of: u32| {
                    TAU * (f64::from(x) + 0.5 * (hash(i, j, c) - 0.5)) / f64::from(of)
                };
                surface(at(i, 1, m), at(j, 2, n))
            })
            .unzip();
        let triangles = (0..m * n)
            .flat_map(|v| {
                let (i, j) = (v / n, v % n);
                let [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
                if hash(i, j, 3) < 0.5 { [a, b, d, b, c, d] } else { [a, b, c, a, c, d] }
            })
            .collect();
        (build(positions, triangles), exact)
    }

    fn torus(m: u32, n: u32) -> (Mesh, Vec<DVec3>) {
        wrapped(m, n, |u, v| {
            let ring = DVec3::new(libm::cos(u), libm::sin(u), 0.0);
            let normal = libm::cos(v) * ring + libm::sin(v) * DVec3::Z;
            (ring + 0.4 * normal, normal)
        })
    }

    /// Root mean square and largest deviation in degrees.
    fn errors(normals: &[DVec3], exact: &[DVec3]) -> (f64, f64) {
        let angles = normals.iter().zip(exact).map(|(&a, &b)| angle(a, b).to_degrees());
        let (squares, largest) = angles.fold((0.0, 0.0), |(s, l): (f64, f64), a| (s + a * a, l.max(a)));
        ((squares / normals.len() as f64).sqrt(), largest)
    }

    /// A jittered height field of n × n cells over [−½, ½]², with exact normals from slopes.
    fn patch(n: u32, surface: impl Fn(f64, f64) -> (f64, f64, f64)) -> (Mesh, Vec<DVec3>) {
        let (positions, exact) = (0..(n + 1) * (n + 1))
            .map(|v| {
                let (i, j) = (v / (n + 1), v % (n + 1));
                let at = |x: u32, c: u32| (f64::from(x) + 0.5 * (hash(i, j, c) - 0.5)) / f64::from(n) - 0.5;
                let (x, y) = (at(i, 1), at(j, 2));
                let (z, slope_x, slope_y) = surface(x, y);
                (DVec3::new(x, y, z), DVec3::new(-slope_x, -slope_y, 1.0).normalize())
            })
            .unzip();
        let triangles = (0..n * n)
            .flat_map(|cell| {
                let (i, j) = (cell / n, cell % n);
                let a = i * (n + 1) + j;
                let [b, c, d] = [a + n + 1, a + n + 2, a + 1];
                if hash(i, j, 3) < 0.5 { [a, b, d, b, c, d] } else { [a, b, c, a, c, d] }
            })
            .collect();
        (build(positions, triangles), exact)
    }

    fn sphere_cap(n: u32) -> (Mesh, Vec<DVec3>) {
        patch(n, |x, y| {
            let z = (1.0 - x * x - y * y).sqrt();
            (z, -x / z, -y / z)
        })
    }

    fn neighbours(points: &[DVec3]) -> Vec<Neighbour> {
        points.iter().map(|&p| Neighbour::new(p, DVec3::ZERO, 1.0)).collect()
    }

    /// Doubling the number of cells must divide the error by four; a weighted mean divides it by two. Measured root
    /// mean squares: torus 2.385°, 0.570°, 0.140°; sphere, where cubic terms are small, 0.0103°, 0.0013°, 0.00015°.
    #[test]
    fn errors_shrink_with_the_square_of_the_edges() {
        // One-sided fits at the rim of a patch are not what is measured.
        let error = |(mesh, exact): (Mesh, Vec<DVec3>), counted: fn(DVec3) -> bool| {
            let pairs = smooth(&mesh).0.into_iter().zip(exact).zip(mesh.positions().iter());
            let (normals, exact): (Vec<_>, Vec<_>) =
                pairs.filter(|(_, p)| counted(*p)).map(|(pair, _)| pair).unzip();
            errors(&normals, &exact)
        };
        let torus = [32, 64, 128].map(|m| error(torus(m, m / 2), |_| true));
        let cap = [12, 24, 48].map(|n| error(sphere_cap(n), |p| p.x.abs().max(p.y.abs()) < 0.4));
        for [coarse, middle, fine] in [torus, cap] {
            assert!(coarse.0 > 4.0 * middle.0 && middle.0 > 4.0 * fine.0, "{coarse:?} {middle:?} {fine:?}");
            assert!(coarse.1 > 3.5 * middle.1 && middle.1 > 3.5 * fine.1, "{coarse:?} {middle:?} {fine:?}");
        }
        assert!(torus[1].0 < 0.6 && cap[1].0 < 0.0014, "{torus:?} {cap:?}");
    }

    /// Where the surface is a quadric over the plane that the fit starts from, nothing but rounding remains:
    /// 1.3e-15 rad was the most.
    #[test]
    fn quadrics_are_fitted_exactly() {
        let mut numbers = Numbers::new(3);
        for count in [7, 20, 64] {
            for _ in 0..200 {
                let mut signed = || 2.0 * numbers.unit() - 1.0;
                let [a, b, c, d, e]: [f64; 5] = std::array::from_fn(|_| signed());
                let points: Vec<DVec3> = (0..count)
                    .map(|_| {
                        let (x, y) = (signed(), signed());
                        DVec3::new(x, y, a * x + b * y + c * x * x + d * x * y + e * y * y)
                    })
                    .collect();
                let normal = fit(DVec3::ZERO, &neighbours(&points), DVec3::Z).unwrap();
                let error = angle(normal, DVec3::new(-a, -b, 1.0));
                assert!(error < 5e-15, "{error:e}");
            }
        }
    }

    #[test]
    fn planes_stay_planes() {
        /// Corners of this patch that lie in one triangle and have too few neighbours.
        const FEW: usize = 1;
        let (mesh, exact) = patch(12, |_, _| (0.0, 0.0, 0.0));
        assert_eq!(smooth(&mesh), (exact, FEW));
        let (mesh, exact) = patch(12, |x, y| (0.3 * x - 0.7 * y, 0.3, -0.7));
        let (normals, fallbacks) = smooth(&mesh);
        // 7.6e-14 degrees were measured: rounding of the heights over the cell size.
        assert!(errors(&normals, &exact).1 < 3e-13);
        assert_eq!(fallbacks, FEW);
    }

    #[test]
    fn too_little_to_fit_leaves_the_mean() {
        let circle = |count: u32| -> Vec<DVec3> {
            let angles = (0..count).map(|i| TAU * f64::from(i) / f64::from(count));
            angles.map(|t| DVec3::new(libm::cos(t), 0.7 * libm::sin(t), 0.1)).collect()
        };
        assert!(fit(DVec3::ZERO, &neighbours(&circle(6)), DVec3::Z).is_some());
        assert_eq!(fit(DVec3::ZERO, &neighbours(&circle(5)), DVec3::Z), None);
        let line: Vec<DVec3> = (1..20).map(|i| f64::from(i) * DVec3::new(1.0, 0.3, 0.0)).collect();
        assert_eq!(fit(DVec3::ZERO, &neighbours(&line), DVec3::Z), None);
        let cross: Vec<DVec3> = (1..9).flat_map(|i| [DVec3::X, DVec3::Y].map(|a| f64::from(i) * a)).collect();
        assert_eq!(fit(DVec3::ZERO, &neighbours(&cross), DVec3::Z), None, "a conic through the vertex");

        // Each vertex of an octahedron has the five others around it.
        let axes = [DVec3::X, DVec3::Y, DVec3::Z, -DVec3::X, -DVec3::Y, -DVec3::Z];
        let faces = [[0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5]];
        let (normals, fallbacks) = smooth(&build(axes.to_vec(), faces.concat()));
        assert_eq!(fallbacks, 6);
        assert!(normals.iter().zip(axes).all(|(&normal, axis)| angle(normal, axis) < 1e-15));
    }

    /// Columns of such a fit are dependent but for the rounding of positions. Without the test against the neighbours
    /// normals were wrong by up to 90°; angle means are right to the rounding over the shorter edge.
    #[test]
    fn two_rings_of_rounded_positions_do_not_mislead() {
        let mut numbers = Numbers::new(11);
        type Store = fn(f64) -> f64;
        let stores: [(Store, f64); 4] = [
            (|x| x, 1e-16),
            (|x| f64::from(x as f32), 6e-8),
            (|x| (x * 1e6).round() / 1e6, 5e-7),
            (|x| (x * 1e4).round() / 1e4, 5e-5),
        ];
        for (sides, (store, grain)) in
            [16_u32, 32, 64].into_iter().flat_map(|s| stores.map(|store| (s, store)))
        {
            let turn = glam::DQuat::from_xyzw(numbers.unit(), numbers.unit(), numbers.unit(), numbers.unit());
            let turn = turn.normalize();
            let spoke = |v: u32| {
                let angle = TAU * f64::from(v / 2) / f64::from(sides);
                DVec3::new(libm::cos(angle), libm::sin(angle), 0.0)
            };
            let place = |v: u32| turn * (spoke(v) + 2.0 * f64::from(v % 2) * DVec3::Z);
            let positions = (0..2 * sides).map(|v| DVec3::from(place(v).to_array().map(store))).collect();
            let exact: Vec<DVec3> = (0..2 * sides).map(|v| turn * spoke(v)).collect();
            let wall = |i: u32| {
                let [a, b] = [2 * i, (2 * i + 2) % (2 * sides)];
                [a, b, b + 1, a, b + 1, a + 1]
            };
            let (normals, _) = smooth(&build(positions, (0..sides).flat_map(wall).collect()));
            // A corner that moves by √3 grains tilts a face by that over its shorter edge; the fit may triple it.
            let shorter = TAU / f64::from(sides);
            let allowed = (3.0 * 4.0 * 3.0_f64.sqrt() * grain / shorter).to_degrees() + 1e-12;
            let (_, largest) = errors(&normals, &exact);
            assert!(largest < allowed, "{sides} sides, {grain:e}: {largest:e}, allowed {allowed:e}");
        }
    }

    #[test]
    fn a_power_of_two_changes_no_bit() {
        let (mesh, _) = torus(24, 12);
        let (normals, _) = smooth(&mesh);
        for power in [-900, -300, -40, 1, 300, 900] {
            let scale = |p: DVec3| DVec3::from(p.to_array().map(|x| libm::ldexp(x, power)));
            let scaled = mesh.positions().iter().map(scale).collect();
            assert_eq!(smooth(&build(scaled, mesh.faces().corners().to_vec())).0, normals, "2^{power}");
        }
    }

    /// Numbering reaches a fit only through the last bits of the mean that it starts from.
    #[test]
    fn numbering_turns_normals_by_rounding_only() {
        let (mesh, _) = torus(64, 32);
        let (normals, _) = smooth(&mesh);
        let mut numbers = Numbers::new(5);
        let mut largest = 0.0f64;
        for _ in 0..4 {
            let mut new_vertex: Vec<u32> = (0..mesh.vertex_count() as u32).collect();
            numbers.shuffle(&mut new_vertex);
            let mut positions = vec![DVec3::ZERO; mesh.vertex_count()];
            for (&new, p) in new_vertex.iter().zip(mesh.positions().iter()) {
                positions[new as usize] = p;
            }
            let mut faces: Vec<[u32; 3]> = mesh
                .faces()
                .iter()
                .map(|face| std::array::from_fn(|corner| new_vertex[face[corner] as usize]))
                .collect();
            numbers.shuffle(&mut faces);
            let (renumbered, _) = smooth(&build(positions, faces.concat()));
            for (&new, &normal) in new_vertex.iter().zip(&normals) {
                largest = largest.max(angle(renumbered[new as usize], normal));
            }
        }
        // 2.8e-16 rad were measured, as much as the means turn themselves.
        assert!(largest < 1e-15, "{largest:e}");
        assert!(largest > 0.0, "the means must have been summed in another order");
    }

    #[test]
    fn copies_of_a_vertex_count_once() {
        let (mesh, _) = torus(24, 12);
        let places = mesh.faces().corners().iter().map(|&v| mesh.positions().at(v)).collect();
        let soup = build(places, (0..mesh.faces().corner_count() as u32).collect());
        assert_eq!(normals_of(&soup, mesh.faces().corners()), smooth(&mesh));
    }

    /// A roof whose ridge is hard: each side is a plane and must be fitted as one.
    #[test]
    fn hard_edges_are_not_crossed() {
        let (mesh, _) = patch(12, |_, _| (0.0, 0.0, 0.0));
        let ridge = |p: DVec3| DVec3::new((p.x * 12.0).round(), p.y * 12.0, -(p.x * 12.0).round().abs());
        let roof = build(mesh.positions().iter().map(ridge).collect(), mesh.faces().corners().to_vec());
        let side = |face: &[u32]| face.iter().any(|&v| roof.positions().at(v).x > 0.0);
        let vertices = roof.vertex_count() as u32;
        let groups: Vec<u32> = roof
            .faces()
            .iter()
            .flat_map(|face| face.iter().map(move |&v| v + vertices * u32::from(side(face))))
            .collect();
        let (normals, _) = normals_of(&roof, &groups);
        for (&group, face) in groups.iter().zip(0..) {
            let right = side(roof.faces().face(face / 3));
            let plane = DVec3::new(if right { 1.0 } else { -1.0 }, 0.0, 1.0);
            assert!(angle(normals[group as usize], plane) < 1e-15);
        }
        let (rounded, _) = smooth(&roof);
        assert!(angle(rounded[6 * 13 + 6], DVec3::new(1.0, 0.0, 1.0)) > 0.1, "smoothed over, it is round");
    }

    /// Two cones base to base: each rim vertex has both tips for neighbours, and each tip the whole rim.
    fn cones(valence: u32) -> Mesh {
        let rim = (0..valence).map(|i| {
            let t = TAU * (f64::from(i) + 0.4 * hash(i, 0, 1)) / f64::from(valence);
            DVec3::new(libm::cos(t), libm::sin(t), 0.01 * hash(i, 0, 2))
        });
        let positions = rim.chain([DVec3::Z, -DVec3::Z]).collect();
        let sides = |i: u32| [i, (i + 1) % valence, valence, (i + 1) % valence, i, valence + 1];
        build(positions, (0..valence).flat_map(sides).collect())
    }

    #[test]
    fn crowded_rings_are_searched_like_others() {
        let mesh = cones(1000);
        let topology = Topology::by_index(mesh.faces(), mesh.vertex_count());
        let request = QuadricRequest {
            corner_vertices: mesh.faces().corners(),
            topology: &topology,
            positions: mesh.positions(),
            corner_group: mesh.faces().corners(),
            group_corners: &SlotCorners::by_slot(mesh.faces().corners(), 1002),
        };
        let with_trees = Rings::new(request, 1002);
        let without = Rings { request, crowds: FxHashMap::default() };
        assert_eq!(with_trees.crowds.len(), 2);
        let (mut a, mut b) = (Scratch::default(), Scratch::default());
        for group in 0..1002 {
            with_trees.neighbours(group, &mut a);
            without.neighbours(group, &mut b);
            assert_eq!(a.chosen, b.chosen);
            assert_eq!(a.chosen.len(), MOST);
        }
    }

    #[test]
    fn computing_normals_gives_these() {
        let recipe = NormalRecipe { weight: Weight::Quadric, crease: Crease::OFF, ..NormalRecipe::default() };
        let (mesh, _) = torus(24, 12);
        let field = compute(&mesh, &recipe);
        let fitted = smooth(&mesh);
        assert_eq!((field.normals.values, field.summary.quadric_fallbacks), fitted);
        let mean = compute(&mesh, &NormalRecipe { weight: Weight::Angle, ..recipe }).normals.values;
        assert!(fitted.0.iter().zip(mean).all(|(&fit, mean)| fit != mean));

        // A single square is too small to fit.
        let square = patch(1, |_, _| (0.0, 0.0, 0.0)).0;
        let field = compute(&square, &recipe);
        assert_eq!((field.normals.values, field.summary.quadric_fallbacks), (vec![DVec3::Z; 4], 4));
    }

    /// Looking at every pair of rim vertices would take minutes.
    #[test]
    fn a_crowded_tip_costs_little() {
        assert_eq!(smooth(&cones(50_000)).0.len(), 50_002);
    }

    #[test]
    fn any_number_of_threads_gives_the_same_bits() {
        let (mesh, _) = torus(64, 32);
        let one = with_threads(1, || smooth(&mesh));
        assert!([2, 3, 8].iter().all(|&threads| with_threads(threads, || smooth(&mesh)) == one));
    }
}
