//! What storing positions in single precision costs.

use super::{Note, Place};
use crate::mesh::{Mesh, Storage};
use rayon::prelude::*;

/// Tells when rounding to `f32` moves vertices far for the size of the model. Around the origin it costs at most
/// 2⁻²⁵ of the size; far from it, or near the smallest numbers, it can cost everything.
pub(super) fn displacement_note(mesh: &Mesh) -> Option<Note> {
    if mesh.storage() != Storage::F64 {
        return None;
    }
    let moved = mesh.positions().par_iter().map(|p| p.distance(p.as_vec3().as_dvec3()));
    let largest = moved.reduce(|| 0.0, f64::max);
    let size = mesh.bounds().map_or(0.0, |(low, high)| low.distance(high));
    (size > 0.0 && largest > size / f64::from(1 << 20)).then(|| {
        let text = format!(
            "rounding positions to 32-bit floats moves vertices by up to {largest:.3e}, {:.1e} of the model's size; \
             move it nearer to the origin, or write PLY or OBJ",
            largest / size
        );
        Note::warning(Place::File, text)
    })
}
