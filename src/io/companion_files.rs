//! Files that an input refers to, and which of them may be read.

use super::{Place, Problem, ReadError, ReadOptions};
use std::fmt;
use std::path::{Component, Path, PathBuf};

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Refusal {
    Remote,
    /// It is outside the folder that companions may come from.
    Outside,
    Missing,
    /// It is there, but a folder or a device.
    NoFile,
}

impl fmt::Display for Refusal {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(match self {
            Refusal::Remote => "is a network path or URL and was not read",
            Refusal::Outside => "is outside the input's folder and was not read",
            Refusal::Missing => "was not found",
            Refusal::NoFile => "is a folder or not a regular file, and was not read",
        })
    }
}

impl Refusal {
    /// What to do about it; `is_stream`: if the input has no folder of its own.
    pub(super) fn advice(self, is_stream: bool) -> &'static str {
        match self {
            Refusal::Remote => "copy it to this machine",
            Refusal::Outside => "move it into that folder, or allow its folder with --root",
            Refusal::Missing if is_stream => "name its folder with --root",
            Refusal::Missing => "copy the file to that path, or correct its name",
            Refusal::NoFile => "name a file",
        }
    }

    /// The same in a note, which has no advice of its own.
    pub(super) fn in_note(self) -> String {
        let hint = if self == Refusal::Outside { " (--root allows its folder)" } else { "" };
        format!("{self}{hint}")
    }
}

/// The file that a name refers to from `folder`, relative to the input's folder `base`. It must lie in that folder or in the
/// root of the options; symbolic links are followed before the check.
pub(super) fn find(
    base: &Path,
    folder: &Path,
    name: &str,
    options: &ReadOptions,
) -> Result<PathBuf, Refusal> {
    let scheme = name.split_once(':').map_or("", |(scheme, _)| scheme);
    let is_url =
        scheme.len() > 1 && scheme.bytes().all(|byte| byte.is_ascii_alphanumeric() || b"+-.".contains(&byte));
    if is_url || name.starts_with("//") || name.starts_with("\\\\") {
        return Err(Refusal::Remote);
    }
    // The folder of a bare file name is the empty path.
    let base = if base.as_os_str().is_empty() { Path::new(".") } else { base };
    let folder = base.join(folder);
    let found = folder.join(name).canonicalize();
    let path = found.or_else(|_| folder.join(name.replace('\\', "/")).canonicalize());
    let path = path.map_err(|_| Refusal::Missing)?;
    let mut allowed = [Some(base), options.root.as_deref()].into_iter().flatten();
    if !allowed.any(|folder| folder.canonicalize().is_ok_and(|folder| path.starts_with(folder))) {
        return Err(Refusal::Outside);
    }
    if !path.is_file() {
        return Err(Refusal::NoFile);
    }
    options.log.add(&path);
    Ok(path)
}

/// The file that a name refers to from the folder `base`, in which it must lie, or else within the root of the options.
pub(crate) fn companion(base: &Path, name: &str, options: &ReadOptions) -> Result<PathBuf, ReadError> {
    find(base, Path::new(""), name, options).map_err(|refusal| {
        ReadError::new(Problem::Companion, Place::File, format!("the file {refusal}"), refusal.advice(false))
    })
}

/// The name of a companion in the output's folder, such that the output's reference finds it; `None` if it is outside.
pub(super) fn output_name(folder: &Path, name: &str) -> Option<String> {
    let path = folder.join(name.replace('\\', "/"));
    let mut parts = Vec::new();
    for part in path.components() {
        match part {
            Component::Normal(part) => parts.push(part.to_str()?),
            Component::CurDir => {}
            Component::ParentDir => drop(parts.pop()?),
            _ => return None,
        }
    }
    (!parts.is_empty()).then(|| parts.join("/"))
}

/// Whether a relative name leads from an output's folder to this very file, so that a reference still holds there.
pub(super) fn leads_to(folder: Option<&Path>, name: &str, file: &Path) -> bool {
    let Some(folder) = folder else { return false };
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let found = folder.join(name.replace('\\', "/")).canonicalize();
    matches!((found, file.canonicalize()), (Ok(found), Ok(file)) if found == file)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn companions_stay_inside_their_folder() {
        let outer = tempfile::tempdir().unwrap();
        let inner = outer.path().join("in");
        fs::create_dir_all(inner.join("sub")).unwrap();
        for name in ["out.mtl", "in/a b.mtl", "in/sub/c.mtl"] {
            fs::write(outer.path().join(name), "").unwrap();
        }
        let options = ReadOptions::default();
        let find_in = |folder: &str, name: &str| find(&inner, Path::new(folder), name, &options);
        let find_with = |name: &str, options: &ReadOptions| find(&inner, Path::new(""), name, options);
        let find = |name: &str| find_in("", name);
        assert!(find("a b.mtl").is_ok() && find("sub/c.mtl").is_ok() && find("sub\\c.mtl").is_ok());
        assert!(find("./sub/../a b.mtl").is_ok());
        assert_eq!(find_in("sub", "../../out.mtl"), Err(Refusal::Outside));
        assert_eq!(find("../out.mtl"), Err(Refusal::Outside));
        assert_eq!(find(outer.path().join("out.mtl").to_str().unwrap()), Err(Refusal::Outside));
        assert_eq!(find("none.mtl"), Err(Refusal::Missing));
        assert_eq!(find("sub"), Err(Refusal::NoFile), "a folder");
        assert_eq!(find("nul\0.mtl"), Err(Refusal::Missing));
        for name in ["http://host/a.mtl", "file:///etc/passwd", "//host/share/a.mtl", "\\\\host\\a.mtl"] {
            assert_eq!(find(name), Err(Refusal::Remote), "{name}");
        }
        let root = ReadOptions { root: Some(outer.path().to_owned()), ..ReadOptions::default() };
        assert!(find_with("../out.mtl", &root).is_ok());
        let elsewhere = tempfile::tempdir().unwrap();
        let root = ReadOptions { root: Some(elsewhere.path().to_owned()), ..ReadOptions::default() };
        assert!(find_with("a b.mtl", &root).is_ok(), "a root takes nothing away");
    }

    #[test]
    #[cfg(unix)]
    fn links_do_not_lead_outside() {
        let outer = tempfile::tempdir().unwrap();
        let inner = outer.path().join("in");
        fs::create_dir(&inner).unwrap();
        fs::write(outer.path().join("out.mtl"), "").unwrap();
        std::os::unix::fs::symlink(outer.path().join("out.mtl"), inner.join("link.mtl")).unwrap();
        let options = ReadOptions::default();
        assert_eq!(find(&inner, Path::new(""), "link.mtl", &options), Err(Refusal::Outside));
    }

    #[test]
    fn output_names_are_relative_and_inside() {
        let name = |folder: &str, name: &str| output_name(Path::new(folder), name);
        assert_eq!(name("", "./a.mtl").as_deref(), Some("a.mtl"));
        assert_eq!(name("sub", "tex\\b c.png").as_deref(), Some("sub/tex/b c.png"));
        assert_eq!(name("sub", "../b.png").as_deref(), Some("b.png"));
        assert_eq!(name("sub", "../../sub/b.png"), None);
        assert_eq!(name("", "/etc/passwd"), None);
        assert_eq!(name("", ""), None);
    }
}
