//! From what one sees in a picture to findings, for `--explain`.

use crease::quality::catalogue::{Entry, entries};

/// What one sees, in the words of users, and the ids of the findings that cause it.
const SYMPTOMS: [(&str, &str); 15] = [
    (
        "black in viewer, black or flickering spots, nan",
        "not-finite-normals zero-normals flipped-normals missing-normals inverted-normals cancelling-fans singular-node",
    ),
    (
        "dark from one side, inside out, inverted, lit from behind",
        "inverted-normals inside-out open-inside-out",
    ),
    (
        "missing faces, holes, invisible, transparent, see through",
        "inside-out open-inside-out inconsistent-winding",
    ),
    (
        "faceted, blocky, flat, low poly, hard edges, polygons visible, not smooth",
        "faceted-normals no-normals coarse-outline",
    ),
    (
        "soft or rounded edges, blurred, blurry, inflated, gradients on flat faces, smudges",
        "soft-normals averaged-crease",
    ),
    ("seam, visible line, crack, hard edge on a smooth surface", "split-seam cracked-seam needless-seam"),
    (
        "dark or bright patches, spots, streaks",
        "stray-normals flipped-normals normals-against-face missing-normals cancelling-fans",
    ),
    ("highlights with steps, noise or banding, shiny, glossy", "coarse-normals lost-highlight"),
    ("bright or dark bands, stripes, mach bands", "mach-bands"),
    (
        "wrong light, lit from the wrong side",
        "swapped-axes rotated-normals untransformed-normals constant-normals mirrored-node",
    ),
    ("animated shapes, animation, morph targets, blend shapes", "wrong-morph-normals"),
    ("normal map, tangents", "tangents-off-normals"),
    ("jagged outline, silhouette", "coarse-outline"),
    ("shadows break up, terminator", "shading-terminator"),
    ("missing highlight, dull", "lost-highlight"),
];

/// Words that say nothing about what one sees.
const FILLERS: [&str; 14] =
    ["a", "the", "in", "on", "of", "is", "are", "it", "my", "and", "or", "looks", "look", "mesh"];

/// One word of each symptom, to choose from.
pub fn examples() -> String {
    let first = |(seen, _): &(&'static str, &str)| seen.split(',').next().unwrap_or_default();
    SYMPTOMS.iter().map(first).collect::<Vec<_>>().join(", ")
}

/// The findings that a word or a symptom means: those with these words in their id, and the causes of the symptoms that
/// have the most of the words.
pub fn search(words: &str) -> Vec<&'static Entry> {
    let words = words.trim().to_lowercase();
    if words.is_empty() {
        return Vec::new();
    }
    let significant = || words.split_whitespace().filter(|word| !FILLERS.contains(word));
    let score = |seen: &str| significant().filter(|word| seen.contains(*word)).count();
    let best = SYMPTOMS.iter().map(|(seen, _)| score(seen)).max().unwrap_or_default();
    let fitting = SYMPTOMS.iter().filter(|(seen, _)| best > 0 && score(seen) == best);
    let mut ids: Vec<&str> = fitting.flat_map(|(_, ids)| ids.split(' ')).collect();
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
            ("it looks blocky", "faceted-normals"),
            ("hard edges", "faceted-normals"),
            ("black spots on my mesh", "zero-normals"),
        ] {
            assert!(ids(words).contains(&id), "{words}: {:?}", ids(words));
        }
        assert!(ids("gibberish").is_empty() && ids(" ").is_empty());
    }
}
