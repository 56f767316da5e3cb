//! The integration suite.

mod data;
