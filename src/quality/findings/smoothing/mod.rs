//! Smoothing: the edges across which stored normals are smooth.

// Edges with the stored normals on both sides, and corners around a vertex that share one.
pub(crate) mod edge;
// Averaged creases, seams, and edges against smoothing groups.
pub(crate) mod seams;
// Flat normals on a smooth shape, smooth ones on a sharp shape.
pub(crate) mod sharpness;
