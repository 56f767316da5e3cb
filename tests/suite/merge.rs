//! Vertices of facets merged in new files: the same corners, fewer vertices, no needless seam.

use crate::meshes::rows;
use crease::io::{self, Format, Loaded, Merge, ReadOptions, WriteOptions, Written};
use crease::mesh::Mesh;
use crease::normals::{Crease, NormalRecipe};
use crease::num::Degrees;
use crease::pipeline::{Task, revise};
use glam::DVec3;
use std::collections::HashSet;
use std::path::Path;

/// No edge is sharp.
const OFF: Crease = Crease::Angle(Degrees(180.0));

fn data(name: &str) -> Loaded {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("data").join(name);
    io::read(&path, None, &ReadOptions::default()).unwrap()
}

fn task(crease: Crease) -> Task {
    Task { recipe: NormalRecipe { crease, ..NormalRecipe::default() }, ..Task::default() }
}

/// A file with new normals in another format, as the program writes it.
fn converted(loaded: &Loaded, crease: Crease, to: Format, merge: Merge) -> Written {
    let revision = revise(loaded, &task(crease), Some(to), &|_| {});
    let options = WriteOptions { merge, ..WriteOptions::default() };
    io::write(loaded, revision.edits, to, &options).unwrap()
}

fn read(written: &Written, format: Format) -> Loaded {
    io::read_bytes(written.bytes.clone(), Some(format), None, &ReadOptions::default()).unwrap()
}

/// The position and the normal of every corner, to the bit (−0 as 0 in positions).
fn corners(loaded: &Loaded) -> Vec<[u64; 6]> {
    let of_mesh = |mesh: &Mesh| {
        let normals = mesh.columns().normals.clone().unwrap();
        let corner = |(corner, &vertex): (usize, &u32)| {
            let position = mesh.positions().at(vertex) + DVec3::ZERO;
            let normal = normals.get(corner, vertex).unwrap();
            let [a, b, c] = position.to_array().map(f64::to_bits);
            let [x, y, z] = normal.to_array().map(f64::to_bits);
            [a, b, c, x, y, z]
        };
        mesh.faces().corners().iter().enumerate().map(corner).collect::<Vec<_>>()
    };
    loaded.parts.iter().flat_map(|part| of_mesh(&part.mesh)).collect()
}

fn vertices(loaded: &Loaded) -> usize {
    loaded.parts.iter().map(|part| part.mesh.vertex_count()).sum()
}

/// One stored normal for all corners of a face: only corners at equal positions are merged.
#[test]
fn a_normal_that_several_positions_share_does_not_merge_them() {
    let obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\nf 4//1 5//1 6//1\n";
    let loaded =
        io::read_bytes(obj.as_bytes().to_vec(), Some(Format::Obj), None, &ReadOptions::default()).unwrap();
    let written = io::write(&loaded, &[], Format::Glb, &WriteOptions::default()).unwrap();
    let merged = read(&written, Format::Glb);
    assert_eq!((vertices(&merged), corners(&merged)), (4, corners(&loaded)));
}

/// Merging must keep every corner, and leave as many vertices as there are different corners.
fn check(name: &str, loaded: &Loaded, crease: Crease) {
    for to in [Format::Glb, Format::Ply] {
        let separate = read(&converted(loaded, crease, to, Merge::Off), to);
        let written = converted(loaded, crease, to, Merge::FacetWise);
        let merged = read(&written, to);
        let corners_now = corners(&merged);
        assert!(corners(&separate) == corners_now, "{name}: {to}");
        let different: HashSet<[u64; 6]> = corners_now.into_iter().collect();
        assert_eq!(vertices(&merged), different.len(), "{name}: {to}");
        assert_eq!(written.vertices as usize, different.len(), "{name}: {to}");
        assert_eq!(
            written.merged_vertices as usize,
            vertices(loaded).saturating_sub(different.len()),
            "{name}: {to}"
        );
    }
}

#[test]
fn vertices_of_facets_are_merged_where_corners_agree() {
    for crease in [Crease::Default, OFF, Crease::Angle(Degrees(0.0))] {
        check("part.stl", &data("part.stl"), crease);
        check("part-binary.stl", &data("part-binary.stl"), crease);
    }
    for row in rows("stl/", &["stl", "STL"]) {
        let loaded = io::read(&row.path, None, &ReadOptions::default()).unwrap();
        if loaded.parts.len() == 1 && vertices(&loaded) < 30_000 {
            check(row.name(), &loaded, Crease::Default);
        }
    }
}

#[test]
fn merged_facets_have_no_seam() {
    let stl = data("part.stl");
    let glb = read(&converted(&stl, OFF, Format::Glb, Merge::FacetWise), Format::Glb);
    // Closed and of genus g: V − E + F = 2 − 2g, and each edge has two faces.
    let mesh = &glb.parts[0].mesh;
    let (faces, vertices) = (mesh.face_count(), mesh.vertex_count());
    let euler = vertices as i64 - (3 * faces / 2) as i64 + faces as i64;
    assert!(euler <= 2 && euler % 2 == 0, "{euler}");
    let positions: HashSet<[u64; 3]> =
        mesh.positions().iter().map(|p| (p + DVec3::ZERO).to_array().map(f64::to_bits)).collect();
    assert_eq!(positions.len(), vertices, "all smooth: one vertex a position");
    // Meshes that share vertices are not merged unless asked.
    let gear = data("gear.obj");
    let usual = converted(&gear, Crease::Default, Format::Glb, Merge::FacetWise);
    assert_eq!(usual.bytes, converted(&gear, Crease::Default, Format::Glb, Merge::Off).bytes);
}

#[test]
fn an_obj_shares_positions_and_normals_of_facets() {
    let stl = data("part.stl");
    let obj = converted(&stl, Crease::Default, Format::Obj, Merge::FacetWise);
    let again = read(&obj, Format::Obj);
    let separate = read(&converted(&stl, Crease::Default, Format::Obj, Merge::Off), Format::Obj);
    assert!(corners(&again) == corners(&separate));
    let positions: HashSet<[u64; 3]> =
        corners(&again).iter().map(|corner| [corner[0], corner[1], corner[2]]).collect();
    assert_eq!(vertices(&again), positions.len());
}

#[test]
fn exact_merging_in_gltf_keeps_all_corners() {
    let stl = data("part.stl");
    let separate = converted(&stl, Crease::Default, Format::Glb, Merge::Off);
    let glb = read(&separate, Format::Glb);
    let edited = converted(&glb, Crease::Default, Format::Glb, Merge::Exact);
    // Without it, editing keeps the vertices.
    let usual = converted(&glb, Crease::Default, Format::Glb, Merge::FacetWise);
    assert!(corners(&read(&edited, Format::Glb)) == corners(&read(&usual, Format::Glb)));
    assert_eq!((edited.vertices, edited.merged_vertices, usual.vertices), (66, 126, 192));
    assert!(2 * edited.bytes.len() < usual.bytes.len(), "the old vertices are gone: {}", edited.bytes.len());
}

#[test]
fn close_vertices_are_moved_then_merged() {
    // Each facet of the part, its corners moved by up to 10⁻⁶ of the size.
    let mut stl = data("part.stl");
    let moved = stl.move_together(1e-12);
    assert_eq!(moved.vertices, 0, "equal positions do not move");
    let text = "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n\
                facet normal 0 0 1\nouter loop\nvertex 1.0000001 0 0\nvertex 1 1 0\nvertex 0 1.0000001 0\nendloop\nendfacet\nendsolid\n";
    let mut near = io::read_bytes(text.into(), Some(Format::Stl), None, &ReadOptions::default()).unwrap();
    let apart = converted(&near, Crease::Default, Format::Glb, Merge::Exact);
    assert_eq!(apart.vertices, 6);
    let moved = near.move_together(1e-6);
    assert_eq!(moved.vertices, 2);
    assert!((moved.longest - 1e-7).abs() < 2e-8, "{moved:?}: the spacing of f32 at 1 is 1.2e-7");
    assert_eq!(converted(&near, Crease::Default, Format::Glb, Merge::Exact).vertices, 4);
}
