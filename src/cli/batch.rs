//! All inputs of a run, one after the other. A bad one does not stop the others.

use super::Exit;
use super::console::{Console, Verbosity, escaped};
use super::normals::{self, Failure};
use super::output::Store;
use super::progress::Progress;
use super::report::Report;
use super::request::{Job, Request};
use super::{notes, text};
use std::panic::{self, AssertUnwindSafe, PanicHookInfo};
use std::sync::Mutex;
use std::time::Instant;

/// Carries out a request, reports on every input and tells how it went.
pub fn run(request: &Request, console: &Console) -> Exit {
    let progress = Progress::new(console, &request.jobs);
    let mut store = Store::new(request.sync, request.dry_run);
    let mut failed = 0;
    let mut exit = Exit::Done;
    for job in &request.jobs {
        let mut report = Report::new(job, request);
        let start = Instant::now();
        let file = progress.begin(job);
        let result = guarded(|| normals::run(job, request, &mut store, &file, &mut report));
        drop(file);
        report.seconds.total = start.elapsed().as_secs_f64();
        if let Err(failure) = result {
            failed += 1;
            exit = exit_of(&failure);
            report.fail(&failure);
        }
        progress.suspended(|| tell(&report, job, request, console));
    }
    drop(progress);
    if request.jobs.len() > 1 {
        if !console.json && console.verbosity > Verbosity::Quiet {
            console.report(&summary(request.jobs.len(), failed));
        }
        exit = if failed > 0 { Exit::PartOfBatch } else { Exit::Done };
    }
    match exit {
        Exit::Done if !console.has_reported() => Exit::OutputFailed,
        exit => exit,
    }
}

/// The line that ends the report on a batch.
fn summary(inputs: usize, failed: usize) -> String {
    match failed {
        0 => format!("{} done\n", text::count(inputs, "file")),
        _ => format!("{} of {} done, {failed} failed\n", inputs - failed, text::count(inputs, "file")),
    }
}

/// What a failure means to the caller of the program.
pub fn exit_of(failure: &Failure) -> Exit {
    match failure {
        Failure::Read(_) | Failure::Draw(_) | Failure::Internal(_) => Exit::BadInput,
        Failure::Usage(_) => Exit::Usage,
        Failure::Write(_) => Exit::OutputFailed,
    }
}

fn tell(report: &Report, job: &Job, request: &Request, console: &Console) {
    let name = escaped(&report.input.path);
    if let Some(error) = &report.head.error {
        // Names of outputs stand in the message itself.
        console.error(&format!("{name}: {}", error.message));
    }
    if console.json {
        console.report(&report.to_json());
        return;
    }
    if console.verbosity == Verbosity::Quiet {
        return;
    }
    let brief = request.jobs.len() > 1 && console.verbosity < Verbosity::Verbose;
    notes::print(&report.input.path, &report.notes, brief, console);
    if report.head.error.is_none() {
        console.report(&if brief {
            text::line(report, console.report_style())
        } else {
            text::block(report, job, request, console)
        });
    }
}

/// Runs one job and turns a panic, which would be a fault of this program or of a library under it, into a
/// failure of that job alone.
pub fn guarded<T>(work: impl FnOnce() -> Result<T, Failure>) -> Result<T, Failure> {
    static MESSAGE: Mutex<Option<String>> = Mutex::new(None);
    let remember = |info: &PanicHookInfo<'_>| {
        if let Ok(mut message) = MESSAGE.lock() {
            message.get_or_insert_with(|| info.to_string());
        }
    };
    let usual = panic::take_hook();
    panic::set_hook(Box::new(remember));
    let result = panic::catch_unwind(AssertUnwindSafe(work));
    panic::set_hook(usual);
    let message = MESSAGE.lock().ok().and_then(|mut message| message.take());
    result.unwrap_or_else(|_| Err(Failure::Internal(message.unwrap_or_else(|| "panicked".into()))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_fails_its_own_job_only() {
        let failure = guarded::<()>(|| panic!("corner {} is missing", 7)).unwrap_err();
        let Failure::Internal(message) = failure else { panic!("{failure:?}") };
        assert!(message.contains("corner 7 is missing") && message.contains("batch.rs"), "{message}");
        assert!(guarded(|| Ok(())).is_ok());
        let failure = guarded(|| rayon::join(|| panic!("in a thread"), || Ok(())).1).unwrap_err();
        assert!(matches!(failure, Failure::Internal(message) if message.contains("in a thread")));
    }
}
