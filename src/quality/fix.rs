//! One command that fixes all findings that can be fixed together.

use crate::quality::catalogue::Kind;
use crate::quality::diagnosis::Diagnosis;
use crate::quality::element::Severity;
use crate::quality::finding::{Finding, fix_command};
use serde::{Serialize, Serializer};
use std::collections::BTreeMap;

/// A command that fixes several findings.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Fix {
    /// The command, for a POSIX shell.
    pub command: String,
    /// The findings of the diagnosis that it fixes, in their order.
    #[serde(rename = "findings", serialize_with = "as_ids")]
    pub kinds: Vec<Kind>,
}

fn as_ids<S: Serializer>(kinds: &[Kind], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(kinds.iter().map(|kind| kind.id()))
}

/// Options and their values; an option without one has an empty value.
type Options<'a> = BTreeMap<&'a str, &'a str>;

/// Options of which a stronger value does all that a weaker one does, weakest first.
const STRONGER: [(&str, &[&str]); 2] =
    [("--when", &["missing", "broken", ""]), ("--orient", &["", "consistent", "outward"])];

/// How strong a value of such an option is.
fn strength(values: &[&str], value: &str) -> Option<usize> {
    values.iter().position(|known| *known == value)
}

impl Diagnosis {
    /// The command that fixes the selected findings, with these names of input and output. `None` if none of them can be fixed.
    ///
    /// Notes may be intended. So the command is made for errors and warnings, and for notes only if `with_notes` is set or no
    /// selected error or warning can be fixed. [`Fix::kinds`] lists all selected findings that this command fixes.
    ///
    /// The remedies are merged: the stronger value of `--when` and `--orient`, and for other options the value that the more
    /// severe finding needs. Recomputing all normals includes the broken and missing ones. Authored normals are kept, unless an
    /// error or a warning needs all normals to be computed.
    pub fn fix(
        &self,
        is_selected: impl Fn(&Finding) -> bool,
        with_notes: bool,
        [input, output]: [&str; 2],
    ) -> Option<Fix> {
        let has_authored = self.get(Kind::Custom).is_some();
        let keeps_authored = |finding: &Finding, needs: &Options<'_>| {
            finding.severity > Severity::Note || needs.contains_key("--when") || !has_authored
        };
        let selected = self.findings.iter().filter(|finding| is_selected(finding));
        let fixable: Vec<(&Finding, Options<'_>)> =
            selected.filter_map(|finding| Some((finding, needs(finding, has_authored)?))).collect();
        let is_grave = |finding: &Finding| finding.severity > Severity::Note;
        let takes_notes = with_notes || !fixable.iter().any(|(finding, _)| is_grave(finding));
        let due = fixable
            .iter()
            .filter(|(finding, needs)| keeps_authored(finding, needs) && (takes_notes || is_grave(finding)));
        let options = due.map(|(_, needs)| needs.clone()).reduce(merge)?;
        let fixed = fixable
            .iter()
            .filter(|(finding, needs)| keeps_authored(finding, needs) && includes(&options, needs));
        let words = options.iter().flat_map(|(option, value)| [*option, *value]);
        let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
        Some(Fix {
            command: fix_command(input, output, &words.join(" ")),
            kinds: fixed.map(|(finding, _)| finding.kind).collect(),
        })
    }
}

/// The options that fix a finding; `None` if none do.
fn needs(finding: &Finding, has_authored: bool) -> Option<Options<'_>> {
    let words: Vec<&str> = finding.remedy.as_deref()?.split(' ').collect();
    let is_option = |word: &str| word.starts_with("--");
    let options = words.iter().enumerate().filter(|(_, word)| is_option(word));
    let value = |at: usize| words.get(at + 1).copied().filter(|word| !is_option(word)).unwrap_or_default();
    let mut options: Options<'_> = options.map(|(at, option)| (*option, value(at))).collect();
    // Faces can be reoriented without touching normals that were authored.
    if has_authored && !options.is_empty() && options.keys().all(|option| *option == "--orient") {
        options.insert("--when", "broken");
    }
    Some(options)
}

/// Options that do what both lists do; where that is impossible, those of the first win.
fn merge<'a>(mut options: Options<'a>, others: Options<'a>) -> Options<'a> {
    for (option, values) in STRONGER {
        let value = |options: &Options<'a>| options.get(option).copied().unwrap_or_default();
        let pair = [value(&options), value(&others)];
        let stronger = pair.into_iter().max_by_key(|value| strength(values, value)).unwrap_or_default();
        match stronger {
            "" => options.remove(option),
            value => options.insert(option, value),
        };
    }
    for (option, value) in others {
        if STRONGER.iter().all(|(known, _)| *known != option) {
            options.entry(option).or_insert(value);
        }
    }
    options
}

/// Whether options do all that others do.
fn includes(options: &Options<'_>, needs: &Options<'_>) -> bool {
    let are_strong = STRONGER.iter().all(|(option, values)| {
        let of = |options: &Options<'_>| strength(values, options.get(option).copied().unwrap_or_default());
        of(options) >= of(needs)
    });
    let is_ranked = |option: &str| STRONGER.iter().any(|(known, _)| *known == option);
    are_strong && needs.iter().all(|(option, value)| is_ranked(option) || options.get(option) == Some(value))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::{Format, ReadOptions, read_bytes};
    use crate::quality::{Thresholds, diagnose};

    /// A diagnosis with findings of these kinds, severities and remedies.
    fn found(findings: &[(Kind, Severity, Option<&str>)]) -> Diagnosis {
        let zero = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nf 1//1 2//1 3//1\n";
        let loaded = read_bytes(zero.to_vec(), Some(Format::Obj), None, &ReadOptions::default()).unwrap();
        let one = diagnose(&loaded, &Thresholds::default(), &|_| {}).findings[0].clone();
        let finding = |&(kind, severity, remedy): &(Kind, Severity, Option<&str>)| Finding {
            kind,
            severity,
            remedy: remedy.map(str::to_owned),
            ..one.clone()
        };
        Diagnosis { findings: findings.iter().map(finding).collect(), ..Diagnosis::default() }
    }

    fn fix(diagnosis: &Diagnosis, with_notes: bool) -> (String, Vec<Kind>) {
        let fix = diagnosis.fix(|_| true, with_notes, ["a b.obj", "c.obj"]);
        fix.map_or_else(Default::default, |fix| (fix.command, fix.kinds))
    }

    const START: &str = "crease normals 'a b.obj' -o c.obj";

    #[test]
    fn remedies_are_merged_and_the_more_severe_one_wins() {
        let kinds = [Kind::NotFinite, Kind::Soft, Kind::SplitSeam];
        let merged = |remedies: &[&str]| {
            let findings = kinds.iter().zip(remedies);
            let findings: Vec<_> =
                findings.map(|(&kind, remedy)| (kind, Severity::Warning, Some(*remedy))).collect();
            fix(&found(&findings), false)
        };
        assert_eq!(merged(&[]).0, "");
        assert_eq!(
            merged(&["--when broken", "--when missing"]),
            (format!("{START} --when broken"), kinds[..2].to_vec())
        );
        assert_eq!(merged(&["--when broken", ""]), (START.into(), kinds[..2].to_vec()));
        assert_eq!(merged(&["", "--when broken"]), (START.into(), kinds[..2].to_vec()));
        // The second finding needs another crease angle than the one that is used.
        assert_eq!(
            merged(&["--orient outward --crease 30", "--crease 40 --flip", "--orient consistent"]),
            (format!("{START} --crease 30 --flip --orient outward"), vec![kinds[0], kinds[2]])
        );
    }

    #[test]
    fn authored_normals_are_kept_if_only_notes_need_others() {
        let with_authored = |severity: Severity, remedy: &str| {
            let authored = (Kind::Custom, Severity::Note, None);
            fix(&found(&[(Kind::Faceted, severity, Some(remedy)), authored]), true).0
        };
        assert_eq!(with_authored(Severity::Note, "--crease 40"), "");
        assert!(with_authored(Severity::Note, "--when broken").ends_with(" --when broken"));
        assert!(with_authored(Severity::Warning, "--crease 40").ends_with(" --crease 40"));
        let reoriented = with_authored(Severity::Error, "--orient consistent");
        assert!(reoriented.ends_with("--orient consistent --when broken"), "{reoriented}");
    }

    /// A note changes the command only if it is asked for, and is named if the command fixes it anyway.
    #[test]
    fn notes_do_not_change_the_command_of_errors() {
        let error = (Kind::ZeroNormals, Severity::Error, Some("--when broken"));
        let length = (Kind::LooseLength, Severity::Note, Some("--when broken"));
        let area = (Kind::ZeroArea, Severity::Note, Some("--degenerate drop"));
        let diagnosis = found(&[error, length, area]);
        let broken = format!("{START} --when broken");
        assert_eq!(fix(&diagnosis, false), (broken, vec![Kind::ZeroNormals, Kind::LooseLength]));
        let (command, kinds) = fix(&diagnosis, true);
        assert_eq!((command, kinds.len()), (format!("{START} --degenerate drop"), 3));
        assert_eq!(fix(&found(&[area]), false), (format!("{START} --degenerate drop"), vec![Kind::ZeroArea]));
    }
}
