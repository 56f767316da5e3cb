//! Seams: one surface of several primitives, cuts through smooth meshes, and vertices that nearly meet.

use super::cavities::one_mesh;
use super::clean::{Clean, meshes};
use super::planted::{Planted, per_corner, unshared};
use super::{grave, inspect, rebuilt, recipe, surface, with_normals};
use crease::io::{Format, Loaded, Part, ReadOptions, WriteOptions, read_bytes, write_new};
use crease::mesh::{Column, Faces, Mesh, Topology, Weld};
use crease::normals::Weight;
use crease::num::{Degrees, angle_between};
use crease::quality::catalogue::Kind;
use crease::quality::{Severity, Thresholds, diagnose};
use crease::surface::{Pattern, Sphere, Surface, Tessellation, Torus};
use glam::DVec3;
use std::collections::BTreeSet;

/// Whether a face lies on the half of a ball towards +x.
fn is_right(mesh: &Mesh, face: usize) -> bool {
    let corners = mesh.faces().face(face);
    corners.iter().map(|&vertex| mesh.positions().at(vertex).x).sum::<f64>() > 0.0
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
fn seams_between_primitives_are_reported() {
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
        half.with_normals(Some(Column::per_vertex(values)))
    };
    assert_eq!(seams(&halves(&ball, as_whole)), (0, 0), "computed as one");
}

/// A mesh with separate vertices for the faces beyond a plane, moved away by `apart`, a share of the diagonal.
pub(super) fn cut(mesh: &Mesh, across: DVec3, apart: f64) -> Mesh {
    let (low, high) = mesh.bounds().unwrap();
    let middle = low.midpoint(high) + (high - low) * 0.013;
    let aside = DVec3::new(0.6, 0.0, 0.8) * apart * (high - low).length();
    let positions = mesh.positions();
    let is_beyond =
        |face: &[u32]| face.iter().map(|&v| (positions.at(v) - middle).dot(across)).sum::<f64>() > 0.0;
    let count = positions.len() as u32;
    let mut faces = Faces::new();
    for face in mesh.faces().iter() {
        let offset = if is_beyond(face) { count } else { 0 };
        faces.push(&face.iter().map(|v| v + offset).collect::<Vec<_>>());
    }
    let all = [DVec3::ZERO, aside].into_iter().flat_map(|by| positions.iter().map(move |p| p + by));
    rebuilt(all.collect(), faces)
}

/// Edges that are smooth in `smooth`, and whose two sides in `split` differ by more than `degrees` at both ends.
fn split_by(mesh: &Mesh, smooth: &[DVec3], split: &[DVec3], degrees: f64) -> BTreeSet<u32> {
    let topology = Topology::build(mesh, Weld::Exact);
    let is_split = |half_edge: &u32| {
        let Some(across) = topology.across(*half_edge).filter(|across| half_edge < across) else {
            return false;
        };
        let ends = [[*half_edge, topology.next(across)], [topology.next(*half_edge), across]];
        ends.iter().all(|ends| {
            let [a, b] = ends.map(|corner| split[corner as usize]);
            let [c, d] = ends.map(|corner| smooth[corner as usize]);
            c == d && Degrees::from(angle_between(a, b)).0 > degrees
        })
    };
    (0..mesh.faces().corner_count() as u32).filter(is_split).collect()
}

/// A clean mesh cut so that the vertices of the two sides nearly meet, with normals computed for each side alone.
pub(super) fn cracked(clean: &Clean) -> Option<Planted> {
    let mesh = with_normals(cut(&clean.mesh, CUTS[1], 1e-9), &clean.recipe);
    // The uncut mesh, also without smoothing groups and other columns of its file.
    let whole = rebuilt(clean.mesh.positions().to_vec(), clean.mesh.faces().clone());
    let whole = with_normals(whole, &clean.recipe);
    let places = split_by(&clean.mesh, &unshared(&whole), &unshared(&mesh), 2.0);
    let what = "cut, with a gap of 1e-9 of the diagonal";
    // A cut along flat sides changes no normals.
    (places.len() > 2).then(|| Planted::new(what, Kind::CrackedSeam, mesh, places))
}

/// Meshes without creases, coarse and fine, with our own normals.
fn smooth() -> Vec<(String, Mesh)> {
    let sphere = Surface::from(Sphere::default());
    let mut all: Vec<(String, Mesh)> = Vec::new();
    for level in 1..=4 {
        let ball = Tessellation { pattern: Pattern::Icosphere(level), ..Tessellation::default() };
        all.push((format!("icosphere {level}"), sphere.tessellate(&ball).unwrap()));
    }
    for segments in [[24, 12], [32, 16], [64, 32]] {
        all.push((format!("torus {segments:?}"), surface(&Surface::from(Torus::default()), segments)));
    }
    all.push(("teapot".to_owned(), surface(&Surface::Teapot, [8, 8])));
    all.extend(meshes().into_iter().filter(|it| it.name == "bowl").map(|it| ("bowl".to_owned(), it.mesh)));
    let bunny = crate::meshes::path("obj/stanford_bunny.obj").filter(|_| !cfg!(debug_assertions));
    let read = |path: &std::path::Path| crease::io::read(path, None, &ReadOptions::default()).unwrap();
    all.extend(bunny.map(|path| ("bunny".to_owned(), read(&path).parts.remove(0).mesh)));
    let made = |(name, mesh): (String, Mesh)| {
        (name, with_normals(mesh.with_normals(None), &recipe(Weight::Angle, 60.0)))
    };
    all.into_iter().map(made).collect()
}

/// The first corners of the edges that a finding names.
fn reported(mesh: &Mesh, found: Option<&crease::quality::Finding>) -> BTreeSet<u32> {
    let corner = |face: u32, corner: u32| mesh.faces().range(face as usize).start as u32 + corner;
    let places = found.iter().flat_map(|it| &it.places);
    places.map(|at| corner(at.face.unwrap(), at.corner.unwrap())).collect()
}

const CUTS: [DVec3; 2] = [DVec3::X, DVec3::new(1.0, 2.0, 3.0)];

/// Normals averaged on each side of a cut alone: the sides differ by 5° on fine meshes and by 30° on coarse ones. If more than
/// one edge in fifty is cut, no crease angle fits, and the cut is recognised because dihedral angles there are as elsewhere.
#[test]
fn cuts_through_smooth_meshes_are_reported() {
    let mut misses = Vec::new();
    for (name, mesh) in smooth() {
        let smooth = unshared(&mesh);
        for across in CUTS {
            let apart = with_normals(cut(&mesh, across, 1e-9), &recipe(Weight::Angle, 60.0));
            let split = unshared(&apart);
            let [all, sure] = [2.0, 4.0].map(|degrees| split_by(&mesh, &smooth, &split, degrees));
            let diagnosis = inspect(&per_corner(&mesh, split), 1 << 16);
            let found = diagnosis.get(Kind::SplitSeam);
            let places = reported(&mesh, found);
            let hits = |of: &BTreeSet<u32>| places.intersection(of).count() as f64;
            let recall = hits(&sure) / sure.len() as f64;
            let precision = hits(&all) / places.len().max(1) as f64;
            let severity = found.map(|it| it.severity);
            let others = grave(&diagnosis);
            if severity != Some(Severity::Warning) || recall < 0.99 || precision < 0.99 || others.len() > 1 {
                let of = (sure.len(), all.len());
                misses.push(format!(
                    "{name} across {across}, {of:?}: {severity:?}, {recall:.3}, {precision:.3}, {others:?}"
                ));
            }
        }
    }
    assert!(misses.is_empty(), "{} misses:\n{}", misses.len(), misses.join("\n"));
}

/// The same where the vertices of the two sides only nearly meet, so that welding equal positions does not join them.
#[test]
fn edges_that_nearly_meet_are_reported() {
    let mut misses = Vec::new();
    for (name, mesh) in smooth() {
        let smooth = unshared(&mesh);
        for (across, apart, is_near) in
            [(CUTS[0], 1e-12, true), (CUTS[1], 1e-9, true), (CUTS[0], 9e-7, true), (CUTS[0], 3e-6, false)]
        {
            let bare = cut(&mesh, across, apart);
            let cracked = with_normals(bare.clone(), &recipe(Weight::Angle, 60.0));
            let split = unshared(&cracked);
            let [all, sure] = [2.0, 4.0].map(|degrees| split_by(&mesh, &smooth, &split, degrees));
            let diagnosis = inspect(&cracked, 1 << 16);
            let found = diagnosis.get(Kind::CrackedSeam);
            let places = reported(&cracked, found);
            let hits = |of: &BTreeSet<u32>| places.intersection(of).count();
            let is_right = hits(&sure) == sure.len() && hits(&all) == places.len();
            let severity = found.map(|it| it.severity);
            let others = grave(&diagnosis).len();
            // Without normals, a note reports all edges of the cut that computed normals would smooth.
            let of_bare = inspect(&bare, 1);
            let noted =
                of_bare.get(Kind::CrackedSeam).map(|it| (it.severity, it.count as usize >= all.len()));
            let expected = if is_near {
                (is_right, Some(Severity::Warning), 1, Some((Severity::Note, true)))
            } else {
                (places.is_empty(), None, 0, None)
            };
            if (is_right || !is_near, severity, others, noted) != expected {
                misses.push(format!(
                    "{name} cut by {apart}: {is_right}, {severity:?}, {:?}, {noted:?}",
                    grave(&diagnosis)
                ));
            }
        }
        assert!(inspect(&mesh, 1).get(Kind::CrackedSeam).is_none(), "{name}");
    }
    assert!(misses.is_empty(), "{} misses:\n{}", misses.len(), misses.join("\n"));
}
