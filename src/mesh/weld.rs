//! Joining boundary edges at coincident positions, for smoothing only.
//!
//! Vertices, texture coordinates and all other attributes stay separate; only the faces on the two sides of a seam become
//! neighbours.

use super::box_tree::Bounds;
use super::faces::is_collapsed;
use super::link::{Link, PackedLink};
use super::point_clusters::clusters;
use super::polygon_mesh::Mesh;
use super::topology::Topology;
use super::vertex_merge::place_key;
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

    /// Joins boundary edges whose ends coincide; returns the number of their half-edges.
    fn weld(&mut self, mesh: &Mesh, weld: Weld) -> usize {
        if weld == Weld::Off {
            return 0;
        }
        let faces = mesh.faces();
        let open: Vec<u32> = (0..faces.corner_count() as u32)
            .into_par_iter()
            .filter(|&h| self.links.get(h) == PackedLink::BOUNDARY.0)
            .collect();
        if open.is_empty() {
            return 0;
        }
        let joined = join(mesh, self, &open, weld);
        self.wide_clusters += joined.wide_clusters;
        self.ambiguous += joined.ambiguous;
        for &(half_edge, link) in &joined.links {
            self.links.set(half_edge, PackedLink::new(link).0);
            if let Link::Welded(_) = link {
                self.welded_vertices.resize(mesh.vertex_count(), false);
                let (tail, head) = self.ends(faces.corners(), half_edge);
                self.welded_vertices[tail as usize] = true;
                self.welded_vertices[head as usize] = true;
            }
        }
        joined.links.len()
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
    let classes = exact_classes(&rim, mesh).of_rim;
    // Classes are numbered as they are met.
    (0..).zip(&classes).all(|(number, &class)| class == number)
}

/// The result of welding.
struct Joined {
    /// New links of half-edges that were boundary.
    links: Vec<(u32, Link)>,
    /// Clusters wider than twice the welding distance.
    wide_clusters: usize,
    /// Groups of several coincident edges, none of which was joined.
    ambiguous: usize,
}

/// Pairs the open half-edges whose ends coincide, in the mesh and in each of its morph targets.
fn join(mesh: &Mesh, topology: &Topology, open: &[u32], weld: Weld) -> Joined {
    let faces = mesh.faces();
    let ends = |half_edge: u32| topology.ends(faces.corners(), half_edge);
    let mut rim: Vec<u32> = open.iter().flat_map(|&h| <[u32; 2]>::from(ends(h))).collect();
    rim.par_sort_unstable();
    rim.dedup();
    let Classes { of_rim, wide_clusters } = match weld {
        Weld::Relative(fraction) => near_classes(&rim, mesh, fraction),
        Weld::Exact | Weld::Off => exact_classes(&rim, mesh),
    };
    let class = |vertex: u32| of_rim[rim.binary_search(&vertex).expect("a rim vertex")];

    // (lower class, higher class, whether it runs downwards, half-edge)
    let mut edges: Vec<(u32, u32, bool, u32)> = open
        .par_chunk_by(|&a, &b| topology.face_of(a) == topology.face_of(b))
        .flat_map_iter(|of_face| {
            let classes = |&h: &u32| (h, class(ends(h).0), class(ends(h).1));
            // An edge of no length is not joined.
            let long = of_face.iter().map(classes).filter(|&(_, a, b)| a != b);
            let mut long: Vec<_> = long.map(|(h, a, b)| (a.min(b), a.max(b), a > b, h)).collect();
            let place = |v| rim.binary_search(v).map_or(u32::MAX - v, |i| of_rim[i]);
            if is_collapsed(faces.face(topology.face_of(of_face[0]) as usize).iter().map(place)) {
                keep_surplus(&mut long);
            }
            long
        })
        .collect();
    edges.par_sort_unstable();
    let (mut links, mut ambiguous) = (Vec::new(), 0);
    for edge in edges.chunk_by(|x, y| (x.0, x.1) == (y.0, y.1)) {
        match *edge {
            [_] => {}
            [x, y] if x.2 != y.2 => links.extend([(x.3, Link::Welded(y.3)), (y.3, Link::Welded(x.3))]),
            [x, y] => links.extend([(x.3, Link::Inconsistent(y.3)), (y.3, Link::Inconsistent(x.3))]),
            _ => {
                ambiguous += 1;
                links.extend(edge.iter().map(|x| (x.3, Link::Ambiguous)));
            }
        }
    }
    Joined { links, wide_clusters, ambiguous }
}

/// Of the edges of a face that has only two distinct positions, keeps those of one direction without a partner of the other
/// direction: with both open, such a face would separate its neighbours, which meet there themselves.
fn keep_surplus(edges: &mut Vec<(u32, u32, bool, u32)>) {
    let down = edges.iter().filter(|edge| edge.2).count();
    let up = edges.len() - down;
    let surplus = up.abs_diff(down);
    edges.retain(|edge| edge.2 == (down > up));
    edges.truncate(surplus);
}

/// Which vertices of open edges coincide: a class number for each, in the order of `rim`.
struct Classes {
    of_rim: Vec<u32>,
    wide_clusters: usize,
}

fn exact_classes(rim: &[u32], mesh: &Mesh) -> Classes {
    let mut of_rim = vec![0; rim.len()];
    // Each morph target refines the classes: two vertices stay together only if it moves them alike.
    for shape in shapes(mesh) {
        let mut finer: FxHashMap<(u32, [u64; 3]), u32> = FxHashMap::default();
        for (class, &vertex) in of_rim.iter_mut().zip(rim) {
            let fresh = finer.len() as u32;
            *class = *finer.entry((*class, place_key(shape[vertex as usize]))).or_insert(fresh);
        }
    }
    Classes { of_rim, wide_clusters: 0 }
}

/// The positions, and the displacements of each morph target.
fn shapes(mesh: &Mesh) -> impl Iterator<Item = &[DVec3]> {
    std::iter::once(mesh.positions()).chain(mesh.columns().morph_targets.iter().map(Vec::as_slice))
}

/// Connected components of "closer than ε" in every shape.
fn near_classes(rim: &[u32], mesh: &Mesh, fraction: f64) -> Classes {
    let Bounds { low, high } = Bounds::of(mesh.positions().iter().copied());
    // In units of the largest extent no square leaves the range of a double.
    let unit = (high - low).max_element();
    if unit.is_nan() || unit <= 0.0 || fraction <= 0.0 {
        return exact_classes(rim, mesh);
    }
    let epsilon = fraction * ((high - low) / unit).length();
    let origins = std::iter::once(low).chain(std::iter::repeat(DVec3::ZERO));
    let scaled = |(shape, origin): (&[DVec3], DVec3)| -> Vec<DVec3> {
        rim.iter().map(|&vertex| (shape[vertex as usize] - origin) / unit).collect()
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
