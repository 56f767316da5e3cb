//! The artefact laboratory for people: a page an experiment, an index with thumbnails, sheets of panels, tables, plots; in
//! English or Portuguese.

// Formulas as MathML and in words, and sub- and superscripts in running text, where there is no room for a formula.
mod notation;
// The texts of the pages: tables and sentences.
mod tables;
// Pages of experiments: for a browser, paper and a projector.
mod page;
// The gallery's structure, in both languages.
#[cfg(test)]
mod tests;

pub use notation::{mathml, running, spoken};
pub use page::{chart_plot, experiment_page, experiment_sheet, index_page, page_name, picture_name};
pub use tables::{list_table, measure_table, misses, verdict_sentence, verdict_text};
