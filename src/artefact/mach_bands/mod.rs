//! Mach bands on a cylinder: steps of flat shading, slope jumps of Gouraud's and Phong's.

// A cylinder in facets, luminance across it, and its jumps at an edge in closed form.
mod tube;
// Pictures of the cylinder, maps of its slope jumps, and luminance across it with its derivatives.
mod pictures;
// The overshoot at edges that a model of lateral inhibition predicts.
mod predicted_overshoot;

use super::prelude::*;
use pictures::{Jumps, Lines};
use std::f64::consts::PI;
use tube::{Found, Law, Profile, Tube, flat_step, gouraud_jump, phong_jump};

static TEXTS: Catalogue = catalogue!("texts");

pub(super) static EXPERIMENT: Experiment = Experiment {
    takes: &[ParameterName::Size, ParameterName::Segments, ParameterName::Light],
    // With fewer facets no edge may be visible; with more, those of the finer cylinder would be a few pixels wide.
    ranges: &[(ParameterName::Segments, [6.0, 128.0])],
    // So few that bands are visible; with an odd number of facets in the light no two neighbours are alike.
    defaults: Parameters { segments: 10, light: Degrees(30.0), ..Parameters::USUAL },
    ..Experiment::new("mach-bands", &TEXTS, run)
};

/// How many times more segments the cured cylinder has.
const FINER: u32 = 4;

fn run(setup: &Setup) -> Result<Outcome> {
    let Parameters { size, segments, light, .. } = setup.parameters;
    let values = [
        ("segments", f64::from(segments).into()),
        ("finer", (FINER * segments).into()),
        ("factor", FINER.into()),
        ("light", light.0.into()),
    ];
    let mut out = Recorder::new(&TEXTS, &values);
    let (tube, fine) = (Tube::under(light, segments)?, Tube::under(light, FINER * segments)?);
    let lines = Lines::new(&tube, light)?;
    let edges = Edges::measure(&tube, &fine, light, &lines, &mut out)?;
    measure_counter_example(segments, &mut out)?;
    predicted_overshoot::measure(&tube, &fine, light, &mut out)?;
    measure_halfway(light, segments, &mut out)?;
    // Jumps are of first order in the width of a facet, and of more where tangents grow.
    let bad = edges.worse.found.measured.abs();
    let effect = out.effect("finer", "1/R", [bad, edges.of_fine.abs()], threshold(&tube, &out), 3.5);
    // Another shading has to make bands visibly smaller, not to remove them.
    let of_shading = |numbers: [f64; 2], tube: &Tube, out: &Recorder| {
        out.effect("shading", "1/R", numbers, threshold(tube, out), 1.5)
    };
    let step = Effect {
        name: out.text("flat-effect"),
        unit: "",
        bad: edges.step.measured.abs(),
        present: Threshold::half_step(),
        ..effect.clone()
    };
    let of_other = of_shading([bad, edges.better.measured.abs()], &tube, &out);
    let grazing = Jumps::measure(Tube::under(GRAZING, segments)?, GRAZING)?;
    let of_grazing = of_shading(grazing.largest(), &grazing.tube, &out);
    pictures::record_charts(&lines, &of_other, &mut out);
    predicted_overshoot::charts(&tube, light, &mut out)?;
    pictures::record_grazing(&grazing.tube, GRAZING, &of_grazing, &mut out)?;
    let worse = edges.worse.shading;
    pictures::record(size, light, [&tube, &fine], worse, [&step, &of_other, &effect], &mut out)?;
    grazing.show(size, GRAZING, &of_grazing, &mut out)?;
    let verdict = match worse {
        Shading::Gouraud => Verdict::HoldsOnlyIf(out.text("holds-only-if")),
        _ => Verdict::Fails(out.text("fails")),
    };
    Ok(out.finish(verdict, effect))
}

struct Edges {
    /// Of flat shading.
    step: Found,
    worse: Worse,
    /// Of the other shading.
    better: Found,
    /// Of the worse shading on the finer cylinder, at the same edge.
    of_fine: f64,
}

/// Gouraud's or Phong's shading: the one whose slope jumps more.
struct Worse {
    name: &'static str,
    shading: Shading,
    law: Law,
    found: Found,
}

impl Edges {
    fn measure(tube: &Tube, fine: &Tube, light: Degrees, lines: &Lines, out: &mut Recorder) -> Result<Self> {
        let delta = tube.delta();
        let step =
            tube.largest(light, |theta| (lines.flat.step(tube, theta), flat_step(theta, light, delta)));
        let largest = |line: &Profile, law: Law| {
            tube.largest(light, |theta| (line.slope_jump(tube, theta).0, law(theta, light, delta)))
        };
        let (gouraud, phong) = (largest(&lines.gouraud, gouraud_jump), largest(&lines.phong, phong_jump));
        let of_gouraud =
            Worse { name: "Gouraud", shading: Shading::Gouraud, law: gouraud_jump, found: gouraud };
        let of_phong = Worse { name: "Phong", shading: Shading::Phong, law: phong_jump, found: phong };
        let is_gouraud_worse = gouraud.measured.abs() > phong.measured.abs();
        let (worse, better) = if is_gouraud_worse { (of_gouraud, of_phong) } else { (of_phong, of_gouraud) };
        out.set("worse", worse.name);
        out.set("better", better.name);
        let better = better.found;
        // At the same edge, which the finer one has too.
        let (at, fine_line) = (worse.found.theta, fine.profile(light, worse.shading)?);
        let (of_fine, by_fine) = fine_line.slope_jump(fine, at);
        out.measure("flat-step", "", step.measured, Check::Near(step.law, 1e-6));
        for (name, line, found) in
            [("gouraud-jump", &lines.gouraud, gouraud), ("phong-jump", &lines.phong, phong)]
        {
            let (_, tolerance) = line.slope_jump(tube, found.theta);
            out.measure(name, "1/R", found.measured, Check::Near(found.law, tolerance));
        }
        let law = (worse.law)(at, light, fine.delta());
        out.measure("fine-jump", "1/R", of_fine, Check::Near(law, by_fine));
        Ok(Self { step, worse, better, of_fine })
    }
}

/// The jump of slope above which a luminance that is straight over a facet of width w is off a round one by half a step of 8
/// bits: in the middle it is off by w/8 times the jump.
fn threshold(tube: &Tube, out: &Recorder) -> Threshold {
    Threshold {
        value: 8.0 * Threshold::HALF_STEP / (2.0 * libm::sin(0.5 * tube.delta())),
        why: out.text("why-slope"),
    }
}

/// Light in which Phong's shading is the worse one.
const GRAZING: Degrees = Degrees(80.0);
/// The light at which Phong's jump half-way between viewer and light is as large as Gouraud's: arccos(1/3).
const BORDER: f64 = 70.528_779_365_509_31;
/// How much larger their ratio is a degree farther on: cot(θ_L/2) + tan(θ_L) there, per radian.
const GROWTH: f64 = 3.0 * std::f64::consts::SQRT_2 * PI / 180.0;

fn measure_counter_example(segments: u32, out: &mut Recorder) -> Result<()> {
    let (worst, open) = ratio(GRAZING, segments)?;
    let (border, open_there) = border(segments)?;
    let theta = half(GRAZING);
    let delta = 2.0 * PI / f64::from(segments);
    let law = phong_jump(theta, GRAZING, delta) / gouraud_jump(theta, GRAZING, delta);
    // The facets next to the edge have to be lit as a whole: half of 80° and one facet are less than 90° then.
    let check = |value, tolerance| match theta + delta > PI / 2.0 {
        true => Check::Untested("facets-lit-in-part"),
        false => Check::Near(value, tolerance),
    };
    out.measure("grazing-ratio", "", worst, check(law, open));
    out.measure("border-angle", "°", border, check(BORDER, open_there / GROWTH + RESOLVED));
    Ok(())
}

/// How much larger Phong's jump is than Gouraud's under this light, at an edge half-way between viewer and light, where the facets next
/// to it are lit as a whole. The difference is 0 at 70.53°.
fn measure_halfway(light: Degrees, segments: u32, out: &mut Recorder) -> Result<()> {
    let (theta, delta) = (half(light), 2.0 * PI / f64::from(segments));
    if theta.abs() + delta <= PI / 2.0 {
        let [(phong, by_phong), (gouraud, by_gouraud)] = jumps(light, segments)?;
        let law = phong_jump(theta, light, delta).abs() - gouraud_jump(theta, light, delta).abs();
        let value = phong.abs() - gouraud.abs();
        out.measure("halfway-difference", "1/R", value, Check::Near(law, by_phong + by_gouraud));
    }
    Ok(())
}

fn half(Degrees(angle): Degrees) -> f64 {
    Radians::from(Degrees(angle / 2.0)).0
}

/// The slope jumps of Phong's and Gouraud's shading half-way between the viewer and the light, where Phong's is worst, with their
/// rounding.
fn jumps(light: Degrees, segments: u32) -> Result<[(f64, f64); 2]> {
    let tube = Tube::new(segments, half(light))?;
    let jump = |shading| tube.profile(light, shading).map(|line| line.slope_jump(&tube, half(light)));
    Ok([jump(Shading::Phong)?, jump(Shading::Gouraud)?])
}

/// Their ratio, and its rounding.
fn ratio(light: Degrees, segments: u32) -> Result<(f64, f64)> {
    let [(phong, by_phong), (gouraud, by_gouraud)] = jumps(light, segments)?;
    let ratio = phong / gouraud;
    Ok((ratio, ratio.abs() * (by_phong / phong.abs() + by_gouraud / gouraud.abs())))
}

/// The resolution of the angle after halving.
const RESOLVED: f64 = 20.0 / 2048.0;

/// The angle of the light at which Phong's jump is as large as Gouraud's, in degrees, by halving; and the rounding of the ratio.
fn border(segments: u32) -> Result<(f64, f64)> {
    let (mut low, mut high, mut open) = (60.0, 80.0, 0.0);
    for _ in 0..10 {
        let middle = 0.5 * (low + high);
        let (ratio, moved) = ratio(Degrees(middle), segments)?;
        open = moved;
        if ratio.abs() > 1.0 { high = middle } else { low = middle }
    }
    Ok((0.5 * (low + high), open))
}

#[cfg(test)]
mod tests {
    use super::tube::slope_weights;
    use super::*;
    use crate::num::Radians;
    use std::f64::consts::TAU;

    #[test]
    fn every_edge_follows_its_closed_form() {
        for (segments, light) in
            [(16, 0.0), (16, 30.0), (16, -45.0), (16, 80.0), (7, 30.0), (64, 60.0), (512, 30.0)]
        {
            let light = Degrees(light);
            let tube = Tube::under(light, segments).unwrap();
            let profile = |shading| tube.profile(light, shading).unwrap();
            let (gouraud, phong) = (profile(Shading::Gouraud), profile(Shading::Phong));
            let flat = profile(Shading::Flat);
            assert!(tube.edges(light).count() >= 1);
            for theta in tube.edges(light) {
                for (line, law) in [(&gouraud, gouraud_jump as Law), (&phong, phong_jump)] {
                    let (found, tolerance) = line.slope_jump(&tube, theta);
                    let law = law(theta, light, tube.delta());
                    // Below a third of the jumps under frontal light; otherwise the test would show nothing.
                    let largest = gouraud_jump(theta, Degrees(0.0), tube.delta()).abs();
                    assert!(tolerance < 0.3 * largest, "{segments} {theta}: {tolerance} of {largest}");
                    assert!(
                        (found - law).abs() <= tolerance,
                        "{segments} {theta} {light:?}: {found} is not {law}"
                    );
                }
                let (found, law) = (flat.step(&tube, theta), flat_step(theta, light, tube.delta()));
                assert!((found - law).abs() <= 1e-6, "{segments} {theta} {light:?}: {found} is not {law}");
            }
        }
    }

    /// Figures computed outside this program: N = 16 at θ = 30° under a light from the viewer, and at −45° under one at
    /// −80°.
    #[test]
    fn closed_forms_have_their_published_values() {
        let delta = TAU / 16.0;
        let [theta, across] = [30.0, -45.0].map(|angle| Radians::from(Degrees(angle)).0);
        for (found, printed) in [
            (gouraud_jump(theta, Degrees(0.0), delta), -0.537_52),
            (phong_jump(theta, Degrees(0.0), delta), -0.134_38),
            (gouraud_jump(across, Degrees(-80.0), delta), -0.143_85),
            (phong_jump(across, Degrees(-80.0), delta), 0.335_99),
        ] {
            assert!((found - printed).abs() < 6e-6, "{found} is not {printed}");
        }
    }

    fn run(light: f64, segments: u32) -> Outcome {
        let parameters = Parameters { size: 48, light: Degrees(light), segments, ..EXPERIMENT.defaults };
        EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap()
    }

    #[test]
    fn the_artefact_is_there_and_is_cured() {
        let outcome = run(30.0, 16);
        for measure in &outcome.measures {
            assert_eq!(measure.agrees, Some(true), "{measure:?}");
        }
        // Jumps of first order: a quarter, and less where tangents grow.
        assert!(outcome.effect.bad > 0.3 && outcome.effect.reduction() > 3.5, "{:?}", outcome.effect);
        assert!(matches!(outcome.verdict, Verdict::HoldsOnlyIf(_)));
    }

    /// Duff's angle is found by moving the light, with few segments and with many.
    #[test]
    fn phong_is_the_worse_one_half_way_from_duffs_angle_on() {
        for (segments, light, is_phong_worse) in
            [(10, 70.0, false), (10, 71.0, true), (32, 70.0, false), (32, 71.0, true), (32, -71.0, true)]
        {
            let outcome = run(light, segments);
            let last = outcome.measures.last().unwrap();
            assert_eq!(last.unit, "1/R");
            assert_eq!(last.agrees, Some(true), "{last:?}");
            assert_eq!(last.value > 0.0, is_phong_worse, "{segments} {light}: {last:?}");
        }
    }

    /// From 70.53° on there may be edges where Phong is the worse one; at 80° there are. The pictures are labelled by that.
    #[test]
    fn in_grazing_light_the_claim_fails() {
        use super::super::effect::Role;
        for (light, is_gouraud_worse) in [(60.0, true), (-60.0, true), (80.0, false), (-80.0, false)] {
            let outcome = run(light, 16);
            let [gouraud, phong] = [1, 2].map(|k| outcome.measures[k].value.abs());
            assert_eq!(gouraud > phong, is_gouraud_worse, "{light}: {gouraud} {phong}");
            assert_eq!(matches!(outcome.verdict, Verdict::HoldsOnlyIf(_)), is_gouraud_worse, "{light}");
            assert_eq!(matches!(outcome.verdict, Verdict::Fails(_)), !is_gouraud_worse, "{light}");
            let role = |name| outcome.shots.iter().find(|shot| shot.name == name).unwrap().role;
            assert_eq!(role("gouraud") == Role::Bad, is_gouraud_worse, "{light}");
            assert_eq!(role("phong") == Role::Bad, !is_gouraud_worse, "{light}");
            assert!(outcome.charts.iter().any(|chart| chart.name == "slope-80"));
        }
    }

    #[test]
    fn where_nothing_is_lit_or_facets_are_fine_nothing_is_claimed() {
        for (light, segments) in [(180.0, 16), (30.0, 128)] {
            let outcome = run(light, segments);
            assert!(
                matches!(outcome.verdict, Verdict::Absent(_)),
                "{light} {segments}: {:?}",
                outcome.effect
            );
        }
        let parameters = Parameters { segments: 5, ..EXPERIMENT.defaults };
        let error = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap_err().to_string();
        assert!(error.contains("6 to 128"), "{error}");
    }

    #[test]
    fn slopes_of_polynomials_are_exact() {
        let nodes = [1.0, 1.5, 2.0, 3.0];
        let slope: f64 =
            slope_weights(0.5, &nodes).iter().zip(nodes).map(|(weight, x)| weight * (x * x * x - x)).sum();
        // 3x² − 1 at 0.5; a few roundings of numbers up to 24.
        assert!((slope + 0.25).abs() < 1e-13);
    }
}
