//! The artefact laboratory (layer 5): what textbooks say of shading's artefacts, as pictures with numbers.
//!
//! An [`Experiment`] states a claim, runs it and gives an [`Outcome`]: whether the claim holds here and under what
//! conditions it fails, measured numbers beside their closed forms, pictures with the artefact and without, the number that
//! the cure moved, curves. Outcomes are data and linear samples; `report` makes pages of them.
//!
//! ```
//! use crease::artefact::{EXPERIMENTS, Language, Parameters, Setup, experiment};
//!
//! let experiment = experiment("orientation")?;
//! let setup = Setup { parameters: Parameters { size: 65, ..experiment.defaults }, mesh: None };
//! let outcome = experiment.run(&setup)?;
//! assert!(outcome.moved.bad > outcome.moved.cured);
//! println!("{}", outcome.verdict.condition().get(Language::Portuguese));
//! # Ok::<(), crease::artefact::ArtefactError>(())
//! ```
//!
//! # How to add an experiment
//! 1. A file `src/artefact/<id with underscores>.rs` with one `pub(super) const EXPERIMENT: Experiment`; a line in the list of
//!    modules and one in [`EXPERIMENTS`], in the order in which they are read. Pages, thumbnails, the command line and the
//!    structural tests of the gallery take it from there.
//! 2. `takes` lists the parameters that it heeds, `defaults` their values; all others are refused at the command line. If it
//!    takes [`Knob::Mesh`], `setup.mesh` may hold a user's mesh: say in `own_mesh` what it is looked at for, and in
//!    [`ArtefactError::Mesh`] what to do about one that does not suit. `frame` draws frame k of n of its animation, if it has one.
//! 3. `run` gives at least one picture of the artefact and one of its cure, drawn by `stage::draw` at `parameters.size`, and
//!    [`Moved`] with the number before and after. Each [`Shot`] has such a number too (`Moved::bad_shot`, `Moved::cured_shot`):
//!    its [`Role`] follows from it, and of its caption the part that tells what is seen, which must be true wherever the number
//!    says that the artefact is there, or cured; the other part must be true with all parameters, as notes must. Measure on
//!    linear samples (`stage::luminance`), with
//!    the metrics of [`metric`](crate::metric) where there is one. A [`Measure`] has its closed form or independent check by
//!    [`Measure::expect`], or its bound by [`Measure::at_most`], with the reason of the tolerance in its text.
//! 4. Every word is a [`Text`] in both languages; numbers in it by [`Text::made`]. Claims name their lecture section.
//! 5. [`Moved`] says from what size on the artefact is there and by what factor the cure has to reduce it. Where it is not there,
//!    or no picture shows it, or none its cure, [`Experiment::run`] makes the verdict [`Verdict::Absent`], with `shown_by`; else the verdict follows from
//!    what was measured.
//! 6. Tests at small sizes: all measures agree, the artefact is present in the bad case, the cure reduces it by a stated
//!    factor.

mod attenuation_and_overflow;
mod body;
mod error;
mod experiment;
mod false_smoothing;
mod flat_validity;
mod lost_highlight;
mod mach_bands;
mod moved;
mod orientation;
mod outcome;
mod own_mesh;
mod parameters;
mod perspective_distortion;
mod precision;
mod reflection_models;
mod shading_terminator;
mod shared_vertices;
mod shown;
mod silhouette;
mod stage;
mod triangulation;
mod vertex_average;

pub use crate::text::{Language, Text};
pub use error::ArtefactError;
pub use experiment::{Experiment, Formula};
pub use moved::{Moved, Threshold};
pub use outcome::{
    Amount, Chart, Curve, Drawn, Expected, Measure, Outcome, Range, Role, Scale, Shot, Verdict,
};
pub use parameters::{Changes, Knob, Parameters, Setup, Taken, UserMesh};

/// All experiments, in the order in which they are read.
pub static EXPERIMENTS: [&Experiment; 14] = [
    &silhouette::EXPERIMENT,
    &mach_bands::EXPERIMENT,
    &orientation::EXPERIMENT,
    &false_smoothing::EXPERIMENT,
    &vertex_average::EXPERIMENT,
    &shared_vertices::EXPERIMENT,
    &perspective_distortion::EXPERIMENT,
    &lost_highlight::EXPERIMENT,
    &flat_validity::EXPERIMENT,
    &attenuation_and_overflow::EXPERIMENT,
    &reflection_models::EXPERIMENT,
    &shading_terminator::EXPERIMENT,
    &triangulation::EXPERIMENT,
    &precision::EXPERIMENT,
];

/// The experiment of an id.
///
/// # Errors
/// [`ArtefactError::Unknown`], with the id that is most like it.
pub fn experiment(id: &str) -> Result<&'static Experiment, ArtefactError> {
    EXPERIMENTS.into_iter().find(|experiment| experiment.id == id).ok_or_else(|| {
        let shared =
            |other: &str| id.split('-').filter(|word| word.len() > 2 && other.contains(word)).count();
        let nearest = EXPERIMENTS.iter().map(|experiment| experiment.id).max_by_key(|other| shared(other));
        ArtefactError::Unknown { found: id.to_owned(), nearest: nearest.filter(|other| shared(other) > 0) }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::Degrees;
    use std::collections::BTreeSet;

    #[test]
    fn experiments_are_well_formed() {
        let mut ids = BTreeSet::new();
        for experiment in EXPERIMENTS {
            let is_plain =
                experiment.id.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-');
            assert!(is_plain && ids.insert(experiment.id), "{}", experiment.id);
            assert!(!experiment.sources().is_empty() && !experiment.takes.is_empty(), "{}", experiment.id);
            assert_eq!(experiment.defaults.check(), Ok(()), "{}", experiment.id);
            assert!(self::experiment(experiment.id).is_ok());
            let takes_mesh = experiment.takes.contains(&Knob::Mesh);
            assert_eq!(experiment.own_mesh().is_some(), takes_mesh, "{}", experiment.id);
        }
    }

    #[test]
    fn unknown_ids_are_reported_what_there_is() {
        let reported = experiment("mach-band").unwrap_err().to_string();
        assert!(
            reported.contains("did you mean `mach-bands`") && reported.contains("artefact list"),
            "{reported}"
        );
        assert!(!experiment("x").unwrap_err().to_string().contains("did you mean"));
    }

    #[test]
    fn parameters_are_checked() {
        let mach_bands = experiment("mach-bands").unwrap();
        let reported = mach_bands.refuse([Knob::Size, Knob::Crease]).unwrap_err().to_string();
        assert!(reported.contains("no crease") && reported.contains("--segments"), "{reported}");
        let parameters = Parameters { segments: 2, ..mach_bands.defaults };
        let error = mach_bands.run(&Setup { parameters, mesh: None }).unwrap_err();
        assert!(matches!(error, ArtefactError::Range { knob: Knob::Segments, .. }));
        let still =
            mach_bands.frame(&Setup { parameters: mach_bands.defaults, mesh: None }, 0, 2).unwrap_err();
        assert!(still.to_string().contains("orientation"), "{still}");
    }

    #[test]
    fn commands_name_what_was_changed() {
        let experiment = experiment("mach-bands").unwrap();
        let parameters = Parameters { segments: 24, ..experiment.defaults };
        let setup = Setup { parameters, mesh: None };
        let command = experiment.command(&setup, Language::English);
        assert_eq!(command, "crease artefact mach-bands --segments 24 -o out");
        let command = experiment.command(&setup, Language::Portuguese);
        assert_eq!(command, "crease artefact mach-bands --segments 24 --lang pt -o out");
    }

    #[test]
    fn what_no_picture_shows_is_not_put_to_the_test() {
        let small = |id| Parameters { size: 64, ..experiment(id).unwrap().defaults };
        let terminator = Parameters { segments: 3, ..small("shading-terminator") };
        let away = Parameters {
            size: 32,
            light: Degrees(-170.0),
            crease: Degrees(59.0),
            ..small("false-smoothing")
        };
        for (id, parameters, is_tested) in [
            ("reflection-models", small("reflection-models"), true),
            ("reflection-models", Parameters { exponent: 1e4, ..small("reflection-models") }, false),
            ("false-smoothing", small("false-smoothing"), true),
            ("false-smoothing", away, false),
            ("lost-highlight", Parameters { exponent: 2000.0, ..small("lost-highlight") }, false),
            ("lost-highlight", Parameters { exponent: 1e6, ..small("lost-highlight") }, false),
            ("lost-highlight", Parameters { exponent: 200.0, ..small("lost-highlight") }, true),
            // What is advised there can be done, and helps.
            ("shading-terminator", Parameters { light: Degrees(-10.0), ..terminator }, false),
            ("shading-terminator", terminator, true),
        ] {
            let outcome = experiment(id).unwrap().run(&Setup { parameters, mesh: None }).unwrap();
            let found = !matches!(outcome.verdict, Verdict::Absent(_));
            assert_eq!(found, is_tested, "{id} {parameters:?}: {:?}", outcome.verdict);
            let advice = outcome.verdict.condition().get(Language::English);
            assert!(!advice.contains("fewer segments"), "{advice}");
        }
    }
}
