//! Attributes that go with normals in glTF files: tangents and the normals of morph targets, with faults at known vertices.

use super::planted::Planted;
use super::{grave, surface, with_normals};
use base64::Engine;
use crease::io::{Format, Loaded, ReadOptions, read_bytes};
use crease::mesh::{Mesh, triangulate};
use crease::normals::NormalRecipe;
use crease::num::{Degrees, angle_between};
use crease::quality::catalogue::Kind;
use crease::quality::{Diagnosis, Thresholds, diagnose};
use crease::surface::{Surface, Torus};
use glam::DVec3;
use serde_json::json;
use std::collections::BTreeSet;

/// The data of a file's vertices.
struct Vertices {
    positions: Vec<DVec3>,
    normals: Vec<DVec3>,
    uvs: Vec<[f64; 2]>,
    tangents: Vec<[f64; 4]>,
    /// The displacements of the only morph target.
    moves: Vec<DVec3>,
    turns: Vec<DVec3>,
    indices: Vec<u32>,
}

/// The shear of the morph target: x grows with y.
const SHEAR: f64 = 0.8;

impl Vertices {
    /// A torus with right tangents, and a morph target that shears it, with right normals.
    fn right() -> Self {
        let mesh = surface(&Surface::from(Torus::default()), [24, 12]).with_normals(None);
        let mesh = with_normals(
            mesh,
            &NormalRecipe { crease: crease::normals::Crease::OFF, ..NormalRecipe::default() },
        );
        let stored = mesh.columns().normals.as_ref().unwrap();
        let corners = mesh.faces().corners();
        let mut normals = vec![DVec3::ZERO; mesh.vertex_count()];
        corners
            .iter()
            .enumerate()
            .for_each(|(corner, &v)| normals[v as usize] = *stored.get(corner, v).unwrap());
        let sheared = |p: DVec3| p + DVec3::X * SHEAR * p.y;
        let leant: Vec<DVec3> = mesh.positions().iter().map(sheared).collect();
        let leant = crease::mesh::MeshBuilder {
            positions: leant.into(),
            faces: mesh.faces().clone(),
            ..Default::default()
        };
        let leant = with_normals(
            leant.build().unwrap(),
            &NormalRecipe { crease: crease::normals::Crease::OFF, ..NormalRecipe::default() },
        );
        let stored = leant.columns().normals.as_ref().unwrap();
        let mut turns = vec![DVec3::ZERO; mesh.vertex_count()];
        for (corner, &v) in corners.iter().enumerate() {
            turns[v as usize] = *stored.get(corner, v).unwrap() - normals[v as usize];
        }
        let across = |n: &DVec3| n.any_orthonormal_vector();
        Self {
            positions: mesh.positions().to_vec(),
            tangents: normals.iter().map(|n| across(n).extend(1.0).to_array()).collect(),
            uvs: mesh.positions().iter().map(|p| [p.x, p.y]).collect(),
            moves: mesh.positions().iter().map(|p| DVec3::X * SHEAR * p.y).collect(),
            turns,
            normals,
            indices: indices(&mesh),
        }
    }

    fn file(&self) -> Vec<u8> {
        let mut bin: Vec<u8> = Vec::new();
        let (mut views, mut accessors) = (Vec::new(), Vec::new());
        let mut put = |floats: Vec<f64>, kind: &str, width: usize| {
            let start = bin.len();
            bin.extend(floats.iter().flat_map(|&x| (x as f32).to_le_bytes()));
            views.push(json!({"buffer": 0, "byteOffset": start, "byteLength": bin.len() - start}));
            let mut accessor = json!({"bufferView": views.len() - 1, "componentType": 5126, "type": kind,
                "count": floats.len() / width});
            if accessors.is_empty() || kind == "VEC3" {
                let bound = |pick: fn(f64, f64) -> f64| -> Vec<f64> {
                    (0..width)
                        .map(|i| {
                            floats
                                .iter()
                                .skip(i)
                                .step_by(width)
                                .map(|&x| f64::from(x as f32))
                                .reduce(pick)
                                .unwrap()
                        })
                        .collect()
                };
                accessor["min"] = bound(f64::min).into();
                accessor["max"] = bound(f64::max).into();
            }
            accessors.push(accessor);
            accessors.len() - 1
        };
        let flat = |list: &[DVec3]| list.iter().flat_map(|p| p.to_array()).collect::<Vec<f64>>();
        let position = put(flat(&self.positions), "VEC3", 3);
        let normal = put(flat(&self.normals), "VEC3", 3);
        let tangent = put(self.tangents.iter().flatten().copied().collect(), "VEC4", 4);
        let uv = put(self.uvs.iter().flatten().copied().collect(), "VEC2", 2);
        let moves = put(flat(&self.moves), "VEC3", 3);
        let turns = put(flat(&self.turns), "VEC3", 3);
        let start = bin.len();
        bin.extend(self.indices.iter().flat_map(|i| i.to_le_bytes()));
        views.push(json!({"buffer": 0, "byteOffset": start, "byteLength": bin.len() - start}));
        accessors.push(json!({"bufferView": views.len() - 1, "componentType": 5125, "type": "SCALAR",
            "count": self.indices.len()}));
        let data = base64::engine::general_purpose::STANDARD.encode(&bin);
        json!({
            "asset": {"version": "2.0"},
            "scenes": [{"nodes": [0]}],
            "nodes": [
                {"name": "body", "children": [1]},
                {"name": "arm", "children": [2]},
                {"name": "ring", "mesh": 0}
            ],
            "meshes": [{"primitives": [{
                "attributes": {"POSITION": position, "NORMAL": normal, "TANGENT": tangent, "TEXCOORD_0": uv},
                "targets": [{"POSITION": moves, "NORMAL": turns}],
                "indices": accessors.len() - 1
            }], "weights": [0.0]}],
            "accessors": accessors,
            "bufferViews": views,
            "buffers": [{"byteLength": bin.len(), "uri": format!("data:application/octet-stream;base64,{data}")}]
        })
        .to_string()
        .into_bytes()
    }

    /// The angle in degrees by which the shear rotates the normal of a vertex.
    fn turn(&self, vertex: u32) -> f64 {
        let (normal, turn) = (self.normals[vertex as usize], self.turns[vertex as usize]);
        Degrees::from(angle_between(normal, normal + turn)).0
    }

    fn loaded(&self) -> Loaded {
        read_bytes(self.file(), Some(Format::Gltf), None, &ReadOptions::default()).unwrap()
    }

    /// The file with a fault at some vertices.
    fn planted(&self, what: &'static str, expected: Kind, vertices: &BTreeSet<u32>) -> Planted {
        let mesh = self.loaded().parts.remove(0).mesh;
        let corners = mesh.faces().corners().iter().zip(0..);
        let places = corners.filter(|(v, _)| vertices.contains(v)).map(|(_, corner)| corner).collect();
        Planted { file: Some(self.file()), ..Planted::new(what, expected, mesh, places) }
    }

    fn diagnosis(&self) -> Diagnosis {
        let loaded = self.loaded();
        diagnose(&loaded, &Thresholds { places: 1 << 16, ..Thresholds::default() }, &|_| {})
    }
}

fn indices(mesh: &Mesh) -> Vec<u32> {
    triangulate(mesh).triangles.iter().flatten().map(|&c| mesh.faces().corners()[c as usize]).collect()
}

/// The vertices at which something is found.
fn vertices(diagnosis: &Diagnosis, kind: Kind) -> BTreeSet<u32> {
    diagnosis.get(kind).into_iter().flat_map(|found| &found.places).filter_map(|site| site.vertex).collect()
}

/// Every seventh vertex.
fn some(file: &Vertices) -> BTreeSet<u32> {
    (0..file.positions.len() as u32).step_by(7).collect()
}

#[test]
fn right_attributes_are_not_reported() {
    let diagnosis = Vertices::right().diagnosis();
    assert_eq!(grave(&diagnosis), Vec::<&str>::new());
    assert!(diagnosis.get(Kind::Tangents).is_none() && diagnosis.get(Kind::MorphNormals).is_none());
}

#[test]
fn tangents_that_do_not_fit_are_found_where_they_are() {
    type Fault = fn(&mut [f64; 4], DVec3);
    let lean: Fault = |tangent, normal| {
        let leant = DVec3::from_slice(&tangent[..3]) * libm::cos(0.2) + normal * libm::sin(0.2);
        tangent[..3].copy_from_slice(&leant.to_array());
    };
    let faults: [(&str, Fault); 3] = [
        ("by 11.5°", lean),
        ("too long", |tangent, _| tangent[..3].iter_mut().for_each(|x| *x *= 1.1)),
        ("no handedness", |tangent, _| tangent[3] = 0.0),
    ];
    for (name, fault) in faults {
        let mut file = Vertices::right();
        let places = some(&file);
        for &vertex in &places {
            fault(&mut file.tangents[vertex as usize], file.normals[vertex as usize]);
        }
        let diagnosis = file.diagnosis();
        assert_eq!(vertices(&diagnosis, Kind::Tangents), places, "{name}");
        assert_eq!(grave(&diagnosis), ["tangents-off-normals"], "{name}");
    }
}

#[test]
fn morph_normals_that_do_not_turn_along_are_found() {
    let mut file = Vertices::right();
    // At least twice the threshold.
    let places: BTreeSet<u32> = some(&file).into_iter().filter(|&v| file.turn(v) > 30.0).collect();
    assert!(places.len() > 5);
    places.iter().for_each(|&vertex| file.turns[vertex as usize] = DVec3::ZERO);
    let diagnosis = file.diagnosis();
    assert_eq!(vertices(&diagnosis, Kind::MorphNormals), places);
    assert_eq!(grave(&diagnosis), ["wrong-morph-normals"]);
    let site = &diagnosis.get(Kind::MorphNormals).unwrap().places[0];
    assert_eq!(site.node.as_deref(), Some("body/arm/ring"), "the full path of the node");
}

/// The faults above with their names in the table, at the vertices of [`some`].
pub(super) fn planted() -> [Planted; 2] {
    let mut leaning = Vertices::right();
    let places = some(&leaning);
    places
        .iter()
        .for_each(|&v| leaning.tangents[v as usize] = leaning.normals[v as usize].extend(1.0).into());
    let mut unmoved = Vertices::right();
    let far: BTreeSet<u32> = some(&unmoved).into_iter().filter(|&v| unmoved.turn(v) > 30.0).collect();
    far.iter().for_each(|&v| unmoved.turns[v as usize] = DVec3::ZERO);
    [
        leaning.planted("tangents along their normals", Kind::Tangents, &places),
        unmoved.planted("morph targets that do not rotate normals", Kind::MorphNormals, &far),
    ]
}

/// Files, each with a fault that a command fixes.
pub(super) fn faulty() -> [(Kind, Vec<u8>); 2] {
    let mut leaning = Vertices::right();
    leaning.tangents[5] = leaning.normals[5].extend(1.0).to_array();
    let mut unmoved = Vertices::right();
    unmoved.turns.fill(DVec3::ZERO);
    [(Kind::Tangents, leaning.file()), (Kind::MorphNormals, unmoved.file())]
}
