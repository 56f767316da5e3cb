//! Creases: which edges are sharp, and which corners share a normal.

// Whether the dihedral angle exceeds the crease angle.
pub(super) mod dihedral_test;
// By how much rounding of the coordinates may change a dihedral angle.
pub(super) mod coordinate_rounding;
// Edges that are sharp at any angle.
pub(super) mod hard_edges;
// The fans of corners around a vertex.
pub(super) mod fans;
// Smooth groups: corners that share a normal.
pub(super) mod smooth_groups;
// The cone rule.
pub(super) mod cone;
// Chains of crease edges: scans have short ones.
pub(super) mod chains;
// Counts of edges by kind, for reports.
pub(super) mod edge_counts;
// Up to eight corners at a vertex of a triangle mesh, matched by vector instructions.
pub(super) mod spokes;
// Smooth groups of triangles, vertex by vertex.
pub(super) mod triangle_groups;
// The smooth groups that a recipe gives a mesh.
pub(super) mod grouping;
