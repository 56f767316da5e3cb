//! What a reader gives and what a writer takes.

use super::obj::ObjDocument;
use super::{Format, Note};
use crate::mesh::{Column, FaceEdit, Mesh};
use glam::{DMat4, DVec3};
use std::path::PathBuf;

/// What a reader may do and how much it may take.
#[derive(Clone, Debug, Default)]
pub struct ReadOptions {
    /// Companion files (MTL, glTF buffers) may be read from this folder and below, beside the folder of the input itself; those
    /// of a stream are looked for here. Nothing is ever read from a network.
    pub root: Option<PathBuf>,
    /// What to do with positions that are infinite or not a number.
    pub non_finite: NonFinite,
    /// Bounds on what a file may ask for.
    pub limits: Limits,
}

/// What to do with positions that are infinite or not a number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum NonFinite {
    /// Refuse the file and name the first such vertex.
    #[default]
    Refuse,
    /// Drop the faces that use one, and count them in [`Part::non_finite_faces`].
    DropFaces,
}

/// Bounds on what a file may make a reader do. Counts in a header never drive an allocation by themselves.
#[derive(Clone, Debug)]
pub struct Limits {
    /// Largest input, companion files counted, in bytes.
    pub bytes: u64,
    /// Deepest nesting of JSON values.
    pub json_depth: usize,
    /// Most elements that an accessor without stored data may stand for.
    pub implied_elements: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Self { bytes: 16 << 30, json_depth: 128, implied_elements: 1 << 22 }
    }
}

/// A file, read.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// The format that it was in.
    pub format: Format,
    /// Its meshes. OBJ and PLY have one, STL one a solid, glTF one a glTF mesh.
    pub parts: Vec<Part>,
    /// Where the meshes stand in the world; empty where the format has no such thing (each part then stands as
    /// it is, once).
    pub nodes: Vec<FileNode>,
    /// What was repaired, skipped or refused.
    pub notes: Vec<Note>,
    /// The document itself, for editing it in place.
    pub document: Document,
}

impl Loaded {
    /// The file as it is good for looking at alone, in less memory: without the bytes of PLY and STL and without the text of
    /// OBJ, but for [which lines are what](super::obj::ObjDocument::lines). STL, in which each facet repeats its vertices, has
    /// one vertex for each place. The document of glTF stays: attributes are read from it when they are asked for.
    ///
    /// OBJ, PLY and STL can then not be [written](super::write) in their own format, which edits the document.
    ///
    /// ```
    /// use crease::io::{Format, ReadOptions, WriteOptions, read_bytes, write};
    ///
    /// let facet = "facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet ";
    /// let text = format!("solid\n{facet}{facet}endsolid");
    /// let loaded = read_bytes(text.into_bytes(), Some(Format::Stl), None, &ReadOptions::default())?;
    /// assert_eq!(loaded.parts[0].mesh.vertex_count(), 6);
    /// let loaded = loaded.without_source();
    /// assert_eq!(loaded.parts[0].mesh.vertex_count(), 3);
    /// assert!(write(&loaded, &[], Format::Stl, &WriteOptions::default()).is_err());
    /// # Ok::<(), crease::io::ReadError>(())
    /// ```
    pub fn without_source(mut self) -> Self {
        match &mut self.document {
            Document::Obj(document) => document.forget_text(),
            Document::Ply(_) | Document::Stl(_) => self.document = Document::None,
            Document::Gltf(_) | Document::None => {}
        }
        if self.format == Format::Stl {
            for part in &mut self.parts {
                part.mesh = std::mem::take(&mut part.mesh).with_shared_vertices();
            }
        }
        self
    }

    /// Where each part stands in the world: nowhere, if no node has it; once and as it is, if there are no nodes at all.
    pub(crate) fn places(&self) -> Vec<Vec<DMat4>> {
        if self.nodes.is_empty() {
            return vec![vec![DMat4::IDENTITY]; self.parts.len()];
        }
        let mut places = vec![Vec::new(); self.parts.len()];
        self.nodes.iter().for_each(|node| places[node.part].push(node.world_from_part));
        places
    }
}

/// One mesh of a file.
#[derive(Clone, Debug, Default)]
pub struct Part {
    /// Its name in the file, possibly empty.
    pub name: String,
    /// The mesh.
    pub mesh: Mesh,
    /// Faces that use a vertex without a finite position ([`NonFinite::DropFaces`]), ascending. They are still in
    /// `mesh`, with such vertices at the origin; the caller puts them into [`FaceEdit::dropped`].
    pub non_finite_faces: Vec<u32>,
}

/// A place at which a part stands in the world.
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

/// A document kept for editing. Its content is private to the readers and writers of its format.
#[derive(Clone, Debug)]
pub enum Document {
    /// Nothing kept: the file can only be written as new.
    None,
    /// An OBJ file.
    Obj(Box<ObjDocument>),
    /// glTF, in either spelling.
    Gltf(Box<super::gltf::GltfDocument>),
    /// A PLY file.
    Ply(Box<super::ply::PlyDocument>),
    /// An STL file.
    Stl(Box<super::stl::StlDocument>),
}

/// What changes in one part.
///
/// `normals` refer to the corners of the part's mesh as it was read, dropped and reversed faces included.
#[derive(Clone, Debug, Default)]
pub struct PartEdit {
    /// Faces dropped and turned round. A reversed face's normals are given as they shall be written.
    pub faces: FaceEdit,
    /// The normals to write, one index a corner or per vertex; `None` leaves the stored ones alone, present or not.
    pub normals: Option<Column<DVec3>>,
    /// How many of `normals.values`, from the front, are the file's own values in the file's own order: a corner
    /// that refers to one of these keeps its stored bits. 0 when all are new.
    pub kept: usize,
    /// One normal a face, for formats and callers that want them ([`Emit::Face`]).
    pub face_normals: Option<Vec<DVec3>>,
    /// Unit normals of each morph target's shape, in the order of `normals.values` (glTF).
    pub morph_normals: Vec<Vec<DVec3>>,
}

impl PartEdit {
    /// Whether the part stays as it is.
    pub fn is_empty(&self) -> bool {
        self.faces.is_empty() && self.normals.is_none() && self.face_normals.is_none()
    }
}

/// Which normals an output carries.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Emit {
    /// One per corner, shared where equal.
    #[default]
    Corner,
    /// One per vertex.
    Vertex,
    /// One per face.
    Face,
}

/// What becomes of tangents when normals change.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TangentPolicy {
    /// Leave them out and say so; glTF readers then generate them.
    #[default]
    Drop,
    /// Keep them as they are.
    Keep,
    /// Make them again by MikkTSpace where texture coordinates allow.
    Regenerate,
}

/// How glTF normals are stored.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum NormalFormat {
    /// As they were, `f32` where there were none.
    #[default]
    Same,
    /// 32-bit floats.
    F32,
    /// Normalised 16-bit integers (`KHR_mesh_quantization`).
    I16,
    /// Normalised 8-bit integers (`KHR_mesh_quantization`).
    I8,
}

/// How to write.
#[derive(Clone, Debug, Default)]
pub struct WriteOptions {
    /// Which normals.
    pub emit: Emit,
    /// Tangents (glTF).
    pub tangents: TangentPolicy,
    /// Storage of normals (glTF).
    pub normal_format: NormalFormat,
    /// File name without extension of the output, for naming companion files; `None` when writing to a stream,
    /// where everything must fit into one file.
    pub stem: Option<String>,
    /// The folder of the output, if it is known. Files outside it that the input refers to need no copy if the
    /// output's own reference leads to them too.
    pub folder: Option<PathBuf>,
}

/// An output, ready to be stored.
#[derive(Clone, Debug, Default)]
pub struct Written {
    /// The file itself.
    pub bytes: Vec<u8>,
    /// Files that belong beside it.
    pub companions: Vec<OutputFile>,
    /// What could not be kept, and other remarks.
    pub notes: Vec<Note>,
    /// Vertices in the output.
    pub vertices: u64,
    /// Vertices added by splitting.
    pub added_vertices: u64,
}

/// A file that belongs beside the main output.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OutputFile {
    /// Path relative to the main output's folder.
    pub name: String,
    /// Its content.
    pub content: OutputContent,
}

/// Where a companion's bytes are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum OutputContent {
    /// New bytes.
    Bytes(Vec<u8>),
    /// A copy of this file, which the input refers to; nothing to do when both are the same file.
    CopyOf(PathBuf),
}
