//! A bar for long work: bytes of input done, their rate, and the time left.

use super::console::Console;
use super::inputs::Source;
use super::request::Job;
use indicatif::{HumanBytes, HumanDuration, ProgressBar, ProgressState, ProgressStyle};
use std::fmt::Write;
use std::time::Duration;

/// Below this many bytes in this many files nobody has to wait.
const SHORT_BYTES: u64 = 16 << 20;
const SHORT_FILES: usize = 16;

const TEMPLATE: &str = "{spinner} {msg} [{wide_bar}] {bytes}/{total_bytes}{rate_and_left}";

/// The bar of a run; it does nothing where it would not be seen.
#[derive(Debug)]
pub struct Progress {
    bar: ProgressBar,
}

/// The bar's share of one input.
#[derive(Debug)]
pub struct FileProgress<'a> {
    bar: &'a ProgressBar,
    start: u64,
    bytes: u64,
}

/// What is being done with an input. Each stage is taken to last as long as any other; that is near enough for
/// a bar.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    Read,
    Compute,
    Write,
}

impl Progress {
    pub fn new(console: &Console, jobs: &[Job]) -> Self {
        let total: u64 = jobs.iter().map(size).sum();
        if !console.may_show_progress() || (total < SHORT_BYTES && jobs.len() < SHORT_FILES) {
            return Self { bar: ProgressBar::hidden() };
        }
        let bar = ProgressBar::new(total);
        let style = ProgressStyle::with_template(TEMPLATE).expect("a right template");
        bar.set_style(style.with_key("rate_and_left", rate_and_left));
        bar.enable_steady_tick(Duration::from_millis(100));
        Self { bar }
    }

    /// Begins with an input.
    pub fn begin(&self, job: &Job) -> FileProgress<'_> {
        FileProgress { bar: &self.bar, start: self.bar.position(), bytes: size(job) }
    }

    /// Prints something while the bar is away.
    pub fn suspended(&self, print: impl FnOnce()) {
        self.bar.suspend(print);
    }
}

impl FileProgress<'_> {
    /// Begins with a stage.
    pub fn stage(&self, stage: Stage) {
        self.bar.set_message(match stage {
            Stage::Read => "reading",
            Stage::Compute => "computing",
            Stage::Write => "writing",
        });
        self.within(stage, 0, 1);
    }

    /// So much of a stage is done.
    pub fn within(&self, stage: Stage, done: usize, all: usize) {
        let thirds = stage as u64 as f64 + done as f64 / all.max(1) as f64;
        self.bar.set_position(self.start + (self.bytes as f64 * thirds / 3.0) as u64);
    }
}

impl Drop for FileProgress<'_> {
    fn drop(&mut self) {
        self.bar.set_position(self.start + self.bytes);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

/// Before anything is done there is no rate to tell the rest from.
fn rate_and_left(state: &ProgressState, out: &mut dyn Write) {
    if state.pos() > 0 {
        let rate = HumanBytes(state.per_sec() as u64);
        let _ = write!(out, " {rate}/s, {:#} left", HumanDuration(state.eta()));
    }
}

fn size(job: &Job) -> u64 {
    match &job.source {
        Source::Stdin => 0,
        Source::File(path) => path.metadata().map_or(0, |metadata| metadata.len()),
    }
}
