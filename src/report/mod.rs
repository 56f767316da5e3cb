//! Output for people and programs (layer 7): picture files, labels, lines over a picture, the numbers of a pixel, tables, plots
//! and pages.
//!
//! ```
//! use crease::num::Transfer;
//! use crease::raster::Pixels;
//! use crease::report::{Picture, encode_png};
//!
//! let picture = Picture { size: [2, 1], pixels: Pixels::Eight(vec![[255, 0, 0], [0, 0, 255]]) };
//! let file = encode_png(&picture, None, Transfer::Srgb)?;
//! assert_eq!(&file[..8], b"\x89PNG\r\n\x1a\n");
//! # Ok::<(), crease::report::ReportError>(())
//! ```

// What can go wrong.
mod error;
// Pictures to combine and to draw on, as PNG files.
mod picture;
// Text in pictures, and pictures side by side with captions.
mod panel;
// Legends below pictures.
mod legend;
// Legends of false colours.
mod show_legend;
// Pictures without their background.
mod transparency;
// GIF files, and the palette of an animation.
mod animation;
// Edges, creases and normals as lines over a picture.
mod overlay;
// The numbers of one pixel.
mod probe;
// Plots as SVG.
mod plot;
// Tables as text and Markdown.
mod table;
// Pages of HTML.
mod html;
// Pages of experiments.
mod artefact;
// Accuracy against speed.
mod trade;
// Pages and heat maps of a diagnosis.
mod diagnosis;
// The page of a plan.
mod plan;

pub use animation::{Animation, ColourCount, Palette};
pub use artefact::{
    chart_plot, experiment_page, experiment_sheet, index_page, list_table, mathml, measure_table, misses,
    page_name, picture_name, running, spoken, verdict_sentence, verdict_text,
};
pub use diagnosis::{After, DiagnosisPage, HeatMap, Sight, heat_map};
pub use error::ReportError;
pub use html::{Drawing, Page, escape_html, svg_file};
pub use legend::{ColourScale, Key, Legend};
pub use overlay::{Overlay, overlay};
pub use panel::{Panel, draw_text, panels, panels_size, text_width};
pub use picture::{CutOut, Picture, encode_jpeg, encode_png, encode_webp};
pub use plan::{PlanPage, plan_page, plan_sheet};
pub use plot::{Axis, Mark, Plot, Scale, Series};
pub use probe::{PixelReport, SampleReport, probe_pixel};
pub use show_legend::{deviation_range, show_legend};
pub use table::Table;
pub use trade::{
    approximation_table, box_table, class_table, cost_table, encoding_table, frontier_table, order_table,
    own_page, own_table, precision_table, shading_table, shading_times, surface_table, trade_page,
};
pub use transparency::cut_out;
