//! One command that fixes all that can be fixed together.

use crease::quality::catalogue::Kind;
use crease::quality::{Finding, Severity, fix_command};
use std::collections::BTreeMap;

/// Values of options of which one does all that another does, least first.
const STRONGER: [(&str, &[&str]); 2] =
    [("--when", &["missing", "broken", ""]), ("--orient", &["", "consistent", "outward"])];

/// The command that fixes the findings, which are in order of severity; `None` if none can be fixed.
///
/// The remedies are merged: the stronger value of `--when` and `--orient`, and for other options the value that the more severe
/// finding needs. Recomputing all normals includes the broken and missing ones. Authored normals are kept, unless a finding above
/// a note needs all normals to be computed.
pub fn command(findings: &[&Finding], input: &str, output: &str) -> Option<String> {
    let has_authored = findings.iter().any(|finding| finding.kind == Kind::Custom);
    let is_due = |finding: &&&Finding| {
        let keeps = finding.remedy.as_deref().is_some_and(|options| options.contains("--when"));
        finding.severity > Severity::Note || keeps || !has_authored
    };
    let due = findings.iter().filter(is_due);
    let remedies: Vec<Vec<&str>> =
        due.filter_map(|finding| Some(finding.remedy.as_deref()?.split(' ').collect())).collect();
    let mut options: BTreeMap<&str, &str> = BTreeMap::new();
    for (number, words) in remedies.iter().enumerate() {
        let mut given: BTreeMap<&str, &str> = pairs(words).collect();
        // Faces can be reoriented without touching normals that were authored.
        if has_authored && given.keys().all(|option| *option == "--orient") {
            given.insert("--when", "broken");
        }
        for (option, values) in STRONGER {
            let strength = |value: &str| values.iter().position(|known| *known == value);
            let value = given.get(option).copied().unwrap_or_default();
            let before = options.get(option).copied().unwrap_or_default();
            if number == 0 || strength(value) > strength(before) {
                options.insert(option, value);
            }
        }
        for (option, value) in given {
            options.entry(option).or_insert(value);
        }
    }
    options.retain(|option, value| STRONGER.iter().all(|(known, _)| known != option) || !value.is_empty());
    let words: Vec<&str> = options.into_iter().flat_map(|(option, value)| [option, value]).collect();
    let words: Vec<&str> = words.into_iter().filter(|word| !word.is_empty()).collect();
    (!remedies.is_empty()).then(|| fix_command(input, output, &words.join(" ")))
}

/// Options and their values; an option without one has an empty value.
fn pairs<'a>(words: &'a [&'a str]) -> impl Iterator<Item = (&'a str, &'a str)> {
    let is_option = |word: &str| word.starts_with("--");
    let options = words.iter().enumerate().filter(move |(_, word)| is_option(word));
    options.map(move |(at, option)| {
        (*option, words.get(at + 1).copied().filter(|word| !is_option(word)).unwrap_or_default())
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crease::io::{Format, ReadOptions, read_bytes};
    use crease::quality::{Thresholds, diagnose};

    #[test]
    fn remedies_are_merged_and_the_more_severe_one_wins() {
        let zero = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nf 1//1 2//1 3//1\n";
        let loaded = read_bytes(zero.to_vec(), Some(Format::Obj), None, &ReadOptions::default()).unwrap();
        let finding = diagnose(&loaded, &Thresholds::default(), &|_| {}).findings[0].clone();
        let merged = |remedies: &[&str]| {
            let with = |remedy: &&str| Finding { remedy: Some((*remedy).to_owned()), ..finding.clone() };
            let findings: Vec<Finding> = remedies.iter().map(with).collect();
            command(&findings.iter().collect::<Vec<_>>(), "a b.obj", "c.obj").unwrap_or_default()
        };
        let start = "crease normals 'a b.obj' -o c.obj";
        assert_eq!(merged(&[]), "");
        assert_eq!(merged(&["--when broken", "--when missing"]), format!("{start} --when broken"));
        assert_eq!(merged(&["--when broken", ""]), start);
        assert_eq!(merged(&["", "--when broken"]), start);
        assert_eq!(
            merged(&["--orient consistent", "--orient outward --crease 30", "--crease 40 --flip"]),
            format!("{start} --crease 30 --flip --orient outward")
        );

        let of = |kind: Kind, severity: Severity, remedy: Option<&str>| Finding {
            kind,
            severity,
            remedy: remedy.map(str::to_owned),
            ..finding.clone()
        };
        let authored = of(Kind::Custom, Severity::Note, None);
        let with_authored = |severity: Severity, remedy: &str| {
            let other = of(Kind::Faceted, severity, Some(remedy));
            command(&[&other, &authored], "a.obj", "b.obj")
        };
        assert_eq!(with_authored(Severity::Note, "--crease 40"), None);
        assert!(with_authored(Severity::Note, "--when broken").is_some());
        assert!(with_authored(Severity::Warning, "--crease 40").is_some());
        let reoriented = with_authored(Severity::Error, "--orient consistent").unwrap();
        assert!(reoriented.ends_with("--orient consistent --when broken"), "{reoriented}");
    }
}
