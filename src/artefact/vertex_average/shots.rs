//! The pictures, with what there is to see in them.

use super::super::own_mesh::{camera, light_from};
use super::super::stage::{chalk, differences, draw, map, object, settings, smooth};
use super::super::{ArtefactError, Language, Role, Shot, Text};
use super::cuts::{CUTS, cut_box};
use super::specimen::{Look, Specimen};
use super::{FLAT, LONG, MEANS, ROUND};
use crate::normals::Weight;
use crate::raster::{Image, Interpolation, Shading, Show};
use glam::DVec3;

/// Full scale of the maps: of light, and of angles in degrees.
const FULL_LIGHT: f64 = 0.3;
const FULL_ANGLE: f64 = 5.0;

pub(super) fn all(
    weight: Weight,
    look: &Look,
    torus: &Specimen,
    ball: &Specimen,
) -> Result<Vec<Shot>, ArtefactError> {
    let mut shots = of_boxes(weight, look)?;
    shots.extend(of_ball(weight, ball)?);
    shots.extend(of_torus(weight, torus)?);
    Ok(shots)
}

/// What is seen, and by which weights.
fn label(what: [&str; 2], weight: Weight) -> Text {
    let name = MEANS.iter().find(|(known, _)| *known == weight).map(|(_, name)| name);
    Text::each(|language| {
        let what = what[usize::from(language == Language::Portuguese)];
        let name = name.map_or(weight.name(), |name| name.get(language));
        format!("{what}, {name}")
    })
}

fn of_boxes(weight: Weight, look: &Look) -> Result<Vec<Shot>, ArtefactError> {
    let (one, other) = (cut(DVec3::ONE, 0, weight, look)?, cut(DVec3::ONE, CUTS - 1, weight, look)?);
    let between = map(one.size, &differences(&one, &other), FULL_LIGHT);
    Ok(vec![
        Shot::new(
            "cube-1",
            Role::Bad,
            label(["cube cut one way", "cubo cortado de um modo"], weight),
            Text::new(
                "The cube smoothed, its faces cut along one diagonal: some corners lean to one side.",
                "O cubo alisado, as faces cortadas por uma diagonal: alguns cantos se inclinam para um lado.",
            ),
            one,
        ),
        Shot::new(
            "cube-2",
            Role::Bad,
            label(["cut the other way", "cortado do outro modo"], weight),
            Text::new(
                "The same cube with all faces cut along the other diagonal: light and shadow are elsewhere.",
                "O mesmo cubo com todas as faces cortadas pela outra diagonal: luz e sombra estão em outro lugar.",
            ),
            other,
        ),
        Shot::new(
            "cube-difference",
            Role::Difference,
            Text::new("between both", "entre os dois"),
            Text::made(
                format!(
                    "How far both pictures differ: violet 0, yellow {FULL_LIGHT} of the full range and more."
                ),
                "Quanto as duas imagens diferem: violeta 0, amarelo 0,3 da faixa ou mais.".to_owned(),
            ),
            between,
        ),
        Shot::new(
            "cube-angle",
            Role::Cured,
            label(["cube", "cubo"], FLAT),
            Text::new(
                "Weights by the angle: every corner has the diagonal for its normal, however the faces are cut.",
                "Pesos pelo ângulo: cada canto tem a diagonal como normal, sejam como forem cortadas as faces.",
            ),
            cut(DVec3::ONE, 0, FLAT, look)?,
        ),
        Shot::new(
            "box-max",
            Role::Bad,
            label(["box", "caixa"], ROUND),
            Text::new(
                "The box of 1 × 1 × 10 with Max' weights: normals lean towards the small faces at the ends, 46.7° off, and the long faces look \
                 bent.",
                "A caixa de 1 × 1 × 10 com os pesos de Max: as normais se inclinam para as faces pequenas das pontas, com erro de 46,7°, e \
                 as faces longas parecem curvas.",
            ),
            cut(LONG, 0, ROUND, look)?,
        ),
        Shot::new(
            "box-angle",
            Role::Cured,
            label(["box", "caixa"], FLAT),
            Text::new(
                "The box with weights by the angle: each of the three faces at a corner counts alike.",
                "A caixa com pesos pelo ângulo: cada uma das três faces num canto conta igual.",
            ),
            cut(LONG, 0, FLAT, look)?,
        ),
    ])
}

fn of_ball(weight: Weight, ball: &Specimen) -> Result<Vec<Shot>, ArtefactError> {
    let of = ["slivers", "lascas"];
    Ok(vec![
        Shot::new(
            "slivers",
            Role::Bad,
            label(of, weight),
            Text::new(
                "A ball of which every other row of triangles is twelve times narrower: the rows show as bands, the highlight is torn.",
                "Uma bola em que uma fileira de triângulos sim, outra não, é doze vezes mais estreita: as fileiras aparecem como faixas, o \
                 brilho se rasga.",
            ),
            ball.picture(weight)?,
        ),
        Shot::new(
            "slivers-angle",
            Role::Bad,
            label(of, FLAT),
            Text::new(
                "Weights by the angle do not help here: a sliver between two vertices has as large an angle as a wide triangle.",
                "Pesos pelo ângulo não ajudam aqui: uma lasca entre dois vértices tem um ângulo tão grande quanto um triângulo largo.",
            ),
            ball.picture(FLAT)?,
        ),
        Shot::new(
            "slivers-max",
            Role::Cured,
            label(of, ROUND),
            Text::new(
                "Max' weights on the same triangles: exact at every vertex of a sphere, and round between them.",
                "Os pesos de Max nos mesmos triângulos: exatos em cada vértice de uma esfera, e redondos entre eles.",
            ),
            ball.picture(ROUND)?,
        ),
        error_map("slivers-error", of, ball, weight)?,
    ])
}

fn of_torus(weight: Weight, torus: &Specimen) -> Result<Vec<Shot>, ArtefactError> {
    let of = ["irregular torus", "toro irregular"];
    Ok(vec![
        Shot::new(
            "torus",
            Role::Bad,
            label(of, weight),
            Text::new(
                "A torus of triangles cut at random: the highlights are blotchy.",
                "Um toro de triângulos cortados ao acaso: os brilhos ficam manchados.",
            ),
            torus.picture(weight)?,
        ),
        Shot::new(
            "torus-max",
            Role::Cured,
            label(of, ROUND),
            Text::new("The same triangles with Max' weights.", "Os mesmos triângulos com os pesos de Max."),
            torus.picture(ROUND)?,
        ),
        error_map("torus-error", of, torus, weight)?,
        Shot::new(
            "torus-itself",
            Role::Truth,
            Text::new("the torus itself", "o próprio toro"),
            Text::new(
                "The torus with its own normal at every pixel.",
                "O toro com a sua própria normal em cada pixel.",
            ),
            torus.truth(Show::Shaded)?,
        ),
    ])
}

fn error_map(
    name: &'static str,
    [en, pt]: [&str; 2],
    specimen: &Specimen,
    weight: Weight,
) -> Result<Shot, ArtefactError> {
    let caption = Text::made(
        format!("The angle between interpolated and true normals: violet 0°, yellow {FULL_ANGLE}° and more."),
        format!(
            "O ângulo entre normais interpoladas e verdadeiras: violeta 0°, amarelo {FULL_ANGLE}° ou mais."
        ),
    );
    let label = Text::made(format!("{en}, error"), format!("{pt}, erro"));
    Ok(Shot::new(name, Role::Difference, label, caption, specimen.error_map(weight, FULL_ANGLE)?))
}

/// A box whose corners are smoothed.
fn cut(sides: DVec3, cut: u32, weight: Weight, look: &Look) -> Result<Image, ArtefactError> {
    let mesh = cut_box(sides, cut)?;
    let field = smooth(&mesh, weight);
    let object = object(&mesh, &field, chalk());
    let camera = camera(std::slice::from_ref(&object));
    let settings = settings([look.size; 2], Shading::Phong, Interpolation::Perspective);
    draw(vec![object], &[light_from(&camera, look.light)?], camera, &settings)
}
