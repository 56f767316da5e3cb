//! Light on a sphere and on a prism, and the pixels where their normals and facets disagree.

use super::super::prelude::*;
use crate::shade::Terminator;

/// The window's side; prism and sphere have the radius 1.
pub(super) const WINDOW: f64 = 2.2;
/// How high the light stands over the sphere, so that its border crosses facets askew.
pub(super) const HEIGHT: Degrees = Degrees(25.0);
/// No height at all: light at right angles to the prism.
pub(super) const LEVEL: Degrees = Degrees(0.0);

/// The direction of a light at an angle from the viewer to the right, raised by another.
pub(super) fn towards(light: Degrees, height: Degrees) -> DVec3 {
    let (sine, cosine) = libm::sincos(Radians::from(light).0);
    let (up, along) = libm::sincos(Radians::from(height).0);
    DVec3::new(sine * along, up, cosine * along)
}

pub(super) fn paint(
    mesh: &TriangleMesh,
    towards: DVec3,
    terminator: Terminator,
    size: [u32; 2],
) -> Result<Image> {
    picture(mesh.object(chalk()), towards, (Shading::Phong, terminator), size)
}

pub(super) fn picture(
    object: Object,
    towards: DVec3,
    (shading, terminator): (Shading, Terminator),
    size: [u32; 2],
) -> Result<Image> {
    let settings = RenderSettings { terminator, ..settings(size, shading, Interpolation::Perspective) };
    let height = WINDOW * f64::from(size[1]) / f64::from(size[0]);
    let light = Light::Directional { towards, colour: LinearRgb::WHITE };
    draw(vec![object], &[light], front(height), &settings)
}

/// 1 for pixels whose normal faces the light and whose facet does not, 0 for others.
pub(super) fn concerned(mesh: &TriangleMesh, towards: DVec3, size: u32) -> Result<Vec<Option<f64>>> {
    let normals = |shading| {
        let settings = RenderSettings {
            show: Show::Normals,
            ..settings([size; 2], shading, Interpolation::Perspective)
        };
        draw(vec![mesh.object(chalk())], &[], front(WINDOW), &settings)
    };
    let light_on = |colour: &[f32; 3]| (DVec3::from(colour.map(f64::from)) * 2.0 - 1.0).dot(towards);
    let (smooth, faces) = (normals(Shading::Phong)?, normals(Shading::Flat)?);
    let pairs = linear(&smooth).iter().zip(linear(&faces)).zip(&smooth.coverage);
    let is_concerned = |((own, face), &covered): ((&[f32; 3], &[f32; 3]), &u8)| {
        (covered > 0).then(|| f64::from(u8::from(light_on(own) > 0.0 && light_on(face) <= 0.0)))
    };
    Ok(pairs.map(is_concerned).collect())
}

/// The share of ones.
pub(super) fn share(map: &[Option<f64>]) -> f64 {
    let covered: Vec<f64> = map.iter().flatten().copied().collect();
    covered.iter().sum::<f64>() / covered.len().max(1) as f64
}

/// The mean of values on pixels that a map has 1 for; 0 if there are none.
pub(super) fn mean_where(map: &[Option<f64>], values: &[Option<f64>]) -> f64 {
    let is_meant = |(&mark, &value): (&Option<f64>, &Option<f64>)| value.filter(|_| mark == Some(1.0));
    let meant: Vec<f64> = map.iter().zip(values).filter_map(is_meant).collect();
    meant.iter().sum::<f64>() / meant.len().max(1) as f64
}
