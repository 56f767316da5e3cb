//! The images of a document's materials, for formats that have base colour and normal textures only.

use crate::io::companion_files::output_name;
use crate::io::gltf::appearance::appearance;
use crate::io::gltf::buffers::{Uri, decode_data};
use crate::io::gltf::document::GltfDocument;
use crate::io::gltf::json::Value;
use crate::io::{FileImage, FileImages, FileMaterial, FileReflection, ImageKind, OutputContent};
use rustc_hash::FxHashMap;
use std::fs;
use std::io::Read;
use std::path::Path;
use std::sync::Arc;

/// The materials of a document with their images, and with the names of the members that MTL lacks. `stem` begins the names of
/// images that are not files.
pub(in crate::io) fn materials_with_images(document: &GltfDocument, stem: Option<&str>) -> Vec<FileMaterial> {
    let mut found = appearance(document).materials;
    let mut images = Images { document, stem: stem.unwrap_or_default(), known: FxHashMap::default() };
    for material in &mut found {
        if let Some(&number) = document.materials.get(&material.name) {
            material.images = images.of_material(document.records.materials[number], material);
        }
    }
    found
}

type Found = Result<FileImage, &'static str>;

struct Images<'a> {
    document: &'a GltfDocument,
    stem: &'a str,
    /// Each image is decoded once.
    known: FxHashMap<usize, Found>,
}

impl Images<'_> {
    fn of_material(&mut self, object: Value, material: &FileMaterial) -> FileImages {
        let json = &self.document.records.json;
        let mut images = FileImages::default();
        let member = |object, name: &str| json.member(object, name);
        let surface = member(object, "pbrMetallicRoughness");
        let mut texture = |name: &str, reference: Option<Value>, omitted: &mut Vec<String>| match self
            .texture(reference?)
        {
            Ok(image) => Some(image),
            Err(why) => {
                omitted.push(format!("{name} ({why})"));
                None
            }
        };
        let base_colour = surface.and_then(|surface| member(surface, "baseColorTexture"));
        images.base_colour = texture("baseColorTexture", base_colour, &mut images.omitted);
        images.normal = texture("normalTexture", member(object, "normalTexture"), &mut images.omitted);
        // A material without the member is a metal.
        if matches!(material.reflection, FileReflection::MetallicRoughness { metallic, .. } if metallic > 0.0)
        {
            images.omitted.push("metallicFactor".to_owned());
        }
        let names = |object: Option<Value>| {
            object.into_iter().flat_map(|object| json.members(object)).filter_map(|(key, value)| {
                let is_default = matches!(json.raw(value), "false" | "\"OPAQUE\"" | "\"BLEND\"");
                json.string(key).filter(|_| !is_default)
            })
        };
        const KEPT: [&str; 9] = [
            "name",
            "extras",
            "extensions",
            "pbrMetallicRoughness",
            "baseColorFactor",
            "baseColorTexture",
            "metallicFactor",
            "roughnessFactor",
            "normalTexture",
        ];
        let all = names(surface).chain(names(Some(object))).chain(names(member(object, "extensions")));
        images.omitted.extend(all.filter(|name| !KEPT.contains(&&**name)).map(String::from));
        images
    }

    /// The image that a member refers to, or why there is none.
    fn texture(&mut self, reference: Value) -> Found {
        let json = &self.document.records.json;
        let integer = |object, name| json.integer_member(object, name);
        if integer(reference, "texCoord").is_some_and(|set| set > 0) {
            return Err("uses other texture coordinates than TEXCOORD_0");
        }
        let item =
            |list, number: Option<u64>| json.items(json.root(), list).nth(usize::try_from(number?).ok()?);
        let texture = item("textures", integer(reference, "index")).ok_or("has no texture")?;
        let source = integer(texture, "source");
        let image = item("images", source).ok_or("has no PNG or JPEG")?;
        let number = source.unwrap_or_default() as usize;
        if !self.known.contains_key(&number) {
            let found = self.image(number, image);
            self.known.insert(number, found);
        }
        let found = self.known[&number].clone()?;
        let scale = json.member(reference, "scale").and_then(|scale| json.number(scale));
        Ok(FileImage { scale: scale.filter(|scale| scale.is_finite()).unwrap_or(1.0), ..found })
    }

    fn image(&self, number: usize, object: Value) -> Found {
        const OTHER: &str = "is not a PNG or JPEG";
        let document = self.document;
        let json = &document.records.json;
        let uri = json.member(object, "uri").and_then(|uri| json.string(uri));
        let (name, content, kind) = match uri.as_deref().map(Uri::parse) {
            Some(Uri::Elsewhere) => return Err("is not a file in this folder"),
            Some(Uri::File(name)) => {
                let file = document.images.iter().find(|(known, _)| *known == name);
                let (_, path) = file.ok_or("was not found")?;
                let mut head = Vec::new();
                fs::File::open(path)
                    .and_then(|file| file.take(ImageKind::HEAD as u64).read_to_end(&mut head))
                    .map_err(|_| "cannot be read")?;
                let bare = || path.file_name().map(|name| name.to_string_lossy().into_owned());
                let name = output_name(Path::new(""), &name).or_else(bare).ok_or("was not found")?;
                (name, OutputContent::CopyOf(path.clone()), ImageKind::of(&head))
            }
            data => {
                let bytes = match data {
                    Some(_) => decode_data(&uri.unwrap_or_default()).map_err(|_| "has a damaged data URI")?,
                    None => self.view_bytes(object).ok_or("has no data")?.to_vec(),
                };
                let kind = ImageKind::of(&bytes);
                (format!("{}.image{number}", self.stem), OutputContent::Bytes(bytes), kind)
            }
        };
        Ok(FileImage::new(name, Arc::new(content), kind.ok_or(OTHER)?, 1.0))
    }

    fn view_bytes(&self, object: Value) -> Option<&[u8]> {
        let records = &self.document.records;
        let number = records.json.integer_member(object, "bufferView")?;
        let view = records.views.get(usize::try_from(number).ok()?)?;
        let bytes = self.document.buffers.bytes(view.buffer)?;
        let start = usize::try_from(view.offset).ok()?;
        bytes.get(start..start.checked_add(usize::try_from(view.length).ok()?)?)
    }
}
