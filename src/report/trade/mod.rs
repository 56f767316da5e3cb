//! The measurement of accuracy against speed: tables, plots, pictures and pages.

// Tables.
mod tables;
// Plots.
mod plots;
// The pages of the measurement, with meshes coloured by the errors of their normals. The texts are in page.en.ftl.
mod page;

pub use page::{own_page, trade_page};
pub use tables::{
    approximation_table, box_table, class_table, cost_table, encoding_table, frontier_table, order_table,
    own_table, precision_table, shading_table, shading_times, surface_table,
};
