//! Orientation of closed, nested, open and degenerate surfaces.

use super::policy::*;
use crate::mesh::{FaceEdit, Faces, Link, MeshBuilder, Weld};
use crate::mesh::{Mesh, Topology};
use glam::DVec3;

fn build(positions: Vec<DVec3>, faces: &[Vec<u32>]) -> Mesh {
    let mut list = Faces::new();
    faces.iter().for_each(|face| list.push(face));
    MeshBuilder { positions: positions.into(), faces: list, ..MeshBuilder::default() }.build().unwrap()
}

/// A sphere of 8·4ˡ triangles, facing outwards.
fn sphere(levels: u32, centre: DVec3, radius: f64) -> Mesh {
    let axes = [DVec3::X, DVec3::Y, DVec3::Z];
    let mut positions: Vec<DVec3> = axes.iter().flat_map(|&axis| [axis, -axis]).collect();
    let mut faces: Vec<Vec<u32>> = Vec::new();
    for octant in 0..8u32 {
        let [x, y, z] = [octant & 1, octant >> 1 & 1, octant >> 2];
        let face = vec![x, 2 + y, 4 + z];
        faces.push(if (x + y + z) % 2 == 0 { face } else { face.into_iter().rev().collect() });
    }
    for _ in 0..levels {
        let mut middles = std::collections::BTreeMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                positions.push((positions[a as usize] + positions[b as usize]).normalize());
                positions.len() as u32 - 1
            })
        };
        faces = faces
            .iter()
            .flat_map(|face| {
                let [a, b, c] = [face[0], face[1], face[2]];
                let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
                [vec![a, ab, ca], vec![ab, b, bc], vec![ca, bc, c], vec![ab, bc, ca]]
            })
            .collect();
    }
    build(positions.into_iter().map(|p| centre + radius * p).collect(), &faces)
}

/// The eight corners of a box and its six quadrilaterals, facing outwards.
fn cuboid(low: DVec3, high: DVec3) -> Mesh {
    let corner = |i: u32| {
        let pick = |bit: u32, axis: usize| if i >> bit & 1 == 1 { high[axis] } else { low[axis] };
        DVec3::new(pick(0, 0), pick(1, 1), pick(2, 2))
    };
    let sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    build((0..8).map(corner).collect(), &sides.map(|side| side.to_vec()))
}

fn union(meshes: &[Mesh]) -> Mesh {
    let (mut positions, mut faces) = (Vec::new(), Vec::new());
    for mesh in meshes {
        let first = positions.len() as u32;
        positions.extend(mesh.positions().iter());
        faces.extend(mesh.faces().iter().map(|face| face.iter().map(|v| v + first).collect()));
    }
    build(positions, &faces)
}

fn turned(mesh: &Mesh, reversed: impl IntoIterator<Item = u32>) -> Mesh {
    mesh.with_faces(&FaceEdit { reversed: reversed.into_iter().collect(), ..FaceEdit::default() })
}

fn mapped(mesh: &Mesh, map: impl Fn(DVec3) -> DVec3) -> Mesh {
    let faces: Vec<Vec<u32>> = mesh.faces().iter().map(<[u32]>::to_vec).collect();
    build(mesh.positions().iter().map(map).collect(), &faces)
}

/// Every face with vertices of its own, as in an STL file.
fn soup(mesh: &Mesh) -> Mesh {
    let positions = mesh.faces().corners().iter().map(|&v| mesh.positions().at(v)).collect();
    let faces: Vec<Vec<u32>> = mesh.faces().ranges().map(|r| r.map(|c| c as u32).collect()).collect();
    build(positions, &faces)
}

fn run(mesh: &Mesh, policy: Orient) -> Orientation {
    orient(mesh, &Topology::build(mesh, Weld::Exact), policy, Confidence::default())
}

fn inconsistent(mesh: &Mesh) -> usize {
    let topology = Topology::build(mesh, Weld::Exact);
    let half_edges = 0..mesh.faces().corner_count() as u32;
    half_edges.filter(|&h| matches!(topology.link(h), Link::Inconsistent(_))).count()
}

/// A strip of quadrilaterals round a ring, joined with a half turn or without.
fn strip(half_turn: bool) -> Mesh {
    let count = 12;
    let positions = (0..2 * count)
        .map(|i| {
            let (turn, side) = (f64::from(i / 2) / f64::from(count), f64::from(i % 2) - 0.5);
            let (round, tilt) = (turn * std::f64::consts::TAU, turn * std::f64::consts::PI);
            let out = 2.0 + side * if half_turn { libm::cos(tilt) } else { 1.0 };
            let up = side * if half_turn { libm::sin(tilt) } else { 0.0 };
            DVec3::new(out * libm::cos(round), out * libm::sin(round), up)
        })
        .collect();
    let faces: Vec<Vec<u32>> = (0..count)
        .map(|i| {
            let (a, b) = (2 * i, 2 * i + 1);
            let last = i + 1 == count;
            let (c, d) = ((2 * i + 2) % (2 * count), (2 * i + 3) % (2 * count));
            if last && half_turn { vec![a, b, c, d] } else { vec![a, b, d, c] }
        })
        .collect();
    build(positions, &faces)
}

#[test]
fn scattered_faces_are_turned_back() {
    let good = sphere(2, DVec3::ZERO, 1.0);
    assert!(run(&good, Orient::Outward).reversed.is_empty());
    for wrong in [vec![0], vec![3, 4, 5, 70], (0..60).map(|i| 2 * i).collect()] {
        let mesh = turned(&good, wrong.iter().copied());
        for policy in [Orient::Consistent, Orient::Outward] {
            let found = run(&mesh, policy);
            assert_eq!(found.reversed, wrong);
            assert_eq!((found.components, found.closed, found.inside_out), (1, 1, 0));
            assert_eq!(turned(&mesh, found.reversed), good);
        }
    }
    assert_eq!(run(&turned(&good, [1]), Orient::Keep), Orientation::default());
}

#[test]
fn a_tie_goes_to_the_lowest_face() {
    let square = [[0., 0.], [1., 0.], [1., 1.], [0., 1.]].map(|[x, y]| DVec3::new(x, y, 0.0));
    let found = run(&build(square.to_vec(), &[vec![0, 1, 2], vec![2, 0, 3]]), Orient::Consistent);
    assert_eq!(found.reversed, [1]);
}

#[test]
fn inside_out_surfaces_are_turned_as_a_whole() {
    let good = sphere(1, DVec3::ONE, 3.0);
    let mesh = turned(&good, (0..32).filter(|&face| face != 7));
    let found = run(&mesh, Orient::Outward);
    assert_eq!(turned(&mesh, found.reversed.iter().copied()), good);
    assert_eq!((found.inside_out, found.cavities), (1, 0));
    let found = run(&mesh, Orient::Consistent);
    assert_eq!(found.reversed, [7], "the fewer ones, whichever way the rest faces");
}

/// Neither a Möbius strip nor anything with a rim has an outside; a Möbius strip has not even two sides.
#[test]
fn surfaces_without_an_outside_stay() {
    let ring = turned(&strip(false), [4]);
    let found = run(&ring, Orient::Outward);
    assert_eq!((found.reversed.len(), found.open_left, found.components), (0, 1, 1));
    assert_eq!(run(&ring, Orient::Consistent).reversed, [4]);
    for mesh in [strip(true), turned(&strip(true), [2, 3])] {
        for policy in [Orient::Consistent, Orient::Outward] {
            let found = run(&mesh, policy);
            assert_eq!((found.reversed.len(), found.non_orientable, found.open_left), (0, 1, 0));
        }
    }
    let half = sphere(2, DVec3::ZERO, 1.0);
    let upper: Vec<Vec<u32>> = half
        .faces()
        .iter()
        .filter(|face| face.iter().all(|&v| half.positions().at(v).z >= 0.0))
        .map(<[u32]>::to_vec)
        .collect();
    let half = turned(&build(half.positions().to_vec(), &upper), [9]);
    let topology = Topology::build(&half, Weld::Exact);
    let found = orient(&half, &topology, Orient::Outward, Confidence::NEVER);
    assert_eq!((found.reversed.len(), found.open_left, found.closed), (0, 1, 0));
}

#[test]
fn shells_alternate_with_depth() {
    let radii = [4.0, 3.0, 2.0, 1.0];
    let shells = radii.map(|radius| sphere(2, DVec3::new(0.3, 0.2, 0.1), radius));
    let next_to = sphere(1, DVec3::new(9.0, 0.0, 0.0), 2.0);
    let mesh = union(&[shells.to_vec(), vec![next_to]].concat());
    let found = run(&mesh, Orient::Outward);
    let cavities: Vec<u32> = (128..256).chain(384..512).collect();
    assert_eq!(found.reversed, cavities);
    assert_eq!((found.closed, found.inside_out, found.cavities), (5, 2, 2));
    let found = run(&turned(&mesh, cavities.iter().copied().chain([520])), Orient::Outward);
    assert_eq!((found.reversed.as_slice(), found.inside_out, found.cavities), (&[520][..], 0, 2));
}

/// Boxes on a grid: rays through corners and along walls, faces in one plane.
#[test]
fn boxes_that_share_planes_are_distinguished() {
    let cube = |low: [f64; 3], size: f64| cuboid(low.into(), DVec3::from(low) + size);
    let depths = |meshes: &[Mesh]| {
        let mesh = union(meshes);
        let found = orient(&mesh, &Topology::build(&mesh, Weld::Off), Orient::Outward, Confidence::NEVER);
        (found.cavities, found.undecided, found.reversed.len())
    };
    let big = cube([0.; 3], 4.0);
    assert_eq!(depths(&[big.clone(), cube([1.; 3], 1.0)]), (1, 0, 6), "inside");
    assert_eq!(depths(&[big.clone(), cube([4., 0., 0.], 4.0)]), (0, 0, 0), "wall to wall");
    assert_eq!(depths(&[big.clone(), cube([0.; 3], 1.0)]), (1, 0, 6), "inside, in a corner");
    assert_eq!(depths(&[big.clone(), cube([3., 1., 1.], 2.0)]), (0, 0, 0), "cutting through a wall");
    let plate = cuboid(DVec3::ZERO, DVec3::new(4.0, 4.0, 1.0));
    let rib = cuboid(DVec3::new(0.0, 0.0, 1.0), DVec3::new(1.0, 4.0, 4.0));
    assert_eq!(depths(&[plate, rib, cube([1.; 3], 1.0)]), (0, 0, 0), "in the hollow of an L");
    assert_eq!(depths(&[big.clone(), big]), (0, 2, 0), "twice the same");
}

/// A box that touches another along an edge is closed, though four faces meet there; a fin on its side is
/// open and stays.
#[test]
fn shared_edges_do_not_open_a_surface() {
    let touching = union(&[
        cuboid(DVec3::ZERO, DVec3::ONE),
        cuboid(DVec3::new(1.0, 1.0, 0.0), DVec3::new(2.0, 2.0, 1.0)),
    ]);
    let found = run(&turned(&touching, 3..12), Orient::Outward);
    assert_eq!((found.components, found.closed), (2, 2));
    assert_eq!(found.reversed, (3..12).collect::<Vec<_>>());

    let cube = cuboid(DVec3::ZERO, DVec3::ONE);
    let mut positions = cube.positions().to_vec();
    positions.push(DVec3::new(-1.0, -1.0, 0.5));
    let mut faces: Vec<Vec<u32>> = cube.faces().iter().map(<[u32]>::to_vec).collect();
    faces.push(vec![0, 4, 8]);
    let found = run(&turned(&build(positions, &faces), 0..6), Orient::Outward);
    assert_eq!((found.closed, found.open_left), (1, 1));
    assert_eq!(found.reversed, [0, 1, 2, 3, 4, 5]);
}

#[test]
fn a_sheet_with_two_sides_has_no_volume() {
    let corners = [DVec3::ZERO, DVec3::X, DVec3::new(0.3, 0.7, 0.1)];
    let found = run(&build(corners.to_vec(), &[vec![0, 1, 2], vec![0, 2, 1]]), Orient::Outward);
    assert_eq!((found.closed, found.flat, found.reversed.len()), (1, 1, 0));
    // Its two sides are cut along different diagonals, and what lies between is no inside.
    for height in [1e-9, -1e-9, 0.3, -0.3] {
        let corners = [DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, height), DVec3::Y];
        let sheet = build(corners.to_vec(), &[vec![0, 1, 2, 3], vec![3, 2, 1, 0]]);
        let found = run(&sheet, Orient::Outward);
        assert_eq!((found.closed, found.flat, found.reversed.len()), (1, 1, 0), "{height}");
    }
}

/// Edges of no length and faces of no area neither open a surface nor make components of their own.
#[test]
fn collapsed_faces_do_not_count() {
    let cube = cuboid(DVec3::ZERO, DVec3::ONE);
    let mut positions = cube.positions().to_vec();
    positions.push(positions[0]);
    let mut faces: Vec<Vec<u32>> = cube.faces().iter().map(<[u32]>::to_vec).collect();
    faces.push(vec![0, 1, 1]);
    faces.push(vec![0, 8, 1]);
    let mesh = soup(&build(positions, &faces));
    let found = run(&turned(&mesh, [5]), Orient::Outward);
    assert_eq!((found.components, found.closed, found.reversed.as_slice()), (1, 1, &[5][..]));
}

#[test]
fn soups_are_oriented_over_welded_edges() {
    let shells = union(&[sphere(2, DVec3::ZERO, 2.0), sphere(1, DVec3::ZERO, 1.0)]);
    let wrong: Vec<u32> = (0..160).filter(|face| face % 7 == 3).collect();
    let mesh = turned(&soup(&shells), wrong.iter().copied());
    let found = run(&mesh, Orient::Outward);
    let repaired = turned(&mesh, found.reversed);
    assert_eq!((found.components, found.closed, found.cavities), (2, 2, 1));
    assert_eq!(inconsistent(&repaired), 0);
    assert!(inconsistent(&mesh) > 0);
    let right = turned(&soup(&shells), 128..160);
    let same_way = |a: &Mesh, b: &Mesh| {
        // Reversing keeps the first corner, and a soup's corners count up or down from it.
        (0..a.face_count()).all(|face| a.faces().face(face)[1] == b.faces().face(face)[1])
    };
    assert!(same_way(&repaired, &right));
    let off = orient(&mesh, &Topology::build(&mesh, Weld::Off), Orient::Outward, Confidence::NEVER);
    assert_eq!((off.components, off.open_left), (160, 160));
}

/// Powers of two change nothing, however far they go; distance costs the digits of the file and no more.
#[test]
fn size_and_place_do_not_matter() {
    let shells = union(&[3.0, 2.0, 1.0].map(|radius| sphere(2, DVec3::new(0.1, 0.2, 0.3), radius)));
    let mesh = turned(&shells, [5, 130, 131, 300]);
    let expected = run(&mesh, Orient::Outward);
    assert_eq!((expected.closed, expected.cavities, expected.undecided), (3, 1, 0));
    for power in [-1020, -600, -100, 100, 600, 1021] {
        let scaled = mapped(&mesh, |p| p.to_array().map(|x| libm::scalbn(x, power)).into());
        assert_eq!(run(&scaled, Orient::Outward), expected, "2^{power}");
    }
    for away in [1e3, 1e7, 1e12] {
        let moved = mapped(&mesh, |p| p + away * DVec3::new(1.0, -0.7, 0.3));
        assert_eq!(run(&moved, Orient::Outward), expected, "{away:e}");
    }
    // A small pair of shells next to a huge box.
    let small = mapped(&mesh, |p| p * 1e-60);
    let both = union(&[small, cuboid(DVec3::splat(10.0), DVec3::splat(1e60))]);
    assert_eq!(run(&both, Orient::Outward).reversed, expected.reversed);
}

#[test]
fn numbering_does_not_matter() {
    let shells = union(&[3.0, 2.0, 1.0].map(|radius| sphere(2, DVec3::new(0.1, 0.2, 0.3), radius)));
    let mesh = turned(&shells, (0..384).filter(|face| face % 5 == 2));
    let found = run(&mesh, Orient::Outward);
    let count = mesh.face_count() as u32;
    // 5 and 384 have no common factor, nor have 7 and the number of vertices.
    let vertices = mesh.vertex_count() as u32;
    let old_face = |new: u32| new * 5 % count;
    let new_vertex = |old: u32| old * 7 % vertices;
    assert_ne!(vertices % 7, 0);
    let mut positions = vec![DVec3::ZERO; vertices as usize];
    for (old, p) in mesh.positions().iter().enumerate() {
        positions[new_vertex(old as u32) as usize] = p;
    }
    let faces: Vec<Vec<u32>> = (0..count)
        .map(|new| mesh.faces().face(old_face(new) as usize).iter().map(|&v| new_vertex(v)).collect())
        .collect();
    let renumbered = run(&build(positions, &faces), Orient::Outward);
    let mut back: Vec<u32> = renumbered.reversed.iter().map(|&new| old_face(new)).collect();
    back.sort_unstable();
    assert_eq!(back, found.reversed);
    assert_eq!(Orientation { reversed: back, ..renumbered }, found);
}

#[test]
fn any_number_of_threads_finds_the_same() {
    let shells = union(&[3.0, 2.0, 1.0].map(|radius| sphere(5, DVec3::new(0.1, 0.2, 0.3), radius)));
    let mesh = turned(&shells, (0..20_000).filter(|face| face % 11 == 2));
    let topology = Topology::build(&mesh, Weld::Exact);
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| orient(&mesh, &topology, Orient::Outward, Confidence::default()))
    };
    let one = with(1);
    assert_eq!((one.closed, one.cavities), (3, 1));
    assert!([2, 3, 8].iter().all(|&threads| with(threads) == one));
}

/// Each of n tetrahedra within all larger ones needs n² answers. Few tetrahedra have them all; of many, those beyond the budget
/// are counted and do not change.
#[test]
fn searches_without_end_are_cut_short() {
    let nested = |count: u32| {
        let tetrahedra: Vec<Mesh> = (0..count)
            .map(|i| {
                let (low, size) = (DVec3::splat(-0.2 * f64::from(i)), f64::from(i + 1));
                let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z].map(|p| low + size * p);
                build(corners.to_vec(), &[vec![0, 2, 1], vec![0, 1, 3], vec![0, 3, 2], vec![1, 2, 3]])
            })
            .collect();
        run(&union(&tetrahedra), Orient::Outward)
    };
    let few = nested(201);
    assert_eq!((few.closed, few.cavities, few.undecided), (201, 100, 0));
    let many = nested(30_000);
    assert!(many.undecided > 20_000, "{}", many.undecided);
    assert_eq!(many.reversed.len(), 4 * many.cavities);
    assert!(many.undecided + many.cavities < many.closed);
}
