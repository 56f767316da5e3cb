//! A part of a file and what surrounds it: everything that is known before its normals are judged.

// The file of a part, and normals at positions that parts share.
pub(crate) mod file;
// Faces at the same positions as others.
pub(crate) mod duplicates;
// Mesh, topology, faces and stored normals of a part.
pub(crate) mod part;
