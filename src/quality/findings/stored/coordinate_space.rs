//! Stored normals in another space of the node tree than their positions.

use crate::io::{FileNode, NodeTree};
use crate::mesh::{Mesh, normal_matrix};
use crate::num::UnitVec3;
use crate::quality::estimate::recipe::Estimate;
use crate::quality::findings::prelude::*;
use crate::quality::findings::stored::rotated::{ALIKE, explains, least, worst};
use glam::{DMat3, DVec3};
use std::ops::Range;

const NODES: usize = 32;

/// The angle in degrees up to which a matrix changes normals only by rounding.
const ROUNDING: f64 = 1e-6;

const SAMPLE: usize = 1 << 11;

/// The most likely mistake with the matrices of the nodes that place a mesh, if there may be one. The node tree is read only if it is
/// needed.
pub(crate) fn find_mistake<'a>(
    facts: &Facts<'_>,
    nodes: &[&FileNode],
    tree: &dyn Fn() -> Option<&'a NodeTree<'a>>,
) -> Option<Mistake> {
    facts.stored?;
    let thresholds = facts.thresholds;
    let of_node = |node: &&FileNode| Chain::new(node, tree()).mistakes(thresholds.rotation.0);
    let possible: Vec<Vec<Candidate>> = nodes.iter().take(NODES).map(of_node).collect();
    if possible.iter().all(Vec::is_empty) {
        return None;
    }
    let mean = |agreement: &dyn Fn(DVec3, DVec3) -> f64| mean(facts, 1, agreement);
    let either_way = mean(&|stored, expected| stored.dot(expected).abs());
    // No matrix explains what is not wrong.
    if 1.0 - either_way <= least(thresholds) {
        return None;
    }
    let (best, is_only) = best_of(facts, &possible)?;
    let matrix = normal_matrix(best.map)?;
    let with = mean(&|stored, expected| stored.dot(matrix.apply(expected).unwrap_or(expected)));
    let rotation = facts.rotation.unwrap_or_default();
    let by_rotation = || mean(&|stored, expected| stored.dot(rotation * expected));
    let is_certain = explains(with, either_way, thresholds) && by_rotation() - with <= least(thresholds);
    if !is_certain && with <= mean(&|stored, expected| stored.dot(expected)) {
        return None;
    }
    let description = best.describe(|node| tree().map(|tree| tree.name(node)));
    Some(Mistake {
        taken_back: taken_back(facts.mesh, best.map),
        degrees: best.degrees,
        description: description.map(|mistake| match is_only {
            true => mistake,
            false => REMARKS.with("or-another-mistake", &[("mistake", mistake.into())]),
        }),
        is_certain,
    })
}

/// Stored normals that matrices of nodes seem to have transformed.
pub(crate) struct Mistake {
    /// The mesh with its stored normals in its own space.
    pub(crate) taken_back: Mesh,
    /// The largest angle by which the matrices turn normals, in degrees.
    degrees: f64,
    /// Which nodes' matrices were mistaken, and how.
    description: Option<Text>,
    /// Whether the normals then agree so well with the faces that no other proof is needed.
    is_certain: bool,
}

impl Mistake {
    /// Whether this is the fault, by the recipes of the normals as stored and taken back. After a stretch, normals may look as if
    /// made by another recipe, by which the matrix explains nothing: then the recipes decide.
    pub(crate) fn is_proved(&self, as_stored: Option<Estimate>, taken_back: Option<Estimate>) -> bool {
        let estimates = as_stored.zip(taken_back);
        self.is_certain || estimates.is_some_and(|(as_stored, taken_back)| taken_back.clears_up(&as_stored))
    }

    /// Reports it, with the worst positions of the normals as stored.
    pub(crate) fn report(&self, stored: &Facts<'_>, found: &mut Found) {
        found.add_mesh(Kind::Untransformed, stored.total_area, worst(stored));
        let tally = found.tally(Kind::Untransformed);
        tally.rotation_degrees = Some(self.degrees);
        tally.remark = self.description.clone().map(|text| Remark { weight: self.degrees, text });
    }
}

/// The nodes that place a mesh and turn or stretch it, from the root, and the product of their matrices.
struct Chain {
    links: Vec<(usize, DMat3)>,
    whole: DMat3,
}

impl Chain {
    fn new(node: &FileNode, tree: Option<&NodeTree<'_>>) -> Self {
        let whole = DMat3::from_mat4(node.world_from_part);
        let matrices = tree.map(|tree| tree.chain(node.number).into_iter());
        let links = matrices.map(|links| links.map(|(node, map)| (node, DMat3::from_mat4(map))).collect());
        let mut links: Vec<(usize, DMat3)> = links.unwrap_or_else(|| vec![(node.number, whole)]);
        // A mesh that is flattened has no normals.
        links.retain(|&(_, map)| largest_rotation(map) > ROUNDING && normal_matrix(whole).is_some());
        Self { links, whole }
    }

    fn product(&self, range: Range<usize>) -> DMat3 {
        self.links[range].iter().fold(DMat3::IDENTITY, |above, link| above * link.1)
    }

    /// All mistakes with the matrix of one node, or of those from the root to one or from one to the mesh, that turn normals by
    /// more than so many degrees; the likely ones first.
    fn mistakes(&self, least_rotation: f64) -> Vec<Candidate> {
        let count = self.links.len();
        let to_mesh = (0..count).map(|from| from..count);
        let from_root = (1..count).map(|to| 0..to);
        // Those at both ends are among the others.
        let single = (1..count.max(2) - 1).map(|at| at..at + 1);
        let mut mistakes = Vec::new();
        for range in to_mesh.chain(from_root).chain(single) {
            let map = if range.len() == count { self.whole } else { self.product(range.clone()) };
            let below = self.product(range.end..count);
            let ends = [range.start, range.end - 1].map(|at| self.links[at].0);
            let seen_here = below.inverse() * map * below;
            let within = [(How::Within, map, map), (How::WithinInverse, map.inverse(), map)];
            let all = [(How::Twice, seen_here, seen_here), (How::Missing, seen_here.inverse(), seen_here)]
                .into_iter()
                .chain(within.into_iter().filter(|_| range.end < count));
            for (how, map, forward) in all {
                let degrees = largest_rotation(forward);
                if degrees > least_rotation && map.is_finite() {
                    mistakes.push(Candidate { map, degrees, ends, how });
                }
            }
        }
        mistakes
    }
}

/// What may have been done wrong with the matrices of consecutive nodes.
#[derive(Clone, Copy)]
enum How {
    /// They are in the normals, and the nodes apply them again.
    Twice,
    /// Their inverse is in the normals, and the nodes undo it.
    Missing,
    /// They are in the normals, in a space that they are not for.
    Within,
    /// The same with their inverse.
    WithinInverse,
}

struct Candidate {
    /// The map of points whose normal matrix was applied to the normals.
    map: DMat3,
    /// The largest angle by which the matrices turn normals, in degrees.
    degrees: f64,
    /// The first and the last of the nodes.
    ends: [usize; 2],
    how: How,
}

impl Candidate {
    fn describe(&self, name: impl Fn(usize) -> Option<String>) -> Option<Text> {
        let mistake = match self.how {
            How::Twice => "applied-twice",
            How::Missing => "undone",
            How::Within => "applied-elsewhere",
            How::WithinInverse => "undone-elsewhere",
        };
        let [first, last] = self.ends;
        let nodes = if first == last { "node" } else { "nodes" };
        let names = [("first", name(first)?.into()), ("last", name(last)?.into())];
        Some(REMARKS.with(&format!("{mistake}-{nodes}"), &names))
    }
}

/// The mean over every `step`-th face, weighted by area, of a function of stored and expected normals.
fn mean(facts: &Facts<'_>, step: usize, agreement: &dyn Fn(DVec3, DVec3) -> f64) -> f64 {
    let (mut sum, mut weight) = (0.0, 0.0);
    let faces = (0..facts.mesh.face_count()).step_by(step);
    for face in faces.filter(|&face| facts.has_direction(face)) {
        for corner in facts.corners_of(face) {
            if let Some(stored) = facts.stored_unit(corner) {
                sum += facts.area[face] * agreement(stored, facts.expected_or_face(face, corner));
                weight += facts.area[face];
            }
        }
    }
    sum / weight
}

/// The mistake that agrees best with a sample of the faces, the first of several, and whether it is the only one of its node.
fn best_of<'a>(facts: &Facts<'_>, possible: &'a [Vec<Candidate>]) -> Option<(&'a Candidate, bool)> {
    let step = facts.mesh.face_count().div_ceil(SAMPLE).max(1);
    let agreement = |candidate: &'a Candidate| {
        let matrix = normal_matrix(candidate.map)?;
        let cosine = |stored: DVec3, expected| stored.dot(matrix.apply(expected).unwrap_or(expected));
        Some((mean(facts, step, &cosine), candidate))
    };
    let by_node: Vec<Vec<(f64, &Candidate)>> =
        possible.iter().map(|candidates| candidates.iter().filter_map(agreement).collect()).collect();
    let best = by_node.iter().flatten().map(|it| it.0).reduce(f64::max)?;
    by_node.iter().find_map(|candidates| {
        let mut alike = candidates.iter().filter(|it| it.0 >= best - ALIKE).map(|it| it.1);
        Some((alike.next()?, alike.next().is_none()))
    })
}

/// A mesh with the stored normals that it had before a linear map of points transformed them. Lengths stay.
fn taken_back(mesh: &Mesh, map: DMat3) -> Mesh {
    let mut normals = mesh.columns().normals.clone();
    let back = normal_matrix(map.inverse());
    for normal in normals.iter_mut().flat_map(|column| &mut column.values) {
        let unit = UnitVec3::new(*normal).and_then(|unit| back.as_ref()?.apply(unit.get()));
        *normal = unit.map_or(*normal, |unit| unit * normal.length());
    }
    mesh.clone().with_normals(normals)
}

/// The largest angle by which a linear map turns normals, over the axes and the diagonals, in degrees.
fn largest_rotation(map: DMat3) -> f64 {
    let [across, up] = [DVec3::new(1.0, -1.0, 1.0), DVec3::new(1.0, 1.0, -1.0)];
    let directions = [DVec3::X, DVec3::Y, DVec3::Z, DVec3::ONE, across, up];
    let Some(matrix) = normal_matrix(map) else { return 0.0 };
    let turn = |d: DVec3| matrix.apply(d).map_or(0.0, |turned| degrees_between(d, turned));
    directions.into_iter().map(turn).fold(0.0, f64::max)
}
