//! Outputs appear whole or not at all.
//!
//! Everything is written to temporary files in the folders where it belongs, then renamed: companions first, the
//! main file last, so that a program that sees the new main file finds its companions. A link is followed to the file
//! that it names, an existing file keeps its permissions, a new one has those that the umask leaves.

use super::stream::Stream;
use anyhow::{Context, Result, bail, ensure};
use crease::io::{Note, OutputContent, OutputFile, Written};
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Component, Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use tempfile::NamedTempFile;

/// What is written.
pub type Target = Stream;

impl Target {
    /// Stores a file without companions, and returns its name.
    pub fn store(&self, bytes: Vec<u8>) -> Result<String> {
        Store::default().store(Written { bytes, ..Written::default() }, self)?;
        Ok(self.name())
    }
}

/// Stores outputs and remembers which companions this run has written already.
#[derive(Debug, Default)]
pub struct Store {
    sync: bool,
    /// Do everything but write.
    dry_run: bool,
    /// Companions with the mark of their content; `None` for those of an earlier run.
    companions: Mutex<BTreeMap<PathBuf, Option<u64>>>,
}

/// An output that is stored.
#[derive(Debug, Default)]
pub struct Stored {
    /// A note for each companion that replaced a file with other content.
    pub notes: Vec<Note>,
    /// Its files: the companions, then the main one.
    pub files: Vec<PathBuf>,
}

/// Identifies the content of a companion, without keeping its bytes.
fn mark(content: &OutputContent) -> u64 {
    let mut hasher = DefaultHasher::new();
    match content {
        OutputContent::Bytes(bytes) => (0, bytes).hash(&mut hasher),
        OutputContent::CopyOf(path) => (1, path).hash(&mut hasher),
    }
    hasher.finish()
}

/// A file that is complete, but not yet at its place.
enum Staged {
    Temporary(NamedTempFile, PathBuf),
    /// A device or a pipe, which cannot be replaced: written to when its turn comes.
    Direct(PathBuf, Vec<u8>),
}

/// Makes a folder for outputs, before the work begins.
pub fn make_folder(folder: &Path) -> Result<()> {
    let file = folder.ancestors().find(|it| it.exists() && !it.is_dir());
    ensure!(
        file.is_none(),
        "{} is a file, not a folder\nhelp: name a folder; it is created if necessary",
        file.unwrap_or(folder).display()
    );
    fs::create_dir_all(folder).with_context(|| format!("could not create the folder {}", folder.display()))
}

impl Store {
    /// With `sync`, each output is on the disk before its name is. With `dry_run` nothing is written, but errors that can be
    /// known in advance are reported.
    pub fn new(sync: bool, dry_run: bool) -> Self {
        Self { sync, dry_run, ..Self::default() }
    }

    /// Keeps files that an earlier run has written: no companion may replace them by other content.
    pub fn keep(&self, paths: impl IntoIterator<Item = String>) {
        let mut known = self.companions.lock().unwrap_or_else(PoisonError::into_inner);
        known.extend(paths.into_iter().map(|path| (PathBuf::from(path), None)));
    }

    /// Stores an output and its companion files.
    ///
    /// # Errors
    /// If anything cannot be written; nothing half-written remains then.
    pub fn store(&self, written: Written, target: &Target) -> Result<Stored> {
        match target {
            Target::Standard => {
                // A copied companion exists where the input refers to it; standard output has no folder for new ones.
                let new = written.companions.iter().find(|c| matches!(c.content, OutputContent::Bytes(_)));
                if let Some(companion) = new {
                    bail!(
                        "standard output has no folder for the companion file {}\nhelp: name an output file",
                        companion.name
                    );
                }
                if !self.dry_run {
                    to_stdout(&written.bytes)?;
                }
                Ok(Stored::default())
            }
            Target::File(path) => self.store_file(written, path),
        }
    }

    /// Stores an output that is made while it is written, whole or not at all. Returns its length.
    ///
    /// # Errors
    /// Those of making it, and if it cannot be written.
    pub fn stream<E: From<anyhow::Error>>(
        &self,
        target: &Target,
        make: impl FnOnce(&mut dyn Write) -> Result<(), E>,
    ) -> Result<u64, E> {
        if let Target::File(path) = target {
            let (staged, length) = self.stage(&follow_links(path)?, make)?;
            staged.put(self.sync)?;
            return Ok(length);
        }
        let mut bytes = Vec::new();
        make(&mut bytes)?;
        to_stdout(&bytes)?;
        Ok(bytes.len() as u64)
    }

    fn store_file(&self, written: Written, path: &Path) -> Result<Stored> {
        let path = follow_links(path)?;
        // Outputs without companions are stored by several threads at the same time.
        let mut known = match written.companions.is_empty() {
            true => None,
            false => Some(self.companions.lock().unwrap_or_else(PoisonError::into_inner)),
        };
        let mut claimed = Vec::new();
        for companion in written.companions {
            claimed.extend(claim(known.as_deref().expect("there are companions"), companion, &path)?);
        }
        // Each that is new has other content than what may be there, which may be somebody else's.
        let replaced = claimed.iter().filter(|claim| claim.is_new && claim.place.is_file());
        let replaced = replaced.map(|claim| {
            let path = claim.place.display();
            let text = "belongs to the output and replaces a file of that name with other content";
            Note::remark(format!("{path} {text}"))
        });
        let notes = replaced.collect();
        check_place(&path)?;
        if !self.dry_run {
            let mut staged = Vec::new();
            for claim in claimed.iter_mut().filter(|claim| claim.is_new) {
                let bytes = claim.take_bytes()?;
                staged.push(self.stage_bytes(&claim.place, &bytes)?);
            }
            staged.push(self.stage_bytes(&path, &written.bytes)?);
            for file in staged {
                file.put(self.sync)?;
            }
        }
        let files = claimed.iter().map(|claim| claim.place.clone()).chain([path]).collect();
        if let Some(known) = &mut known {
            known.extend(claimed.into_iter().map(|claim| (claim.place, Some(claim.mark))));
        }
        Ok(Stored { notes, files })
    }

    fn stage_bytes(&self, path: &Path, bytes: &[u8]) -> Result<Staged> {
        let could_not = || format!("could not write {}", path.display());
        self.stage(path, |out| out.write_all(bytes).with_context(could_not)).map(|(staged, _)| staged)
    }

    /// Makes a complete file that can take its place, and returns its length.
    fn stage<E: From<anyhow::Error>>(
        &self,
        path: &Path,
        make: impl FnOnce(&mut dyn Write) -> Result<(), E>,
    ) -> Result<(Staged, u64), E> {
        check_place(path)?;
        let existing = fs::metadata(path).ok();
        if existing.as_ref().is_some_and(|existing| !existing.is_file()) {
            let mut bytes = Vec::new();
            make(&mut bytes)?;
            let length = bytes.len() as u64;
            return Ok((Staged::Direct(path.to_path_buf(), bytes), length));
        }
        let could_not = || format!("could not write {}", path.display());
        let mut file = temporary_in_folder(path)?;
        let mut out = BufWriter::new(file.as_file_mut());
        make(&mut out)?;
        out.flush().with_context(could_not)?;
        drop(out);
        if let Some(existing) = existing {
            file.as_file().set_permissions(existing.permissions()).with_context(could_not)?;
        }
        if self.sync {
            file.as_file().sync_all().with_context(could_not)?;
        }
        let length = file.as_file().metadata().with_context(could_not)?.len();
        Ok((Staged::Temporary(file, path.to_path_buf()), length))
    }
}

/// The place that a companion will have; `None` if it is left where it is because its name leads out of the output's folder.
fn claim(
    known: &BTreeMap<PathBuf, Option<u64>>,
    companion: OutputFile,
    main: &Path,
) -> Result<Option<Claim>> {
    let OutputFile { name, content } = companion;
    let path = Path::new(&name);
    if !path.components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir)) {
        match content {
            OutputContent::CopyOf(_) => return Ok(None),
            OutputContent::Bytes(_) => bail!("{name} leads out of the output's folder"),
        }
    }
    let place = follow_links(&folder_of(main).join(path))?;
    ensure!(
        place != main,
        "{name} is both the output and a companion file\nhelp: give the output another name"
    );
    let mark = mark(&content);
    let twin = known.get(&place);
    ensure!(
        twin.is_none_or(|twin| twin.map_or_else(|| stands(&place, &content), |twin| twin == mark)),
        "{} belongs to another output of this run too, with other content\nhelp: write them into different folders, or \
         one by one under different names",
        place.display()
    );
    let is_there = matches!(&content, OutputContent::CopyOf(source) if is_same_file(source, &place));
    if let OutputContent::CopyOf(source) = &content {
        ensure!(source.is_file(), "could not read {}, which belongs to the output", source.display());
    }
    let is_new = twin.is_none() && !is_there && !stands(&place, &content);
    if is_new {
        check_place(&place)?;
    }
    Ok(Some(Claim { is_new, place, mark, content }))
}

/// An empty file in the folder of another, which is made if it is not there.
fn temporary_in_folder(path: &Path) -> Result<NamedTempFile> {
    let folder = folder_of(path);
    make_folder(&folder)?;
    let mut builder = tempfile::Builder::new();
    builder.prefix(".crease-").suffix(".tmp");
    // The crate's own default is 0600; a new file shall be as open as the umask allows.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder).with_context(|| format!("could not write {}", path.display()))
}

/// A companion and its place.
struct Claim {
    place: PathBuf,
    mark: u64,
    content: OutputContent,
    /// It has to be written: neither has this run done so, nor is it the file that it would be a copy of, nor one with the
    /// same bytes, which may be write-protected.
    is_new: bool,
}

impl Claim {
    fn take_bytes(&mut self) -> Result<Vec<u8>> {
        match &mut self.content {
            OutputContent::Bytes(bytes) => Ok(std::mem::take(bytes)),
            OutputContent::CopyOf(source) => {
                fs::read(&*source).with_context(|| format!("could not read {}", source.display()))
            }
        }
    }
}

/// Whether a regular file is there that has this content.
fn stands(place: &Path, content: &OutputContent) -> bool {
    let Some(existing) = fs::metadata(place).ok().filter(fs::Metadata::is_file) else { return false };
    let is_as_long = |length: u64| existing.len() == length;
    match content {
        OutputContent::Bytes(bytes) => {
            is_as_long(bytes.len() as u64) && fs::read(place).is_ok_and(|there| there == *bytes)
        }
        OutputContent::CopyOf(source) => {
            fs::metadata(source).is_ok_and(|source| is_as_long(source.len()))
                && matches!((fs::read(source), fs::read(place)), (Ok(own), Ok(there)) if own == there)
        }
    }
}

/// Refuses a place where no file can be put.
fn check_place(path: &Path) -> Result<()> {
    if let Ok(existing) = fs::metadata(path) {
        ensure!(!existing.is_dir(), "{} is a folder", path.display());
        let is_protected = existing.is_file() && existing.permissions().readonly();
        ensure!(!is_protected, "{} is write-protected", path.display());
    }
    Ok(())
}

/// The folder that a file is in, links followed.
pub fn folder_of(path: &Path) -> PathBuf {
    let path = follow_links(path).unwrap_or_else(|_| path.to_path_buf());
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder.to_path_buf(),
        _ => PathBuf::from("."),
    }
}

impl Staged {
    fn put(self, sync: bool) -> Result<()> {
        match self {
            Staged::Direct(path, bytes) => {
                let result =
                    File::options().write(true).open(&path).and_then(|mut file| file.write_all(&bytes));
                forgive_broken_pipe(result).with_context(|| format!("could not write {}", path.display()))
            }
            Staged::Temporary(file, path) => {
                file.persist(&path).with_context(|| format!("could not replace {}", path.display()))?;
                if sync && cfg!(unix) {
                    let folder = folder_of(&path);
                    File::open(&folder).and_then(|folder| folder.sync_all()).with_context(|| {
                        format!("could not wait for the folder {} to be stored", folder.display())
                    })?;
                }
                Ok(())
            }
        }
    }
}

/// The name of a file without its ending.
pub fn stem(path: &Path) -> Option<String> {
    Some(path.file_stem()?.to_string_lossy().into_owned())
}

/// Writes bytes to standard output. It is no failure if its reader has closed it.
pub fn to_stdout(bytes: &[u8]) -> Result<()> {
    let mut out = io::stdout().lock();
    forgive_broken_pipe(out.write_all(bytes).and_then(|()| out.flush()))
        .context("could not write to standard output")
}

/// A reader that closes the stream early, as `head` does, is no error.
pub fn forgive_broken_pipe(result: io::Result<()>) -> io::Result<()> {
    match result {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        other => other,
    }
}

/// The file behind a chain of links, which need not exist yet.
pub fn follow_links(path: &Path) -> Result<PathBuf> {
    // As many steps as Linux takes before it calls a chain endless.
    const LONGEST: usize = 40;
    let mut path = path.to_path_buf();
    for _ in 0..LONGEST {
        let Ok(next) = fs::read_link(&path) else { return Ok(path) };
        path = path.parent().unwrap_or(Path::new("")).join(next);
    }
    bail!("{} is a symbolic link that refers to itself", path.display())
}

/// Whether both paths exist and are one file.
pub fn is_same_file(a: &Path, b: &Path) -> bool {
    matches!((a.canonicalize(), b.canonicalize()), (Ok(a), Ok(b)) if a == b)
}

/// A path with its folder made absolute, whether or not the file is there.
pub fn resolve_parent(path: &Path) -> PathBuf {
    path.canonicalize().unwrap_or_else(|_| {
        let folder = match path.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        let folder = folder.canonicalize().unwrap_or_else(|_| folder.to_path_buf());
        folder.join(path.file_name().unwrap_or_default())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(bytes: &[u8], companions: &[(&str, OutputContent)]) -> Written {
        let companions = companions
            .iter()
            .map(|(name, content)| OutputFile { name: (*name).to_owned(), content: content.clone() })
            .collect();
        Written { bytes: bytes.to_vec(), companions, ..Written::default() }
    }

    fn names(folder: &Path) -> Vec<String> {
        let mut names: Vec<String> =
            fs::read_dir(folder).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    #[test]
    fn companions_go_next_to_the_output_and_equal_ones_meet() {
        let folder = tempfile::tempdir().unwrap();
        let source = folder.path().join("source.png");
        fs::write(&source, "picture").unwrap();
        let out = folder.path().join("deep/out");
        let store = Store::new(true, false);
        let companions = [
            ("a.bin", OutputContent::Bytes(b"bin".to_vec())),
            ("textures/p.png", OutputContent::CopyOf(source.clone())),
            ("../outside.png", OutputContent::CopyOf(source.clone())),
        ];
        store.store(written(b"main", &companions), &Target::File(out.join("a.gltf"))).unwrap();
        assert_eq!(names(&out), ["a.bin", "a.gltf", "textures"]);
        assert_eq!(fs::read(out.join("textures/p.png")).unwrap(), b"picture");
        assert_eq!(names(folder.path()), ["deep", "source.png"], "nothing outside the output's folder");

        store.store(written(b"main", &companions), &Target::File(out.join("b.gltf"))).unwrap();
        let other = [("a.bin", OutputContent::Bytes(b"other".to_vec()))];
        let error = store.store(written(b"main", &other), &Target::File(out.join("c.gltf"))).unwrap_err();
        assert!(error.to_string().contains("another output"), "{error}");
        assert_eq!(names(&out), ["a.bin", "a.gltf", "b.gltf", "textures"]);
        assert_eq!(fs::read(out.join("a.bin")).unwrap(), b"bin");
    }

    #[test]
    fn what_cannot_be_stored_leaves_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let store = Store::new(false, false);
        let missing = [
            ("a.bin", OutputContent::Bytes(b"bin".to_vec())),
            ("p.png", OutputContent::CopyOf(folder.path().join("nowhere.png"))),
        ];
        for companions in [&missing[..], &[("../x.bin", OutputContent::Bytes(vec![]))]] {
            let target = Target::File(folder.path().join("a.gltf"));
            assert!(store.store(written(b"main", companions), &target).is_err());
            assert_eq!(names(folder.path()), [""; 0]);
        }
        let stream = [("a.bin", OutputContent::Bytes(vec![]))];
        assert!(store.store(written(b"", &stream), &Target::Standard).is_err());
        assert!(store.store(written(b"", &[]), &Target::File(folder.path().to_path_buf())).is_err());
    }

    #[test]
    fn streams_are_stored_whole_or_not_at_all() {
        let folder = tempfile::tempdir().unwrap();
        let (store, path) = (Store::new(true, false), folder.path().join("deep/a.gif"));
        let stream = |fails: bool| {
            store.stream(&Target::File(path.clone()), |out| -> Result<()> {
                out.write_all(b"frame")?;
                ensure!(!fails, "no second frame");
                Ok(())
            })
        };
        assert!(stream(true).is_err());
        assert_eq!(names(&folder.path().join("deep")), [""; 0]);
        assert_eq!(stream(false).unwrap(), 5);
        assert!(stream(true).is_err());
        assert_eq!(
            (names(&folder.path().join("deep")), fs::read(&path).unwrap()),
            (vec!["a.gif".to_owned()], b"frame".to_vec())
        );
        assert!(store.stream(&Target::File(folder.path().into()), |_| -> Result<()> { Ok(()) }).is_err());
    }

    /// What has the bytes already need not be writable; what has others does.
    #[test]
    fn companions_that_stay_the_same_are_left_alone() {
        let folder = tempfile::tempdir().unwrap();
        let there = folder.path().join("a.bin");
        fs::write(&there, "bin").unwrap();
        let mut permissions = fs::metadata(&there).unwrap().permissions();
        permissions.set_readonly(true);
        fs::set_permissions(&there, permissions).unwrap();
        let store = |name: &str, content: OutputContent| {
            let target = Target::File(folder.path().join(name));
            Store::new(false, false).store(written(b"main", &[("a.bin", content)]), &target)
        };
        assert!(store("b.gltf", OutputContent::Bytes(b"bin".to_vec())).unwrap().notes.is_empty());
        assert!(store("c.gltf", OutputContent::CopyOf(there.clone())).unwrap().notes.is_empty());
        assert!(store("d.gltf", OutputContent::Bytes(b"new".to_vec())).is_err());
        assert_eq!(names(folder.path()), ["a.bin", "b.gltf", "c.gltf"]);
    }

    #[cfg(unix)]
    #[test]
    fn links_are_followed_and_permissions_kept() {
        use std::os::unix::fs::{PermissionsExt, symlink};
        let folder = tempfile::tempdir().unwrap();
        let (real, link) = (folder.path().join("real/file.obj"), folder.path().join("link.obj"));
        symlink("real/file.obj", &link).unwrap();
        let store = Store::new(false, false);
        store.store(written(b"one", &[]), &Target::File(link.clone())).unwrap();
        fs::set_permissions(&real, fs::Permissions::from_mode(0o640)).unwrap();
        store.store(written(b"two", &[]), &Target::File(link.clone())).unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::read(&real).unwrap(), b"two");
        assert_eq!(fs::metadata(&real).unwrap().permissions().mode() & 0o777, 0o640);

        fs::set_permissions(&real, fs::Permissions::from_mode(0o444)).unwrap();
        assert!(store.store(written(b"three", &[]), &Target::File(link)).is_err());
        assert_eq!(fs::read(&real).unwrap(), b"two");

        let (a, b) = (folder.path().join("a"), folder.path().join("b"));
        symlink(&b, &a).unwrap();
        symlink(&a, &b).unwrap();
        assert!(store.store(written(b"", &[]), &Target::File(a)).is_err());
    }
}
