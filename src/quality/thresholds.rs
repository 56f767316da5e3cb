//! From where on something is a finding.

use crate::mesh::Confidence;
use crate::num::Degrees;

/// The limits that findings begin at. Angles are in degrees; everything else has no unit, so that the size of a mesh
/// does not matter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thresholds {
    /// Most by which the length of a stored normal may differ from 1 without a warning: the glTF validator's bound.
    pub length: f64,
    /// The same without a note: what three decimals leave.
    pub strict_length: f64,
    /// How far a stored normal may be from the best-reproducing recomputed one.
    pub deviation: Degrees,
    /// How far past 90° from its face a stored normal may point.
    pub against: Degrees,
    /// How far a rotation of all stored normals may turn them.
    pub rotation: Degrees,
    /// The error of stored precision that is worth a note.
    pub quantisation: Degrees,
    /// How far a tangent may lean towards its normal or away from it.
    pub tangent: Degrees,
    /// How far past the crease angle an edge with one normal on both sides may bend.
    pub crease: Degrees,
    /// How far the stored normals on the two sides of a smooth edge may be apart.
    pub seam: Degrees,
    /// The distance between the ends of open edges, over the diagonal of the bounding box, below which two are taken for one:
    /// what rounding coordinates to six digits or to 32 bits leaves. 0 for those that coincide alone.
    pub weld: f64,
    /// Width over length below which a face is a needle: of a triangle, height over longest edge.
    pub needle: f64,
    /// How far the corners of a polygon may leave its plane, as the angle between the normals at its corners.
    pub planarity: Degrees,
    /// The bend from which on an edge is folded.
    pub fold: Degrees,
    /// How sure it has to be which side of a component with a rim is its outer one.
    pub confidence: Confidence,
    /// The most faces round a vertex.
    pub valence: u32,
    /// The error of face normals that rounding coordinates to 32 bits may make.
    pub rounding: Degrees,
    /// How far the normal of a corner may be from its face before shadows break up.
    pub terminator: Degrees,
    /// The Blinn exponent whose highlight each face has to hold; `None` for that of its material, or 32 where the file
    /// does not say.
    pub exponent: Option<f64>,
    /// The change of slope at a smooth edge, in 8-bit steps a pixel, from which on it shows as a Mach band.
    pub band: f64,
    /// Pixels by which an outline may cut its curve, where the mesh is [`size`](Self::size) pixels wide.
    pub outline: f64,
    /// The size in pixels that outlines and bands are measured at.
    pub size: f64,
    /// How many places of each finding are told, the worst first. Counts are always complete.
    pub places: usize,
}

impl Default for Thresholds {
    fn default() -> Self {
        Self {
            length: crate::normals::LENGTH_TOLERANCE,
            strict_length: 0.001,
            deviation: Degrees(15.0),
            against: Degrees(5.0),
            rotation: Degrees(5.0),
            quantisation: Degrees(0.05),
            tangent: Degrees(5.0),
            crease: Degrees(10.0),
            seam: Degrees(2.0),
            weld: 1e-6,
            needle: 0.001,
            planarity: Degrees(10.0),
            fold: Degrees(170.0),
            confidence: Confidence::default(),
            valence: 48,
            rounding: Degrees(0.5),
            terminator: Degrees(20.0),
            exponent: None,
            band: 0.1,
            outline: 1.0,
            size: 512.0,
            places: 10,
        }
    }
}
