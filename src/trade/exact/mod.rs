//! Exact references: numbers of any length for the signs and areas of faces, 256 bits for roots, arc tangents and powers.
//!
//! 256 bits are more than the 200 that any row of the stress table needs: an error of the reference is below 2⁻²⁴⁰ of
//! what it is the reference for, unless a formula itself cancels by more than that.

// Vectors, their angles and errors.
mod vector;
// Faces and vertices: exact areas of faces; normals of faces, dihedral angles, rotations and vertex normals in 256 bits.
mod face;
// Rays and triangles, for the coverage of pixels.
mod ray;

pub(crate) use face::{degenerate, dihedral, face_normal, radians, turn, vertex_normal};
pub(crate) use ray::Target;
pub(crate) use vector::{Vector, angle, degrees_to, distance, dot, error_in_ulps, length, unit};

use dashu_float::{FBig, round::mode::HalfEven};

/// A binary floating-point number of [`BITS`] bits.
pub(crate) type Big = FBig<HalfEven, 2>;

/// The precision of everything that is not a whole number.
pub(crate) const BITS: usize = 256;

/// The same finite number.
pub(crate) fn big(x: f64) -> Big {
    Big::try_from(x).expect("a finite number").with_precision(BITS).value()
}

/// The same finite number, of a kind whose sums, differences and products are never rounded: their precision is unlimited.
pub(crate) fn exact(x: f64) -> Big {
    big(x).with_precision(0).value()
}

/// The nearest double.
pub(crate) fn small(x: &Big) -> f64 {
    x.to_f64().value()
}
