//! The experiments that a command line names, and whether its options suit them.

use super::args::{ALL, ArtefactArgs, LIST};
use crease::artefact::{ArtefactError, Changes, EXPERIMENTS, Experiment, ParameterName, experiment};
use std::path::Path;

pub struct Chosen {
    pub run: Vec<&'static Experiment>,
    /// Of all experiments, those that a given value does not suit, and why.
    pub left_out: Vec<(&'static Experiment, ArtefactError)>,
}

/// The named experiments, if they take the given options.
pub fn chosen(args: &ArtefactArgs) -> Result<Chosen, String> {
    if let Some(path) = &args.animate {
        refuse_other_than_gif(path)?;
    }
    match args.experiment.as_str() {
        LIST => refuse_to_list(args).map(|()| Chosen { run: EXPERIMENTS.to_vec(), left_out: vec![] }),
        ALL => all(args),
        name => one(name, args).map_err(|error| error.to_string()),
    }
}

/// The given options, of those that change pictures and measurements.
pub fn given(args: &ArtefactArgs) -> impl Iterator<Item = ParameterName> {
    let mesh = args.own.mesh.is_some().then_some(ParameterName::Mesh);
    args.parameters.changes().names().chain(mesh)
}

fn accept(experiment: &Experiment, changes: &Changes) -> Result<(), ArtefactError> {
    experiment.accept(&changes.only(experiment.takes).apply(experiment.defaults))
}

fn one(name: &str, args: &ArtefactArgs) -> Result<Chosen, ArtefactError> {
    let chosen = experiment(name)?;
    chosen.refuse(given(args))?;
    accept(chosen, &args.parameters.changes())?;
    if args.animate.is_some() {
        chosen.refuse_still()?;
    }
    Ok(Chosen { run: vec![chosen], left_out: vec![] })
}

/// All experiments; each uses the options that it takes. An option that none takes is refused, and so is a value that none of
/// its takers accepts.
fn all(args: &ArtefactArgs) -> Result<Chosen, String> {
    if args.animate.is_some() {
        return Err("an animation shows one experiment\nhelp: name it in place of `all`".into());
    }
    let changes = args.parameters.changes();
    for name in given(args) {
        let takers = EXPERIMENTS.iter().filter(|experiment| experiment.takes.contains(&name));
        let refusals = takers.map(|experiment| accept(experiment, &changes.only(&[name])).err());
        match refusals.min_by_key(Option::is_some) {
            None => return Err(format!("no experiment takes --{}", name.name())),
            Some(Some(error)) => return Err(error.to_string()),
            Some(None) => {}
        }
    }
    let mut chosen = Chosen { run: vec![], left_out: vec![] };
    for experiment in EXPERIMENTS {
        match accept(experiment, &changes) {
            Ok(()) => chosen.run.push(experiment),
            Err(error) => chosen.left_out.push((experiment, error)),
        }
    }
    Ok(chosen)
}

/// A list draws nothing and runs nothing, so all of this would be lost.
fn refuse_to_list(args: &ArtefactArgs) -> Result<(), String> {
    let option = match given(args).next() {
        _ if args.output.is_some() => "-o".to_owned(),
        _ if args.animate.is_some() => "--animate".to_owned(),
        Some(name) => format!("--{}", name.name()),
        None => return Ok(()),
    };
    Err(format!("`list` ignores {option}\nhelp: omit it, or name an experiment or `all` in place of `list`"))
}

fn refuse_other_than_gif(path: &Path) -> Result<(), String> {
    let shown = path.display();
    match path.extension() {
        _ if path.as_os_str() == "-" => {
            Err("--animate cannot write to standard output\nhelp: name a file such as turn.gif".into())
        }
        Some(ending) if !ending.eq_ignore_ascii_case("gif") => {
            let gif = path.with_extension("gif");
            Err(format!("--animate writes a GIF, not {shown}\nhelp: use {}", gif.display()))
        }
        _ => Ok(()),
    }
}
