//! Max's weights and inversion in a sphere.

use crate::random::Random;
use crate::shade::{direction, uniform};
use crate::theory::angle;
use crease::normals::{Averaging, Scratch, Slivers, Weight, vertex_normals};
use glam::DVec3;
use std::f64::consts::TAU;

/// The normal of vertex 0 of a closed fan over a ring, or over triangles.
fn normal(positions: &[DVec3], triangles: &[[u32; 3]], weight: Weight) -> DVec3 {
    let positions: Vec<[f64; 3]> = positions.iter().map(DVec3::to_array).collect();
    let mut normals = vec![[0.0; 3]; positions.len()];
    vertex_normals(
        &positions,
        triangles,
        Averaging { weight, slivers: Slivers::Keep, ..Averaging::default() },
        &mut Scratch::new(),
        &mut normals,
    )
    .unwrap();
    DVec3::from(normals[0])
}

fn fan(ring: usize) -> Vec<[u32; 3]> {
    (0..ring as u32).map(|i| [0, i + 1, (i + 1) % ring as u32 + 1]).collect()
}

/// A ring round the origin, far from round, and the origin before it.
fn ring(sides: usize, random: &mut Random) -> Vec<DVec3> {
    let spoke = |k: usize, random: &mut Random| {
        let turn = TAU * (k as f64 + 0.8 * uniform(random)) / sides as f64;
        let radius = libm::exp2(4.0 * uniform(random) - 2.0);
        DVec3::new(radius * libm::cos(turn), radius * libm::sin(turn), 2.0 * uniform(random) - 1.0)
    };
    std::iter::once(DVec3::ZERO).chain((0..sides).map(|k| spoke(k, random))).collect()
}

/// Σ e_i×e_{i+1}/(|e_i|²|e_{i+1}|²) is Σ q_i×q_{i+1} with q = e/|e|²: twice the area vector of the ring inverted in the unit
/// sphere about the vertex.
#[test]
fn maxs_sum_is_the_area_vector_of_the_inverted_ring() {
    let mut random = Random(101);
    let (mut worst, mut other): (f64, f64) = (0.0, 0.0);
    for round in 0..2000 {
        let sides = 3 + round % 9;
        let positions = ring(sides, &mut random);
        let inverted: Vec<DVec3> = positions[1..].iter().map(|e| *e / e.length_squared()).collect();
        // Relative to its first corner, as the area vector of any polygon is best taken.
        let fan_of = |pair: &[DVec3]| (pair[0] - inverted[0]).cross(pair[1] - inverted[0]);
        let area: DVec3 = inverted[1..].windows(2).map(fan_of).sum();
        let sum: f64 = (0..sides).map(|i| inverted[i].cross(inverted[(i + 1) % sides]).length()).sum();
        if area.length() < 1e-3 * sum {
            continue; // what is left of a cancelling sum is not compared
        }
        // The sum itself, with its factor: twice ½Σ.
        let maxs = |i: usize| {
            let [a, b] = [positions[1 + i], positions[1 + (i + 1) % sides]];
            a.cross(b) / (a.length_squared() * b.length_squared())
        };
        let total: DVec3 = (0..sides).map(maxs).sum();
        let vector_area = 0.5 * area;
        assert!((total - 2.0 * vector_area).length() < 1e-13 * sum, "{total} {vector_area}");
        worst = worst.max(angle(normal(&positions, &fan(sides), Weight::Max), area));
        other = other.max(angle(normal(&positions, &fan(sides), Weight::Edge), area));
    }
    // Some tens of roundings, times what the sum shrinks by: at most a thousand.
    assert!(worst < 1e-11, "{worst:e}");
    assert!(other > 0.1, "another weight would do as well: {other}");
}

/// Inversion maps a sphere through the vertex to a plane.
#[test]
fn it_is_exact_where_the_ring_lies_on_a_sphere() {
    let mut random = Random(102);
    let mut others: f64 = 0.0;
    for _ in 0..500 {
        let pole = direction(&mut random);
        let aside = pole.any_orthonormal_vector();
        let across = pole.cross(aside);
        let on_sphere = |k: usize, random: &mut Random| {
            let turn = TAU * (k as f64 + 0.9 * uniform(random)) / 6.0;
            let polar = 0.05 + 0.9 * uniform(random);
            pole * libm::cos(polar) + (aside * libm::cos(turn) + across * libm::sin(turn)) * libm::sin(polar)
        };
        let positions: Vec<DVec3> =
            std::iter::once(pole).chain((0..6).map(|k| on_sphere(k, &mut random))).collect();
        assert!(angle(normal(&positions, &fan(6), Weight::Max), pole) < 1e-12);
        others = others.max(angle(normal(&positions, &fan(6), Weight::Angle), pole));
    }
    assert!(others > 0.05, "angle weights would do as well: {others}");
}

/// On grids along the lines of a torus and of a cone: the quads there are cyclic, which is more than enough.
#[test]
fn it_is_exact_on_grids_of_a_torus_and_a_cone() {
    let mut random = Random(103);
    let torus = |u: f64, v: f64| {
        let radius = 1.0 + 0.4 * libm::cos(v);
        DVec3::new(radius * libm::cos(u), radius * libm::sin(u), 0.4 * libm::sin(v))
    };
    let torus_normal =
        |u: f64, v: f64| DVec3::new(libm::cos(v) * libm::cos(u), libm::cos(v) * libm::sin(u), libm::sin(v));
    let cone = |u: f64, s: f64| DVec3::new(s * libm::cos(u), s * libm::sin(u), 1.0 - 0.7 * s);
    let cone_normal = |u: f64, _: f64| DVec3::new(0.7 * libm::cos(u), 0.7 * libm::sin(u), 1.0).normalize();
    type Map<'a> = &'a dyn Fn(f64, f64) -> DVec3;
    let surfaces: [(Map, Map, f64); 2] = [(&torus, &torus_normal, 6.0), (&cone, &cone_normal, 0.0)];
    let mut others: f64 = 0.0;
    for (surface, truth, turn) in surfaces {
        for _ in 0..200 {
            let (u, v) = (6.0 * uniform(&mut random), 0.8 + turn * uniform(&mut random));
            let (du, dv) = (0.05 + 0.3 * uniform(&mut random), 0.05 + 0.3 * uniform(&mut random));
            // The vertex, and the eight about it, counter-clockwise in (u, v).
            let around = [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1]];
            let at = |[i, j]: [i32; 2]| surface(u + f64::from(i) * du, v + f64::from(j) * dv);
            let positions: Vec<DVec3> = std::iter::once([0, 0]).chain(around).map(at).collect();
            // Each of the four quads, cut either way.
            let mut triangles = Vec::new();
            for quad in 0..4 {
                let [a, b, c] = [2 * quad, 2 * quad + 1, (2 * quad + 2) % 8].map(|k| k as u32 + 1);
                match random.one_in(2) {
                    true => triangles.extend([[0, a, b], [0, b, c]]),
                    false => triangles.push([0, a, c]),
                }
            }
            let truth = truth(u, v);
            let off = |weight| {
                let normal = normal(&positions, &triangles, weight);
                angle(normal * normal.dot(truth).signum(), truth)
            };
            assert!(off(Weight::Max) < 1e-11, "{:e}", off(Weight::Max));
            others = others.max(off(Weight::Uniform));
        }
    }
    assert!(others > 0.05, "uniform weights would do as well: {others}");
}

/// Inversion maps the circle of the quad to a line.
#[test]
fn cutting_a_concyclic_quad_changes_nothing() {
    let mut random = Random(104);
    let mut others: f64 = 0.0;
    for _ in 0..500 {
        let mut positions = ring(5, &mut random);
        // A fourth point on the circle through the vertex and spokes 1 and 2, between them.
        let (a, b) = (positions[1], positions[2]);
        let [p, q] = [a, b].map(|e| e / e.length_squared());
        let between = p + (q - p) * (0.2 + 0.6 * uniform(&mut random));
        positions.push(between / between.length_squared());
        let whole = fan(5);
        let mut cut = whole[1..].to_vec();
        cut.extend([[0, 1, 6], [0, 6, 2]]);
        let off = |weight| angle(normal(&positions, &whole, weight), normal(&positions, &cut, weight));
        assert!(off(Weight::Max) < 1e-10, "{:e}", off(Weight::Max));
        others = others.max(off(Weight::Area));
    }
    assert!(others > 0.05, "area weights would do as well: {others}");
}
