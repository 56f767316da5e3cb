//! The outline of somebody's own mesh, against that of a finer one.

use super::super::own_mesh::{Room, camera, light_from, unseen};
use super::super::{
    ArtefactError, Language, Measure, Moved, Outcome, Parameters, Shot, Text, Threshold, UserMesh, Verdict,
};
use super::curved::curved;
use super::texts::TEXTS;
use super::{View, between, material};
use crate::mesh::Mesh;
use crate::metric::MetricError;
use crate::normals::{Crease, NormalRecipe, compute};
use crate::num::Degrees;
use crate::raster::{Object, Shading, Shape};

/// Into how many parts the edges of the cure are cut, which is what a program that draws would do.
const CURE: u32 = 3;
/// Into how many those of a mesh that has to be its own truth, at most, and how many triangles that may make.
const TRUTH: u32 = 8;
const MOST_TRIANGLES: usize = 1 << 21;

pub(super) fn run(own: &UserMesh, parameters: &Parameters) -> Result<Outcome, ArtefactError> {
    measure(own, parameters).map_err(|error| match error {
        ArtefactError::Metric(MetricError::Empty) => unseen(own, parameters.size),
        other => other,
    })
}

fn measure(own: &UserMesh, parameters: &Parameters) -> Result<Outcome, ArtefactError> {
    let &Parameters { size, light, crease, .. } = parameters;
    let room = Room::of(own)?;
    let recipe = NormalRecipe { crease: Crease::Angle(crease), ..NormalRecipe::default() };
    let mesh = room.moved(own.mesh)?;
    let finer = own.finer.map(|(_, finer)| room.moved(finer)).transpose()?;
    let field = compute(&mesh, &recipe);
    let of_finer = finer.as_ref().map(|finer| compute(finer, &recipe));
    let object = |mesh, normals| Object::new(Shape::Mesh { mesh, normals }, material());
    let parts = parts(&mesh);
    let patches = curved(&mesh, &field, parts);
    let truth = match (&finer, &of_finer) {
        (Some(finer), Some(normals)) => object(finer, normals),
        _ => patches.object(material()),
    };
    let camera = camera(&[truth.clone(), object(&mesh, &field)]);
    let view = View { size, camera, light: light_from(&camera, light)? };
    let patches_of_cure = curved(&mesh, &field, CURE);
    let cure = || patches_of_cure.object(material());
    let outline = |object| view.outline(object, Shading::Flat);
    let true_outline = outline(truth.clone())?;
    let of_coarse = outline(object(&mesh, &field))?.distance(&true_outline)?;
    let of_cured = outline(cure())?.distance(&true_outline)?;
    let picture = |object| view.draw(object, Shading::Phong);
    let (truth, coarse, cured) = (picture(truth)?, picture(object(&mesh, &field))?, picture(cure())?);
    let lacking = between(&coarse, &truth);
    let reported = reported(own, parts);
    let sharp = Sharp { edges: field.summary.edges.crease, crease };
    let is_off = of_coarse.hausdorff > Threshold::HALF_PIXEL.value;
    let number = |en, pt, unit, value| Measure::new(Text::new(en, pt), unit, value);
    let moved = Moved {
        name: TEXTS.get("moved"),
        unit: "px",
        bad: of_coarse.hausdorff,
        present: Threshold::HALF_PIXEL,
        cure: Text::made(
            format!("curved triangles, every edge cut into {CURE}"),
            format!("triângulos curvos, cada aresta cortada em {CURE}"),
        ),
        cured: of_cured.hausdorff,
        factor: 2.0,
    };
    let is_beside = own.finer.is_some() && moved.is_present() && !moved.is_cured();
    let control_mesh = is_beside.then_some(TEXTS.get("curved-triangles-leave"));
    Ok(Outcome {
        verdict: match (is_off, own.finer) {
            (true, _) => Verdict::Holds(Text::each(|language| {
                let off = TEXTS.get("holds-outline-mesh-off");
                format!("{} {}", off.get(language), reported.get(language))
            })),
            (false, Some(_)) => Verdict::Absent(TEXTS.get("absent-meshes-same-outline")),
            (false, None) => Verdict::Absent(sharp.advice()),
        },
        measures: vec![
            number(
                "largest distance of the outline",
                "maior distância do contorno",
                "px",
                of_coarse.hausdorff,
            ),
            number("mean distance of the outline", "distância média do contorno", "px", of_coarse.mean),
            number(
                "area over that of what it is held against",
                "área sobre a daquilo com que é comparada",
                "",
                of_coarse.area_ratio,
            ),
            number(
                "curved triangles: largest distance of the outline",
                "triângulos curvos: maior distância do contorno",
                "px",
                of_cured.hausdorff,
            ),
            number(
                "curved triangles: mean distance of the outline",
                "triângulos curvos: distância média do contorno",
                "px",
                of_cured.mean,
            ),
            number(
                "edges would have to be so many times shorter for half a pixel",
                "as arestas teriam de ser tantas vezes mais curtas para meio pixel",
                "",
                (2.0 * of_coarse.hausdorff).sqrt(),
            ),
        ],
        shots: vec![
            moved.bad_shot(
                "own",
                TEXTS.get("own-title"),
                [TEXTS.get("own-caption-mesh-phong-shading"), TEXTS.get("own-caption-outline-off")],
                coarse,
            ),
            Shot::difference(
                "lacking",
                TEXTS.get("lacking-title-between-outlines"),
                match own.finer {
                    Some(_) => TEXTS.get("lacking-caption-yellow-only-covers"),
                    None => TEXTS.get("lacking-caption-yellow-only-covers-picture"),
                },
                lacking,
            ),
            moved.cured_shot(
                "own-curved",
                TEXTS.get("own-curved-title"),
                [
                    TEXTS.get("own-curved-caption-same-mesh-curved"),
                    TEXTS.get("own-curved-caption-outline-comes-closer"),
                ],
                cured,
            ),
            Shot::truth(
                "finer",
                match own.finer {
                    Some(_) => TEXTS.get("finer-title"),
                    None => TEXTS.get("finer-caption-held-against"),
                },
                TEXTS.get("finer-caption-outlines-held-against"),
                truth,
            ),
        ],
        moved,
        charts: Vec::new(),
        notes: [Some(reported), control_mesh].into_iter().flatten().collect(),
    })
}

/// Edges of a mesh that stay sharp in curved triangles, and the angle that makes them so.
struct Sharp {
    edges: usize,
    crease: Degrees,
}

impl Sharp {
    /// What would show an outline that is seen to be right, for a mesh that is its own truth.
    fn advice(&self) -> Text {
        let &Self { edges, crease } = self;
        match edges {
            0 => TEXTS.get("no-finer-mesh"),
            _ => Text::each(|language| {
                let angle = language.number(crease.0);
                match language {
                    Language::English => format!(
                        "no finer mesh was given, and {edges} edges stay sharp in the curved triangles that this one is held against, \
                         being sharper than {angle}°. If they stand for something round, --crease 180 makes them so; --finer FILE gives \
                         the true shape."
                    ),
                    Language::Portuguese => format!(
                        "não foi dada malha mais fina, e {edges} arestas ficam vivas nos triângulos curvos com que esta é comparada, \
                         por serem mais vivas que {angle}°. Se representam algo redondo, --crease 180 as torna assim; --finer ARQUIVO \
                         indica a forma verdadeira."
                    ),
                }
            }),
        }
    }
}

/// What was taken for the truth.
fn reported(own: &UserMesh, parts: u32) -> Text {
    match own.finer {
        Some((finer, _)) => TEXTS.with("held-against-finer", &[("finer", finer.into())]),
        None => TEXTS.with("no-finer-mesh-given", &[("parts", parts.into())]),
    }
}

/// Into how many parts edges are cut: all of them, unless that makes too many triangles.
fn parts(mesh: &Mesh) -> u32 {
    let triangles = mesh.faces().corner_count() - 2 * mesh.face_count();
    let fits = |&parts: &u32| triangles.saturating_mul((parts * parts) as usize) <= MOST_TRIANGLES;
    (CURE + 1..=TRUTH).rev().find(fits).unwrap_or(CURE + 1)
}
