//! Findings about what even right normals will show.

use crate::quality::catalogue::{Entry, Kind, entry};
use crate::quality::finding::Severity;

const fn risk(
    kind: Kind,
    id: &'static str,
    title: &'static str,
    meaning: &'static str,
    advice: &'static str,
) -> Entry {
    entry(kind, id, Severity::Note, title, meaning, advice, None)
}

pub(super) const ENTRIES: &[Entry] = &[
    risk(
        Kind::Terminator,
        "shading-terminator",
        "normals far from their face",
        "For every direction between the two, a light sees the shading normal but not the face, or the face but not the normal. Along the edge of the shadow the surface breaks into triangles.",
        "Use smaller faces there, or a crease.",
    ),
    risk(
        Kind::MachBands,
        "mach-bands",
        "smooth edges where the slope of brightness jumps",
        "Brightness interpolated over the two faces has a kink at the edge, which eyes see as a bright or dark line along it. Measured as the change of slope of a white matte surface under a key light 45° from the edge's normal, in 8-bit steps a pixel, with the mesh 512 pixels wide.",
        "Use more faces where it bends, or shade each pixel (Phong) instead of each vertex (Gouraud).",
    ),
    risk(
        Kind::CoarseOutline,
        "coarse-outline",
        "an outline with visible corners",
        "Where such an edge is seen against the background, its two faces cut the curve that the normals promise by more than the threshold, in pixels. The shading says round, the outline says polygon.",
        "Use more faces where it bends.",
    ),
    risk(
        Kind::LostHighlight,
        "lost-highlight",
        "faces too large for the highlight",
        "The normals at the corners of the face are further apart than the highlight of its material is wide. Computed at the corners only (Gouraud), it vanishes inside the face and jumps from corner to corner in motion.",
        "Shade each pixel (Phong), or use more faces.",
    ),
];
