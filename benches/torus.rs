//! The scene that drawing and tracing are measured on: a torus that covers 40 % of 1920 × 1080 pixels, one directional light.

use crease::num::{Degrees, LinearRgb};
use crease::raster::{Camera, Object, Projection, Scene, Shape, Triangles};
use crease::shade::{Light, Material};
use glam::DVec3;
use std::f64::consts::TAU;

pub const SIZE: [u32; 2] = [1920, 1080];
pub const TOWARDS: DVec3 = DVec3::new(0.4, 0.6, 1.0);
const EYE: DVec3 = DVec3::new(0.0, 3.2, 4.0);

/// The vertical angle with which the torus covers 40 % of the picture.
const ANGLE: f64 = 27.25;

/// Resident buffers in single precision.
pub struct Torus {
    pub positions: Vec<[f32; 3]>,
    pub triangles: Vec<[u32; 3]>,
    pub normals: Vec<[f32; 3]>,
    pub face_normals: Vec<[f32; 3]>,
}

impl Torus {
    /// A torus of about this many triangles, in rows around the tube.
    pub fn new(triangles: usize) -> Self {
        let around = ((triangles as f64).sqrt() as usize).next_multiple_of(2);
        let across = (triangles / 2).div_ceil(around);
        let (mut positions, mut normals, mut list) = (Vec::new(), Vec::new(), Vec::new());
        for i in 0..around {
            for j in 0..across {
                let (u, v) = (TAU * i as f64 / around as f64, TAU * j as f64 / across as f64);
                let ((su, cu), (sv, cv)) = (libm::sincos(u), libm::sincos(v));
                let normal = DVec3::new(cv * su, sv, cv * cu);
                positions.push((DVec3::new(su, 0.0, cu) + normal * 0.4).as_vec3().to_array());
                normals.push(normal.as_vec3().to_array());
                let at = |i: usize, j: usize| (i % around * across + j % across) as u32;
                list.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
                list.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
            }
        }
        let mut face_normals = vec![[0.0; 3]; list.len()];
        let mut scratch = crease::normals::Scratch::new();
        crease::normals::face_normals(&positions, &list, &mut scratch, &mut face_normals)
            .expect("the mesh is sound");
        Self { positions, triangles: list, normals, face_normals }
    }

    pub fn scene(&self) -> Scene<'_> {
        let shape = Shape::Triangles(Triangles {
            positions: &self.positions,
            triangles: &self.triangles,
            normals: &self.normals,
            face_normals: &self.face_normals,
        });
        Scene {
            objects: vec![Object::new(shape, Material::default())],
            lines: Vec::new(),
            lights: vec![Light::Directional { towards: TOWARDS, colour: LinearRgb::WHITE }],
            camera: camera(),
            background: LinearRgb::BLACK,
        }
    }
}

pub fn camera() -> Camera {
    Camera {
        eye: EYE,
        target: DVec3::ZERO,
        up: DVec3::Y,
        projection: Projection::Perspective(Degrees(ANGLE).into()),
        near: 0.1,
    }
}
