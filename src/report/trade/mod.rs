//! The measurement of accuracy against speed, for people: tables, plots, pictures and one page of all.

mod page;
mod pictures;
mod plots;
mod tables;

pub use page::{own_page, trade_page};
pub use tables::{
    approximation_table, box_table, class_table, cost_table, encoding_table, order_table, own_table,
    precision_table, shading_table, shading_times, surface_table,
};
