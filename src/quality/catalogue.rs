//! All findings, and their texts: what they mean for a picture, and what to do.
//!
//! `crease inspect --explain` and the pages of reports read from here.

use crate::num::three_digits;
use crate::quality::definition::Definition;
use crate::quality::element::{Element, Severity};
use crate::quality::findings::geometry::{
    duplicates, edges, far_from_origin, nodes, polygons, slivers, vertices,
};
use crate::quality::findings::shading::interpolation;
use crate::quality::findings::smoothing::{facets, seams, soft};
use crate::quality::findings::storage::quantisation;
use crate::quality::findings::stored::{attributes, coordinate_space, deviations, rotated, values};
use crate::quality::findings::winding::{components, neighbours};
use crate::text::{Catalogue, Language, catalogue};

static TEXTS: Catalogue = catalogue!("catalogue", en);

/// The groups of findings.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Family {
    /// The normals that a file has.
    Stored,
    /// Which edges they are smooth over.
    Smoothing,
    /// Geometry that spoils normals.
    Geometry,
    /// What even correct normals show.
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
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// The kind.
    pub kind: Kind,
    /// What it is about.
    pub family: Family,
    /// The stable name, on the command line and in reports.
    pub id: &'static str,
    /// The highest severity; a finding may be less severe.
    pub severity: Severity,
    /// What it counts.
    pub element: Element,
    /// Options of `crease normals` that fix it; `None` if none does. A finding may have better ones.
    pub remedy: Option<&'static str>,
    pub(crate) definition: &'static Definition,
}

/// Makes [`Kind`] and [`ENTRIES`] from one line for each finding: its kind and its definition, by family.
macro_rules! findings {
    ($($family:ident { $($kind:ident: $definition:path,)* })*) => {
        /// A kind of finding.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[allow(missing_docs, reason = "the catalogue has an entry for each: `Kind::entry`")]
        pub enum Kind { $($($kind,)*)* }

        /// All entries, in the order of [`Kind`].
        static ENTRIES: &[Entry] =
            &[$($(Entry::new(Kind::$kind, Family::$family, &$definition),)*)*];
    };
}

findings! {
    Stored {
        NoNormals: values::NO_NORMALS,
        MissingNormals: values::MISSING_NORMALS,
        NotFinite: values::NOT_FINITE,
        ZeroNormals: values::ZERO_NORMALS,
        NotUnit: values::NOT_UNIT,
        LooseLength: values::LOOSE_LENGTH,
        Inverted: deviations::INVERTED,
        Flipped: deviations::FLIPPED,
        AgainstFace: deviations::AGAINST_FACE,
        Constant: rotated::CONSTANT,
        SwappedAxes: rotated::SWAPPED_AXES,
        Rotated: rotated::ROTATED,
        Untransformed: coordinate_space::UNTRANSFORMED,
        Stray: deviations::OUTLIERS,
        Custom: deviations::CUSTOM,
        Faceted: facets::FACETED,
        Soft: soft::SOFT,
        Quantised: quantisation::QUANTISED,
        Tangents: attributes::TANGENTS,
        MorphNormals: attributes::MORPH_NORMALS,
    }
    Smoothing {
        AveragedCrease: seams::AVERAGED_CREASE,
        SplitSeam: seams::SPLIT_SEAM,
        NeedlessSeam: seams::NEEDLESS_SEAM,
        CrackedSeam: seams::CRACKED_SEAM,
        GroupMismatch: seams::GROUP_MISMATCH,
    }
    Geometry {
        NoFaces: nodes::NO_FACES,
        InconsistentWinding: neighbours::INCONSISTENT_WINDING,
        NonOrientable: neighbours::NON_ORIENTABLE,
        InsideOut: components::INSIDE_OUT,
        OpenInsideOut: components::OPEN_INSIDE_OUT,
        Room: components::ROOM,
        ZeroArea: slivers::ZERO_AREA,
        BelowStorage: slivers::BELOW_STORAGE,
        Needles: slivers::NEEDLES,
        DuplicateFaces: duplicates::DUPLICATE_FACES,
        BackToBack: duplicates::BACK_TO_BACK,
        DuplicateVertices: duplicates::DUPLICATE_VERTICES,
        NonPlanar: polygons::NON_PLANAR,
        Concave: polygons::CONCAVE,
        Crossed: polygons::CROSSED,
        NonManifold: edges::NON_MANIFOLD,
        PinchedVertices: vertices::PINCHED_VERTICES,
        Folded: edges::FOLDED,
        Cancelling: vertices::CANCELLING,
        HighValence: vertices::HIGH_VALENCE,
        FarFromOrigin: far_from_origin::FAR_FROM_ORIGIN,
        MirroredNode: nodes::MIRRORED_NODE,
        SingularNode: nodes::SINGULAR_NODE,
    }
    Shading {
        Terminator: interpolation::TERMINATOR,
        MachBands: interpolation::MACH_BANDS,
        CoarseOutline: interpolation::COARSE_OUTLINE,
        LostHighlight: interpolation::LOST_HIGHLIGHT,
    }
}

/// All entries, in the order of [`Kind`].
pub fn entries() -> impl Iterator<Item = &'static Entry> {
    ENTRIES.iter()
}

impl Entry {
    const fn new(kind: Kind, family: Family, definition: &'static Definition) -> Self {
        let Definition { id, severity, element, remedy, .. } = *definition;
        Self { kind, family, id, severity, element, remedy, definition }
    }

    /// The cause in a few words.
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
    /// The unit of the amount at the worst position, if it is not an angle; of needles less is worse.
    pub fn unit(self) -> Option<&'static str> {
        self.entry().definition.unit
    }

    /// That amount in words: whole if it counts, with three digits if it measures.
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
