//! Meshes that would be slow to diagnose: all their elements are at one position.
//!
//! Each is so large that an algorithm of quadratic time would take hours.

use super::patiently;
use crate::random::Random;
use crease::io::{Document, Format, Loaded, Part};
use crease::mesh::{Column, Columns, Faces, Mesh, MeshBuilder};
use crease::quality::catalogue::Kind;
use crease::quality::{Diagnosis, Thresholds, diagnose};
use glam::{DVec2, DVec3};

const COUNT: u32 = 100_000;

fn mesh(positions: Vec<DVec3>, triangles: impl Iterator<Item = [u32; 3]>, columns: Columns) -> Mesh {
    let mut faces = Faces::new();
    triangles.for_each(|triangle| faces.push(&triangle));
    MeshBuilder { positions: positions.into(), faces, columns }.build().unwrap()
}

/// A shallow cone of triangles about one vertex.
fn pole(columns: Columns) -> Mesh {
    let rim = (0..COUNT).map(|i| {
        let (sin, cos) = libm::sincos(f64::from(i) * std::f64::consts::TAU / f64::from(COUNT));
        DVec3::new(cos, sin, 0.0)
    });
    let positions = std::iter::once(DVec3::Z * 0.2).chain(rim).collect();
    mesh(positions, (0..COUNT).map(|i| [0, i + 1, (i + 1) % COUNT + 1]), columns)
}

fn reported(mesh: Mesh) -> Diagnosis {
    let parts = vec![Part { mesh, ..Part::default() }];
    let file = Loaded { format: Format::Obj, parts, nodes: vec![], notes: vec![], document: Document::None };
    diagnose(&file, &Thresholds::default(), &|_| {})
}

#[test]
fn a_pole_of_one_tilted_normal_is_judged() {
    patiently("a pole of one normal", || {
        let tilted = std::iter::once(DVec3::new(0.9, 0.0, 0.4).normalize());
        let normals = tilted.chain(std::iter::repeat_n(DVec3::Z, COUNT as usize)).collect();
        let columns = Columns { normals: Some(Column::per_vertex(normals)), ..Columns::default() };
        let custom = reported(pole(columns)).get(Kind::Custom).map(|finding| finding.count);
        assert_eq!(custom, Some(u64::from(COUNT)), "the normal at the pole, and none at the rim");
    });
}

#[test]
fn a_pole_of_strewn_normals_is_judged() {
    patiently("a pole of many normals", || {
        let mut random = Random(7);
        let mut strewn = || DVec3::new(random.unit() - 0.5, random.unit() - 0.5, 0.3).normalize();
        let normals = (0..=COUNT).map(|_| strewn()).collect();
        let corners = (0..COUNT).flat_map(|i| [i, i, (i + 1) % COUNT]).collect();
        let normals = Column::per_corner(normals, corners);
        let columns = Columns { normals: Some(normals), ..Columns::default() };
        assert!(reported(pole(columns)).get(Kind::Custom).is_some());
    });
}

#[test]
fn vertices_that_differ_at_one_place_are_judged() {
    patiently("vertices at one place", || {
        let rim = (0..COUNT).map(|i| DVec3::new(f64::from(i), 1.0, f64::from(i % 7)));
        let positions = std::iter::repeat_n(DVec3::ZERO, COUNT as usize).chain(rim).collect();
        let uvs = (0..2 * COUNT).map(|i| DVec2::splat(f64::from(i / 2))).collect();
        let columns = Columns { uvs: Some(Column::per_vertex(uvs)), ..Columns::default() };
        let triangles = (0..COUNT).map(|i| [i, COUNT + i, COUNT + (i + 1) % COUNT]);
        let found = reported(mesh(positions, triangles, columns));
        assert_eq!(found.get(Kind::DuplicateVertices).map(|it| it.count), Some(u64::from(COUNT / 2)));
    });
}
