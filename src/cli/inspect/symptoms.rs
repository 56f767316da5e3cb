//! From what one sees in a picture to findings, for `--explain`.

use crate::cli::common::nearest::did_you_mean;
use crease::quality::catalogue::{Entry, entries};

/// What one sees, in the words of users, and the ids of the findings that cause it.
fn symptoms() -> impl Iterator<Item = (&'static str, &'static str)> {
    include_str!("symptoms.txt").lines().filter_map(|line| line.split_once(" => "))
}

/// Words that say nothing about what one sees.
const FILLERS: [&str; 14] =
    ["a", "the", "in", "on", "of", "is", "are", "it", "my", "and", "or", "looks", "look", "mesh"];

/// One word of each symptom, to choose from.
pub fn examples() -> String {
    let first = |(seen, _): (&'static str, &str)| seen.split(',').next().unwrap_or_default();
    symptoms().map(first).collect::<Vec<_>>().join(", ")
}

/// A suggestion of an id or a symptom that is similar to words.
pub fn similar(words: &str) -> String {
    let words = words.trim().to_lowercase();
    let ids = entries().map(|entry| entry.id);
    let seen = symptoms().flat_map(|(seen, _)| seen.split(", "));
    did_you_mean(&words.replace(' ', "-"), ids.chain(seen))
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
    let best = symptoms().map(|(seen, _)| score(seen)).max().unwrap_or_default();
    let fitting = symptoms().filter(|(seen, _)| best > 0 && score(seen) == best);
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
        for (_, ids) in symptoms() {
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
        for (words, suggestion) in
            [("invertd normals", "inverted-normals"), ("facetted", "faceted"), ("blokcy", "blocky")]
        {
            assert!(ids(words).is_empty(), "{words}: {:?}", ids(words));
            assert_eq!(similar(words), format!("did you mean {suggestion}? "));
        }
        assert_eq!(similar("gibberish"), "");
    }
}
