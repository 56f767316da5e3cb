//! The file formats, by name and by content.

use std::fmt;
use std::path::Path;

/// A mesh file format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Format {
    /// Wavefront OBJ.
    Obj,
    /// Polygon file format, ascii or binary.
    Ply,
    /// Stereolithography, ascii or binary.
    Stl,
    /// glTF 2.0 as JSON.
    Gltf,
    /// glTF 2.0 in its binary container.
    Glb,
    /// 3D Manufacturing Format, which is read only.
    #[serde(rename = "3mf")]
    ThreeMf,
}

impl Format {
    /// All formats.
    pub const ALL: [Format; 6] =
        [Format::Obj, Format::Ply, Format::Stl, Format::Gltf, Format::Glb, Format::ThreeMf];

    /// Those that are written. 3MF has no normals.
    pub const WRITTEN: [Format; 5] = [Format::Obj, Format::Ply, Format::Stl, Format::Gltf, Format::Glb];

    /// The usual file name extension, without the dot.
    pub fn extension(self) -> &'static str {
        match self {
            Format::Obj => "obj",
            Format::Ply => "ply",
            Format::Stl => "stl",
            Format::Gltf => "gltf",
            Format::Glb => "glb",
            Format::ThreeMf => "3mf",
        }
    }

    /// The format of a path's extension, upper or lower case.
    pub fn from_path(path: &Path) -> Option<Format> {
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        Format::ALL.into_iter().find(|format| format.extension() == extension)
    }

    /// Whether it is one of the two spellings of glTF.
    pub fn is_gltf(self) -> bool {
        matches!(self, Format::Gltf | Format::Glb)
    }

    /// Whether writing this format edits the document of a file that was read in the other one.
    pub fn edits(self, read: Format) -> bool {
        self == read || self.is_gltf() && read.is_gltf()
    }
}

impl fmt::Display for Format {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(self.extension())
    }
}
