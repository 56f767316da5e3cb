//! Files that an input refers to, and which of them may be read.

use super::{Place, Problem, ReadError, ReadOptions};
use std::fmt;
use std::path::{Component, Path, PathBuf};

/// Why a companion is not read.
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
            Refusal::Outside => {
                "is outside the input's folder and was not read (--root allows another folder)"
            }
            Refusal::Missing => "was not found",
            Refusal::NoFile => "is not a regular file and was not read",
        })
    }
}

pub(super) struct Companions {
    base: PathBuf,
    /// Where they may be: the base, and the root of the options.
    allowed: Vec<PathBuf>,
}

impl Companions {
    /// Companions of a file in the folder `base`; from nowhere outside it and outside the root of the options.
    pub fn new(base: &Path, options: &ReadOptions) -> Self {
        // The folder of a bare file name is the empty path.
        let base = if base.as_os_str().is_empty() { Path::new(".") } else { base };
        let folders = [Some(base), options.root.as_deref()];
        let allowed = folders.into_iter().flatten().filter_map(|folder| folder.canonicalize().ok());
        Self { base: base.to_owned(), allowed: allowed.collect() }
    }

    /// The file that a name refers to from the folder `folder`, relative to the input's. Symbolic links are followed
    /// before the location is checked.
    pub fn find(&self, folder: &Path, name: &str) -> Result<PathBuf, Refusal> {
        let scheme = name.split_once(':').map_or("", |(scheme, _)| scheme);
        let is_url = scheme.len() > 1
            && scheme.bytes().all(|byte| byte.is_ascii_alphanumeric() || b"+-.".contains(&byte));
        if is_url || name.starts_with("//") || name.starts_with("\\\\") {
            return Err(Refusal::Remote);
        }
        let folder = self.base.join(folder);
        let found = folder.join(name).canonicalize();
        let path = found.or_else(|_| folder.join(name.replace('\\', "/")).canonicalize());
        let path = path.map_err(|_| Refusal::Missing)?;
        if !self.allowed.iter().any(|folder| path.starts_with(folder)) {
            return Err(Refusal::Outside);
        }
        if path.is_file() { Ok(path) } else { Err(Refusal::NoFile) }
    }
}

/// The file that a name refers to from the folder `base`, in which it must lie, or else within the root of the options.
pub(crate) fn companion(base: &Path, name: &str, options: &ReadOptions) -> Result<PathBuf, ReadError> {
    Companions::new(base, options).find(Path::new(""), name).map_err(|refusal| {
        let advice = match refusal {
            Refusal::Remote => "copy it to this machine",
            Refusal::Outside => "move it into that folder",
            Refusal::Missing => "check the name",
            Refusal::NoFile => "name a file",
        };
        ReadError::new(Problem::Companion, Place::File, format!("it {refusal}"), advice)
    })
}

/// The name of a companion in the folder of the output, such that the output's reference finds it; `None` if that would be
/// outside the output's folder.
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
        let companions = Companions::new(&inner, &ReadOptions::default());
        let find = |name: &str| companions.find(Path::new(""), name);
        assert!(find("a b.mtl").is_ok() && find("sub/c.mtl").is_ok() && find("sub\\c.mtl").is_ok());
        assert!(find("./sub/../a b.mtl").is_ok());
        assert_eq!(companions.find(Path::new("sub"), "../../out.mtl"), Err(Refusal::Outside));
        assert_eq!(find("../out.mtl"), Err(Refusal::Outside));
        assert_eq!(find(outer.path().join("out.mtl").to_str().unwrap()), Err(Refusal::Outside));
        assert_eq!(find("none.mtl"), Err(Refusal::Missing));
        assert_eq!(find("sub"), Err(Refusal::NoFile), "a folder");
        assert_eq!(find("nul\0.mtl"), Err(Refusal::Missing));
        for name in ["http://host/a.mtl", "file:///etc/passwd", "//host/share/a.mtl", "\\\\host\\a.mtl"] {
            assert_eq!(find(name), Err(Refusal::Remote), "{name}");
        }
        let root = ReadOptions { root: Some(outer.path().to_owned()), ..ReadOptions::default() };
        assert!(Companions::new(&inner, &root).find(Path::new(""), "../out.mtl").is_ok());
        let elsewhere = tempfile::tempdir().unwrap();
        let root = ReadOptions { root: Some(elsewhere.path().to_owned()), ..ReadOptions::default() };
        assert!(
            Companions::new(&inner, &root).find(Path::new(""), "a b.mtl").is_ok(),
            "a root takes nothing away"
        );
    }

    #[test]
    #[cfg(unix)]
    fn links_do_not_lead_outside() {
        let outer = tempfile::tempdir().unwrap();
        let inner = outer.path().join("in");
        fs::create_dir(&inner).unwrap();
        fs::write(outer.path().join("out.mtl"), "").unwrap();
        std::os::unix::fs::symlink(outer.path().join("out.mtl"), inner.join("link.mtl")).unwrap();
        let companions = Companions::new(&inner, &ReadOptions::default());
        assert_eq!(companions.find(Path::new(""), "link.mtl"), Err(Refusal::Outside));
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
