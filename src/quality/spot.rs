//! One occurrence of a finding.

use crate::mesh::NONE;
use std::cmp::Ordering;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Measure {
    /// Only the order of occurrences.
    Order,
    /// Steps of 8 bits in the grey value under a key light.
    Steps,
    /// An amount in the unit of the finding; negative where less is worse.
    Amount,
}

/// One occurrence. Numbers of what it is not about are [`NONE`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Spot {
    pub(crate) part: u32,
    pub(crate) face: u32,
    /// A corner of the mesh, not of the face.
    pub(crate) corner: u32,
    pub(crate) vertex: u32,
    /// The index among the nodes that place the part.
    pub(crate) node: u32,
    /// How bad it is: the order of occurrences.
    pub(crate) weight: f64,
    pub(crate) measure: Measure,
    /// The angle, if it is known.
    pub(crate) degrees: Option<f64>,
}

/// About the mesh as a whole.
const WHOLE: Spot = Spot {
    part: 0,
    face: NONE,
    corner: NONE,
    vertex: NONE,
    node: NONE,
    weight: 0.0,
    measure: Measure::Order,
    degrees: None,
};

impl Spot {
    /// A corner that is off by an angle.
    pub(crate) fn corner(face: usize, corner: usize, degrees: f64) -> Self {
        Self { face: face as u32, corner: corner as u32, ..WHOLE }.by(degrees)
    }

    pub(crate) fn face(face: usize) -> Self {
        Self { face: face as u32, ..WHOLE }
    }

    pub(crate) fn vertex(vertex: usize) -> Self {
        Self { vertex: vertex as u32, ..WHOLE }
    }

    pub(crate) fn node(number: usize) -> Self {
        Self { node: number as u32, ..WHOLE }
    }

    pub(crate) fn mesh() -> Self {
        WHOLE
    }

    /// With an angle for its weight.
    pub(crate) fn by(self, degrees: f64) -> Self {
        Self { weight: degrees, measure: Measure::Order, degrees: Some(degrees), ..self }
    }

    /// With a weight in another measure.
    pub(crate) fn of(self, measure: Measure, weight: f64) -> Self {
        Self { weight, measure, degrees: None, ..self }
    }

    /// Worse ones first; among equals the first of the file.
    pub(crate) fn order(&self, other: &Self) -> Ordering {
        let position = |spot: &Self| (spot.part, spot.face, spot.corner, spot.vertex, spot.node);
        other.weight.total_cmp(&self.weight).then_with(|| position(self).cmp(&position(other)))
    }
}
