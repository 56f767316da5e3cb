//! Builds a tree top down, with the surface area heuristic on bins of centroids (I. Wald, *On fast construction of SAH-based
//! bounding volume hierarchies*, RT 2007).
//!
//! A node opens its box of largest area until it has eight. Large ranges are binned and built in parallel; all sums are
//! minima, maxima and counts, so that the tree is the same at any number of threads.

use super::tree::{LEAF, Leaf, Node, Tree, WIDTH};
use crate::num::parallel;
use glam::{Vec3, Vec4};

/// Bins along each axis.
const BINS: usize = 16;

/// Ranges of at least so many triangles are divided among threads.
const PARALLEL: usize = 1 << 14;

/// Nodes deeper than this are cut in the middle of their lists, so that no input makes a deep tree.
const DEEPEST: usize = 24;

/// A triangle's box, with its number in the bits of the fourth coordinate of `low`.
#[derive(Clone, Copy)]
pub(super) struct BoxedTriangle {
    low: Vec4,
    high: Vec4,
}

impl BoxedTriangle {
    pub(super) fn new(id: u32, corners: [Vec3; 3]) -> Self {
        let [a, b, c] = corners;
        let low = a.min(b).min(c).extend(f32::from_bits(id));
        Self { low, high: a.max(b).max(c).extend(0.0) }
    }

    fn id(&self) -> u32 {
        self.low.w.to_bits()
    }

    /// Twice the centre of the box.
    #[inline(always)]
    fn centre(&self) -> Vec3 {
        self.low.truncate() + self.high.truncate()
    }
}

#[derive(Clone, Copy)]
struct Bounds {
    low: Vec3,
    high: Vec3,
}

impl Bounds {
    const NONE: Self = Self { low: Vec3::INFINITY, high: Vec3::NEG_INFINITY };

    #[inline(always)]
    fn with(self, low: Vec3, high: Vec3) -> Self {
        Self { low: self.low.min(low), high: self.high.max(high) }
    }

    fn union(self, other: Self) -> Self {
        self.with(other.low, other.high)
    }

    /// Half the surface area; 0 for no points.
    fn area(self) -> f32 {
        let size = (self.high - self.low).max(Vec3::ZERO);
        size.x * size.y + size.y * size.z + size.z * size.x
    }
}

/// A range of triangles with the bounds of their boxes and of their centres.
struct Range<'a> {
    triangles: &'a mut [BoxedTriangle],
    bounds: Bounds,
    centres: Bounds,
}

impl<'a> Range<'a> {
    fn new(triangles: &'a mut [BoxedTriangle]) -> Self {
        let each = |part: &[BoxedTriangle]| {
            part.iter().fold((Bounds::NONE, Bounds::NONE), |(bounds, centres), it| {
                let centre = it.centre();
                (bounds.with(it.low.truncate(), it.high.truncate()), centres.with(centre, centre))
            })
        };
        let (bounds, centres) = match triangles.len() >= PARALLEL {
            true => parallel::ranges(triangles.len(), |range| each(&triangles[range]))
                .into_iter()
                .fold((Bounds::NONE, Bounds::NONE), |a, b| (a.0.union(b.0), a.1.union(b.1))),
            false => each(triangles),
        };
        Self { triangles, bounds, centres }
    }
}

#[derive(Clone, Copy)]
struct Bin {
    bounds: Bounds,
    count: u32,
}

/// The bins of all three axes.
type Bins = [[Bin; BINS]; 3];

const NO_BINS: Bins = [[Bin { bounds: Bounds::NONE, count: 0 }; BINS]; 3];

/// How centres are sorted into bins.
#[derive(Clone, Copy)]
struct Binning {
    low: Vec3,
    per_length: Vec3,
}

impl Binning {
    fn new(centres: Bounds) -> Self {
        let size = centres.high - centres.low;
        let per_length = |length: f32| {
            let scale = BINS as f32 * (1.0 - 1e-6) / length;
            if length > 0.0 && scale.is_finite() { scale } else { 0.0 }
        };
        Self {
            low: centres.low,
            per_length: Vec3::new(per_length(size.x), per_length(size.y), per_length(size.z)),
        }
    }

    #[inline(always)]
    fn bins(&self, triangle: &BoxedTriangle) -> [usize; 3] {
        let place = (triangle.centre() - self.low) * self.per_length;
        place.to_array().map(|x| (x as usize).min(BINS - 1))
    }

    fn fill(&self, triangles: &[BoxedTriangle]) -> Bins {
        let mut bins = NO_BINS;
        for triangle in triangles {
            let (low, high) = (triangle.low.truncate(), triangle.high.truncate());
            for (axis, bin) in self.bins(triangle).into_iter().enumerate() {
                let bin = &mut bins[axis][bin];
                bin.bounds = bin.bounds.with(low, high);
                bin.count += 1;
            }
        }
        bins
    }
}

fn merged(mut a: Bins, b: Bins) -> Bins {
    for (a, b) in a.as_flattened_mut().iter_mut().zip(b.as_flattened()) {
        a.bounds = a.bounds.union(b.bounds);
        a.count += b.count;
    }
    a
}

/// The axis and the first bin of the right side of the cheapest cut; `None` if no cut divides the triangles.
fn cheapest_cut(bins: &Bins) -> Option<(usize, usize)> {
    let leaves = |count: u32| count.div_ceil(WIDTH as u32) as f32;
    let mut best: Option<(f32, usize, usize)> = None;
    for (axis, bins) in bins.iter().enumerate() {
        let mut right = [0.0; BINS];
        let mut sum = Bin { bounds: Bounds::NONE, count: 0 };
        for cut in (1..BINS).rev() {
            sum = Bin { bounds: sum.bounds.union(bins[cut].bounds), count: sum.count + bins[cut].count };
            right[cut] = if sum.count == 0 { -1.0 } else { sum.bounds.area() * leaves(sum.count) };
        }
        let mut sum = Bin { bounds: Bounds::NONE, count: 0 };
        for cut in 1..BINS {
            let bin = &bins[cut - 1];
            sum = Bin { bounds: sum.bounds.union(bin.bounds), count: sum.count + bin.count };
            if sum.count == 0 || right[cut] < 0.0 {
                continue;
            }
            let cost = sum.bounds.area() * leaves(sum.count) + right[cut];
            if best.is_none_or(|(least, ..)| cost < least) {
                best = Some((cost, axis, cut));
            }
        }
    }
    best.map(|(_, axis, cut)| (axis, cut))
}

/// Cuts a range in two, neither of them empty.
fn cut<'a>(range: Range<'a>, depth: usize) -> [Range<'a>; 2] {
    let count = range.triangles.len();
    let binning = Binning::new(range.centres);
    let chosen = if depth >= DEEPEST {
        None
    } else {
        let bins = match count >= PARALLEL {
            true => parallel::ranges(count, |part| binning.fill(&range.triangles[part]))
                .into_iter()
                .fold(NO_BINS, merged),
            false => binning.fill(range.triangles),
        };
        cheapest_cut(&bins)
    };
    let middle = match chosen {
        Some((axis, cut)) => partition(range.triangles, |triangle| binning.bins(triangle)[axis] < cut),
        None => count / 2,
    };
    let (left, right) = range.triangles.split_at_mut(middle);
    if count >= PARALLEL {
        let (left, right) = rayon::join(|| Range::new(left), || Range::new(right));
        [left, right]
    } else {
        [Range::new(left), Range::new(right)]
    }
}

/// Moves those that are `left` to the front; returns how many there are.
fn partition(list: &mut [BoxedTriangle], left: impl Fn(&BoxedTriangle) -> bool) -> usize {
    let (mut low, mut high) = (0, list.len());
    loop {
        while low < high && left(&list[low]) {
            low += 1;
        }
        while low < high && !left(&list[high - 1]) {
            high -= 1;
        }
        if low >= high {
            return low;
        }
        list.swap(low, high - 1);
    }
}

impl Tree {
    /// A tree of triangles; `corners` returns those of a number.
    pub(super) fn new(triangles: &mut [BoxedTriangle], corners: &(impl Fn(u32) -> [Vec3; 3] + Sync)) -> Self {
        let mut tree = Self::default();
        if !triangles.is_empty() {
            tree.add(Range::new(triangles), 0, corners);
        }
        tree
    }

    /// Adds a node of a range and all below it.
    fn add(&mut self, range: Range, depth: usize, corners: &(impl Fn(u32) -> [Vec3; 3] + Sync)) {
        let count = range.triangles.len();
        let number = self.nodes.len();
        self.nodes.push(Node::EMPTY);
        let mut parts = vec![range];
        while parts.len() < WIDTH {
            let open = parts.iter().enumerate().filter(|(_, part)| part.triangles.len() > WIDTH);
            let largest =
                open.max_by(|a, b| a.1.bounds.area().total_cmp(&b.1.bounds.area()).then(b.0.cmp(&a.0)));
            let Some((at, _)) = largest else { break };
            let [left, right] = cut(parts.swap_remove(at), depth);
            parts.extend([left, right]);
        }
        let mut node = Node::EMPTY;
        for (lane, part) in parts.iter().enumerate() {
            for axis in 0..3 {
                node.sides[axis][0][lane] = part.bounds.low[axis];
                node.sides[axis][1][lane] = part.bounds.high[axis];
            }
        }
        if count >= PARALLEL {
            let below = |part: Range| {
                let mut tree = Self::default();
                let child = tree.add_child(part, depth, corners);
                (tree, child)
            };
            let below = parallel::map_owned(parts, below);
            for (lane, (tree, child)) in below.into_iter().enumerate() {
                node.children[lane] = self.append(tree, child);
            }
        } else {
            for (lane, part) in parts.into_iter().enumerate() {
                node.children[lane] = self.add_child(part, depth, corners);
            }
        }
        self.nodes[number] = node;
    }

    /// Adds a leaf or node of a range; returns its number, with the mark of leaves.
    fn add_child(&mut self, range: Range, depth: usize, corners: &(impl Fn(u32) -> [Vec3; 3] + Sync)) -> u32 {
        if range.triangles.len() > WIDTH {
            let number = self.nodes.len() as u32;
            self.add(range, depth + 1, corners);
            return number;
        }
        let triangles = range.triangles.iter().map(|triangle| (triangle.id(), corners(triangle.id())));
        self.leaves.push(Leaf::new(triangles));
        (self.leaves.len() - 1) as u32 | LEAF
    }

    /// Appends a tree that was built separately; returns the new number of its child.
    fn append(&mut self, mut tree: Self, child: u32) -> u32 {
        let (nodes, leaves) = (self.nodes.len() as u32, self.leaves.len() as u32);
        let moved = |child: u32| if child & LEAF == 0 { child + nodes } else { child + leaves };
        for child in tree.nodes.iter_mut().flat_map(|node| &mut node.children) {
            *child = moved(*child);
        }
        self.nodes.append(&mut tree.nodes);
        self.leaves.append(&mut tree.leaves);
        moved(child)
    }
}
