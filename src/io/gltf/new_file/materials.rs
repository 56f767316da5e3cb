//! The materials of a new file, each written once.

use super::File;
use crate::io::gltf::appearance::{MaterialTextures, material_members};
use crate::io::gltf::json::quoted;
use crate::io::{
    FileImage, FileImages, FileMaterial, FileOptics, FileReflection, MaterialFallback, WriteError,
};
use crate::mesh::{FaceLabels, Mesh};

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
        // Without colour and gloss glTF would make it a rough metal, which is almost black in most viewers.
        if self.fallback == MaterialFallback::Plastic && !members.starts_with(",\"pbrMetallicRoughness\"") {
            members.insert_str(0, ",\"pbrMetallicRoughness\":{\"metallicFactor\":0,\"roughnessFactor\":0.6}");
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
