//! The neighbours of a smooth group, ring by ring, in an order that numbering does not change.

use crate::mesh::{PositionsRef, Topology, first_positions};
use crate::normals::creases::smooth_groups::SlotCorners;
use crate::normals::fits::nearest::{NearTree, Neighbour, by_coordinates, take_nearest};
use crate::num::parallel;
use crate::num::unit_scale;
use glam::DVec3;
use rustc_hash::FxHashMap;

/// Most neighbours that one fit takes.
pub(crate) const MOST: usize = 64;

/// A group of more corners than this has its ring searched by a tree: each of its neighbours asks for it.
const CROWDED: usize = 128;

/// In rings of fewer neighbours, comparing with all is quicker than sorting.
const SHORT: usize = 24;

/// Groups whose rings are found by one task.
const CHUNK: usize = 4096;

/// The surface that polynomials are fitted to.
#[derive(Clone, Copy)]
pub(crate) struct FitRequest<'a> {
    pub(crate) corner_vertices: &'a [u32],
    pub(crate) topology: &'a Topology,
    pub(crate) positions: PositionsRef<'a>,
    /// The smooth group of each corner.
    pub(crate) corner_group: &'a [u32],
    /// The corners of each smooth group.
    pub(crate) group_corners: &'a SlotCorners,
}

/// How far neighbours are searched.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Extent {
    /// Rings are added to the first two while there are fewer neighbours.
    pub(crate) fewest: usize,
    /// Rings that are added then.
    pub(crate) more_rings: usize,
}

/// What is next to each smooth group: the edge neighbours of its corners in their faces, so no hard edge is crossed. Each
/// position counts once; it has the number of the first vertex there.
pub(crate) struct Rings<'a> {
    positions: PositionsRef<'a>,
    chunks: Vec<RingChunk>,
    /// The rings of crowded groups.
    crowds: FxHashMap<u32, NearTree>,
}

/// The rings of successive groups, in compressed rows.
struct RingChunk {
    centres: Vec<u32>,
    /// Starts of the rows of `places` and `groups`, and the end of the last.
    starts: Vec<[u32; 2]>,
    places: Vec<u32>,
    groups: Vec<u32>,
}

/// Memory reused from group to group.
#[derive(Default)]
pub(crate) struct RingScratch {
    /// The number of the last search that met each place.
    met: Vec<u32>,
    search: u32,
    /// The places that this search met, the group's own first: so many of these.
    known: Vec<u32>,
    known_count: usize,
    frontier: Vec<u32>,
    reached: Vec<u32>,
    from_trees: Vec<DVec3>,
    candidates: Vec<Neighbour>,
}

impl RingScratch {
    /// The groups of the last search: those of inner rings, and those whose ring is the outermost one.
    pub(crate) fn groups(&self) -> [&[u32]; 2] {
        [&self.reached, &self.frontier]
    }

    /// Begins a search.
    fn begin(&mut self) {
        self.known_count = 0;
        self.reached.clear();
        self.search = self.search.wrapping_add(1);
        if self.search == 0 {
            self.met.fill(0);
            self.search = 1;
        }
    }

    /// Adds the places that this search meets for the first time to those that it knows.
    #[inline]
    fn meet(&mut self, places: &[u32]) {
        let mut count = self.known_count;
        let most = count + places.len();
        if self.known.len() < most {
            self.known.resize(2 * most, 0);
        }
        let (known, search) = (&mut self.known[..most], self.search);
        for &place in places {
            // The next one overwrites a place that was known. A branch would often be predicted wrongly.
            known[count] = place;
            let met = &mut self.met[place as usize];
            count += usize::from(*met != search);
            *met = search;
        }
        self.known_count = count;
    }
}

impl<'a> Rings<'a> {
    pub(crate) fn new(request: FitRequest<'a>, groups: usize) -> Self {
        let first = first_positions(request.positions);
        let chunks = parallel::blocks(groups, CHUNK, |range| RingChunk::new(request, &first, range));
        let mut rings = Self { positions: request.positions, chunks, crowds: FxHashMap::default() };
        let crowded = (0..groups as u32).filter(|&group| request.group_corners.row(group).len() > CROWDED);
        let tree = |&group: &u32| {
            let points = rings.places(group).iter().map(|&place| rings.position(place)).collect();
            (group, NearTree::build(points))
        };
        rings.crowds = parallel::map_each(&crowded.collect::<Vec<_>>(), tree).into_iter().collect();
        rings
    }

    /// The position of a place, without negative zeros.
    fn position(&self, place: u32) -> DVec3 {
        self.positions.at(place) + DVec3::ZERO
    }

    fn places(&self, group: u32) -> &[u32] {
        let (chunk, row) = (&self.chunks[group as usize / CHUNK], group as usize % CHUNK);
        &chunk.places[chunk.starts[row][0] as usize..chunk.starts[row + 1][0] as usize]
    }

    /// The groups at the edge neighbours.
    pub(crate) fn groups(&self, group: u32) -> &[u32] {
        let (chunk, row) = (&self.chunks[group as usize / CHUNK], group as usize % CHUNK);
        &chunk.groups[chunk.starts[row][1] as usize..chunk.starts[row + 1][1] as usize]
    }

    /// Groups of so many corners that visiting their rings from each neighbour would take quadratic time.
    pub(crate) fn crowded(&self) -> impl Iterator<Item = u32> {
        self.crowds.keys().copied()
    }

    /// The position of a group with corners: the first by coordinates, should welding have joined vertices that are not quite at
    /// one position.
    pub(crate) fn centre(&self, group: u32) -> DVec3 {
        self.position(self.chunks[group as usize / CHUNK].centres[group as usize % CHUNK])
    }

    /// Memory for searches. Places that no search meets stay untouched, and cost nothing.
    pub(crate) fn scratch(&self) -> RingScratch {
        RingScratch { met: vec![0; self.positions.len()], ..RingScratch::default() }
    }

    /// Appends the neighbours of a group: its two-ring and further rings as far as they are searched and each adds some; at most 64,
    /// the first ring before the second, near before far, then by coordinates.
    pub(crate) fn neighbours(
        &self,
        group: u32,
        extent: Extent,
        scratch: &mut RingScratch,
        into: &mut Vec<DVec3>,
    ) {
        scratch.begin();
        let centre_place = self.chunks[group as usize / CHUNK].centres[group as usize % CHUNK];
        let centre = self.position(centre_place);
        scratch.meet(&[centre_place]);
        scratch.meet(self.places(group));
        scratch.candidates.clear();
        let mut size = 0.0_f64;
        for &place in &scratch.known[1..scratch.known_count] {
            let at = self.position(place);
            size = (at - centre).abs().max_element().max(size);
            scratch.candidates.push(Neighbour { distance: 0.0, at });
        }
        let scale = unit_scale(size);
        for neighbour in &mut scratch.candidates {
            *neighbour = Neighbour::new(neighbour.at, centre, scale);
        }
        let start = into.len();
        take_nearest(&mut scratch.candidates, MOST, into);
        scratch.frontier.clear();
        scratch.frontier.extend_from_slice(self.groups(group));
        let Extent { fewest, more_rings: mut more } = extent;
        let mut is_second = true;
        while into.len() - start < MOST && (is_second || into.len() - start < fewest || more > 0) {
            more -= usize::from(!is_second && into.len() - start >= fewest);
            let known = scratch.known_count;
            scratch.from_trees.clear();
            for next in 0..scratch.frontier.len() {
                let next = scratch.frontier[next];
                // Almost no mesh has any.
                let tree = if self.crowds.is_empty() { None } else { self.crowds.get(&next) };
                if let Some(tree) = tree {
                    // More than can be taken, should some be known.
                    tree.nearest(centre, scale, MOST + known, &mut scratch.from_trees);
                    continue;
                }
                scratch.meet(self.places(next));
            }
            let neighbour = |&place: &u32| Neighbour::new(self.position(place), centre, scale);
            scratch.candidates.clear();
            scratch.candidates.extend(scratch.known[known..scratch.known_count].iter().map(neighbour));
            if !scratch.from_trees.is_empty() {
                let RingScratch { known: places, from_trees, candidates, .. } = scratch;
                let is_known = |at: &DVec3| places[..known].iter().any(|&place| self.position(place) == *at);
                let found = from_trees.iter().filter(|at| !is_known(at));
                candidates.extend(found.map(|&at| Neighbour::new(at, centre, scale)));
                candidates.sort_unstable();
                candidates.dedup();
            }
            let before = into.len();
            take_nearest(&mut scratch.candidates, MOST - (before - start), into);
            is_second = false;
            let goes_on = into.len() - start < fewest || more > 0;
            // A polygon may have a thousand corners at eight positions, and as many groups.
            if goes_on && (into.len() == before || !self.next_frontier(group, scratch)) {
                break;
            }
        }
    }

    /// Replaces the groups of a ring by those next to them that are in no ring yet. Returns whether there are any.
    #[cold]
    fn next_frontier(&self, group: u32, scratch: &mut RingScratch) -> bool {
        let RingScratch { frontier, reached, .. } = scratch;
        reached.extend_from_slice(frontier);
        reached.push(group);
        let next: Vec<u32> = frontier.iter().flat_map(|&group| self.groups(group)).copied().collect();
        *frontier = next;
        for list in [&mut *reached, &mut *frontier] {
            list.sort_unstable();
            list.dedup();
        }
        frontier.retain(|group| reached.binary_search(group).is_err());
        !frontier.is_empty()
    }
}

impl RingChunk {
    fn new(request: FitRequest<'_>, first: &[u32], groups: std::ops::Range<usize>) -> Self {
        let (centres, starts) = (Vec::with_capacity(groups.len()), Vec::with_capacity(groups.len() + 1));
        let mut chunk = Self { centres, starts, places: Vec::new(), groups: Vec::new() };
        chunk.starts.push([0; 2]);
        let place = |corner: u32| first[request.corner_vertices[corner as usize] as usize];
        let position = |place: u32| request.positions.at(place) + DVec3::ZERO;
        let (mut pairs, mut places, mut next_groups) = (Vec::new(), Vec::new(), Vec::new());
        for group in groups {
            let corners = request.group_corners.row(group as u32);
            pairs.clear();
            places.clear();
            next_groups.clear();
            let mut centre = corners.first().map_or(0, |&corner| place(corner));
            for &corner in corners {
                let own = place(corner);
                if own != centre && by_coordinates(&position(own), &position(centre)).is_lt() {
                    centre = own;
                }
                for other in [request.topology.next(corner), request.topology.previous(corner)] {
                    let pair = [place(other), request.corner_group[other as usize]];
                    // Most rings are short; long ones are sorted.
                    if pairs.len() >= SHORT || !pairs.contains(&pair) {
                        pairs.push(pair);
                    }
                }
            }
            for &[place, group] in &pairs {
                let is_short = pairs.len() < SHORT;
                if !is_short || !places.contains(&place) {
                    places.push(place);
                }
                if !is_short || !next_groups.contains(&group) {
                    next_groups.push(group);
                }
            }
            for list in [&mut places, &mut next_groups].into_iter().filter(|list| list.len() >= SHORT) {
                list.sort_unstable();
                list.dedup();
            }
            chunk.centres.push(centre);
            chunk.places.extend_from_slice(&places);
            chunk.groups.extend_from_slice(&next_groups);
            chunk.starts.push([chunk.places.len() as u32, chunk.groups.len() as u32]);
        }
        chunk
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::normals::fits::test_surfaces::{cones, patch, with_rings};

    #[test]
    fn crowded_rings_are_searched_like_others() {
        let mesh = cones(1000);
        let find = |rings: &Rings<'_>| -> Vec<Vec<DVec3>> {
            let mut scratch = rings.scratch();
            let mut find = |group| {
                let mut found = Vec::new();
                rings.neighbours(group, Extent::default(), &mut scratch, &mut found);
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

    #[test]
    fn further_rings_can_be_asked_for() {
        let (mesh, _) = patch(12, |_, _| (0.0, 0.0, 0.0));
        with_rings(&mesh, mesh.faces().corners(), |rings| {
            let mut scratch = rings.scratch();
            let mut find = |more_rings, fewest| {
                let mut found = Vec::new();
                rings.neighbours(6 * 13 + 6, Extent { fewest, more_rings }, &mut scratch, &mut found);
                found
            };
            let two = find(0, 0);
            let three = find(0, two.len() + 1);
            assert!(three.len() > two.len() && three.starts_with(&two));
            assert_eq!(find(1, 0), three);
            assert_eq!(find(1, two.len() + 1), find(2, 0));
            assert_eq!((find(2, 0).starts_with(&three), find(9, 0).len()), (true, MOST));
        });
    }

    /// A polygon that passes the corners of a square a thousand times: as many groups at four positions, which took seconds.
    #[test]
    fn many_groups_at_few_positions_end_the_search() {
        use crate::mesh::{Faces, MeshBuilder};
        let square = [DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.0), DVec3::Y];
        let corners: Vec<u32> = (0..4000).map(|corner| corner % 4).collect();
        let mut faces = Faces::new();
        faces.push(&corners);
        let mesh = MeshBuilder { positions: square.to_vec().into(), faces, ..MeshBuilder::default() }
            .build()
            .unwrap();
        let each = Vec::from_iter(0..4000);
        with_rings(&mesh, &each, |rings| {
            let (mut scratch, mut found) = (rings.scratch(), Vec::new());
            let extent = Extent { fewest: 14, more_rings: 0 };
            rings.neighbours(1, extent, &mut scratch, &mut found);
            assert_eq!(found, [square[0], square[2], square[3]]);
            // Two rings, and one that adds nothing.
            assert!(scratch.reached.len() <= 5, "{}", scratch.reached.len());
        });
    }
}
