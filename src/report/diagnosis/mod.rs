//! The diagnosis of a file as a page: what was found, shown.

mod page;
mod pictures;
mod plots;

pub use page::diagnosis_page;
pub use pictures::{Sight, deviation_picture};
