//! A ray through a tree of triangles.
//!
//! The test of triangles is watertight: no ray slips between two that share an edge (S. Woop, C. Benthin, I. Wald,
//! *Watertight ray/triangle intersection*, JCGT 2(1), 2013). An edge function that is 0 in single precision is computed
//! again in double precision. Boxes are widened by the rounding of their test (T. Ize, *Robust BVH ray traversal*, JCGT 2(2), 2013).

use super::tree::{LEAF, Leaf, Node, Tree, WIDTH};
use crate::num::{Arithmetic, EightLanes, Kernel, Lanes, Scalars, Truth};
use glam::{DVec3, Vec3};

/// 1 + 2γ₃ of single precision, rounded up.
pub(super) const WIDENED: f64 = 1.0 + 4e-7;

/// A ray in single precision, prepared for boxes and triangles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TreeRay {
    pub(super) origin: Vec3,
    pub(super) inverse: [f32; 3],
    /// By axis: whether the high side of a box is nearer.
    pub(super) turned: [bool; 3],
    /// The two axes across and the one along which the direction is longest.
    axes: [usize; 3],
    /// How coordinates are sheared so that the direction becomes the third axis, and scaled to its length.
    shear: [f32; 3],
    /// Hits beyond this distance do not count.
    pub(crate) reach: f32,
}

/// The smallest component of a direction that is divided by.
const THIN: f32 = 1e-30;

impl TreeRay {
    /// A ray with a unit vector as its direction.
    #[inline(always)]
    pub(crate) fn new(origin: DVec3, direction: DVec3, reach: f32) -> Self {
        let d = direction.as_vec3().to_array();
        let inverse = d.map(|x| 1.0 / if x.abs() < THIN { THIN.copysign(x) } else { x });
        let size = d.map(f32::abs);
        let along = match () {
            () if size[0] >= size[1] && size[0] >= size[2] => 0,
            () if size[1] >= size[2] => 1,
            () => 2,
        };
        let (mut first, mut second) = ((along + 1) % 3, (along + 2) % 3);
        if d[along] < 0.0 {
            std::mem::swap(&mut first, &mut second);
        }
        Self {
            origin: origin.as_vec3(),
            inverse,
            turned: d.map(|x| x.is_sign_negative()),
            axes: [first, second, along],
            shear: [d[first] / d[along], d[second] / d[along], 1.0 / d[along]],
            reach,
        }
    }
}

/// A triangle that a ray meets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TriangleHit {
    /// The distance.
    pub(crate) distance: f32,
    pub(crate) id: u32,
    /// Not normalised.
    pub(crate) weights: [f64; 3],
    /// Its corners.
    pub(crate) corners: [Vec3; 3],
}

/// Nodes still to visit, with the distance of their boxes.
pub(crate) type Stack = Vec<(u32, f32)>;

/// Finds the nearest triangle that a ray meets; of two at the same distance that of the lower number.
pub(crate) struct Nearest<'a, F> {
    pub(crate) tree: &'a Tree,
    pub(crate) ray: TreeRay,
    pub(crate) stack: &'a mut Stack,
    /// Any hit serves, not only the nearest.
    pub(crate) any: bool,
    /// Whether a triangle counts.
    pub(crate) counts: F,
}

impl<F: Fn(&TriangleHit) -> bool> Kernel for Nearest<'_, F> {
    type Output = Option<TriangleHit>;

    #[inline(always)]
    fn run<A: Lanes>(self, arch: A) -> Option<TriangleHit> {
        let root = self.tree.nodes.first()?;
        nearest(arch.singles(), (self.tree, root), &self.ray, self.stack, self.any, &self.counts)
    }
}

/// As [`Nearest`]; `first` is the root, or what is left of the tree for this ray.
#[inline(always)]
pub(super) fn nearest<S: EightLanes<Element = f32>>(
    arch: S,
    (tree, first): (&Tree, &Node),
    ray: &TreeRay,
    stack: &mut Stack,
    any: bool,
    counts: &impl Fn(&TriangleHit) -> bool,
) -> Option<TriangleHit> {
    let lanes = LaneRay::new(arch, ray);
    let mut best: Option<TriangleHit> = None;
    let mut reach = ray.reach;
    stack.clear();
    lanes.enter(first, ray, reach, stack);
    while let Some((child, distance)) = stack.pop() {
        // As near as the best counts: of equally near triangles the lower number wins.
        if distance > reach {
            continue;
        }
        if child & LEAF == 0 {
            lanes.enter(&tree.nodes[child as usize], ray, reach, stack);
            continue;
        }
        let leaf = &tree.leaves[(child & !LEAF) as usize];
        lanes.meet(leaf, ray, reach, |hit| {
            let is_nearer = best.is_none_or(|best| (hit.distance, hit.id) < (best.distance, best.id));
            if is_nearer && counts(&hit) {
                reach = hit.distance;
                best = Some(hit);
            }
        });
        if any && best.is_some() {
            return best;
        }
    }
    best
}

/// A ray in every lane.
struct LaneRay<S: Arithmetic> {
    arch: S,
    origin: [Scalars<S>; 3],
    inverse: [Scalars<S>; 3],
    widened: Scalars<S>,
    shear: [Scalars<S>; 3],
    zero: Scalars<S>,
}

impl<S: EightLanes<Element = f32>> LaneRay<S> {
    #[inline(always)]
    fn new(arch: S, ray: &TreeRay) -> Self {
        let each = |x: f32| Scalars::new(arch, arch.load(&[x; WIDTH]));
        Self {
            arch,
            origin: ray.origin.to_array().map(each),
            inverse: ray.inverse.map(each),
            widened: Scalars::splat(arch, WIDENED),
            shear: ray.shear.map(each),
            zero: each(0.0),
        }
    }

    #[inline(always)]
    fn load(&self, row: &[f32; WIDTH]) -> Scalars<S> {
        Scalars::new(self.arch, self.arch.load(row))
    }

    /// Pushes the children whose boxes the ray meets within its reach, the nearest one last.
    #[inline(always)]
    fn enter(&self, node: &Node, ray: &TreeRay, reach: f32, stack: &mut Stack) {
        let sides = |axis: usize| {
            let [low, high] = &node.sides[axis];
            let (near, far) = if ray.turned[axis] { (high, low) } else { (low, high) };
            let along = |side: &[f32; WIDTH]| (self.load(side) - self.origin[axis]) * self.inverse[axis];
            (along(near), along(far))
        };
        let ((near_x, far_x), (near_y, far_y), (near_z, far_z)) = (sides(0), sides(1), sides(2));
        let near = near_x.max(near_y).max(near_z.max(self.zero));
        let far = (far_x.min(far_y).min(far_z) * self.widened).min(self.load(&[reach; WIDTH]));
        let mut met = !far.less(near).lane_bits();
        let distances = self.arch.to_array(near.value);
        let first = stack.len();
        while met != 0 {
            let lane = met.trailing_zeros() as usize;
            met &= met - 1;
            let (child, distance) = (node.children[lane], distances[lane]);
            // Insertion by descending distance: a ray meets few boxes of a node.
            let mut at = stack.len();
            stack.push((child, distance));
            while at > first && stack[at - 1].1 < distance {
                stack[at] = stack[at - 1];
                at -= 1;
            }
            stack[at] = (child, distance);
        }
    }

    /// Corners relative to the origin, sheared so that the ray is the third axis. (Not a closure: it would not be inlined.)
    #[inline(always)]
    fn sheared(
        &self,
        corners: &[[f32; WIDTH]; 3],
        [first, second, along]: [usize; 3],
    ) -> (Scalars<S>, Scalars<S>, Scalars<S>) {
        let z = self.load(&corners[along]) - self.origin[along];
        let x = self.load(&corners[first]) - self.origin[first];
        let y = self.load(&corners[second]) - self.origin[second];
        (x - self.shear[0] * z, y - self.shear[1] * z, z)
    }

    /// Offers the triangles of a leaf that the ray meets.
    #[inline(always)]
    fn meet(&self, leaf: &Leaf, ray: &TreeRay, reach: f32, mut take: impl FnMut(TriangleHit)) {
        let (ax, ay, az) = self.sheared(&leaf.corners[0], ray.axes);
        let (bx, by, bz) = self.sheared(&leaf.corners[1], ray.axes);
        let (cx, cy, cz) = self.sheared(&leaf.corners[2], ray.axes);
        let u = cx * by - cy * bx;
        let v = ax * cy - ay * cx;
        let w = bx * ay - by * ax;
        let bits = |truth: Truth<S>| truth.lane_bits();
        let negative = [u, v, w].map(|x| bits(x.less(self.zero)));
        let positive = [u, v, w].map(|x| bits(self.zero.less(x)));
        let any = |bits: [u8; 3]| bits[0] | bits[1] | bits[2];
        let mut met = any(negative) ^ any(positive);
        let signed = [0, 1, 2].map(|k| negative[k] | positive[k]);
        let mut zero = !(signed[0] & signed[1] & signed[2]);
        if zero == 0 && met == 0 {
            return;
        }
        let determinant = (u + v) + w;
        let distance = ((u * az + v * bz) + w * cz) * self.shear[2] / determinant;
        let beyond = bits(self.load(&[reach; WIDTH]).less(distance));
        met &= bits(self.zero.less(distance)) & !beyond & !zero;
        let rows = [u, v, w, distance].map(|row| self.arch.to_array(row.value));
        while met != 0 {
            let lane = met.trailing_zeros() as usize;
            met &= met - 1;
            take(TriangleHit {
                distance: rows[3][lane],
                id: leaf.ids[lane],
                weights: [rows[0][lane], rows[1][lane], rows[2][lane]].map(f64::from),
                corners: leaf.triangle(lane),
            });
        }
        while zero != 0 {
            let lane = zero.trailing_zeros() as usize;
            zero &= zero - 1;
            let hit = in_double_precision(ray, leaf.triangle(lane), leaf.ids[lane]);
            if let Some(hit) = hit.filter(|hit| hit.distance <= reach) {
                take(hit);
            }
        }
    }
}

/// The test of one triangle with edge functions in double precision: exact products of the same sheared coordinates, so
/// that two triangles with a common edge get opposite signs or zero.
#[cold]
fn in_double_precision(ray: &TreeRay, corners: [Vec3; 3], id: u32) -> Option<TriangleHit> {
    let [first, second, along] = ray.axes;
    let [a, b, c] = corners.map(|corner| {
        let from = corner - ray.origin;
        let z = from[along];
        [from[first] - ray.shear[0] * z, from[second] - ray.shear[1] * z, z].map(f64::from)
    });
    let edge = |p: [f64; 3], q: [f64; 3]| p[0] * q[1] - p[1] * q[0];
    let weights = [edge(c, b), edge(a, c), edge(b, a)];
    if weights.iter().any(|&x| x < 0.0) && weights.iter().any(|&x| x > 0.0) {
        return None;
    }
    let determinant = weights[0] + weights[1] + weights[2];
    let along_ray = weights[0] * a[2] + weights[1] * b[2] + weights[2] * c[2];
    let distance = (along_ray * f64::from(ray.shear[2]) / determinant) as f32;
    // Also NaN of a triangle seen edge-on.
    (distance > 0.0 && distance.is_finite()).then_some(TriangleHit { distance, id, weights, corners })
}

#[cfg(test)]
mod tests {
    use super::super::build::BoxedTriangle;
    use super::*;
    use crate::num::dispatch;
    use crate::num::test_numbers::Numbers;

    /// A closed, bumpy ball about the origin: rows of quads between two poles, cut into triangles.
    fn ball(rows: u32, numbers: &mut Numbers) -> Vec<[Vec3; 3]> {
        let columns = 2 * rows;
        let mut points = Vec::new();
        for row in 0..=rows {
            for column in 0..columns {
                let (phi, theta) = (
                    std::f64::consts::PI * f64::from(row) / f64::from(rows),
                    std::f64::consts::TAU * f64::from(column) / f64::from(columns),
                );
                let ((sin_phi, cos_phi), (sin, cos)) = (libm::sincos(phi), libm::sincos(theta));
                let is_pole = row == 0 || row == rows;
                let radius = if is_pole { 1.0 } else { 0.7 + 0.6 * numbers.unit() };
                let sin_phi = if is_pole { 0.0 } else { sin_phi };
                points.push((DVec3::new(sin_phi * cos, cos_phi, sin_phi * sin) * radius).as_vec3());
            }
        }
        let at = |row: u32, column: u32| points[(row * columns + column % columns) as usize];
        let quads = (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column)));
        quads
            .flat_map(|(row, column)| {
                let [a, b, c, d] = [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(i, j)| at(row + i, column + j));
                [[a, b, c], [a, c, d]]
            })
            .filter(|[a, b, c]| a != b && b != c && c != a)
            .collect()
    }

    fn tree(triangles: &[[Vec3; 3]]) -> Tree {
        let boxed = |(id, &corners): (usize, &[Vec3; 3])| BoxedTriangle::new(id as u32, corners);
        let mut boxes: Vec<BoxedTriangle> = triangles.iter().enumerate().map(boxed).collect();
        Tree::new(&mut boxes, &|id| triangles[id as usize])
    }

    fn cast(tree: &Tree, ray: TreeRay) -> Option<TriangleHit> {
        dispatch(Nearest { tree, ray, stack: &mut Stack::new(), any: false, counts: |_: &TriangleHit| true })
    }

    /// Rays from inside a closed mesh at its vertices and at points of its edges. `CREASE_LONG=1` casts a million.
    #[test]
    fn no_ray_leaves_a_closed_mesh() {
        let is_long = std::env::var_os("CREASE_LONG").is_some_and(|value| value == "1");
        let count = if is_long { 1_000_000 } else { 20_000 };
        let mut numbers = Numbers::new(77);
        let triangles = ball(40, &mut numbers);
        let tree = tree(&triangles);
        let mut in_double = 0;
        for number in 0..count {
            let [a, b, _] = triangles[(numbers.unit() * triangles.len() as f64) as usize];
            let along = if number % 2 == 0 { 0.0 } else { numbers.unit() };
            // Also exactly from the centre, and from there exactly at a pole, where edge functions are 0.
            let target = match number % 50 {
                0 => DVec3::Y,
                25 => DVec3::NEG_Y,
                _ => a.as_dvec3().lerp(b.as_dvec3(), along),
            };
            let origin = match number % 5 {
                0 => DVec3::ZERO,
                _ => DVec3::from_array(std::array::from_fn(|_| 0.4 * numbers.unit() - 0.2)),
            };
            let direction = (target - origin).normalize();
            let ray = TreeRay::new(origin, direction, f32::INFINITY);
            let hit = cast(&tree, ray);
            let hit = hit.unwrap_or_else(|| panic!("ray {number} from {origin} at {target} escapes"));
            assert!(hit.distance < 2.0, "{hit:?}");
            in_double += u32::from(hit.weights.contains(&0.0));
        }
        assert!(in_double >= count / 25, "the rays are too easy: {in_double}");
    }

    /// The tree finds what a test of every triangle finds, at any number of threads.
    #[test]
    fn a_tree_finds_what_all_triangles_have() {
        let mut numbers = Numbers::new(78);
        for count in [0, 1, 7, 9, 100, 40_000] {
            let mut soup: Vec<[Vec3; 3]> = (0..count)
                .map(|_| {
                    let mut point = |size: f64| {
                        DVec3::from_array(std::array::from_fn(|_| size * (numbers.unit() - 0.5))).as_vec3()
                    };
                    let centre = point(2.0);
                    [(); 3].map(|()| centre + point(0.2))
                })
                .collect();
            // Equal ones, of which the first counts, and some without area.
            if count > 9 {
                soup[count / 2] = soup[3];
                soup[5] = [soup[5][0]; 3];
            }
            let [one, three] = [1, 3].map(|threads| {
                let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
                pool.install(|| tree(&soup))
            });
            for _ in 0..if count > 1000 { 40 } else { 400 } {
                let mut point = || DVec3::from_array(std::array::from_fn(|_| 4.0 * (numbers.unit() - 0.5)));
                let (origin, direction) = (point(), point().normalize());
                let ray = TreeRay::new(origin, direction, f32::INFINITY);
                let each = soup.iter().enumerate().filter_map(|(id, &corners)| {
                    let alone = Leaf::new([(id as u32, corners)].into_iter());
                    let tree = Tree { nodes: vec![everything()], leaves: vec![alone] };
                    cast(&tree, ray)
                });
                let nearest =
                    each.min_by(|a, b| (a.distance, a.id).partial_cmp(&(b.distance, b.id)).unwrap());
                assert_eq!(cast(&one, ray), nearest);
                assert_eq!(cast(&three, ray), nearest);
            }
        }
    }

    /// A node whose first child is a leaf that every ray reaches.
    fn everything() -> Node {
        let mut node = Node::EMPTY;
        for sides in &mut node.sides {
            (sides[0][0], sides[1][0]) = (-1e30, 1e30);
        }
        node
    }
}
