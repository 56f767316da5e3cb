//! Every finding there is: what it means for a picture, and what to do.
//!
//! `crease inspect --explain` and the pages of reports read from here.

use crate::num::three_digits;
use crate::quality::finding::{Element, Severity};
use crate::text::{Catalogue, Language, catalogue};

static TEXTS: Catalogue = catalogue!("catalogue", en);

/// A kind of finding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[allow(missing_docs, reason = "the catalogue has an entry for each: `Kind::entry`")]
pub enum Kind {
    NoNormals,
    MissingNormals,
    NotFinite,
    ZeroNormals,
    NotUnit,
    LooseLength,
    Inverted,
    Flipped,
    AgainstFace,
    Constant,
    SwappedAxes,
    Rotated,
    Untransformed,
    Stray,
    Custom,
    Faceted,
    Soft,
    Quantised,
    Tangents,
    MorphNormals,
    AveragedCrease,
    SplitSeam,
    NeedlessSeam,
    CrackedSeam,
    GroupMismatch,
    NoFaces,
    InconsistentWinding,
    NonOrientable,
    InsideOut,
    OpenInsideOut,
    Room,
    ZeroArea,
    BelowStorage,
    Needles,
    DuplicateFaces,
    BackToBack,
    DuplicateVertices,
    NonPlanar,
    Concave,
    Crossed,
    NonManifold,
    PinchedVertices,
    Folded,
    Cancelling,
    HighValence,
    FarFromOrigin,
    MirroredNode,
    SingularNode,
    Terminator,
    MachBands,
    CoarseOutline,
    LostHighlight,
}

/// The groups of findings.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Family {
    /// The normals that a file has.
    Stored,
    /// Which edges they are smooth over.
    Smoothing,
    /// Geometry that spoils normals.
    Geometry,
    /// What even right normals will show.
    Shading,
}

impl Family {
    /// The heading used in reports.
    pub const fn name(self) -> &'static str {
        match self {
            Family::Stored => "stored normals",
            Family::Smoothing => "smoothing",
            Family::Geometry => "geometry",
            Family::Shading => "shading risk",
        }
    }
}

/// What the catalogue says of a kind of finding.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// The kind.
    pub kind: Kind,
    /// The stable name, on the command line and in reports.
    pub id: &'static str,
    /// How much it matters at most; a finding may be less.
    pub severity: Severity,
    /// What it counts.
    pub element: Element,
    /// What it is about.
    pub family: Family,
    /// Options of `crease normals` that fix it; `None` if none does. A finding may have better ones.
    pub remedy: Option<&'static str>,
}

const fn entry(
    kind: Kind,
    id: &'static str,
    severity: Severity,
    element: Element,
    remedy: Option<&'static str>,
) -> Entry {
    Entry { kind, id, severity, element, family: kind.family(), remedy }
}

/// All entries, in the order of [`Kind`].
const ENTRIES: [Entry; Kind::COUNT] = [
    // The normals that a file stores.
    entry(Kind::NoNormals, "no-normals", Severity::Note, Element::Mesh, Some("")),
    entry(
        Kind::MissingNormals,
        "missing-normals",
        Severity::Warning,
        Element::Corner,
        Some("--when missing"),
    ),
    entry(Kind::NotFinite, "not-finite-normals", Severity::Error, Element::Corner, Some("--when broken")),
    entry(Kind::ZeroNormals, "zero-normals", Severity::Error, Element::Corner, Some("--when broken")),
    entry(Kind::NotUnit, "not-unit-normals", Severity::Warning, Element::Corner, Some("--when broken")),
    entry(Kind::LooseLength, "loose-length", Severity::Note, Element::Corner, Some("")),
    entry(Kind::Inverted, "inverted-normals", Severity::Error, Element::Corner, Some("")),
    entry(Kind::Flipped, "flipped-normals", Severity::Error, Element::Corner, Some("--when broken")),
    entry(
        Kind::AgainstFace,
        "normals-against-face",
        Severity::Warning,
        Element::Corner,
        Some("--when broken"),
    ),
    entry(Kind::Constant, "constant-normals", Severity::Warning, Element::Mesh, Some("")),
    entry(Kind::SwappedAxes, "swapped-axes", Severity::Error, Element::Mesh, Some("")),
    entry(Kind::Rotated, "rotated-normals", Severity::Error, Element::Mesh, Some("")),
    entry(Kind::Untransformed, "untransformed-normals", Severity::Error, Element::Mesh, Some("")),
    entry(Kind::Stray, "stray-normals", Severity::Warning, Element::Corner, Some("")),
    entry(Kind::Custom, "custom-normals", Severity::Note, Element::Corner, None),
    entry(Kind::Faceted, "faceted-normals", Severity::Note, Element::Mesh, Some("")),
    entry(Kind::Soft, "soft-normals", Severity::Warning, Element::Edge, Some("--crease 40")),
    entry(Kind::Quantised, "coarse-normals", Severity::Note, Element::Mesh, Some("")),
    entry(
        Kind::Tangents,
        "tangents-off-normals",
        Severity::Warning,
        Element::Corner,
        Some("--tangents regenerate"),
    ),
    entry(Kind::MorphNormals, "wrong-morph-normals", Severity::Warning, Element::Corner, Some("")),
    // The edges that they are smooth over.
    entry(Kind::AveragedCrease, "averaged-crease", Severity::Warning, Element::Edge, Some("")),
    entry(Kind::SplitSeam, "split-seam", Severity::Warning, Element::Edge, Some("")),
    entry(Kind::NeedlessSeam, "needless-seam", Severity::Note, Element::Edge, None),
    entry(Kind::CrackedSeam, "cracked-seam", Severity::Warning, Element::Edge, Some("")),
    entry(Kind::GroupMismatch, "group-mismatch", Severity::Note, Element::Edge, Some("--groups honour")),
    // Geometry that spoils normals.
    entry(Kind::NoFaces, "no-faces", Severity::Warning, Element::Mesh, None),
    entry(
        Kind::InconsistentWinding,
        "inconsistent-winding",
        Severity::Error,
        Element::Face,
        Some("--orient consistent"),
    ),
    entry(Kind::NonOrientable, "non-orientable", Severity::Warning, Element::Face, None),
    entry(Kind::InsideOut, "inside-out", Severity::Error, Element::Face, Some("--orient outward")),
    entry(Kind::OpenInsideOut, "open-inside-out", Severity::Warning, Element::Face, Some("--orient outward")),
    entry(Kind::Room, "room", Severity::Note, Element::Face, None),
    entry(Kind::ZeroArea, "zero-area-faces", Severity::Note, Element::Face, Some("--degenerate drop")),
    entry(Kind::BelowStorage, "faces-below-storage", Severity::Note, Element::Face, None),
    entry(Kind::Needles, "needle-faces", Severity::Note, Element::Face, None),
    entry(Kind::DuplicateFaces, "duplicate-faces", Severity::Warning, Element::Face, None),
    entry(Kind::BackToBack, "back-to-back-faces", Severity::Note, Element::Face, None),
    entry(Kind::DuplicateVertices, "duplicate-vertices", Severity::Note, Element::Vertex, None),
    entry(Kind::NonPlanar, "non-planar-polygons", Severity::Note, Element::Face, None),
    entry(Kind::Concave, "concave-polygons", Severity::Note, Element::Face, None),
    entry(Kind::Crossed, "crossed-polygons", Severity::Warning, Element::Face, None),
    entry(Kind::NonManifold, "non-manifold-edges", Severity::Note, Element::Edge, None),
    entry(Kind::PinchedVertices, "pinched-vertices", Severity::Note, Element::Vertex, None),
    entry(Kind::Folded, "folded-edges", Severity::Note, Element::Edge, None),
    entry(Kind::Cancelling, "cancelling-fans", Severity::Warning, Element::Corner, None),
    entry(Kind::HighValence, "high-valence-poles", Severity::Note, Element::Vertex, None),
    entry(Kind::FarFromOrigin, "far-from-origin", Severity::Warning, Element::Mesh, None),
    entry(Kind::MirroredNode, "mirrored-node", Severity::Note, Element::Node, None),
    entry(Kind::SingularNode, "singular-node", Severity::Warning, Element::Node, None),
    // Effects that even correct normals show.
    entry(Kind::Terminator, "shading-terminator", Severity::Note, Element::Corner, None),
    entry(Kind::MachBands, "mach-bands", Severity::Note, Element::Edge, None),
    entry(Kind::CoarseOutline, "coarse-outline", Severity::Note, Element::Edge, None),
    entry(Kind::LostHighlight, "lost-highlight", Severity::Note, Element::Face, None),
];

/// All entries, in the order of [`Kind`].
pub fn entries() -> impl Iterator<Item = &'static Entry> {
    ENTRIES.iter()
}

impl Entry {
    /// The cause in few words.
    pub fn title(&self) -> String {
        self.text("title")
    }

    /// What the finding means, how it is distinguished from other causes, and what a picture shows.
    pub fn meaning(&self) -> String {
        self.text("meaning")
    }

    /// What to do.
    pub fn advice(&self) -> String {
        self.text("advice")
    }

    fn text(&self, part: &str) -> String {
        TEXTS.get(&format!("{}-{part}", self.id)).get(Language::English).to_owned()
    }
}

impl Kind {
    /// How many kinds there are.
    pub(super) const COUNT: usize = Kind::LostHighlight as usize + 1;

    /// Kinds stand in the order of their families.
    const fn family(self) -> Family {
        match self as usize {
            number if number < Kind::AveragedCrease as usize => Family::Stored,
            number if number < Kind::NoFaces as usize => Family::Smoothing,
            number if number < Kind::Terminator as usize => Family::Geometry,
            _ => Family::Shading,
        }
    }

    /// What follows the number that says how bad it is, where that is no angle; of needles less is worse.
    pub const fn unit(self) -> Option<&'static str> {
        match self {
            Kind::Needles => Some("times as wide as long"),
            Kind::NonManifold => Some("faces at an edge"),
            Kind::HighValence => Some("faces at a vertex"),
            Kind::MachBands => Some("grey steps a pixel"),
            Kind::CoarseOutline => Some("pixels"),
            _ => None,
        }
    }

    /// That number as it is told: whole where it counts, three digits where it measures.
    pub fn write_amount(self, amount: f64) -> String {
        match self {
            Kind::NonManifold | Kind::HighValence => format!("{amount}"),
            _ => three_digits(amount),
        }
    }

    /// What the catalogue says of it.
    pub fn entry(self) -> &'static Entry {
        &ENTRIES[self as usize]
    }

    /// The stable name, on the command line and in reports.
    pub fn id(self) -> &'static str {
        self.entry().id
    }

    /// The kind with this name.
    pub fn of_id(id: &str) -> Option<Kind> {
        entries().find(|entry| entry.id == id).map(|entry| entry.kind)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn every_kind_has_one_entry_in_its_place() {
        assert_eq!(entries().count(), Kind::COUNT);
        let mut ids = BTreeSet::new();
        for (number, entry) in entries().enumerate() {
            assert_eq!(entry.kind as usize, number, "{}", entry.id);
            assert!(ids.insert(entry.id), "{} stands twice", entry.id);
            assert_eq!(Kind::of_id(entry.id), Some(entry.kind));
            assert!(entry.id.chars().all(|c| c.is_ascii_lowercase() || c == '-'), "{}", entry.id);
            for text in [entry.meaning(), entry.advice()] {
                assert!(text.len() > 10 && text.ends_with('.'), "{}: {text}", entry.id);
            }
        }
        assert_eq!(Kind::of_id("nothing"), None);
    }
}
