//! Each cause is reported once, without its consequences, and its severity grows with its size.

use super::clean::meshes;
use super::planted::{averaged_crease, everywhere, per_corner, turned, unshared};
use super::{inspect, loaded};
use crate::meshes::path;
use crease::io::{FileNode, ReadOptions, read};
use crease::mesh::{Column, Columns, Faces, Mesh, MeshBuilder, Topology, Weld, normal_matrix};
use crease::num::{Degrees, angle_between};
use crease::quality::catalogue::{Family, Kind};
use crease::quality::{Diagnosis, Severity, Thresholds, diagnose};
use glam::{DMat3, DMat4, DVec3};
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// Findings on stored normals and smoothing that the clean mesh does not have; without those on smoothing groups, which the
/// planted faults contradict as well.
fn reported_of_normals(diagnosis: &Diagnosis, clean: &Diagnosis) -> Vec<&'static str> {
    let is_of_normals = |kind: Kind| [Family::Stored, Family::Smoothing].contains(&kind.entry().family);
    let reported = diagnosis.findings.iter().map(|finding| finding.kind);
    let reported = reported.filter(|&kind| is_of_normals(kind) && kind != Kind::GroupMismatch);
    reported.filter(|&kind| clean.get(kind).is_none()).map(Kind::id).collect()
}

/// The normals of one half of a mesh are rotated: the seam between the halves is reported at a few degrees and at many.
#[test]
fn severity_does_not_fall_as_half_of_the_normals_turn_further() {
    for clean in meshes().into_iter().filter(|it| ["icosphere", "torus", "wave"].contains(&it.name)) {
        let positions = clean.mesh.positions();
        let is_turned = |corner: usize| {
            let face = clean.mesh.faces().ranges().position(|range| range.contains(&corner)).unwrap();
            clean.mesh.faces().face(face).iter().map(|&vertex| positions.at(vertex).x).sum::<f64>() > 0.0
        };
        let normals = unshared(&clean.mesh);
        let half: Vec<bool> = (0..normals.len()).map(is_turned).collect();
        let axis = DVec3::new(1.0, 2.0, 3.0).normalize();
        let each: fn(DVec3, f64, DVec3) -> DVec3 = |normal, degrees, _| turned(normal, degrees);
        let together: fn(DVec3, f64, DVec3) -> DVec3 =
            |normal, degrees, axis| DMat3::from_axis_angle(axis, degrees.to_radians()) * normal;
        for turn in [each, together] {
            let worst = |degrees: u32| {
                let changed = normals.iter().zip(&half).map(|(&normal, &is_turned)| {
                    if is_turned { turn(normal, f64::from(degrees), axis) } else { normal }
                });
                let diagnosis = inspect(&per_corner(&clean.mesh, changed.collect()), 1);
                let reported =
                    diagnosis.findings.iter().filter(|it| it.kind.entry().family != Family::Shading);
                reported.map(|it| it.severity).max()
            };
            let all: Vec<_> = (1..=90).into_par_iter().map(worst).collect();
            assert!(all.is_sorted(), "{}: {all:?}", clean.name);
            let are_told = all[3..].iter().all(|severity| *severity >= Some(Severity::Warning));
            assert!(are_told, "{}: {all:?}", clean.name);
        }
    }
}

/// A mesh with all normals at the ends of sharp edges replaced by their mean at each position, if x is beyond a share of the
/// bounds; and the number of these edges.
fn averaged_beyond(mesh: &Mesh, share: f64) -> (Mesh, usize) {
    let topology = Topology::build(mesh, Weld::Exact);
    let (mut normals, corners) = (unshared(mesh), mesh.faces().corners());
    let (low, high) = mesh.bounds().unwrap();
    let at = |corner: u32| mesh.positions().at(corners[corner as usize]);
    let key = |corner: u32| at(corner).to_array().map(|x| (x + 0.0).to_bits());
    let is_beyond = |corner: u32| at(corner).x > low.x + share * (high.x - low.x);
    let mut edges = 0;
    let mut at_place: BTreeSet<[u64; 3]> = BTreeSet::new();
    for half_edge in 0..corners.len() as u32 {
        let Some(across) = topology.across(half_edge).filter(|&across| half_edge < across) else { continue };
        let ends = [[half_edge, topology.next(across)], [topology.next(half_edge), across]];
        let is_sharp =
            ends.iter().all(|&[a, b]| angle_between(normals[a as usize], normals[b as usize]).0 > 1.0);
        if is_sharp && ends.iter().all(|&[corner, _]| is_beyond(corner)) {
            at_place.extend(ends.map(|[corner, _]| key(corner)));
            edges += 1;
        }
    }
    let mut sums: BTreeMap<[u64; 3], DVec3> = BTreeMap::new();
    for corner in (0..corners.len() as u32).filter(|&corner| at_place.contains(&key(corner))) {
        *sums.entry(key(corner)).or_default() += normals[corner as usize];
    }
    for corner in 0..corners.len() as u32 {
        if let Some(sum) = sums.get(&key(corner)).and_then(|sum| sum.try_normalize()) {
            normals[corner as usize] = sum;
        }
    }
    (per_corner(mesh, normals), edges)
}

/// Averaged edges are reported as such, and not also as normals that match no weighting.
#[test]
fn averaged_creases_of_parts_are_reported_once() {
    let mut misses = Vec::new();
    for name in ["ref/fandisk_vtk_split30.ply", "ref/wingnut_vtk_split45.ply", "obj/cylinder_ngon.obj"] {
        let Some(path) = path(name) else { continue };
        let mesh = read(&path, None, &ReadOptions::default()).unwrap().parts.remove(0).mesh;
        let clean = inspect(&mesh, 1);
        if let Some(planted) = averaged_crease(&mesh) {
            let reported = reported_of_normals(&planted.diagnosis(), &clean);
            if reported != [Kind::AveragedCrease.id()] {
                misses.push(format!("{name}, here and there: {reported:?}"));
            }
        }
        // Not below 0.7: if most sharp edges were averaged, averaging would fit best.
        for share in [0.95, 0.9, 0.8, 0.7] {
            let (averaged, edges) = averaged_beyond(&mesh, share);
            let reported = reported_of_normals(&inspect(&averaged, 1), &clean);
            if edges > 0 && reported != [Kind::AveragedCrease.id()] {
                misses.push(format!("{name}, {edges} edges beyond {share}: {reported:?}"));
            }
        }
    }
    assert!(misses.is_empty(), "{}", misses.join("\n"));
}

/// The same mesh with a vertex for each corner.
fn with_own_vertices(mesh: &Mesh) -> Mesh {
    let positions = mesh.faces().corners().iter().map(|&vertex| mesh.positions().at(vertex)).collect();
    let mut faces = Faces::new();
    mesh.faces()
        .ranges()
        .for_each(|range| faces.push(&range.map(|corner| corner as u32).collect::<Vec<_>>()));
    let columns = Columns {
        normals: Some(Column::per_vertex(unshared(mesh))),
        smoothing: mesh.columns().smoothing.clone(),
        ..Columns::default()
    };
    MeshBuilder { positions, faces, columns }.build().unwrap()
}

/// Which corners an averaged edge explains does not depend on how corners share vertices.
#[test]
fn averaged_creases_explain_as_much_where_no_vertex_is_shared() {
    for clean in meshes() {
        let (averaged, _) = averaged_beyond(&clean.mesh, 0.8);
        let outliers = |mesh: &Mesh| {
            let diagnosis = inspect(mesh, 1);
            [Kind::AveragedCrease, Kind::Outlier, Kind::Custom]
                .map(|kind| diagnosis.get(kind).map(|finding| finding.count))
        };
        assert_eq!(outliers(&with_own_vertices(&averaged)), outliers(&averaged), "{}", clean.name);
    }
}

/// For normals stored in world space below a node that stretches, the weighting is recognised in mesh space, and other faults of
/// these normals are still reported.
#[test]
fn normals_of_another_space_are_reported_as_that_alone() {
    for clean in meshes().into_iter().filter(|clean| !clean.is_room) {
        let node = DMat4::from_scale(DVec3::new(1.0, 2.0, 1.0));
        let matrix = normal_matrix(DMat3::from_mat4(node)).unwrap();
        let planted = everywhere(&clean, "", Kind::Untransformed, |normal| matrix.apply(normal).unwrap());
        let below = |mesh: &Mesh| {
            let mut file = loaded(mesh.clone());
            file.nodes.push(FileNode { number: 0, name: "node".into(), part: 0, world_from_part: node });
            diagnose(&file, &Thresholds::default(), &|_| {})
        };
        let diagnosis = below(&planted.mesh);
        let of_clean = below(&clean.mesh);
        assert_eq!(reported_of_normals(&diagnosis, &of_clean), [Kind::Untransformed.id()], "{}", clean.name);
        let estimate = diagnosis.parts[0].estimate.unwrap();
        assert!(estimate.turned && estimate.reproduced > 0.99, "{}: {estimate:?}", clean.name);
        assert!(estimate.median < Degrees(1e-3), "{}: {estimate:?}", clean.name);
        let mut normals = unshared(&planted.mesh);
        normals.iter_mut().step_by(100).for_each(|normal| *normal = -*normal);
        let both = below(&per_corner(&planted.mesh, normals.clone()));
        let flipped = both.get(Kind::Flipped).map(|finding| finding.count);
        assert_eq!(flipped, Some(normals.len().div_ceil(100) as u64), "{}", clean.name);
    }
}
