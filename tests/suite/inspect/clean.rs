//! Meshes without faults.

use super::{grave, inspect, rebuilt, recipe, surface, with_normals};
use crate::cli::data;
use crate::meshes;
use crease::io::{Format, Part, ReadOptions, WriteOptions, read, read_bytes, write_new};
use crease::mesh::{FaceEdit, Faces, Mesh};
use crease::normals::{NormalRecipe, Weight};
use crease::quality::catalogue::Kind;
use crease::quality::{Severity, Site, Thresholds, diagnose};
use crease::surface::{
    Catenoid, Cone, Cylinder, MonkeySaddle, Pattern, Sphere, Superquadric, Surface, Tessellation, Torus, Wave,
};
use glam::DVec3;

/// A clean mesh and its properties.
pub(super) struct Clean {
    pub(super) name: &'static str,
    pub(super) mesh: Mesh,
    /// The recipe of its normals.
    pub(super) recipe: NormalRecipe,
    pub(super) is_closed: bool,
    /// It has an outer side; that of an open mesh is known by visibility.
    pub(super) has_outside: bool,
    /// Its normals have so many directions that quantisation shows.
    pub(super) is_round: bool,
    /// Its faces are so uneven that weightings differ.
    pub(super) is_uneven: bool,
    /// It is closed and faces inwards intentionally: its normals do so as well.
    pub(super) is_room: bool,
}

fn clean(name: &'static str, mesh: Mesh, crease: f64) -> Clean {
    let recipe = recipe(Weight::Angle, crease);
    let mesh = with_normals(mesh.with_normals(None), &recipe);
    let (is_closed, has_outside, is_round) = (true, true, true);
    Clean { name, mesh, recipe, is_closed, has_outside, is_round, is_uneven: false, is_room: false }
}

/// A closed mesh to be seen from within: its faces are reversed before its normals are computed.
fn room(name: &'static str, mesh: &Mesh) -> Clean {
    let reversed = (0..mesh.face_count() as u32).collect();
    let inward = mesh.with_faces(&FaceEdit { reversed, ..FaceEdit::default() });
    Clean { is_round: false, is_room: true, ..clean(name, inward, 40.0) }
}

/// A box with sides of 8 × 8 squares, each side with vertices of its own.
fn tiled_box() -> Mesh {
    const TILES: u32 = 8;
    let (mut positions, mut faces) = (Vec::new(), Faces::new());
    for (axis, sign) in (0..3).flat_map(|axis| [(axis, -1.0), (axis, 1.0)]) {
        let [out, across] = [DVec3::AXES[axis] * sign, DVec3::AXES[(axis + 1) % 3]];
        let along = out.cross(across);
        let first = positions.len() as u32;
        let share = |i: u32| f64::from(i) * 2.0 / f64::from(TILES) - 1.0;
        let rows = (0..=TILES).flat_map(|i| (0..=TILES).map(move |j| (i, j)));
        let size = DVec3::new(3.0, 2.0, 4.0);
        positions.extend(rows.map(|(i, j)| (out + across * share(i) + along * share(j)) * size));
        for corner in (0..TILES).flat_map(|i| (0..TILES).map(move |j| first + i * (TILES + 1) + j)) {
            faces.push(&[corner, corner + TILES + 1, corner + TILES + 2, corner + 1]);
        }
    }
    rebuilt(positions, faces)
}

fn jittered(shape: &Surface, segments: [u32; 2]) -> Mesh {
    let tessellation = Tessellation { segments, jitter: 0.5, ..Tessellation::default() };
    shape.tessellate(&tessellation).unwrap()
}

/// Half a ball of uneven triangles, open below.
fn bowl() -> Mesh {
    let whole = jittered(&Surface::from(Sphere::default()), [40, 24]);
    let is_above = |face: &&[u32]| face.iter().all(|&v| whole.positions().at(v).y > -0.2);
    let mut faces = Faces::new();
    whole.faces().iter().filter(is_above).for_each(|face| faces.push(face));
    rebuilt(whole.positions().to_vec(), faces)
}

pub(super) fn file(name: &str) -> Mesh {
    read(&data(name), None, &ReadOptions::default()).unwrap().parts.remove(0).mesh
}

/// Analytic surfaces and files of `data/`, and a real mesh if it is available.
pub(super) fn meshes() -> Vec<Clean> {
    let ball = Tessellation { pattern: Pattern::Icosphere(3), ..Tessellation::default() };
    let sphere = Surface::from(Sphere::default());
    let torus = Surface::from(Torus::default());
    let mut all = vec![
        clean("icosphere", sphere.tessellate(&ball).unwrap(), 40.0),
        Clean { is_uneven: true, ..clean("torus", jittered(&torus, [48, 24]), 40.0) },
        Clean {
            is_closed: false,
            has_outside: false,
            is_uneven: true,
            ..clean("wave", jittered(&Surface::Wave(Wave::default()), [40, 40]), 40.0)
        },
        Clean { is_closed: false, is_uneven: true, ..clean("bowl", bowl(), 40.0) },
        Clean { is_round: false, ..clean("gear", file("gear.obj"), 40.0) },
        room("sky", &sphere.tessellate(&ball).unwrap()),
        room("box room", &tiled_box()),
        room("gear room", &file("gear.obj")),
    ];
    if let Some(path) = meshes::path("ref/fandisk_vtk_split30.ply") {
        let mesh = read(&path, None, &ReadOptions::default()).unwrap().parts.remove(0).mesh;
        all.push(Clean { is_uneven: true, ..clean("fandisk", mesh, 30.0) });
    }
    all
}

#[test]
fn clean_meshes_get_no_warning() {
    for clean in meshes() {
        let diagnosis = inspect(&clean.mesh, 10);
        // Only the author knows whether a room is intended.
        let reported: &[&str] = if clean.is_room { &["inside-out"] } else { &[] };
        assert_eq!(grave(&diagnosis), reported, "{}", clean.name);
        assert_ne!(diagnosis.worst(), Some(Severity::Error), "{}", clean.name);
    }
    for (shape, segments) in [
        (Surface::from(Cylinder::default()), [32, 8]),
        (Surface::from(Torus::default()), [32, 16]),
        (Surface::Superquadric(Superquadric::default()), [32, 16]),
        (Surface::Teapot, [6, 6]),
    ] {
        // With the exact normals of the surface, which are no weighted mean of face normals.
        let diagnosis = inspect(&surface(&shape, segments), 10);
        assert_eq!(grave(&diagnosis), Vec::<&str>::new(), "{shape:?}");
    }
}

/// The dual cuts the tip of a cone off, and the flat end has the normals of the sides: this is the only finding.
#[test]
fn a_cone_is_clean_but_for_a_tip_that_is_cut_off() {
    let cone = Surface::from(Cone::default());
    let reported = |pattern| {
        let tessellation = Tessellation { segments: [64, 32], pattern, ..Tessellation::default() };
        inspect(&cone.tessellate(&tessellation).unwrap(), 100)
    };
    for pattern in [Pattern::Triangles, Pattern::Quads] {
        assert_eq!(grave(&reported(pattern)), Vec::<&str>::new(), "{}", pattern.name());
    }
    let diagnosis = reported(Pattern::Polygons);
    assert_eq!(grave(&diagnosis), ["averaged-crease"]);
    let averaged = diagnosis.get(Kind::AveragedCrease).unwrap();
    assert_eq!(averaged.count, 64);
    let is_at_tip = |site: &Site| site.position.is_some_and(|at| at.y > 0.95);
    assert!(averaged.places.len() == 64 && averaged.places.iter().all(is_at_tip));
}

/// Some triangles of marching and scattered meshes hardly have the direction of the surface. A large dihedral angle there is no
/// sharp edge if the mesh has no other sharp edges.
#[test]
fn faces_that_came_out_badly_are_no_sharp_edges() {
    let mut noted = 0;
    let saddle = || Surface::MonkeySaddle(MonkeySaddle::default());
    for (shape, pattern) in [
        (Surface::from(Cone::default()), Pattern::Marching),
        (Surface::Catenoid(Catenoid::default()), Pattern::Marching),
        (saddle(), Pattern::Marching),
        (saddle(), Pattern::Scattered),
    ] {
        let tessellation = Tessellation { segments: [40, 24], pattern, ..Tessellation::default() };
        let diagnosis = inspect(&shape.tessellate(&tessellation).unwrap(), 1);
        assert_eq!(grave(&diagnosis), [""; 0], "{shape:?}, {}", pattern.name());
        noted += u32::from(diagnosis.get(Kind::AveragedCrease).is_some());
    }
    assert!(noted > 2, "{noted} have such edges");
}

/// On a rough surface many edges above the crease angle are the only one at their vertex. They split nothing, so smooth edges do
/// not bound the crease angle.
#[test]
fn rough_meshes_with_our_own_normals_get_no_warning() {
    let sphere = Surface::from(Sphere::default());
    for noise in [0.06, 0.15, 0.2] {
        let rough = Tessellation { noise, ..Tessellation::default() };
        let clean = clean("rough ball", sphere.tessellate(&rough).unwrap(), 40.0);
        let diagnosis = inspect(&clean.mesh, 10);
        let estimate = diagnosis.parts[0].estimate.unwrap();
        assert!(estimate.reproduced > 0.999, "{noise}: {estimate:?}");
        let stored = ["flipped-normals", "stray-normals", "split-seam", "averaged-crease"];
        assert!(!grave(&diagnosis).iter().any(|id| stored.contains(id)), "{noise}: {:?}", grave(&diagnosis));
    }
}

/// The vertices of an edge without length share a position. If a file has a vertex for each normal, its fans there may differ
/// from those that the normals were computed from, which is no fault.
#[test]
fn edges_without_length_make_no_outliers() {
    let mut without_length = 0;
    for seed in 0..12 {
        let rough = Tessellation { noise: 0.2, seed, segments: [24, 12], ..Tessellation::default() };
        let ball = Surface::from(Sphere::default()).tessellate(&rough).unwrap();
        let mut positions = ball.positions().to_vec();
        for face in ball.faces().iter().skip(7).step_by(31) {
            positions[face[1] as usize] = positions[face[0] as usize];
            without_length += 1;
        }
        let mesh = with_normals(rebuilt(positions, ball.faces().clone()), &recipe(Weight::Angle, 40.0));
        let parts = [Part { mesh, ..Part::default() }];
        let written = write_new(&parts, Format::Ply, &WriteOptions::default()).unwrap();
        let loaded = read_bytes(written.bytes, Some(Format::Ply), None, &ReadOptions::default()).unwrap();
        let diagnosis = diagnose(&loaded, &Thresholds::default(), &|_| {});
        assert!(!grave(&diagnosis).contains(&"stray-normals"), "seed {seed}: {:?}", diagnosis.findings);
    }
    assert!(without_length > 100, "{without_length}");
}
