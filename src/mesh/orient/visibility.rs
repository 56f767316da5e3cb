//! The outer side of a surface with a boundary: a vote of points about the side from which they are visible.
//!
//! After K. Takayama, A. Jacobson, L. Kavan, O. Sorkine-Hornung, *A simple method for correcting facet orientations in
//! polygon meshes based on ray casting*, JCGT 3(4), 2014: rays leave points of the surface on both sides, and more of them
//! escape on the outer side. All faces of the mesh are obstacles.
//!
//! Here each point has one vote, and only if its sides differ clearly: by a quarter of the rays, which leave a point with
//! the density of diffuse reflection (by the cosine). So the points of an open sphere vote if a quarter of it or more is
//! left, since from inside a sphere the share of rays that meet it is its share of the sphere; a gently curved sheet does
//! not vote. The confidence is Laplace's rule of succession: the probability that another point would vote with the
//! majority.

use super::components::Components;
use crate::mesh::obstacles::Obstacles;
use crate::mesh::polygon_mesh::Mesh;
use crate::num::parallel;
use glam::DVec3;

/// Points of each component; fewer if there are very many components.
const POINTS: usize = 64;

/// The fewest points of a component: nine that agree have a confidence above 0.9.
const FEWEST: usize = 16;

/// Rays that leave each side of a point.
const RAYS: usize = 32;

/// The share of rays by which the sides have to differ.
const CLEAR: f64 = 0.25;

/// Points of all components together: the components with most faces vote, others stay undecided.
const MOST_POINTS: usize = 1 << 12;

/// Boxes and faces that all rays together may visit, shared evenly; but at least so many for each.
const STEPS: (usize, usize) = (1 << 28, 1024);

#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Vote {
    /// Whether the outer side is where the normal of its lowest face points.
    pub(super) outward: bool,
    /// 1/2 for a tie or no vote, towards 1 as more points agree.
    pub(super) confidence: f64,
}

pub(super) fn votes(mesh: &Mesh, components: &Components, open: &[usize]) -> Vec<Vote> {
    let undecided = Vote { outward: true, confidence: 0.5 };
    let mut votes = vec![undecided; open.len()];
    if open.is_empty() {
        return votes;
    }
    let points = (MOST_POINTS / open.len()).clamp(FEWEST, POINTS);
    let mut largest: Vec<usize> = (0..open.len()).collect();
    largest.sort_by_key(|&i| std::cmp::Reverse(components.faces(open[i]).len()));
    largest.truncate(MOST_POINTS / points);
    let obstacles = Obstacles::new(mesh);
    let rays = largest.len() * points * 2 * RAYS;
    let poll = Poll { obstacles, directions: directions(), budget: (STEPS.0 / rays).max(STEPS.1) };
    let vote = |&i: &usize| poll.vote(components.faces(open[i]), &components.against, points);
    let reported = parallel::map_each(&largest, vote);
    largest.into_iter().zip(reported).for_each(|(i, vote)| votes[i] = vote);
    votes
}

struct Poll<'a> {
    obstacles: Obstacles<'a>,
    /// Directions about +z, by the cosine.
    directions: Vec<DVec3>,
    /// Boxes and faces that each ray may visit.
    budget: usize,
}

impl Poll<'_> {
    /// The vote of points that are spread evenly over the area of a component.
    fn vote(&self, faces: &[u32], against: &[bool], points: usize) -> Vote {
        let mut sums: Vec<f64> = Vec::with_capacity(faces.len());
        let mut sum = 0.0;
        for &face in faces {
            sum += self.vector_area(face).length();
            sums.push(sum);
        }
        let said = parallel::filter_map(points, |point| {
            let wanted = sum * (point as f64 + 0.5) / points as f64;
            let face = *faces.get(sums.partition_point(|&sum| sum <= wanted))?;
            let difference = self.difference(face, point)?;
            let difference = if against[face as usize] { -difference } else { difference };
            (difference.abs() >= CLEAR).then_some(difference > 0.0)
        });
        let outward = said.iter().filter(|&&outward| outward).count();
        let most = outward.max(said.len() - outward);
        Vote { outward: 2 * outward >= said.len(), confidence: (most + 1) as f64 / (said.len() + 2) as f64 }
    }

    /// Twice the vector area of a face.
    fn vector_area(&self, face: u32) -> DVec3 {
        self.obstacles.triangles(face).map(|[a, b, c]| (b - a).cross(c - a)).sum()
    }

    /// How many more rays escape from the front of a face than from its back, as a share; `None` if the face has no
    /// direction, or the rays cost too much.
    fn difference(&self, face: u32, point: usize) -> Option<f64> {
        let normal = self.vector_area(face).try_normalize()?;
        let area =
            |triangle: &[DVec3; 3]| (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).length();
        let mut widest = self.obstacles.triangles(face).max_by(|a, b| area(a).total_cmp(&area(b)))?;
        // The same point for both orientations of the face, so that a reversed mesh votes alike.
        widest.sort_by(|a, b| a.to_array().partial_cmp(&b.to_array()).unwrap_or(std::cmp::Ordering::Equal));
        let from = 0.5 * widest[0] + 0.3125 * widest[1] + 0.1875 * widest[2];
        let up = if normal.to_array() > [0.0; 3] { normal } else { -normal };
        let (x, y) = up.any_orthonormal_pair();
        // The golden angle, so that the directions of no two points are the same.
        let (sine, cosine) = libm::sincos(2.399_963_229_728_653 * point as f64);
        let (x, y) = (x * cosine + y * sine, y * cosine - x * sine);
        let free = |up: DVec3| {
            let ways = self.directions.iter().map(|d| x * d.x + y * d.y + up * d.z);
            ways.map(|way| self.obstacles.is_free(from, way, face, self.budget).map(usize::from))
                .sum::<Option<usize>>()
        };
        let difference = (free(up)? as f64 - free(-up)? as f64) / RAYS as f64;
        Some(if up == normal { difference } else { -difference })
    }
}

/// Directions with the density of diffuse reflection: points spread evenly over a disc (H. Vogel, *A better way to construct
/// the sunflower head*, 1979), raised to the hemisphere.
fn directions() -> Vec<DVec3> {
    let direction = |i: usize| {
        let square = (i as f64 + 0.5) / RAYS as f64;
        let (sine, cosine) = libm::sincos(2.399_963_229_728_653 * i as f64);
        let radius = square.sqrt();
        DVec3::new(radius * cosine, radius * sine, (1.0 - square).sqrt())
    };
    (0..RAYS).map(direction).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Faces, MeshBuilder, Topology, Weld};

    /// The part of the unit sphere above a height, in rings of quadrilaterals that face outwards.
    fn cap(height: f64) -> Mesh {
        const ROUND: u32 = 64;
        const RINGS: u32 = 24;
        let place = |ring: u32, i: u32| {
            let polar = libm::acos(height) * f64::from(ring) / f64::from(RINGS);
            let (sine, cosine) = libm::sincos(std::f64::consts::TAU * f64::from(i) / f64::from(ROUND));
            DVec3::new(libm::sin(polar) * cosine, libm::sin(polar) * sine, libm::cos(polar))
        };
        let positions = (0..=RINGS).flat_map(|ring| (0..ROUND).map(move |i| place(ring, i))).collect();
        let mut faces = Faces::new();
        for ring in 0..RINGS {
            for i in 0..ROUND {
                let (a, b) = (ring * ROUND + i, ring * ROUND + (i + 1) % ROUND);
                faces.push(&[a, a + ROUND, b + ROUND, b]);
            }
        }
        MeshBuilder { positions, faces, ..MeshBuilder::default() }.build().unwrap()
    }

    fn poll(mesh: &Mesh) -> Poll<'_> {
        Poll { obstacles: Obstacles::new(mesh), directions: directions(), budget: 10_000 }
    }

    /// Seen from any point inside a sphere, by the cosine, each part of it takes up its share of the sphere.
    #[test]
    fn within_a_sphere_rays_meet_its_share() {
        for height in [-0.9, -0.5, 0.0, 0.5] {
            let mesh = cap(height);
            let poll = poll(&mesh);
            let share = 0.5 * (1.0 - height);
            for face in (0..mesh.face_count() as u32).step_by(37) {
                let difference = poll.difference(face, face as usize).unwrap();
                // Two of 32 rays lie on the wrong side of the rim at most, or of the facets that approximate it.
                assert!(
                    (difference - share).abs() <= 2.5 / RAYS as f64,
                    "{height}: {difference}, not {share}"
                );
            }
        }
    }

    #[test]
    fn confidence_follows_the_rule_of_succession() {
        let vote = |height: f64| {
            let mesh = cap(height);
            let components = Components::find(&mesh, &Topology::build(&mesh, Weld::Exact));
            votes(&mesh, &components, &[0])[0]
        };
        assert_eq!(vote(0.0), Vote { outward: true, confidence: 65.0 / 66.0 });
        // A twentieth of the sphere: no point has a vote.
        assert_eq!(vote(0.9).confidence, 0.5);
    }

    #[test]
    fn what_costs_too_much_has_no_vote() {
        let mesh = cap(0.0);
        let poll = Poll { budget: 1, ..poll(&mesh) };
        assert_eq!(poll.difference(7, 0), None);
    }
}
