//! Which faces meet at which edges.
//!
//! Half-edge `c` runs from the vertex of corner `c` to the vertex of the next corner of its face. Two half-edges
//! that run opposite ways between the same two vertices are *twins*: there the surface continues from one face to
//! the other. Every half-edge has a [`Link`] that says what it meets.

use super::edge_matching::EdgeMatcher;
use super::faces::{Faces, FacesRef, next_in_triangle, previous_in_triangle};
use super::link::{Link, PackedLink};
use super::rings::{Rings, Scatter};
use crate::num::parallel;
use rayon::prelude::*;

/// Edges and fans of a mesh, made from its faces; positions matter only for welding.
///
/// The caller holds it: nothing is cached inside [`Mesh`](super::Mesh). Memory: 8 bytes a corner and 4 a
/// vertex; with polygons 4 more a corner and a face.
#[derive(Clone, Debug)]
pub struct Topology {
    pub(super) links: Scatter,
    rings: Rings,
    /// The face of each corner and where each face starts; empty for plain triangles.
    owners: Vec<u32>,
    starts: Vec<u32>,
    /// Whether a vertex has a welded half-edge; empty if there is none at all.
    pub(super) welded_vertices: Vec<bool>,
    /// Whether a half-edge runs between two vertices at equal positions; empty if none does.
    pub(super) without_length: Vec<bool>,
    pub(super) wide_clusters: usize,
    non_manifold: usize,
    pub(super) ambiguous: usize,
}

impl Topology {
    /// Finds what every half-edge meets by vertex index alone.
    ///
    /// Linear in corners (but for vertices of very high valence, which are sorted), parallel, and the same for
    /// any thread count.
    pub fn by_index(faces: &Faces, vertex_count: usize) -> Self {
        Self::of_view(faces.view(), vertex_count)
    }

    /// As [`by_index`](Self::by_index), for faces of any owner.
    pub(crate) fn of_view(faces: FacesRef, vertex_count: usize) -> Self {
        let (owners, starts) = faces.owners_and_starts();
        let rings = Rings::build(faces.corners(), vertex_count);
        let links = EdgeMatcher::new(faces, &owners).links(&rings);
        let mut topology = Self {
            links,
            rings,
            owners,
            starts,
            welded_vertices: Vec::new(),
            without_length: Vec::new(),
            wide_clusters: 0,
            non_manifold: 0,
            ambiguous: 0,
        };
        let is_crowded = |h| topology.links.get(h) == PackedLink::NON_MANIFOLD.0;
        let crowded = parallel::filter(faces.corners().len(), is_crowded).into_iter();
        let ends = crowded.map(|h| topology.ends(faces.corners(), h));
        let mut crowded: Vec<(u32, u32)> = ends.map(|(a, b)| (a.min(b), a.max(b))).collect();
        crowded.par_sort_unstable();
        crowded.dedup();
        topology.non_manifold = crowded.len();
        topology
    }

    /// What a half-edge meets.
    #[inline]
    pub fn link(&self, half_edge: u32) -> Link {
        PackedLink(self.links.get(half_edge)).unpack()
    }

    /// The half-edge across, where the surface continues ([`Link::Twin`] and [`Link::Welded`]).
    #[inline]
    pub fn across(&self, half_edge: u32) -> Option<u32> {
        PackedLink(self.links.get(half_edge)).across()
    }

    /// The face of a corner.
    #[inline]
    pub fn face_of(&self, corner: u32) -> u32 {
        if self.owners.is_empty() { corner / 3 } else { self.owners[corner as usize] }
    }

    /// The next corner of the same face.
    #[inline]
    pub fn next(&self, corner: u32) -> u32 {
        if self.owners.is_empty() {
            return next_in_triangle(corner);
        }
        let face = self.owners[corner as usize] as usize;
        if corner + 1 == self.starts[face + 1] { self.starts[face] } else { corner + 1 }
    }

    /// The previous corner of the same face.
    #[inline]
    pub fn previous(&self, corner: u32) -> u32 {
        if self.owners.is_empty() {
            return previous_in_triangle(corner);
        }
        let face = self.owners[corner as usize] as usize;
        if corner == self.starts[face] { self.starts[face + 1] - 1 } else { corner - 1 }
    }

    /// The two vertices of a half-edge, given the vertex of every corner.
    #[inline]
    pub fn ends(&self, corner_vertices: &[u32], half_edge: u32) -> (u32, u32) {
        (corner_vertices[half_edge as usize], corner_vertices[self.next(half_edge) as usize])
    }

    /// Whether the face of a corner has no edge at all: fewer than three distinct vertices or positions.
    pub(crate) fn is_collapsed(&self, corner: u32) -> bool {
        let next = |&at: &u32| Some(self.next(at)).filter(|&next| next != corner);
        std::iter::successors(Some(corner), next).all(|half_edge| self.is_no_edge(half_edge))
    }

    /// Whether the two ends of a half-edge are different vertices at equal positions that welding takes for one.
    #[inline]
    pub(crate) fn has_no_length(&self, half_edge: u32) -> bool {
        !self.without_length.is_empty() && self.without_length[half_edge as usize]
    }

    /// Whether fans continue at the other end of a half-edge, within its face.
    #[inline]
    pub(crate) fn is_no_edge(&self, half_edge: u32) -> bool {
        self.has_no_length(half_edge) || self.link(half_edge) == Link::Collapsed
    }

    /// The corners at a vertex, ascending.
    pub fn corners_at(&self, vertex: u32) -> &[u32] {
        self.rings.at(vertex as usize)
    }

    /// Whether an edge at this vertex is joined to one of another vertex, or has no length: its fan continues there.
    #[inline]
    pub fn is_welded(&self, vertex: u32) -> bool {
        !self.welded_vertices.is_empty() && self.welded_vertices[vertex as usize]
    }

    /// Whether any two edges are joined by welding.
    pub fn has_welds(&self) -> bool {
        !self.welded_vertices.is_empty()
    }

    /// How many edges have more than two faces, by vertex index.
    pub fn non_manifold_edges(&self) -> usize {
        self.non_manifold
    }

    /// How many groups of several coincident boundary edges were not joined because they are ambiguous.
    pub fn ambiguous_edges(&self) -> usize {
        self.ambiguous
    }

    /// Clusters of positions that chains of short distances made wider than twice the welding distance.
    pub fn wide_clusters(&self) -> usize {
        self.wide_clusters
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Columns, MeshBuilder};
    use crate::mesh::{Mesh, Weld};
    use glam::DVec3;

    fn mesh(positions: &[[f64; 3]], faces: &[&[u32]]) -> Mesh {
        let mut list = Faces::new();
        faces.iter().for_each(|face| list.push(face));
        let positions = positions.iter().map(|&p| DVec3::from(p)).collect();
        MeshBuilder { positions, faces: list, ..MeshBuilder::default() }.build().unwrap()
    }

    /// Every relation must be seen alike from both sides.
    fn check_symmetry(topology: &Topology, corners: usize) {
        for h in 0..corners as u32 {
            match topology.link(h) {
                Link::Twin(t) => assert_eq!(topology.link(t), Link::Twin(h)),
                Link::Welded(t) => assert_eq!(topology.link(t), Link::Welded(h)),
                Link::Inconsistent(t) => assert_eq!(topology.link(t), Link::Inconsistent(h)),
                _ => {}
            }
        }
    }

    const SQUARE: [[f64; 3]; 4] = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]];

    #[test]
    fn two_triangles_share_an_edge() {
        let topology = Topology::by_index(mesh(&SQUARE, &[&[0, 1, 2], &[0, 2, 3]]).faces(), 4);
        assert_eq!(topology.link(2), Link::Twin(3));
        assert_eq!(topology.link(3), Link::Twin(2));
        assert_eq!(topology.link(0), Link::Boundary);
        assert_eq!(topology.corners_at(2), [2, 4]);
    }

    #[test]
    fn same_way_is_inconsistent_and_three_faces_are_non_manifold() {
        let topology = Topology::by_index(mesh(&SQUARE, &[&[0, 1, 2], &[2, 0, 3]]).faces(), 4);
        assert_eq!(topology.link(2), Link::Inconsistent(3));
        let topology = Topology::by_index(mesh(&SQUARE, &[&[0, 1, 2], &[1, 0, 3], &[1, 0, 2]]).faces(), 4);
        assert_eq!(topology.link(0), Link::NonManifold);
        assert_eq!(topology.link(3), Link::NonManifold);
        check_symmetry(&topology, 9);
    }

    #[test]
    fn a_collapsed_triangle_does_not_stand_between_its_neighbours() {
        let topology = Topology::by_index(mesh(&SQUARE, &[&[0, 1, 2], &[0, 2, 2], &[0, 2, 3]]).faces(), 4);
        assert_eq!(topology.link(2), Link::Twin(6));
        assert_eq!([3, 4, 5].map(|h| topology.link(h)), [Link::Collapsed; 3]);
        let topology = Topology::by_index(mesh(&SQUARE, &[&[0, 1, 2], &[0, 2, 2, 3]]).faces(), 4);
        assert_eq!(topology.link(2), Link::Twin(3));
        assert_eq!(topology.link(4), Link::Collapsed);
    }

    /// A fan long enough to leave the small matcher must match like short ones.
    #[test]
    fn long_fans_match_like_short_ones() {
        for valence in [3u32, 7, 8, 9, 15, 16, 17, 40] {
            let positions: Vec<[f64; 3]> = (0..=valence).map(|i| [f64::from(i), 1.0, 0.0]).collect();
            let faces: Vec<[u32; 3]> = (0..valence).map(|i| [0, 1 + i, 1 + (i + 1) % valence]).collect();
            let faces: Vec<&[u32]> = faces.iter().map(|f| f.as_slice()).collect();
            let topology = Topology::by_index(mesh(&positions, &faces).faces(), valence as usize + 1);
            for face in 0..valence {
                assert_eq!(topology.link(3 * face + 2), Link::Twin(3 * ((face + 1) % valence)), "{valence}");
                assert_eq!(topology.link(3 * face + 1), Link::Boundary);
            }
            check_symmetry(&topology, 3 * valence as usize);
        }
    }

    const SOUP: [[f64; 3]; 6] =
        [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [-0., 0., 0.], [1., 1., 0.], [0., 1., 0.]];

    #[test]
    fn coincident_boundary_edges_are_joined() {
        let soup = mesh(&SOUP, &[&[0, 1, 2], &[3, 4, 5]]);
        let topology = Topology::build(&soup, Weld::Exact);
        assert_eq!(topology.link(2), Link::Welded(3));
        assert_eq!([0, 1, 2, 3, 4, 5].map(|v| topology.is_welded(v)), [true, false, true, true, true, false]);
        assert_eq!(Topology::build(&soup, Weld::Off).link(2), Link::Boundary);
        let turned = Topology::build(&mesh(&SOUP, &[&[0, 1, 2], &[4, 3, 5]]), Weld::Exact);
        assert_eq!(turned.link(2), Link::Inconsistent(3));
    }

    #[test]
    fn a_flat_triangle_hands_an_edge_on_and_stands_in_no_way() {
        let seam = [[0., 0., 0.], [0., 1., 0.]];
        let positions = [&[[-1., 0., 0.]][..], &seam, &seam, &[[1., 0., 0.]], &seam[..1], &seam].concat();
        // It shares an edge with the left side by index: its other edge continues to the right side's.
        let handing: [&[u32]; 3] = [&[0, 1, 2], &[2, 1, 6], &[5, 4, 3]];
        let topology = Topology::build(&mesh(&positions, &handing), Weld::Exact);
        assert_eq!((topology.link(1), topology.link(5)), (Link::Twin(3), Link::Welded(7)));
        assert_eq!((topology.link(4), topology.has_no_length(4)), (Link::Boundary, true));
        // On its own, it is ignored, and the two sides meet.
        let alone: [&[u32]; 3] = [&[0, 1, 2], &[7, 8, 6], &[5, 4, 3]];
        let topology = Topology::build(&mesh(&positions, &alone), Weld::Exact);
        assert_eq!((topology.link(1), topology.link(7)), (Link::Welded(7), Link::Welded(1)));
        assert_eq!([3, 4, 5].map(|h| topology.link(h)), [Link::Boundary; 3]);
    }

    #[test]
    fn sheets_back_to_back_stay_separate() {
        let positions: Vec<[f64; 3]> = [SOUP, SOUP].concat();
        let faces: [&[u32]; 4] = [&[0, 1, 2], &[3, 4, 5], &[7, 6, 8], &[10, 9, 11]];
        let topology = Topology::build(&mesh(&positions, &faces), Weld::Exact);
        assert_eq!(topology.link(2), Link::Ambiguous);
        assert_eq!(topology.link(0), Link::Welded(6), "the outer rims have one partner each");
    }

    #[test]
    fn near_positions_join_within_a_fraction_of_the_diagonal() {
        let mut soup = SOUP;
        soup[4] = [1.0, 1.0 + 1e-7, 0.0];
        let soup = mesh(&soup, &[&[0, 1, 2], &[3, 4, 5]]);
        assert_eq!(Topology::build(&soup, Weld::Exact).link(2), Link::Boundary);
        assert_eq!(Topology::build(&soup, Weld::Relative(1e-6)).link(2), Link::Welded(3));
        assert_eq!(Topology::build(&soup, Weld::Relative(1e-8)).link(2), Link::Boundary);
    }

    /// A chain of short steps makes one class of any width; the report says so.
    #[test]
    fn wide_clusters_are_counted() {
        let positions: Vec<[f64; 3]> = (0..12)
            .map(|i| [if i < 9 { 1e-3 * f64::from(i) } else { 1.0 }, f64::from(i / 9 * i), 0.0])
            .collect();
        let faces: Vec<[u32; 3]> = (0..9).map(|i| [i, 9 + i % 3, 9 + (i + 1) % 3]).collect();
        let faces: Vec<&[u32]> = faces.iter().map(|f| f.as_slice()).collect();
        let chain = mesh(&positions, &faces);
        let diagonal = {
            let (low, high) = chain.bounds().unwrap();
            (high - low).length()
        };
        assert_eq!(Topology::build(&chain, Weld::Relative(1.1e-3 / diagonal)).wide_clusters(), 1);
        assert_eq!(Topology::build(&chain, Weld::Relative(0.9e-3 / diagonal)).wide_clusters(), 0);
    }

    #[test]
    fn a_morph_target_keeps_coincident_edges_separate() {
        let soup = mesh(&SOUP, &[&[0, 1, 2], &[3, 4, 5]]);
        let moved = |by: f64| {
            MeshBuilder {
                positions: soup.positions().to_vec().into(),
                faces: soup.faces().clone(),
                columns: Columns {
                    morph_targets: vec![vec![
                        DVec3::ZERO,
                        DVec3::ZERO,
                        DVec3::ZERO,
                        DVec3::splat(by),
                        DVec3::ZERO,
                        DVec3::ZERO,
                    ]],
                    ..Columns::default()
                },
            }
            .build()
            .unwrap()
        };
        assert_eq!(Topology::build(&moved(0.0), Weld::Exact).link(2), Link::Welded(3));
        assert_eq!(Topology::build(&moved(0.5), Weld::Exact).link(2), Link::Boundary);
        assert_eq!(Topology::build(&moved(0.5), Weld::Relative(1e-3)).link(2), Link::Boundary);
    }
}
