//! What must not change a normal: the numbering of faces and vertices, the number of threads, the unit of length.

use crease::io::{ReadOptions, read};
use crease::mesh::{Faces, Mesh, MeshBuilder, Positions, Storage, Topology, Weld, triangulate};
use crease::normals::{Crease, CreaseRule, NormalField, NormalRecipe, Precision, Weight, compute};
use crease::num::Degrees;
use glam::DVec3;
use std::path::Path;

/// Meshes with polygons, creases, seams, slivers and faces that cancel.
fn meshes() -> Vec<(&'static str, Mesh)> {
    ["gear.obj", "bracket.obj", "polygons.obj", "slivers.obj", "leaf.ply", "sphere-seam.glb"]
        .map(|name| {
            let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("data").join(name);
            let mut loaded = read(&path, None, &ReadOptions::default()).unwrap();
            (name, loaded.parts.swap_remove(0).mesh)
        })
        .into()
}

/// Every combination that takes another path through the code.
fn recipes() -> impl Iterator<Item = NormalRecipe> {
    Weight::ALL.into_iter().flat_map(|weight| {
        let angles = [0.0, 40.0, 180.0].map(|angle| Crease::Angle(Degrees(angle)));
        angles.into_iter().flat_map(move |crease| {
            [CreaseRule::Fan, CreaseRule::Cone].map(|rule| NormalRecipe {
                weight,
                crease,
                rule,
                ..NormalRecipe::default()
            })
        })
    })
}

fn with_threads(threads: usize, work: impl FnOnce() -> NormalField + Send) -> NormalField {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(work)
}

#[test]
fn threads_do_not_change_a_bit() {
    for (name, mesh) in meshes() {
        for recipe in recipes() {
            let one = with_threads(1, || compute(&mesh, &recipe));
            for threads in [2, 3, 8] {
                assert_eq!(
                    with_threads(threads, || compute(&mesh, &recipe)),
                    one,
                    "{name} {recipe:?} {threads}"
                );
            }
        }
    }
}

fn rebuilt(mesh: &Mesh, storage: Storage, move_to: impl Fn(DVec3) -> DVec3) -> Mesh {
    MeshBuilder {
        positions: Positions::rounded(mesh.positions().iter().map(move_to).collect(), storage),
        faces: mesh.faces().clone(),
        columns: mesh.columns().clone(),
    }
    .build()
    .unwrap()
}

/// The same mesh in metres and in parsecs: a power of two scales without rounding, so nothing may change.
#[test]
fn powers_of_two_do_not_change_a_bit() {
    for (name, mesh) in meshes() {
        for storage in [Storage::F32, Storage::F64] {
            // Positions as f32 values, which stay normal numbers of an f32 under the scalings below.
            let round_one = |x: f64| if x.abs() < 1e-9 { 0.0 } else { f64::from(x as f32) };
            let round = |p: DVec3| DVec3::from(p.to_array().map(round_one));
            let mesh = rebuilt(&mesh, storage, round);
            for recipe in recipes() {
                let expected = compute(&mesh, &recipe);
                for exponent in [-90, -31, 1, 40, 100] {
                    let factor = f64::from_bits(((1023 + i64::from(exponent)) as u64) << 52);
                    let scaled = compute(&rebuilt(&mesh, storage, |p| p * factor), &recipe);
                    assert_eq!(scaled, expected, "{name} {storage:?} {recipe:?} 2^{exponent}");
                }
            }
        }
    }
}

/// Singles and doubles of the same values: welding joins the same edges, and normals have the same bits. Slivers differ, since a
/// double has more digits below which they are noise.
#[test]
fn singles_and_the_same_doubles_give_the_same_bits() {
    for (name, mesh) in meshes().into_iter().filter(|(name, _)| *name != "slivers.obj") {
        let of_storage = |storage| rebuilt(&mesh, storage, |p| p.as_vec3().as_dvec3());
        for separate in [false, true] {
            let [singles, doubles] = [Storage::F32, Storage::F64].map(|storage| {
                let mesh = of_storage(storage);
                if separate { with_own_vertices(&mesh) } else { mesh }
            });
            assert_eq!((singles.storage(), doubles.storage()), (Storage::F32, Storage::F64));
            for weld in [Weld::Exact, Weld::Relative(1e-3)] {
                let links = [&singles, &doubles].map(|mesh| {
                    let topology = Topology::build(mesh, weld);
                    (0..mesh.faces().corner_count() as u32).map(|h| topology.link(h)).collect::<Vec<_>>()
                });
                assert_eq!(links[0], links[1], "{name} {weld:?}");
            }
            assert_eq!(triangulate(&singles), triangulate(&doubles), "{name}");
            for recipe in recipes() {
                for precision in [Precision::Faithful, Precision::Fast] {
                    let recipe = NormalRecipe { precision, ..recipe };
                    let [a, b] = [&singles, &doubles].map(|mesh| compute(mesh, &recipe));
                    assert_eq!((a.normals, a.face_normals), (b.normals, b.face_normals), "{name} {recipe:?}");
                    assert_eq!(a.summary.fast_declined, b.summary.fast_declined, "{name} {recipe:?}");
                }
            }
        }
    }
}

/// The mesh with a vertex for each corner, as in an STL file. Every other zero is negative.
fn with_own_vertices(mesh: &Mesh) -> Mesh {
    let signed = |(corner, &vertex): (usize, &u32)| {
        let sign = if corner % 2 == 0 { 1.0 } else { -1.0 };
        DVec3::from(mesh.positions().at(vertex).to_array().map(|x| if x == 0.0 { sign * 0.0 } else { x }))
    };
    let positions = mesh.faces().corners().iter().enumerate().map(signed).collect();
    let mut faces = Faces::new();
    mesh.faces().ranges().for_each(|range| faces.push(&range.map(|c| c as u32).collect::<Vec<_>>()));
    let positions = Positions::rounded(positions, mesh.storage());
    MeshBuilder { positions, faces, ..MeshBuilder::default() }.build().unwrap()
}

/// A fixed shuffle of `0..count`.
fn shuffle(count: usize, seed: u64) -> Vec<u32> {
    let mut state = seed;
    let mut order: Vec<u32> = (0..count as u32).collect();
    for i in (1..count).rev() {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        order.swap(i, (state >> 33) as usize % (i + 1));
    }
    order
}

/// Faces and vertices in another order. Returns for each new corner the old one.
fn renumbered(mesh: &Mesh, seed: u64) -> (Mesh, Vec<u32>) {
    let vertices = shuffle(mesh.vertex_count(), seed);
    let mut new_of = vec![0; vertices.len()];
    vertices.iter().enumerate().for_each(|(new, &old)| new_of[old as usize] = new as u32);
    let (mut faces, mut corners) = (Faces::new(), Vec::new());
    for face in shuffle(mesh.face_count(), seed ^ 1) {
        let range = mesh.faces().range(face as usize);
        corners.extend(range.clone().map(|corner| corner as u32));
        let face: Vec<u32> = range.map(|c| new_of[mesh.faces().corners()[c] as usize]).collect();
        faces.push(&face);
    }
    let positions = vertices.iter().map(|&old| mesh.positions().at(old)).collect();
    let mesh = MeshBuilder {
        positions: Positions::rounded(positions, mesh.storage()),
        faces,
        ..MeshBuilder::default()
    };
    (mesh.build().unwrap(), corners)
}

/// Other numbers give the same groups, and normals that differ by the rounding of sums in another order: at most
/// 8 · valence · 2⁻⁵³ · κ. Here valence ≤ 64 and κ < 100 where sums do not cancel, so 1e-11 rad.
#[test]
fn numbering_changes_no_more_than_rounding() {
    for (name, mesh) in meshes() {
        let mesh = rebuilt(&mesh, mesh.storage(), |p| p);
        let plain = MeshBuilder {
            positions: Positions::rounded(mesh.positions().to_vec(), mesh.storage()),
            faces: mesh.faces().clone(),
            ..MeshBuilder::default()
        }
        .build()
        .unwrap();
        let (other, old_corner) = renumbered(&plain, 2024);
        for recipe in recipes().filter(|recipe| !recipe.weight.is_fit()) {
            let (a, b) = (compute(&plain, &recipe), compute(&other, &recipe));
            assert_eq!(a.summary, b.summary, "{name} {recipe:?}");
            let sorted = |field: &NormalField, map: &dyn Fn(u32) -> u32| {
                let mut faults: Vec<_> =
                    field.faults.corners.iter().map(|fault| (map(fault.index), fault.reason)).collect();
                faults.sort_unstable();
                faults
            };
            let faults = sorted(&a, &|corner| corner);
            assert_eq!(faults, sorted(&b, &|corner| old_corner[corner as usize]), "{name} {recipe:?}");
            for (new, &old) in old_corner.iter().enumerate() {
                let (x, y) = (a.normals.get(old as usize, 0).unwrap(), b.normals.get(new, 0).unwrap());
                let off = libm::atan2(x.cross(*y).length(), x.dot(*y));
                assert!(off <= 1e-11, "{name} {recipe:?} corner {old}: {off:e} rad, {x} {y}");
            }
        }
    }
}
