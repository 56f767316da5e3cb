//! Images in data URIs, which a GLB holds in its binary chunk instead: the official validator warns of data URIs there.

use crate::io::ImageKind;
use crate::io::gltf::buffers::{Uri, decode_data};
use crate::io::gltf::json::{Json, Value, quoted};
use crate::io::gltf::splice::Splices;

/// An image of a document in a data URI, decoded.
pub struct DataImage {
    object: Value,
    pub bytes: Vec<u8>,
    kind: ImageKind,
}

impl DataImage {
    /// Those of a document that are PNG or JPEG, the types that a view may have without an extension.
    pub fn all(json: &Json) -> Vec<Self> {
        let image = |object| {
            let uri = json.string(json.member(object, "uri")?)?;
            let bytes = (Uri::parse(&uri) == Uri::Data).then(|| decode_data(&uri).ok())??;
            let kind = ImageKind::of(&bytes)?;
            Some(Self { object, bytes, kind })
        };
        json.items(json.root(), "images").filter_map(image).collect()
    }

    /// Refers the image to a new view of the first buffer, number `view` of all.
    pub fn move_to(&self, json: &Json, offset: usize, view: usize, splices: &mut Splices<'_>) {
        let length = self.bytes.len();
        let object = format!("{{\"buffer\":0,\"byteOffset\":{offset},\"byteLength\":{length}}}");
        splices.push("bufferViews", object);
        splices.remove(self.object, "uri");
        splices.set(self.object, "bufferView", view);
        if json.member(self.object, "mimeType").is_none() {
            splices.set(self.object, "mimeType", quoted(self.kind.mime_type()));
        }
    }
}
