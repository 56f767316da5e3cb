//! No output may replace an input or another output.

use super::output::{follow_links, resolve_parent};
use std::cell::RefCell;
use std::collections::HashMap;
use std::path::{Component, Path, PathBuf};

/// The files that a run reads and writes.
pub struct Files<'a> {
    folders: Folders,
    inputs: HashMap<PathBuf, &'a Path>,
    /// Each output with the name of what it is made of.
    outputs: HashMap<PathBuf, String>,
}

impl<'a> Files<'a> {
    pub fn read(inputs: impl IntoIterator<Item = &'a Path>) -> Self {
        let folders = Folders::default();
        let inputs = inputs.into_iter().map(|path| (folders.resolve(path), path)).collect();
        Self { folders, inputs, outputs: HashMap::new() }
    }

    /// # Errors
    /// If the output is an input.
    pub fn check(&self, output: &Path) -> Result<(), String> {
        match self.inputs.get(&self.folders.resolve(output)) {
            Some(input) => {
                let input = input.display();
                Err(format!("this would overwrite the input {input}\nhelp: name another output"))
            }
            None => Ok(()),
        }
    }

    /// Adds an output that is made of an input.
    ///
    /// # Errors
    /// If it is another output too.
    pub fn write(&mut self, output: &Path, of: String) -> Result<(), String> {
        let output_file = self.folders.resolve(output);
        let Some(other) = self.outputs.insert(output_file, of.clone()) else { return Ok(()) };
        let both = if other == of { "two outputs".into() } else { format!("{other} and {of}") };
        Err(format!("{both} would both be written to {}\nhelp: name a file for each", output.display()))
    }
}

/// Folders by their paths without symbolic links. Millions of files are in few folders, and each access to shared storage takes time.
#[derive(Default)]
struct Folders(RefCell<HashMap<PathBuf, PathBuf>>);

impl Folders {
    /// A path without symbolic links, whether or not the file exists.
    fn resolve(&self, path: &Path) -> PathBuf {
        let (Some(parent), Some(name)) = (path.parent(), path.file_name()) else {
            return resolve_parent(path);
        };
        let mut known = self.0.borrow_mut();
        if !known.contains_key(parent) {
            known.insert(parent.to_owned(), real_folder(parent));
        }
        let file = known[parent].join(name);
        match file.read_link() {
            Ok(_) => resolve_parent(&follow_links(&file).unwrap_or(file)),
            Err(_) => file,
        }
    }
}

/// A folder without symbolic links and steps upwards, whether or not it exists.
fn real_folder(folder: &Path) -> PathBuf {
    let mut real = Path::new(".").canonicalize().unwrap_or_default();
    for part in folder.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir => _ = real.pop(),
            part => real.push(part),
        }
        if let Ok(link) = real.canonicalize() {
            real = link;
        }
    }
    real
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[cfg(unix)]
    #[test]
    fn a_file_is_recognised_by_all_its_paths() {
        let folder = tempfile::tempdir().unwrap();
        let root = folder.path();
        fs::create_dir_all(root.join("a/b")).unwrap();
        fs::write(root.join("a/in.obj"), "").unwrap();
        std::os::unix::fs::symlink("a", root.join("link")).unwrap();
        std::os::unix::fs::symlink("a/in.obj", root.join("also.obj")).unwrap();
        std::os::unix::fs::symlink("a/new.obj", root.join("later.obj")).unwrap();
        let input = root.join("a/in.obj");
        let mut files = Files::read([input.as_path()]);
        for path in ["a/in.obj", "a/b/../in.obj", "link/in.obj", "also.obj", "link/b/../in.obj"] {
            assert!(files.check(&root.join(path)).is_err(), "{path}");
        }
        for path in ["a/other.obj", "in.obj", "none/in.obj"] {
            files.check(&root.join(path)).unwrap();
        }
        files.write(&root.join("a/new.obj"), "x".into()).unwrap();
        assert!(files.write(&root.join("later.obj"), "y".into()).is_err());
        files.write(&root.join("none/new.obj"), "x".into()).unwrap();
        assert!(files.write(&root.join("none/new.obj"), "y".into()).is_err());
        assert!(files.write(&root.join("none/more/../new.obj"), "y".into()).is_err());
        assert!(files.write(&root.join("none/../a/new.obj"), "y".into()).is_err());
        assert!(Files::read([root.join("also.obj").as_path()]).check(&input).is_err());
        // The working folder has no name in a path.
        assert!(Files::read([Path::new("in.obj")]).check(Path::new("./in.obj")).is_err());
    }
}
