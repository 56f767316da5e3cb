//! Cases about normals.

// The formulas as usually written, in f32.
pub(super) mod naive;
// Differences of nearly equal products.
pub(super) mod product;
// Unit vectors of extreme length.
pub(super) mod unit;
// Face normals against exact arithmetic.
pub(super) mod triangles;
// Vertex normals of fans against 256-bit arithmetic.
pub(super) mod fans;
// Coordinates at the ends of f32.
pub(super) mod magnitude;
// Far from the origin.
pub(super) mod offset;
// Slivers.
pub(super) mod sliver;
// Collinear and coincident points.
pub(super) mod degenerate;
// Infinite and undefined positions.
pub(super) mod non_finite;
// Nearly closed and nearly straight corners.
pub(super) mod angle;
// Many faces at one vertex.
pub(super) mod valence;
// Faces that meet as in no smooth surface.
pub(super) mod fan;
// Dihedral angles equal to the crease angle.
pub(super) mod crease;
// Quadrics through exact points.
pub(super) mod quadric;
// Normals in few bits.
pub(super) mod encoding;
