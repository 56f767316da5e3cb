//! One mesh of a file: where it is placed, and the edit of it that a writer takes.

use crate::mesh::{Column, FaceEdit, Mesh};
use glam::{DMat4, DVec3};

/// One mesh of a file.
#[derive(Clone, Debug, Default)]
pub struct Part {
    /// Its name in the file, possibly empty.
    pub name: String,
    /// The mesh.
    pub mesh: Mesh,
    /// Faces that use a vertex without a finite position ([`NonFinite::DropFaces`](super::NonFinite::DropFaces)), ascending. They are still in
    /// `mesh`, with such vertices at the origin; the caller puts them into [`FaceEdit::dropped`].
    pub non_finite_faces: Vec<u32>,
}

/// A placement of a part in the world.
#[derive(Clone, Debug, PartialEq)]
pub struct FileNode {
    /// Its number in the file.
    pub number: usize,
    /// Name of the node, possibly empty.
    pub name: String,
    /// Which part.
    pub part: usize,
    /// From the part's space to the world's.
    pub world_from_part: DMat4,
}

/// What changes in one part.
///
/// `normals` refer to the corners of the part's mesh as it was read, including dropped and reversed faces.
#[derive(Clone, Debug, Default)]
pub struct PartEdit {
    /// Faces dropped and reversed. A reversed face's normals are given as they shall be written.
    pub faces: FaceEdit,
    /// The normals to write, one index a corner or per vertex; `None` leaves the stored ones alone, present or not.
    pub normals: Option<Column<DVec3>>,
    /// How many of `normals.values`, from the front, are the file's own values in the file's own order: a corner
    /// that refers to one of these keeps its stored bits. 0 when all are new.
    pub kept: usize,
    /// One normal a face, for formats and callers that want them ([`Emit::Face`](super::Emit::Face)).
    pub face_normals: Option<Vec<DVec3>>,
    /// Unit normals of each morph target's shape, in the order of `normals.values` (glTF).
    pub morph_normals: Vec<Vec<DVec3>>,
}

impl PartEdit {
    /// Whether the part does not change.
    pub fn is_empty(&self) -> bool {
        self.faces.is_empty() && self.normals.is_none() && self.face_normals.is_none()
    }
}
