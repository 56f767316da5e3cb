//! Walking around a vertex: fans of corners, and where creases cut them.

use crate::mesh::{FacesRef, Topology};
use crate::normals::creases::dihedral_test::CreaseTest;
use crate::normals::creases::hard_edges::Marks;
use crate::normals::faces::face_normals::FaceNormals;
use crate::normals::faces::shape::FaceState;
use crate::normals::recipe::Slivers;
use glam::DVec3;
use std::ops::Range;

/// Corners around a vertex in the order in which their faces follow each other across edges that are not hard
/// for other reasons than their angle.
#[derive(Default)]
pub(crate) struct Sector {
    pub(crate) corners: Vec<u32>,
    /// Whether the last corner's face meets the first one's.
    pub(crate) closed: bool,
}

/// How the corners around a vertex follow each other, across edges that are not hard for other reasons than their angle.
pub(crate) trait Fans {
    /// The corner on the far side of the edge that leaves a corner's vertex.
    fn forward(&self, corner: u32) -> Option<u32>;

    /// The corner on the far side of the edge that arrives at a corner's vertex.
    fn backward(&self, corner: u32) -> Option<u32>;

    /// Whether a corner is in no fan: its face has fewer than three distinct vertices or positions.
    fn is_isolated(&self, corner: u32) -> bool;

    /// The face of a corner.
    fn face_of(&self, corner: u32) -> u32;
}

/// The fans of a mesh whose topology is known.
pub(crate) struct MeshFans<'a> {
    pub(crate) faces: FacesRef<'a>,
    pub(crate) topology: &'a Topology,
    pub(crate) marks: &'a Marks<'a>,
}

impl Fans for MeshFans<'_> {
    #[inline]
    fn forward(&self, corner: u32) -> Option<u32> {
        // A face that repeats a vertex, or has two at one position, continues within itself.
        if self.topology.is_no_edge(corner) {
            return (!self.is_isolated(corner)).then(|| self.topology.next(corner));
        }
        let across = self.topology.across(corner)?;
        let crossing = !self.marks.is_marked(self.topology, corner, across);
        crossing.then(|| self.topology.next(across))
    }

    #[inline]
    fn backward(&self, corner: u32) -> Option<u32> {
        let arriving = self.topology.previous(corner);
        if self.topology.is_no_edge(arriving) {
            return (!self.is_isolated(corner)).then_some(arriving);
        }
        let across = self.topology.across(arriving)?;
        (!self.marks.is_marked(self.topology, arriving, across)).then_some(across)
    }

    fn is_isolated(&self, corner: u32) -> bool {
        self.topology.is_collapsed(corner)
    }

    #[inline]
    fn face_of(&self, corner: u32) -> u32 {
        self.topology.face_of(corner)
    }
}

/// Walks around vertices and finds where creases cut.
pub(crate) struct FanWalker<'a, F> {
    pub(crate) fans: F,
    pub(crate) normals: &'a FaceNormals,
    pub(crate) crease: CreaseTest,
    pub(crate) slivers: Slivers,
}

/// Walks around the vertices of a mesh whose topology is known.
pub(crate) type MeshWalker<'a> = FanWalker<'a, MeshFans<'a>>;

impl<F: Fans> FanWalker<'_, F> {
    /// The whole sector of fan that a corner lies in.
    pub(crate) fn sector(&self, start: u32, sector: &mut Sector) {
        sector.corners.clear();
        sector.corners.push(start);
        let mut corner = start;
        while let Some(next) = self.fans.forward(corner) {
            if next == start {
                sector.closed = true;
                return;
            }
            sector.corners.push(next);
            corner = next;
        }
        sector.closed = false;
        let ahead = sector.corners.len();
        corner = start;
        while let Some(next) = self.fans.backward(corner) {
            sector.corners.push(next);
            corner = next;
        }
        // Backward corners come first, furthest away in front.
        sector.corners[ahead..].reverse();
        sector.corners.rotate_left(ahead);
    }

    /// Whether a face decides about creases, which is whether it adds to sums: the faces above the sliver threshold, or
    /// where slivers count or a sector has none above it, all with a direction.
    fn deciding(&self, sector: &Sector) -> impl Fn(u32) -> bool + '_ {
        let state = |corner: u32| self.normals.state[self.fans.face_of(corner) as usize];
        let slivers_decide =
            self.slivers == Slivers::Keep || !sector.corners.iter().any(|&c| state(c) == FaceState::Counted);
        move |corner| match state(corner) {
            FaceState::Counted => true,
            FaceState::Sliver => slivers_decide,
            _ => false,
        }
    }

    /// The corners of a sector whose faces decide, as positions in it.
    pub(crate) fn deciding_places(&self, sector: &Sector, places: &mut Vec<usize>) {
        let decides = self.deciding(sector);
        places.clear();
        places.extend((0..sector.corners.len()).filter(|&i| decides(sector.corners[i])));
    }

    /// Whether a corner's face is above the sliver threshold.
    #[inline]
    pub(crate) fn is_counted(&self, corner: u32) -> bool {
        self.normals.state[self.fans.face_of(corner) as usize] == FaceState::Counted
    }

    /// The unit normal of a corner's face.
    #[inline]
    pub(crate) fn normal(&self, corner: u32) -> DVec3 {
        self.normals.unit[self.fans.face_of(corner) as usize]
    }

    /// Where creases cut a sector: `cuts[i]` is the edge between its corners `i` and `i + 1`, cyclic if closed.
    ///
    /// Each deciding face is compared with the next one; over the limit, every edge between the
    /// two is hard, so that a sliver in a rounded corner neither makes nor hides a crease.
    pub(crate) fn cuts(&self, sector: &Sector, places: &mut Vec<usize>, cuts: &mut Vec<bool>) {
        let count = sector.corners.len();
        let edges = if sector.closed { count } else { count - 1 };
        cuts.clear();
        cuts.resize(count, false);
        match self.crease {
            CreaseTest::None => {}
            CreaseTest::Every => cuts[..edges].fill(true),
            CreaseTest::Over { limit, .. } => {
                self.for_each_span(sector, places, |span, a, b| {
                    if limit.exceeded(self.normal(a), self.normal(b)) {
                        span.for_each(|edge| cuts[edge % count] = true);
                    }
                });
            }
        }
    }

    /// Visits the edges of a sector, as the corners that they leave, with corners of the faces that decide about them: the
    /// nearest on each side that decide.
    pub(crate) fn for_each_decision(
        &self,
        sector: &Sector,
        places: &mut Vec<usize>,
        mut visit: impl FnMut(u32, u32, u32),
    ) {
        let count = sector.corners.len();
        self.for_each_span(sector, places, |span, a, b| {
            span.for_each(|edge| visit(sector.corners[edge % count], a, b));
        });
    }

    /// Visits the edges, as positions in a sector, between each deciding face and the next, with the corners of the two.
    fn for_each_span(
        &self,
        sector: &Sector,
        places: &mut Vec<usize>,
        mut visit: impl FnMut(Range<usize>, u32, u32),
    ) {
        let count = sector.corners.len();
        self.deciding_places(sector, places);
        let pairs = places.windows(2).map(|pair| (pair[0], pair[1]));
        let around =
            (sector.closed && places.len() > 1).then(|| (places[places.len() - 1], places[0] + count));
        for (from, to) in pairs.chain(around) {
            visit(from..to, sector.corners[from], sector.corners[to % count]);
        }
    }
}

impl MeshWalker<'_> {
    /// Whether the corners at a vertex, `ring`, are one closed fan without any hard edge: the case that most
    /// vertices of most meshes are in, found without collecting anything.
    #[inline]
    pub(crate) fn is_smooth_ring(&self, ring: &[u32]) -> bool {
        let MeshFans { topology, marks, .. } = self.fans;
        let limit = match self.crease {
            CreaseTest::Over { limit, .. } => Some(limit),
            CreaseTest::None => None,
            CreaseTest::Every => return false,
        };
        let Some(&start) = ring.first().filter(|_| marks.is_empty()) else { return false };
        let (mut corner, mut normal) = (start, self.normal(start));
        for step in 1..=ring.len() {
            let Some(across) = topology.across(corner) else { return false };
            corner = topology.next(across);
            if let Some(limit) = limit {
                let face = topology.face_of(corner) as usize;
                let (before, state) = (normal, self.normals.state[face]);
                normal = self.normals.unit[face];
                if state != FaceState::Counted || !limit.surely_within(before, normal) {
                    return false;
                }
            }
            if corner == start {
                return step == ring.len();
            }
        }
        false
    }
}
