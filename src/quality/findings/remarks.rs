//! What findings say about a file in addition to their titles.

use crate::text::{Catalogue, catalogue};

pub(crate) static REMARKS: Catalogue = catalogue!("remarks");
