//! The journal of a batch in use: which inputs need no work, what was done, and further tries.

use super::batch::BatchArgs;
use super::console::{Console, escaped};
use super::failure::Failure;
use super::input::{Input, Source};
use super::journal::{Entry, Journal, Key, Status, hash_of, hash_of_bytes};
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, SystemTime, UNIX_EPOCH};

/// The journal, if there is one.
pub struct Ledger {
    journal: Option<Mutex<Journal>>,
    retries: u8,
    start: SystemTime,
}

/// What identifies a piece of work.
pub struct Work<'a> {
    pub verb: &'static str,
    pub input: &'a Input,
    pub output: Option<String>,
    /// All options that affect the result, as text.
    pub options: String,
}

impl Work<'_> {
    fn key(&self) -> Key {
        (self.verb.into(), self.input.source.name(), self.output.clone())
    }
}

/// What came of a piece of work.
#[derive(Default)]
pub struct Outcome<'a> {
    pub bytes: u64,
    pub error: Option<&'a Failure>,
    /// The files that were read, and those that were written.
    pub read: Vec<PathBuf>,
    pub written: Vec<PathBuf>,
    /// The bytes that will replace the input.
    pub replacement: Option<&'a [u8]>,
    pub faults: u64,
    pub findings: BTreeMap<String, u64>,
    pub verdict: Option<String>,
    pub seconds: f64,
}

impl Ledger {
    /// Opens the journal that options name, unless nothing is to be written.
    ///
    /// # Errors
    /// If it cannot be read or written.
    pub fn open(batch: &BatchArgs, dry_run: bool, sync: bool) -> Result<Self, Failure> {
        let path = batch.journal.as_deref().filter(|_| !dry_run);
        let journal = path.map(|path| Journal::open(path, sync)).transpose()?;
        Ok(Self { journal: journal.map(Mutex::new), retries: batch.retries, start: SystemTime::now() })
    }

    /// Reports lines of the journal that are no entries.
    pub fn note(&self, console: &Console) {
        let bad = self.journal.as_ref().map(|journal| journal.lock().map_or(0, |journal| journal.bad));
        if let Some(bad @ 1..) = bad {
            console.note(&format!("incomplete lines of the journal are ignored: {bad}"));
        }
    }

    /// The entry of an earlier run that has done this, if nothing has changed since.
    pub fn done_before(&self, work: &Work) -> Option<Entry> {
        let entry = {
            let journal = self.journal.as_ref()?.lock().unwrap_or_else(PoisonError::into_inner);
            journal.entry(&work.key())?.clone()
        };
        entry.is_valid(&hash_of_bytes(work.options.as_bytes())).then_some(entry)
    }

    /// Does something, and repeats it if it failed for a reason that may pass. The wait doubles each time. Standard input can be read
    /// only once.
    ///
    /// # Errors
    /// Those of the last try.
    pub fn retried<T>(
        &self,
        source: &Source,
        mut work: impl FnMut() -> Result<T, Failure>,
    ) -> Result<T, Failure> {
        let mut done = work();
        for number in 0..if *source == Source::Standard { 0 } else { self.retries } {
            match &done {
                Err(failure) if failure.may_pass() => {
                    std::thread::sleep(Duration::from_millis(100 << number));
                    done = work();
                }
                _ => break,
            }
        }
        done
    }

    /// Adds what was done to the journal.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn record(&self, work: &Work<'_>, outcome: Outcome<'_>) -> Result<(), Failure> {
        let Some(journal) = &self.journal else { return Ok(()) };
        let hashed = |path: &PathBuf| Some((path.to_str()?.to_owned(), hash_of(path).ok()?));
        let hashes = |paths: &[PathBuf]| paths.iter().map(hashed).collect::<Option<BTreeMap<_, _>>>();
        let is_new = |path: &PathBuf| {
            let time = path.metadata().and_then(|metadata| metadata.modified());
            time.is_ok_and(|time| time >= self.start) && !outcome.written.contains(path)
        };
        let (verb, input, output) = work.key();
        let written = match outcome.replacement {
            Some(bytes) => Some([(input.clone(), hash_of_bytes(bytes))].into()),
            None if outcome.error.is_some() => Some(BTreeMap::new()),
            None => hashes(&outcome.written),
        };
        let read = hashes(&outcome.read).filter(|_| written.is_some() && !outcome.read.iter().any(is_new));
        let ended = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
        let entry = Entry {
            input,
            verb,
            line_options: work.input.options.clone(),
            is_bare_line: work.input.line.is_some() && work.input.output.is_none(),
            bytes: outcome.bytes,
            output,
            status: if outcome.error.is_some() { Status::Failed } else { Status::Done },
            crease: env!("CARGO_PKG_VERSION").into(),
            options: hash_of_bytes(work.options.as_bytes()),
            // Without hashes the next run repeats the work: files that changed meanwhile, and those that have no content to compare.
            read: read.unwrap_or_default(),
            written: written.unwrap_or_default(),
            faults: outcome.faults,
            findings: outcome.findings,
            verdict: outcome.verdict,
            seconds: outcome.seconds,
            ended: ended.as_millis() as u64,
            error: outcome.error.map(|failure| failure.message.clone()),
        };
        journal.lock().unwrap_or_else(PoisonError::into_inner).add(&entry)
    }
}

/// The line of the report on an input that an earlier run has done.
pub fn skipped(path: &str) -> String {
    format!("{}: done before, unchanged\n", escaped(path))
}
