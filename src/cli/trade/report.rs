//! The report of `crease trade` as JSON and as text. Members are described in `docs/json.md`.

use crate::cli::common::console::{Style, escaped, push_wrapped};
use crate::cli::common::report::Head;
use crease::report::{
    Table, approximation_table, box_table, class_table, cost_table, encoding_table, frontier_table,
    order_table, own_table, precision_table, shading_table, shading_times, surface_table,
};
use crease::trade::{EncodingRow, OwnMesh, Trade};
use serde::Serialize;
use std::fmt::Write;

#[derive(Debug, Default, Serialize)]
pub struct Report {
    #[serde(flatten)]
    pub head: Head,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub input: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub output: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub surfaces: Option<Trade>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mesh: Option<OwnMesh>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub advice: Option<Vec<String>>,
    pub seconds: f64,
}

impl Report {
    pub fn new(input: Option<String>) -> Self {
        Self { head: Head::new("crease-trade/1"), input, ..Self::default() }
    }
}

/// Tables, then advice. `long` adds every surface, and Phong's highlights.
pub fn text(report: &Report, style: Style, long: bool) -> String {
    let surfaces = report.surfaces.iter().flat_map(|trade| tables(trade, long));
    let tables: Vec<Table> = surfaces.chain(report.mesh.iter().map(own_table)).collect();
    let mut text = String::new();
    for table in &tables {
        text.push_str(&heading(&table.to_text(), style));
        text.push('\n');
    }
    let _ = writeln!(text, "{}", style.paint(Style::BOLD, "Advice"));
    let recommended = report.mesh.as_ref().map(|own| match own.recommended {
        Some(weight) => format!("Use --weight {}.", weight.name()),
        None => "No weighting can be recommended on this mesh.".into(),
    });
    for sentence in recommended.iter().chain(report.advice.iter().flatten()) {
        push_wrapped(&mut text, sentence, ["  - ", "    "]);
    }
    if let Some(path) = &report.output {
        let _ = writeln!(text, "\npage: {}", escaped(path));
    }
    text
}

fn tables(trade: &Trade, long: bool) -> Vec<Table> {
    let mut tables = vec![class_table(trade), frontier_table(trade)];
    if long {
        tables.push(surface_table(trade));
    }
    tables.extend([order_table(trade), box_table(trade), cost_table(trade)]);
    tables.push(precision_table(trade));
    tables.push(encoding_table(&trade.encodings, true));
    tables.push(shading_table(&trade.shading, "blinn"));
    if long {
        tables.push(shading_table(&trade.shading, "phong"));
    }
    tables.push(shading_times(&trade.shading));
    tables.push(approximation_table(trade));
    tables
}

/// The tables that a README quotes: weights by class, and encodings of every even number of bits up to 12, and 16. No times,
/// which differ from machine to machine.
pub fn markdown(trade: &Trade) -> String {
    let is_quoted = |row: &&EncodingRow| {
        let odd = ["oct 9", "oct 11", "oct 13", "oct 14", "oct 15"];
        !odd.iter().any(|odd| row.name.starts_with(odd))
    };
    let encodings: Vec<EncodingRow> = trade.encodings.iter().filter(is_quoted).cloned().collect();
    let tables = [class_table(trade), encoding_table(&encodings, false)];
    tables.map(|table| table.to_markdown()).join("\n")
}

fn heading(text: &str, style: Style) -> String {
    let (first, rest) = text.split_once('\n').unwrap_or((text, ""));
    format!("{}\n{rest}", style.paint(Style::BOLD, first))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_sentences_are_broken_between_words() {
        let sentence = "word ".repeat(40);
        let mut text = String::new();
        push_wrapped(&mut text, sentence.trim_end(), ["  - ", "    "]);
        assert!(text.lines().count() == 3 && text.lines().all(|line| line.chars().count() <= 100), "{text}");
        assert_eq!(text.split_whitespace().count(), 41);
    }
}
