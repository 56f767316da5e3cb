//! One fault of each kind, planted at known positions: all of it is found, nothing else, and with the right cause.

use super::clean::Clean;
use super::whole_meshes::{self, by_chance, turned_any_way};
use super::{loaded, rebuilt, with_normals};
use crate::random::Random;
use crease::io::{FileNode, ReadOptions, read_bytes};
use crease::mesh::{Column, FaceEdit, Mesh, MeshBuilder, SmoothingGroups, Topology, Weld, normal_matrix};
use crease::normals::compute;
use crease::num::{Degrees, angle_between};
use crease::quality::catalogue::Kind;
use crease::quality::{Diagnosis, Finding, Thresholds, diagnose};
use glam::{DMat3, DMat4, DQuat, DVec3};
use std::collections::BTreeSet;

/// A mesh with a fault, and the faulty corners or faces.
pub(super) struct Planted {
    /// The name of the change.
    pub(super) what: &'static str,
    pub(super) mesh: Mesh,
    /// The file of the mesh, if the fault is not in the mesh itself.
    pub(super) file: Option<Vec<u8>>,
    /// The matrix of the mesh's node, if it is not the identity.
    pub(super) node: Option<DMat4>,
    pub(super) expected: Kind,
    /// The faulty corners or faces; empty for a fault of the mesh as a whole.
    pub(super) places: BTreeSet<u32>,
    pub(super) by_face: bool,
}

impl Planted {
    pub(super) fn new(what: &'static str, expected: Kind, mesh: Mesh, places: BTreeSet<u32>) -> Self {
        Self { what, mesh, file: None, node: None, expected, places, by_face: false }
    }

    pub(super) fn by_face(self) -> Self {
        Self { by_face: true, ..self }
    }

    /// The diagnosis, with all places of each finding.
    pub(super) fn diagnosis(&self) -> Diagnosis {
        let mut file = match &self.file {
            Some(bytes) => read_bytes(bytes.clone(), None, None, &ReadOptions::default()).unwrap(),
            None => loaded(self.mesh.clone()),
        };
        file.nodes.extend(self.node.map(|world_from_part| FileNode {
            number: 0,
            name: "node".into(),
            part: 0,
            world_from_part,
        }));
        diagnose(&file, &Thresholds { places: 1 << 16, ..Thresholds::default() }, &|_| {})
    }
}

/// The first corner of every 37th face, which is one corner in 111 of a triangle mesh.
fn chosen_corners(mesh: &Mesh) -> BTreeSet<u32> {
    let starts = mesh.faces().ranges().map(|range| range.start as u32);
    starts.step_by(37).collect()
}

/// The stored normals with one value a corner.
pub(super) fn unshared(mesh: &Mesh) -> Vec<DVec3> {
    let stored = mesh.columns().normals.as_ref().expect("a clean mesh has normals");
    let corners = mesh.faces().corners();
    (0..corners.len()).map(|corner| *stored.get(corner, corners[corner]).unwrap()).collect()
}

pub(super) fn per_corner(mesh: &Mesh, normals: Vec<DVec3>) -> Mesh {
    let index = (0..normals.len() as u32).collect();
    mesh.clone().with_normals(Some(Column::per_corner(normals, index)))
}

/// Changes the normals of single corners.
pub(super) fn at_corners(
    clean: &Clean,
    what: &'static str,
    expected: Kind,
    change: impl Fn(DVec3) -> DVec3,
) -> Planted {
    let places = chosen_corners(&clean.mesh);
    let mut normals = unshared(&clean.mesh);
    places.iter().for_each(|&corner| normals[corner as usize] = change(normals[corner as usize]));
    Planted::new(what, expected, per_corner(&clean.mesh, normals), places)
}

/// Changes all normals.
pub(super) fn everywhere(
    clean: &Clean,
    what: &'static str,
    expected: Kind,
    change: impl Fn(DVec3) -> DVec3,
) -> Planted {
    let normals = unshared(&clean.mesh).into_iter().map(change).collect();
    Planted::new(what, expected, per_corner(&clean.mesh, normals), BTreeSet::new())
}

/// A direction at an angle from another.
pub(super) fn turned(normal: DVec3, degrees: f64) -> DVec3 {
    let aside = normal.any_orthonormal_vector();
    let angle = degrees.to_radians();
    normal * libm::cos(angle) + aside * libm::sin(angle)
}

/// Some faces reversed, with their stored normals unchanged.
fn reversed_faces(clean: &Clean) -> Planted {
    let places: BTreeSet<u32> = (0..clean.mesh.face_count() as u32).step_by(53).collect();
    let edit = FaceEdit { reversed: places.iter().copied().collect(), ..FaceEdit::default() };
    let mesh = clean.mesh.with_faces(&edit);
    Planted::new("1 face in 53 reversed", Kind::InconsistentWinding, mesh, places).by_face()
}

/// All faces reversed, with their stored normals unchanged.
fn inside_out(clean: &Clean) -> Planted {
    let places: BTreeSet<u32> = (0..clean.mesh.face_count() as u32).collect();
    let edit = FaceEdit { reversed: places.iter().copied().collect(), ..FaceEdit::default() };
    let expected = if clean.is_closed { Kind::InsideOut } else { Kind::OpenInsideOut };
    Planted::new("all faces reversed", expected, clean.mesh.with_faces(&edit), places).by_face()
}

/// Some sharp edges averaged: both sides get the mean of their normals.
pub(super) fn averaged_crease(mesh: &Mesh) -> Option<Planted> {
    let topology = Topology::build(mesh, Weld::Exact);
    let mut normals = unshared(mesh);
    let before = normals.clone();
    let corners = mesh.faces().corners();
    let mut places = BTreeSet::new();
    // By position: across a seam, the same point of the shape is another vertex.
    let mut touched: BTreeSet<[u64; 3]> = BTreeSet::new();
    let place = |corner: u32| mesh.positions().at(corners[corner as usize]).to_array().map(f64::to_bits);
    // Above the crease angle of the meshes, 40°.
    let far = |a: DVec3, b: DVec3| angle_between(a, b).0 > 0.7;
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
    // Only a mesh with enough creases shows that some of them should be sharp.
    let mesh = per_corner(mesh, normals);
    (places.len() >= 3).then(|| Planted::new("sharp edges averaged", Kind::AveragedCrease, mesh, places))
}

/// Some smooth edges with the normals of one side tilted.
pub(super) fn split_seam(clean: &Clean, degrees: f64) -> Option<Planted> {
    let topology = Topology::build(&clean.mesh, Weld::Exact);
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
        // The corners of the edge on one side.
        for [a, _] in ends {
            normals[a as usize] = turned(before[a as usize], degrees);
        }
        places.insert(half_edge);
    }
    let mesh = per_corner(&clean.mesh, normals);
    (!places.is_empty()).then(|| Planted::new("smooth edges split by 10°", Kind::SplitSeam, mesh, places))
}

/// Some faces doubled.
fn doubled_faces(clean: &Clean) -> Planted {
    let mut faces = crease::mesh::Faces::new();
    clean.mesh.faces().iter().for_each(|face| faces.push(face));
    let count = clean.mesh.face_count();
    for face in (0..count).step_by(61) {
        faces.push(clean.mesh.faces().face(face));
    }
    let places = (count as u32..faces.len() as u32).collect();
    let mesh = rebuilt(clean.mesh.positions().to_vec(), faces);
    let mesh = with_normals(mesh, &clean.recipe);
    Planted::new("1 face in 61 doubled", Kind::DuplicateFaces, mesh, places).by_face()
}

/// Smoothing groups divided by a plane through the mesh, which its normals do not follow.
fn other_groups(clean: &Clean) -> Planted {
    let faces = clean.mesh.faces();
    let middle = |face: usize| -> f64 {
        faces.face(face).iter().map(|&v| clean.mesh.positions().at(v).x).sum::<f64>()
    };
    let of_face: Vec<u32> = (0..faces.len()).map(|face| if middle(face) > 0.0 { 1 } else { 2 }).collect();
    let topology = Topology::build(&clean.mesh, Weld::Exact);
    let normals = unshared(&clean.mesh);
    let face_normals = compute(&clean.mesh, &clean.recipe).face_normals;
    let places = (0..faces.corner_count() as u32)
        .filter(|&half_edge| {
            let Some(across) = topology.across(half_edge).filter(|&across| half_edge < across) else {
                return false;
            };
            let [a, b] = [half_edge, across].map(|corner| topology.face_of(corner) as usize);
            let ends = [[half_edge, topology.next(across)], [topology.next(half_edge), across]];
            let is_shared = ends.iter().all(|&[a, b]| normals[a as usize] == normals[b as usize]);
            let is_split = ends.iter().all(|&[a, b]| {
                Degrees::from(angle_between(normals[a as usize], normals[b as usize])).0 > 2.0
            });
            let is_bent = Degrees::from(angle_between(face_normals[a], face_normals[b])).0 > 1.0;
            let is_one_group = of_face[a] == of_face[b];
            (is_one_group && is_split) || (!is_one_group && is_shared && is_bent)
        })
        .collect();
    let mut columns = clean.mesh.columns().clone();
    columns.smoothing = Some(SmoothingGroups { of_face, before_first: 0 });
    let (positions, faces) = (clean.mesh.positions().to_vec(), faces.clone());
    let mesh = MeshBuilder { positions: positions.into(), faces, columns }.build().unwrap();
    Planted::new("smoothing groups cut by a plane", Kind::GroupMismatch, mesh, places)
}

/// Normals stored in world space below a node that rotates and stretches the mesh.
fn in_world_space(clean: &Clean) -> Planted {
    let node = DMat4::from_scale_rotation_translation(
        DVec3::new(1.0, 2.5, 1.0),
        DQuat::from_axis_angle(DVec3::new(1.0, 2.0, 3.0).normalize(), 0.7),
        DVec3::new(5.0, 0.0, -2.0),
    );
    let matrix = normal_matrix(DMat3::from_mat4(node)).unwrap();
    let what = "all stored in world space";
    let planted = everywhere(clean, what, Kind::Untransformed, |normal| matrix.apply(normal).unwrap());
    Planted { node: Some(node), ..planted }
}

/// Recall and precision: the share of planted places that was found, and the share of found places that was planted.
pub(super) fn recall_and_precision(planted: &Planted, finding: &Finding) -> (f64, f64) {
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

/// All faults that are planted into a clean mesh.
pub(super) fn faults(clean: &Clean) -> Vec<Planted> {
    let swap = |n: DVec3| DVec3::new(n.x, n.z, n.y);
    let mirror = |n: DVec3| DVec3::new(-n.x, n.y, n.z);
    let rotation = DMat3::from_axis_angle(DVec3::new(1.0, 2.0, 3.0).normalize(), 30f64.to_radians());
    let mut all = vec![
        at_corners(clean, "1 corner in 111 negated", Kind::Flipped, |n| -n),
        at_corners(clean, "1 corner in 111 not a number", Kind::NotFinite, |_| DVec3::NAN),
        at_corners(clean, "1 corner in 111 zero", Kind::ZeroNormals, |_| DVec3::ZERO),
        at_corners(clean, "1 corner in 111 2 % too long", Kind::NotUnit, |n| n * 1.02),
        at_corners(clean, "1 corner in 111 0.3 % too long", Kind::LooseLength, |n| n * 1.003),
        at_corners(clean, "1 corner in 111 tilted by 30°", Kind::Outlier, |n| turned(n, 30.0)),
        at_corners(clean, "1 corner in 111 tilted by 118°", Kind::AgainstFace, |n| turned(n, 118.0)),
        everywhere(clean, "all negated", Kind::Inverted, |n| -n),
        everywhere(clean, "y and z exchanged", Kind::SwappedAxes, swap),
        everywhere(clean, "x mirrored", Kind::SwappedAxes, mirror),
        everywhere(clean, "all rotated by 30°", Kind::Rotated, |n| rotation * n),
        everywhere(clean, "all equal", Kind::Constant, |_| DVec3::Y),
        in_world_space(clean),
        reversed_faces(clean),
        doubled_faces(clean),
        other_groups(clean),
    ];
    if clean.has_outside {
        all.push(inside_out(clean));
    }
    all.extend(averaged_crease(&clean.mesh));
    all.extend(split_seam(clean, 10.0));
    all.extend(super::seams::cracked(clean));
    let neg = |n: DVec3, _: &mut Random| -n;
    let tilt = |n, random: &mut Random| turned_any_way(n, 30.0, random);
    all.push(by_chance(clean, ("1 % of corners negated, by chance", Kind::Flipped, 0.01), neg));
    all.push(by_chance(clean, ("10 % of corners tilted by 30°, by chance", Kind::Outlier, 0.1), tilt));
    all.extend(whole_meshes::faults(clean));
    // A room with all normals inverted or all faces reversed is a solid with one of the two reversed.
    all.retain(|it| !clean.is_room || ![Kind::Inverted, Kind::InsideOut].contains(&it.expected));
    // Mirroring the normals of a box inverts those of two sides.
    all.retain(|it| clean.name != "box room" || it.what != "x mirrored");
    all
}
