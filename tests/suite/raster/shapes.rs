//! Scenes to draw.

use crate::random::Random;
use crease::mesh::{Faces, Mesh, MeshBuilder};
use crease::normals::{NormalField, NormalRecipe, compute};
use crease::num::LinearRgb;
use crease::raster::{Camera, Object, Projection, RenderSettings, Scene, Shape};
use crease::shade::{Light, Material};
use glam::DVec3;
use std::collections::BTreeMap;

/// A mesh with its normals.
pub struct Model {
    pub mesh: Mesh,
    pub normals: NormalField,
}

impl Model {
    pub fn new(positions: Vec<DVec3>, faces: Faces) -> Self {
        let mesh =
            MeshBuilder { positions: positions.into(), faces, ..MeshBuilder::default() }.build().unwrap();
        let normals = compute(&mesh, &NormalRecipe::default());
        Self { mesh, normals }
    }

    /// One polygon in a list of corners.
    pub fn polygon(corners: &[DVec3]) -> Self {
        let mut faces = Faces::new();
        faces.push(&(0..corners.len() as u32).collect::<Vec<_>>());
        Self::new(corners.to_vec(), faces)
    }

    pub fn shape(&self) -> Shape<'_> {
        Shape::Mesh { mesh: &self.mesh, normals: &self.normals }
    }

    pub fn object(&self) -> Object<'_> {
        Object::new(self.shape(), Material::default())
    }

    /// Puts other normals in place of those computed: one for each vertex.
    pub fn with_vertex_normals(mut self, normal: impl Fn(DVec3) -> DVec3) -> Self {
        let values = self.normals.entry_vertex.iter().map(|&v| normal(self.mesh.positions().at(v)));
        self.normals.normals.values = values.collect();
        self
    }
}

/// The icosahedron's faces cut in four `level` times, on the unit sphere, with the sphere's own normals.
pub fn icosphere(level: usize) -> Model {
    let t = (1.0 + 5.0_f64.sqrt()) / 2.0;
    let mut positions: Vec<DVec3> = [
        [-1.0, t, 0.0],
        [1.0, t, 0.0],
        [-1.0, -t, 0.0],
        [1.0, -t, 0.0],
        [0.0, -1.0, t],
        [0.0, 1.0, t],
        [0.0, -1.0, -t],
        [0.0, 1.0, -t],
        [t, 0.0, -1.0],
        [t, 0.0, 1.0],
        [-t, 0.0, -1.0],
        [-t, 0.0, 1.0],
    ]
    .map(|p| DVec3::from(p).normalize())
    .to_vec();
    let mut triangles: Vec<[u32; 3]> = vec![
        [0, 11, 5],
        [0, 5, 1],
        [0, 1, 7],
        [0, 7, 10],
        [0, 10, 11],
        [1, 5, 9],
        [5, 11, 4],
        [11, 10, 2],
        [10, 7, 6],
        [7, 1, 8],
        [3, 9, 4],
        [3, 4, 2],
        [3, 2, 6],
        [3, 6, 8],
        [3, 8, 9],
        [4, 9, 5],
        [2, 4, 11],
        [6, 2, 10],
        [8, 6, 7],
        [9, 8, 1],
    ];
    for _ in 0..level {
        let mut middles: BTreeMap<(u32, u32), u32> = BTreeMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                positions.push((positions[a as usize] + positions[b as usize]).normalize());
                positions.len() as u32 - 1
            })
        };
        let quarters = triangles.iter().flat_map(|&[a, b, c]| {
            let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
            [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
        });
        triangles = quarters.collect();
    }
    Model::new(positions, Faces::triangles(triangles.into_flattened())).with_vertex_normals(DVec3::normalize)
}

/// A closed, bumpy shape: an icosphere with its vertices moved in and out.
pub fn bumpy(level: usize, random: &mut Random) -> Model {
    let Model { mesh, .. } = icosphere(level);
    let positions = mesh.positions().iter().map(|p| p * (0.6 + 0.8 * unit(random))).collect();
    Model::new(positions, mesh.faces().clone())
}

/// A number from 0 to 1.
pub fn unit(random: &mut Random) -> f64 {
    (random.next() >> 11) as f64 / (1_u64 << 53) as f64
}

/// A scene of some objects before a black background, seen along −z from a distance, with one light behind the viewer.
pub fn scene(objects: Vec<Object>) -> Scene {
    Scene {
        objects,
        lines: Vec::new(),
        lights: vec![Light::Directional { towards: DVec3::new(0.3, 0.4, 1.0), colour: LinearRgb::WHITE }],
        camera: Camera {
            eye: DVec3::new(0.0, 0.0, 4.0),
            target: DVec3::ZERO,
            up: DVec3::Y,
            projection: Projection::Perspective(crease::num::Degrees(40.0).into()),
            near: 0.1,
        },
        background: LinearRgb::BLACK,
    }
}

/// A camera whose pixels are units of the scene, with (0, 0) at the lower left corner of the picture.
pub fn pixel_camera([width, height]: [u32; 2]) -> Camera {
    let middle = DVec3::new(f64::from(width), f64::from(height), 0.0) * 0.5;
    Camera {
        eye: middle + DVec3::Z * 100.0,
        target: middle,
        up: DVec3::Y,
        projection: Projection::Orthographic(f64::from(height)),
        near: 0.0,
    }
}

/// Settings for metrics: linear colours are kept.
pub fn linear(size: [u32; 2]) -> RenderSettings {
    RenderSettings { size, keep_linear: true, ..RenderSettings::default() }
}
