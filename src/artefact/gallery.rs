//! All experiments, found by their ids.

use super::error::ArtefactError;
use super::experiment::{Experiment, FrameFn};
use super::parameters::Setup;
use super::{
    attenuation_and_overflow, false_smoothing, flat_validity, local_and_global, lost_highlight, mach_bands,
    orientation, perspective_distortion, precision, reflection_models, refraction, shading_terminator,
    shared_vertices, silhouette, triangulation, vertex_average,
};
use crate::raster::Image;

/// All experiments, in the order in which they are read.
pub static EXPERIMENTS: [&Experiment; 16] = [
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
    &local_and_global::EXPERIMENT,
    &refraction::EXPERIMENT,
];

/// The experiment of an id.
///
/// # Errors
/// [`ArtefactError::Request`], with the id that is most like it.
pub fn experiment(id: &str) -> Result<&'static Experiment, ArtefactError> {
    EXPERIMENTS.into_iter().find(|experiment| experiment.id == id).ok_or_else(|| {
        let shared =
            |other: &str| id.split('-').filter(|word| word.len() > 2 && other.contains(word)).count();
        let nearest = EXPERIMENTS.iter().map(|experiment| experiment.id).max_by_key(|other| shared(other));
        let found = ("found", id.into());
        match nearest.filter(|other| shared(other) > 0) {
            Some(nearest) => {
                ArtefactError::request("unknown-but-similar", &[found, ("nearest", nearest.into())])
            }
            None => ArtefactError::request("unknown", &[found]),
        }
    })
}

impl Experiment {
    /// Draws one frame, counted from 0, of an animation of `count` frames.
    ///
    /// # Errors
    /// As [`run`](Self::run), and if it has no animation.
    pub fn frame(&self, setup: &Setup, number: u32, count: u32) -> Result<Image, ArtefactError> {
        self.check(setup)?;
        self.frame_fn()?(setup, number, count)
    }

    /// Refuses to be animated if nothing in it moves.
    ///
    /// # Errors
    /// [`ArtefactError::Request`], with the names of those that have an animation.
    pub fn refuse_still(&self) -> Result<(), ArtefactError> {
        self.frame_fn().map(|_| ())
    }

    fn frame_fn(&self) -> Result<FrameFn, ArtefactError> {
        self.frame.ok_or_else(|| {
            let animated = EXPERIMENTS.iter().filter(|other| other.is_animated());
            let names: Vec<&str> = animated.map(|other| other.id).collect();
            let values = [("experiment", self.id.into()), ("animated", names.join(", ").into())];
            ArtefactError::request("still", &values)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::artefact::ParameterName;
    use crate::artefact::{Language, Parameters, Verdict};
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
            assert_eq!(experiment.accept(&experiment.defaults), Ok(()), "{}", experiment.id);
            assert!(self::experiment(experiment.id).is_ok());
            let takes_mesh = experiment.takes.contains(&ParameterName::Mesh);
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
        let reported =
            mach_bands.refuse([ParameterName::Size, ParameterName::Crease]).unwrap_err().to_string();
        assert!(reported.contains("no crease") && reported.contains("--segments"), "{reported}");
        let parameters = Parameters { segments: 2, ..mach_bands.defaults };
        let error = mach_bands.run(&Setup { parameters, mesh: None }).unwrap_err();
        assert!(error.to_string().contains("--segments is 2"), "{error}");
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
