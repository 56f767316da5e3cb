//! Phong's and Blinn's highlights.

// A sphere with nothing but a highlight: light from behind it, and the ratio of length to width of the highlight.
mod highlights;

use super::prelude::*;
use crate::shade::{Guards, blinn_exponent};
use highlights::{BEHIND, GRAZING, HalfWidths, WINDOW, ball, record_light_behind};
use std::f64::consts::{FRAC_PI_2, PI};

static TEXTS: Catalogue = catalogue!("texts");

pub(super) static EXPERIMENT: Experiment = Experiment {
    takes: &[ParameterName::Size, ParameterName::Exponent],
    defaults: Parameters { exponent: 10.0, ..Parameters::USUAL },
    ..Experiment::new("reflection-models", &TEXTS, run)
};

/// How many times nearer to Phong's highlight four times the exponent has to be.
const FACTOR: f64 = 5.0;

fn run(setup: &Setup) -> Result<Outcome> {
    let Parameters { size, exponent, .. } = setup.parameters;
    let [blinn, phong] = highlights::in_front(exponent);
    let values = [
        ("exponent", exponent.into()),
        ("blinn-exponent", blinn_exponent(exponent).into()),
        ("blinn-angle", blinn.into()),
        ("phong-angle", phong.into()),
        ("behind", BEHIND.0.into()),
    ];
    let mut out = Recorder::new(&TEXTS, &values);
    let effect = matched_exponent(size, exponent, &mut out)?;
    grazing_light(size, exponent, &mut out)?;
    record_light_behind(Reflection::Phong, exponent, size, &mut out)?;
    record_light_behind(Reflection::Blinn, exponent, size, &mut out)?;
    out.set("is-cured", if effect.is_cured() { "yes" } else { "no" });
    chart(exponent, &mut out);
    let verdict = match effect.is_cured() {
        true => Verdict::HoldsOnlyIf(out.text("holds-only-if")),
        false => Verdict::Fails(out.text("fails")),
    };
    Ok(out.finish(verdict, effect))
}

/// Light and viewer in front: Blinn's highlight with Phong's exponent and with four times that.
fn matched_exponent(size: u32, exponent: f64, out: &mut Recorder) -> Result<Effect> {
    let ball = |reflection, exponent| ball(reflection, exponent, Degrees(0.0), Guards::default(), size);
    let phong = ball(Reflection::Phong, exponent)?;
    let blinn = ball(Reflection::Blinn, exponent)?;
    let matched = ball(Reflection::Blinn, blinn_exponent(exponent))?;
    let largest = |image: &Image| largest_error(image, &phong);
    let (same, fourfold) = (largest(&blinn)?, largest(&matched)?);
    let radius = f64::from(size) / WINDOW;
    // Half a pixel turns the normal by 1/R over the cosine of its angle to the viewer, and the mirrored ray by twice that. Powers
    // change by √n of it at most, and by 1 for the smallest n.
    let pixel = 0.5 / radius * 2.0 * exponent.sqrt().max(1.0);
    let check = |law: f64, tolerance: f64| match pixel < 0.5 {
        true => Check::Near(law, tolerance),
        false => Check::Untested("highlight-below-pixel"),
    };
    out.measure("same-exponent", "", same, check(largest_difference(exponent, exponent), 0.5 * pixel));
    let law = largest_difference(exponent, blinn_exponent(exponent));
    // Near its largest the difference is flat; where powers are steep it is not.
    let tolerance = (0.1 * law + 1e-5).max(if exponent < 2.0 { 0.5 * pixel } else { 0.0 });
    out.measure("fourfold-exponent", "", fourfold, check(law, tolerance));
    let effect = out.effect("exponent", "", [same, fourfold], Threshold::half_step(), FACTOR);
    out.truth("phong", phong);
    out.bad("blinn-same-n", &effect, blinn);
    out.cured("blinn-4n", &effect, matched);
    Ok(effect)
}

/// The largest difference of Phong's highlight and Blinn's of another exponent over the angle to the mirrored ray, by a scan.
fn largest_difference(exponent: f64, of_blinn: f64) -> f64 {
    let difference = |k: u32| {
        let phi = f64::from(k) / 1e4 * PI;
        // Mirrored away from the viewer there is nothing, whatever the exponent.
        let phong = if phi < FRAC_PI_2 { libm::pow(libm::cos(phi), exponent) } else { 0.0 };
        (phong - libm::pow(libm::cos(0.5 * phi), of_blinn)).abs()
    };
    (0..=10_000).map(difference).fold(0.0, f64::max)
}

fn grazing_light(size: u32, exponent: f64, out: &mut Recorder) -> Result<()> {
    let four = blinn_exponent(exponent);
    let ball = |reflection, exponent| ball(reflection, exponent, GRAZING, Guards::default(), size);
    let (phong, blinn) = (ball(Reflection::Phong, exponent)?, ball(Reflection::Blinn, four)?);
    let widths = HalfWidths::of_phong(exponent);
    let of_phong = widths.measure("width-phong", &phong, highlights::phong_at(exponent), out);
    let widths = HalfWidths::of_blinn(four);
    let of_blinn = widths.measure("width-blinn", &blinn, highlights::blinn_at(four), out);
    let present = Threshold { value: 0.1, why: out.text("why-width") };
    let effect = out.effect("width", "", [of_phong, of_blinn], present, FACTOR);
    out.bad("phong-grazing", &effect, phong);
    out.cured("blinn-grazing", &effect, blinn);
    Ok(())
}

fn chart(exponent: f64, out: &mut Recorder) {
    let curve = |name, value: &dyn Fn(f64) -> f64| {
        let degrees = (0..=180).map(|k| f64::from(k) * 0.5);
        let points = degrees.map(|degrees| [degrees, value(Radians::from(Degrees(degrees)).0)]);
        out.curve(name, Drawn::Curve, points.collect())
    };
    let power = |cosine: f64, n: f64| libm::pow(cosine, n);
    let curves = vec![
        curve("phong", &|phi| power(libm::cos(phi), exponent)),
        curve("blinn-same-n", &|phi| power(libm::cos(0.5 * phi), exponent)),
        curve("blinn-4n", &|phi| power(libm::cos(0.5 * phi), blinn_exponent(exponent))),
    ];
    out.chart("highlights", [Axis::Linear; 2], curves);
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
            assert!(outcome.effect.bad > 0.2 && outcome.effect.reduction() > 10.0, "{:?}", outcome.effect);
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
                outcome.effect
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
                    assert_ne!(measure.agrees, Some(false), "{size} {exponent}: {measure:?}");
                }
            }
        }
    }
}
