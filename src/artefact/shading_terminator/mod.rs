//! The border between light and shadow on a coarse mesh.

// Light on a sphere and on a prism, one facet of which turns away from it.
mod scene;

use super::prelude::*;
use crate::shade::Terminator;
use scene::{HEIGHT, LEVEL, Prism, concerned, mean_where, paint, picture, share, towards};

static TEXTS: Catalogue = catalogue!("texts");

pub(super) static EXPERIMENT: Experiment = Experiment {
    takes: &[ParameterName::Size, ParameterName::Segments, ParameterName::Light],
    // More, and four times as many in the cured picture, would be hardly larger than pixels.
    ranges: &[(ParameterName::Segments, [3.0, 256.0])],
    defaults: Parameters { segments: 16, light: Degrees(80.0), ..Parameters::USUAL },
    frame: Some(frame),
    ..Experiment::new("shading-terminator", &TEXTS, run)
};

/// Segments of the finest sphere: so many that its teeth are hardly larger than pixels, and four times as many at least.
fn finest(segments: u32) -> u32 {
    (16 * segments).min(256).max(4 * segments)
}

fn run(setup: &Setup) -> Result<Outcome> {
    let Parameters { size, segments, light, .. } = setup.parameters;
    let prism = Prism { segments, size };
    let values = [
        ("finest", finest(segments).into()),
        ("turn", prism.turn().0.into()),
        ("step", prism.step().0.into()),
        ("light", light.0.into()),
    ];
    let mut out = Recorder::new(&TEXTS, &values);
    let on_prism = share(&concerned(&prism.mesh(), towards(light, LEVEL), size)?);
    let (share_law, share_open) = prism.share_law(light);
    out.measure("prism-share", "", on_prism, Check::Near(share_law, share_open));
    let (self_shadow, cost) = sphere(&setup.parameters, &mut out)?;
    let popping = popping(&prism, &mut out)?;
    cost.show(&mut out);
    prism.chart(&mut out)?;
    // The prism has a light of its own. Its artefact is visible on the sphere only if facets of the sphere take light away.
    let verdict = match self_shadow.is_present() {
        false => Verdict::Absent(out.text("shown-by")),
        true => Verdict::HoldsOnlyIf(out.text("holds-only-if")),
    };
    Ok(out.finish(verdict, popping))
}

struct Cost {
    effect: Effect,
    coarse: Image,
    fine: Image,
}

impl Cost {
    fn show(self, out: &mut Recorder) {
        out.bad("soft", &self.effect, self.coarse);
        out.cured("soft-fine", &self.effect, self.fine);
    }
}

/// The sphere whose facets shade themselves, and the cost of softening that.
fn sphere(
    &Parameters { size, segments, light, .. }: &Parameters,
    out: &mut Recorder,
) -> Result<(Effect, Cost)> {
    let globe = |segments, terminator| globe(segments, light, terminator, size);
    let (hard, smooth) = (globe(segments, Terminator::Hard)?, globe(segments, Terminator::Smooth)?);
    let (coarse, fine) = (globe(segments, Terminator::Soft)?, globe(finest(segments), Terminator::Soft)?);
    let concerned = |segments| concerned(&TriangleMesh::globe(segments, 0.0), towards(light, HEIGHT), size);
    let (map_of_coarse, map_of_fine) = (concerned(segments)?, concerned(finest(segments))?);
    out.measure("sphere-share", "", share(&map_of_coarse), Check::None);
    out.measure("fine-sphere-share", "", share(&map_of_fine), Check::None);
    out.measure("sphere-shadow", "", largest_difference(&hard, &smooth), Check::None);
    let exact = Object::new(Shape::Surface(Primitive::from(Sphere::default())), chalk());
    let truth = picture(exact, towards(light, HEIGHT), (Shading::Exact, Terminator::Smooth), [size; 2])?;
    let error = |image: &Image| mean_where(&map_of_coarse, &differences(image, &truth));
    let errors = [error(&hard), error(&smooth)];
    let effect = out.effect("shadow", "", errors, Threshold::half_step(), 10.0);
    // With a quarter of the cost the teeth are still visible.
    let costs = [
        largest_difference(&coarse, &smooth),
        largest_difference(&fine, &globe(finest(segments), Terminator::Smooth)?),
    ];
    let cost = out.effect("cost", "", costs, Threshold::half_step(), 10.0);
    out.bad("hard", &effect, hard);
    out.cured("smooth", &effect, smooth);
    out.difference("concerned", map([size; 2], &map_of_coarse, 1.0), 1.0, "");
    Ok((effect, Cost { effect: cost, coarse, fine }))
}

/// The facet of the prism that goes out as the light turns. This is the effect that the experiment reports.
fn popping(prism: &Prism, out: &mut Recorder) -> Result<Effect> {
    let (hard, soft) = (prism.pop(Terminator::Hard)?, prism.pop(Terminator::Soft)?);
    out.measure("pop-hard", "", hard, Check::Near(prism.pop_law(Terminator::Hard), 2e-3));
    out.measure("pop-soft", "", soft, Check::Near(prism.pop_law(Terminator::Soft), 2e-4));
    let effect = out.effect("pop", "", [hard, soft], Threshold::half_step(), 10.0);
    out.bad("film-hard", &effect, prism.film(Terminator::Hard)?);
    out.cured("film-soft", &effect, prism.film(Terminator::Soft)?);
    Ok(effect)
}

/// The sphere while the light goes round it: at the left facets shade themselves, at the right that is softened.
fn frame(setup: &Setup, number: u32, count: u32) -> Result<Image> {
    let Parameters { size, segments, .. } = setup.parameters;
    let light = Degrees(360.0 * f64::from(number) / f64::from(count.max(1)));
    let globe = |terminator| globe(segments, light, terminator, size);
    Ok(tiles(&[vec![globe(Terminator::Hard)?, globe(Terminator::Soft)?]]))
}

fn globe(segments: u32, light: Degrees, terminator: Terminator, size: u32) -> Result<Image> {
    paint(&TriangleMesh::globe(segments, 0.0), towards(light, HEIGHT), terminator, [size; 2])
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
                outcome.effect.bad > 0.9 * sine && outcome.effect.reduction() > 10.0,
                "{:?}",
                outcome.effect
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
            assert_eq!(taken > Threshold::HALF_STEP, is_seen, "{segments}: {taken}");
            assert_eq!(matches!(outcome.verdict, Verdict::Absent(_)), !is_seen, "{segments}");
        }
    }
}
