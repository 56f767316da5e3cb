//! Smooth groups of plain triangles, vertex by vertex.
//!
//! All edges at a vertex are seen from its own corners, so the fans around it need no topology of the whole
//! mesh. Up to eight corners are matched by one comparison of vertex numbers each, and most edges are smooth by one product of
//! normals. Vertices of more corners, and those where edges are irregular, are matched and walked in full.

use crate::mesh::{EdgeMatcher, FacesRef, Link, NONE, Rings, Scatter, next_in_triangle};
use crate::normals::creases::dihedral_test::CreaseTest;
use crate::normals::creases::edge_counts::RingCounts;
use crate::normals::creases::fans::{FanWalker, Fans};
use crate::normals::creases::smooth_groups::{FanScratch, label_ring};
use crate::normals::creases::spokes::{Links, Spokes};
use crate::normals::faces::face_normals::FaceNormals;
use crate::normals::faces::shape::FaceState;
use crate::normals::recipe::Slivers;
use crate::num::parallel;
use crate::num::{self, Kernel, Lanes};
use rayon::prelude::*;

/// Memory that the next call reuses.
#[derive(Default)]
pub(crate) struct GroupMemory {
    rings: Rings,
    /// For each vertex its first entry, with [`SPLIT`] if there are others.
    firsts: Vec<u32>,
    /// The group of each corner at a vertex that is split; elsewhere left to chance.
    labels: Scatter,
}

/// The vertex has several groups: its corners have labels. Above all numbers of corners that a mesh may have.
const SPLIT: u32 = 1 << 31;

/// Vertices of one task.
const TASK: usize = 1024;
/// Vertices whose corners are all stored before any is read: vectors read right behind the writes of their elements would wait
/// for them.
const BLOCK: usize = 16;

/// What decides about groups.
#[derive(Clone, Copy)]
pub(crate) struct TriangleCreases<'a> {
    pub(crate) faces: FacesRef<'a>,
    /// May be empty if no edge is hard for its angle.
    pub(crate) normals: &'a FaceNormals,
    pub(crate) crease: CreaseTest,
    pub(crate) slivers: Slivers,
    /// Whether to count the edges, and by how many radians rounding may turn the normal of each face. Every face must add to
    /// sums.
    pub(crate) counts: Option<Option<&'a [f64]>>,
}

impl TriangleCreases<'_> {
    /// Writes the entry of each corner, as [`SmoothGroups::by_fan`](crate::normals::creases::smooth_groups::SmoothGroups::by_fan) numbers them, and
    /// gives how many there are. With [`counts`](Self::counts), counts edges too; open edges are always collected.
    pub(crate) fn entries(
        self,
        vertex_count: usize,
        memory: &mut GroupMemory,
        entries: &mut [u32],
    ) -> (usize, RingCounts) {
        let GroupMemory { rings, firsts, labels } = memory;
        let vertices = self.faces.corners();
        rings.fill(vertices, vertex_count);
        labels.reserve(vertices.len());
        firsts.resize(vertex_count, 0);
        let all_counted = parallel::all(&self.normals.state, |&state| state == FaceState::Counted);
        let (rings, labels) = (&*rings, &*labels);
        let context = Context {
            creases: self,
            matcher: &EdgeMatcher::new(self.faces, &[]),
            rings,
            labels,
            all_counted,
        };
        let tasks = firsts.par_chunks_mut(TASK).enumerate();
        let found = tasks.map_init(
            || Walk::new(context),
            |walk, (task, counts)| {
                num::dispatch(CountGroups { walk, first: task * TASK, counts });
                std::mem::take(&mut walk.found)
            },
        );
        let found = found.reduce(RingCounts::default, RingCounts::join);
        let mut total = 0;
        for first in firsts.iter_mut() {
            let count = *first & !SPLIT;
            *first = total | *first & SPLIT;
            total += count;
        }
        let entry = |corner: usize, vertex: u32| match firsts[vertex as usize] {
            first if first & SPLIT == 0 => first,
            first => (first & !SPLIT) + labels.get(corner as u32),
        };
        let rows = entries.par_chunks_mut(3 * TASK).zip(vertices.par_chunks(3 * TASK)).enumerate();
        rows.for_each(|(task, (entries, vertices))| {
            for (i, (to, &vertex)) in entries.iter_mut().zip(vertices).enumerate() {
                *to = entry(task * 3 * TASK + i, vertex);
            }
        });
        (total as usize, found)
    }
}

impl GroupMemory {
    /// The vertex of each entry.
    pub(crate) fn entry_vertices(&self, entries: usize) -> Vec<u32> {
        let mut vertices = Vec::with_capacity(entries);
        let ends = self.firsts.iter().skip(1).map(|first| first & !SPLIT).chain([entries as u32]);
        for (vertex, end) in (0..).zip(ends) {
            vertices.resize(end as usize, vertex);
        }
        vertices
    }
}

/// What all tasks share.
#[derive(Clone, Copy)]
struct Context<'a> {
    creases: TriangleCreases<'a>,
    matcher: &'a EdgeMatcher<'a>,
    rings: &'a Rings,
    labels: &'a Scatter,
    /// Whether no triangle is a sliver or worse.
    all_counted: bool,
}

/// Counts the groups at some vertices in a row, and labels the corners of those that have several.
struct CountGroups<'a, 'w> {
    walk: &'w mut Walk<'a>,
    first: usize,
    /// One number a vertex.
    counts: &'w mut [u32],
}

impl Kernel for CountGroups<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run<A: Lanes>(self, arch: A) {
        let Self { walk, first, counts } = self;
        let context = walk.context;
        let TriangleCreases { crease, counts: counted, .. } = context.creases;
        let filter = crease.filter(counted.is_some());
        let every = matches!(crease, CreaseTest::Every);
        let triangles = context.creases.faces.corners().as_chunks().0;
        let FaceNormals { unit, state } = context.creases.normals;
        let state: &[FaceState] = if context.all_counted { &[] } else { state };
        let mut block = [const { Spokes::NONE }; BLOCK];
        for (first, counts) in (first..).step_by(BLOCK).zip(counts.chunks_mut(BLOCK)) {
            for (vertex, spokes) in (first..first + counts.len()).zip(&mut block) {
                spokes.lay_out(triangles, vertex as u32, context.rings.at(vertex));
            }
            for ((vertex, count), spokes) in (first..).zip(counts).zip(&block) {
                let Some(links) = spokes.links(arch, state) else {
                    *count = walk.count_groups(vertex);
                    continue;
                };
                let uncertain = if every {
                    links.linked
                } else {
                    spokes.uncertain(links, unit, counted.flatten(), filter)
                };
                *count = match uncertain == 0 && links.are_one_cycle(spokes.count) {
                    true => {
                        if counted.is_some() {
                            walk.found.edges.counts.smooth += spokes.edges_to_higher(vertex as u32);
                        }
                        1
                    }
                    false if counted.is_none() => walk.count_linked_groups(vertex, spokes, links, uncertain),
                    false => walk.count_groups(vertex),
                };
            }
        }
    }
}

/// Looks at one vertex after the other in full.
struct Walk<'a> {
    context: Context<'a>,
    walker: FanWalker<'a, RingFans>,
    scratch: FanScratch,
    found: RingCounts,
}

impl<'a> Walk<'a> {
    fn new(context: Context<'a>) -> Self {
        let TriangleCreases { normals, crease, slivers, .. } = context.creases;
        let walker = FanWalker { fans: RingFans::default(), normals, crease, slivers };
        Self { context, walker, scratch: FanScratch::default(), found: RingCounts::default() }
    }

    /// As [`count_groups`](Self::count_groups), where the links are known. The edges after `uncertain` corners are tested exactly.
    #[inline(never)]
    fn count_linked_groups(&mut self, vertex: usize, spokes: &Spokes, links: Links, uncertain: u8) -> u32 {
        let Context { rings, labels, creases, .. } = self.context;
        let (unit, count) = (&creases.normals.unit, spokes.count);
        let mut smooth = links;
        for at in 0..count {
            if links.linked >> at & 1 == 0 {
                self.found.edges.open.push([vertex as u32, spokes.to[at]]);
            }
            let normal = |at: usize| unit[spokes.faces[at] as usize];
            if uncertain >> at & 1 == 1 && creases.crease.is_over(normal(at), normal(links.after(at))) {
                smooth.linked &= !(1 << at);
            }
        }
        let ring = rings.at(vertex);
        let mut groups = 0;
        for group in smooth.groups(count) {
            let members = ring.iter().enumerate().filter(|(at, _)| group >> at & 1 == 1);
            members.for_each(|(_, &corner)| labels.set(corner, groups));
            groups += 1;
        }
        if groups > 1 { groups | SPLIT } else { groups }
    }

    /// How many groups there are at a vertex, with [`SPLIT`] if they are several; then its corners are labelled.
    #[inline(never)]
    fn count_groups(&mut self, vertex: usize) -> u32 {
        let Context { matcher, rings, labels, creases, .. } = self.context;
        let ring = rings.at(vertex);
        let Self { walker, found, .. } = self;
        let vertices = creases.faces.corners();
        walker.fans.find(matcher, vertex as u32, ring, |corner, link| {
            let to = vertices[next_in_triangle(corner) as usize];
            found.edges.open.extend((link == Link::Boundary).then_some([vertex as u32, to]));
            if let Some(turns) = creases.counts {
                found.add(&creases.crease, creases.normals, turns, [vertex as u32, to], corner, link);
            }
        });
        ring.iter().for_each(|&corner| labels.set(corner, NONE));
        let count = label_ring(&self.walker, ring, labels, &mut self.scratch);
        if count > 1 { count | SPLIT } else { count }
    }
}

/// The fans around one vertex.
#[derive(Default)]
struct RingFans {
    /// Ascending.
    corners: Vec<u32>,
    /// For each the corner before it and the one after it in its fan.
    neighbours: Vec<[Option<u32>; 2]>,
    outliers: Vec<bool>,
}

impl RingFans {
    /// Matches the edges at a vertex.
    fn find(&mut self, matcher: &EdgeMatcher, vertex: u32, ring: &[u32], mut visit: impl FnMut(u32, Link)) {
        self.corners.clear();
        self.corners.extend_from_slice(ring);
        self.neighbours.clear();
        self.neighbours.resize(ring.len(), [None; 2]);
        self.outliers.clear();
        self.outliers.resize(ring.len(), false);
        matcher.match_ring(vertex, ring, |corner, link| {
            visit(corner, link);
            let place = self.place(corner);
            match link {
                Link::Twin(across) => {
                    let next = next_in_triangle(across);
                    let next_place = self.place(next);
                    self.neighbours[place][1] = Some(next);
                    self.neighbours[next_place][0] = Some(corner);
                }
                Link::Collapsed => self.outliers[place] = true,
                _ => {}
            }
        });
    }

    fn place(&self, corner: u32) -> usize {
        self.corners.binary_search(&corner).expect("a corner at this vertex")
    }
}

impl Fans for RingFans {
    fn forward(&self, corner: u32) -> Option<u32> {
        self.neighbours[self.place(corner)][1]
    }

    fn backward(&self, corner: u32) -> Option<u32> {
        self.neighbours[self.place(corner)][0]
    }

    fn is_isolated(&self, corner: u32) -> bool {
        self.outliers[self.place(corner)]
    }

    fn face_of(&self, corner: u32) -> u32 {
        corner / 3
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Faces, MeshBuilder, Positions, Storage, Topology};
    use crate::normals::creases::edge_counts::edge_counts;
    use crate::normals::creases::fans::MeshFans;
    use crate::normals::creases::hard_edges::Marks;
    use crate::normals::creases::smooth_groups::SmoothGroups;
    use crate::normals::faces::face_normals::face_normals;
    use crate::normals::recipe::NormalRecipe;
    use crate::num::{Degrees, test_numbers::Numbers};
    use glam::DVec3;

    /// Few vertices, so that triangles meet in every way: edges of three and more, fans that touch in a point, triangles that
    /// are wound against each other or have a vertex twice, fans of more triangles than lanes. Flat places make slivers.
    fn soup(numbers: &mut Numbers) -> (Vec<DVec3>, Vec<[u32; 3]>) {
        let vertices = 3 + numbers.below(12);
        let mut coordinate = || f64::from(numbers.below(5) as u8);
        let positions =
            (0..vertices).map(|_| DVec3::new(coordinate(), coordinate(), 0.1 * coordinate())).collect();
        let mut triangles: Vec<[u32; 3]> = Vec::new();
        if numbers.below(2) == 0 {
            // A fan around the first vertex: closed, or a piece of it.
            let rim = vertices as u32 - 1;
            let present = 1 + numbers.below(rim as usize) as u32;
            triangles.extend((0..present).map(|i| [0, 1 + i, 1 + (i + 1) % rim]));
        }
        for _ in 0..numbers.below(10) {
            triangles.push([(); 3].map(|()| numbers.below(vertices) as u32));
        }
        (positions, triangles)
    }

    #[test]
    fn groups_are_those_that_the_whole_topology_gives() {
        let mut numbers = Numbers::new(5);
        let mut memory = GroupMemory::default();
        let (mut sharp_and_smooth, mut near) = (0, 0);
        for round in 0..20_000 {
            let (positions, triangles) = soup(&mut numbers);
            let faces = FacesRef::triangles(&triangles);
            let normals = face_normals(faces, Positions::rounded(positions.clone(), Storage::F32).view());
            let crease = CreaseTest::new(Some(Degrees([0.0, 10.0, 40.0, 100.0, 180.0][round % 5])));
            let slivers = [Slivers::Exclude, Slivers::Keep][round % 2];

            let mesh = MeshBuilder {
                positions: positions.clone().into(),
                faces: Faces::triangles(triangles.as_flattened().to_vec()),
                ..MeshBuilder::default()
            };
            let mesh = mesh.build().unwrap();
            let topology = Topology::by_index(mesh.faces(), positions.len());
            let marks = Marks::new(&mesh, &NormalRecipe::default());
            let fans = MeshFans { faces, topology: &topology, marks: &marks };
            let walker = FanWalker { fans, normals: &normals, crease, slivers };
            let expected = SmoothGroups::by_fan(&walker, positions.len());

            // Edges are counted only where every face adds to sums; some with normals that rounding may have turned.
            let all_counted = normals.state.iter().all(|&state| state == FaceState::Counted);
            let turns = vec![0.02; triangles.len()];
            let turns = (round % 3 == 0).then_some(turns.as_slice());
            let counts = all_counted.then_some(turns);
            let creases = TriangleCreases { faces, normals: &normals, crease, slivers, counts };
            let mut entries = vec![0; 3 * triangles.len()];
            let (count, found) = creases.entries(positions.len(), &mut memory, &mut entries);
            assert_eq!(entries, expected.corner_entry, "{triangles:?} {positions:?} {crease:?}");
            assert_eq!(memory.entry_vertices(count), expected.entry_vertex);
            let open = (0..entries.len() as u32).filter(|&h| topology.link(h) == Link::Boundary);
            let mut open: Vec<_> =
                open.map(|h| <[u32; 2]>::from(topology.ends(faces.corners(), h))).collect();
            open.sort_unstable();
            let mut found_open = found.edges.open.clone();
            found_open.sort_unstable();
            assert_eq!(found_open, open);
            if all_counted {
                let (mut found, mut expected) = (found.finish(false), edge_counts(&walker, turns));
                [&mut found, &mut expected].into_iter().for_each(|edges| {
                    [&mut edges.creases, &mut edges.open, &mut edges.irregular]
                        .into_iter()
                        .for_each(|ends| ends.sort_unstable())
                });
                assert_eq!(found, expected, "{triangles:?} {positions:?} {crease:?}");
                sharp_and_smooth += usize::from(expected.counts.smooth > 0 && expected.counts.crease > 0);
                near += usize::from(expected.near > 0);
            }
        }
        assert!(sharp_and_smooth > 100 && near > 20, "too few meshes: {sharp_and_smooth} {near}");
    }
}
