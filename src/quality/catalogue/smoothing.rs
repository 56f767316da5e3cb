//! Findings about which edges normals are smooth over.

use crate::quality::catalogue::{Entry, Kind, entry};
use crate::quality::finding::Severity;

pub(super) const ENTRIES: &[Entry] = &[
    entry(
        Kind::AveragedCrease,
        "averaged-crease",
        Severity::Warning,
        "sharp edges with one normal on both sides",
        "Edges that bend as much as those that the mesh keeps sharp share their normals: both faces are shaded as if the edge were round. Flat faces show a gradient towards it, and the corner looks inflated. A note where the normals follow no rule, not even two in five of them to the letter, or where more than one in fifty of the ends of edges that bend is on the wrong side of the crease angle: they may be made by hand; and where there are fewer than eight and no other edge is kept sharp: on a smooth shape it is the faces that came out badly.",
        "Compute normals with a crease angle below the bend of these edges.",
        Some(""),
    ),
    entry(
        Kind::SplitSeam,
        "split-seam",
        Severity::Warning,
        "smooth edges with different normals on their two sides",
        "The edge bends less than those that the mesh keeps smooth, yet its sides have normals of their own, at both ends further apart than `--seam` allows: at a uv seam, between two primitives, or after pieces were joined. A line shows where the surface has none. A note where the normals follow no rule, not even two in five of them to the letter, or where more than one in fifty of the ends of edges that bend is on the wrong side of the crease angle and split edges bend by more than most others: they may be made by hand.",
        "Compute normals; coincident edges are joined for smoothing, and vertices stay apart.",
        Some(""),
    ),
    entry(
        Kind::NeedlessSeam,
        "needless-seam",
        Severity::Note,
        "seams whose two sides have the same normal",
        "Position, normal and texture coordinates are equal on both sides, but the vertices are two. No picture shows it, so its angle is 0; it costs memory, and tools that go by indices see a rim there and will not smooth over it.",
        "Merge the vertices with a tool that does; normals need nothing.",
        None,
    ),
    entry(
        Kind::CrackedSeam,
        "cracked-seam",
        Severity::Warning,
        "edges that miss each other by the rounding of their vertices",
        "Two open edges, each at both ends closer to the other than a millionth of the bounding box's diagonal and not at equal places, as when positions were printed with few digits or pieces were moved by different matrices. What goes by equal places, as `crease normals` without `--weld` does, sees a rim there and shades the two sides apart: a line shows where the surface goes on. Reported where the stored normals of such edges differ, as a warning or a note like `split-seam`; as a note where none are stored, by the bend of the edge.",
        "Compute normals with such edges joined; vertices stay where they are.",
        Some(""),
    ),
    entry(
        Kind::GroupMismatch,
        "group-mismatch",
        Severity::Note,
        "smoothing groups and stored normals disagree",
        "The groups say smooth where the normals are split, or sharp where they are shared. A program that goes by groups shows another shape than one that goes by normals.",
        "Compute normals from the groups, or leave the groups out.",
        Some("--groups honour"),
    ),
];
