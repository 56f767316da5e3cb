//! User-visible texts (layer 1), in files of [Project Fluent](https://projectfluent.org) next to the code that uses them.
//!
//! A source file names its texts once and takes them by key; placeholders are named, numbers follow the language, and
//! plurals are Fluent's:
//! ```text
//! static TEXTS: Catalogue = catalogue!("silhouette"); // silhouette.en.ftl and silhouette.pt.ftl in the same folder
//! let title = TEXTS.get("title");
//! let name = TEXTS.with("offset", &[("count", 16.into()), ("offset", Value::quantity(0.5, "px"))]);
//! ```
//! The files are compiled into the program. Tests of this module read all of them: both languages have the same keys and the
//! same placeholders, every key that the code names exists, and every key is used.

// How each language writes numbers.
mod language;
// One text in both languages.
mod bilingual;
// What fills a placeholder.
mod value;
// The texts of one file by key.
mod catalogue;
// All Fluent files of the source tree, read as text: keys, placeholders, and their use in the code.
#[cfg(test)]
mod files_tests;

pub use bilingual::Text;
pub use catalogue::Catalogue;
pub(crate) use catalogue::catalogue;
pub use language::{Language, given};
pub use value::Value;
