//! Why elements have fallback normals, and how often.

use crate::num::names;

/// Why a face or a corner has no normal of its own, but a documented unit fallback.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum FaultReason {
    /// A face whose area is exactly zero.
    ZeroArea,
    /// A face whose height is below the rounding of its own coordinates: its direction is noise.
    BelowStorage,
    /// Weighted face normals that cancel: with κ = Σ|w| / |Σ w n̂|, the error bound 2⁻⁵³ (n + 20) κ of a sum of n faces is
    /// above 10⁻³ rad. That is κ above 3·10¹¹ for six faces.
    CancellingFan,
    /// A position that is infinite or not a number.
    NonFinite,
    /// Exponents that `f64` cannot hold.
    OutOfRange,
    /// A vertex that no face uses.
    Unreferenced,
}

names! { FaultReason:
    ZeroArea = "ZeroArea", BelowStorage = "BelowStorage", CancellingFan = "CancellingFan",
    NonFinite = "NonFinite", OutOfRange = "OutOfRange", Unreferenced = "Unreferenced",
}

/// One fault at one element (a face, a corner or a vertex, by the list that it is in).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Fault {
    /// Number of the element.
    pub index: u32,
    /// Why.
    pub reason: FaultReason,
}

/// All faults of one computation, each list ascending by element.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Faults {
    /// Faces that add nothing to sums, or that have a fallback normal.
    pub faces: Vec<Fault>,
    /// Corners that have a fallback normal.
    pub corners: Vec<Fault>,
    /// Vertices that have a fallback normal.
    pub vertices: Vec<Fault>,
}

impl Faults {
    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.faces.is_empty() && self.corners.is_empty() && self.vertices.is_empty()
    }

    /// How often a list has a reason.
    pub fn count(list: &[Fault], reason: FaultReason) -> usize {
        list.iter().filter(|fault| fault.reason == reason).count()
    }
}
