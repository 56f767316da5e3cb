//! Inspection: the numbers behind one sample.

// The point of a face at a screen position, in double precision.
pub(super) mod hit_point;
// The probe of one sample.
pub(super) mod probe;
