//! The images and textures of a new file: files next to it, or views of its buffer.

use crate::io::appearance::omitted_note;
use crate::io::gltf::appearance::MaterialTextures;
use crate::io::gltf::buffers::percent_encoded;
use crate::io::gltf::json::quoted;
use crate::io::{FileImage, FileMaterial, Note, OutputContent, OutputFile, WriteError};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::sync::Arc;

/// The images of a new file, each with a texture of the same number.
#[derive(Default)]
pub struct NewTextures<'a> {
    /// Whether images are in the file.
    is_embedding: bool,
    /// Names of materials, and what is omitted of them.
    omitted: BTreeSet<(&'a str, String)>,
    /// By name.
    known: BTreeMap<String, (usize, Arc<OutputContent>)>,
    /// The JSON of each image.
    pub images: Vec<String>,
    /// Image files that belong with the output.
    pub companions: Vec<OutputFile>,
}

impl<'a> NewTextures<'a> {
    pub fn new(is_embedding: bool) -> Self {
        Self { is_embedding, ..Self::default() }
    }

    /// The textures of a material; none for vertices without texture coordinates. `embed` stores bytes and returns the number of
    /// their view.
    pub fn of_material(
        &mut self,
        material: &'a FileMaterial,
        has_uvs: bool,
        embed: &mut dyn FnMut(Vec<u8>) -> usize,
    ) -> Result<MaterialTextures, WriteError> {
        let FileMaterial { name, images, .. } = material;
        self.omitted.extend(images.omitted.iter().map(|what| (name.as_str(), what.clone())));
        let mut texture = |image: &Option<FileImage>| match image {
            None => Ok(None),
            Some(image) if has_uvs => self.number(image, embed).map(Some),
            Some(image) => {
                let text = format!("`{}` (a mesh has no texture coordinates)", image.name);
                self.omitted.insert((name, text));
                Ok(None)
            }
        };
        let base_colour = texture(&images.base_colour)?;
        let normal = texture(&images.normal)?.zip(images.normal.as_ref().map(|image| image.scale));
        Ok(MaterialTextures { base_colour, normal })
    }

    /// What is omitted of materials.
    pub fn note(&self) -> Option<Note> {
        omitted_note(self.omitted.iter().map(|(name, what)| (*name, what.clone())))
    }

    fn number(
        &mut self,
        image: &FileImage,
        embed: &mut dyn FnMut(Vec<u8>) -> usize,
    ) -> Result<usize, WriteError> {
        // Files of different folders may have the same name.
        let names = (2_u64..).map(|number| format!("{number}-{}", image.name));
        let mut names = std::iter::once(image.name.clone()).chain(names);
        let name = names.find(|name| self.known.get(name).is_none_or(|(_, other)| *other == image.content));
        let name = name.unwrap_or_default();
        if let Some((number, _)) = self.known.get(&name) {
            return Ok(*number);
        }
        let json = if self.is_embedding {
            let (view, kind) = (embed(bytes(image)?), image.kind.mime_type());
            format!("{{\"name\":{},\"bufferView\":{view},\"mimeType\":\"{kind}\"}}", quoted(&name))
        } else {
            let content = OutputContent::clone(&image.content);
            self.companions.push(OutputFile { name: name.clone(), content });
            format!("{{\"uri\":{}}}", quoted(&percent_encoded(&name)))
        };
        let number = self.images.len();
        self.images.push(json);
        self.known.insert(name, (number, image.content.clone()));
        Ok(number)
    }

    /// The JSON of the textures.
    pub fn textures(&self) -> Vec<String> {
        (0..self.images.len()).map(|image| format!("{{\"source\":{image}}}")).collect()
    }
}

fn bytes(image: &FileImage) -> Result<Vec<u8>, WriteError> {
    match &*image.content {
        OutputContent::Bytes(bytes) => Ok(bytes.clone()),
        OutputContent::CopyOf(path) => fs::read(path).map_err(|error| {
            WriteError::Unsupported(format!("the image {} cannot be read: {error}", path.display()))
        }),
    }
}
