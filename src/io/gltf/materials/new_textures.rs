//! The images and textures of a new file: files next to it, or views of its buffer.

use crate::io::gltf::buffers::percent_encoded;
use crate::io::gltf::json::quoted;
use crate::io::{FileImage, OutputContent, OutputFile, WriteError};
use std::collections::BTreeMap;
use std::fs;
use std::sync::Arc;

/// The images of a new file, each with a texture of the same number.
#[derive(Default)]
pub struct NewTextures {
    /// By name.
    known: BTreeMap<String, (usize, Arc<OutputContent>)>,
    /// The JSON of each image.
    pub images: Vec<String>,
    /// Image files that belong with the output.
    pub companions: Vec<OutputFile>,
}

impl NewTextures {
    /// The number of an image's texture. `embed` stores bytes and returns the number of their view; without it the image is a file
    /// next to the output.
    pub fn number(
        &mut self,
        image: &FileImage,
        embed: Option<impl FnOnce(Vec<u8>) -> usize>,
    ) -> Result<usize, WriteError> {
        // Files of different folders may have the same name.
        let names = (2_u64..).map(|number| format!("{number}-{}", image.name));
        let mut names = std::iter::once(image.name.clone()).chain(names);
        let name = names.find(|name| self.known.get(name).is_none_or(|(_, other)| *other == image.content));
        let name = name.unwrap_or_default();
        if let Some((number, _)) = self.known.get(&name) {
            return Ok(*number);
        }
        let json = match embed {
            Some(embed) => {
                let view = embed(bytes(image)?);
                let kind = image.kind.mime_type();
                format!("{{\"name\":{},\"bufferView\":{view},\"mimeType\":\"{kind}\"}}", quoted(&name))
            }
            None => {
                let content = OutputContent::clone(&image.content);
                self.companions.push(OutputFile { name: name.clone(), content });
                format!("{{\"uri\":{}}}", quoted(&percent_encoded(&name)))
            }
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
