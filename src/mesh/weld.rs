//! Joining boundary edges at coincident positions, for smoothing only.
//!
//! Vertices, texture coordinates and everything else stay apart; only the faces on the two sides of a seam learn
//! of each other.

use super::Faces;
use super::edges::is_collapsed;
use super::near::{self, extent};
use super::topology::Link;
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

/// What welding found.
pub(super) struct Joined {
    /// New links of half-edges that were boundary.
    pub(super) links: Vec<(u32, Link)>,
    /// Clusters wider than twice the welding distance.
    pub(super) wide_clusters: usize,
    /// Places where several coincident edges could be joined, and none was.
    pub(super) ambiguous: usize,
}

/// Pairs the open half-edges whose ends coincide.
pub(super) fn join(
    faces: &Faces,
    owners: &[u32],
    open: &[u32],
    positions: &[DVec3],
    shapes: &[&[DVec3]],
    weld: Weld,
) -> Joined {
    let face_of = |half_edge: u32| match owners {
        [] => half_edge as usize / 3,
        owners => owners[half_edge as usize] as usize,
    };
    let ends = |half_edge: u32| {
        let range = faces.range(face_of(half_edge));
        let next = if half_edge as usize + 1 == range.end { range.start } else { half_edge as usize + 1 };
        (faces.corners()[half_edge as usize], faces.corners()[next])
    };
    let mut rim: Vec<u32> = open.iter().flat_map(|&h| <[u32; 2]>::from(ends(h))).collect();
    rim.par_sort_unstable();
    rim.dedup();
    let Classes { of_rim, wide_clusters } = match weld {
        Weld::Off => return Joined { links: Vec::new(), wide_clusters: 0, ambiguous: 0 },
        Weld::Exact => exact_classes(&rim, positions, shapes),
        Weld::Relative(fraction) => near_classes(&rim, positions, shapes, fraction),
    };
    let class = |vertex: u32| of_rim[rim.binary_search(&vertex).expect("a rim vertex")];

    // (lower class, higher class, whether it runs downwards, half-edge)
    let mut edges: Vec<(u32, u32, bool, u32)> = open
        .par_chunk_by(|&a, &b| face_of(a) == face_of(b))
        .flat_map_iter(|of_face| {
            let classes = |&h: &u32| (h, class(ends(h).0), class(ends(h).1));
            // An edge of no length joins nothing.
            let long = of_face.iter().map(classes).filter(|&(_, a, b)| a != b);
            let mut long: Vec<_> = long.map(|(h, a, b)| (a.min(b), a.max(b), a > b, h)).collect();
            let place = |v| rim.binary_search(v).map_or(u32::MAX - v, |i| of_rim[i]);
            if is_collapsed(faces.face(face_of(of_face[0])).iter().map(place)) {
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

/// Leaves of the edges of a face that has only two places left, all between the two, those that run one way without another
/// that runs the other way: both ways open, such a face would stand between its neighbours, which meet there themselves.
fn keep_surplus(edges: &mut Vec<(u32, u32, bool, u32)>) {
    let down = edges.iter().filter(|edge| edge.2).count();
    let up = edges.len() - down;
    let surplus = up.abs_diff(down);
    edges.retain(|edge| edge.2 == (down > up));
    edges.truncate(surplus);
}

/// Which rim vertices coincide: one class number for each, in the order of the rim.
struct Classes {
    of_rim: Vec<u32>,
    wide_clusters: usize,
}

/// The bits of a position, with −0 taken as +0: alike for the ends that [`Weld::Exact`] joins.
pub(crate) fn place_key(p: DVec3) -> [u64; 3] {
    (p + DVec3::ZERO).to_array().map(f64::to_bits)
}

fn exact_classes(rim: &[u32], positions: &[DVec3], shapes: &[&[DVec3]]) -> Classes {
    let mut first: FxHashMap<[u64; 3], u32> = FxHashMap::default();
    let mut of_rim: Vec<u32> = Vec::with_capacity(rim.len());
    for &vertex in rim {
        let fresh = first.len() as u32;
        of_rim.push(*first.entry(place_key(positions[vertex as usize])).or_insert(fresh));
    }
    // Each morph target refines the classes: two vertices stay together only if it moves them alike.
    for shape in shapes {
        let mut finer: FxHashMap<(u32, [u64; 3]), u32> = FxHashMap::default();
        for (class, &vertex) in of_rim.iter_mut().zip(rim) {
            let fresh = finer.len() as u32;
            *class = *finer.entry((*class, place_key(shape[vertex as usize]))).or_insert(fresh);
        }
    }
    Classes { of_rim, wide_clusters: 0 }
}

/// Connected components of "closer than ε" in every shape.
fn near_classes(rim: &[u32], positions: &[DVec3], shapes: &[&[DVec3]], fraction: f64) -> Classes {
    let (low, high) = extent(positions.iter().copied());
    // Everything is measured in units of the largest extent, so no square can leave the range of a double.
    let unit = (high - low).max_element();
    if unit.is_nan() || unit <= 0.0 || fraction <= 0.0 {
        return exact_classes(rim, positions, shapes);
    }
    let epsilon = fraction * ((high - low) / unit).length();
    let scaled = |shape: &[DVec3], origin: DVec3| -> Vec<DVec3> {
        rim.iter().map(|&vertex| (shape[vertex as usize] - origin) / unit).collect()
    };
    let mut all = vec![scaled(positions, low)];
    all.extend(shapes.iter().map(|shape| scaled(shape, DVec3::ZERO)));
    let of_rim = near::components(&all, epsilon);
    let mut boxes: FxHashMap<u32, (DVec3, DVec3)> = FxHashMap::default();
    for (&class, &p) in of_rim.iter().zip(&all[0]) {
        let span = boxes.entry(class).or_insert((p, p));
        *span = (span.0.min(p), span.1.max(p));
    }
    let wide_clusters = boxes.values().filter(|(low, high)| (*high - *low).length() > 2.0 * epsilon).count();
    Classes { of_rim, wide_clusters }
}
