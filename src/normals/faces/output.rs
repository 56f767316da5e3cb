//! The types that normals are written as.

use crate::num::Lanes;
use glam::DVec3;

/// A place for a unit vector in the caller's own type.
pub(crate) trait Emit: Copy + Send + Sync {
    /// The vector, rounded to the type.
    fn emit(unit: DVec3) -> Self;

    /// A row's first three numbers times a factor, rounded to the type.
    fn emit_row<A: Lanes>(arch: A, row: &[f64; 4], factor: f64) -> Self;
}

impl Emit for DVec3 {
    #[inline(always)]
    fn emit(unit: DVec3) -> Self {
        unit
    }

    #[inline(always)]
    fn emit_row<A: Lanes>(arch: A, row: &[f64; 4], factor: f64) -> Self {
        let [x, y, z, _] = arch.scaled_row(row, factor);
        DVec3::new(x, y, z)
    }
}

impl Emit for [f64; 3] {
    #[inline(always)]
    fn emit(unit: DVec3) -> Self {
        unit.to_array()
    }

    #[inline(always)]
    fn emit_row<A: Lanes>(arch: A, row: &[f64; 4], factor: f64) -> Self {
        let [x, y, z, _] = arch.scaled_row(row, factor);
        [x, y, z]
    }
}

impl Emit for [f32; 3] {
    #[inline(always)]
    fn emit(unit: DVec3) -> Self {
        unit.as_vec3().to_array()
    }

    #[inline(always)]
    fn emit_row<A: Lanes>(arch: A, row: &[f64; 4], factor: f64) -> Self {
        let [x, y, z, _] = arch.scaled_row_of_singles(row, factor);
        [x, y, z]
    }
}
