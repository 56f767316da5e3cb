//! The materials of MTL libraries, parsed by `tobj`.

use super::cursor::name_text;
use crate::io::appearance::as_written;
use crate::io::{FileMaterial, FileReflection};
use std::collections::BTreeSet;
use std::io::Cursor;

/// The materials of a library. Only statements that are understood here are handed on, with the numbers that make
/// sense: `tobj` panics at a colour with fewer than three, and gives up at bytes that are not UTF-8 and at numbers that
/// are none.
pub(super) fn materials(library: &[u8]) -> Vec<tobj::Material> {
    let mut kept = String::new();
    for line in library.split(|&byte| matches!(byte, b'\n' | b'\r')) {
        let line = name_text(line.trim_ascii());
        let Some((word, argument)) = line.split_once(char::is_whitespace) else { continue };
        let argument = argument.trim();
        let argument = match word {
            _ if argument.is_empty() => None,
            "newmtl" => Some(argument.to_owned()),
            "Ka" | "Kd" | "Ks" => colour(argument),
            "Ns" | "d" | "Tr" => numbers(argument).next().map(|number| number.to_string()),
            "illum" => argument.parse::<u8>().ok().map(|model| model.to_string()),
            word => is_texture(word).then(|| argument.to_owned()),
        };
        if let Some(argument) = argument {
            kept.push_str(&format!("{word} {argument}\n"));
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

fn is_texture(word: &str) -> bool {
    let word = word.to_ascii_lowercase();
    word.starts_with("map_") || ["bump", "norm", "disp", "decal", "refl"].contains(&&*word)
}

/// A material as plain data.
pub(super) fn file_material(material: &tobj::Material) -> FileMaterial {
    let colour = |colour: Option<[f32; 3]>| colour.map(|colour| colour.map(as_written));
    // Models 0 and 1 have no highlight.
    let is_matte = material.illumination_model.is_some_and(|model| model < 2);
    let transparency = material.unknown_param.get("Tr").and_then(|value| value.parse::<f32>().ok());
    FileMaterial {
        name: material.name.clone(),
        reflection: FileReflection::Phong {
            ambient: colour(material.ambient),
            diffuse: colour(material.diffuse),
            specular: if is_matte { Some([0.0; 3]) } else { colour(material.specular) },
            exponent: material.shininess.map(as_written),
        },
        opacity: material.dissolve.or(transparency.map(|value| 1.0 - value)).map(as_written),
        textures: textures(material).len(),
    }
}

/// The texture files of a material, in a fixed order.
pub(super) fn textures(material: &tobj::Material) -> BTreeSet<&str> {
    let known = [
        &material.ambient_texture,
        &material.diffuse_texture,
        &material.specular_texture,
        &material.normal_texture,
        &material.shininess_texture,
        &material.dissolve_texture,
    ];
    let others = material.unknown_param.iter().filter(|(word, _)| is_texture(word)).map(|(_, value)| value);
    known
        .into_iter()
        .flatten()
        .chain(others)
        .map(|value| without_options(value))
        .filter(|name| !name.is_empty())
        .collect()
}

/// The file name of a texture statement, which may have blanks and options such as `-bm 0.5` in front.
fn without_options(value: &str) -> &str {
    let mut rest = value.trim();
    while let Some((option, behind)) =
        rest.split_once(char::is_whitespace).filter(|(option, _)| option.starts_with('-'))
    {
        let most = match option {
            "-o" | "-s" | "-t" => 3,
            "-mm" => 2,
            _ => 1,
        };
        rest = behind.trim_start();
        for argument in 0..most {
            let (word, behind) = rest.split_once(char::is_whitespace).unwrap_or((rest, ""));
            // All but the first of up to three numbers are optional.
            if argument > 0 && word.parse::<f32>().is_err() {
                break;
            }
            rest = behind.trim_start();
        }
    }
    rest
}

#[cfg(test)]
mod tests {
    use super::*;

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
    fn statements_that_make_no_sense_are_left_out() {
        let library = b"newmtl a\nKd 0.1 0.6 1 # red\nKa 0.5\nKs -1 0 0\nNs 1e40\nd 0.25\nillum 2\n\
            newmtl b\nKd spectral a.rfl\nKs 1 1 1\nNs 10\nillum 1\nmap_Kd t.png\nTr 0.25\n\
            newmtl c\nKd 1 nan 1\nKs 1 2\nillum 999\n";
        let found: Vec<FileMaterial> = materials(library).iter().map(file_material).collect();
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
