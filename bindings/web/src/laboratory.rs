//! One request, one answer: the list of all requests.

use crate::subject::Subject;
use crate::view::View;
use crate::{deviation, exercises, experiments, inspection, pictures, saving, shapes};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

/// The laboratory: the file that was opened, and what was computed for the last view.
#[derive(Default)]
pub struct Laboratory {
    /// The mesh of the last view.
    subject: Option<Subject>,
    /// The user's file: its name and bytes.
    file: Option<(String, Vec<u8>)>,
}

/// An answer: JSON, and buffers that it describes. An error has a member `error`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Answer {
    /// The answer as JSON.
    pub json: String,
    /// Pictures as RGBA, or the bytes of a file.
    pub buffers: Vec<Vec<u8>>,
}

/// An answer before it is text.
pub(crate) type Result<T = (Value, Vec<Vec<u8>>)> = std::result::Result<T, String>;

#[derive(Deserialize)]
#[serde(tag = "verb", rename_all = "kebab-case")]
enum Request {
    /// The built-in meshes.
    Shapes,
    /// A user's file: its bytes come with the request.
    Open { name: String },
    /// The counts of the normals of a view.
    Normals { view: View },
    /// Pictures of a view.
    Draw { view: View, pictures: Vec<pictures::Kind>, marks: Vec<[f64; 3]> },
    /// The numbers of a pixel of a picture of a view.
    Probe { view: View, picture: pictures::Kind, pixel: [u32; 2] },
    /// The deviation from other normals, in numbers.
    Deviation { view: View },
    /// The mesh with its normals as a file.
    Save { view: View, format: String },
    /// The commands of `Save`.
    Command { view: View, format: String },
    /// The findings of a mesh.
    Inspect { view: View },
    /// All experiments.
    Experiments { language: String },
    /// The outcome of an experiment.
    Experiment(experiments::Run),
    /// All exercises.
    Exercises,
    /// The statement of an exercise; with a seed, one with random numbers.
    Exercise { id: String, seed: Option<u32> },
    /// Whether an answer to an exercise is right, and how it is found.
    Check { id: String, seed: Option<u32>, answer: [f64; 3] },
}

impl Laboratory {
    /// Answers a request in JSON. `bytes` is the file of the request `open`, else empty.
    pub fn answer(&mut self, request: &str, bytes: Vec<u8>) -> Answer {
        let answer = match serde_json::from_str(request) {
            Ok(request) => self.run(request, bytes),
            Err(error) => Err(format!("this is no request: {error}")),
        };
        let (value, buffers) = answer.unwrap_or_else(|error| (json!({ "error": error }), Vec::new()));
        Answer { json: value.to_string(), buffers }
    }

    fn run(&mut self, request: Request, bytes: Vec<u8>) -> Result {
        let value = match request {
            Request::Shapes => json!(shapes::SHAPES),
            Request::Open { name } => return self.open(name, bytes),
            Request::Normals { view } => self.subject(&view)?.counts(&view),
            Request::Draw { view, pictures, marks } => {
                return pictures::draw(self.subject(&view)?, &view, &pictures, &marks);
            }
            Request::Probe { view, picture, pixel } => {
                pictures::probe(self.subject(&view)?, &view, picture, pixel)?
            }
            Request::Deviation { view } => deviation::numbers(self.subject(&view)?, &view)?,
            Request::Save { view, format } => return saving::save(self.subject(&view)?, &view, &format),
            Request::Command { view, format } => {
                json!(saving::commands(self.subject(&view)?, &view, &format))
            }
            Request::Inspect { view } => inspection::inspect(self.subject(&view)?)?,
            Request::Experiments { language } => experiments::list(&language),
            Request::Experiment(run) => return run.outcome(),
            Request::Exercises => exercises::list(),
            Request::Exercise { id, seed } => return exercises::statement(&id, seed),
            Request::Check { id, seed, answer } => exercises::check(&id, seed, answer)?,
        };
        Ok((value, Vec::new()))
    }

    /// Reads a file. If that fails, the file before stays.
    fn open(&mut self, name: String, bytes: Vec<u8>) -> Result {
        let subject = Subject::of_file(&name, bytes.clone())?;
        let value = subject.facts();
        self.subject = Some(subject);
        self.file = Some((name, bytes));
        Ok((value, Vec::new()))
    }

    /// The mesh of a view: that of the last one, or another.
    fn subject(&mut self, view: &View) -> Result<&mut Subject> {
        let is_other = self.subject.as_ref().is_none_or(|subject| !subject.is_of(view));
        if is_other {
            let made = match (&*view.subject, &self.file) {
                ("file", Some((name, bytes))) => Subject::of_file(name, bytes.clone()),
                ("file", None) => Err("no file is open; drop one on the page".to_owned()),
                (id, _) => Subject::built_in(id, view.segments),
            };
            self.subject = Some(made?);
        }
        let subject = self.subject.as_mut().ok_or("no mesh")?;
        subject.compute(view);
        Ok(subject)
    }
}

/// Anything that has a JSON form as JSON.
pub(crate) fn value(of: &impl Serialize) -> Result<Value> {
    serde_json::to_value(of).map_err(|error| error.to_string())
}
