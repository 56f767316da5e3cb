//! The names that the code of most findings uses.

pub(crate) use crate::quality::angles::{Limit, SAME, degrees_between};
pub(crate) use crate::quality::catalogue::Kind;
pub(crate) use crate::quality::counts::{Found, Remark, Tallies, Tally, scan};
pub(crate) use crate::quality::element::Severity;
pub(crate) use crate::quality::facts::Facts;
pub(crate) use crate::quality::findings::remarks::REMARKS;
pub(crate) use crate::quality::spot::{Measure, Spot};
pub(crate) use crate::text::{Text, Value};
