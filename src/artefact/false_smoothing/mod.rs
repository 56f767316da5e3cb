//! Edges that are meant to be sharp, smoothed away by averaged normals.

mod bodies;
mod own;
mod shots;
mod subject;

use super::own_mesh::{camera, light_from};
use super::stage::{front, light_at, object};
use super::{
    ArtefactError, Chart, Curve, Drawn, Experiment, Knob, Language, Measure, Moved, Outcome, Parameters,
    Scale, Setup, Text, Threshold, Verdict,
};
use crate::normals::{Crease, NormalRecipe, Weight, compute};
use crate::num::{Degrees, Radians};
use crate::raster::Camera;
use glam::DVec3;
use subject::Subject;
use texts::TEXTS;

pub(super) static EXPERIMENT: Experiment = Experiment {
    id: "false-smoothing",
    texts: &TEXTS,
    takes: &[Knob::Size, Knob::Light, Knob::Weight, Knob::Crease, Knob::Mesh],
    segments: Parameters::SEGMENTS,
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
        (TEXTS.get("cube"), cube_smooth.largest(), cube_sharp.largest(), CUBE, right_angle),
        (TEXTS.get("zig-zag"), zigzag_smooth.largest(), zigzag_sharp.largest(), SLOPE.0, right_angle),
        (TEXTS.get("roof"), roof_smooth.largest(), roof_sharp.largest(), 0.5 * SLOPE.0, SLOPE),
    ];
    let mut measures = Vec::new();
    for (of, smooth, sharp, law, edge) in bends {
        measures.extend(angles(&of, [smooth, sharp], law, parameters, edge));
    }
    measures.extend([
        brightness(TEXTS.get("zig-zag-light"), front_smooth.middle(), 1.0),
        brightness(
            TEXTS.get("zig-zag-light-front"),
            front_sharp.true_middle(),
            libm::cos(Radians::from(SLOPE).0),
        ),
        share(
            TEXTS.with("gear-share-corners", &[("value", crease.0.into())]),
            gear_smooth.share_over(crease),
        ),
        bore(gear_sharp.largest(), parameters),
        Measure::new(TEXTS.get("measure-gear-averaged-mean"), "°", gear_smooth.deviation.mean),
        Measure::new(TEXTS.get("measure-gear-split-mean"), "°", gear_sharp.deviation.mean),
    ]);
    let moved = Moved {
        name: TEXTS.get("moved"),
        unit: "°",
        bad: gear_smooth.deviation.mean,
        present: Threshold::HALF_STEP_OF_TILT,
        cure: match separates_gear(parameters) {
            true => Text::each(|language| {
                let left = TEXTS.get("cure");
                format!("{}; {}", cure(crease).get(language), left.get(language))
            }),
            false => cure(crease),
        },
        cured: gear_sharp.deviation.mean,
        factor: 100.0,
    };
    Ok(Outcome {
        verdict: Verdict::Holds(TEXTS.get("holds-wherever-faces-share")),
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
    vec![TEXTS.get("zig-zag-every"), TEXTS.get("splitting-gives-each")]
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
    Measure::new(name, "", found).expect(law, 1e-6, TEXTS.get("by-n-l-l"))
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
    let measure = Measure::new(TEXTS.get("measure-gear-split-largest"), "°", found);
    if !separates_gear(parameters) {
        return measure;
    }
    measure.expect(180.0 / f64::from(bodies::BORE), 1e-9, TEXTS.get("by-half-angle-between"))
}

/// What crease angles make of the gear.
fn chart(gear: &Subject, weight: Weight) -> Result<Chart, ArtefactError> {
    let points = (0..=36).map(|k| {
        let crease = Degrees(5.0 * f64::from(k));
        [crease.0, gear.mean_of_corners(weight, Crease::Angle(crease))]
    });
    Ok(Chart {
        name: "error-by-crease-angle",
        title: TEXTS.get("chart-title"),
        caption: TEXTS.get("chart-caption"),
        x: Scale::linear(TEXTS.get("axis-crease-angle-degrees")),
        y: Scale::linear(TEXTS.get("axis-mean-angle-degrees")),
        curves: vec![Curve {
            name: TEXTS.get("curve-corners-gear"),
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
mod texts;
