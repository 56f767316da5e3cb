//! Neighbouring rays that begin deeper in a tree than at its root.
//!
//! Rays of the camera through neighbouring pixels pass the same upper nodes. Boxes that none of them can meet are found for
//! all of them at once, by interval arithmetic (S. Boulos, I. Wald, P. Shirley, *Geometric and arithmetic culling methods for
//! entire ray packets*, University of Utah UUCS-06-10, 2006). What is left becomes the first node of each ray.

use super::traverse::TreeRay;
use super::tree::{LEAF, Node, Tree, WIDTH};
use crate::num::{EightLanes, Scalars};

/// Rays of a bundle: pixels of a picture, two rows of eight.
pub(super) const BUNDLE: usize = 16;

/// The ranges of some rays, by axis. Rounding is monotone, so a bound of the test of boxes, computed with the ends of these
/// ranges, bounds that test for each ray.
struct Bundle {
    origin: [[f32; 2]; 3],
    inverse: [[f32; 2]; 3],
    /// Whether the high side of a box is nearer; `None` if that differs, and the axis says nothing.
    turned: [Option<bool>; 3],
}

impl Bundle {
    /// The ranges of rays; `None` without any.
    fn of<'a>(mut rays: impl Iterator<Item = &'a TreeRay>) -> Option<Self> {
        let first = rays.next()?;
        let both = |x: f32| [x; 2];
        let mut bundle = Self {
            origin: first.origin.to_array().map(both),
            inverse: first.inverse.map(both),
            turned: first.turned.map(Some),
        };
        for ray in rays {
            for axis in 0..3 {
                let widen = |[low, high]: [f32; 2], x: f32| [low.min(x), high.max(x)];
                bundle.origin[axis] = widen(bundle.origin[axis], ray.origin[axis]);
                bundle.inverse[axis] = widen(bundle.inverse[axis], ray.inverse[axis]);
                bundle.turned[axis] = bundle.turned[axis].filter(|&turned| turned == ray.turned[axis]);
            }
        }
        Some(bundle)
    }

    /// Which boxes of a node a ray may meet, a bit for each.
    #[inline(always)]
    fn meets<S: EightLanes<Element = f32>>(&self, arch: S, node: &Node, widened: Scalars<S>) -> u8 {
        let (mut near, mut far) = (splat(arch, 0.0), splat(arch, f32::INFINITY));
        for axis in 0..3 {
            let Some(turned) = self.turned[axis] else { continue };
            let [low, high] = &node.sides[axis];
            let (first, last) = if turned { (high, low) } else { (low, high) };
            let [a, b, c, d] = self.products(arch, axis, first);
            near = near.max(a.min(b).min(c.min(d)));
            let [a, b, c, d] = self.products(arch, axis, last);
            far = far.min(a.max(b).max(c.max(d)));
        }
        !(far * widened).less(near).lane_bits()
    }

    /// Where the ends of the ranges meet a side of each box. (Not a closure: it might not be inlined.)
    #[inline(always)]
    fn products<S: EightLanes<Element = f32>>(
        &self,
        arch: S,
        axis: usize,
        side: &[f32; WIDTH],
    ) -> [Scalars<S>; 4] {
        let side = Scalars::new(arch, arch.load(side));
        let ([low, high], [least, most]) = (self.origin[axis], self.inverse[axis]);
        let (a, b) = (side - splat(arch, low), side - splat(arch, high));
        let (p, q) = (splat(arch, least), splat(arch, most));
        [a * p, a * q, b * p, b * q]
    }
}

/// The same number in every lane.
#[inline(always)]
fn splat<S: EightLanes<Element = f32>>(arch: S, x: f32) -> Scalars<S> {
    Scalars::new(arch, arch.load(&[x; WIDTH]))
}

/// A node whose boxes are all that these rays can meet, from as deep in the tree as there is room for; `None` if they meet nothing.
#[inline(always)]
pub(super) fn first_node<'a, S: EightLanes<Element = f32>>(
    arch: S,
    tree: &Tree,
    rays: impl Iterator<Item = &'a TreeRay>,
    widened: Scalars<S>,
) -> Option<Node> {
    let bundle = Bundle::of(rays)?;
    let mut first = Node::EMPTY;
    let mut count = 0;
    put(&mut first, &mut count, tree.nodes.first()?, bundle.meets(arch, &tree.nodes[0], widened));
    let mut next = 0;
    while next < count {
        let child = first.children[next];
        if child & LEAF != 0 {
            next += 1;
            continue;
        }
        let node = &tree.nodes[child as usize];
        let met = bundle.meets(arch, node, widened);
        if count - 1 + met.count_ones() as usize > WIDTH {
            next += 1;
            continue;
        }
        // The last box takes the place of the one that is opened.
        count -= 1;
        move_box(&mut first, count, next);
        put(&mut first, &mut count, node, met);
    }
    (count > 0).then_some(first)
}

/// Adds some boxes of a node.
#[inline(always)]
fn put(first: &mut Node, count: &mut usize, node: &Node, mut met: u8) {
    while met != 0 {
        let lane = met.trailing_zeros() as usize;
        met &= met - 1;
        for (sides, own) in first.sides.as_flattened_mut().iter_mut().zip(node.sides.as_flattened()) {
            sides[*count] = own[lane];
        }
        first.children[*count] = node.children[lane];
        *count += 1;
    }
}

/// Moves a box to another place and leaves an empty one.
#[inline(always)]
fn move_box(node: &mut Node, from: usize, to: usize) {
    for (sides, empty) in node.sides.as_flattened_mut().iter_mut().zip(Node::EMPTY.sides.as_flattened()) {
        sides[to] = sides[from];
        sides[from] = empty[0];
    }
    node.children[to] = node.children[from];
    node.children[from] = LEAF;
}

#[cfg(test)]
mod tests {
    use super::super::build::BoxedTriangle;
    use super::super::traverse::{Stack, TriangleHit, WIDENED, nearest};
    use super::*;
    use crate::num::test_numbers::Numbers;
    use crate::num::{Kernel, Lanes, dispatch};
    use glam::{DVec3, Vec3};

    /// The first hits of a bundle, from the root and from a node of its own; and whether there is one.
    struct Both<'a>(&'a Tree, &'a [TreeRay]);

    impl Kernel for Both<'_> {
        type Output = (Vec<[Option<TriangleHit>; 2]>, bool);

        #[inline(always)]
        fn run<A: Lanes>(self, arch: A) -> Self::Output {
            let Self(tree, rays) = self;
            let arch = arch.singles();
            let first = first_node(arch, tree, rays.iter(), Scalars::splat(arch, WIDENED));
            let mut stack = Stack::new();
            let mut cast =
                |first: &Node, ray| nearest(arch, (tree, first), ray, &mut stack, false, &|_| true);
            let mut hits =
                |ray| [cast(&tree.nodes[0], ray), first.as_ref().and_then(|first| cast(first, ray))];
            (rays.iter().map(&mut hits).collect(), first.is_some())
        }
    }

    /// Bundles of all widths, also with directions on both sides of an axis.
    #[test]
    fn bundles_hit_what_their_rays_hit() {
        let mut numbers = Numbers::new(79);
        let mut random =
            |size: f64| DVec3::from_array(std::array::from_fn(|_| size * (numbers.unit() - 0.5)));
        let soup: Vec<[Vec3; 3]> = (0..4000)
            .map(|_| {
                let centre = random(2.0);
                [(); 3].map(|()| (centre + random(0.1)).as_vec3())
            })
            .collect();
        let boxed = |(id, &corners): (usize, &[Vec3; 3])| BoxedTriangle::new(id as u32, corners);
        let mut boxes: Vec<BoxedTriangle> = soup.iter().enumerate().map(boxed).collect();
        let tree = Tree::new(&mut boxes, &|id| soup[id as usize]);
        let (mut hit, mut culled) = (0, 0);
        for number in 0..400 {
            let spread = [0.0, 0.002, 0.02, 0.5][number % 4];
            let axis = [DVec3::ZERO, DVec3::X][number / 4 % 2];
            let (origin, target) = (random(6.0) * (DVec3::ONE - axis), random(2.4) * (DVec3::ONE - axis));
            let ray = |_| {
                let origin = origin + random(0.1 * spread);
                TreeRay::new(origin, (target + random(spread) - origin).normalize(), f32::INFINITY)
            };
            let rays: Vec<TreeRay> = (0..BUNDLE).map(ray).collect();
            let (hits, is_met) = dispatch(Both(&tree, &rays));
            assert!(hits.iter().all(|[root, own]| root == own), "bundle {number}");
            hit += hits.iter().filter(|[root, _]| root.is_some()).count();
            culled += usize::from(!is_met);
        }
        // Found: 2637 and 19.
        assert!(hit > 1000 && culled > 10, "{hit} hits, {culled} bundles meet nothing");
    }
}
