//! Fans that are cut by reversed or doubled faces: the stored normals were made without the cut.

use super::planted::{per_corner, unshared};
use super::{grave, inspect, rebuilt, recipe, with_normals};
use crate::meshes::path;
use crease::io::{ReadOptions, read};
use crease::mesh::{FaceEdit, Mesh};
use crease::normals::Weight;
use crease::quality::Severity;
use crease::quality::catalogue::Kind;
use crease::surface::{Sphere, Surface, Tessellation};
use glam::DVec3;

/// Rough balls, on which many edges above the crease angle are the only one at their vertex and split nothing unless its fan is
/// cut; and real meshes, if they are available.
fn meshes() -> Vec<Mesh> {
    let rough = |seed| Tessellation { noise: 0.15, seed, ..Tessellation::default() };
    let ball = |seed| Surface::from(Sphere::default()).tessellate(&rough(seed)).unwrap();
    let mut all: Vec<Mesh> = (0..3).map(|seed| ball(seed).with_normals(None)).collect();
    let real = ["obj/armadillo_low.obj", "obj/cycloidal.obj"].into_iter().filter_map(path);
    let real = real.map(|path| read(&path, None, &ReadOptions::default()).unwrap().parts.remove(0).mesh);
    all.extend(real.map(|mesh| rebuilt(mesh.positions().to_vec(), mesh.faces().clone())));
    all.into_iter().map(|mesh| with_normals(mesh, &recipe(Weight::Angle, 40.0))).collect()
}

/// One face in 101 reversed.
fn reversed(mesh: &Mesh) -> Mesh {
    let reversed = (0..mesh.face_count() as u32).step_by(101).collect();
    mesh.with_faces(&FaceEdit { reversed, ..FaceEdit::default() })
}

/// One face in 101 doubled, with the same normals.
fn doubled(mesh: &Mesh) -> Mesh {
    let normals = unshared(mesh);
    let (mut faces, mut more) = (mesh.faces().clone(), normals.clone());
    for face in (0..mesh.face_count()).step_by(101) {
        faces.push(mesh.faces().face(face));
        more.extend(&normals[mesh.faces().range(face)]);
    }
    per_corner(&rebuilt(mesh.positions().to_vec(), faces), more)
}

#[test]
fn edges_at_reversed_and_doubled_faces_are_not_averaged() {
    for (number, mesh) in meshes().iter().enumerate() {
        let clean = grave(&inspect(mesh, 1));
        for (changed, kind) in
            [(reversed(mesh), Kind::InconsistentWinding), (doubled(mesh), Kind::DuplicateFaces)]
        {
            let reported = grave(&inspect(&changed, 1));
            let new: Vec<&str> = reported.into_iter().filter(|id| !clean.contains(id)).collect();
            assert_eq!(new, [kind.id()], "mesh {number}");
        }
    }
}

/// A ball and a separate disc that is visible only from above. The reversed disc has one normal, which is opposite to its faces.
#[test]
fn normals_of_a_flat_piece_say_that_it_is_reversed() {
    let ball = Surface::from(Sphere::default()).tessellate(&Tessellation::default()).unwrap();
    let (mut positions, mut faces) = (ball.positions().to_vec(), ball.faces().clone());
    const RIM: u32 = 12;
    let middle = positions.len() as u32;
    positions.push(DVec3::Y * 1.2);
    positions.extend((0..RIM).map(|i| {
        let (sine, cosine) = libm::sincos(std::f64::consts::TAU * f64::from(i) / f64::from(RIM));
        DVec3::new(0.3 * sine, 1.2, 0.3 * cosine)
    }));
    (0..RIM).for_each(|i| faces.push(&[middle, middle + 1 + i, middle + 1 + (i + 1) % RIM]));
    let mesh = with_normals(rebuilt(positions, faces), &recipe(Weight::Angle, 40.0));
    assert_eq!(grave(&inspect(&mesh, 1)), Vec::<&str>::new());
    let reversed = (0..mesh.face_count() as u32).collect();
    let diagnosis = inspect(&mesh.with_faces(&FaceEdit { reversed, ..FaceEdit::default() }), 1);
    assert_eq!(grave(&diagnosis), ["inside-out", "open-inside-out"], "{:?}", diagnosis.findings);
    assert_eq!(diagnosis.count(Severity::Error), 1);
    assert_eq!(diagnosis.get(Kind::OpenInsideOut).unwrap().count, u64::from(RIM));
}
