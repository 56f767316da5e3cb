//! Edges that are meant to be sharp, smoothed away by averaged normals.

mod bodies;
mod own;
mod shots;
mod subject;

use super::own_mesh::{camera, light_from};
use super::stage::{front, light_at, object};
use super::{
    ArtefactError, Chart, Curve, Drawn, Experiment, Formula, Knob, Language, Measure, Moved, Outcome,
    Parameters, Scale, Setup, Text, Threshold, Verdict,
};
use crate::normals::{Crease, NormalRecipe, Weight, compute};
use crate::num::{Degrees, Radians};
use crate::raster::Camera;
use glam::DVec3;
use subject::Subject;

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "false-smoothing",
    title: Text::new("False smoothing", "Falso alisamento"),
    claim: Text::new(
        "Normals at vertices are means of those of the faces, so edges that are meant to be sharp are smoothed as well: in the \
         worst case all means are parallel, and a zig-zag looks flat. Gouraud's and Phong's shading share the fault.",
        "As normais nos vértices são médias das normais das faces, e também são alisadas as arestas que deviam ser vivas: no pior \
         caso todas as médias são paralelas, e um zigue-zague parece plano. Os sombreamentos de Gouraud e de Phong partilham o defeito.",
    ),
    sources: &[
        Text::new(
            "Lectures: 1.6.4 (figure 41), 1.6.13 (figure 44), 1.6.15, 1.6.47",
            "Aulas: 1.6.4 (figura 41), 1.6.13 (figura 44), 1.6.15, 1.6.47",
        ),
        Text::new(
            "The lectures' cure is not to interpolate at all; splitting vertices where edges are sharp is the one used since",
            "A cura das aulas é não interpolar; separar os vértices onde as arestas são vivas é a que se usa desde então",
        ),
    ],
    formulas: &[
        Formula {
            notation: Text::new(
                "δ_{cube} = arctan(\\sqrt{2}) = 54.7356°",
                "δ_{cubo} = arctan(\\sqrt{2}) = 54,7356°",
            ),
            says: Text::new(
                "the angle between a face of the cube and the mean of the three faces at its corner",
                "o ângulo entre uma face do cubo e a média das três faces no seu vértice",
            ),
        },
        Formula {
            notation: Text::new(
                "δ_{zigzag} = s, \\quad δ_{roof} = s/2",
                "δ_{zigue} = s, \\quad δ_{telhado} = s/2",
            ),
            says: Text::new(
                "for strips that lean by s to either side, and for strips of which every other leans by s",
                "para faixas inclinadas de s para um lado e para o outro, e para faixas das quais uma sim, outra não, se inclina de s",
            ),
        },
        Formula {
            notation: Text::new(
                "I_{faces} = cos(s), \\quad I_{mean} = 1",
                "I_{faces} = cos(s), \\quad I_{média} = 1",
            ),
            says: Text::new(
                "the zig-zag in light from the front, lit by its faces' normals as it is, and by their means as it is shown",
                "o zigue-zague sob luz frontal, iluminado pelas normais das faces como é, e pelas suas médias como aparece",
            ),
        },
    ],
    takes: &[Knob::Size, Knob::Light, Knob::Weight, Knob::Crease, Knob::Mesh],
    own_mesh: Some(Text::new(
        "its normals averaged over every edge, and not over creases",
        "as suas normais médias sobre todas as arestas, e não sobre os vincos",
    )),
    segments: Parameters::SEGMENTS,
    shown_by: Text::new(
        "faces that meet at more than the crease angle, in light from the viewer's side, would show it.",
        "faces que se encontram com mais que o ângulo de vinco, sob luz do lado do observador, o mostrariam.",
    ),
    defaults: Parameters { light: Degrees(35.0), ..Parameters::USUAL },
    run,
    frame: None,
};

/// How much the strips of the zig-zag and of the roof lean.
const SLOPE: Degrees = Degrees(45.0);
/// Full scale of the maps of angles, in degrees, and of light.
const FULL_ANGLE: f64 = 60.0;
const FULL_LIGHT: f64 = 0.5;

fn run(setup: &Setup) -> Result<Outcome, ArtefactError> {
    match &setup.mesh {
        None => of_bodies(&setup.parameters),
        Some(own) => own::run(own, &setup.parameters),
    }
}

fn of_bodies(parameters: &Parameters) -> Result<Outcome, ArtefactError> {
    let &Parameters { size, light, weight, crease, .. } = parameters;
    let solid = |mesh| {
        let field = compute(&mesh, &NormalRecipe::default());
        let camera = camera(&[object(&mesh, &field, subject::material())]);
        Ok::<_, ArtefactError>(Subject { light: light_from(&camera, light)?, mesh, camera, size })
    };
    let sheet = |leans: &[Degrees], light| {
        // Wider than the window, which no end is seen in.
        let mesh = bodies::folded(leans, 32)?;
        Ok::<_, ArtefactError>(Subject { mesh, camera: from_above(), light: light_at(light), size })
    };
    let (cube, gear) = (solid(bodies::cube()?)?, solid(bodies::gear()?)?);
    let folds = [SLOPE, Degrees(-SLOPE.0)];
    let zigzag = sheet(&folds, light)?;
    let zigzag_in_front = sheet(&folds, Degrees(0.0))?;
    let roof = sheet(&[SLOPE, Degrees(0.0), Degrees(-SLOPE.0), Degrees(0.0)], light)?;

    let splits = Crease::Angle(crease);
    let both = |subject: &Subject| {
        Ok::<_, ArtefactError>([subject.case(weight, Crease::OFF)?, subject.case(weight, splits)?])
    };
    let [cube_smooth, cube_sharp] = both(&cube)?;
    let [gear_smooth, gear_sharp] = both(&gear)?;
    let [zigzag_smooth, zigzag_sharp] = both(&zigzag)?;
    let [roof_smooth, roof_sharp] = both(&roof)?;
    let [front_smooth, front_sharp] = both(&zigzag_in_front)?;
    let right_angle = Degrees(90.0);
    // Corners at the sheets' ends, out of sight, have one face only.
    let bends = [
        (Text::new("cube", "cubo"), cube_smooth.largest(), cube_sharp.largest(), CUBE, right_angle),
        (
            Text::new("zig-zag", "zigue-zague"),
            zigzag_smooth.largest(),
            zigzag_sharp.largest(),
            SLOPE.0,
            right_angle,
        ),
        (Text::new("roof", "telhado"), roof_smooth.largest(), roof_sharp.largest(), 0.5 * SLOPE.0, SLOPE),
    ];
    let mut measures = Vec::new();
    for (of, smooth, sharp, law, edge) in bends {
        measures.extend(angles(&of, [smooth, sharp], law, parameters, edge));
    }
    measures.extend([
        brightness(
            Text::new(
                "zig-zag, light from the front, averaged: luminance",
                "zigue-zague, luz frontal, média: luminância",
            ),
            front_smooth.middle(),
            1.0,
        ),
        brightness(
            Text::new(
                "zig-zag, light from the front, as it is: luminance",
                "zigue-zague, luz frontal, como é: luminância",
            ),
            front_sharp.true_middle(),
            libm::cos(Radians::from(SLOPE).0),
        ),
        share(
            Text::with(
                "gear: share of corners whose averaged normal is more than {}° off its face",
                "engrenagem: parcela dos cantos cuja normal média está a mais de {}° da sua face",
                &[crease.0],
            ),
            gear_smooth.share_over(crease),
        ),
        bore(gear_sharp.largest(), parameters),
        Measure::new(
            Text::new(
                "gear, averaged: mean error of the pixels' normals",
                "engrenagem, média: erro médio das normais dos pixels",
            ),
            "°",
            gear_smooth.deviation.mean,
        ),
        Measure::new(
            Text::new(
                "gear, split: mean error of the pixels' normals",
                "engrenagem, separada: erro médio das normais dos pixels",
            ),
            "°",
            gear_sharp.deviation.mean,
        ),
    ]);
    let moved = Moved {
        name: Text::new(
            "gear: mean error of the pixels' normals",
            "engrenagem: erro médio das normais dos pixels",
        ),
        unit: "°",
        bad: gear_smooth.deviation.mean,
        present: Threshold::HALF_STEP_OF_TILT,
        cure: match separates_gear(parameters) {
            true => Text::each(|language| {
                let left = Text::new(
                    "what is left is the bore, smoothed on purpose",
                    "o que resta é o furo, alisado de propósito",
                );
                format!("{}; {}", cure(crease).get(language), left.get(language))
            }),
            false => cure(crease),
        },
        cured: gear_sharp.deviation.mean,
        factor: 100.0,
    };
    Ok(Outcome {
        verdict: Verdict::Holds(Text::new(
            "wherever faces that share a vertex are not meant as one smooth surface. Where they are, the same means are right, so \
             no rule without a crease angle, marks or groups can serve both. Finer faces make the smeared strip beside a sharp edge narrower, and leave the normals on the \
             edge as wrong as they were.",
            "sempre que faces que partilham um vértice não representam uma só superfície lisa. Onde representam, as mesmas médias \
             estão certas, e nenhuma regra sem ângulo de vinco, marcas ou grupos serve a ambas. Faces mais finas estreitam a \
             faixa borrada ao lado de uma aresta viva, e deixam as normais na aresta tão erradas quanto antes.",
        )),
        charts: vec![chart(&gear, weight)?],
        shots: shots::all(
            &moved,
            separates_gear(parameters),
            [
                [cube_smooth, cube_sharp],
                [gear_smooth, gear_sharp],
                [roof_smooth, roof_sharp],
                [zigzag_smooth, zigzag_sharp],
            ],
        ),
        moved,
        measures,
        notes: notes(),
    })
}

/// A parallel view of a sheet at which its profile is seen at both of its ends.
fn from_above() -> Camera {
    Camera { eye: DVec3::new(0.0, 70.0, 100.0), ..front(6.0) }
}

fn notes() -> Vec<Text> {
    vec![
        Text::new(
            "On the zig-zag every vertex has one face that leans to the left and one that leans as much to the right, so that every \
             mean is straight up. Whatever the light, whatever the model of reflection, it looks like a flat sheet.",
            "No zigue-zague cada vértice tem uma face inclinada para a esquerda e outra igualmente inclinada para a direita, e toda \
             média aponta reto para a frente. Seja qual for a luz ou o modelo de reflexão, ele parece uma chapa plana.",
        ),
        Text::new(
            "Splitting gives each side of a sharp edge a normal of its own. The crease angle has to lie between the bends that are \
             meant and those that only stand for something round, as along the gear's bore: the plot shows that plateau.",
            "A separação dá a cada lado de uma aresta viva a sua própria normal. O ângulo de vinco tem de ficar entre as dobras \
             que são reais e as que só representam algo redondo, como no furo da engrenagem: o gráfico mostra esse patamar.",
        ),
    ]
}

/// The angle at the cube's corners: arctan √2.
const CUBE: f64 = 54.735_610_317_245_346;

/// The largest angle between a corner's normal and its face, averaged and split, with the law of the averaged one and the angle
/// of the edges.
fn angles(
    of: &Text,
    [smooth, sharp]: [f64; 2],
    law: f64,
    parameters: &Parameters,
    edge: Degrees,
) -> Vec<Measure> {
    let &Parameters { weight, crease, .. } = parameters;
    let name = |what: [&'static str; 2]| {
        Text::each(|language| {
            let [en, pt] = what;
            let what = Text::new(en, pt);
            format!("{}, {}", of.get(language), what.get(language))
        })
    };
    let averaged = Measure::new(
        name([
            "averaged: largest angle of a corner's normal to its face",
            "média: maior ângulo da normal de um canto com a sua face",
        ]),
        "°",
        smooth,
    );
    let split = Measure::new(
        name([
            "split: largest angle of a corner's normal to its face",
            "separado: maior ângulo da normal de um canto com a sua face",
        ]),
        "°",
        sharp,
    );
    // A quadric through vertices of a bend is no mean of its faces.
    if weight == Weight::Quadric {
        return vec![averaged, split];
    }
    let is_split = crease.0 < edge.0 - 0.1;
    let by = |en, pt| Text::new(en, pt);
    vec![
        averaged.expect(
            law,
            1e-9,
            by(
                "the angle between the mean and a face; a few roundings",
                "o ângulo entre a média e uma face; poucos arredondamentos",
            ),
        ),
        split.expect(
            if is_split { 0.0 } else { law },
            1e-9,
            by(
                "0 where the crease angle is less than that of the edge",
                "0 onde o ângulo de vinco é menor que o da aresta",
            ),
        ),
    ]
}

fn brightness(name: Text, found: f64, law: f64) -> Measure {
    Measure::new(name, "", found).expect(
        law,
        1e-6,
        Text::new("N·L with L = (0, 0, 1); single precision", "N·L com L = (0, 0, 1); precisão simples"),
    )
}

fn share(name: Text, found: f64) -> Measure {
    Measure::new(name, "", found)
}

/// Whether all of the gear is split but its bore: teeth bend by more than 60°, the bore by 7.5°.
fn separates_gear(parameters: &Parameters) -> bool {
    (8.0..60.0).contains(&parameters.crease.0) && parameters.weight != Weight::Quadric
}

/// What is left at the gear's bore, which is round: half the angle between its facets.
fn bore(found: f64, parameters: &Parameters) -> Measure {
    let measure = Measure::new(
        Text::new(
            "gear, split: largest angle of a corner's normal to its face",
            "engrenagem, separada: maior ângulo da normal de um canto com a sua face",
        ),
        "°",
        found,
    );
    if !separates_gear(parameters) {
        return measure;
    }
    measure.expect(
        180.0 / f64::from(bodies::BORE),
        1e-9,
        Text::new(
            "half the angle between the facets of the bore, which stay smooth",
            "metade do ângulo entre as facetas do furo, que continua liso",
        ),
    )
}

/// What crease angles make of the gear.
fn chart(gear: &Subject, weight: Weight) -> Result<Chart, ArtefactError> {
    let points = (0..=36).map(|k| {
        let crease = Degrees(5.0 * f64::from(k));
        [crease.0, gear.mean_of_corners(weight, Crease::Angle(crease))]
    });
    Ok(Chart {
        name: "error-by-crease-angle",
        title: Text::new("The gear by crease angle", "A engrenagem por ângulo de vinco"),
        caption: Text::new(
            "The mean angle of the corners' normals to their faces: nothing is smooth below 7.5°, the bore alone on the plateau, and \
             beyond it the teeth and at last the sides are smoothed falsely.",
            "O ângulo médio das normais dos cantos com as suas faces: abaixo de 7,5° nada é liso, no patamar só o furo, e além dele \
             os dentes e por fim os lados são alisados falsamente.",
        ),
        x: Scale::linear(Text::new("crease angle, degrees", "ângulo de vinco, graus")),
        y: Scale::linear(Text::new("mean angle, degrees", "ângulo médio, graus")),
        curves: vec![Curve {
            name: Text::new("corners of the gear", "cantos da engrenagem"),
            drawn: Drawn::Line,
            points: points.collect(),
        }],
    })
}

/// What is done about it.
fn cure(crease: Degrees) -> Text {
    Text::each(|language| {
        let angle = language.number(crease.0);
        match language {
            Language::English => format!("vertices split at edges over {angle}°"),
            Language::Portuguese => format!("vértices separados em arestas de mais de {angle}°"),
        }
    })
}

#[cfg(test)]
mod tests;
