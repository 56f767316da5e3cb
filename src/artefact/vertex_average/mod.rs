//! Vertex normals as means of faces: how a mesh is cut shows through.

mod cuts;
mod shots;
mod specimen;

use super::{
    ArtefactError, Chart, Curve, Drawn, Experiment, Formula, Knob, Language, Measure, Moved, Outcome,
    Parameters, Scale, Setup, Text, Threshold, Verdict,
};
use crate::normals::Weight;
use crate::num::Degrees;
use crate::surface::{Pattern, Sphere, Tessellation, Torus};
use cuts::{law, measured};
use glam::DVec3;
use specimen::{Look, Specimen};

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "vertex-average",
    title: Text::new("The mean at a vertex", "A média no vértice"),
    claim: Text::new(
        "The normal at a vertex is the mean of the normals of all faces at it. So it depends on how the surface happens to be cut into \
         faces: a face that is cut through the vertex counts twice.",
        "A normal num vértice é a média das normais de todas as faces nele. Ela depende então de como a superfície foi cortada em \
         faces: uma face cortada através do vértice conta duas vezes.",
    ),
    sources: &[
        Text::new(
            "Lectures: 1.5.2.1 (figure 33), 1.6.13, 1.6.21 b (figure 47)",
            "Aulas: 1.5.2.1 (figura 33), 1.6.13, 1.6.21 b (figura 47)",
        ),
        Text::new(
            "Weights: G. Thürmer, C. A. Wüthrich, Computing vertex normals from polygonal facets, JGT 3(1), 1998; N. Max, Weights for \
             computing vertex normals from facet normals, JGT 4(2), 1999",
            "Pesos: G. Thürmer, C. A. Wüthrich, Computing vertex normals from polygonal facets, JGT 3(1), 1998; N. Max, Weights for \
             computing vertex normals from facet normals, JGT 4(2), 1999",
        ),
    ],
    formulas: &[
        Formula {
            notation: Text::same("N = \\frac{Σ w_i N_i}{|Σ w_i N_i|}"),
            says: Text::new(
                "the mean at a vertex: w = 1 in the lectures, the angle at the vertex by Thürmer and Wüthrich, sin(α)/(|e_1| |e_2|) by Max",
                "a média num vértice: w = 1 nas aulas, o ângulo no vértice em Thürmer e Wüthrich, sin(α)/(|e_1| |e_2|) em Max",
            ),
        },
        Formula {
            notation: Text::same(
                "cos(δ_{211}) = \\frac{4}{\\sqrt{6} \\sqrt{3}}, cos(δ_{221}) = \\frac{5}{3 \\sqrt{3}}",
            ),
            says: Text::new(
                "the corner of a cube of which one face or two are cut: δ = 19.4712° and 15.7932° off the diagonal with w = 1",
                "o vértice de um cubo do qual uma face ou duas estão cortadas: δ = 19,4712° e 15,7932° da diagonal com w = 1",
            ),
        },
        Formula {
            notation: Text::same("w = α: δ = 0"),
            says: Text::new(
                "angles of the parts of a flat face add up to that of the face, however it is cut",
                "os ângulos das partes de uma face plana somam o da face, seja como for cortada",
            ),
        },
    ],
    takes: &[Knob::Size, Knob::Light, Knob::Exponent, Knob::Weight],
    own_mesh: None,
    segments: Parameters::SEGMENTS,
    shown_by: Text::new(
        "other weights (--weight uniform) would show it.",
        "outros pesos (--weight uniform) o mostrariam.",
    ),
    defaults: Parameters {
        weight: Weight::Uniform,
        light: Degrees(-25.0),
        exponent: 40.0,
        ..Parameters::USUAL
    },
    run,
    frame: None,
};

/// The weights that are means over triangles, with their names.
static MEANS: [(Weight, Text); 6] = [
    (Weight::Uniform, Text::new("equal weights", "pesos iguais")),
    (Weight::Area, Text::new("area weights", "pesos pela área")),
    (Weight::Angle, Text::new("angle weights", "pesos pelo ângulo")),
    (Weight::AngleArea, Text::new("weights angle × area", "pesos ângulo × área")),
    (Weight::Max, Text::new("Max's weights", "pesos de Max")),
    (Weight::Edge, Text::new("weights 1/(|e₁| |e₂|) of edges", "pesos 1/(|e₁| |e₂|) das arestas")),
];
/// What they are called.
fn name_of(weight: Weight, language: Language) -> &'static str {
    MEANS.iter().find(|(known, _)| *known == weight).map_or(weight.name(), |(_, name)| name.get(language))
}

/// The weights that do not change when flat faces are cut, and those that are exact on spheres.
const FLAT: Weight = Weight::Angle;
const ROUND: Weight = Weight::Max;
/// The sides of the box.
const LONG: DVec3 = DVec3::new(10.0, 1.0, 1.0);
/// How many times closer every other row of the ball is to the next.
const SLIVERS: f64 = 12.0;

fn run(setup: &Setup) -> Result<Outcome, ArtefactError> {
    let Parameters { size, light, exponent, weight, .. } = setup.parameters;
    let look = Look { size, light, exponent };
    let irregular = Tessellation { jitter: 0.5, ..Tessellation::default() };
    let torus = Specimen::new(Torus::default().into(), Torus::default().into(), &irregular, &look)?;
    let ball = ball(SLIVERS, &look)?;
    let mut measures = Vec::new();
    for (weight, name) in &MEANS {
        measures.extend(of_boxes(*weight, name)?);
    }
    measures.extend(of_torus(&torus));
    measures.extend(of_ball(&ball));
    let slivers = Moved {
        name: Text::new(
            "ball of slivers: error of the normals at vertices (rms)",
            "bola de lascas: erro das normais nos vértices (rms)",
        ),
        unit: "°",
        bad: ball.at_vertices(weight).rms,
        present: Threshold::HALF_STEP_OF_TILT,
        cure: Text::new("Max's weights", "pesos de Max"),
        cured: ball.at_vertices(ROUND).rms,
        factor: 1000.0,
    };
    let off = |sides, weight| measured(sides, weight).map(|range| range.largest);
    let of_boxes = |name, sides, weight| -> Result<Moved, ArtefactError> {
        let (bad, cured) = (off(sides, weight)?, off(sides, FLAT)?);
        let cure = Text::new("angle weights", "pesos pelo ângulo");
        Ok(Moved { name, bad, cured, cure, ..slivers.clone() })
    };
    let of_cube = Text::new("cube: largest angle to the diagonal", "cubo: maior ângulo com a diagonal");
    let of_long = Text::new("box: largest angle to the diagonal", "caixa: maior ângulo com a diagonal");
    let shown = Shown {
        cube: of_boxes(of_cube, DVec3::ONE, weight)?,
        long: of_boxes(of_long.clone(), LONG, ROUND)?,
        torus: Moved {
            name: Text::new(
                "irregular torus: error of the normals at vertices (rms)",
                "toro irregular: erro das normais nos vértices (rms)",
            ),
            bad: torus.at_vertices(weight).rms,
            cured: torus.at_vertices(ROUND).rms,
            // No weights are exact on a torus.
            factor: 1.5,
            ..slivers.clone()
        },
        slivers_by_angle: ball.at_vertices(FLAT).rms,
        slivers: slivers.clone(),
    };
    // The first that is seen with these weights.
    let all =
        [shown.slivers.clone(), shown.cube.clone(), of_boxes(of_long, LONG, weight)?, shown.torus.clone()];
    let moved = all.iter().find(|moved| moved.is_present()).unwrap_or(&all[0]).clone();
    Ok(Outcome {
        verdict: verdict(weight, shown.cube.bad),
        measures,
        charts: vec![chart(&look)?],
        shots: shots::all(weight, &look, [&torus, &ball], &shown)?,
        moved,
        notes: vec![
            Text::new(
                "On the cube each corner has three faces. Where one of them is cut through the corner, two triangles vote for it and the \
             mean leans over. The angle at the corner is shared out between the two, so that their votes add up to one again.",
                "No cubo cada vértice tem três faces. Onde uma delas é cortada através do vértice, dois triângulos votam por ela e a \
             média se inclina. O ângulo no vértice se divide entre os dois, e os seus votos voltam a somar um.",
            ),
            Text::new(
                "Not to depend on the cut is not yet to be right: on the box of 1 × 1 × 10 Max's weights give the same normal for all 64 \
             cuts, 46.7° off, for they favour small faces. On a ball, where the mean is meant to stand for something round, they \
             are exact, and angles are not.",
                "Não depender do corte ainda não é estar certo: na caixa de 1 × 1 × 10 os pesos de Max dão a mesma normal para os 64 \
             cortes, com erro de 46,7°, pois favorecem faces pequenas. Numa bola, onde a média representa algo redondo, eles são \
             exatos, e os ângulos não.",
            ),
        ],
    })
}

/// What the pictures are measured by.
struct Shown {
    cube: Moved,
    /// The box, with Max's weights.
    long: Moved,
    torus: Moved,
    slivers: Moved,
    /// The error on the ball of slivers with weights by the angle.
    slivers_by_angle: f64,
}

/// By the largest angle on the cube over all of its cuts.
fn verdict(weight: Weight, cube: f64) -> Verdict {
    match cube > 1e-6 {
        true => Verdict::Holds(Text::each(|language| {
            let these = name_of(weight, language);
            match language {
                Language::English => format!(
                    "with weights that change where a face is cut through the vertex, as those of these pictures do ({these}). Weights \
                     by the angle do not see how flat faces are cut, and Max's are exact on spheres; none is right everywhere."
                ),
                Language::Portuguese => format!(
                    "com pesos que mudam onde uma face é cortada através do vértice, como os destas imagens ({these}). Pesos pelo \
                     ângulo não veem como faces planas são cortadas, e os de Max são exatos em esferas; nenhum está certo em toda parte."
                ),
            }
        })),
        false => Verdict::Fails(Text::new(
            "these weights give the cube the same normals however its faces are cut. On round surfaces the mean depends on the \
             triangles still.",
            "estes pesos dão ao cubo as mesmas normais, como quer que as faces sejam cortadas. Em superfícies redondas a média ainda \
             depende dos triângulos.",
        )),
    }
}

/// A ball in rows, every other one so many times narrower.
fn ball(ratio: f64, look: &Look) -> Result<Specimen, ArtefactError> {
    let (pattern, segments) = (Pattern::Slivers(ratio), [24, 24]);
    let tessellation = Tessellation { pattern, segments, ..Tessellation::default() };
    Specimen::new(Sphere::default().into(), Sphere::default().into(), &tessellation, look)
}

/// Over all corners and all 64 cuts: the largest angle, and the others that tell something.
fn of_boxes(weight: Weight, weighting: &Text) -> Result<Vec<Measure>, ArtefactError> {
    let measure = |what: [&'static str; 2], found: f64, law: Option<f64>| {
        let what = Text::new(what[0], what[1]);
        let name = Text::each(|language| format!("{}, {}", what.get(language), weighting.get(language)));
        let measure = Measure::new(name, "°", found);
        let by = match weight {
            Weight::Angle | Weight::AngleArea | Weight::Max => Text::new(
                "both parts of a face cut through the corner count together as much as the one part of a face cut the other way; a few \
                 roundings",
                "as duas partes de uma face cortada pelo vértice contam juntas tanto quanto a única parte de uma face cortada do outro \
                 modo; poucos arredondamentos",
            ),
            _ => Text::new(
                "each face counts as one triangle or as two; a few roundings",
                "cada face conta como um triângulo ou como dois; poucos arredondamentos",
            ),
        };
        match law {
            Some(law) => measure.expect(law, 1e-9, by),
            None => measure,
        }
    };
    let [cube, long] = [DVec3::ONE, LONG].map(|sides| measured(sides, weight));
    let (cube, long) = (cube?, long?);
    let [cube_law, long_law] = [DVec3::ONE, LONG].map(|sides| law(sides, weight));
    let mut measures = Vec::new();
    measures.push(measure(
        ["cube: largest angle over all cuts", "cubo: maior ângulo entre todos os cortes"],
        cube.largest,
        cube_law.map(|law| law.largest),
    ));
    if cube.next < cube.largest {
        measures.push(measure(
            ["cube: smallest that is not 0", "cubo: menor que não é 0"],
            cube.next,
            cube_law.map(|law| law.next),
        ));
    }
    measures.push(measure(
        ["box 1 × 1 × 10: largest", "caixa 1 × 1 × 10: maior"],
        long.largest,
        long_law.map(|law| law.largest),
    ));
    if long.least > 1.0 {
        measures.push(measure(
            ["box 1 × 1 × 10: least", "caixa 1 × 1 × 10: menor"],
            long.least,
            long_law.map(|law| law.least),
        ));
    }
    Ok(measures)
}

/// Rms and maximum over the vertices of an irregular torus, for two weights by figures computed apart from this program.
fn of_torus(torus: &Specimen) -> Vec<Measure> {
    const KNOWN: [(Weight, [f64; 2]); 2] = [(Weight::Uniform, [1.644, 4.677]), (Weight::Max, [0.498, 2.054])];
    let mut measures = Vec::new();
    for (weight, name) in &MEANS {
        let errors = torus.at_vertices(*weight);
        let known = KNOWN.iter().find(|(known, _)| known == weight).map(|(_, known)| known);
        let figures = [("rms", "rms", errors.rms), ("largest", "maior", errors.max)];
        for (figure, (en, pt, found)) in figures.into_iter().enumerate() {
            let name = Text::made(
                format!("irregular torus: {en} error at vertices, {}", name.get(Language::English)),
                format!("toro irregular: erro {pt} nos vértices, {}", name.get(Language::Portuguese)),
            );
            let measure = Measure::new(name, "°", found);
            measures.push(match known {
                Some(known) => measure.expect(
                    known[figure],
                    5e-4,
                    Text::new(
                        "another program on the same mesh, to the digits that it printed",
                        "outro programa na mesma malha, até os dígitos que imprimiu",
                    ),
                ),
                None => measure,
            });
        }
    }
    measures
}

fn of_ball(ball: &Specimen) -> Vec<Measure> {
    let measure = |(weight, name): &(Weight, Text)| {
        let name = Text::made(
            format!("ball of slivers: rms error at vertices, {}", name.get(Language::English)),
            format!("bola de lascas: erro rms nos vértices, {}", name.get(Language::Portuguese)),
        );
        let measure = Measure::new(name, "°", ball.at_vertices(*weight).rms);
        match *weight {
            ROUND => measure.expect(
                0.0,
                1e-9,
                Text::new(
                    "exact where all vertices of a fan lie on a sphere (Max 1999)",
                    "exatos onde todos os vértices de um leque estão numa esfera (Max 1999)",
                ),
            ),
            _ => measure,
        }
    };
    MEANS.iter().map(measure).collect()
}

/// Errors on the ball by how thin its slivers are.
fn chart(look: &Look) -> Result<Chart, ArtefactError> {
    let mut curves: Vec<Curve> = MEANS
        .iter()
        .map(|(_, name)| Curve { name: name.clone(), drawn: Drawn::Line, points: Vec::new() })
        .collect();
    for ratio in [1.0, 2.0, 4.0, 8.0, 16.0, 32.0] {
        let ball = ball(ratio, look)?;
        for (curve, (weight, _)) in curves.iter_mut().zip(&MEANS) {
            curve.points.push([ratio, ball.at_vertices(*weight).rms]);
        }
    }
    Ok(Chart {
        name: "error-by-slivers",
        title: Text::new("Weights on a ball of slivers", "Pesos numa bola de lascas"),
        caption: Text::new(
            "The error of normals at vertices (rms) when every other row of triangles is so many times narrower: it grows with most \
             weights, and stays 0 with Max's.",
            "O erro das normais nos vértices (rms) quando uma fileira de triângulos sim, outra não, é tantas vezes mais estreita: \
             cresce com quase todos os pesos, e fica 0 com os de Max.",
        ),
        x: Scale::log(Text::new(
            "height of a wide row over that of a narrow one",
            "altura da fileira larga sobre a da estreita",
        )),
        y: Scale::linear(Text::new("error in degrees", "erro em graus")),
        curves,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn run(weight: Weight) -> Outcome {
        let parameters = Parameters { size: 96, weight, ..EXPERIMENT.defaults };
        EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap()
    }

    #[test]
    fn the_cut_shows_and_stops_showing() {
        for weight in [Weight::Uniform, Weight::Area] {
            let outcome = run(weight);
            for measure in &outcome.measures {
                assert_ne!(measure.agrees(), Some(false), "{measure:?}");
            }
            // Present: degrees. Cured: Max's weights are exact on a sphere but for roundings.
            assert!(outcome.moved.bad > 1.5 && outcome.moved.reduction() > 1000.0, "{:?}", outcome.moved);
            assert!(matches!(outcome.verdict, Verdict::Holds(_)));
        }
        assert!(matches!(run(Weight::Angle).verdict, Verdict::Fails(_)));
        // Neither the cube's cuts nor the ball's slivers show with Max's weights, but the box leans.
        let round = run(ROUND);
        assert!(matches!(round.verdict, Verdict::Fails(_)), "{:?}", round.verdict);
        assert!(round.moved.bad > 40.0 && round.moved.is_cured(), "{:?}", round.moved);
        // The ball is all but right with weights by the edges, the cube is not.
        let edge = run(Weight::Edge);
        assert!(matches!(edge.verdict, Verdict::Holds(_)), "{:?}", edge.verdict);
        assert!((edge.moved.bad - 9.736).abs() < 1e-3 && edge.moved.is_cured(), "{:?}", edge.moved);
    }
}
