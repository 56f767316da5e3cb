//! The diagonal of a quad.

use glam::DVec3;

/// Sums of angles and squared lengths that agree to this, relative to π and to themselves, are equal: it is what
/// rounding to `f32` can do to the corners of a rotated rectangle of ordinary size.
const TIE: f64 = 1.0 / (1 << 20) as f64;

/// The corner whose position comes first in lexicographic order.
pub(super) fn lowest(points: &[DVec3]) -> usize {
    let before = |a: DVec3, b: DVec3| a.to_array() < b.to_array();
    (1..points.len()).fold(0, |low, k| if before(points[k], points[low]) { k } else { low })
}

/// The two triangles of a quad whose `lowest` corner decides ties; `None` if it has no area or crosses itself.
pub(super) fn cut(points: &[DVec3], lowest: usize) -> Option<[[u32; 3]; 2]> {
    let p: [DVec3; 4] = points.try_into().ok()?;
    let normal = (p[2] - p[0]).cross(p[3] - p[1]);
    // A diagonal leaves the two triangles (k−1, k, k+1) at the corners k that it does not touch.
    let around = [0, 1, 2, 3].map(|k: usize| {
        let (to, from) = (p[(k + 1) % 4] - p[k], p[(k + 3) % 4] - p[k]);
        let cross = to.cross(from);
        (cross.dot(normal), cross.length(), to.dot(from))
    });
    let areas = around.map(|(area, ..)| area);
    let even = choice(areas[1], areas[3]);
    let odd = choice(areas[0], areas[2]);
    let even_wins = match even.cmp(&odd) {
        _ if even == Soundness::Folded && odd == Soundness::Folded => return None,
        std::cmp::Ordering::Greater => true,
        std::cmp::Ordering::Less => false,
        std::cmp::Ordering::Equal => {
            // The argument of a product of complex numbers is the sum of their angles.
            let sum = |a: usize, b: usize| {
                let ((_, sin_a, cos_a), (_, sin_b, cos_b)) = (around[a], around[b]);
                let angle = libm::atan2(sin_a * cos_b + cos_a * sin_b, cos_a * cos_b - sin_a * sin_b);
                if angle < 0.0 { angle + std::f64::consts::TAU } else { angle }
            };
            let opposite = (sum(1, 3), sum(0, 2));
            let length = ((p[2] - p[0]).length_squared(), (p[3] - p[1]).length_squared());
            if (opposite.0 - opposite.1).abs() > TIE * std::f64::consts::PI {
                opposite.0 < opposite.1
            } else if (length.0 - length.1).abs() > TIE * (length.0 + length.1) {
                length.0 < length.1
            } else {
                lowest.is_multiple_of(2)
            }
        }
    };
    Some(if even_wins { [[0, 1, 2], [0, 2, 3]] } else { [[0, 1, 3], [1, 2, 3]] })
}

/// The quality of a diagonal, from bad to good.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Soundness {
    /// A triangle is inverted, or neither has area.
    Folded,
    /// One triangle has no area.
    Degenerate,
    /// Both triangles have area, on the quad's own side.
    Sound,
}

fn choice(a: f64, b: f64) -> Soundness {
    if a > 0.0 && b > 0.0 {
        Soundness::Sound
    } else if a.min(b) == 0.0 && a.max(b) > 0.0 {
        Soundness::Degenerate
    } else {
        Soundness::Folded
    }
}
