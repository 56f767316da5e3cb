//! The known name that is most similar to an unknown one.

use strsim::jaro_winkler;

/// Names that are less similar than this are not suggested.
const LEAST: f64 = 0.8;

/// `did you mean X? `, or nothing if no name is similar.
pub fn did_you_mean<'a>(word: &str, names: impl IntoIterator<Item = &'a str>) -> String {
    let similar = names.into_iter().map(|name| (jaro_winkler(word, name), name));
    let nearest = similar.filter(|(similarity, _)| *similarity >= LEAST).max_by(|a, b| a.0.total_cmp(&b.0));
    nearest.map_or_else(String::new, |(_, name)| format!("did you mean {name}? "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_most_similar_name_is_suggested() {
        let names = ["zero-normals", "no-normals", "inverted-normals", "needle-faces"];
        let nearest = |word: &str| did_you_mean(word, names);
        assert_eq!(nearest("invertd-normal"), "did you mean inverted-normals? ");
        assert_eq!(nearest("zeronormals"), "did you mean zero-normals? ");
        assert_eq!(nearest("nedle-face"), "did you mean needle-faces? ");
        assert_eq!(nearest("gibberish"), "");
    }
}
