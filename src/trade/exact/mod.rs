//! Truth to hold computed numbers against: exact integers for the signs and areas of faces, 256 bits for everything that
//! has a root, an arc tangent or a power in it.
//!
//! 256 bits are more than the 200 that any row of the stress table needs: an error of the reference is below 2⁻²⁴⁰ of
//! what it is the reference for, unless a formula itself cancels by more than that.

mod dihedral;
mod face;
mod mean;
mod ray;
mod vector;

pub(crate) use dihedral::{dihedral, radians, turn};
pub(crate) use face::{degenerate, face_normal};
pub(crate) use mean::vertex_normal;
pub(crate) use ray::Target;
pub(crate) use vector::{Vector, angle, degrees_to, distance, dot, error_in_ulps, length, unit};

use dashu::float::{FBig, round::mode::HalfEven};

/// A binary floating-point number of [`BITS`] bits.
pub(crate) type Big = FBig<HalfEven, 2>;

/// The precision of everything that is not a whole number.
pub(crate) const BITS: usize = 256;

/// The same finite number.
pub(crate) fn big(x: f64) -> Big {
    Big::try_from(x).expect("a finite number").with_precision(BITS).value()
}

/// The nearest double.
pub(crate) fn small(x: &Big) -> f64 {
    x.to_f64().value()
}
