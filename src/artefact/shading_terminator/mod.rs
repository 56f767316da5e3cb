//! The border of light on a coarse mesh.

mod texts;
mod tube;

use super::body::Body;
use super::stage::{chalk, differences, draw, front, linear, map, settings, tiles};
use super::{
    ArtefactError, Experiment, Knob, Measure, Moved, Outcome, Parameters, Setup, Shot, Text, Threshold,
    Verdict,
};
use crate::num::{Degrees, LinearRgb, Radians};
use crate::raster::{Image, Interpolation, Object, RenderSettings, Shading, Shape, Show};
use crate::shade::{Light, Terminator};
use crate::surface::{Primitive, Sphere};
use glam::DVec3;
use texts::TEXTS;
use tube::Tube;

pub(super) static EXPERIMENT: Experiment = Experiment {
    id: "shading-terminator",
    texts: &TEXTS,
    takes: &[Knob::Size, Knob::Segments, Knob::Light],
    // More, and four times as many in the cured picture, would be hardly larger than pixels.
    segments: 3..=256,
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
        name: TEXTS.get("moved"),
        unit: "",
        bad: off(&hard),
        present: Threshold::HALF_STEP,
        cure: TEXTS.get("cure"),
        cured: off(&smooth),
        factor: 10.0,
    };
    let price = Moved {
        name: TEXTS.get("moved-most-light-softening"),
        bad: taken(&soft, &smooth),
        cure: TEXTS.get("cure-finer-facets"),
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
        cure: TEXTS.get("cure-chiang-li-burley"),
        cured: pop_soft,
        ..self_shadow.clone()
    };
    let (share_law, share_open) = tube.share_law(light);
    let by_formula = TEXTS.get("formula-every-pixel");
    let measures = vec![
        Measure::new(TEXTS.get("measure-prism-share-pixels"), "", on_tube).expect(
            share_law,
            share_open,
            TEXTS.get("by-cosines-every-pixel"),
        ),
        Measure::new(TEXTS.get("measure-sphere-share-pixels"), "", share(&coarse_map)),
        Measure::new(
            Text::made(
                format!("sphere with {} segments: share of pixels concerned", finest(segments)),
                format!("esfera com {} segmentos: parcela dos pixels em questão", finest(segments)),
            ),
            "",
            share(&fine_map),
        ),
        Measure::new(TEXTS.get("measure-sphere-most-light"), "", taken(&hard, &smooth)),
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
        false => Verdict::Absent(TEXTS.get("shown-by")),
        true => Verdict::HoldsOnlyIf(TEXTS.get("holds-only-if-facets-shade-themselves")),
    };
    let Degrees(step) = tube.step();
    Ok(Outcome {
        verdict,
        measures,
        shots: vec![
            self_shadow.bad_shot(
                "hard",
                TEXTS.get("hard-title"),
                [
                    TEXTS.get("hard-caption-smooth-normals-but"),
                    TEXTS.get("hard-caption-border-saw-triangles"),
                ],
                hard,
            ),
            self_shadow.cured_shot(
                "smooth",
                TEXTS.get("smooth-title"),
                [
                    TEXTS.get("smooth-caption-interpolated-normals-alone"),
                    TEXTS.get("smooth-caption-smooth-light-facets"),
                ],
                smooth,
            ),
            Shot::difference(
                "concerned",
                TEXTS.get("concerned-title"),
                TEXTS.get("concerned-caption-yellow-interpolated-normal"),
                difference,
            ),
            popping.bad_shot(
                "film-hard",
                TEXTS.get("film-hard-title"),
                [
                    TEXTS.with("film-hard-caption-prism-picture-picture", &[("step", step.into())]),
                    TEXTS.get("film-hard-caption-facet-left-middle"),
                ],
                tube.film(Terminator::Hard)?,
            ),
            popping.cured_shot(
                "film-soft",
                TEXTS.get("film-soft-title"),
                [
                    TEXTS.get("film-soft-caption-same-softening-term"),
                    TEXTS.get("film-soft-caption-facet-gets-darker"),
                ],
                tube.film(Terminator::Soft)?,
            ),
            price.bad_shot(
                "soft",
                TEXTS.get("soft-title"),
                [TEXTS.get("soft-caption-softening-term-costs"), TEXTS.get("soft-caption-facets-about-turn")],
                soft,
            ),
            price.cured_shot(
                "soft-fine",
                TEXTS.get("soft-fine-title"),
                [
                    Text::made(
                        format!("{} segments and the softening term.", finest(segments)),
                        format!("{} segmentos e o termo de suavização.", finest(segments)),
                    ),
                    TEXTS.get("soft-fine-caption-facets-hardly-larger"),
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
        TEXTS.get("factor-continuous-facet"),
        TEXTS.with("three-lights-sphere", &[("value", light.0.into()), ("value-2", light.0.into())]),
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
