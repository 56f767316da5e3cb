//! Somebody's own mesh, averaged over every edge and not over creases.

use super::super::own_mesh::{Room, camera, light_from, unseen};
use super::super::stage::object;
use super::super::{ArtefactError, Measure, Moved, Outcome, Parameters, Text, Threshold, UserMesh, Verdict};
use super::cure;
use super::shots::{angle_map, labelled, light_map};
use super::subject::{Subject, material};
use super::texts::TEXTS;
use crate::normals::{Crease, NormalRecipe, compute};

pub(super) fn run(own: &UserMesh, parameters: &Parameters) -> Result<Outcome, ArtefactError> {
    let &Parameters { size, light, weight, crease, .. } = parameters;
    let mesh = Room::of(own)?.moved(own.mesh)?;
    let field = compute(&mesh, &NormalRecipe::default());
    let camera = camera(&[object(&mesh, &field, material())]);
    let subject = Subject { light: light_from(&camera, light)?, mesh, camera, size };
    let [smooth, sharp] = [Crease::OFF, Crease::Angle(crease)].map(|crease| subject.case(weight, crease));
    let (smooth, sharp) = (smooth?, sharp?);
    if smooth.lit.coverage.iter().all(|&covered| covered == 0) {
        return Err(unseen(own, size));
    }
    let measure = |en, pt, unit, value| Measure::new(Text::new(en, pt), unit, value);
    let [angles, light] = smooth.maps();
    let of = ["mesh", "malha"];
    let moved = Moved {
        name: TEXTS.get("moved-largest-angle-corner"),
        unit: "°",
        bad: smooth.largest(),
        present: Threshold { value: crease.0, why: TEXTS.get("why-crease-angle-less") },
        cure: cure(crease),
        cured: sharp.largest(),
        factor: 2.0,
    };
    Ok(Outcome {
        verdict: Verdict::Holds(TEXTS.get("holds-mesh-corners-mean")),
        measures: vec![
            measure(
                "averaged: share of corners over the crease angle",
                "média: parcela de cantos acima do ângulo de vinco",
                "",
                smooth.share_over(crease),
            ),
            measure(
                "split: share of corners over the crease angle",
                "separada: parcela de cantos acima do ângulo de vinco",
                "",
                sharp.share_over(crease),
            ),
            measure(
                "averaged: largest angle of a corner's normal to its face",
                "média: maior ângulo da normal de um canto com a sua face",
                "°",
                smooth.largest(),
            ),
            measure(
                "split: largest angle of a corner's normal to its face",
                "separada: maior ângulo da normal de um canto com a sua face",
                "°",
                sharp.largest(),
            ),
            measure(
                "averaged: mean angle of the pixels",
                "média: ângulo médio dos pixels",
                "°",
                smooth.deviation.mean,
            ),
            measure(
                "split: mean angle of the pixels",
                "separada: ângulo médio dos pixels",
                "°",
                sharp.deviation.mean,
            ),
        ],
        shots: vec![
            moved.bad_shot(
                "own",
                labelled(of, ["averaged", "média"]),
                [TEXTS.get("own-title"), TEXTS.get("own-caption-sharp-edges-smoothed")],
                smooth.lit,
            ),
            moved.cured_shot(
                "own-split",
                labelled(of, ["split", "separada"]),
                [TEXTS.get("own-split-title"), TEXTS.get("own-split-caption-they-sharp-again")],
                sharp.lit,
            ),
            angle_map("own-angles", of, angles),
            light_map("own-light", of, light),
        ],
        moved,
        charts: Vec::new(),
        notes: vec![TEXTS.get("note-faces-stand-something")],
    })
}
