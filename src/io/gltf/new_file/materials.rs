//! The materials of a new file, each written once, and their images and textures: files next to it, or views of its buffer.

use super::File;
use crate::io::appearance::omitted_note;
use crate::io::gltf::appearance::{MaterialTextures, material_members};
use crate::io::gltf::buffers::percent_encoded;
use crate::io::gltf::json::quoted;
use crate::io::{
    FileImage, FileImages, FileMaterial, FileOptics, FileReflection, MaterialFallback, Note, OutputContent,
    OutputFile, WriteError,
};
use crate::mesh::{FaceLabels, Mesh};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::sync::Arc;

impl<'a> File<'a> {
    /// The normal texture of a material, if the mesh has the coordinates for it.
    pub(super) fn normal_texture(&self, mesh: &Mesh, label: u32) -> Option<&'a FileImage> {
        let columns = mesh.columns();
        let name = columns.materials.as_ref()?.names.get(label as usize)?;
        columns.uvs.as_ref()?;
        self.known.get(name.as_str())?.images.normal.as_ref()
    }

    pub(super) fn material(
        &mut self,
        labels: &'a FaceLabels,
        label: u32,
        has_uvs: bool,
    ) -> Result<usize, WriteError> {
        let name = labels.names[label as usize].as_str();
        let known = self.known.get(name).copied();
        let has_images = known.is_some_and(|known| known.images.has_any());
        let key = (name, has_uvs || !has_images);
        if let Some(number) = self.material_numbers.get(&key) {
            return Ok(*number);
        }
        let mut members = String::new();
        if let Some(known) = known {
            let Self { views, blob, textures, .. } = self;
            let mut embed = |bytes: Vec<u8>| {
                let length = bytes.len();
                let offset = blob.push(bytes);
                views.push(format!("{{\"buffer\":0,\"byteOffset\":{offset},\"byteLength\":{length}}}"));
                views.len() - 1
            };
            members = material_members(known, textures.of_material(known, has_uvs, &mut embed)?);
        }
        self.materials.push(format!("{{\"name\":{}{members}}}", quoted(name)));
        self.material_numbers.insert(key, self.materials.len() - 1);
        Ok(self.materials.len() - 1)
    }

    /// The material of faces without one. Colours of vertices multiply its base colour.
    pub(super) fn fallback_material(&mut self, is_coloured: bool) -> Option<usize> {
        if self.fallback == MaterialFallback::Omit {
            return None;
        }
        let next = self.materials.len();
        let number = *self.fallback_numbers[usize::from(is_coloured)].get_or_insert(next);
        if number == next {
            let (name, grey) = if is_coloured { ("default, coloured", 1.0) } else { ("default", 0.8) };
            let reflection = FileReflection::MetallicRoughness {
                base_colour: [grey; 3],
                metallic: 0.0,
                roughness: 0.6,
                unlit: false,
            };
            let plastic = FileMaterial {
                name: name.into(),
                reflection,
                opacity: None,
                optics: FileOptics::default(),
                textures: 0,
                images: FileImages::default(),
            };
            let members = material_members(&plastic, MaterialTextures::default());
            self.materials.push(format!("{{\"name\":{}{members}}}", quoted(name)));
        }
        Some(number)
    }
}

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
