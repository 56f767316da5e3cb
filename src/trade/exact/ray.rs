//! Intersections of rays with a triangle, in exact numbers: the true coverage of a pixel.

use super::vector::{Vector, cross, dot};
use super::{Big, exact};
use glam::DVec3;

/// A triangle before an eye at the origin.
pub(crate) struct Target {
    /// The cross products of corners that follow each other: normals of the planes through the eye and the edges.
    planes: [Vector; 3],
    /// a·(b × c).
    volume: Big,
    /// Hits nearer than this many times a ray's direction do not count.
    nearest: Big,
}

impl Target {
    /// All coordinates are exact: nothing is rounded.
    pub(crate) fn new(triangle: &[DVec3; 3], nearest: f64) -> Self {
        let [a, b, c] = triangle.map(|corner| corner.to_array().map(exact));
        let planes = [cross(&a, &b), cross(&b, &c), cross(&c, &a)];
        Self { volume: dot(&a, &planes[1]), planes, nearest: exact(nearest) }
    }

    /// On which side of each edge a ray passes: 1, −1, or 0 for a ray through the edge.
    pub(crate) fn sides(&self, direction: DVec3) -> [i8; 3] {
        self.distances(direction).each_ref().map(side)
    }

    /// Whether the ray along a direction meets the interior, edges excluded, at least the nearest distance away.
    pub(crate) fn is_hit(&self, direction: DVec3) -> bool {
        let distances = self.distances(direction);
        let sides = distances.each_ref().map(side);
        let [a, b, c] = distances;
        // Met at t·direction with t = volume/Σ distances; both have the sign of the side that is seen.
        let excess = || side(&(&self.volume - &self.nearest * (a + b + c)));
        sides[0] != 0 && sides == [sides[0]; 3] && excess() == sides[0]
    }

    /// The products of a direction with the normals of the planes.
    fn distances(&self, direction: DVec3) -> [Big; 3] {
        let direction = direction.to_array().map(exact);
        self.planes.each_ref().map(|plane| dot(&direction, plane))
    }
}

/// The sign: 1, −1, or 0 for zero.
fn side(distance: &Big) -> i8 {
    i8::from(*distance > Big::ZERO) - i8::from(*distance < Big::ZERO)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rays_meet_what_is_before_them_and_inside() {
        let triangle =
            [DVec3::new(-1.0, -1.0, -2.0), DVec3::new(1.0, -1.0, -2.0), DVec3::new(0.0, 1.0, -2.0)];
        let at =
            |x: f64, y: f64, nearest: f64| Target::new(&triangle, nearest).is_hit(DVec3::new(x, y, -1.0));
        assert_eq!((at(0.0, 0.0, 0.1), at(0.0, 0.6, 0.1)), (true, false));
        // The distance is 2.
        assert_eq!((at(0.0, 0.0, 1.999), at(0.0, 0.0, 2.001)), (true, false));
        assert!(!Target::new(&triangle.map(|corner| -corner), 0.1).is_hit(DVec3::NEG_Z));
        let [a, b, c] = triangle;
        assert!(Target::new(&[c, b, a], 0.1).is_hit(DVec3::NEG_Z));
        // An edge does not belong to the interior, whichever side is seen.
        assert!(!at(0.0, -0.5, 0.1));
        assert!(!Target::new(&[c, b, a], 0.1).is_hit(DVec3::new(0.0, -0.5, -1.0)));
        let sides = |y: f64| Target::new(&triangle, 0.1).sides(DVec3::new(0.0, y, -1.0));
        assert_eq!((sides(-0.5), sides(0.0)), ([0, -1, -1], [-1; 3]));
    }

    #[test]
    fn far_triangles_are_exact() {
        let far =
            [DVec3::new(-1e300, 0.0, -1.0), DVec3::new(1e300, 0.0, -1.0), DVec3::new(0.0, 1e-300, -1.0)];
        let far = Target::new(&far, 0.1);
        assert!(far.is_hit(DVec3::new(0.0, 0.5e-300, -1.0)));
        assert!(!far.is_hit(DVec3::new(0.0, 1.5e-300, -1.0)));
        // The normal of the first plane is (2³⁰⁰, 2⁻³⁰⁰, −2³⁰⁰): 601 bits decide about these sides.
        let (large, small) = (libm::exp2(300.0), libm::exp2(-300.0));
        let target =
            Target::new(&[DVec3::new(1.0, 0.0, 1.0), DVec3::new(small, -large, 0.0), DVec3::NEG_Z], 0.1);
        assert_eq!([1.0, 0.0, -1.0].map(|y| target.sides(DVec3::new(1.0, y, 1.0))[0]), [1, 0, -1]);
    }
}
