//! Counting edges by kind, for reports.

use crate::mesh::{Link, PositionsRef};
use crate::normals::creases::chains::CreaseChains;
use crate::normals::creases::dihedral_test::CreaseTest;
use crate::normals::creases::fans::{Fans, MeshWalker, Sector};
use crate::normals::faces::face_normals::FaceNormals;
use crate::normals::field::EdgeCounts;
use crate::num::parallel;
use rustc_hash::{FxHashMap, FxHashSet};

/// Counts the edges of a mesh, each once, and those near the crease angle.
///
/// An edge counts as a crease if it is hard at either end: next to a face that adds to no sum, the faces that decide may be
/// others at each end. An edge is near the crease angle within 0.1°, or within what `turns` allows, the angle in radians that
/// the normal of each face may be off by: of the two faces that decide.
pub(crate) fn edge_counts(walker: &MeshWalker, turns: Option<&[f64]>) -> FoundEdges {
    const CHUNK: usize = 1 << 14;
    let corner_count = walker.fans.faces.corners().len();
    let tallies = parallel::blocks(corner_count, CHUNK, |half_edges| {
        let mut tally = Tally::default();
        for half_edge in half_edges {
            tally.add(walker, turns, half_edge as u32);
        }
        tally
    });
    let Tally { mut edges, undecided } = tallies.into_iter().fold(Tally::default(), Tally::join);
    for (edge, verdict) in decided_by_others(walker, turns, &undecided) {
        edges.add(verdict, || ends(walker, edge));
    }
    edges.counts.non_manifold = walker.fans.topology.non_manifold_edges();
    edges.counts.ambiguous = walker.fans.topology.ambiguous_edges();
    edges
}

fn ends(walker: &MeshWalker, half_edge: u32) -> (u32, u32) {
    walker.fans.topology.ends(walker.fans.faces.corners(), half_edge)
}

/// Edges by what they are.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct FoundEdges {
    pub(crate) counts: EdgeCounts,
    /// How many are near the crease angle.
    pub(crate) near: usize,
    /// The ends of those that are hard for their angle, the lower first.
    pub(crate) creases: Vec<[u32; 2]>,
    /// The ends of those with one face.
    pub(crate) open: Vec<[u32; 2]>,
    /// The ends of others at which a crease may end: of more than two faces, of reversed ones, and of faces that add to no sum.
    pub(crate) irregular: Vec<[u32; 2]>,
}

impl FoundEdges {
    fn join(mut self, mut other: Self) -> Self {
        self.creases.append(&mut other.creases);
        self.open.append(&mut other.open);
        self.irregular.append(&mut other.irregular);
        Self { counts: self.counts + other.counts, near: self.near + other.near, ..self }
    }

    /// Takes an edge between two faces into account.
    fn add(&mut self, Verdict { is_crease, is_near }: Verdict, ends: impl FnOnce() -> (u32, u32)) {
        self.near += usize::from(is_near);
        if is_crease {
            self.counts.crease += 1;
            let (a, b) = ends();
            self.creases.push([a.min(b), a.max(b)]);
        } else {
            self.counts.smooth += 1;
        }
    }

    /// The chains of creases. None are counted if chains may end at marked edges, too, which are modelled, or if nothing is
    /// smooth.
    pub(crate) fn chains(&self, positions: PositionsRef) -> CreaseChains {
        match self.counts {
            EdgeCounts { marked: 0, smooth: 1.., .. } => {
                CreaseChains::of(&self.creases, &[&self.open[..], &self.irregular].concat(), positions)
            }
            _ => CreaseChains::default(),
        }
    }
}

#[derive(Default)]
struct Tally {
    edges: FoundEdges,
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
        if walker.fans.topology.has_no_length(half_edge) {
            edges.irregular.push(ends(walker, half_edge).into());
            return;
        }
        let across = match walker.fans.topology.link(half_edge) {
            Link::Twin(across) => across,
            Link::Welded(across) => {
                counts.welded += usize::from(half_edge < across);
                across
            }
            Link::Inconsistent(across) => {
                counts.inconsistent += usize::from(half_edge < across);
                edges.irregular.push(ends(walker, half_edge).into());
                return;
            }
            Link::Boundary => {
                counts.boundary += 1;
                edges.open.push(ends(walker, half_edge).into());
                return;
            }
            Link::NonManifold | Link::Ambiguous | Link::Collapsed => {
                edges.irregular.push(ends(walker, half_edge).into());
                return;
            }
        };
        if half_edge > across {
            return;
        }
        if walker.fans.marks.is_marked(walker.fans.topology, half_edge, across) {
            counts.marked += 1;
            return;
        }
        let is_decided = walker.is_counted(half_edge) && walker.is_counted(across);
        if !is_decided && matches!(walker.crease, CreaseTest::Over { .. }) {
            undecided.push(half_edge);
            edges.irregular.push(ends(walker, half_edge).into());
            return;
        }
        let faces = [half_edge, across].map(|corner| walker.fans.face_of(corner) as usize);
        let verdict = Verdict::new(&walker.crease, walker.normals, turns, faces);
        edges.add(verdict, || ends(walker, half_edge));
    }
}

/// What an edge between two faces is.
#[derive(Clone, Copy, Default)]
struct Verdict {
    is_crease: bool,
    is_near: bool,
}

impl Verdict {
    /// Of the edge between two faces that add to sums; their normals matter only if edges are hard for their angle.
    fn new(crease: &CreaseTest, normals: &FaceNormals, turns: Option<&[f64]>, [a, b]: [usize; 2]) -> Self {
        if !matches!(crease, CreaseTest::Over { .. }) {
            return Self { is_crease: matches!(crease, CreaseTest::Every), is_near: false };
        }
        let (normal, other) = (normals.unit[a], normals.unit[b]);
        let is_near = match turns {
            None => crease.is_near(normal, other),
            Some(turns) => crease.is_near_if_turned(normal, other, turns[a] + turns[b]),
        };
        Self { is_crease: crease.is_over(normal, other), is_near }
    }
}

/// Edges of triangles counted vertex by vertex: an edge that two ends see, at the lower one. Every face adds to sums.
#[derive(Default)]
pub(crate) struct RingCounts {
    pub(crate) edges: FoundEdges,
    /// The ends of edges with more than two, lower one first, as often as they are met.
    non_manifold: Vec<[u32; 2]>,
}

impl RingCounts {
    pub(crate) fn join(mut self, mut other: Self) -> Self {
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
                self.edges.add(Verdict::new(crease, normals, turns, faces), || (from, to));
            }
            Link::Inconsistent(across) => {
                counts.inconsistent += usize::from(corner < across);
                self.edges.irregular.push([from, to]);
            }
            Link::Boundary => counts.boundary += 1,
            Link::NonManifold => {
                self.non_manifold.push([from.min(to), from.max(to)]);
                self.edges.irregular.push([from, to]);
            }
            Link::Ambiguous | Link::Collapsed => self.edges.irregular.push([from, to]),
            Link::Twin(_) | Link::Welded(_) => {}
        }
    }

    /// The edges, when all are counted. `joined`: by position, all of them, instead of by vertex.
    pub(crate) fn finish(mut self, joined: bool) -> FoundEdges {
        self.non_manifold.sort_unstable();
        self.non_manifold.dedup();
        let counts = EdgeCounts { non_manifold: self.non_manifold.len(), ..self.edges.counts };
        self.edges.counts = if joined { counts.all_welded() } else { counts };
        self.edges
    }
}

/// What edges are by the faces that decide in the sectors of fan at their two ends. Each sector is walked once.
fn decided_by_others<'a>(
    walker: &MeshWalker,
    turns: Option<&[f64]>,
    edges: &'a [u32],
) -> impl Iterator<Item = (u32, Verdict)> + use<'a> {
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
                let faces = [a, b].map(|corner| walker.fans.face_of(corner) as usize);
                let found = Verdict::new(&walker.crease, walker.normals, turns, faces);
                verdict.is_crease |= found.is_crease;
                verdict.is_near |= found.is_near;
            });
        }
    }
    edges.iter().map(move |edge| (*edge, verdicts.get(edge).copied().unwrap_or_default()))
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
