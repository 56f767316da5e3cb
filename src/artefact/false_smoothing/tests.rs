//! What averaging does to sharp edges.

use super::*;
use crate::artefact::UserMesh;
use crate::surface::{Sphere, Surface, Tessellation};

fn setup(size: u32) -> Setup<'static> {
    Setup { parameters: Parameters { size, ..EXPERIMENT.defaults }, mesh: None }
}

#[test]
fn the_artefact_is_there_and_is_cured() {
    for weight in [Weight::Angle, Weight::Area, Weight::Max] {
        let mut setup = setup(96);
        setup.parameters.weight = weight;
        let outcome = EXPERIMENT.run(&setup).unwrap();
        for measure in &outcome.measures {
            assert_ne!(measure.agrees, Some(false), "{weight:?}: {measure:?}");
        }
        // Present: normals are off by tens of degrees. Cured: only the bore's facets are left, a hundred times less.
        let effect = &outcome.effect;
        assert!(effect.bad > 20.0 && effect.reduction() > 100.0, "{weight:?}: {effect:?}");
    }
}

/// The zig-zag in averaged normals is one luminance, split it is two.
#[test]
fn a_zigzag_vanishes() {
    let outcome = EXPERIMENT.run(&setup(64)).unwrap();
    let luminances = |name: &str| {
        let shot = outcome.shots.iter().find(|shot| shot.name == name).unwrap();
        let all = super::super::drawing::luminance(&shot.image);
        let seen = all.iter().zip(&shot.image.coverage).filter(|(_, covered)| **covered > 0);
        seen.fold((f64::INFINITY, 0.0), |(low, high): (f64, f64), (&y, _)| (low.min(y), high.max(y)))
    };
    let ((low, high), (dark, bright)) = (luminances("zigzag"), luminances("zigzag-split"));
    let expected = [35.0 + 45.0, 35.0 - 45.0].map(|angle: f64| libm::cos(angle.to_radians()));
    assert!(high - low < 1e-6, "{low} {high}");
    assert!((dark - expected[0]).abs() < 1e-6 && (bright - expected[1]).abs() < 1e-6, "{dark} {bright}");
}

#[test]
fn a_crease_angle_over_the_edges_cures_nothing() {
    let mut setup = setup(48);
    setup.parameters.crease = Degrees(100.0);
    let outcome = EXPERIMENT.run(&setup).unwrap();
    assert!(outcome.measures.iter().all(|measure| measure.agrees != Some(false)));
    assert_eq!(outcome.effect.bad, outcome.effect.cured);
    assert!(outcome.effect.is_present() && !outcome.effect.is_cured());
}

#[test]
fn meshes_of_ones_own_are_judged_by_the_crease_angle() {
    let (cube, ball) = (meshes::cube().unwrap(), Surface::from(Sphere::default()));
    let ball = ball.tessellate(&Tessellation { segments: [24, 12], ..Tessellation::default() }).unwrap();
    let run = |mesh| {
        let own = UserMesh { name: "own.obj", mesh, finer: None };
        EXPERIMENT.run(&Setup { mesh: Some(own), ..setup(64) }).unwrap()
    };
    let outcome = run(&cube);
    assert!(matches!(outcome.verdict, Verdict::Holds(_)));
    assert_eq!(outcome.measures[0].value, 1.0);
    // Single precision of pictures.
    assert!(outcome.effect.bad > 10.0 && outcome.effect.cured < 1e-4, "{:?}", outcome.effect);
    assert!(matches!(run(&ball).verdict, Verdict::Absent(_)));
}
