//! The limits from which something is a finding.

use crate::mesh::Confidence;
use crate::num::Degrees;

/// The limits of findings. Angles are in degrees. Everything else is without a unit, so that the size of a mesh does not matter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thresholds {
    /// The largest difference from 1 of the length of a stored normal without a warning: the bound of the glTF validator.
    pub length: f64,
    /// Tolerance below which no note is given: rounding to three decimals is less.
    pub strict_length: f64,
    /// The largest angle between a stored normal and the expected one.
    pub deviation: Degrees,
    /// The largest angle beyond 90° between a stored normal and its face.
    pub against: Degrees,
    /// The largest angle of a rotation of all stored normals.
    pub rotation: Degrees,
    /// The largest error of the stored precision.
    pub quantisation: Degrees,
    /// The largest difference from 90° of the angle between a tangent and its normal.
    pub tangent: Degrees,
    /// The largest dihedral angle beyond the crease angle of an edge with the same normal on both sides.
    pub crease: Degrees,
    /// The largest angle between the stored normals on the two sides of a smooth edge.
    pub seam: Degrees,
    /// The distance between the ends of open edges, divided by the diagonal of the bounding box, below which two count as one: more
    /// than rounding coordinates to six digits or to 32 bits leaves. 0 if they have to coincide.
    pub weld: f64,
    /// Width over length below which a face is a needle: of a triangle, height over longest edge.
    pub needle: f64,
    /// The largest angle between a polygon and the planes at its corners.
    pub planarity: Degrees,
    /// The dihedral angle from which an edge is folded.
    pub fold: Degrees,
    /// The least confidence in which side of a component with a rim is its outer one.
    pub confidence: Confidence,
    /// The largest number of faces at a vertex.
    pub valence: u32,
    /// The largest error of face normals by rounding coordinates to 32 bits.
    pub rounding: Degrees,
    /// The largest angle between the normal of a corner and its face at which shadows do not break up.
    pub terminator: Degrees,
    /// The Blinn exponent of the highlight that each face has to hold; `None` for that of its material, or 32 if it has none.
    pub exponent: Option<f64>,
    /// The change of slope at a smooth edge, in 8-bit steps a pixel, from which it shows as a Mach band.
    pub band: f64,
    /// The largest distance in pixels of an outline from its curve if the mesh is [`size`](Self::size) pixels wide.
    pub outline: f64,
    /// The size of the mesh in pixels at which outlines and bands are measured.
    pub size: f64,
    /// How many positions of each finding are kept, the worst first. Counts are always complete.
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
