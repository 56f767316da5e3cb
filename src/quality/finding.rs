//! What a diagnosis says: findings with causes, counts and places.

use crate::io::shell_word;
use crate::quality::catalogue::Kind;
use glam::DVec3;
use serde::Serialize;

/// How much a finding matters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Severity {
    /// Significance knowing; may well be meant.
    Note,
    /// Shows in pictures, in some light or some viewer.
    Warning,
    /// Wrong in any picture.
    Error,
}

impl Severity {
    /// All severities, from the least.
    pub const ALL: [Severity; 3] = [Severity::Note, Severity::Warning, Severity::Error];

    /// The name used on the command line and in reports.
    pub const fn name(self) -> &'static str {
        match self {
            Severity::Note => "note",
            Severity::Warning => "warning",
            Severity::Error => "error",
        }
    }
}

/// What a finding counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Element {
    /// Corners of faces.
    Corner,
    /// Faces.
    Face,
    /// Edges between two faces, each counted once.
    Edge,
    /// Vertices that faces use.
    Vertex,
    /// Places of a mesh in the world.
    Node,
    /// Whole meshes.
    Mesh,
}

impl Element {
    /// Whether it covers a part of the surface.
    pub(super) const fn has_area(self) -> bool {
        matches!(self, Element::Corner | Element::Face | Element::Mesh)
    }

    /// The name used in reports, in the singular.
    pub const fn name(self) -> &'static str {
        match self {
            Element::Corner => "corner",
            Element::Face => "face",
            Element::Edge => "edge",
            Element::Vertex => "vertex",
            Element::Node => "node",
            Element::Mesh => "mesh",
        }
    }
}

/// One of the places of a finding. All numbers count from 0, as the mesh was read.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Site {
    /// Which part of the file.
    pub part: usize,
    /// The face, if it is about one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub face: Option<u32>,
    /// Which corner of the face.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub corner: Option<u32>,
    /// The vertex.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub vertex: Option<u32>,
    /// Where that is, in the space of the part.
    #[serde(skip_serializing_if = "Option::is_none", serialize_with = "as_array")]
    pub position: Option<DVec3>,
    /// How far off it is, if that is an angle.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub degrees: Option<f64>,
    /// Which of the nodes that have the part, in their order, if it is about one.
    #[serde(skip)]
    pub place: Option<u32>,
    /// The way to the node that has the part, as `body/arm/hand`; to the first one if there are several (glTF).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub node: Option<String>,
    /// The line of the file that has the face, or the vertex where it is on no face (OBJ).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<u64>,
}

fn as_array<S: serde::Serializer>(position: &Option<DVec3>, serializer: S) -> Result<S::Ok, S::Error> {
    position.map(|position| position.to_array()).serialize(serializer)
}

/// Something that is wrong, or worth knowing, and where.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// What it is: the key to the [catalogue](crate::quality::catalogue).
    pub kind: Kind,
    /// How much it matters here.
    pub severity: Severity,
    /// The cause in words, with the numbers of this mesh.
    pub cause: String,
    /// How many elements.
    pub count: u64,
    /// Of how many.
    pub of: u64,
    /// Their share of the surface's area; a corner has its part of its face, and what has no area none.
    pub area_share: Option<f64>,
    /// The largest angle, in degrees, if an angle measures it.
    pub degrees: Option<f64>,
    /// What that angle does to the grey value under a key light at most ([`key_light_steps`](crate::quality::key_light_steps)); for
    /// normals that give no light, or too much, what that does. `None` where no normal is off.
    pub steps: Option<f64>,
    /// How bad it is at the worst place, in the [kind's unit](Kind::unit), if it has one.
    pub amount: Option<f64>,
    /// How sure it is, from ½ to 1, at the least sure place, where that is a question: which side of a surface is its
    /// outer one ([`Confidence`](crate::mesh::Confidence)).
    pub confidence: Option<f64>,
    /// The worst places, worst first: as many as [`Thresholds::places`](crate::quality::Thresholds::places).
    pub places: Vec<Site>,
    /// Options of `crease normals` that mend it; `None` if none does.
    pub remedy: Option<String>,
}

impl Finding {
    /// The share of elements that it concerns.
    pub fn share(&self) -> f64 {
        if self.of == 0 { 0.0 } else { self.count as f64 / self.of as f64 }
    }

    /// The command that mends it, for these names of input and output, which are quoted for a POSIX shell.
    ///
    /// ```
    /// use crease::io::{Format, ReadOptions, read_bytes};
    /// use crease::quality::{Thresholds, diagnose};
    ///
    /// let zero = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nf 1//1 2//1 3//1\n";
    /// let loaded = read_bytes(zero.to_vec(), Some(Format::Obj), None, &ReadOptions::default())?;
    /// let diagnosis = diagnose(&loaded, &Thresholds::default(), &|_| {});
    /// let command = diagnosis.findings[0].command("a.obj", "b.obj");
    /// assert_eq!(command.as_deref(), Some("crease normals a.obj -o b.obj --when broken"));
    /// # Ok::<(), crease::io::ReadError>(())
    /// ```
    pub fn command(&self, input: &str, output: &str) -> Option<String> {
        let options = self.remedy.as_ref()?;
        let space = if options.is_empty() { "" } else { " " };
        let [input, output] = [input, output].map(shell_word);
        Some(format!("crease normals {input} -o {output}{space}{options}"))
    }
}
