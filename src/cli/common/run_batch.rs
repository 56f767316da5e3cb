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
    skipped: usize,
    failed: Vec<(String, Failure)>,
    /// The exit code if no input fails.
    pub exit: Exit,
}

impl Batch {
    pub fn new(inputs: usize) -> Self {
        Self { inputs, skipped: 0, failed: Vec::new(), exit: Exit::Done }
    }

    /// Counts an input by the first members of its report.
    pub fn count(&mut self, path: &str, head: &Head) {
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
        match failed {
            0 => format!("{files} done{before}\n"),
            _ => format!(
                "{} of {files} done{before}, {failed} failed:\n{}",
                self.inputs - failed,
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

/// A result, and whether the journal could be written.
pub type Recorded<R> = (R, Result<(), Failure>);

/// Does the work of all items. `source` is an item's input with its format, if that is known. `finish` counts and prints a result;
/// the results come in the order of the items. The batch stops if its journal cannot be written.
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
        work(item, &Shared { ledger, turn, progress: &progress })
    };
    args.jobs().run(items, &needs, work, |item, (result, recorded)| {
        progress.suspended(|| finish(item, result, &mut batch));
        match recorded {
            Ok(()) => ControlFlow::Continue(()),
            Err(failure) => {
                stopped = Some(failure);
                ControlFlow::Break(())
            }
        }
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
