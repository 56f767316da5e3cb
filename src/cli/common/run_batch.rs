//! The loop over the inputs of a verb: several at a time, with progress, a journal and an exit code.

use super::batch::{BatchArgs, memory_need};
use super::console::{Console, HELP, escaped};
use super::failure::{Exit, Failure, exit_code};
use super::input::Source;
use super::jobs::Turn;
use super::ledger::Ledger;
use super::numbers::count;
use super::progress::{FileProgress, Progress};
use super::report::{Head, SKIPPED};
use crease::io::Format;
use std::ops::ControlFlow;

/// Some inputs, and those that failed with their errors.
#[derive(Debug)]
pub struct Batch {
    inputs: usize,
    /// Inputs that were processed.
    processed: usize,
    skipped: usize,
    failed: Vec<(String, Failure)>,
    /// The exit code if no input fails.
    pub exit: Exit,
}

impl Batch {
    pub fn new(inputs: usize) -> Self {
        Self { inputs, processed: 0, skipped: 0, failed: Vec::new(), exit: Exit::Done }
    }

    /// Counts an input by the first members of its report.
    pub fn count(&mut self, path: &str, head: &Head) {
        self.processed += 1;
        self.skipped += usize::from(head.status == SKIPPED);
        self.failed.extend(head.error.clone().map(|failure| (path.to_owned(), failure)));
    }

    /// Prints a summary of several inputs, and returns the exit code.
    pub fn finish(mut self, console: &Console) -> Exit {
        if self.inputs > 1 {
            console.text(|| self.summary());
        }
        let result = match self.failed.pop() {
            Some(_) if self.inputs > 1 => Ok(Exit::PartOfBatch),
            Some((_, failure)) => Err(failure),
            None => Ok(self.exit),
        };
        exit_code(result, console)
    }

    fn summary(&self) -> String {
        let (files, failed) = (count(self.inputs, "file"), self.failed.len());
        let found = |failure: &Failure| escaped(failure.message.split(HELP).next().unwrap_or_default());
        let lines = self.failed.iter().map(|(path, why)| format!("  {}: {}\n", escaped(path), found(why)));
        let before = match self.skipped {
            0 => String::new(),
            skipped => format!(" ({skipped} of them before)"),
        };
        let rest = match self.inputs - self.processed {
            0 => String::new(),
            rest => format!(", {rest} not processed"),
        };
        match failed {
            0 => format!("{files} done{before}\n"),
            _ => format!(
                "{} of {files} done{before}{rest}, {failed} failed:\n{}",
                self.processed - failed,
                lines.collect::<String>()
            ),
        }
    }
}

/// What the work on an input shares with that on others.
pub struct Shared<'a> {
    pub ledger: &'a Ledger,
    pub turn: &'a Turn<'a>,
    pub progress: &'a FileProgress<'a>,
}

/// The work on an input, recorded in the journal.
pub struct Recorded<R> {
    pub report: R,
    pub has_failed: bool,
    /// Whether the journal could be written.
    pub journal: Result<(), Failure>,
}

impl<R> Recorded<R> {
    /// An earlier run has done the work.
    pub fn skipped(report: R) -> Self {
        Self { report, has_failed: false, journal: Ok(()) }
    }
}

/// Does the work of all items. `source` is an item's input with its format, if that is known. `finish` counts and prints a
/// report; the reports come in the order of the items. The batch stops if its journal cannot be written, and with `--keep-going=false` after a failure.
pub fn run_batch<'a, T: Sync, R: Send>(
    console: &Console,
    args: &BatchArgs,
    ledger: &Ledger,
    items: &'a [T],
    source: impl Fn(&'a T) -> (&'a Source, Option<Format>) + Sync,
    work: impl Fn(&'a T, &Shared<'_>) -> Recorded<R> + Sync,
    mut finish: impl FnMut(&'a T, R, &mut Batch),
) -> Exit {
    ledger.note(console);
    let progress = Progress::of_inputs(console, items.iter().map(|item| source(item).0));
    let needs: Vec<u64> =
        items.iter().map(&source).map(|(source, format)| memory_need(source, format)).collect();
    let (mut batch, mut stopped) = (Batch::new(items.len()), None);
    let work = |item: &'a T, turn: &Turn<'_>| {
        let progress = progress.begin(source(item).0);
        let done = work(item, &Shared { ledger, turn, progress: &progress });
        let is_last = done.journal.is_err() || done.has_failed && !args.keep_going;
        if is_last { ControlFlow::Break(done) } else { ControlFlow::Continue(done) }
    };
    args.jobs().run(items, &needs, work, |item, done| {
        progress.suspended(|| finish(item, done.report, &mut batch));
        stopped = stopped.take().or(done.journal.err());
    });
    drop(progress);
    match stopped {
        Some(failure) => {
            console.error(&failure.message);
            failure.exit()
        }
        None => batch.finish(console),
    }
}
