//! Material libraries: their materials, and the files that a copy of the output needs.

use super::cursor::name_text;
use super::mtl_materials::{file_material, materials, textures};
use crate::io::companion_files::{Companions, Refusal, output_name};
use crate::io::text::shown;
use crate::io::{FileMaterial, Note, OutputContent, OutputFile, Place, ReadOptions};
use crate::mesh::FaceLabels;
use rustc_hash::FxHashSet;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::Read;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// The most libraries and textures that are searched for. Real files have a handful; a hostile one must not cost a million
/// file look-ups.
const MOST_FILES: usize = 1000;

/// The most names of missing files that a note lists after the first.
const MOST_NAMES: usize = 10;

/// Largest library that is read.
const MOST_BYTES: u64 = 64 << 20;

/// The material libraries of a file.
#[derive(Clone, Debug, Default)]
pub(super) struct Materials {
    /// Libraries and textures, to be copied along with an output in another folder.
    pub files: Vec<OutputFile>,
    /// The materials, the first definition of each name.
    pub materials: Vec<FileMaterial>,
    pub notes: Vec<Note>,
}

/// Finds the libraries that `mtllib` statements name, and the textures that these name.
pub(super) fn find(
    text: &[u8],
    statements: &[Range<usize>],
    used: Option<&FaceLabels>,
    base: &Path,
    options: &ReadOptions,
) -> Materials {
    let companions = Companions::new(base, options);
    let mut search = Search {
        companions,
        searched: 0,
        files: BTreeMap::new(),
        missing: BTreeMap::new(),
        defined: FxHashSet::default(),
        materials: Vec::new(),
    };
    let mut seen = FxHashSet::default();
    for statement in statements {
        let names = name_text(&text[statement.clone()]);
        if seen.insert(names.clone()) {
            search.libraries(&names);
        }
    }
    let notes = search.notes(used);
    let files = search.files.into_iter();
    let files = files.map(|(name, path)| OutputFile { name, content: OutputContent::CopyOf(path) }).collect();
    Materials { files, materials: search.materials, notes }
}

/// The note on the libraries of a stream, which has no folder to search for them.
pub(super) fn out_of_reach(text: &[u8], statements: &[Range<usize>]) -> Materials {
    let note = |first: &Range<usize>| {
        let name = name_text(&text[first.clone()]);
        let found =
            format!("`{}` was not read: a stream has no folder (--root names one)", shown(name.as_bytes()));
        Note { more: statements.len() as u64 - 1, ..Note::warning(Place::File, found) }
    };
    Materials { notes: statements.first().map(note).into_iter().collect(), ..Materials::default() }
}

struct Search {
    companions: Companions,
    /// How many files were searched for.
    searched: usize,
    files: BTreeMap<String, PathBuf>,
    /// Names of companions by the reason why they are not read; without a reason, they cannot be copied.
    missing: BTreeMap<Missing, BTreeSet<String>>,
    defined: FxHashSet<String>,
    materials: Vec<FileMaterial>,
}

#[derive(PartialEq, Eq, PartialOrd, Ord)]
enum Missing {
    NotRead(Refusal),
    /// A copy would be outside the output's folder.
    NotCopied,
}

impl Search {
    /// One `mtllib` statement: one name with blanks in it, if there is such a file, or else several names.
    fn libraries(&mut self, names: &str) {
        if self.may_search() && self.companions.find(Path::new(""), names).is_ok() {
            return self.read_library(names);
        }
        for name in split_names(names) {
            if self.searched > MOST_FILES {
                return;
            }
            self.read_library(name);
        }
    }

    fn may_search(&mut self) -> bool {
        self.searched += 1;
        self.searched <= MOST_FILES
    }

    fn read_library(&mut self, name: &str) {
        let Some(path) = self.file(Path::new(""), name) else { return };
        let mut bytes = Vec::new();
        let read = fs::File::open(&path).and_then(|file| file.take(MOST_BYTES).read_to_end(&mut bytes));
        if read.is_err() {
            return self.is_missing(Missing::NotRead(Refusal::Missing), name);
        }
        let folder = Path::new(name).parent().unwrap_or(Path::new("")).to_owned();
        for material in materials(&bytes) {
            for texture in textures(&material) {
                self.file(&folder, texture);
            }
            if self.defined.insert(material.name.clone()) {
                self.materials.push(file_material(&material));
            }
        }
    }

    fn is_missing(&mut self, missing: Missing, name: &str) {
        self.missing.entry(missing).or_default().insert(name.to_owned());
    }

    fn file(&mut self, folder: &Path, name: &str) -> Option<PathBuf> {
        if !self.may_search() {
            return None;
        }
        match (self.companions.find(folder, name), output_name(folder, name)) {
            (Ok(path), Some(output)) => {
                self.files.insert(output, path.clone());
                Some(path)
            }
            (Ok(path), None) => {
                self.is_missing(Missing::NotCopied, name);
                Some(path)
            }
            (Err(refusal), _) => {
                self.is_missing(Missing::NotRead(refusal), name);
                None
            }
        }
    }

    fn notes(&self, used: Option<&FaceLabels>) -> Vec<Note> {
        let quoted = |name: &String| format!("`{}`", shown(name.as_bytes()));
        let mut notes = Vec::new();
        let mut are_complete = true;
        for (missing, names) in &self.missing {
            let what = match missing {
                Missing::NotRead(refusal) => format!("{refusal}; the output goes without it"),
                Missing::NotCopied => {
                    let text =
                        "cannot be copied along with an output in another folder: its name leads out of it";
                    text.to_owned()
                }
            };
            are_complete &= *missing == Missing::NotCopied;
            let mut quoted = names.iter().map(quoted);
            let first = quoted.next().unwrap_or_default();
            let others: Vec<String> = quoted.take(MOST_NAMES).collect();
            let more = match names.len() - 1 {
                0 => String::new(),
                more => {
                    let rest = if more > others.len() { ", …" } else { "" };
                    format!(" (and {more} more like it: {}{rest})", others.join(", "))
                }
            };
            notes.push(Note::warning(Place::File, format!("{first} {what}{more}")));
        }
        if self.searched > MOST_FILES {
            let text = "the file names very many material libraries and textures; not all were looked for";
            notes.push(Note::warning(Place::File, text));
        }
        // If a library is missing, the definition may be in it.
        if are_complete && !self.defined.is_empty() {
            let mut names = used.into_iter().flat_map(|labels| &labels.names);
            notes.extend(names.find(|name| !self.defined.contains(*name)).map(|name| {
                Note::remark(format!("{} is used as a material, but no library defines it", quoted(name)))
            }));
        }
        notes
    }
}

/// Several names in one statement: each goes on to the next `.mtl`, or where there is none, to a blank.
fn split_names(names: &str) -> Vec<&str> {
    const EXTENSION: &str = ".mtl";
    let lower = names.to_ascii_lowercase();
    let ends = lower.match_indices(EXTENSION).map(|(at, _)| at + EXTENSION.len());
    let mut ends = ends.filter(|&end| !names[end..].starts_with(|next: char| !next.is_whitespace()));
    let mut found = Vec::new();
    let mut start = 0;
    loop {
        start = names.len() - names[start..].trim_start().len();
        if start == names.len() {
            return found;
        }
        let blank = || names[start..].find(char::is_whitespace).map_or(names.len(), |length| start + length);
        let end = ends.next().unwrap_or_else(blank);
        found.push(&names[start..end]);
        start = end;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn statements_name_one_file_or_several() {
        assert_eq!(split_names("a.mtl b.MTL"), ["a.mtl", "b.MTL"]);
        assert_eq!(split_names(" my file.mtl  other.mtl "), ["my file.mtl", "other.mtl"]);
        assert_eq!(split_names("cube.mat"), ["cube.mat"]);
        assert_eq!(split_names("a.mtlx b.mtl c"), ["a.mtlx b.mtl", "c"]);
        assert!(split_names("").is_empty());
    }

    #[test]
    fn what_is_found_goes_along_and_what_is_not_is_said() {
        let outer = tempfile::tempdir().unwrap();
        let folder = outer.path().join("in");
        fs::create_dir_all(folder.join("m")).unwrap();
        fs::write(
            folder.join("m/a.mtl"),
            "newmtl x\nmap_Kd t.png\nmap_d ../u.png\nrefl ../../in/v.png\nmap_Ks gone.png\n",
        )
        .unwrap();
        fs::write(folder.join("m/t.png"), "").unwrap();
        fs::write(folder.join("u.png"), "").unwrap();
        fs::write(folder.join("v.png"), "").unwrap();
        let text = b"m/a.mtl ../../b.mtl /etc/hostname";
        let statement = 0..text.len();
        let found = find(text, std::slice::from_ref(&statement), None, &folder, &ReadOptions::default());
        let names: Vec<&str> = found.files.iter().map(|file| &*file.name).collect();
        assert_eq!(names, ["m/a.mtl", "m/t.png", "u.png"]);
        let said: Vec<String> = found.notes.iter().map(ToString::to_string).collect();
        assert!(said.iter().any(|text| text.contains("outside")), "{said:?}");
        assert!(
            said.iter().any(|text| text.contains("`gone.png`") || text.contains("was not found")),
            "{said:?}"
        );
        assert!(said.iter().any(|text| text.contains("`../../in/v.png` cannot be copied")), "{said:?}");
    }
}
