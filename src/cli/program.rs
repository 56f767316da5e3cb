//! From the command line to an exit code.

use super::args::{Cli, Verb};
use super::common::command_line;
use super::common::failure::Exit;
use super::common::output::forgive_broken_pipe;
use super::{artefact, docs, help, inspect, journal, normals, plan, render, stress, surface, trade, usage};
use clap::error::ErrorKind;
use clap::{Command, Parser};
use std::ffi::OsString;
use std::io::Write as _;

/// Runs a command line, whose first word is the name of the program. Wrong usage ends the process.
pub fn run(line: Vec<OsString>) -> Exit {
    command_line::remember(&line);
    let cli = match Cli::try_parse_from(&line) {
        Ok(cli) => cli,
        Err(error) => {
            let mut command = help::for_line(help::command(), &line);
            let error = command.try_get_matches_from_mut(&line).err().unwrap_or(error);
            return reported(&error.format(&mut command), &command, &line);
        }
    };
    match cli.verb {
        Verb::Artefact(ref args) => artefact::run::main(args, cli.color),
        Verb::Normals(ref args) => normals::run::main(args, cli.color),
        Verb::Inspect(ref args) => inspect::run::main(args, cli.color),
        Verb::Journal(ref args) => journal::run::main(args, cli.color),
        Verb::Plan(ref args) => plan::run::main(args, cli.color),
        Verb::Render(ref args) if args.batch.manifest.is_some() => render::batch::main(args, cli.color),
        Verb::Render(ref args) => render::run::main(args, cli.color),
        Verb::Stress(ref args) => stress::run::main(args, cli.color),
        Verb::Surface(ref args) => surface::run::main(args, cli.color),
        Verb::Trade(ref args) => trade::run::main(args, cli.color),
        Verb::Completions { shell } => docs::completions(shell),
        Verb::Man { ref verb } => docs::manual(verb.as_deref()),
        Verb::Help { verb } => {
            let program = line.into_iter().take(1);
            run(program.chain(verb).chain(["--help".into()]).collect())
        }
    }
}

/// Prints wrong usage, or the help or version that was asked for; the latter can fail as any output can.
fn reported(error: &clap::Error, command: &Command, line: &[OsString]) -> Exit {
    if error.use_stderr() && error.kind() != ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
        let mut words = line.iter().skip(1).filter_map(|word| word.to_str());
        let verb = words.find(|word| command.find_subcommand(word).is_some());
        usage::explain(verb.unwrap_or_default(), error);
        return Exit::Usage;
    }
    let printed = forgive_broken_pipe(error.print().and_then(|()| std::io::stdout().flush()));
    match printed {
        Err(_) if !error.use_stderr() => Exit::OutputFailed,
        // A line without a verb prints the help to standard error.
        _ if error.use_stderr() => Exit::Usage,
        _ => Exit::Done,
    }
}
