//! Edges whose dihedral angle is exactly the crease angle, before rounding.

use crate::mesh::{Faces, Link, Mesh, MeshBuilder, Storage, Topology};
use crate::normals::{Crease, NormalField, NormalRecipe, Precision, compute_on};
use crate::num::Degrees;
use crate::num::numbers::Numbers;
use crate::trade::exact::{self, Big, big};
use crate::trade::stress::case::{Bound, Measured, StressCase, Unit, Worst};
use crate::trade::stress::group::Group;
use crate::trade::stress::normals::naive;
use dashu::base::Abs;
use glam::{DQuat, DVec3, Vec3};

/// Sides of the prisms: they meet at 45°, 40° (the default) and 30°.
const SIDES: [usize; 3] = [8, 9, 12];
/// Rotations of each.
const TURNS: usize = 40;

/// By how much an edge may bend more than the crease angle and stay smooth.
const SLACK: f64 = 0.01;
/// How near the crease angle an edge is counted, whatever the digits.
const NEAR: f64 = 0.1;

/// How positions are stored.
#[derive(Clone, Copy, Debug)]
enum Stored {
    Single,
    Text { decimals: usize },
}

pub(in crate::trade::stress) fn cases() -> Vec<StressCase> {
    let smooth =
        [("prisms in f32", Stored::Single), ("prisms in text of 6 decimals", Stored::Text { decimals: 6 })];
    let smooth = smooth.map(|(name, stored)| smooth_case(name, stored));
    smooth.into_iter().chain([5, 4, 3, 2].map(counted_case)).collect()
}

fn smooth_case(name: &str, stored: Stored) -> StressCase {
    let none = Bound::none_wrong(
        "dihedral angle > crease angle + 0.01 degrees, in 256 bits; rounding turns these faces by less than that",
    );
    StressCase {
        group: Group::Crease,
        name: name.into(),
        what: "40 rotations each of prisms with 8, 9, 12 sides, crease angle 45, 40, 30: edges that split otherwise than \
               their angle in 256 bits says, and side edges that split",
        expectation: "no side edge splits, all others do",
        bound: none,
        fast_bound: Some(none),
        plain_unit: Unit::Wrong,
        plain_formula: "dot(n1, n2) < cos(angle), normals of three corners",
        measure: Box::new(move || {
            let mut measured = Measured::default();
            let (mut wrong, mut fast_wrong, mut plain_wrong) = (0, 0, 0);
            for_each_prism(stored, |prism| {
                let limit = exact::radians(prism.angle() + SLACK);
                let over: Vec<bool> = prism.edges().map(|edge| prism.true_angle(edge) > limit).collect();
                let count = |field: &NormalField| {
                    let splits = prism.edges().map(|edge| prism.splits(field, edge));
                    let expected = prism.edges().map(|edge| !prism.is_side(edge));
                    splits.zip(&over).zip(expected).filter(|&((a, &b), c)| a != b || a != c).count()
                };
                measured.samples += over.len();
                wrong += count(&prism.field(Precision::Faithful));
                let quick = prism.field(Precision::Fast);
                fast_wrong += count(&quick);
                measured.declined += if quick.summary.fast_declined { over.len() } else { 0 };
                plain_wrong += prism.plain_splits();
            });
            Measured {
                faithful: Worst::wrong(wrong),
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
        what: "the same prisms, whose side edges are exactly at the angle before rounding: by how many near_crease differs \
               from the count in 256 bits, and that from the number of sides",
        expectation: "every side edge counted, within max(0.1 degrees, what the digits allow), and no other",
        bound: Bound::none_wrong(
            "asin(d (sum |P(i+1) - P(i-1)| + n d) / |sum P(i) x P(i+1)|) for each of two faces whose corners move by d, in \
             256 bits",
        ),
        fast_bound: None,
        plain_unit: Unit::Wrong,
        plain_formula: "|acos(dot(n1, n2)) - angle| <= 0.1 degrees, normals of three corners",
        measure: Box::new(move || {
            let (mut measured, mut wrong, mut plain) = (Measured::default(), 0, 0);
            for_each_prism(Stored::Text { decimals }, |prism| {
                let truly = prism.truly_near(decimals);
                let counted = prism.field(Precision::Faithful).summary.near_crease;
                measured.samples += prism.sides;
                wrong += counted.abs_diff(truly) + truly.abs_diff(prism.sides);
                plain += prism.sides - prism.plain_near();
            });
            Measured { faithful: Worst::wrong(wrong), plain: Some(Worst::wrong(plain)), ..measured }
        }),
    }
}

/// A prism whose sides meet at the crease angle.
struct Prism {
    sides: usize,
    mesh: Mesh,
    topology: Topology,
}

impl Prism {
    /// Radius 1, height 1; the sides first, then the two ends.
    fn new(sides: usize, turn: DQuat, stored: Stored) -> Self {
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
        let mesh = MeshBuilder { positions, storage, faces, ..MeshBuilder::default() };
        let mesh = mesh.build().expect("a good mesh");
        let topology = Topology::by_index(mesh.faces(), mesh.vertex_count());
        Self { sides, mesh, topology }
    }

    /// The crease angle, in degrees.
    fn angle(&self) -> f64 {
        360.0 / self.sides as f64
    }

    fn field(&self, precision: Precision) -> NormalField {
        let crease = Crease::Angle(Degrees(self.angle()));
        compute_on(&self.mesh, &self.topology, &NormalRecipe { crease, precision, ..NormalRecipe::default() })
    }

    /// Each edge as its two half-edges.
    fn edges(&self) -> impl Iterator<Item = [u32; 2]> {
        let half_edges = 0..self.mesh.faces().corner_count() as u32;
        half_edges.filter_map(|half_edge| match self.topology.link(half_edge) {
            Link::Twin(across) if half_edge < across => Some([half_edge, across]),
            _ => None,
        })
    }

    /// Whether an edge is between two sides.
    fn is_side(&self, edge: [u32; 2]) -> bool {
        self.faces_at(edge).into_iter().all(|face| face < self.sides)
    }

    /// Whether the normals on the two sides of an edge are others.
    fn splits(&self, field: &NormalField, [half_edge, across]: [u32; 2]) -> bool {
        let slot = |corner: u32| {
            let vertex = self.mesh.faces().corners()[corner as usize];
            field.normals.slot(corner as usize, vertex)
        };
        let next = |half_edge| self.topology.next(half_edge);
        slot(half_edge) != slot(next(across)) || slot(next(half_edge)) != slot(across)
    }

    /// The two faces at an edge.
    fn faces_at(&self, edge: [u32; 2]) -> [usize; 2] {
        edge.map(|half_edge| self.topology.face_of(half_edge) as usize)
    }

    /// Where the corners of a face are.
    fn corners(&self, face: usize) -> Vec<DVec3> {
        self.mesh.faces().face(face).iter().map(|&vertex| self.mesh.positions()[vertex as usize]).collect()
    }

    /// The angle between the stored faces at an edge.
    fn true_angle(&self, edge: [u32; 2]) -> Big {
        let [a, b] = self.faces_at(edge).map(|face| self.corners(face));
        exact::dihedral(&a, &b).expect("faces with an area")
    }

    /// At how many edges the stored faces may have been at the crease angle before they were rounded, or are near it.
    fn truly_near(&self, decimals: usize) -> usize {
        let unit = big(1.0) / big(libm::exp10(decimals as f64));
        let moved = big(3.0).sqrt() * big(0.5) * unit;
        let faces = 0..self.mesh.face_count();
        let turns: Vec<Big> = faces.map(|face| exact::turn(&self.corners(face), &moved)).collect();
        let (angle, near) = (exact::radians(self.angle()), exact::radians(NEAR));
        let is_near = |&edge: &[u32; 2]| {
            let [a, b] = self.faces_at(edge).map(|face| &turns[face]);
            (self.true_angle(edge) - &angle).abs() <= (a + b).max(near.clone())
        };
        self.edges().filter(is_near).count()
    }

    fn plain_normals(&self) -> Vec<Vec3> {
        let normal = |face: usize| {
            let corners = self.mesh.faces().face(face);
            naive::face_normal([0, 1, 2].map(|k| self.mesh.positions()[corners[k] as usize].as_vec3()))
        };
        (0..self.sides).map(normal).collect()
    }

    /// How many side edges plain code splits.
    fn plain_splits(&self) -> usize {
        let cosine = libm::cosf((360.0 / self.sides as f32).to_radians());
        pairs(&self.plain_normals()).filter(|(a, b)| a.dot(**b) < cosine).count()
    }

    /// How many it finds near the angle.
    fn plain_near(&self) -> usize {
        let off = |a: Vec3, b: Vec3| (naive::angle(a, b).to_degrees() - 360.0 / self.sides as f32).abs();
        pairs(&self.plain_normals()).filter(|(a, b)| off(**a, **b) <= NEAR as f32).count()
    }
}

fn for_each_prism(stored: Stored, mut act: impl FnMut(&Prism)) {
    let mut numbers = Numbers::new(21);
    for sides in SIDES {
        for _ in 0..TURNS {
            let [x, y, z, w] = [0; 4].map(|_| 2.0 * numbers.unit() - 1.0);
            act(&Prism::new(sides, DQuat::from_xyzw(x, y, z, w).normalize(), stored));
        }
    }
}

/// Each with the next, round the prism.
fn pairs<T>(all: &[T]) -> impl Iterator<Item = (&T, &T)> {
    all.iter().zip(all.iter().cycle().skip(1))
}
