//! Bars for long work: what is done of it, its rate, and the time left.

use super::console::Console;
use super::inputs::Source;
use super::request::Job;
use crease::trade;
use indicatif::{HumanBytes, HumanDuration, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use std::fmt::Write;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::thread::{self, JoinHandle};
use std::time::Duration;

/// Nobody has to be told about work that is over sooner.
const SHORT: Duration = Duration::from_secs(1);

const STEPS_TEMPLATE: &str = "{spinner} {msg} [{wide_bar}] {pos}/{len}";
const ONE_TEMPLATE: &str = "{spinner} {prefix} {msg}, {elapsed}";
const COUNT_TEMPLATE: &str = "{prefix} [{wide_bar}] {pos}/{len} {msg}, {eta} left";
const TEMPLATE: &str = "{spinner} {msg} [{wide_bar}] {bytes}/{total_bytes}{rate_and_left}";

/// The bar of a run; it does nothing where it would not be seen.
#[derive(Debug)]
pub struct Progress {
    late: LateBar,
}

/// The bar of work on several things of one kind: the frames of an animation, the cases of a catalogue.
#[derive(Debug)]
pub struct CountProgress {
    late: LateBar,
}

/// A bar over the steps of a measurement, stage by stage.
#[derive(Debug)]
pub struct StepProgress {
    late: LateBar,
}

/// A bar that is seen once work has taken a while.
#[derive(Debug)]
struct LateBar {
    bar: ProgressBar,
    /// Shows the bar after a while, unless the sender is gone by then.
    waiting: Option<(Sender<()>, JoinHandle<()>)>,
}

/// The bar's share of one input.
#[derive(Debug)]
pub struct FileProgress<'a> {
    bar: &'a ProgressBar,
    start: u64,
    /// How many bytes the input has, as far as is known.
    bytes: AtomicU64,
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
        if !console.may_show_progress() {
            return Self { late: LateBar::hidden() };
        }
        Self::after(SHORT, jobs.iter().map(size).sum(), ProgressDrawTarget::stderr())
    }

    /// A bar that is shown after a delay.
    fn after(delay: Duration, total: u64, target: ProgressDrawTarget) -> Self {
        let style = ProgressStyle::with_template(TEMPLATE).expect("a right template");
        let style = style.with_key("rate_and_left", rate_and_left);
        Self { late: LateBar::after(delay, total, style, target) }
    }

    /// Begins with an input.
    pub fn begin(&self, job: &Job) -> FileProgress<'_> {
        let bar = &self.late.bar;
        FileProgress { bar, start: bar.position(), bytes: AtomicU64::new(size(job)) }
    }

    /// Prints something while the bar is away.
    pub fn suspended(&self, print: impl FnOnce()) {
        self.late.bar.suspend(print);
    }
}

impl CountProgress {
    /// A bar over so many things, with what is being done and their name; none for one.
    pub fn new(console: &Console, doing: &'static str, things: &'static str, count: u64) -> Self {
        if count < 2 || !console.may_show_progress() {
            return Self { late: LateBar::hidden() };
        }
        Self::after(SHORT, COUNT_TEMPLATE, count, [doing, things], ProgressDrawTarget::stderr())
    }

    /// For one thing, of which nobody knows how much is done: that it goes on, and for how long it has.
    pub fn of_one(console: &Console, doing: &'static str, thing: &'static str) -> Self {
        if !console.may_show_progress() {
            return Self { late: LateBar::hidden() };
        }
        Self::after(SHORT, ONE_TEMPLATE, 1, [doing, thing], ProgressDrawTarget::stderr())
    }

    /// A bar that is shown after a delay.
    fn after(
        delay: Duration,
        template: &str,
        count: u64,
        [doing, things]: [&'static str; 2],
        target: ProgressDrawTarget,
    ) -> Self {
        let style = ProgressStyle::with_template(template).expect("a right template");
        let late = LateBar::after(delay, count, style, target);
        late.bar.set_prefix(doing);
        late.bar.set_message(things);
        Self { late }
    }

    /// One more is done.
    pub fn done(&self) {
        self.late.bar.inc(1);
    }
}

impl StepProgress {
    pub fn new(console: &Console) -> Self {
        if !console.may_show_progress() {
            return Self { late: LateBar::hidden() };
        }
        let style = ProgressStyle::with_template(STEPS_TEMPLATE).expect("a right template");
        Self { late: LateBar::after(SHORT, 1, style, ProgressDrawTarget::stderr()) }
    }

    /// So far it has come.
    pub fn step(&self, step: trade::Progress) {
        self.late.bar.set_message(step.stage);
        self.late.bar.set_length(step.total as u64);
        self.late.bar.set_position(step.done as u64);
    }
}

impl LateBar {
    /// A bar that is never seen.
    fn hidden() -> Self {
        Self { bar: ProgressBar::hidden(), waiting: None }
    }

    fn after(delay: Duration, total: u64, style: ProgressStyle, target: ProgressDrawTarget) -> Self {
        let bar = ProgressBar::with_draw_target(Some(total), ProgressDrawTarget::hidden());
        bar.set_style(style);
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
        let bytes = self.bytes.load(Ordering::Relaxed);
        self.bar.set_position(self.start + (bytes as f64 * thirds / 3.0) as u64);
    }

    /// So many more bytes have come from an input whose length nobody knows.
    pub fn came(&self, bytes: u64) {
        let all = self.bytes.fetch_add(bytes, Ordering::Relaxed) + bytes;
        self.bar.inc_length(bytes);
        self.bar.set_position(self.start + all / 3);
    }
}

impl Drop for FileProgress<'_> {
    fn drop(&mut self) {
        self.bar.set_position(self.start + self.bytes.load(Ordering::Relaxed));
    }
}

impl Drop for LateBar {
    fn drop(&mut self) {
        if let Some((sender, thread)) = self.waiting.take() {
            drop(sender);
            let _ = thread.join();
        }
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

    fn stdin() -> Job {
        Job { source: Source::Stdin, format: None, target: None, to: None }
    }

    #[test]
    fn a_bar_is_seen_once_work_has_taken_a_while() {
        let paper = Paper::default();
        let target = ProgressDrawTarget::term_like(Box::new(paper.clone()));
        let progress = Progress::after(Duration::from_millis(20), 1000, target);
        let file = progress.begin(&stdin());
        file.stage(Stage::Compute);
        let start = Instant::now();
        while !paper.0.lock().unwrap().contains("computing") {
            assert!(start.elapsed() < Duration::from_secs(30), "no bar was drawn");
            thread::sleep(Duration::from_millis(5));
        }
        drop(file);

        let paper = Paper::default();
        let target = ProgressDrawTarget::term_like(Box::new(paper.clone()));
        let progress = Progress::after(Duration::from_secs(600), 1000, target);
        progress.begin(&stdin()).stage(Stage::Compute);
        // Ends without waiting for the delay.
        drop(progress);
        assert_eq!(*paper.0.lock().unwrap(), "");
    }

    #[test]
    fn a_single_thing_has_its_name_and_its_time() {
        let paper = Paper::default();
        let target = ProgressDrawTarget::term_like(Box::new(paper.clone()));
        let delay = Duration::from_millis(20);
        let progress = CountProgress::after(delay, ONE_TEMPLATE, 1, ["measuring", "silhouette"], target);
        let start = Instant::now();
        while !paper.0.lock().unwrap().contains("measuring silhouette, 0s") {
            assert!(start.elapsed() < Duration::from_secs(30), "{}", paper.0.lock().unwrap());
            thread::sleep(Duration::from_millis(5));
        }
        drop(progress);
    }

    #[test]
    fn what_comes_from_standard_input_counts() {
        let progress = Progress::after(Duration::from_secs(600), 0, ProgressDrawTarget::hidden());
        let file = progress.begin(&stdin());
        file.stage(Stage::Read);
        file.came(600);
        file.came(300);
        let bar = &progress.late.bar;
        assert_eq!((bar.length(), bar.position()), (Some(900), 300));
        file.stage(Stage::Write);
        assert_eq!(bar.position(), 600);
        drop(file);
        assert_eq!(bar.position(), 900);
    }
}
