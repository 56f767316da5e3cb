//! Completion scripts and manual pages, made from the same description as `--help`.

use super::args::Cli;
use super::output::to_stdout;
use super::{Exit, usage_error};
use clap::CommandFactory;
use clap_complete::Shell;

/// Prints the completion script of a shell.
pub fn completions(shell: Shell) -> Exit {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Cli::command(), "crease", &mut script);
    print(&script)
}

/// Prints the manual page of the program or of one verb.
pub fn manual(verb: Option<&str>) -> Exit {
    let mut command = Cli::command();
    command.build();
    let page = match verb {
        None => command,
        Some(verb) => match command.find_subcommand(verb) {
            Some(found) => found.clone(),
            None => usage_error("man", format!("there is no verb {verb:?}")),
        },
    };
    let mut text = Vec::new();
    match clap_mangen::Man::new(page).render(&mut text) {
        Ok(()) => print(&text),
        Err(_) => Exit::OutputFailed,
    }
}

fn print(text: &[u8]) -> Exit {
    match to_stdout(text) {
        Ok(()) => Exit::Done,
        Err(_) => Exit::OutputFailed,
    }
}
