//! Faces so thin that their direction is noise of the file's own rounding.

use crate::mesh::Storage;
use crate::num;
use glam::DVec3;

/// The height below which a face is a sliver, for the largest |coordinate| of the face: four times the spacing
/// of `f32` values there, or 2^-48 of it for doubles and text.
#[inline]
pub(crate) fn threshold(storage: Storage, largest: f64) -> f64 {
    match storage {
        // Below the normal numbers the spacing stays 2^-149.
        Storage::F32 => 4.0 * num::power_of_two((num::exponent(largest) - 23).max(-149)),
        Storage::F64 => largest * num::power_of_two(-48),
    }
}

/// Triangles whose |v|² is above this times |e1|² + |e2|² are no slivers, if no coordinate is larger than `largest`.
pub(crate) fn triangle_bound(storage: Storage, largest: f64) -> f64 {
    let threshold = threshold(storage, largest);
    // The longest edge is at most |e1| + |e2|, its square at most twice the sum of theirs; and something for the
    // rounding of the test itself.
    2.001 * threshold * threshold
}

/// Up to this many corners, all pairs are measured.
const ALL_PAIRS: usize = 8;

/// Axes, face diagonals and body diagonals of the cube. Every direction is within 27.6° of one of them.
const DIRECTIONS: [[f64; 3]; 13] = [
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [1.0, 1.0, 0.0],
    [1.0, -1.0, 0.0],
    [1.0, 0.0, 1.0],
    [1.0, 0.0, -1.0],
    [0.0, 1.0, 1.0],
    [0.0, 1.0, -1.0],
    [1.0, 1.0, 1.0],
    [1.0, 1.0, -1.0],
    [1.0, -1.0, 1.0],
    [-1.0, 1.0, 1.0],
];

/// The square of the largest distance between two corners, in units of 2^(2·exponent). For polygons of more than
/// eight corners, of the largest between those that lie outermost along thirteen directions: at least 0.886 of
/// the true distance, in time linear in the corners.
pub(crate) fn squared_diameter(points: &[DVec3], exponent: i32) -> f64 {
    if points.len() <= ALL_PAIRS {
        return largest_pair(points, exponent);
    }
    let mut outermost = Vec::with_capacity(2 * DIRECTIONS.len());
    for direction in DIRECTIONS.map(DVec3::from) {
        let first = (points[0], 0.0);
        let (mut low, mut high) = (first, first);
        for &point in points {
            let at = (point - points[0]).dot(direction);
            if at < low.1 {
                low = (point, at);
            }
            if at > high.1 {
                high = (point, at);
            }
        }
        outermost.extend([low.0, high.0]);
    }
    largest_pair(&outermost, exponent)
}

fn largest_pair(points: &[DVec3], exponent: i32) -> f64 {
    let mut largest = 0.0;
    for (i, &a) in points.iter().enumerate() {
        for &b in &points[i + 1..] {
            largest = f64::max(largest, num::squared_length(num::scale(b - a, -exponent)));
        }
    }
    largest
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::test_numbers::Numbers;

    #[test]
    fn threshold_follows_the_spacing_of_the_storage() {
        assert_eq!(threshold(Storage::F32, 1.0), 4.0 * f64::from(f32::EPSILON));
        assert_eq!(threshold(Storage::F32, 1.99), 4.0 * f64::from(f32::EPSILON));
        assert_eq!(threshold(Storage::F32, 1e-42), 4.0 * f64::from(f32::from_bits(1)));
        assert_eq!(threshold(Storage::F32, 0.0), 4.0 * f64::from(f32::from_bits(1)));
        assert_eq!(threshold(Storage::F64, 3.0), 3.0 / 281_474_976_710_656.0);
    }

    #[test]
    fn the_diameter_of_large_polygons_is_within_its_stated_factor() {
        let mut numbers = Numbers::new(7);
        let mut worst: f64 = 1.0;
        for _ in 0..3000 {
            // Long in a random direction, so that the diameter is one pair and no other comes near.
            let long = DVec3::new(numbers.unit() - 0.5, numbers.unit() - 0.5, numbers.unit() - 0.5);
            let mut points: Vec<DVec3> = (0..20)
                .map(|_| DVec3::new(numbers.unit() - 0.5, numbers.unit() - 0.5, numbers.unit() - 0.5))
                .collect();
            points[3] += long * 3.0;
            let ratio = (squared_diameter(&points, 0) / largest_pair(&points, 0)).sqrt();
            worst = worst.min(ratio);
        }
        assert!((0.886..=1.0).contains(&worst), "{worst}");
        let few = [DVec3::ZERO, DVec3::X, DVec3::new(4.0, 3.0, 0.0)];
        assert_eq!(squared_diameter(&few, 1), 6.25);
    }
}
