//! The definition of a finding: id, severity, element and remedy. Each finding has one, in the file of its search.

use crate::quality::counts::Tallies;
use crate::quality::element::{Element, Severity};
use crate::quality::facts::Facts;
use crate::quality::spot::Spot;

/// What is known of a finding without a file.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Definition {
    /// The stable name, on the command line and in reports.
    pub(crate) id: &'static str,
    /// The highest severity.
    pub(crate) severity: Severity,
    pub(crate) element: Element,
    /// Options of `crease normals` that fix it; `None` if none does.
    pub(crate) remedy: Option<&'static str>,
    /// The unit of the amount at the worst position, if the finding has one.
    pub(crate) unit: Option<&'static str>,
    /// The angle at an occurrence, in degrees, where the search measures something else.
    pub(crate) angle: Option<fn(&Facts<'_>, &Spot) -> f64>,
    /// What to say about the sum over all parts ([`Tally::sum`](crate::quality::counts::Tally::sum)).
    pub(crate) say_sum: Option<fn(u64) -> String>,
}

/// What was found, by definition.
pub(crate) type Found = Tallies<&'static Definition>;

impl Definition {
    const fn new(
        id: &'static str,
        severity: Severity,
        element: Element,
        remedy: Option<&'static str>,
    ) -> Self {
        Self { id, severity, element, remedy, unit: None, angle: None, say_sum: None }
    }

    /// A finding that is a note.
    pub(crate) const fn note(id: &'static str, element: Element, remedy: Option<&'static str>) -> Self {
        Self::new(id, Severity::Note, element, remedy)
    }

    /// A finding that is a warning at most.
    pub(crate) const fn warning(id: &'static str, element: Element, remedy: Option<&'static str>) -> Self {
        Self::new(id, Severity::Warning, element, remedy)
    }

    /// A finding that is an error at most.
    pub(crate) const fn error(id: &'static str, element: Element, remedy: Option<&'static str>) -> Self {
        Self::new(id, Severity::Error, element, remedy)
    }
}

/// Definitions are the same if they are the same static.
impl PartialEq for Definition {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self, other)
    }
}
