//! Polygons of five corners or more, by constrained Delaunay triangulation.

use glam::{DVec2, DVec3};
use rustc_hash::FxHashMap;
use spade::handles::{DirectedEdgeHandle, FaceHandle, PossiblyOuterTag};
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation};

type Cdt = ConstrainedDelaunayTriangulation<Point2<f64>>;
type Edge<'a> = DirectedEdgeHandle<'a, Point2<f64>, (), spade::CdtEdge<()>, ()>;
type Face<'a> = FaceHandle<'a, PossiblyOuterTag, Point2<f64>, (), spade::CdtEdge<()>, ()>;

/// The `n - 2` triangles of a polygon whose first point is the origin and whose size is about one; `None` if its
/// projection has no area, crosses itself, or touches itself with a corner inside an edge.
pub(super) fn cut(points: &[DVec3]) -> Option<Vec<[u32; 3]>> {
    let flat = project(points)?;
    let (mut triangles, ring) = clip_empty_ears(&flat);
    if ring.len() < 3 {
        return None;
    }
    triangles.extend(Ring::new(&flat, &ring).triangles()?);
    (triangles.len() == points.len() - 2).then_some(triangles)
}

/// Coordinates on the polygon's own plane, on which it runs counter-clockwise.
fn project(points: &[DVec3]) -> Option<Vec<DVec2>> {
    let normal: DVec3 = points[1..].windows(2).map(|pair| pair[0].cross(pair[1])).sum();
    let normal = normal.try_normalize()?;
    // For a polygon in a coordinate plane the basis is exactly two of the axes, and projecting exact.
    let axis = DVec3::AXES[(normal.abs().max_position() + 1) % 3];
    let u = (axis - normal * normal.dot(axis)).try_normalize()?;
    let v = normal.cross(u);
    let flatten = |p: &DVec3| {
        let point = spade::mitigate_underflow(Point2::new(p.dot(u), p.dot(v)));
        // −0 and 0 are one place.
        DVec2::new(point.x + 0.0, point.y + 0.0)
    };
    Some(points.iter().map(flatten).collect())
}

/// Cuts off the corners that coincide with the next one and those whose two neighbours coincide (there and
/// back again), as triangles without area. Returns these and the corners that remain.
fn clip_empty_ears(flat: &[DVec2]) -> (Vec<[u32; 3]>, Vec<u32>) {
    let mut triangles = Vec::new();
    let mut ring: Vec<u32> = Vec::with_capacity(flat.len());
    let same = |a: u32, b: u32| flat[a as usize] == flat[b as usize];
    for corner in 0..flat.len() as u32 {
        ring.push(corner);
        while let [.., a, b, c] = ring[..]
            && (same(a, b) || same(b, c) || same(a, c))
        {
            triangles.push([a, b, c]);
            ring.remove(ring.len() - 2);
        }
    }
    // The same where the end meets the beginning.
    let mut rest = &ring[..];
    while let [a, b, .., y, z] = *rest {
        if same(z, a) || same(y, a) {
            triangles.push([y, z, a]);
            rest = &rest[..rest.len() - 1];
        } else if same(z, b) {
            triangles.push([z, a, b]);
            rest = &rest[1..];
        } else {
            break;
        }
    }
    let ring = rest.to_vec();
    (triangles, ring)
}

/// A polygon without empty ears, and the triangulation of its distinct points.
struct Ring<'a> {
    /// Numbers of the corners.
    corners: &'a [u32],
    /// The distinct point of each.
    point_of: Vec<u32>,
    points: Vec<Point2<f64>>,
    /// Which place of the ring a directed edge between distinct points starts from.
    edges: FxHashMap<(u32, u32), u32>,
}

impl<'a> Ring<'a> {
    fn new(flat: &[DVec2], corners: &'a [u32]) -> Self {
        let mut number = FxHashMap::default();
        let mut points = Vec::with_capacity(corners.len());
        let point_of: Vec<u32> = corners
            .iter()
            .map(|&corner| {
                let DVec2 { x, y } = flat[corner as usize];
                *number.entry((x.to_bits(), y.to_bits())).or_insert_with(|| {
                    points.push(Point2::new(x, y));
                    points.len() as u32 - 1
                })
            })
            .collect();
        Self { corners, point_of, points, edges: FxHashMap::default() }
    }

    fn triangles(mut self) -> Option<Vec<[u32; 3]>> {
        let count = self.corners.len();
        let mut constraints = Vec::with_capacity(count);
        for place in 0..count {
            let edge = (self.point_of[place], self.point_of[(place + 1) % count]);
            // An edge that is run through twice in one direction bounds a region that is covered twice.
            if self.edges.insert(edge, place as u32).is_some() {
                return None;
            }
            constraints.push([edge.0 as usize, edge.1 as usize]);
        }
        let mut conflicts = 0;
        let points = std::mem::take(&mut self.points);
        let cdt = Cdt::try_bulk_load_cdt(points, constraints, |_| conflicts += 1).ok()?;
        if conflicts > 0 {
            return None;
        }
        let inside = self.inside(&cdt)?;
        self.label(&cdt, &inside)
    }

    fn place(&self, edge: Edge<'_>) -> Option<u32> {
        self.edges.get(&(edge.from().index() as u32, edge.to().index() as u32)).copied()
    }

    /// Which faces the polygon winds round once; `None` if there is one that it winds round otherwise, or if one
    /// of its edges is not an edge of the triangulation (it runs through another corner).
    ///
    /// The winding number, unlike the parity of crossings, tells a hole from a loop that overlaps.
    fn inside(&self, cdt: &Cdt) -> Option<Vec<bool>> {
        if cdt.directed_edges().filter(|&edge| self.place(edge).is_some()).count() != self.corners.len() {
            return None;
        }
        let mut sides: Vec<Vec<Edge<'_>>> = Vec::new();
        sides.push(
            cdt.convex_hull().map(|edge| if edge.face().is_outer() { edge } else { edge.rev() }).collect(),
        );
        let mut winding: Vec<Option<i32>> = vec![None; cdt.num_all_faces()];
        winding[cdt.outer_face().index()] = Some(0);
        while let Some(edges) = sides.pop() {
            for edge in edges {
                let here = winding[edge.face().index()]?;
                let neighbour: Face<'_> = edge.rev().face();
                let there = here - i32::from(self.place(edge).is_some())
                    + i32::from(self.place(edge.rev()).is_some());
                match winding[neighbour.index()] {
                    Some(known) if known != there => return None,
                    Some(_) => {}
                    None if there == 0 || there == 1 => {
                        winding[neighbour.index()] = Some(there);
                        sides.push(neighbour.as_inner()?.adjacent_edges().to_vec());
                    }
                    None => return None,
                }
            }
        }
        Some(winding.into_iter().map(|winding| winding == Some(1)).collect())
    }

    /// The triangles inside, as corners. Where several corners are at one point, each owns the sector from the
    /// edge that leaves it round to the edge that comes to it.
    fn label(&self, cdt: &Cdt, inside: &[bool]) -> Option<Vec<[u32; 3]>> {
        const UNKNOWN: u32 = u32::MAX;
        let mut corner_of_edge = vec![UNKNOWN; cdt.num_directed_edges()];
        for start in cdt.directed_edges() {
            let Some(place) = self.place(start) else { continue };
            let mut edge = start;
            while inside[edge.face().index()] && corner_of_edge[edge.index()] == UNKNOWN {
                corner_of_edge[edge.index()] = self.corners[place as usize];
                edge = edge.ccw();
                if self.place(edge).is_some() || self.place(edge.rev()).is_some() {
                    break;
                }
            }
        }
        let mut triangles = Vec::with_capacity(self.corners.len());
        for face in cdt.inner_faces().filter(|face| inside[face.index()]) {
            let triangle = face.adjacent_edges().map(|edge| corner_of_edge[edge.index()]);
            if triangle.contains(&UNKNOWN) {
                return None;
            }
            triangles.push(triangle);
        }
        Some(triangles)
    }
}
