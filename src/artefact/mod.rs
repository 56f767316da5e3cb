//! The artefact laboratory (layer 5): claims of textbooks about the artefacts of shading, tested by pictures and numbers.
//!
//! An [`Experiment`] states a claim, tests it and gives an [`Outcome`]: whether the claim holds here and under what
//! conditions it fails, measured numbers with their closed forms, pictures with the artefact and without it, the number that
//! the cure changes, and curves. Outcomes are data and linear samples; `report` makes pages of them.
//!
//! ```
//! use crease::artefact::{EXPERIMENTS, Language, Parameters, Setup, experiment};
//!
//! let experiment = experiment("orientation")?;
//! let setup = Setup { parameters: Parameters { size: 65, ..experiment.defaults }, mesh: None };
//! let outcome = experiment.run(&setup)?;
//! assert!(outcome.effect.bad > outcome.effect.cured);
//! println!("{}", outcome.verdict.condition().get(Language::Portuguese));
//! # Ok::<(), crease::artefact::ArtefactError>(())
//! ```
//!
//! # An experiment
//! `CONTRIBUTING.md` of the repository describes how to add one. `takes` lists its parameters, `defaults` their values; the
//! command line refuses all others. `run` draws pictures, measures their linear samples and passes both to a `Recorder`, which
//! looks up the texts by the names of measures and pictures. A measure has its closed form or an independent check, or a bound,
//! with the reason of the tolerance in its text `-by`. At least one picture shows the artefact and one its cure, each with an
//! [`Effect`]; the [`Role`] of a picture follows from it. Where no artefact is present or visible, the verdict is
//! [`Verdict::Absent`].

// The errors of experiments.
mod error;
// The parameters of experiments: names, ranges, values.
mod parameters;
// Scenes, pictures made of pictures, and the meshes that experiments draw.
mod drawing;
// A user's mesh as the input of an experiment.
mod user_mesh;
// What a run finds, and pictures with captions.
mod effect;
// The result of an experiment: data and linear pictures, no markup.
mod outcome;
// Collects the findings of an experiment.
mod recorder;
// The definition of an experiment.
mod experiment;
// The names that the code of every experiment uses.
mod prelude;
// Light that fades with distance, and light above the displayable range.
mod attenuation_and_overflow;
// Sharp edges that averaged normals smooth away.
mod false_smoothing;
// When one colour for each face is exact.
mod flat_validity;
// One scene under a local model and traced.
mod local_and_global;
// A highlight that falls between vertices.
mod lost_highlight;
// Mach bands on a cylinder: steps of flat shading, slope jumps of Gouraud's and Phong's.
mod mach_bands;
// The lectures' diamond: rotating a polygon changes its colours under the scanline algorithm.
mod orientation;
// Interpolation on the picture against interpolation in the scene.
mod perspective_distortion;
// The effect of rounded positions and normals on a highlight.
mod precision;
// Phong's and Blinn's highlights.
mod reflection_models;
// A stick in water and a glass ball.
mod refraction;
// The border between light and shadow on a coarse mesh.
mod shading_terminator;
// Vertices that neighbours do not share: T-junctions, cracks, seams.
mod shared_vertices;
// Outlines stay polygons, however smoothly the faces are shaded.
mod silhouette;
// One polygon, cut in two ways.
mod triangulation;
// Vertex normals as means of faces: how a mesh is cut shows through.
mod vertex_average;
// All of them by id.
mod gallery;

pub use crate::text::{Language, Text};
pub use effect::{Amount, Effect, MapScale, Role, Shot, Threshold};
pub use error::ArtefactError;
pub use experiment::{Experiment, Formula};
pub use gallery::{EXPERIMENTS, experiment};
pub use outcome::{Chart, Curve, Drawn, Expected, Measure, Outcome, Range, Scale, Verdict};
pub use parameters::{Changes, ParameterName, ParameterValues, Parameters, Setup, UserMesh};
