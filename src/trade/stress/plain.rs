//! The formulas as they are usually written, in `f32`, for comparison. Nothing of the library uses them.

use crate::normals::Weight;
use glam::Vec3;

/// v / √(v·v).
pub(super) fn unit(v: Vec3) -> Vec3 {
    v / (v.x * v.x + v.y * v.y + v.z * v.z).sqrt()
}

/// The cross product of two edges, made unit.
pub(super) fn face_normal([a, b, c]: [Vec3; 3]) -> Vec3 {
    unit((b - a).cross(c - a))
}

/// The angle between unit vectors.
pub(super) fn angle(a: Vec3, b: Vec3) -> f32 {
    libm::acosf(a.dot(b))
}

/// Σ w n̂ over triangles (centre, a, b), made unit.
pub(super) fn vertex_normal(centre: Vec3, fan: &[[Vec3; 2]], weight: Weight) -> Vec3 {
    let term = |&[a, b]: &[Vec3; 2]| {
        let (e1, e2) = (a - centre, b - centre);
        let cross = e1.cross(e2);
        let corner = || angle(unit(e1), unit(e2));
        let weight = match weight {
            Weight::Uniform => 1.0,
            Weight::Area => cross.length(),
            Weight::Angle | Weight::Quadric | Weight::Jet | Weight::Best => corner(),
            Weight::AngleArea => corner() * cross.length(),
            Weight::Max => cross.length() / (e1.length_squared() * e2.length_squared()),
            Weight::Edge => 1.0 / (e1.length() * e2.length()),
        };
        unit(cross) * weight
    };
    unit(fan.iter().map(term).fold(Vec3::ZERO, |sum, term| sum + term))
}
