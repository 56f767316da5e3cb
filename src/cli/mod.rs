//! The command-line program: what was typed ([`args`]) becomes a checked [`request`], which is carried out input
//! by input ([`batch`], [`normals`]) and told about ([`report`], [`text`]). Other verbs have a module each ([`artefact`],
//! [`inspect`], [`render`], [`stress`], [`surface`], [`trade`]).

mod args;
mod artefact;
mod batch;
mod choice;
mod console;
mod docs;
mod inputs;
mod inspect;
mod normals;
mod notes;
mod output;
mod progress;
mod render;
mod report;
mod request;
mod stress;
mod surface;
mod text;
mod trade;

use args::{Cli, NormalsArgs, Verb};
use clap::error::ErrorKind;
use clap::{CommandFactory, Parser};
use console::Console;
use request::{Request, RequestError};
use std::io::Write as _;
use std::process::ExitCode;

/// What the program tells its caller. Wrong usage ends it in [`usage_error`], with clap's 2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Exit {
    Done = 0,
    Findings = 1,
    Usage = 2,
    BadInput = 3,
    OutputFailed = 4,
    PartOfBatch = 5,
}

/// Runs the program on the arguments that it was started with.
pub fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => return reported(&error),
    };
    let exit = match cli.verb {
        Verb::Artefact(ref args) => artefact::main(args, cli.color),
        Verb::Normals(ref args) => normals_verb(args, &cli),
        Verb::Inspect(ref args) => inspect::main(args, cli.color),
        Verb::Render(ref args) => render::main(args, cli.color),
        Verb::Stress(ref args) => stress::main(args, cli.color),
        Verb::Surface(ref args) => surface::main(args, cli.color),
        Verb::Trade(ref args) => trade::main(args, cli.color),
        Verb::Completions { shell } => docs::completions(shell),
        Verb::Man { ref verb } => docs::manual(verb.as_deref()),
    };
    ExitCode::from(exit as u8)
}

fn normals_verb(args: &NormalsArgs, cli: &Cli) -> Exit {
    let console = Console::new(&args.run, cli.color, args.output.output.as_deref());
    let request = match Request::resolve(args) {
        Ok(request) => request,
        Err(RequestError::Usage(message)) => usage_error("normals", message),
        Err(RequestError::Input(message)) => {
            console.error(&message);
            return Exit::BadInput;
        }
    };
    use_threads(args.run.threads);
    batch::run(&request, &console)
}

/// Prints wrong usage, or the help or version that was asked for; the latter can fail as any output can.
fn reported(error: &clap::Error) -> ExitCode {
    let printed = output::forgive_broken_pipe(error.print().and_then(|()| std::io::stdout().flush()));
    match printed {
        Err(_) if !error.use_stderr() => ExitCode::from(Exit::OutputFailed as u8),
        _ => ExitCode::from(error.exit_code() as u8),
    }
}

/// Bounds the number of threads; to be called before any work is done.
fn use_threads(threads: Option<u16>) {
    if let Some(threads) = threads {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.into()).build_global();
        pool.expect("the pool has not been used yet");
    }
}

/// Prints a message and the verb's usage as clap does for its own errors, and ends the program.
fn usage_error(verb: &str, message: String) -> ! {
    let mut command = Cli::command();
    command.build();
    let verb = command.find_subcommand_mut(verb).expect("a verb of this program");
    verb.error(ErrorKind::ArgumentConflict, message).exit()
}
