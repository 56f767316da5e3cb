//! The point of a face that a place of the picture sees, in double precision.

use super::job::Job;
use super::triangles::DrawnObject;
use glam::DVec3;

/// Barycentric coordinates in the scene of the point of a triangle's plane that a place of the picture sees, by edge
/// functions in homogeneous coordinates, which hold behind the eye as well (Olano & Greer 1997).
pub(super) fn weights(job: &Job, drawn: &DrawnObject, triangle: [u32; 3], at: [f64; 2]) -> [f64; 3] {
    let [mx, my] = job.view.middle();
    let ray = DVec3::new(at[0] - mx, at[1] - my, 1.0);
    let [a, b, c] = triangle.map(|vertex| {
        let point = drawn.map.view(drawn.points.get(vertex));
        DVec3::new(point.x, point.y, point.h)
    });
    shares([ray.dot(b.cross(c)), ray.dot(c.cross(a)), ray.dot(a.cross(b))])
}

/// That point relative to the eye, in the scene's axes.
pub(super) fn from_eye(drawn: &DrawnObject, triangle: [u32; 3], weights: [f64; 3]) -> DVec3 {
    let corner = |vertex| drawn.map.scene_point(drawn.points.get(vertex));
    triangle.into_iter().zip(weights).map(|(vertex, weight)| corner(vertex) * weight).sum()
}

/// Parts as shares of their sum.
pub(super) fn shares(parts: [f64; 3]) -> [f64; 3] {
    let sum: f64 = parts.iter().sum();
    parts.map(|part| part / sum)
}
