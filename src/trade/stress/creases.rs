//! Edges whose dihedral angle is exactly the crease angle, before rounding.

use super::prelude::*;
use crate::mesh::{Link, Positions, Topology};
use crate::normals::compute_on;

/// Sides of the prisms: they meet at 45°, 40° (the default) and 30°.
const SIDES: [usize; 3] = [8, 9, 12];
/// Rotations of each.
const TURNS: usize = 40;

/// By how much the dihedral angle of a smooth edge may exceed the crease angle.
const SLACK: f64 = 0.01;
/// How near the crease angle an edge is counted, whatever the digits.
const NEAR: f64 = 0.1;

#[derive(Clone, Copy, Debug)]
enum Stored {
    Single,
    Text { decimals: usize },
}

pub(super) fn cases() -> Vec<StressCase> {
    let splits = [("f32", Stored::Single), ("text of 6 decimals", Stored::Text { decimals: 6 })];
    let splits = splits.map(|(name, stored)| {
        let bound = Bound::none_wrong("split-prisms-bound");
        let (name, bounds) = (format!("prisms in {name}"), (bound, Some(bound)));
        StressCase::new(Group::Crease, "split-prisms", name, bounds, move || measure_splits(stored))
    });
    // With few digits the edges are what the digits make them; the report has to count all of them as near the angle.
    let counts = [5, 4, 3, 2].map(|decimals| {
        let name = format!("prisms in text of {decimals} decimals");
        let bounds = (Bound::none_wrong("counted-prisms-bound"), None);
        StressCase::new(Group::Crease, "counted-prisms", name, bounds, move || measure_counts(decimals))
    });
    splits.into_iter().chain(counts).collect()
}

/// Edges whose splits are not those of their angle in 256 bits, and side edges that split.
fn measure_splits(stored: Stored) -> Measured {
    let (mut samples, mut declined, mut wrong) = (0, 0, [0; 4]);
    for prism in prisms(stored) {
        let limit = exact::radians(prism.angle() + SLACK);
        let over: Vec<bool> = prism.edges().map(|edge| prism.true_angle(edge) > limit).collect();
        let count = |field: &NormalField| {
            let is_wrong = |(edge, &is_over): ([u32; 2], &bool)| {
                let splits = prism.splits(field, edge);
                splits != is_over || splits == prism.is_side(edge)
            };
            prism.edges().zip(&over).filter(|&pair| is_wrong(pair)).count()
        };
        let [faithful, fast] = [Precision::Faithful, Precision::Fast].map(|precision| prism.field(precision));
        samples += over.len();
        declined += if fast.summary.fast_declined { over.len() } else { 0 };
        let angle = exact::radians(prism.angle());
        let definition = prism.side_angles().filter(|side| *side > angle).count();
        let of_prism = [count(&faithful), count(&fast), prism.plain_splits(), definition];
        wrong.iter_mut().zip(of_prism).for_each(|(wrong, of_prism)| *wrong += of_prism);
    }
    let [faithful, fast, plain, definition] = wrong;
    let measured = Measured::wrong(samples, [faithful, plain, definition]);
    Measured { fast: Some(Worst::wrong(fast)), declined, ..measured }
}

/// Edges that are wrongly counted as near the crease angle, or wrongly not.
fn measure_counts(decimals: usize) -> Measured {
    let (mut samples, mut wrong, mut plain, mut definition) = (0, 0, 0, 0);
    for prism in prisms(Stored::Text { decimals }) {
        let near = prism.truly_near(decimals);
        let counted = prism.field(Precision::Faithful).summary.near_crease;
        samples += prism.sides;
        wrong += counted.abs_diff(near) + near.abs_diff(prism.sides);
        plain += prism.sides - prism.plain_near();
        let (angle, near) = (exact::radians(prism.angle()), exact::radians(NEAR));
        definition += prism.side_angles().filter(|side| (side - &angle).abs() > near).count();
    }
    Measured::wrong(samples, [wrong, plain, definition])
}

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
            Stored::Text { decimals } => format!("{x:.decimals$}").parse().expect("a printed number"),
        };
        let corner = |i: usize| {
            let angle = TAU * (i / 2) as f64 / sides as f64;
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
        let mesh = Mesh::new(Positions::rounded(positions, storage), faces).expect("a good mesh");
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

    fn is_side(&self, edge: [u32; 2]) -> bool {
        self.faces_at(edge).into_iter().all(|face| face < self.sides)
    }

    /// Whether the normals on the two sides of an edge differ.
    fn splits(&self, field: &NormalField, [half_edge, across]: [u32; 2]) -> bool {
        let slot = |corner: u32| {
            let vertex = self.mesh.faces().corners()[corner as usize];
            field.normals.slot(corner as usize, vertex)
        };
        let next = |half_edge| self.topology.next(half_edge);
        slot(half_edge) != slot(next(across)) || slot(next(half_edge)) != slot(across)
    }

    fn faces_at(&self, edge: [u32; 2]) -> [usize; 2] {
        edge.map(|half_edge| self.topology.face_of(half_edge) as usize)
    }

    fn corners(&self, face: usize) -> Vec<DVec3> {
        self.mesh.faces().face(face).iter().map(|&vertex| self.mesh.positions().at(vertex)).collect()
    }

    fn true_angle(&self, edge: [u32; 2]) -> Big {
        let [a, b] = self.faces_at(edge).map(|face| self.corners(face));
        exact::dihedral(&a, &b).expect("faces with an area")
    }

    /// The number of edges whose angle may have been the crease angle before rounding, or is near it.
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

    /// The angles at side edges by the plain formula in 256 bits: between the normals of the first three corners.
    fn side_angles(&self) -> impl Iterator<Item = Big> {
        let corners: Vec<Vec<DVec3>> = (0..self.sides).map(|side| self.corners(side)).collect();
        let angle = |side: usize| {
            let [a, b] = [side, (side + 1) % self.sides].map(|side| &corners[side][..3]);
            exact::dihedral(a, b).expect("corners that are not collinear")
        };
        (0..self.sides).map(angle).collect::<Vec<_>>().into_iter()
    }

    fn plain_normals(&self) -> Vec<Vec3> {
        let normal = |face: usize| {
            let corners = self.mesh.faces().face(face);
            plain::face_normal([0, 1, 2].map(|k| self.mesh.positions().at(corners[k]).as_vec3()))
        };
        (0..self.sides).map(normal).collect()
    }

    /// The number of side edges that plain code splits.
    fn plain_splits(&self) -> usize {
        let cosine = libm::cosf((360.0 / self.sides as f32).to_radians());
        pairs(&self.plain_normals()).filter(|(a, b)| a.dot(**b) < cosine).count()
    }

    /// The number of side edges that plain code finds near the angle.
    fn plain_near(&self) -> usize {
        let off = |a: Vec3, b: Vec3| (plain::angle(a, b).to_degrees() - 360.0 / self.sides as f32).abs();
        pairs(&self.plain_normals()).filter(|(a, b)| off(**a, **b) <= NEAR as f32).count()
    }
}

fn prisms(stored: Stored) -> impl Iterator<Item = Prism> {
    let mut numbers = Numbers::new(21);
    let all = SIDES.into_iter().flat_map(|sides| [sides; TURNS]);
    all.map(move |sides| Prism::new(sides, rotation(&mut numbers), stored))
}

/// Each with the next, around the prism.
fn pairs<T>(all: &[T]) -> impl Iterator<Item = (&T, &T)> {
    all.iter().zip(all.iter().cycle().skip(1))
}
