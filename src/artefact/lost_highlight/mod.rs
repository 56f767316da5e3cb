//! A highlight that falls between vertices.

mod scene;
mod texts;

use super::body::Body;
use super::stage::{GAP, tiles};
use super::{
    ArtefactError, Chart, Curve, Drawn, Experiment, Knob, Language, Measure, Moved, Outcome, Parameters,
    Scale, Setup, Shot, Text, Threshold, Verdict,
};
use crate::metric::Highlight;
use crate::num::{Degrees, Radians};
use crate::raster::{Image, Object, Shading, Shape};
use crate::surface::{Primitive, Sphere};
use scene::{TILT, WINDOW, law, look, material, of_diffuse, paint, plate};
use std::f64::consts::{FRAC_1_SQRT_2, PI, SQRT_2, TAU};
use texts::TEXTS;

pub(super) static EXPERIMENT: Experiment = Experiment {
    id: "lost-highlight",
    texts: &TEXTS,
    takes: &[Knob::Size, Knob::Segments, Knob::Exponent],
    // More would be hardly larger than pixels.
    segments: 3..=256,
    defaults: Parameters { segments: 16, exponent: 32.0, ..Parameters::USUAL },
    run,
    frame: Some(frame),
};

/// The window's side from close by.
const CLOSE: f64 = 1.1;
/// Pictures of one turn by a segment.
const FRAMES: u32 = 8;

/// Whether a vertex so far from the highlight has less of it than where it is steepest, at e^(−1/2) of its height: a highlight
/// narrower than that angle is lost there, a wider one dulled.
fn is_lost(angle: f64, exponent: f64) -> bool {
    libm::pow(libm::cos(angle), exponent) <= libm::exp(-0.5)
}

/// By whether the highlight is narrower than half a segment, where a vertex is at the farthest.
fn verdict(segments: u32, exponent: f64) -> Verdict {
    let least = (f64::from(segments) / PI) * (f64::from(segments) / PI);
    let reported = |language: Language| [language.number(exponent), language.number(least.round())];
    let (en, pt) = (reported(Language::English), reported(Language::Portuguese));
    match is_lost(PI / f64::from(segments), exponent) {
        true => Verdict::Holds(Text::made(
            format!(
                "wherever the nearest vertex's normal is farther from the highlight than the highlight is wide: exponents from about \
                 (N/π)² on with N facets round, {} on this sphere of N = {segments}. As it turns it flickers.",
                en[1]
            ),
            format!(
                "sempre que a normal do vértice mais próximo está mais longe do brilho do que o brilho é largo: expoentes a partir de \
                 cerca de (N/π)² com N facetas em volta, {} nesta esfera de N = {segments}. Girando, ela cintila.",
                pt[1]
            ),
        )),
        false => Verdict::HoldsOnlyIf(Text::made(
            format!(
                "the nearest vertex's normal is farther from the highlight than the highlight is wide. On this sphere \
                 (N = {segments} facets round) that takes exponents from about (N/π)² = {} on; at {} its highlight is wider than a facet: dulled, not lost.",
                en[1], en[0]
            ),
            format!(
                "a normal do vértice mais próximo está mais longe do brilho do que o brilho é largo. Nesta esfera isso \
                 (N = {segments} facetas em volta) pede expoentes a partir de cerca de (N/π)² = {}; com {} o brilho é mais largo que uma faceta: embaçado, não perdido.",
                pt[1], pt[0]
            ),
        )),
    }
}

/// The largest tolerance that a value of up to 1, or a length of 1, is held against its law with.
const MOST_TOLERANCE: f64 = 0.5;

fn run(setup: &Setup) -> Result<Outcome, ArtefactError> {
    let Parameters { size, segments, exponent, .. } = setup.parameters;
    let delta = TAU / f64::from(segments);
    let peak = |image: &Image| Highlight::of(image).map(|found| found.peak);
    let plate = |shading| paint(plate().object(material(exponent)), size, shading);
    let (plate_gouraud, plate_phong) = (plate(Shading::Gouraud)?, plate(Shading::Phong)?);
    let globe =
        |turn: f64, shading| paint(Body::globe(segments, turn).object(material(exponent)), size, shading);
    let truth = paint(
        Object::new(Shape::Surface(Primitive::from(Sphere::default())), material(exponent)),
        size,
        Shading::Exact,
    )?;
    let (worst, cured) = (globe(delta / 2.0, Shading::Gouraud)?, globe(delta / 2.0, Shading::Phong)?);
    let quarter = globe(delta / 4.0, Shading::Gouraud)?;
    let (mut gouraud, mut phong) = (Vec::new(), Vec::new());
    for k in 0..=FRAMES {
        let turn = delta * f64::from(k) / f64::from(FRAMES);
        let degrees = Degrees::from(Radians(turn)).0;
        gouraud.push([degrees, peak(&globe(turn, Shading::Gouraud)?)?]);
        phong.push([degrees, peak(&globe(turn, Shading::Phong)?)?]);
    }
    let (flicker_gouraud, flicker_phong) = (flicker(&gouraud), flicker(&phong));
    // The peak of diffuse light falls to the cosine of half a segment, whatever the highlight does.
    let beyond_diffuse = |flicker: f64| (flicker - of_diffuse(0.5 * delta)).max(0.0);
    let radius = f64::from(size) / WINDOW;
    let of_nearest = law(delta / 2.0, exponent);
    // What a peak may lose if it lies in the middle between four pixels, on the sphere and on the plate.
    let between = FRAC_1_SQRT_2 * WINDOW / f64::from(size);
    let lean = libm::tan(Radians::from(TILT).0) * FRAC_1_SQRT_2;
    let [lost_on_sphere, lost_on_plate] =
        [libm::asin(between), libm::atan(between * lean)].map(|angle| 1.0 - law(angle, exponent));
    // Where that is more than a fifth, the true peak falls between pixels, and nothing is told of what others lack.
    let is_seen = |lost: f64| lost < 0.2;
    let reported = |lost: f64, value: f64| if is_seen(lost) { value } else { 0.0 };
    let held = |measure: Measure, lost: f64, law: f64, tolerance: f64, by: Text| match is_seen(lost) {
        true => measure.expect(law, tolerance + lost * law, by),
        false => measure.beyond(TEXTS.get("untested-true-highlight-narrower")),
    };
    // A pixel's centre is up to 0.71 pixels from a vertex, from which light falls along edges to the next one.
    let edge = 2.0 * libm::sin(delta / 2.0) * radius;
    let tolerance = 0.75 / edge;
    // On facets of few pixels that would allow almost anything.
    let by_pixels = |measure: Measure, is_coarse: bool, held: &dyn Fn(Measure) -> Measure| match is_coarse {
        false => held(measure),
        true => measure.beyond(TEXTS.get("untested-not-held-against")),
    };
    let off_pixel = TEXTS.get("pixel-centre-up");
    let change = Highlight::change(&quarter, &truth)?;
    let displacement = radius * libm::sin(delta / 4.0);
    let measures = vec![
        held(
            Measure::new(
                TEXTS.get("measure-plate-gouraud-peak"),
                "",
                peak(&plate_gouraud)? / peak(&plate_phong)?,
            ),
            lost_on_plate,
            law(Radians::from(TILT).0, exponent),
            2e-3,
            TEXTS.get("by-k-d-cos"),
        ),
        by_pixels(
            Measure::new(
                TEXTS.get("measure-sphere-gouraud-peak"),
                "",
                Highlight::change(&worst, &truth)?.peak_ratio,
            ),
            tolerance > MOST_TOLERANCE,
            &|measure| held(measure, lost_on_sphere, of_nearest, tolerance, off_pixel.clone()),
        ),
        by_pixels(
            Measure::new(TEXTS.get("measure-sphere-turned-quarter"), "px", change.displacement),
            SQRT_2 > MOST_TOLERANCE * displacement,
            &|measure| measure.expect(displacement, SQRT_2, TEXTS.get("by-r-sin-nearest")),
        ),
        by_pixels(
            Measure::new(TEXTS.get("measure-gouraud-flicker-peak"), "", flicker_gouraud),
            tolerance > MOST_TOLERANCE,
            &|measure| measure.expect(1.0 - of_nearest, tolerance, off_pixel.clone()),
        ),
        Measure::new(TEXTS.get("measure-phong-flicker-peak"), "", flicker_phong),
        Measure::new(TEXTS.get("measure-gouraud-same-beyond"), "", beyond_diffuse(flicker_gouraud)),
    ];
    let moved = Moved {
        name: match is_seen(lost_on_sphere) {
            true => TEXTS.get("moved"),
            false => TEXTS.get("moved-flicker-highlight-peak"),
        },
        unit: "",
        bad: reported(lost_on_sphere, beyond_diffuse(flicker_gouraud)),
        present: Threshold::HALF_STEP,
        cure: TEXTS.get("cure"),
        cured: reported(lost_on_sphere, beyond_diffuse(flicker_phong)),
        factor: 100.0,
    };
    // The light that the highlight has in its middle is 1.
    let lacking = |[gouraud, phong]: [&Image; 2], lost: f64, angle: f64| -> Result<Moved, ArtefactError> {
        Ok(Moved {
            name: match is_seen(lost) {
                true => TEXTS.get("moved-highlight-missing-peak"),
                false => TEXTS.get("moved-highlight-missing-peak-far"),
            },
            bad: reported(lost, (1.0 - peak(gouraud)? - of_diffuse(angle)).max(0.0)),
            // Of diffuse light nothing lacks there: the normals in the middle face the light.
            cured: reported(lost, (1.0 - peak(phong)?).max(0.0)),
            // The highlight's middle may lie between four pixels.
            factor: 5.0,
            ..moved.clone()
        })
    };
    let of_plate = lacking([&plate_gouraud, &plate_phong], lost_on_plate, Radians::from(TILT).0)?;
    let of_sphere = lacking([&worst, &cured], lost_on_sphere, 0.5 * delta)?;
    Ok(Outcome {
        verdict: verdict(segments, exponent),
        shots: vec![
            of_plate.bad_shot(
                "plate-gouraud",
                TEXTS.get("plate-gouraud-title"),
                [
                    TEXTS.get("plate-gouraud-caption-all-four-corners"),
                    match is_lost(Radians::from(TILT).0, exponent) {
                        true => TEXTS.get("plate-gouraud-caption-whole-plate-evenly"),
                        false => TEXTS.get("plate-gouraud-caption-highlight-wide-they"),
                    },
                ],
                plate_gouraud,
            ),
            of_plate.cured_shot(
                "plate-phong",
                TEXTS.get("plate-phong-title"),
                [
                    TEXTS.get("plate-phong-caption-same-triangles-interpolated"),
                    TEXTS.get("plate-phong-caption-highlight"),
                ],
                plate_phong,
            ),
            of_sphere.bad_shot(
                "sphere-gouraud",
                TEXTS.get("sphere-gouraud-title"),
                [
                    TEXTS.with(
                        "sphere-gouraud-caption-n-facets-round",
                        &[("from", (f64::from(segments)).into()), ("exponent", exponent.into())],
                    ),
                    match is_lost(0.5 * delta, exponent) {
                        true => TEXTS.get("sphere-gouraud-caption-dull-bar-between"),
                        false => TEXTS.get("sphere-gouraud-caption-wider-facet-dulled"),
                    },
                ],
                worst,
            ),
            of_sphere.cured_shot(
                "sphere-phong",
                TEXTS.get("sphere-phong-title"),
                [
                    TEXTS.get("sphere-phong-caption-same-sphere-phong"),
                    TEXTS.get("sphere-phong-caption-highlight-round-place"),
                ],
                cured,
            ),
            Shot::truth(
                "sphere-exact",
                TEXTS.get("sphere-exact-title"),
                TEXTS.get("sphere-exact-caption-every-pixel-normal"),
                truth,
            ),
            moved.bad_shot(
                "film",
                TEXTS.get("film-title"),
                [
                    TEXTS.get("film-caption-highlight-close-while"),
                    match moved.is_cured() {
                        true => TEXTS.get("film-caption-gouraud-gets-dimmer"),
                        false => TEXTS.get("film-caption-both-get-dimmer"),
                    },
                ],
                film(&setup.parameters)?,
            ),
        ],
        charts: vec![chart([gouraud, phong], exponent, delta, &moved)],
        // What is black throughout does not flicker, but is not cured either.
        moved: if of_sphere.is_cured() { moved } else { of_sphere },
        measures,
        notes: vec![TEXTS.get("note-gouraud-shading-mixes")],
    })
}

/// A frame of the sphere turning by two segments, with Gouraud's shading at the left and Phong's at the right.
fn frame(setup: &Setup, number: u32, count: u32) -> Result<Image, ArtefactError> {
    let Parameters { size, segments, exponent, .. } = setup.parameters;
    let turn = 2.0 * TAU / f64::from(segments) * f64::from(number) / f64::from(count.max(1));
    let globe = Body::globe(segments, turn);
    let paint = |shading| paint(globe.object(material(exponent)), size, shading);
    Ok(tiles(&[vec![paint(Shading::Gouraud)?, paint(Shading::Phong)?]]))
}

/// Three pictures of a turn by a segment from close by, under Gouraud's shading and Phong's.
fn film(parameters: &Parameters) -> Result<Image, ArtefactError> {
    const PICTURES: u32 = 3;
    let &Parameters { size, segments, exponent, .. } = parameters;
    let row = |shading| {
        let picture = |k: u32| {
            let turn = TAU / f64::from(segments) * f64::from(k) / f64::from(PICTURES - 1);
            let globe = Body::globe(segments, turn);
            look(globe.object(material(exponent)), size / PICTURES - GAP, shading, CLOSE)
        };
        (0..PICTURES).map(picture).collect::<Result<Vec<_>, ArtefactError>>()
    };
    Ok(tiles(&[row(Shading::Gouraud)?, row(Shading::Phong)?]))
}

fn chart([gouraud, phong]: [Vec<[f64; 2]>; 2], exponent: f64, delta: f64, moved: &Moved) -> Chart {
    let theory = (0..=64).map(|k| {
        let turn = delta * f64::from(k) / 64.0;
        [Degrees::from(Radians(turn)).0, law(turn.min(delta - turn), exponent)]
    });
    let curve = |name, drawn, points| Curve { name, drawn, points };
    Chart {
        name: "flicker",
        title: TEXTS.get("chart-title"),
        caption: match moved.is_present() && moved.is_cured() {
            true => TEXTS.get("chart-caption"),
            false => TEXTS.get("chart-caption-brightest-pixel-against"),
        },
        x: Scale::linear(TEXTS.get("axis-turn-degrees")),
        y: Scale::linear(TEXTS.get("axis-peak-luminance")),
        curves: vec![
            curve(Text::same("Gouraud"), Drawn::Points, gouraud),
            curve(Text::same("Phong"), Drawn::Points, phong),
            curve(TEXTS.get("closed-form-gouraud"), Drawn::Guide, theory.collect()),
        ],
    }
}

/// How far a peak falls, as a share of its largest.
fn flicker(peaks: &[[f64; 2]]) -> f64 {
    let values = || peaks.iter().map(|peak| peak[1]);
    let largest = values().fold(0.0, f64::max);
    (largest - values().fold(f64::INFINITY, f64::min)) / largest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn highlights_are_lost_and_found() {
        // The last: 1 − 0.4 cos(Δ/2) − 0.6 cosⁿ(Δ/2), computed apart from this program.
        for (segments, exponent, flicker) in [(12, 16.0, 0.2691), (16, 32.0, 0.2852), (24, 100.0, 0.3493)] {
            let parameters = Parameters { size: 160, segments, exponent, ..EXPERIMENT.defaults };
            let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
            outcome.prove();
            // Present: a tenth of the peak at least. Cured: what the raster of pixels leaves, less than a tenth of that.
            // A pixel's centre is up to 0.71 pixels from the vertex, of an edge of 15 pixels and more.
            let found = outcome.measured("Gouraud: flicker");
            assert!((found - flicker).abs() < 0.05, "{found}");
            // Of that, 0.4 parts of diffuse light fall by 1 − cos(Δ/2) on their own.
            let alone = 0.4 * (1.0 - libm::cos(PI / f64::from(segments)));
            let beyond = outcome.measured("Gouraud: the same");
            assert!((found - beyond - alone).abs() < 1e-12, "{beyond} of {found}");
            assert!(outcome.moved.bad > 0.1 && outcome.moved.reduction() > 10.0, "{:?}", outcome.moved);
            let peak = |name: &str| {
                let shot = outcome.shots.iter().find(|shot| shot.name == name).unwrap();
                Highlight::of(&shot.image).unwrap().peak
            };
            assert!(peak("plate-gouraud") < 0.5 * peak("plate-phong"));
            assert!(peak("sphere-gouraud") < peak("sphere-phong"));
            let still = EXPERIMENT.frame(&Setup { parameters, mesh: None }, 0, 2).unwrap();
            assert_eq!(still.size, [2 * 160 + 2, 160]);
        }
    }

    #[test]
    fn what_is_no_highlight_is_not_lost() {
        for (segments, exponent) in [(16, 0.0), (200, 1.0), (200, 32.0)] {
            let parameters = Parameters { size: 48, segments, exponent, ..EXPERIMENT.defaults };
            let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
            assert!(
                matches!(outcome.verdict, Verdict::Absent(_)),
                "{segments} {exponent}: {:?}",
                outcome.moved
            );
        }
    }

    /// A highlight as wide as diffuse light loses 0.6 (1 − cos(Δ/2)) = 0.0115 between vertices: it is seen, and no loss.
    #[test]
    fn what_is_wide_is_dulled() {
        let parameters = Parameters { size: 160, segments: 16, exponent: 1.0, ..EXPERIMENT.defaults };
        let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
        assert!(matches!(outcome.verdict, Verdict::HoldsOnlyIf(_)), "{:?}", outcome.verdict);
        // The brightest pixel is up to 0.71 pixels from a vertex, of an edge of 28: a fortieth of that fall of diffuse light.
        assert!((outcome.moved.bad - 0.0115).abs() < 0.0192 / 28.0, "{:?}", outcome.moved);
    }

    /// At the usual exponent the highlight is narrower than half a segment of 16, of 12 too, of 24 not.
    #[test]
    fn what_is_wider_than_facets_is_not_lost() {
        for (segments, exponent, holds) in
            [(16, 32.0, true), (12, 32.0, true), (24, 32.0, false), (16, 10.0, false)]
        {
            let verdict = verdict(segments, exponent);
            assert_eq!(matches!(verdict, Verdict::Holds(_)), holds, "{segments} {exponent}: {verdict:?}");
        }
    }
}
