//! Mach bands on a cylinder: steps of flat shading, slope jumps of Gouraud's and Phong's.

mod duff;
mod pictures;
mod predicted;
mod texts;
mod tube;

use super::{
    ArtefactError, Experiment, Knob, Measure, Moved, Outcome, Parameters, Setup, Text, Threshold, Verdict,
};
use crate::num::{Degrees, Radians};
use crate::raster::Shading;
use texts::TEXTS;
use tube::{Found, Profile, Tube};

pub(super) static EXPERIMENT: Experiment = Experiment {
    id: "mach-bands",
    texts: &TEXTS,
    takes: &[Knob::Size, Knob::Segments, Knob::Light],
    // Of fewer facets no edge may be in sight; those of four times as many more would be a few pixels wide.
    segments: 6..=128,
    // So few that bands are seen with the naked eye; with an odd number of facets in the light no two neighbours are alike.
    defaults: Parameters { segments: 10, light: Degrees(30.0), ..Parameters::USUAL },
    run,
    frame: None,
};

/// Where Phong's shading is the worse one.
const GRAZING: Degrees = Degrees(80.0);
/// How many times more segments the cured cylinder has.
const FINER: u32 = 4;

fn run(setup: &Setup) -> Result<Outcome, ArtefactError> {
    let Parameters { size, segments, light, .. } = setup.parameters;
    let tube = Tube::under(light, segments)?;
    let lines = [Shading::Flat, Shading::Gouraud, Shading::Phong, Shading::Exact]
        .map(|shading| tube.profile(light, shading));
    let [flat, gouraud, phong, exact] = lines;
    let lines = Lines { flat: flat?, gouraud: gouraud?, phong: phong?, exact: exact? };
    let fine = Tube::under(light, FINER * segments)?;

    let step =
        tube.largest(light, |theta| (lines.flat.step(&tube, theta), flat_step(theta, light, tube.delta())));
    let of = |line: &Profile, law: Law| {
        tube.largest(light, |theta| (line.slope_jump(&tube, theta).0, law(theta, light, tube.delta())))
    };
    let (of_gouraud, of_phong) = (of(&lines.gouraud, gouraud_jump), of(&lines.phong, phong_jump));
    let is_gouraud_worse = of_gouraud.measured.abs() > of_phong.measured.abs();
    let worse = match is_gouraud_worse {
        true => Worse { name: "Gouraud", shading: Shading::Gouraud, law: gouraud_jump, found: of_gouraud },
        false => Worse { name: "Phong", shading: Shading::Phong, law: phong_jump, found: of_phong },
    };
    let is_phong_worse_at = |theta: f64| {
        phong_jump(theta, light, tube.delta()).abs() > gouraud_jump(theta, light, tube.delta()).abs()
    };
    // At the same edge, which the finer one has too.
    let (at, fine_line) = (worse.found.theta, fine.profile(light, worse.shading)?);
    let (of_fine, by_fine) = fine_line.slope_jump(&fine, at);

    let jump = |name: &str, line: &Profile, found: Found, notation: Text| {
        let name = TEXTS.with("name-largest-slope", &[("name", name.into())]);
        let (_, tolerance) = line.slope_jump(&tube, found.theta);
        Measure::new(name, "1/R", found.measured).expect(found.law, tolerance, notation)
    };
    let mut measures = vec![
        Measure::new(TEXTS.get("measure-flat-largest-step"), "", step.measured).expect(
            step.law,
            1e-6,
            TEXTS.get("by-sin-l-sin"),
        ),
        jump("Gouraud", &lines.gouraud, of_gouraud, TEXTS.get("cos-l-tan")),
        jump("Phong", &lines.phong, of_phong, TEXTS.get("sin-l-sin")),
        Measure::new(
            Text::made(
                format!("{} with {} segments: slope jump at the same edge", worse.name, FINER * segments),
                format!(
                    "{} com {} segmentos: salto de inclinação na mesma aresta",
                    worse.name,
                    FINER * segments
                ),
            ),
            "1/R",
            of_fine,
        )
        .expect((worse.law)(at, light, fine.delta()), by_fine, TEXTS.get("by-same-smaller")),
    ];
    measures.extend(duff::measures(segments)?);
    measures.extend(predicted::measures(&tube, &fine, light)?);
    let grazing = Tube::under(GRAZING, segments)?;
    let moved = Moved {
        name: Text::made(
            format!(
                "{}'s slope jump at the edge, within 60° of the direction of view, where it is largest",
                worse.name
            ),
            format!(
                "o salto de inclinação de {} na aresta, a até 60° da direção de visão, em que ele é maior",
                worse.name
            ),
        ),
        unit: "1/R",
        bad: worse.found.measured.abs(),
        present: threshold(&tube),
        cure: Text::made(
            format!("{FINER} times the segments, at the same edge"),
            format!("{FINER} vezes mais segmentos, na mesma aresta"),
        ),
        cured: of_fine.abs(),
        // Jumps are of first order in the width of a facet, and of more where tangents grow.
        factor: 3.5,
    };
    let better = if is_gouraud_worse { of_phong } else { of_gouraud };
    let [phong_at_80, gouraud_at_80] =
        [Shading::Phong, Shading::Gouraud].map(|shading| grazing.jumps(GRAZING, shading));
    let jumps_at_80 = [phong_at_80?, gouraud_at_80?];
    let largest = |jumps: &Vec<[f64; 2]>| jumps.iter().map(|jump| jump[1]).fold(0.0, f64::max);
    let [phong_at_80, gouraud_at_80] = jumps_at_80.each_ref().map(largest);
    // What another shading does need not make bands vanish, but be seen to be less.
    let other = |bad: f64, cured: f64, tube: &Tube| Moved {
        name: TEXTS.get("moved"),
        bad,
        cured,
        present: threshold(tube),
        factor: 1.5,
        ..moved.clone()
    };
    let shown = Shown {
        worse: &worse,
        step: Moved {
            name: TEXTS.get("moved-largest-step-within"),
            unit: "",
            bad: step.measured.abs(),
            present: Threshold::HALF_STEP,
            ..moved.clone()
        },
        other: other(worse.found.measured.abs(), better.measured.abs(), &tube),
        finer: moved.clone(),
        at_80: other(phong_at_80, gouraud_at_80, &grazing),
        jumps_at_80,
    };
    let mut charts = pictures::charts(&lines, &shown);
    charts.extend(predicted::charts(&tube, light)?);
    charts.extend(pictures::charts_of_grazing_light(&grazing, &shown.at_80)?);
    Ok(Outcome {
        verdict: verdict(is_gouraud_worse, tube.edges(light).any(is_phong_worse_at), light),
        measures,
        shots: pictures::shots(size, light, [&tube, &fine, &grazing], &shown)?,
        moved,
        charts,
        notes: notes(),
    })
}

/// Luminance across the picture.
struct Lines {
    flat: Profile,
    gouraud: Profile,
    phong: Profile,
    exact: Profile,
}

/// The shading whose slope jumps more.
struct Worse {
    name: &'static str,
    shading: Shading,
    law: Law,
    found: Found,
}

/// What the pictures are measured by.
struct Shown<'a> {
    worse: &'a Worse,
    /// Of flat shading.
    step: Moved,
    /// The shading whose slope jumps more, and the other one.
    other: Moved,
    /// The former, and the same with more segments.
    finer: Moved,
    /// In light at 80°, Phong's and Gouraud's.
    at_80: Moved,
    /// The same at each edge: its place across the picture, and the slope's jump.
    jumps_at_80: [Vec<[f64; 2]>; 2],
}

/// Where cos θ_L = 1/3: from there on Phong's slope jump is the larger one at some edge.
const DUFF: Degrees = Degrees(70.528_779_365_509_3);

/// By what was measured at the edges, and whether Phong's jump is the larger one at any of them.
fn verdict(is_gouraud_worse: bool, is_phong_worse_somewhere: bool, light: Degrees) -> Verdict {
    match is_gouraud_worse {
        true if light.0.abs() > DUFF.0 && !is_phong_worse_somewhere => {
            Verdict::HoldsOnlyIf(TEXTS.get("holds-only-if-no-edge-stands"))
        }
        true if light.0.abs() > DUFF.0 => {
            Verdict::HoldsOnlyIf(TEXTS.get("holds-only-if-largest-jumps-compared"))
        }
        true => Verdict::HoldsOnlyIf(TEXTS.get("holds-only-if-light-less-off")),
        false => Verdict::Fails(TEXTS.get("fails-light-far-off")),
    }
}

fn notes() -> Vec<Text> {
    vec![
        TEXTS.get("slope-luminance-jumps"),
        TEXTS.get("overshoot-called-predicted"),
        TEXTS.get("facets-meet-light"),
        TEXTS.get("jumps-first-order"),
    ]
}

/// The jump at an edge at the angle θ (radians) under a light, for facets of the angle Δ (radians).
type Law = fn(f64, Degrees, f64) -> f64;

fn flat_step(theta: f64, light: Degrees, delta: f64) -> f64 {
    2.0 * libm::sin(theta - Radians::from(light).0).abs() * libm::sin(delta / 2.0)
}

fn gouraud_jump(theta: f64, light: Degrees, delta: f64) -> f64 {
    -libm::cos(Radians::from(light).0) * (libm::tan(theta + delta / 2.0) - libm::tan(theta - delta / 2.0))
}

fn phong_jump(theta: f64, light: Degrees, delta: f64) -> f64 {
    let bend = libm::tan(theta + delta / 2.0) - libm::tan(theta - delta / 2.0);
    -libm::sin(theta - Radians::from(light).0) * libm::sin(theta) * bend
}

/// The jump of slope from which on a luminance that is straight over facets is off a round one by half a step of 8 bits: in the
/// middle of a facet of the width w it is w/8 times the jump.
fn threshold(tube: &Tube) -> Threshold {
    Threshold {
        value: 8.0 * Threshold::HALF_STEP.value / (2.0 * libm::sin(0.5 * tube.delta())),
        why: TEXTS.get("why-luminance-facet-half"),
    }
}

#[cfg(test)]
mod tests {
    use super::tube::slope_weights;
    use super::*;
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
                    // Less than a third of what jumps are under light from the front, or the test would say nothing.
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

    /// Figures computed apart from this program: N = 16 at θ = 30° under a light from the viewer, and at −45° under one at
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
            assert_eq!(measure.agrees(), Some(true), "{measure:?}");
        }
        // Jumps of first order: a quarter, and less where tangents grow.
        assert!(outcome.moved.bad > 0.3 && outcome.moved.reduction() > 3.5, "{:?}", outcome.moved);
        assert!(matches!(outcome.verdict, Verdict::HoldsOnlyIf(_)));
    }

    /// From 70.53° on there may be edges where Phong is the worse one; at 80° there are. The pictures are labelled by that.
    #[test]
    fn in_grazing_light_the_claim_fails() {
        use super::super::Role;
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
            assert!(matches!(outcome.verdict, Verdict::Absent(_)), "{light} {segments}: {:?}", outcome.moved);
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
