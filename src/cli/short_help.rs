//! The help of `-h`, which fits on a screen: the options that have a short help, one line each. `--help` has all of them.

use super::help::{VERBS, text};
use clap::{Arg, Command};
use crease::text::Catalogue;
use std::ffi::OsString;

/// The longest text in a line, after the name of its option.
const WIDTH: usize = 70;

/// The command with the help of `-h`, if a command line asks for it.
pub fn for_line(command: Command, line: &[OsString]) -> Command {
    if !line.iter().any(|word| word == "-h") {
        return command;
    }
    let command = command.mut_arg("color", |arg| arg.hide_short_help(true));
    VERBS.iter().fold(command, |command, (verb, texts, _)| {
        command.mut_subcommand(verb, |verb| verb.mut_args(|arg| brief(arg, texts)))
    })
}

fn brief(arg: Arg, texts: &Catalogue) -> Arg {
    if arg.get_long().is_none() {
        return arg;
    }
    let Some(text) = text(texts, &format!("{}-short", arg.get_id())) else {
        return arg.hide_short_help(true);
    };
    let added = |kind: &str, width: usize| if width > 0 { width + kind.len() } else { 0 };
    let default = added(" [default: ]", arg.get_default_values().iter().map(|value| value.len()).sum());
    let names = arg.get_possible_values();
    let values = match arg.get_action().takes_values() {
        true => added(" [possible values: ]", names.iter().map(|value| value.get_name().len() + 2).sum()),
        false => 0,
    };
    let is_short = text.chars().count() + default + values <= WIDTH;
    arg.help(text).hide_possible_values(values > 0 && !is_short)
}
