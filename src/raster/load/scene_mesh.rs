//! The meshes of a scene: a part of a file with its normals, and its division by material.

use crate::io::{Format, Part};
use crate::mesh::{Column, Columns, FaceEdit, Faces, MeshBuilder, NONE};
use crate::normals::{Faults, NormalField};
use crate::num::parallel;
use crate::num::{LinearRgb, Transfer};
use crate::raster::load::normal_settings::NormalSettings;
use crate::raster::load::scene_file::{LoadOptions, SceneMesh};
use glam::DVec3;
use std::collections::HashMap;

impl SceneMesh {
    /// A part of a file in this format, without the faces that use non-finite positions.
    pub(super) fn new(part: Part, format: Format, options: &LoadOptions) -> Self {
        let Part { mesh, non_finite_faces, .. } = part;
        let source_faces = (!non_finite_faces.is_empty()).then(|| {
            let all = 0..mesh.face_count() as u32;
            all.filter(|face| non_finite_faces.binary_search(face).is_err()).collect()
        });
        let mesh = mesh.with_faces(&FaceEdit { dropped: non_finite_faces, reversed: Vec::new() });
        let colours = mesh.columns().colors.as_ref().map(|colours| linear(colours, format));
        let normals = options.normals.normals(&mesh, &options.recipe, options.when.unwrap_or_default());
        Self { mesh, normals, colours, source_faces }
    }
}

impl SceneMesh {
    /// The mesh as it is stored: vertices merged if that is wanted, and normals rounded. Those of faces are not stored, since they follow from
    /// positions.
    pub(super) fn stored(self, settings: &NormalSettings) -> Self {
        let mut mesh = if settings.merge == Some(true) { self.merged() } else { self };
        if let Some(format) = settings.format {
            format.round(&mut mesh.normals);
        }
        mesh
    }

    /// The mesh whose vertices at equal positions with equal colours are one, the first of them, without those that no face uses. Equal
    /// normals are one as well. Corners have the same values as before.
    pub(crate) fn merged(self) -> Self {
        let Self { mesh, normals: field, colours, source_faces } = self;
        let corners = mesh.faces().corners();
        let mut representative = mesh.first_vertices();
        if let Some(colours) = &colours {
            let mut known = HashMap::new();
            for (vertex, first) in (0..).zip(&mut representative) {
                let bits = colours[vertex as usize].to_array().map(f64::to_bits);
                *first = *known.entry((*first, bits)).or_insert(vertex);
            }
        }
        let mut slots = field.normals.corner_index(corners);
        let mut known = HashMap::new();
        for slot in slots.iter_mut().filter(|slot| **slot != NONE) {
            let bits = field.normals.values[*slot as usize].to_array().map(f64::to_bits);
            *slot = *known.entry(bits).or_insert(*slot);
        }
        let mut numbers = vec![NONE; mesh.vertex_count()];
        let kept = number(&mut numbers, corners.iter().map(|&vertex| representative[vertex as usize]));
        let mut values = vec![NONE; field.normals.values.len()];
        let kept_values = number(&mut values, slots.iter().copied().filter(|&slot| slot != NONE));
        let mut faces = Faces::with_capacity(corners.len());
        let mut face_vertices = Vec::new();
        for face in 0..mesh.face_count() {
            face_vertices.clear();
            let vertices = mesh.faces().face(face).iter();
            face_vertices.extend(vertices.map(|&v| numbers[representative[v as usize] as usize]));
            faces.push(&face_vertices);
        }
        let index = slots.iter().map(|&slot| if slot == NONE { NONE } else { values[slot as usize] });
        let kept_normals = kept_values.iter().map(|&value| field.normals.values[value as usize]).collect();
        let normals = Column::per_corner(kept_normals, index.collect());
        let entry_vertex = entry_vertices(&normals, &faces);
        let normals = NormalField {
            normals,
            entry_vertex,
            morph_normals: Vec::new(),
            // Their numbers are those of the mesh before.
            faults: Faults::default(),
            ..field
        };
        let colours = colours.map(|colours| kept.iter().map(|&vertex| colours[vertex as usize]).collect());
        let positions = mesh.positions().gather(&kept);
        let builder = MeshBuilder { positions, faces, columns: Columns::default() };
        let mesh = builder.build().expect("the vertices of a mesh that was checked");
        Self { mesh, normals, colours, source_faces }
    }

    /// One face with its normals, whose vertices and corners are numbered in its order.
    pub(crate) fn of_face(&self, face: u32) -> Self {
        let (mesh, field) = (&self.mesh, &self.normals);
        let range = mesh.faces().range(face as usize);
        let vertices = &mesh.faces().corners()[range.clone()];
        let corners = 0..vertices.len() as u32;
        let mut faces = Faces::with_capacity(vertices.len());
        faces.push(&corners.clone().collect::<Vec<_>>());
        let normal =
            |(corner, &vertex): (usize, &u32)| field.normals.get(corner, vertex).copied().unwrap_or_default();
        let normals = NormalField {
            normals: Column::per_corner(range.zip(vertices).map(normal).collect(), corners.clone().collect()),
            entry_vertex: corners.collect(),
            face_normals: vec![field.face_normals[face as usize]],
            ..NormalField::default()
        };
        let positions = mesh.positions().gather(vertices);
        let builder = MeshBuilder { positions, faces, columns: Columns::default() };
        let mesh = builder.build().expect("a face of a mesh that was checked");
        let colours = self.colours.as_ref().map(|all| vertices.iter().map(|&v| all[v as usize]).collect());
        Self { mesh, normals, colours, source_faces: None }
    }
}

/// Colours of vertices. Those of glTF are linear; other formats do not say, and their programs write what screens show.
fn linear(colours: &[[f32; 4]], format: Format) -> Vec<LinearRgb> {
    let decode = |component: f32| match format {
        Format::Gltf | Format::Glb => f64::from(component),
        Format::Obj | Format::Ply | Format::Stl | Format::ThreeMf => {
            Transfer::Srgb.decode(f64::from(component))
        }
    };
    parallel::map_each(colours, |&[r, g, b, _]| [r, g, b].map(decode).into())
}

/// The faces of each label as a mesh of its own with the vertices that it uses and the normals of the whole, in the order of
/// labels ([`NONE`] last). The mesh itself if all faces have the same label.
pub(super) fn by_label(whole: SceneMesh, label_of_face: &[u32]) -> Vec<(u32, SceneMesh)> {
    let first = label_of_face.first().copied().unwrap_or(NONE);
    if label_of_face.iter().all(|&label| label == first) {
        return vec![(first, whole)];
    }
    let mut faces: Vec<u32> = (0..label_of_face.len() as u32).collect();
    faces.sort_by_key(|&face| label_of_face[face as usize]);
    let mut numbers = NewNumbers {
        vertices: vec![NONE; whole.mesh.vertex_count()],
        values: vec![NONE; whole.normals.normals.values.len()],
    };
    faces
        .chunk_by(|&a, &b| label_of_face[a as usize] == label_of_face[b as usize])
        .map(|faces| (label_of_face[faces[0] as usize], numbers.submesh(&whole, faces)))
        .collect()
}

/// New numbers of vertices and of values, [`NONE`] between submeshes.
struct NewNumbers {
    vertices: Vec<u32>,
    values: Vec<u32>,
}

impl NewNumbers {
    fn submesh(&mut self, whole: &SceneMesh, faces: &[u32]) -> SceneMesh {
        let (mesh, field) = (&whole.mesh, &whole.normals);
        let corners = || faces.iter().flat_map(|&face| mesh.faces().range(face as usize));
        let vertex_of = |corner: usize| mesh.faces().corners()[corner];
        let slot_of = |corner: usize| field.normals.slot(corner, vertex_of(corner));
        let kept_vertices = number(&mut self.vertices, corners().map(vertex_of));
        let kept_values = number(&mut self.values, corners().filter_map(slot_of));

        let mut part_faces = Faces::with_capacity(corners().count());
        let mut face_vertices = Vec::new();
        for &face in faces {
            face_vertices.clear();
            let vertices = mesh.faces().face(face as usize).iter();
            face_vertices.extend(vertices.map(|&vertex| self.vertices[vertex as usize]));
            part_faces.push(&face_vertices);
        }
        let index = corners().map(|corner| slot_of(corner).map_or(NONE, |slot| self.values[slot as usize]));
        let values = kept_values.iter().map(|&value| field.normals.values[value as usize]).collect();
        let normals = Column::per_corner(values, index.collect());
        let entry_vertex = entry_vertices(&normals, &part_faces);
        let normals = NormalField {
            normals,
            entry_vertex,
            face_normals: faces.iter().map(|&face| field.face_normals[face as usize]).collect(),
            morph_normals: Vec::new(),
            // Their numbers are those of the whole.
            faults: Faults::default(),
            summary: field.summary,
        };
        let builder = MeshBuilder {
            positions: mesh.positions().gather(&kept_vertices),
            faces: part_faces,
            columns: Columns::default(),
        };
        let colours = whole.colours.as_ref();
        let colours =
            colours.map(|colours| kept_vertices.iter().map(|&vertex| colours[vertex as usize]).collect());
        let source = |&face: &u32| whole.source_faces.as_ref().map_or(face, |faces| faces[face as usize]);
        let source_faces = Some(faces.iter().map(source).collect());
        kept_vertices.iter().for_each(|&vertex| self.vertices[vertex as usize] = NONE);
        kept_values.iter().for_each(|&value| self.values[value as usize] = NONE);
        let mesh = builder.build().expect("part of a mesh that was checked");
        SceneMesh { mesh, normals, colours, source_faces }
    }
}

/// The first vertex with each value.
fn entry_vertices(normals: &Column<DVec3>, faces: &Faces) -> Vec<u32> {
    let mut vertices = vec![0; normals.values.len()];
    for (corner, &vertex) in faces.corners().iter().enumerate().rev() {
        if let Some(slot) = normals.slot(corner, vertex) {
            vertices[slot as usize] = vertex;
        }
    }
    vertices
}

/// Numbers what is used in ascending order, and returns it.
fn number(numbers: &mut [u32], used: impl Iterator<Item = u32>) -> Vec<u32> {
    let mut kept: Vec<u32> = Vec::new();
    for old in used {
        if numbers[old as usize] == NONE {
            numbers[old as usize] = 0;
            kept.push(old);
        }
    }
    kept.sort_unstable();
    kept.iter().zip(0..).for_each(|(&old, new)| numbers[old as usize] = new);
    kept
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::{Format, ReadOptions, read_bytes};
    use crate::normals::When;

    #[test]
    fn parts_keep_what_they_had_in_the_whole() {
        let text = "v 0 0 0 1 0 0\nv 1 0 0\nv 1 1 0 0 1 0\nv 0 1 0\nv 2 0 1\nv 2 1 1 0 0 1\nv 9 9 9\n\
            f 1 2 3\nusemtl b\nf 2 5 6 3\nusemtl a\nf 1 3 4\nusemtl b\nf 6 5 2\n";
        let loaded = read_bytes(text.into(), Some(Format::Obj), None, &ReadOptions::default()).unwrap();
        let part = loaded.parts[0].clone();
        let labels = part.mesh.columns().materials.clone().unwrap();
        let whole = SceneMesh::new(part, Format::Obj, &LoadOptions::default());
        let parts = by_label(whole.clone(), &labels.of_face);
        let found: Vec<_> = parts.iter().map(|(label, part)| (*label, part.source_faces.clone())).collect();
        assert_eq!(found, [(0, Some(vec![1, 3])), (1, Some(vec![2])), (NONE, Some(vec![0]))]);
        for (_, part) in &parts {
            let (mesh, normals) = (&part.mesh, &part.normals);
            for (face, &source) in part.source_faces.as_ref().unwrap().iter().enumerate() {
                assert_eq!(normals.face_normals[face], whole.normals.face_normals[source as usize]);
                let (here, there) = (mesh.faces().range(face), whole.mesh.faces().range(source as usize));
                for (corner, old) in here.zip(there) {
                    let (vertex, was) = (mesh.faces().corners()[corner], whole.mesh.faces().corners()[old]);
                    assert_eq!(mesh.positions().at(vertex), whole.mesh.positions().at(was));
                    assert_eq!(normals.normals.get(corner, vertex), whole.normals.normals.get(old, was));
                    let colour =
                        |mesh: &SceneMesh, vertex: u32| mesh.colours.as_ref().unwrap()[vertex as usize];
                    assert_eq!(colour(part, vertex), colour(&whole, was));
                }
            }
            let slots = normals.normals.corner_index(mesh.faces().corners());
            let used = |list: &[u32], count: usize| (0..count as u32).all(|number| list.contains(&number));
            assert!(
                used(mesh.faces().corners(), mesh.vertex_count()) && used(&slots, normals.entry_vertex.len())
            );
        }
        assert_eq!(by_label(whole.clone(), &[7; 4]), [(7, whole)]);
    }

    /// Six corners at four positions, of which two have another colour at one of the vertices.
    #[test]
    fn merged_vertices_keep_the_values_of_corners() {
        let text = "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0 1 0 0\nv 9 9 9 1 0 0\nv 0 0 0 1 0 0\nv 1 1 0 0 1 0\nv 0 1 0 1 0 0\n\
            vn 0 0 2\nvn 0 0 2\nvn 0 3 4\nf 1//1 2//1 3//3\nf 5//2 6//3 7//1\n";
        let loaded = read_bytes(text.into(), Some(Format::Obj), None, &ReadOptions::default()).unwrap();
        let options = LoadOptions { when: Some(When::Missing), ..LoadOptions::default() };
        let mesh = SceneMesh::new(loaded.parts[0].clone(), Format::Obj, &options);
        let merged = mesh.clone().merged();
        assert_eq!(merged.mesh.faces().corners(), [0, 1, 2, 0, 3, 4]);
        assert_eq!(merged.normals.normals.values, [DVec3::Z * 2.0, DVec3::new(0.0, 3.0, 4.0)]);
        assert_eq!((&merged.normals.entry_vertex[..], merged.normals.morph_normals.len()), (&[0, 2][..], 0));
        let values = |mesh: &SceneMesh| {
            let corners = mesh.mesh.faces().corners().iter().enumerate();
            let value = |(corner, &vertex): (usize, &u32)| {
                let colour = mesh.colours.as_ref().unwrap()[vertex as usize];
                (mesh.mesh.positions().at(vertex), mesh.normals.normals.get(corner, vertex).copied(), colour)
            };
            corners.map(value).collect::<Vec<_>>()
        };
        assert_eq!(values(&mesh), values(&merged));
    }
}
