//! Sums: weighted sums of face normals over vertices or smooth groups.

// What to sum, and what a sum can turn out to be.
pub(super) mod request;
// How much a face counts at each of its corners.
pub(super) mod weight;
// Division of the work among threads without changing a bit.
pub(super) mod partition;
// Positions of a block of triangles, brought together.
pub(super) mod gather;
// Adding the terms of a block to sums.
pub(super) mod scatter;
// The block kernel: terms of eight triangles at a time.
pub(super) mod block;
// The scalar path: terms of one face, the same bits as the block kernel.
pub(super) mod corner_terms;
// The sum of a few faces at one corner.
pub(super) mod corner_mean;
// From sums to unit vectors.
pub(super) mod finish;
// One thread's share of the sums.
pub(super) mod accumulate;
// A second evaluation of sums that may have cancelled.
pub(super) mod recheck;
// The weighted sums of all vertices or groups.
pub(super) mod weighted_sums;
// Sums in which each corner selects its own faces.
pub(super) mod corner_sums;
// From sums in single precision to unit vectors.
pub(super) mod single_finish;
// The weighted sums in single precision.
pub(super) mod single_precision;
