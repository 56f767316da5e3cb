//! An `f32` mesh has the same normals however its text spells its coordinates.

use crease::io::{Format, ReadOptions, read_bytes};
use crease::mesh::{Mesh, MeshBuilder, Positions, Storage};
use crease::normals::{NormalField, NormalRecipe, compute};
use crease::surface::{Pattern, Surface, Tessellation, Torus};
use glam::DVec3;
use std::fmt::Write;

type Spell = fn(f64) -> String;

/// As `%.9g`, `%.8f`, `%.12g` and `%.17g` print.
const SPELLINGS: [(&str, Spell); 4] = [
    ("nine digits", |x| format!("{x:.8e}")),
    ("eight decimals", |x| format!("{x:.8}")),
    ("twelve digits", |x| format!("{x:.11e}")),
    ("seventeen digits", |x| format!("{x:.16e}")),
];

/// A torus with coordinates between 6 and 10 and rows of slivers: faces whose height is below the rounding of `f32`.
fn torus(storage: Storage) -> Mesh {
    let tessellation =
        Tessellation { pattern: Pattern::Slivers(1e6), segments: [24, 12], ..Tessellation::default() };
    let torus = Surface::from(Torus::default()).tessellate(&tessellation).unwrap();
    let positions = torus.positions().iter().map(|p| p + DVec3::splat(8.0)).collect();
    MeshBuilder {
        positions: Positions::rounded(positions, storage),
        faces: torus.faces().clone(),
        ..MeshBuilder::default()
    }
    .build()
    .unwrap()
}

fn obj(mesh: &Mesh, spell: Spell) -> String {
    let mut text = String::new();
    for DVec3 { x, y, z } in mesh.positions().iter() {
        writeln!(text, "v {} {} {}", spell(x), spell(y), spell(z)).unwrap();
    }
    for face in mesh.faces().iter() {
        let [a, b, c] = [face[0], face[1], face[2]].map(|vertex| vertex + 1);
        writeln!(text, "f {a} {b} {c}").unwrap();
    }
    text
}

fn ply(mesh: &Mesh, spell: Spell) -> String {
    let mut text = format!("ply\nformat ascii 1.0\nelement vertex {}\n", mesh.vertex_count());
    for axis in ["x", "y", "z"] {
        writeln!(text, "property float {axis}").unwrap();
    }
    let faces = mesh.face_count();
    writeln!(text, "element face {faces}\nproperty list uchar int vertex_indices\nend_header").unwrap();
    for DVec3 { x, y, z } in mesh.positions().iter() {
        writeln!(text, "{} {} {}", spell(x), spell(y), spell(z)).unwrap();
    }
    for face in mesh.faces().iter() {
        writeln!(text, "3 {} {} {}", face[0], face[1], face[2]).unwrap();
    }
    text
}

fn read(text: String, format: Format) -> Mesh {
    read_bytes(text.into_bytes(), Some(format), None, &ReadOptions::default()).unwrap().parts.remove(0).mesh
}

fn normals(mesh: &Mesh) -> NormalField {
    compute(mesh, &NormalRecipe::default())
}

#[test]
fn every_spelling_of_an_f32_mesh_gives_the_same_normals() {
    let mesh = torus(Storage::F32);
    let expected = normals(&mesh);
    for (name, spell) in SPELLINGS {
        for (format, text) in [(Format::Obj, obj(&mesh, spell)), (Format::Ply, ply(&mesh, spell))] {
            let found = read(text, format);
            assert_eq!(found.positions().to_vec(), mesh.positions().to_vec(), "{name}, {format:?}");
            assert_eq!(normals(&found), expected, "{name}, {format:?}");
        }
    }
    // The same positions as doubles have other normals: their slivers count.
    let positions = Positions::rounded(mesh.positions().to_vec(), Storage::F64);
    let doubles =
        MeshBuilder { positions, faces: mesh.faces().clone(), ..MeshBuilder::default() }.build().unwrap();
    assert_ne!(normals(&doubles).normals, expected.normals);
}

#[test]
fn doubles_with_seventeen_digits_stay_doubles() {
    let mesh = torus(Storage::F64);
    let found = read(obj(&mesh, |x| format!("{x:.16e}")), Format::Obj);
    assert_eq!(found.positions().storage(), Storage::F64);
    assert_eq!(found.positions().to_vec(), mesh.positions().to_vec());
    assert_eq!(normals(&found), normals(&mesh));
}
