//! A part of a file and what surrounds it: everything that is known before its normals are judged.

// Normals of parts at positions that they share.
pub(crate) mod borders;
// The file of a part.
pub(crate) mod file;
// Faces at the same positions as others.
pub(crate) mod duplicates;
// Faces that disagree with their neighbours or face inwards.
pub(crate) mod winding;
// Mesh, topology, faces and stored normals of a part.
pub(crate) mod part;
