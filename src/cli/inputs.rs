//! Which files are meant: arguments and folders become a list in a fixed order.

use super::request::RequestError;
use crease::io::Format;
use ignore::WalkBuilder;
use std::path::{Path, PathBuf};

/// A file to read, or standard input.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Source {
    Stdin,
    File(PathBuf),
}

/// One input.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Input {
    pub source: Source,
    /// Where it goes below an output folder: its place in the folder that was given, or its bare name.
    pub place: PathBuf,
}

/// Turns arguments into inputs, in the order given; what a folder holds is sorted by path.
///
/// Folders are searched for the extensions of [`Format`]. Hidden files are left out, links to folders are not
/// followed, and nothing below `out_dir` is taken: it may lie within the input from the run before. What has such a name and is
/// no file, as a link that leads nowhere, is taken, so that reading it fails and nothing is passed over without a word.
pub fn expand(args: &[PathBuf], recursive: bool, out_dir: Option<&Path>) -> Result<Vec<Input>, RequestError> {
    let mut inputs = Vec::new();
    let out_dir = out_dir.and_then(|dir| dir.canonicalize().ok());
    for arg in args {
        if arg.as_os_str() == "-" {
            if inputs.iter().any(|input: &Input| input.source == Source::Stdin) {
                return Err(RequestError::Usage("standard input can be read only once".into()));
            }
            inputs.push(Input { source: Source::Stdin, place: PathBuf::from("-") });
        } else if arg.is_dir() {
            if !recursive {
                let advice = format!("{} is a folder; --recursive takes the mesh files in it", arg.display());
                return Err(RequestError::Usage(advice));
            }
            let before = inputs.len();
            search(arg, out_dir.as_deref(), &mut inputs)?;
            if inputs.len() == before {
                let found = format!("{}: no obj, ply, stl, gltf or glb file in this folder", arg.display());
                return Err(RequestError::Input(found));
            }
        } else {
            let place = arg.file_name().map(PathBuf::from).unwrap_or_else(|| arg.clone());
            inputs.push(Input { source: Source::File(arg.clone()), place });
        }
    }
    Ok(inputs)
}

fn search(folder: &Path, out_dir: Option<&Path>, inputs: &mut Vec<Input>) -> Result<(), RequestError> {
    let out_dir = out_dir.map(Path::to_path_buf);
    let walk = WalkBuilder::new(folder)
        .standard_filters(false)
        .hidden(true)
        .sort_by_file_path(Path::cmp)
        // The folder itself may be where the output goes; then only its collisions are refused.
        .filter_entry(move |entry| {
            entry.depth() == 0 || out_dir.is_none() || entry.path().canonicalize().ok() != out_dir
        })
        .build();
    for entry in walk {
        let entry = entry.map_err(|error| RequestError::Input(error.to_string()))?;
        let path = entry.into_path();
        if Format::from_path(&path).is_some() && !path.is_dir() {
            let place = path.strip_prefix(folder).unwrap_or(&path).to_path_buf();
            inputs.push(Input { source: Source::File(path), place });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
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
        assert!(matches!(expand(&args, false, None), Err(RequestError::Usage(_))));
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
        assert!(matches!(expand(&args, true, None), Err(RequestError::Input(_))));
        let args = [PathBuf::from("dir/nowhere.obj"), PathBuf::from("-")];
        assert_eq!(names(&expand(&args, false, None).unwrap()), ["nowhere.obj", "-"]);
        assert!(matches!(
            expand(&[args[1].clone(), args[1].clone()], false, None),
            Err(RequestError::Usage(_))
        ));
    }
}
