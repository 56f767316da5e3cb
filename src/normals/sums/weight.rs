//! How much a face counts at each of its corners.
//!
//! A weight is a factor of the face (its area, or 1) times a factor of the corner. It is a run-time value: the block kernel
//! branches on it once for eight triangles.

use crate::normals::recipe::Weight;
use crate::num::{self, Arithmetic, Scalars, Vectors};

impl Weight {
    /// Whether the area of the face is a factor.
    pub(crate) fn has_area_factor(self) -> bool {
        matches!(self, Weight::Area | Weight::AngleArea)
    }

    /// Whether the corner's own factor is 1, so that all corners of a face have the same weight.
    pub(crate) fn is_equal_at_corners(self) -> bool {
        matches!(self, Weight::Uniform | Weight::Area)
    }

    /// The power of length in the corner's own factor.
    pub(crate) fn length_power(self) -> i32 {
        if matches!(self, Weight::Max | Weight::Edge) { -2 } else { 0 }
    }
}

/// The quantities of triangles that weights are made of, in any unit of length.
#[derive(Clone, Copy)]
pub(crate) struct TriangleMeasures<A: Arithmetic> {
    /// Twice the area: |e1×e2| at every corner.
    pub(crate) double_area: Scalars<A>,
    /// e1·e2 at each corner.
    pub(crate) dots: [Scalars<A>; 3],
    /// |e|² of the edge opposite each corner.
    pub(crate) opposite: [Scalars<A>; 3],
}

impl<A: Arithmetic> TriangleMeasures<A> {
    /// From the edges P0→P1, P0→P2 and P1→P2.
    #[inline(always)]
    pub(crate) fn new(double_area: Scalars<A>, e1: Vectors<A>, e2: Vectors<A>, e3: Vectors<A>) -> Self {
        Self {
            double_area,
            dots: [e1.dot(e2), Scalars::splat(double_area.arch, 0.0) - e1.dot(e3), e2.dot(e3)],
            opposite: [e3.squared_length(), e2.squared_length(), e1.squared_length()],
        }
    }

    /// The corners' own factors of a weight. Fits have none of their own: their frame is the angle mean.
    #[inline(always)]
    pub(crate) fn corner_factors(self, weight: Weight) -> [Scalars<A>; 3] {
        let one = Scalars::splat(self.double_area.arch, 1.0);
        let [a, b, c] = self.opposite;
        match weight {
            Weight::Uniform | Weight::Area => [one; 3],
            Weight::Angle | Weight::AngleArea | Weight::Quadric | Weight::Jet | Weight::Best => {
                num::triangle_angles(self.double_area, self.dots)
            }
            Weight::Max => {
                // One division: 1/(bc) = a/(abc), and so on. Nothing here leaves f64 for edges of the f32 range.
                let common = self.double_area / ((a * b) * c);
                [common * a, common * b, common * c]
            }
            Weight::Edge => {
                let (a, b, c) = (a.sqrt(), b.sqrt(), c.sqrt());
                let common = one / ((a * b) * c);
                [common * a, common * b, common * c]
            }
        }
    }
}
