//! Every experiment over the whole range of each of its parameters: the measurement is right for all valid values, or the report
//! says why there is no expected value.

use crease::artefact::{
    EXPERIMENTS, Experiment, Language, Outcome, ParameterName, Parameters, Role, Setup, Shot, Verdict,
};
use crease::normals::Weight;
use crease::num::Degrees;
use crease::report::verdict_text;
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::LazyLock;

/// Small pictures, so that measurements must allow for the size of pixels.
const SIZE: u32 = 40;

/// One parameter at a time is changed, also to the ends of its range.
fn cases(experiment: &'static Experiment) -> Vec<Parameters> {
    let usual = Parameters { size: SIZE, ..experiment.defaults };
    let range = |name| experiment.range(name).map_or([0.0; 2], |range| [*range.start(), *range.end()]);
    let [fewest, most] = range(ParameterName::Segments).map(|count| (count as u32).min(256));
    let of = |&knob: &ParameterName| -> Vec<Parameters> {
        match knob {
            ParameterName::Size => [32, 33, 100].map(|size| Parameters { size, ..usual }).to_vec(),
            ParameterName::Segments => [fewest, fewest + 4, 10, 13, 41, most]
                .map(|segments| Parameters { segments, ..usual })
                .to_vec(),
            ParameterName::Light => [-180.0, -60.0, 0.0, 80.0, 90.0, 120.0]
                .into_iter()
                .filter(|light| experiment.range(knob).is_some_and(|range| range.contains(light)))
                .map(|light| Parameters { light: Degrees(light), ..usual })
                .collect(),
            ParameterName::Turn => range(knob)
                .into_iter()
                .chain([10.0, 45.0, 80.0])
                .map(|turn| Parameters { turn: Degrees(turn), ..usual })
                .collect(),
            ParameterName::Intensity => range(knob)
                .into_iter()
                .chain([0.3, 0.5, 1.6, 8.0])
                .map(|intensity| Parameters { intensity, ..usual })
                .collect(),
            ParameterName::Exponent => [0.0, 0.5, 1.0, 1.3, 5.0, 1000.0, 1e6]
                .map(|exponent| Parameters { exponent, ..usual })
                .to_vec(),
            ParameterName::Crease => [0.0, 30.0, 45.0, 90.0, 180.0]
                .map(|crease| Parameters { crease: Degrees(crease), ..usual })
                .to_vec(),
            ParameterName::Weight => Weight::ALL.map(|weight| Parameters { weight, ..usual }).to_vec(),
            ParameterName::Interpolation | ParameterName::Mesh => Vec::new(),
        }
    };
    experiment.takes.iter().flat_map(of).collect()
}

/// Pairs of parameters that were once compared with a law that does not cover both.
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

/// A run and its outcome.
type Run = (&'static Experiment, Parameters, Outcome);

/// All runs, made once for all tests.
static RUNS: LazyLock<Vec<Run>> = LazyLock::new(|| {
    let of = |experiment| cases(experiment).into_iter().map(move |parameters| (experiment, parameters));
    let mut all: Vec<_> = EXPERIMENTS.into_iter().flat_map(of).collect();
    all.extend(pairs());
    assert!(all.len() > 100);
    let run = |(experiment, parameters): (&'static Experiment, Parameters)| {
        (experiment, parameters, experiment.run(&Setup { parameters, mesh: None }).unwrap())
    };
    all.into_par_iter().map(run).collect()
});

#[test]
fn no_legal_parameter_contradicts_a_closed_form() {
    let wrong = |(experiment, parameters, outcome): &Run| {
        let bad = outcome.measures.iter().filter(|measure| {
            // A value that is not finite disagrees.
            measure.agrees == Some(false) || !measure.value.is_finite()
        });
        let reported = |measure: &crease::artefact::Measure| {
            let name = measure.name.get(Language::English);
            format!("{} {parameters:?}: {name} {} {:?}", experiment.id, measure.value, measure.expected)
        };
        bad.map(reported).collect::<Vec<_>>()
    };
    let wrong: Vec<String> = RUNS.iter().flat_map(wrong).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The words of captions if the artefact is not visible or the cure does too little, in both languages.
const NOTHING: [[&str; 3]; 2] = [
    ["No artefact is measured here", "Nothing is lit here", "There is no artefact to cure here"],
    ["Nenhum artefato é medido aqui", "Nada está iluminado aqui", "Não há artefato a curar aqui"],
];
const TOO_LITTLE: [&str; 2] = ["The cure does too little here", "A cura não basta aqui"];

/// The contradiction between a picture's role, number and caption, if there is one.
fn disagreement(shot: &Shot) -> Option<String> {
    let is_measured = !matches!(shot.role, Role::Difference | Role::Truth | Role::Seen);
    let Some(measured) = &shot.measured else {
        return is_measured.then(|| "no number".into());
    };
    let is_seen = measured.value.abs() > measured.present.value;
    for (language, (nothing, too_little)) in Language::ALL.into_iter().zip(NOTHING.iter().zip(TOO_LITTLE)) {
        let caption = shot.caption.get(language);
        let is_denied = nothing.iter().any(|said| caption.contains(said));
        let is_small = caption.contains(too_little);
        let fits = match shot.role {
            Role::Bad => is_seen && !is_denied && !is_small,
            Role::Cured => !is_denied && !is_small,
            Role::Attempt => is_seen && is_small,
            Role::Absent => is_denied && !is_small,
            Role::Difference | Role::Truth | Role::Seen => false,
        };
        let has_number = caption.ends_with(").") && caption.contains(measured.name.get(language));
        if !fits || !has_number {
            return Some(format!("{:?} of {} {:?}: {caption}", shot.role, measured.value, measured.present));
        }
    }
    None
}

#[test]
fn roles_captions_and_verdicts_agree_with_what_was_measured() {
    let mut wrong = Vec::new();
    for (experiment, parameters, outcome) in &*RUNS {
        let reported = |what: String| format!("{} {parameters:?}: {what}", experiment.id);
        wrong.extend(outcome.shots.iter().filter_map(disagreement).map(reported));
        let has = |role| outcome.shots.iter().any(|shot| shot.role == role);
        let (moved, is_absent) = (&outcome.effect, matches!(outcome.verdict, Verdict::Absent(_)));
        let is_shown = moved.is_present() && has(Role::Bad);
        if !is_absent && !is_shown {
            wrong.push(reported(format!("a verdict on nothing: {:?}", outcome.verdict)));
        }
        // A cure needs a picture; if nothing is lit, its role is `Absent`.
        if !is_absent && moved.is_cured() && !has(Role::Cured) && !has(Role::Absent) {
            wrong.push(reported("a cure without a picture".into()));
        }
        for (language, fails) in Language::ALL.into_iter().zip(["The cure fails here", "A cura falha aqui"]) {
            let [_, condition] = verdict_text(outcome, language);
            if condition.contains(fails) != (!is_absent && !moved.is_cured()) {
                wrong.push(reported(condition));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Parameters for which roles and captions once contradicted the measurement.
#[test]
fn pictures_are_reported_as_they_are() {
    type Change = fn(&mut Parameters);
    /// A picture's name, its role, and words that its caption must not contain.
    type Reported = (&'static str, Role, &'static str);
    let reported: &[(&str, Change, &[Reported])] = &[
        (
            "vertex-average",
            |p| p.weight = Weight::Angle,
            &[
                ("cube-1", Role::Absent, "lean to one side"),
                ("cube-2", Role::Absent, "elsewhere"),
                ("slivers", Role::Bad, "Nothing"),
            ],
        ),
        (
            "vertex-average",
            |p| p.weight = Weight::Max,
            &[
                ("cube-1", Role::Absent, "lean to one side"),
                ("slivers", Role::Absent, "bands"),
                ("box-max", Role::Bad, "Nothing"),
            ],
        ),
        (
            "false-smoothing",
            |p| p.crease = Degrees(180.0),
            &[("gear-split", Role::Attempt, "flat"), ("cube-split", Role::Attempt, "one luminance")],
        ),
        ("false-smoothing", |p| p.crease = Degrees(0.0), &[("gear-split", Role::Cured, "stays round")]),
        ("false-smoothing", |p| p.light = Degrees(180.0), &[("zigzag", Role::Absent, "silhouette")]),
        (
            "reflection-models",
            |p| p.exponent = 1.0,
            &[("blinn-4n", Role::Attempt, "much closer"), ("phong-grazing", Role::Absent, "stretched")],
        ),
        ("reflection-models", |p| p.exponent = 3.0, &[("blinn-4n", Role::Cured, "not to be told")]),
        (
            "lost-highlight",
            |p| p.exponent = 2.0,
            &[("plate-gouraud", Role::Bad, "is lost"), ("sphere-gouraud", Role::Bad, "all that is left")],
        ),
        // The highlight is narrower than a pixel and falls between pixels with any shading: nothing is visible.
        (
            "lost-highlight",
            |p| p.exponent = 1e6,
            &[("plate-phong", Role::Absent, "is visible"), ("sphere-phong", Role::Absent, "right position")],
        ),
        (
            "mach-bands",
            |p| p.light = Degrees(180.0),
            &[("flat", Role::Absent, "lighter"), ("gouraud", Role::Absent, "Bands stand")],
        ),
        ("precision", |p| p.exponent = 2.0, &[("eight-bits", Role::Absent, "blotchy")]),
        (
            "silhouette",
            |p| p.segments = 200,
            &[("ball", Role::Absent, "polygon."), ("ball-fine", Role::Absent, "looks round")],
        ),
        ("triangulation", |p| p.light = Degrees(180.0), &[("waves-rising", Role::Absent, "beads")]),
        ("shared-vertices", |p| p.light = Degrees(0.0), &[("seam", Role::Absent, "line down")]),
    ];
    for (id, change, pictures) in reported {
        let experiment = crease::artefact::experiment(id).unwrap();
        let mut parameters = Parameters { size: SIZE, ..experiment.defaults };
        change(&mut parameters);
        let outcome = experiment.run(&Setup { parameters, mesh: None }).unwrap();
        for (name, role, unsaid) in *pictures {
            let shot = outcome.shots.iter().find(|shot| shot.name == *name).unwrap();
            let caption = shot.caption.get(Language::English);
            assert_eq!(shot.role, *role, "{id} {parameters:?} {name}: {caption}");
            assert!(!caption.contains(unsaid), "{id} {parameters:?} {name}: {caption}");
        }
    }
}

/// The cure of an outline has more segments than the outline, whatever the size.
#[test]
fn outlines_are_cured_by_more_segments() {
    let experiment = crease::artefact::experiment("silhouette").unwrap();
    for (size, segments) in [(32, 12), (40, 200), (64, 16)] {
        let parameters = Parameters { size, segments, ..experiment.defaults };
        let outcome = experiment.run(&Setup { parameters, mesh: None }).unwrap();
        let label = outcome.shots.iter().find(|shot| shot.name == "ball-fine").unwrap();
        let label = label.label.get(Language::English);
        let fine: u32 = label.trim_start_matches("sphere, ").trim_end_matches(" segments").parse().unwrap();
        assert!(fine >= 2 * segments, "{label}");
    }
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
        assert!(matches!(outcome.verdict, Verdict::Absent(_)), "{id}: {:?}", outcome.effect);
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
    assert!(sharp.effect.is_present() && !sharp.effect.is_cured(), "{:?}", sharp.effect);
}

/// Round numbers next to pictures that no parameter changes, and the reason for each.
const KEPT: [(&str, &str, &str); 14] = [
    ("attenuation-and-overflow", "clamped", "the colours of exercise 1.6.17"),
    ("attenuation-and-overflow", "cured", "nothing is brighter than white"),
    ("attenuation-and-overflow", "offset", "nothing is brighter than white"),
    ("attenuation-and-overflow", "quadratic", "nothing is brighter than white"),
    ("false-smoothing", "zigzag", "the error is the slope, which is no parameter"),
    ("orientation", "cured", "barycentric coordinates do not rotate; rounding counts as zero"),
    ("orientation", "diagonal-13", "the same"),
    ("orientation", "diagonal-24", "the same"),
    ("orientation", "halves-triangles", "the same"),
    ("precision", "needles-exact", "a flat plate has one normal"),
    ("reflection-models", "behind-guarded", "no light falls on what faces away from it"),
    ("reflection-models", "behind-phong-guarded", "the same"),
    ("shared-vertices", "crack-closed", "nothing is seen between faces that share their edges"),
    ("vertex-average", "cube-angle", "angles do not depend on how a face is cut"),
];

/// A number that is not measured would be round and the same for all parameters.
#[test]
fn what_is_reported_next_to_pictures_is_measured() {
    let mut values: BTreeMap<(&str, String), BTreeSet<u64>> = BTreeMap::new();
    for (experiment, _, outcome) in RUNS.iter() {
        let moved = [("bad", outcome.effect.bad), ("cured", outcome.effect.cured)];
        let shots = outcome.shots.iter().filter_map(|shot| Some((shot.name, shot.measured.as_ref()?.value)));
        for (name, value) in moved.into_iter().chain(shots) {
            values.entry((experiment.id, name.to_owned())).or_default().insert(value.to_bits());
        }
    }
    let is_round = |bits: &u64| format!("{:e}", f64::from_bits(*bits)).len() <= "-1.234e-10".len();
    let still = values.iter().filter(|(_, values)| values.len() == 1 && values.iter().all(is_round));
    let unexplained =
        still.filter(|((id, name), _)| !KEPT.iter().any(|kept| (kept.0, kept.1) == (*id, name)));
    let reported = |((id, name), values): (&(&str, String), &BTreeSet<u64>)| {
        format!("{id}, {name}: {:?}", values.iter().map(|&bits| f64::from_bits(bits)).collect::<Vec<_>>())
    };
    let unexplained: Vec<String> = unexplained.map(reported).collect();
    assert!(unexplained.is_empty(), "{unexplained:#?}");
}
