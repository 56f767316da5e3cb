//! Smoothing: the edges across which stored normals are smooth.

// An edge with the stored normals on both sides.
pub(crate) mod edge;
// Averaged creases, seams, and edges against smoothing groups.
pub(crate) mod seams;
// Corners around a vertex that share a normal.
pub(crate) mod runs;
// Flat normals on a smooth shape.
pub(crate) mod facets;
// Smooth normals on a shape with sharp edges.
pub(crate) mod soft;
