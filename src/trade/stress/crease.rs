//! Edges whose dihedral angle is exactly the crease angle, before rounding.

use super::case::{Bound, Measured, StressCase, Unit, Worst};
use super::group::Group;
use super::plain;
use crate::mesh::{Faces, Mesh, MeshBuilder, Storage};
use crate::normals::{Crease, NormalField, NormalRecipe, Precision, compute};
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

/// With few digits the edges are what the digits make them; the report has to count them as near the angle.
fn counted_case(decimals: usize) -> StressCase {
    let allowed = SIDES.map(|sides| turn_by_digits(sides, decimals)).into_iter().fold(0.1, f64::max);
    StressCase {
        group: Group::Crease,
        name: format!("prisms in text of {decimals} decimals"),
        what: "the same prisms: how far side edges are from the angle, and whether those within 0.1 degrees are counted",
        expectation: "within what the digits allow, and counted in near_crease",
        bound: Bound::new(
            allowed,
            Unit::Degrees,
            "max(0.1, twice asin((4 d D + 4 d^2)/|D x D'|)): diagonals D of a face whose corners move by d",
        ),
        fast_bound: None,
        plain_unit: Unit::Degrees,
        plain_formula: "acos(dot(n1, n2)), normals of three corners",
        measure: Box::new(move || {
            let (mut measured, mut plain) = (Measured::default(), Worst::default());
            for_each_prism(Stored::Text { decimals }, |sides, mesh| {
                let field = compute(mesh, &recipe(sides, Precision::Faithful));
                let turned = deviations(&field, sides);
                let near = turned.iter().filter(|degrees| **degrees <= 0.1).count();
                let counted = near == field.summary.near_crease;
                measured.samples += sides;
                measured.faithful.add(if counted {
                    turned.into_iter().fold(0.0, f64::max)
                } else {
                    f64::INFINITY
                });
                let normals = plain_normals(mesh, sides);
                for (a, b) in pairs(&normals) {
                    let degrees = f64::from(plain::angle(*a, *b)).to_degrees();
                    plain.add((degrees - 360.0 / sides as f64).abs());
                }
            });
            Measured { plain: Some(plain), ..measured }
        }),
    }
}

/// How far rounding to decimals can turn two neighbouring sides against each other, in degrees.
fn turn_by_digits(sides: usize, decimals: usize) -> f64 {
    let moved = 0.5 * 3.0_f64.sqrt() * libm::exp10(-(decimals as f64));
    let width = 2.0 * libm::sin(std::f64::consts::PI / sides as f64);
    let diagonal = (width * width + 1.0).sqrt();
    let sine = (4.0 * moved * diagonal + 4.0 * moved * moved) / (2.0 * width);
    2.0 * libm::asin(sine.min(1.0)).to_degrees()
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

/// How far each angle between neighbouring sides is from what it was before rounding, in degrees.
fn deviations(field: &NormalField, sides: usize) -> Vec<f64> {
    let angle = |(a, b): (&DVec3, &DVec3)| libm::atan2(a.cross(*b).length(), a.dot(*b)).to_degrees();
    pairs(&field.face_normals[..sides]).map(|pair| (angle(pair) - 360.0 / sides as f64).abs()).collect()
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
