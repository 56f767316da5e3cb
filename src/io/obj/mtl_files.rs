//! Material libraries: which materials they define, and which files have to go along with a copy of them.

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

/// Most libraries and textures that are looked for. Real files have a handful; a hostile one must not cost a million
/// file look-ups.
const MOST_FILES: usize = 1000;

/// Most names of missing files that a note lists beside the first.
const MOST_NAMES: usize = 10;

/// Largest library that is read.
const MOST_BYTES: u64 = 64 << 20;

/// What was found.
#[derive(Clone, Debug, Default)]
pub(super) struct Materials {
    /// Libraries and textures, to be copied beside an output in another folder.
    pub files: Vec<OutputFile>,
    /// What the libraries say, the first definition of each name.
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
    let mut search = Search::new(Companions::new(base, options));
    let mut seen = FxHashSet::default();
    for statement in statements {
        let names = name_text(&text[statement.clone()]);
        if seen.insert(names.clone()) {
            search.libraries(&names);
        }
    }
    search.finish(used)
}

/// What is said of libraries that a stream names, which has no folder that they could be in.
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
    looked_for: usize,
    files: BTreeMap<String, PathBuf>,
    /// Names of companions that are not read, by reason.
    refused: BTreeMap<Refusal, BTreeSet<String>>,
    /// Names for which a copy cannot be put where the output looks for it.
    out_of_place: BTreeSet<String>,
    defined: FxHashSet<String>,
    materials: Vec<FileMaterial>,
}

impl Search {
    fn new(companions: Companions) -> Self {
        Self {
            companions,
            looked_for: 0,
            files: BTreeMap::new(),
            refused: BTreeMap::new(),
            out_of_place: BTreeSet::new(),
            defined: FxHashSet::default(),
            materials: Vec::new(),
        }
    }

    /// One `mtllib` statement: one name with blanks in it, if there is such a file, or else several names.
    fn libraries(&mut self, names: &str) {
        if self.may_look() && self.companions.find(Path::new(""), names).is_ok() {
            return self.read_library(names);
        }
        for name in split_names(names) {
            if self.looked_for > MOST_FILES {
                return;
            }
            self.read_library(name);
        }
    }

    fn may_look(&mut self) -> bool {
        self.looked_for += 1;
        self.looked_for <= MOST_FILES
    }

    fn read_library(&mut self, name: &str) {
        let Some(path) = self.file(Path::new(""), name) else { return };
        let mut bytes = Vec::new();
        let read = fs::File::open(&path).and_then(|file| file.take(MOST_BYTES).read_to_end(&mut bytes));
        if read.is_err() {
            self.refused.entry(Refusal::Missing).or_default().insert(name.to_owned());
            return;
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

    fn file(&mut self, folder: &Path, name: &str) -> Option<PathBuf> {
        if !self.may_look() {
            return None;
        }
        match self.companions.find(folder, name) {
            Ok(path) => {
                match output_name(folder, name) {
                    Some(output) => drop(self.files.insert(output, path.clone())),
                    None => drop(self.out_of_place.insert(name.to_owned())),
                }
                Some(path)
            }
            Err(refusal) => {
                self.refused.entry(refusal).or_default().insert(name.to_owned());
                None
            }
        }
    }

    fn finish(self, used: Option<&FaceLabels>) -> Materials {
        let mut notes = Vec::new();
        let mut warn = |names: &BTreeSet<String>, what: &str| {
            let Some(first) = names.first() else { return };
            let others: Vec<String> = names
                .iter()
                .skip(1)
                .take(MOST_NAMES)
                .map(|name| format!("`{}`", shown(name.as_bytes())))
                .collect();
            let more = match names.len() - 1 {
                0 => String::new(),
                more if more > others.len() => {
                    format!(" (and {more} more like it: {}, …)", others.join(", "))
                }
                more => format!(" (and {more} more like it: {})", others.join(", ")),
            };
            notes.push(Note::warning(Place::File, format!("`{}` {what}{more}", shown(first.as_bytes()))));
        };
        for (refusal, names) in &self.refused {
            warn(names, &format!("{refusal}; the output goes without it"));
        }
        warn(
            &self.out_of_place,
            "cannot be copied along with an output in another folder: its name leads out of it",
        );
        if self.looked_for > MOST_FILES {
            let text = "the file names very many material libraries and textures; not all were looked for";
            notes.push(Note::warning(Place::File, text));
        }
        // Where a library is missing, so may be the definition.
        if self.refused.is_empty() && !self.defined.is_empty() {
            let undefined =
                used.into_iter().flat_map(|labels| &labels.names).find(|&name| !self.defined.contains(name));
            notes.extend(undefined.map(|name| {
                let name = shown(name.as_bytes());
                Note::remark(format!("`{name}` is used as a material, but no library defines it"))
            }));
        }
        let files = self.files.into_iter();
        let files =
            files.map(|(name, path)| OutputFile { name, content: OutputContent::CopyOf(path) }).collect();
        Materials { files, materials: self.materials, notes }
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
