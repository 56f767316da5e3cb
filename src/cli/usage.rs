//! Wrong usage: what is wrong with a command line, and the next step.

use super::common::console::{Console, HELP};
use super::common::failure::{Exit, Failure, FailureKind};
use super::common::nearest::did_you_mean;
use super::common::options::{Color, RunArgs};
use clap::Error;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use std::error::Error as _;

/// Prints what is wrong with the command line of a verb, and ends the program.
pub fn usage_error(verb: &str, message: impl ToString) -> ! {
    print(verb, &message.to_string());
    std::process::exit(Exit::Usage as i32)
}

/// Ends a verb whose command line cannot be carried out; wrong usage ends the program.
pub fn refused(verb: &str, failure: &Failure, console: &Console) -> Exit {
    if failure.kind == FailureKind::Usage {
        usage_error(verb, &failure.message);
    }
    console.error(&failure.message);
    failure.exit()
}

/// Prints why clap refuses a command line. The verb is empty if the line has none.
pub fn explain(verb: &str, error: &Error) {
    print(verb, &explanation(verb, error));
}

/// Why clap refuses a command line and, after [`HELP`], the next step if there is one.
pub fn explanation(verb: &str, error: &Error) -> String {
    let (found, help) = refusal(error, verb);
    if help.is_empty() { found } else { format!("{found}{HELP}{help}") }
}

/// Prints a message; without a next step of its own, that is the help of the verb.
fn print(verb: &str, message: &str) {
    let console = Console::new(&RunArgs::default(), Color::Auto, None);
    match message.contains(HELP) {
        true => console.error(message),
        false => console.error(&format!("{message}{HELP}{}", see(verb, "lists the options"))),
    }
}

/// Refers to the long help.
fn see(verb: &str, does: &str) -> String {
    format!("`{} --help` {does}", format!("crease {verb}").trim_end())
}

/// What clap found, and the next step, which is empty if that is the help of the verb.
fn refusal(error: &Error, verb: &str) -> (String, String) {
    let all = |kind| match error.get(kind) {
        Some(ContextValue::Strings(texts)) => texts.clone(),
        Some(ContextValue::String(text)) => vec![text.clone()],
        Some(ContextValue::StyledStr(text)) => vec![text.to_string()],
        _ => Vec::new(),
    };
    let one = |kind| all(kind).into_iter().next().unwrap_or_default();
    let argument = name(&one(ContextKind::InvalidArg)).to_owned();
    let value = one(ContextKind::InvalidValue);
    let (verbs, options) = (see("", "lists the verbs"), see(verb, "lists the options"));
    let values = match all(ContextKind::ValidValue) {
        none if none.is_empty() => see(verb, &format!("describes {argument}")),
        values => format!("use one of: {}", values.join(", ")),
    };
    match error.kind() {
        ErrorKind::UnknownArgument if argument.starts_with('-') => {
            (format!("unknown option {argument}"), or_similar(&one(ContextKind::SuggestedArg), options))
        }
        ErrorKind::UnknownArgument => {
            (format!("unexpected argument {argument:?}"), see(verb, "lists the arguments"))
        }
        ErrorKind::InvalidSubcommand => {
            let word = one(ContextKind::InvalidSubcommand);
            // Clap's own list is not in the order of similarity.
            let similar = all(ContextKind::SuggestedSubcommand);
            let similar = did_you_mean(&word, similar.iter().map(String::as_str));
            (format!("unknown verb {word:?}"), format!("{similar}{verbs}"))
        }
        ErrorKind::MissingSubcommand => ("no verb is given".into(), verbs),
        ErrorKind::MissingRequiredArgument => {
            let missing = all(ContextKind::InvalidArg);
            let verb = if missing.len() > 1 { "are" } else { "is" };
            let missing = missing.join(" and ");
            let usage = one(ContextKind::Usage).replace("Usage:", "");
            (format!("{missing} {verb} required"), format!("usage: {}", usage.trim()))
        }
        ErrorKind::ArgumentConflict => {
            let others = all(ContextKind::PriorArg);
            let others: Vec<&str> = others.iter().map(|other| name(other)).collect();
            match &others[..] {
                [] => (
                    format!("{argument} cannot be used with other arguments"),
                    "omit the file and all other options".into(),
                ),
                [other] if *other == argument => {
                    (format!("{argument} is given twice"), "give it once".into())
                }
                others => {
                    let found = format!("{argument} cannot be used with {}", others.join(" and "));
                    (found, "omit one of them".into())
                }
            }
        }
        ErrorKind::InvalidValue if value.is_empty() => (format!("{argument} needs a value"), values),
        ErrorKind::InvalidValue => (
            format!("unknown value {value:?} of {argument}"),
            or_similar(&one(ContextKind::SuggestedValue), values),
        ),
        ErrorKind::ValueValidation => {
            let reason = error.source().map(|source| expected(&source.to_string())).unwrap_or_default();
            let (reason, help) = reason.split_once(HELP).unwrap_or((&reason, &values));
            let found = match reason.strip_prefix(&format!("{value:?} ")) {
                Some(reason) => format!("the value {value:?} of {argument} {reason}"),
                None => format!("wrong value {value:?} of {argument}: {reason}"),
            };
            (found, help.to_owned())
        }
        _ => {
            let text = error.to_string();
            let found = text.lines().next().unwrap_or_default();
            (found.trim_start_matches("error: ").to_owned(), String::new())
        }
    }
}

/// The name of an argument, without that of its value if it is an option.
fn name(argument: &str) -> &str {
    argument.split(' ').next().unwrap_or_default()
}

fn or_similar(similar: &str, help: String) -> String {
    if similar.is_empty() { help } else { format!("did you mean {similar}? {help}") }
}

/// The reason why a value is refused. The parsers of numbers of clap and of the standard library say it in terms of Rust.
fn expected(reason: &str) -> String {
    let range = |bounds: &str| match bounds.split_once("..") {
        Some((least, most)) => match most.trim_start_matches('=') {
            "" => format!("expected a whole number of {least} or more"),
            most => format!("expected a whole number from {least} to {most}"),
        },
        None => format!("expected a number in {bounds}"),
    };
    match reason.split_once(" is not in ") {
        Some((_, bounds)) => range(bounds),
        None if reason.ends_with("digit found in string") => "expected a whole number".into(),
        None if reason.contains("number too ") => "the number is beyond the range of this option".into(),
        None if reason.contains("float literal") => "expected a number".into(),
        None => reason.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::args::Cli;
    use clap::Parser;

    fn said(line: &str) -> String {
        let words = line.split(' ');
        let error = Cli::try_parse_from(words.clone()).err().unwrap();
        let (found, help) = refusal(&error, words.clone().nth(1).unwrap_or_default());
        format!("{found} / {help}")
    }

    #[test]
    fn refusals_have_a_fact_and_a_next_step() {
        let all = "`crease normals --help` lists the options";
        for (line, expected) in [
            ("crease normals --creese 3", "unknown option --creese / did you mean --crease? "),
            ("crease normals --zzz", &format!("unknown option --zzz / {all}")),
            (
                "crease normls",
                "unknown verb \"normls\" / did you mean normals? `crease --help` lists the verbs",
            ),
            (
                "crease nrmals",
                "unknown verb \"nrmals\" / did you mean normals? `crease --help` lists the verbs",
            ),
            ("crease stres", "unknown verb \"stres\" / did you mean stress? `crease --help` lists the verbs"),
            ("crease --color never", "no verb is given / `crease --help` lists the verbs"),
            ("crease normals", "<INPUT>... is required / usage: crease normals "),
            ("crease normals a -q -v", "--quiet cannot be used with --verbose / omit one of them"),
            ("crease normals a --to obj --to ply", "--to is given twice / give it once"),
            ("crease normals a --to", "--to needs a value / use one of: obj, ply, stl, gltf, glb"),
            (
                "crease normals a --threads",
                "--threads needs a value / `crease normals --help` describes --threads",
            ),
            (
                "crease normals a --weight angel",
                "unknown value \"angel\" of --weight / did you mean angle? use one of: uni",
            ),
            (
                "crease normals a --threads 0",
                "wrong value \"0\" of --threads: expected a whole number from 1 to 1024 / ",
            ),
            ("crease inspect a --places x", "wrong value \"x\" of --places: expected a whole number / "),
            ("crease surface sphere --jitter x", "wrong value \"x\" of --jitter: expected a number / "),
            ("crease inspect a --only flat", "wrong value \"flat\" of --only: no finding has this id / "),
            ("crease stress x", "unexpected argument \"x\" / `crease stress --help` lists the arguments"),
            ("crease inspect a --explain b", "[INPUT]... cannot be used with --explain / omit one of them"),
            (
                "crease render a --scene-help",
                "--scene-help cannot be used with other arguments / omit the file",
            ),
            ("crease surface", "--output <FILE> and <SURFACE> are required / "),
            (
                "crease inspect a --shard 4/4",
                "the value \"4/4\" of --shard is not I/N with I from 0 to N − 1, such as 0/4 / ",
            ),
        ] {
            assert!(said(line).starts_with(expected), "{line}: {}", said(line));
        }
    }
}
