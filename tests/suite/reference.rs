//! Against an independent program: corner normals that VTK's `vtkPolyDataNormals` made (splitting at a feature
//! angle, unweighted mean of face normals per smooth patch, face order kept).

use crate::meshes;
use crease::io::{ReadOptions, read};
use crease::mesh::{Mesh, Topology, Weld};
use crease::normals::{Crease, FaultReason, NormalField, NormalRecipe, Weight, compute_on};
use crease::num::Degrees;
use glam::DVec3;

/// Both sides round to `f32` (6e-8 each) after a few f32 sums on the reference's side; a wrong group or weight on
/// these meshes is off by 1e-3 and more.
const TOLERANCE: f64 = 1e-5;

/// Edges this close to the angle, in degrees, may fall on either side: crease adds 0.01° and the reference
/// compares `f32` cosines, which at 30° resolve 7e-6°.
const TIE_DEGREES: f64 = 0.011;

fn angle(a: DVec3, b: DVec3) -> f64 {
    libm::atan2(a.cross(b).length(), a.dot(b))
}

struct Case {
    source: &'static str,
    reference: &'static str,
    degrees: f64,
}

const CASES: [Case; 4] = [
    Case { source: "obj/fandisk.obj", reference: "ref/fandisk_vtk_split30.ply", degrees: 30.0 },
    Case { source: "stl/featuretype.STL", reference: "ref/featuretype_vtk_split30.ply", degrees: 30.0 },
    Case { source: "obj/platonic_shelf.obj", reference: "ref/platonic_shelf_vtk_split20.ply", degrees: 20.0 },
    Case { source: "obj/wingnut.obj", reference: "ref/wingnut_vtk_split45.ply", degrees: 45.0 },
];

#[test]
fn uniform_fans_agree_with_vtk() {
    for Case { source, reference, degrees } in CASES {
        let (Some(source), Some(reference)) = (meshes::path(source), meshes::path(reference)) else { return };
        let load = |path: &std::path::Path| {
            let mut loaded = read(path, None, &ReadOptions::default()).unwrap();
            loaded.parts.swap_remove(0).mesh
        };
        let (mesh, expected) = (load(&source), load(&reference));
        let topology = Topology::build(&mesh, Weld::Exact);
        let recipe = NormalRecipe {
            weight: Weight::Uniform,
            crease: Crease::Angle(Degrees(degrees)),
            ..NormalRecipe::default()
        };
        let field = compute_on(&mesh, &topology, &recipe);
        assert_eq!(mesh.face_count(), expected.face_count());
        let stored = expected.columns().normals.as_ref().unwrap();
        let (mut worst, mut explained) = (0.0f64, 0);
        for (face, range) in mesh.faces().ranges().enumerate() {
            let theirs = expected.faces().range(face);
            assert_eq!(range.len(), theirs.len());
            for (corner, other) in range.zip(theirs) {
                let ours = *field.normals.get(corner, 0).unwrap();
                let normal = *stored.get(other, expected.faces().corners()[other]).unwrap();
                let off = angle(ours, normal);
                if off <= TOLERANCE {
                    worst = worst.max(off);
                } else {
                    explained += 1;
                    let why = explanation(&mesh, &topology, &field, corner as u32, degrees, off);
                    assert!(
                        why.is_some(),
                        "{}: corner {corner} of face {face}: {} rad off: {ours} against {normal}",
                        source.display(),
                        off
                    );
                }
            }
        }
        println!("{}: worst {worst:.2e} rad, {explained} corners explained", source.display());
    }
}

/// Why a corner may differ: its fan has an edge at the angle itself, a face without a reliable direction, or faces so
/// thin that the reference's `f32` positions and normals explain as much.
fn explanation(
    mesh: &Mesh,
    topology: &Topology,
    field: &NormalField,
    corner: u32,
    degrees: f64,
    off: f64,
) -> Option<&'static str> {
    let faces = mesh.faces();
    let position = mesh.positions().at(faces.corners()[corner as usize]);
    let fan = (0..faces.corner_count() as u32)
        .filter(|&c| mesh.positions().at(faces.corners()[c as usize]) == position);
    let (mut blur, mut sum) = (0.0, DVec3::ZERO);
    for member in fan {
        let face = topology.face_of(member);
        let bad = [FaultReason::ZeroArea, FaultReason::BelowStorage];
        if field.faults.faces.iter().any(|fault| fault.index == face && bad.contains(&fault.reason)) {
            return Some("a face without a reliable direction");
        }
        let points: Vec<DVec3> = faces.face(face as usize).iter().map(|&v| mesh.positions().at(v)).collect();
        let largest = points.iter().map(|p| p.abs().max_element()).fold(0.0, f64::max);
        let longest = points.iter().flat_map(|a| points.iter().map(|b| a.distance(*b))).fold(0.0, f64::max);
        let double_area = (points[1] - points[0]).cross(points[2] - points[0]).length();
        blur += largest / (1 << 24) as f64 * longest / double_area;
        sum += field.face_normals[face as usize];
        for half_edge in [member, topology.previous(member)] {
            let Some(across) = topology.across(half_edge) else { continue };
            let other = topology.face_of(across);
            let dihedral =
                angle(field.face_normals[face as usize], field.face_normals[other as usize]).to_degrees();
            if (dihedral - degrees).abs() <= TIE_DEGREES {
                return Some("an edge at the angle itself");
            }
        }
    }
    // Rounding the corners of a face to `f32` moves each by up to 2⁻²⁴ of its largest coordinate, and so turns the
    // normal by about that over the height; the reference's own arithmetic in `f32` adds as much again.
    if off <= 2.0 * blur / sum.length() { Some("faces that single precision turns this far") } else { None }
}
