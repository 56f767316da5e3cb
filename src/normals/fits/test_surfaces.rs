//! Meshes of surfaces with exact normals, and what fits make of them.

use crate::mesh::{Faces, Mesh, MeshBuilder, Topology, Weld};
use crate::normals::creases::smooth_groups::SlotCorners;
use crate::normals::fits::fitted_normals::{FitFailures, fitted_normals};
use crate::normals::fits::polynomial::Polynomial;
use crate::normals::fits::rings::{FitRequest, Rings};
use crate::normals::recipe::{Slivers, Weight};
use crate::normals::sums::request::SumRequest;
use crate::normals::sums::weighted_sums::{SumScratch, weighted_sums};
use crate::num::test_numbers::Numbers;
use glam::DVec3;
use std::f64::consts::TAU;

pub(super) fn build(positions: Vec<DVec3>, triangles: Vec<u32>) -> Mesh {
    MeshBuilder { positions: positions.into(), faces: Faces::triangles(triangles), ..MeshBuilder::default() }
        .build()
        .unwrap()
}

/// The angle means of groups of corners: all at a vertex, or by the given numbers.
pub(super) fn means_of(mesh: &Mesh, corner_group: &[u32]) -> Vec<DVec3> {
    let groups = corner_group.iter().max().map_or(0, |&group| group as usize + 1);
    let request = SumRequest {
        faces: mesh.faces().view(),
        positions: mesh.positions(),
        target: corner_group,
        slots: groups,
        weight: Weight::Angle,
        slivers: Slivers::Keep,
    };
    weighted_sums(&request, &mut SumScratch::default()).0.unit
}

/// Calls a function with the rings of groups of corners.
pub(super) fn with_rings<T>(mesh: &Mesh, corner_group: &[u32], work: impl FnOnce(Rings<'_>) -> T) -> T {
    let topology = Topology::build(mesh, Weld::Exact);
    let groups = corner_group.iter().max().map_or(0, |&group| group as usize + 1);
    let request = FitRequest {
        corner_vertices: mesh.faces().corners(),
        topology: &topology,
        positions: mesh.positions(),
        corner_group,
        group_corners: &SlotCorners::by_slot(corner_group, groups),
    };
    work(Rings::new(request, groups))
}

/// The normals of groups of corners by some polynomials, and how often each failed.
pub(super) fn normals_of<const N: usize>(
    mesh: &Mesh,
    corner_group: &[u32],
    polynomials: [Polynomial; N],
) -> (Vec<DVec3>, [FitFailures; N]) {
    let means = means_of(mesh, corner_group);
    let groups: Vec<u32> = (0..means.len() as u32).collect();
    let (mut normals, failures) = with_rings(mesh, corner_group, |rings| {
        fitted_normals(&rings, polynomials, 0, &means, &groups, &|_| ())
    });
    let without_fit = normals.iter_mut().zip(means).filter(|(normal, _)| **normal == DVec3::ZERO);
    without_fit.for_each(|(normal, mean)| *normal = mean);
    (normals, failures)
}

pub(super) fn angle(a: DVec3, b: DVec3) -> f64 {
    libm::atan2(a.cross(b).length(), a.dot(b))
}

/// The hash of cell coordinates that jitters the reference meshes.
pub(super) fn hash(i: u32, j: u32, c: u32) -> f64 {
    let mut h = i.wrapping_mul(73_856_093) ^ j.wrapping_mul(19_349_663) ^ c.wrapping_mul(83_492_791);
    h = h.wrapping_mul(2_654_435_761);
    h = (h ^ h >> 16).wrapping_mul(2_246_822_519);
    f64::from(h ^ h >> 13) / 4_294_967_296.0
}

/// A surface over a torus of m × n cells, jittered by half a cell, with random diagonals; with exact normals.
pub(super) fn wrapped(m: u32, n: u32, surface: impl Fn(f64, f64) -> (DVec3, DVec3)) -> (Mesh, Vec<DVec3>) {
    let vertex = |i: u32, j: u32| i % m * n + j % n;
    let (positions, exact) = (0..m * n)
        .map(|v| {
            let (i, j) = (v / n, v % n);
            let at =
                |x: u32, c: u32, of: u32| TAU * (f64::from(x) + 0.5 * (hash(i, j, c) - 0.5)) / f64::from(of);
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

pub(super) fn torus(m: u32, n: u32) -> (Mesh, Vec<DVec3>) {
    wrapped(m, n, |u, v| {
        let ring = DVec3::new(libm::cos(u), libm::sin(u), 0.0);
        let normal = libm::cos(v) * ring + libm::sin(v) * DVec3::Z;
        (ring + 0.4 * normal, normal)
    })
}

/// Root mean square and largest deviation in degrees.
pub(super) fn errors(normals: &[DVec3], exact: &[DVec3]) -> (f64, f64) {
    let angles = normals.iter().zip(exact).map(|(&a, &b)| angle(a, b).to_degrees());
    let (squares, largest) = angles.fold((0.0, 0.0), |(s, l): (f64, f64), a| (s + a * a, l.max(a)));
    ((squares / normals.len() as f64).sqrt(), largest)
}

/// A jittered height field of n × n cells over [−½, ½]², with exact normals from slopes.
pub(super) fn patch(n: u32, surface: impl Fn(f64, f64) -> (f64, f64, f64)) -> (Mesh, Vec<DVec3>) {
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

pub(super) fn sphere_cap(n: u32) -> (Mesh, Vec<DVec3>) {
    patch(n, |x, y| {
        let z = (1.0 - x * x - y * y).sqrt();
        (z, -x / z, -y / z)
    })
}

/// The wave z = 0.3 sin 3x cos 3y over [−1, 1]², and which of its vertices are not on the boundary.
pub(super) fn wave(n: u32) -> (Mesh, Vec<DVec3>, Vec<bool>) {
    let (mesh, exact) = patch(n, |x, y| {
        let ((sin_x, cos_x), (sin_y, cos_y)) = (libm::sincos(6.0 * x), libm::sincos(6.0 * y));
        (0.15 * sin_x * cos_y, 0.9 * cos_x * cos_y, -0.9 * sin_x * sin_y)
    });
    let inner = |i: u32| 0 < i && i < n;
    let is_inner = (0..(n + 1) * (n + 1)).map(|v| inner(v / (n + 1)) && inner(v % (n + 1))).collect();
    (mesh, exact, is_inner)
}

/// The rms error in degrees of the normals of some polynomials inside the [`wave`].
pub(super) fn rms_on_wave<const N: usize>(n: u32, polynomials: [Polynomial; N]) -> f64 {
    let (mesh, exact, is_inner) = wave(n);
    let normals = normals_of(&mesh, mesh.faces().corners(), polynomials).0;
    let inner = |normals: &[DVec3]| -> Vec<DVec3> {
        normals.iter().zip(&is_inner).filter(|it| *it.1).map(|it| *it.0).collect()
    };
    errors(&inner(&normals), &inner(&exact)).0
}

/// The same on the [`torus`].
pub(super) fn rms_on_torus<const N: usize>(m: u32, n: u32, polynomials: [Polynomial; N]) -> f64 {
    let (mesh, exact) = torus(m, n);
    errors(&normals_of(&mesh, mesh.faces().corners(), polynomials).0, &exact).0
}

/// By how much, in radians, another numbering of vertices and faces turns normals at most.
pub(super) fn turn_by_numbering(mesh: &Mesh, rounds: usize, normals_of: impl Fn(&Mesh) -> Vec<DVec3>) -> f64 {
    let normals = normals_of(mesh);
    let mut numbers = Numbers::new(5);
    let mut largest = 0.0_f64;
    for _ in 0..rounds {
        let mut new_vertex: Vec<u32> = (0..mesh.vertex_count() as u32).collect();
        numbers.shuffle(&mut new_vertex);
        let mut positions = vec![DVec3::ZERO; mesh.vertex_count()];
        new_vertex.iter().zip(mesh.positions().iter()).for_each(|(&new, p)| positions[new as usize] = p);
        let renumber = |face: &[u32]| std::array::from_fn(|corner| new_vertex[face[corner] as usize]);
        let mut faces: Vec<[u32; 3]> = mesh.faces().iter().map(renumber).collect();
        numbers.shuffle(&mut faces);
        let renumbered = normals_of(&build(positions, faces.concat()));
        let turns =
            new_vertex.iter().zip(&normals).map(|(&new, &normal)| angle(renumbered[new as usize], normal));
        largest = turns.fold(largest, f64::max);
    }
    largest
}

/// Two cones base to base: each rim vertex has both tips for neighbours, and each tip the whole rim.
pub(super) fn cones(valence: u32) -> Mesh {
    let rim = (0..valence).map(|i| {
        let t = TAU * (f64::from(i) + 0.4 * hash(i, 0, 1)) / f64::from(valence);
        DVec3::new(libm::cos(t), libm::sin(t), 0.01 * hash(i, 0, 2))
    });
    let positions = rim.chain([DVec3::Z, -DVec3::Z]).collect();
    let sides = |i: u32| [i, (i + 1) % valence, valence, (i + 1) % valence, i, valence + 1];
    build(positions, (0..valence).flat_map(sides).collect())
}

#[test]
fn the_hash_is_the_published_one() {
    assert_eq!(hash(0, 0, 1), 0.371_767_405_187_711_1);
    assert_eq!(hash(10, 20, 3), 0.953_712_598_420_679_6);
}
