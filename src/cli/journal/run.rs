//! Runs `crease journal`.

use super::args::{Action, JournalArgs};
use crate::cli::common::console::Console;
use crate::cli::common::failure::{Exit, Failure, exit_code};
use crate::cli::common::journal::{Entry, Status, entries};
use crate::cli::common::numbers::{count, size};
use crate::cli::common::options::Color;
use crate::cli::usage::refused;
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet, HashMap};

pub fn main(args: &JournalArgs, color: Color) -> Exit {
    let console = Console::new(&args.run, color, None);
    let (found, incomplete) = match all(args) {
        Ok(found) => found,
        Err(failure) => return refused("journal", &failure, &console),
    };
    match args.action {
        Action::Summary => {
            let summary = Summary::new(&found, incomplete);
            console.print(&summary, || summary.text());
        }
        Action::Failed => {
            let failed = found.iter().filter(|entry| entry.status == Status::Failed);
            failed.for_each(|entry| {
                let line = serde_json::to_string(&Line::new(entry)).expect("string keys");
                console.report(&format!("{line}\n"));
            });
        }
        Action::Merge => {
            let lines = found.iter().map(|entry| serde_json::to_string(entry).expect("string keys") + "\n");
            console.report(&lines.collect::<String>());
        }
    }
    exit_code(Ok(Exit::Done), &console)
}

/// A line of a manifest.
#[derive(Serialize)]
struct Line<'a> {
    input: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    output: Option<&'a str>,
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    options: &'a [String],
}

impl<'a> Line<'a> {
    /// The line that asks for an entry again.
    fn new(Entry { input, output, line_options, is_bare_line, .. }: &'a Entry) -> Self {
        Self { input, output: output.as_deref().filter(|_| !is_bare_line), options: line_options }
    }
}

/// The entries of all journals: the one that ended last for each piece of work, in the order of their lines.
fn all(args: &JournalArgs) -> Result<(Vec<Entry>, usize), Failure> {
    let (mut last, mut incomplete, mut number) = (HashMap::<_, (u32, Entry)>::new(), 0, 0);
    for path in &args.journals {
        let (found, bad) = entries(path)?;
        incomplete += bad;
        for entry in found {
            let key = entry.key();
            if last.get(&key).is_none_or(|(_, known)| known.ended <= entry.ended) {
                last.insert(key, (number, entry));
            }
            number += 1;
        }
    }
    let mut all: Vec<_> = last.into_values().collect();
    all.sort_by_key(|(number, _)| *number);
    Ok((all.into_iter().map(|(_, entry)| entry).collect(), incomplete))
}

#[derive(Serialize)]
struct Summary {
    schema: &'static str,
    files: usize,
    done: usize,
    failed: usize,
    /// How often each verb was done or has failed.
    verbs: BTreeMap<String, VerbCount>,
    /// Files with fallback normals.
    with_faults: usize,
    /// Files with each finding, and elements in them.
    findings: BTreeMap<String, FindingCount>,
    bytes: u64,
    /// Of work, summed over files.
    seconds: f64,
    /// Failed files by the first line of their error. Names of input and output are `FILE`.
    errors: BTreeMap<String, usize>,
    incomplete_lines: usize,
}

#[derive(Default, Serialize)]
struct VerbCount {
    done: usize,
    failed: usize,
}

#[derive(Default, Serialize)]
struct FindingCount {
    files: usize,
    count: u64,
}

impl Summary {
    fn new(entries: &[Entry], incomplete_lines: usize) -> Self {
        let is_failed = |entry: &&Entry| entry.status == Status::Failed;
        let mut errors = BTreeMap::new();
        for entry in entries.iter().filter(is_failed) {
            let first = entry.error.as_deref().and_then(|error| error.lines().next()).unwrap_or_default();
            // Without names, equal errors of different files are one.
            let names = entry.output.iter().chain([&entry.input]);
            let first = names.fold(first.to_owned(), |text, name| text.replace(&**name, "FILE"));
            *errors.entry(first).or_default() += 1;
        }
        let mut findings = BTreeMap::<String, FindingCount>::new();
        for (id, count) in entries.iter().flat_map(|entry| &entry.findings) {
            let finding = findings.entry(id.clone()).or_default();
            finding.files += 1;
            finding.count += count;
        }
        let mut verbs = BTreeMap::<String, VerbCount>::new();
        for entry in entries {
            let verb = verbs.entry(entry.verb.clone()).or_default();
            *(if is_failed(&entry) { &mut verb.failed } else { &mut verb.done }) += 1;
        }
        // Several verbs, or outputs of one, may have the same input.
        let count = |wanted: &dyn Fn(&&Entry) -> bool| {
            entries.iter().filter(wanted).map(|entry| &entry.input).collect::<BTreeSet<_>>().len()
        };
        let (files, failed) = (count(&|_| true), count(&is_failed));
        Self {
            findings,
            schema: "crease-journal/1",
            files,
            done: files - failed,
            failed,
            verbs,
            with_faults: count(&|entry| entry.faults > 0),
            bytes: entries.iter().map(|entry| entry.bytes).sum(),
            seconds: entries.iter().map(|entry| entry.seconds).sum(),
            errors,
            incomplete_lines,
        }
    }

    fn text(&self) -> String {
        let works: usize = self.verbs.values().map(|verb| verb.done + verb.failed).sum();
        let rate = if self.seconds > 0.0 { works as f64 / self.seconds } else { 0.0 };
        let mut text = format!(
            "{}: {} done, {} failed; {} with fallback normals\n{} read in {:.1} s of work ({rate:.1} files/s)\n",
            count(self.files, "file"),
            self.done,
            self.failed,
            self.with_faults,
            size(self.bytes),
            self.seconds,
        );
        if works != self.files {
            for (verb, VerbCount { done, failed }) in &self.verbs {
                text += &format!("  {verb}: {done} done, {failed} failed\n");
            }
        }
        let mut findings: Vec<_> = self.findings.iter().collect();
        findings.sort_by_key(|(_, finding)| std::cmp::Reverse(finding.files));
        for (id, FindingCount { files, count: elements }) in findings {
            let elements = count(*elements as usize, "element");
            text += &format!("  {id}: {} ({elements})\n", count(*files, "file"));
        }
        let mut errors: Vec<_> = self.errors.iter().collect();
        errors.sort_by_key(|(_, count)| std::cmp::Reverse(**count));
        errors.into_iter().for_each(|(error, count)| text += &format!("  {count} failed: {error}\n"));
        if self.incomplete_lines > 0 {
            text += &format!(
                "{} ignored: the run was stopped while it wrote them\n",
                count(self.incomplete_lines, "incomplete line")
            );
        }
        text
    }
}
