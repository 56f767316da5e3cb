//! The neighbours of a smooth group, ring by ring, in an order that numbering does not change.

use crate::mesh::{Topology, first_positions};
use crate::normals::creases::smooth_groups::SlotCorners;
use crate::normals::fits::nearest::{NearTree, Neighbour, by_coordinates};
use crate::num::unit_scale;
use glam::DVec3;
use rayon::prelude::*;
use rustc_hash::FxHashMap;

/// Most neighbours that one fit takes.
pub(crate) const MOST: usize = 64;

/// A group of more corners than this has its ring searched by a tree: each of its neighbours asks for it.
const CROWDED: usize = 128;

/// Groups whose rings are found by one task.
const CHUNK: usize = 4096;

/// The surface that polynomials are fitted to.
#[derive(Clone, Copy)]
pub(crate) struct FitRequest<'a> {
    pub(crate) corner_vertices: &'a [u32],
    pub(crate) topology: &'a Topology,
    pub(crate) positions: &'a [DVec3],
    /// The smooth group of each corner.
    pub(crate) corner_group: &'a [u32],
    /// The corners of each smooth group.
    pub(crate) group_corners: &'a SlotCorners,
}

/// What is next to each smooth group: the edge neighbours of its corners in their faces, so no hard edge is crossed. Each
/// position counts once; it has the number of the first vertex there.
pub(crate) struct Rings<'a> {
    positions: &'a [DVec3],
    chunks: Vec<RingChunk>,
    /// The rings of crowded groups.
    crowds: FxHashMap<u32, NearTree>,
}

/// The rings of successive groups, in compressed rows.
#[derive(Default)]
struct RingChunk {
    centres: Vec<u32>,
    /// Ends of the rows of `places` and `groups`.
    ends: Vec<[u32; 2]>,
    places: Vec<u32>,
    groups: Vec<u32>,
}

/// Memory reused from group to group.
#[derive(Default)]
pub(crate) struct RingScratch {
    /// Positions that are taken or were omitted: those of all rings so far and the group's own. Ascending.
    known: Vec<u32>,
    ring: Vec<u32>,
    frontier: Vec<u32>,
    reached: Vec<u32>,
    from_trees: Vec<DVec3>,
    candidates: Vec<Neighbour>,
}

impl<'a> Rings<'a> {
    pub(crate) fn new(request: FitRequest<'a>, groups: usize) -> Self {
        let first = first_positions(request.positions);
        let chunk = |chunk: usize| {
            let range = chunk * CHUNK..groups.min((chunk + 1) * CHUNK);
            RingChunk::new(request, &first, range)
        };
        let chunks = (0..groups.div_ceil(CHUNK)).into_par_iter().map(chunk).collect();
        let mut rings = Self { positions: request.positions, chunks, crowds: FxHashMap::default() };
        let crowded = (0..groups as u32).filter(|&group| request.group_corners.row(group).len() > CROWDED);
        let tree = |group: u32| {
            let points = rings.places(group).iter().map(|&place| rings.position(place)).collect();
            (group, NearTree::build(points))
        };
        rings.crowds =
            crowded.collect::<Vec<_>>().into_par_iter().map(tree).collect::<Vec<_>>().into_iter().collect();
        rings
    }

    /// The position of a place, without negative zeros.
    fn position(&self, place: u32) -> DVec3 {
        self.positions[place as usize] + DVec3::ZERO
    }

    fn places(&self, group: u32) -> &[u32] {
        let (chunk, row) = (&self.chunks[group as usize / CHUNK], group as usize % CHUNK);
        let start = row.checked_sub(1).map_or(0, |before| chunk.ends[before][0]);
        &chunk.places[start as usize..chunk.ends[row][0] as usize]
    }

    /// The groups at the edge neighbours, ascending.
    pub(crate) fn groups(&self, group: u32) -> &[u32] {
        let (chunk, row) = (&self.chunks[group as usize / CHUNK], group as usize % CHUNK);
        let start = row.checked_sub(1).map_or(0, |before| chunk.ends[before][1]);
        &chunk.groups[start as usize..chunk.ends[row][1] as usize]
    }

    /// The number of edge neighbours.
    pub(crate) fn ring_size(&self, group: u32) -> usize {
        let own = self.chunks[group as usize / CHUNK].centres[group as usize % CHUNK];
        self.places(group).iter().filter(|&&place| place != own).count()
    }

    /// The position of a group with corners: the first by coordinates, should welding have joined vertices that are not quite at
    /// one position.
    pub(crate) fn centre(&self, group: u32) -> DVec3 {
        self.position(self.chunks[group as usize / CHUNK].centres[group as usize % CHUNK])
    }

    /// Appends the neighbours of a group: its two-ring, and further rings while there are fewer than `fewest`; at most 64, the
    /// first ring before the second, near before far, then by coordinates.
    pub(crate) fn neighbours(
        &self,
        group: u32,
        fewest: usize,
        scratch: &mut RingScratch,
        into: &mut Vec<DVec3>,
    ) {
        let RingScratch { known, ring, frontier, reached, from_trees, candidates } = scratch;
        let centre_place = self.chunks[group as usize / CHUNK].centres[group as usize % CHUNK];
        let centre = self.position(centre_place);
        let offset = |place: u32| (self.position(place) - centre).abs().max_element();
        let places = self.places(group);
        let scale = unit_scale(places.iter().fold(0.0, |size, &place| offset(place).max(size)));
        let mut room = MOST;
        let mut take_nearest = |candidates: &mut Vec<Neighbour>| {
            if candidates.len() > room {
                candidates.select_nth_unstable(room);
                candidates.truncate(room);
            }
            candidates.sort_unstable();
            room -= candidates.len();
            into.extend(candidates.iter().map(|neighbour| neighbour.at));
            MOST - room
        };
        let seen = |place: u32| Neighbour::new(self.position(place), centre, scale);
        candidates.clear();
        candidates.extend(places.iter().filter(|&&place| place != centre_place).map(|&place| seen(place)));
        let mut taken = take_nearest(candidates);
        known.clear();
        known.extend_from_slice(places);
        if let Err(at) = known.binary_search(&centre_place) {
            known.insert(at, centre_place);
        }
        frontier.clear();
        frontier.extend_from_slice(self.groups(group));
        reached.clear();
        let mut rings = 1;
        while taken < MOST && (rings == 1 || taken < fewest) && !frontier.is_empty() {
            rings += 1;
            ring.clear();
            from_trees.clear();
            for group in frontier.iter() {
                match self.crowds.get(group) {
                    // More than can be taken, should some be known.
                    Some(tree) => tree.nearest(centre, scale, MOST + known.len(), from_trees),
                    None => ring.extend_from_slice(self.places(*group)),
                }
            }
            ring.sort_unstable();
            ring.dedup();
            ring.retain(|place| known.binary_search(place).is_err());
            candidates.clear();
            candidates.extend(ring.iter().map(|&place| seen(place)));
            if !from_trees.is_empty() {
                let is_known = |at: &DVec3| known.iter().any(|&place| self.position(place) == *at);
                let found = from_trees.iter().filter(|at| !is_known(at));
                candidates.extend(found.map(|&at| Neighbour::new(at, centre, scale)));
                candidates.sort_unstable();
                candidates.dedup();
            }
            taken = take_nearest(candidates);
            if taken < fewest {
                known.extend_from_slice(ring);
                known.sort_unstable();
                reached.extend_from_slice(frontier);
                reached.push(group);
                reached.sort_unstable();
                let next: Vec<u32> = frontier.iter().flat_map(|&group| self.groups(group)).copied().collect();
                *frontier = next;
                frontier.sort_unstable();
                frontier.dedup();
                frontier.retain(|group| reached.binary_search(group).is_err());
            }
        }
    }
}

impl RingChunk {
    fn new(request: FitRequest<'_>, first: &[u32], groups: std::ops::Range<usize>) -> Self {
        let mut chunk = Self::default();
        let place = |corner: u32| first[request.corner_vertices[corner as usize] as usize];
        let position = |place: u32| request.positions[place as usize] + DVec3::ZERO;
        let (mut places, mut next_groups) = (Vec::new(), Vec::new());
        for group in groups {
            let corners = request.group_corners.row(group as u32);
            places.clear();
            next_groups.clear();
            let mut centre = corners.first().map_or(0, |&corner| place(corner));
            for &corner in corners {
                let own = place(corner);
                if own != centre && by_coordinates(&position(own), &position(centre)).is_lt() {
                    centre = own;
                }
                for other in [request.topology.next(corner), request.topology.previous(corner)] {
                    places.push(place(other));
                    next_groups.push(request.corner_group[other as usize]);
                }
            }
            for list in [&mut places, &mut next_groups] {
                list.sort_unstable();
                list.dedup();
            }
            chunk.centres.push(centre);
            chunk.places.extend_from_slice(&places);
            chunk.groups.extend_from_slice(&next_groups);
            chunk.ends.push([chunk.places.len() as u32, chunk.groups.len() as u32]);
        }
        chunk
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::normals::fits::test_surfaces::{cones, with_rings};

    #[test]
    fn crowded_rings_are_searched_like_others() {
        let mesh = cones(1000);
        let find = |rings: &Rings<'_>| -> Vec<Vec<DVec3>> {
            let mut scratch = RingScratch::default();
            let mut find = |group| {
                let mut found = Vec::new();
                rings.neighbours(group, 0, &mut scratch, &mut found);
                found
            };
            (0..1002).map(&mut find).collect()
        };
        with_rings(&mesh, mesh.faces().corners(), |mut rings| {
            assert_eq!(rings.crowds.len(), 2);
            let found = find(&rings);
            assert!(found.iter().all(|found| found.len() == MOST));
            rings.crowds.clear();
            assert_eq!(found, find(&rings));
        });
    }
}
