//! All findings, and their texts: what they mean for a picture, and what to do.
//!
//! `crease inspect --explain` and the pages of reports read from here.

use crate::num::{names, three_digits};
use crate::quality::element::{Element, Severity};
use crate::text::{Catalogue, Text, catalogue};

static TEXTS: Catalogue = catalogue!("catalogue");

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

names! { Family:
    Stored = "stored normals", Smoothing = "smoothing", Geometry = "geometry", Shading = "shading risk",
}

/// The entry of a kind of finding.
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
}

/// Makes [`Kind`] and [`ENTRIES`] from one row for each finding: its kind, id, highest severity, element and remedy.
macro_rules! findings {
    ($($family:ident { $($kind:ident: $id:literal, $severity:ident, $element:ident, $remedy:expr;)* })*) => {
        /// A kind of finding.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[allow(missing_docs, reason = "the catalogue has an entry for each: `Kind::entry`")]
        pub enum Kind { $($($kind,)*)* }

        /// All entries, in the order of [`Kind`].
        static ENTRIES: &[Entry] = &[$($(Entry {
            kind: Kind::$kind,
            family: Family::$family,
            id: $id,
            severity: Severity::$severity,
            element: Element::$element,
            remedy: $remedy,
        },)*)*];
    };
}

findings! {
    Stored {
        NoNormals: "no-normals", Note, Mesh, Some("");
        MissingNormals: "missing-normals", Warning, Corner, Some("--when missing");
        NotFinite: "not-finite-normals", Error, Corner, Some("--when broken");
        ZeroNormals: "zero-normals", Error, Corner, Some("--when broken");
        NotUnit: "not-unit-normals", Warning, Corner, Some("--when broken");
        LooseLength: "loose-length", Note, Corner, Some("");
        Inverted: "inverted-normals", Error, Corner, Some("");
        Flipped: "flipped-normals", Error, Corner, Some("--when broken");
        AgainstFace: "normals-against-face", Warning, Corner, Some("--when broken");
        Constant: "constant-normals", Warning, Mesh, Some("");
        SwappedAxes: "swapped-axes", Error, Mesh, Some("");
        Rotated: "rotated-normals", Error, Mesh, Some("");
        Untransformed: "untransformed-normals", Error, Mesh, Some("");
        Outlier: "stray-normals", Warning, Corner, Some("");
        Custom: "custom-normals", Note, Corner, None;
        Faceted: "faceted-normals", Note, Mesh, Some("");
        Soft: "soft-normals", Warning, Edge, Some("--crease 40");
        Quantised: "coarse-normals", Note, Mesh, Some("");
        Tangents: "tangents-off-normals", Warning, Corner, Some("--tangents regenerate");
        MorphNormals: "wrong-morph-normals", Warning, Corner, Some("");
    }
    Smoothing {
        AveragedCrease: "averaged-crease", Warning, Edge, Some("");
        SplitSeam: "split-seam", Warning, Edge, Some("");
        NeedlessSeam: "needless-seam", Note, Edge, None;
        CrackedSeam: "cracked-seam", Warning, Edge, Some("");
        GroupMismatch: "group-mismatch", Note, Edge, Some("--groups honour");
    }
    Geometry {
        NoFaces: "no-faces", Warning, Mesh, None;
        InconsistentWinding: "inconsistent-winding", Error, Face, Some("--orient consistent");
        NonOrientable: "non-orientable", Warning, Face, None;
        InsideOut: "inside-out", Error, Face, Some("--orient outward");
        OpenInsideOut: "open-inside-out", Warning, Face, Some("--orient outward");
        Room: "room", Note, Face, None;
        ZeroArea: "zero-area-faces", Note, Face, Some("--degenerate drop");
        BelowStorage: "faces-below-storage", Note, Face, None;
        Needles: "needle-faces", Note, Face, None;
        DuplicateFaces: "duplicate-faces", Warning, Face, None;
        BackToBack: "back-to-back-faces", Note, Face, None;
        DuplicateVertices: "duplicate-vertices", Note, Vertex, None;
        NonPlanar: "non-planar-polygons", Note, Face, None;
        Concave: "concave-polygons", Note, Face, None;
        Crossed: "crossed-polygons", Warning, Face, None;
        NonManifold: "non-manifold-edges", Note, Edge, None;
        PinchedVertices: "pinched-vertices", Note, Vertex, None;
        Folded: "folded-edges", Note, Edge, None;
        Cancelling: "cancelling-fans", Warning, Corner, None;
        HighValence: "high-valence-poles", Note, Vertex, None;
        FarFromOrigin: "far-from-origin", Warning, Mesh, None;
        MirroredNode: "mirrored-node", Note, Node, None;
        SingularNode: "singular-node", Warning, Node, None;
    }
    Shading {
        Terminator: "shading-terminator", Note, Corner, None;
        MachBands: "mach-bands", Note, Edge, None;
        CoarseOutline: "coarse-outline", Note, Edge, None;
        LostHighlight: "lost-highlight", Note, Face, None;
    }
}

/// All entries, in the order of [`Kind`].
pub fn entries() -> impl Iterator<Item = &'static Entry> {
    ENTRIES.iter()
}

impl Entry {
    /// The cause in a few words.
    pub fn title(&self) -> Text {
        self.text("title")
    }

    /// What the finding means, how it is distinguished from other causes, and what a picture shows.
    pub fn meaning(&self) -> Text {
        self.text("meaning")
    }

    /// What to do.
    pub fn advice(&self) -> Text {
        self.text("advice")
    }

    fn text(&self, part: &str) -> Text {
        TEXTS.get(&format!("{}-{part}", self.id))
    }
}

impl Kind {
    /// The unit of the amount at the worst position, if it is not an angle; of needles less is worse.
    pub fn unit(self) -> Option<Text> {
        let key = [self.id(), "unit"].join("-");
        TEXTS.has(&key).then(|| TEXTS.get(&key))
    }

    /// That amount in words: whole if it counts, with three digits if it measures.
    pub fn write_amount(self, amount: f64) -> String {
        match self {
            Kind::NonManifold | Kind::HighValence => format!("{amount}"),
            _ => three_digits(amount),
        }
    }

    /// Its entry in the catalogue.
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
    use crate::text::Language;
    use std::collections::BTreeSet;

    #[test]
    fn every_kind_has_one_entry_in_its_place() {
        let mut ids = BTreeSet::new();
        for (number, entry) in entries().enumerate() {
            assert_eq!(entry.kind as usize, number, "{}", entry.id);
            assert!(ids.insert(entry.id), "{} stands twice", entry.id);
            assert_eq!(Kind::of_id(entry.id), Some(entry.kind));
            assert!(entry.id.chars().all(|c| c.is_ascii_lowercase() || c == '-'), "{}", entry.id);
            let texts = [entry.meaning(), entry.advice()];
            for text in texts.iter().flat_map(|text| Language::ALL.map(|language| text.get(language))) {
                assert!(text.len() > 10 && text.ends_with('.'), "{}: {text}", entry.id);
            }
        }
        assert_eq!(Kind::of_id("nothing"), None);
    }
}
