//! Winding repair on the real meshes.

use super::meshes::rows;
use crease::io::{ReadOptions, read};
use crease::mesh::{FaceEdit, Link, Mesh, Orient, Orientation, Topology, Weld, orient};

/// The parts of all files that can be read, by file name; which ones must be is for the tests of formats to say.
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
    orient(mesh, &Topology::build(mesh, Weld::Exact), policy)
}

/// What is mended once needs no mending, and whatever can agree does.
#[test]
fn mended_meshes_stay_as_they_are() {
    for (name, mesh) in parts() {
        for policy in [Orient::Consistent, Orient::Outward] {
            let found = find(&mesh, policy);
            let mended = turned(&mesh, &found.reversed);
            let again = find(&mended, policy);
            assert_eq!(again, Orientation { reversed: Vec::new(), inside_out: 0, ..found.clone() }, "{name}");
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

/// Which way a closed surface was wound before does not matter afterwards.
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

/// Faults that were looked at one by one.
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
