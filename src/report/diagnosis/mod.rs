//! The diagnosis of a file as a page: what was found, shown.

mod change;
mod close_up;
mod deviation;
mod dots;
mod heat;
mod page;
mod pictures;
mod plots;
mod sight;

pub use change::After;
pub use page::diagnosis_page;
pub use pictures::deviation_picture;
pub use sight::Sight;
