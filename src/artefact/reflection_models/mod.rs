//! Phong's and Blinn's highlights.

mod behind;
mod texts;
mod widths;

use super::stage::{draw, front, light_at, settings};
use super::{
    ArtefactError, Chart, Curve, Drawn, Experiment, Knob, Measure, Moved, Outcome, Parameters, Scale, Setup,
    Shot, Text, Threshold, Verdict,
};
use crate::metric::image_error;
use crate::num::{Degrees, LinearRgb, Radians};
use crate::raster::{Image, Interpolation, Object, RenderSettings, Shading, Shape};
use crate::shade::{Guards, Material, Reflectance, Reflection, blinn_exponent};
use crate::surface::{Primitive, Sphere};
use behind::Behind;
use std::f64::consts::FRAC_PI_2;
use texts::TEXTS;

pub(super) static EXPERIMENT: Experiment = Experiment {
    id: "reflection-models",
    texts: &TEXTS,
    takes: &[Knob::Size, Knob::Exponent],
    segments: Parameters::SEGMENTS,
    defaults: Parameters { exponent: 10.0, ..Parameters::USUAL },
    run,
    frame: None,
};

/// Light far round the sphere.
const GRAZING: Degrees = Degrees(120.0);
/// How many times nearer to Phong's highlight four times the exponent has to be.
const FACTOR: f64 = 5.0;
/// The window's side; the sphere has the radius 1.
const WINDOW: f64 = 2.2;

fn run(setup: &Setup) -> Result<Outcome, ArtefactError> {
    let Parameters { size, exponent, .. } = setup.parameters;
    let ball = |reflection, exponent, light, guards| ball(reflection, exponent, light, guards, size);
    let on = Guards::default();
    let head_on = Degrees(0.0);
    let phong = ball(Reflection::Phong, exponent, head_on, on)?;
    let blinn = ball(Reflection::Blinn, exponent, head_on, on)?;
    let matched = ball(Reflection::Blinn, blinn_exponent(exponent), head_on, on)?;
    let largest =
        |image: &Image| Ok::<f64, ArtefactError>(image_error(image, &phong, 0.5)?.linear.max / 255.0);
    let (same, fourfold) = (largest(&blinn)?, largest(&matched)?);
    let law = |own: f64| {
        let difference = |k: u32| {
            let phi = f64::from(k) / 1e4 * std::f64::consts::PI;
            // Mirrored away from the viewer there is nothing, whatever the exponent.
            let phong = if phi < FRAC_PI_2 { libm::pow(libm::cos(phi), exponent) } else { 0.0 };
            (phong - libm::pow(libm::cos(0.5 * phi), own)).abs()
        };
        (0..=10_000).map(difference).fold(0.0, f64::max)
    };
    let (grazing_phong, grazing_blinn) = (
        ball(Reflection::Phong, exponent, GRAZING, on)?,
        ball(Reflection::Blinn, blinn_exponent(exponent), GRAZING, on)?,
    );
    let radius = f64::from(size) / WINDOW;
    // Half a pixel turns the normal by 1/R over the cosine of its angle to the viewer, and the mirrored ray by twice that. Powers
    // change by √n of it at most, and by 1 for the smallest n.
    let pixel = 0.5 / radius * 2.0 * exponent.sqrt().max(1.0);
    let by_scan = TEXTS.get("largest-over-scan");
    let compared = |measure: Measure, law: f64, tolerance: f64| match pixel < 0.5 {
        true => measure.expect(law, tolerance, by_scan.clone()),
        false => measure.beyond(TEXTS.get("untested-highlight-hardly-wider")),
    };
    let [across_phong, across_blinn] = [
        widths::measure(
            TEXTS.get("light-phong-highlight"),
            &grazing_phong,
            widths::of_phong(exponent),
            widths::phong_at(exponent),
            TEXTS.get("half-widths-half"),
        ),
        widths::measure(
            TEXTS.get("light-blinn-highlight"),
            &grazing_blinn,
            widths::of_blinn(blinn_exponent(exponent)),
            widths::blinn_at(blinn_exponent(exponent)),
            TEXTS.get("round"),
        ),
    ];
    // Where widths cannot be told nothing is said of them.
    let stretch = |measure: &Measure| match measure.beyond {
        None => (measure.value - 1.0).abs(),
        Some(_) => 0.0,
    };
    let moved = Moved {
        name: TEXTS.get("moved"),
        unit: "",
        bad: same,
        present: Threshold::HALF_STEP,
        cure: TEXTS.get("cure"),
        cured: fourfold,
        factor: FACTOR,
    };
    let stretched = Moved {
        name: match across_phong.beyond.is_none() && across_blinn.beyond.is_none() {
            true => TEXTS.get("moved-width-across-over"),
            false => TEXTS.get("moved-width-across-over-width"),
        },
        bad: stretch(&across_phong),
        present: Threshold { value: 0.1, why: TEXTS.get("why-tenth-width") },
        cured: stretch(&across_blinn),
        ..moved.clone()
    };
    let [phong_behind, blinn_behind] = [Reflection::Phong, Reflection::Blinn]
        .map(|reflection| Behind::new(reflection, exponent, size, &moved));
    let (phong_behind, blinn_behind) = (phong_behind?, blinn_behind?);
    let mut measures = vec![
        compared(Measure::new(TEXTS.get("measure-same-n-largest"), "", same), law(exponent), 0.5 * pixel),
        compared(
            Measure::new(TEXTS.get("measure-blinn-n-largest"), "", fourfold),
            law(blinn_exponent(exponent)),
            // Near its largest the difference is flat; where powers are steep it is not.
            (0.1 * law(blinn_exponent(exponent)) + 1e-5).max(if exponent < 2.0 { 0.5 * pixel } else { 0.0 }),
        ),
        across_phong,
        across_blinn,
    ];
    measures.extend(phong_behind.measures());
    measures.extend(blinn_behind.measures());
    Ok(Outcome {
        verdict: verdict(&moved),
        shots: [vec![
            Shot::truth(
                "phong",
                TEXTS.get("phong-title"),
                TEXTS.with("phong-caption-phong-highlight-sphere", &[("exponent", exponent.into())]),
                phong,
            ),
            moved.bad_shot(
                "blinn-same-n",
                TEXTS.get("blinn-same-n-title"),
                [
                    TEXTS.get("blinn-same-n-caption-blinn-same-exponent"),
                    Text::with(
                        "It is wider: at half its height where the normal is {}° off the viewer, Phong's at {}°.",
                        "É mais largo: à meia altura onde a normal está a {}° do observador, o de Phong a {}°.",
                        &widths::in_front(exponent),
                    ),
                ],
                blinn,
            ),
            moved.cured_shot(
                "blinn-4n",
                TEXTS.get("blinn-4n-title"),
                [
                    TEXTS.get("blinn-4n-caption-blinn-four-times"),
                    TEXTS.get("blinn-4n-caption-much-closer-phong"),
                ],
                matched,
            ),
            stretched.bad_shot(
                "phong-grazing",
                TEXTS.get("phong-grazing-title"),
                [
                    TEXTS.with("phong-grazing-caption-light-far-round", &[("exponent", exponent.into())]),
                    TEXTS.get("phong-grazing-caption-here-phong-highlight"),
                ],
                grazing_phong,
            ),
            stretched.cured_shot(
                "blinn-grazing",
                TEXTS.get("blinn-grazing-title"),
                [
                    TEXTS.with("blinn-grazing-caption-blinn-under-same", &[("blinn-exponent", (blinn_exponent(exponent)).into())]),
                    TEXTS.get("blinn-grazing-caption-circle-sphere-cut"),
                ],
                grazing_blinn,
            ),
        ], phong_behind.shots().into(), blinn_behind.shots().into()].concat(),
        charts: vec![chart(exponent, moved.is_cured())],
        moved,
        measures,
        notes: vec![TEXTS.get("note-lectures-give-both")],
    })
}

/// The true sphere with nothing but a highlight.
fn ball(
    reflection: Reflection,
    exponent: f64,
    light: Degrees,
    guards: Guards,
    size: u32,
) -> Result<Image, ArtefactError> {
    let material = Material {
        ambient: Reflectance::NONE,
        diffuse: Reflectance::NONE,
        specular: Reflectance::Merged(LinearRgb::WHITE),
        exponent,
        reflection,
    };
    let sphere = Object::new(Shape::Surface(Primitive::from(Sphere::default())), material);
    let settings =
        RenderSettings { guards, ..settings([size; 2], Shading::Exact, Interpolation::Perspective) };
    draw(vec![sphere], &[light_at(light)], front(WINDOW), &settings)
}

/// By whether four times the exponent brings Blinn's highlight to Phong's.
fn verdict(moved: &Moved) -> Verdict {
    match moved.is_cured() {
        true => Verdict::HoldsOnlyIf(TEXTS.get("holds-only-if-blinn-exponent-n")),
        false => Verdict::Fails(TEXTS.get("fails-small-exponent-no")),
    }
}

fn chart(exponent: f64, is_covered: bool) -> Chart {
    let curve = |name, drawn, value: &dyn Fn(f64) -> f64| Curve {
        name,
        drawn,
        points: (0..=180)
            .map(|k| {
                let degrees = f64::from(k) * 0.5;
                [degrees, value(Radians::from(Degrees(degrees)).0)]
            })
            .collect(),
    };
    let power = |cosine: f64, n: f64| libm::pow(cosine, n);
    Chart {
        name: "highlights",
        title: TEXTS.get("chart-title"),
        caption: match is_covered {
            true => TEXTS.get("chart-caption"),
            false => TEXTS.get("chart-caption-against-angle-mirrored"),
        },
        x: Scale::linear(TEXTS.get("axis-degrees")),
        y: Scale::linear(TEXTS.get("axis-highlight")),
        curves: vec![
            curve(TEXTS.get("phong-title"), Drawn::Curve, &|phi| power(libm::cos(phi), exponent)),
            curve(TEXTS.get("blinn-same-n-title"), Drawn::Curve, &|phi| {
                power(libm::cos(0.5 * phi), exponent)
            }),
            curve(TEXTS.get("blinn-4n-title"), Drawn::Curve, &|phi| {
                power(libm::cos(0.5 * phi), blinn_exponent(exponent))
            }),
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::artefact::Range;

    #[test]
    fn highlights_differ_as_the_formulas_say() {
        for exponent in [10.0, 50.0] {
            let parameters = Parameters { size: 256, exponent, ..EXPERIMENT.defaults };
            let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
            outcome.prove();
            // Present: a fifth of full light. Cured: ten times less.
            assert!(outcome.moved.bad > 0.2 && outcome.moved.reduction() > 10.0, "{:?}", outcome.moved);
        }
    }

    /// Published: n = 10 and 4n differ by 0.01425 at most, n = 50 by 0.00273.
    #[test]
    fn fourfold_exponents_have_the_published_differences() {
        for (exponent, published) in [(10.0, 0.014_25), (50.0, 0.002_73)] {
            let parameters = Parameters { size: 200, exponent, ..EXPERIMENT.defaults };
            let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
            let Some(Range::Near { value, .. }) = outcome.measures[1].expected.as_ref().map(|law| law.range)
            else {
                panic!("{:?}", outcome.measures[1]);
            };
            assert!((value - published).abs() < 5e-6, "{value}");
            let found = outcome.measured("Blinn with 4n");
            assert!((found - published).abs() < 1e-4, "{found}");
        }
    }

    /// A constant highlight is cut off where the mirrored ray turns away, which no exponent of Blinn's does.
    #[test]
    fn small_exponents_have_no_match() {
        for (exponent, fails) in [(0.0, true), (1.0, true), (3.0, false)] {
            let parameters = Parameters { size: 64, exponent, ..EXPERIMENT.defaults };
            let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
            assert_eq!(
                matches!(outcome.verdict, Verdict::Fails(_)),
                fails,
                "{exponent}: {:?}",
                outcome.moved
            );
        }
    }

    /// Highlights of small exponents come so near to the outline that straight lines between pixels reach beyond it.
    #[test]
    fn widths_agree_near_the_outline() {
        for size in [46, 50, 58, 65, 70, 85, 86, 128] {
            for exponent in [2.0, 3.0, 8.0] {
                let parameters = Parameters { size, exponent, ..EXPERIMENT.defaults };
                let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
                for measure in &outcome.measures {
                    assert_ne!(measure.agrees(), Some(false), "{size} {exponent}: {measure:?}");
                }
            }
        }
    }
}
