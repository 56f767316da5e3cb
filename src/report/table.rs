//! Tables as text for terminals and as Markdown; pages write them as HTML.

use std::fmt::Write;

/// The name of a column, and its cell for an item.
pub(super) type Column<'a, T> = (&'a str, &'a dyn Fn(&T) -> String);

/// Rows under columns, the first of which names the row.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    pub(super) caption: String,
    /// The headings of its columns.
    pub columns: Vec<String>,
    /// Its cells, row by row.
    pub rows: Vec<Vec<String>>,
}

impl Table {
    /// A table without rows.
    pub fn new(caption: &str, columns: &[impl AsRef<str>]) -> Self {
        let columns = columns.iter().map(|column| column.as_ref().to_owned()).collect();
        Self { caption: caption.to_owned(), columns, rows: Vec::new() }
    }

    /// A table with a row for each item, whose cells are computed by the columns.
    pub(super) fn of<T>(caption: &str, items: &[T], columns: &[Column<T>]) -> Self {
        let names: Vec<&str> = columns.iter().map(|(name, _)| *name).collect();
        let rows = items.iter().map(|item| columns.iter().map(|(_, cell)| cell(item)).collect()).collect();
        Self { rows, ..Self::new(caption, &names) }
    }

    /// With another row.
    #[must_use]
    pub fn row<T: Into<String>>(mut self, cells: impl IntoIterator<Item = T>) -> Self {
        self.push(cells);
        self
    }

    /// Adds a row. Missing cells are empty.
    pub fn push<T: Into<String>>(&mut self, cells: impl IntoIterator<Item = T>) {
        let mut row: Vec<String> = cells.into_iter().map(Into::into).collect();
        row.resize(self.columns.len(), String::new());
        self.rows.push(row);
    }

    /// Removes the columns that are empty in every row.
    pub fn drop_empty_columns(&mut self) {
        let keep: Vec<bool> = (0..self.columns.len())
            .map(|column| self.rows.iter().any(|row| !row[column].is_empty()))
            .collect();
        for row in self.rows.iter_mut().chain([&mut self.columns]) {
            let mut kept = keep.iter();
            row.retain(|_| kept.next() == Some(&true));
        }
    }

    /// Whether there are no rows.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Whether a column holds words: fewer than half of its cells are numbers, with a digit first and one word at most, such as
    /// a unit.
    pub(super) fn has_words(&self, column: usize) -> bool {
        let filled = || self.rows.iter().map(|row| &row[column]).filter(|cell| !cell.is_empty());
        let is_word = |text: &&str| text.chars().filter(|c| c.is_alphabetic()).count() > 1;
        let words = |cell: &str| cell.split(' ').filter(is_word).count();
        let is_number = |cell: &&String| {
            let starts = |c: char| c.is_ascii_digit() || c == '∞';
            cell.trim_start_matches(['-', '−', '+']).starts_with(starts) && words(cell) < 2
        };
        2 * filled().filter(is_number).count() < filled().count()
    }

    /// As text for a terminal: columns of equal width, numbers to the right, words to the left.
    pub fn to_text(&self) -> String {
        let lines = || std::iter::once(&self.columns).chain(&self.rows);
        let width = |column: usize| lines().map(|line| line[column].chars().count()).max().unwrap_or(0);
        let widths: Vec<usize> = (0..self.columns.len()).map(width).collect();
        let words: Vec<bool> = (0..self.columns.len()).map(|column| self.has_words(column)).collect();
        let mut text = format!("{}\n", self.caption);
        for line in lines() {
            let cells = line.iter().zip(&widths).enumerate().map(|(column, (cell, width))| {
                let fill = " ".repeat(width - cell.chars().count());
                if column == 0 || words[column] { format!("{cell}{fill}") } else { format!("{fill}{cell}") }
            });
            let _ = writeln!(text, "  {}", cells.collect::<Vec<_>>().join("  ").trim_end());
        }
        text
    }

    /// As a table of Markdown, without the caption.
    pub fn to_markdown(&self) -> String {
        let line = |cells: &[String]| {
            let cells = cells.iter().map(|cell| cell.replace('|', "\\|"));
            format!("| {} |\n", cells.collect::<Vec<_>>().join(" | "))
        };
        let mut text = line(&self.columns);
        let _ = writeln!(text, "|---|{}", "---:|".repeat(self.columns.len().saturating_sub(1)));
        self.rows.iter().for_each(|row| text.push_str(&line(row)));
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_are_the_same_in_every_form() {
        let table =
            Table::new("Errors", &["weight", "rms"]).row(["max", "0.5"]).row(["a|b", "11.25"]).row(["–"]);
        assert_eq!(table.to_text(), "Errors\n  weight    rms\n  max       0.5\n  a|b     11.25\n  –\n");
        let markdown = "| weight | rms |\n|---|---:|\n| max | 0.5 |\n| a\\|b | 11.25 |\n| – |  |\n";
        assert_eq!(table.to_markdown(), markdown);
        assert!(!table.is_empty());
    }

    #[test]
    fn empty_columns_are_removed() {
        let mut table =
            Table::new("t", &["face", "corner", "degrees"]).row(["1", "", ""]).row(["2", "", "30"]);
        table.drop_empty_columns();
        assert_eq!(table, Table::new("t", &["face", "degrees"]).row(["1", ""]).row(["2", "30"]));
    }

    /// Words may begin with a digit.
    #[test]
    fn columns_of_words_are_distinguished_from_numbers() {
        let table = Table::new("t", &["quantity", "found", "others"])
            .row(["1/d²: share of the floor", "0.5 px", "8.7 to 9.7"])
            .row(["8 bits: largest change", "-3", "0.5 (12 %)"]);
        assert_eq!([0, 1, 2].map(|column| table.has_words(column)), [true, false, false]);
    }
}
