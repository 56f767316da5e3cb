//! From what one sees in a picture to findings, for `--explain`.

use crease::quality::catalogue::{Entry, entries};

/// What one sees, in the words of users, and the ids of the findings that cause it.
const SYMPTOMS: [(&str, &str); 15] = [
    (
        "black in viewer, black or flickering spots, nan",
        "not-finite-normals zero-normals flipped-normals missing-normals",
    ),
    (
        "dark from one side, inside out, inverted, lit from behind",
        "inverted-normals inside-out open-inside-out",
    ),
    (
        "missing faces, holes, invisible, transparent, see through",
        "inside-out open-inside-out inconsistent-winding",
    ),
    ("faceted, flat, polygons visible, not smooth", "faceted-normals no-normals coarse-outline"),
    ("soft or rounded edges, gradients on flat faces, smudges", "soft-normals averaged-crease"),
    ("seam, visible line, crack", "split-seam cracked-seam needless-seam"),
    (
        "dark or bright patches, spots, streaks",
        "stray-normals normals-against-face missing-normals cancelling-fans",
    ),
    ("highlights with steps, noise or banding", "coarse-normals"),
    ("bright or dark bands, mach bands", "mach-bands"),
    (
        "wrong light, lit from the wrong side",
        "swapped-axes rotated-normals untransformed-normals constant-normals mirrored-node",
    ),
    ("animated shapes, morph targets, blend shapes", "wrong-morph-normals"),
    ("normal map, tangents", "tangents-off-normals"),
    ("jagged outline, silhouette", "coarse-outline"),
    ("shadows break up, terminator", "shading-terminator"),
    ("missing highlight, dull", "lost-highlight"),
];

/// The findings that a word or a symptom means: by a part of the id, else by what one sees.
pub fn search(words: &str) -> Vec<&'static Entry> {
    let words = words.trim().to_lowercase();
    if words.is_empty() {
        return Vec::new();
    }
    let mut ids: Vec<&str> = SYMPTOMS
        .iter()
        .filter(|(seen, _)| words.split_whitespace().all(|word| seen.contains(word)))
        .flat_map(|(_, ids)| ids.split(' '))
        .collect();
    let id = words.replace(' ', "-");
    ids.extend(entries().map(|entry| entry.id).filter(|known| known.contains(&id)));
    entries().filter(|entry| ids.contains(&entry.id)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn findings_are_found_by_symptom() {
        for (_, ids) in SYMPTOMS {
            for id in ids.split(' ') {
                assert!(entries().any(|entry| entry.id == id), "{id}");
            }
        }
        let ids = |words| search(words).iter().map(|entry| entry.id).collect::<Vec<_>>();
        for (words, id) in [
            ("dark", "inverted-normals"),
            ("Faceted", "faceted-normals"),
            ("seam", "split-seam"),
            ("inside out", "inside-out"),
            ("black in viewer", "zero-normals"),
            ("winding", "inconsistent-winding"),
        ] {
            assert!(ids(words).contains(&id), "{words}: {:?}", ids(words));
        }
        assert!(ids("gibberish").is_empty() && ids(" ").is_empty());
    }
}
