//! The page of a plan: pictures, decisions in words, refused steps, and all that was tried.

// Texts of decisions in both languages.
mod decisions;
// The page, and its pictures in one.
mod page;
// Error against cost of all that was tried.
mod tried;

pub use page::{PlanPage, plan_page, plan_sheet};
