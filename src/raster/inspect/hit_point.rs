//! The point of a face that a place of the picture sees, in double precision.

use crate::num::{self, Split};
use crate::raster::coverage::triangles::DrawnObject;
use crate::raster::frame::job::Job;
use glam::DVec3;

/// A point of the plane of a triangle.
pub(crate) struct SeenPoint {
    /// Its barycentric coordinates in the scene.
    pub(crate) weights: [f64; 3],
    /// Where it is relative to the eye, in the scene's axes: on the ray, however far away corners are.
    pub(crate) from_eye: DVec3,
}

/// The point of a triangle's plane that a place of the picture sees, by edge functions in homogeneous coordinates, which
/// hold behind the eye as well (Olano & Greer 1997).
pub(crate) fn seen_point(job: &Job, drawn: &DrawnObject, triangle: [u32; 3], at: [f64; 2]) -> SeenPoint {
    let [mx, my] = job.view.middle();
    let ray = DVec3::new(at[0] - mx, at[1] - my, 1.0);
    let seen = triangle.map(|vertex| drawn.map.view(drawn.points.get(vertex)));
    let corners = seen.map(|point| DVec3::new(point.x, point.y, point.h));
    let normals = [0, 1, 2].map(|k| num::cross::<Split>(corners[(k + 1) % 3], corners[(k + 2) % 3]));
    let parts = normals.map(|normal| ray.dot(normal));
    let weights = shares(parts);
    let distance = if job.view.perspective {
        // The determinant of the corners, by that one of them whose products have the least to lose. Their mean would be
        // what is left of distances in front of the eye and behind it.
        let products = [0, 1, 2].map(|k| corners[k] * normals[k]);
        let size = |product: &&DVec3| product.abs().element_sum();
        let least = products.iter().min_by(|a, b| size(a).total_cmp(&size(b)));
        least.map_or(f64::NAN, |product| product.element_sum()) / parts.iter().sum::<f64>()
    } else {
        (0..3).map(|k| seen[k].z * weights[k]).sum()
    };
    let (start, direction) = job.view.ray(at);
    SeenPoint { weights, from_eye: start + direction * distance }
}

/// Parts as shares of their sum.
pub(crate) fn shares(parts: [f64; 3]) -> [f64; 3] {
    let sum: f64 = parts.iter().sum();
    parts.map(|part| part / sum)
}
