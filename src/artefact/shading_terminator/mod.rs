//! The border of light on a coarse mesh.

mod tube;

use super::body::Body;
use super::stage::{chalk, differences, draw, front, linear, map, settings, tiles};
use super::{
    ArtefactError, Experiment, Formula, Knob, Measure, Moved, Outcome, Parameters, Setup, Shot, Text,
    Threshold, Verdict,
};
use crate::num::{Degrees, LinearRgb, Radians};
use crate::raster::{Image, Interpolation, Object, RenderSettings, Shading, Shape, Show};
use crate::shade::{Light, Terminator};
use crate::surface::{Primitive, Sphere};
use glam::DVec3;
use tube::Tube;

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "shading-terminator",
    title: Text::new("The shading terminator", "O terminador de sombreamento"),
    claim: Text::new(
        "Where interpolated normals still face the light and the facet itself does not, shading and geometry disagree. If facets \
         shade themselves, the border of light runs along their edges, and whole facets pop when the light moves.",
        "Onde as normais interpoladas ainda olham para a luz e a própria faceta já não, sombreamento e geometria discordam. Se as \
         facetas se sombreiam, a fronteira da luz corre pelas arestas, e facetas inteiras saltam quando a luz se move.",
    ),
    sources: &[
        Text::new(
            "Paper: M. J.-Y. Chiang, Y. K. Li, B. Burley, Taming the shadow terminator, SIGGRAPH 2019 Talks",
            "Artigo: M. J.-Y. Chiang, Y. K. Li, B. Burley, Taming the shadow terminator, SIGGRAPH 2019 Talks",
        ),
        Text::new(
            "Lectures: 1.5.2.2, 1.6.13 (errors of vertex normals that Phong's shading keeps)",
            "Aulas: 1.5.2.2, 1.6.13 (erros das normais nos vértices que o sombreamento de Phong mantém)",
        ),
    ],
    formulas: &[
        Formula {
            notation: Text::same("N·L > 0 ≥ N_g·L"),
            says: Text::new(
                "the pixels concerned: N interpolated, N_g that of the facet",
                "os pixels em questão: N interpolada, N_g a da faceta",
            ),
        },
        Formula {
            notation: Text::same("G = −g^3 + g^2 + g, \\quad g = \\frac{N_g·L}{(N·L) (N_g·N)}"),
            says: Text::new(
                "Chiang, Li and Burley's factor for 0 ≤ g < 1, 0 below and 1 from 1 on: light goes out gradually as the facet turns away",
                "o fator de Chiang, Li e Burley para 0 ≤ g < 1, 0 abaixo e 1 a partir de 1: a luz se apaga aos poucos quando a faceta \
                 se vira",
            ),
        },
        Formula {
            notation: Text::same("ΔI = sin(Δ/2)"),
            says: Text::new(
                "how much a facet of the angle Δ lights up at once without it, at its bright edge",
                "quanto uma faceta de ângulo Δ acende de uma vez sem ele, na aresta clara",
            ),
        },
    ],
    takes: &[Knob::Size, Knob::Segments, Knob::Light],
    own_mesh: None,
    // More, and four times as many in the cured picture, would be hardly larger than pixels.
    segments: 3..=256,
    shown_by: Text::new(
        "light from the side (--light 80), on no more than 16 segments, would show it.",
        "luz de lado (--light 80), em não mais que 16 segmentos, o mostraria.",
    ),
    defaults: Parameters { segments: 16, light: Degrees(80.0), ..Parameters::USUAL },
    run,
    frame: Some(frame),
};

/// The window's side; prism and sphere have the radius 1.
const WINDOW: f64 = 2.2;
/// How high the light stands over the sphere, so that its border crosses facets askew.
const HEIGHT: Degrees = Degrees(25.0);
/// No height at all: light at right angles to the prism.
const LEVEL: Degrees = Degrees(0.0);
/// Segments of the finest sphere: so many that its teeth are hardly larger than pixels, and four times as many at least.
fn finest(segments: u32) -> u32 {
    (16 * segments).min(256).max(4 * segments)
}

fn run(setup: &Setup) -> Result<Outcome, ArtefactError> {
    let Parameters { size, segments, light, .. } = setup.parameters;
    let tube = Tube { segments, size };
    let globe = |segments, terminator| globe(segments, light, terminator, size);
    let hard = globe(segments, Terminator::Hard)?;
    let soft = globe(segments, Terminator::Soft)?;
    let smooth = globe(segments, Terminator::Smooth)?;
    let [finer, finer_smooth] =
        [Terminator::Soft, Terminator::Smooth].map(|terminator| globe(finest(segments), terminator));
    let (finer, finer_smooth) = (finer?, finer_smooth?);
    let concerned_globe = |segments| concerned(&Body::globe(segments, 0.0), towards(light, HEIGHT), size);
    let (coarse_map, fine_map) = (concerned_globe(segments)?, concerned_globe(finest(segments))?);
    let on_tube = share(&concerned(&tube.body(), towards(light, LEVEL), size)?);
    let [pop_hard, pop_soft] = [Terminator::Hard, Terminator::Soft].map(|terminator| tube.pop(terminator));
    let (pop_hard, pop_soft) = (pop_hard?, pop_soft?);
    let turn = [tube.turn().0];
    let taken = |by: &Image, of: &Image| differences(by, of).into_iter().flatten().fold(0.0, f64::max);
    let sphere = Object::new(Shape::Surface(Primitive::from(Sphere::default())), chalk());
    let truth = picture(sphere, towards(light, HEIGHT), (Shading::Exact, Terminator::Smooth), [size; 2])?;
    let off = |image: &Image| mean_where(&coarse_map, &differences(image, &truth));
    let self_shadow = Moved {
        name: Text::new(
            "mean error of light against the sphere itself, on the pixels concerned",
            "erro médio da luz em relação à própria esfera, nos pixels em questão",
        ),
        unit: "",
        bad: off(&hard),
        present: Threshold::HALF_STEP,
        cure: Text::new("no shadow of their own", "nenhuma sombra própria"),
        cured: off(&smooth),
        factor: 10.0,
    };
    let price = Moved {
        name: Text::new(
            "most light that the softening takes from a pixel",
            "máximo de luz que a suavização tira de um pixel",
        ),
        bad: taken(&soft, &smooth),
        cure: Text::new("finer facets", "facetas mais finas"),
        cured: taken(&finer, &finer_smooth),
        // Of a quarter the teeth are still seen.
        factor: 10.0,
        ..self_shadow.clone()
    };
    let popping = Moved {
        name: Text::with(
            "prism: largest change on a facet when the light turns by {}°",
            "prisma: maior mudança numa faceta quando a luz gira {}°",
            &turn,
        ),
        bad: pop_hard,
        cure: Text::new(
            "Chiang, Li and Burley's softening term",
            "o termo de suavização de Chiang, Li e Burley",
        ),
        cured: pop_soft,
        ..self_shadow.clone()
    };
    let (share_law, share_open) = tube.share_law(light);
    let by_formula = Text::new(
        "the formula at every pixel's centre in double precision; edges snap to 1/256 pixel",
        "a fórmula no centro de cada pixel em precisão dupla; arestas ajustadas a 1/256 pixel",
    );
    let measures = vec![
        Measure::new(
            Text::new("prism: share of pixels concerned", "prisma: parcela dos pixels em questão"),
            "",
            on_tube,
        )
        .expect(
            share_law,
            share_open,
            Text::new(
                "the two cosines at every pixel's centre in double precision; pixels with an edge or a change of sign within 1/256 pixel",
                "os dois cossenos no centro de cada pixel em precisão dupla; pixels com aresta ou mudança de sinal a menos de 1/256 pixel",
            ),
        ),
        Measure::new(
            Text::new("sphere: share of pixels concerned", "esfera: parcela dos pixels em questão"),
            "",
            share(&coarse_map),
        ),
        Measure::new(
            Text::made(
                format!("sphere with {} segments: share of pixels concerned", finest(segments)),
                format!("esfera com {} segmentos: parcela dos pixels em questão", finest(segments)),
            ),
            "",
            share(&fine_map),
        ),
        Measure::new(
            Text::new(
                "sphere: most light that facets' own shadow takes from a pixel",
                "esfera: máximo de luz que a sombra própria das facetas tira de um pixel",
            ),
            "",
            taken(&hard, &smooth),
        ),
        Measure::new(
            Text::with(
                "prism, light turned by {}°: largest change on a facet, hard",
                "prisma, luz girada de {}°: maior mudança numa faceta, dura",
                &turn,
            ),
            "",
            pop_hard,
        )
        .expect(tube.pop_law(Terminator::Hard), 2e-3, by_formula.clone()),
        Measure::new(
            Text::with(
                "prism, light turned by {}°: largest change on a facet, softened",
                "prisma, luz girada de {}°: maior mudança numa faceta, suavizada",
                &turn,
            ),
            "",
            pop_soft,
        )
        .expect(tube.pop_law(Terminator::Soft), 2e-4, by_formula),
    ];
    let difference = map([size; 2], &coarse_map, 1.0);
    // The prism has a light of its own. What it does there is seen on the sphere only if facets of that take light away in this.
    let verdict = match self_shadow.is_present() {
        false => Verdict::Absent(EXPERIMENT.shown_by.clone()),
        true => Verdict::HoldsOnlyIf(Text::new(
            "facets shade themselves, as they do where shadows are cast. Without shadows, as in the lectures, light on facets that \
             face away is no fault that is seen. The softening term takes away the popping, not the corners of the border, \
             and darkens facets that are lit askew: both go with finer meshes, as their facets' size.",
            "as facetas se sombreiam, como fazem onde há sombras projetadas. Sem sombras, como nas aulas, a luz em facetas viradas \
             não é defeito visível. O termo de suavização tira os saltos, não os cantos da fronteira, e escurece facetas \
             iluminadas de lado: ambos somem com malhas mais finas, com o tamanho das facetas.",
        )),
    };
    let Degrees(step) = tube.step();
    Ok(Outcome {
        verdict,
        measures,
        shots: vec![
            self_shadow.bad_shot(
                "hard",
                Text::new("facets shade themselves", "facetas se sombreiam"),
                [
                    Text::new(
                        "Smooth normals, but light ends where facets turn away.",
                        "Normais lisas, mas a luz termina onde as facetas se viram.",
                    ),
                    Text::new("The border is a saw of triangles.", "A fronteira é um serrote de triângulos."),
                ],
                hard,
            ),
            self_shadow.cured_shot(
                "smooth",
                Text::new("no shadow of their own", "sem sombra própria"),
                [
                    Text::new(
                        "Interpolated normals alone decide, as in the lectures.",
                        "Só as normais interpoladas decidem, como nas aulas.",
                    ),
                    Text::new(
                        "Smooth, with light on facets that face away.",
                        "Liso, com luz em facetas viradas para longe.",
                    ),
                ],
                smooth,
            ),
            Shot::difference(
                "concerned",
                Text::new("pixels concerned", "pixels em questão"),
                Text::new(
                    "Yellow where the interpolated normal faces the light and the facet does not.",
                    "Amarelo onde a normal interpolada olha para a luz e a faceta não.",
                ),
                difference,
            ),
            popping.bad_shot(
                "film-hard",
                Text::new("the light turns: it pops", "a luz gira: salta"),
                [
                    Text::with(
                        "A prism from picture to picture, downwards: the light turns by {}° each time.",
                        "Um prisma de imagem em imagem, para baixo: a luz gira {}° de cada vez.",
                        &[step],
                    ),
                    Text::new(
                        "The facet left of the middle has light in the upper four and is black in the lower four: it goes out at once.",
                        "A faceta à esquerda do meio tem luz nas quatro de cima e é preta nas quatro de baixo: apaga-se de uma vez.",
                    ),
                ],
                tube.film(Terminator::Hard)?,
            ),
            popping.cured_shot(
                "film-soft",
                Text::new("softened: it fades", "suavizado: esmaece"),
                [
                    Text::new("The same with the softening term.", "O mesmo com o termo de suavização."),
                    Text::new(
                        "That facet gets darker from picture to picture, and nothing pops.",
                        "A faceta escurece de imagem em imagem, e nada salta.",
                    ),
                ],
                tube.film(Terminator::Soft)?,
            ),
            price.bad_shot(
                "soft",
                Text::new("softened, as coarse", "suavizado, mesma malha"),
                [
                    Text::new("What the softening term costs.", "O que custa o termo de suavização."),
                    Text::new(
                        "Facets that are about to turn away are dim already, and show even in the light. A still picture is none the better \
                         for it.",
                        "Facetas que estão para se virar já são escuras, e aparecem até na luz. Uma imagem parada nada ganha com ele.",
                    ),
                ],
                soft,
            ),
            price.cured_shot(
                "soft-fine",
                Text::new("softened, finer", "suavizado, mais fino"),
                [
                    Text::made(
                        format!("{} segments and the softening term.", finest(segments)),
                        format!("{} segmentos e o termo de suavização.", finest(segments)),
                    ),
                    Text::new(
                        "Facets are hardly larger than pixels, and the border is smooth.",
                        "As facetas quase não são maiores que pixels, e a fronteira é lisa.",
                    ),
                ],
                finer,
            ),
        ],
        moved: popping,
        charts: vec![tube.chart()?],
        notes: notes(light),
    })
}

fn notes(light: Degrees) -> Vec<Text> {
    vec![
        Text::new(
            "The factor is continuous: it is 0 where the facet's own cosine N_g·L is, and 1 where that is at least (N·L) (N_g·N). It \
             needs nothing but the two normals.",
            "O fator é contínuo: vale 0 onde o cosseno da própria faceta, N_g·L, é 0, e 1 onde este é ao menos (N·L) (N_g·N). \
             Precisa só das duas normais.",
        ),
        Text::with(
            "There are three lights. The sphere's comes from {}° to the side of the viewer and 25° up, so that its border crosses \
             facets askew. The one in which pixels of the prism are counted comes from {}° too, but level: where the prism's border \
             is out of sight it concerns none. That of the films is level and turns about the angle at which the facet left of the \
             middle turns away.",
            "Há três luzes. A da esfera vem de {}° ao lado do observador e 25° acima, de modo que a sua fronteira cruza facetas de \
             viés. Aquela em que se contam pixels do prisma vem também de {}°, mas horizontal: quando a fronteira do prisma não se \
             vê, nenhum está em questão. A dos filmes é horizontal e gira em torno do ângulo em que a faceta à esquerda do meio se \
             vira.",
            &[light.0, light.0],
        ),
    ]
}

/// The sphere while the light goes round it: at the left facets shade themselves, at the right that is softened.
fn frame(setup: &Setup, number: u32, count: u32) -> Result<Image, ArtefactError> {
    let Parameters { size, segments, .. } = setup.parameters;
    let light = Degrees(360.0 * f64::from(number) / f64::from(count.max(1)));
    let globe = |terminator| globe(segments, light, terminator, size);
    Ok(tiles(&[vec![globe(Terminator::Hard)?, globe(Terminator::Soft)?]]))
}

fn globe(segments: u32, light: Degrees, terminator: Terminator, size: u32) -> Result<Image, ArtefactError> {
    paint(&Body::globe(segments, 0.0), towards(light, HEIGHT), terminator, [size; 2])
}

/// The direction of a light at an angle from the viewer to the right, raised by another.
fn towards(light: Degrees, height: Degrees) -> DVec3 {
    let (sine, cosine) = libm::sincos(Radians::from(light).0);
    let (up, along) = libm::sincos(Radians::from(height).0);
    DVec3::new(sine * along, up, cosine * along)
}

fn paint(
    body: &Body,
    towards: DVec3,
    terminator: Terminator,
    size: [u32; 2],
) -> Result<Image, ArtefactError> {
    picture(body.object(chalk()), towards, (Shading::Phong, terminator), size)
}

fn picture(
    object: Object,
    towards: DVec3,
    (shading, terminator): (Shading, Terminator),
    size: [u32; 2],
) -> Result<Image, ArtefactError> {
    let settings = RenderSettings { terminator, ..settings(size, shading, Interpolation::Perspective) };
    let height = WINDOW * f64::from(size[1]) / f64::from(size[0]);
    let light = Light::Directional { towards, colour: LinearRgb::WHITE };
    draw(vec![object], &[light], front(height), &settings)
}

/// 1 for pixels whose normal faces the light and whose facet does not, 0 for others.
fn concerned(body: &Body, towards: DVec3, size: u32) -> Result<Vec<Option<f64>>, ArtefactError> {
    let normals = |shading| {
        let settings = RenderSettings {
            show: Show::Normals,
            ..settings([size; 2], shading, Interpolation::Perspective)
        };
        draw(vec![body.object(chalk())], &[], front(WINDOW), &settings)
    };
    let light_on = |colour: &[f32; 3]| (DVec3::from(colour.map(f64::from)) * 2.0 - 1.0).dot(towards);
    let (smooth, faces) = (normals(Shading::Phong)?, normals(Shading::Flat)?);
    let pairs = linear(&smooth).iter().zip(linear(&faces)).zip(&smooth.coverage);
    let is_concerned = |((own, face), &covered): ((&[f32; 3], &[f32; 3]), &u8)| {
        (covered > 0).then(|| f64::from(u8::from(light_on(own) > 0.0 && light_on(face) <= 0.0)))
    };
    Ok(pairs.map(is_concerned).collect())
}

/// The share of ones.
fn share(map: &[Option<f64>]) -> f64 {
    let covered: Vec<f64> = map.iter().flatten().copied().collect();
    covered.iter().sum::<f64>() / covered.len().max(1) as f64
}

/// The mean of values on pixels that a map has 1 for; 0 if there are none.
fn mean_where(map: &[Option<f64>], values: &[Option<f64>]) -> f64 {
    let is_meant = |(&mark, &value): (&Option<f64>, &Option<f64>)| value.filter(|_| mark == Some(1.0));
    let meant: Vec<f64> = map.iter().zip(values).filter_map(is_meant).collect();
    meant.iter().sum::<f64>() / meant.len().max(1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn facets_pop_and_fade() {
        for (segments, light) in [(16, 80.0), (12, 80.0)] {
            let parameters = Parameters { size: 200, segments, light: Degrees(light), ..EXPERIMENT.defaults };
            let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
            outcome.prove();
            // Present: close to sin(Δ/2). Cured: of the size of the turn, ten times less.
            let sine = libm::sin(0.5 * TAU / f64::from(segments));
            assert!(
                outcome.moved.bad > 0.9 * sine && outcome.moved.reduction() > 10.0,
                "{:?}",
                outcome.moved
            );
            // Finer meshes have fewer pixels concerned, in proportion.
            let [coarse, fine] = [1, 2].map(|k| outcome.measures[k].value);
            assert!(coarse > 0.005 && fine < 0.5 * coarse, "{coarse} {fine}");
        }
    }

    /// With the light from the viewer's side no pixel of the prism is concerned; the sphere says whether anything is seen.
    #[test]
    fn what_is_claimed_is_seen_on_the_sphere() {
        for (segments, is_seen) in [(16, true), (64, false)] {
            let parameters = Parameters { size: 32, segments, light: Degrees(0.0), ..EXPERIMENT.defaults };
            let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
            assert_eq!(outcome.measured("prism: share"), 0.0);
            let taken = outcome.measured("sphere: most light");
            assert_eq!(taken > Threshold::HALF_STEP.value, is_seen, "{segments}: {taken}");
            assert_eq!(matches!(outcome.verdict, Verdict::Absent(_)), !is_seen, "{segments}");
        }
    }
}
