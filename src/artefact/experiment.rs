//! The definition of an experiment.

use super::effect::Role;
use super::error::ArtefactError;
use super::outcome::{Outcome, Verdict};
use super::parameters::{ParameterName, Parameters, Setup};
use crate::io::shell_word;
use crate::raster::Image;
use crate::text::{Catalogue, Language, Text, Value, given};
use serde::Serialize;
use std::ops::RangeInclusive;

/// A claim of a textbook, and how it is put to the test.
#[derive(Debug)]
pub struct Experiment {
    /// Its name: lower-case letters, digits and hyphens. It does not change between versions.
    pub id: &'static str,
    /// Its texts: `title`, `claim`, `source-N` (a section or exercise of the lectures, or a paper), `formula-N` with
    /// `formula-N-says` (closed forms), `own-mesh` (what is measured on a user's mesh) and `shown-by` (how to show the
    /// artefact where it is absent: the end of a sentence).
    pub(super) texts: &'static Catalogue,
    /// The parameters that it takes.
    pub takes: &'static [ParameterName],
    /// The least and largest values of numbers that have a smaller range here than elsewhere.
    pub(super) ranges: &'static [(ParameterName, [f64; 2])],
    /// The default parameters.
    pub defaults: Parameters,
    pub(super) run: RunFn,
    pub(super) frame: Option<FrameFn>,
}

pub(super) type RunFn = fn(&Setup) -> Result<Outcome, ArtefactError>;
pub(super) type FrameFn = fn(&Setup, u32, u32) -> Result<Image, ArtefactError>;

/// A formula in LaTeX notation, and its meaning.
#[derive(Debug, Serialize)]
pub struct Formula {
    /// The formula.
    pub notation: Text,
    /// Its meaning in words.
    pub says: Text,
}

impl Experiment {
    /// An experiment without parameters, with the usual defaults of them, and without an animation.
    pub(super) const fn new(id: &'static str, texts: &'static Catalogue, run: RunFn) -> Self {
        Self { id, texts, takes: &[], ranges: &[], defaults: Parameters::USUAL, run, frame: None }
    }

    /// Its title.
    pub fn title(&self) -> Text {
        self.texts.get("title")
    }

    /// The claim that it tests.
    pub fn claim(&self) -> Text {
        self.texts.get("claim")
    }

    /// The publications that make the claim or deny it.
    pub fn sources(&self) -> Vec<Text> {
        self.texts.list("source")
    }

    /// What is measured on a user's mesh; `None` if it takes none.
    pub fn own_mesh(&self) -> Option<Text> {
        self.takes.contains(&ParameterName::Mesh).then(|| self.texts.get("own-mesh"))
    }

    /// Runs the experiment.
    ///
    /// The same setup gives the same bits at any number of threads. Where no artefact is measured or visible, the verdict is
    /// [`Verdict::Absent`].
    ///
    /// # Errors
    /// Parameters out of range, a mesh that does not suit, or a picture that cannot be drawn.
    pub fn run(&self, setup: &Setup) -> Result<Outcome, ArtefactError> {
        self.check(setup)?;
        let mut outcome = (self.run)(setup)?;
        let shows = |roles: &[Role]| outcome.shots.iter().any(|shot| roles.contains(&shot.role));
        let is_shown = shows(&[Role::Bad]) && shows(&[Role::Cured, Role::Attempt]);
        let is_tested = outcome.effect.is_present() && is_shown;
        if !is_tested && !matches!(outcome.verdict, Verdict::Absent(_)) {
            outcome.verdict = Verdict::Absent(self.texts.get("shown-by"));
        }
        Ok(outcome)
    }

    /// The closed forms of its shapes; none for a user's mesh.
    pub fn closed_forms(&self, setup: &Setup) -> Vec<Formula> {
        let formulas = || self.texts.list("formula").into_iter().enumerate();
        let says = |index: usize| self.texts.get(&format!("formula-{}-says", index + 1));
        match setup.mesh {
            Some(_) => Vec::new(),
            None => formulas().map(|(index, notation)| Formula { notation, says: says(index) }).collect(),
        }
    }

    /// Whether it has an animation.
    pub fn is_animated(&self) -> bool {
        self.frame.is_some()
    }

    /// The command of the same run, with pages in this language. File names are quoted for a POSIX shell.
    pub fn command(&self, setup: &Setup, language: Language) -> String {
        let mut command = format!("crease artefact {}", self.id);
        if let Some(own) = setup.mesh {
            command.push_str(&format!(" --mesh {}", shell_word(own.name)));
            if let Some((finer, _)) = own.finer {
                command.push_str(&format!(" --finer {}", shell_word(finer)));
            }
        }
        for &name in self.takes {
            let [own, usual] = [&setup.parameters, &self.defaults].map(|parameters| parameters.value(name));
            if let Some(own) = own.filter(|own| Some(own) != usual.as_ref()) {
                command.push_str(&format!(" --{} {own}", name.name()));
            }
        }
        if language != Language::default() {
            command.push_str(&format!(" --lang {}", language.tag()));
        }
        command + " -o out"
    }

    pub(super) fn check(&self, setup: &Setup) -> Result<(), ArtefactError> {
        self.accept(&setup.parameters)?;
        match setup.mesh {
            Some(_) => self.refuse([ParameterName::Mesh]),
            None => Ok(()),
        }
    }

    /// Whether parameters are within their ranges and the experiment's own.
    ///
    /// # Errors
    /// [`ArtefactError::Request`] for the first that is not.
    pub fn accept(&self, parameters: &Parameters) -> Result<(), ArtefactError> {
        for (name, found) in ParameterName::NUMBERS.map(|name| (name, parameters.number(name))) {
            let Some((range, found)) = name.range().zip(found) else { continue };
            if !range.contains(&found) {
                let key = format!("{}-{}", name.name(), "range");
                return Err(ArtefactError::request(&key, &[("found", given(found).into())]));
            }
        }
        for &(name, [least, most]) in self.ranges {
            let Some(found) = parameters.number(name) else { continue };
            if !(least..=most).contains(&found) {
                let (id, name) = (("experiment", self.id.into()), ("name", name.name().into()));
                let number = |number: f64| Value::from(given(number));
                let [found, least, most] = [found, least, most].map(number);
                let values = [id, name, ("found", found), ("least", least), ("most", most)];
                return Err(ArtefactError::request("own-range", &values));
            }
        }
        Ok(())
    }

    /// The range of a number that it takes; `None` for parameters that are no numbers, and for those that it does not take.
    pub fn range(&self, name: ParameterName) -> Option<RangeInclusive<f64>> {
        let own = self.ranges.iter().find(|(own, _)| *own == name);
        let own = own.map(|&(_, [least, most])| least..=most);
        own.or_else(|| name.range()).filter(|_| self.takes.contains(&name))
    }

    /// Refuses the first of some parameters that the experiment does not take.
    ///
    /// # Errors
    /// [`ArtefactError::Request`].
    pub fn refuse(&self, given: impl IntoIterator<Item = ParameterName>) -> Result<(), ArtefactError> {
        match given.into_iter().find(|name| !self.takes.contains(name)) {
            None => Ok(()),
            Some(name) => {
                let takes: Vec<String> = self.takes.iter().map(|name| format!("--{}", name.name())).collect();
                let (id, name) = (("experiment", self.id.into()), ("name", name.name().into()));
                let values = [id, name, ("takes", takes.join(", ").into())];
                Err(ArtefactError::request("not-taken", &values))
            }
        }
    }
}
