//! Winding repair: on the real meshes, and of surfaces with a rim whose outer side is known.

use super::meshes::rows;
use crease::io::{ReadOptions, read};
use crease::mesh::{
    Confidence, FaceEdit, Faces, Link, Mesh, MeshBuilder, Orient, Orientation, Topology, Weld, orient,
};
use crease::surface::{Sphere, Surface, Tessellation, Torus, Wave};
use glam::DVec3;

/// The parts of all files that can be read, with the names of the files.
fn parts() -> impl Iterator<Item = (String, Mesh)> {
    let files = [("obj", &["obj"][..]), ("ply", &["ply"]), ("stl", &["stl"]), ("gltf", &["gltf", "glb"])];
    files.into_iter().flat_map(|(folder, extensions)| rows(folder, extensions)).flat_map(|row| {
        let loaded = read(&row.path, None, &ReadOptions::default());
        let name = row.name().to_owned();
        loaded.into_iter().flat_map(|loaded| loaded.parts).map(move |part| (name.clone(), part.mesh))
    })
}

fn turned(mesh: &Mesh, reversed: &[u32]) -> Mesh {
    mesh.with_faces(&FaceEdit { reversed: reversed.to_vec(), ..FaceEdit::default() })
}

fn find(mesh: &Mesh, policy: Orient) -> Orientation {
    orient(mesh, &Topology::build(mesh, Weld::Exact), policy, Confidence::default())
}

/// A repaired mesh needs no further repair, and neighbours that can agree do.
#[test]
fn mended_meshes_stay_as_they_are() {
    for (name, mesh) in parts() {
        for policy in [Orient::Consistent, Orient::Outward] {
            let found = find(&mesh, policy);
            let mended = turned(&mesh, &found.reversed);
            let again = find(&mended, policy);
            let rest = Orientation {
                reversed: Vec::new(),
                reversed_open: Vec::new(),
                inside_out: 0,
                open_inside_out: 0,
                ..found.clone()
            };
            assert_eq!(again, rest, "{name}");
            let topology = Topology::build(&mended, Weld::Exact);
            let half_edges = 0..mended.faces().corner_count() as u32;
            let differ = half_edges.filter(|&h| matches!(topology.link(h), Link::Inconsistent(_))).count();
            if found.non_orientable == 0 && (policy == Orient::Consistent || found.closed == found.components)
            {
                assert_eq!(differ, 0, "{name}");
            }
        }
    }
}

/// The result does not depend on which winding a closed surface had.
#[test]
fn turned_round_as_a_whole_it_comes_out_the_same() {
    for (name, mesh) in parts() {
        let all: Vec<u32> = (0..mesh.face_count() as u32).collect();
        let (one, other) = (find(&mesh, Orient::Outward), find(&turned(&mesh, &all), Orient::Outward));
        let mut both = [one.reversed.as_slice(), &other.reversed].concat();
        both.sort_unstable();
        both.dedup();
        assert_eq!(both.len(), one.reversed.len() + other.reversed.len(), "{name}: a face turned both times");
        if one.closed == one.components && one.flat + one.undecided == 0 {
            assert_eq!(both.len(), mesh.face_count(), "{name}");
        }
    }
}

/// Faults that were checked manually.
#[test]
fn known_faults_are_found() {
    let known = |name: &str| {
        Some(match name {
            "obj/box-incorrect-winding-order.obj" => (1, Orientation { closed: 1, ..Orientation::default() }),
            "obj/moebius.obj" => (0, Orientation { non_orientable: 1, ..Orientation::default() }),
            // Signed volume −1: each of its twelve triangles faces inwards.
            "gltf/box_sparse/box_sparse.gltf" => {
                (12, Orientation { closed: 1, inside_out: 1, ..Orientation::default() })
            }
            // A tetrahedron in a corner of a cube, with three of its faces on the cube's.
            "obj/two_objects.obj" => (
                4,
                Orientation {
                    components: 2,
                    closed: 2,
                    inside_out: 1,
                    cavities: 1,
                    ..Orientation::default()
                },
            ),
            "obj/hourglass_ico.obj" => {
                (0, Orientation { components: 2, closed: 2, ..Orientation::default() })
            }
            _ => return None,
        })
    };
    for (name, mesh) in parts() {
        let Some((turned, expected)) = known(&name) else { continue };
        let found = find(&mesh, Orient::Outward);
        assert_eq!(found.reversed.len(), turned, "{name}");
        let components = expected.components.max(1);
        assert_eq!(
            Orientation { reversed: Vec::new(), ..found },
            Orientation { components, ..expected },
            "{name}"
        );
    }
}

/// The faces of a surface that a condition keeps, by the middles of the faces.
fn part_of(surface: &Surface, segments: [u32; 2], keep: impl Fn(DVec3) -> bool) -> Mesh {
    let whole = surface.tessellate(&Tessellation { segments, ..Tessellation::default() }).unwrap();
    let middle = |face: &[u32]| -> DVec3 {
        face.iter().map(|&v| whole.positions().at(v)).sum::<DVec3>() / face.len() as f64
    };
    let mut faces = Faces::new();
    whole.faces().iter().filter(|face| keep(middle(face))).for_each(|face| faces.push(face));
    build(whole.positions().to_vec(), faces)
}

fn build(positions: Vec<DVec3>, faces: Faces) -> Mesh {
    MeshBuilder { positions: positions.into(), faces, ..MeshBuilder::default() }.build().unwrap()
}

/// A cup: the side of a cylinder and its floor, facing outwards.
fn cup() -> Mesh {
    const ROUND: u32 = 24;
    let ring = |height: f64| {
        (0..ROUND).map(move |i| {
            let (sine, cosine) = libm::sincos(std::f64::consts::TAU * f64::from(i) / f64::from(ROUND));
            DVec3::new(cosine, sine, height)
        })
    };
    let mut faces = Faces::new();
    faces.push(&(0..ROUND).rev().collect::<Vec<_>>());
    (0..ROUND).map(|i| (i, (i + 1) % ROUND)).for_each(|(a, b)| faces.push(&[a, b, b + ROUND, a + ROUND]));
    build(ring(0.0).chain(ring(2.0)).collect(), faces)
}

/// A square that faces upwards.
fn plane(height: f64, half: f64) -> Mesh {
    let corner = |x: f64, y: f64| DVec3::new(x * half, y * half, height);
    let mut faces = Faces::new();
    faces.push(&[0, 1, 2, 3]);
    build(vec![corner(-1., -1.), corner(1., -1.), corner(1., 1.), corner(-1., 1.)], faces)
}

/// Several meshes as one, each moved by `step` from the one before.
fn next_to(meshes: &[Mesh], step: DVec3) -> Mesh {
    let (mut positions, mut faces) = (Vec::new(), Faces::new());
    for (number, mesh) in meshes.iter().enumerate() {
        let first = positions.len() as u32;
        positions.extend(mesh.positions().iter().map(|p| p + step * number as f64));
        mesh.faces().iter().for_each(|face| faces.push(&face.iter().map(|v| v + first).collect::<Vec<_>>()));
    }
    build(positions, faces)
}

/// Surfaces with a rim, facing their outer side.
fn with_rims() -> Vec<(&'static str, Mesh)> {
    let torus = Surface::from(Torus::default());
    vec![
        ("hemisphere", part_of(&Surface::from(Sphere::default()), [24, 12], |p| p.z > 0.0)),
        ("cup", cup()),
        ("a torus sliced like a bagel", part_of(&torus, [32, 16], |p| p.z > 0.0)),
        ("a torus cut in two", part_of(&torus, [32, 16], |p| p.x > 0.0)),
    ]
}

fn all_of(mesh: &Mesh) -> Vec<u32> {
    (0..mesh.face_count() as u32).collect()
}

#[test]
fn surfaces_with_a_rim_are_turned_to_the_side_that_sees_more() {
    for (name, mesh) in with_rims() {
        let right = find(&mesh, Orient::Outward);
        assert_eq!((right.reversed.len(), right.open_told, right.open_left), (0, 1, 0), "{name}");
        assert!(right.confidence > 0.95, "{name}: {}", right.confidence);
        let wrong = find(&turned(&mesh, &all_of(&mesh)), Orient::Outward);
        assert_eq!(
            (wrong.reversed.as_slice(), wrong.open_inside_out),
            (all_of(&mesh).as_slice(), 1),
            "{name}"
        );
        assert_eq!(wrong.confidence, right.confidence, "{name}: the same votes");
        // A single reversed face is reversed alone.
        assert_eq!(find(&turned(&mesh, &[5]), Orient::Outward).reversed, [5], "{name}");
    }
}

/// Both sides of a plane see equally much, and so do those of symmetric waves: nothing is reversed at any confidence.
#[test]
fn ties_stay() {
    for (name, mesh) in
        [("plane", plane(0.0, 1.0)), ("wave", part_of(&Surface::Wave(Wave::default()), [40, 40], |_| true))]
    {
        let found = find(&turned(&mesh, &all_of(&mesh)), Orient::Outward);
        assert_eq!((found.reversed.len(), found.open_left, found.open_told), (0, 1, 0), "{name}");
    }
}

#[test]
fn each_component_has_its_own_vote() {
    let ball = Surface::from(Sphere::default()).tessellate(&Tessellation::default()).unwrap();
    let reversed_cup = turned(&cup(), &all_of(&cup()));
    let meshes = [cup(), plane(0.0, 1.0), reversed_cup, turned(&ball, &all_of(&ball))];
    let mesh = next_to(&meshes, DVec3::X * 20.0);
    let found = find(&mesh, Orient::Outward);
    assert_eq!((found.components, found.closed, found.open_told, found.open_left), (4, 1, 2, 1));
    assert_eq!((found.open_inside_out, found.inside_out), (1, 1));
    let first = (meshes[0].face_count() + meshes[1].face_count()) as u32;
    let cup_faces: Vec<u32> = (first..first + cup().face_count() as u32).collect();
    assert_eq!(found.reversed_open, cup_faces);
    assert_eq!(found.reversed.len(), cup_faces.len() + ball.face_count());
}

/// Components hide sides of each other: two sheets, and a sheet within a ball.
#[test]
fn other_components_hide_sides() {
    let above = |mesh: &Mesh| next_to(&[mesh.clone(), plane(0.3, 1.0)], DVec3::ZERO);
    // Two sheets: each sees more on the side away from the other.
    let found = find(&above(&plane(0.0, 1.0)), Orient::Outward);
    assert_eq!((found.reversed.as_slice(), found.open_told), (&[0][..], 2));
    let ball = Surface::from(Sphere::default()).tessellate(&Tessellation::default()).unwrap();
    let found = find(&next_to(&[ball, plane(0.0, 0.3)], DVec3::ZERO), Orient::Outward);
    assert_eq!((found.reversed.len(), found.open_left), (0, 1), "within a ball");
}

#[test]
fn votes_do_not_depend_on_threads_or_size() {
    let meshes: Vec<Mesh> = with_rims().into_iter().map(|(_, mesh)| mesh).collect();
    let mesh = next_to(&meshes, DVec3::new(7.0, 1.0, 0.5));
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| find(&mesh, Orient::Outward))
    };
    let one = with(1);
    assert_eq!(one.open_told, 4);
    assert!([2, 5].iter().all(|&threads| with(threads) == one));
    for power in [-600, 600] {
        let scaled = mesh.positions().iter().map(|p| p.to_array().map(|x| libm::scalbn(x, power)).into());
        assert_eq!(find(&build(scaled.collect(), mesh.faces().clone()), Orient::Outward), one, "2^{power}");
    }
}

/// Many components share the sample points. A component without points is not reversed, and time stays bounded.
#[test]
fn votes_have_a_budget() {
    let cups: Vec<Mesh> = (0..1000).map(|_| cup()).collect();
    let found = find(&next_to(&cups, DVec3::new(3.0, 0.0, 0.0)), Orient::Outward);
    assert_eq!((found.open_told, found.open_left), (256, 744));
    assert_eq!(found.reversed.len(), 0);
}

#[test]
fn the_confidence_asked_for_decides() {
    let (_, mesh) = with_rims().remove(0);
    let topology = Topology::build(&mesh, Weld::Exact);
    let reported =
        |confidence: f64| orient(&mesh, &topology, Orient::Outward, Confidence(confidence)).open_told;
    // 64 points that agree: 65/66.
    assert_eq!([0.5, 0.9, 0.98, 0.99, 1.0].map(reported), [1, 1, 1, 0, 0]);
    assert_eq!(reported(65.0 / 66.0), 0, "it has to be above");
}
