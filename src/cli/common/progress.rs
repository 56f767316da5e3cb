//! Bars for long work: what is done of it, its rate, and the time left.

use super::console::Console;
use super::input::Source;
use crease::io::{Format, Loaded, ReadError, ReadOptions};
use crease::plan;
use crease::trade;
use indicatif::{HumanBytes, HumanDuration, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use std::fmt::Write;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::thread::{self, JoinHandle};
use std::time::Duration;

/// Bars of shorter work are not shown.
const SHORT: Duration = Duration::from_secs(1);

const STEPS: &str = "{spinner} {msg} [{wide_bar}] {pos}/{len}";
const ONE: &str = "{spinner} {prefix} {msg}, {elapsed}";
const COUNT: &str = "{prefix} [{wide_bar}] {pos}/{len} {msg}, {eta} left";
const BYTES: &str = "{spinner} {msg} [{wide_bar}] {bytes}/{total_bytes}{rate_and_left}";

/// A bar that is shown after a while; hidden if the terminal would not show it.
#[derive(Debug)]
pub struct Progress {
    bar: ProgressBar,
    /// Shows the bar after a while, unless the sender is gone by then.
    waiting: Option<(Sender<()>, JoinHandle<()>)>,
}

#[derive(Debug)]
pub struct FileProgress<'a> {
    bar: &'a ProgressBar,
    /// How far this input has moved the bar.
    shown: AtomicU64,
    /// How many bytes the input has, as far as is known.
    bytes: AtomicU64,
}

/// What is being done with an input. The bar gives each stage the same share.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    Read,
    Compute,
    Write,
}

impl Progress {
    pub fn of_inputs<'a>(console: &Console, inputs: impl IntoIterator<Item = &'a Source>) -> Self {
        let bytes = inputs.into_iter().filter_map(Source::length).sum();
        Self::new(console, BYTES, bytes)
    }

    /// A bar over a number of items of one kind, with the activity and the name of the items; none for one item.
    pub fn of_count(console: &Console, doing: &'static str, things: &'static str, count: u64) -> Self {
        if count < 2 { Self::hidden() } else { Self::new(console, COUNT, count).with_words(doing, things) }
    }

    /// The share done of a search, from 0 to 1, and its best plan so far.
    pub fn plan(&self, step: plan::Progress) {
        self.bar.set_length(1000);
        self.bar.set_position((1000.0 * step.share) as u64);
        self.bar.set_message(format!("planning, best {:.0} %", 100.0 * step.best));
    }

    /// For one item, whose progress is not known: a spinner and the elapsed time.
    pub fn of_one(console: &Console, doing: &'static str, thing: &'static str) -> Self {
        Self::new(console, ONE, 1).with_words(doing, thing)
    }

    /// A bar over the steps of a measurement or of a search, which says what is done.
    pub fn of_steps(console: &Console) -> Self {
        Self::new(console, STEPS, 1)
    }

    fn new(console: &Console, template: &str, total: u64) -> Self {
        match console.may_show_progress() {
            true => Self::after(SHORT, template, total, ProgressDrawTarget::stderr()),
            false => Self::hidden(),
        }
    }

    pub fn hidden() -> Self {
        Self { bar: ProgressBar::hidden(), waiting: None }
    }

    fn after(delay: Duration, template: &str, total: u64, target: ProgressDrawTarget) -> Self {
        let bar = ProgressBar::with_draw_target(Some(total), ProgressDrawTarget::hidden());
        let style = ProgressStyle::with_template(template).expect("a valid template");
        bar.set_style(style.with_key("rate_and_left", rate_and_left));
        let (sender, receiver) = mpsc::channel::<()>();
        let shown = bar.clone();
        let thread = thread::spawn(move || {
            if receiver.recv_timeout(delay) == Err(RecvTimeoutError::Timeout) {
                shown.set_draw_target(target);
                shown.enable_steady_tick(Duration::from_millis(100));
            }
        });
        Self { bar, waiting: Some((sender, thread)) }
    }

    fn with_words(self, doing: &'static str, things: &'static str) -> Self {
        self.bar.set_prefix(doing);
        self.bar.set_message(things);
        self
    }

    pub fn begin(&self, source: &Source) -> FileProgress<'_> {
        let bytes = source.length().unwrap_or_default();
        FileProgress { bar: &self.bar, shown: AtomicU64::new(0), bytes: AtomicU64::new(bytes) }
    }

    /// Prints something while the bar is away.
    pub fn suspended(&self, print: impl FnOnce()) {
        self.bar.suspend(print);
    }

    pub fn done(&self) {
        self.bar.inc(1);
    }

    pub fn step(&self, step: trade::Progress) {
        self.bar.set_message(step.stage);
        self.bar.set_length(step.total as u64);
        self.bar.set_position(step.done as u64);
    }
}

impl FileProgress<'_> {
    pub fn stage(&self, stage: Stage) {
        self.bar.set_message(match stage {
            Stage::Read => "reading",
            Stage::Compute => "computing",
            Stage::Write => "writing",
        });
        self.within(stage, 0, 1);
    }

    pub fn within(&self, stage: Stage, done: usize, all: usize) {
        let thirds = stage as u64 as f64 + done as f64 / all.max(1) as f64;
        let bytes = self.bytes.load(Ordering::Relaxed);
        self.advance((bytes as f64 * thirds / 3.0) as u64);
    }

    /// Moves the bar to this number of bytes of the input. Other inputs move it at the same time.
    fn advance(&self, bytes: u64) {
        let before = self.shown.fetch_max(bytes, Ordering::Relaxed);
        self.bar.inc(bytes.saturating_sub(before));
    }

    /// Reads an input; `bytes` becomes its length.
    pub fn read(
        &self,
        source: &Source,
        format: Option<Format>,
        options: &ReadOptions,
        bytes: &mut Option<u64>,
    ) -> Result<Loaded, ReadError> {
        source.read(format, options, |more| {
            *bytes = Some(bytes.unwrap_or_default() + more);
            self.arrived(more);
        })
    }

    /// Adds bytes that have arrived from standard input, whose length is not known.
    fn arrived(&self, bytes: u64) {
        let all = self.bytes.fetch_add(bytes, Ordering::Relaxed) + bytes;
        self.bar.inc_length(bytes);
        self.advance(all / 3);
    }
}

impl Drop for FileProgress<'_> {
    fn drop(&mut self) {
        self.advance(self.bytes.load(Ordering::Relaxed));
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some((sender, thread)) = self.waiting.take() {
            drop(sender);
            let _ = thread.join();
        }
        self.bar.finish_and_clear();
    }
}

/// The rate and the time left, once there is a rate.
fn rate_and_left(state: &ProgressState, out: &mut dyn Write) {
    if state.pos() > 0 {
        let rate = HumanBytes(state.per_sec() as u64);
        let _ = write!(out, " {rate}/s, {:#} left", HumanDuration(state.eta()));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use indicatif::TermLike;
    use std::io;
    use std::sync::{Arc, Mutex};
    use std::time::Instant;

    /// A terminal that keeps what is written to it.
    #[derive(Clone, Debug, Default)]
    struct Paper(Arc<Mutex<String>>);

    impl TermLike for Paper {
        fn width(&self) -> u16 {
            100
        }
        fn move_cursor_up(&self, _: usize) -> io::Result<()> {
            Ok(())
        }
        fn move_cursor_down(&self, _: usize) -> io::Result<()> {
            Ok(())
        }
        fn move_cursor_right(&self, _: usize) -> io::Result<()> {
            Ok(())
        }
        fn move_cursor_left(&self, _: usize) -> io::Result<()> {
            Ok(())
        }
        fn write_line(&self, text: &str) -> io::Result<()> {
            self.write_str(text)
        }
        fn write_str(&self, text: &str) -> io::Result<()> {
            self.0.lock().unwrap().push_str(text);
            Ok(())
        }
        fn clear_line(&self) -> io::Result<()> {
            Ok(())
        }
        fn flush(&self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn a_bar_is_seen_once_work_has_taken_a_while() {
        let paper = Paper::default();
        let target = ProgressDrawTarget::term_like(Box::new(paper.clone()));
        let progress = Progress::after(Duration::from_millis(20), BYTES, 1000, target);
        let file = progress.begin(&Source::Standard);
        file.stage(Stage::Compute);
        let start = Instant::now();
        while !paper.0.lock().unwrap().contains("computing") {
            assert!(start.elapsed() < Duration::from_secs(30), "no bar was drawn");
            thread::sleep(Duration::from_millis(5));
        }
        drop(file);

        let paper = Paper::default();
        let target = ProgressDrawTarget::term_like(Box::new(paper.clone()));
        let progress = Progress::after(Duration::from_secs(600), BYTES, 1000, target);
        progress.begin(&Source::Standard).stage(Stage::Compute);
        // Ends without waiting for the delay.
        drop(progress);
        assert_eq!(*paper.0.lock().unwrap(), "");
    }

    #[test]
    fn a_single_thing_has_its_name_and_its_time() {
        let paper = Paper::default();
        let target = ProgressDrawTarget::term_like(Box::new(paper.clone()));
        let delay = Duration::from_millis(20);
        let progress = Progress::after(delay, ONE, 1, target).with_words("measuring", "silhouette");
        let start = Instant::now();
        while !paper.0.lock().unwrap().contains("measuring silhouette, 0s") {
            assert!(start.elapsed() < Duration::from_secs(30), "{}", paper.0.lock().unwrap());
            thread::sleep(Duration::from_millis(5));
        }
        drop(progress);
    }

    #[test]
    fn what_comes_from_standard_input_counts() {
        let progress = Progress::after(Duration::from_secs(600), BYTES, 0, ProgressDrawTarget::hidden());
        let file = progress.begin(&Source::Standard);
        file.stage(Stage::Read);
        file.arrived(600);
        file.arrived(300);
        let bar = &progress.bar;
        assert_eq!((bar.length(), bar.position()), (Some(900), 300));
        file.stage(Stage::Write);
        assert_eq!(bar.position(), 600);
        drop(file);
        assert_eq!(bar.position(), 900);
    }
}
