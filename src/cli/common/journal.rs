//! A journal of a batch: a line of JSON for each file that is done or failed. A later run with the same journal skips what is
//! done and unchanged. Each line is written at once, so that a killed run loses at most the file in work.

use super::console::HELP;
use super::failure::{Failure, io_reason};
use anyhow::{Context, Result, ensure};
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, HashMap};
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::path::Path;
use xxhash_rust::xxh3::Xxh3;

/// A line of a journal.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Entry {
    pub input: String,
    /// The verb, empty in older journals.
    #[serde(default)]
    pub verb: String,
    /// Options of the line of the manifest.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub line_options: Vec<String>,
    /// The line of the manifest names no output.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub is_bare_line: bool,
    pub bytes: u64,
    /// Where the output went, if there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub output: Option<String>,
    pub status: Status,
    /// Version of the program.
    pub crease: String,
    /// Hash of all options that affect the output.
    pub options: String,
    /// Hashes of the files that were read: the input and its companions.
    pub read: BTreeMap<String, String>,
    /// Hashes of the files that were written.
    pub written: BTreeMap<String, String>,
    /// Normals that are fallbacks.
    pub faults: u64,
    /// How many elements have each finding, by its id.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub findings: BTreeMap<String, u64>,
    /// The severity of the worst finding.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub verdict: Option<String>,
    pub seconds: f64,
    /// When the work ended, in milliseconds since 1970.
    #[serde(default)]
    pub ended: u64,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub error: Option<String>,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Status {
    #[default]
    Done,
    Failed,
}

impl Entry {
    pub fn key(&self) -> Key {
        (self.verb.clone(), self.input.clone(), self.output.clone())
    }

    /// Whether the same work need not be repeated: all files that were read and written are the same. A file that was replaced in
    /// place is now what was written. Without a hash of the input and of an output, as for streams, nothing is known.
    pub fn is_valid(&self, options: &str) -> bool {
        let is_same =
            |path: &String, expected: &String| hash_of(Path::new(path)).is_ok_and(|it| it == *expected);
        self.status == Status::Done
            && self.crease == env!("CARGO_PKG_VERSION")
            && self.options == options
            && self.read.contains_key(&self.input)
            && self.output.as_ref().is_none_or(|output| !self.written.is_empty() || *output == self.input)
            && self.written.iter().all(|(path, hash)| is_same(path, hash))
            && self.read.iter().all(|(path, hash)| self.written.contains_key(path) || is_same(path, hash))
    }
}

/// What identifies a piece of work: verb, input and output.
pub type Key = (String, String, Option<String>);

/// The entries of a journal: the last one for each piece of work. Also the number of lines that are no entries, which a killed
/// run leaves.
///
/// # Errors
/// If the file cannot be read or is not a journal.
pub fn entries(path: &Path) -> Result<(Vec<Entry>, usize), Failure> {
    let unreadable = |error: std::io::Error| {
        let (reason, advice) = io_reason(&error);
        Failure::input(format!("{}: {reason}{HELP}{advice}", path.display()))
    };
    let file = File::open(path).map_err(unreadable)?;
    let found = entries_of(&file).map_err(unreadable)?;
    if found.0.is_empty() && !is_begun(file).map_err(unreadable)? {
        return Err(Failure::input(not_a_journal(path)));
    }
    Ok(found)
}

/// Whether a file without an entry is empty or has a part of the first one, which a killed run leaves.
fn is_begun(mut file: impl Read + Seek) -> std::io::Result<bool> {
    let mut text = Vec::new();
    file.rewind()?;
    file.take(1 << 16).read_to_end(&mut text)?;
    Ok((text.starts_with(FIRST_BYTES) || FIRST_BYTES.starts_with(&text)) && !text.contains(&b'\n'))
}

fn not_a_journal(path: &Path) -> String {
    format!("{} is not a journal: it has no entry{HELP}name another file", path.display())
}

fn entries_of(file: &File) -> std::io::Result<(Vec<Entry>, usize)> {
    let mut last = HashMap::new();
    let mut bad = 0;
    for (number, line) in BufReader::new(file).split(b'\n').enumerate() {
        let line = line?;
        match serde_json::from_slice::<Entry>(&line) {
            Ok(entry) => {
                last.insert(entry.key(), (number, entry));
            }
            Err(_) => bad += usize::from(!line.trim_ascii().is_empty()),
        }
    }
    let mut entries: Vec<_> = last.into_values().collect();
    entries.sort_by_key(|(number, _)| *number);
    Ok((entries.into_iter().map(|(_, entry)| entry).collect(), bad))
}

/// The first bytes of each entry.
const FIRST_BYTES: &[u8] = b"{\"input\":\"";

/// A journal that is written.
#[derive(Debug)]
pub struct Journal {
    file: File,
    sync: bool,
    done: HashMap<Key, Entry>,
    /// Lines that are no entries.
    pub bad: usize,
}

impl Journal {
    /// Opens a journal, or makes one. It is locked until it is dropped, on file systems that have locks.
    ///
    /// # Errors
    /// If the file cannot be read or written, or another run has it.
    pub fn open(path: &Path, sync: bool) -> Result<Self, Failure> {
        let file = Self::file(path)?;
        if let Err(TryLockError::WouldBlock) = file.try_lock() {
            return Err(Failure::usage(format!(
                "another run writes the journal {}\nhelp: give each share a journal of its own, and join them with `crease journal merge`",
                path.display()
            )));
        }
        Ok(Self::of(file, path, sync)?)
    }

    fn file(path: &Path) -> Result<File> {
        ensure!(
            path.metadata().map_or(true, |metadata| metadata.is_file()),
            "the journal {} is not a regular file\nhelp: name a file",
            path.display()
        );
        let file = OpenOptions::new().read(true).append(true).create(true).open(path);
        file.with_context(|| format!("could not open the journal {}", path.display()))
    }

    fn of(mut file: File, path: &Path, sync: bool) -> Result<Self> {
        let context = || format!("could not open the journal {}", path.display());
        let (old, bad) = entries_of(&file).with_context(context)?;
        // Other files are not to be changed.
        ensure!(!old.is_empty() || is_begun(&file).with_context(context)?, "{}", not_a_journal(path));
        // A killed run may have written half a line.
        if file.seek(SeekFrom::End(0)).with_context(context)? > 0 {
            file.seek(SeekFrom::End(-1)).with_context(context)?;
            let mut last = [0];
            file.read_exact(&mut last).with_context(context)?;
            if last != *b"\n" {
                file.write_all(b"\n").with_context(context)?;
            }
        }
        let done = old.into_iter().map(|entry| (entry.key(), entry)).collect();
        Ok(Self { file, sync, done, bad })
    }

    /// The entry of earlier runs for a piece of work.
    pub fn entry(&self, work: &Key) -> Option<&Entry> {
        self.done.get(work)
    }

    /// Adds an entry.
    ///
    /// # Errors
    /// If it cannot be written: the batch must stop then, as the journal would lack what is done.
    pub fn add(&mut self, entry: &Entry) -> Result<(), Failure> {
        let mut line = serde_json::to_vec(entry).expect("an entry has string keys");
        line.push(b'\n');
        let written = self.file.write_all(&line);
        let written = written.and_then(|()| if self.sync { self.file.sync_data() } else { Ok(()) });
        written.map_err(|error| Failure::output(format!("the journal could not be written: {error}")))
    }
}

/// The hash of a file's content: XXH3 of 128 bits.
///
/// # Errors
/// If it cannot be read.
pub fn hash_of(path: &Path) -> std::io::Result<String> {
    if !path.metadata()?.is_file() {
        // Reading a pipe would wait, or take what is in it.
        return Err(std::io::Error::from(std::io::ErrorKind::InvalidInput));
    }
    let mut file = File::open(path)?;
    let mut hash = Xxh3::new();
    let mut piece = vec![0; 1 << 20];
    loop {
        match file.read(&mut piece)? {
            0 => return Ok(format!("{:032x}", hash.digest128())),
            read => hash.update(&piece[..read]),
        }
    }
}

/// The hash of bytes, as of a file with that content.
pub fn hash_of_bytes(bytes: &[u8]) -> String {
    format!("{:032x}", xxhash_rust::xxh3::xxh3_128(bytes))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_entry_is_valid_until_a_file_an_option_or_the_version_changes() {
        let folder = tempfile::tempdir().unwrap();
        let [input, output] = ["in.obj", "out.glb"].map(|name| folder.path().join(name));
        std::fs::write(&input, "v 0 0 0").unwrap();
        std::fs::write(&output, "glTF").unwrap();
        let named = |path: &Path| (path.to_str().unwrap().to_owned(), hash_of(path).unwrap());
        let entry = Entry {
            input: input.to_str().unwrap().into(),
            crease: env!("CARGO_PKG_VERSION").into(),
            options: hash_of_bytes(b"a"),
            read: [named(&input)].into(),
            written: [named(&output)].into(),
            ..Entry::default()
        };
        assert!(entry.is_valid(&hash_of_bytes(b"a")) && !entry.is_valid(&hash_of_bytes(b"b")));
        assert!(!Entry { crease: "0".into(), ..entry.clone() }.is_valid(&entry.options));
        assert!(!Entry { status: Status::Failed, ..entry.clone() }.is_valid(&entry.options));
        // Replaced in place: what was read is gone, what was written is there.
        let in_place = Entry {
            written: [named(&input)].into(),
            read: [(entry.input.clone(), "old".into())].into(),
            ..entry.clone()
        };
        assert!(in_place.is_valid(&entry.options));
        std::fs::write(&output, "glTG").unwrap();
        assert!(!entry.is_valid(&entry.options), "the output changed");
        std::fs::write(&output, "glTF").unwrap();
        std::fs::remove_file(&input).unwrap();
        assert!(!entry.is_valid(&entry.options), "the input is gone");
    }

    #[test]
    fn other_files_are_no_journals() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("file");
        for (text, is_journal) in [
            ("", true),
            ("{\"inp", true),
            ("{\"input\":\"a.obj\",\"by", true),
            ("a.obj", false),
            ("a.obj\n", false),
            ("{\"input\": \"a.obj\"}\n", false),
            ("{\"input\":\"a.obj\"}\n", false),
            ("v 0 0 0\nf 1 1 1\n", false),
        ] {
            std::fs::write(&path, text).unwrap();
            assert_eq!(Journal::open(&path, false).is_ok(), is_journal, "{text:?}");
            assert!(is_journal || std::fs::read_to_string(&path).unwrap() == text);
        }
    }

    #[test]
    fn half_a_line_stays_separate_from_the_next_entry() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("journal");
        let entry = |input: &str| Entry { input: input.into(), ..Entry::default() };
        Journal::open(&path, false).unwrap().add(&entry("a")).unwrap();
        let mut text = std::fs::read_to_string(&path).unwrap();
        text.push_str("{\"input\": \"b\", \"by");
        std::fs::write(&path, text).unwrap();
        let mut journal = Journal::open(&path, false).unwrap();
        assert_eq!(journal.bad, 1);
        journal.add(&entry("c")).unwrap();
        let again = Entry { seconds: 2.0, ..entry("a") };
        journal.add(&again).unwrap();
        let (found, bad) = entries(&path).unwrap();
        assert_eq!((found, bad), (vec![entry("c"), again], 1), "the last entry of each input, in order");
    }
}
