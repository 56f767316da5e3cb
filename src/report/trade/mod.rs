//! The measurement of accuracy against speed: tables, plots, pictures and pages.

// Tables.
mod tables;
// Plots.
mod plots;
// Pictures of errors.
mod pictures;
// Pages.
mod page;

pub use page::{own_page, trade_page};
pub use tables::{
    approximation_table, box_table, class_table, cost_table, encoding_table, order_table, own_table,
    precision_table, shading_table, shading_times, surface_table,
};
