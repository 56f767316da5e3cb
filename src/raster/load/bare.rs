//! From a mesh file to a scene.

use super::lights::plain_material;
use super::{LoadOptions, SceneFile, SceneMesh, SceneObject, SceneShape};
use crate::io::{FileNode, Loaded, Place, Problem, ReadError};
use crate::num::LinearRgb;
use crate::raster::RenderSettings;
use glam::DMat4;
use rayon::prelude::*;

impl SceneFile {
    /// A file that is read, as a scene: every part at every place where it stands, framed by itself.
    ///
    /// # Errors
    /// If it has no faces.
    pub fn from_loaded(loaded: Loaded, options: &LoadOptions) -> Result<Self, ReadError> {
        let Loaded { format, parts, mut nodes, notes, .. } = loaded;
        if nodes.is_empty() && !format.is_gltf() {
            let as_it_stands = |(part, name)| FileNode { name, part, world_from_part: DMat4::IDENTITY };
            nodes = parts.iter().map(|part| part.name.clone()).enumerate().map(as_it_stands).collect();
        }
        nodes.retain(|node| parts[node.part].mesh.face_count() > 0);
        if nodes.is_empty() {
            let found = "there are no faces to draw";
            return Err(ReadError::new(Problem::Unsupported, Place::File, found, "give a mesh with faces"));
        }
        let meshes: Vec<SceneMesh> =
            parts.into_par_iter().map(|part| SceneMesh::new(part, format, options)).collect();
        let object = |node: FileNode| SceneObject {
            name: node.name,
            shape: SceneShape::Mesh(node.part),
            transform: node.world_from_part,
            material: plain_material(),
            given: false,
            surface: None,
        };
        Ok(Self {
            meshes,
            objects: nodes.into_iter().map(object).collect(),
            lights: None,
            camera: None,
            background: LinearRgb::BLACK,
            settings: RenderSettings::default(),
            notes,
        })
    }
}
