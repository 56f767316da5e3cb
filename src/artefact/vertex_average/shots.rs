//! The pictures, with what there is to see in them.

use super::super::own_mesh::{camera, light_from};
use super::super::stage::{chalk, differences, draw, map, object, settings, smooth};
use super::super::{ArtefactError, Language, Moved, Shot, Text};
use super::cuts::{CUTS, cut_box};
use super::specimen::{Look, Specimen};
use super::{FLAT, LONG, ROUND, Shown, name_of};
use crate::normals::Weight;
use crate::raster::{Image, Interpolation, Shading, Show};
use glam::DVec3;

/// Full scale of the maps: of light, and of angles in degrees.
const FULL_LIGHT: f64 = 0.3;
const FULL_ANGLE: f64 = 5.0;

pub(super) fn all(
    weight: Weight,
    look: &Look,
    [torus, ball]: [&Specimen; 2],
    shown: &Shown,
) -> Result<Vec<Shot>, ArtefactError> {
    // The ball first: of these pictures the index shows the first of each kind, and bands are plain even when they are small.
    let mut shots = of_ball(weight, ball, shown)?;
    shots.extend(of_boxes(weight, look, shown)?);
    shots.extend(of_torus(weight, torus, &shown.torus)?);
    Ok(shots)
}

/// What is seen, and by which weights.
fn label(what: [&str; 2], weight: Weight) -> Text {
    Text::each(|language| {
        let what = what[usize::from(language == Language::Portuguese)];
        format!("{what}, {}", name_of(weight, language))
    })
}

fn of_boxes(weight: Weight, look: &Look, shown: &Shown) -> Result<Vec<Shot>, ArtefactError> {
    let Shown { cube, long, .. } = shown;
    let (one, other) = (cut(DVec3::ONE, 0, weight, look)?, cut(DVec3::ONE, CUTS - 1, weight, look)?);
    let between = map(one.size, &differences(&one, &other), FULL_LIGHT);
    Ok(vec![
        cube.bad_shot(
            "cube-1",
            label(["cube cut one way", "cubo cortado de um modo"], weight),
            [
                Text::new(
                    "The cube smoothed, its faces cut along one diagonal.",
                    "O cubo alisado, as faces cortadas por uma diagonal.",
                ),
                Text::new("Some corners lean to one side.", "Alguns cantos se inclinam para um lado."),
            ],
            one,
        ),
        cube.bad_shot(
            "cube-2",
            label(["cut the other way", "cortado do outro modo"], weight),
            [
                Text::new(
                    "The same cube with all faces cut along the other diagonal.",
                    "O mesmo cubo com todas as faces cortadas pela outra diagonal.",
                ),
                Text::new("Light and shadow are elsewhere.", "Luz e sombra estão em outro lugar."),
            ],
            other,
        ),
        Shot::difference(
            "cube-difference",
            Text::new("between both", "entre os dois"),
            Text::with(
                "How far both pictures differ: violet 0, yellow {} of the full range and more.",
                "Quanto as duas imagens diferem: violeta 0, amarelo {} da faixa ou mais.",
                &[FULL_LIGHT],
            ),
            between,
        ),
        cube.cured_shot(
            "cube-angle",
            label(["cube", "cubo"], FLAT),
            [
                Text::new("Weights by the angle.", "Pesos pelo ângulo."),
                Text::new(
                    "Every corner has the diagonal for its normal, however the faces are cut.",
                    "Cada canto tem a diagonal como normal, como quer que as faces sejam cortadas.",
                ),
            ],
            cut(DVec3::ONE, 0, FLAT, look)?,
        ),
        long.bad_shot(
            "box-max",
            label(["box", "caixa"], ROUND),
            [
                Text::new("The box of 1 × 1 × 10 with Max's weights.", "A caixa de 1 × 1 × 10 com os pesos de Max."),
                Text::new(
                    "Normals lean towards the small faces at the ends, and the long faces look bent.",
                    "As normais se inclinam para as faces pequenas das pontas, e as faces longas parecem curvas.",
                ),
            ],
            cut(LONG, 0, ROUND, look)?,
        ),
        long.cured_shot(
            "box-angle",
            label(["box", "caixa"], FLAT),
            [
                Text::new("The box with weights by the angle.", "A caixa com pesos pelo ângulo."),
                Text::new(
                    "Each of the three faces at a corner counts alike.",
                    "Cada uma das três faces num canto conta igual.",
                ),
            ],
            cut(LONG, 0, FLAT, look)?,
        ),
    ])
}

fn of_ball(weight: Weight, ball: &Specimen, shown: &Shown) -> Result<Vec<Shot>, ArtefactError> {
    let of = ["slivers", "lascas"];
    let slivers = &shown.slivers;
    let by_angle = Moved { bad: shown.slivers_by_angle, ..slivers.clone() };
    Ok(vec![
        slivers.bad_shot(
            "slivers",
            label(of, weight),
            [
                Text::new(
                    "A ball of which every other row of triangles is twelve times narrower.",
                    "Uma bola em que uma fileira de triângulos sim, outra não, é doze vezes mais estreita.",
                ),
                Text::new("The rows show as bands in the light.", "As fileiras aparecem como faixas na luz."),
            ],
            ball.picture(weight)?,
        ),
        by_angle.bad_shot(
            "slivers-angle",
            label(of, FLAT),
            [
                Text::new("Weights by the angle do not help here.", "Pesos pelo ângulo não ajudam aqui."),
                Text::new(
                    "A sliver between two vertices has as large an angle as a wide triangle.",
                    "Uma lasca entre dois vértices tem um ângulo tão grande quanto um triângulo largo.",
                ),
            ],
            ball.picture(FLAT)?,
        ),
        by_angle.cured_shot(
            "slivers-max",
            label(of, ROUND),
            [
                Text::new("Max's weights on the same triangles.", "Os pesos de Max nos mesmos triângulos."),
                Text::new(
                    "They are exact at every vertex of a sphere, and round between them.",
                    "São exatos em cada vértice de uma esfera, e redondos entre eles.",
                ),
            ],
            ball.picture(ROUND)?,
        ),
        error_map("slivers-error", of, ball, weight)?,
    ])
}

fn of_torus(weight: Weight, torus: &Specimen, moved: &Moved) -> Result<Vec<Shot>, ArtefactError> {
    let of = ["irregular torus", "toro irregular"];
    Ok(vec![
        moved.bad_shot(
            "torus",
            label(of, weight),
            [
                Text::new("A torus of triangles cut at random.", "Um toro de triângulos cortados ao acaso."),
                Text::new("The light is uneven.", "A luz é irregular."),
            ],
            torus.picture(weight)?,
        ),
        moved.cured_shot(
            "torus-max",
            label(of, ROUND),
            [
                Text::new(
                    "The same triangles with Max's weights.",
                    "Os mesmos triângulos com os pesos de Max.",
                ),
                Text::new("The light is more even.", "A luz é mais regular."),
            ],
            torus.picture(ROUND)?,
        ),
        error_map("torus-error", of, torus, weight)?,
        Shot::truth(
            "torus-itself",
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
    let label = label([&format!("{en}, error"), &format!("{pt}, erro")], weight);
    Ok(Shot::difference(name, label, caption, specimen.error_map(weight, FULL_ANGLE)?))
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
