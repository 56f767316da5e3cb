//! Accuracy against speed, measured, and the numerical extremes (layer 5).
//!
//! *Which vertex normals should I use?* is answered with numbers: errors on surfaces whose normals are known, and costs; the
//! same for encodings of normals, for shading with them, and for the approximations that this crate uses itself. Errors are
//! the same bits at any number of threads; times depend on the machine and are ratios to a plain loop that ran in the same
//! measurement. Module `stress` tests the limits of floating-point numbers.

// Enumerations whose variants have a name and a description.
mod described;
// How much is measured, progress, and times that can be compared.
mod effort;
// Histograms of angles between normals, and orders of convergence.
mod angles;
// Surfaces, tilings, and meshes with their true normals.
mod cases;
// Errors of every weight on surfaces.
mod vertex;
// Costs of every weight.
mod cost;
// Error against cost on each class of meshes, and the Pareto frontier.
mod frontier;
// Dependence on the triangulation of flat faces.
mod solids;
// Single precision compared with faithful.
mod precision;
// Normals in few bits.
mod encodings;
// Ways to shade.
mod shading;
// The crate's own approximations.
mod approximations;
// The whole measurement.
mod summary;
// Advice from its numbers.
mod advice;
// Normals that replace the unknown true ones of a user mesh.
mod reference;
// All weights on a user mesh.
mod own;
// Which of them to use, and how certain that is.
mod own_advice;
// Exact references in integers and 256 bits.
#[cfg(any(test, feature = "stress"))]
pub(crate) mod exact;
// The numerical extremes.
#[cfg(feature = "stress")]
pub mod stress;

pub use advice::advice;
pub use angles::{AngleErrors, Histogram, angle_between, order_of_convergence};
pub use approximations::{ApproximationRow, approximation_rows};
pub use cases::{NamedSurface, Tiling};
pub use cost::{CostRow, Costs, Way, plain_vertex_normals};
pub use effort::{Effort, Observer, Progress};
pub use encodings::{DIRECTIONS, EncodingRow, direction, encoding_error, encoding_rows};
pub use frontier::{ClassPoint, MeshClass, frontier, mark_dominated};
pub use own::{OwnMesh, OwnMethod, Truth};
pub use precision::{PrecisionRow, precision_rows};
pub use reference::{Reference, error_maps};
pub use shading::{ShadingRow, shading_rows};
pub use solids::{BoxRow, box_rows};
pub use summary::Trade;
pub use vertex::{MeshSize, MethodErrors, VertexCase, error_map, vertex_cases};
