//! One fault of each kind, planted at known places: is it found, all of it and nothing else, and is its cause named?

use super::clean::{Clean, meshes};
use super::{inspect, rebuilt, with_normals};
use crease::mesh::{Column, ColumnIndex, FaceEdit, Mesh};
use crease::normals::{NormalRecipe, compute};
use crease::num::{Degrees, angle_between};
use crease::quality::Finding;
use crease::quality::catalogue::Kind;
use glam::{DMat3, DVec3};
use std::collections::BTreeSet;

/// A mesh with a fault, and where it is, as corners of the mesh, or as faces.
pub(super) struct Planted {
    pub(super) mesh: Mesh,
    pub(super) expected: Kind,
    /// What is wrong; empty for a fault of the mesh as a whole.
    places: BTreeSet<u32>,
    by_face: bool,
}

/// Corners, a hundredth of all, spread so that no two are of neighbouring faces' same vertex: one corner of every
/// hundredth face.
fn chosen_corners(mesh: &Mesh) -> BTreeSet<u32> {
    let starts = mesh.faces().ranges().map(|range| range.start as u32);
    starts.step_by(37).collect()
}

/// The stored normals with one value a corner.
fn unshared(mesh: &Mesh) -> Vec<DVec3> {
    let stored = mesh.columns().normals.as_ref().expect("a clean mesh has normals");
    let corners = mesh.faces().corners();
    (0..corners.len()).map(|corner| *stored.get(corner, corners[corner]).unwrap()).collect()
}

fn per_corner(mesh: &Mesh, normals: Vec<DVec3>) -> Mesh {
    let index = (0..normals.len() as u32).collect();
    mesh.clone().with_normals(Some(Column::per_corner(normals, index)))
}

/// Changes the normals of single corners.
fn at_corners(clean: &Clean, expected: Kind, change: impl Fn(DVec3) -> DVec3) -> Planted {
    let places = chosen_corners(&clean.mesh);
    let mut normals = unshared(&clean.mesh);
    places.iter().for_each(|&corner| normals[corner as usize] = change(normals[corner as usize]));
    Planted { mesh: per_corner(&clean.mesh, normals), expected, places, by_face: false }
}

/// Changes all normals.
fn everywhere(clean: &Clean, expected: Kind, change: impl Fn(DVec3) -> DVec3) -> Planted {
    let normals = unshared(&clean.mesh).into_iter().map(change).collect();
    Planted { mesh: per_corner(&clean.mesh, normals), expected, places: BTreeSet::new(), by_face: false }
}

/// A direction at an angle from another.
fn turned(normal: DVec3, degrees: f64) -> DVec3 {
    let aside = normal.any_orthonormal_vector();
    let angle = degrees.to_radians();
    normal * libm::cos(angle) + aside * libm::sin(angle)
}

fn quantised(normal: DVec3) -> DVec3 {
    (normal * 127.0).round() / 127.0
}

/// Faces turned round, their stored normals left as they are.
fn reversed_faces(clean: &Clean) -> Planted {
    let places: BTreeSet<u32> = (0..clean.mesh.face_count() as u32).step_by(53).collect();
    let edit = FaceEdit { reversed: places.iter().copied().collect(), ..FaceEdit::default() };
    Planted { mesh: clean.mesh.with_faces(&edit), expected: Kind::InconsistentWinding, places, by_face: true }
}

/// All faces turned round, their stored normals left as they are.
fn inside_out(clean: &Clean) -> Planted {
    let places: BTreeSet<u32> = (0..clean.mesh.face_count() as u32).collect();
    let edit = FaceEdit { reversed: places.iter().copied().collect(), ..FaceEdit::default() };
    Planted { mesh: clean.mesh.with_faces(&edit), expected: Kind::InsideOut, places, by_face: true }
}

/// Every tenth sharp edge averaged: both sides get the normal in the middle.
fn averaged_crease(clean: &Clean) -> Option<Planted> {
    let topology = crease::mesh::Topology::build(&clean.mesh, crease::mesh::Weld::Exact);
    let mut normals = unshared(&clean.mesh);
    let before = normals.clone();
    let corners = clean.mesh.faces().corners();
    let mut places = BTreeSet::new();
    // By place: beyond a seam the same corner of the shape is another vertex.
    let mut touched: BTreeSet<[u64; 3]> = BTreeSet::new();
    let place =
        |corner: u32| clean.mesh.positions()[corners[corner as usize] as usize].to_array().map(f64::to_bits);
    let far = |a: DVec3, b: DVec3| angle_between(a, b).0 > 0.8;
    for half_edge in 0..corners.len() as u32 {
        let Some(across) = topology.across(half_edge).filter(|&across| half_edge < across) else { continue };
        let ends = [[half_edge, topology.next(across)], [topology.next(half_edge), across]];
        let places_of_ends = ends.map(|[corner, _]| place(corner));
        let is_sharp = ends.iter().all(|&[a, b]| far(before[a as usize], before[b as usize]));
        if !is_sharp || places_of_ends.iter().any(|place| touched.contains(place)) || half_edge % 5 != 0 {
            continue;
        }
        touched.extend(places_of_ends);
        for pair in ends {
            let mean = (before[pair[0] as usize] + before[pair[1] as usize]).normalize();
            pair.iter().for_each(|&corner| normals[corner as usize] = mean);
        }
        places.insert(half_edge);
    }
    // A crease can be told from the rule only where the rule is known from others.
    (places.len() >= 3).then(|| Planted {
        mesh: per_corner(&clean.mesh, normals),
        expected: Kind::AveragedCrease,
        places,
        by_face: false,
    })
}

/// A smooth edge here and there whose one side is turned away from the other.
fn split_seam(clean: &Clean, degrees: f64) -> Option<Planted> {
    let topology = crease::mesh::Topology::build(&clean.mesh, crease::mesh::Weld::Exact);
    let corners = clean.mesh.faces().corners();
    let mut normals = unshared(&clean.mesh);
    let before = normals.clone();
    let (mut places, mut touched) = (BTreeSet::new(), BTreeSet::new());
    for half_edge in (0..corners.len() as u32).step_by(41) {
        let Some(across) = topology.across(half_edge).filter(|&across| half_edge < across) else { continue };
        let ends = [[half_edge, topology.next(across)], [topology.next(half_edge), across]];
        let faces = [half_edge, across].map(|corner| topology.face_of(corner));
        let is_smooth = ends.iter().all(|&[a, b]| before[a as usize] == before[b as usize]);
        let vertices = ends.map(|[corner, _]| corners[corner as usize]);
        if !is_smooth || vertices.iter().any(|vertex| touched.contains(vertex)) || faces[0] == faces[1] {
            continue;
        }
        touched.extend(vertices);
        // All corners at the two ends that lie on one side, up to the next edges: the face's own two corners.
        for [a, _] in ends {
            normals[a as usize] = turned(before[a as usize], degrees);
        }
        places.insert(half_edge);
    }
    (!places.is_empty()).then(|| Planted {
        mesh: per_corner(&clean.mesh, normals),
        expected: Kind::SplitSeam,
        places,
        by_face: false,
    })
}

/// Faces that stand twice.
fn doubled_faces(clean: &Clean) -> Planted {
    let mut faces = crease::mesh::Faces::new();
    clean.mesh.faces().iter().for_each(|face| faces.push(face));
    let count = clean.mesh.face_count();
    for face in (0..count).step_by(61) {
        faces.push(clean.mesh.faces().face(face));
    }
    let places = (count as u32..faces.len() as u32).collect();
    let mesh = rebuilt(clean.mesh.positions().to_vec(), faces);
    Planted { mesh: with_normals(mesh, &clean.recipe), expected: Kind::DuplicateFaces, places, by_face: true }
}

/// How much of what was planted was found, and how much of what was found was planted.
fn recall_and_precision(planted: &Planted, finding: &Finding) -> (f64, f64) {
    if planted.places.is_empty() {
        return (1.0, 1.0);
    }
    let start = |face: u32| planted.mesh.faces().range(face as usize).start as u32;
    let found: BTreeSet<u32> = finding
        .places
        .iter()
        .map(|site| match (planted.by_face, site.face, site.corner) {
            (true, Some(face), _) => face,
            (false, Some(face), Some(corner)) => start(face) + corner,
            _ => u32::MAX,
        })
        .collect();
    let hits = found.intersection(&planted.places).count() as f64;
    (hits / planted.places.len() as f64, hits / found.len().max(1) as f64)
}

/// Every fault that can be told from the shape of a clean mesh.
pub(super) fn faults(clean: &Clean) -> Vec<Planted> {
    let swap = |n: DVec3| DVec3::new(n.x, n.z, n.y);
    let mirror = |n: DVec3| DVec3::new(-n.x, n.y, n.z);
    let rotation = DMat3::from_axis_angle(DVec3::new(1.0, 2.0, 3.0).normalize(), 30f64.to_radians());
    let mut all = vec![
        at_corners(clean, Kind::Flipped, |n| -n),
        at_corners(clean, Kind::NotFinite, |_| DVec3::NAN),
        at_corners(clean, Kind::ZeroNormals, |_| DVec3::ZERO),
        at_corners(clean, Kind::NotUnit, |n| n * 1.02),
        at_corners(clean, Kind::LooseLength, |n| n * 1.003),
        at_corners(clean, Kind::Stray, |n| turned(n, 30.0)),
        at_corners(clean, Kind::AgainstFace, |n| turned(n, 118.0)),
        everywhere(clean, Kind::Inverted, |n| -n),
        everywhere(clean, Kind::SwappedAxes, swap),
        everywhere(clean, Kind::SwappedAxes, mirror),
        everywhere(clean, Kind::Rotated, |n| rotation * n),
        everywhere(clean, Kind::Constant, |_| DVec3::Y),
        reversed_faces(clean),
        doubled_faces(clean),
    ];
    if clean.is_round {
        all.push(everywhere(clean, Kind::Quantised, quantised));
    }
    if clean.is_closed {
        all.push(inside_out(clean));
    }
    all.extend(averaged_crease(clean));
    all.extend(split_seam(clean, 10.0));
    all
}

#[test]
fn planted_faults_are_found_where_they_are_and_named() {
    let mut misses = Vec::new();
    for clean in meshes() {
        for planted in faults(&clean) {
            let diagnosis = inspect(&planted.mesh, 1 << 16);
            let name = format!("{}: {}", clean.name, planted.expected.id());
            let Some(finding) = diagnosis.get(planted.expected) else {
                let found: Vec<&str> = diagnosis.findings.iter().map(|it| it.kind.id()).collect();
                misses.push(format!("{name} is not found, but {found:?}"));
                continue;
            };
            let (recall, precision) = recall_and_precision(&planted, finding);
            if recall < 0.99 || precision < 0.99 {
                misses.push(format!("{name}: recall {recall:.3}, precision {precision:.3}"));
            }
            let others: Vec<&str> =
                super::grave(&diagnosis).into_iter().filter(|id| *id != planted.expected.id()).collect();
            if !others.is_empty() {
                let all: Vec<_> = diagnosis
                    .findings
                    .iter()
                    .filter(|it| others.contains(&it.kind.id()))
                    .map(|it| (it.kind.id(), it.count, it.places.first().cloned()))
                    .collect();
                misses.push(format!("{name} ({} places) comes with {all:?}", planted.places.len()));
            }
        }
    }
    assert!(misses.is_empty(), "{} misses:\n{}", misses.len(), misses.join("\n"));
}

/// Below the threshold a fault may pass; above, by so much that rounding of the reference does not matter, it may not.
#[test]
fn strays_are_found_from_the_threshold_on() {
    let clean = &meshes()[0];
    let recalled = |degrees: f64| {
        let planted = at_corners(clean, Kind::Stray, |n| turned(n, degrees));
        let diagnosis = inspect(&planted.mesh, 1 << 16);
        diagnosis.get(Kind::Stray).map_or(0.0, |finding| recall_and_precision(&planted, finding).0)
    };
    assert_eq!([5.0, 14.0, 16.0, 30.0].map(recalled), [0.0, 0.0, 1.0, 1.0]);
}

/// The weighting and the crease angle that normals were made with are told from the normals.
#[test]
fn the_recipe_is_estimated() {
    use crease::normals::Weight;
    for clean in meshes().into_iter().filter(|clean| clean.is_uneven) {
        for weight in
            [Weight::Uniform, Weight::Area, Weight::Angle, Weight::AngleArea, Weight::Max, Weight::Edge]
        {
            let recipe = NormalRecipe { weight, ..clean.recipe };
            let mesh = with_normals(clean.mesh.clone().with_normals(None), &recipe);
            let estimate = inspect(&mesh, 1).parts[0].estimate.unwrap();
            assert_eq!(estimate.weight, weight, "{}", clean.name);
            assert!(
                estimate.reproduced > 0.999 && estimate.median < Degrees(1e-5),
                "{}: {estimate:?}",
                clean.name
            );
            let again = compute(&mesh, &estimate.recipe()).normals;
            let ColumnIndex::PerCorner(index) = &again.index else { panic!("per corner") };
            assert_eq!(index.len(), mesh.faces().corner_count());
            assert_eq!(
                Some(again),
                mesh.columns().normals,
                "{}: the estimate gives the same bits",
                clean.name
            );
        }
    }
}
