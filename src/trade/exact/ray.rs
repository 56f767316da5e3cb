//! Intersections of rays with a triangle, in exact integers: the true coverage of a pixel.

use dashu_base::Signed;
use dashu_int::IBig;
use glam::DVec3;

/// A vector of whole multiples of a power of two.
struct Whole {
    components: [IBig; 3],
    /// The power.
    exponent: i32,
}

/// A triangle before an eye at the origin.
pub(crate) struct Target {
    /// The cross products of corners that follow each other: normals of the planes through the eye and the edges.
    planes: [Whole; 3],
    /// a·(b × c), and its exponent.
    volume: (IBig, i32),
    /// Hits nearer than this many times a ray's direction do not count.
    nearest: Whole,
}

impl Target {
    /// All coordinates are exact: nothing is rounded.
    pub(crate) fn new(triangle: &[DVec3; 3], nearest: f64) -> Self {
        let [a, b, c] = triangle.map(Whole::new);
        let planes = [a.cross(&b), b.cross(&c), c.cross(&a)];
        let volume = (a.dot(&planes[1]), a.exponent + planes[1].exponent);
        Self { planes, volume, nearest: Whole::new(DVec3::new(nearest, 0.0, 0.0)) }
    }

    /// On which side of each edge a ray passes: 1, −1, or 0 for a ray through the edge.
    pub(crate) fn sides(&self, direction: DVec3) -> [i8; 3] {
        let direction = Whole::new(direction);
        self.planes.each_ref().map(|plane| {
            let side = direction.dot(plane);
            i8::from(side.is_positive()) - i8::from(side.is_negative())
        })
    }

    /// Whether the ray along a direction meets the interior, edges excluded, at least the nearest distance away.
    pub(crate) fn is_hit(&self, direction: DVec3) -> bool {
        let direction = Whole::new(direction);
        let exponents = self.planes.each_ref().map(|plane| plane.exponent);
        let lowest = exponents.into_iter().fold(i32::MAX, i32::min);
        let side = |plane: &Whole| direction.dot(plane) << (plane.exponent - lowest) as usize;
        let sides = self.planes.each_ref().map(side);
        if !(sides.iter().all(Signed::is_positive) || sides.iter().all(Signed::is_negative)) {
            return false;
        }
        // Met at t·direction with t = volume/Σ sides; both have the sign of the side that is seen.
        let sum: IBig = sides.into_iter().sum();
        let is_positive = sum.is_positive();
        let bar = &self.nearest.components[0] * sum;
        let bar_exponent = self.nearest.exponent + direction.exponent + lowest;
        let (volume, exponent) = &self.volume;
        let common = bar_exponent.min(*exponent);
        let excess = (volume << (exponent - common) as usize) - (bar << (bar_exponent - common) as usize);
        if is_positive { excess.is_positive() } else { excess.is_negative() }
    }
}

impl Whole {
    fn new(v: DVec3) -> Self {
        let parts = v.to_array().map(parts);
        let nonzero = parts.iter().filter(|(significand, _)| *significand != 0);
        let exponent = nonzero.map(|(_, exponent)| *exponent).min().unwrap_or(0);
        let component =
            |(significand, own): (i64, i32)| IBig::from(significand) << (own - exponent).max(0) as usize;
        Self { components: parts.map(component), exponent }
    }

    fn dot(&self, other: &Self) -> IBig {
        self.components.iter().zip(&other.components).map(|(a, b)| a * b).sum()
    }

    fn cross(&self, other: &Self) -> Self {
        let (a, b) = (&self.components, &other.components);
        let component = |axis: usize| {
            let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
            &a[j] * &b[k] - &a[k] * &b[j]
        };
        Self { components: std::array::from_fn(component), exponent: self.exponent + other.exponent }
    }
}

/// An odd significand and the exponent of its last bit.
fn parts(x: f64) -> (i64, i32) {
    let bits = x.to_bits();
    let (exponent, fraction) = ((bits >> 52 & 0x7ff) as i32, (bits & ((1 << 52) - 1)) as i64);
    let significand = if exponent == 0 { fraction } else { fraction | 1 << 52 };
    let zeros = significand.trailing_zeros() % 64;
    let magnitude = significand >> zeros;
    (if x < 0.0 { -magnitude } else { magnitude }, exponent.max(1) - 1075 + zeros as i32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_split_and_join() {
        for x in [1.0, -6.0, 0.1, 1e300, -5e-324, f64::MIN_POSITIVE, f64::MAX, 0.0] {
            let (significand, exponent) = parts(x);
            assert_eq!(libm::ldexp(significand as f64, exponent), x);
            assert!(significand % 2 != 0 || x == 0.0);
        }
    }

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
        // An edge is no inside.
        assert!(!at(0.0, -0.5, 0.1));
    }

    #[test]
    fn far_triangles_are_exact() {
        let far =
            [DVec3::new(-1e300, 0.0, -1.0), DVec3::new(1e300, 0.0, -1.0), DVec3::new(0.0, 1e-300, -1.0)];
        let far = Target::new(&far, 0.1);
        assert!(far.is_hit(DVec3::new(0.0, 0.5e-300, -1.0)));
        assert!(!far.is_hit(DVec3::new(0.0, 1.5e-300, -1.0)));
    }
}
