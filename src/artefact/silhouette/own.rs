//! The outline of somebody's own mesh, against that of a finer one.

use super::super::own_mesh::{Room, camera, light_from, unseen};
use super::super::{
    ArtefactError, Language, Measure, Moved, Outcome, Parameters, Shot, Text, Threshold, UserMesh, Verdict,
};
use super::curved::curved;
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
    let told = told(own, parts);
    let sharp = Sharp { edges: field.summary.edges.crease, crease };
    let is_off = of_coarse.hausdorff > Threshold::HALF_PIXEL.value;
    let number = |en, pt, unit, value| Measure::new(Text::new(en, pt), unit, value);
    let moved = Moved {
        name: Text::new("largest distance of the outline", "maior distância do contorno"),
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
    let control_mesh = is_beside.then_some(Text::new(
        "Curved triangles leave the mesh's vertices where they are. If this is the control mesh of a subdivision surface, they do \
         not lie on that surface, so that no curve through them is its outline: what helps is to subdivide it, or to move its \
         vertices to where the subdivision brings them.",
        "Triângulos curvos deixam os vértices da malha onde estão. Se esta é a malha de controle de uma superfície de subdivisão, eles \
         não estão nessa superfície, e nenhuma curva por eles é o seu contorno: o que ajuda é subdividi-la, ou mover os vértices para \
         onde a subdivisão os leva.",
    ));
    Ok(Outcome {
        verdict: match (is_off, own.finer) {
            (true, _) => Verdict::Holds(Text::each(|language| {
                let off = Text::new(
                    "the outline of this mesh is off by more than half a pixel here.",
                    "o contorno desta malha erra mais de meio pixel aqui.",
                );
                format!("{} {}", off.get(language), told.get(language))
            })),
            (false, Some(_)) => Verdict::Absent(Text::new(
                "the two meshes have the same outline at this size: a larger picture (--size) or a finer mesh for --finer would \
                 show more.",
                "as duas malhas têm o mesmo contorno neste tamanho: uma imagem maior (--size) ou uma malha mais fina em --finer \
                 mostraria mais.",
            )),
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
                Text::new("the mesh", "a malha"),
                [
                    Text::new(
                        "The mesh as it is, with Phong's shading.",
                        "A malha como ela é, com o sombreamento de Phong.",
                    ),
                    Text::new("Its outline is off.", "O seu contorno erra."),
                ],
                coarse,
            ),
            Shot::difference(
                "lacking",
                Text::new("between the outlines", "entre os contornos"),
                match own.finer {
                    Some(_) => Text::new(
                        "Yellow where only one of the two covers the picture, the mesh or the finer one.",
                        "Amarelo onde só uma das duas cobre a imagem, a malha ou a mais fina.",
                    ),
                    None => Text::new(
                        "Yellow where only one of the two covers the picture, the mesh or its own curved triangles.",
                        "Amarelo onde só uma das duas cobre a imagem, a malha ou os seus próprios triângulos curvos.",
                    ),
                },
                lacking,
            ),
            moved.cured_shot(
                "own-curved",
                Text::new("curved triangles", "triângulos curvos"),
                [
                    Text::new(
                        "The same mesh in curved triangles that its normals determine.",
                        "A mesma malha em triângulos curvos que as suas normais determinam.",
                    ),
                    Text::new("Its outline comes closer.", "O seu contorno se aproxima."),
                ],
                cured,
            ),
            Shot::truth(
                "finer",
                match own.finer {
                    Some(_) => Text::new("the finer mesh", "a malha mais fina"),
                    None => Text::new("what it is held against", "aquilo com que é comparada"),
                },
                Text::new(
                    "What the outlines are held against.",
                    "Aquilo com que os contornos são comparados.",
                ),
                truth,
            ),
        ],
        moved,
        charts: Vec::new(),
        notes: [Some(told), control_mesh].into_iter().flatten().collect(),
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
            0 => Text::new(
                "no finer mesh was given, and in curved triangles the outline is the same: give one with --finer FILE, or a larger \
                 picture (--size).",
                "não foi dada malha mais fina, e em triângulos curvos o contorno é o mesmo: indique uma com --finer ARQUIVO, ou uma \
                 imagem maior (--size).",
            ),
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
fn told(own: &UserMesh, parts: u32) -> Text {
    match own.finer {
        Some((finer, _)) => Text::made(
            format!("It is held against the finer mesh `{finer}`."),
            format!("Ela é comparada com a malha mais fina `{finer}`."),
        ),
        None => Text::made(
            format!(
                "No finer mesh was given, so it is held against itself in curved triangles, every edge cut into {parts}: Bézier \
                 triangles of third order that leave its vertices at right angles to its normals (curved PN triangles), and \
                 along creases at right angles to the normals of both sides. What it stands for may be another shape; \
                 --finer FILE gives that."
            ),
            format!(
                "Não foi dada malha mais fina, e ela é comparada consigo mesma em triângulos curvos, cada aresta cortada em \
                 {parts}: triângulos de Bézier de terceira ordem que saem dos vértices em ângulo reto com as normais (curved PN \
                 triangles), e nos vincos em ângulo reto com as normais dos dois lados. Aquilo que ela representa pode ter outra \
                 forma; --finer ARQUIVO a indica."
            ),
        ),
    }
}

/// Into how many parts edges are cut: all of them, unless that makes too many triangles.
fn parts(mesh: &Mesh) -> u32 {
    let triangles = mesh.faces().corner_count() - 2 * mesh.face_count();
    let fits = |&parts: &u32| triangles.saturating_mul((parts * parts) as usize) <= MOST_TRIANGLES;
    (CURE + 1..=TRUTH).rev().find(fits).unwrap_or(CURE + 1)
}
