//! Seams where one surface is made of several primitives of a mesh.

use super::cavities::one_mesh;
use super::{rebuilt, recipe, surface, with_normals};
use crease::io::{Format, Loaded, Part, ReadOptions, WriteOptions, read_bytes, write_new};
use crease::mesh::{Faces, Mesh, Topology, Weld};
use crease::normals::Weight;
use crease::quality::catalogue::Kind;
use crease::quality::{Thresholds, diagnose};
use crease::surface::{Sphere, Surface};
use glam::DVec3;

/// Whether a face lies on the half of a ball towards +x.
fn is_right(mesh: &Mesh, face: usize) -> bool {
    let corners = mesh.faces().face(face);
    corners.iter().map(|&vertex| mesh.positions()[vertex as usize].x).sum::<f64>() > 0.0
}

/// Two halves of a ball as primitives of one glTF mesh, each with vertices of its own.
fn halves(ball: &Mesh, normals: impl Fn(Mesh) -> Mesh) -> Loaded {
    let half = |right: bool| {
        let mut faces = Faces::new();
        (0..ball.face_count())
            .filter(|&face| is_right(ball, face) == right)
            .for_each(|face| faces.push(ball.faces().face(face)));
        Part { mesh: normals(rebuilt(ball.positions().to_vec(), faces)), ..Part::default() }
    };
    let bytes = write_new(&[half(true), half(false)], Format::Gltf, &WriteOptions::default()).unwrap().bytes;
    let bytes = one_mesh(&bytes).into_bytes();
    read_bytes(bytes, Some(Format::Gltf), None, &ReadOptions::default()).unwrap()
}

/// Normals that were computed for each primitive alone differ along the line where the two meet, and only there.
#[test]
fn seams_between_primitives_are_told() {
    let ball = surface(&Surface::from(Sphere::new(1.0).unwrap()), [24, 16]).with_normals(None);
    let topology = Topology::build(&ball, Weld::Exact);
    let face = |half_edge: u32| topology.face_of(half_edge) as usize;
    let line = (0..ball.faces().corner_count() as u32).filter(|&half_edge| {
        let across = topology.across(half_edge).expect("a ball is closed");
        half_edge < across && is_right(&ball, face(half_edge)) != is_right(&ball, face(across))
    });
    let apart = halves(&ball, |half| with_normals(half, &recipe(Weight::Angle, 60.0)));
    assert_eq!((apart.parts.len(), apart.parts[0].mesh.face_count()), (1, ball.face_count()));
    let seams = |loaded: &Loaded| {
        let found = diagnose(loaded, &Thresholds { places: 1000, ..Thresholds::default() }, &|_| {});
        found.get(Kind::SplitSeam).map_or((0, 0), |it| {
            let on_line = |position: DVec3| position.x.abs() < 1e-6;
            (it.count as usize, it.places.iter().filter(|at| at.position.is_some_and(on_line)).count())
        })
    };
    let count = line.count();
    assert_eq!(seams(&apart), (count, count));
    let whole = with_normals(ball.clone(), &recipe(Weight::Angle, 60.0)).columns().normals.clone().unwrap();
    let as_whole = |half: Mesh| {
        let of_vertex = |vertex: u32| {
            let corner = ball.faces().corners().iter().position(|&it| it == vertex);
            corner.map_or(DVec3::Z, |corner| *whole.get(corner, vertex).unwrap())
        };
        let values = (0..half.vertex_count() as u32).map(of_vertex).collect();
        half.with_normals(Some(crease::mesh::Column::per_vertex(values)))
    };
    assert_eq!(seams(&halves(&ball, as_whole)), (0, 0), "computed as one");
}
