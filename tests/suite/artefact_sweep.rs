//! Every experiment over the whole range of each of its numbers: what is legal is measured right, or says why it is held
//! against nothing.

use crease::artefact::{EXPERIMENTS, Experiment, Knob, Language, Parameters, Setup, Verdict};
use crease::num::Degrees;
use rayon::prelude::*;

/// Small pictures, so that numbers have to know what pixels leave open.
const SIZE: u32 = 40;

/// One setting after the other is changed; the ends of its range are among them.
fn cases(experiment: &'static Experiment) -> Vec<Parameters> {
    let usual = Parameters { size: SIZE, ..experiment.defaults };
    let (fewest, most) = (*experiment.segments.start(), (*experiment.segments.end()).min(256));
    let of = |&knob: &Knob| -> Vec<Parameters> {
        match knob {
            Knob::Size => [32, 33, 100].map(|size| Parameters { size, ..usual }).to_vec(),
            Knob::Segments => [fewest, fewest + 4, 10, 13, 41, most]
                .map(|segments| Parameters { segments, ..usual })
                .to_vec(),
            Knob::Light => [-180.0, -60.0, 0.0, 80.0, 90.0, 120.0]
                .map(|light| Parameters { light: Degrees(light), ..usual })
                .to_vec(),
            Knob::Exponent => [0.0, 0.5, 1.0, 1.3, 5.0, 1000.0, 1e6]
                .map(|exponent| Parameters { exponent, ..usual })
                .to_vec(),
            Knob::Crease => [0.0, 30.0, 45.0, 90.0, 180.0]
                .map(|crease| Parameters { crease: Degrees(crease), ..usual })
                .to_vec(),
            Knob::Weight | Knob::Interpolation | Knob::Mesh => Vec::new(),
        }
    };
    experiment.takes.iter().flat_map(of).collect()
}

/// Settings that were once held against a law that does not cover both of them.
fn pairs() -> Vec<(&'static Experiment, Parameters)> {
    let flat = [(90.0, 0.0), (91.0, 1.0), (91.0, 5.0), (89.99, 0.5), (-90.0, 0.9), (71.0, 0.5)];
    let flat = flat.map(|(light, exponent)| ("flat-validity", 12, light, exponent));
    let fine =
        [(12, 3e5), (17, 1e6), (24, 5e5)].map(|(segments, exponent)| ("precision", segments, 30.0, exponent));
    let small = [28, 33].map(|segments| ("triangulation", segments, 0.0, 32.0));
    let all = flat.into_iter().chain(fine).chain(small);
    all.map(|(id, segments, light, exponent)| {
        let experiment = crease::artefact::experiment(id).unwrap();
        let size = if id == "triangulation" { 32 } else { SIZE };
        let light = Degrees(light);
        (experiment, Parameters { size, segments, light, exponent, ..experiment.defaults })
    })
    .collect()
}

#[test]
fn no_legal_parameter_contradicts_a_closed_form() {
    let mut all: Vec<_> = EXPERIMENTS
        .iter()
        .flat_map(|experiment| cases(experiment).into_iter().map(move |parameters| (experiment, parameters)))
        .collect();
    all.extend(pairs());
    assert!(all.len() > 100);
    let wrong: Vec<String> = all
        .par_iter()
        .flat_map_iter(|&(experiment, parameters)| {
            let outcome = experiment.run(&Setup { parameters, mesh: None }).unwrap();
            let bad = outcome.measures.into_iter().filter(|measure| {
                // What is not a number agrees with nothing.
                measure.agrees() == Some(false) || !measure.value.is_finite()
            });
            let told = move |measure: crease::artefact::Measure| {
                let name = measure.name.get(Language::English).to_owned();
                format!("{} {parameters:?}: {name} {} {:?}", experiment.id, measure.value, measure.expected)
            };
            bad.map(told).collect::<Vec<_>>()
        })
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The verdicts of runs that show nothing, and of cures that do nothing.
#[test]
fn verdicts_follow_from_what_is_measured() {
    let run = |id: &str, change: &dyn Fn(&mut Parameters)| {
        let experiment = crease::artefact::experiment(id).unwrap();
        let mut parameters = Parameters { size: SIZE, ..experiment.defaults };
        change(&mut parameters);
        experiment.run(&Setup { parameters, mesh: None }).unwrap()
    };
    let light = |degrees: f64| move |parameters: &mut Parameters| parameters.light = Degrees(degrees);
    for id in ["flat-validity", "mach-bands", "triangulation"] {
        let outcome = run(id, &light(180.0));
        assert!(matches!(outcome.verdict, Verdict::Absent(_)), "{id}: {:?}", outcome.moved);
        assert!(!matches!(run(id, &|_| ()).verdict, Verdict::Absent(_)), "{id}");
    }
    // Past 70.53° the largest jumps are still Gouraud's, but the light is not where the lectures have it.
    let past = run("mach-bands", &light(71.0));
    assert!(
        past.verdict.condition().get(Language::English).contains("more than 70.5288°"),
        "{:?}",
        past.verdict
    );
    let sharp = run("false-smoothing", &|parameters| parameters.crease = Degrees(180.0));
    assert!(sharp.moved.is_present() && !sharp.moved.is_cured(), "{:?}", sharp.moved);
}
