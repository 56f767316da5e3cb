//! New binary data, and the JSON that describes them.

use crate::io::gltf::container::glb::padded;
use crate::io::gltf::document::records::{Format, SHAPES};
use bytemuck::NoUninit;
use std::borrow::Cow;
use std::fmt::Write as _;

// glTF is little-endian, and arrays are stored as they lie in memory.
const _: () = assert!(cfg!(target_endian = "little"), "a big-endian machine needs byte swaps here");

/// What a view is for: glTF's codes for vertex attributes and for indices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    Vertices = 34962,
    Indices = 34963,
}

impl Target {
    /// From one element to the next, where elements do not fill whole multiples of four, as those of vertices must.
    pub fn stride(self, format: Format) -> Option<usize> {
        let size = format.size();
        (self == Target::Vertices && padded(size) != size).then(|| padded(size))
    }
}

/// The content of a buffer view.
pub trait Bytes {
    fn bytes(&self) -> &[u8];
}

impl<T: NoUninit> Bytes for Vec<T> {
    fn bytes(&self) -> &[u8] {
        bytemuck::cast_slice(self)
    }
}

impl Bytes for Cow<'_, [u32]> {
    fn bytes(&self) -> &[u8] {
        bytemuck::cast_slice(self)
    }
}

/// The JSON of a buffer view. A stride is given where elements do not fill whole multiples of four.
pub fn view_json(buffer: usize, offset: u64, length: usize, stride: Option<usize>, target: Target) -> String {
    let mut json = format!("{{\"buffer\":{buffer},\"byteOffset\":{offset},\"byteLength\":{length}");
    if let Some(stride) = stride {
        let _ = write!(json, ",\"byteStride\":{stride}");
    }
    let _ = write!(json, ",\"target\":{}}}", target as u32);
    json
}

/// The JSON of an accessor that fills a view from its start.
pub fn accessor_json(view: usize, format: Format, count: usize, bounds: Option<&Bounds>) -> String {
    let (kind, code) = (SHAPES[format.width - 1].0, format.component.as_gl_enum());
    let mut json = format!("{{\"bufferView\":{view},\"componentType\":{code}");
    if format.normalized {
        json.push_str(",\"normalized\":true");
    }
    let _ = write!(json, ",\"count\":{count},\"type\":\"{kind}\"");
    if let Some(bounds) = bounds {
        let _ = write!(json, ",\"min\":{},\"max\":{}", number_list(&bounds.low), number_list(&bounds.high));
    }
    json.push('}');
    json
}

/// Smallest and largest value of each component, in the units of the storage.
#[derive(Clone, Debug, PartialEq)]
pub struct Bounds {
    pub low: Vec<f64>,
    pub high: Vec<f64>,
}

/// A list of numbers, each in the shortest spelling that reads back as the same double.
pub fn number_list(numbers: &[f64]) -> String {
    let spelt: Vec<String> =
        numbers.iter().map(|&number| serde_json::Value::from(number).to_string()).collect();
    format!("[{}]", spelt.join(","))
}

/// Pieces that make up a buffer, each at a multiple of four.
#[derive(Default)]
pub struct Blob<'a> {
    pieces: Vec<Box<dyn Bytes + 'a>>,
    pub length: u64,
}

impl<'a> Blob<'a> {
    /// Adds a piece and returns where it begins.
    pub fn push(&mut self, piece: impl Bytes + 'a) -> u64 {
        let offset = self.length;
        self.length += padded(piece.bytes().len()) as u64;
        self.pieces.push(Box::new(piece));
        offset
    }

    /// The bytes, piece by piece, fillers included.
    pub fn pieces(&self) -> Vec<&[u8]> {
        const FILLER: [u8; 4] = [0; 4];
        let bytes = self.pieces.iter().map(|piece| piece.bytes());
        bytes.flat_map(|bytes| [bytes, &FILLER[..padded(bytes.len()) - bytes.len()]]).collect()
    }
}
