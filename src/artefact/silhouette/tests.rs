//! Outlines of balls and of meshes.

use super::round_surfaces::{area_ratio, enough, sagitta};
use super::*;
use crate::artefact::{Language, UserMesh};
use crate::surface::{Pattern, Sphere, Surface, Tessellation};

fn setup(size: u32) -> Setup<'static> {
    Setup { parameters: Parameters { size, ..EXPERIMENT.defaults }, mesh: None }
}

/// Figures computed outside this program.
#[test]
fn closed_forms_have_their_published_values() {
    for (segments, printed) in [(16, 3.843), (32, 0.963), (64, 0.241)] {
        assert!((sagitta(segments, 200.0) - printed).abs() < 5e-4, "{segments}");
    }
    assert_eq!([100.0, 200.0, 500.0].map(enough), [32, 45, 71]);
    for (segments, printed) in [(8, 0.900_316), (16, 0.974_495), (32, 0.993_587)] {
        assert!((area_ratio(segments) - printed).abs() < 5e-7, "{segments}");
    }
}

#[test]
fn the_artefact_is_there_and_is_cured() {
    for (size, segments) in [(96, 8), (128, 12)] {
        let mut setup = setup(size);
        setup.parameters.segments = segments;
        let outcome = EXPERIMENT.run(&setup).unwrap();
        for measure in &outcome.measures {
            assert_eq!(measure.agrees, Some(true), "{measure:?}");
        }
        // Present: two pixels. Cured: less than half of one, all that outlines leave open included.
        let effect = &outcome.effect;
        assert!(effect.bad > 1.9 && effect.cured < 0.5 && effect.reduction() > 3.9, "{effect:?}");
    }
}

fn ball(level: u32) -> crate::mesh::Mesh {
    let tessellation = Tessellation { pattern: Pattern::Icosphere(level), ..Tessellation::default() };
    Surface::from(Sphere::default()).tessellate(&tessellation).unwrap()
}

#[test]
fn a_mesh_of_ones_own_is_held_against_a_finer_one_or_itself() {
    let (coarse, fine) = (ball(1), ball(4));
    let run = |finer| {
        let own = UserMesh { name: "ball.obj", mesh: &coarse, finer };
        EXPERIMENT.run(&Setup { mesh: Some(own), ..setup(160) }).unwrap()
    };
    for outcome in [run(Some(("fine.obj", &fine))), run(None)] {
        // The middles of its faces lie up to 0.074 radii of 72 pixels within, those of its edges up to 0.049.
        let effect = &outcome.effect;
        assert!(effect.bad > 2.0 && effect.bad < 5.4 && effect.reduction() > 2.5, "{effect:?}");
        assert!(matches!(outcome.verdict, crate::artefact::Verdict::Holds(_)));
    }
    let own = UserMesh { name: "fine.obj", mesh: &fine, finer: None };
    let smooth = EXPERIMENT.run(&Setup { mesh: Some(own), ..setup(160) }).unwrap();
    assert!(matches!(smooth.verdict, crate::artefact::Verdict::Absent(_)), "{:?}", smooth.effect);
}

/// The edges of a coarse ball are sharper than the usual crease angle, so that it is compared with itself: the advice helps.
#[test]
fn a_coarse_mesh_is_reported_what_shows_its_outline() {
    let (coarse, fine) = (ball(0), ball(4));
    let run = |crease: f64, finer| {
        let own = UserMesh { name: "ball.obj", mesh: &coarse, finer };
        let mut setup = Setup { mesh: Some(own), ..setup(96) };
        setup.parameters.crease = Degrees(crease);
        EXPERIMENT.run(&setup).unwrap()
    };
    let alone = run(40.0, None);
    assert!(matches!(alone.verdict, crate::artefact::Verdict::Absent(_)), "{:?}", alone.effect);
    for (language, says) in Language::ALL.into_iter().zip(["30 edges stay sharp", "30 arestas ficam vivas"]) {
        let reported = alone.verdict.condition().get(language);
        assert!([says, "--crease 180", "--finer "].iter().all(|part| reported.contains(part)), "{reported}");
    }
    for helped in [run(180.0, None), run(40.0, Some(("fine.obj", &fine)))] {
        assert!(helped.effect.bad > 3.0 && matches!(helped.verdict, crate::artefact::Verdict::Holds(_)));
    }
}

#[test]
fn meshes_that_cannot_be_compared_are_refused() {
    let coarse = ball(1);
    let moved = crate::mesh::MeshBuilder {
        positions: coarse.positions().iter().map(|place| place + 3.0).collect(),
        faces: coarse.faces().clone(),
        ..Default::default()
    };
    let (moved, nothing) = (moved.build().unwrap(), crate::mesh::MeshBuilder::default().build().unwrap());
    let error = |mesh, finer| {
        let own = UserMesh { name: "a.obj", mesh, finer };
        EXPERIMENT.run(&Setup { mesh: Some(own), ..setup(64) }).unwrap_err().to_string()
    };
    assert!(error(&coarse, Some(("b.obj", &moved))).contains("`b.obj` and `a.obj` have different positions"));
    assert!(error(&coarse, Some(("b.obj", &nothing))).contains("`b.obj` has no faces"));
    assert!(error(&nothing, None).contains("`a.obj` has no faces"));
}
