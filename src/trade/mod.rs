//! Accuracy against speed, measured, and the extremes (layer 5).
//!
//! *Which vertex normals should I use?* is answered with numbers: errors against surfaces whose normals are known, beside
//! what they cost; the same for ways to store normals, to shade with them, and for the approximations that this crate's own
//! code makes. Errors are the same bits at any number of threads; times are of the machine, as ratios to a plain loop that
//! ran in between. Module `stress` asks what happens where numbers end.

mod advice;
mod angles;
mod approximations;
mod baseline;
mod cases;
mod cost;
mod effort;
mod encodings;
#[cfg(any(test, feature = "stress"))]
pub(crate) mod exact;
mod own;
mod precision;
mod shading;
mod solids;
#[cfg(feature = "stress")]
pub mod stress;
mod summary;
mod timing;
mod vertex;

pub use advice::advice;
pub use angles::{AngleErrors, Histogram, angle_between, order_of_convergence};
pub use approximations::{ApproximationRow, approximation_rows};
pub use baseline::plain_vertex_normals;
pub use cases::{Subject, Tiling};
pub use cost::{CostRow, Costs, Way};
pub use effort::{Effort, Observer, Progress};
pub use encodings::{DIRECTIONS, EncodingRow, direction, encoding_error, encoding_rows};
pub use own::{OwnMesh, OwnMethod, estimate_map};
pub use precision::{PrecisionRow, precision_rows};
pub use shading::{ShadingRow, shading_rows};
pub use solids::{BoxRow, box_rows};
pub use summary::{ClassPoint, Trade, frontier};
pub use vertex::{MeshSize, MethodErrors, VertexCase, error_map, vertex_cases};
