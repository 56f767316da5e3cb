//! The rotation or reflection that brings a set of directions closest to another.

use crate::num::{Degrees, Radians};
use glam::{DMat3, DVec3};

/// How much the plane of coplanar directions counts against a reflection in it: so little that it decides only if nothing else
/// does.
const IN_PLANE: f64 = 1e-3;

/// Below this determinant of the mean of a·bᵀ, directions are taken as collinear: the rotation about their line is then free.
const ON_A_LINE: f64 = 1e-9;

/// One term of Σ a · bᵀ.
pub(crate) fn outer(a: DVec3, b: DVec3) -> DMat3 {
    DMat3::from_cols(a * b.x, a * b.y, a * b.z)
}

/// The rotation or reflection that brings each b closest to its a, from the mean of a · bᵀ: its orthogonal factor, by Newton's
/// iteration (N. Higham, *Computing the polar decomposition*, 1986). The rotation if all are coplanar, which a reflection in
/// their plane leaves unchanged; `None` if all are collinear.
pub(crate) fn closest_rotation(mean: DMat3) -> Option<DMat3> {
    let [a, b, c] = [mean.x_axis, mean.y_axis, mean.z_axis];
    // With singular values s and t in the plane, the cofactors have s·t across it, and the sign that makes a rotation.
    let cofactors = DMat3::from_cols(b.cross(c), c.cross(a), a.cross(b));
    let mut x = mean + cofactors * IN_PLANE;
    if x.determinant().abs() < ON_A_LINE {
        return None;
    }
    for _ in 0..60 {
        let next = (x + x.inverse().transpose()) * 0.5;
        let change = (next - x).to_cols_array().iter().fold(0.0, |most: f64, entry| most.max(entry.abs()));
        x = next;
        if change < 1e-14 {
            break;
        }
    }
    x.is_finite().then_some(x)
}

/// The same from pairs of unit vectors a and b of which up to half may be outliers: pairs that are farther off than most are
/// omitted, until that changes nothing.
pub(crate) fn robust_rotation(pairs: &[(DVec3, DVec3)]) -> Option<DMat3> {
    /// The squared distance of unit vectors 1° from each other: nearer pairs always stay.
    const NEAR: f64 = 3e-4;
    const ROUNDS: usize = 20;
    let mut bound = f64::INFINITY;
    let mut rotation: Option<DMat3> = None;
    for _ in 0..ROUNDS {
        let distance =
            |&(a, b): &(DVec3, DVec3)| rotation.map_or(0.0, |rotation| (a - rotation * b).length_squared());
        let (mut sum, mut count) = (DMat3::ZERO, 0);
        for &(a, b) in pairs.iter().filter(|pair| distance(pair) <= bound) {
            sum += outer(a, b);
            count += 1;
        }
        let next = closest_rotation(sum * (1.0 / f64::from(count.max(1))))?;
        let mut distances: Vec<f64> = pairs.iter().map(|&(a, b)| (a - next * b).length_squared()).collect();
        if rotation.is_some_and(|rotation| rotation == next) || distances.is_empty() {
            break;
        }
        let middle = distances.len() / 2;
        let (_, median, _) = distances.select_nth_unstable_by(middle, f64::total_cmp);
        // Twice the median angle.
        bound = (4.0 * *median).max(NEAR);
        rotation = Some(next);
    }
    rotation
}

/// Whether directions lie on at least three lines: fewer leave the rotation open.
pub(crate) fn are_spread(directions: impl IntoIterator<Item = DVec3>) -> bool {
    /// The sine of 5°: lines that are closer count as one.
    const SEPARATE: f64 = 0.087;
    let mut lines: Vec<DVec3> = Vec::new();
    for direction in directions {
        if lines.iter().all(|line| line.cross(direction).length() > SEPARATE) {
            lines.push(direction);
        }
        if lines.len() == 3 {
            return true;
        }
    }
    false
}

/// The angle of a rotation, in degrees; for a reflection, the angle of its negative.
pub(crate) fn rotation_angle(rotation: DMat3) -> f64 {
    let rotation = if rotation.determinant() < 0.0 { -rotation } else { rotation };
    let axis = DVec3::new(
        rotation.y_axis.z - rotation.z_axis.y,
        rotation.z_axis.x - rotation.x_axis.z,
        rotation.x_axis.y - rotation.y_axis.x,
    );
    let trace = rotation.x_axis.x + rotation.y_axis.y + rotation.z_axis.z;
    Degrees::from(Radians(libm::atan2(axis.length(), trace - 1.0))).0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rotation() -> DMat3 {
        DMat3::from_axis_angle(DVec3::new(2.0, -1.0, 3.0).normalize(), 0.4)
    }

    fn mean(pairs: &[(DVec3, DVec3)]) -> DMat3 {
        let sum = pairs.iter().fold(DMat3::ZERO, |sum, &(a, b)| sum + outer(a, b));
        sum * (1.0 / pairs.len() as f64)
    }

    /// Unit vectors all round, on a spiral.
    fn directions(count: u32) -> Vec<DVec3> {
        let one = |i: u32| {
            let height = 1.0 - 2.0 * (f64::from(i) + 0.5) / f64::from(count);
            let (sine, cosine) = libm::sincos(2.4 * f64::from(i));
            DVec3::new(cosine, sine, 0.0) * (1.0 - height * height).sqrt() + DVec3::Z * height
        };
        (0..count).map(one).collect()
    }

    #[test]
    fn rotations_and_reflections_are_found() {
        for rotation in [rotation(), -rotation(), DMat3::from_diagonal(DVec3::new(1.0, -1.0, 1.0))] {
            let pairs: Vec<_> = directions(50).into_iter().map(|b| (rotation * b, b)).collect();
            let found = closest_rotation(mean(&pairs)).unwrap();
            assert!(
                (found - rotation).to_cols_array().iter().all(|off| off.abs() < 1e-12),
                "{found} for {rotation}"
            );
        }
    }

    #[test]
    fn in_a_plane_it_is_a_rotation_and_on_a_line_none() {
        let flat = [DVec3::X, DVec3::Y, DVec3::new(0.6, 0.8, 0.0)].map(|b| (rotation() * b, b));
        let found = closest_rotation(mean(&flat)).unwrap();
        assert!((found - rotation()).to_cols_array().iter().all(|off| off.abs() < 1e-12), "{found}");
        assert_eq!(closest_rotation(mean(&[(DVec3::X, DVec3::Y), (DVec3::NEG_X, DVec3::NEG_Y)])), None);
    }

    #[test]
    fn what_has_nothing_to_do_with_it_does_not_pull() {
        let aside = DMat3::from_axis_angle(DVec3::X, 1.5);
        let pairs = directions(100).into_iter().enumerate();
        let pairs: Vec<_> =
            pairs.map(|(i, b)| (if i % 3 == 0 { aside * b } else { rotation() * b }, b)).collect();
        let pulled = closest_rotation(mean(&pairs)).unwrap();
        assert!((rotation_angle(pulled) - rotation_angle(rotation())).abs() > 1.0);
        let steady = robust_rotation(&pairs).unwrap();
        assert!((steady - rotation()).to_cols_array().iter().all(|off| off.abs() < 1e-9), "{steady}");
    }

    #[test]
    fn two_lines_are_not_spread() {
        let lines = [DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::new(1.0, 0.01, 0.0).normalize()];
        assert!(!are_spread(lines));
        assert!(are_spread([DVec3::X, DVec3::Y, DVec3::new(0.6, 0.8, 0.0)]));
    }
}
