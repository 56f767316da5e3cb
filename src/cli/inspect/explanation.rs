//! The texts of the catalogue for `--explain`: one finding, all, or a list of those that a symptom fits.

use crate::cli::common::console::Style;
use crease::quality::catalogue::{Entry, Family};
use crease::text::{Catalogue, Language, Value};

/// The labels; the texts of the findings are the library's.
static LABELS: Catalogue =
    Catalogue::new(include_str!("explanation.en.ftl"), include_str!("explanation.pt.ftl"));

/// Title, meaning, advice and command of a finding.
pub fn one(entry: &Entry, language: Language, style: Style) -> String {
    let label = |key: &str| LABELS.get(key).get(language).to_owned();
    let with = |key, values: &[(&'static str, Value)]| LABELS.with(key, values).get(language).to_owned();
    let group = match entry.family {
        Family::Stored => "stored",
        Family::Smoothing => "smoothing",
        Family::Geometry => "geometry",
        Family::Shading => "shading",
    };
    let kind = [
        ("severity", label(entry.severity.name()).into()),
        ("group", label(group).into()),
        ("counted", label(entry.element.name()).into()),
    ];
    let fix = match entry.remedy {
        Some(options) => format!("crease normals INPUT -o OUTPUT {options}").trim_end().to_owned(),
        None => label("no-command"),
    };
    format!(
        "{} {}\n  {}.\n  {}\n  {}\n  {}\n",
        style.paint(Style::BOLD, entry.id),
        with("about", &kind),
        capital(entry.title().get(language)),
        entry.meaning().get(language),
        with("to-do", &[("advice", entry.advice().get(language).to_owned().into())]),
        with("fix", &[("command", fix.into())]),
    )
}

/// All of these findings.
pub fn all(entries: &[&Entry], language: Language, style: Style) -> String {
    entries.iter().map(|entry| one(entry, language, style)).collect::<Vec<_>>().join("\n")
}

/// The titles of these findings.
pub fn list(entries: &[&Entry], language: Language, style: Style) -> String {
    let line =
        |entry: &&Entry| format!("{}: {}\n", style.paint(Style::BOLD, entry.id), entry.title().get(language));
    let lines: String = entries.iter().map(line).collect();
    format!("{lines}{}\n", LABELS.get("list-end").get(language))
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
