//! The help of the program. Texts are in Fluent files next to the options, and are read only when
//! help is printed. The help of `-h` fits on a screen: the options that have a short text, one line each.

use super::args::Cli;
use super::common::choice::english;
use clap::{Arg, Command, CommandFactory};
use crease::text::{Catalogue, Language};
use std::ffi::OsString;

/// Texts of the program, and of options that several verbs have.
static SHARED: Catalogue = english(include_str!("help.en.ftl"));

/// The texts of each verb, and what its long help begins with.
static VERBS: [(&str, Catalogue, &str); 9] = [
    ("normals", english(include_str!("normals/help.en.ftl")), ""),
    ("inspect", english(include_str!("inspect/help.en.ftl")), ""),
    ("render", english(include_str!("render/help.en.ftl")), include_str!("render/syntax.txt")),
    ("artefact", english(include_str!("artefact/help.en.ftl")), ""),
    ("surface", english(include_str!("surface/help.en.ftl")), ""),
    ("trade", english(include_str!("trade/help.en.ftl")), ""),
    ("stress", english(include_str!("stress/help.en.ftl")), ""),
    ("plan", english(include_str!("plan/help.en.ftl")), ""),
    ("journal", english(include_str!("journal/help.en.ftl")), ""),
];

const EXIT_CODES: &str = include_str!("exit_codes.txt");

/// The command line with all of its help.
pub fn command() -> Command {
    let program = described(Cli::command(), &SHARED, "").after_help(EXIT_CODES.trim_end());
    let program = VERBS.iter().fold(program, |program, (verb, texts, syntax)| {
        let short = examples(texts, "example");
        let long = format!("{syntax}\n{short}\n\n{EXIT_CODES}");
        program.mut_subcommand(verb, |command| {
            described(command, texts, "").after_help(short).after_long_help(long.trim().to_owned())
        })
    });
    let program = program.mut_subcommand("help", |command| described(command, &SHARED, "help-"));
    ["completions", "man"].into_iter().fold(program, |program, verb| {
        let examples = examples(&SHARED, &format!("{verb}-example"));
        program.mut_subcommand(verb, |command| {
            described(command, &SHARED, &format!("{verb}-")).after_help(examples)
        })
    })
}

fn examples(texts: &Catalogue, stem: &str) -> String {
    let examples = texts.list(stem).into_iter();
    let lines: String = examples.map(|text| format!("\n  {}", text.get(Language::English))).collect();
    format!("Examples:{lines}")
}

/// A command with its own help and that of its options, whose keys have a prefix.
fn described(command: Command, texts: &Catalogue, prefix: &str) -> Command {
    let about = text(texts, &format!("{prefix}about")).unwrap_or_default();
    let command = match about.split_once("\n\n") {
        Some((first, _)) => command.about(first.to_owned()).long_about(about),
        None => command.about(about),
    };
    command.mut_args(|arg| match text(texts, &format!("{prefix}{}", arg.get_id())) {
        Some(help) => arg.help(help),
        None => arg,
    })
}

/// The text of a key, a verb's own or a shared one; in keys, hyphens replace the underscores of option ids.
fn text(texts: &Catalogue, key: &str) -> Option<String> {
    let key = key.replace('_', "-");
    let texts = [texts, &SHARED].into_iter().find(|texts| texts.has(&key))?;
    Some(texts.get(&key).get(Language::English).to_owned())
}

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

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    fn keys(source: &str) -> impl Iterator<Item = &str> {
        source
            .lines()
            .filter(|line| line.starts_with(|c: char| c.is_ascii_lowercase()))
            .filter_map(|line| line.split(' ').next())
    }

    /// Every verb, option and value has its help, and every text is the help of one.
    #[test]
    fn all_help_is_there_and_used() {
        let program = command();
        let mut known: BTreeSet<String> = [
            "about",
            "completions-about",
            "completions-shell",
            "help-about",
            "help-verb",
            "man-about",
            "man-verb",
            "color",
        ]
        .map(str::to_owned)
        .into();
        let mut values = BTreeSet::new();
        for (verb, ..) in &VERBS {
            let command = program.find_subcommand(verb).unwrap();
            assert!(command.get_about().is_some_and(|about| !about.to_string().is_empty()), "{verb}");
            for arg in command.get_arguments() {
                known.insert(arg.get_id().as_str().replace('_', "-"));
                assert!(arg.get_help().is_some(), "{verb}: {}", arg.get_id());
                for value in arg.get_possible_values().iter().filter(|_| arg.get_action().takes_values()) {
                    let help = value.get_help().unwrap().to_string();
                    assert!(!help.starts_with('{'), "{verb}: {help}");
                    values.insert(help);
                }
            }
        }
        let sources = [
            include_str!("help.en.ftl"),
            include_str!("normals/help.en.ftl"),
            include_str!("inspect/help.en.ftl"),
            include_str!("render/help.en.ftl"),
            include_str!("artefact/help.en.ftl"),
            include_str!("surface/help.en.ftl"),
            include_str!("trade/help.en.ftl"),
            include_str!("stress/help.en.ftl"),
            include_str!("plan/help.en.ftl"),
            include_str!("journal/help.en.ftl"),
        ];
        for key in sources.into_iter().flat_map(keys).filter(|key| !key.contains("example-")) {
            assert!(known.contains(key.trim_end_matches("-short")), "{key} is no option");
        }
        let texts = english(include_str!("common/values.en.ftl"));
        for key in keys(include_str!("common/values.en.ftl")).filter(|key| !key.starts_with("color-")) {
            assert!(values.contains(texts.get(key).get(Language::English)), "{key} is no value");
        }
    }
}
