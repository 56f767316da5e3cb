//! Completion scripts and manual pages, made from the same description as `--help`.

use super::common::console::HELP;
use super::common::failure::Exit;
use super::common::nearest::did_you_mean;
use super::common::output::to_stdout;
use super::help;
use super::usage::usage_error;
use clap::Command;
use clap_complete::Shell;
use clap_mangen::Man;
use std::io::Write as _;

pub fn completions(shell: Shell) -> Exit {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut help::command(), "crease", &mut script);
    print(&script)
}

pub fn manual(verb: Option<&str>) -> Exit {
    let mut command = help::command();
    command.build();
    let command = match verb {
        None => command,
        Some(verb) => match command.find_subcommand(verb) {
            Some(found) => found.clone(),
            None => {
                let names = command.get_subcommands().map(Command::get_name);
                let similar = did_you_mean(verb, names);
                usage_error(
                    "man",
                    format!("unknown verb {verb:?}{HELP}{similar}`crease --help` lists the verbs"),
                )
            }
        },
    };
    match page(&command) {
        Ok(page) => print(&page),
        Err(_) => Exit::OutputFailed,
    }
}

/// The sections of `clap_mangen`, and the text after the help: examples and exit codes.
fn page(command: &Command) -> std::io::Result<Vec<u8>> {
    let man = Man::new(command.clone());
    let mut page = Vec::new();
    man.render_title(&mut page)?;
    man.render_name_section(&mut page)?;
    man.render_synopsis_section(&mut page)?;
    man.render_description_section(&mut page)?;
    man.render_options_section(&mut page)?;
    if command.has_subcommands() {
        man.render_subcommands_section(&mut page)?;
    }
    let after = command.get_after_long_help().or(command.get_after_help());
    for line in after.map(ToString::to_string).unwrap_or_default().lines() {
        // Backslashes, hyphens and dots at the start have a meaning of their own.
        let text = line.trim_start().replace('\\', "\\e").replace('-', "\\-");
        match text.strip_suffix(':').filter(|_| !line.starts_with(' ')) {
            Some(heading) => writeln!(page, ".SH \"{}\"\n.nf", heading.to_uppercase())?,
            None => writeln!(page, "\\&{text}")?,
        }
    }
    Ok(page)
}

fn print(text: &[u8]) -> Exit {
    match to_stdout(text) {
        Ok(()) => Exit::Done,
        Err(_) => Exit::OutputFailed,
    }
}
