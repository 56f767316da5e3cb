//! Why a run failed, and the exit code for that.

use super::console::{Console, HELP};
use crease::io::{Place, Problem, ReadError};
use crease::report::ReportError;
use serde::{Serialize, Serializer};
use std::io::{self, ErrorKind};
use std::panic::{self, AssertUnwindSafe, PanicHookInfo};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, Once, PoisonError};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Exit {
    Done = 0,
    Findings = 1,
    Usage = 2,
    BadInput = 3,
    OutputFailed = 4,
    PartOfBatch = 5,
}

/// The member `error` of reports.
#[derive(Clone, Debug, Serialize)]
pub struct Failure {
    pub kind: FailureKind,
    /// What was found and, after [`HELP`], the next step.
    #[serde(serialize_with = "in_one_line")]
    pub message: String,
    #[serde(flatten)]
    pub read: Option<ReadError>,
    /// C's number for why the operating system refused to store an output, if it is a usual one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub errno: Option<i32>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum FailureKind {
    /// The options do not fit this input.
    Usage,
    /// The input cannot be read, or it holds nothing that can be drawn or measured.
    Input,
    Output,
    /// A fault of this program.
    Internal,
}

impl Failure {
    fn new(kind: FailureKind, message: impl ToString) -> Self {
        Self { kind, message: message.to_string(), read: None, errno: None }
    }

    pub fn usage(message: impl ToString) -> Self {
        Self::new(FailureKind::Usage, message)
    }

    pub fn input(message: impl ToString) -> Self {
        Self::new(FailureKind::Input, message)
    }

    /// An error of the library about an input. Its text has the next step after the first semicolon.
    pub fn advised(error: impl ToString) -> Self {
        Self::input(error.to_string().replacen("; ", HELP, 1))
    }

    pub fn output(message: impl ToString) -> Self {
        Self::new(FailureKind::Output, message)
    }

    /// A file that cannot be read, with its name, for command lines that name several.
    pub fn read(path: &str, error: ReadError) -> Self {
        let found = match error.place {
            Place::File => format!("{path}: {}", error.found),
            _ => format!("in {path}: {}", error.found),
        };
        ReadError { found, ..error }.into()
    }

    /// Whether another try may succeed: the input or the output could not be reached.
    pub fn may_pass(&self) -> bool {
        self.kind == FailureKind::Output
            || self
                .read
                .as_ref()
                .is_some_and(|error| matches!(error.problem, Problem::Io | Problem::Companion))
    }

    pub fn exit(&self) -> Exit {
        match self.kind {
            FailureKind::Usage => Exit::Usage,
            FailureKind::Input | FailureKind::Internal => Exit::BadInput,
            FailureKind::Output => Exit::OutputFailed,
        }
    }
}

impl From<ReadError> for Failure {
    fn from(error: ReadError) -> Self {
        let message = match &*error.advice {
            "" => error.to_string(),
            advice => format!("{}{HELP}{advice}", ReadError { advice: String::new(), ..error.clone() }),
        };
        Self { read: Some(error), ..Self::input(message) }
    }
}

fn in_one_line<S: Serializer>(message: &str, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(&message.replace(HELP, "; "))
}

impl From<anyhow::Error> for Failure {
    /// An output that failed: in words of this program, without the name of a temporary file.
    fn from(error: anyhow::Error) -> Self {
        let Some(cause) = error.chain().find_map(|cause| cause.downcast_ref::<io::Error>()) else {
            return Self::output(format!("{error:#}"));
        };
        let contexts = error.chain().take_while(|cause| !cause.is::<io::Error>());
        let mut parts: Vec<String> = contexts.map(ToString::to_string).collect();
        let (reason, advice) = io_reason(cause);
        parts.push(reason);
        let message = format!("{}{HELP}{advice}", parts.join(": "));
        Self { errno: errno(cause.kind()), ..Self::output(message) }
    }
}

/// Why the operating system refused, and the next step.
pub fn io_reason(error: &io::Error) -> (String, &'static str) {
    let (reason, advice) = match error.kind() {
        ErrorKind::NotFound => ("there is no such file or folder", "check the path"),
        ErrorKind::PermissionDenied => ("no permission", "check the permissions"),
        ErrorKind::StorageFull => ("the disk is full", "make room, or choose another disk"),
        ErrorKind::ReadOnlyFilesystem => ("the file system is read-only", "choose another folder"),
        _ => {
            let text = error.to_string();
            return (text.split(" (os error ").next().unwrap_or_default().to_owned(), "check the path");
        }
    };
    (reason.to_owned(), advice)
}

/// ENOENT, EACCES, ENOSPC and EROFS, the same on every system.
fn errno(kind: ErrorKind) -> Option<i32> {
    Some(match kind {
        ErrorKind::NotFound => 2,
        ErrorKind::PermissionDenied => 13,
        ErrorKind::StorageFull => 28,
        ErrorKind::ReadOnlyFilesystem => 30,
        _ => return None,
    })
}

impl From<ReportError> for Failure {
    fn from(error: ReportError) -> Self {
        Self::output(error)
    }
}

/// The exit code of a verb: a report that could not be printed is a failed output.
pub fn exit_code(result: Result<Exit, Failure>, console: &Console) -> Exit {
    match result {
        Err(failure) => failure.exit(),
        Ok(_) if console.failed.get() => Exit::OutputFailed,
        Ok(exit) => exit,
    }
}

/// Runs one job. A panic, which would be a fault of this program or of a library, fails that job only. Several threads may run
/// jobs at the same time.
pub fn guarded<T>(work: impl FnOnce() -> Result<T, Failure>) -> Result<T, Failure> {
    static JOBS: AtomicUsize = AtomicUsize::new(0);
    static MESSAGES: Mutex<Vec<String>> = Mutex::new(Vec::new());
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let usual = panic::take_hook();
        panic::set_hook(Box::new(move |info: &PanicHookInfo<'_>| match JOBS.load(Ordering::SeqCst) {
            0 => usual(info),
            _ => MESSAGES.lock().unwrap_or_else(PoisonError::into_inner).push(info.to_string()),
        }));
    });
    JOBS.fetch_add(1, Ordering::SeqCst);
    let result = panic::catch_unwind(AssertUnwindSafe(work));
    JOBS.fetch_sub(1, Ordering::SeqCst);
    result.unwrap_or_else(|payload| {
        let text = payload.downcast_ref::<String>().map(String::as_str);
        let text = text.or_else(|| payload.downcast_ref::<&str>().copied()).unwrap_or("panicked");
        // The message of the hook has the place too.
        let mut messages = MESSAGES.lock().unwrap_or_else(PoisonError::into_inner);
        let own = messages.iter().position(|message| message.contains(text));
        let message = own.map_or_else(|| text.to_owned(), |own| messages.swap_remove(own));
        let message = format!("internal error: {message}{HELP}please report it");
        Err(Failure::new(FailureKind::Internal, message))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_fails_its_own_job_only() {
        let failure = guarded::<()>(|| panic!("corner {} is missing", 7)).unwrap_err();
        assert_eq!(failure.kind, FailureKind::Internal);
        let message = failure.message;
        assert!(message.contains("corner 7 is missing") && message.contains("failure.rs"), "{message}");
        assert!(guarded(|| Ok(())).is_ok());
        let failure = guarded(|| rayon::join(|| panic!("in a thread"), || Ok(())).1).unwrap_err();
        assert!(failure.kind == FailureKind::Internal && failure.message.contains("in a thread"));
    }
    #[test]
    fn an_output_that_failed_has_the_number_of_its_reason() {
        let of = |kind| Failure::from(anyhow::Error::from(io::Error::from(kind)).context("out.glb"));
        let json = serde_json::to_value(of(ErrorKind::StorageFull)).unwrap();
        assert_eq!(json["errno"], 28);
        assert_eq!(json["message"], "out.glb: the disk is full; make room, or choose another disk");
        let other = serde_json::to_value(of(ErrorKind::BrokenPipe)).unwrap();
        assert!(other["kind"] == "output" && other.get("errno").is_none());
    }
}
