//! The degrees and grey steps of findings, against independent computations.

use super::{inspect, rebuilt};
use crease::mesh::{Column, Faces};
use crease::quality::catalogue::Kind;
use glam::DVec3;

/// The degrees of a finding about a mesh of these corners and faces.
fn degrees(kind: Kind, corners: &[[f64; 3]], faces: &[&[u32]]) -> f64 {
    let mut all = Faces::new();
    faces.iter().for_each(|face| all.push(face));
    let mesh = rebuilt(corners.iter().map(|&corner| DVec3::from(corner)).collect(), all);
    let diagnosis = inspect(&mesh, 10);
    let finding =
        diagnosis.get(kind).unwrap_or_else(|| panic!("no {} in {:?}", kind.id(), diagnosis.findings));
    assert!(finding.steps.is_some(), "{finding:?}");
    finding.degrees.unwrap_or_else(|| panic!("{} has no angle", kind.id()))
}

#[test]
fn angles_are_those_that_can_be_worked_out() {
    // A corner of a cube with one side doubled: its normal changes from (1, 1, 1) to (2, 1, 1).
    let cube = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let twice: [&[u32]; 4] = [&[0, 2, 1], &[0, 3, 2], &[0, 1, 3], &[0, 2, 1]];
    let of_cube = libm::acos(4.0 / 18f64.sqrt()).to_degrees();
    // A roof of two sides with a dihedral angle of 30° and no common vertices: each side is 15° off the smooth normal.
    let (sin, cos) = libm::sincos(30f64.to_radians());
    let roof = [
        [0.0, 1.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, -cos, -sin],
    ];
    // Two perpendicular triangles that touch in a point.
    let touching = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]];
    let arrow = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.2, 0.2, 0.0], [0.0, 1.0, 0.0]];
    let bow = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.9, 0.0]];
    let two_sides: [&[u32]; 2] = [&[0, 2, 1], &[0, 1, 2]];
    // A flat sheet, and a wing perpendicular to it along its middle line.
    let tee = [[0.0; 3], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    // Each end of the height is off by up to 2⁻²⁴ of the largest coordinate.
    let needle = [[100.0, 0.0, 0.0], [101.0, 0.0, 0.0], [100.5, 1e-4, 0.0]];
    let of_needle = libm::atan(101.0 * f64::from(f32::EPSILON) / 1e-4).to_degrees();
    // A cone with an opening angle of 90° and many faces.
    let count = 200;
    let turn = std::f64::consts::TAU / f64::from(count);
    let rim = (0..count).map(|k| {
        let (sin, cos) = libm::sincos(f64::from(k) * turn);
        [cos, sin, 0.0]
    });
    let cone: Vec<[f64; 3]> = std::iter::once([0.0, 0.0, 1.0]).chain(rim).collect();
    let around: Vec<[u32; 3]> = (0..count).map(|k| [0, 1 + k, 1 + (k + 1) % count]).collect();
    let around: Vec<&[u32]> = around.iter().map(|face| &face[..]).collect();
    for (kind, corners, faces, expected) in [
        (Kind::DuplicateFaces, &cube[..], &twice[..], of_cube),
        (Kind::DuplicateVertices, &roof, &[&[0, 2, 1], &[3, 5, 4]], 15.0),
        (Kind::PinchedVertices, &touching, &[&[0, 1, 2], &[0, 3, 4]], 45.0),
        (Kind::Concave, &arrow, &[&[0, 1, 2, 3]], 0.0),
        (Kind::Concave, &arrow, &[&[1, 2, 3, 0]], 180.0),
        (Kind::Crossed, &bow, &[&[0, 1, 2, 3]], 180.0),
        (Kind::BackToBack, &cube, &two_sides, 180.0),
        (Kind::NonManifold, &tee, &[&[0, 1, 2], &[1, 0, 3], &[0, 1, 4]], 90.0),
        (Kind::Needles, &needle, &[&[0, 1, 2]], of_needle),
        (Kind::HighValence, &cone, &around, libm::atan(1.0 / libm::cos(turn / 2.0)).to_degrees()),
        // The difference between smooth and flat shading.
        (Kind::NoNormals, &roof[..], &[&[0, 2, 1], &[3, 5, 4]], 15.0),
    ] {
        let reported = degrees(kind, corners, faces);
        assert!((reported - expected).abs() < 1e-9, "{}: {reported} for {expected}", kind.id());
    }
}

/// The normals of a flat sheet have right directions and wrong lengths, which changes the light of a lamp at 45°.
#[test]
fn light_that_lengths_take_and_give_is_reported() {
    let corners = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]].map(DVec3::from);
    let sheet = |length: f64| {
        let mut faces = Faces::new();
        [[0, 1, 2], [0, 2, 3]].iter().for_each(|face| faces.push(face));
        let normals = Column::per_vertex(vec![DVec3::Z * length; 4]);
        rebuilt(corners.to_vec(), faces).with_normals(Some(normals))
    };
    // The transfer curve of sRGB (IEC 61966-2-1).
    let grey = |light: f64| 255.0 * (1.055 * libm::pow(light, 1.0 / 2.4) - 0.055);
    let right = grey(0.5f64.sqrt());
    for (kind, length, steps) in [
        (Kind::ZeroNormals, 0.0, right),
        (Kind::NotFinite, f64::NAN, right),
        (Kind::NotUnit, 0.5, right - grey(0.125f64.sqrt())),
        // White is the maximum.
        (Kind::NotUnit, 3.0, 255.0 - right),
        (Kind::LooseLength, 1.003, grey(1.003 * 0.5f64.sqrt()) - right),
    ] {
        let diagnosis = inspect(&sheet(length), 10);
        let finding = diagnosis.get(kind).unwrap_or_else(|| panic!("{length}: {:?}", diagnosis.findings));
        let reported = finding.steps.unwrap();
        assert!((reported - steps).abs() < 1e-9, "{length}: {reported} for {steps}");
        assert_eq!(finding.degrees, None, "{length}");
    }
}
