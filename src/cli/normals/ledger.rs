//! The journal of a batch: which files need no work, and what was done.

use super::json::Report;
use super::request::{Job, Request};
use crate::cli::common::console::Console;
use crate::cli::common::failure::Failure;
use crate::cli::common::journal::{Entry, Journal, Status, hash_of, hash_of_text};
use crate::cli::common::output::{Store, Target};
use crease::io::CompanionLog;
use crease::pipeline::Task;
use std::collections::BTreeMap;
use std::path::Path;
use std::time::Duration;

/// The journal, if there is one, with what its entries need.
pub struct Ledger {
    journal: Option<Journal>,
    /// All options that affect outputs, as text.
    options: String,
    companions: CompanionLog,
    retries: u8,
}

impl Ledger {
    pub fn open(request: &Request) -> Result<Self, Failure> {
        let (args, read) = (&request.args, &request.read);
        let path = args.batch.journal.as_deref().filter(|_| !args.output.dry_run);
        let mesh = (args.mesh.up, args.mesh.scale, request.merge_distance);
        // Edges are counted for reports only.
        let task = Task { edge_counts: false, ..request.task.clone() };
        let reading = (&read.root, read.non_finite, &read.allowed_extensions);
        Ok(Self {
            journal: path.map(|path| Journal::open(path, args.output.sync)).transpose()?,
            options: format!("{:?}", (&task, &request.write, mesh, reading)),
            companions: read.companions.clone(),
            retries: args.batch.retries,
        })
    }

    /// Reports lines of the journal that are no entries.
    pub fn note(&self, console: &Console) {
        if let Some(bad @ 1..) = self.journal.as_ref().map(|journal| journal.bad) {
            console.note(&format!("the journal has {bad} incomplete lines, which are ignored"));
        }
    }

    fn options_of(&self, job: &Job) -> String {
        hash_of_text(&format!("{} {:?} {:?}", self.options, job.format, job.to))
    }

    /// Whether an earlier run has done this, and nothing has changed since.
    pub fn has(&self, job: &Job) -> bool {
        let output = job.target.as_ref().map(Target::name);
        let is_done =
            |journal: &Journal| journal.has(&job.source.name(), output.as_deref(), &self.options_of(job));
        self.journal.as_ref().is_some_and(is_done)
    }

    /// Does something, again if it failed for a reason that may pass. The wait doubles each time.
    pub fn retried(&self, mut work: impl FnMut() -> Result<(), Failure>) -> Result<(), Failure> {
        let mut done = work();
        for number in 0..self.retries {
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
    pub fn record(&mut self, job: &Job, report: &Report, store: &Store) -> Result<(), Failure> {
        let companions = self.companions.take();
        let options = self.options_of(job);
        let Some(journal) = &mut self.journal else { return Ok(()) };
        let error = report.head.error.as_ref().map(|failure| failure.message.clone());
        let hashed = |path: &Path| Some((path.to_str()?.to_owned(), hash_of(path).ok()?));
        let stored = store.last.iter().filter(|_| error.is_none());
        let written: BTreeMap<_, _> = stored.filter_map(|path| hashed(path)).collect();
        let read = job.source.path().into_iter().chain(companions.iter().map(|path| &**path));
        journal.add(&Entry {
            input: job.source.name(),
            bytes: report.input.bytes.unwrap_or_default(),
            output: job.target.as_ref().map(Target::name),
            status: if error.is_some() { Status::Failed } else { Status::Done },
            crease: env!("CARGO_PKG_VERSION").into(),
            options,
            read: read.filter_map(hashed).collect(),
            written,
            faults: report
                .parts
                .iter()
                .map(|part| part.outcome.faults.corners.values().sum::<usize>() as u64)
                .sum(),
            seconds: report.seconds.total,
            error,
        })
    }
}
