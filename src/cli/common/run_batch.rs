//! The loop over the inputs of a verb: several at a time, with progress, a journal and an exit code.

use super::batch::{BatchArgs, memory_need};
use super::console::Console;
use super::failure::{Batch, Exit, Failure};
use super::input::Source;
use super::jobs::Turn;
use super::ledger::Ledger;
use super::progress::{FileProgress, Progress};
use crease::io::Format;
use std::ops::ControlFlow;

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
