//! Runs `crease artefact`: experiments, their numbers, pages and pictures.

use super::args::{ArtefactArgs, LIST};
use super::choose::{Chosen, chosen, given};
use super::files::{self, Run};
use super::json::{Report, RunReport};
use crate::cli::common::console::{Console, Style, Verbosity};
use crate::cli::common::failure::{Exit, Failure, exit_code, guarded};
use crate::cli::common::input::Source;
use crate::cli::common::options::Color;
use crate::cli::common::output::make_folder;
use crate::cli::common::progress::Progress;
use crate::cli::usage::usage_error;
use crease::artefact::{ArtefactError, EXPERIMENTS, Experiment, Language, ParameterName, Setup, UserMesh};
use crease::io::{Loaded, ReadOptions, shell_word};
use crease::mesh::{Faces, Mesh, MeshBuilder};
use crease::report::{list_table, measure_table, misses, verdict_sentence};
use rayon::prelude::*;
use std::path::PathBuf;
use std::time::Instant;

pub fn main(args: &ArtefactArgs, color: Color) -> Exit {
    let console = Console::new(&args.run, color, None);
    let Chosen { run: experiments, left_out } =
        chosen(args).unwrap_or_else(|message| usage_error("artefact", Failure::advised(message).message));
    args.run.use_threads();
    if args.experiment == LIST {
        list(args, &console);
        return exit_code(Ok(Exit::Done), &console);
    }
    left_out.iter().for_each(|(experiment, why)| leave_out(args, experiment, why, &console));
    if console.verbosity > Verbosity::Quiet {
        if experiments.len() > 1 {
            unheeded(args, &experiments).iter().for_each(|text| console.note(text));
        }
        if args.parameters.interpolation.is_some() && args.animate.is_none() {
            console.note("--interpolation applies to the animation only\nhelp: draw it with --animate FILE");
        }
    }
    let result = guarded(|| run_all(args, &experiments, &console));
    if let Err(failure) = &result {
        console.error(&failure.message);
        report_unrun(
            experiments[0],
            &Setup { parameters: experiments[0].defaults, mesh: None },
            "failed",
            failure,
            &console,
        );
    }
    exit_code(result, &console)
}

fn list(args: &ArtefactArgs, console: &Console) {
    for experiment in EXPERIMENTS.iter().filter(|_| console.json) {
        let setup = Setup { parameters: experiment.defaults, mesh: None };
        console.print(&Report::new(experiment, &setup), String::new);
    }
    if !console.json {
        console.report(&list_table(args.lang).to_text());
    }
}

fn report_unrun(
    experiment: &'static Experiment,
    setup: &Setup<'_>,
    status: &'static str,
    why: &Failure,
    console: &Console,
) {
    let mut report = Report::new(experiment, setup);
    (report.head.status, report.head.error) = (status, Some(why.clone()));
    console.print(&report, String::new);
}

/// The options that some experiments ignore; `--interpolation` has a note of its own.
fn typed(args: &ArtefactArgs) -> impl Iterator<Item = ParameterName> {
    given(args).filter(|&name| name != ParameterName::Interpolation)
}

/// The given options that change only some of the experiments, in words.
fn unheeded(args: &ArtefactArgs, experiments: &[&'static Experiment]) -> Vec<String> {
    let reported = typed(args).filter_map(|name| {
        let takes = |experiment: &&&Experiment| experiment.takes.contains(&name);
        let ids: Vec<&str> = experiments.iter().filter(takes).map(|experiment| experiment.id).collect();
        (ids.len() < experiments.len()).then(|| match &ids[..] {
            [] => format!("--{} changes none of them", name.name()),
            ids => format!("--{} changes only {}", name.name(), ids.join(", ")),
        })
    });
    reported.collect()
}

/// Reports that an experiment is omitted where all are run.
fn leave_out(args: &ArtefactArgs, experiment: &'static Experiment, why: &ArtefactError, console: &Console) {
    let parameters = args.parameters.changes().only(experiment.takes).apply(experiment.defaults);
    let setup = Setup { parameters, mesh: None };
    report_unrun(experiment, &setup, "left-out", &Failure::usage(why), console);
    if console.verbosity > Verbosity::Quiet {
        console.note(&format!("`{}` is omitted: {why}", experiment.id));
    }
}

/// Runs experiments and writes their files. The exit code reports findings if a number is not as expected.
fn run_all(
    args: &ArtefactArgs,
    experiments: &[&'static Experiment],
    console: &Console,
) -> Result<Exit, Failure> {
    if let Some(folder) = &args.output {
        make_folder(folder)?;
    }
    let read = |path: Option<&PathBuf>| {
        let source = path.map(|path| Source::of(path));
        let read = |source: Source| {
            let loaded = source.read(args.own.format, &ReadOptions::default(), |_| ());
            let mesh = as_one(loaded.map_err(|error| Failure::read(&source.name(), error))?);
            Ok::<_, Failure>((source.name(), mesh))
        };
        source.map(read).transpose()
    };
    let (mesh, finer) = (read(args.own.mesh.as_ref())?, read(args.own.finer.as_ref())?);
    let finer = finer.as_ref().map(|(name, mesh)| (&**name, mesh));
    let own = mesh.as_ref().map(|(name, mesh)| UserMesh { name, mesh, finer });
    let changes = args.parameters.changes();
    let progress = match experiments {
        [one] => Progress::of_one(console, "measuring", one.id),
        all => Progress::of_count(console, "measuring", "experiments", all.len() as u64),
    };
    let run = |&experiment: &&'static Experiment| {
        let start = Instant::now();
        let setup = Setup {
            parameters: changes.only(experiment.takes).apply(experiment.defaults),
            mesh: own.filter(|_| experiment.takes.contains(&ParameterName::Mesh)),
        };
        let outcome = experiment
            .run(&setup)
            .map_err(|error| Failure::advised(format!("{}: {error}", experiment.id)))?;
        progress.done();
        Ok(Run { experiment, setup, outcome, seconds: start.elapsed().as_secs_f64() })
    };
    let runs: Vec<Run> = experiments.par_iter().with_max_len(1).map(run).collect::<Result<_, Failure>>()?;
    drop(progress);
    let mut written = match &args.output {
        Some(folder) => files::write_all(&runs, folder, args.lang)?,
        None => vec![Vec::new(); runs.len()],
    };
    if let (Some(path), Some(run)) = (&args.animate, runs.first()) {
        written[0].push(files::animate(run, path, args.frames, console)?);
    }
    let mut exit = Exit::Done;
    for (run, files) in runs.iter().zip(written) {
        let misses = misses(&run.outcome, Language::English);
        if !misses.is_empty() {
            exit = Exit::Findings;
        }
        print(run, files, misses.is_empty(), args, console);
        misses.iter().for_each(|miss| console.error(&format!("{}: {miss}", run.experiment.id)));
    }
    Ok(exit)
}

fn animated(command: String, args: &ArtefactArgs) -> String {
    match &args.animate {
        Some(path) => {
            format!("{command} --animate {} --frames {}", shell_word(&path.to_string_lossy()), args.frames)
        }
        None => command,
    }
}

fn print(run: &Run, files: Vec<String>, agrees: bool, args: &ArtefactArgs, console: &Console) {
    let language = args.lang;
    let Run { experiment, setup, outcome, seconds } = run;
    let mut report = Report::new(experiment, setup);
    report.head.status = if agrees { "ok" } else { "findings" };
    report.result = Some(RunReport {
        unheeded: typed(args)
            .filter(|name| !experiment.takes.contains(name))
            .map(ParameterName::name)
            .collect(),
        outcome,
        command: animated(experiment.command(setup, language), args),
        files: files.clone(),
        seconds: *seconds,
    });
    console.print(&report, || {
        let title = console.report_style.paint(Style::BOLD, experiment.title().get(language));
        let claim = experiment.claim();
        let claim = claim.get(language);
        let verdict = verdict_sentence(outcome, language);
        let numbers = measure_table(outcome, language).to_text();
        let files = if files.is_empty() { String::new() } else { format!("  → {}\n", files.join(", ")) };
        format!("{title}\n  {claim}\n  {verdict}\n{numbers}{files}")
    });
}

/// All meshes of a file as one, each at its own position.
fn as_one(loaded: Loaded) -> Mesh {
    if let [part] = &loaded.parts[..] {
        return part.mesh.clone();
    }
    let (mut positions, mut faces) = (Vec::new(), Faces::default());
    for part in &loaded.parts {
        let first = positions.len() as u32;
        positions.extend(part.mesh.positions().iter());
        for face in 0..part.mesh.face_count() {
            let corners: Vec<u32> =
                part.mesh.faces().face(face).iter().map(|vertex| first + vertex).collect();
            faces.push(&corners);
        }
    }
    let builder = MeshBuilder { positions: positions.into(), faces, ..MeshBuilder::default() };
    builder.build().expect("parts are sound, and together they are no larger than their file")
}
