//! Polygons of five corners or more, by constrained Delaunay triangulation.

use glam::{DVec2, DVec3};
use rustc_hash::FxHashMap;
use spade::handles::{DirectedEdgeHandle, FaceHandle, FixedVertexHandle, PossiblyOuterTag};
use spade::{ConstrainedDelaunayTriangulation, LineIntersectionIterator, Point2, Triangulation};

/// Points are found from a hierarchy of samples, so that inserting one costs log n.
type Cdt = ConstrainedDelaunayTriangulation<Point2<f64>, (), (), (), spade::HierarchyHintGenerator<f64>>;
type Edge<'a> = DirectedEdgeHandle<'a, Point2<f64>, (), spade::CdtEdge<()>, ()>;
type Face<'a> = FaceHandle<'a, PossiblyOuterTag, Point2<f64>, (), spade::CdtEdge<()>, ()>;

/// Limit of the work beyond n log n. An edge of the polygon that crosses `c` edges of the Delaunay triangulation of its
/// corners costs `c²`: there are few of these in an authored polygon, but a bundle of thousands of slivers may cost hours.
pub(super) struct Budget(u64);

impl Budget {
    /// The limit of a polygon of so many corners.
    pub(super) fn own(corners: usize) -> Self {
        Self(64 * corners as u64)
    }

    /// The limit of all polygons together that exceed their own: about a second.
    pub(super) fn common() -> Self {
        Self(1 << 25)
    }

    fn spend(&mut self, crossings: usize) -> Result<(), Unfit> {
        let squared = (crossings as u64).saturating_mul(crossings as u64);
        self.0 = self.0.checked_sub(squared).ok_or(Unfit::OverBudget)?;
        Ok(())
    }
}

/// Why a polygon is not triangulated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Unfit {
    /// Its projection has no area, crosses itself, or touches itself with a corner inside an edge.
    Shape,
    /// It exceeds its budget.
    OverBudget,
}

/// The `n - 2` triangles of a polygon whose first point is the origin and whose size is about one.
pub(super) fn cut(points: &[DVec3], budget: &mut Budget) -> Result<Vec<[u32; 3]>, Unfit> {
    let flat = project(points).ok_or(Unfit::Shape)?;
    let (mut triangles, ring) = clip_empty_ears(&flat);
    if ring.len() < 3 {
        return Err(Unfit::Shape);
    }
    triangles.extend(Ring::new(&flat, &ring).triangles(budget)?);
    if triangles.len() == points.len() - 2 { Ok(triangles) } else { Err(Unfit::Shape) }
}

/// Coordinates in the polygon's plane, in which it is counter-clockwise.
fn project(points: &[DVec3]) -> Option<Vec<DVec2>> {
    let normal: DVec3 = points[1..].windows(2).map(|pair| pair[0].cross(pair[1])).sum();
    let normal = normal.try_normalize()?;
    // For a polygon in a coordinate plane the basis is exactly two of the axes, and projecting exact.
    let axis = DVec3::AXES[(normal.abs().max_position() + 1) % 3];
    let u = (axis - normal * normal.dot(axis)).try_normalize()?;
    let v = normal.cross(u);
    let flatten = |p: &DVec3| {
        let point = spade::mitigate_underflow(Point2::new(p.dot(u), p.dot(v)));
        // −0 and 0 are equal.
        DVec2::new(point.x + 0.0, point.y + 0.0)
    };
    Some(points.iter().map(flatten).collect())
}

/// Cuts off the corners that coincide with the next one and those whose two neighbours coincide, as triangles without
/// area. Returns these and the remaining corners.
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
    /// The position in the ring from which a directed edge between distinct points starts.
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
        let mut ring = Self { corners, point_of, points, edges: FxHashMap::default() };
        ring.shuffle();
        ring
    }

    /// Numbers the points in the order of their insertion: a large triangle first, then at random. Then no arrangement of
    /// corners (all but one on a line, on a circle, on a parabola) costs more than n log n.
    fn shuffle(&mut self) {
        let count = self.points.len();
        let mut order = random_order(count);
        let from_first = |k: u32| {
            (self.points[k as usize].x - self.points[0].x, self.points[k as usize].y - self.points[0].y)
        };
        let furthest = |distance: &dyn Fn(u32) -> f64| {
            (0..count as u32).max_by(|&a, &b| distance(a).total_cmp(&distance(b)))
        };
        let far = furthest(&|k| from_first(k).0.abs() + from_first(k).1.abs()).unwrap_or(0);
        let (x, y) = from_first(far);
        let apex = furthest(&|k| (x * from_first(k).1 - y * from_first(k).0).abs()).unwrap_or(0);
        for (front, number) in [0, far, apex].into_iter().enumerate().take(count) {
            if let Some(at) = order[front..].iter().position(|&k| k == number) {
                order.swap(front, front + at);
            }
        }
        let mut rank = vec![0; count];
        for (place, &number) in order.iter().enumerate() {
            rank[number as usize] = place as u32;
        }
        self.points = order.iter().map(|&k| self.points[k as usize]).collect();
        self.point_of.iter_mut().for_each(|k| *k = rank[*k as usize]);
    }

    fn triangles(mut self, budget: &mut Budget) -> Result<Vec<[u32; 3]>, Unfit> {
        let count = self.corners.len();
        for place in 0..count {
            let edge = (self.point_of[place], self.point_of[(place + 1) % count]);
            // An edge that occurs twice in one direction bounds a region that is covered twice.
            if self.edges.insert(edge, place as u32).is_some() {
                return Err(Unfit::Shape);
            }
        }
        let cdt = self.triangulation(budget)?;
        self.inside(&cdt).and_then(|inside| self.label(&cdt, &inside)).ok_or(Unfit::Shape)
    }

    /// The triangulation, vertex `k` of which is point `k`; none if edges of the polygon cross.
    fn triangulation(&self, budget: &mut Budget) -> Result<Cdt, Unfit> {
        let mut cdt = Cdt::new();
        for (number, &point) in self.points.iter().enumerate() {
            if cdt.insert(point).map_err(|_| Unfit::Shape)?.index() != number {
                return Err(Unfit::Shape);
            }
        }
        let count = self.corners.len();
        // Also at random, because an edge that divides a bundle of edges shortens the others.
        for place in random_order(count) {
            let place = place as usize;
            let [from, to] = [self.point_of[place], self.point_of[(place + 1) % count]]
                .map(|point| FixedVertexHandle::from_index(point as usize));
            if cdt.exists_constraint(from, to) {
                continue;
            }
            budget.spend(LineIntersectionIterator::new_from_handles(&cdt, from, to).count())?;
            if cdt.try_add_constraint(from, to).is_empty() {
                return Err(Unfit::Shape);
            }
        }
        Ok(cdt)
    }

    fn place(&self, edge: Edge<'_>) -> Option<u32> {
        self.edges.get(&(edge.from().index() as u32, edge.to().index() as u32)).copied()
    }

    /// Which faces have winding number 1; `None` if a face has another one except 0, or if one of the polygon's edges is
    /// not an edge of the triangulation (it runs through another corner).
    ///
    /// The winding number, unlike the parity of crossings, distinguishes a hole from a loop that overlaps.
    fn inside(&self, cdt: &Cdt) -> Option<Vec<bool>> {
        if cdt.directed_edges().filter(|&edge| self.place(edge).is_some()).count() != self.corners.len() {
            return None;
        }
        let outer = |edge: Edge<'_>| edge.face().is_outer();
        let mut sides: Vec<Vec<Edge<'_>>> =
            vec![cdt.convex_hull().map(|edge| if outer(edge) { edge } else { edge.rev() }).collect()];
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

    /// The triangles inside, as corners. If several corners coincide, each owns the sector from the edge that leaves it
    /// around to the edge that arrives.
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

/// The numbers below `count`, shuffled, always the same way.
fn random_order(count: usize) -> Vec<u32> {
    let mut order: Vec<u32> = (0..count as u32).collect();
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    for k in (1..count).rev() {
        // Knuth's MMIX generator; only its high bits are random enough.
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        order.swap(k, (state >> 33) as usize % (k + 1));
    }
    order
}
