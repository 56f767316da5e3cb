//! What must not change a normal: the numbering of faces and vertices, the number of threads, the unit of length.

use crease::io::{ReadOptions, read};
use crease::mesh::{Faces, Mesh, MeshBuilder, Storage};
use crease::normals::{Crease, CreaseRule, NormalField, NormalRecipe, Weight, compute};
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

/// Every combination that takes another way through the code.
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
        positions: mesh.positions().iter().map(|&p| move_to(p)).collect(),
        storage,
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
            // Positions as f32 values, which stay normal numbers under the scalings below.
            let round = |p: DVec3| p.as_vec3().as_dvec3();
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
    let positions = vertices.iter().map(|&old| mesh.positions()[old as usize]).collect();
    let mesh = MeshBuilder { positions, faces, storage: mesh.storage(), ..MeshBuilder::default() };
    (mesh.build().unwrap(), corners)
}

/// Other numbers give the same groups, and normals that differ by the rounding of sums in another order: at most
/// 8 · valence · 2⁻⁵³ · κ. Here valence ≤ 64 and κ < 100 where sums do not cancel, so 1e-11 rad.
#[test]
fn numbering_changes_no_more_than_rounding() {
    for (name, mesh) in meshes() {
        let mesh = rebuilt(&mesh, mesh.storage(), |p| p);
        let plain = MeshBuilder {
            positions: mesh.positions().to_vec(),
            faces: mesh.faces().clone(),
            storage: mesh.storage(),
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
