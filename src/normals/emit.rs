//! The types that normals are written as.

use glam::DVec3;

/// A place for a unit vector in the caller's own type.
pub(crate) trait Emit: Copy + Send + Sync {
    /// The vector, rounded to the type.
    fn emit(unit: DVec3) -> Self;
}

impl Emit for DVec3 {
    #[inline(always)]
    fn emit(unit: DVec3) -> Self {
        unit
    }
}

impl Emit for [f64; 3] {
    #[inline(always)]
    fn emit(unit: DVec3) -> Self {
        unit.to_array()
    }
}

impl Emit for [f32; 3] {
    #[inline(always)]
    fn emit(unit: DVec3) -> Self {
        unit.as_vec3().to_array()
    }
}
