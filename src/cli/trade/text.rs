//! The report of `crease trade` as text.

use super::json::Report;
use crate::cli::common::console::{Style, escaped};
use crease::report::{
    Table, approximation_table, box_table, class_table, cost_table, encoding_table, order_table, own_table,
    precision_table, shading_table, shading_times, surface_table,
};
use crease::trade::{EncodingRow, Trade};
use std::fmt::Write;

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
    let recommended = report.mesh.as_ref().map(|own| format!("Use --weight {}.", own.recommended.name()));
    for sentence in recommended.iter().chain(report.advice.iter().flatten()) {
        text.push_str(&wrapped(sentence));
    }
    if let Some(path) = &report.output {
        let _ = writeln!(text, "\npage: {}", escaped(path));
    }
    text
}

fn tables(trade: &Trade, long: bool) -> Vec<Table> {
    let mut tables = vec![class_table(trade), order_table(trade), box_table(trade), cost_table(trade)];
    if long {
        tables.insert(1, surface_table(trade));
    }
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

/// A sentence as a point of a list, in lines of at most 100 letters.
fn wrapped(sentence: &str) -> String {
    const WIDTH: usize = 100;
    let mut text = String::from("  -");
    let mut column = text.len();
    for word in sentence.split(' ') {
        let length = word.chars().count() + 1;
        if column + length > WIDTH {
            text.push_str("\n   ");
            column = 3;
        }
        text.push(' ');
        text.push_str(word);
        column += length;
    }
    text.push('\n');
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_sentences_are_broken_between_words() {
        let sentence = "word ".repeat(40);
        let text = wrapped(sentence.trim_end());
        assert!(text.lines().count() == 3 && text.lines().all(|line| line.chars().count() <= 100), "{text}");
        assert_eq!(text.split_whitespace().count(), 41);
    }
}
