//! How much the normals and positions within a face of an object vary.

use crate::mesh::normal_matrix;
use crate::num::angle_between;
use crate::raster::{Camera, Projection, SceneFile, SceneMesh, SceneShape};
use glam::{DMat3, DVec3};

/// The largest differences within a face of a unit, over all its faces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// A length that no weighted mean of the normals at the corners of a face falls below.
    pub shortest: f64,
    /// Angle between the normals of two corners, in radians.
    pub corners: f64,
    /// Angle between the normal of a face and that of a corner, in radians.
    pub from_face: f64,
    /// Distance of two corners, in the scene's units.
    pub extent: f64,
}

impl Spread {
    /// Of the meshes of a unit. `None` if corner normals of a face point into opposite half-spaces, or if a transform changes
    /// angles, so that errors of normals do not stay the same.
    pub fn of(file: &SceneFile) -> Option<Self> {
        let mut most = Self { shortest: 1.0, corners: 0.0, from_face: 0.0, extent: 0.0 };
        for object in &file.objects {
            let SceneShape::Mesh(number) = object.shape else { return None };
            let scale = uniform_scale(DMat3::from_mat4(object.transform))?;
            let SceneMesh { mesh, normals, .. } = &file.meshes[number];
            for face in 0..mesh.face_count() {
                let range = mesh.faces().range(face);
                let vertices = &mesh.faces().corners()[range.clone()];
                let of_corner = |(corner, &vertex)| normals.normals.get(corner, vertex).copied();
                let corners: Option<Vec<DVec3>> = range.zip(vertices).map(of_corner).collect();
                let corners = corners?;
                let points: Vec<DVec3> = vertices.iter().map(|&vertex| mesh.positions().at(vertex)).collect();
                // All of them are on one side of this plane, so their means are as well.
                let axis = corners.iter().sum::<DVec3>().normalize_or_zero();
                let face_normal = *normals.face_normals.get(face)?;
                for (at, &normal) in corners.iter().enumerate() {
                    most.shortest = most.shortest.min(normal.dot(axis));
                    most.from_face = most.from_face.max(angle(normal, face_normal));
                    for (&other, point) in corners[..at].iter().zip(&points) {
                        most.corners = most.corners.max(angle(normal, other));
                        most.extent = most.extent.max(scale * points[at].distance(*point));
                    }
                }
            }
        }
        (most.shortest > 0.0).then_some(most)
    }
}

/// The scale of a map that is made of rotations, reflections and one scale; `None` for others.
fn uniform_scale(linear: DMat3) -> Option<f64> {
    /// Such maps keep angles to some roundings.
    const ROUNDING: f64 = 1e-12;
    normal_matrix(linear)?;
    let gram = linear.transpose() * linear;
    let square = gram.x_axis.x;
    gram.abs_diff_eq(DMat3::from_diagonal(DVec3::splat(square)), ROUNDING * square).then(|| square.sqrt())
}

/// The angle between unit vectors at the distance of two stored normals, whose lengths rounding may have changed, or their own
/// angle if that is larger.
fn angle(a: DVec3, b: DVec3) -> f64 {
    let chord = 2.0 * libm::asin((0.5 * a.distance(b)).min(1.0));
    chord.max(angle_between(a, b).0)
}

/// The largest angle between normals at the same corners of two versions of a unit; `None` if they have other corners.
pub fn angle_between_normals(file: &SceneFile, other: &SceneFile) -> Option<f64> {
    let mut largest = 0.0_f64;
    for (one, two) in file.meshes.iter().zip(&other.meshes) {
        let vertices = one.mesh.faces().corners();
        if two.mesh.faces().corners() != vertices {
            return None;
        }
        for (corner, &vertex) in vertices.iter().enumerate() {
            let [a, b] = [one, two].map(|mesh| mesh.normals.normals.get(corner, vertex).copied());
            largest = largest.max(angle(a?, b?));
        }
    }
    (file.meshes.len() == other.meshes.len()).then_some(largest)
}

/// The largest share by which the weights of corners differ between affine and perspective interpolation, over all faces and cameras:
/// (√ρ − 1)/(√ρ + 1) for depths whose ratio within a face is ρ. `None` for faces that reach behind a camera.
pub fn depth_share(file: &SceneFile, cameras: &[Camera]) -> Option<f64> {
    let mut largest = 0.0_f64;
    let cameras = cameras.iter().filter(|camera| !matches!(camera.projection, Projection::Orthographic(_)));
    for camera in cameras {
        let forward = (camera.target - camera.eye).normalize_or_zero();
        for object in &file.objects {
            let SceneShape::Mesh(number) = object.shape else { return None };
            let mesh = &file.meshes[number].mesh;
            for face in 0..mesh.face_count() {
                let [mut near, mut far] = [f64::INFINITY, 0.0_f64];
                for &vertex in mesh.faces().face(face) {
                    let point = object.transform.transform_point3(mesh.positions().at(vertex));
                    let depth = (point - camera.eye).dot(forward);
                    (near, far) = (near.min(depth), far.max(depth));
                }
                let root = (far / near).sqrt();
                largest = largest.max((near > 0.0).then(|| (root - 1.0) / (root + 1.0))?);
            }
        }
    }
    Some(largest)
}
