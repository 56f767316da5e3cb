//! A polygon mesh and its topology (layer 1).

// Faces as polygons of any size.
mod faces;
// Optional attributes.
mod columns;
// What a half-edge meets, in four bytes.
mod link;
// Positions in single or double precision.
mod positions;
// The mesh, and the builder that checks it.
mod polygon_mesh;
// The corners at each vertex.
mod rings;
// Half-edges matched to edges.
mod edge_matching;
// Union-find.
mod disjoint_sets;
// Boxes, and a tree of them.
mod box_tree;
// Points connected by short steps, by a k-d tree.
mod point_clusters;
// Vertices split where corners differ, and merged where they agree.
mod vertices;
// Which faces meet at which edges.
mod topology;
// Boundary edges joined by position.
mod weld;
// Vector areas of faces, and stored normals compared with them.
mod face_normals;
// Faces dropped and reversed.
mod face_edit;
// Affine maps.
mod transform;
// Up axes and units.
mod axes;
// Polygons cut into triangles.
mod triangulate;
// Rays through a mesh.
mod obstacles;
// Consistent and outward orientation.
mod orient;

pub use axes::{AxisConversion, UpAxis};
pub use columns::{Column, ColumnIndex, Columns, FaceLabels, NONE, SmoothingGroups};
pub(crate) use disjoint_sets::DisjointSets;
pub(crate) use edge_matching::EdgeMatcher;
pub use face_edit::FaceEdit;
pub(crate) use face_normals::{are_same, normals_oppose, stored_unit, vector_area};
pub use faces::Faces;
pub(crate) use faces::{FacesRef, next_in_triangle};
pub use link::Link;
pub(crate) use link::MAX_CORNERS;
#[cfg(feature = "report")]
pub(crate) use obstacles::Obstacles;
pub use orient::{Confidence, Orient, Orientation, orient};
pub(crate) use orient::{Orientations, Placed, cavities};
pub use polygon_mesh::{Mesh, MeshBuilder, MeshError};
pub use positions::{PositionIter, Positions, PositionsRef, Storage};
pub(crate) use rings::{Rings, Scatter};
pub use topology::Topology;
pub use transform::{NormalMatrix, TransformFault, normal_matrix};
pub use triangulate::{Triangulation, triangulate};
pub(crate) use vertices::merge::{SplitView, first_positions, place_key};
pub use vertices::near::Movement;
pub use vertices::split::{VertexSplit, split_vertices};
pub use weld::Weld;
pub(crate) use weld::joins_no_edges;
