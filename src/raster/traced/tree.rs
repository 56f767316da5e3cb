//! A tree of axis-aligned boxes over triangles in single precision.

use glam::{DVec3, Vec3};

/// Children of a node and triangles of a leaf: the lanes that are tested side by side.
pub(super) const WIDTH: usize = 8;

/// The bit of a child that is a leaf; the others are its number.
pub(super) const LEAF: u32 = 1 << 31;

/// Eight boxes. Unused ones are empty, so that no ray meets them.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub(super) struct Node {
    /// The low and the high side of each box, by axis.
    pub(super) sides: [[[f32; WIDTH]; 2]; 3],
    pub(super) children: [u32; WIDTH],
}

impl Node {
    pub(super) const EMPTY: Self =
        Self { sides: [[[f32::INFINITY; WIDTH], [f32::NEG_INFINITY; WIDTH]]; 3], children: [LEAF; WIDTH] };
}

/// Up to eight triangles; the first one in each unused lane too, where it changes nothing.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub(super) struct Leaf {
    /// The coordinates by corner and axis.
    pub(super) corners: [[[f32; WIDTH]; 3]; 3],
    pub(super) ids: [u32; WIDTH],
}

impl Leaf {
    /// A leaf of triangles with their numbers.
    pub(super) fn new(triangles: impl ExactSizeIterator<Item = (u32, [Vec3; 3])>) -> Self {
        let mut leaf = Self { corners: [[[0.0; WIDTH]; 3]; 3], ids: [0; WIDTH] };
        for (first, (id, corners)) in triangles.enumerate() {
            let lanes = if first == 0 { 0..WIDTH } else { first..first + 1 };
            leaf.ids[lanes.clone()].fill(id);
            for (axes, corner) in leaf.corners.iter_mut().zip(corners) {
                axes.iter_mut().zip(corner.to_array()).for_each(|(row, x)| row[lanes.clone()].fill(x));
            }
        }
        leaf
    }

    pub(super) fn triangle(&self, lane: usize) -> [Vec3; 3] {
        self.corners.each_ref().map(|axes| Vec3::new(axes[0][lane], axes[1][lane], axes[2][lane]))
    }
}

/// Nodes and leaves; the first node is the root. Empty without triangles.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tree {
    pub(super) nodes: Vec<Node>,
    pub(super) leaves: Vec<Leaf>,
}

impl Tree {
    /// The smallest and the largest corner of all triangles; those of nothing without any.
    pub(super) fn bounds(&self) -> [DVec3; 2] {
        let Some(root) = self.nodes.first() else { return [DVec3::INFINITY, DVec3::NEG_INFINITY] };
        let side = |which: usize, fold: fn(f32, f32) -> f32| {
            let of_axis = |axis: usize| {
                let [first, rest @ ..] = root.sides[axis][which];
                f64::from(rest.into_iter().fold(first, fold))
            };
            DVec3::new(of_axis(0), of_axis(1), of_axis(2))
        };
        [side(0, f32::min), side(1, f32::max)]
    }
}
