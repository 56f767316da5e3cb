//! The number types of the caller's positions and normals.

use crate::mesh::PositionsRef;
use crate::num::{Lanes, Real};
use glam::DVec3;

/// A component of positions and of unit vectors, `f32` or `f64`.
pub(crate) trait Component: Real + bytemuck::Pod {
    /// Positions as kernels read them.
    fn positions(points: &[[Self; 3]]) -> PositionsRef<'_>;

    /// The vector, rounded to the type.
    fn emit(unit: DVec3) -> [Self; 3];

    /// A row's first three numbers times a factor, rounded to the type.
    fn emit_row<A: Lanes>(arch: A, row: &[f64; 4], factor: f64) -> [Self; 3];

    /// A vector that is unit but for the rounding of single precision. Where doubles are wanted it is made unit in doubles.
    fn emit_single(unit: [f32; 3]) -> [Self; 3];

    /// The vector in double precision.
    fn widen(unit: [Self; 3]) -> DVec3;
}

impl Component for f32 {
    fn positions(points: &[[f32; 3]]) -> PositionsRef<'_> {
        PositionsRef::F32(points)
    }

    #[inline(always)]
    fn emit(unit: DVec3) -> [f32; 3] {
        unit.as_vec3().to_array()
    }

    #[inline(always)]
    fn emit_row<A: Lanes>(arch: A, row: &[f64; 4], factor: f64) -> [f32; 3] {
        let [x, y, z, _] = arch.scaled_row_of_singles(row, factor);
        [x, y, z]
    }

    #[inline(always)]
    fn emit_single(unit: [f32; 3]) -> [f32; 3] {
        unit
    }

    fn widen(unit: [f32; 3]) -> DVec3 {
        DVec3::from(unit.map(f64::from))
    }
}

impl Component for f64 {
    fn positions(points: &[[f64; 3]]) -> PositionsRef<'_> {
        PositionsRef::F64(bytemuck::cast_slice(points))
    }

    #[inline(always)]
    fn emit(unit: DVec3) -> [f64; 3] {
        unit.to_array()
    }

    #[inline(always)]
    fn emit_row<A: Lanes>(arch: A, row: &[f64; 4], factor: f64) -> [f64; 3] {
        let [x, y, z, _] = arch.scaled_row(row, factor);
        [x, y, z]
    }

    /// The square of the length is off by e < 10⁻⁶, so three terms of the series of 1/√(1 + e) leave 10⁻¹⁸.
    #[inline(always)]
    fn emit_single(unit: [f32; 3]) -> [f64; 3] {
        let unit = DVec3::from(unit.map(f64::from));
        let e = unit.length_squared() - 1.0;
        (unit * (1.0 - e * (0.5 - 0.375 * e))).to_array()
    }

    fn widen(unit: [f64; 3]) -> DVec3 {
        DVec3::from(unit)
    }
}
