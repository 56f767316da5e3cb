//! Vertex normals as means of faces: how a mesh is cut shows through.

mod cuts;
mod shots;
mod specimen;
mod texts;

use super::{
    ArtefactError, Chart, Curve, Drawn, Experiment, Knob, Language, Measure, Moved, Outcome, Parameters,
    Scale, Setup, Text, Threshold, Verdict,
};
use crate::normals::Weight;
use crate::num::Degrees;
use crate::surface::{Pattern, Sphere, Tessellation, Torus};
use cuts::{law, measured};
use glam::DVec3;
use specimen::{Look, Specimen};
use std::sync::LazyLock;
use texts::TEXTS;

pub(super) static EXPERIMENT: Experiment = Experiment {
    id: "vertex-average",
    texts: &TEXTS,
    takes: &[Knob::Size, Knob::Light, Knob::Exponent, Knob::Weight],
    segments: Parameters::SEGMENTS,
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
static MEANS: LazyLock<[(Weight, Text); 6]> = LazyLock::new(|| {
    [
        (Weight::Uniform, TEXTS.get("equal-weights")),
        (Weight::Area, TEXTS.get("area-weights")),
        (Weight::Angle, TEXTS.get("angle-weights")),
        (Weight::AngleArea, TEXTS.get("weights-angle-area")),
        (Weight::Max, TEXTS.get("max-weights")),
        (Weight::Edge, TEXTS.get("weights-e-e")),
    ]
});
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
    for (weight, name) in MEANS.iter() {
        measures.extend(of_boxes(*weight, name)?);
    }
    measures.extend(of_torus(&torus));
    measures.extend(of_ball(&ball));
    let slivers = Moved {
        name: TEXTS.get("moved"),
        unit: "°",
        bad: ball.at_vertices(weight).rms,
        present: Threshold::HALF_STEP_OF_TILT,
        cure: TEXTS.get("max-weights"),
        cured: ball.at_vertices(ROUND).rms,
        factor: 1000.0,
    };
    let off = |sides, weight| measured(sides, weight).map(|range| range.largest);
    let of_boxes = |name, sides, weight| -> Result<Moved, ArtefactError> {
        let (bad, cured) = (off(sides, weight)?, off(sides, FLAT)?);
        let cure = TEXTS.get("angle-weights");
        Ok(Moved { name, bad, cured, cure, ..slivers.clone() })
    };
    let of_cube = TEXTS.get("cube-largest-angle");
    let of_long = TEXTS.get("box-largest-angle");
    let shown = Shown {
        cube: of_boxes(of_cube, DVec3::ONE, weight)?,
        long: of_boxes(of_long.clone(), LONG, ROUND)?,
        torus: Moved {
            name: TEXTS.get("moved-irregular-torus-error"),
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
        notes: vec![TEXTS.get("note-cube-each-corner"), TEXTS.get("note-not-depend-cut")],
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
        false => Verdict::Fails(TEXTS.get("fails-these-weights-give")),
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
            Weight::Angle | Weight::AngleArea | Weight::Max => TEXTS.get("both-parts-face"),
            _ => TEXTS.get("each-face-counts"),
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
    for (weight, name) in MEANS.iter() {
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
                Some(known) => measure.expect(known[figure], 5e-4, TEXTS.get("by-another-program-same")),
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
            ROUND => measure.expect(0.0, 1e-9, TEXTS.get("by-exact-all-vertices")),
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
        for (curve, (weight, _)) in curves.iter_mut().zip(MEANS.iter()) {
            curve.points.push([ratio, ball.at_vertices(*weight).rms]);
        }
    }
    Ok(Chart {
        name: "error-by-slivers",
        title: TEXTS.get("chart-title"),
        caption: TEXTS.get("chart-caption"),
        x: Scale::log(TEXTS.get("axis-height-wide-row")),
        y: Scale::linear(TEXTS.get("axis-error-degrees")),
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
