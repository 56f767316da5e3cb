//! The texts of this experiment.

use crate::text::{Catalogue, catalogue};

pub(super) static TEXTS: Catalogue = catalogue!("texts");
