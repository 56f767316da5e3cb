//! The help of `-h`, which fits on a screen: the common options, one line each. `--help` has all of them.

use clap::{Arg, Command};
use std::ffi::OsString;

/// The common options of each verb, by their long names.
const COMMON: [(&str, &str); 7] = [
    (
        "normals",
        "output out-dir in-place to recursive dry-run weight crease hard-edges when emit orient degenerate json quiet verbose",
    ),
    (
        "inspect",
        "recursive against html heatmap view severity fail-on only ignore explain deviation seam past-crease json quiet verbose",
    ),
    (
        "render",
        "output size samples compare turntable probe shading interpolation show overlay scene-help camera light material \
         weight crease when json quiet verbose",
    ),
    ("artefact", "output lang animate mesh size segments light exponent weight crease json quiet verbose"),
    (
        "surface",
        "output to radius height size semi-axes scale offset pattern segments level jitter noise seed uv json quiet verbose",
    ),
    ("trade", "output quick full markdown crease json quiet verbose"),
    ("stress", "only list json quiet verbose"),
];

/// The longest text in a line, after the name of its option.
const WIDTH: usize = 70;

/// The command with the help of `-h`, if a command line asks for it.
pub fn for_line(command: Command, line: &[OsString]) -> Command {
    if line.iter().any(|word| word == "-h") { brief(command) } else { command }
}

fn brief(command: Command) -> Command {
    let command = command.mut_arg("color", |arg| arg.hide_short_help(true));
    COMMON.iter().fold(command, |command, (verb, common)| {
        command.mut_subcommand(*verb, |verb| verb.mut_args(|arg| brief_arg(arg, common)))
    })
}

fn brief_arg(arg: Arg, common: &str) -> Arg {
    let Some(long) = arg.get_long() else { return arg };
    let is_common = common.split(' ').any(|name| name == long);
    let added = |kind: &str, width: usize| if width > 0 { width + kind.len() } else { 0 };
    let default = added(" [default: ]", arg.get_default_values().iter().map(|value| value.len()).sum());
    let names = arg.get_possible_values();
    let values = match arg.get_action().takes_values() {
        true => added(" [possible values: ]", names.iter().map(|value| value.get_name().len() + 2).sum()),
        false => 0,
    };
    let text = first_clause(&arg.get_help().map(ToString::to_string).unwrap_or_default(), WIDTH - default);
    let is_short = text.chars().count() + default + values <= WIDTH;
    arg.help(text).hide_short_help(!is_common).hide_possible_values(values > 0 && !is_short)
}

/// The help up to its first stop, or up to a comma if that is too long, and the default.
fn first_clause(help: &str, width: usize) -> String {
    let (help, default) = match help.split_once(" [default: ") {
        Some((help, default)) if !default.contains('[') => {
            (help, format!(" [default: {}]", cut(default.trim_end_matches(']'), &["; "])))
        }
        _ => (help, String::new()),
    };
    let mut text = cut(help, &[". ", "; ", ": ", " [default"]);
    while text.chars().count() + default.chars().count() > width
        && let Some((shorter, _)) = text.rsplit_once(", ")
    {
        text = shorter;
    }
    format!("{text}{default}")
}

fn cut<'a>(text: &'a str, stops: &[&str]) -> &'a str {
    let end = stops.iter().filter_map(|stop| text.find(stop)).min();
    &text[..end.unwrap_or(text.len())]
}
