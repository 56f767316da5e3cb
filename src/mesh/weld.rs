//! Joining boundary edges at coincident positions, for smoothing only.
//!
//! Vertices, texture coordinates and all other attributes stay separate; only the faces on the two sides of a seam become
//! neighbours.

use super::box_tree::Bounds;
use super::columns::NONE;
use super::faces::is_collapsed;
use super::link::{Link, PackedLink};
use super::point_clusters::clusters;
use super::polygon_mesh::Mesh;
use super::positions::PositionsRef;
use super::rings::Rings;
use super::topology::Topology;
use super::vertices::merge::first_at_place;
use crate::num::parallel;
use glam::DVec3;
use rayon::prelude::*;
use rustc_hash::FxHashMap;

/// Which coincident edges are joined for smoothing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Weld {
    /// Those whose ends have the same coordinates to the bit, with −0 = +0.
    #[default]
    Exact,
    /// None.
    Off,
    /// Those whose ends are closer than this fraction of the bounding box's diagonal, chains included.
    Relative(f64),
}

impl Topology {
    /// Finds what every half-edge meets. `weld` joins coincident boundary edges for smoothing; two positions
    /// coincide only if they do so in every morph target as well.
    ///
    /// Cost as of [`by_index`](Self::by_index).
    pub fn build(mesh: &Mesh, weld: Weld) -> Self {
        let mut topology = Self::by_index(mesh.faces(), mesh.vertex_count());
        if weld != Weld::Off {
            topology.find_edges_without_length(mesh);
        }
        topology.weld(mesh, weld);
        topology
    }

    /// As [`build`](Self::build) with edges at equal positions joined, and then those that this leaves open and whose ends
    /// are closer than a fraction of the diagonal; also returns the number of the latter half-edges.
    pub(crate) fn build_near(mesh: &Mesh, fraction: f64) -> (Self, usize) {
        let mut topology = Self::build(mesh, Weld::Exact);
        let near = if fraction > 0.0 { topology.weld(mesh, Weld::Relative(fraction)) } else { 0 };
        (topology, near)
    }

    /// Marks the edges whose two ends are different vertices at equal positions: fans of the two continue into each other. So the
    /// pole of a sphere whose first row is many vertices at one position has one fan.
    fn find_edges_without_length(&mut self, mesh: &Mesh) {
        let (corners, positions) = (mesh.faces().corners(), mesh.positions());
        let targets = &mesh.columns().morph_targets;
        let has_no_length = |half_edge: u32| {
            let (tail, head) = self.ends(corners, half_edge);
            let stays = |target: &Vec<DVec3>| target[tail as usize] == target[head as usize];
            tail != head && positions.at(tail) == positions.at(head) && targets.iter().all(stays)
        };
        for half_edge in parallel::filter(corners.len(), has_no_length) {
            self.without_length.resize(corners.len(), false);
            self.without_length[half_edge as usize] = true;
            self.mark_welded(mesh, half_edge);
        }
    }

    fn mark_welded(&mut self, mesh: &Mesh, half_edge: u32) {
        self.welded_vertices.resize(mesh.vertex_count(), false);
        let (tail, head) = self.ends(mesh.faces().corners(), half_edge);
        self.welded_vertices[tail as usize] = true;
        self.welded_vertices[head as usize] = true;
    }

    /// Joins boundary edges whose ends coincide; returns the number of their half-edges.
    fn weld(&mut self, mesh: &Mesh, weld: Weld) -> usize {
        if weld == Weld::Off {
            return 0;
        }
        let corners = mesh.faces().corners();
        let open = parallel::filter(corners.len(), |h| self.links.get(h) == PackedLink::BOUNDARY.0);
        if open.is_empty() {
            return 0;
        }
        let found = join(mesh, self, &open, weld);
        self.wide_clusters += found.wide_clusters;
        self.ambiguous += found.ambiguous;
        let mut joined = 0;
        for &half_edge in &open {
            let link = self.link(half_edge);
            joined += usize::from(link != Link::Boundary);
            if let Link::Welded(_) = link {
                self.mark_welded(mesh, half_edge);
            }
        }
        joined
    }
}

/// Whether joining boundary edges with these ends at equal positions would change nothing.
pub(crate) fn joins_no_edges(mesh: &Mesh, ends: &[[u32; 2]]) -> bool {
    // A mesh of separate triangles.
    if ends.len() == mesh.faces().corner_count() && ends.len() > 3 {
        return false;
    }
    let mut rim = ends.as_flattened().to_vec();
    rim.sort_unstable();
    rim.dedup();
    let first = exact_classes(&rim, mesh).of_rim;
    (0..).zip(&first).all(|(number, &first)| first == number)
}

/// What welding found.
struct Joined {
    /// Clusters wider than twice the welding distance.
    wide_clusters: usize,
    /// Groups of several coincident edges, none of which was joined.
    ambiguous: usize,
}

/// Links the open half-edges whose ends coincide, in the mesh and in each of its morph targets.
fn join(mesh: &Mesh, topology: &Topology, open: &[u32], weld: Weld) -> Joined {
    let faces = mesh.faces();
    let ends = |half_edge: u32| <[u32; 2]>::from(topology.ends(faces.corners(), half_edge));
    let mut class = vec![NONE; mesh.vertex_count()];
    open.iter().flat_map(|&half_edge| ends(half_edge)).for_each(|vertex| class[vertex as usize] = 0);
    let rim: Vec<u32> = (0..class.len() as u32).filter(|&vertex| class[vertex as usize] == 0).collect();
    let Classes { of_rim, wide_clusters } = match weld {
        Weld::Relative(fraction) => near_classes(&rim, mesh, fraction),
        Weld::Exact | Weld::Off => exact_classes(&rim, mesh),
    };
    rim.iter().zip(&of_rim).for_each(|(&vertex, &of_vertex)| class[vertex as usize] = of_vertex);
    drop(of_rim);

    let classes = |half_edge: u32| ends(half_edge).map(|vertex| class[vertex as usize]);
    let long = open.par_chunk_by(|&a, &b| topology.face_of(a) == topology.face_of(b)).fold(
        Vec::new,
        |mut long, of_face| {
            let start = long.len();
            // An edge of no length is not joined.
            long.extend(of_face.iter().filter(|&&half_edge| {
                let [tail, head] = classes(half_edge);
                tail != head
            }));
            let place = |&vertex: &u32| match class[vertex as usize] {
                NONE => Err(vertex),
                class => Ok(class),
            };
            if is_collapsed(faces.face(topology.face_of(of_face[0]) as usize).iter().map(place)) {
                let edges = long.split_off(start);
                long.extend(surplus(&edges, |half_edge| classes(half_edge).is_sorted()));
            }
            long
        },
    );
    let long = long.reduce(Vec::new, |mut all, mut part| {
        all.append(&mut part);
        all
    });

    let lower = parallel::map_each(&long, |&h| classes(h)[0].min(classes(h)[1]));
    let rows = Rings::build(&lower, rim.len());
    drop(lower);
    let set = |half_edge: u32, link: Link| topology.links.set(half_edge, PackedLink::new(link).0);
    let at_class = |row: &mut Vec<(u32, bool, u32)>, class: usize| {
        row.clear();
        row.extend(rows.at(class).iter().map(|&at| {
            let half_edge = long[at as usize];
            let [tail, head] = classes(half_edge);
            (tail.max(head), tail > head, half_edge)
        }));
        row.sort_unstable();
        let mut ambiguous = 0;
        for edge in row.chunk_by(|x, y| x.0 == y.0) {
            match *edge {
                [_] => {}
                [x, y] => {
                    let link = if x.1 != y.1 { Link::Welded } else { Link::Inconsistent };
                    set(x.2, link(y.2));
                    set(y.2, link(x.2));
                }
                _ => {
                    ambiguous += 1;
                    edge.iter().for_each(|x| set(x.2, Link::Ambiguous));
                }
            }
        }
        ambiguous
    };
    let ambiguous = parallel::ranges(rim.len(), |classes| {
        let mut row = Vec::new();
        classes.map(|class| at_class(&mut row, class)).sum::<usize>()
    });
    Joined { wide_clusters, ambiguous: ambiguous.into_iter().sum() }
}

/// Of the edges of a face that has only two distinct positions, those of one direction without a partner of the other
/// direction: with both open, such a face would separate its neighbours, which meet there themselves.
fn surplus(edges: &[u32], is_up: impl Fn(u32) -> bool) -> impl Iterator<Item = u32> {
    let up = edges.iter().filter(|&&edge| is_up(edge)).count();
    let down = edges.len() - up;
    edges.iter().copied().filter(move |&edge| is_up(edge) == (up >= down)).take(up.abs_diff(down))
}

/// Which vertices of open edges coincide: a class number for each, in the order of `rim`.
struct Classes {
    of_rim: Vec<u32>,
    wide_clusters: usize,
}

fn exact_classes(rim: &[u32], mesh: &Mesh) -> Classes {
    let shapes: Vec<PositionsRef> = shapes(mesh).collect();
    Classes { of_rim: first_at_place(rim.len(), &shapes, |item| rim[item as usize]), wide_clusters: 0 }
}

/// The positions, and the displacements of each morph target.
fn shapes(mesh: &Mesh) -> impl Iterator<Item = PositionsRef<'_>> {
    let targets = mesh.columns().morph_targets.iter().map(|target| PositionsRef::F64(target));
    std::iter::once(mesh.positions()).chain(targets)
}

/// Connected components of "closer than ε" in every shape.
fn near_classes(rim: &[u32], mesh: &Mesh, fraction: f64) -> Classes {
    let Bounds { low, high } = Bounds::of(mesh.positions().iter());
    // In units of the largest extent no square leaves the range of a double.
    let unit = (high - low).max_element();
    if unit.is_nan() || unit <= 0.0 || fraction <= 0.0 {
        return exact_classes(rim, mesh);
    }
    let epsilon = fraction * ((high - low) / unit).length();
    let origins = std::iter::once(low).chain(std::iter::repeat(DVec3::ZERO));
    let scaled = |(shape, origin): (PositionsRef, DVec3)| -> Vec<DVec3> {
        rim.iter().map(|&vertex| (shape.at(vertex) - origin) / unit).collect()
    };
    let all: Vec<Vec<DVec3>> = shapes(mesh).zip(origins).map(scaled).collect();
    let of_rim = clusters(&all, epsilon);
    let mut boxes: FxHashMap<u32, Bounds> = FxHashMap::default();
    for (&class, &p) in of_rim.iter().zip(&all[0]) {
        let bounds = boxes.entry(class).or_insert(Bounds::EMPTY);
        *bounds = bounds.union(Bounds { low: p, high: p });
    }
    let wide_clusters = boxes.values().filter(|it| (it.high - it.low).length() > 2.0 * epsilon).count();
    Classes { of_rim, wide_clusters }
}
