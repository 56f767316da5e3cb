//! The angles that findings about shape tell, against ones that are known.

use super::{inspect, rebuilt};
use crease::mesh::Faces;
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
    // The corner of a cube, one side twice: from (1, 1, 1) to (2, 1, 1).
    let cube = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let twice: [&[u32]; 4] = [&[0, 2, 1], &[0, 3, 2], &[0, 1, 3], &[0, 2, 1]];
    let of_cube = libm::acos(4.0 / 18f64.sqrt()).to_degrees();
    // A roof of two sides that bend by 30° with no corner in common: each is half of that off what is smooth.
    let (sin, cos) = libm::sincos(30f64.to_radians());
    let roof = [
        [0.0, 1.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, -cos, -sin],
    ];
    // Two triangles that stand on each other and touch in a point.
    let touching = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]];
    let arrow = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.2, 0.2, 0.0], [0.0, 1.0, 0.0]];
    let bow = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.9, 0.0]];
    let two_sides: [&[u32]; 2] = [&[0, 2, 1], &[0, 1, 2]];
    for (kind, corners, faces, expected) in [
        (Kind::DuplicateFaces, &cube[..], &twice[..], of_cube),
        (Kind::DuplicateVertices, &roof, &[&[0, 2, 1], &[3, 5, 4]], 15.0),
        (Kind::PinchedVertices, &touching, &[&[0, 1, 2], &[0, 3, 4]], 45.0),
        (Kind::Concave, &arrow, &[&[0, 1, 2, 3]], 0.0),
        (Kind::Concave, &arrow, &[&[1, 2, 3, 0]], 180.0),
        (Kind::Crossed, &bow, &[&[0, 1, 2, 3]], 180.0),
        (Kind::BackToBack, &cube, &two_sides, 180.0),
        // Smooth and flat.
        (Kind::NoNormals, &roof[..], &[&[0, 2, 1], &[3, 5, 4]], 15.0),
    ] {
        let told = degrees(kind, corners, faces);
        assert!((told - expected).abs() < 1e-9, "{}: {told} for {expected}", kind.id());
    }
}
