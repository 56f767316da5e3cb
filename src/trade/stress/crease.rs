//! Edges whose dihedral angle is exactly the crease angle, before rounding.

use super::case::{Bound, Measured, StressCase, Unit, Worst};
use super::group::Group;
use super::plain;
use crate::mesh::{Faces, Mesh, MeshBuilder, Storage};
use crate::normals::{Crease, NormalRecipe, Precision, compute};
use crate::num::Degrees;
use crate::num::numbers::Numbers;
use glam::{DQuat, DVec3, Vec3};

/// Sides of the prisms: they meet at 45°, 40° (the default) and 30°.
const SIDES: [usize; 3] = [8, 9, 12];
/// Rotations of each.
const TURNS: usize = 40;

/// How positions are stored.
#[derive(Clone, Copy, Debug)]
enum Stored {
    Single,
    Text { decimals: usize },
}

pub(super) fn cases() -> Vec<StressCase> {
    let smooth =
        [("prisms in f32", Stored::Single), ("prisms in text of 6 decimals", Stored::Text { decimals: 6 })];
    let smooth = smooth.map(|(name, stored)| smooth_case(name, stored));
    smooth.into_iter().chain([5, 4, 3, 2].map(counted_case)).collect()
}

fn smooth_case(name: &str, stored: Stored) -> StressCase {
    let none = Bound::none_wrong("0.01 degrees of slack are more than rounding turns these faces by");
    StressCase {
        group: Group::Crease,
        name: name.into(),
        what: "40 rotations each of prisms with 8, 9, 12 sides, crease angle 45, 40, 30: side edges that split",
        expectation: "no side edge splits, all others do",
        bound: none,
        fast_bound: Some(none),
        plain_unit: Unit::Wrong,
        plain_formula: "dot(n1, n2) < cos(angle), normals of three corners",
        measure: Box::new(move || {
            let mut measured = Measured::default();
            let (mut fast_wrong, mut plain_wrong) = (0, 0);
            for_each_prism(stored, |sides, mesh| {
                let wrong = |precision| {
                    let field = compute(mesh, &recipe(sides, precision));
                    (field.summary.edges.crease.abs_diff(2 * sides), field.summary.fast_declined)
                };
                measured.samples += sides;
                measured.faithful.error += wrong(Precision::Faithful).0 as f64;
                let (count, declined) = wrong(Precision::Fast);
                fast_wrong += count;
                measured.declined += if declined { sides } else { 0 };
                plain_wrong += plain_splits(mesh, sides);
            });
            Measured {
                fast: Some(Worst::wrong(fast_wrong)),
                plain: Some(Worst::wrong(plain_wrong)),
                ..measured
            }
        }),
    }
}

/// With few digits the edges are what the digits make them; the report has to count all of them as near the angle.
fn counted_case(decimals: usize) -> StressCase {
    StressCase {
        group: Group::Crease,
        name: format!("prisms in text of {decimals} decimals"),
        what: "the same prisms, whose side edges are exactly at the angle before rounding: those that near_crease misses, or \
               others that it counts",
        expectation: "every side edge counted, within max(0.1 degrees, what the digits allow), and no other",
        bound: Bound::none_wrong(
            "asin((4 d D + 4 d^2)/|D x D'|) for each side: diagonals D of a face whose corners move by d",
        ),
        fast_bound: None,
        plain_unit: Unit::Wrong,
        plain_formula: "|acos(dot(n1, n2)) - angle| <= 0.1 degrees, normals of three corners",
        measure: Box::new(move || {
            let (mut measured, mut missed, mut plain) = (Measured::default(), 0, 0);
            for_each_prism(Stored::Text { decimals }, |sides, mesh| {
                let field = compute(mesh, &recipe(sides, Precision::Faithful));
                measured.samples += sides;
                missed += field.summary.near_crease.abs_diff(sides);
                let normals = plain_normals(mesh, sides);
                let off = |a: Vec3, b: Vec3| (plain::angle(a, b).to_degrees() - 360.0 / sides as f32).abs();
                plain +=
                    pairs(&normals).filter(|(a, b)| off(**a, **b).is_nan() || off(**a, **b) > 0.1).count();
            });
            Measured { faithful: Worst::wrong(missed), plain: Some(Worst::wrong(plain)), ..measured }
        }),
    }
}

fn recipe(sides: usize, precision: Precision) -> NormalRecipe {
    let crease = Crease::Angle(Degrees(360.0 / sides as f64));
    NormalRecipe { crease, precision, ..NormalRecipe::default() }
}

fn for_each_prism(stored: Stored, mut act: impl FnMut(usize, &Mesh)) {
    let mut numbers = Numbers::new(21);
    for sides in SIDES {
        for _ in 0..TURNS {
            let [x, y, z, w] = [0; 4].map(|_| 2.0 * numbers.unit() - 1.0);
            act(sides, &prism(sides, DQuat::from_xyzw(x, y, z, w).normalize(), stored));
        }
    }
}

/// Radius 1, height 1; the sides first, then the two ends.
fn prism(sides: usize, turn: DQuat, stored: Stored) -> Mesh {
    let store = |x: f64| match stored {
        Stored::Single => f64::from(x as f32),
        Stored::Text { decimals } => {
            format!("{x:.decimals$}").parse().expect("a number that was just printed")
        }
    };
    let corner = |i: usize| {
        let angle = std::f64::consts::TAU * (i / 2) as f64 / sides as f64;
        let corner = turn * DVec3::new(libm::cos(angle), libm::sin(angle), (i % 2) as f64 - 0.5);
        DVec3::from(corner.to_array().map(store))
    };
    let mut faces = Faces::new();
    let next = |i: usize| (i + 1) % sides;
    for i in 0..sides {
        faces.push(&[2 * i, 2 * next(i), 2 * next(i) + 1, 2 * i + 1].map(|v| v as u32));
    }
    faces.push(&(0..sides as u32).map(|i| 2 * i + 1).collect::<Vec<_>>());
    faces.push(&(0..sides as u32).rev().map(|i| 2 * i).collect::<Vec<_>>());
    let storage = if matches!(stored, Stored::Single) { Storage::F32 } else { Storage::F64 };
    let positions = (0..2 * sides).map(corner).collect();
    MeshBuilder { positions, storage, faces, ..MeshBuilder::default() }.build().expect("a good mesh")
}

fn plain_normals(mesh: &Mesh, sides: usize) -> Vec<Vec3> {
    let normal = |face: usize| {
        let corners = mesh.faces().face(face);
        plain::face_normal([0, 1, 2].map(|k| mesh.positions()[corners[k] as usize].as_vec3()))
    };
    (0..sides).map(normal).collect()
}

fn plain_splits(mesh: &Mesh, sides: usize) -> usize {
    let cosine = libm::cosf((360.0 / sides as f32).to_radians());
    let normals = plain_normals(mesh, sides);
    pairs(&normals).filter(|(a, b)| a.dot(**b) < cosine).count()
}

/// Each with the next, round the prism.
fn pairs<T>(all: &[T]) -> impl Iterator<Item = (&T, &T)> {
    all.iter().zip(all.iter().cycle().skip(1))
}
