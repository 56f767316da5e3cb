//! Counting edges by what they are, for reports.

use crate::mesh::Link;
use crate::normals::creases::chains::CreaseChains;
use crate::normals::creases::dihedral_test::CreaseTest;
use crate::normals::creases::fans::{Fans, MeshWalker, Sector};
use crate::normals::faces::face_normals::FaceNormals;
use crate::normals::field::{EdgeCounts, Summary};
use glam::DVec3;
use rayon::prelude::*;
use rustc_hash::{FxHashMap, FxHashSet};

/// Counts the edges of a mesh, each once, and those near the crease angle.
///
/// An edge counts as a crease if it is hard at either end: next to a face that adds to no sum, the faces that decide may be
/// others at each end. An edge is near the crease angle within 0.1°, or within what `turns` allows, the angle in radians that
/// the normal of each face may be off by: of the two faces that decide.
pub(crate) fn edge_counts(walker: &MeshWalker, turns: Option<&[f64]>) -> FoundEdges {
    const CHUNK: usize = 1 << 14;
    let corner_count = walker.fans.faces.corners().len();
    let Tally { edges: FoundEdges { mut counts, near, mut creases }, undecided } = (0..corner_count
        .div_ceil(CHUNK))
        .into_par_iter()
        .map(|chunk| {
            let mut tally = Tally::default();
            for half_edge in chunk * CHUNK..((chunk + 1) * CHUNK).min(corner_count) {
                tally.add(walker, turns, half_edge as u32);
            }
            tally
        })
        .reduce(Tally::default, Tally::join);
    let (others, nears) = decided_by_others(walker, turns, &undecided);
    counts.crease += others.len();
    counts.smooth += undecided.len() - others.len();
    creases.extend(others.into_iter().map(|edge| <[u32; 2]>::from(ends(walker, edge))));
    counts.non_manifold = walker.fans.topology.non_manifold_edges();
    counts.ambiguous = walker.fans.topology.ambiguous_edges();
    FoundEdges { counts, near: near + nears, creases }
}

/// Edges by what they are.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct FoundEdges {
    pub(crate) counts: EdgeCounts,
    /// How many are near the crease angle.
    pub(crate) near: usize,
    /// The ends of those that are creases.
    pub(crate) creases: Vec<[u32; 2]>,
}

impl FoundEdges {
    fn join(mut self, other: Self) -> Self {
        self.creases.extend(other.creases);
        Self { counts: self.counts + other.counts, near: self.near + other.near, creases: self.creases }
    }

    /// Puts the edges into a summary.
    pub(crate) fn report(self, positions: &[DVec3], summary: &mut Summary) {
        (summary.edges, summary.near_crease) = (self.counts, self.near);
        // Chains may end at marked edges, too: modelled ones, so there is no scan to detect.
        if self.counts.marked == 0 {
            summary.crease_chains = CreaseChains::of(&self.creases, positions);
        }
    }

    /// Takes an edge into account that its angle decides on.
    fn add(&mut self, is_crease: bool, ends: impl FnOnce() -> (u32, u32)) {
        if is_crease {
            self.counts.crease += 1;
            let (a, b) = ends();
            self.creases.push([a.min(b), a.max(b)]);
        } else {
            self.counts.smooth += 1;
        }
    }
}

#[derive(Default)]
struct Tally {
    pub(crate) edges: FoundEdges,
    /// Edges of a face that may add to no sum, by the lower of their half-edges.
    undecided: Vec<u32>,
}

impl Tally {
    fn join(mut self, other: Self) -> Self {
        self.undecided.extend(other.undecided);
        Self { edges: self.edges.join(other.edges), undecided: self.undecided }
    }

    fn add(&mut self, walker: &MeshWalker, turns: Option<&[f64]>, half_edge: u32) {
        let Self { edges, undecided } = self;
        let counts = &mut edges.counts;
        let across = match walker.fans.topology.link(half_edge) {
            Link::Twin(across) => across,
            Link::Welded(across) => {
                counts.welded += usize::from(half_edge < across);
                across
            }
            Link::Inconsistent(across) => {
                counts.inconsistent += usize::from(half_edge < across);
                return;
            }
            Link::Boundary => {
                counts.boundary += 1;
                return;
            }
            Link::NonManifold | Link::Ambiguous | Link::Collapsed => return,
        };
        if half_edge > across {
            return;
        }
        if walker.fans.marks.is_marked(walker.fans.topology, half_edge, across) {
            counts.marked += 1;
            return;
        }
        let is_crease = match walker.crease {
            CreaseTest::Every => true,
            CreaseTest::None => false,
            CreaseTest::Over { limit, .. } => {
                if !walker.is_counted(half_edge) || !walker.is_counted(across) {
                    undecided.push(half_edge);
                    return;
                }
                edges.near += usize::from(is_near(walker, turns, half_edge, across));
                limit.exceeded(walker.normal(half_edge), walker.normal(across))
            }
        };
        edges.add(is_crease, || ends(walker, half_edge));
    }
}

fn ends(walker: &MeshWalker, half_edge: u32) -> (u32, u32) {
    walker.fans.topology.ends(walker.fans.faces.corners(), half_edge)
}

/// Whether the angle between the faces of two corners is near the crease angle.
fn is_near(walker: &MeshWalker, turns: Option<&[f64]>, a: u32, b: u32) -> bool {
    let faces = [a, b].map(|corner| walker.fans.face_of(corner) as usize);
    are_near(&walker.crease, walker.normals, turns, faces)
}

fn are_near(crease: &CreaseTest, normals: &FaceNormals, turns: Option<&[f64]>, [a, b]: [usize; 2]) -> bool {
    let (normal, other) = (normals.unit[a], normals.unit[b]);
    match turns {
        None => crease.is_near(normal, other),
        Some(turns) => crease.is_near_if_turned(normal, other, turns[a] + turns[b]),
    }
}

/// Edges of triangles counted vertex by vertex: an edge that two ends see, at the lower one. Every face adds to sums.
#[derive(Default)]
pub(crate) struct RingCounts {
    pub(crate) edges: FoundEdges,
    /// The ends of edges with one face.
    pub(crate) open: Vec<[u32; 2]>,
    /// The ends of edges with more than two, lower one first, as often as they are met.
    non_manifold: Vec<[u32; 2]>,
}

impl RingCounts {
    pub(crate) fn join(mut self, mut other: Self) -> Self {
        self.open.append(&mut other.open);
        self.non_manifold.append(&mut other.non_manifold);
        Self { edges: self.edges.join(other.edges), ..self }
    }

    /// Takes the edge that leaves a corner into account.
    pub(crate) fn add(
        &mut self,
        crease: &CreaseTest,
        normals: &FaceNormals,
        turns: Option<&[f64]>,
        [from, to]: [u32; 2],
        corner: u32,
        link: Link,
    ) {
        let counts = &mut self.edges.counts;
        match link {
            Link::Twin(across) if from < to => {
                let faces = [corner, across].map(|corner| corner as usize / 3);
                let is_crease = match crease {
                    CreaseTest::Every => true,
                    CreaseTest::None => false,
                    CreaseTest::Over { limit, .. } => {
                        self.edges.near += usize::from(are_near(crease, normals, turns, faces));
                        limit.exceeded(normals.unit[faces[0]], normals.unit[faces[1]])
                    }
                };
                self.edges.add(is_crease, || (from, to));
            }
            Link::Inconsistent(across) => counts.inconsistent += usize::from(corner < across),
            Link::Boundary => counts.boundary += 1,
            Link::NonManifold => self.non_manifold.push([from.min(to), from.max(to)]),
            Link::Twin(_) | Link::Welded(_) | Link::Ambiguous | Link::Collapsed => {}
        }
    }

    /// The edges, when all are counted.
    pub(crate) fn finish(mut self) -> FoundEdges {
        self.non_manifold.sort_unstable();
        self.non_manifold.dedup();
        self.edges.counts.non_manifold = self.non_manifold.len();
        self.edges
    }
}

/// Which edges are creases, and how many are near ones, by the faces that decide in the sectors of fan at their two ends.
/// Each sector is walked once.
fn decided_by_others(walker: &MeshWalker, turns: Option<&[f64]>, edges: &[u32]) -> (Vec<u32>, usize) {
    let mut verdicts: FxHashMap<u32, Verdict> = FxHashMap::default();
    let mut walked: FxHashSet<u32> = FxHashSet::default();
    let (mut sector, mut places) = (Sector::default(), Vec::new());
    for &edge in edges {
        let across = walker.fans.topology.across(edge).expect("such an edge has two faces");
        for corner in [edge, across] {
            if walked.contains(&corner) {
                continue;
            }
            walker.sector(corner, &mut sector);
            walked.extend(&sector.corners);
            walker.for_each_decision(&sector, &mut places, |corner, a, b| {
                let across = walker.fans.topology.across(corner).unwrap_or(corner);
                let verdict = verdicts.entry(corner.min(across)).or_default();
                verdict.is_crease |= walker.crease.is_over(walker.normal(a), walker.normal(b));
                verdict.is_near |= is_near(walker, turns, a, b);
            });
        }
    }
    let is = |edge: &&u32, kind: fn(&Verdict) -> bool| verdicts.get(edge).is_some_and(kind);
    let creases = edges.iter().filter(|edge| is(edge, |verdict| verdict.is_crease));
    (creases.copied().collect(), edges.iter().filter(|edge| is(edge, |verdict| verdict.is_near)).count())
}

#[derive(Default)]
struct Verdict {
    is_crease: bool,
    is_near: bool,
}

impl std::ops::Add for EdgeCounts {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            smooth: self.smooth + other.smooth,
            boundary: self.boundary + other.boundary,
            non_manifold: self.non_manifold + other.non_manifold,
            inconsistent: self.inconsistent + other.inconsistent,
            ambiguous: self.ambiguous + other.ambiguous,
            marked: self.marked + other.marked,
            crease: self.crease + other.crease,
            welded: self.welded + other.welded,
        }
    }
}
