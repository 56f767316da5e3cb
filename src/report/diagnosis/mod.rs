//! The diagnosis of a file as a page and as a heat map.

// The texts.
mod texts;
// Lines, dots and rings over a heat map.
mod markers;
// The legend of a heat map.
mod legend;
// A file with separate corners, and its pictures.
mod model;
// The choice of a view.
mod view_choice;
// Heat maps of angles, and the choice of a heat map.
mod deviation;
// Maps of findings.
mod finding_map;
// Pictures of single sites.
mod close_up;
// Before and after.
mod comparison;
// Histograms of a survey.
mod histograms;
// The page.
mod page;

pub use comparison::After;
pub use deviation::{HeatMap, heat_map};
pub(super) use markers::end_above;
pub use page::DiagnosisPage;
pub use view_choice::Sight;
