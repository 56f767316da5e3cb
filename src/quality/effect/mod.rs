//! Effect: what a wrong normal does to a picture.

// Specular exponents of faces.
pub(super) mod specular_exponent;
// Steps of 8 bits that a wrong normal changes.
pub(super) mod lost_light;
// Findings about what correct normals will show.
pub(super) mod risk_findings;
