//! Completion scripts and manual pages, made from the same description as `--help`.

use super::args::{Cli, usage_error};
use super::common::failure::Exit;
use super::common::options::EXIT_CODES;
use super::common::output::to_stdout;
use super::normals::args::EXAMPLES;
use clap::{Arg, ArgAction, Command, CommandFactory};
use clap_complete::Shell;
use clap_mangen::Man;
use std::fmt::Write as _;

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
    let command = match verb {
        None => command,
        Some(verb) => match command.find_subcommand(verb) {
            Some(found) => found.clone(),
            None => usage_error("man", format!("there is no verb {verb:?}")),
        },
    };
    match page(&command) {
        Ok(text) => print(text.as_bytes()),
        Err(_) => Exit::OutputFailed,
    }
}

/// The sections of `clap_mangen`, but for a synopsis that names values, and the text behind the help under headings of
/// manual pages.
fn page(command: &Command) -> std::io::Result<String> {
    let man = Man::new(command.clone());
    let mut text = Vec::new();
    man.render_title(&mut text)?;
    man.render_name_section(&mut text)?;
    text.extend_from_slice(section("SYNOPSIS", &synopsis(command)).as_bytes());
    man.render_description_section(&mut text)?;
    man.render_options_section(&mut text)?;
    if command.has_subcommands() {
        man.render_subcommands_section(&mut text)?;
    }
    let mut text = String::from_utf8_lossy(&text).into_owned();
    for arg in command.get_positionals().filter(|arg| is_repeated(arg)) {
        let name = format!("<\\fI{}\\fR>", values(arg));
        text = text.replace(&name, &format!("{name}..."));
    }
    if command.get_name() == "normals" {
        text.push_str(&section("EXAMPLES", &verbatim(EXAMPLES)));
    }
    if command.get_after_help().is_some() {
        text.push_str(&section("EXIT STATUS", &verbatim(EXIT_CODES)));
    }
    Ok(text)
}

fn section(heading: &str, body: &str) -> String {
    format!(".SH \"{heading}\"\n{body}")
}

/// Lines unchanged, without their heading.
fn verbatim(text: &str) -> String {
    let lines: String = text.lines().skip(1).map(|line| format!("{}\n", roff(line.trim_start()))).collect();
    format!(".nf\n{lines}.fi\n")
}

fn synopsis(command: &Command) -> String {
    let name = command.get_bin_name().unwrap_or_else(|| command.get_name());
    let mut text = format!("\\fB{}\\fR", roff(name));
    for arg in command.get_arguments().filter(|arg| !arg.is_positional()) {
        let short = arg.get_short().map(|short| format!("-{short}"));
        let long = arg.get_long().map(|long| format!("--{long}"));
        let names: Vec<String> = [short, long].into_iter().flatten().collect();
        let value = if arg.get_action().takes_values() { format!(" {}", values(arg)) } else { String::new() };
        let _ = write!(text, " [\\fB{}\\fR{}]", roff(&names.join("|")), roff(&value));
    }
    for arg in command.get_positionals() {
        let dots = if is_repeated(arg) { "..." } else { "" };
        let name = format!("<{}>{dots}", values(arg));
        let _ = match arg.is_required_set() {
            true => write!(text, " \\fI{}\\fR", roff(&name)),
            false => write!(text, " [\\fI{}\\fR]", roff(&name)),
        };
    }
    if command.has_subcommands() {
        text.push_str(" \\fI<COMMAND>\\fR");
    }
    text.push('\n');
    text
}

fn values(arg: &Arg) -> String {
    let names = arg.get_value_names().unwrap_or_default();
    if names.is_empty() {
        return arg.get_id().as_str().to_uppercase();
    }
    names.iter().map(|name| name.as_str()).collect::<Vec<_>>().join(" ")
}

fn is_repeated(arg: &Arg) -> bool {
    matches!(arg.get_action(), ArgAction::Append) || arg.get_num_args().is_some_and(|n| n.max_values() > 1)
}

/// Text without what the formatter would take for its own.
fn roff(text: &str) -> String {
    let text = text.replace('\\', "\\e").replace('-', "\\-");
    if text.starts_with(['.', '\'']) { format!("\\&{text}") } else { text }
}

fn print(text: &[u8]) -> Exit {
    match to_stdout(text) {
        Ok(()) => Exit::Done,
        Err(_) => Exit::OutputFailed,
    }
}
