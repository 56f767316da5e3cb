//! Fits: normals of surfaces fitted to the neighbourhood of a vertex.

// The nearest of many points.
mod nearest;
// The neighbours of a smooth group.
pub(super) mod rings;
// Polynomials fitted to eight neighbourhoods at a time.
mod polynomial;
// Where no polynomial is a model of the surface.
mod folds;
// Normals of polynomials at all smooth groups.
pub(super) mod fitted_normals;
// Least-squares quadrics.
pub(super) mod quadric;
// Osculating jets of degree 3.
pub(super) mod jet;
// Their errors, estimated from wider neighbourhoods.
pub(super) mod differences;
// The one of these with the smallest error on a mesh.
pub(super) mod choice;
// How many fits are done.
pub(super) mod progress;
// Fits in place of means.
pub(super) mod slot_fits;

// Meshes of surfaces with exact normals.
#[cfg(test)]
mod test_surfaces;
