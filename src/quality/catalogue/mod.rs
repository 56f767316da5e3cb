//! Every finding there is: what it means for a picture, and what to do.
//!
//! `crease inspect --explain` and the pages of reports read from here.

mod geometry;
mod shading;
mod smoothing;
mod stored;

use crate::num::three_digits;
use crate::quality::finding::{Element, Severity};

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
    /// The cause in few words.
    pub title: &'static str,
    /// What is the case, how it is told from other causes, and what that means for a picture.
    pub meaning: &'static str,
    /// What to do.
    pub advice: &'static str,
    /// Options of `crease normals` that mend it; `None` if none does. A finding may have better ones.
    pub remedy: Option<&'static str>,
}

/// An entry; what it counts and is about follow from its kind.
const fn entry(
    kind: Kind,
    id: &'static str,
    severity: Severity,
    title: &'static str,
    meaning: &'static str,
    advice: &'static str,
    remedy: Option<&'static str>,
) -> Entry {
    let (element, family) = (kind.element(), kind.family());
    Entry { kind, id, severity, element, family, title, meaning, advice, remedy }
}

const FAMILIES: [&[Entry]; 4] = [stored::ENTRIES, smoothing::ENTRIES, geometry::ENTRIES, shading::ENTRIES];

/// All entries, in the order of [`Kind`].
pub fn entries() -> impl Iterator<Item = &'static Entry> {
    FAMILIES.into_iter().flatten()
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

    const fn element(self) -> Element {
        match self {
            Kind::NoNormals
            | Kind::NoFaces
            | Kind::Constant
            | Kind::SwappedAxes
            | Kind::Rotated
            | Kind::Untransformed
            | Kind::Faceted
            | Kind::Quantised
            | Kind::FarFromOrigin => Element::Mesh,
            Kind::Soft
            | Kind::AveragedCrease
            | Kind::SplitSeam
            | Kind::NeedlessSeam
            | Kind::CrackedSeam
            | Kind::GroupMismatch
            | Kind::NonManifold
            | Kind::Folded
            | Kind::MachBands
            | Kind::CoarseOutline => Element::Edge,
            Kind::DuplicateVertices | Kind::PinchedVertices | Kind::HighValence => Element::Vertex,
            Kind::MirroredNode | Kind::SingularNode => Element::Node,
            Kind::MissingNormals
            | Kind::NotFinite
            | Kind::ZeroNormals
            | Kind::NotUnit
            | Kind::LooseLength
            | Kind::Inverted
            | Kind::Flipped
            | Kind::AgainstFace
            | Kind::Stray
            | Kind::Custom
            | Kind::Tangents
            | Kind::MorphNormals
            | Kind::Cancelling
            | Kind::Terminator => Element::Corner,
            _ => Element::Face,
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
        entries().nth(self as usize).expect("an entry for every kind")
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
            for text in [entry.meaning, entry.advice] {
                assert!(text.len() > 10 && text.ends_with('.'), "{}: {text}", entry.id);
            }
        }
        assert_eq!(Kind::of_id("nothing"), None);
    }
}
