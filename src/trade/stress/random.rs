//! Reproducible random numbers, vectors and rotations.

use crate::num::numbers::Numbers;
use glam::{DQuat, DVec3};

/// Uniform in ±1.
pub(super) fn signed(numbers: &mut Numbers) -> f64 {
    2.0 * numbers.unit() - 1.0
}

/// Each component uniform in ±1.
pub(super) fn vector(numbers: &mut Numbers) -> DVec3 {
    DVec3::from_array([0; 3].map(|_| signed(numbers)))
}

pub(super) fn rotation(numbers: &mut Numbers) -> DQuat {
    let [x, y, z, w] = [0; 4].map(|_| signed(numbers));
    DQuat::from_xyzw(x, y, z, w).normalize()
}
