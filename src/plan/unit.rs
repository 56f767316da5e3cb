//! An object table of a scene file, and its model as declared.

use super::axes::{Normals, ObjectModel, Source, Terms};
use super::cost::Highlight;
use super::document::Document;
use crate::normals::{Precision, Scope};
use crate::raster::{RenderSettings, SceneFile, SceneMesh, SceneObject, SceneShape, Shading, Shape};
use crate::shade::Material;
use std::rc::Rc;

/// An object table of the scene file, which may be several objects of a mesh file.
#[derive(Debug)]
pub struct Unit {
    /// Its name in reports.
    pub name: String,
    /// The objects as declared.
    pub declared: Rc<SceneFile>,
    /// Its model as declared.
    pub reference: ObjectModel,
    /// The material that all its objects have; `None` if they have several, or colours of their vertices.
    pub material: Option<Material>,
    /// Its most expensive highlight.
    pub highlight: Highlight,
    /// Whether the scene marks it as unchanged.
    pub is_kept: bool,
    /// Whether rays are cast at it.
    pub is_cast: bool,
    /// Whether it is tessellated in the default pattern.
    pub has_regular_cells: bool,
    /// Whether its normals differ between hard and smooth edges.
    pub has_splits: bool,
    /// Whether some of its vertices, or normals of vertices, agree.
    pub can_merge: bool,
}

impl Unit {
    /// The table of an object, whose objects are declared like this.
    pub fn new(
        document: &Document,
        object: usize,
        declared: Rc<SceneFile>,
        settings: &RenderSettings,
    ) -> Self {
        let first = &declared.objects[0];
        let is_same = declared.objects.iter().all(|other| other.material == first.material && !other.given);
        let material = is_same.then_some(first.material);
        let has_highlight = |object: &&SceneObject| object.material.specular.merged().largest() > 0.0;
        let highlight = declared.objects.iter().find(has_highlight).map(|object| object.material.reflection);
        let is_cast = declared.objects.iter().all(|object| matches!(object.shape, SceneShape::Surface(_)));
        let SceneObject { settings: own, is_kept, .. } = *first;
        let shading = own.shading.unwrap_or(settings.shading);
        let needs_normals = !is_cast && !matches!(shading, Shading::Flat | Shading::Wireframe);
        let reference = ObjectModel {
            shading,
            normals: needs_normals.then(|| declared_normals(first)),
            interpolation: own.interpolation.unwrap_or(settings.interpolation),
            terms: Terms::Declared,
            segments: document.segments(object).filter(|_| !is_cast),
            merged: first.normals.merge == Some(true),
            two_sided: own.two_sided.unwrap_or(settings.two_sided),
        };
        let has_regular_cells = document.has_regular_cells(object);
        let has_splits = declared.meshes.iter().any(|mesh| {
            let [vertices, normals] = count_vertices(mesh);
            normals > vertices
        });
        let fewer = |mesh: &SceneMesh| count_vertices(&mesh.clone().merged()) != count_vertices(mesh);
        let can_merge = !reference.merged && declared.meshes.iter().any(fewer);
        let name = if first.name.is_empty() { format!("object {object}") } else { first.name.clone() };
        Self {
            name,
            declared,
            reference,
            material,
            highlight,
            is_kept,
            is_cast,
            has_regular_cells,
            has_splits,
            can_merge,
        }
    }
}

/// The vertices that faces of a mesh use, and these counted once for each of their normals.
pub fn count_vertices(SceneMesh { mesh, normals, .. }: &SceneMesh) -> [u64; 2] {
    let used = Shape::Mesh { mesh, normals }.vertex_normals();
    [used.chunk_by(|a, b| a[0] == b[0]).count() as u64, used.len() as u64]
}

/// The normals that an object declares.
fn declared_normals(object: &SceneObject) -> Normals {
    let settings = &object.normals;
    let weight = settings.weight.unwrap_or_default();
    Normals {
        source: if object.keeps_normals { Source::Given } else { Source::Computed(weight) },
        creases: settings.scope != Some(Scope::Vertex),
        precision: settings.precision.unwrap_or(Precision::Faithful),
        format: settings.format,
    }
}
