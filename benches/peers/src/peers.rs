//! The same job in other crates.

use crate::meshes::Mesh;
use bevy_asset::RenderAssetUsages;
use bevy_mesh::{Indices, PrimitiveTopology};
use std::fmt::Write as _;
use std::hint::black_box;

type Work<'a> = Box<dyn FnMut() + 'a>;

pub fn three_d_asset(mesh: &Mesh) -> Work<'static> {
    use three_d_asset::{Indices, Positions, TriMesh, vec3};
    let mut peer = TriMesh {
        positions: Positions::F32(mesh.positions.iter().map(|&[x, y, z]| vec3(x, y, z)).collect()),
        indices: Indices::U32(mesh.triangles.as_flattened().to_vec()),
        ..TriMesh::default()
    };
    Box::new(move || black_box(&mut peer).compute_normals())
}

fn bevy(mesh: &Mesh) -> bevy_mesh::Mesh {
    bevy_mesh::Mesh::new(PrimitiveTopology::TriangleList, RenderAssetUsages::default())
        .with_inserted_attribute(bevy_mesh::Mesh::ATTRIBUTE_POSITION, mesh.positions.clone())
        .with_inserted_indices(Indices::U32(mesh.triangles.as_flattened().to_vec()))
}

pub fn bevy_area(mesh: &Mesh) -> Work<'static> {
    let mut peer = bevy(mesh);
    Box::new(move || black_box(&mut peer).compute_area_weighted_normals())
}

pub fn bevy_angle(mesh: &Mesh) -> Work<'static> {
    let mut peer = bevy(mesh);
    Box::new(move || black_box(&mut peer).compute_smooth_normals())
}

/// The single-precision scatter loop that an engineer would write.
pub fn plain_loop<'a>(mesh: &'a Mesh) -> Work<'a> {
    let mut normals = vec![[0.0_f32; 3]; mesh.positions.len()];
    Box::new(move || {
        crease::trade::plain_vertex_normals(&mesh.positions, &mesh.triangles, black_box(&mut normals));
    })
}

pub fn meshopt_crease<'a>(mesh: &'a Mesh) -> Work<'a> {
    let indices = mesh.triangles.as_flattened();
    Box::new(move || {
        let angle = 40.0_f32.to_radians();
        black_box(meshopt::generate_normals_decoder(Some(indices), &mesh.positions, angle, 0.0));
    })
}

pub fn tobj_load(obj: &[u8]) -> Work<'_> {
    let options = tobj::LoadOptions { triangulate: true, ..tobj::LoadOptions::default() };
    Box::new(move || {
        let mut bytes = obj;
        let no_material = |_: &std::path::Path| Err(tobj::LoadError::OpenFileFailed);
        drop(black_box(tobj::load_obj_buf(&mut bytes, &options, no_material)));
    })
}

/// The mesh as OBJ text with the shortest decimals.
pub fn obj_text(mesh: &Mesh) -> Vec<u8> {
    let mut text = String::new();
    for [x, y, z] in &mesh.positions {
        let _ = writeln!(text, "v {x} {y} {z}");
    }
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|vertex| vertex + 1);
        let _ = writeln!(text, "f {a} {b} {c}");
    }
    text.into_bytes()
}
