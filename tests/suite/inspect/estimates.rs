//! Estimates of our own normals, by every weighting and many crease angles: each is found, and nothing is reported as a fault.

use super::clean::{file, meshes};
use super::planted::{per_corner, unshared};
use super::{grave, inspect, rebuilt, recipe, surface, with_normals};
use crate::random::Random;
use crease::mesh::{ColumnIndex, Columns, Faces, Mesh, MeshBuilder, SmoothingGroups};
use crease::normals::{Crease, Groups, NormalRecipe, Weight, compute};
use crease::num::Degrees;
use crease::quality::Estimate;
use crease::quality::catalogue::Kind;
use crease::surface::{Cone, Ellipsoid, Sphere, Surface, Torus, Wave};
use glam::DVec3;

fn estimate(mesh: &Mesh) -> Estimate {
    inspect(mesh, 1).parts[0].estimate.unwrap()
}

/// Whether the estimated recipe gives all normals of a mesh again, to the bit.
fn gives_the_same_bits(estimate: &Estimate, mesh: &Mesh) -> bool {
    let again = compute(mesh, &estimate.recipe()).normals;
    let ColumnIndex::PerCorner(index) = &again.index else { panic!("per corner") };
    assert_eq!(index.len(), mesh.faces().corner_count());
    Some(again) == mesh.columns().normals
}

#[test]
fn the_recipe_is_estimated() {
    for clean in meshes().into_iter().filter(|clean| clean.is_uneven) {
        // Of the fits, only quadrics are recognised.
        for weight in Weight::SUMS.into_iter().chain([Weight::Quadric]) {
            let recipe = NormalRecipe { weight, ..clean.recipe };
            let mesh = with_normals(clean.mesh.clone().with_normals(None), &recipe);
            let estimate = estimate(&mesh);
            let reported = format!("{}: {estimate:?}", clean.name);
            assert_eq!(estimate.weight, weight, "{reported}");
            assert!(estimate.reproduced > 0.999 && estimate.median < Degrees(1e-5), "{reported}");
            assert!(gives_the_same_bits(&estimate, &mesh), "{reported}");
        }
    }
}

/// Fits are no weighted means: without trying a fit, these would be taken for the closest mean or for authored normals.
#[test]
fn quadrics_are_reported_and_blamed_for_nothing() {
    for (shape, segments) in [
        (Surface::from(Torus::default()), [24, 12]),
        (Surface::from(Ellipsoid::default()), [32, 16]),
        (Surface::from(Cone::default()), [32, 8]),
        (Surface::Wave(Wave::default()), [30, 30]),
        (Surface::Teapot, [6, 6]),
    ] {
        let mesh = with_normals(surface(&shape, segments).with_normals(None), &recipe(Weight::Quadric, 40.0));
        let diagnosis = inspect(&mesh, 1);
        let estimate = diagnosis.parts[0].estimate.unwrap();
        assert_eq!(estimate.weight, Weight::Quadric, "{shape:?}: {estimate:?}");
        assert!(estimate.exactly == 1.0 && estimate.sample <= 2048, "{shape:?}: {estimate:?}");
        assert_eq!(grave(&diagnosis), [""; 0], "{shape:?}");
    }
}

/// On a capped cylinder with a smooth rim, fits differ so much from means that the edges do not determine the closest mean.
#[test]
fn quadrics_are_reported_with_their_own_crease_angle() {
    let mut faces = Faces::new();
    for i in 0..32 {
        let next = (i + 1) % 32;
        faces.push(&[i, next, 32 + next, 32 + i]);
    }
    faces.push(&Vec::from_iter((0..32).rev()));
    faces.push(&Vec::from_iter(32..64));
    let at = |i: u32| {
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * f64::from(i % 32) / 32.0);
        DVec3::new(sin, cos, if i < 32 { 1.0 } else { -1.0 })
    };
    let cylinder = rebuilt((0..64).map(at).collect(), faces);
    let mesh = with_normals(cylinder, &recipe(Weight::Quadric, 180.0));
    let diagnosis = inspect(&mesh, 1);
    let estimate = diagnosis.parts[0].estimate.unwrap();
    assert_eq!((estimate.weight, estimate.exactly), (Weight::Quadric, 1.0), "{estimate:?}");
    assert!(gives_the_same_bits(&estimate, &mesh), "{estimate:?}");
    // The smooth rim of 90° is reported, and nothing else.
    assert_eq!(grave(&diagnosis), ["soft-normals"]);
}

/// An edge with a negated normal at one end looks sharp at any dihedral angle. That must not shift the estimated crease angle.
#[test]
fn many_negated_normals_do_not_shift_the_crease_angle() {
    let teapot = surface(&Surface::Teapot, [6, 6]).with_normals(None);
    let normals = unshared(&with_normals(teapot.clone(), &recipe(Weight::Angle, 30.0)));
    for seed in 0..8 {
        let mut random = Random(seed);
        let mut negated = 0;
        let mut negate = |&normal: &DVec3| {
            let is_one = random.one_in(10);
            negated += u64::from(is_one);
            if is_one { -normal } else { normal }
        };
        let normals = normals.iter().map(&mut negate).collect();
        let diagnosis = inspect(&per_corner(&teapot, normals), 1);
        assert_eq!(diagnosis.parts[0].estimate.unwrap().crease, Degrees(30.0), "{seed}");
        assert_eq!(grave(&diagnosis), [Kind::Flipped.id()], "{seed}");
        assert_eq!(diagnosis.get(Kind::Flipped).unwrap().count, negated, "{seed}");
    }
}

/// Many dihedral angles of the gear are 60° up to the rounding of its file; others are larger, at its teeth.
#[test]
fn crease_angles_are_reported_as_computing_has_them() {
    let gear = file("gear.obj");
    for groups in [Groups::Honour, Groups::Ignore] {
        for angle in [30.0, 40.0, 45.0, 50.0, 55.0, 60.0, 61.0, 70.0, 180.0] {
            let made =
                NormalRecipe { groups, crease: Crease::Angle(Degrees(angle)), ..NormalRecipe::default() };
            let mesh = with_normals(gear.clone(), &made);
            let diagnosis = inspect(&mesh, 1);
            let estimate = diagnosis.parts[0].estimate.unwrap();
            let reported = format!("{groups:?}, {angle}: {estimate:?}");
            assert!(gives_the_same_bits(&estimate, &mesh), "{reported}");
            assert_eq!(estimate.exactly, 1.0, "{reported}");
            // Edges where smoothing groups and crease angle disagree are reported.
            let told_of = grave(&diagnosis);
            assert!(told_of.iter().all(|id| *id == "group-mismatch"), "{reported}: {told_of:?}");
        }
    }
}

/// A smooth ball in two smoothing groups: smooth normals across the border contradict the groups, and split normals follow them.
#[test]
fn a_seam_between_groups_is_meant() {
    let ball = surface(&Surface::from(Sphere::default()), [32, 16]);
    let group = |face: &[u32]| {
        let above = face.iter().map(|&vertex| ball.positions().at(vertex).y).sum::<f64>() > 0.0;
        if above { 1 } else { 2 }
    };
    let of_face = ball.faces().iter().map(group).collect();
    let smoothing = Some(SmoothingGroups { of_face, before_first: 0 });
    let columns = Columns { smoothing, ..Columns::default() };
    let grouped =
        MeshBuilder { positions: ball.positions().to_vec().into(), faces: ball.faces().clone(), columns };
    let grouped = grouped.build().unwrap();
    let with = |groups| NormalRecipe { groups, ..recipe(Weight::Angle, 40.0) };
    let across = inspect(&with_normals(grouped.clone(), &with(Groups::Ignore)), 1);
    // 32 edges of the border.
    assert_eq!(across.get(Kind::GroupMismatch).map(|finding| finding.count), Some(32));
    let parted = inspect(&with_normals(grouped, &with(Groups::Honour)), 1);
    assert_eq!(grave(&parted), [""; 0]);
    assert!(parted.get(Kind::GroupMismatch).is_none() && parted.get(Kind::SplitSeam).is_none());
}

/// Means by every weighting with many crease angles: the report names both. Fits are compared with means in another test, because
/// both are the same on coarse shapes.
#[test]
fn the_recipe_that_made_the_normals_is_among_those_reported() {
    for (name, step) in [("bracket.obj", 1), ("polygons.obj", 1), ("gear.obj", 13)] {
        let mesh = file(name).with_normals(None);
        for weight in Weight::SUMS {
            for angle in (1..180).step_by(step).map(f64::from) {
                let made = NormalRecipe { groups: Groups::Ignore, ..recipe(weight, angle) };
                let report = estimate(&with_normals(mesh.clone(), &made)).in_words();
                let report = report.english();
                let [low, high] = reported_range(report);
                assert!(low <= angle && angle <= high, "{name}, {weight:?}, {angle}: {report}");
                let words: Vec<&str> = report.split([' ', ',']).collect();
                let is_listed = words.contains(&weight.name()) || report.contains("any weight");
                assert!(is_listed, "{name}, {weight:?}, {angle}: {report}");
            }
        }
    }
}

/// The estimate has smoothing groups even if a crease angle alone is within 5° of all normals.
#[test]
fn normals_by_smoothing_groups_are_attributed_to_them() {
    for name in ["bracket.obj", "gear.obj"] {
        let mesh = file(name).with_normals(None);
        for weight in Weight::SUMS {
            let made = NormalRecipe { weight, ..NormalRecipe::default() };
            let estimate = estimate(&with_normals(mesh.clone(), &made));
            assert!(estimate.groups, "{name}, {weight:?}: {}", estimate.in_words().english());
        }
    }
}

/// The ends of `crease 28° to 60°`, `crease 28°`, `crease 28° or more` or `any crease angle`.
fn reported_range(report: &str) -> [f64; 2] {
    let Some((_, from)) = report.split_once(" fit crease ") else { return [0.0, 180.0] };
    let angle = |text: &str| text.split('°').next().unwrap().parse::<f64>().unwrap();
    let low = angle(from);
    let rest = from.split_once('°').unwrap().1;
    match rest.strip_prefix(" to ") {
        Some(high) => [low, angle(high)],
        None => [low, if rest.starts_with(" or more") { 180.0 } else { low }],
    }
}
