//! The artefact laboratory for people: a page an experiment, an index with thumbnails, sheets of panels, tables, plots; in
//! English or Portuguese.

mod formula;
mod page;
mod pictures;
mod running;
mod tables;
#[cfg(test)]
mod tests;
mod words;

pub use formula::{mathml, spoken};
pub use page::{experiment_page, index_page, page_name};
pub use pictures::{chart_plot, experiment_sheet, picture_name};
pub use tables::{list_table, measure_table, misses, verdict_text};
