//! Options of readers and writers, and what a writer returns.

use super::Note;
use crate::mesh::{AxisConversion, Mesh};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

/// What a reader may do and how much it may take.
#[derive(Clone, Debug, Default)]
pub struct ReadOptions {
    /// Companion files (MTL, glTF buffers) may be read from this folder and below, in addition to the folder of the input itself;
    /// those of a stream are searched for here. Nothing is ever read from a network.
    pub root: Option<PathBuf>,
    /// What to do with positions that are infinite or not a number.
    pub non_finite: NonFinite,
    /// glTF extensions that a file may require although crease does not know them: they hold no vertices, indices or their order.
    pub allowed_extensions: Vec<String>,
    /// Bounds on the resources that a file may use.
    pub limits: Limits,
    /// Receives the files that are read, inputs and companions, if the caller keeps a copy.
    pub log: ReadLog,
}

/// The files that were read, inputs and companions. Copies share one list.
#[derive(Clone, Debug, Default)]
pub struct ReadLog(Arc<Mutex<BTreeSet<PathBuf>>>);

impl ReadLog {
    /// The files that were read so far.
    pub fn files(&self) -> BTreeSet<PathBuf> {
        self.0.lock().map(|found| found.clone()).unwrap_or_default()
    }

    pub(super) fn add(&self, path: &Path) {
        if let Ok(mut found) = self.0.lock() {
            found.insert(path.to_owned());
        }
    }
}

/// What to do with positions that are infinite or not a number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum NonFinite {
    /// Refuse the file and name the first such vertex.
    #[default]
    Refuse,
    /// Drop the faces that use one, and count them in [`Part::non_finite_faces`](super::Part::non_finite_faces).
    DropFaces,
}

/// Bounds on the resources that a file may use. Counts in a header never drive an allocation by themselves.
#[derive(Clone, Debug)]
pub struct Limits {
    /// Largest input, companion files counted, in bytes.
    pub bytes: u64,
    /// Deepest nesting of JSON values.
    pub json_depth: usize,
    /// Most elements of an accessor without stored data.
    pub implied_elements: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Self { bytes: 16 << 30, json_depth: 128, implied_elements: 1 << 22 }
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

/// What happens to tangents when normals change.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TangentPolicy {
    /// Compute them anew by MikkTSpace from the texture coordinates of the material's normal or anisotropy texture, also where the
    /// material needs tangents and there are none. Corners whose normals do not change keep theirs. Without coordinates they are
    /// made perpendicular to normals that turned by less than 30°, and otherwise removed with a warning.
    #[default]
    Auto,
    /// Leave them out, with a note; glTF readers then generate them, if there is a normal texture.
    Drop,
    /// Keep them unchanged.
    Keep,
    /// Compute all of them anew by MikkTSpace, also where normals do not change. Without coordinates they are removed with a warning.
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

/// How vertices and indices are compressed in a GLB.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MeshCompression {
    /// Not at all: every program can read them.
    #[default]
    None,
    /// Without loss by meshopt (`EXT_meshopt_compression`), which readers must know.
    Meshopt,
}

/// Which vertices are merged if they agree in everything that is stored of them. The first of equal ones stays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Merge {
    /// None.
    Off,
    /// In new files, those of meshes whose faces share no vertex: of STL, of glTF without indices, of PLY with three vertices a face.
    #[default]
    FacetWise,
    /// All, in new files and in glTF.
    Exact,
}

impl Merge {
    /// Whether vertices of a mesh are merged in a new file. Points and lines refer to vertices by number: with them, none are.
    pub(super) fn applies_to(self, mesh: &Mesh) -> bool {
        let is_wanted = match self {
            Self::Off => false,
            Self::FacetWise => mesh.is_facet_wise(),
            Self::Exact => mesh.face_count() > 0,
        };
        is_wanted && mesh.columns().points.is_empty() && mesh.columns().lines.is_empty()
    }
}

/// The material of faces without one in a new glTF, where a primitive without material would be a perfectly rough metal.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MaterialFallback {
    /// Light grey plastic of roughness 0.6, named `default`; white where vertices have colours, which multiply it.
    #[default]
    Plastic,
    /// None.
    Omit,
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
    /// Which vertices are merged.
    pub merge: Merge,
    /// The material of faces without one (new glTF).
    pub material: MaterialFallback,
    /// Other axes and units of a new file; files that are edited keep theirs.
    pub conversion: Option<AxisConversion>,
    /// Compression of the output (GLB).
    pub compression: MeshCompression,
    /// Omit normals where neither tangents nor normals of morph targets need them: such faces are flat (glTF).
    pub omit_normals: bool,
    /// Merge vertices that agree in everything that is stored of them, where that saves bytes. In a GLB also remove accessors, views
    /// and bytes that nothing uses.
    pub compact: bool,
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
    /// Files that belong with it.
    pub companions: Vec<OutputFile>,
    /// What could not be kept, and other notes.
    pub notes: Vec<Note>,
    /// Vertices in the output.
    pub vertices: u64,
    /// Vertices added by splitting.
    pub added_vertices: u64,
    /// Vertices fewer than before, by merging.
    pub merged_vertices: u64,
}

impl Written {
    /// Compares the number of vertices with that before.
    pub(super) fn count_change(&mut self, before: usize) {
        self.added_vertices = self.vertices.saturating_sub(before as u64);
        self.merged_vertices = (before as u64).saturating_sub(self.vertices);
    }
}

/// A file that belongs with the main output.
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
