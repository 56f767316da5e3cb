//! What people and programs are told (layer 7): pictures as files, labels, lines over a picture, the numbers behind a
//! pixel; pages and plots.
//!
//! ```
//! use crease::num::Transfer;
//! use crease::raster::Pixels;
//! use crease::report::{Picture, encode_png};
//!
//! let picture = Picture { size: [2, 1], pixels: Pixels::Eight(vec![[255, 0, 0], [0, 0, 255]]) };
//! let file = encode_png(&picture, Transfer::Srgb)?;
//! assert_eq!(&file[..8], b"\x89PNG\r\n\x1a\n");
//! # Ok::<(), crease::report::ReportError>(())
//! ```

mod animation;
mod artefact;
mod diagnosis;
mod error;
mod html;
mod label;
mod overlay;
mod palette;
mod panel;
mod picture;
mod plot;
mod png;
mod probe;
mod seams;
mod trade;

pub use animation::Animation;
pub use artefact::{
    chart_plot, experiment_page, experiment_sheet, index_page, list_table, mathml, measure_table, misses,
    page_name, picture_name, spoken, verdict_text,
};
pub use diagnosis::{After, Sight, deviation_picture, diagnosis_page};
pub use error::ReportError;
pub use html::{Page, Table, escape_html};
pub use label::{draw_text, text_width};
pub use overlay::{Overlay, overlay};
pub use palette::{ColourCount, Palette};
pub use panel::{Panel, panels, panels_size};
pub use picture::Picture;
pub use plot::{Axis, Mark, Plot, Scale, Series};
pub use png::encode_png;
pub use probe::{PixelReport, SampleReport, probe_pixel};
pub use trade::{
    approximation_table, box_table, class_table, cost_table, encoding_table, order_table, own_page,
    own_table, precision_table, shading_table, shading_times, surface_table, trade_page,
};
