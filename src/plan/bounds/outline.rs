//! The bound on the outline of a coarser sphere or ellipsoid, in pixels.
//!
//! The mesh of a sphere of radius R with u × v cells is inside the sphere. Each of its faces has two corners at each of two latitudes, or one at
//! a pole. In the plane of its meridian it is a chord of an arc of π/v, with the distances from the axis times cos(π/u). So its plane is at
//! least R cos(π/u) cos(π/2v) from the centre, and a ray from the centre leaves any finer mesh at most R (1 − cos(π/u) cos(π/2v)) farther away: for
//! circles of n corners R (1 − cos(π/n)). A map scales this distance by its largest stretch at most.
//!
//! Both meshes are convex, so their outlines are no farther apart than the pictures of two such points. At a distance δ, both deeper than z and at
//! most t times their depth aside of the axis, these are at most f δ √(1 + t²)/z pixels apart, f being the focal length in pixels.

use crate::plan::stage::Stage;
use crate::plan::views::View;
use crate::raster::{Camera, Projection, SceneObject};
use crate::surface::Primitive;
use glam::{DMat3, DVec3};
use std::f64::consts::PI;

/// The largest distance between the outlines of the declared tessellation of a unit and of a coarser regular one, in pixels, over all views.
/// `None` for other surfaces, other patterns, and cameras that are closer than the surface is large.
pub fn outline_bound(stage: &Stage, unit: usize, [u, v]: [u32; 2], views: &[View]) -> Option<f64> {
    let unit = &stage.units[unit];
    let [object] = &unit.declared.objects[..] else { return None };
    let share = 1.0 - libm::cos(PI / f64::from(u)) * libm::cos(0.5 * PI / f64::from(v));
    let ball = enclosing_ball(object).filter(|_| unit.has_regular_cells)?;
    let height = f64::from(stage.settings.size[1]);
    let mut most = 0.0_f64;
    for view in views {
        most = most.max(pixels_per_unit(&view.camera, ball, height)? * share * ball.1);
    }
    Some(most)
}

/// A ball around a sphere or an ellipsoid in the scene, whose radius is the largest distance of the surface from its centre.
fn enclosing_ball(object: &SceneObject) -> Option<(DVec3, f64)> {
    let semi_axes = match object.surface? {
        Primitive::Sphere(sphere) => DVec3::splat(sphere.radius()),
        Primitive::Ellipsoid(ellipsoid) => ellipsoid.semi_axes(),
        _ => return None,
    };
    let linear = DMat3::from_mat4(object.transform) * DMat3::from_diagonal(semi_axes);
    Some((object.transform.w_axis.truncate(), largest_stretch(linear)))
}

/// A bound on the largest factor by which a map stretches: the square root of the largest sum of absolute values in a row of AᵀA, which no
/// eigenvalue exceeds. It is reached by maps with orthogonal columns.
fn largest_stretch(linear: DMat3) -> f64 {
    let gram = linear.transpose() * linear;
    [gram.x_axis, gram.y_axis, gram.z_axis]
        .map(|row| row.abs().element_sum())
        .into_iter()
        .fold(0.0, f64::max)
        .sqrt()
}

/// The most pixels by which a distance of 1 between points of a ball is seen.
fn pixels_per_unit(camera: &Camera, (middle, radius): (DVec3, f64), height: f64) -> Option<f64> {
    let angle = match camera.projection {
        Projection::Orthographic(seen) => return Some(height / seen),
        Projection::Perspective(angle) => angle,
    };
    let forward = (camera.target - camera.eye).normalize_or_zero();
    let to_middle = middle - camera.eye;
    let depth = to_middle.dot(forward);
    let nearest = depth - radius;
    let aside = ((to_middle - forward * depth).length() + radius) / nearest;
    let focal = 0.5 * height / libm::tan(0.5 * angle.0);
    (nearest > camera.near).then(|| focal * libm::hypot(aside, 1.0) / nearest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::document::Document;
    use crate::raster::{LoadOptions, SceneFile};
    use crate::trade::direction;
    use glam::{DVec2, dvec2};
    use std::path::Path;

    /// The farthest corner of a picture of an object in a direction.
    fn support(file: &SceneFile, camera: &Camera, height: f64, towards: DVec2) -> f64 {
        let [right, up, forward] = camera.axes().unwrap();
        let mut farthest = f64::NEG_INFINITY;
        for position in file.meshes[0].mesh.positions().iter() {
            let from_eye = file.objects[0].transform.transform_point3(position) - camera.eye;
            let scale = match camera.projection {
                Projection::Orthographic(seen) => height / seen,
                Projection::Perspective(angle) => {
                    0.5 * height / libm::tan(0.5 * angle.0) / from_eye.dot(forward)
                }
            };
            let pixel = scale * dvec2(from_eye.dot(right), from_eye.dot(up));
            farthest = farthest.max(pixel.dot(towards));
        }
        farthest
    }

    /// The distance of two convex outlines is the largest difference of their supports.
    #[test]
    fn no_outline_exceeds_the_bound() {
        let mut closest = 1.0_f64;
        let mut least = 0.0_f64;
        for seed in 0..60 {
            let shape =
                ["sphere = { radius = 1 }", "ellipsoid = { semi-axes = [1, 0.5, 2] }"][seed as usize % 2];
            let projection = ["angle = 40", "height = 5"][seed as usize / 2 % 2];
            let eye = (direction(3 * seed) * (4.0 + 8.0 * direction(3 * seed + 1).z.abs())).to_array();
            let scene = |cells: [u32; 2]| {
                format!(
                    "[settings]\nsize = [400, 300]\n[camera]\neye = {eye:?}\ntarget = [0.1, 0.2, 0]\n{projection}\n[[object]]\n\
                     surface = {{ {shape} }}\ntessellation = {{ segments = {cells:?} }}\ntransform = [{{ rotate = [20, 50, 0] }}, \
                     {{ scale = [1, 1, 0.8] }}]\n"
                )
            };
            let cells = [[6, 4], [9, 5], [16, 8]][seed as usize % 3];
            let (text, options) = (scene([64, 32]), LoadOptions::default());
            let whole = SceneFile::from_toml(&text, Path::new("."), &options).unwrap();
            let document = Document::parse(&text).unwrap().with_tables();
            let stage = Stage::new(&document, &whole, Path::new("."), &options).unwrap();
            let camera = whole.scene().camera;
            let view = View::new(
                &stage,
                camera,
                &[],
                crate::plan::views::Turn::sampled(crate::num::Degrees(0.0), DVec3::ZERO)[0],
            )
            .unwrap();
            let bound = outline_bound(&stage, 0, cells, &[view]).unwrap();
            let coarse = SceneFile::from_toml(&scene(cells), Path::new("."), &options).unwrap();
            let mut distance = 0.0_f64;
            for step in 0..360 {
                let towards = DVec2::from_angle(f64::from(step).to_radians());
                let [one, other] = [&whole, &coarse].map(|file| support(file, &camera, 300.0, towards));
                distance = distance.max((one - other).abs());
            }
            assert!(distance <= bound, "{seed}: {distance}, bound {bound}");
            least = least.max(distance / bound);
            closest = closest.min(distance / bound);
        }
        assert!(least > 0.6 && closest > 0.1, "{least} {closest}");
    }
}
