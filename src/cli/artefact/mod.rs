//! The verb `artefact`: experiments of the laboratory, their numbers, pages and pictures.

mod args;
mod choose;
mod report;
mod store;

pub use args::ArtefactArgs;

use super::args::Color;
use super::batch::{exit_of, guarded};
use super::console::{Console, Style, Verbosity};
use super::normals::{Failure, read_stdin};
use super::output::make_folder;
use super::progress::CountProgress;
use super::report::{ErrorReport, json_line};
use super::{Exit, usage_error, use_threads};
use args::LIST;
use choose::{Chosen, chosen};
use crease::artefact::{
    ArtefactError, Changes, EXPERIMENTS, Experiment, Language, Outcome, ParameterName, Setup, UserMesh,
};
use crease::io::{self, Limits, Loaded, ReadError, ReadOptions, shell_word};
use crease::mesh::{Faces, Mesh, MeshBuilder};
use crease::report::{list_table, measure_table, misses, verdict_text};
use rayon::prelude::*;
use report::Report;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Carries the verb out.
pub fn main(args: &ArtefactArgs, color: Color) -> Exit {
    let console = Console::new(&args.run, color, None);
    let Chosen { run: experiments, left_out } =
        chosen(args).unwrap_or_else(|message| usage_error("artefact", message));
    use_threads(args.run.threads);
    if args.experiment == LIST {
        list(args, &console);
        return if console.has_reported() { Exit::Done } else { Exit::OutputFailed };
    }
    left_out.iter().for_each(|(experiment, why)| leave_out(args, experiment, why, &console));
    if experiments.len() > 1 && console.verbosity > Verbosity::Quiet {
        unheeded(args, &experiments).iter().for_each(|text| console.note(text));
    }
    if args.parameters.interpolation.is_some()
        && args.animate.is_none()
        && console.verbosity > Verbosity::Quiet
    {
        console.note("--interpolation is that of the animation only: pictures and numbers show every way; --animate FILE draws it");
    }
    let result = guarded(|| work(args, &experiments, &console));
    match result {
        Err(failure) => {
            let error = ErrorReport::new(&failure);
            console.error(&error.message);
            if console.json {
                let setup = Setup { parameters: experiments[0].defaults, mesh: None };
                let report =
                    Report { status: "failed", error: Some(error), ..Report::new(experiments[0], &setup) };
                console.report(&json_line(&report));
            }
            exit_of(&failure)
        }
        Ok(_) if !console.has_reported() => Exit::OutputFailed,
        Ok(true) => Exit::Done,
        Ok(false) => Exit::Findings,
    }
}

fn list(args: &ArtefactArgs, console: &Console) {
    if console.json {
        for experiment in EXPERIMENTS {
            let setup = Setup { parameters: experiment.defaults, mesh: None };
            console.report(&json_line(&Report::new(experiment, &setup)));
        }
    } else {
        console.report(&list_table(args.lang).to_text());
    }
}

/// The options that were typed, of those that change what is drawn and measured.
fn typed(args: &ArtefactArgs) -> impl Iterator<Item = ParameterName> {
    let changes = args.parameters.changes();
    let has_mesh = args.own.mesh.is_some();
    ParameterName::ALL.into_iter().filter(move |&knob| match knob {
        ParameterName::Mesh => has_mesh,
        // Reported beside.
        ParameterName::Interpolation => false,
        _ => changes.only(&[knob]) != Changes::default(),
    })
}

/// Which of the options that were typed change only some of the experiments, in words.
fn unheeded(args: &ArtefactArgs, experiments: &[&'static Experiment]) -> Vec<String> {
    let reported = typed(args).filter_map(|knob| {
        let takes = |experiment: &&&Experiment| experiment.takes.contains(&knob);
        let ids: Vec<&str> = experiments.iter().filter(takes).map(|experiment| experiment.id).collect();
        (ids.len() < experiments.len()).then(|| match &ids[..] {
            [] => format!("--{} changes none of them", knob.name()),
            ids => format!("--{} changes {} only; the others are as without it", knob.name(), ids.join(", ")),
        })
    });
    reported.collect()
}

/// Tells that an experiment is left out where all are run.
fn leave_out(args: &ArtefactArgs, experiment: &'static Experiment, why: &ArtefactError, console: &Console) {
    if console.json {
        let parameters = args.parameters.changes().only(experiment.takes).apply(experiment.defaults);
        let setup = Setup { parameters, mesh: None };
        let error = ErrorReport { kind: "usage", message: why.to_string(), input: None };
        let report = Report { status: "left-out", error: Some(error), ..Report::new(experiment, &setup) };
        console.report(&json_line(&report));
    }
    if console.verbosity > Verbosity::Quiet {
        console.note(&format!("`{}` is left out: {why}", experiment.id));
    }
}

/// One experiment, run.
struct Run<'a> {
    experiment: &'static Experiment,
    setup: Setup<'a>,
    outcome: Outcome,
    seconds: f64,
}

/// Whether every number is what it should be.
fn work(
    args: &ArtefactArgs,
    experiments: &[&'static Experiment],
    console: &Console,
) -> Result<bool, Failure> {
    if let Some(folder) = &args.output {
        make_folder(folder).map_err(|error| Failure::Write(format!("{error:#}")))?;
    }
    let read = |path: Option<&PathBuf>| {
        let read = |path: &PathBuf| {
            read(path, args).map_err(|error| Failure::read_of(&path.to_string_lossy(), error))
        };
        path.map(read).transpose()
    };
    let (mesh, finer) = (read(args.own.mesh.as_ref())?, read(args.own.finer.as_ref())?);
    let [name, finer_name] = [&args.own.mesh, &args.own.finer]
        .map(|path| path.as_ref().map(|path| path.to_string_lossy()).unwrap_or_default());
    let finer = finer.as_ref().map(|mesh| (&*finer_name, mesh));
    let own = mesh.as_ref().map(|mesh| UserMesh { name: &name, mesh, finer });
    let changes = args.parameters.changes();
    let progress = match experiments {
        [one] => CountProgress::of_one(console, "measuring", one.id),
        all => CountProgress::new(console, "measuring", "experiments", all.len() as u64),
    };
    let run = |&experiment: &&'static Experiment| {
        let start = Instant::now();
        let setup = Setup {
            parameters: changes.only(experiment.takes).apply(experiment.defaults),
            mesh: own.filter(|_| experiment.takes.contains(&ParameterName::Mesh)),
        };
        let outcome =
            experiment.run(&setup).map_err(|error| Failure::Draw(format!("{}: {error}", experiment.id)))?;
        progress.done();
        Ok(Run { experiment, setup, outcome, seconds: start.elapsed().as_secs_f64() })
    };
    let runs: Vec<Run> = experiments.par_iter().with_max_len(1).map(run).collect::<Result<_, _>>()?;
    drop(progress);
    let mut files = match &args.output {
        Some(folder) => store::store(&runs, folder, args.lang)?,
        None => vec![Vec::new(); runs.len()],
    };
    if let (Some(path), Some(run)) = (&args.animate, runs.first()) {
        store::animate(run, path, args.frames, console)?;
        files[0].push(path.to_string_lossy().into_owned());
    }
    let mut agree = true;
    for (run, files) in runs.iter().zip(files) {
        let misses = misses(&run.outcome, Language::English);
        agree &= misses.is_empty();
        tell(run, files, misses.is_empty(), args, console);
        misses.iter().for_each(|miss| console.error(&format!("{}: {miss}", run.experiment.id)));
    }
    Ok(agree)
}

/// A command that draws the animation as well.
fn animated(command: String, args: &ArtefactArgs) -> String {
    match &args.animate {
        Some(path) => {
            format!("{command} --animate {} --frames {}", shell_word(&path.to_string_lossy()), args.frames)
        }
        None => command,
    }
}

fn tell(run: &Run, files: Vec<String>, agrees: bool, args: &ArtefactArgs, console: &Console) {
    let language = args.lang;
    let Run { experiment, setup, outcome, seconds } = run;
    if console.json {
        let report = Report {
            status: if agrees { "ok" } else { "findings" },
            outcome: Some(outcome),
            command: Some(animated(experiment.command(setup, language), args)),
            files,
            unheeded: typed(args)
                .filter(|knob| !experiment.takes.contains(knob))
                .map(ParameterName::name)
                .collect(),
            seconds: Some(*seconds),
            ..Report::new(experiment, setup)
        };
        console.report(&json_line(&report));
    } else if console.verbosity > Verbosity::Quiet {
        let title = console.report_style().paint(Style::BOLD, experiment.title().get(language));
        let claim = experiment.claim();
        let claim = claim.get(language);
        let [verdict, condition] = verdict_text(outcome, language);
        let numbers = measure_table(outcome, language).to_text();
        let files = match files.len() {
            0 => String::new(),
            _ => format!("  → {}\n", files.join(", ")),
        };
        console.report(&format!("{title}\n  {claim}\n  {verdict}: {condition}\n{numbers}{files}"));
    }
}

/// All meshes of a file as one, as they stand in it.
fn read(path: &Path, args: &ArtefactArgs) -> Result<Mesh, ReadError> {
    let options = ReadOptions::default();
    let loaded = match path.as_os_str() == "-" {
        true => io::read_bytes(read_stdin(&Limits::default(), |_| ())?, args.own.format, None, &options)?,
        false => io::read(path, args.own.format, &options)?,
    };
    Ok(as_one(loaded))
}

fn as_one(loaded: Loaded) -> Mesh {
    if let [part] = &loaded.parts[..] {
        return part.mesh.clone();
    }
    let (mut positions, mut faces) = (Vec::new(), Faces::default());
    for part in &loaded.parts {
        let first = positions.len() as u32;
        positions.extend_from_slice(part.mesh.positions());
        for face in 0..part.mesh.face_count() {
            let corners: Vec<u32> =
                part.mesh.faces().face(face).iter().map(|vertex| first + vertex).collect();
            faces.push(&corners);
        }
    }
    let builder = MeshBuilder { positions, faces, ..MeshBuilder::default() };
    builder.build().expect("parts are sound, and together they are no larger than their file")
}
