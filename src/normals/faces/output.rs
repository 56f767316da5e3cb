//! The types that normals are written as.

use crate::num::Lanes;
use glam::DVec3;

/// A place for a unit vector in the caller's own type.
pub(crate) trait Emit: Copy + Send + Sync {
    /// The vector, rounded to the type.
    fn emit(unit: DVec3) -> Self;

    /// A row's first three numbers times a factor, rounded to the type.
    fn emit_row<A: Lanes>(arch: A, row: &[f64; 4], factor: f64) -> Self;

    /// A vector that is unit but for the rounding of single precision. Where doubles are wanted it is made unit in doubles.
    fn emit_single(unit: [f32; 3]) -> Self;
}

/// A vector of length 1 but for the rounding of single precision, made unit in doubles. The square is off by e < 10⁻⁶, so three
/// terms of the series of 1/√(1 + e) leave 10⁻¹⁸.
#[inline(always)]
fn widened(unit: [f32; 3]) -> DVec3 {
    let unit = DVec3::from(unit.map(f64::from));
    let e = unit.length_squared() - 1.0;
    unit * (1.0 - e * (0.5 - 0.375 * e))
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

    #[inline(always)]
    fn emit_single(unit: [f32; 3]) -> Self {
        widened(unit)
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

    #[inline(always)]
    fn emit_single(unit: [f32; 3]) -> Self {
        unit
    }
}
