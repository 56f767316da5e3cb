//! The texture statements of a material: their files, and which of them glTF can have.

use crate::io::text::shown;
use crate::io::{FileImage, FileImages, ImageKind, OutputContent};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

pub(super) fn is_texture(word: &str) -> bool {
    let word = word.to_ascii_lowercase();
    // `map_aat` is a switch, without a file.
    word.starts_with("map_") && word != "map_aat"
        || ["bump", "norm", "disp", "decal", "refl"].contains(&&*word)
}

/// The texture statements of a material by keyword, in a fixed order. `tobj` keeps one of `map_Bump`, `map_bump` and `bump`.
fn statements(material: &tobj::Material) -> BTreeMap<&str, &str> {
    let known = [
        ("map_Ka", &material.ambient_texture),
        ("map_Kd", &material.diffuse_texture),
        ("map_Ks", &material.specular_texture),
        ("map_Bump", &material.normal_texture),
        ("map_Ns", &material.shininess_texture),
        ("map_d", &material.dissolve_texture),
    ];
    let known = known.into_iter().filter_map(|(word, value)| Some((word, value.as_deref()?)));
    let others = material.unknown_param.iter().filter(|(word, _)| is_texture(word));
    known.chain(others.map(|(word, value)| (word.as_str(), value.as_str()))).collect()
}

/// The texture files of a material, in a fixed order.
pub(super) fn textures(material: &tobj::Material) -> BTreeSet<&str> {
    let names = statements(material).into_values().map(|value| Arguments::of(value).file);
    names.filter(|name| !name.is_empty()).collect()
}

/// What a texture statement has after its keyword.
struct Arguments<'a> {
    /// Such as `-bm` and `0.5`.
    options: Vec<(&'a str, &'a str)>,
    /// The file name, which may have blanks.
    file: &'a str,
}

impl<'a> Arguments<'a> {
    fn of(value: &'a str) -> Self {
        let (mut options, mut rest) = (Vec::new(), value.trim());
        while let Some((option, behind)) =
            rest.split_once(char::is_whitespace).filter(|(option, _)| option.starts_with('-'))
        {
            let most = match option {
                "-o" | "-s" | "-t" => 3,
                "-mm" => 2,
                _ => 1,
            };
            let arguments = behind.trim_start();
            rest = arguments;
            for argument in 0..most {
                let (word, behind) = rest.split_once(char::is_whitespace).unwrap_or((rest, ""));
                // All but the first of up to three numbers are optional.
                if argument > 0 && word.parse::<f32>().is_err() {
                    break;
                }
                rest = behind.trim_start();
            }
            options.push((option, arguments[..arguments.len() - rest.len()].trim_end()));
        }
        Self { options, file: rest }
    }

    /// The factor of a bump or normal map.
    fn scale(&self) -> f64 {
        let value = self.options.iter().find(|(option, _)| *option == "-bm").map(|(_, value)| value);
        value.and_then(|value| value.parse().ok()).filter(|scale: &f64| scale.is_finite()).unwrap_or(1.0)
    }

    /// The other options, which glTF has no counterpart for.
    fn others(&self) -> impl Iterator<Item = &'a str> {
        self.options.iter().map(|(option, _)| *option).filter(|option| *option != "-bm")
    }
}

/// The texture files that were found, by the name in the statement.
#[derive(Default)]
pub(super) struct Found(BTreeMap<String, File>);

struct File {
    name: String,
    path: PathBuf,
    kind: Option<ImageKind>,
    /// A PNG without colours, which is no normal map.
    is_grey: bool,
    /// More bytes than the limits allow.
    is_large: bool,
}

impl Found {
    /// Adds a file, which is opened for its first bytes. `name` is that of a copy of it, `None` if that would be outside the folder
    /// of the output. `left` are the bytes of images that the limits still allow.
    pub fn add(&mut self, texture: &str, name: Option<String>, path: PathBuf, left: &mut u64) {
        let bare = |path: &Path| path.file_name().map(|name| name.to_string_lossy().into_owned());
        let Some(name) = name.or_else(|| bare(&path)) else { return };
        let mut head = Vec::new();
        let opened = fs::File::open(&path);
        let size = opened.as_ref().ok().and_then(|file| Some(file.metadata().ok()?.len())).unwrap_or(0);
        let read = opened.and_then(|file| file.take(ImageKind::HEAD as u64).read_to_end(&mut head));
        let kind = ImageKind::of(&head).filter(|_| read.is_ok());
        // The colour types 0 and 4 of the header chunk (PNG specification, 11.2.1).
        let is_grey = kind == Some(ImageKind::Png) && matches!(head.get(25), Some(0 | 4));
        let rest = left.checked_sub(size);
        *left = rest.unwrap_or(*left);
        self.0.insert(texture.to_owned(), File { name, path, kind, is_grey, is_large: rest.is_none() });
    }
}

/// The images of a material that glTF can have, and what it cannot have.
pub(super) fn images(material: &tobj::Material, found: &Found) -> FileImages {
    let mut images = FileImages::default();
    let statements = statements(material);
    let is_norm = |word: &str| word.eq_ignore_ascii_case("norm");
    let has_norm = statements.keys().any(|word| is_norm(word));
    for (word, value) in statements {
        let arguments = Arguments::of(value);
        let is_bump = word == "map_Bump" && !has_norm;
        let target = match word {
            "map_Kd" => &mut images.base_colour,
            _ if is_bump || is_norm(word) => &mut images.normal,
            _ => {
                images.omitted.push(word.to_owned());
                continue;
            }
        };
        match image(&arguments, is_bump, found) {
            Ok(image) => {
                *target = Some(image);
                images.omitted.extend(arguments.others().map(|option| format!("{option} of {word}")));
            }
            Err(why) => {
                let file = shown(arguments.file.as_bytes());
                images.omitted.push(format!("{word} (`{file}` {why})"));
            }
        }
    }
    images
}

fn image(arguments: &Arguments<'_>, is_bump: bool, found: &Found) -> Result<FileImage, &'static str> {
    let file = found.0.get(arguments.file).ok_or("was not read")?;
    let kind = file.kind.ok_or("is not a PNG or JPEG")?;
    if file.is_large {
        return Err("exceeds the size limit of one input");
    }
    if is_bump && file.is_grey {
        return Err("is a height map, not a normal map");
    }
    let content = OutputContent::CopyOf(file.path.clone());
    Ok(FileImage::new(file.name.clone(), content.into(), kind, arguments.scale()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_precede_the_file() {
        let arguments = |value: &'static str| {
            let found = Arguments::of(value);
            (found.options.clone(), found.file, found.scale())
        };
        assert_eq!(arguments("a b.png"), (vec![], "a b.png", 1.0));
        assert_eq!(
            arguments(" -bm 0.5 -clamp on a.png "),
            (vec![("-bm", "0.5"), ("-clamp", "on")], "a.png", 0.5)
        );
        assert_eq!(arguments("-s 1 2 a.png"), (vec![("-s", "1 2")], "a.png", 1.0));
        assert_eq!(arguments("-o 1 2 3 4.png"), (vec![("-o", "1 2 3")], "4.png", 1.0));
        assert_eq!(arguments("-bm inf a.png").2, 1.0);
        assert_eq!(arguments("-s"), (vec![], "-s", 1.0));
    }
}
