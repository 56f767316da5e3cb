//! Stored: the normals of the file, corner by corner.

// The surroundings of a part in its file.
pub(super) mod neighbours;
// Normals of parts where they meet.
pub(super) mod borders;
// Facts shared by the corners around a vertex.
pub(super) mod vertex_fans;
// Regions whose normals follow another weighting.
pub(super) mod regions;
// Normals that were edited gradually within a surface.
pub(super) mod gradual_edits;
// Normals far from those of the weighting.
pub(super) mod outliers;
// Normals in another space of the node tree.
pub(super) mod coordinate_space;
// Normals rotated or reflected as a whole.
pub(super) mod rotated;
// Tangents and normals of morph targets.
pub(super) mod attributes;
// Findings about stored normals.
pub(super) mod stored_findings;
