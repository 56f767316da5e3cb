//! How much a face counts at each of its corners.

use crate::normals::recipe::Weight;
use crate::num::{self, Arithmetic, Scalars, Vectors};
use glam::DVec3;

/// The measures of triangles that weights are made of, in any unit of length.
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
}

/// a·b, added in the same order everywhere.
#[inline(always)]
pub(crate) fn dot(a: DVec3, b: DVec3) -> f64 {
    (a.x * b.x + a.y * b.y) + a.z * b.z
}

/// The measures of one corner of a polygon; e1 and e2 lead to the next and the previous corner that do not
/// coincide with it.
#[derive(Clone, Copy)]
pub(crate) struct CornerMeasures {
    /// |e1×e2|.
    pub(crate) cross: f64,
    /// e1·e2.
    pub(crate) dot: f64,
    /// |e1|² |e2|².
    pub(crate) squares: f64,
    /// Whether e1×e2 points away from the face normal.
    pub(crate) reflex: bool,
}

/// A weight, resolved at compile time so that a kernel is made for each.
pub(crate) trait CornerWeight: Copy + Send + Sync + 'static {
    /// Whether the face counts by its area beside what the corner says.
    const BY_AREA: bool = false;
    /// Whether every corner of a face counts the same.
    const EVEN: bool = false;
    /// The power of length that the corner's own weight has.
    const POWER: i32 = 0;

    /// The weights of a triangle's corners.
    fn of_triangle<A: Arithmetic>(measures: TriangleMeasures<A>) -> [Scalars<A>; 3];

    /// The weight of a polygon's corner.
    fn of_corner(measures: CornerMeasures) -> f64;
}

/// w = 1.
#[derive(Clone, Copy)]
pub(crate) struct Uniform;

impl CornerWeight for Uniform {
    const EVEN: bool = true;

    #[inline(always)]
    fn of_triangle<A: Arithmetic>(measures: TriangleMeasures<A>) -> [Scalars<A>; 3] {
        [Scalars::splat(measures.double_area.arch, 1.0); 3]
    }

    fn of_corner(_: CornerMeasures) -> f64 {
        1.0
    }
}

/// w = area.
#[derive(Clone, Copy)]
pub(crate) struct Area;

impl CornerWeight for Area {
    const BY_AREA: bool = true;
    const EVEN: bool = true;

    #[inline(always)]
    fn of_triangle<A: Arithmetic>(measures: TriangleMeasures<A>) -> [Scalars<A>; 3] {
        [Scalars::splat(measures.double_area.arch, 1.0); 3]
    }

    fn of_corner(_: CornerMeasures) -> f64 {
        1.0
    }
}

/// w = α.
#[derive(Clone, Copy)]
pub(crate) struct Angle;

impl CornerWeight for Angle {
    #[inline(always)]
    fn of_triangle<A: Arithmetic>(measures: TriangleMeasures<A>) -> [Scalars<A>; 3] {
        num::triangle_angles(measures.double_area, measures.dots)
    }

    fn of_corner(measures: CornerMeasures) -> f64 {
        let angle = num::corner_angle(measures.cross, measures.dot);
        if measures.reflex { std::f64::consts::TAU - angle } else { angle }
    }
}

/// w = α · area.
#[derive(Clone, Copy)]
pub(crate) struct AngleArea;

impl CornerWeight for AngleArea {
    const BY_AREA: bool = true;

    #[inline(always)]
    fn of_triangle<A: Arithmetic>(measures: TriangleMeasures<A>) -> [Scalars<A>; 3] {
        Angle::of_triangle(measures)
    }

    fn of_corner(measures: CornerMeasures) -> f64 {
        Angle::of_corner(measures)
    }
}

/// w = |e1×e2| / (|e1|² |e2|²) (Max, *Weights for computing vertex normals from facet normals*, JGT 4(2), 1999).
#[derive(Clone, Copy)]
pub(crate) struct Max;

impl CornerWeight for Max {
    const POWER: i32 = -2;

    #[inline(always)]
    fn of_triangle<A: Arithmetic>(measures: TriangleMeasures<A>) -> [Scalars<A>; 3] {
        let [a, b, c] = measures.opposite;
        // One division: 1/(bc) = a/(abc), and so on. Nothing here leaves f64 for edges of the f32 range.
        let common = measures.double_area / ((a * b) * c);
        [common * a, common * b, common * c]
    }

    fn of_corner(measures: CornerMeasures) -> f64 {
        measures.cross / measures.squares
    }
}

/// w = 1 / (|e1| |e2|).
#[derive(Clone, Copy)]
pub(crate) struct Edge;

impl CornerWeight for Edge {
    const POWER: i32 = -2;

    #[inline(always)]
    fn of_triangle<A: Arithmetic>(measures: TriangleMeasures<A>) -> [Scalars<A>; 3] {
        let [a, b, c] = measures.opposite;
        let (a, b, c) = (a.sqrt(), b.sqrt(), c.sqrt());
        let common = Scalars::splat(a.arch, 1.0) / ((a * b) * c);
        [common * a, common * b, common * c]
    }

    fn of_corner(measures: CornerMeasures) -> f64 {
        1.0 / measures.squares.sqrt()
    }
}

/// Work done with a weight resolved.
pub(crate) trait WeightVisitor {
    /// What it gives.
    type Output;

    /// Does it.
    fn visit<W: CornerWeight>(self) -> Self::Output;
}

/// Calls the visitor with the weight's type. A quadric has no weights: its frame is the angle mean.
pub(crate) fn visit_weight<V: WeightVisitor>(weight: Weight, visitor: V) -> V::Output {
    match weight {
        Weight::Uniform => visitor.visit::<Uniform>(),
        Weight::Area => visitor.visit::<Area>(),
        Weight::Angle | Weight::Quadric => visitor.visit::<Angle>(),
        Weight::AngleArea => visitor.visit::<AngleArea>(),
        Weight::Max => visitor.visit::<Max>(),
        Weight::Edge => visitor.visit::<Edge>(),
    }
}
