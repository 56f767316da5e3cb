//! Options of a line of a manifest, which override those of the command line.

use super::args::Cli;
use super::common::command_line;
use super::common::failure::Failure;
use super::common::input::Input;
use super::usage::explanation;
use clap::{CommandFactory, FromArgMatches};
use std::ffi::OsString;

/// The options of the command line of a verb with those of a line of the manifest, which override them.
///
/// # Errors
/// If an option is unknown, has a wrong value, or cannot differ within a batch.
pub fn with_line<A: FromArgMatches>(verb: &str, input: &Input) -> Result<A, Failure> {
    let refused = |why: String| input.refused(Failure::usage(why));
    let command = Cli::command().mut_subcommand(verb, |command| command.args_override_self(true));
    let options = command.find_subcommand(verb).expect("a verb");
    for word in &input.options {
        let name = word.split('=').next().unwrap_or_default();
        if ["--help", "-h", "--version", "-V", "--color"].contains(&name) {
            return Err(refused(format!("{name} is not an option of one input\nhelp: remove it")));
        }
        let is_named = |arg: &&clap::Arg| match name.strip_prefix("--") {
            Some(long) => arg.get_long() == Some(long),
            None => name.strip_prefix('-').is_some_and(|it| it.chars().next() == arg.get_short()),
        };
        let is_fixed = |arg: &clap::Arg| {
            let of_run = ["Batches", "Running and reporting"].map(Some).contains(&arg.get_help_heading());
            of_run || FIXED.contains(&arg.get_id().as_str())
        };
        if options.get_arguments().find(is_named).is_some_and(is_fixed) {
            return Err(refused(format!(
                "{name} is the same for all inputs\nhelp: give it on the command line"
            )));
        }
    }
    let words = command_line::words().into_iter().chain(input.options.iter().map(OsString::from));
    let explained = |error: &clap::Error| refused(explanation(verb, error));
    let matches = command
        .clone()
        .try_get_matches_from(std::iter::once("crease".into()).chain(words))
        .map_err(|error| explained(&error))?;
    let (_, matches) = matches.subcommand().expect("a verb was given");
    A::from_arg_matches(matches).map_err(|error| explained(&error))
}

/// Options, by their ids, that hold for the whole of a batch, besides those of batches and of reporting.
const FIXED: [&str; 8] =
    ["output", "out_dir", "in_place", "recursive", "dry_run", "sync", "fail_on", "explain"];
