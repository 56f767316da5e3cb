//! Quadrics through points that lie on a quadric except for rounding.

use super::case::{Bound, Measured, StressCase, Unit};
use super::fans::recipe;
use super::group::Group;
use super::plain;
use super::random::rotation;
use crate::mesh::{Faces, Mesh, MeshBuilder, Storage};
use crate::normals::{Precision, Weight, compute};
use crate::num::numbers::Numbers;
use crate::trade::exact;
use glam::{DQuat, DVec3, Vec3};
use std::f64::consts::TAU;

/// Sides of the cylinders.
const SIDES: [u32; 3] = [16, 32, 64];
/// Rotations of each.
const TURNS: usize = 5;

/// A name of the way that positions are stored, by how much that moves a coordinate, and the stored coordinate.
type Stored = (&'static str, f64, fn(f64) -> f64);

const STORED: [Stored; 4] = [
    ("f64", 2.3e-16, |x| x),
    ("f32", 1.2e-7, |x| f64::from(x as f32)),
    ("6 decimals", 5e-7, |x| (x * 1e6).round() / 1e6),
    ("4 decimals", 5e-5, |x| (x * 1e4).round() / 1e4),
];

pub(super) fn cases() -> Vec<StressCase> {
    STORED.map(case).into()
}

fn case((name, moved, store): Stored) -> StressCase {
    // A corner that moves by d = √3 coordinates tilts a face by 2d over its shorter edge, here the side of the cylinder of
    // most sides, and a mean no more. Fits may differ from their neighbours by twice as much, 2·2 such tilts.
    let shorter = TAU / f64::from(SIDES[2]);
    let most = (10.0 * 3.0_f64.sqrt() * moved / shorter).to_degrees() + 1e-10;
    let bounds = (Bound::new(most, Unit::Degrees, "quadric-bound"), None);
    let name = format!("quadric on two rings, {name}");
    StressCase::new(Group::Fan, "quadric", name, bounds, move || measure(store))
}

fn measure(store: fn(f64) -> f64) -> Measured {
    let mut numbers = Numbers::new(41);
    let mut errors = Vec::new();
    for sides in SIDES {
        for _ in 0..TURNS {
            let turn = rotation(&mut numbers);
            let mesh = cylinder(sides, turn, store);
            let field = compute(&mesh, &recipe(Weight::Quadric, Precision::Faithful));
            for (&normal, &vertex) in field.normals.values.iter().zip(&field.entry_vertex) {
                let truth = exact::unit(&(turn * spoke(vertex, sides)).to_array().map(exact::big));
                let truth = truth.expect("a spoke has a direction");
                let plain = plain::direction(plain_mean(&mesh, vertex));
                errors.push([normal, plain].map(|normal| exact::degrees_to(normal, &truth)));
            }
        }
    }
    Measured::pairs(errors)
}

/// The direction from the axis to a vertex before rotation.
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
        |face: &[u32]| plain::face_normal([0, 1, 2].map(|k| mesh.positions()[face[k] as usize].as_vec3()));
    plain::unit(around.map(normal).fold(Vec3::ZERO, |sum, normal| sum + normal))
}
