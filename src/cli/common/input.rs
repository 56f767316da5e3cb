//! Files and standard input: arguments and folders become a list of inputs in a fixed order, which are then read.

use super::failure::Failure;
use super::stream::Stream;
use crease::io::{self, Format, Limits, Loaded, Place, Problem, ReadError, ReadOptions};
use std::io::{IsTerminal, Read};
use std::path::{Path, PathBuf};
use walkdir::WalkDir;

/// What is read.
pub type Source = Stream;

impl Source {
    /// Reads it; `arrived` receives the number of bytes of each piece of standard input.
    pub fn read(
        &self,
        format: Option<Format>,
        options: &ReadOptions,
        arrived: impl FnMut(u64),
    ) -> Result<Loaded, ReadError> {
        match self {
            Source::File(path) => io::read(path, format, options),
            Source::Standard => io::read_bytes(read_stdin(&options.limits, arrived)?, format, None, options),
        }
    }
}

fn read_stdin(limits: &Limits, mut arrived: impl FnMut(u64)) -> Result<Vec<u8>, ReadError> {
    const PIECE: u64 = 1 << 20;
    let mut stdin = std::io::stdin().lock();
    let fail = |problem, found: String, advice: &str| ReadError::new(problem, Place::File, found, advice);
    if stdin.is_terminal() {
        let found = "standard input is a terminal".into();
        return Err(fail(Problem::Io, found, "pipe a file into it, or name a file"));
    }
    let mut bytes = Vec::new();
    while bytes.len() as u64 <= limits.bytes {
        let read = stdin.by_ref().take(PIECE).read_to_end(&mut bytes);
        match read {
            Ok(0) => {
                arrived(0);
                return Ok(bytes);
            }
            Ok(more) => arrived(more as u64),
            Err(error) => {
                let advice = "check the command before the pipe";
                return Err(fail(Problem::Io, format!("could not read standard input: {error}"), advice));
            }
        }
    }
    let found = format!("standard input has more than {} bytes", limits.bytes);
    Err(fail(Problem::Limit, found, "split the file"))
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Input {
    pub source: Source,
    /// The path of its output below an output folder: its path within the given folder, or its file name.
    pub place: PathBuf,
    /// The output that a manifest names for it.
    pub output: Option<PathBuf>,
    /// Options for it alone, from a manifest.
    pub options: Vec<String>,
    /// The manifest and the number of its line, for messages.
    pub line: Option<String>,
}

impl Input {
    fn new(source: Source, place: PathBuf) -> Self {
        Self { source, place, output: None, options: Vec::new(), line: None }
    }

    /// An error in what its line of the manifest asks for.
    pub fn refused(&self, failure: Failure) -> Failure {
        let place = self.line.iter().map(|line| format!("{line}: "));
        Failure { message: place.collect::<String>() + &failure.message, ..failure }
    }
}

/// Turns arguments into inputs, in the order given; what a folder holds is sorted by path.
///
/// Folders are searched for the extensions of [`Format`]. Hidden files are skipped, links to folders are not followed, and
/// nothing below `out_dir` is taken: an earlier run may have written there. A broken link with such a name is taken, so that
/// reading it fails with a message.
pub fn expand(args: &[PathBuf], recursive: bool, out_dir: Option<&Path>) -> Result<Vec<Input>, Failure> {
    let mut inputs = Vec::new();
    let out_dir = out_dir.and_then(|dir| dir.canonicalize().ok());
    for arg in args {
        if arg.as_os_str() == "-" {
            if inputs.iter().any(|input: &Input| input.source == Source::Standard) {
                return Err(Failure::usage("standard input can be read only once\nhelp: give `-` once"));
            }
            inputs.push(Input::new(Source::Standard, PathBuf::from("-")));
        } else if arg.is_dir() {
            if !recursive {
                let advice =
                    format!("{} is a folder\nhelp: --recursive includes the mesh files in it", arg.display());
                return Err(Failure::usage(advice));
            }
            let before = inputs.len();
            search(arg, out_dir.as_deref(), &mut inputs)?;
            if inputs.len() == before {
                let found = format!(
                    "{}: no obj, ply, stl, gltf, glb or 3mf file in this folder\nhelp: check the name of the folder",
                    arg.display()
                );
                return Err(Failure::input(found));
            }
        } else {
            let place = arg.file_name().map(PathBuf::from).unwrap_or_else(|| arg.clone());
            inputs.push(Input::new(Source::File(arg.clone()), place));
        }
    }
    Ok(inputs)
}

fn search(folder: &Path, out_dir: Option<&Path>, inputs: &mut Vec<Input>) -> Result<(), Failure> {
    // Of the folder itself only the collisions are refused: it may be hidden, or where the output goes.
    let is_input = |entry: &walkdir::DirEntry| {
        let is_hidden = entry.file_name().as_encoded_bytes().starts_with(b".");
        let is_output = || out_dir.is_some() && entry.path().canonicalize().ok().as_deref() == out_dir;
        entry.depth() == 0 || !is_hidden && !is_output()
    };
    for entry in WalkDir::new(folder).sort_by_file_name().into_iter().filter_entry(is_input) {
        let entry = entry.map_err(Failure::input)?;
        let path = entry.into_path();
        if Format::from_path(&path).is_some() && !path.is_dir() {
            let place = path.strip_prefix(folder).unwrap_or(&path).to_path_buf();
            inputs.push(Input::new(Source::File(path), place));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::failure::FailureKind;
    use super::*;
    use std::fs;

    fn names(inputs: &[Input]) -> Vec<&str> {
        inputs.iter().map(|input| input.place.to_str().unwrap()).collect()
    }

    #[test]
    fn folders_are_searched_in_order_without_hidden_files_and_outputs() {
        let folder = tempfile::tempdir().unwrap();
        let root = folder.path();
        for name in ["b.obj", "a/z.STL", "a/y.ply", ".hidden.obj", "out/b.obj", "note.txt", "c.glb"] {
            let path = root.join(name);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, "").unwrap();
        }
        let args = [root.to_path_buf()];
        let found = expand(&args, true, Some(&root.join("out"))).unwrap();
        assert_eq!(names(&found), ["a/y.ply", "a/z.STL", "b.obj", "c.glb"]);
        let found = expand(&args, true, None).unwrap();
        assert_eq!(names(&found), ["a/y.ply", "a/z.STL", "b.obj", "c.glb", "out/b.obj"]);
        assert_eq!(expand(&args, false, None).unwrap_err().kind, FailureKind::Usage);
    }

    #[cfg(unix)]
    #[test]
    fn links_that_lead_nowhere_are_not_passed_over() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("a.obj"), "").unwrap();
        fs::create_dir(folder.path().join("folder")).unwrap();
        std::os::unix::fs::symlink("nowhere.obj", folder.path().join("b.obj")).unwrap();
        std::os::unix::fs::symlink("folder", folder.path().join("c.obj")).unwrap();
        let found = expand(&[folder.path().to_path_buf()], true, None).unwrap();
        assert_eq!(names(&found), ["a.obj", "b.obj"]);
    }

    #[test]
    fn an_empty_folder_is_an_error_and_a_missing_file_waits_for_its_turn() {
        let folder = tempfile::tempdir().unwrap();
        let args = [folder.path().to_path_buf()];
        assert_eq!(expand(&args, true, None).unwrap_err().kind, FailureKind::Input);
        let args = [PathBuf::from("dir/nowhere.obj"), PathBuf::from("-")];
        assert_eq!(names(&expand(&args, false, None).unwrap()), ["nowhere.obj", "-"]);
        let twice = [args[1].clone(), args[1].clone()];
        assert_eq!(expand(&twice, false, None).unwrap_err().kind, FailureKind::Usage);
    }
}
