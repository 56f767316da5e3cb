//! What goes to which stream, and how it looks there.

use super::options::{Color, RunArgs};
use super::output::forgive_broken_pipe;
use crease::io::{Note, Place, Severity};
use serde::Serialize;
use std::cell::Cell;
use std::fmt::Write as _;
use std::io::{self, IsTerminal, Write};
use std::path::Path;

/// How many notes of an input are printed unless all are asked for.
const NOTES: usize = 20;

/// Separates the fact from the next step in messages.
pub const HELP: &str = "\nhelp: ";

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verbosity {
    Quiet,
    Normal,
    Verbose,
}

/// The streams of this run.
#[derive(Debug)]
pub struct Console {
    pub json: bool,
    pub verbosity: Verbosity,
    /// Standard output carries a mesh, so reports go to standard error.
    reports_to_stderr: bool,
    pub report_style: Style,
    error_style: Style,
    /// A report could not be printed.
    pub failed: Cell<bool>,
}

/// Whether text may carry colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Style(bool);

impl Style {
    pub const BOLD: &str = "1";
    pub const RED: &str = "1;31";
    pub const YELLOW: &str = "1;33";
    #[cfg(test)]
    pub const PLAIN: Style = Style(false);

    /// Text in a colour, or unchanged.
    pub fn paint(self, colour: &str, text: &str) -> String {
        if self.0 { format!("\x1b[{colour}m{text}\x1b[0m") } else { text.to_owned() }
    }

    /// The first line of a report: the input, and the output if there is one.
    pub fn title(self, input: &str, output: Option<&str>) -> String {
        let bold = |name| self.paint(Self::BOLD, &escaped(name));
        output.map_or_else(|| bold(input), |output| format!("{} -> {}", bold(input), bold(output)))
    }
}

impl Console {
    pub fn new(run: &RunArgs, color: Color, output: Option<&Path>) -> Self {
        let reports_to_stderr = output.is_some_and(|path| path.as_os_str() == "-");
        let variable = |name: &str| std::env::var(name).ok();
        let style = |terminal| Style(use_color(color, terminal, variable));
        let error_style = style(io::stderr().is_terminal());
        Self {
            json: run.json,
            verbosity: match (run.quiet, run.verbose) {
                (true, _) => Verbosity::Quiet,
                (_, true) => Verbosity::Verbose,
                _ => Verbosity::Normal,
            },
            reports_to_stderr,
            report_style: if reports_to_stderr { error_style } else { style(io::stdout().is_terminal()) },
            error_style,
            failed: Cell::new(false),
        }
    }

    /// Whether standard error is left to the JSON report, so that it can be parsed.
    fn stderr_is_json(&self) -> bool {
        self.json && self.reports_to_stderr
    }

    pub fn may_show_progress(&self) -> bool {
        self.verbosity > Verbosity::Quiet && !self.stderr_is_json() && io::stderr().is_terminal()
    }

    /// Prints a report: as JSON on one line if that was asked for, else as text unless the run is quiet.
    pub fn print(&self, report: &impl Serialize, text: impl FnOnce() -> String) {
        if self.json {
            let line = serde_json::to_string(report).expect("a report has string keys");
            self.report(&(line + "\n"));
        }
        self.text(text);
    }

    /// Prints text of a report, unless the report is JSON or the run is quiet.
    pub fn text(&self, text: impl FnOnce() -> String) {
        if !self.json && self.verbosity > Verbosity::Quiet {
            self.report(&text());
        }
    }

    /// Prints a report, text or JSON, whole lines. Reports are outputs: one that is lost is a failure.
    pub fn report(&self, text: &str) {
        let printed = if self.reports_to_stderr {
            write(io::stderr().lock(), text)
        } else {
            write(io::stdout().lock(), text)
        };
        if let Err(error) = printed
            && !self.failed.replace(true)
        {
            self.error(&format!("the report could not be written: {error}"));
        }
    }

    pub fn error(&self, message: &str) {
        self.remark(Style::RED, "error", message);
    }

    pub fn about(&self, severity: Severity, message: &str) {
        match severity {
            Severity::Note => self.note(message),
            Severity::Warning => self.remark(Style::YELLOW, "warning", message),
        }
    }

    /// Prints a note.
    pub fn note(&self, message: &str) {
        self.remark(Style::BOLD, "note", message);
    }

    /// Prints the notes of an input: when brief, warnings only.
    pub fn notes(&self, path: &str, notes: &[Note], brief: bool) {
        let all = self.verbosity == Verbosity::Verbose;
        let most = if all { usize::MAX } else { NOTES };
        let wanted: Vec<_> =
            notes.iter().filter(|note| !brief || note.severity == Severity::Warning).collect();
        for note in wanted.iter().take(most) {
            let text = if all { with_places(note) } else { note.to_string() };
            self.about(note.severity, &format!("{path}: {text}"));
        }
        if wanted.len() > most {
            self.note(&format!("{path}: {} more; -v shows them", wanted.len() - most));
        }
    }

    fn remark(&self, colour: &str, kind: &str, message: &str) {
        if self.stderr_is_json() {
            return;
        }
        let line = |colour, kind: &str, text| {
            let label = self.error_style.paint(colour, &format!("{kind}:"));
            format!("{label} {}\n", escaped(text))
        };
        let (found, help) = message.split_once(HELP).unwrap_or((message, ""));
        let help = if help.is_empty() { String::new() } else { line(Style::BOLD, "help", help) };
        // Where remarks cannot be printed, neither can a complaint about that.
        let _ = write(io::stderr().lock(), &(line(colour, kind, found) + &help));
    }
}

/// A note with the places of those that are alike.
fn with_places(note: &Note) -> String {
    let mut places: Vec<String> = note.also.iter().map(Place::to_string).collect();
    if places.is_empty() {
        return note.to_string();
    }
    if note.more > places.len() as u64 {
        places.push("…".into());
    }
    let text = note.to_string();
    format!("{}: {})", text.trim_end_matches(')'), places.join(", "))
}

/// Writes text. That its reader has gone away is no failure.
fn write(mut stream: impl Write, text: &str) -> io::Result<()> {
    forgive_broken_pipe(stream.write_all(text.as_bytes()).and_then(|()| stream.flush()))
}

/// Colour by choice, else by environment, else by terminal (no-color.org, bixense.com/clicolors).
fn use_color(choice: Color, terminal: bool, variable: impl Fn(&str) -> Option<String>) -> bool {
    let set = |name| variable(name).is_some_and(|value| !value.is_empty());
    match choice {
        Color::Always => true,
        Color::Never => false,
        Color::Auto if set("NO_COLOR") => false,
        Color::Auto if variable("CLICOLOR_FORCE").is_some_and(|value| !value.is_empty() && value != "0") => {
            true
        }
        Color::Auto => terminal,
    }
}

/// Appends a text in lines of at most 100 characters, the first and the others after an indent. Code stays on one line.
pub fn push_wrapped(out: &mut String, text: &str, [first, others]: [&str; 2]) {
    let mut line = first.to_owned();
    let mut words = text.split(' ');
    while let Some(word) = words.next() {
        let mut word = word.to_owned();
        while word.matches('`').count() % 2 == 1 {
            let Some(next) = words.next() else { break };
            word.extend([" ", next]);
        }
        if line.trim_start() != "" && line.chars().count() + word.chars().count() > 100 {
            out.extend([line.trim_end(), "\n"]);
            line = others.to_owned();
        }
        line.extend([word.as_str(), " "]);
    }
    out.extend([line.trim_end(), "\n"]);
}

/// Text that cannot steer a terminal: control characters and marks that turn the direction of writing are
/// escaped. Names come from files and folders, and may hold anything.
pub fn escaped(text: &str) -> String {
    let is_steering = |c: char| {
        c.is_control()
            || matches!(c, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
    };
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            _ if !is_steering(c) => out.push(c),
            '\n' | '\t' | '\r' => out.extend(c.escape_default()),
            _ => drop(write!(out, "\\u{{{:x}}}", u32::from(c))),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn control_characters_are_escaped() {
        assert_eq!(escaped("a\x1b[31mb\nc\u{202e}d é °"), "a\\u{1b}[31mb\\nc\\u{202e}d é °");
    }

    #[test]
    fn colour_follows_choice_then_environment_then_terminal() {
        let with = |color, terminal, names: &[(&str, &str)]| {
            use_color(color, terminal, |name| {
                names.iter().find(|(known, _)| *known == name).map(|(_, value)| (*value).to_owned())
            })
        };
        assert!(with(Color::Auto, true, &[]));
        assert!(!with(Color::Auto, false, &[]));
        assert!(!with(Color::Auto, true, &[("NO_COLOR", "1"), ("CLICOLOR_FORCE", "1")]));
        assert!(with(Color::Auto, true, &[("NO_COLOR", "")]));
        assert!(with(Color::Auto, false, &[("CLICOLOR_FORCE", "1")]));
        assert!(!with(Color::Auto, false, &[("CLICOLOR_FORCE", "0")]));
        assert!(with(Color::Always, false, &[("NO_COLOR", "1")]));
        assert!(!with(Color::Never, true, &[("CLICOLOR_FORCE", "1")]));
    }
}
