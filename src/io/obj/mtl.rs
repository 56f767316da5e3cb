//! Material libraries: their materials, and the files that a copy of the output needs.

use super::cursor::name_text;
use super::texture_statements::{Found, images, is_texture, textures};
use crate::io::appearance::as_written;
use crate::io::companion_files::{self, Refusal, output_name};
use crate::io::text::shown;
use crate::io::{
    FileMaterial, FileOptics, FileReflection, Note, OutputContent, OutputFile, Place, ReadOptions,
};
use rustc_hash::FxHashSet;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::{Cursor, Read};
use std::path::{Path, PathBuf};

/// The most libraries and textures that are searched for. Real files have a handful.
const MOST_FILES: usize = 1000;

/// The most names of missing files that a note lists after the first.
const MOST_NAMES: usize = 10;

const MOST_BYTES: u64 = 64 << 20;

#[derive(Clone, Debug, Default)]
pub(super) struct Materials {
    /// Libraries and textures, to be copied along with an output in another folder.
    pub files: Vec<OutputFile>,
    /// The materials, the first definition of each name.
    pub materials: Vec<FileMaterial>,
    pub notes: Vec<Note>,
}

/// Finds the libraries that `mtllib` statements name, and the textures that these name. `used` are the materials of faces.
pub(super) fn find(statements: &[String], used: &[String], base: &Path, options: &ReadOptions) -> Materials {
    let mut search = Search {
        base,
        options,
        searched: 0,
        left: options.limits.bytes,
        files: BTreeMap::new(),
        missing: BTreeMap::new(),
        not_copied: BTreeSet::new(),
        defined: FxHashSet::default(),
        materials: Vec::new(),
    };
    let mut seen = FxHashSet::default();
    for names in statements.iter().filter(|names| seen.insert(*names)) {
        search.libraries(names);
    }
    let notes = search.notes(used);
    let files = search.files.into_iter();
    let files = files.map(|(name, path)| OutputFile { name, content: OutputContent::CopyOf(path) }).collect();
    Materials { files, materials: search.materials, notes }
}

/// The note on the libraries of a stream, which has no folder to search for them.
pub(super) fn out_of_reach(statements: &[String]) -> Materials {
    let note = |first: &String| {
        let found =
            format!("{} was not read, because a stream has no folder (--root names one)", quoted(first));
        Note { more: statements.len() as u64 - 1, ..Note::warning(Place::File, found) }
    };
    Materials { notes: statements.first().map(note).into_iter().collect(), ..Materials::default() }
}

struct Search<'a> {
    base: &'a Path,
    options: &'a ReadOptions,
    searched: usize,
    /// Bytes of images that may still be written.
    left: u64,
    files: BTreeMap<String, PathBuf>,
    /// Names of files by the reason why they are not read.
    missing: BTreeMap<Refusal, BTreeSet<String>>,
    /// Names of files whose copy would be outside the output's folder.
    not_copied: BTreeSet<String>,
    defined: FxHashSet<String>,
    materials: Vec<FileMaterial>,
}

impl Search<'_> {
    /// One `mtllib` statement: one name with blanks in it, if there is such a file, or else several names.
    fn libraries(&mut self, names: &str) {
        if self.may_search() && self.find(Path::new(""), names).is_ok() {
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
            return self.is_missing(Refusal::Missing, name);
        }
        let folder = Path::new(name).parent().unwrap_or(Path::new("")).to_owned();
        for material in materials(&bytes) {
            let mut found = Found::default();
            for texture in textures(&material) {
                if let Some(path) = self.file(&folder, texture) {
                    found.add(texture, output_name(&folder, texture), path, &mut self.left);
                }
            }
            if self.defined.insert(material.name.clone()) {
                self.materials.push(file_material(&material, &found));
            }
        }
    }

    fn find(&self, folder: &Path, name: &str) -> Result<PathBuf, Refusal> {
        companion_files::find(self.base, folder, name, self.options)
    }

    fn is_missing(&mut self, refusal: Refusal, name: &str) {
        self.missing.entry(refusal).or_default().insert(name.to_owned());
    }

    fn file(&mut self, folder: &Path, name: &str) -> Option<PathBuf> {
        if !self.may_search() {
            return None;
        }
        let path = match self.find(folder, name) {
            Ok(path) => path,
            Err(refusal) => {
                self.is_missing(refusal, name);
                return None;
            }
        };
        match output_name(folder, name) {
            Some(output) => drop(self.files.insert(output, path.clone())),
            None => drop(self.not_copied.insert(name.to_owned())),
        }
        Some(path)
    }

    fn notes(&self, used: &[String]) -> Vec<Note> {
        let missing = self.missing.iter();
        let missing = missing.map(|(refusal, names)| (names, refusal.in_note()));
        let text = "is not copied next to a new OBJ, because its name leads out of the folder";
        let not_copied = Some((&self.not_copied, text.to_owned())).filter(|(names, _)| !names.is_empty());
        let mut notes: Vec<Note> =
            missing.chain(not_copied).map(|(names, text)| listed(names, &text)).collect();
        if self.searched > MOST_FILES {
            let text =
                "the file names more than 1000 material libraries and textures; the others were not checked";
            notes.push(Note::warning(Place::File, text));
        }
        // If a library is missing, the definition may be in it.
        if self.missing.is_empty() && !self.defined.is_empty() {
            let undefined = used.iter().find(|name| !self.defined.contains(*name));
            let text =
                |name| Note::remark(format!("material {} is used, but no library defines it", quoted(name)));
            notes.extend(undefined.map(text));
        }
        notes
    }
}

fn quoted(name: &String) -> String {
    format!("`{}`", shown(name.as_bytes()))
}

/// A warning about the first of some files, with the names of the next ones.
fn listed(names: &BTreeSet<String>, text: &str) -> Note {
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
    Note::warning(Place::File, format!("{first} {text}{more}"))
}

/// Several names in one statement: each ends with the next `.mtl`, or if there is none, at a blank.
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

/// Behind the keyword of a statement whose numbers make no sense.
const NOT_UNDERSTOOD: char = '?';

/// The materials of a library. Statements that are understood here are handed on with the numbers that make sense: `tobj` panics
/// at a colour with fewer than three, and gives up at bytes that are not UTF-8 and at numbers that are none.
fn materials(library: &[u8]) -> Vec<tobj::Material> {
    let mut kept = String::new();
    for line in library.split(|&byte| matches!(byte, b'\n' | b'\r')) {
        let line = name_text(line.trim_ascii());
        let Some((word, argument)) = line.split_once(char::is_whitespace) else { continue };
        let argument = argument.trim();
        let is_ignored = argument.is_empty() || word.starts_with('#');
        let argument = match word {
            _ if is_ignored => None,
            "newmtl" => Some(argument.to_owned()),
            "Ka" | "Kd" | "Ks" | "Ke" | "Tf" => colour(argument),
            // Any number: an impossible refractive index is reported where it matters.
            "Ni" => {
                let index = argument.split_whitespace().next().and_then(|word| word.parse::<f32>().ok());
                index.map(|index| index.to_string())
            }
            "Ns" | "d" | "Tr" => numbers(argument).next().map(|number| number.to_string()),
            "illum" => argument.parse::<u8>().ok().map(|model| model.to_string()),
            // Textures, and what is named as omitted.
            _ => Some(argument.to_owned()),
        };
        match argument {
            Some(argument) => kept.push_str(&format!("{word} {argument}\n")),
            // To be named as omitted.
            None if !is_ignored => kept.push_str(&format!("{word}{NOT_UNDERSTOOD} yes\n")),
            None => {}
        }
    }
    tobj::load_mtl_buf(&mut Cursor::new(kept)).map(|(materials, _)| materials).unwrap_or_default()
}

/// The finite numbers that are not negative, up to whatever else follows.
fn numbers(argument: &str) -> impl Iterator<Item = f32> {
    let number = |word: &str| word.parse().ok().filter(|number: &f32| number.is_finite() && *number >= 0.0);
    argument.split_whitespace().map_while(number)
}

/// Three numbers, or one for all three. Spectral files and CIE colours are not supported.
fn colour(argument: &str) -> Option<String> {
    let numbers: Vec<f32> = numbers(argument).collect();
    match numbers[..] {
        // Not if another word follows, which should be a number.
        [grey] if argument.split_whitespace().count() == 1 => Some(format!("{grey} {grey} {grey}")),
        [r, g, b, ..] => Some(format!("{r} {g} {b}")),
        _ => None,
    }
}

fn file_material(material: &tobj::Material, found: &Found) -> FileMaterial {
    let colour = |colour: Option<[f32; 3]>| colour.map(|colour| colour.map(as_written));
    // Models 0 and 1 have no highlight.
    let is_matte = material.illumination_model.is_some_and(|model| model < 2);
    let transparency = material.unknown_param.get("Tr").and_then(|value| value.parse::<f32>().ok());
    let opacity = material.dissolve.or(transparency.map(|value| 1.0 - value)).map(as_written);
    FileMaterial {
        name: material.name.clone(),
        reflection: FileReflection::Phong {
            ambient: colour(material.ambient),
            diffuse: colour(material.diffuse),
            specular: if is_matte { Some([0.0; 3]) } else { colour(material.specular) },
            exponent: material.shininess.map(as_written),
        },
        opacity,
        optics: optics(material, opacity),
        textures: textures(material).len(),
        images: {
            let mut images = images(material, found);
            images.omitted.extend(omitted(material));
            images
        },
    }
}

/// The statements with an effect that glTF lacks. Numbers of zero, filters and refractive indices of one, and the
/// illumination models without rays have none.
fn omitted(material: &tobj::Material) -> Vec<String> {
    let differs = |value: Option<[f32; 3]>| value.is_some_and(|value| value != [0.0; 3]);
    let known = [
        ("Ka", differs(material.ambient)),
        ("Ks", differs(material.specular)),
        ("Ke", differs(material.emissive)),
        ("Ni", material.optical_density.is_some_and(|index| index != 1.0)),
        ("illum", material.illumination_model.is_some_and(|model| model > 2)),
    ];
    let has_effect = |(word, value): &(&String, &String)| {
        let neutral = if *word == "Tf" { 1.0 } else { 0.0 };
        let is_neutral = |word: &str| word.parse() == Ok(neutral);
        !is_texture(word) && *word != "Tr" && !value.split_whitespace().all(is_neutral)
    };
    let known = known.into_iter().filter(|(_, has_effect)| *has_effect).map(|(word, _)| word.to_owned());
    let others = material.unknown_param.iter().filter(has_effect).map(|(word, _)| {
        let known = word.strip_suffix(NOT_UNDERSTOOD);
        known.map_or_else(|| shown(word.as_bytes()), |known| format!("{known} (not understood)"))
    });
    // Not in the order of a hash map.
    known.chain(others).collect::<BTreeSet<_>>().into_iter().collect()
}

/// What the illumination models 3 to 9 add (*Object files*, Wavefront, 1992): all mirror Ks; 4 and 9 transmit what the opacity
/// leaves and do not bend it; 6 and 7 transmit (1 − Ks) Tf and bend it by Ni. Fresnel's share, which 5 and 7 ask for, is
/// computed for all transmitted light.
fn optics(material: &tobj::Material, opacity: Option<f64>) -> FileOptics {
    let model = material.illumination_model.unwrap_or(2);
    if !(3..=9).contains(&model) {
        return FileOptics::default();
    }
    let specular = material.specular.unwrap_or([0.0; 3]).map(as_written);
    let filter =
        material.unknown_param.get("Tf").map(|value| numbers(value).map(as_written).collect::<Vec<_>>());
    let filter = match filter.as_deref() {
        Some(&[r, g, b, ..]) => [r, g, b],
        _ => [1.0; 3],
    };
    let clear = 1.0 - opacity.unwrap_or(1.0);
    let (transmit, ior) = match model {
        4 | 9 => (filter.map(|filter| filter * clear), 1.0),
        6 | 7 => {
            let passed = [0, 1, 2].map(|k| filter[k] * (1.0 - specular[k]).max(0.0));
            (passed, material.optical_density.map_or(1.0, as_written))
        }
        _ => ([0.0; 3], 1.0),
    };
    FileOptics { reflect: specular, transmit, ior, ..FileOptics::default() }
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
        let statement = "m/a.mtl ../../b.mtl /etc/hostname".to_owned();
        let found = find(&[statement], &[], &folder, &ReadOptions::default());
        let names: Vec<&str> = found.files.iter().map(|file| &*file.name).collect();
        assert_eq!(names, ["m/a.mtl", "m/t.png", "u.png"]);
        let said: Vec<String> = found.notes.iter().map(ToString::to_string).collect();
        assert!(said.iter().any(|text| text.contains("outside")), "{said:?}");
        assert!(
            said.iter().any(|text| text.contains("`gone.png`") || text.contains("was not found")),
            "{said:?}"
        );
        assert!(said.iter().any(|text| text.contains("`../../in/v.png` is not copied")), "{said:?}");
    }

    #[test]
    fn broken_libraries_do_not_stop_anything() {
        let library =
            b"newmtl \nKa 0.5\nnewmtl red\nKd 1 x\nNs\nillum 99999\nmap_Kd -s 1 1 -bm 0.2 my tex.png\n\
            \xff\xfe\nbump -o 0 b.png\nmap_Kd\nrefl -type sphere r.png\r\nnewmtl gr\xfcn\rmap_d t.png";
        let found = materials(library);
        let names: Vec<&str> = found.iter().map(|material| &*material.name).collect();
        assert_eq!(names, ["red", "grün"]);
        assert_eq!(textures(&found[0]).into_iter().collect::<Vec<_>>(), ["b.png", "my tex.png", "r.png"]);
        assert_eq!(textures(&found[1]).into_iter().collect::<Vec<_>>(), ["t.png"]);
    }

    #[test]
    fn illumination_models_mirror_and_transmit() {
        let library = b"newmtl matte\nKs 0.5 0.5 0.5\nNi 1.5\nTf 0 0 0\nillum 2\n\
            newmtl mirror\nKs 0.5 0.25 1\nillum 3\n\
            newmtl pane\nKs 0.1 0.1 0.1\nd 0.25\nTf 1 0.5 0\nNi 1.5\nillum 4\n\
            newmtl glass\nKs 0.25 0.25 0.25\nTf 1 0.5 0\nNi 1.5\nillum 7\nnewmtl clear\nillum 6\n";
        let found: Vec<FileOptics> =
            materials(library).iter().map(|it| file_material(it, &Found::default()).optics).collect();
        let none = FileOptics::default();
        let mirror = FileOptics { reflect: [0.5, 0.25, 1.0], ..none };
        let pane = FileOptics { reflect: [0.1; 3], transmit: [0.75, 0.375, 0.0], ..none };
        let glass = FileOptics { reflect: [0.25; 3], transmit: [0.75, 0.375, 0.0], ior: 1.5, ..none };
        let clear = FileOptics { transmit: [1.0; 3], ..none };
        assert_eq!(found, [none, mirror, pane, glass, clear]);
    }

    #[test]
    fn statements_that_make_no_sense_are_left_out() {
        let library = b"newmtl a\nKd 0.1 0.6 1 # red\nKa 0.5\nKs -1 0 0\nNs 1e40\nd 0.25\nillum 2\n\
            newmtl b\nKd spectral a.rfl\nKs 1 1 1\nNs 10\nillum 1\nmap_Kd t.png\nTr 0.25\n\
            newmtl c\nKd 1 nan 1\nKs 1 2\nillum 999\n";
        let found: Vec<FileMaterial> =
            materials(library).iter().map(|it| file_material(it, &Found::default())).collect();
        let plain = |ambient, diffuse, specular, exponent| FileReflection::Phong {
            ambient,
            diffuse,
            specular,
            exponent,
        };
        let expected = [
            // As written, not as the nearest single.
            (plain(Some([0.5; 3]), Some([0.1, 0.6, 1.0]), None, None), Some(0.25), 0),
            (plain(None, None, Some([0.0; 3]), Some(10.0)), Some(0.75), 1),
            (plain(None, None, None, None), None, 0),
        ];
        assert_eq!(found.len(), expected.len());
        for (found, (reflection, opacity, textures)) in found.iter().zip(expected) {
            let name = &found.name;
            assert_eq!(
                (found.reflection, found.opacity, found.textures),
                (reflection, opacity, textures),
                "{name}"
            );
        }
    }
}
