//! A new material library.

use crate::io::appearance::omitted_note;
use crate::io::{
    FileImage, FileMaterial, FileReflection, Note, OutputContent, OutputFile, Part, WriteOptions,
};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

/// A material library, and the images that it names.
#[derive(Default)]
pub(super) struct Library {
    /// The library is the first; empty if there is none.
    pub files: Vec<OutputFile>,
    /// What MTL lacks.
    pub note: Option<Note>,
}

/// The library of the materials that parts use. There is none in a stream, which has no folder.
pub(super) fn library(parts: &[Part], materials: &[FileMaterial], options: &WriteOptions) -> Library {
    let labels = parts.iter().filter_map(|part| part.mesh.columns().materials.as_ref());
    let used: BTreeSet<&str> = labels.flat_map(|labels| labels.names.iter().map(String::as_str)).collect();
    let used: Vec<&FileMaterial> =
        materials.iter().filter(|material| used.contains(material.name.as_str())).collect();
    let Some(stem) = options.stem.as_ref().filter(|_| !used.is_empty()) else { return Library::default() };
    let mut text = concat!("# crease ", env!("CARGO_PKG_VERSION"), "\n").as_bytes().to_vec();
    let mut images = BTreeMap::new();
    for &material in &used {
        named(&mut text, "newmtl", &material.name);
        text.extend(statements(material).bytes());
        for (keyword, image) in [("map_Kd", &material.images.base_colour), ("norm", &material.images.normal)]
        {
            let Some(image) = image else { continue };
            texture(&mut text, keyword, image);
            images.insert(&image.name, &image.content);
        }
    }
    let library = OutputFile { name: format!("{stem}.mtl"), content: OutputContent::Bytes(text) };
    let images = images.into_iter();
    let images = images
        .map(|(name, content)| OutputFile { name: name.clone(), content: OutputContent::clone(content) });
    let lost = used.iter().flat_map(|material| {
        material.images.omitted.iter().map(|what| (material.name.as_str(), what.clone()))
    });
    Library { files: std::iter::once(library).chain(images).collect(), note: omitted_note(lost) }
}

/// The colour, the opacity and the exponent of the highlight: n = 2/r⁴ − 2 for roughness r, the inverse of what a new glTF has
/// (Walter et al. 2007, eq. 30), at most 1000, which is the largest of MTL.
fn statements(material: &FileMaterial) -> String {
    const LARGEST: f64 = 1000.0;
    let mut text = String::new();
    if let FileReflection::MetallicRoughness { base_colour: [r, g, b], roughness, .. } = material.reflection {
        let exponent = (2.0 / (roughness * roughness) / (roughness * roughness) - 2.0).min(LARGEST);
        let _ = writeln!(text, "Kd {r} {g} {b}\nNs {}", exponent as f32);
    }
    if let Some(opacity) = material.opacity.filter(|opacity| *opacity < 1.0) {
        let _ = writeln!(text, "d {opacity}");
    }
    text
}

fn texture(text: &mut Vec<u8>, keyword: &str, image: &FileImage) {
    let scale = if image.scale == 1.0 { String::new() } else { format!("-bm {} ", image.scale) };
    named(text, keyword, &format!("{scale}{}", image.name));
}

/// Appends a statement with a name, unless that is blank.
pub(super) fn named(out: &mut Vec<u8>, keyword: &str, name: &str) {
    if name.trim().is_empty() {
        return;
    }
    out.extend_from_slice(keyword.as_bytes());
    out.push(b' ');
    // A line end in a name would start a statement, and a backslash at its end would continue it.
    let name = name.trim().trim_end_matches('\\');
    out.extend(name.bytes().map(|byte| if matches!(byte, b'\n' | b'\r') { b' ' } else { byte }));
    out.push(b'\n');
}
