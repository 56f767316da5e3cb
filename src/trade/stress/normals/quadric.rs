//! Quadrics through points that lie on one but for their rounding.

use crate::mesh::{Faces, Mesh, MeshBuilder, Storage};
use crate::normals::{Crease, NormalRecipe, Scope, Weight, compute};
use crate::num::numbers::Numbers;
use crate::trade::exact;
use crate::trade::stress::case::{Bound, Measured, StressCase, Unit, Worst};
use crate::trade::stress::group::Group;
use crate::trade::stress::normals::naive;
use glam::{DQuat, DVec3, Vec3};
use std::f64::consts::TAU;

/// Sides of the cylinders.
const SIDES: [u32; 3] = [16, 32, 64];
/// Rotations of each.
const TURNS: usize = 5;

/// How positions are stored, and by how much that moves a coordinate.
type Stored = (&'static str, f64, fn(f64) -> f64);

pub(in crate::trade::stress) fn cases() -> Vec<StressCase> {
    let stored: [Stored; 4] = [
        ("f64", 2.3e-16, |x| x),
        ("f32", 1.2e-7, |x| f64::from(x as f32)),
        ("6 decimals", 5e-7, |x| (x * 1e6).round() / 1e6),
        ("4 decimals", 5e-5, |x| (x * 1e4).round() / 1e4),
    ];
    stored.map(case).into_iter().collect()
}

fn case((name, moved, store): Stored) -> StressCase {
    // A corner that moves by d = √3 coordinates tilts a face by 2d over its shorter edge, here the side of the cylinder of
    // most sides, and a mean no more; what the neighbours bear out is twice what they differ by, 2·2 such tilts.
    let shorter = TAU / f64::from(SIDES[2]);
    let most = (10.0 * 3.0_f64.sqrt() * moved / shorter).to_degrees() + 1e-10;
    StressCase {
        group: Group::Fan,
        name: format!("quadric on two rings, {name}"),
        what: "open cylinders of 16, 32, 64 sides and one ring of faces, turned 5 ways: the quadric through points on two lines",
        expectation: "no farther off than rounding of positions turns faces",
        bound: Bound::new(
            most,
            Unit::Degrees,
            "10 d/s: tilts of 2d/s by corners moved by d over sides s, and fits borne out by the neighbours within twice theirs",
        ),
        fast_bound: None,
        plain_unit: Unit::Degrees,
        plain_formula: "uniform mean of the faces",
        measure: Box::new(move || measure(store)),
    }
}

fn measure(store: fn(f64) -> f64) -> Measured {
    let mut numbers = Numbers::new(41);
    let (mut faithful, mut plain, mut samples) = (Worst::default(), Worst::default(), 0);
    let recipe = NormalRecipe {
        weight: Weight::Quadric,
        crease: Crease::OFF,
        scope: Scope::Vertex,
        ..NormalRecipe::default()
    };
    for sides in SIDES {
        for _ in 0..TURNS {
            let [x, y, z, w] = [0; 4].map(|_| 2.0 * numbers.unit() - 1.0);
            let turn = DQuat::from_xyzw(x, y, z, w).normalize();
            let mesh = cylinder(sides, turn, store);
            let field = compute(&mesh, &recipe);
            for (&normal, &vertex) in field.normals.values.iter().zip(&field.entry_vertex) {
                let truth = exact::unit(&(turn * spoke(vertex, sides)).to_array().map(exact::big));
                let truth = truth.expect("a spoke has a direction");
                let degrees = |normal: DVec3| exact::angle_to(normal, &truth).to_degrees();
                faithful.add(degrees(normal));
                plain.add(degrees(naive::direction(plain_mean(&mesh, vertex))));
                samples += 1;
            }
        }
    }
    Measured { samples, faithful, plain: Some(plain), ..Measured::default() }
}

fn spoke(vertex: u32, sides: u32) -> DVec3 {
    let angle = TAU * f64::from(vertex / 2) / f64::from(sides);
    DVec3::new(libm::cos(angle), libm::sin(angle), 0.0)
}

/// Radius 1 and height 2, each side cut in two.
fn cylinder(sides: u32, turn: DQuat, store: fn(f64) -> f64) -> Mesh {
    let place = |v: u32| turn * (spoke(v, sides) + 2.0 * f64::from(v % 2) * DVec3::Z);
    let positions = (0..2 * sides).map(|v| DVec3::from(place(v).to_array().map(store))).collect();
    let side = |i: u32| {
        let [a, b] = [2 * i, (2 * i + 2) % (2 * sides)];
        [a, b, b + 1, a, b + 1, a + 1]
    };
    let faces = Faces::triangles((0..sides).flat_map(side).collect());
    MeshBuilder { positions, faces, storage: Storage::F64, ..MeshBuilder::default() }
        .build()
        .expect("a good mesh")
}

fn plain_mean(mesh: &Mesh, vertex: u32) -> Vec3 {
    let around = mesh.faces().iter().filter(|face| face.contains(&vertex));
    let normal =
        |face: &[u32]| naive::face_normal([0, 1, 2].map(|k| mesh.positions()[face[k] as usize].as_vec3()));
    naive::unit(around.map(normal).fold(Vec3::ZERO, |sum, normal| sum + normal))
}
